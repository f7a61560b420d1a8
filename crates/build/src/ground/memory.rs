//! Resident memory of the process, where the system tells.

use std::sync::atomic::{AtomicU64, Ordering};

/// The largest peak that [`restart`] has made the system forget, in bytes.
static FORGOTTEN_BYTES: AtomicU64 = AtomicU64::new(0);

/// Forgets the largest resident memory so far and gives the present one in bytes. Only Linux can; elsewhere nothing
/// happens and nothing is known.
pub fn restart() -> Option<u64> {
    FORGOTTEN_BYTES.fetch_max(peak_bytes().unwrap_or(0), Ordering::Relaxed);
    // "5" resets VmHWM (proc(5)); a refusal only means that `peak_bytes` covers more than asked.
    let _ = std::fs::write("/proc/self/clear_refs", "5");
    status_bytes("VmRSS:")
}

/// Largest resident memory in bytes since [`restart`], or since the process began where that was refused.
pub fn peak_bytes() -> Option<u64> {
    status_bytes("VmHWM:")
}

/// Largest resident memory in bytes since the process began.
pub fn process_peak_bytes() -> Option<u64> {
    Some(peak_bytes()?.max(FORGOTTEN_BYTES.load(Ordering::Relaxed)))
}

fn status_bytes(field: &str) -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(field))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok().map(|kib| kib << 10)
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::process::Command;

    /// Set in the process that measures.
    const ALONE: &str = "DIFFRACTION_ATLAS_TEST_ALONE";

    /// In a process of its own: other tests would give memory back meanwhile.
    #[test]
    fn a_large_allocation_shows() {
        if std::env::var_os(ALONE).is_none() {
            let name = concat!(module_path!(), "::a_large_allocation_shows");
            let name = name.split_once("::").unwrap().1;
            let output = Command::new(std::env::current_exe().unwrap())
                .args(["--exact", name, "--test-threads=1"])
                .env(ALONE, "1")
                .output()
                .unwrap();
            let text = String::from_utf8_lossy(&output.stdout);
            assert!(output.status.success() && text.contains("1 passed"), "{text}");
            return;
        }
        let before = super::restart().unwrap();
        let block = std::hint::black_box(vec![1u8; 64 << 20]);
        let peak = super::peak_bytes().unwrap();
        assert!((before + (60 << 20)..before + (100 << 20)).contains(&peak), "{before} {peak}");
        drop(block);
        // Linux adds its counters per core only now and then: up to some hundred KiB are missing.
        assert!(super::peak_bytes().unwrap() >= peak - (1 << 20), "what was given back counts");
        assert!(super::restart().unwrap() < peak - (32 << 20), "until it is forgotten");
        let whole = super::process_peak_bytes().unwrap();
        assert!(whole >= peak - (1 << 20) && super::peak_bytes().unwrap() < whole, "but not for the whole run");
    }
}
