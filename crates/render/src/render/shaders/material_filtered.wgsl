// A filtered material for other renderers: directions in the local frame and a footprint in, linear sRGB out. Follows tables.wgsl and
// tables_filtered.wgsl.

// As `shade_material`, as the mean over a footprint (uu, uv, vv): see `footprint_of_light` and `footprint_of_normals`.
@fragment
fn shade_material_filtered(
    @location(0) wi: vec3<f32>,
    @location(1) wo: vec3<f32>,
    @location(2) footprint: vec3<f32>,
) -> @location(0) vec4<f32> {
    let to_light = normalize(wi);
    let shown = surface_xyz_filtered(to_light, normalize(wo), footprint);
    if !has_answer(shown) {
        // No answer: magenta, which no surface is by itself.
        return vec4<f32>(1.0, 0.0, 1.0, 1.0);
    }
    return vec4<f32>(xyz_to_linear_srgb(shown * max(to_light.z, 0.0)), 1.0);
}
