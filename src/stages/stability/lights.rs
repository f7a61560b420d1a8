//! Stability in the light: windows far smaller and far larger than the scan, lasers, gaps, wide spectra.

use super::StabilityCase;
use super::support::{build_error, compared, config, laser, optics, relief};
use crate::ground::spectrum::Illuminant;
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::tables::model::{Basis, TablesConfig};

/// Wavelength step in nm of published tables.
const PUBLISHED_STEP_NM: f64 = 5.0;

/// σ in nm from which that step shows bands: `σ_f λ² / |(u, v)|` is 1.2 nm for 40 µm, 550 nm and `|(u, v)|` = 1.
const BANDS_NM: f64 = 40_000.0;

pub fn cases() -> Vec<StabilityCase> {
    let field = relief([32, 32], [125.0; 2], 200.0);
    [windows(&field), spectra(&field)].concat()
}

/// Guard: the wavelengths follow the window; with the step of published tables a wide one shows bands.
fn windows(field: &HeightField) -> Vec<StabilityCase> {
    let note = "95 % error of Y on texels, tiled scan of 4 um";
    [0.25, 1.0, 6.0, 40.0, 1_000.0]
        .into_iter()
        .map(|um| {
            let optics = optics(um * 1e3);
            let kept = compared(&format!("window of sigma {um} um"), note, field, &optics);
            if optics.sigma_nm < BANDS_NM { kept } else { stepped(kept, field, &optics, PUBLISHED_STEP_NM) }
        })
        .collect()
}

fn stepped(kept: StabilityCase, field: &HeightField, optics: &OpticsConfig, step_nm: f64) -> StabilityCase {
    let fixed = TablesConfig { wavelength_step_nm: Some(step_nm), ..config(Basis::Chebyshev) };
    let what = format!("wavelengths as dense as the window asks for; a step of {step_nm} nm");
    let [without, _] = build_error(field, optics, &fixed);
    kept.guarded(&what, without)
}

fn spectra(field: &HeightField) -> Vec<StabilityCase> {
    let with = |illuminant, wavelength_nm| OpticsConfig { illuminant, wavelength_nm, ..optics(800.0) };
    let gap = Illuminant::Tabulated {
        wavelength_nm: vec![420.0, 480.0, 481.0, 599.0, 600.0, 680.0],
        power: vec![1.0, 2.0, 0.0, 0.0, 3.0, 1.0],
    };
    let note = "95 % error of Y on texels";
    let (gap, wide) = (with(gap, [380.0, 780.0]), with(Illuminant::E, [200.0, 2_500.0]));
    vec![
        compared("a laser line", note, field, &laser(532.0, 800.0)),
        // As many wavelengths as a smooth spectrum would take fall on either side of the gap's edges.
        stepped(compared("a spectrum with a gap", note, field, &gap), field, &gap, 100.0),
        // Half the fewest wavelengths, spread over the whole range, leave the eye three or four.
        stepped(compared("200 to 2500 nm", note, field, &wide), field, &wide, 200.0),
    ]
}
