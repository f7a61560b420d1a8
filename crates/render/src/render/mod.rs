//! Render floor: shading the samples of a scene.

use diffraction_brdf::direction::{Vec3, Xyz};

pub mod cpu;
pub mod gpu;
pub mod gpu_bound;
pub mod gpu_bound_spectral;
pub mod gpu_filtered;
pub mod gpu_frame;
pub mod gpu_layout;
pub mod gpu_sampled;
pub mod gpu_spectral;
pub mod gpu_tables;
pub mod gpu_thread;
pub mod png_image;
pub mod wgsl;

/// A BRDF to shade with: local `wi` and `wo`, both with positive z, to XYZ in 1/sr. It is called from
/// several threads.
pub type Brdf<'a> = dyn Fn(Vec3, Vec3) -> Xyz + Sync + 'a;
