//! Texel positions of tables.

/// Texel positions over [-2, 2] in u and v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Texels along each axis; odd, so that one lies at (0, 0).
    pub size: usize,
    /// Half width of the square: 2 for a whole table, the lobe's radius for its patch.
    pub half_width: f64,
}

impl Grid {
    /// Distance between texels.
    pub fn texel(&self) -> f64 {
        2.0 * self.half_width / (self.size - 1) as f64
    }

    /// `u` of a column.
    pub fn u(&self, column: usize) -> f64 {
        -self.half_width + column as f64 * self.texel()
    }

    /// `v` of a row: row 0 is the +v edge.
    pub fn v(&self, row: usize) -> f64 {
        -self.u(row)
    }

    /// Index, row by row, of the texel nearest to `(u, v)`; `None` outside of the grid.
    pub fn nearest(&self, [u, v]: [f64; 2]) -> Option<usize> {
        let at = |x: f64| ((x + self.half_width) / self.texel()).round();
        let inside = |at: f64| at >= 0.0 && at < self.size as f64;
        let (row, column) = (at(-v), at(u));
        (inside(row) && inside(column)).then(|| row as usize * self.size + column as usize)
    }

    /// Columns with `|u| <= reach`, as a half-open range.
    pub(crate) fn columns_within(&self, reach: f64) -> std::ops::Range<usize> {
        let middle = (self.size - 1) / 2;
        if reach < 0.0 {
            return middle..middle;
        }
        let steps = ((reach / self.texel()) as usize).min(middle);
        middle - steps..middle + steps + 1
    }
}
