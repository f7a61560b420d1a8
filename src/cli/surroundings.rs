//! What libraries below the program expect of its environment.

/// Names the folder that Vulkan's loader and Mesa look for on Linux.
#[cfg(target_os = "linux")]
const RUNTIME_FOLDER: &str = "XDG_RUNTIME_DIR";

/// Starts the program anew where a variable is missing without which Vulkan drivers complain on stderr, to a user who can do nothing about
/// it: as on servers and in containers. Comes back where it is set, or where that cannot be done.
///
/// The variable cannot be set in place: other threads, of libraries too, may read the environment at any time. Replaced by itself the
/// process keeps its number, its files and whoever waits for it.
#[cfg(target_os = "linux")]
pub fn ensure_runtime_folder() {
    use std::os::unix::process::CommandExt;

    if std::env::var_os(RUNTIME_FOLDER).is_some() {
        return;
    }
    if let Ok(program) = std::env::current_exe() {
        let mut again = std::process::Command::new(program);
        // It comes back only with an error, and then the complaint is the smaller evil.
        let _ = again.args(std::env::args_os().skip(1)).env(RUNTIME_FOLDER, std::env::temp_dir()).exec();
    }
}

/// Nothing is missing elsewhere.
#[cfg(not(target_os = "linux"))]
pub fn ensure_runtime_folder() {}
