// A material for other renderers: directions in the local frame in, linear sRGB out. Follows tables.wgsl.

// BRDF and pigment times the cosine of incidence, in 1/sr, for a light of unit irradiance; components may be negative.
@fragment
fn shade_material(@location(0) wi: vec3<f32>, @location(1) wo: vec3<f32>) -> @location(0) vec4<f32> {
    let to_light = normalize(wi);
    let to_viewer = normalize(wo);
    let shown = surface_xyz(to_light, to_viewer);
    if !has_answer(shown) {
        // No answer: magenta, which no surface is by itself.
        return vec4<f32>(1.0, 0.0, 1.0, 1.0);
    }
    let xyz = shown * max(to_light.z, 0.0);
    return vec4<f32>(xyz_to_linear_srgb(xyz), 1.0);
}
