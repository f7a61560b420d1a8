//! The texels that are computed: a window of a grid, and of each of its rows the runs of columns.

use std::ops::Range;

use super::grid::Grid;

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

    /// Those of a window that are asked for.
    pub(super) fn some(
        grid: Grid,
        [rows, columns]: [Range<usize>; 2],
        asked_for: impl Fn(usize, usize) -> bool,
    ) -> Self {
        let runs = rows.clone().map(|row| runs_of(columns.clone().filter(|&column| asked_for(row, column))));
        Self { grid, runs: Some(runs.collect()), rows, columns }
    }

    /// Whether every texel of the grid counts.
    pub(crate) fn is_whole(&self) -> bool {
        self.runs.is_none()
    }

    /// Texels in the window, counted or not.
    pub(crate) fn window_texels(&self) -> usize {
        self.rows.len() * self.columns.len()
    }

    /// Number of texels within `radius[0] <= |(u, v)| < radius[1]`.
    pub(crate) fn count_within(&self, radius: [f64; 2]) -> usize {
        self.rows.clone().flat_map(|row| self.runs_in(row, radius)).map(|run| run.len()).sum()
    }

    /// Runs of columns of a row (of the grid) within `radius[0] <= |(u, v)| < radius[1]`.
    pub(crate) fn runs_in(&self, row: usize, radius: [f64; 2]) -> Vec<Range<usize>> {
        let v = self.grid.v(row);
        // What lies inside the next ring's hole.
        let outer = inner_columns(&self.grid, radius[1], v);
        let hole = inner_columns(&self.grid, radius[0], v);
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
pub(super) fn inner_columns(grid: &Grid, radius: f64, v: f64) -> Range<usize> {
    let reach = radius * radius - v * v;
    if reach <= 0.0 {
        return 0..0;
    }
    let columns = grid.columns_within(reach.sqrt());
    // The ring includes its inner radius.
    let on_rim = |column: usize| grid.u(column).hypot(v) >= radius;
    let start = columns.start + usize::from(on_rim(columns.start));
    let end = columns.end - usize::from(columns.end > start && on_rim(columns.end - 1));
    start..end.max(start)
}
