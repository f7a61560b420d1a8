//! The stability suite: stiff and extreme cases, each with a derived bound and a measured figure.
//!
//! A case measures one number that must not exceed its bound; where the program protects itself by a
//! recognisable guard, the same number is measured without it and must exceed the bound.

mod depth;
mod directions;
mod shapes;
mod support;

use serde::{Deserialize, Serialize};

/// Outcome of one case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StabilityCase {
    /// What was tried.
    pub name: String,
    /// What was measured, and where the bound comes from.
    pub note: String,
    /// The figure.
    pub measured: f64,
    /// Its bound.
    pub bound: f64,
    /// The same figure without the guard that keeps it, where that can be taken out.
    pub without_guard: Option<f64>,
}

/// Whether a case kept its bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Finite and within the bound.
    Kept,
    /// Beyond the bound, or not a number.
    Broken,
}

impl StabilityCase {
    /// Whether the bound was kept; NaN never is.
    pub fn verdict(&self) -> Verdict {
        if self.measured <= self.bound { Verdict::Kept } else { Verdict::Broken }
    }
}

/// Runs every case.
pub fn run_stability() -> Vec<StabilityCase> {
    [depth::cases(), directions::cases(), shapes::cases()].concat()
}
