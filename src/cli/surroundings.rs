//! What libraries below the program expect of its environment.

/// Names the folder that Vulkan's loader and Mesa look for on Linux.
#[cfg(target_os = "linux")]
const RUNTIME_FOLDER: &str = "XDG_RUNTIME_DIR";

/// From which size on glibc gives an array pages of its own, which go back as soon as it is freed, and how large that is: left alone it raises
/// it up to 32 MiB, keeps what is freed in between, and a run holds a quarter more than it uses, more or less as it happens. Pages fetched anew cost a
/// hundredth to a twentieth of the processor's time.
#[cfg(target_os = "linux")]
const OWN_PAGES: (&str, &str) = ("MALLOC_MMAP_THRESHOLD_", "1048576");

/// Starts the program anew where variables are missing: one without which Vulkan drivers complain on stderr, to a user who can do nothing about
/// it, as on servers and in containers; and one that the allocator reads. Comes back where they are set, or where that cannot be done.
///
/// The variable cannot be set in place: other threads, of libraries too, may read the environment at any time. Replaced by itself the
/// process keeps its number, its files and whoever waits for it.
#[cfg(target_os = "linux")]
pub fn ensure_surroundings() {
    use std::os::unix::process::CommandExt;

    let is_set = |name: &str| std::env::var_os(name).is_some();
    let (own_pages, from_bytes) = OWN_PAGES;
    if is_set(RUNTIME_FOLDER) && is_set(own_pages) {
        return;
    }
    if let Ok(program) = std::env::current_exe() {
        let mut again = std::process::Command::new(program);
        again.args(std::env::args_os().skip(1));
        if !is_set(RUNTIME_FOLDER) {
            again.env(RUNTIME_FOLDER, std::env::temp_dir());
        }
        if !is_set(own_pages) {
            again.env(own_pages, from_bytes);
        }
        // It comes back only with an error, and then the complaint is the smaller evil.
        let _ = again.exec();
    }
}

/// Nothing is missing elsewhere.
#[cfg(not(target_os = "linux"))]
pub fn ensure_surroundings() {}
