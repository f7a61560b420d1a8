//! What rounding may change, and which number format follows from it.

use super::*;
use crate::tables::model::Lobe;
use diffraction_brdf::front_factor::{Factor, FrontFactor};
use diffraction_brdf::material::Material;

const SIZE: usize = 25;

/// Of the lobe at 780 nm whose window is 1 µm wide.
const LOBE_RADIUS: f64 = 0.565;

/// Five tables, each a tenth of the last, whose numbers look like chance; sums stay above zero.
fn set(basis: Basis) -> TableSet {
    let number = |n: usize| {
        move |(row, column, channel): (usize, usize, usize)| {
            let chance = ((row * 7919 + column * 104_729 + channel * 1299 + n * 15_485) % 10_007) as f32 / 10_007.0;
            0.1f32.powi(n as i32) * if n == 0 { 1.0 + chance } else { 2.0 * chance - 1.0 }
        }
    };
    TableSet {
        basis,
        tables: (0..5).map(|n| Array3::from_shape_fn((SIZE, SIZE, 3), number(n))).collect(),
        lobe: None,
        prefilter_width: 0.0,
        front_factor: FrontFactor { material: Material::Ideal, shadowing: false, factor: Factor::Scalar },
        restriction: None,
        usable_radius: 2.0,
    }
}

/// Largest change of a set's values over all texels in the disc and a hundred values of `t`, as a share of what is allowed.
fn worst_share(exact: &TableSet, other: &TableSet, allowed: f64) -> f64 {
    let grid = Grid { size: SIZE, half_width: 2.0 };
    let texels = (0..SIZE * SIZE).map(|index| [index / SIZE, index % SIZE]);
    let inside = texels.filter(|at| grid.u(at[1]).hypot(grid.v(at[0])) < 2.0);
    let at_each_t = |at| (2..=100).map(move |k| (at, f64::from(k) / 100.0));
    let changes =
        inside.flat_map(at_each_t).filter_map(|(at, t)| change(value(exact, at, t), value(other, at, t), 0.0));
    changes.flatten().fold(0.0, f64::max) / allowed
}

#[test]
fn values_keep_their_share_of_the_tolerance_at_every_t() {
    for basis in [Basis::Chebyshev, Basis::Taylor] {
        let exact = set(basis);
        for tolerance in [3e-2, 1e-3, 1e-5] {
            let share = worst_share(&exact, &to_tolerance(&exact, tolerance), ROUNDED_SHARE * tolerance);
            assert!(share <= 1.0 + 1e-9, "{basis:?} {tolerance:e}: {share}");
            // Nor is room given away, and steps four times as large would not pass.
            assert!(share > 0.5, "{basis:?} {tolerance:e}: {share}");
            let coarse = to_tolerance(&exact, 4.0 * tolerance);
            assert!(worst_share(&exact, &coarse, ROUNDED_SHARE * tolerance) > 1.0, "{basis:?} {tolerance:e}");
        }
    }
}

#[test]
fn bits_below_the_tolerance_are_zero() {
    let bits = |set: &TableSet, n: usize| {
        let zeros: u32 = set.tables[n].iter().map(|number| number.to_bits().trailing_zeros().min(24)).sum();
        24.0 - f64::from(zeros) / set.tables[n].len() as f64
    };
    let exact = set(Basis::Chebyshev);
    let [coarse, fine] = [1e-2, 1e-4].map(|tolerance| to_tolerance(&exact, tolerance));
    // 1e-2 leaves a value near 1 nine bits and a table a tenth as large about three fewer; 1e-4 asks for seven more.
    assert!(bits(&exact, 0) > 21.0 && bits(&exact, 1) > 21.0);
    assert!(bits(&coarse, 0) < 10.0 && bits(&coarse, 1) < 7.0, "{} {}", bits(&coarse, 0), bits(&coarse, 1));
    assert!((4.0..9.0).contains(&(bits(&fine, 1) - bits(&coarse, 1))));
    assert!(coarse.tables[4].iter().all(|number| *number == 0.0), "a ten-thousandth adds nothing to 1e-2");
    assert_eq!(to_tolerance(&coarse, 1e-2).tables[4], coarse.tables[4]);
}

#[test]
fn what_vanishes_at_some_t_keeps_all_its_digits() {
    let mut exact = set(Basis::Chebyshev);
    // T_0 - T_1 - 1e-9 T_2 falls below zero towards t = 1.
    for (table, number) in exact.tables.iter_mut().zip([0.3, -0.3, -1e-9, 0.0, 0.0]) {
        (0..3).for_each(|c| table[[12, 12, c]] = number);
    }
    exact.tables[0][[3, 12, 1]] = f32::NAN;
    exact.tables[1][[4, 12, 0]] = f32::INFINITY;
    let rounded = to_tolerance(&exact, 1e-2);
    for (before, after) in exact.tables.iter().zip(&rounded.tables) {
        assert!((0..3).all(|c| before[[12, 12, c]] == after[[12, 12, c]]));
    }
    assert!(rounded.tables[0][[3, 12, 1]].is_nan() && rounded.tables[1][[4, 12, 0]] == f32::INFINITY);
    assert_ne!(exact.tables[2][[13, 12, 1]], rounded.tables[2][[13, 12, 1]]);
}

#[test]
fn halves_are_chosen_where_they_keep_the_tolerance() {
    let benign = set(Basis::Chebyshev);
    let chosen = choose(&benign, None, 1e-3, LOBE_RADIUS);
    assert_eq!(chosen.storage, Storage::Half);
    assert!(chosen.rounding.half > HALF_P95 && chosen.rounding.float < 0.25e-3 && chosen.rounding.float > 5e-5);
    // A finer tolerance, or values a fifth of their terms, are too much for halves.
    assert_eq!(choose(&benign, None, 1e-4, LOBE_RADIUS).storage, Storage::Float);
    let mut cancelling = set(Basis::Chebyshev);
    let first = cancelling.tables[0].clone();
    cancelling.tables[1].zip_mut_with(&first, |second, first| *second -= 0.8 * first);
    let chosen = choose(&cancelling, None, 1e-3, LOBE_RADIUS);
    assert!(chosen.storage == Storage::Float && chosen.rounding.half > 1e-3, "{:?}", chosen.rounding);
    assert_eq!(choose(&cancelling, None, 1e-2, LOBE_RADIUS).storage, Storage::Half, "the tolerance decides");
    assert_eq!(choose(&cancelling, Some(Storage::Half), 1e-3, LOBE_RADIUS).storage, Storage::Half, "as asked for");
    assert_eq!([1e-3, 4e-4].map(|tolerance| expected(None, tolerance)), [Storage::Half, Storage::Float]);
}

#[test]
fn the_cross_term_counts() {
    let mut exact = set(Basis::Chebyshev);
    // Patches that cancel each other but for a hundredth at one end of the range.
    let patch = |value: f32| {
        Array3::from_shape_fn((9, 9, 3), |(row, column, _)| value * (1.0 + 0.01 * (row * 9 + column) as f32))
    };
    exact.lobe =
        Some(Lobe { coherent: Array3::zeros((5, 6, 3)), radius_max: 0.3, cross: vec![patch(300.0), patch(-299.9)] });
    assert_eq!(choose(&exact, None, 1e-3, LOBE_RADIUS).storage, Storage::Float);
    exact.lobe = None;
    assert_eq!(choose(&exact, None, 1e-3, LOBE_RADIUS).storage, Storage::Half);
}

#[test]
fn the_percentile_of_halves_is_that_of_numbers_of_all_sizes() {
    let numbers = (0..20_000).map(|k| 2f32.powf(k as f32 / 20_000.0 * 7.0));
    let mut errors: Vec<f64> =
        numbers.map(|x| (f64::from(half::f16::from_f32(x).to_f32()) / f64::from(x) - 1.0).abs()).collect();
    errors.sort_by(f64::total_cmp);
    let found = errors[errors.len() * 19 / 20];
    assert!((found / HALF_P95 - 1.0).abs() < 0.02, "{found:e} {HALF_P95:e}");
}
