// The lighting pass of an interactive program: stored surfaces under distant lights. Follows tables.wgsl.

struct FrameParams {
    // Pixels along each side.
    size_px: u32,
    light_count: u32,
    // Words of `lit` for each pixel.
    lit_words: u32,
    // Factor that brings XYZ to display values.
    exposure: f32,
}

struct FrameLight {
    // Unit vector in the world.
    direction: vec3<f32>,
    irradiance: f32,
    // Layer of the surfaces that this light is shaded on.
    layer: u32,
    // In radians; 0 for a point.
    angular_radius: f32,
}

@group(1) @binding(0) var<uniform> frame: FrameParams;
@group(1) @binding(1) var<storage, read> lights: array<FrameLight>;
// Bit `light % 32` of word `light / 32` is set where nothing shades a pixel from the light.
@group(1) @binding(2) var<storage, read> lit: array<u32>;
// World vectors, one texel a pixel: the structure's x axis with the sign of its y axis against normal x tangent, the
// outward normal, the direction to the viewer.
@group(1) @binding(3) var tangents: texture_2d_array<f32>;
@group(1) @binding(4) var normals: texture_2d_array<f32>;
@group(1) @binding(5) var viewers: texture_2d_array<f32>;

@vertex
fn full_screen(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(2.0 * corner - 1.0, 0.0, 1.0);
}

@fragment
fn shade_surfaces(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return shaded(position, false);
}

// The same with one look-up for the whole disc of each light.
@fragment
fn shade_surfaces_filtered(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return shaded(position, true);
}

fn shaded(position: vec4<f32>, filtered: bool) -> vec4<f32> {
    let at = vec2<i32>(position.xy);
    let first_word = (u32(at.y) * frame.size_px + u32(at.x)) * frame.lit_words;
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    for (var index = 0u; index < frame.light_count; index = index + 1u) {
        if ((lit[first_word + index / 32u] >> (index % 32u)) & 1u) == 0u {
            continue;
        }
        let light = lights[index];
        let tangent = textureLoad(tangents, at, light.layer, 0);
        let normal = textureLoad(normals, at, light.layer, 0).xyz;
        let to_viewer = textureLoad(viewers, at, light.layer, 0).xyz;
        let bitangent = tangent.w * cross(normal, tangent.xyz);
        let wi = in_frame(tangent.xyz, bitangent, normal, light.direction);
        let wo = in_frame(tangent.xyz, bitangent, normal, to_viewer);
        var shown: vec3<f32>;
        if filtered {
            shown = surface_xyz_filtered(wi, wo, footprint_of_light(wi, light.angular_radius));
        } else {
            shown = surface_xyz(wi, wo);
        }
        if !has_answer(shown) {
            return vec4<f32>(1.0, 0.0, 1.0, 1.0);
        }
        sum = sum + light.irradiance * wi.z * shown;
    }
    return vec4<f32>(xyz_to_linear_srgb(frame.exposure * sum), 1.0);
}

fn in_frame(tangent: vec3<f32>, bitangent: vec3<f32>, normal: vec3<f32>, v: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(dot(tangent, v), dot(bitangent, v), dot(normal, v));
}
