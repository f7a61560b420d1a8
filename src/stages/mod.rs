//! Stages floor: order of the work, what it found out, the atlas on disk, publishing, comparing versions.

pub mod atlas;
pub mod diff;
pub mod format_md;
pub mod progress;
pub mod publish;
pub mod results;
pub mod specimen;
pub mod verify;
pub mod worked;
