//! The directions that are asked for: which texels of (u, v), and which depths at each of them.
//!
//! Depth is `t = |w| / sqrt(4 - u² - v²)`, the share of what `|w|` can be: a scene with one light and one camera reaches
//! nearly the same `t` everywhere, but every `|w|`.

use std::ops::Range;

use half::f16;
use ndarray::Array3;

use super::model::Served;
use super::plan::Grid;
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

    /// The `t` of those whose radius is no less than `rho[0]` and no more than `rho[1]`; `None` where there are none.
    ///
    /// `t² = (|q|² - ρ²) / (4 - ρ²)` falls with the radius and rises with `|q|²`.
    fn t_within(&self, rho: [f64; 2]) -> Option<[f64; 2]> {
        let [least, most] = self.q_squared;
        let t = |q_squared: f64, rho: f64| match 4.0 - rho * rho {
            reach_squared if reach_squared > 0.0 => ((q_squared - rho * rho).max(0.0) / reach_squared).sqrt().min(1.0),
            // Beyond the rim nothing lies, and at it `t` can be anything.
            _ => 0.0,
        };
        if most + ROUNDING_Q_SQUARED < rho[0].max(0.0).powi(2) {
            return None;
        }
        let low = t(least - ROUNDING_Q_SQUARED, rho[1]).max(self.t[0]);
        let high = if rho[0] >= 2.0 { 1.0 } else { t(most + ROUNDING_Q_SQUARED, rho[0].max(0.0)) }.min(self.t[1]);
        (low <= high).then_some([low, high])
    }
}

/// What is reached of a grid, texel by texel in rows from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Domain {
    /// The whole grid.
    pub grid: Grid,
    /// Lowest `t` of each texel; infinite where nothing is reached.
    pub low: Vec<f32>,
    /// Highest `t`; negative where nothing is reached.
    pub high: Vec<f32>,
    /// What each scene reaches that is exposed by what it shows; empty where one is not, or no scene is known.
    pub scenes: Vec<TexelSet>,
}

/// Some texels of a grid, a bit for each.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TexelSet(pub Vec<u64>);

impl TexelSet {
    /// Those that a domain reaches.
    pub fn reached(domain: &Domain) -> Self {
        let mut bits = vec![0; domain.low.len().div_ceil(64)];
        for (index, (low, high)) in domain.low.iter().zip(&domain.high).enumerate() {
            bits[index / 64] |= u64::from(low <= high) << (index % 64);
        }
        Self(bits)
    }

    /// Whether a texel, given by its index row by row, is one of them.
    pub fn holds(&self, index: usize) -> bool {
        self.0.get(index / 64).is_some_and(|bits| bits >> (index % 64) & 1 == 1)
    }
}

impl Domain {
    /// Nothing reached yet.
    pub fn new(grid: Grid) -> Self {
        let texels = grid.size * grid.size;
        Self { grid, low: vec![f32::INFINITY; texels], high: vec![-1.0; texels], scenes: Vec::new() }
    }

    /// Memory that one takes.
    pub fn bytes(grid: Grid) -> u64 {
        2 * size_of::<f32>() as u64 * (grid.size * grid.size) as u64
    }

    /// Marks every texel that a bilinear look-up of these directions reads, and of others up to `margin_texels` beside
    /// them, for the `t` that such a look-up can have.
    pub fn mark(&mut self, directions: &Directions, margin_texels: f64) {
        let Directions { u, v, .. } = *directions;
        let columns = self.stencil(u[0], u[1], margin_texels);
        // What reads a texel lies less than a texel from it along either axis.
        let support = (1.0 + ROUNDING_TEXELS) * self.grid.texel() * std::f64::consts::SQRT_2;
        for row in self.stencil(-v[1], -v[0], margin_texels) {
            let v = self.grid.v(row);
            for column in columns.clone() {
                let rho = (self.grid.u(column).powi(2) + v * v).sqrt();
                let within = |support: f64| directions.t_within([rho - support, rho + support]);
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

    /// Adds what another domain on the same grid reaches.
    pub fn merge(mut self, other: &Self) -> Self {
        assert_eq!(self.grid, other.grid, "domains are merged texel by texel");
        self.low.iter_mut().zip(&other.low).for_each(|(low, other)| *low = low.min(*other));
        self.high.iter_mut().zip(&other.high).for_each(|(high, other)| *high = high.max(*other));
        self
    }

    /// Widens every range by `pad` at both ends, within [0, 1], then lets neighbours differ by at most `slope` per
    /// texel in the middle, and by as much in `|w|` anywhere, again by widening; at last the ends become half floats,
    /// which is how they are stored.
    ///
    /// Between texels a look-up interpolates coefficients and ranges with the same shares `s_i`. That is the mean of
    /// the texels' polynomials at `t_i`, which lie as deep in the ranges of the texels as `t` does in the range
    /// between them: `Σ s_i t_i = t`. So what errs is the part of the polynomials' slopes that differs from texel to
    /// texel, and their second order.
    pub fn with_smooth_ranges(mut self, pad: f64, slope: f64) -> Self {
        for (low, high) in self.low.iter_mut().zip(&mut self.high).filter(|(low, high)| low <= high) {
            *low = (*low - pad as f32).max(0.0);
            *high = (*high + pad as f32).min(1.0);
        }
        let texels = self.low.len();
        let slopes: Vec<f32> = (0..texels)
            .map(|index| {
                let [row, column] = [index / self.grid.size, index % self.grid.size];
                let reach = max_abs_w(self.grid.u(column).hypot(self.grid.v(row)));
                // No two ends differ by more than 1.
                (slope * max_abs_w(0.0) / reach).min(1.0) as f32
            })
            .collect();
        let size = self.grid.size as isize;
        let neighbours: [[isize; 2]; 4] = [[-1, -1], [-1, 0], [-1, 1], [0, -1]];
        let mut relax = |index: usize, back: bool| {
            let mut changed = false;
            if self.low[index] > self.high[index] {
                return changed;
            }
            let (row, column) = (index as isize / size, index as isize % size);
            for [dr, dc] in neighbours.map(|offset| if back { offset.map(|o| -o) } else { offset }) {
                let (r, c) = (row + dr, column + dc);
                if !(0..size).contains(&r) || !(0..size).contains(&c) {
                    continue;
                }
                let other = (r * size + c) as usize;
                if self.low[other] <= self.high[other] {
                    let distance = if dr != 0 && dc != 0 { std::f32::consts::SQRT_2 } else { 1.0 };
                    let step = distance * slopes[index].min(slopes[other]);
                    let [low, high] = [self.low[other] + step, self.high[other] - step];
                    changed |= low < self.low[index] || high > self.high[index];
                    self.low[index] = self.low[index].min(low);
                    self.high[index] = self.high[index].max(high);
                }
            }
            changed
        };
        // Down and up once settles a domain without holes; around a hole ranges spread in further rounds.
        loop {
            let down = (0..texels).fold(false, |changed, index| relax(index, false) | changed);
            let up = (0..texels).rev().fold(false, |changed, index| relax(index, true) | changed);
            if !down && !up {
                break;
            }
        }
        for (low, high) in self.low.iter_mut().zip(&mut self.high).filter(|(low, high)| low <= high) {
            (*low, *high) = (half_below(*low), half_above(*high));
        }
        self
    }

    /// Every texel of the disc, those not reached with the hull of all ranges.
    pub fn with_all_texels(&self) -> Self {
        let ends = |ends: [f64; 2], [low, high]: [f64; 2]| [ends[0].min(low), ends[1].max(high)];
        let whole = self.iter().map(|(_, _, t)| t).fold([1.0, 0.0], ends);
        self.filled(|row, column| if self.reaches(row, column) { self.range(row, column) } else { whole })
    }

    /// The texels reached, each over all its depths.
    pub fn with_all_depths(&self) -> Self {
        let mut deep = self.clone();
        for (low, high) in deep.low.iter_mut().zip(&mut deep.high).filter(|(low, high)| low <= high) {
            (*low, *high) = (0.0, 1.0);
        }
        deep
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

    /// Whether a texel is reached.
    pub fn reaches(&self, row: usize, column: usize) -> bool {
        let index = row * self.grid.size + column;
        self.low[index] <= self.high[index]
    }

    /// Lowest and highest `t` of a texel that is reached.
    pub fn range(&self, row: usize, column: usize) -> [f64; 2] {
        let index = row * self.grid.size + column;
        [self.low[index].into(), self.high[index].into()]
    }

    /// Range of `|w|` at the texel nearest to `(u, v)`; `None` where it is not reached.
    pub fn w_near(&self, uv: [f64; 2]) -> Option<[f64; 2]> {
        let index = self.grid.nearest(uv)?;
        let [row, column] = [index / self.grid.size, index % self.grid.size];
        self.reaches(row, column).then(|| self.w_at(row, column, self.range(row, column)))
    }

    /// Number of texels reached.
    pub fn texels(&self) -> usize {
        self.low.iter().zip(&self.high).filter(|(low, high)| low <= high).count()
    }

    /// Number of texels in the disc of radius 2: those that are reached, and all.
    pub fn disc_texels(&self) -> [usize; 2] {
        let size = self.grid.size;
        let inside = |&index: &usize| self.grid.u(index % size).hypot(self.grid.v(index / size)) < 2.0;
        let reached = |&index: &usize| self.reaches(index / size, index % size);
        let disc = (0..size * size).filter(inside);
        [disc.clone().filter(reached).count(), disc.count()]
    }

    /// Row, column and range of every texel reached.
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, [f64; 2])> + '_ {
        let size = self.grid.size;
        let ranges = self.low.iter().zip(&self.high).enumerate().filter(|(_, (low, high))| low <= high);
        ranges.map(move |(index, (&low, &high))| (index / size, index % size, [low.into(), high.into()]))
    }

    /// The range of `|w|` that a range of `t` is at a texel.
    pub fn w_at(&self, row: usize, column: usize, t: [f64; 2]) -> [f64; 2] {
        let reach = max_abs_w(self.grid.u(column).hypot(self.grid.v(row)));
        t.map(|t| t * reach)
    }

    /// Radius, and `|w|`, from the least to the greatest that is reached; `None` where nothing is.
    pub fn hull(&self) -> Option<Hull> {
        let mut hull: Option<Hull> = None;
        for (row, column, t) in self.iter() {
            let [u, v] = [self.grid.u(column), self.grid.v(row)];
            let here = Hull { rho: [u.hypot(v); 2], u: [u; 2], v: [v; 2], w: self.w_at(row, column, t) };
            hull = Some(hull.map_or(here, |hull| hull.with(&here)));
        }
        hull
    }

    /// Lowest and highest `t` of the texels that look-ups within a radius read; `None` where there are none.
    pub fn t_inside(&self, radius: f64) -> Option<[f64; 2]> {
        let reads = radius + 2.0 * self.grid.texel();
        let inside = self.iter().filter(|&(row, column, _)| self.grid.u(column).hypot(self.grid.v(row)) < reads);
        inside.map(|(_, _, t)| t).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
    }

    /// Lowest and highest `|w|` of the texels of each ring, given by radii that go down, ring `n` from `radii[n]` to
    /// `radii[n + 1]`, inner radius included; `None` where it has none.
    pub fn w_of_rings(&self, radii: &[f64]) -> Vec<Option<[f64; 2]>> {
        let mut rings: Vec<Option<[f64; 2]>> = vec![None; radii.len().saturating_sub(1)];
        for (row, column, t) in self.iter() {
            let rho = self.grid.u(column).hypot(self.grid.v(row));
            let beyond = radii.partition_point(|&radius| radius > rho);
            if let Some(ring) = beyond.checked_sub(1).and_then(|ring| rings.get_mut(ring)) {
                let w = self.w_at(row, column, t);
                *ring = Some(ring.map_or(w, |own| [own[0].min(w[0]), own[1].max(w[1])]));
            }
        }
        rings
    }

    /// The window around everything reached, as rows and columns.
    pub fn window(&self) -> Option<[Range<usize>; 2]> {
        let mut window: Option<[Range<usize>; 2]> = None;
        for (row, column, _) in self.iter() {
            let [rows, columns] = window.unwrap_or([row..row + 1, column..column + 1]);
            let grown = |range: Range<usize>, at: usize| range.start.min(at)..range.end.max(at + 1);
            window = Some([grown(rows, row), grown(columns, column)]);
        }
        window
    }

    /// What readers of the tables need to know; `None` where nothing is reached.
    pub fn served(&self) -> Option<Served> {
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
        Some(Served { size: self.grid.size, first: [rows.start, columns.start], range })
    }
}

/// The next half float at or below a number in [0, 1].
fn half_below(number: f32) -> f32 {
    let half = f16::from_f32(number);
    let above = half.to_f32() > number;
    if above { f16::from_bits(half.to_bits() - 1).to_f32() } else { half.to_f32() }
}

/// The next half float at or above a number in [0, 1].
fn half_above(number: f32) -> f32 {
    let half = f16::from_f32(number);
    let below = half.to_f32() < number;
    if below { f16::from_bits(half.to_bits() + 1).to_f32() } else { half.to_f32() }
}

/// The extent of a domain, each from the least to the greatest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hull {
    /// Radius in (u, v).
    pub rho: [f64; 2],
    /// `u`.
    pub u: [f64; 2],
    /// `v`.
    pub v: [f64; 2],
    /// `|w|`.
    pub w: [f64; 2],
}

impl Hull {
    /// Everything that directions above the surface reach, and the rim of texels beyond.
    pub fn whole(rho_max: f64) -> Self {
        Self { rho: [0.0, rho_max], u: [-rho_max, rho_max], v: [-rho_max, rho_max], w: [0.0, max_abs_w(0.0)] }
    }

    fn with(&self, other: &Self) -> Self {
        let joined = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        Self {
            rho: joined(self.rho, other.rho),
            u: joined(self.u, other.u),
            v: joined(self.v, other.v),
            w: joined(self.w, other.w),
        }
    }
}

/// The texels that are computed: a window of a grid, and of each of its rows the runs of columns.
#[derive(Debug, Clone, PartialEq)]
pub struct Texels {
    /// The whole grid.
    pub grid: Grid,
    /// Rows of the window.
    pub rows: Range<usize>,
    /// Columns of the window.
    pub columns: Range<usize>,
    /// Runs of each row of the window; `None` where every column counts.
    runs: Option<Vec<Vec<Range<usize>>>>,
}

impl Texels {
    /// All texels of a grid.
    pub fn whole(grid: Grid) -> Self {
        Self { grid, rows: 0..grid.size, columns: 0..grid.size, runs: None }
    }

    /// Those that a domain reaches; none for an empty domain.
    pub fn reached(domain: &Domain) -> Self {
        let [rows, columns] = domain.window().unwrap_or_default();
        let runs = rows.clone().map(|row| runs_of(columns.clone().filter(|&column| domain.reaches(row, column))));
        Self { grid: domain.grid, runs: Some(runs.collect()), rows, columns }
    }

    /// Whether every texel of the grid counts.
    pub fn is_whole(&self) -> bool {
        self.runs.is_none()
    }

    /// Texels in the window, counted or not.
    pub fn window_texels(&self) -> usize {
        self.rows.len() * self.columns.len()
    }

    /// Number of texels within `rho[0] <= radius < rho[1]`.
    pub fn count_within(&self, rho: [f64; 2]) -> usize {
        self.rows.clone().flat_map(|row| self.runs_in(row, rho)).map(|run| run.len()).sum()
    }

    /// Runs of columns of a row (of the grid) within `rho[0] <= radius < rho[1]`.
    pub fn runs_in(&self, row: usize, rho: [f64; 2]) -> Vec<Range<usize>> {
        let v = self.grid.v(row);
        // What lies inside the next ring's hole.
        let outer = inner_columns(&self.grid, rho[1], v);
        let hole = inner_columns(&self.grid, rho[0], v);
        let annulus = if hole.is_empty() { [outer, 0..0] } else { [outer.start..hole.start, hole.end..outer.end] };
        let Some(runs) = &self.runs else {
            return annulus.into_iter().filter(|run| !run.is_empty()).collect();
        };
        let own = row.checked_sub(self.rows.start).and_then(|index| runs.get(index));
        let both = |a: &Range<usize>, b: &Range<usize>| a.start.max(b.start)..a.end.min(b.end);
        let cut = own.into_iter().flatten().flat_map(|run| annulus.iter().map(move |part| both(run, part)));
        cut.filter(|run| !run.is_empty()).collect()
    }
}

/// Ascending numbers as runs.
fn runs_of(columns: impl Iterator<Item = usize>) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for column in columns {
        match runs.last_mut() {
            Some(run) if run.end == column => run.end += 1,
            _ => runs.push(column..column + 1),
        }
    }
    runs
}

/// Columns of a row that lie inside a ring's hole.
pub fn inner_columns(grid: &Grid, rho: f64, v: f64) -> Range<usize> {
    let reach = rho * rho - v * v;
    if reach <= 0.0 {
        return 0..0;
    }
    let columns = grid.columns_within(reach.sqrt());
    // The ring includes its inner radius.
    let on_rim = |column: usize| grid.u(column).hypot(v) >= rho;
    let start = columns.start + usize::from(on_rim(columns.start));
    let end = columns.end - usize::from(columns.end > start && on_rim(columns.end - 1));
    start..end.max(start)
}

#[cfg(test)]
#[path = "domain_tests.rs"]
mod tests;
