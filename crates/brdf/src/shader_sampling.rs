//! Sampling in shaders: the source that draws directions, and what it reads beside the tables.
//!
//! Binding 6 of group 0 of [`TABLES_SAMPLED_WGSL`] is `sampling`, a 2D texture of R32F that is not filtered: [`SamplingImage`]. Its rows,
//! in 32-bit floats:
//!
//! | row | columns | what |
//! |---|---|---|
//! | 0 | 0 to 5 | u of the left edge and v of the upper edge of the grid of cells, a cell's side, rows, columns, rows of a band |
//! | 1 | 0 to 64 | front factor of the lobe at cosines of the half vector of k / 64 |
//! | 2 to 9 | 0, 1, 2 | shares of the samples at node k: even over solid angle, of the lobe, of the tables |
//! | 2 to 9 | 3 to 34 | what 32 strips across the lobe reflect, in any unit |
//! | from 10 on | 0 to the number of columns | for each of 8 nodes: sums of each row of cells up to each edge, then those of each band of rows |
//!
//! A node `k` is a polar angle of the viewer, `cos = ((k + 1/2) / 8)²`, which stands for `k / 8 <= sqrt(cos) < (k + 1) / 8`. Rows beyond what
//! is told hold 0. Cells are blocks of the tables' texels, at most [`CELLS_MAX`] side by side: coarser than those of [`Brdf::sample`](crate::Brdf::sample), so
//! that weights vary more where orders are narrower than a cell (31 thousandths of u), at a hundredth of the numbers.

use crate::direction::Vec3;
use crate::sampling::{NumbersForShaders, Sampler};
use crate::table_set::TableSet;

/// [`TABLES_FILTERED_WGSL`](crate::shader::TABLES_FILTERED_WGSL) with `brdf_sample(wo, u)` and `brdf_pdf(wi, wo)`. Has one binding more.
pub const TABLES_SAMPLED_WGSL: &str = concat!(
    include_str!("shaders/optics.wgsl"),
    "\n",
    include_str!("shaders/tables.wgsl"),
    "\n",
    include_str!("shaders/splines.wgsl"),
    "\n",
    include_str!("shaders/filtered.wgsl"),
    "\n",
    include_str!("shaders/tables_filtered.wgsl"),
    "\n",
    include_str!("shaders/sampling.wgsl"),
    "\n",
    include_str!("shaders/sampling_tables.wgsl")
);

/// Most cells along u and along v.
pub const CELLS_MAX: usize = 128;

/// The texture `sampling` as it is uploaded.
#[derive(Debug, Clone, PartialEq)]
pub struct SamplingImage {
    /// Number of rows and columns.
    pub size: [usize; 2],
    /// One number per texel, row by row.
    pub texels: Vec<f32>,
}

/// The density from which shaders draw, in double precision: what they are held against.
#[derive(Debug, Clone)]
pub struct ShaderSampler(Sampler);

impl ShaderSampler {
    /// That of a table set.
    pub fn new(set: &TableSet) -> Self {
        Self(Sampler::coarse(set, CELLS_MAX))
    }

    /// The texture of this density.
    pub fn image(&self) -> SamplingImage {
        let NumbersForShaders { size, numbers } = self.0.numbers_for_shaders();
        SamplingImage { size, texels: numbers }
    }

    /// A direction to the light for one to the viewer, from three even random numbers in [0, 1); `None` where the viewer is not above the
    /// surface. Where tables are restricted to scenes they need not have an answer there.
    pub fn sample(&self, wo: Vec3, u: [f64; 3]) -> Option<Vec3> {
        self.0.sample(wo, u)
    }

    /// Density of [`Self::sample`] in 1/sr, whose integral over the hemisphere is 1; 0 for directions not above the surface.
    pub fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        self.0.pdf(wi, wo)
    }
}
