//! Stages floor: order, timing, cache, publishing.

pub mod progress;
//! Stages floor: order of the work, the atlas on disk, publishing, comparing versions.

pub mod atlas;
pub mod diff;
pub mod format_md;
pub mod publish;
pub mod specimen;
pub mod verify;
pub mod worked;
//! Stages floor: the order of the work, its timing, and what it found out.

pub mod results;
