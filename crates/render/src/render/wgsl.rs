//! The shaders' sources: the entry points put behind the one that evaluates tables.

use diffraction_brdf::shader::{TABLES_FILTERED_WGSL, TABLES_WGSL};
use diffraction_brdf::shader_sampling::TABLES_SAMPLED_WGSL;
use diffraction_brdf::shader_spectral::{SPECTRAL_FILTERED_WGSL, SPECTRAL_WGSL};

/// Compute entry point [`SHADE_RUNS`].
const CHECK: &str = include_str!("shaders/check.wgsl");
/// Entry points [`FULL_SCREEN`] and [`SHADE_SURFACES`].
const FRAME: &str = include_str!("shaders/frame.wgsl");
/// Fragment entry point [`SHADE_MATERIAL`].
const MATERIAL: &str = include_str!("shaders/material.wgsl");

/// Compute entry point [`EVAL_SPECTRAL`].
const SPECTRAL_CHECK: &str = include_str!("shaders/spectral_check.wgsl");
/// Fragment entry point [`SHADE_SPECTRAL`].
const SPECTRAL_MATERIAL: &str = include_str!("shaders/spectral_material.wgsl");

/// Fragment entry point [`SHADE_MATERIAL_FILTERED`].
const MATERIAL_FILTERED: &str = include_str!("shaders/material_filtered.wgsl");
/// Fragment entry point [`SHADE_SPECTRAL_FILTERED`].
const SPECTRAL_MATERIAL_FILTERED: &str = include_str!("shaders/spectral_material_filtered.wgsl");
/// Compute entry point [`EVAL_FILTERED`], before the function that tells XYZ from wavelengths.
const FILTERED_CHECK: &str = include_str!("shaders/filtered_check.wgsl");

/// What a filtered query asks of tables of XYZ.
const FILTERED_XYZ: &str = "
fn value_of(query: FilteredQuery, footprint: vec3<f32>) -> vec4<f32> {
    let xyz = surface_xyz_filtered(query.wi, query.wo, footprint);
    return vec4<f32>(xyz, select(0.0, 1.0, has_answer(xyz)));
}
";

/// What a filtered query asks of spectral tables.
const FILTERED_SPECTRAL: &str = "
fn value_of(query: FilteredQuery, footprint: vec3<f32>) -> vec4<f32> {
    let value = brdf_spectral_filtered(query.wi, query.wo, query.wavelength_nm, footprint);
    return vec4<f32>(value, value, value, select(0.0, 1.0, has_answer(value)));
}
";

/// Compute entry point of [`check`]: one invocation per run of samples.
pub(crate) const SHADE_RUNS: &str = "shade_runs";
/// Vertex entry point of [`frame`].
pub(crate) const FULL_SCREEN: &str = "full_screen";
/// Fragment entry point of [`frame`].
pub(crate) const SHADE_SURFACES: &str = "shade_surfaces";
/// The other one, with a look-up over the disc of each light.
pub(crate) const SHADE_SURFACES_FILTERED: &str = "shade_surfaces_filtered";
/// Fragment entry point of [`material`].
pub const SHADE_MATERIAL: &str = "shade_material";

/// Source that shades uploaded samples.
pub fn check() -> String {
    [TABLES_WGSL, CHECK].join("\n")
}

/// Source that shades the stored surfaces of a frame.
pub fn frame() -> String {
    [TABLES_FILTERED_WGSL, FRAME].join("\n")
}

/// Source that other shading languages are translated from.
pub fn material() -> String {
    [TABLES_WGSL, MATERIAL].join("\n")
}

/// Compute entry point of [`spectral_check`]: one invocation per query.
pub(crate) const EVAL_SPECTRAL: &str = "eval_spectral";
/// Fragment entry point of [`spectral_material`].
pub const SHADE_SPECTRAL: &str = "shade_spectral";

/// Source that evaluates spectral tables for uploaded queries.
pub fn spectral_check() -> String {
    [SPECTRAL_WGSL, SPECTRAL_CHECK].join("\n")
}

/// Source for spectral tables that other shading languages are translated from.
pub fn spectral_material() -> String {
    [SPECTRAL_WGSL, SPECTRAL_MATERIAL].join("\n")
}

/// Compute entry point of [`filtered_check`] and [`filtered_spectral_check`]: one invocation per query.
pub(crate) const EVAL_FILTERED: &str = "eval_filtered";

/// Source that evaluates tables of XYZ over footprints of uploaded queries.
pub fn filtered_check() -> String {
    [TABLES_FILTERED_WGSL, FILTERED_CHECK, FILTERED_XYZ].join("\n")
}

/// The same for spectral tables.
pub fn filtered_spectral_check() -> String {
    [SPECTRAL_FILTERED_WGSL, FILTERED_CHECK, FILTERED_SPECTRAL].join("\n")
}

/// Fragment entry point of [`material_filtered`].
pub const SHADE_MATERIAL_FILTERED: &str = "shade_material_filtered";
/// Fragment entry point of [`spectral_material_filtered`].
pub const SHADE_SPECTRAL_FILTERED: &str = "shade_spectral_filtered";

/// As [`material`], over a footprint.
pub fn material_filtered() -> String {
    [TABLES_FILTERED_WGSL, MATERIAL_FILTERED].join("\n")
}

/// As [`spectral_material`], over a footprint.
pub fn spectral_material_filtered() -> String {
    [SPECTRAL_FILTERED_WGSL, SPECTRAL_MATERIAL_FILTERED].join("\n")
}

/// Fragment entry point [`SHADE_MATERIAL_SAMPLED`].
const MATERIAL_SAMPLED: &str = include_str!("shaders/material_sampled.wgsl");
/// Compute entry points [`DRAW_SAMPLES`] and [`EVAL_DENSITIES`].
const SAMPLED_CHECK: &str = include_str!("shaders/sampled_check.wgsl");

/// Fragment entry point of [`material_sampled`].
pub const SHADE_MATERIAL_SAMPLED: &str = "shade_material_sampled";
/// Compute entry points of [`sampled_check`]: one invocation per query.
pub(crate) const DRAW_SAMPLES: &str = "draw_samples";
/// The other one.
pub(crate) const EVAL_DENSITIES: &str = "eval_densities";

/// As [`material_filtered`], of a direction that is drawn.
pub fn material_sampled() -> String {
    [TABLES_SAMPLED_WGSL, MATERIAL_SAMPLED].join("\n")
}

/// Source that draws directions and evaluates their densities for uploaded queries.
pub fn sampled_check() -> String {
    [TABLES_SAMPLED_WGSL, SAMPLED_CHECK].join("\n")
}
