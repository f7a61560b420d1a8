//! The shaders' sources: the entry points put behind the one that evaluates tables.

use diffraction_brdf::shader::TABLES_WGSL;
use diffraction_brdf::shader_spectral::SPECTRAL_WGSL;

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

/// Compute entry point of [`check`]: one invocation per run of samples.
pub(crate) const SHADE_RUNS: &str = "shade_runs";
/// Vertex entry point of [`frame`].
pub(crate) const FULL_SCREEN: &str = "full_screen";
/// Fragment entry point of [`frame`].
pub(crate) const SHADE_SURFACES: &str = "shade_surfaces";
/// Fragment entry point of [`material`].
pub const SHADE_MATERIAL: &str = "shade_material";

/// Source that shades uploaded samples.
pub fn check() -> String {
    [TABLES_WGSL, CHECK].join("\n")
}

/// Source that shades the stored surfaces of a frame.
pub fn frame() -> String {
    [TABLES_WGSL, FRAME].join("\n")
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
