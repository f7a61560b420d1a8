//! The process's largest resident memory over a stretch of work, where the system tells.

/// Forgets the largest resident memory so far and gives the present one in bytes. Only Linux can; elsewhere nothing
/// happens and nothing is known.
pub fn restart() -> Option<u64> {
    // "5" resets VmHWM (proc(5)); a refusal only means that `peak_bytes` covers more than asked.
    let _ = std::fs::write("/proc/self/clear_refs", "5");
    status_bytes("VmRSS:")
}

/// Largest resident memory in bytes since [`restart`], or since the process began where that was refused.
pub fn peak_bytes() -> Option<u64> {
    status_bytes("VmHWM:")
}

fn status_bytes(field: &str) -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(field))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok().map(|kib| kib << 10)
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    #[test]
    fn a_large_allocation_shows() {
        let before = super::restart().unwrap();
        let block = std::hint::black_box(vec![1u8; 64 << 20]);
        assert!(super::peak_bytes().unwrap() >= before + (32 << 20));
        drop(block);
    }
}
