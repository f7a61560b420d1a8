// A material for other renderers: directions in the local frame and a wavelength in, one number out. Follows spectral.wgsl.

// BRDF at the wavelength in nm times the cosine of incidence, in 1/sr, in the first channel; the second is 1 where the tables have
// an answer and 0 where they have none.
@fragment
fn shade_spectral(
    @location(0) wi: vec3<f32>,
    @location(1) wo: vec3<f32>,
    @location(2) wavelength_nm: f32,
) -> @location(0) vec4<f32> {
    let to_light = normalize(wi);
    let value = brdf_spectral(to_light, normalize(wo), wavelength_nm);
    if !has_answer(value) {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    return vec4<f32>(value * max(to_light.z, 0.0), 1.0, 0.0, 1.0);
}
