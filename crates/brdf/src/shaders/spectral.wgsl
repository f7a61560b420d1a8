// The BRDF of spectral tables at one wavelength: evaluation only, the same functions under the same names as in Rust. Follows
// optics.wgsl.
//
// With r = shortest_nm / wavelength and q' = r q, one expansion in T_n(2t' - 1) over (u', v') answers for every wavelength:
//
//   f = r^4 D (tables + cross) + r^2 C lobe
//
// The BRDF is in 1/sr.

struct SpectralParams {
    // Layers of `tables`, four tables to a layer.
    table_layers: u32,
    // Layers of `cross_terms` that count; 0 where the cross term vanishes.
    cross_layers: u32,
    // Texels of `lobe` that count, row by row; 0 where the tables contain the lobe.
    lobe_count: u32,
    // IDEAL, DIELECTRIC or CONDUCTOR.
    material: u32,
    // SCALAR (R G) or VECTOR (first-order vector perturbation).
    factor: u32,
    // 1 where the V-cavity factor is applied.
    shadowing: u32,
    // Refractive index n + ik at the wavelength that `brdf_spectral` is called with.
    index_n: f32,
    index_k: f32,
    // (n + ik)², real and imaginary part.
    permittivity: vec2<f32>,
    // Wavelength in nm that the tables were made for, the shortest that they answer for.
    shortest_nm: f32,
    // Standard deviation in nm of the light's coherence window at the shortest wavelength, which sets the lobe's width.
    lobe_sigma_nm: f32,
    // Half the side of the cross term's patches in (u', v').
    cross_radius: f32,
    // 1 where lobe_sigma_nm grows in proportion to the wavelength, as under a source of fixed size.
    of_source: u32,
    // LINEAR, or SPLINES where the finest level of `tables` holds coefficients of splines in place of values.
    look_up: u32,
    // Value of a table = texel times scale: the scales of a layer's four tables to a vector.
    table_scales: array<vec4<f32>, 64>,
    cross_scales: array<vec4<f32>, 64>,
}

@group(0) @binding(0) var<uniform> params: SpectralParams;
// Half floats; table n is channel n % 4 of layer n / 4, channels without a table are 0. Texel (row, column) of `side` lies at
// u' = -2 + 4 column / (side - 1), v' = 2 - 4 row / (side - 1).
@group(0) @binding(1) var tables: texture_2d_array<f32>;
// Half floats, packed as the tables are, over [-cross_radius, cross_radius]².
@group(0) @binding(2) var cross_terms: texture_2d_array<f32>;
// 32-bit floats: power over |w'| / 2 evenly from 0 to 1, row by row.
@group(0) @binding(3) var lobe: texture_2d<f32>;
// Bilinear, clamped to the edges.
@group(0) @binding(4) var bilinear: sampler;

// How far r may exceed 1 by rounding.
const SHORTEST_SLACK: f32 = 1e-6;

// A front factor like that of the uniform, for another index n + ik.
fn front_of_index(index: vec2<f32>) -> Front {
    var material = params.material;
    if material != IDEAL {
        // Thinner than air, the roots of a dielectric are complex: the conductor's formulas.
        material = select(CONDUCTOR, DIELECTRIC, index.y == 0.0 && index.x >= 1.0);
    }
    return Front(material, params.factor, params.shadowing, index, complex_product(index, index));
}

fn front_factor() -> Front {
    let index = vec2<f32>(params.index_n, params.index_k);
    return Front(params.material, params.factor, params.shadowing, index, params.permittivity);
}

// The BRDF in 1/sr at a wavelength in nm, with the uniform's index; 0 for directions not above the surface, NO_ANSWER for
// wavelengths shorter than the tables'.
fn brdf_spectral(wi: vec3<f32>, wo: vec3<f32>, wavelength_nm: f32) -> f32 {
    return brdf_spectral_with(front_factor(), wi, wo, wavelength_nm);
}

// The same with a front factor of one's own: where one call of a shader asks for several wavelengths, each has its index.
fn brdf_spectral_with(front: Front, wi: vec3<f32>, wo: vec3<f32>, wavelength_nm: f32) -> f32 {
    if !(wi.z > 0.0 && wo.z > 0.0) {
        return 0.0;
    }
    let ratio = params.shortest_nm / wavelength_nm;
    if !(ratio > 0.0 && ratio <= 1.0 + SHORTEST_SLACK) {
        return NO_ANSWER;
    }
    let r = min(ratio, 1.0);
    let change = wave_vector_change(wi, wo);
    let q = r * change;
    let t = normalised_abs_w(q);
    let diffuse = diffuse_factor(front, wi, wo) * (expansion(0.5 * q.xy, t) + cross_value(q, t));
    let r2 = r * r;
    if params.lobe_count == 0u {
        return r2 * r2 * diffuse;
    }
    // A coherence that grows with the wavelength leaves the lobe what it is at the shortest.
    let grows = params.of_source == 1u;
    let lobe_nm = select(wavelength_nm, params.shortest_nm, grows);
    // With the vector factor, what would leave below the horizon comes back above it.
    var shape = lobe_shape(dot(change.xy, change.xy), lobe_nm);
    if front.factor == VECTOR {
        shape = shape + lobe_shape(image_radius2(wi, wo), lobe_nm);
    }
    return r2 * r2 * diffuse + select(r2, 1.0, grows) * coherent_factor(front, wi, wo) * power_at(abs(q.z)) * shape;
}

// Whether a value is an answer.
fn has_answer(value: f32) -> bool {
    return value != NO_ANSWER;
}

// The lobe's form at a squared distance in (u, v).
fn lobe_shape(radius2: f32, wavelength_nm: f32) -> f32 {
    let scale = 6.283185307 * params.lobe_sigma_nm / wavelength_nm;
    return exp(-scale * scale * radius2);
}

// Power of the lobe at |w'|, linear between texels.
fn power_at(abs_w: f32) -> f32 {
    let last = params.lobe_count - 1u;
    let at = clamp(0.5 * abs_w, 0.0, 1.0) * f32(last);
    let first = min(u32(at), last - 1u);
    return mix(power_texel(first), power_texel(first + 1u), at - f32(first));
}

fn power_texel(index: u32) -> f32 {
    let columns = textureDimensions(lobe).x;
    return textureLoad(lobe, vec2<i32>(i32(index % columns), i32(index / columns)), 0).r;
}

// The cross term over |w'|; 0 where it vanishes.
fn cross_value(q: vec3<f32>, t: f32) -> f32 {
    if params.cross_layers == 0u || max(abs(q.x), abs(q.y)) >= params.cross_radius {
        return 0.0;
    }
    let uv = texel_centred(q.xy / params.cross_radius, textureDimensions(cross_terms));
    var basis = first_four(2.0 * t - 1.0);
    var sum = 0.0;
    for (var layer = 0u; layer < params.cross_layers; layer = layer + 1u) {
        let texel = cross_texel(uv, layer);
        sum = sum + dot(basis * params.cross_scales[layer], texel);
        basis = next_four(basis, 2.0 * t - 1.0);
    }
    return sum / abs(q.z);
}

// Sum of T_n(2t - 1) table_n at a position in [-1, 1]².
fn expansion(at: vec2<f32>, t: f32) -> f32 {
    let uv = texel_centred(at, textureDimensions(tables));
    if params.look_up == SPLINES {
        return expansion_by_splines(spline_places(uv), t);
    }
    var basis = first_four(2.0 * t - 1.0);
    var sum = 0.0;
    for (var layer = 0u; layer < params.table_layers; layer = layer + 1u) {
        let texel = textureSampleLevel(tables, bilinear, uv, layer, 0.0);
        sum = sum + dot(basis * params.table_scales[layer], texel);
        basis = next_four(basis, 2.0 * t - 1.0);
    }
    return sum;
}

fn expansion_by_splines(places: SplinePlaces, t: f32) -> f32 {
    var basis = first_four(2.0 * t - 1.0);
    var sum = 0.0;
    for (var layer = 0u; layer < params.table_layers; layer = layer + 1u) {
        sum = sum + dot(basis * params.table_scales[layer], spline_texel(places, layer));
        basis = next_four(basis, 2.0 * t - 1.0);
    }
    return sum;
}

// T_0 to T_3 at x.
fn first_four(x: f32) -> vec4<f32> {
    let second = 2.0 * x * x - 1.0;
    return vec4<f32>(1.0, x, second, 2.0 * x * second - x);
}

// T_n+4 to T_n+7 at x from T_n to T_n+3.
fn next_four(basis: vec4<f32>, x: f32) -> vec4<f32> {
    let a = 2.0 * x * basis.w - basis.z;
    let b = 2.0 * x * a - basis.w;
    let c = 2.0 * x * b - a;
    return vec4<f32>(a, b, c, 2.0 * x * c - b);
}
