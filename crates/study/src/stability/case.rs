//! One case of the stability suite: a figure, its bound, and what keeps it there.

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
    /// What keeps the bound, and the same figure without it.
    pub guard: Guard,
    /// Largest deviation of the case's tables stored as halves, over what rounding allows each value; at most 1. `None`
    /// where a case has no tables.
    pub half: Option<f64>,
}

/// What keeps a case within its bound.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Guard {
    /// What it is.
    pub what: String,
    /// The case's figure without it; may be infinite, which JSON writes as `null`. No number shows nothing.
    pub without: f64,
}

/// Whether a case kept its bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Finite and within the bound.
    Kept,
    /// Beyond the bound, or not a number.
    Broken,
    /// Within the bound, but without its guard no number beyond it was seen: nothing is shown.
    Blind,
}

impl StabilityCase {
    /// Whether the bound was kept, and is exceeded without the guard; NaN does neither.
    pub fn verdict(&self) -> Verdict {
        let kept = self.measured <= self.bound && self.half.is_none_or(|share| share <= 1.0);
        let exceeded = self.guard.without > self.bound;
        match (kept, exceeded) {
            (false, _) => Verdict::Broken,
            (true, false) => Verdict::Blind,
            (true, true) => Verdict::Kept,
        }
    }
}
