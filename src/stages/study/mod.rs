//! What a study is lent: the manifest's scenes as samples of their pixels, shapes under lights, and the GPU's clock.

mod gpu_clock;
mod light_scenes;
mod scene_samples;

pub use gpu_clock::FrameClock;
pub use light_scenes::lit_shapes;
pub use scene_samples::drawn;
