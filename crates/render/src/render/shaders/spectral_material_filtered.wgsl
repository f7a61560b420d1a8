// A filtered material for other renderers: directions in the local frame, a wavelength and a footprint in, one number out. Follows
// spectral.wgsl and spectral_filtered.wgsl.

// As `shade_spectral`, as the mean over a footprint (uu, uv, vv).
@fragment
fn shade_spectral_filtered(
    @location(0) wi: vec3<f32>,
    @location(1) wo: vec3<f32>,
    @location(2) wavelength_nm: f32,
    @location(3) footprint: vec3<f32>,
) -> @location(0) vec4<f32> {
    let to_light = normalize(wi);
    let value = brdf_spectral_filtered(to_light, normalize(wo), wavelength_nm, footprint);
    if !has_answer(value) {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    return vec4<f32>(value * max(to_light.z, 0.0), 1.0, 0.0, 1.0);
}
