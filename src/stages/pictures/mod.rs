//! Pictures of specimens: the manifest's scenes from the tables and from the reference, alone and shared.

pub(crate) mod covered;
pub(crate) mod preview;
pub mod scenes;
pub mod shading;
pub(crate) mod shared_scenes;
pub(crate) mod sharing;
