// A sphere under disc lights, one full-screen triangle: what an interactive program draws. Follows tables.wgsl.

struct FrameParams {
    // Pixels along each side.
    size_px: f32,
    // The sphere's radius as a share of half the picture's side.
    radius: f32,
    light_count: u32,
    // Factor that brings XYZ to display values.
    exposure: f32,
}

struct FrameLight {
    // Unit vector in the world.
    direction: vec3<f32>,
    irradiance: f32,
    // Position in the pixel, in pixels from its centre, y up.
    pixel_offset: vec2<f32>,
    unused: vec2<f32>,
}

@group(1) @binding(0) var<uniform> frame: FrameParams;
@group(1) @binding(1) var<storage, read> lights: array<FrameLight>;

@vertex
fn full_screen(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(2.0 * corner - 1.0, 0.0, 1.0);
}

@fragment
fn shade_sphere(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    for (var index = 0u; index < frame.light_count; index = index + 1u) {
        let light = lights[index];
        let x = 2.0 * (position.x + light.pixel_offset.x) / frame.size_px - 1.0;
        let y = 1.0 - 2.0 * (position.y - light.pixel_offset.y) / frame.size_px;
        let at = vec2<f32>(x, y) / frame.radius;
        let z_squared = 1.0 - dot(at, at);
        if z_squared > 0.0 {
            // The tangent follows the circles of latitude, the bitangent points to the pole at +y.
            let normal = vec3<f32>(at, sqrt(z_squared));
            let along = vec3<f32>(normal.z, 0.0, -normal.x);
            let tangent = along / max(length(along), 1e-12);
            let bitangent = cross(normal, tangent);
            let to_light = light.direction;
            let wi = vec3<f32>(dot(tangent, to_light), dot(bitangent, to_light), dot(normal, to_light));
            let wo = vec3<f32>(tangent.z, bitangent.z, normal.z);
            if wi.z > 0.0 {
                let brdf = brdf_xyz(wi, wo);
                if !serves(brdf) {
                    return vec4<f32>(1.0, 0.0, 1.0, 1.0);
                }
                sum = sum + light.irradiance * wi.z * brdf;
            }
        }
    }
    return vec4<f32>(xyz_to_linear_srgb(frame.exposure * sum), 1.0);
}
