//! What the report says about a specimen in words and numbers.

use crate::report::frames::period_letter;
use crate::report::{look_up_facts, numbers};
use crate::stages::results::{BuildResult, Period, SpecimenResult, SpectralResult, Statistics};
use diffraction_brdf::dispersion::Origin;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::accuracy::power_sums::DirectionalAlbedo;
use diffraction_build::accuracy::rows::{Cause, ErrorRow, promised};
use diffraction_build::height::statistics::{STEEP_SLOPE, WAVES_MIN, least_uv_radius};
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::dispersive::Dispersive;
use diffraction_build::tables::model::{Basis, Rounding, Storage};

/// A name and what is to be said about it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fact {
    /// The name.
    pub name: String,
    /// A short text.
    pub text: String,
}

fn fact(name: &str, text: String) -> Fact {
    Fact { name: name.into(), text }
}

/// Everything about a specimen that is not a picture or a table.
pub(crate) fn of_specimen(specimen: &SpecimenResult) -> Vec<Fact> {
    let mut facts = vec![fact("Scan", scan(specimen))];
    if let Some(found) = &specimen.statistics {
        facts.push(fact("Heights", heights(found)));
        facts.push(fact("Slopes", slopes(found)));
        if !found.dominant_periods.is_empty() {
            facts.push(fact("Periods", periods(&found.dominant_periods)));
        }
        facts.push(fact("Good for", good_for(specimen, found)));
    }
    if let Some(optics) = &specimen.optics {
        facts.push(fact("Light", light(optics)));
        facts.push(fact("Coherence", coherence(optics)));
        facts.push(fact("Material", material(optics)));
    }
    if let Some(pigment) = &specimen.pigment {
        let [r, g, b] = pigment.albedo.map(|share| numbers::round_number(share, 3));
        facts.push(fact("Pigment below", format!("albedo {r}, {g}, {b} (linear sRGB), in pictures only")));
    }
    if let Some(built) = &specimen.build {
        facts.push(fact("Tables", tables(built)));
        facts.extend(built.rounding.map(|rounding| fact("Numbers", format_of(built.storage, rounding))));
        facts.push(fact("Texels", texels(built)));
        facts.push(fact("Rim", rim(built)));
        facts.extend(look_up_facts::look_ups(built, &specimen.errors).map(|text| fact("Look-ups", text)));
        facts.push(fact("Made from", made_from(built)));
    }
    facts.extend(specimen.spectral.as_ref().map(|spectral| fact("Spectral tables", spectral_tables(spectral))));
    if !specimen.albedo.is_empty() {
        facts.push(fact("Albedo", albedo(&specimen.albedo)));
    }
    if let Some(lobe) = &specimen.lobe {
        let cross = match lobe.cross_tables {
            0 => "no cross term".into(),
            1 => "1 cross-term patch".into(),
            count => format!("{count} cross-term patches"),
        };
        let share = lobe.power_share.map_or_else(String::new, |share| {
            format!(", {} of the light at normal incidence", numbers::percent(share))
        });
        facts.push(fact(
            "Coherent lobe",
            format!("radius {} in (u, v), {cross}{share}", numbers::number(lobe.radius_max, 3)),
        ));
    }
    facts
}

/// Between which distances from the mirror direction the scan's sampling, its side and the window tell periods.
fn good_for(specimen: &SpecimenResult, found: &Statistics) -> String {
    let whole = format!("|(u, v)| up to {} (2 is the whole hemisphere)", numbers::number(found.usable_uv_radius, 3));
    let sides = specimen.size.into_iter().zip(specimen.extent_um).filter(|(count, _)| *count > 1);
    let side_nm = sides.map(|(_, side_um)| side_um * 1e3).fold(f64::INFINITY, f64::min);
    let Some(optics) = specimen.optics.as_ref().filter(|_| side_nm.is_finite()) else { return whole };
    let [shortest_nm, _] = optics.illuminant.reach_nm(optics.wavelength_nm);
    let least = least_uv_radius(side_nm, optics.least_sigma_nm(), shortest_nm);
    format!(
        "{whole}; periods are told from {} on at {shortest_nm:.0} nm: longer ones fit fewer than {WAVES_MIN} times into the \
         scan, or are one with the mirror’s light under this coherence",
        numbers::number(least, 2)
    )
}

/// Texels from the rim of (u, v) within which look-ups err by more than a thousandth or so: docs/accuracy.md.
const RIM_TEXELS: f64 = 2.0;

/// From which polar angle on two directions on one side lie at the rim.
fn rim(built: &BuildResult) -> String {
    let texel = 4.0 / (built.size.max(3) - 1) as f64;
    let theta_deg = (1.0 - 0.5 * RIM_TEXELS * texel).clamp(0.0, 1.0).asin().to_degrees();
    format!(
        "look-ups err by a thousandth and more where light and viewer are both beyond {}° on one side",
        numbers::round_number(theta_deg, 3)
    )
}

/// The provenance of one scan: every entry of the JSON object, in its order. Empty entries are left out.
pub(crate) fn of_scan(scan: &serde_json::Value) -> Vec<Fact> {
    let Some(entries) = scan.as_object() else {
        return vec![fact("provenance", value_text(scan))];
    };
    entries
        .iter()
        .filter(|(_, value)| match value {
            serde_json::Value::Null => false,
            serde_json::Value::Array(items) => !items.is_empty(),
            _ => true,
        })
        .map(|(name, value)| fact(&name.replace('_', " "), value_text(value)))
        .collect()
}

/// Every warning about a specimen once: its own, those of its statistics, and those of its scans.
pub fn warnings(specimen: &SpecimenResult) -> Vec<String> {
    // Of several scans each is named; the statistics here are those of the first.
    let several = specimen.scans.len() > 1;
    let prefix = |scan: &serde_json::Value| {
        let name = scan.get("file_name").and_then(|name| name.as_str()).filter(|_| several);
        name.map_or(String::new(), |name| format!("{name}: "))
    };
    let first = specimen.scans.first().map_or(String::new(), prefix);
    let of_statistics =
        specimen.statistics.iter().flat_map(|found| &found.warnings).map(|text| format!("{first}{text}"));
    let of_scans = specimen.scans.iter().flat_map(|scan| {
        let texts = scan.get("warnings").and_then(|texts| texts.as_array()).into_iter().flatten();
        texts.map(move |text| prefix(scan) + &value_text(text))
    });
    let mut found: Vec<String> = Vec::new();
    for warning in specimen.warnings.iter().cloned().chain(of_statistics).chain(of_scans) {
        if !found.contains(&warning) {
            found.push(warning);
        }
    }
    found
}

/// "6 Chebyshev, half".
pub(crate) fn tables_short(built: &BuildResult) -> String {
    format!(
        "{} {}, {}",
        built.tables,
        basis(built.basis),
        match built.storage {
            Storage::Half => "half",
            Storage::Float => "float",
        }
    )
}

/// "501 × 501".
pub(crate) fn grid_short(built: &BuildResult) -> String {
    format!("{0} × {0}", built.size)
}

/// Error rows with those of one cause together, causes in the order in which they first come.
pub(crate) fn by_cause(rows: &[ErrorRow]) -> Vec<ErrorRow> {
    let first = |row: &ErrorRow| rows.iter().position(|other| other.cause == row.cause);
    let mut sorted = rows.to_vec();
    sorted.sort_by_key(first);
    sorted
}

/// Which directions the errors count, and how much of each group the tables show above the floor.
pub(crate) fn counted_directions(rows: &[ErrorRow]) -> String {
    let total = promised(rows);
    let totals: Vec<&ErrorRow> = rows.iter().filter(|row| row.cause == total).collect();
    let [low, high] = totals
        .iter()
        .fold([f64::INFINITY, 0.0f64], |[low, high], row| [low.min(row.floor_per_sr), high.max(row.floor_per_sr)]);
    let floor = match low < high {
        true => format!("{} to {}", numbers::number(low, 2), numbers::with_unit(high, 2, "/sr")),
        false => numbers::with_unit(low, 2, "/sr"),
    };
    let shares: Vec<String> =
        totals.iter().map(|row| format!("{}: {}", row.group, numbers::percent(row.share_above))).collect();
    let [below, missed] = totals
        .iter()
        .fold([0, 0], |[below, missed], row| [below + row.directions_below, missed + row.missed_directions]);
    let found = match (below, missed) {
        (0, _) => "Nothing is below it.".to_owned(),
        (_, 0) => {
            format!("Of {below} directions below that floor that were evaluated as well, none turned out above it.")
        }
        _ => format!(
            "Of {below} directions below that floor that were evaluated as well, {missed} turned out above it, and count."
        ),
    };
    let p95 = |cause: Cause| rows.iter().find(|row| row.cause == cause).map_or(f64::NAN, |row| row.p95);
    let grid = match p95(Cause::Grid) > 0.5 * p95(total) {
        true => " Most of the total is the grid’s: it arises between texels, and a larger tables.size lowers it.",
        false => "",
    };
    format!(
        "Medians, percentiles and worst ones count directions above the luminance floor, {floor}. Shares of each region that the tables \
         show above it: {}. {found}{}{grid}",
        shares.join("; "),
        left_out(rows)
    )
}

/// What the reference may miss in the dark, where the ends of its kernels are known.
fn left_out(rows: &[ErrorRow]) -> String {
    let most = rows.iter().filter_map(|row| row.left_out_per_sr).max_by(f64::total_cmp);
    most.map_or_else(String::new, |most| {
        format!(
            " In the dark the reference may be lower than the surface by up to {}, since its windows end.",
            numbers::with_unit(most, 2, "/sr")
        )
    })
}

/// The letters of the spectrum's marks and what they stand for.
pub(crate) fn period_marks(periods: &[Period]) -> String {
    if periods.is_empty() {
        return "none, for no period stands out".into();
    }
    let marks: Vec<String> = periods
        .iter()
        .enumerate()
        .map(|(index, period)| format!("{}, {}", period_letter(index), numbers::length_nm(period.period_nm)))
        .collect();
    marks.join("; ")
}

/// "0.041 at 0°, 0.057 at 45°, … of the light is reflected".
fn albedo(albedo: &[DirectionalAlbedo]) -> String {
    let share = |at: &DirectionalAlbedo| {
        format!("{} at {}°", numbers::number(at.albedo, 3), numbers::round_number(at.theta_i_deg, 3))
    };
    let shares: Vec<String> = albedo.iter().map(share).collect();
    format!("share of the light that is reflected, by its angle of incidence (azimuth 0): {}", shares.join(", "))
}

fn scan(specimen: &SpecimenResult) -> String {
    let [nx, ny] = specimen.size;
    let [px, py] = specimen.pitch_nm;
    let pitch = if px == py {
        numbers::round_number(px, 4)
    } else {
        format!("{} × {}", numbers::round_number(px, 4), numbers::round_number(py, 4))
    };
    format!(
        "{nx} × {ny} samples, pitch {pitch} nm, {} × {}",
        numbers::number(specimen.extent_um[0], 3),
        numbers::with_unit(specimen.extent_um[1], 3, "µm"),
    )
}

fn heights(found: &Statistics) -> String {
    format!(
        "rms {}, peak to valley {}",
        numbers::with_unit(found.rms_height_nm, 3, "nm"),
        numbers::with_unit(found.peak_to_valley_nm, 3, "nm"),
    )
}

fn slopes(found: &Statistics) -> String {
    format!(
        "rms {}, {} of the surface above {}; over a quarter of the shortest wavelength rms {}, walls on {}; autocorrelation \
         length {}",
        numbers::number(found.rms_slope, 3),
        numbers::percent(found.steep_share),
        numbers::number(STEEP_SLOPE, 2),
        numbers::number(found.wave_slope, 3),
        numbers::percent(found.wall_share),
        numbers::length_nm(found.autocorrelation_length_nm),
    )
}

fn periods(periods: &[Period]) -> String {
    let texts: Vec<String> = periods
        .iter()
        .enumerate()
        .map(|(index, period)| {
            format!(
                "{}: {} at {}°, power {}",
                period_letter(index),
                numbers::length_nm(period.period_nm),
                // Adding zero turns a rounded −0 into 0.
                numbers::round_number(period.direction_deg.round() + 0.0, 3),
                numbers::number(period.relative_power, 2),
            )
        })
        .collect();
    texts.join("; ")
}

fn light(optics: &OpticsConfig) -> String {
    let [from, to] = optics.wavelength_nm.map(|edge| numbers::number(edge, 3));
    match &optics.illuminant {
        Illuminant::D65 => format!("D65, {from} to {to} nm"),
        Illuminant::A => format!("illuminant A, {from} to {to} nm"),
        Illuminant::E => format!("equal energy, {from} to {to} nm"),
        Illuminant::F(number) => format!("F{number}, {from} to {to} nm"),
        Illuminant::Tabulated { wavelength_nm, .. } => {
            format!("a table of {} wavelengths, {from} to {to} nm", wavelength_nm.len())
        }
        Illuminant::Lines(lines) => {
            let names: Vec<String> = lines.iter().map(|line| numbers::with_unit(line.wavelength_nm, 4, "nm")).collect();
            format!("laser lines at {}", names.join(", "))
        }
    }
}

fn coherence(optics: &OpticsConfig) -> String {
    let edge = match optics.edge {
        Edge::Auto | Edge::Tile => "the scan repeats beyond its edge",
        Edge::Fade => "the window stays inside the scan",
    };
    let windows = match optics.windows {
        Windows::Grid => "window positions averaged",
        Windows::Centre => "one window in the middle",
    };
    let sigma = |nm: f64| numbers::round_number(nm * 1e-3, 4);
    let light = optics.source_deg.map(|source_deg| {
        let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
        let at = |nm: f64| sigma(optics.lobe_coherence().sigma_nm_at(nm));
        format!(
            "a source {} degrees wide: σ = {} µm at {low_nm:.0} nm, {} µm at {high_nm:.0} nm, in proportion to the wavelength",
            numbers::round_number(source_deg, 4),
            at(low_nm),
            at(high_nm)
        )
    });
    match (light, optics.lobe_sigma_nm) {
        (Some(light), None) => format!("{light}, {edge}, {windows}"),
        (Some(light), Some(_)) => format!(
            "{light} for the coherent lobe, {} µm at most for the rest (as much as the scan resolves), {edge}, {windows}",
            sigma(optics.sigma_nm)
        ),
        (None, None) => format!("σ = {} µm, {edge}, {windows}", sigma(optics.sigma_nm)),
        (None, Some(light_nm)) => format!(
            "σ = {} µm for the coherent lobe (the light's), {} µm for the rest (as much as the scan resolves), {edge}, {windows}",
            sigma(light_nm),
            sigma(optics.sigma_nm)
        ),
    }
}

fn material(optics: &OpticsConfig) -> String {
    let material = match optics.material {
        Material::Ideal => "ideal mirror (reflects everything)".into(),
        Material::Dielectric { n } => format!("transparent, n = {}", numbers::round_number(n, 4)),
        Material::Conductor { n, k } => {
            format!("absorbing, n = {}, k = {}", numbers::round_number(n, 4), numbers::round_number(k, 4))
        }
    };
    let material = match &optics.dispersion {
        None => material,
        Some(Dispersive { reference_nm, table }) => format!(
            "{} ({}), its index by wavelength; front factor at {}: {material}",
            table.name(),
            source(table.origin()),
            numbers::with_unit(*reference_nm, 4, "nm")
        ),
    };
    let shadowing = if optics.shadowing { "V-cavity shadowing" } else { "no shadowing" };
    format!("{material}; {shadowing}")
}

fn source(origin: &Origin) -> &str {
    match origin {
        Origin::Literature(citation) => citation,
        Origin::File { path, .. } => path,
    }
}

fn tables(built: &BuildResult) -> String {
    format!(
        "{}, {} texels, {} stored, for a tolerance of {}",
        tables_short(built),
        grid_short(built),
        numbers::bytes(built.stored_bytes),
        numbers::round_percent(built.tolerance),
    )
}

/// Tables of single wavelengths.
fn spectral_tables(found: &SpectralResult) -> String {
    let [shortest, longest] = found.range_nm.map(|nm| numbers::round_number(nm, 4));
    let format = match found.storage {
        Storage::Half => "16-bit",
        Storage::Float => "32-bit",
    };
    format!(
        "{} of {size} × {size}, {format} floats, {}: any wavelength from {shortest} nm, any light up to {longest} nm",
        found.tables,
        numbers::bytes(found.stored_bytes),
        size = found.size,
    )
}

/// The number format and what it does.
fn format_of(storage: Storage, rounding: Rounding) -> String {
    let number = |share| numbers::number(share, 2);
    let Rounding { half, float, allowed } = rounding;
    let allowed = number(allowed);
    match storage {
        Storage::Half => {
            format!("16-bit floats: 95 % of colours shift by less than {} ({allowed} is allowed)", number(half))
        }
        Storage::Float => format!(
            "32-bit floats: 95 % of colours shift by less than {} ({allowed} is allowed, 16-bit ones come to {})",
            number(float),
            number(half)
        ),
    }
}

fn texels(built: &BuildResult) -> String {
    if built.prefilter_width > 0.0 {
        format!("averages over {} in u and v", numbers::round_number(built.prefilter_width, 3))
    } else {
        "point samples".into()
    }
}

fn made_from(built: &BuildResult) -> String {
    let record = &built.record;
    let [shortest, longest] = record.wavelength_step_nm;
    let steps = if longest > 0.0 {
        format!(" in steps of {} to {}", numbers::number(shortest, 2), numbers::with_unit(longest, 2, "nm"))
    } else {
        String::new()
    };
    format!(
        "{} transforms × {} window{}, up to {} wavelengths{steps}, {} samples, in {}",
        record.transforms,
        numbers::count(record.windows as u64),
        if record.windows == 1 { "" } else { "s" },
        record.wavelengths_max,
        numbers::count(record.samples),
        taken(built),
    )
}

/// "0.41 s (predicted 0.35 s; 0.70 s of processor time), with 64 MB of memory (predicted 59 MB)".
fn taken(built: &BuildResult) -> String {
    let in_brackets = |parts: Vec<String>| match parts.is_empty() {
        true => String::new(),
        false => format!(" ({})", parts.join("; ")),
    };
    let seconds = built.predicted.iter().map(|cost| format!("predicted {}", numbers::seconds(cost.seconds)));
    let processor = built.build_cpu_s.iter().map(|s| format!("{} of processor time", numbers::seconds(*s)));
    let mut taken = numbers::seconds(built.build_s) + &in_brackets(seconds.chain(processor).collect());
    if let Some(bytes) = built.memory_bytes {
        let memory =
            built.predicted.iter().map(|cost| format!("predicted {}", numbers::bytes(cost.memory_bytes as u64)));
        taken += &format!(", with {} of memory{}", numbers::bytes(bytes), in_brackets(memory.collect()));
    }
    taken
}

fn basis(basis: Basis) -> &'static str {
    match basis {
        Basis::Chebyshev => "Chebyshev",
        Basis::Taylor => "Taylor",
    }
}

fn value_text(value: &serde_json::Value) -> String {
    use serde_json::Value;
    match value {
        Value::Null => numbers::MISSING.into(),
        Value::Bool(true) => "yes".into(),
        Value::Bool(false) => "no".into(),
        Value::String(text) => text.clone(),
        // Provenance is quoted, not judged: all of its digits stay.
        Value::Number(number) => number.to_string(),
        Value::Array(items) => {
            let texts: Vec<String> = items.iter().map(value_text).collect();
            texts.join(", ")
        }
        Value::Object(entries) => {
            let texts: Vec<String> = entries
                .iter()
                .map(|(name, value)| format!("{}: {}", name.replace('_', " "), value_text(value)))
                .collect();
            texts.join("; ")
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use diffraction_build::accuracy::directions::Group;
    use diffraction_build::ground::sampling::Region;

    /// A row of one direction with this 95th percentile.
    pub(crate) fn error_row(cause: Cause, region: Region, p95: f64) -> ErrorRow {
        ErrorRow {
            cause,
            group: Group::Region(region),
            directions: 1,
            floor_per_sr: 1.5e-4,
            share_above: 1.0,
            directions_below: 32,
            missed_directions: 0,
            left_out_per_sr: None,
            relative_l2: 0.0,
            p50: 0.0,
            p95,
            p99: 0.0,
            worst: 0.0,
        }
    }

    #[test]
    fn what_is_counted_is_said_with_what_was_missed() {
        let row = |region, missed_directions| ErrorRow { missed_directions, ..error_row(Cause::Total, region, 0.0) };
        let rows = [row(Region::NearSpecular, 0), row(Region::Grazing, 0)];
        let text = counted_directions(&rows).replace('\u{a0}', " ");
        assert!(
            text.contains("above the luminance floor, 0.00015 /sr. ")
                && text.contains("near specular: 100 %; grazing: 100 %."),
            "{text}"
        );
        assert!(
            text.ends_with("Of 64 directions below that floor that were evaluated as well, none turned out above it."),
            "{text}"
        );
        assert!(
            counted_directions(&[row(Region::NearSpecular, 0), row(Region::Grazing, 3)])
                .contains(", 3 turned out above it")
        );
        let bounded = ErrorRow { left_out_per_sr: Some(3e-6), ..row(Region::Grazing, 0) };
        let text = counted_directions(&[row(Region::NearSpecular, 0), bounded]).replace('\u{a0}', " ");
        assert!(text.ends_with(" lower than the surface by up to 3.0 × 10⁻⁶ /sr, since its windows end."), "{text}");
    }

    #[test]
    fn rows_of_a_cause_stand_together_in_their_order() {
        let (near, far) = (Region::NearSpecular, Region::Grazing);
        let of = |rows: &[ErrorRow]| rows.iter().map(|row| (row.cause, row.group.clone())).collect::<Vec<_>>();
        let rows = |kinds: [(Cause, Region); 4]| kinds.map(|(cause, region)| error_row(cause, region, 0.0));
        let (total, basis) = (Cause::Total, Cause::Basis);
        let sorted = by_cause(&rows([(total, near), (basis, near), (total, far), (basis, far)]));
        assert_eq!(of(&sorted), of(&rows([(total, near), (total, far), (basis, near), (basis, far)])));
    }

    #[test]
    fn provenance_is_quoted_in_full() {
        let scan = serde_json::json!({
            "file_name": "a.tif", "pitch_nm": [48.828125, 50], "channel": null, "warnings": [],
            "tiled": false, "level": { "slope": 0.1 }
        });
        let facts: Vec<(String, String)> = of_scan(&scan).into_iter().map(|fact| (fact.name, fact.text)).collect();
        let expected =
            [("file name", "a.tif"), ("pitch nm", "48.828125, 50"), ("tiled", "no"), ("level", "slope: 0.1")];
        assert_eq!(facts.len(), expected.len());
        for (found, expected) in facts.iter().zip(expected) {
            assert_eq!((found.0.as_str(), found.1.as_str()), expected);
        }
    }

    #[test]
    fn directions_are_whole_degrees() {
        let period = |direction_deg| Period { period_nm: 1140.0, direction_deg, relative_power: 1.0 };
        let text = periods(&[period(-0.2), period(100.0), period(30.4)]);
        assert_eq!(
            text.replace('\u{a0}', " "),
            "a: 1.14 µm at 0°, power 1.0; b: 1.14 µm at 100°, power 1.0; c: 1.14 µm at 30°, power 1.0"
        );
    }
}
