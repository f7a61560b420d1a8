//! The directions that are covered: which texels of (u, v), and which range of normalised `|w|` at each of them.
//!
//! Normalised is `t = |w| / sqrt(4 - u² - v²)`, the share of what `|w|` can be: a scene with one light and one camera looks
//! up nearly the same `t` everywhere, but every `|w|`.

use std::ops::Range;

use ndarray::Array3;

use crate::tables::grid::Grid;
use crate::tables::model::Restriction;
use crate::tables::texels::Texels;
use diffraction_brdf::direction::max_abs_w;

/// Rounding of positions to 32 bits must not leave what was marked, nor that of `|q|²`.
const ROUNDING_TEXELS: f64 = 1e-3;
const ROUNDING_Q_SQUARED: f64 = 1e-6;

/// Directions that are looked up: intervals that hold them all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Directions {
    /// `u`.
    pub u: [f64; 2],
    /// `v`.
    pub v: [f64; 2],
    /// `t`.
    pub t: [f64; 2],
    /// `|q|² = u² + v² + w² = 2 + 2 wi·wo`, which one light and one camera nearly fix: it ties `t` to the radius.
    pub q_squared: [f64; 2],
}

impl Directions {
    /// Everything between these directions and others.
    pub fn joined(&self, other: &Self) -> Self {
        let joined = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        Self {
            u: joined(self.u, other.u),
            v: joined(self.v, other.v),
            t: joined(self.t, other.t),
            q_squared: joined(self.q_squared, other.q_squared),
        }
    }

    /// The `t` of those whose radius is no less than `radius[0]` and no more than `radius[1]`; `None` where there are none.
    ///
    /// `t² = (|q|² - ρ²) / (4 - ρ²)` falls with the radius and rises with `|q|²`.
    fn t_within(&self, radius: [f64; 2]) -> Option<[f64; 2]> {
        let [least, most] = self.q_squared;
        let t = |q_squared: f64, radius: f64| match 4.0 - radius * radius {
            reach_squared if reach_squared > 0.0 => {
                ((q_squared - radius * radius).max(0.0) / reach_squared).sqrt().min(1.0)
            }
            // Beyond the rim nothing lies, and at it `t` can be anything.
            _ => 0.0,
        };
        if most + ROUNDING_Q_SQUARED < radius[0].max(0.0).powi(2) {
            return None;
        }
        let low = t(least - ROUNDING_Q_SQUARED, radius[1]).max(self.t[0]);
        let high = if radius[0] >= 2.0 { 1.0 } else { t(most + ROUNDING_Q_SQUARED, radius[0].max(0.0)) }.min(self.t[1]);
        (low <= high).then_some([low, high])
    }
}

/// What tables answer, texel by texel of a grid in rows from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverage {
    /// The whole grid.
    pub grid: Grid,
    /// Lowest `t` of each texel; infinite where nothing is covered.
    pub(super) low: Vec<f32>,
    /// Highest `t`; negative where nothing is covered.
    pub(super) high: Vec<f32>,
    /// For each scene the texels that it looks up, if it is exposed by what it shows; none if it is not.
    pub(super) exposed_by: Vec<TexelSet>,
}

/// Some texels of a grid, a bit for each.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct TexelSet(Vec<u64>);

impl TexelSet {
    /// No texels.
    pub fn none() -> Self {
        Self(Vec::new())
    }

    /// Those that are covered.
    pub fn of(coverage: &Coverage) -> Self {
        let mut bits = vec![0; coverage.low.len().div_ceil(64)];
        for (index, (low, high)) in coverage.low.iter().zip(&coverage.high).enumerate() {
            bits[index / 64] |= u64::from(low <= high) << (index % 64);
        }
        Self(bits)
    }

    /// Whether a texel, given by its index row by row, is one of them.
    fn holds(&self, index: usize) -> bool {
        self.0.get(index / 64).is_some_and(|bits| bits >> (index % 64) & 1 == 1)
    }
}

impl Coverage {
    /// Nothing yet.
    pub(super) fn none(grid: Grid) -> Self {
        let texels = grid.size * grid.size;
        Self { grid, low: vec![f32::INFINITY; texels], high: vec![-1.0; texels], exposed_by: Vec::new() }
    }

    /// Memory that one takes, in bytes.
    pub(super) fn bytes(grid: Grid) -> u64 {
        2 * size_of::<f32>() as u64 * (grid.size * grid.size) as u64
    }

    /// Marks every texel that a bilinear look-up of these directions reads, and of others up to `margin_texels` beside
    /// them, for the `t` that such a look-up can have.
    pub(super) fn mark(&mut self, directions: &Directions, margin_texels: f64) {
        let Directions { u, v, .. } = *directions;
        let columns = self.stencil(u[0], u[1], margin_texels);
        // What reads a texel lies less than a texel from it along either axis.
        let support = (1.0 + ROUNDING_TEXELS) * self.grid.texel() * std::f64::consts::SQRT_2;
        for row in self.stencil(-v[1], -v[0], margin_texels) {
            let v = self.grid.v(row);
            for column in columns.clone() {
                let radius = (self.grid.u(column).powi(2) + v * v).sqrt();
                let within = |support: f64| directions.t_within([radius - support, radius + support]);
                // Where |q|² ends, the margin counts too: cubics read a texel farther.
                if let Some([low, high]) = within(support).or_else(|| within((1.0 + margin_texels) * support)) {
                    let index = row * self.grid.size + column;
                    self.low[index] = self.low[index].min(low as f32);
                    self.high[index] = self.high[index].max(high as f32);
                }
            }
        }
    }

    /// Texels along an axis between which positions from `low` to `high` lie, and so many more at both ends.
    fn stencil(&self, low: f64, high: f64, margin_texels: f64) -> Range<usize> {
        let at = |x: f64| (x + self.grid.half_width) / self.grid.texel();
        let last = (self.grid.size - 1) as f64;
        let first = (at(low) - ROUNDING_TEXELS - margin_texels).floor().clamp(0.0, last) as usize;
        let end = (at(high) + ROUNDING_TEXELS + margin_texels).ceil().clamp(0.0, last) as usize;
        first..end + 1
    }

    /// Adds what another one on the same grid covers.
    pub(super) fn merge(mut self, other: &Self) -> Self {
        assert_eq!(self.grid, other.grid, "coverages are merged texel by texel");
        self.low.iter_mut().zip(&other.low).for_each(|(low, other)| *low = low.min(*other));
        self.high.iter_mut().zip(&other.high).for_each(|(high, other)| *high = high.max(*other));
        self
    }

    /// Every texel of the disc, those not covered with the hull of all ranges.
    pub(super) fn with_all_texels(&self) -> Self {
        let ends = |ends: [f64; 2], [low, high]: [f64; 2]| [ends[0].min(low), ends[1].max(high)];
        let whole = self.iter().map(|(_, _, t)| t).fold([1.0, 0.0], ends);
        self.filled(|row, column| if self.covers(row, column) { self.range(row, column) } else { whole })
    }

    /// The texels covered, each over all its `|w|`.
    pub(super) fn with_whole_ranges(&self) -> Self {
        let mut whole = self.clone();
        for (low, high) in whole.low.iter_mut().zip(&mut whole.high).filter(|(low, high)| low <= high) {
            (*low, *high) = (0.0, 1.0);
        }
        whole
    }

    fn filled(&self, range: impl Fn(usize, usize) -> [f64; 2]) -> Self {
        let mut filled = self.clone();
        for row in 0..self.grid.size {
            for column in 0..self.grid.size {
                if self.grid.u(column).hypot(self.grid.v(row)) < 2.0 {
                    let index = row * self.grid.size + column;
                    [filled.low[index], filled.high[index]] = range(row, column).map(|t| t as f32);
                }
            }
        }
        filled
    }

    /// Whether a texel is covered.
    pub fn covers(&self, row: usize, column: usize) -> bool {
        let index = row * self.grid.size + column;
        self.low[index] <= self.high[index]
    }

    /// Lowest and highest `t` of a texel that is covered.
    pub fn range(&self, row: usize, column: usize) -> [f64; 2] {
        let index = row * self.grid.size + column;
        [self.low[index].into(), self.high[index].into()]
    }

    /// Range of `|w|` at the texel nearest to `(u, v)`; `None` where it is not covered.
    pub(crate) fn abs_w_near(&self, uv: [f64; 2]) -> Option<[f64; 2]> {
        let index = self.grid.nearest(uv)?;
        let [row, column] = [index / self.grid.size, index % self.grid.size];
        self.covers(row, column).then(|| self.abs_w_at(row, column, self.range(row, column)))
    }

    /// Number of texels covered.
    pub fn count(&self) -> usize {
        self.low.iter().zip(&self.high).filter(|(low, high)| low <= high).count()
    }

    /// Number of texels in the disc of radius 2: those that are covered, and all.
    pub fn disc_texels(&self) -> [usize; 2] {
        let size = self.grid.size;
        let inside = |&index: &usize| self.grid.u(index % size).hypot(self.grid.v(index / size)) < 2.0;
        let covered = |&index: &usize| self.covers(index / size, index % size);
        let disc = (0..size * size).filter(inside);
        [disc.clone().filter(covered).count(), disc.count()]
    }

    /// Row, column and range of `t` of every texel covered.
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, [f64; 2])> + '_ {
        let size = self.grid.size;
        let ranges = self.low.iter().zip(&self.high).enumerate().filter(|(_, (low, high))| low <= high);
        ranges.map(move |(index, (&low, &high))| (index / size, index % size, [low.into(), high.into()]))
    }

    /// The range of `|w|` that a range of `t` is at a texel.
    pub fn abs_w_at(&self, row: usize, column: usize, t: [f64; 2]) -> [f64; 2] {
        let reach = max_abs_w(self.grid.u(column).hypot(self.grid.v(row)));
        t.map(|t| t * reach)
    }

    /// Everything that is covered, from the least to the greatest; `None` where nothing is.
    pub(in crate::tables) fn hull(&self) -> Option<Hull> {
        let mut hull: Option<Hull> = None;
        for (row, column, t) in self.iter() {
            let [u, v] = [self.grid.u(column), self.grid.v(row)];
            let here = Hull { radius: [u.hypot(v); 2], u: [u; 2], v: [v; 2], abs_w: self.abs_w_at(row, column, t) };
            hull = Some(hull.map_or(here, |hull| hull.with(&here)));
        }
        hull
    }

    /// Lowest and highest `t` of the texels that look-ups within a radius read; `None` where there are none.
    pub(in crate::tables) fn t_inside(&self, radius: f64) -> Option<[f64; 2]> {
        let reads = radius + 2.0 * self.grid.texel();
        let inside = self.iter().filter(|&(row, column, _)| self.grid.u(column).hypot(self.grid.v(row)) < reads);
        inside.map(|(_, _, t)| t).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
    }

    /// Lowest and highest `|w|` of the texels of each ring, given by radii that go down, ring `n` from `radii[n]` to
    /// `radii[n + 1]`, inner radius included; `None` where it has none.
    pub(super) fn abs_w_of_rings(&self, radii: &[f64]) -> Vec<Option<[f64; 2]>> {
        let mut rings: Vec<Option<[f64; 2]>> = vec![None; radii.len().saturating_sub(1)];
        for (row, column, t) in self.iter() {
            let own = self.grid.u(column).hypot(self.grid.v(row));
            let beyond = radii.partition_point(|&radius| radius > own);
            if let Some(ring) = beyond.checked_sub(1).and_then(|ring| rings.get_mut(ring)) {
                let w = self.abs_w_at(row, column, t);
                *ring = Some(ring.map_or(w, |own| [own[0].min(w[0]), own[1].max(w[1])]));
            }
        }
        rings
    }

    /// The window around everything covered, as rows and columns.
    fn window(&self) -> Option<[Range<usize>; 2]> {
        let mut window: Option<[Range<usize>; 2]> = None;
        for (row, column, _) in self.iter() {
            let [rows, columns] = window.unwrap_or([row..row + 1, column..column + 1]);
            let grown = |range: Range<usize>, at: usize| range.start.min(at)..range.end.max(at + 1);
            window = Some([grown(rows, row), grown(columns, column)]);
        }
        window
    }

    /// The texels covered; none where nothing is.
    pub(in crate::tables) fn texels(&self) -> Texels {
        let [rows, columns] = self.window().unwrap_or_default();
        Texels::some(self.grid, [rows, columns], |row, column| self.covers(row, column))
    }

    /// For each scene that is exposed by what it shows, whether it looks up the texel nearest to a place in (u, v). Scenes
    /// exposed by hand look up none of those.
    pub(in crate::tables) fn exposed_at(&self) -> impl Iterator<Item = impl Fn([f64; 2]) -> bool + '_> {
        self.exposed_by
            .iter()
            .map(move |texels| move |uv| self.grid.nearest(uv).is_some_and(|index| texels.holds(index)))
    }

    /// All that it says, for the key of what depends on it.
    pub fn to_bytes(&self) -> Vec<u8> {
        let ends = self.low.iter().chain(&self.high).flat_map(|end| end.to_le_bytes());
        let sets = self.exposed_by.iter().flat_map(|texels| {
            [texels.0.len() as u64].into_iter().chain(texels.0.iter().copied()).flat_map(u64::to_le_bytes)
        });
        ends.chain(sets).collect()
    }

    /// The texture of ranges that readers of the tables need; `None` where nothing is covered.
    pub fn range_texture(&self) -> Option<Restriction> {
        let [rows, columns] = self.window()?;
        let range = Array3::from_shape_fn((rows.len(), columns.len(), 3), |(row, column, channel)| {
            let index = (rows.start + row) * self.grid.size + columns.start + column;
            match (self.low[index] <= self.high[index], channel) {
                (true, 0) => self.low[index],
                (true, 1) => self.high[index],
                (true, _) => 1.0,
                (false, _) => 0.0,
            }
        });
        Some(Restriction { size: self.grid.size, first: [rows.start, columns.start], range })
    }
}

/// The extent of what is covered, each from the least to the greatest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::tables) struct Hull {
    /// Radius in (u, v).
    pub radius: [f64; 2],
    /// `u`.
    pub u: [f64; 2],
    /// `v`.
    pub v: [f64; 2],
    /// `|w|`.
    pub abs_w: [f64; 2],
}

impl Hull {
    /// Every direction, for texels up to a radius.
    pub fn whole(radius_max: f64) -> Self {
        let side = [-radius_max, radius_max];
        Self { radius: [0.0, radius_max], u: side, v: side, abs_w: [0.0, max_abs_w(0.0)] }
    }

    fn with(&self, other: &Self) -> Self {
        let joined = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        Self {
            radius: joined(self.radius, other.radius),
            u: joined(self.u, other.u),
            v: joined(self.v, other.v),
            abs_w: joined(self.abs_w, other.abs_w),
        }
    }
}

#[cfg(test)]
#[path = "ranges_tests.rs"]
mod tests;
