//! What is asked of tables, and what building them took.

use serde::{Deserialize, Serialize};

pub use diffraction_brdf::table_set::{Basis, Lobe, Restriction, Rounding, Storage, TableSet};

/// Box average over (u, v) that every texel holds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Prefilter {
    /// One texel wide where the grid does not resolve the coherence lobe, none where it does.
    Auto,
    /// Point samples.
    None,
    /// A square of this side in u and v.
    Width(f64),
}

/// What is asked of the tables. `None` leaves the choice to the tolerance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TablesConfig {
    /// Which expansion.
    pub basis: Basis,
    /// Relative error that a reader may get in 95 % of lit directions, by the look-up that `FORMAT.md` describes.
    pub tolerance: f64,
    /// Texels along u and v over [-2, 2]; odd.
    pub size: Option<usize>,
    /// Number of tables.
    pub count: Option<usize>,
    /// Largest wavelength step in nm.
    pub wavelength_step_nm: Option<f64>,
    /// Number format in the atlas; decided by [`super::rounding::choose`] once tables are built.
    pub storage: Option<Storage>,
    /// Average over (u, v) held by a texel.
    pub prefilter: Prefilter,
    /// Working memory that building may take, in MiB.
    pub memory_mib: usize,
}

/// What was chosen while building, and what it cost: for reports and `specimen.json`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct BuildRecord {
    /// Transforms of `exp(i s h)` per window.
    pub transforms: usize,
    /// Windows averaged.
    pub windows: usize,
    /// Wavelengths used at the rim of the (u, v) disc, where most are needed.
    pub wavelengths_max: usize,
    /// Wavelengths times texels, summed over the disc.
    pub samples: u64,
    /// The same times the nodes in `w`: what was summed. 0 where the series in powers of `w` has no nodes.
    #[serde(default)]
    pub node_samples: u64,
    /// Smallest and largest wavelength step in nm.
    pub wavelength_step_nm: [f64; 2],
}

/// Receives progress: wavelengths times windows done.
pub type Advance<'a> = &'a (dyn Fn(u64) + Sync);
