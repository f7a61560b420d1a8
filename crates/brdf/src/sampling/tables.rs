//! Directions drawn from the tables: cells of the (u, v) grid, as far as they lie above the horizon for the viewer.
//!
//! For a viewer, the directions to the light fill the disc of radius 1 about `-wo` in (u, v). A band of rows is chosen in
//! proportion to the tables within its widest chord of that disc, then a row likewise, `v` evenly in the row, and `u`
//! within the chord at `v` itself. Sums along rows are kept, so that a piece of a chord costs two look-ups.
//!
//! Cells hold the BRDF times the cosine, and are to be drawn in proportion to it over solid angle: with
//! `wi = (-s, y, ...)`, `s = h sin φ`, `h = sqrt(1 - y²)`, that is `dy dφ = dv du / cos_theta_i`. So a chord is cut into
//! [`PIECES`] pieces that narrow towards its ends by a factor of four, within which the cosine varies by two; in a piece, `u`
//! is drawn in proportion to the cells, and in those at the ends, far narrower than a cell, evenly in `φ`.

use std::f64::consts::TAU;
use std::ops::Range;

use ndarray::Array3;

use super::choice::{choose, probability};
use super::nodes::{NODES, node_cosine};
use crate::chebyshev;
use crate::direction::{Vec3, max_abs_w};
use crate::table_set::{Basis, TableSet};

/// Values of `t` at which the tables are looked at.
const T_VALUES: usize = 9;
/// Rings of the radius in (u, v) at which azimuths are averaged.
const RINGS: usize = 128;
/// Azimuths of the viewer that are averaged.
const AZIMUTHS: usize = 32;
/// Cosines and `|w|` below this count as this where means over azimuth are made of what grows without bound.
const COSINE_MIN: f64 = 0.1;
/// What a cell counts of its largest value over `t`, beside its mean.
const PEAK_SHARE: f64 = 0.2;
/// Pieces of a chord: the edges of half of them lie at `h (1 - 4^-k)` from its middle, and at `h`.
const PIECES: usize = 12;

#[derive(Debug, Clone)]
pub(super) struct TableDensity {
    /// First column's u, first row's v, and a cell's side.
    pub(super) first: [f64; 2],
    pub(super) step: f64,
    /// Cells along v and along u.
    pub(super) rows: usize,
    pub(super) columns: usize,
    /// Rows of a band.
    pub(super) band: usize,
    pub(super) nodes: Vec<Node>,
}

/// For one polar angle of the viewer.
#[derive(Debug, Clone)]
pub(super) struct Node {
    /// Sums of the cells up to each column edge, `[row][columns + 1]`.
    pub(super) rows: Vec<f32>,
    /// The same of bands of rows.
    pub(super) bands: Vec<f32>,
    /// X + Y + Z that the tables reflect of an even sky, averaged over azimuth.
    reflected: f64,
}

/// How the tables at each `t` count, by ring of the radius: for a viewer at a node, averaged over its azimuth.
struct Average {
    weights: Vec<[f64; T_VALUES]>,
    /// The same without the light's cosine, and of all azimuths rather than those that see the ring.
    reflected: Vec<[f64; T_VALUES]>,
}

/// The part of a row that is above the horizon and within the grid, in pieces.
struct Chord {
    /// Half the length of the whole.
    half: f64,
    /// `s` at the edges of the pieces, from low to high; `φ` there; and the sum of the cells up to there.
    edges: [f64; PIECES + 1],
    phi: [f64; PIECES + 1],
    sums: [f64; PIECES + 1],
}

impl Chord {
    /// Whether a piece is drawn from evenly in `φ`.
    fn is_even(&self, piece: usize) -> bool {
        piece == 0 || piece == PIECES - 1 || self.is_flat()
    }

    /// Whether all cells are zero.
    fn is_flat(&self) -> bool {
        self.sums[PIECES].partial_cmp(&self.sums[0]) != Some(std::cmp::Ordering::Greater)
    }

    fn mass(&self, piece: usize) -> f64 {
        let width = self.edges[piece + 1] - self.edges[piece];
        if width.is_nan() || width <= 0.0 {
            return 0.0;
        }
        let sum = if self.is_flat() { width } else { self.sums[piece + 1] - self.sums[piece] };
        sum * (self.phi[piece + 1] - self.phi[piece]) / width
    }
}

impl TableDensity {
    /// Cells as fine as the texels, or blocks of these where more than `cells_max` lie side by side.
    pub fn new(set: &TableSet, cells_max: usize) -> Self {
        let (texel_rows, texel_columns, _) = set.tables[0].dim();
        let texel_cells = [texel_rows - 1, texel_columns - 1];
        let block = texel_cells[0].max(texel_cells[1]).div_ceil(cells_max);
        let [rows, columns] = texel_cells.map(|cells| cells.div_ceil(block));
        let origin = set.restriction.as_ref().map_or([0; 2], |restriction| restriction.first);
        let step = 4.0 / (set.size() - 1) as f64;
        let first = [-2.0 + step * origin[1] as f64, 2.0 - step * origin[0] as f64];
        let band = (rows as f64).sqrt().ceil() as usize;
        let averages: Vec<Average> = (0..NODES).map(|node| average(set, node)).collect();

        let mut texels = vec![vec![0f32; texel_rows * texel_columns]; NODES];
        let mut reflected = [0.0; NODES];
        let (at_each_t, mut scratch) = (AtEachT::new(set), Vec::new());
        for row in 0..texel_rows {
            for column in 0..texel_columns {
                let radius = (first[0] + step * column as f64).hypot(first[1] - step * row as f64);
                if radius > 2.0 {
                    continue;
                }
                let values = at_each_t.values([row, column], radius, &mut scratch);
                let ring = ring_of(radius);
                for (node, average) in averages.iter().enumerate() {
                    let mean = |weights: &[f64; T_VALUES]| {
                        weights.iter().zip(values).map(|(weight, value)| weight * value).sum::<f64>()
                    };
                    let weights = &average.weights[ring];
                    let peak = values.iter().fold(0f64, |peak, value| peak.max(*value)) * weights.iter().sum::<f64>();
                    texels[node][row * texel_columns + column] = (mean(weights) + PEAK_SHARE * peak) as f32;
                    reflected[node] += mean(&average.reflected[ring]) * step * step;
                }
            }
        }
        let nodes = texels.iter().zip(reflected).map(|(texels, reflected)| {
            let (rows, bands) = sums(&cells(texels, texel_cells, block), [rows, columns], band);
            Node { rows, bands, reflected }
        });
        Self { first, step: block as f64 * step, rows, columns, band, nodes: nodes.collect() }
    }

    /// X + Y + Z that the tables reflect of an even sky, at a node.
    pub fn reflected(&self, node: usize) -> f64 {
        self.nodes[node].reflected
    }

    pub fn sample(&self, node: usize, wo: Vec3, [u1, u2]: [f64; 2]) -> Option<Vec3> {
        let node = &self.nodes[node];
        let all = self.seen_rows(wo)?;
        let (band, rest) = choose(self.bands(&all), u1, |band| self.band_mass(node, band, &all, wo));
        let (row, rest) = choose(self.rows_of(band, &all), rest, |row| self.row_mass(node, row, &all, wo));
        let [top, bottom] = within(row, 1, &all);
        let place = top + rest * (bottom - top);
        let sums = self.row(node, row);
        let chord = self.chord(place, sums, wo);
        let (piece, rest) = choose(0..PIECES, u2, |piece| chord.mass(piece));
        let between = |values: &[f64]| values[piece] + rest * (values[piece + 1] - values[piece]);
        let (s, cos) = if chord.is_even(piece) {
            let (sin, cos) = between(&chord.phi).sin_cos();
            (chord.half * sin, chord.half * cos)
        } else {
            let s = self.s(inverse(sums, between(&chord.sums)), wo);
            let s = s.clamp(chord.edges[piece], chord.edges[piece + 1]);
            (s, (chord.half * chord.half - s * s).max(0.0).sqrt())
        };
        Some([-s, self.wi_y(place, wo), cos])
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
        if !(bands.contains(&band) && rows.contains(&row) && bottom > top) {
            return 0.0;
        }
        let sums = self.row(node, row);
        let chord = self.chord(place, sums, wo);
        let piece = chord.edges.partition_point(|edge| *edge <= -wi[0]).clamp(1, PIECES) - 1;
        let width = chord.phi[piece + 1] - chord.phi[piece];
        let mass = chord.mass(piece);
        if !(mass > 0.0 && width > 0.0) {
            return 0.0;
        }
        let along = if chord.is_even(piece) {
            1.0 / width
        } else {
            let cell = f64::from(sums[x as usize + 1] - sums[x as usize]);
            cell / (chord.sums[piece + 1] - chord.sums[piece]) / self.step * wi[2]
        };
        let along = along * probability(0..PIECES, piece, |piece| chord.mass(piece));
        let down = probability(bands, band, |band| self.band_mass(node, band, &all, wo))
            * probability(rows, row, |row| self.row_mass(node, row, &all, wo))
            / (bottom - top);
        along * down / self.step
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

    /// Sum within the widest chord between two places, over `φ`, times their distance.
    fn mass(&self, sums: &[f32], [top, bottom]: [f64; 2], wo: Vec3) -> f64 {
        if bottom.partial_cmp(&top) != Some(std::cmp::Ordering::Greater) {
            return 0.0;
        }
        // The place that lies nearest to the disc's middle.
        let middle = (self.first[1] + wo[1]) / self.step;
        let (half, [low, high]) = self.ends(middle.clamp(top, bottom), wo);
        if high.partial_cmp(&low) != Some(std::cmp::Ordering::Greater) {
            return 0.0;
        }
        let [below, above] = [low, high].map(|s| sum_at(sums, self.column(s, wo)));
        (above - below) * (angle(high, half) - angle(low, half)) / (high - low) * (bottom - top)
    }

    /// Half the chord at a place along v, and the `s` between which it lies in the grid.
    fn ends(&self, place: f64, wo: Vec3) -> (f64, [f64; 2]) {
        let wi_y = self.wi_y(place, wo);
        let half = (1.0 - wi_y * wi_y).max(0.0).sqrt();
        (half, [self.s(0.0, wo).max(-half), self.s(self.columns as f64, wo).min(half)])
    }

    fn chord(&self, place: f64, row: &[f32], wo: Vec3) -> Chord {
        let (half, [low, high]) = self.ends(place, wo);
        let edge = |k: usize| {
            let from_middle = k.abs_diff(PIECES / 2);
            let share = if from_middle == PIECES / 2 { 1.0 } else { 1.0 - 0.25f64.powi(from_middle as i32) };
            let s = if k < PIECES / 2 { -half * share } else { half * share };
            s.min(high).max(low)
        };
        let edges: [f64; PIECES + 1] = std::array::from_fn(edge);
        Chord { half, edges, phi: edges.map(|s| angle(s, half)), sums: edges.map(|s| sum_at(row, self.column(s, wo))) }
    }

    /// `s = -wi_x` at a place between the edges of the grid, and back.
    fn s(&self, column: f64, wo: Vec3) -> f64 {
        self.first[0] + column * self.step + wo[0]
    }

    fn column(&self, s: f64, wo: Vec3) -> f64 {
        ((s - wo[0] - self.first[0]) / self.step).clamp(0.0, self.columns as f64)
    }

    fn wi_y(&self, place: f64, wo: Vec3) -> f64 {
        place * self.step - self.first[1] - wo[1]
    }
}

/// `φ` at `s = half sin φ`.
fn angle(s: f64, half: f64) -> f64 {
    if half > 0.0 { (s / half).clamp(-1.0, 1.0).asin() } else { 0.0 }
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

/// Cells of `block` by `block` texels each. Between four texels there is the largest of them, so that no look-up lies far above; a
/// block has their root mean square, with which weights of an even density in it vary least.
fn cells(texels: &[f32], [rows, columns]: [usize; 2], block: usize) -> Vec<f32> {
    let texel = |row: usize, column: usize| texels[row * (columns + 1) + column];
    let [out_rows, out_columns] = [rows, columns].map(|cells| cells.div_ceil(block));
    let mut squares = vec![0f64; out_rows * out_columns];
    for row in 0..rows {
        for column in 0..columns {
            let upper = texel(row, column).max(texel(row, column + 1));
            let lower = texel(row + 1, column).max(texel(row + 1, column + 1));
            squares[row / block * out_columns + column / block] += f64::from(upper.max(lower)).powi(2);
        }
    }
    squares.into_iter().map(|sum| sum.sqrt() as f32 / block as f32).collect()
}

/// Sums along rows of cells, and along bands of rows.
fn sums(cells: &[f32], [rows, columns]: [usize; 2], band: usize) -> (Vec<f32>, Vec<f32>) {
    let mut along = Vec::with_capacity(rows * (columns + 1));
    let mut bands = Vec::new();
    for first in (0..rows).step_by(band) {
        let mut total = vec![0.0; columns + 1];
        for row in first..(first + band).min(rows) {
            let mut sum = 0.0;
            along.push(0.0);
            for column in 0..columns {
                sum += f64::from(cells[row * columns + column]);
                along.push(sum as f32);
                total[column + 1] += sum;
            }
        }
        bands.extend(total.iter().map(|sum| *sum as f32));
    }
    (along, bands)
}

/// X + Y + Z of the tables at each `t`, texel by texel.
struct AtEachT<'a> {
    set: &'a TableSet,
    /// Polynomials at each `t`, where they do not depend on the texel.
    basis: Option<Vec<Vec<f64>>>,
}

impl<'a> AtEachT<'a> {
    fn new(set: &'a TableSet) -> Self {
        let at = |k: usize| chebyshev::shifted_values(set.tables.len(), k as f64 / (T_VALUES - 1) as f64);
        let basis =
            (set.restriction.is_none() && set.basis == Basis::Chebyshev).then(|| (0..T_VALUES).map(at).collect());
        Self { set, basis }
    }

    /// 0 where negative, and where there is no answer. `sums` is scratch.
    fn values(&self, [row, column]: [usize; 2], radius: f64, sums: &mut Vec<f64>) -> [f64; T_VALUES] {
        sums.clear();
        let channels =
            |table: &Array3<f32>| (0..3).map(|channel| f64::from(table[[row, column, channel]])).sum::<f64>();
        sums.extend(self.set.tables.iter().map(channels));
        let value = |basis: &[f64]| sums.iter().zip(basis).map(|(sum, factor)| sum * factor).sum::<f64>().max(0.0);
        let mut values = [0.0; T_VALUES];
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
        let t = k as f64 / (T_VALUES - 1) as f64;
        let mut share = t;
        if let Some(restriction) = &self.set.restriction {
            let [low, high, there] = [0, 1, 2].map(|n| f64::from(restriction.range[[row, column, n]]));
            // A value of `t` stands for its surroundings, of which any part may be asked for.
            let half = 0.5 / (T_VALUES - 1) as f64;
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

/// For viewers between the edges of a node: those at its lower edge see rings that others do not.
fn average(set: &TableSet, node: usize) -> Average {
    let mut average = Average { weights: vec![[0.0; T_VALUES]; RINGS], reflected: vec![[0.0; T_VALUES]; RINGS] };
    let middle = node_cosine(node);
    let edges = [node, node + 1].map(|edge| (edge as f64 / NODES as f64).powi(2).max(1e-3));
    for ring in 0..RINGS {
        let radius = 2.0 * (ring as f64 + 0.5) / RINGS as f64;
        let mut seen = 0;
        for cos_o in [edges[0], middle, edges[1]] {
            let sin_o = (1.0 - cos_o * cos_o).sqrt();
            for azimuth in 0..AZIMUTHS {
                let (sin, cos) = (TAU * azimuth as f64 / AZIMUTHS as f64).sin_cos();
                let wo = [sin_o * cos, sin_o * sin, cos_o];
                let cos2 = 1.0 - (radius + wo[0]).powi(2) - wo[1] * wo[1];
                if cos2 <= 0.0 {
                    continue;
                }
                seen += 1;
                let cos_i = cos2.sqrt();
                let front = set.front_factor.diffuse([-radius - wo[0], -wo[1], cos_i], wo);
                let place = ((cos_i + cos_o) / max_abs_w(radius)).min(1.0) * (T_VALUES - 1) as f64;
                let below = (place as usize).min(T_VALUES - 2);
                let share = place - below as f64;
                for (k, share) in [(below, 1.0 - share), (below + 1, share)] {
                    average.weights[ring][k] += share * front * cos_i * cos_o;
                    if cos_o == middle {
                        let reflected = front * (cos_i / COSINE_MIN).min(1.0) / AZIMUTHS as f64;
                        average.reflected[ring][k] += share * reflected;
                    }
                }
            }
        }
        match seen {
            // Out of sight but for its edge.
            0 if ring > 0 => average.weights[ring] = average.weights[ring - 1],
            _ => average.weights[ring].iter_mut().for_each(|weight| *weight /= f64::from(seen.max(1))),
        }
    }
    average
}
