//! Slopes of the surface, triangulated between its samples.

use rayon::prelude::*;

use crate::height::HeightField;

/// Slope above which a facet counts as steep.
///
/// At 0.5 (26.6°) a facet lit from above reflects at 53° from the normal. There the Fresnel reflectances of the two
/// polarisations (0.053 and 0.028 for n = 1.5, 0.04 at normal incidence) already are as 1.9 to 1; from slope 1
/// on, light reflected downwards meets the surface again.
pub const STEEP_SLOPE: f64 = 0.5;

/// What the slopes amount to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes {
    /// Root mean square.
    pub rms: f64,
    /// Share above [`STEEP_SLOPE`].
    pub steep_share: f64,
    /// Share of triangles with a leg that rises by more than the given step.
    pub ambiguous_share: f64,
}

/// Sums over the triangles.
#[derive(Clone, Copy, Default)]
struct Sums {
    square: f64,
    steep: usize,
    ambiguous: usize,
    count: usize,
}

impl Sums {
    /// Adds a triangle whose legs rise by `rise_nm` over `pitch_nm`.
    fn add(&mut self, rise_nm: [f64; 2], pitch_nm: [f64; 2], step_nm: f64) {
        let square = (rise_nm[0] / pitch_nm[0]).powi(2) + (rise_nm[1] / pitch_nm[1]).powi(2);
        self.square += square;
        self.steep += usize::from(square > STEEP_SLOPE * STEEP_SLOPE);
        self.ambiguous += usize::from(rise_nm[0].abs().max(rise_nm[1].abs()) > step_nm);
        self.count += 1;
    }

    fn plus(self, other: Self) -> Self {
        Self {
            square: self.square + other.square,
            steep: self.steep + other.steep,
            ambiguous: self.ambiguous + other.ambiguous,
            count: self.count + other.count,
        }
    }
}

/// Slopes of the two triangles between each four neighbours; of the segments, for a single line.
pub fn slopes(field: &HeightField, step_nm: f64) -> Slopes {
    let heights = &field.heights_nm;
    let [nx, ny] = field.size();
    let line = |row: usize| {
        let mut sums = Sums::default();
        let rise = |from: [usize; 2], to: [usize; 2]| heights[to] - heights[from];
        // Across a single line nothing rises: its second leg leads back to where it starts.
        let (below, right) = ((row + 1).min(ny - 1), |column: usize| (column + 1).min(nx - 1));
        for column in 0..(nx - 1).max(1) {
            let (next, here, opposite) = (right(column), [row, column], [below, right(column)]);
            sums.add([rise(here, [row, next]), rise(here, [below, column])], field.pitch_nm, step_nm);
            sums.add([rise([below, column], opposite), rise([row, next], opposite)], field.pitch_nm, step_nm);
        }
        sums
    };
    // Summed row by row in order: the same on any number of threads.
    let rows: Vec<Sums> = (0..(ny - 1).max(1)).into_par_iter().map(line).collect();
    let total = rows.into_iter().fold(Sums::default(), Sums::plus);
    let count = total.count as f64;
    Slopes {
        rms: (total.square / count).sqrt(),
        steep_share: total.steep as f64 / count,
        ambiguous_share: total.ambiguous as f64 / count,
    }
}
