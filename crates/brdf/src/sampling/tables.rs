//! Directions drawn from the tables: cells of the (u, v) grid, as far as they lie above the horizon for the viewer.
//!
//! For a viewer, the directions to the light fill the disc of radius 1 about `-wo` in (u, v). A band of rows is chosen in
//! proportion to the tables within its widest chord of that disc, then a row likewise, `v` evenly in the row, and `u` in
//! proportion to the cells of the row within the chord at `v` itself. Sums along rows are kept, so that a chord costs two
//! look-ups.

use std::ops::Range;

use ndarray::Array3;

use super::{NODES, choose, node_cosine, probability};
use crate::chebyshev;
use crate::direction::{Vec3, max_abs_w};
use crate::table_set::{Basis, TableSet};

/// Values of `t` at which the tables are looked at.
const DEPTHS: usize = 9;
/// Rings of the radius in (u, v) at which azimuths are averaged.
const RINGS: usize = 128;
/// Azimuths of the viewer that are averaged.
const AZIMUTHS: usize = 48;
/// Cosines of the light below this count as this: the front factor grows without bound towards the horizon, where the
/// even remainder of the samples takes over.
const COSINE_MIN: f64 = 0.1;

#[derive(Debug, Clone)]
pub(super) struct TableDensity {
    /// First column's u, first row's v, and the step between texels.
    first: [f64; 2],
    step: f64,
    /// Cells along v and along u.
    rows: usize,
    columns: usize,
    /// Rows of a band.
    band: usize,
    nodes: Vec<Node>,
}

/// For one polar angle of the viewer.
#[derive(Debug, Clone)]
struct Node {
    /// Sums of the cells up to each column edge, `[row][columns + 1]`.
    rows: Vec<f32>,
    /// The same of bands of rows.
    bands: Vec<f32>,
    /// X + Y + Z that the tables reflect of an even sky, averaged over azimuth.
    reflected: f64,
}

/// How the tables at each `t` count, by ring of the radius: for a viewer at a node, averaged over its azimuth.
struct Average {
    weights: Vec<[f64; DEPTHS]>,
    /// Share of the azimuths that see the ring.
    seen: Vec<f64>,
}

impl TableDensity {
    pub fn new(set: &TableSet) -> Self {
        let (texel_rows, texel_columns, _) = set.tables[0].dim();
        let [rows, columns] = [texel_rows - 1, texel_columns - 1];
        let origin = set.served.as_ref().map_or([0; 2], |served| served.first);
        let step = 4.0 / (set.size() - 1) as f64;
        let first = [-2.0 + step * origin[1] as f64, 2.0 - step * origin[0] as f64];
        let band = (rows as f64).sqrt().ceil() as usize;
        let averages: Vec<Average> = (0..NODES).map(|node| average(set, node_cosine(node))).collect();

        let mut texels = vec![vec![0f32; texel_rows * texel_columns]; NODES];
        let mut reflected = [0.0; NODES];
        let (depths, mut scratch) = (Depths::new(set), Vec::new());
        for row in 0..texel_rows {
            for column in 0..texel_columns {
                let radius = (first[0] + step * column as f64).hypot(first[1] - step * row as f64);
                if radius > 2.0 {
                    continue;
                }
                let values = depths.values([row, column], radius, &mut scratch);
                let ring = ring_of(radius);
                for (node, average) in averages.iter().enumerate() {
                    let value: f64 =
                        average.weights[ring].iter().zip(values).map(|(weight, value)| weight * value).sum();
                    texels[node][row * texel_columns + column] = value as f32;
                    reflected[node] += value * average.seen[ring] * step * step;
                }
            }
        }
        let nodes = texels.iter().zip(reflected).map(|(texels, reflected)| {
            let (rows, bands) = sums(texels, [rows, columns], band);
            Node { rows, bands, reflected }
        });
        Self { first, step, rows, columns, band, nodes: nodes.collect() }
    }

    /// X + Y + Z that the tables reflect of an even sky, at a node.
    pub fn reflected(&self, node: usize) -> f64 {
        self.nodes[node].reflected
    }

    pub fn sample(&self, node: usize, wo: Vec3, [u1, u2]: [f64; 2]) -> Option<Vec3> {
        let node = &self.nodes[node];
        let all = self.seen_rows(wo)?;
        let (band, _, rest) = choose(self.bands(&all), u1, |band| self.band_mass(node, band, &all, wo));
        let (row, _, rest) = choose(self.rows_of(band, &all), rest, |row| self.row_mass(node, row, &all, wo));
        let [top, bottom] = within(row, 1, &all);
        let place = top + rest * (bottom - top);
        let chord = self.chord(place, wo);
        let sums = self.row(node, row);
        let [low, high] = chord.map(|x| sum_at(sums, x));
        let x = if high > low {
            inverse(sums, low + u2 * (high - low)).clamp(chord[0], chord[1])
        } else if chord[1] > chord[0] {
            chord[0] + u2 * (chord[1] - chord[0])
        } else {
            return None;
        };
        let [wi_x, wi_y] = [-(self.first[0] + x * self.step) - wo[0], self.wi_y(place, wo)];
        let cos2 = 1.0 - wi_x * wi_x - wi_y * wi_y;
        (cos2 > 0.0).then(|| [wi_x, wi_y, cos2.sqrt()])
    }

    /// In 1/sr.
    pub fn pdf(&self, node: usize, wi: Vec3, wo: Vec3) -> f64 {
        let node = &self.nodes[node];
        let x = (-wi[0] - wo[0] - self.first[0]) / self.step;
        let place = (self.first[1] + wi[1] + wo[1]) / self.step;
        let inside = |at: f64, count: usize| at >= 0.0 && at < count as f64;
        if !(inside(x, self.columns) && inside(place, self.rows)) {
            return 0.0;
        }
        let Some(all) = self.seen_rows(wo) else { return 0.0 };
        let row = place as usize;
        let band = row / self.band;
        let [bands, rows] = [self.bands(&all), self.rows_of(band, &all)];
        let [top, bottom] = within(row, 1, &all);
        let chord = self.chord(place, wo);
        if !(bands.contains(&band) && rows.contains(&row) && bottom > top && chord[1] > chord[0]) {
            return 0.0;
        }
        let sums = self.row(node, row);
        let [low, high] = chord.map(|x| sum_at(sums, x));
        let along = if high > low {
            f64::from(sums[x as usize + 1] - sums[x as usize]) / (high - low)
        } else {
            1.0 / (chord[1] - chord[0])
        };
        let down = probability(bands, band, |band| self.band_mass(node, band, &all, wo))
            * probability(rows, row, |row| self.row_mass(node, row, &all, wo))
            / (bottom - top);
        along * down / (self.step * self.step) * wi[2]
    }

    /// Rows from the top, as a place between the edges of the grid, that the viewer's disc reaches.
    fn seen_rows(&self, wo: Vec3) -> Option<[f64; 2]> {
        let place = |v: f64| ((self.first[1] - v) / self.step).clamp(0.0, self.rows as f64);
        let [top, bottom] = [place(-wo[1] + 1.0), place(-wo[1] - 1.0)];
        (bottom - top > 1e-9).then_some([top, bottom])
    }

    fn bands(&self, &[top, bottom]: &[f64; 2]) -> Range<usize> {
        let row = |place: f64| (place as usize).min(self.rows - 1);
        row(top) / self.band..row(bottom) / self.band + 1
    }

    fn rows_of(&self, band: usize, &[top, bottom]: &[f64; 2]) -> Range<usize> {
        let last = ((band + 1) * self.band).min(self.rows);
        (band * self.band).max(top as usize)..last.min(bottom as usize + 1)
    }

    fn band_mass(&self, node: &Node, band: usize, all: &[f64; 2], wo: Vec3) -> f64 {
        let width = self.columns + 1;
        self.mass(&node.bands[band * width..][..width], within(band * self.band, self.band, all), wo) / self.band as f64
    }

    fn row_mass(&self, node: &Node, row: usize, all: &[f64; 2], wo: Vec3) -> f64 {
        self.mass(self.row(node, row), within(row, 1, all), wo)
    }

    fn row<'a>(&self, node: &'a Node, row: usize) -> &'a [f32] {
        let width = self.columns + 1;
        &node.rows[row * width..][..width]
    }

    /// Sum within the widest chord between two places, times their distance.
    fn mass(&self, sums: &[f32], [top, bottom]: [f64; 2], wo: Vec3) -> f64 {
        if !(bottom > top) {
            return 0.0;
        }
        // The place that lies nearest to the disc's middle.
        let middle = (self.first[1] + wo[1]) / self.step;
        let [low, high] = self.chord(middle.clamp(top, bottom), wo).map(|x| sum_at(sums, x));
        (high - low).max(0.0) * (bottom - top)
    }

    /// Columns, as places between the edges of the grid, that are above the horizon at a place along v.
    fn chord(&self, place: f64, wo: Vec3) -> [f64; 2] {
        let wi_y = self.wi_y(place, wo);
        let half = (1.0 - wi_y * wi_y).max(0.0).sqrt();
        [-half, half].map(|x| ((x - wo[0] - self.first[0]) / self.step).clamp(0.0, self.columns as f64))
    }

    fn wi_y(&self, place: f64, wo: Vec3) -> f64 {
        place * self.step - self.first[1] - wo[1]
    }
}

/// Where `count` rows from `first` on overlap with what is seen.
fn within(first: usize, count: usize, &[top, bottom]: &[f64; 2]) -> [f64; 2] {
    [(first as f64).max(top), ((first + count) as f64).min(bottom)]
}

/// The sum up to a place, linear between edges.
fn sum_at(sums: &[f32], x: f64) -> f64 {
    let cell = (x as usize).min(sums.len() - 2);
    let [before, after] = [sums[cell], sums[cell + 1]].map(f64::from);
    before + (x - cell as f64) * (after - before)
}

/// The place at which the sum is reached.
fn inverse(sums: &[f32], sum: f64) -> f64 {
    let after = sums.partition_point(|&s| f64::from(s) <= sum).clamp(1, sums.len() - 1);
    let [below, above] = [sums[after - 1], sums[after]].map(f64::from);
    (after - 1) as f64 + if above > below { ((sum - below) / (above - below)).clamp(0.0, 1.0) } else { 0.0 }
}

/// Sums along rows of cells, and along bands of rows. A cell has the largest value of its corners, so that no look-up in it
/// lies far above.
fn sums(texels: &[f32], [rows, columns]: [usize; 2], band: usize) -> (Vec<f32>, Vec<f32>) {
    let texel = |row: usize, column: usize| texels[row * (columns + 1) + column];
    let mut along = Vec::with_capacity(rows * (columns + 1));
    let mut bands = Vec::new();
    for first in (0..rows).step_by(band) {
        let mut total = vec![0.0; columns + 1];
        for row in first..(first + band).min(rows) {
            let mut sum = 0.0;
            along.push(0.0);
            for column in 0..columns {
                let upper = texel(row, column).max(texel(row, column + 1));
                let lower = texel(row + 1, column).max(texel(row + 1, column + 1));
                sum += f64::from(upper.max(lower));
                along.push(sum as f32);
                total[column + 1] += sum;
            }
        }
        bands.extend(total.iter().map(|sum| *sum as f32));
    }
    (along, bands)
}

/// X + Y + Z of the tables at the depths, texel by texel.
struct Depths<'a> {
    set: &'a TableSet,
    /// Polynomials at each depth, where they do not depend on the texel.
    basis: Option<Vec<Vec<f64>>>,
}

impl<'a> Depths<'a> {
    fn new(set: &'a TableSet) -> Self {
        let at = |k: usize| chebyshev::shifted_values(set.tables.len(), k as f64 / (DEPTHS - 1) as f64);
        let basis = (set.served.is_none() && set.basis == Basis::Chebyshev).then(|| (0..DEPTHS).map(at).collect());
        Self { set, basis }
    }

    /// 0 where negative, and where there is no answer. `sums` is scratch.
    fn values(&self, [row, column]: [usize; 2], radius: f64, sums: &mut Vec<f64>) -> [f64; DEPTHS] {
        sums.clear();
        let channels =
            |table: &Array3<f32>| (0..3).map(|channel| f64::from(table[[row, column, channel]])).sum::<f64>();
        sums.extend(self.set.tables.iter().map(channels));
        let value = |basis: &[f64]| sums.iter().zip(basis).map(|(sum, factor)| sum * factor).sum::<f64>().max(0.0);
        let mut values = [0.0; DEPTHS];
        for (k, out) in values.iter_mut().enumerate() {
            *out = match &self.basis {
                Some(basis) => value(&basis[k]),
                None => self.basis_at([row, column], radius, k).map_or(0.0, |basis| value(&basis)),
            };
        }
        values
    }

    /// What the tables at a texel are multiplied by; `None` where they have no answer.
    fn basis_at(&self, [row, column]: [usize; 2], radius: f64, k: usize) -> Option<Vec<f64>> {
        let count = self.set.tables.len();
        let t = k as f64 / (DEPTHS - 1) as f64;
        let mut share = t;
        if let Some(served) = &self.set.served {
            let [low, high, there] = [0, 1, 2].map(|n| f64::from(served.range[[row, column, n]]));
            // A depth stands for its surroundings, of which any part may be asked for.
            let half = 0.5 / (DEPTHS - 1) as f64;
            if there == 0.0 || t + half < low || t - half > high {
                return None;
            }
            share = if high > low { ((t - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
        }
        Some(match self.set.basis {
            Basis::Chebyshev => chebyshev::shifted_values(count, share),
            Basis::Taylor => {
                let w = (t * max_abs_w(radius)).max(COSINE_MIN);
                (0..count).map(|n| w.powi(n as i32 - 2)).collect()
            }
        })
    }
}

fn ring_of(radius: f64) -> usize {
    ((0.5 * radius * RINGS as f64) as usize).min(RINGS - 1)
}

fn average(set: &TableSet, cos_o: f64) -> Average {
    let sin_o = (1.0 - cos_o * cos_o).sqrt();
    let mut average = Average { weights: vec![[0.0; DEPTHS]; RINGS], seen: vec![0.0; RINGS] };
    for ring in 0..RINGS {
        let radius = 2.0 * (ring as f64 + 0.5) / RINGS as f64;
        let mut seen = 0;
        for azimuth in 0..AZIMUTHS {
            let (sin, cos) = (std::f64::consts::TAU * (azimuth as f64 + 0.5) / AZIMUTHS as f64).sin_cos();
            let wo = [sin_o * cos, sin_o * sin, cos_o];
            let cos2 = 1.0 - (radius + wo[0]).powi(2) - wo[1] * wo[1];
            if cos2 <= 0.0 {
                continue;
            }
            seen += 1;
            let cos_i = cos2.sqrt();
            let front = set.front_factor.diffuse([-radius - wo[0], -wo[1], cos_i], wo) * (cos_i / COSINE_MIN).min(1.0);
            let place = ((cos_i + cos_o) / max_abs_w(radius)).min(1.0) * (DEPTHS - 1) as f64;
            let below = (place as usize).min(DEPTHS - 2);
            let share = place - below as f64;
            average.weights[ring][below] += (1.0 - share) * front;
            average.weights[ring][below + 1] += share * front;
        }
        average.weights[ring].iter_mut().for_each(|weight| *weight /= f64::from(seen.max(1)));
        average.seen[ring] = f64::from(seen) / AZIMUTHS as f64;
    }
    average
}
