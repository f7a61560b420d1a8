//! What a coverage must keep: closed cases, and random scenes for its bounds.

use super::*;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::direction::normalised_abs_w;
use half::f16;
use proptest::prelude::*;

fn grid(size: usize) -> Grid {
    Grid { size, half_width: 2.0 }
}

/// Directions anywhere in a box, at any `|q|²`.
fn anywhere(u: [f64; 2], v: [f64; 2], t: [f64; 2]) -> Directions {
    Directions { u, v, t, q_squared: [0.0, 4.0] }
}

#[test]
fn nothing_marked_is_nothing_reached() {
    let coverage = Coverage::none(grid(9));
    assert_eq!((coverage.count(), coverage.window(), coverage.hull()), (0, None, None));
    assert!(coverage.range_texture().is_none());
    assert!(coverage.with_smooth_ranges(0.1, 0.1).window().is_none());
}

#[test]
fn a_mark_holds_the_four_texels_of_its_look_up() {
    // Texels lie 0.5 apart: u = 0.3 between columns 4 and 5, v = 0.3 between rows 3 and 4.
    let mut coverage = Coverage::none(grid(9));
    let directions = anywhere([0.3; 2], [0.3; 2], [0.75; 2]);
    coverage.mark(&directions, 0.0);
    let found: Vec<_> = coverage.iter().collect();
    let t = [0.75; 2];
    assert_eq!(found, [(3, 4, t), (3, 5, t), (4, 4, t), (4, 5, t)]);
    coverage.mark(&directions, 1.0);
    assert_eq!(coverage.count(), 16);
    // A mark on a texel's centre keeps its neighbours: a reader's rounding may fall into either cell.
    let mut centred = Coverage::none(grid(9));
    centred.mark(&anywhere([0.5; 2], [0.0; 2], [0.5; 2]), 0.0);
    assert_eq!(centred.count(), 9);
}

#[test]
fn runs_cut_rings_out_of_what_is_reached() {
    let whole = Texels::whole(grid(41));
    let mut coverage = Coverage::none(grid(41));
    coverage.mark(&anywhere([-2.0, 2.0], [-2.0, 2.0], [0.0, 1.0]), 0.0);
    let reached = coverage.texels();
    for row in 0..41 {
        for annulus in [[0.0, 0.33], [0.33, 1.2], [1.2, 2.01]] {
            let mut columns: Vec<usize> = whole.runs_in(row, annulus).into_iter().flatten().collect();
            assert_eq!(columns, reached.runs_in(row, annulus).into_iter().flatten().collect::<Vec<_>>());
            columns.retain(|&column| {
                let radius = whole.grid.u(column).hypot(whole.grid.v(row));
                !(radius >= annulus[0] && radius < annulus[1])
            });
            assert!(columns.is_empty(), "row {row}, ring {annulus:?}: {columns:?} lie outside");
        }
    }
}

proptest! {
    /// Every texel of a coverage lies in exactly one ring's runs, and nothing else does.
    #[test]
    fn runs_hold_each_texel_once(marks in proptest::collection::vec((-2.0..2.0f64, -2.0..2.0f64), 1..20)) {
        let mut coverage = Coverage::none(grid(31));
        for (u, v) in marks {
            coverage.mark(&anywhere([u, u + 0.1], [v, v + 0.2], [0.5; 2]), 0.0);
        }
        let texels = coverage.texels();
        let mut count = vec![0; 31 * 31];
        for row in 0..31 {
            for annulus in [[0.0, 0.71], [0.71, 1.53], [1.53, 3.0]] {
                for column in texels.runs_in(row, annulus).into_iter().flatten() {
                    count[row * 31 + column] += 1;
                }
            }
        }
        for (index, count) in count.into_iter().enumerate() {
            prop_assert_eq!(count, usize::from(coverage.covers(index / 31, index % 31)));
        }
    }

    /// Smooth ranges hold the ranges they are made from, and differ by no more than asked from texel to texel.
    #[test]
    fn ranges_widen_until_they_are_smooth(
        marks in proptest::collection::vec((-1.9..1.9f64, -1.9..1.9f64, 0.0..1.0f64), 1..30), slope in 0.01..0.5f64,
    ) {
        let mut coverage = Coverage::none(grid(21));
        for (u, v, t) in marks {
            coverage.mark(&anywhere([u; 2], [v; 2], [t; 2]), 0.0);
        }
        let smooth = coverage.clone().with_smooth_ranges(0.01, slope);
        prop_assert_eq!(smooth.count(), coverage.count());
        for (row, column, [low, high]) in smooth.iter() {
            let [from, to] = coverage.range(row, column);
            prop_assert!(low <= (from - 0.01).max(0.0) + 1e-6 && high >= (to + 0.01).min(1.0) - 1e-6);
            for (r, c) in [(row + 1, column), (row, column + 1)] {
                if r < 21 && c < 21 && smooth.covers(r, c) {
                    let [a, b] = smooth.range(r, c);
                    // Half floats below 1 lie up to 2^-11 apart. What `|w|` can be falls outwards: the inner texel's counts.
                    let radius = |row, column| smooth.grid.u(column).hypot(smooth.grid.v(row));
                    let reach = max_abs_w(radius(row, column)).max(max_abs_w(radius(r, c)));
                    let step = slope * 2.0 / reach + 5e-4;
                    prop_assert!((a - low).abs() < step && (b - high).abs() < step);
                    prop_assert!([low, high].iter().all(|&x| f64::from(f16::from_f64(x)) == x));
                }
            }
        }
    }

    /// Wherever a marked direction is looked up, the range between the texels holds its `t`.
    #[test]
    fn look_ups_lie_within_their_range(
        marks in proptest::collection::vec((-1.9..1.9f64, -1.9..1.9f64, 0.0..1.0f64), 1..30),
    ) {
        let mut coverage = Coverage::none(grid(21));
        // Nothing lies beyond the disc.
        let marks: Vec<_> = marks.into_iter().filter(|(u, v, _)| u.hypot(*v) < 2.0).collect();
        for &(u, v, t) in &marks {
            coverage.mark(&anywhere([u; 2], [v; 2], [t; 2]), 0.0);
        }
        let coverage = coverage.with_smooth_ranges(0.002, 0.05);
        for (u, v, t) in marks {
            let at = |x: f64| (x + 2.0) / coverage.grid.texel();
            let (x, y) = (at(u), at(-v));
            let (column, row) = (x as usize, y as usize);
            let [fx, fy] = [x - column as f64, y - row as f64];
            let mut range = [0.0; 2];
            for (r, c, share) in [
                (row, column, (1.0 - fx) * (1.0 - fy)),
                (row, column + 1, fx * (1.0 - fy)),
                (row + 1, column, (1.0 - fx) * fy),
                (row + 1, column + 1, fx * fy),
            ] {
                prop_assert!(coverage.covers(r, c));
                let [low, high] = coverage.range(r, c);
                range[0] += share * low;
                range[1] += share * high;
            }
            prop_assert!(range[0] < t + 1e-9 && t - 1e-9 < range[1]);
        }
    }

    /// Where `|q|²` is known, every direction of a box is covered at its own `t`, and at few others.
    #[test]
    fn a_known_length_of_q_ties_t_to_the_radius(
        q_squared in 0.1..4.0f64, spread in 0.0..0.05f64, u in -1.9..1.9f64, v in -1.9..1.9f64, side in 0.0..1.5f64,
        places in proptest::collection::vec((0.0..1.0f64, 0.0..1.0f64, 0.0..1.0f64), 40),
    ) {
        let mut coverage = Coverage::none(grid(201));
        let band = [q_squared, (q_squared + spread).min(4.0)];
        let directions = Directions { u: [u, u + side], v: [v, v + side], t: [0.0, 1.0], q_squared: band };
        coverage.mark(&directions, 0.0);
        for (x, y, share) in places {
            let [u, v] = [u + x * side, v + y * side];
            let q_squared = band[0] + share * (band[1] - band[0]);
            let w_squared = q_squared - u * u - v * v;
            if w_squared < 0.0 || u.abs().max(v.abs()) > 2.0 {
                continue;
            }
            let t = normalised_abs_w([u, v, -w_squared.sqrt()]);
            let at = |x: f64| ((x + 2.0) / coverage.grid.texel()) as usize;
            for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(r, c)| (at(-v) + r, at(u) + c)) {
                prop_assert!(coverage.covers(row, column));
                let [low, high] = coverage.range(row, column);
                prop_assert!(low - 1e-7 <= t && t <= high + 1e-7, "{t} in {low} to {high}");
            }
        }
        for (row, column, t) in coverage.iter() {
            let radius = coverage.grid.u(column).hypot(coverage.grid.v(row));
            prop_assert!(radius < band[1].sqrt() + 0.03);
            // Two texels' diagonals and the band: w² = |q|² - ρ² changes by no more.
            let [low, high] = coverage.abs_w_at(row, column, t);
            let change = high * high - low * low;
            prop_assert!(change <= spread + 4.0 * 0.03 * 2.0 + 1e-3, "{change}");
        }
    }
}
