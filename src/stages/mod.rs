//! Stages floor: order of the work, what it found out, the atlas on disk, publishing, comparing versions.

pub mod atlas;
pub mod config;
pub mod diff;
pub mod format_md;
pub mod gpu_check;
pub mod ingest;
pub mod measure;
pub mod pipeline;
pub mod progress;
pub mod publish;
pub mod results;
pub mod scenes;
pub mod shader_export;
pub mod shared_scenes;
pub mod specimen;
pub mod stability;
pub mod study;
pub mod verify;
pub mod worked;
