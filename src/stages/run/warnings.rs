//! What a user must know about tables and scans before using them, in whole sentences.

use crate::stages::ingest::Scans;
use diffraction_brdf::storage::StoredTables;
use diffraction_build::height::HeightField;
use diffraction_build::height::statistics::{is_whole_grating, seam_warning};
use diffraction_build::optics::config::{Edge, OpticsConfig, TILE_SIGMAS, Windows, ripple, smallest_side_nm};
use diffraction_build::optics::validity::doubts;
use diffraction_build::tables::model::{Basis, Rounding, Storage, TableSet, TablesConfig};

/// Of stored tables; `texel` is their distance in u and v.
pub(super) fn table_warnings(set: &TableSet, stored: &StoredTables, tables: &TablesConfig, texel: f64) -> Vec<String> {
    let mut warnings = Vec::new();
    if set.usable_radius < 2.0 {
        warnings.push(format!(
            "the scan's sampling answers for |(u, v)| up to {:.2} only: beyond, some wavelengths are missing and values are too dark",
            set.usable_radius
        ));
    }
    if set.prefilter_width > 0.0 {
        warnings.push(format!(
            "a texel ({:.4}) is wider than the coherence lobe: each holds the mean over a square of {:.4} in u and v, \
             so single directions differ from the point values while pictures of extended lights and pixels do not",
            texel, set.prefilter_width
        ));
    }
    warnings.extend(stored.rounding.and_then(|rounding| format_warning(stored.storage, tables, rounding)));
    if set.basis == Basis::Taylor {
        warnings.push("tables of the published Taylor series, kept for comparison".into());
    }
    warnings
}

/// Of the number format: that halves were asked for and are too coarse.
fn format_warning(storage: Storage, tables: &TablesConfig, rounding: Rounding) -> Option<String> {
    let Rounding { half, allowed, .. } = rounding;
    (storage == Storage::Half && tables.storage.is_some() && half > allowed).then(|| {
        format!(
            "16-bit floats shift one colour in twenty by {half:.1e} or more, and the tolerance of {:.0e} leaves {allowed:.1e} to storage: tables.storage = \"auto\" \
             would take 32-bit ones",
            tables.tolerance
        )
    })
}

/// Ratio of two scans' rms heights or pitches from which on they are doubted to show one surface.
const UNLIKE: f64 = 2.0;

/// Of scans: what is wrong with each, by its file's name where there are several; of each but the first, whose statistics stand beside
/// these warnings, those of its statistics; where the model ends on each; whether they are alike enough to be averaged; whether each
/// fits itself where it repeats.
pub(crate) fn scan_warnings(scans: &Scans, optics: &OpticsConfig) -> Vec<String> {
    let prefix = |index: usize| prefix(scans, index);
    let mut warnings = Vec::new();
    for (index, findings) in scans.findings.iter().enumerate() {
        warnings.extend(findings.iter().map(|finding| prefix(index) + &finding.sentence));
    }
    let wavelength_nm = optics.illuminant.reach_nm(optics.wavelength_nm);
    for (index, field) in scans.fields.iter().enumerate() {
        let doubts = doubts(field, wavelength_nm, optics.material, optics.factor);
        warnings.extend(doubts.into_iter().map(|doubt| prefix(index) + &doubt));
    }
    for (index, statistics) in scans.statistics.iter().enumerate().skip(1) {
        warnings.extend(statistics.warnings.iter().map(|warning| prefix(index) + warning));
    }
    warnings.extend(repetition_warning(&scans.fields, optics));
    warnings.extend(seam_warnings(scans, optics));
    warnings.extend(unlike_warnings(scans));
    warnings
}

/// What sigma was taken where it follows the scans.
pub(crate) fn sigma_taken(optics: &OpticsConfig) -> Option<String> {
    optics.sigma_follows_scan.then(|| {
        format!(
            "sigma = {:.3} µm by sigma_um = \"auto\": the shortest side of its scans over {}, or what holds by default where they resolve \
             any",
            optics.sigma_nm * 1e-3,
            optics.sides_in_sigmas()
        )
    })
}

/// The file's name where there are several.
fn prefix(scans: &Scans, index: usize) -> String {
    if scans.fields.len() > 1 { format!("{}: ", scans.provenance[index].file_name) } else { String::new() }
}

/// Of scans whose edges do not fit each other where a window lies on them.
pub(super) fn seam_warnings(scans: &Scans, optics: &OpticsConfig) -> Vec<String> {
    if optics.edge == Edge::Fade {
        return Vec::new();
    }
    let seen = scans.fields.iter().enumerate().filter(|(_, field)| seams_are_seen(field, optics));
    seen.filter_map(|(index, field)| seam_warning(field).map(|warning| prefix(scans, index) + &warning)).collect()
}

/// Whether scans are doubted to show one surface.
pub(super) fn are_unlike(scans: &Scans) -> bool {
    !unlike_warnings(scans).is_empty()
}

fn unlike_warnings(scans: &Scans) -> Vec<String> {
    let name = |index: usize| scans.provenance[index].file_name.as_str();
    let rms: Vec<f64> = scans.statistics.iter().map(|statistics| statistics.rms_height_nm).collect();
    let pitch = |axis: usize| scans.fields.iter().map(|field| field.pitch_nm[axis]).collect::<Vec<_>>();
    let kinds = [("rms height", rms), ("pitch along x", pitch(0)), ("pitch along y", pitch(1))];
    kinds.into_iter().filter_map(|(what, values)| unlike(what, &values, &name)).collect()
}

/// Ripple between the lines of a repeated scan from which on it is warned of: what the eye sees in a smooth gradient.
const RIPPLE_WARNED: f64 = 0.02;

/// Of scans that are small beside the light's coherence: what their repetition shows, or what was taken in its place.
pub(super) fn repetition_warning(fields: &[HeightField], optics: &OpticsConfig) -> Option<String> {
    let told = fields.iter().filter(|field| !is_whole_grating(field));
    let side_nm = told.map(smallest_side_nm).fold(f64::INFINITY, f64::min);
    let (side_um, fits_um) = (side_nm * 1e-3, side_nm * 1e-3 / TILE_SIGMAS);
    if let Some(light_nm) = optics.lobe_sigma_nm {
        return Some(format!(
            "the scan is {side_um:.3} µm wide, too small for a coherence of sigma = {:.3} µm{}: its diffuse light is shown as sharp \
             as the scan can tell, with sigma = {:.3} µm, and orders are that much wider; the mirror-like lobe keeps the \
             light's own width",
            light_nm * 1e-3,
            longest(optics),
            optics.sigma_nm * 1e-3
        ));
    }
    let ripple = ripple(side_nm, optics.sigma_nm);
    let invented = optics.edge == Edge::Tile && ripple > RIPPLE_WARNED;
    invented.then(|| {
        format!(
            "the scan is {side_um:.3} µm wide and repeated under a coherence of sigma = {:.3} µm{}: the repetition itself shows as a \
             grating of {side_um:.3} µm, a ripple of {:.0} % in its light; coherence.edge = \"auto\" shows no more than \
             the scan can tell, as does sigma_um <= {fits_um:.3}",
            optics.sigma_nm * 1e-3,
            longest(optics),
            100.0 * ripple
        )
    })
}

/// Where a coherence is the largest of several, at which wavelength.
fn longest(optics: &OpticsConfig) -> String {
    let [_, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
    optics.source_deg.map_or_else(String::new, |_| format!(" at {high_nm:.0} nm"))
}

/// Whether a coherence window lies on the edges: one in the middle of a scan 8 sigma wide, as `fade` asks for, does not.
fn seams_are_seen(field: &HeightField, optics: &OpticsConfig) -> bool {
    let inside = field.extent_nm().iter().all(|extent_nm| *extent_nm >= 8.0 * optics.sigma_nm);
    !(inside && optics.windows == Windows::Centre)
}

/// Says which scans differ most, where that is by more than [`UNLIKE`].
fn unlike<'a>(what: &str, values_nm: &[f64], name: &dyn Fn(usize) -> &'a str) -> Option<String> {
    let by_value = |a: &usize, b: &usize| values_nm[*a].total_cmp(&values_nm[*b]);
    let (low, high) = ((0..values_nm.len()).min_by(by_value)?, (0..values_nm.len()).max_by(by_value)?);
    (values_nm[high] > UNLIKE * values_nm[low]).then(|| {
        format!(
            "The scans differ much in {what} ({}: {:.3} nm, {}: {:.3} nm), and are averaged into one surface all the same; \
             specimens of their own keep them apart.",
            name(low),
            values_nm[low],
            name(high),
            values_nm[high]
        )
    })
}
