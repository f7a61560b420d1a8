//! Which program this is, by its own digest: results of another build are not this one's.

use std::sync::OnceLock;

use super::digest::sha256_file;

/// SHA-256 of the program's file in hexadecimal; `None` where it cannot read itself.
pub(crate) fn digest() -> Option<&'static str> {
    static DIGEST: OnceLock<Option<String>> = OnceLock::new();
    DIGEST.get_or_init(|| Some(sha256_file(&std::env::current_exe().ok()?).ok()?.1)).as_deref()
}
