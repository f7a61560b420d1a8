//! Cases built to break the method, each with a bound derived beside it, and shown to need its guard.

use std::sync::OnceLock;

use diffraction_atlas::stages::stability::{StabilityCase, Verdict, run_stability};

/// The suite runs once for both tests.
fn cases() -> &'static [StabilityCase] {
    static CASES: OnceLock<Vec<StabilityCase>> = OnceLock::new();
    CASES.get_or_init(run_stability)
}

#[test]
fn every_case_keeps_its_bound() {
    let cases = cases();
    for case in cases {
        println!("{:32} measured {:9.2e} bound {:9.2e}  {}", case.name, case.measured, case.bound, case.note);
    }
    assert!(cases.len() >= 20);
    let broken: Vec<_> = cases.iter().filter(|case| case.verdict() != Verdict::Kept).collect();
    assert!(broken.is_empty(), "{broken:#?}");
}

#[test]
fn cases_fail_where_their_guard_is_taken_out() {
    let cases = cases();
    let guarded: Vec<_> = cases.iter().filter_map(|case| Some((case, case.without_guard?))).collect();
    assert!(guarded.len() >= 4);
    for (case, without) in guarded {
        assert!(without > case.bound || without.is_nan(), "{}: {without:e} keeps {:e}", case.name, case.bound);
    }
}
