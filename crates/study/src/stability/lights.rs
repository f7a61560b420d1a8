//! Stability in the light: windows far smaller and far larger than the scan, lasers, gaps, wide spectra.

use super::case::StabilityCase;
use super::support::{TakenOut, compared, config, laser, optics, relief};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::tables::model::{Basis, TablesConfig};

/// Wavelength step in nm of published tables.
const PUBLISHED_STEP_NM: f64 = 5.0;

/// Wavelength of the laser in nm.
const LINE_NM: f64 = 532.0;

/// Windows by σ in µm, each with a step in nm that is too wide for it. Bands show where `σ_f λ² / |(u, v)|` is narrower:
/// 1.2 nm for 40 µm, 8 nm for 6 µm, 550 nm and `|(u, v)|` = 1. Below, the observer's curves ask for more than the window.
const WINDOWS: [(f64, f64); 5] =
    [(0.25, 100.0), (1.0, 100.0), (6.0, 20.0), (40.0, PUBLISHED_STEP_NM), (1_000.0, PUBLISHED_STEP_NM)];

pub fn cases() -> Vec<StabilityCase> {
    let field = relief([32, 32], [125.0; 2], 200.0);
    [windows(&field), spectra(&field)].concat()
}

/// Guard: the wavelengths follow the window and the eye; with too wide a step a wide one shows bands.
fn windows(field: &HeightField) -> Vec<StabilityCase> {
    let of =
        |(um, step_nm): (f64, f64)| stepped(&format!("window of sigma {um} um"), field, &optics(um * 1e3), step_nm);
    WINDOWS.into_iter().map(of).collect()
}

/// A case that fails with a fixed wavelength step.
fn stepped(name: &str, field: &HeightField, optics: &OpticsConfig, step_nm: f64) -> StabilityCase {
    let fixed = TablesConfig { wavelength_step_nm: Some(step_nm), ..config(Basis::Chebyshev) };
    let what = format!("as many wavelengths as window, light and eye ask for; a step of {step_nm} nm");
    compared(name, field, optics, TakenOut { what: &what, without: &|found| found.other(field, optics, &fixed) })
}

fn spectra(field: &HeightField) -> Vec<StabilityCase> {
    let with = |illuminant, wavelength_nm| OpticsConfig { illuminant, wavelength_nm, ..optics(800.0) };
    let gap = Illuminant::Tabulated {
        wavelength_nm: vec![420.0, 480.0, 481.0, 599.0, 600.0, 680.0],
        power: vec![1.0, 2.0, 0.0, 0.0, 3.0, 1.0],
    };
    let (gap, wide) = (with(gap, [380.0, 780.0]), with(Illuminant::E, [200.0, 2_500.0]));
    // A line lies where it lies. Among wavelengths every 5 nm its nearest is 530 nm.
    let nearest = laser((LINE_NM / PUBLISHED_STEP_NM).round() * PUBLISHED_STEP_NM, 800.0);
    let line = TakenOut {
        what: "the line's own wavelength; the nearest multiple of 5 nm",
        without: &|found| found.other(field, &nearest, &config(Basis::Chebyshev)),
    };
    vec![
        compared("a laser line", field, &laser(LINE_NM, 800.0), line),
        // As many wavelengths as a smooth spectrum would take fall on either side of the gap's edges.
        stepped("a spectrum with a gap", field, &gap, 100.0),
        // Half the fewest wavelengths, spread over the whole range, leave the eye three or four.
        stepped("200 to 2500 nm", field, &wide, 200.0),
    ]
}
