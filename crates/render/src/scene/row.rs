//! One row of a picture while its shading samples are gathered.

use diffraction_brdf::direction::Vec3;

/// Samples of one pixel row while it is being gathered.
#[derive(Debug, Default)]
pub struct RowSamples {
    pub(super) counts: Vec<u32>,
    pub(super) wi: Vec<[f32; 3]>,
    pub(super) wo: Vec<[f32; 3]>,
    pub(super) weight: Vec<f32>,
}

/// Adds a sample to the pixel being gathered, unless a direction is at or below the surface or the
/// weight vanishes.
pub fn push(out: &mut RowSamples, wi: Vec3, wo: Vec3, weight: f64) {
    // Tested after rounding: what is stored is what is shaded.
    let (wi, wo) = (wi.map(|c| c as f32), wo.map(|c| c as f32));
    let weight = weight as f32;
    if wi[2] > 0.0 && wo[2] > 0.0 && weight > 0.0 {
        out.wi.push(wi);
        out.wo.push(wo);
        out.weight.push(weight);
    }
}
