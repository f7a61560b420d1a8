//! Cases built to break the method, each with a bound derived beside it, and shown to need its guard.

use std::sync::OnceLock;

use diffraction_build::ground::progress::Silent;
use diffraction_study::stability::{Guard, Stability, StabilityCase, Verdict, large_cases, run_stability};

/// The suite runs once for all tests.
fn stability() -> &'static Stability {
    static STABILITY: OnceLock<Stability> = OnceLock::new();
    STABILITY.get_or_init(|| run_stability(false, &Silent))
}

fn show(case: &StabilityCase) {
    let half = case.half.map_or(String::new(), |h| format!("{h:.2}"));
    let guard = format!("{:9.2e} without {}", case.guard.without, case.guard.what);
    println!("{:36} {:9.2e} of {:9.2e} half {half:5} {guard}", case.name, case.measured, case.bound);
}

/// What is wrong with a case: it must be within its bound, and beyond it where its guard is taken out.
fn faults(case: &StabilityCase) -> Vec<String> {
    show(case);
    let StabilityCase { name, measured, bound, half, guard, .. } = case;
    let without = guard.without;
    let wrong = [
        (measured.is_nan() || measured > bound, format!("{name}: {measured:e} of {bound:e}")),
        (!half.is_none_or(|share| share <= 1.0), format!("{name}: halves deviate by {half:?} of their rounding")),
        (without.is_nan() || without <= *bound, format!("{name}: {without:e} without {} keeps {bound:e}", guard.what)),
        (case.verdict() != Verdict::Kept, format!("{name}: {:?}", case.verdict())),
    ];
    wrong.into_iter().filter(|(wrong, _)| *wrong).map(|(_, message)| message).collect()
}

#[test]
#[ignore = "slow: the whole suite"]
fn every_case_keeps_its_bound_and_fails_where_its_guard_is_taken_out() {
    let cases = &stability().cases;
    let faults: Vec<String> = cases.iter().flat_map(faults).collect();
    assert!(faults.is_empty(), "{faults:#?}");
    let mut names: Vec<_> = cases.iter().map(|case| &case.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), cases.len(), "every case has a name of its own");
    // The extremes are there: four decades of relief, and |w| down to where doubles' rounding would show.
    let depths = stability().depths.iter().map(|row| row.depth_nm);
    let [shallow, deep] = depths.fold([f64::MAX, 0.0], |[low, high], depth: f64| [low.min(depth), high.max(depth)]);
    assert!(deep >= 1e4 * shallow && deep >= 20_000.0, "{shallow} to {deep} nm");
    assert!(stability().grazing.iter().any(|row| row.normalised_w < 1e-3));
}

#[test]
fn a_verdict_needs_the_bound_kept_the_halves_right_and_the_guard_missed() {
    let case = |measured: f64, half: f64, without: f64| StabilityCase {
        name: String::new(),
        note: String::new(),
        measured,
        bound: 1.0,
        half: Some(half),
        guard: Guard { what: String::new(), without },
    };
    for (measured, half, without, verdict) in [
        (1.0, 1.0, 1.1, Verdict::Kept),
        (0.5, 1.0, f64::NAN, Verdict::Blind),
        (0.5, f64::NAN, 2.0, Verdict::Broken),
        (0.5, 1.0, f64::INFINITY, Verdict::Kept),
        (1.1, 1.0, 2.0, Verdict::Broken),
        (f64::NAN, 1.0, 2.0, Verdict::Broken),
        (0.5, 1.1, 2.0, Verdict::Broken),
        (0.5, 1.0, 1.0, Verdict::Blind),
    ] {
        assert_eq!(case(measured, half, without).verdict(), verdict, "{measured} {half} {without}");
    }
}

#[test]
#[ignore = "slow: the whole suite"]
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
#[ignore = "slow: the whole suite"]
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
#[ignore = "slow: scans and tables of many megabytes"]
fn large_scans_and_tables_keep_their_bounds() {
    let started = std::time::Instant::now();
    for case in large_cases() {
        assert_eq!(faults(&case), Vec::<String>::new());
    }
    println!("{:?}", started.elapsed());
}
