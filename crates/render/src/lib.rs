//! Pictures of surfaces: scenes, the directions that their pixels need, and shading on the CPU and on a GPU.

pub mod error;
pub mod render;
pub mod scene;
