//! Generated fields against closed forms, and the promise that their tiles have no seam.

use std::f64::consts::PI;

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use super::*;

/// Seeds that the irregular structures are tried with.
const SEEDS: [u64; 3] = [1, 2, 77];

fn rms(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / count;
    (values.map(|value| (value - mean) * (value - mean)).sum::<f64>() / count).sqrt()
}

/// Power at each pair of waves per tile.
fn power(field: &HeightField) -> Array2<f64> {
    let mut planner = FftPlanner::new();
    let mut data = field.heights_nm.mapv(|height| Complex::new(height, 0.0));
    for axis in 0..2 {
        let plan = planner.plan_fft_forward(data.shape()[axis]);
        for mut lane in data.lanes_mut(ndarray::Axis(axis)) {
            let mut line = lane.to_vec();
            plan.process(&mut line);
            lane.assign(&ndarray::Array1::from(line));
        }
    }
    data.mapv(|value| value.norm_sqr())
}

/// Strongest waves per tile along x and y (y up), of those with a period below `longest_nm`.
fn strongest(field: &HeightField, longest_nm: f64) -> [i64; 2] {
    let signed =
        |index: usize, count: usize| if 2 * index > count { index as i64 - count as i64 } else { index as i64 };
    let extent = field.extent_nm();
    let mut best = ([0, 0], 0.0);
    for ((row, column), power) in power(field).indexed_iter() {
        // Rows count downwards.
        let waves = [signed(column, field.size()[0]), -signed(row, field.size()[1])];
        let per_nm = (waves[0] as f64 / extent[0]).hypot(waves[1] as f64 / extent[1]);
        if per_nm * longest_nm > 1.0 && *power > best.1 {
            best = (waves, *power);
        }
    }
    best.0
}

fn period_nm(field: &HeightField, waves: [i64; 2]) -> f64 {
    let extent = field.extent_nm();
    1.0 / (waves[0] as f64 / extent[0]).hypot(waves[1] as f64 / extent[1])
}

/// Largest share by which the second differences across the tile's edges exceed the largest inside. Unlike
/// steps these are small on slopes, so that a kink counts as well as a jump.
fn seam(field: &HeightField) -> f64 {
    let [nx, ny] = field.size();
    let at = |row: usize, column: usize| field.heights_nm[[row % ny, column % nx]];
    let mut inside: f64 = 0.0;
    let mut across: f64 = 0.0;
    for row in 0..ny {
        for column in 0..nx {
            let along_x = (at(row, column) - 2.0 * at(row, column + 1) + at(row, column + 2)).abs();
            let along_y = (at(row, column) - 2.0 * at(row + 1, column) + at(row + 2, column)).abs();
            for (bend, wraps) in [(along_x, column + 2 >= nx), (along_y, row + 2 >= ny)] {
                let most = if wraps { &mut across } else { &mut inside };
                *most = most.max(bend);
            }
        }
    }
    across / inside
}

#[test]
fn a_sinusoid_meets_its_closed_forms_and_points_up() {
    // The tile holds 3 periods along x and 4 along y: direction atan2(4 / Y, 3 / X).
    let (size, pitch) = ([96, 160], [20.0, 15.0]);
    let vector = [3.0 / (96.0 * 20.0), 4.0 / (160.0 * 15.0)];
    let period = 1.0 / f64::hypot(vector[0], vector[1]);
    let direction = vector[1].atan2(vector[0]) * 180.0 / PI;
    let sinusoid = Structure::Sinusoid { period_nm: period, amplitude_nm: 30.0, direction_deg: direction };
    let field = synthesize(&sinusoid, size, pitch).unwrap();
    assert!(sinusoid.repeats(size, pitch));
    // Over whole periods the sums of cos and cos^2 are exact but for rounding.
    let measured = rms(field.heights_nm.iter().copied());
    assert!((measured - 30.0 / 2f64.sqrt()).abs() < 1e-9, "{measured}");
    // The spectrum has the pair (k, -k) of equal power; only the relative sign tells up from down.
    let waves = strongest(&field, 1e9);
    assert!(waves == [3, 4] || waves == [-3, -4], "{waves:?}");
    let mirrored = Structure::Sinusoid { period_nm: period, amplitude_nm: 30.0, direction_deg: -direction };
    let waves = strongest(&synthesize(&mirrored, size, pitch).unwrap(), 1e9);
    assert!(waves == [3, -4] || waves == [-3, 4], "{waves:?}");
    assert!(!sinusoid.repeats([97, 160], pitch) && !sinusoid.repeats(size, [20.0, 15.1]));
}

#[test]
fn gratings_along_the_axes_repeat_for_any_quarter_turn() {
    for quarter in -4..=4 {
        let direction_deg = 90.0 * f64::from(quarter);
        let grating = Structure::Sinusoid { period_nm: 800.0, amplitude_nm: 10.0, direction_deg };
        assert!(grating.repeats([64, 64], [50.0, 50.0]));
        let field = synthesize(&grating, [64, 64], [50.0; 2]).unwrap();
        let waves = strongest(&field, 1e9).map(i64::abs);
        assert_eq!(waves, if quarter % 2 == 0 { [4, 0] } else { [0, 4] });
    }
}

#[test]
fn a_sawtooth_rises_evenly_and_falls_once_a_period() {
    let blazed = Structure::Blazed { period_nm: 2500.0, depth_nm: 250.0 };
    let field = synthesize(&blazed, [500, 2], [50.0; 2]).unwrap();
    for (column, height) in field.heights_nm.row(1).iter().enumerate() {
        // Mean over the cell from 50 column to 50 column + 50, at a slope of 0.1.
        let expected = 5.0 * (column % 50) as f64 + 2.5;
        assert!((height - expected).abs() < 1e-9, "{column}: {height}");
    }
    // Where cells straddle the edge the mean height is still half the depth.
    let odd = synthesize(&blazed, [625, 1], [2500.0 * 16.0 / 625.0; 2]).unwrap();
    assert!((odd.heights_nm.mean().unwrap() - 125.0).abs() < 1e-9);
}

#[test]
fn a_rectangular_grating_has_its_duty_at_any_pitch() {
    // 7 periods on 100 samples: most edges fall inside cells.
    let lamellar = Structure::Lamellar { period_nm: 1000.0, depth_nm: 80.0, duty: 0.3 };
    let field = synthesize(&lamellar, [100, 3], [70.0, 70.0]).unwrap();
    assert!(lamellar.repeats([100, 3], [70.0, 70.0]));
    assert!((field.heights_nm.mean().unwrap() - 24.0).abs() < 1e-9);
    assert!(field.heights_nm.iter().all(|height| (-1e-9..=80.0 + 1e-9).contains(height)));
    let whole = field.heights_nm.iter().filter(|height| **height == 0.0 || (**height - 80.0).abs() < 1e-9).count();
    // Each period has two edges, each inside one cell at most.
    assert!(whole >= 3 * (100 - 14), "{whole}");
}

#[test]
fn a_rough_surface_has_its_rms_and_correlation_length() {
    // 2048 correlation lengths squared: the estimated autocorrelation has an error of about 1/sqrt(2048) = 0.022.
    let (size, pitch) = ([512, 256], [25.0, 50.0]);
    let rough = Structure::GaussianRough { rms_nm: 12.0, correlation_length_nm: 200.0, seed: 3 };
    let field = synthesize(&rough, size, pitch).unwrap();
    assert!((rms(field.heights_nm.iter().copied()) - 12.0).abs() < 1e-9);
    let at_lag = |dx: usize, dy: usize| {
        let product = |((row, column), height): ((usize, usize), &f64)| {
            height * field.heights_nm[[(row + dy) % size[1], (column + dx) % size[0]]]
        };
        field.heights_nm.indexed_iter().map(product).sum::<f64>() / field.heights_nm.len() as f64 / 144.0
    };
    for (dx, dy, lengths) in [(4, 0, 0.5), (8, 0, 1.0), (0, 4, 1.0), (0, 2, 0.5), (16, 0, 2.0), (8, 4, 2f64.sqrt())] {
        let expected = libm::exp(-lengths * lengths);
        assert!((at_lag(dx, dy) - expected).abs() < 0.05, "{dx} {dy}: {} {expected}", at_lag(dx, dy));
    }
    // A surface twice as smooth would not pass.
    assert!((libm::exp(-0.25) - libm::exp(-1.0)) > 0.05);
    let line = synthesize(&rough, [512, 1], pitch).unwrap();
    assert!((rms(line.heights_nm.iter().copied()) - 12.0).abs() < 1e-9);
}

#[test]
fn snakes_have_their_periods_for_any_seed() {
    // Within 2 % of the published periods; the undulation above 3 um is not the structure.
    for seed in SEEDS {
        let corn = synthesize(&Structure::CornSnake { seed }, [512, 512], [62.34375; 2]).unwrap();
        let waves = strongest(&corn, 3000.0);
        assert!((period_nm(&corn, waves) / 1140.0 - 1.0).abs() < 0.02, "{seed}: {waves:?}");
        assert!(waves[0].abs() > 10 * waves[1].abs(), "{seed}: {waves:?}");
        let sunbeam = synthesize(&Structure::SunbeamSnake { seed }, [512, 512], [60.546875; 2]).unwrap();
        let waves = strongest(&sunbeam, 3000.0);
        assert!((period_nm(&sunbeam, waves) / 1550.0 - 1.0).abs() < 0.02, "{seed}: {waves:?}");
        assert!(waves[1].abs() > 4 * waves[0].abs(), "{seed}: {waves:?}");
        for field in [corn, sunbeam] {
            let measured = rms(field.heights_nm.iter().copied());
            assert!((26.0..48.0).contains(&measured), "{seed}: {measured}");
        }
    }
}

#[test]
fn finger_tips_are_the_steep_upper_ends() {
    // Down the image a tip is a jump up, towards the base the sheet declines: the largest steps down the rows rise.
    for structure in [Structure::CornSnake { seed: 5 }, Structure::SunbeamSnake { seed: 5 }] {
        let field = synthesize(&structure, [256, 256], [62.5; 2]).unwrap();
        let heights = &field.heights_nm;
        let (mut up, mut down): (f64, f64) = (0.0, 0.0);
        for row in 1..256 {
            for column in 0..256 {
                let step = heights[[row, column]] - heights[[row - 1, column]];
                up = up.max(step);
                down = down.max(-step);
            }
        }
        assert!(up > 2.0 * down, "{structure:?}: {up} {down}");
    }
}

#[test]
fn pits_have_the_run_lengths_of_the_standard() {
    for seed in SEEDS {
        let field = synthesize(&Structure::CdTrack { seed }, [1024, 512], [31.25, 62.5]).unwrap();
        // 115 channel bits per track, 20 tracks of 25.6 rows; along the middle of each track.
        let bit = 32000.0 / 115.0;
        for track in 0..20 {
            let y = (f64::from(track) + 0.5) * 1600.0;
            let row = 511 - (y / 62.5) as usize;
            let deep: Vec<bool> = field.heights_nm.row(row).iter().map(|height| *height < -60.0).collect();
            let edges: Vec<usize> = (0..1024).filter(|column| deep[*column] != deep[(column + 1) % 1024]).collect();
            assert!(edges.len() >= 8 && edges.len().is_multiple_of(2), "{seed} {track}: {edges:?}");
            for (index, edge) in edges.iter().enumerate() {
                let next = edges[(index + 1) % edges.len()];
                let length = ((next + 1024 - edge) % 1024) as f64 * 31.25 / bit;
                // Either end is found to within half a sample, 0.06 bits; round ends are off the row's middle
                // by 31 nm at most, which costs a pit twice 2 nm.
                assert!((length - length.round()).abs() < 0.15, "{seed} {track}: {length}");
                assert!((3.0..=11.0).contains(&length.round()), "{seed} {track}: {length}");
            }
        }
        assert_eq!(strongest(&field, 1e9), strongest(&field, 1700.0));
        let low = field.heights_nm.iter().copied().fold(0.0, f64::min);
        assert_eq!(low, -120.0);
    }
}

#[test]
fn irregular_structures_have_no_seam_on_any_tile() {
    let rough = |seed| Structure::GaussianRough { rms_nm: 20.0, correlation_length_nm: 400.0, seed };
    for seed in SEEDS {
        for structure in
            [Structure::CornSnake { seed }, Structure::SunbeamSnake { seed }, Structure::CdTrack { seed }, rough(seed)]
        {
            let field = synthesize(&structure, [300, 263], [55.0, 70.0]).unwrap();
            assert!(structure.repeats([300, 263], [55.0, 70.0]));
            let seam_whole = seam(&field);
            assert!(seam_whole < 1.5, "{structure:?}: {seam_whole}");
        }
        // The measure sees a cut: without its last rows a smooth surface no longer continues.
        let field = synthesize(&rough(seed), [300, 263], [55.0, 70.0]).unwrap();
        let cut = field.heights_nm.view().split_at(ndarray::Axis(0), 240).0.to_owned();
        assert!(seam(&HeightField { heights_nm: cut, ..field }) > 2.0);
    }
}

#[test]
fn bundled_tiles_repeat_and_seeds_differ() {
    for (name, structure, size, pitch) in bundled() {
        assert!(structure.repeats(size, pitch), "{name}");
    }
    let one = synthesize(&Structure::CornSnake { seed: 1 }, [128, 200], [60.0; 2]).unwrap();
    assert_eq!(one, synthesize(&Structure::CornSnake { seed: 1 }, [128, 200], [60.0; 2]).unwrap());
    assert_ne!(one, synthesize(&Structure::CornSnake { seed: 2 }, [128, 200], [60.0; 2]).unwrap());
}

#[test]
fn unreasonable_requests_are_refused_with_the_reason() {
    let sinusoid = |period_nm, direction_deg| Structure::Sinusoid { period_nm, amplitude_nm: 1.0, direction_deg };
    let rough = |length| Structure::GaussianRough { rms_nm: 1.0, correlation_length_nm: length, seed: 1 };
    for (structure, size, pitch, fragment) in [
        (Structure::Flat, [0, 4], [1.0; 2], "0 x 4 samples is empty"),
        (Structure::Flat, [usize::MAX, 4], [1.0; 2], "the limit is"),
        (Structure::Flat, [1 << 14, 1 << 13], [1.0; 2], "the limit is"),
        (Structure::Flat, [4, 4], [f64::NAN, 1.0], "pitch"),
        (Structure::Flat, [4, 4], [1.0, 0.0], "pitch"),
        (sinusoid(100.0, 0.0), [4, 4], [50.0; 2], "more than two samples"),
        (sinusoid(0.0, 0.0), [4, 4], [50.0; 2], "period"),
        (sinusoid(f64::NAN, 0.0), [4, 4], [50.0; 2], "period"),
        (sinusoid(500.0, f64::INFINITY), [4, 4], [50.0; 2], "direction"),
        (Structure::Blazed { period_nm: 90.0, depth_nm: 1.0 }, [4, 4], [50.0; 2], "more than two samples"),
        (Structure::Blazed { period_nm: 900.0, depth_nm: -1.0 }, [4, 4], [50.0; 2], "depth"),
        (Structure::Lamellar { period_nm: 900.0, depth_nm: 1.0, duty: 1.0 }, [4, 4], [50.0; 2], "duty"),
        (Structure::CdTrack { seed: 1 }, [512, 512], [200.0; 2], "too coarse"),
        (Structure::CdTrack { seed: 1 }, [100, 512], [62.5; 2], "wide"),
        (Structure::CornSnake { seed: 1 }, [512, 512], [48.8, 200.0], "too coarse"),
        (Structure::CornSnake { seed: 1 }, [512, 64], [62.5; 2], "high"),
        (Structure::SunbeamSnake { seed: 1 }, [1, 512], [62.5; 2], "wide"),
        (rough(60.0), [512, 512], [50.0; 2], "correlation length"),
        (rough(9000.0), [512, 512], [50.0; 2], "correlation length"),
        (rough(200.0), [1, 1], [50.0; 2], "one sample alone"),
    ] {
        let error = synthesize(&structure, size, pitch).unwrap_err().to_string();
        assert!(error.contains(fragment), "{structure:?}: {error}");
    }
}
