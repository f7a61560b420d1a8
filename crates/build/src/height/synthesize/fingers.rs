//! Rows of fingers on snake scales: thin sheets that overlap like roof tiles, each ending in a fringe.
//!
//! Every sheet slopes down away from its tips (which point to +y) and dips under the next one; through the
//! notches between the fingers one sees the sheet below. Positions are jittered, rows bend, and a slow
//! undulation and a fine grain lie on top. All of it repeats on the tile.

use std::f64::consts::PI;

use fastrand::Rng;
use ndarray::Array2;

use super::grid::{Grid, length, round_heights, step};
use super::random::{Waves, bounded_normal, rough};
use diffraction_brdf::error::Result;

/// Dimensions of a fingered surface, all lengths in nm.
pub(super) struct Fingers {
    /// Mean distance of neighbouring fingers along x, and of rows along y.
    spacing_nm: [f64; 2],
    /// From the tips to the notches' closed ends.
    length_nm: f64,
    /// Radius of the rounded tips.
    tip_nm: f64,
    /// How a finger widens from tip to base: 1 straight, more: late.
    taper: f64,
    /// Standard deviation of the fingers' distances, relative to their mean.
    spacing_jitter: f64,
    /// Share of its neighbour's displacement that a finger takes over: 0 keeps a lattice, 1 none.
    taken_over: f64,
    /// Whether fingers of all rows stand in common columns, and how far they stray from these.
    columns_jitter_nm: Option<f64>,
    /// Standard deviation of the tips along y.
    tip_jitter_nm: f64,
    /// Rms displacement of columns along x and of rows along y.
    bend_nm: [f64; 2],
    /// How far a sheet falls quickly behind its tips, over which length, and its slope further on.
    drop_nm: f64,
    drop_length_nm: f64,
    slope: f64,
    /// Height of a finger's ridge above its edges at the tip and at the base.
    dome_nm: [f64; 2],
    /// Rms of the slow undulation.
    undulation_nm: f64,
    /// Rms of the grain, and its correlation lengths along x and y.
    grain_nm: f64,
    grain_length_nm: [f64; 2],
}

/// After *Elaphe guttata*: columns of long tapered fingers, each row's tips at the next row's bases.
pub(super) const CORN_SNAKE: Fingers = Fingers {
    spacing_nm: [1140.0, 2900.0],
    length_nm: 2650.0,
    tip_nm: 150.0,
    taper: 1.05,
    spacing_jitter: 0.15,
    taken_over: 0.5,
    columns_jitter_nm: Some(55.0),
    tip_jitter_nm: 230.0,
    bend_nm: [160.0, 350.0],
    drop_nm: 0.0,
    drop_length_nm: 1000.0,
    slope: 0.019,
    dome_nm: [14.0, 46.0],
    undulation_nm: 20.0,
    grain_nm: 2.5,
    grain_length_nm: [120.0, 400.0],
};

/// After *Xenopeltis unicolor*: wavy rows of short, nearly parallel fingers.
pub(super) const SUNBEAM_SNAKE: Fingers = Fingers {
    spacing_nm: [544.0, 1550.0],
    length_nm: 1180.0,
    tip_nm: 190.0,
    taper: 1.5,
    spacing_jitter: 0.14,
    taken_over: 0.9,
    columns_jitter_nm: None,
    tip_jitter_nm: 95.0,
    bend_nm: [60.0, 420.0],
    drop_nm: 90.0,
    drop_length_nm: 800.0,
    slope: 0.012,
    dome_nm: [24.0, 18.0],
    undulation_nm: 20.0,
    grain_nm: 1.5,
    grain_length_nm: [150.0, 150.0],
};

/// Half the width in nm over which a sheet's edge rises, seen from above: what a microscope's tip leaves of it.
const EDGE_NM: f64 = 65.0;
/// Largest pitch that resolves the edges.
const PITCH_MAX_NM: f64 = 100.0;
/// Jitter is cut off at this many standard deviations.
const JITTER_LIMIT: f64 = 2.5;

/// The fringe of one sheet: places of the finger tips, x within the tile and increasing.
struct Row {
    tips_nm: Vec<[f64; 2]>,
}

/// Generates the surface.
pub(super) fn generate(grid: &Grid, fingers: &Fingers, seed: u64) -> Result<Array2<f64>> {
    grid.check_pitch(PITCH_MAX_NM, "the edges of the fingers")?;
    let count = [
        grid.count(0, fingers.spacing_nm[0], 4, "a row of fingers")?,
        grid.count(1, fingers.spacing_nm[1], 3, "rows of fingers")?,
    ];
    let extent = grid.extent_nm();
    let mut rng = Rng::with_seed(seed);
    let rows = rows(fingers, extent, count, &mut rng);
    // Rows bend along x; a change of that bend along y would change their distance, so it is kept small.
    let bend_x = Waves::new(extent, [2, 3], fingers.bend_nm[0], &mut rng);
    let bend_y = Waves::new(extent, [4, 0], fingers.bend_nm[1], &mut rng);
    let shear_y = Waves::new(extent, [3, 1], 0.4 * fingers.bend_nm[1], &mut rng);
    let undulation = Waves::new(extent, [4, 4], fingers.undulation_nm, &mut rng);
    let surface = Surface { fingers, rows, extent_nm: extent };
    let mut heights = grid.sample(|x, y| {
        let place = [x + bend_x.at(x, y), y + bend_y.at(x, y) + shear_y.at(x, y)];
        surface.height_nm(place) + undulation.at(x, y)
    });
    heights += &rough(grid, fingers.grain_nm, fingers.grain_length_nm, &mut rng);
    round_heights(&mut heights);
    Ok(heights)
}

/// Places the finger tips.
fn rows(fingers: &Fingers, extent_nm: [f64; 2], count: [usize; 2], rng: &mut Rng) -> Vec<Row> {
    let columns = columns(fingers, extent_nm[0], count[0], rng);
    (0..count[1])
        .map(|row| {
            let xs = match fingers.columns_jitter_nm {
                Some(jitter) => columns.iter().map(|x| x + jitter * bounded_normal(rng, JITTER_LIMIT)).collect(),
                None => self::columns(fingers, extent_nm[0], count[0], rng),
            };
            let base = row as f64 * extent_nm[1] / count[1] as f64;
            let mut tips: Vec<[f64; 2]> = xs
                .into_iter()
                .map(|x| {
                    let y = base + fingers.tip_jitter_nm * bounded_normal(rng, JITTER_LIMIT);
                    [x.rem_euclid(extent_nm[0]), y]
                })
                .collect();
            tips.sort_by(|a, b| a[0].total_cmp(&b[0]));
            Row { tips_nm: tips }
        })
        .collect()
}

/// Places along x around a lattice that closes around the tile and starts anywhere. A place takes over part of its
/// left neighbour's displacement: order is lost over some distances, the mean distance never.
fn columns(fingers: &Fingers, width_nm: f64, count: usize, rng: &mut Rng) -> Vec<f64> {
    // Terms back until the largest share taken over, 0.9, has fallen below 0.001.
    const TERMS: usize = 66;
    let share = fingers.taken_over;
    let spacing = width_nm / count as f64;
    // Displacements are sums of r^j e[i-j], of variance s^2 / (1 - r^2) for kicks e of variance s^2; the distances
    // then have 2 s^2 / (1 + r). Kicks being limited to 2.5 s, distances stay positive for jitters up to 0.2.
    let scale = fingers.spacing_jitter * spacing * (0.5 * (1.0 + share)).sqrt();
    let kicks: Vec<f64> = (0..count).map(|_| scale * bounded_normal(rng, JITTER_LIMIT)).collect();
    let start = rng.f64() * width_nm;
    let displacement = |index: usize| {
        (0..TERMS).rev().fold(0.0, |sum, back| share * sum + kicks[(index + TERMS * count - back) % count])
    };
    (0..count).map(|index| start + index as f64 * spacing + displacement(index)).collect()
}

/// What is needed to tell the height at a place.
struct Surface<'a> {
    fingers: &'a Fingers,
    rows: Vec<Row>,
    extent_nm: [f64; 2],
}

impl Surface<'_> {
    /// Height at a place, in a plane that repeats with the tile.
    fn height_nm(&self, [x, y]: [f64; 2]) -> f64 {
        let x = x.rem_euclid(self.extent_nm[0]);
        let spacing = self.extent_nm[1] / self.rows.len() as f64;
        let above = (y / spacing).floor() as i64;
        // Sheets with their tips further up lie below. Tips stray less than half a row, so the sheet three rows
        // up covers this place for certain.
        let mut height = self.sheet(above + 3, x, y).height_nm;
        for row in (above..above + 3).rev() {
            let sheet = self.sheet(row, x, y);
            height += sheet.cover * (sheet.height_nm - height);
        }
        height
    }

    /// One sheet at a place: how much of the place it covers, and its height there.
    fn sheet(&self, row: i64, x: f64, y: f64) -> Sheet {
        let fingers = self.fingers;
        let count = self.rows.len() as i64;
        let tips = &self.rows[row.rem_euclid(count) as usize].tips_nm;
        // Place relative to the copy of the tile that holds this row.
        let y = y - row.div_euclid(count) as f64 * self.extent_nm[1];
        let [left, right] = neighbours(tips, self.extent_nm[0], x);
        let gap = right[0] - left[0];
        let across = (x - left[0]) / gap;
        let outline = [left, right].map(|tip| inside_finger(fingers, x - tip[0], tip[1] - y, 0.5 * gap));
        let notch = 0.5 * (left[1] + right[1]) - fingers.length_nm;
        let inside = smooth_max(smooth_max(outline[0], outline[1]), notch - y);
        let behind = left[1] + step(2.0 * across - 1.0) * (right[1] - left[1]) - y;
        Sheet { cover: step(inside / EDGE_NM), height_nm: profile(fingers, behind, across) }
    }
}

struct Sheet {
    cover: f64,
    height_nm: f64,
}

/// The fingers left and right of a place, around the tile.
fn neighbours(tips: &[[f64; 2]], width_nm: f64, x: f64) -> [[f64; 2]; 2] {
    let next = tips.partition_point(|tip| tip[0] <= x);
    let last = tips.len() - 1;
    let left = if next == 0 { [tips[last][0] - width_nm, tips[last][1]] } else { tips[next - 1] };
    let right = if next > last { [tips[0][0] + width_nm, tips[0][1]] } else { tips[next] };
    [left, right]
}

/// Distance in nm inside a finger's outline, `x` from its axis and `behind` its tip: a round tip, then sides
/// that meet the neighbour's (`half` away) at the notch.
fn inside_finger(fingers: &Fingers, x: f64, behind: f64, half: f64) -> f64 {
    let tip = fingers.tip_nm.min(0.9 * half);
    if behind < tip {
        return tip - length(x, tip - behind);
    }
    let t = (behind - tip) / (fingers.length_nm - tip);
    tip + (half - tip) * libm::pow(t, fingers.taper) - x.abs()
}

/// Height of a sheet `behind` its tips, at a share `across` of the way from one finger to the next.
fn profile(fingers: &Fingers, behind: f64, across: f64) -> f64 {
    let quick = fingers.drop_nm * (1.0 - libm::exp(-behind.max(0.0) / fingers.drop_length_nm));
    let t = (behind / fingers.length_nm).clamp(0.0, 1.0);
    let dome = fingers.dome_nm[0] + t * (fingers.dome_nm[1] - fingers.dome_nm[0]);
    // Under the next row the ridges flatten out.
    let fade = 1.0 - step((behind - 1.5 * fingers.length_nm) / (0.5 * fingers.length_nm));
    let ridge = libm::cos(PI * across);
    dome * fade * ridge * ridge - quick - fingers.slope * behind
}

/// The larger of two lengths in nm, rounded where they are nearly equal.
fn smooth_max(a: f64, b: f64) -> f64 {
    const ROUND_NM: f64 = 50.0;
    let near = (ROUND_NM - (a - b).abs()).max(0.0);
    a.max(b) + 0.25 * near * near / ROUND_NM
}
