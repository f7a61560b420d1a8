//! What accuracy is told in: rows of errors, and power sums. A number that could not be determined is NaN in memory and
//! `null` in JSON.

use serde::{Deserialize, Serialize};

use crate::ground::null_for_nan;

/// Errors of the stored tables against the reference, over directions of one region.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ErrorRow {
    /// Which error: "total", "basis", "wavelength step", "grid", "storage".
    pub what: String,
    /// Which directions: "whole hemisphere", "near specular", "grazing".
    pub region: String,
    /// Directions compared pointwise: those that the reference has above the floor.
    pub directions: usize,
    /// Luminance in 1/sr up to which a direction is too dark for that.
    #[serde(default = "floor_of_older_reports")]
    pub floor_per_sr: f64,
    /// Share of the region that the tables call lit: where they show more than half of the floor.
    #[serde(default, with = "null_for_nan")]
    pub lit_share: f64,
    /// Directions evaluated that the tables call dark.
    #[serde(default)]
    pub dark_directions: usize,
    /// Those of them that the reference has above the floor: light that the tables miss.
    #[serde(default)]
    pub missed_directions: usize,
    /// Root of the summed squared differences over the root of the summed squares, over the whole region: lit and dark
    /// directions count by the share of it that they stand for.
    #[serde(with = "null_for_nan")]
    pub relative_l2: f64,
    /// Median relative error of the luminance.
    #[serde(with = "null_for_nan")]
    pub p50: f64,
    /// Its 95th percentile.
    #[serde(with = "null_for_nan")]
    pub p95: f64,
    /// Its 99th percentile.
    #[serde(with = "null_for_nan")]
    pub p99: f64,
    /// Its maximum.
    #[serde(with = "null_for_nan")]
    pub worst: f64,
}

impl ErrorRow {
    /// Whether it breaks the tolerance. Only the causes that the tolerance governs can.
    pub fn is_over(&self, tolerance: f64) -> bool {
        matches!(self.what.as_str(), "basis" | "wavelength step") && self.p95 > tolerance
    }
}

/// What reports had before they told: a few millionths of white.
fn floor_of_older_reports() -> f64 {
    1e-6
}

/// `∫ f cos_theta_o dω_o` for one incidence, relative to the incident power.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PowerSum {
    /// Angle of incidence in degrees.
    pub theta_i_deg: f64,
    /// Wavelength in nm; `None` for the luminous sum.
    pub wavelength_nm: Option<f64>,
    /// The sum.
    #[serde(with = "null_for_nan")]
    pub sum: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(worst: f64) -> ErrorRow {
        let (what, region) = ("total".into(), "grazing".into());
        ErrorRow {
            what,
            region,
            directions: 3,
            floor_per_sr: 3e-5,
            lit_share: 0.5,
            dark_directions: 1,
            missed_directions: 0,
            relative_l2: 1e-6,
            p50: 1e-7,
            p95: 1e-6,
            p99: 1e-6,
            worst,
        }
    }

    #[test]
    fn a_missing_measurement_is_null_and_comes_back_as_nan() {
        for missing in [f64::NAN, f64::INFINITY] {
            let text = serde_json::to_string(&row(missing)).unwrap();
            assert!(text.contains("\"worst\":null"), "{text}");
            let back: ErrorRow = serde_json::from_str(&text).unwrap();
            assert!(back.worst.is_nan());
        }
        let back: ErrorRow = serde_json::from_str(&serde_json::to_string(&row(2e-5)).unwrap()).unwrap();
        assert_eq!(back, row(2e-5));
    }
}
