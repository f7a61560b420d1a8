//! Cases built to break the method, each with a bound derived beside it, and shown to need its guard.

use std::sync::OnceLock;

use diffraction_atlas::stages::progress::Silent;
use diffraction_atlas::stages::stability::{Stability, StabilityCase, Verdict, large_cases, run_stability};

/// The suite runs once for all tests.
fn stability() -> &'static Stability {
    static STABILITY: OnceLock<Stability> = OnceLock::new();
    STABILITY.get_or_init(|| run_stability(false, &Silent))
}

fn show(case: &StabilityCase) {
    let guard = case.guard.as_ref().map_or(String::new(), |g| format!("{:9.2e} without {}", g.without, g.what));
    let half = case.half.map_or(String::new(), |h| format!("{h:.2}"));
    println!("{:36} {:9.2e} of {:9.2e} half {half:5} {guard}", case.name, case.measured, case.bound);
}

#[test]
fn every_case_keeps_its_bound() {
    let cases = &stability().cases;
    cases.iter().for_each(show);
    assert!(cases.len() >= 50);
    let broken: Vec<_> = cases.iter().filter(|case| case.verdict() != Verdict::Kept).collect();
    assert!(broken.is_empty(), "{broken:#?}");
}

#[test]
fn cases_fail_where_their_guard_is_taken_out() {
    let guarded = stability().cases.iter().filter_map(|case| Some((case, case.guard.as_ref()?)));
    let mut count = 0;
    for (case, guard) in guarded {
        let without = guard.without;
        assert!(without > case.bound || without.is_nan(), "{}: {without:e} keeps {:e}", case.name, case.bound);
        count += 1;
    }
    assert!(count >= 20, "{count}");
}

#[test]
fn cost_grows_linearly_with_depth() {
    let depths = &stability().depths;
    let [shallow, deep] = [depths.iter().find(|row| row.depth_nm == 1_500.0), depths.last()].map(Option::unwrap);
    let ratio = deep.depth_nm / shallow.depth_nm;
    // J_n(z) dies off beyond z + O(z^1/3): at most in proportion, and by half of it at least.
    for [a, b] in [[shallow.tables, deep.tables], [shallow.transforms, deep.transforms]] {
        let growth = b as f64 / a as f64;
        assert!(growth < ratio && growth > 0.4 * ratio, "{growth} for {ratio}");
    }
}

#[test]
fn the_published_series_fails_format_by_format_as_forecast() {
    let series = &stability().series;
    for row in series {
        println!("{row:?}");
        // The forecast counts one rounding of all terms, averaged over the lines by their power: of halves and floats it
        // must tell the 95th percentile to a factor of 2.5, over forty decades. Doubles are sums of 1024 samples and up to
        // 300 products, whose roundings add to some thirty.
        for (format, (error, predicted)) in row.errors.iter().zip(row.predicted).enumerate() {
            let (least, most) = if format < 2 { (0.4, 2.5) } else { (0.4, 30.0) };
            if predicted > 1e-9 {
                assert!((least..most).contains(&(error / predicted)), "{row:?}");
            }
            assert!(*error <= most * predicted + 2e-11, "{row:?}");
        }
    }
    // Each format is useless from a depth on, halves first.
    let fails =
        |format: usize| series.iter().find(|row| row.errors[format] > 0.1).map_or(f64::INFINITY, |row| row.depth_nm);
    assert!(fails(0) < fails(1) && fails(1) < fails(2) && fails(2) <= 3_000.0);
}

/// Some seconds and two gigabytes each, one after the other.
#[test]
fn large_scans_and_tables_keep_their_bounds() {
    let started = std::time::Instant::now();
    for case in large_cases() {
        show(&case);
        assert_eq!(case.verdict(), Verdict::Kept, "{case:?}");
    }
    println!("{:?}", started.elapsed());
}
