// Filtered look-ups of spectral tables: the mean over a footprint in place of the value at a point, as `eval_filtered` in Rust.
// Follows spectral.wgsl and filtered.wgsl; reads the mip chains of `tables` and `cross_terms` at whole levels.

// The BRDF's mean over a footprint in 1/sr at a wavelength in nm; otherwise as `brdf_spectral`.
fn brdf_spectral_filtered(wi: vec3<f32>, wo: vec3<f32>, wavelength_nm: f32, footprint: vec3<f32>) -> f32 {
    return brdf_spectral_filtered_with(front_factor(), wi, wo, wavelength_nm, footprint);
}

// The same with a front factor of one's own: see `brdf_spectral_with`.
fn brdf_spectral_filtered_with(
    front: Front,
    wi: vec3<f32>,
    wo: vec3<f32>,
    wavelength_nm: f32,
    footprint: vec3<f32>,
) -> f32 {
    if !(wi.z > 0.0 && wo.z > 0.0) {
        return 0.0;
    }
    let ratio = params.shortest_nm / wavelength_nm;
    if !(ratio > 0.0 && ratio <= 1.0 + SHORTEST_SLACK) {
        return NO_ANSWER;
    }
    let r = min(ratio, 1.0);
    let r2 = r * r;
    let change = wave_vector_change(wi, wo);
    let q = r * change;
    let t = normalised_abs_w(q);
    let scaled = ellipse_of(r2 * footprint);
    let diffuse = diffuse_factor(front, wi, wo) * (expansion_mean(q, t, scaled) + cross_mean(q, t, scaled));
    if params.lobe_count == 0u {
        return r2 * r2 * diffuse;
    }
    // A coherence that grows with the wavelength leaves the lobe what it is at the shortest.
    let grows = params.of_source == 1u;
    let width = select(wavelength_nm, params.shortest_nm, grows) / (2.0 * PI * params.lobe_sigma_nm);
    var shape = lobe_mean(direct_lobe(change.xy, ellipse_of(footprint)), width);
    if front.factor == VECTOR {
        shape = shape + lobe_mean(image_lobe(wi, wo, footprint), width);
    }
    return r2 * r2 * diffuse + select(r2, 1.0, grows) * coherent_factor(front, wi, wo) * power_at(abs(q.z)) * shape;
}

fn lobe_mean(place: LobePlace, width: f32) -> f32 {
    if !reaches(place, GAUSSIAN_REACH * width) {
        return 0.0;
    }
    return gaussian_mean(place, width);
}

fn expansion_mean(q: vec3<f32>, t: f32, ellipse: Ellipse) -> f32 {
    let size = textureDimensions(tables);
    let texels_per_unit = 0.25 * (f32(size.x) - 1.0);
    var taps = taps_of(ellipse, texels_per_unit, coarsest_level(size));
    // Coarser levels hold values.
    if params.look_up == SPLINES && taps.level == 0.0 {
        if ellipse.variances.x * texels_per_unit * texels_per_unit < SPLINE_POINT_MAX {
            return expansion(0.5 * q.xy, t);
        }
        taps = taps_of(for_coefficients(ellipse, texels_per_unit), texels_per_unit, 0.0);
    }
    var sum = 0.0;
    var place = vec2<f32>(0.0, 0.0);
    var weight = taps.centre;
    for (var k = 0u; k <= RING; k = k + 1u) {
        var at = q.xy + place.x * taps.along + place.y * taps.across;
        // No two directions reach further.
        at = at * min(1.0, 2.0 / max(length(at), 1e-20));
        sum = sum + weight * expansion_on(0.5 * at, t, taps.level);
        weight = (1.0 - taps.centre) / f32(RING);
        if k == 0u {
            place = vec2<f32>(1.0, 0.0);
        } else {
            place = next_of_ring(place);
        }
    }
    return sum;
}

// The cross term's mean over |w'|; nothing lies beyond the patches.
fn cross_mean(q: vec3<f32>, t: f32, ellipse: Ellipse) -> f32 {
    var sum = 0.0;
    let reach = 2.0 * sqrt(ellipse.variances.x) + params.cross_radius;
    if params.cross_layers == 0u || max(abs(q.x), abs(q.y)) >= reach {
        return sum;
    }
    let size = textureDimensions(cross_terms);
    let taps = taps_of(ellipse, 0.5 * (f32(size.x) - 1.0) / params.cross_radius, coarsest_level(size));
    var place = vec2<f32>(0.0, 0.0);
    var weight = taps.centre;
    for (var k = 0u; k <= RING; k = k + 1u) {
        let at = (q.xy + place.x * taps.along + place.y * taps.across) / params.cross_radius;
        if max(abs(at.x), abs(at.y)) < 1.0 {
            sum = sum + weight * cross_on(at, t, taps.level);
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

// Sums of T_n(2t - 1) table_n, and of patches, at a position in [-1, 1]² on a level of the mip chain.
fn expansion_on(at: vec2<f32>, t: f32, level: f32) -> f32 {
    let uv = texel_centred(at, textureDimensions(tables));
    var basis = first_four(2.0 * t - 1.0);
    var sum = 0.0;
    for (var layer = 0u; layer < params.table_layers; layer = layer + 1u) {
        let texel = textureSampleLevel(tables, bilinear, uv, layer, level);
        sum = sum + dot(basis * params.table_scales[layer], texel);
        basis = next_four(basis, 2.0 * t - 1.0);
    }
    return sum;
}

fn cross_on(at: vec2<f32>, t: f32, level: f32) -> f32 {
    let uv = texel_centred(at, textureDimensions(cross_terms));
    var basis = first_four(2.0 * t - 1.0);
    var sum = 0.0;
    for (var layer = 0u; layer < params.cross_layers; layer = layer + 1u) {
        let texel = textureSampleLevel(cross_terms, bilinear, uv, layer, level);
        sum = sum + dot(basis * params.cross_scales[layer], texel);
        basis = next_four(basis, 2.0 * t - 1.0);
    }
    return sum;
}
