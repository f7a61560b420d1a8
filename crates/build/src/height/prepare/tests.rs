//! Tests of preparing: closed forms, invariants, degenerate fields.

use std::f64::consts::TAU;

use ndarray::Array2;
use proptest::prelude::*;

use super::*;

fn config(level: Level) -> PrepareConfig {
    PrepareConfig { level, despike: None, blend_nm: None }
}

fn field(size: [usize; 2], pitch_nm: [f64; 2], height: impl Fn(f64, f64) -> f64) -> HeightField {
    let [nx, ny] = size;
    let heights_nm = Array2::from_shape_fn((ny, nx), |(row, column)| {
        height(
            (column as f64 - 0.5 * (nx - 1) as f64) * pitch_nm[0],
            (0.5 * (ny - 1) as f64 - row as f64) * pitch_nm[1],
        )
    });
    HeightField { heights_nm, pitch_nm }
}

/// Independent samples of ±`amplitude`.
fn noise(size: [usize; 2], pitch_nm: [f64; 2], amplitude: f64, seed: u64) -> HeightField {
    let mut random = fastrand::Rng::with_seed(seed);
    let heights_nm = Array2::from_shape_simple_fn((size[1], size[0]), || amplitude * (2.0 * random.f64() - 1.0));
    HeightField { heights_nm, pitch_nm }
}

fn largest(field: &HeightField) -> f64 {
    field.heights_nm.iter().fold(0.0, |largest, height| height.abs().max(largest))
}

fn difference(a: &HeightField, b: &HeightField) -> f64 {
    (&a.heights_nm - &b.heights_nm).iter().fold(0.0, |largest, height| height.abs().max(largest))
}

proptest! {
    #[test]
    fn a_plane_becomes_zero(
        nx in 1usize..20, ny in 1usize..20, sx in -2.0f64..2.0, sy in -2.0f64..2.0, offset in -1e4f64..1e4,
    ) {
        let plane = field([nx, ny], [31.0, 47.0], |x, y| offset + sx * x + sy * y);
        let (levelled, record) = prepare(&plane, &config(Level::Plane)).unwrap();
        // Heights below 1.4e4 nm: 1e-9 is some 500 of their ulps.
        prop_assert!(largest(&levelled) < 1e-9);
        // The slope along a single line of samples is unknowable.
        let known = [if nx > 1 { sx } else { 0.0 }, if ny > 1 { sy } else { 0.0 }];
        prop_assert!(record.removed_slope.iter().zip(known).all(|(found, slope)| (found - slope).abs() < 1e-10));
    }

    #[test]
    fn a_quadratic_becomes_zero(
        nx in 3usize..20, ny in 3usize..20, c in proptest::array::uniform6(-1.0f64..1.0),
    ) {
        let bowl = field([nx, ny], [31.0, 47.0], |x, y| {
            c[0] + c[1] * x + c[2] * y + 1e-3 * (0.5 * c[3] * x * x + c[4] * x * y + 0.5 * c[5] * y * y)
        });
        let (levelled, record) = prepare(&bowl, &config(Level::Quadratic)).unwrap();
        prop_assert!(largest(&levelled) < 1e-9);
        for (found, expected) in record.removed_curvature_per_nm.iter().zip(&c[3..]) {
            prop_assert!((found - 1e-3 * expected).abs() < 1e-12);
        }
        prop_assert!((record.removed_slope[0] - c[1]).abs() < 1e-9 && (record.removed_slope[1] - c[2]).abs() < 1e-9);
        if c[3].abs() > 0.1 {
            let (planed, _) = prepare(&bowl, &config(Level::Plane)).unwrap();
            prop_assert!(largest(&planed) > 1e-3, "a plane must not be enough");
        }
    }

    #[test]
    fn levelling_twice_changes_nothing_more(nx in 8usize..24, ny in 1usize..24, seed in any::<u64>(), which in 0usize..4) {
        let level = [Level::None, Level::Plane, Level::Quadratic, Level::Rows][which];
        let rough = noise([nx, ny], [20.0, 30.0], 50.0, seed);
        let (once, record) = prepare(&rough, &config(level)).unwrap();
        let (twice, _) = prepare(&once, &config(level)).unwrap();
        prop_assert!(difference(&once, &twice) < 1e-10);
        prop_assert_eq!(once.pitch_nm, rough.pitch_nm);
        prop_assert_eq!(once.size(), rough.size());
        let (low, high) = range_nm(&once);
        prop_assert!((low + high).abs() < 1e-10);
        prop_assert_eq!(record.level, level);
    }

    #[test]
    fn what_is_levelled_is_orthogonal_to_what_was_subtracted(nx in 2usize..24, ny in 2usize..24, seed in any::<u64>()) {
        let mut rough = noise([nx, ny], [20.0, 30.0], 50.0, seed);
        level::subtract_surface(&mut rough, level::Order::Quadratic);
        let sum = |term: fn(f64, f64) -> f64| rough.heights_nm.indexed_iter()
            .map(|((j, i), h)| h * term(i as f64, j as f64)).sum::<f64>();
        for term in [|_, _| 1.0, |x, _| x, |_, y| y, |x, y| x * y, |x, _| x * x, |_, y| y * y] as [fn(f64, f64) -> f64; 6] {
            prop_assert!(sum(term).abs() < 1e-7);
        }
    }

    #[test]
    fn drifting_lines_are_levelled(seed in any::<u64>()) {
        let (grating, _) = prepare(
            &field([64, 40], [25.0, 50.0], |x, _| 30.0 * (TAU * x / 400.0).sin()), &config(Level::Plane),
        ).unwrap();
        let mut drifting = grating.clone();
        let mut random = fastrand::Rng::with_seed(seed);
        for mut line in drifting.heights_nm.rows_mut() {
            let offset = 200.0 * random.f64();
            line.iter_mut().for_each(|height| *height += offset);
        }
        let (levelled, record) = prepare(&drifting, &config(Level::Rows)).unwrap();
        prop_assert!(difference(&levelled, &grating) < 1e-9);
        prop_assert!(record.removed_lines_rms_nm > 1.0);
        let (planed, _) = prepare(&drifting, &config(Level::Plane)).unwrap();
        prop_assert!(difference(&planed, &grating) > 1.0);
    }

    #[test]
    fn blended_edges_step_no_more_than_the_interior(
        nx in 16usize..50, ny in 16usize..50, period in 200.0f64..2000.0, turn in 0.0f64..3.1, tilt in -0.2f64..0.2,
    ) {
        let wavy = field([nx, ny], [30.0, 40.0], |x, y| {
            50.0 * (TAU * (x * turn.cos() + y * turn.sin()) / period).sin() + tilt * x
        });
        let blend_nm = 4.0 * 40.0;
        let (blended, _) = prepare(&wavy, &PrepareConfig { blend_nm: Some(blend_nm), ..config(Level::None) }).unwrap();
        let (plain, _) = prepare(&wavy, &config(Level::None)).unwrap();
        for axis in 0..2 {
            let (wrap, _) = steps(&blended, axis);
            let (_, interior) = steps(&plain, axis);
            // The wanted step is the mean of two interior ones; blending along the other axis turns it a little.
            prop_assert!(wrap <= 1.05 * interior + 1e-9, "axis {axis}: {wrap} {interior}");
        }
        let offset = blended.heights_nm[[ny / 2, nx / 2]] - plain.heights_nm[[ny / 2, nx / 2]];
        for ((row, column), height) in blended.heights_nm.indexed_iter() {
            let inside = |index: usize, count: usize, pitch: f64| index.min(count - 1 - index) as f64 * pitch >= blend_nm;
            if inside(row, ny, 40.0) && inside(column, nx, 30.0) {
                prop_assert!((height - plain.heights_nm[[row, column]] - offset).abs() < 1e-9, "the interior changed");
            }
        }
    }

    #[test]
    fn small_fields_survive_everything(nx in 1usize..6, ny in 1usize..6, seed in any::<u64>()) {
        let rough = noise([nx, ny], [20.0, 30.0], 50.0, seed);
        for level in [Level::None, Level::Plane, Level::Quadratic] {
            let all = PrepareConfig { level, despike: Some(Despike { threshold_rms: 3.0 }), blend_nm: None };
            let (prepared, _) = prepare(&rough, &all).unwrap();
            prop_assert!(prepared.heights_nm.iter().all(|height| height.is_finite()));
        }
    }
}

/// Largest step over the seam and largest between neighbours along an axis (0 for x).
fn steps(field: &HeightField, axis: usize) -> (f64, f64) {
    let lines = if axis == 0 { field.heights_nm.clone() } else { field.heights_nm.t().to_owned() };
    let mut found = (0.0f64, 0.0f64);
    for line in lines.rows() {
        found.0 = found.0.max((line[0] - line[line.len() - 1]).abs());
        found.1 = line.windows(2).into_iter().fold(found.1, |largest, pair| largest.max((pair[1] - pair[0]).abs()));
    }
    found
}

#[test]
fn lines_of_two_equal_levels_are_not_torn_apart() {
    // 32 of 64 samples high in even lines, 30 in odd ones: the median would jump by the whole depth.
    let heights_nm = Array2::from_shape_fn((20, 64), |(row, column)| {
        let high = if row % 2 == 0 { 16 } else { 15 };
        if column % 32 < high { 500.0 } else { 0.0 }
    });
    let (levelled, _) = prepare(&HeightField { heights_nm, pitch_nm: [50.0; 2] }, &config(Level::Rows)).unwrap();
    // The midmean differs by twice the share that does: 2 * 2/64 of 500 nm.
    let jump = (levelled.heights_nm[[4, 2]] - levelled.heights_nm[[5, 2]]).abs();
    assert!(jump < 2.0 * 2.0 / 64.0 * 500.0 + 1e-9, "{jump}");
}

/// Each line by itself: the median of what it rises over half of its length taken away, and the median of what is left.
fn line_by_line(field: &HeightField) -> HeightField {
    let mut levelled = field.clone();
    for mut line in levelled.heights_nm.rows_mut() {
        let half = line.len() / 2;
        let mut rises: Vec<f64> = (half..line.len()).map(|i| line[i] - line[i - half]).collect();
        let slope = robust::median(&mut rises) / half as f64;
        line.indexed_iter_mut().for_each(|(i, height)| *height -= slope * i as f64);
        let median = robust::median(&mut line.to_vec());
        line -= median;
    }
    levelled
}

/// Root mean square of the difference of two fields about their planes.
fn rms_apart(a: &HeightField, b: &HeightField) -> f64 {
    let mut apart = HeightField { heights_nm: &a.heights_nm - &b.heights_nm, pitch_nm: a.pitch_nm };
    level::subtract_surface(&mut apart, level::Order::Plane);
    repair::rms_nm(&apart)
}

#[test]
fn matched_differences_leave_more_than_lines_by_themselves() {
    use crate::height::synthesize::{Structure, synthesize};
    let mut sums = [0.0; 2];
    for seed in [1, 2, 3] {
        let rough = Structure::GaussianRough { rms_nm: 30.0, correlation_length_nm: 400.0, seed };
        for structure in [Structure::CornSnake { seed }, Structure::SunbeamSnake { seed }, rough] {
            let made = synthesize(&structure, [256, 256], [62.5; 2]).unwrap();
            let (clean, _) = prepare(&made, &config(Level::Plane)).unwrap();
            let rms_nm = repair::rms_nm(&clean);
            let mut random = fastrand::Rng::with_seed(5);
            let mut offset = clean.clone();
            offset.heights_nm.rows_mut().into_iter().for_each(|mut line| line += rms_nm * (random.f64() - 0.5));
            let errors = |offset: &HeightField, clean: &HeightField| {
                let (matched, _) = prepare(offset, &config(Level::Rows)).unwrap();
                [&matched, &line_by_line(offset)].map(|levelled| rms_apart(levelled, clean) / rms_nm)
            };
            let of_all = errors(&offset, &clean);
            // A piece twenty times as high as all else, on a quarter of each line.
            let with_piece = |field: &HeightField| {
                let is_on = |(row, column): (usize, usize)| (60..124).contains(&row) && (60..120).contains(&column);
                let mut field = field.clone();
                for (place, height) in field.heights_nm.indexed_iter_mut() {
                    *height += if is_on(place) { 20.0 * rms_nm } else { 0.0 };
                }
                field
            };
            let tall = errors(&with_piece(&offset), &with_piece(&clean));
            println!("{structure:?}: off by {of_all:.3?} of the rms height, under a tall piece by {tall:.3?}");
            assert!(tall[0] < 0.5 && tall[1] > 1.4 * tall[0], "{structure:?}: {tall:?}");
            sums = [sums[0] + of_all[0], sums[1] + of_all[1]];
        }
    }
    assert!(sums[0] < 0.85 * sums[1], "{sums:?}");
}

#[test]
fn without_blending_the_seam_steps() {
    let ramp = field([40, 30], [30.0, 40.0], |x, y| 0.1 * x + (TAU * y / 700.0).cos());
    let (wrap, interior) = steps(&ramp, 0);
    assert!(wrap > 30.0 * interior);
    let (blended, _) = prepare(&ramp, &PrepareConfig { blend_nm: Some(300.0), ..config(Level::None) }).unwrap();
    // The ramp's own step of 3 nm goes on over the seam.
    for row in blended.heights_nm.rows() {
        assert!((row[0] - row[39] - 3.0).abs() < 1e-9);
    }
}

#[test]
fn two_by_two_is_left_with_its_twist() {
    let heights_nm = Array2::from_shape_vec((2, 2), vec![3.0, 1.0, 1.0, 7.0]).unwrap();
    let twisted = HeightField { heights_nm, pitch_nm: [10.0, 20.0] };
    let (planed, record) = prepare(&twisted, &config(Level::Plane)).unwrap();
    // Mean 3, slopes 2 and 2 per sample, so ±1 in each: 3-3+2, 1-3, 1-3, 7-3-2.
    assert_eq!(planed.heights_nm.as_slice().unwrap(), &[2.0, -2.0, -2.0, 2.0]);
    assert_eq!(record.removed_slope, [0.2, -0.1]);
    let (flat, _) = prepare(&twisted, &config(Level::Quadratic)).unwrap();
    assert_eq!(largest(&flat), 0.0);
}

#[test]
fn spikes_are_removed_and_nothing_else() {
    let mut dusty = noise([60, 40], [20.0, 20.0], 1.0, 5);
    let clean = dusty.clone();
    let dust = [[0, 0], [0, 30], [20, 59], [17, 23], [18, 23], [17, 24], [39, 11]];
    for (index, place) in dust.into_iter().enumerate() {
        dusty.heights_nm[place] += if index % 2 == 0 { 40.0 } else { -40.0 };
    }
    let despike = PrepareConfig { despike: Some(Despike { threshold_rms: 8.0 }), ..config(Level::None) };
    let (cleaned, record) = prepare(&dusty, &despike).unwrap();
    assert_eq!(record.spikes, dust.len());
    for (place, height) in cleaned.heights_nm.indexed_iter() {
        let spike = dust.contains(&[place.0, place.1]);
        let change = height - record.centring_nm - clean.heights_nm[place];
        assert!(if spike { change.abs() <= 2.0 } else { change.abs() < 1e-12 }, "{place:?}: {change}");
    }
    let (_, record) = prepare(&clean, &despike).unwrap();
    assert_eq!(record.spikes, 0);
}

#[test]
fn structure_is_not_taken_for_spikes() {
    let despike = PrepareConfig { despike: Some(Despike { threshold_rms: 3.0 }), ..config(Level::None) };
    let pits = field([64, 64], [20.0, 20.0], |x, y| {
        if x.rem_euclid(200.0) < 80.0 && y.rem_euclid(200.0) < 80.0 { -90.0 } else { 0.0 }
    });
    let lines = field([64, 64], [20.0, 20.0], |x, _| if x.rem_euclid(200.0) < 20.0 { 90.0 } else { 0.0 });
    for structure in [pits, lines] {
        assert_eq!(prepare(&structure, &despike).unwrap().1.spikes, 0);
    }
    // On perfectly flat ground a single step of one count is an outlier, and the only one.
    let mut flat = field([32, 32], [20.0, 20.0], |_, _| 7.0);
    assert_eq!(prepare(&flat, &despike).unwrap().1.spikes, 0);
    flat.heights_nm[[9, 9]] = 8.0;
    assert_eq!(prepare(&flat, &despike).unwrap().1.spikes, 1);
}

#[test]
fn unsuitable_settings_are_refused_with_their_name() {
    let rough = noise([20, 12], [20.0, 30.0], 50.0, 1);
    let refusal = |field: &HeightField, config: PrepareConfig| prepare(field, &config).unwrap_err().to_string();
    let blend = |blend_nm| PrepareConfig { blend_nm: Some(blend_nm), ..config(Level::None) };
    for blend_nm in [f64::NAN, -1.0, 0.0, 100.0, 181.0, f64::INFINITY] {
        assert!(refusal(&rough, blend(blend_nm)).contains("blend_nm"), "{blend_nm}");
    }
    assert!(prepare(&rough, &blend(180.0)).is_ok());
    for threshold_rms in [f64::NAN, -1.0, 0.0, f64::INFINITY] {
        let despike = PrepareConfig { despike: Some(Despike { threshold_rms }), ..config(Level::None) };
        assert!(refusal(&rough, despike).contains("threshold_rms"));
    }
    assert!(refusal(&noise([7, 9], [1.0, 1.0], 1.0, 1), config(Level::Rows)).contains("rows"));
    assert!(refusal(&noise([0, 9], [1.0, 1.0], 1.0, 1), config(Level::Plane)).contains("0 x 9"));
    assert!(refusal(&noise([3, 9], [1.0, f64::NAN], 1.0, 1), config(Level::Plane)).contains("pitch"));
    let mut holed = rough;
    holed.heights_nm[[3, 3]] = f64::NAN;
    assert!(refusal(&holed, config(Level::Plane)).contains("NaN"));
}
