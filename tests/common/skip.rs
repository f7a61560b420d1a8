//! How a test says that something it needs is not on this machine.
//!
//! `REQUIRE_ALL=1` makes every such word a failure. `REQUIRE_ALL=tools` does so for programs, drivers and packages, which can be
//! installed, and lets the scans be missing that are not part of the repository.

#![allow(dead_code)] // each test program uses its own part

use std::fmt::Arguments;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Says aloud what is not tested here, and why; panics where nothing may be left out.
#[track_caller]
pub fn skipped(why: Arguments) {
    let required = std::env::var("REQUIRE_ALL").unwrap_or_default();
    assert!(required.is_empty(), "REQUIRE_ALL={required} forbids what would be SKIPPED: {why}");
    say(why);
}

fn say(why: Arguments) {
    // Past the test harness, which swallows what passing tests print with macros.
    let _ = writeln!(std::io::stderr(), "SKIPPED: {why}");
}

/// `skip!("why")`, with arguments as `format!` takes them: ends the test that it stands in.
#[allow(unused_macros)]
macro_rules! skip {
    ($($why:tt)*) => {{
        crate::skip::skipped(format_args!($($why)*));
        return;
    }};
}

/// A folder of the scans and figures that are kept beside the checkout, or `None` and a loud word.
#[track_caller]
pub fn shared(folder: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared").join(folder);
    if path.is_dir() {
        return Some(path);
    }
    let why = format!("{} is not there, nothing of it is read", path.display());
    match std::env::var("REQUIRE_ALL").as_deref() {
        Ok("tools") => say(format_args!("{why}")),
        _ => skipped(format_args!("{why}")),
    }
    None
}

/// The files that are part of the repository for tests alone.
pub fn test_data(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(folder)
}
