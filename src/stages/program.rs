//! Which program this is, by its own digest: results of another build are not this one's.

use std::sync::OnceLock;

use sha2::{Digest, Sha256};

use super::digest::hex;

/// SHA-256 of the program's file in hexadecimal; `None` where it cannot read itself.
pub(crate) fn digest() -> Option<&'static str> {
    static DIGEST: OnceLock<Option<String>> = OnceLock::new();
    let read = || {
        // The processor's own instructions: the program is larger than all that a run without anything to do reads besides.
        let bytes = std::fs::read(std::env::current_exe().ok()?).ok()?;
        Some(hex(&Sha256::digest(&bytes)))
    };
    DIGEST.get_or_init(read).as_deref()
}
