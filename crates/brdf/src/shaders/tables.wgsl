// The BRDF of a table set: evaluation only, the same functions under the same names as in Rust. Follows optics.wgsl.
// The BRDF is XYZ in 1/sr; `brdf_xyz` gives NO_ANSWER in every channel for directions that the tables do not cover.

// basis
const CHEBYSHEV: u32 = 0u;
const TAYLOR: u32 = 1u;

struct TableParams {
    // CHEBYSHEV or TAYLOR.
    basis: u32,
    // Layers of `tables`.
    table_count: u32,
    // Layers of `cross_terms` that count; 0 where the cross term vanishes.
    cross_count: u32,
    // IDEAL, DIELECTRIC or CONDUCTOR.
    material: u32,
    // 1 where the V-cavity factor is applied.
    shadowing: u32,
    // Outer radius of the coherent lobe; 0 where there is none.
    radius_max: f32,
    // Refractive index n + ik.
    index_n: f32,
    index_k: f32,
    // 1 where the tables are restricted to scenes: one more layer of `tables` holds the range of t of each texel.
    restricted: u32,
    // Texels along u and v of the whole grid less one, and where in it the tables' window begins.
    grid_last: f32,
    first_column: f32,
    first_row: f32,
    // SCALAR (R G) or VECTOR (first-order vector perturbation).
    factor: u32,
    // LINEAR, or SPLINES where the finest level of `tables` holds coefficients of splines in place of values.
    look_up: u32,
    // (n + ik)², real and imaginary part.
    permittivity: vec2<f32>,
    // XYZ of the pigment below the structure in 1/sr, and 1 where there is one.
    pigment: vec4<f32>,
    // Value of a layer = texel times scale; four scales to a vector.
    table_scales: array<vec4<f32>, 64>,
    cross_scales: array<vec4<f32>, 64>,
}

@group(0) @binding(0) var<uniform> params: TableParams;
// Half floats, one layer per basis function; texel (row, column) of the whole grid lies at u = -2 + 4 column / grid_last,
// v = 2 - 4 row / grid_last. Where tables are restricted to scenes, the layer after the last holds low, high and 1 where
// a texel is covered.
@group(0) @binding(1) var tables: texture_2d_array<f32>;
// Half floats, one layer per basis function, over [-radius_max, radius_max]².
@group(0) @binding(2) var cross_terms: texture_2d_array<f32>;
// 32-bit floats: rows are t from 0 to 1, columns the radius from 0 to radius_max.
@group(0) @binding(3) var lobe: texture_2d<f32>;
// Bilinear, clamped to the edges.
@group(0) @binding(4) var bilinear: sampler;

// How far t may lie outside of the range between the texels, as a share of the range.
const RANGE_SLACK: f32 = 0.02;

fn front_factor() -> Front {
    let index = vec2<f32>(params.index_n, params.index_k);
    return Front(params.material, params.factor, params.shadowing, index, params.permittivity);
}

// XYZ of the pigment's BRDF in 1/sr; 0 for directions not above the surface.
fn pigment_xyz(wi: vec3<f32>, wo: vec3<f32>) -> vec3<f32> {
    if !(wi.z > 0.0 && wo.z > 0.0) {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    let front = front_factor();
    return (1.0 - reflectance(front, wi.z)) * (1.0 - reflectance(front, wo.z)) * params.pigment.xyz;
}

// Basis functions in registers: b_0 = first, b_1 = second, b_n+1 = forward b_n - back b_n-1.
struct Recurrence {
    first: f32,
    second: f32,
    forward: f32,
    back: f32,
}

// T_n(2t - 1).
fn shifted_values(t: f32) -> Recurrence {
    let x = 2.0 * t - 1.0;
    return Recurrence(1.0, x, 2.0 * x, 1.0);
}

// |w|^(n - 2).
fn powers(w: f32) -> Recurrence {
    let first = (1.0 / w) / w;
    return Recurrence(first, 1.0 / w, w, 0.0);
}

// What the surface shows in 1/sr: the BRDF and, where there is one, the pigment below it. As `brdf_xyz` otherwise.
fn surface_xyz(wi: vec3<f32>, wo: vec3<f32>) -> vec3<f32> {
    let brdf = brdf_xyz(wi, wo);
    if params.pigment.w == 0.0 || !has_answer(brdf) {
        return brdf;
    }
    return brdf + pigment_xyz(wi, wo);
}

// XYZ of the BRDF in 1/sr; 0 for directions not above the surface, NO_ANSWER for those that the tables do not cover.
fn brdf_xyz(wi: vec3<f32>, wo: vec3<f32>) -> vec3<f32> {
    if !(wi.z > 0.0 && wo.z > 0.0) {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    let q = wave_vector_change(wi, wo);
    let t = normalised_abs_w(q);
    let at = 0.5 * q.xy;
    var s = t;
    if params.restricted != 0u {
        s = share_of_range(at, t);
        if s < 0.0 {
            return vec3<f32>(NO_ANSWER, NO_ANSWER, NO_ANSWER);
        }
    }
    var basis = shifted_values(s);
    if params.basis == TAYLOR {
        basis = powers(abs(q.z));
    }
    // One loop for both, a tenth faster than one each where branches are masked; sets of powers have no lobe.
    let diffuse = diffuse_factor(front_factor(), wi, wo) * (expansion(basis, at) + cross_value(q, t));
    return diffuse + coherent_value(wi, wo, q);
}

// Whether a value is an answer.
fn has_answer(xyz: vec3<f32>) -> bool {
    return !(xyz.x == NO_ANSWER && xyz.y == NO_ANSWER && xyz.z == NO_ANSWER);
}

// Where t lies in the range at a position, 0 to 1; negative outside of what is covered.
fn share_of_range(at: vec2<f32>, t: f32) -> f32 {
    let uv = table_place(at);
    let half_texel = 0.5 / vec2<f32>(textureDimensions(tables));
    let range = textureSampleLevel(tables, bilinear, uv, params.table_count, 0.0).rgb;
    let inside = all(uv > 0.99 * half_texel) && all(1.0 - uv > 0.99 * half_texel);
    let s = (t - range.x) / (range.y - range.x);
    if !(inside && range.z > 0.998 && s >= -RANGE_SLACK && s <= 1.0 + RANGE_SLACK) {
        return -1.0;
    }
    return clamp(s, 0.0, 1.0);
}

// The cross term over |w|; 0 where it vanishes.
fn cross_value(q: vec3<f32>, t: f32) -> vec3<f32> {
    if params.cross_count == 0u || max(abs(q.x), abs(q.y)) >= params.radius_max {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    return cross_expansion(shifted_values(t), q.xy / params.radius_max) / abs(q.z);
}

// The coherent lobe with its factor. With the vector factor, what would leave below the horizon comes back above it.
fn coherent_value(wi: vec3<f32>, wo: vec3<f32>, q: vec3<f32>) -> vec3<f32> {
    let radius = length(q.xy);
    if radius >= params.radius_max {
        // The image lies farther away still.
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    var value = lobe_at(radius, q.z);
    if params.factor == VECTOR {
        value = value + lobe_at(sqrt(image_radius2(wi, wo)), q.z);
    }
    return coherent_factor(front_factor(), wi, wo) * value;
}

// The coherent table at a radius and w: 0 from radius_max on.
fn lobe_at(radius: f32, w: f32) -> vec3<f32> {
    if radius >= params.radius_max {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    let last = vec2<f32>(textureDimensions(lobe)) - 1.0;
    let t = normalised_abs_w(vec3<f32>(radius, 0.0, w));
    return sample(vec2<f32>(t * last.y, radius / params.radius_max * last.x));
}

// Sum of basis_n table_n at a position in [-1, 1]².
fn expansion(basis: Recurrence, at: vec2<f32>) -> vec3<f32> {
    let uv = table_place(at);
    if params.look_up == SPLINES {
        return expansion_by_splines(basis, spline_places(uv));
    }
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    var now = basis.first;
    var next = basis.second;
    for (var n = 0u; n < params.table_count; n = n + 1u) {
        let texel = textureSampleLevel(tables, bilinear, uv, n, 0.0).rgb;
        sum = sum + (now * params.table_scales[n / 4u][n % 4u]) * texel;
        let after = basis.forward * next - basis.back * now;
        now = next;
        next = after;
    }
    return sum;
}

fn expansion_by_splines(basis: Recurrence, places: SplinePlaces) -> vec3<f32> {
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    var now = basis.first;
    var next = basis.second;
    for (var n = 0u; n < params.table_count; n = n + 1u) {
        sum = sum + (now * params.table_scales[n / 4u][n % 4u]) * spline_texel(places, n).rgb;
        let after = basis.forward * next - basis.back * now;
        now = next;
        next = after;
    }
    return sum;
}

// The same for the patch of the cross term.
fn cross_expansion(basis: Recurrence, at: vec2<f32>) -> vec3<f32> {
    let uv = texel_centred(at, textureDimensions(cross_terms));
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    var now = basis.first;
    var next = basis.second;
    for (var n = 0u; n < params.cross_count; n = n + 1u) {
        let texel = cross_texel(uv, n).rgb;
        sum = sum + (now * params.cross_scales[n / 4u][n % 4u]) * texel;
        let after = basis.forward * next - basis.back * now;
        now = next;
        next = after;
    }
    return sum;
}

// Normalised coordinates in the tables of a position in [-1, 1]², y up.
fn table_place(at: vec2<f32>) -> vec2<f32> {
    let texel = vec2<f32>(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y) * params.grid_last;
    return (texel - vec2<f32>(params.first_column, params.first_row) + 0.5) / vec2<f32>(textureDimensions(tables));
}

// The coherent lobe at a position in texels (row, column). Bilinear by hand: the lobe spans nine decades,
// too many for half floats, and filtering 32-bit floats is not everywhere to be had.
fn sample(at: vec2<f32>) -> vec3<f32> {
    let last = vec2<i32>(textureDimensions(lobe)).yx - 1;
    if params.look_up == SPLINES && min(last.x, last.y) >= 3 {
        return sample_cubic(clamp(at, vec2<f32>(0.0, 0.0), vec2<f32>(last)), last);
    }
    let inside = clamp(at, vec2<f32>(0.0, 0.0), vec2<f32>(last));
    let first = max(min(vec2<i32>(inside), last - 1), vec2<i32>(0, 0));
    let second = min(first + 1, last);
    let share = inside - vec2<f32>(first);
    let low = mix(
        textureLoad(lobe, vec2<i32>(first.y, first.x), 0).rgb,
        textureLoad(lobe, vec2<i32>(second.y, first.x), 0).rgb,
        share.y,
    );
    let high = mix(
        textureLoad(lobe, vec2<i32>(first.y, second.x), 0).rgb,
        textureLoad(lobe, vec2<i32>(second.y, second.x), 0).rgb,
        share.y,
    );
    return mix(low, high, share.x);
}

fn sample_cubic(at: vec2<f32>, last: vec2<i32>) -> vec3<f32> {
    let first = clamp(vec2<i32>(at) - 1, vec2<i32>(0, 0), last - 3);
    let down = lagrange_weights(at.x - f32(first.x));
    let across = lagrange_weights(at.y - f32(first.y));
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    for (var k = 0; k < 16; k = k + 1) {
        let texel = textureLoad(lobe, vec2<i32>(first.y + k % 4, first.x + k / 4), 0).rgb;
        sum = sum + across[k % 4] * down[k / 4] * texel;
    }
    return sum;
}

// IEC 61966-2-1 primaries and white; components may be negative.
fn xyz_to_linear_srgb(xyz: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(
        dot(vec3<f32>(3.2404542, -1.5371385, -0.4985314), xyz),
        dot(vec3<f32>(-0.9692660, 1.8760108, 0.0415560), xyz),
        dot(vec3<f32>(0.0556434, -0.2040259, 1.0572252), xyz),
    );
}
