//! What depends on this crate depends on few others.

use std::collections::BTreeSet;
use std::process::Command;

/// Crates that a program may get with this one, itself included.
const CRATES_MAX: usize = 45;

#[test]
fn the_crate_stays_light() {
    let call = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "-p", "diffraction-brdf", "-e", "normal", "--prefix", "none"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs, as it does for this test");
    let text = String::from_utf8(call.stdout).expect("names of crates are text");
    // Name and version; behind them "(*)" and "(proc-macro)".
    let crates: BTreeSet<_> = text.lines().map(|line| line.split(' ').take(2).collect::<Vec<_>>()).collect();
    assert!(call.status.success(), "{}", String::from_utf8_lossy(&call.stderr));
    assert!(crates.iter().any(|found| found[0] == "exr"), "{crates:?}");
    assert!(crates.len() <= CRATES_MAX, "{} crates: {crates:?}", crates.len());
    for heavy in ["tiff", "wgpu", "naga", "plotters", "clap", "minijinja", "rayon"] {
        assert!(!crates.iter().any(|found| found[0] == heavy), "{heavy}");
    }
}
