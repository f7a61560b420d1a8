//! The shaders' sources: the entry points put behind the one that evaluates tables.

use diffraction_brdf::shader::TABLES_WGSL;

/// Compute entry point [`SHADE_RUNS`].
const CHECK: &str = include_str!("shaders/check.wgsl");
/// Entry points [`FULL_SCREEN`] and [`SHADE_SURFACES`].
const FRAME: &str = include_str!("shaders/frame.wgsl");
/// Fragment entry point [`SHADE_MATERIAL`].
const MATERIAL: &str = include_str!("shaders/material.wgsl");

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
