//! What `inspect` thinks of a scan.

use diffraction_build::height::quality::{Advice, Verdict, scan_verdict};
use diffraction_build::height::statistics::{seam_warning, statistics};
use diffraction_build::optics::config::{Factor, Material, smallest_side_nm};
use diffraction_build::optics::validity::doubts;

/// The shortest wavelength that `usable_uv_radius` refers to: the violet end of the observer.
pub(super) const WAVELENGTH_MIN_NM: f64 = 380.0;

/// The longest: its red end.
pub(super) const WAVELENGTH_MAX_NM: f64 = 780.0;

/// What a scan is taken for, which has no material: a dielectric; which index it has does not matter to the doubts.
pub(super) const MATERIAL: Material = Material::Dielectric { n: 1.5 };

/// Rms height in nm below which there is no relief: a 1e-15th of the light is scattered.
const FLAT_NM: f64 = 1e-6;

/// Share of the shorter side over which opposite edges are advised to be blended.
const BLEND_SHARE: f64 = 0.1;

/// What to think of a scan under the settings that were advised, with what no setting takes away.
pub(super) fn verdict(advice: &Advice) -> Verdict {
    let range_nm = [WAVELENGTH_MIN_NM, WAVELENGTH_MAX_NM];
    let field = &advice.prepared;
    let found = statistics(field, WAVELENGTH_MIN_NM);
    // What levelling leaves of nothing is rounding.
    let is_flat = found.rms_height_nm < FLAT_NM;
    let limits = [
        (is_flat, "it is flat and diffracts nothing"),
        (!is_flat && found.autocorrelation_length_nm.is_nan(), "it is smaller than its structure"),
        (!doubts(field, range_nm, MATERIAL, Factor::Vector).is_empty(), "some orders are doubtful, see the warnings"),
        (found.is_ambiguous(), "steps between samples are too high for violet light"),
    ];
    let of_findings =
        advice.findings.iter().filter(|finding| finding.is_limit()).map(|finding| finding.in_short.clone());
    let limits = limits.into_iter().filter(|(holds, _)| *holds).map(|(_, words)| words.to_owned());
    let limits: Vec<String> = of_findings.chain(limits).collect();
    let blend_nm = seam_warning(field).map(|_| two_digits(BLEND_SHARE * smallest_side_nm(field)));
    scan_verdict(advice, range_nm, &limits, blend_nm)
}

/// Rounded to two digits.
fn two_digits(value: f64) -> f64 {
    let unit = 10f64.powf(value.log10().floor() - 1.0);
    (value / unit).round() * unit
}
