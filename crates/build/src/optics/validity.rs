//! Where the model ends: which orders and angles of a surface to doubt, from its slopes and walls at the scale of the wavelength.
//!
//! The limits are those above which some diffraction order is off by two or more from rigorous ones; how they were chosen, and
//! how often they are right, is told in `tests/rigorous/README.md`.

use super::config::{Factor, Material};
use crate::height::HeightField;
use crate::height::statistics::{wall_share, wave_slope, wave_slope_max, wavelength_told_nm};

/// Share of points at walls from which on conductors are doubtful in light more oblique than 45 degrees.
const WALL_LIMIT: f64 = 0.01;

/// Step in nm in which the wavelength is looked for at which a limit is crossed.
const WAVELENGTH_STEP_NM: f64 = 5.0;

/// Slope over a quarter wavelength above which some order is to be expected off by two or more.
pub(crate) fn slope_limit(material: Material, factor: Factor) -> f64 {
    match (material, factor) {
        (Material::Dielectric { .. }, Factor::Vector) => 0.40,
        (Material::Dielectric { .. }, Factor::Scalar) => 0.30,
        (Material::Conductor { .. } | Material::Ideal, _) => 0.25,
    }
}

fn conducts(material: Material) -> bool {
    !matches!(material, Material::Dielectric { .. })
}

/// Whether the slopes are too steep at a wavelength in nm, whatever the angle of incidence.
pub(crate) fn is_steep(field: &HeightField, wavelength_nm: f64, material: Material, factor: Factor) -> bool {
    wave_slope(field, wavelength_nm) > slope_limit(material, factor)
}

/// Whether there are too many walls at a wavelength in nm for light more oblique than 45 degrees: on conductors alone.
pub(crate) fn is_walled(field: &HeightField, wavelength_nm: f64, material: Material) -> bool {
    conducts(material) && wall_share(field, wavelength_nm) > WALL_LIMIT
}

/// Which orders and angles of a surface to doubt under light of these wavelengths in nm, in whole sentences; nothing where
/// orders are as a rule within a factor of two.
pub fn doubts(field: &HeightField, wavelength_nm: [f64; 2], material: Material, factor: Factor) -> Vec<String> {
    let shortest_nm = wavelength_nm[0];
    let limit = slope_limit(material, factor);
    let mut sentences = Vec::new();
    if is_steep(field, shortest_nm, material, factor) {
        let (what, model) = (kind(material), model(material, factor));
        sentences.push(format!(
            "Over a quarter of {shortest_nm} nm the surface is steeper (rms slope {:.2}) than {limit:.2}, up to which orders of \
             {what} with {model} are within a factor of two; {}. Doubt first the orders that leave beyond 60 degrees, those \
             that in oblique light go back towards the light, and those weaker than a tenth of the strongest.",
            wave_slope(field, shortest_nm),
            until(wavelength_nm, |nm| is_steep(field, nm, material, factor)),
        ));
    } else if let Some(sentence) = too_coarse(field, wavelength_nm, limit) {
        sentences.push(sentence);
    }
    if is_walled(field, shortest_nm, material) {
        sentences.push(format!(
            "{:.1} % of the surface are walls (more than a tenth of {shortest_nm} nm high within a tenth of it): of {} doubt all \
             but the strongest orders in light more oblique than 45 degrees; {}.",
            100.0 * wall_share(field, shortest_nm),
            kind(material),
            until(wavelength_nm, |nm| is_walled(field, nm, material)),
        ));
    }
    sentences
}

/// That the sampling cannot tell, for a surface whose heights would allow slopes above the limit.
fn too_coarse(field: &HeightField, [shortest_nm, longest_nm]: [f64; 2], limit: f64) -> Option<String> {
    let told_nm = wavelength_told_nm(field);
    let rms_nm = {
        let mean = field.heights_nm.mean().unwrap_or(0.0);
        (field.heights_nm.iter().map(|height| (height - mean).powi(2)).sum::<f64>() / field.heights_nm.len() as f64)
            .sqrt()
    };
    let may_be_steep = wave_slope_max(rms_nm, shortest_nm) > limit;
    (told_nm > shortest_nm && may_be_steep).then(|| {
        let below = if told_nm > longest_nm { "at any wavelength".to_owned() } else { format!("below {told_nm:.0} nm") };
        format!(
            "Samples {:.1} nm apart are too coarse to tell {below} whether the surface is too steep for the model: that takes a \
             pitch of a fifth of the wavelength.",
            told_nm * 0.2
        )
    })
}

/// Up to which wavelength a doubt holds that holds at the shortest, in words. Slopes and walls as a rule fall towards longer
/// wavelengths, so one crossing is looked for.
fn until([shortest_nm, longest_nm]: [f64; 2], holds: impl Fn(f64) -> bool) -> String {
    if holds(longest_nm) {
        return match shortest_nm < longest_nm {
            true => format!("so it is at every wavelength up to {longest_nm} nm"),
            false => "so it is at this wavelength".to_owned(),
        };
    }
    let [mut inside, mut outside] = [shortest_nm, longest_nm];
    while outside - inside > WAVELENGTH_STEP_NM {
        let middle = 0.5 * (inside + outside);
        if holds(middle) { inside = middle } else { outside = middle }
    }
    format!("so it is up to about {outside:.0} nm, and beyond it is not")
}

fn kind(material: Material) -> &'static str {
    match material {
        Material::Ideal => "an ideal reflector",
        Material::Dielectric { .. } => "a dielectric",
        Material::Conductor { .. } => "a conductor",
    }
}

fn model(material: Material, factor: Factor) -> &'static str {
    match (material, factor) {
        (Material::Ideal, _) | (_, Factor::Scalar) => "the scalar factor",
        (_, Factor::Vector) => "the vector factor",
    }
}

#[cfg(test)]
#[path = "validity_tests.rs"]
mod tests;
