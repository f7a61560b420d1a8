//! What the report says about a specimen in words and numbers.

use crate::report::frames::period_letter;
use crate::report::look_up_facts::look_ups;
use crate::report::numbers;
use crate::report::optics_facts::{coherence, light, material};
use crate::report::table_facts::{format_of, grid_short, made_from, rim, spectral_tables, tables, texels};
use crate::stages::results::{Period, SpecimenResult, Statistics};
use diffraction_build::accuracy::power_sums::DirectionalAlbedo;
use diffraction_build::height::statistics::{STEEP_SLOPE, WAVES_MIN, least_uv_radius};
use diffraction_build::tables::model::Storage;

/// A name and what is to be said about it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fact {
    /// The name.
    pub name: String,
    /// A short text.
    pub text: String,
}

/// A fact.
pub(crate) fn fact(name: &str, text: String) -> Fact {
    Fact { name: name.into(), text }
}

/// What is known of the surface, and of the light that it was computed for; nothing of a scan that could not be read.
pub(crate) fn of_surface(specimen: &SpecimenResult) -> Vec<Fact> {
    let mut facts = Vec::new();
    if specimen.size.iter().all(|count| *count > 0) {
        facts.push(fact("Scan", scan(specimen)));
    }
    if let Some(found) = &specimen.statistics {
        facts.push(fact("Heights", heights(found)));
        facts.push(fact("Slopes", slopes(found)));
        facts.extend(found.surface.map(|surface| fact("ISO 25178", surface.to_string())));
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
    if !specimen.albedo.is_empty() {
        facts.push(fact("Albedo", albedo(&specimen.albedo)));
    }
    facts
}

/// What is known of the tables.
pub(crate) fn of_tables(specimen: &SpecimenResult) -> Vec<Fact> {
    let mut facts = Vec::new();
    if let Some(built) = &specimen.build {
        facts.push(fact("Tables", tables(built)));
        facts.extend(built.rounding.map(|rounding| fact("Numbers", format_of(built.storage, rounding))));
        facts.push(fact("Texels", texels(built)));
        facts.push(fact("Rim", rim(built)));
        facts.extend(look_ups(built, &specimen.errors).map(|text| fact("Look-ups", text)));
        facts.push(fact("Made from", made_from(built)));
    }
    facts.extend(specimen.spectral.as_ref().map(|spectral| fact("Spectral tables", spectral_tables(spectral))));
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

/// What a look-up costs: `None` where there are no tables.
pub(crate) fn cost(specimen: &SpecimenResult) -> Option<String> {
    let built = specimen.build.as_ref()?;
    let halves = 8 * built.tables as u64 * (built.size as u64).pow(2);
    let spectral = specimen.spectral.as_ref().map_or_else(String::new, |spectral| {
        format!(" {} more tables answer for single wavelengths and other lights.", spectral.tables)
    });
    let textures = match built.rounding.filter(|_| built.storage == Storage::Float) {
        None => format!("{} as textures of four 16-bit numbers", numbers::bytes(halves)),
        Some(rounding) => format!(
            "stored as 32-bit floats; {} as textures of four, or {} of four 16-bit ones, which shift one colour in twenty by {} or more",
            numbers::bytes(2 * halves),
            numbers::bytes(halves),
            numbers::percent(rounding.half)
        ),
    };
    Some(format!(
        "{} tables of {}: a linear look-up is a fetch of each, a spline four, and up to two more near the mirror direction. {} of \
         files, {textures}.{spectral}",
        built.tables,
        grid_short(built),
        numbers::bytes(built.stored_bytes)
    ))
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
        texts.map(move |text| prefix(scan) + text.as_str().unwrap_or_default())
    });
    let stale = specimen
        .stale
        .iter()
        .map(|why| format!("this is the result of an older version, for making it again failed: {why}"));
    let mut found: Vec<String> = stale.collect();
    for warning in specimen.warnings.iter().cloned().chain(of_statistics).chain(of_scans) {
        if !found.contains(&warning) {
            found.push(warning);
        }
    }
    found
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

#[cfg(test)]
mod tests {
    use super::*;

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
