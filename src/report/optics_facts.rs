//! What the report says about light, coherence and material.

use crate::report::numbers;
use diffraction_brdf::dispersion::Origin;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::dispersive::Dispersive;

pub(crate) fn light(optics: &OpticsConfig) -> String {
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

pub(crate) fn coherence(optics: &OpticsConfig) -> String {
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
        (None, None) => {
            let follows = if optics.sigma_follows_scan { " (auto: what the scan tells)" } else { "" };
            format!("σ = {} µm{follows}, {edge}, {windows}", sigma(optics.sigma_nm))
        }
        (None, Some(light_nm)) => format!(
            "σ = {} µm for the coherent lobe (the light's), {} µm for the rest (as much as the scan resolves), {edge}, {windows}",
            sigma(light_nm),
            sigma(optics.sigma_nm)
        ),
    }
}

pub(crate) fn material(optics: &OpticsConfig) -> String {
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
