// What stands in front of tables' values, and the geometry of look-ups: the same functions under the same names as in Rust.
// No bindings: the sources of tables of XYZ and of spectral tables follow it.
//
// Local frame: x along scan columns, y up the image, z the outward normal. `wi` points to the light, `wo`
// to the viewer, both unit vectors.

// material
const IDEAL: u32 = 0u;
const DIELECTRIC: u32 = 1u;
const CONDUCTOR: u32 = 2u;
// factor
const SCALAR: u32 = 0u;
const VECTOR: u32 = 1u;

// What the front factor depends on besides the two directions.
struct Front {
    // IDEAL, DIELECTRIC or CONDUCTOR.
    material: u32,
    // SCALAR (R G) or VECTOR (first-order vector perturbation).
    factor: u32,
    // 1 where the V-cavity factor is applied.
    shadowing: u32,
    // Refractive index, n and k of n + ik.
    index: vec2<f32>,
    // (n + ik)², real and imaginary part.
    permittivity: vec2<f32>,
}

// What stands for a value where the tables have none.
const NO_ANSWER: f32 = -1.0;

fn wave_vector_change(wi: vec3<f32>, wo: vec3<f32>) -> vec3<f32> {
    return -wi - wo;
}

fn geometry_factor(wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    let one_plus = 1.0 + dot(wi, wo);
    // Divided one by one: the product of two grazing cosines could underflow.
    return (one_plus / wi.z) * (one_plus / wo.z);
}

fn v_cavity_shadowing(wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    let sum = wi + wo;
    let m = sum / sqrt(dot(sum, sum));
    let wo_m = dot(wo, m);
    if !(wo_m > 0.0) {
        return 0.0;
    }
    let scale = 2.0 * m.z / wo_m;
    return clamp(min(scale * wo.z, scale * wi.z), 0.0, 1.0);
}

fn complex_product(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

fn complex_quotient(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return complex_product(a, vec2<f32>(b.x, -b.y)) / dot(b, b);
}

// Principal square root. The smaller part follows from the larger one, without cancellation.
fn complex_root(a: vec2<f32>) -> vec2<f32> {
    let larger = sqrt(0.5 * (sqrt(dot(a, a)) + abs(a.x)));
    if larger == 0.0 {
        return vec2<f32>(0.0, 0.0);
    }
    let smaller = 0.5 * abs(a.y) / larger;
    let turn = select(-1.0, 1.0, a.y >= 0.0);
    if a.x >= 0.0 {
        return vec2<f32>(larger, turn * smaller);
    }
    return vec2<f32>(smaller, turn * larger);
}

fn reflectance(front: Front, cos_theta_d: f32) -> f32 {
    if front.material == IDEAL {
        return 1.0;
    }
    let index = front.index;
    let cos_i = clamp(cos_theta_d, 0.0, 1.0);
    let sin2_t = complex_quotient(vec2<f32>(1.0 - cos_i * cos_i, 0.0), complex_product(index, index));
    let cos_t = complex_root(vec2<f32>(1.0, 0.0) - sin2_t);
    let index_cos_t = complex_product(index, cos_t);
    let along = vec2<f32>(cos_i, 0.0);
    let s = complex_quotient(along - index_cos_t, along + index_cos_t);
    let p = complex_quotient(index * cos_i - cos_t, index * cos_i + cos_t);
    return 0.5 * (dot(s, s) + dot(p, p));
}

fn cos_half_angle(wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    return sqrt(max(0.5 + 0.5 * dot(wi, wo), 0.0));
}

fn shadowing(front: Front, wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    if front.shadowing == 0u {
        return 1.0;
    }
    return v_cavity_shadowing(wi, wo);
}

// The factor of tables and cross term, for directions above the surface.
fn diffuse_factor(front: Front, wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    if front.factor == VECTOR && front.material != IDEAL {
        return 2.0 * wi.z * wo.z * polarised_sum(front, wi, wo) * shadowing(front, wi, wo);
    }
    return reflectance(front, cos_half_angle(wi, wo)) * geometry_factor(wi, wo) * shadowing(front, wi, wo);
}

// The factor of the coherent lobe, for directions above the surface.
fn coherent_factor(front: Front, wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    let mirror = reflectance(front, cos_half_angle(wi, wo)) * shadowing(front, wi, wo);
    if front.factor == VECTOR {
        return mirror;
    }
    let w = wi.z + wo.z;
    return mirror * geometry_factor(wi, wo) / w / w;
}

// Q_ss + Q_sp + Q_ps + Q_pp of first-order vector perturbation (Rayleigh-Rice). The azimuth is that of the scattered light
// against the mirror's side; at normal incidence it is arbitrary, and the sum does not depend on it.
fn polarised_sum(front: Front, wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    let sin2_i = dot(wi.xy, wi.xy);
    let sin2_o = dot(wo.xy, wo.xy);
    let sines = sqrt(sin2_i) * sqrt(sin2_o);
    var cos_phi = 1.0;
    if sines > 1e-12 {
        cos_phi = clamp(-dot(wi.xy, wo.xy) / sines, -1.0, 1.0);
    }
    let cos2_phi = cos_phi * cos_phi;
    let eps = front.permittivity;
    if front.material == DIELECTRIC {
        // Everything is real.
        let a = sqrt(max(eps.x - sin2_i, 0.0));
        let b = sqrt(max(eps.x - sin2_o, 0.0));
        let s_i = wi.z + a;
        let s_o = wo.z + b;
        let p_i = eps.x * wi.z + a;
        let p_o = eps.x * wo.z + b;
        let ss = 1.0 / (s_i * s_o);
        let sp = b / (s_i * p_o);
        let ps = a / (p_i * s_o);
        let pp = (a * b * cos_phi - eps.x * sines) / (p_i * p_o);
        let contrast = (eps.x - 1.0) * (eps.x - 1.0);
        return contrast * (cos2_phi * ss * ss + (1.0 - cos2_phi) * (sp * sp + ps * ps) + pp * pp);
    }
    let a = complex_root(eps - vec2<f32>(sin2_i, 0.0));
    let b = complex_root(eps - vec2<f32>(sin2_o, 0.0));
    let s_i = a + vec2<f32>(wi.z, 0.0);
    let s_o = b + vec2<f32>(wo.z, 0.0);
    let p_i = eps * wi.z + a;
    let p_o = eps * wo.z + b;
    let ss = 1.0 / (dot(s_i, s_i) * dot(s_o, s_o));
    let sp = dot(b, b) / (dot(s_i, s_i) * dot(p_o, p_o));
    let ps = dot(a, a) / (dot(p_i, p_i) * dot(s_o, s_o));
    let across = complex_product(a, b) * cos_phi - eps * sines;
    let pp = dot(across, across) / (dot(p_i, p_i) * dot(p_o, p_o));
    let less = eps - vec2<f32>(1.0, 0.0);
    return dot(less, less) * (cos2_phi * ss + (1.0 - cos2_phi) * (sp + ps) + pp);
}

// Squared lateral distance of the lobe's image in the horizon.
fn image_radius2(wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    let lateral = wi.xy + wo.xy;
    let to_horizon_i = wi.z * wi.z / (1.0 + length(wi.xy));
    let to_horizon_o = wo.z * wo.z / (1.0 + length(wo.xy));
    return dot(lateral, lateral) + 4.0 * to_horizon_i * to_horizon_o;
}

fn max_abs_w(rho: f32) -> f32 {
    return sqrt(max(4.0 - rho * rho, 0.0));
}

fn normalised_abs_w(q: vec3<f32>) -> f32 {
    let reach = max_abs_w(length(q.xy));
    if reach == 0.0 {
        return 0.0;
    }
    return min(abs(q.z) / reach, 1.0);
}

// Normalised texture coordinates of a position in [-1, 1]², y up: its ends are the outer texels' centres.
fn texel_centred(at: vec2<f32>, size: vec2<u32>) -> vec2<f32> {
    let across = vec2<f32>(size);
    let texel = vec2<f32>(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y) * (across - 1.0);
    return (texel + 0.5) / across;
}
