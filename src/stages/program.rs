//! Which program this is, by its own digest, and on what kind of processor it runs.

use std::sync::OnceLock;

use sha2::{Digest, Sha256};

/// SHA-256 of the program's file in hexadecimal; `None` where it cannot read itself.
pub(crate) fn digest() -> Option<&'static str> {
    static DIGEST: OnceLock<Option<String>> = OnceLock::new();
    let read = || {
        // The processor's own instructions: the program is larger than all that a run without anything to do reads besides.
        let bytes = std::fs::read(std::env::current_exe().ok()?).ok()?;
        Some(Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect())
    };
    DIGEST.get_or_init(read).as_deref()
}

/// The kind of processor, as far as results depend on it: without these instructions the transforms and the system's functions
/// take other paths, whose results differ in the last digits.
pub(crate) fn processor() -> String {
    #[cfg(target_arch = "x86_64")]
    let instructions = [("avx", std::is_x86_feature_detected!("avx")), ("fma", std::is_x86_feature_detected!("fma"))];
    #[cfg(not(target_arch = "x86_64"))]
    let instructions: [(&str, bool); 0] = [];
    let known = instructions.into_iter().filter(|(_, there)| *there).map(|(name, _)| name);
    [std::env::consts::ARCH].into_iter().chain(known).collect::<Vec<_>>().join(" ")
}
