// A sampled material for other renderers: the direction to the viewer, a footprint and random numbers in, linear sRGB of one sample out.
// Follows tables.wgsl, tables_filtered.wgsl and sampling_tables.wgsl.

// What one direction, drawn by three even random numbers, shows of a sky whose radiance is 1 everywhere: the mean over many is the share
// that the surface reflects, as a colour. A sky of one's own is looked up at the direction that is drawn.
@fragment
fn shade_material_sampled(
    @location(0) wo: vec3<f32>,
    @location(1) footprint: vec3<f32>,
    @location(2) random: vec3<f32>,
) -> @location(0) vec4<f32> {
    let to_viewer = normalize(wo);
    let drawn = brdf_sample(to_viewer, random);
    if !(drawn.w > 0.0) {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    let shown = surface_xyz_filtered(drawn.xyz, to_viewer, footprint);
    if !has_answer(shown) {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    return vec4<f32>(xyz_to_linear_srgb(shown * (drawn.z / drawn.w)), 1.0);
}
