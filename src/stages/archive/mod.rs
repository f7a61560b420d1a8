//! The atlas on disk: what a version's files hold, how one is published, checked, compared, and read by others.

pub mod diff;
mod diff_colours;
mod diff_text;
mod format_look_ups;
pub mod format_md;
mod format_spectral;
mod ktx2;
pub mod lock;
pub(crate) mod materialx;
pub(crate) mod osl;
pub(crate) mod prune;
pub mod publish;
pub mod result_file;
pub(crate) mod shader_data;
pub mod shader_export;
pub mod shader_include;
pub mod specimen_file;
pub(crate) mod units;
pub(crate) mod verify;
mod verify_chance;
pub mod verify_files;
mod verify_root;
pub(crate) mod verify_scans;
pub mod worked;
