//! Directions drawn from the coherent lobe, as far as it lies above the horizon.
//!
//! In a frame with x along the viewer's projection, a direction is `wi = (h sin φ, -y, h cos φ)` with `h = sqrt(1 - y²)`, and
//! `dω = dy dφ` (Archimedes). A strip of constant `y` (the component of (u, v) across the viewer's plane) is
//! chosen first, then `φ` in the part of the strip that the lobe reaches, in proportion to what the lobe sends there.

use std::f64::consts::FRAC_PI_2;

use super::choice::{choose, probability};
use super::nodes::{NODES, node_cosine};
use crate::direction::{Vec3, max_abs_w};
use crate::front_factor::{Factor, FrontFactor, image_radius2};
use crate::table_set::Lobe;

/// Strips across the lobe.
pub(super) const STRIPS: usize = 32;
/// Cells along a strip.
const CELLS: usize = 32;
/// What every cell and every strip gets at least, as a share of the mean.
const FLOOR: f64 = 0.02;

#[derive(Debug, Clone)]
pub(super) struct LobeDensity {
    /// X + Y + Z of the coherent part, `[t][radius]`.
    sum: Vec<f32>,
    rows: usize,
    columns: usize,
    radius_max: f64,
    factor: Factor,
    pub(super) reflectance: Reflectance,
    /// What strips reflect, by the viewer's node.
    pub(super) strips: Vec<[f64; STRIPS]>,
}

/// A strip for one viewer: `φ` from `first` on in cells of `step`.
struct Strip {
    first: f64,
    step: f64,
    cells: [f64; CELLS],
}

impl Strip {
    /// What it reflects, all channels added.
    fn integral(&self) -> f64 {
        self.cells.iter().sum::<f64>() * self.step
    }
}

impl LobeDensity {
    pub fn new(lobe: &Lobe, front_factor: FrontFactor) -> Self {
        let (rows, columns, _) = lobe.coherent.dim();
        let sum = lobe.coherent.rows().into_iter().map(|xyz| xyz.sum().max(0.0)).collect();
        let reflectance = Reflectance::new(front_factor);
        let (radius_max, factor) = (lobe.radius_max, front_factor.factor);
        let mut density = Self { sum, rows, columns, radius_max, factor, reflectance, strips: Vec::new() };
        density.strips = (0..NODES).map(|node| density.strips_of(node_cosine(node))).collect();
        density
    }

    fn strips_of(&self, cos_o: f64) -> [f64; STRIPS] {
        let sin_o = (1.0 - cos_o * cos_o).sqrt();
        let width = self.strip_width();
        let integral = |k: usize| {
            let y = -self.radius_max + (k as f64 + 0.5) * width;
            self.strip([sin_o, cos_o], y).map_or(0.0, |strip| strip.integral())
        };
        let strips: [f64; STRIPS] = std::array::from_fn(integral);
        let floor = FLOOR * strips.iter().sum::<f64>() / STRIPS as f64;
        strips.map(|strip| (strip + floor) * width)
    }

    fn strip_width(&self) -> f64 {
        2.0 * self.radius_max / STRIPS as f64
    }

    /// X + Y + Z that the lobe reflects of an even sky, at a node.
    pub fn reflected(&self, node: usize) -> f64 {
        self.strips[node].iter().sum()
    }

    /// The strip at `y` for a viewer at `[sin, cos]`; `None` where it lies below the horizon.
    fn strip(&self, [sin_o, cos_o]: [f64; 2], y: f64) -> Option<Strip> {
        let h = (1.0 - y * y).max(0.0).sqrt();
        let half = (self.radius_max * self.radius_max - y * y).max(0.0).sqrt();
        let angle = |x: f64| {
            if x >= h {
                FRAC_PI_2
            } else if x <= -h {
                -FRAC_PI_2
            } else {
                (x / h).asin()
            }
        };
        let [first, last] = [angle(-sin_o - half), angle(-sin_o + half)];
        let step = (last - first) / CELLS as f64;
        if step.is_nan() || step <= 1e-12 {
            return None;
        }
        let mut cells = [0.0; CELLS];
        let mut before = self.shape([sin_o, cos_o], h, y, first);
        for (k, cell) in cells.iter_mut().enumerate() {
            let after = self.shape([sin_o, cos_o], h, y, first + (k + 1) as f64 * step);
            *cell = before.max(after);
            before = after;
        }
        let floor = FLOOR * cells.iter().sum::<f64>() / CELLS as f64;
        cells.iter_mut().for_each(|cell| *cell += floor);
        Some(Strip { first, step, cells })
    }

    /// `f cos_theta_i` of the lobe alone, all channels added, without shadowing.
    fn shape(&self, [sin_o, cos_o]: [f64; 2], h: f64, y: f64, phi: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        let (wi, wo) = ([h * sin, -y, h * cos.max(0.0)], [sin_o, 0.0, cos_o]);
        let radius2 = (wi[0] + sin_o).powi(2) + y * y;
        let w = wi[2] + cos_o;
        let q2 = radius2 + w * w;
        let direct = self.coherent(w, radius2.sqrt());
        let shape = match self.factor {
            // G cos_i / w², with G = |q|⁴ / (4 cos_i cos_o).
            Factor::Scalar => direct * q2 * q2 / (4.0 * cos_o * w * w),
            Factor::Vector => (direct + self.coherent(w, image_radius2(wi, wo).sqrt())) * wi[2],
        };
        self.reflectance.at(q2) * shape
    }

    /// The coherent part at `|w|` and a radius: linear look-up, 0 from `radius_max` on.
    fn coherent(&self, w: f64, radius: f64) -> f64 {
        if radius >= self.radius_max {
            return 0.0;
        }
        let t = (w / max_abs_w(radius)).min(1.0);
        let [y, x] = [t * (self.rows - 1) as f64, radius / self.radius_max * (self.columns - 1) as f64];
        let (row, column) = ((y as usize).min(self.rows - 2), (x as usize).min(self.columns - 2));
        let (y, x) = (y - row as f64, x - column as f64);
        let texel = |row: usize, column: usize| f64::from(self.sum[row * self.columns + column]);
        let along = |row: usize| (1.0 - x) * texel(row, column) + x * texel(row, column + 1);
        (1.0 - y) * along(row) + y * along(row + 1)
    }

    pub fn sample(&self, node: usize, wo: Vec3, [u1, u2]: [f64; 2]) -> Option<Vec3> {
        let (along, sin_o) = projection(wo);
        let strips = &self.strips[node];
        let (strip, rest) = choose(0..STRIPS, u1, |k| strips[k]);
        let y = -self.radius_max + (strip as f64 + rest) * self.strip_width();
        let strip = self.strip([sin_o, wo[2]], y)?;
        let (cell, rest) = choose(0..CELLS, u2, |k| strip.cells[k]);
        let (sin, cos) = (strip.first + (cell as f64 + rest) * strip.step).sin_cos();
        let h = (1.0 - y * y).max(0.0).sqrt();
        let [x, across] = [h * sin, -y];
        Some([x * along[0] - across * along[1], x * along[1] + across * along[0], h * cos])
    }

    /// In 1/sr.
    pub fn pdf(&self, node: usize, wi: Vec3, wo: Vec3) -> f64 {
        let (along, sin_o) = projection(wo);
        let y = wi[0] * along[1] - wi[1] * along[0];
        let place = (y + self.radius_max) / self.strip_width();
        if !(place >= 0.0 && place < STRIPS as f64) {
            return 0.0;
        }
        let x = wi[0] * along[0] + wi[1] * along[1];
        if (x + sin_o).abs() > self.radius_max {
            return 0.0;
        }
        let Some(strip) = self.strip([sin_o, wo[2]], y) else { return 0.0 };
        let cell = (x.atan2(wi[2]) - strip.first) / strip.step;
        if !(cell >= 0.0 && cell < CELLS as f64) {
            return 0.0;
        }
        let strips = &self.strips[node];
        let across = probability(0..STRIPS, place as usize, |k| strips[k]) / self.strip_width();
        across * probability(0..CELLS, cell as usize, |k| strip.cells[k]) / strip.step
    }

    /// Largest ratio of what a strip reflects to the density with which it is drawn: see the bound on weights.
    pub(crate) fn largest_ratio(&self, node: usize, wo: Vec3) -> f64 {
        let sin_o = wo[0].hypot(wo[1]);
        let strips = &self.strips[node];
        let width = self.strip_width();
        let integral = |edge: usize| {
            let strip = self.strip([sin_o, wo[2]], -self.radius_max + edge as f64 * width);
            strip.map_or(0.0, |strip| strip.integral())
        };
        let edges: Vec<f64> = (0..=STRIPS).map(integral).collect();
        let total: f64 = strips.iter().sum();
        (0..STRIPS).map(|k| edges[k].max(edges[k + 1]) * width * total / strips[k]).fold(0.0, f64::max)
    }
}

/// Unit vector along the viewer's projection (x where it has none), and the projection's length.
pub(super) fn projection(wo: Vec3) -> ([f64; 2], f64) {
    let sin_o = wo[0].hypot(wo[1]);
    if sin_o < 1e-9 { ([1.0, 0.0], 0.0) } else { ([wo[0] / sin_o, wo[1] / sin_o], sin_o) }
}

/// The reflectance by the cosine at the half vector, in steps of 1/64: that of mirrored directions.
#[derive(Debug, Clone)]
pub(super) struct Reflectance(pub(super) Vec<f64>);

impl Reflectance {
    fn new(front_factor: FrontFactor) -> Self {
        let at = |k: usize| {
            let cos: f64 = (k as f64 / 64.0).max(0.01);
            let sin = (1.0 - cos * cos).sqrt();
            front_factor.coherent([sin, 0.0, cos], [-sin, 0.0, cos])
        };
        Self((0..=64).map(at).collect())
    }

    /// At a squared length of `q`, which is twice the cosine long.
    fn at(&self, q2: f64) -> f64 {
        let at = (0.5 * q2.sqrt()).min(1.0) * 64.0;
        let first = (at as usize).min(63);
        let share = at - first as f64;
        (1.0 - share) * self.0[first] + share * self.0[first + 1]
    }
}
