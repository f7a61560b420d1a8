//! What a study is lent: the manifest's scenes as samples of their pixels, and the GPU's clock.

mod gpu_clock;
mod scene_samples;

pub use gpu_clock::FrameClock;
pub use scene_samples::drawn;
