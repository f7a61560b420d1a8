//! Stages floor: order of the work, what it found out, the atlas on disk, publishing, comparing versions.

pub mod atlas;
pub mod config;
pub(crate) mod describe;
pub mod diff;
pub mod format_md;
pub mod frame_time;
pub mod gpu_check;
pub mod gpu_results;
pub mod gpu_stage;
pub mod ingest;
pub mod measure;
pub mod measured;
pub mod pipeline;
pub mod progress;
pub mod publish;
pub mod reached;
pub mod results;
pub mod scenes;
pub mod serve;
pub mod shader_data;
pub mod shader_export;
pub mod specimen;
pub mod stability;
pub mod study;
pub mod verify;
pub mod worked;
