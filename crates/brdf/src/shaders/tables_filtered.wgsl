// Filtered look-ups of a table set: the mean over a footprint in place of the value at a point, as `eval_filtered` in Rust. The
// front factor and t are the centre's. Follows tables.wgsl and filtered.wgsl; reads the mip chains of `tables` and
// `cross_terms` at whole levels, as far as they are there.

// 32-bit floats: rows are t as those of `lobe`, columns the Gaussians whose sum is its profile, the widest first.
@group(0) @binding(5) var lobe_gaussians: texture_2d<f32>;

// Number of Gaussians.
const LOBE_GAUSSIANS: u32 = 8u;
// Width of the widest one, and that of the narrowest, as shares of the lobe's outer radius.
const LOBE_WIDEST: f32 = 0.2197802;
const LOBE_NARROWEST: f32 = 0.1098901;
// Semi-axis of an ellipse in narrowest widths up to which places of the disc stand for the lobe.
const LOBE_PLACES_MAX: f32 = 0.6;

// What the surface shows over a footprint in 1/sr: as `surface_xyz`, the pigment at the centre.
fn surface_xyz_filtered(wi: vec3<f32>, wo: vec3<f32>, footprint: vec3<f32>) -> vec3<f32> {
    let brdf = brdf_xyz_filtered(wi, wo, footprint);
    if params.pigment.w == 0.0 || !has_answer(brdf) {
        return brdf;
    }
    return brdf + pigment_xyz(wi, wo);
}

// XYZ of the BRDF's mean over a footprint in 1/sr; otherwise as `brdf_xyz`, without an answer where a part of the footprint has
// none.
fn brdf_xyz_filtered(wi: vec3<f32>, wo: vec3<f32>, footprint: vec3<f32>) -> vec3<f32> {
    if !(wi.z > 0.0 && wo.z > 0.0) {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    let q = wave_vector_change(wi, wo);
    let t = normalised_abs_w(q);
    let ellipse = ellipse_of(footprint);
    let of_tables = tables_mean(q, t, ellipse);
    if !has_answer(of_tables) {
        return of_tables;
    }
    let diffuse = diffuse_factor(front_factor(), wi, wo) * (of_tables + cross_mean(q, t, ellipse));
    var shape = lobe_mean(direct_lobe(q.xy, ellipse), q.z);
    if params.factor == VECTOR {
        // What would leave below the horizon comes back above it.
        shape = shape + lobe_mean(image_lobe(wi, wo, footprint), q.z);
    }
    return diffuse + coherent_factor(front_factor(), wi, wo) * shape;
}

fn tables_mean(q: vec3<f32>, t: f32, ellipse: Ellipse) -> vec3<f32> {
    var level_max = 0.0;
    if params.restricted == 0u {
        level_max = coarsest_level(textureDimensions(tables));
    }
    let texels_per_unit = 0.25 * params.grid_last;
    var taps = taps_of(ellipse, texels_per_unit, level_max);
    var basis = shifted_values(t);
    if params.basis == TAYLOR {
        basis = powers(abs(q.z));
    }
    // Coarser levels hold values.
    if params.look_up == SPLINES && taps.level == 0.0 {
        if ellipse.variances.x * texels_per_unit * texels_per_unit < SPLINE_POINT_MAX {
            return expansion(basis, 0.5 * q.xy);
        }
        taps = taps_of(for_coefficients(ellipse, texels_per_unit), texels_per_unit, 0.0);
    }
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    var place = vec2<f32>(0.0, 0.0);
    var weight = taps.centre;
    for (var k = 0u; k <= RING; k = k + 1u) {
        var at = q.xy + place.x * taps.along + place.y * taps.across;
        // No two directions reach further.
        at = at * min(1.0, 2.0 / max(length(at), 1e-20));
        if params.restricted != 0u {
            let s = share_of_range(0.5 * at, t);
            if s < 0.0 {
                return vec3<f32>(NO_ANSWER, NO_ANSWER, NO_ANSWER);
            }
            basis = shifted_values(s);
        }
        sum = sum + weight * expansion_on(basis, 0.5 * at, taps.level);
        weight = (1.0 - taps.centre) / f32(RING);
        if k == 0u {
            place = vec2<f32>(1.0, 0.0);
        } else {
            place = next_of_ring(place);
        }
    }
    return sum;
}

// The cross term's mean over |w|; nothing lies beyond the patches.
fn cross_mean(q: vec3<f32>, t: f32, ellipse: Ellipse) -> vec3<f32> {
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    let reach = 2.0 * sqrt(ellipse.variances.x) + params.radius_max;
    if params.cross_count == 0u || max(abs(q.x), abs(q.y)) >= reach {
        return sum;
    }
    let size = textureDimensions(cross_terms);
    let taps = taps_of(ellipse, 0.5 * (f32(size.x) - 1.0) / params.radius_max, coarsest_level(size));
    let basis = shifted_values(t);
    var place = vec2<f32>(0.0, 0.0);
    var weight = taps.centre;
    for (var k = 0u; k <= RING; k = k + 1u) {
        let at = (q.xy + place.x * taps.along + place.y * taps.across) / params.radius_max;
        if max(abs(at.x), abs(at.y)) < 1.0 {
            sum = sum + weight * cross_expansion_on(basis, at, taps.level);
        }
        weight = (1.0 - taps.centre) / f32(RING);
        if k == 0u {
            place = vec2<f32>(1.0, 0.0);
        } else {
            place = next_of_ring(place);
        }
    }
    return sum / abs(q.z);
}

// The coherent table's mean over an ellipse, at the centre's t: by places of the disc where it is small beside the lobe, beyond in
// closed form.
fn lobe_mean(place: LobePlace, w: f32) -> vec3<f32> {
    let zero = vec3<f32>(0.0, 0.0, 0.0);
    if !reaches(place, params.radius_max) {
        return zero;
    }
    let rows = textureDimensions(lobe).y;
    let row = normalised_abs_w(vec3<f32>(length(place.centre), 0.0, w)) * f32(rows - 1u);
    let longest = max(place.semi_axes.x, place.semi_axes.y);
    if longest > LOBE_PLACES_MAX * LOBE_NARROWEST * params.radius_max {
        return lobe_by_gaussians(place, row);
    }
    if longest == 0.0 {
        return profile_at(row, length(place.centre));
    }
    return lobe_by_places(place, row);
}

// The profile of a row at a radius: 0 from radius_max on.
fn profile_at(row: f32, radius: f32) -> vec3<f32> {
    if radius >= params.radius_max {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    return sample(vec2<f32>(row, radius / params.radius_max * f32(textureDimensions(lobe).x - 1u)));
}

// Three rings of eight places: Gauss's rule in the squared radius.
fn lobe_by_places(place: LobePlace, row: f32) -> vec3<f32> {
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    for (var k = 0u; k < 24u; k = k + 1u) {
        let ring = k / 8u;
        var radius = 0.70710678;
        var weight = 4.0 / 72.0;
        if ring != 1u {
            radius = select(0.94196514, 0.33571069, ring == 0u);
            weight = 2.5 / 72.0;
        }
        let angle = (f32(k % 8u) + 0.5 * f32(ring % 2u)) * 0.25 * PI;
        let at = place.centre + radius * vec2<f32>(cos(angle), sin(angle)) * place.semi_axes;
        sum = sum + weight * profile_at(row, length(at));
    }
    return sum;
}

fn lobe_by_gaussians(place: LobePlace, row: f32) -> vec3<f32> {
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    let last = i32(textureDimensions(lobe).y) - 1;
    let first = max(min(i32(row), last - 1), 0);
    let share = clamp(row - f32(first), 0.0, 1.0);
    for (var k = 0u; k < LOBE_GAUSSIANS; k = k + 1u) {
        let low = textureLoad(lobe_gaussians, vec2<i32>(i32(k), first), 0).rgb;
        let high = textureLoad(lobe_gaussians, vec2<i32>(i32(k), min(first + 1, last)), 0).rgb;
        let width = params.radius_max * LOBE_WIDEST * exp2(-f32(k) / f32(LOBE_GAUSSIANS - 1u));
        sum = sum + gaussian_mean(place, width) * mix(low, high, share);
    }
    // Signed factors may leave less than nothing in the dark.
    return max(sum, vec3<f32>(0.0, 0.0, 0.0));
}

// As `expansion` and `cross_expansion`, on a level of the mip chain.
fn expansion_on(basis: Recurrence, at: vec2<f32>, level: f32) -> vec3<f32> {
    let uv = table_place(at);
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    var now = basis.first;
    var next = basis.second;
    for (var n = 0u; n < params.table_count; n = n + 1u) {
        let texel = textureSampleLevel(tables, bilinear, uv, n, level).rgb;
        sum = sum + (now * params.table_scales[n / 4u][n % 4u]) * texel;
        let after = basis.forward * next - basis.back * now;
        now = next;
        next = after;
    }
    return sum;
}

fn cross_expansion_on(basis: Recurrence, at: vec2<f32>, level: f32) -> vec3<f32> {
    let uv = texel_centred(at, textureDimensions(cross_terms));
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    var now = basis.first;
    var next = basis.second;
    for (var n = 0u; n < params.cross_count; n = n + 1u) {
        let texel = textureSampleLevel(cross_terms, bilinear, uv, n, level).rgb;
        sum = sum + (now * params.cross_scales[n / 4u][n % 4u]) * texel;
        let after = basis.forward * next - basis.back * now;
        now = next;
        next = after;
    }
    return sum;
}
