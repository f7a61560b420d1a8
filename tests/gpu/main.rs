//! Tables on the GPU against the CPU, on whatever Vulkan adapter there is (Mesa's software driver will do).

#[macro_use]
#[path = "../common/skip.rs"]
mod skip;
// Other test programs use the rest of it.
#[allow(dead_code)]
#[path = "../common/surfaces.rs"]
mod surfaces;

mod agreement;
mod containers;
mod corruption;
mod exported;
mod filtered;
mod frame;
mod published;
mod sampled;
mod sets;
mod shader_export;
mod shader_include;
mod shader_layout;
mod spectral;
mod viewer_shaders;
