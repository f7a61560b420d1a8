// Look-ups closer than linear ones, where `look_up` of the uniform asks for them: tables by cubic B-splines, whose coefficients the
// finest level of `tables` then holds, and what belongs to the lobe by cubics through four texels a side. Follows the source that
// declares the bindings.

// look_up
const LINEAR: u32 = 0u;
const SPLINES: u32 = 1u;

// Two places along each axis, in normalised coordinates, whose linear fetches stand for the four coefficients that a spline takes,
// and what the first ones count.
struct SplinePlaces {
    first: vec2<f32>,
    second: vec2<f32>,
    share: vec2<f32>,
}

fn spline_places(uv: vec2<f32>) -> SplinePlaces {
    let size = vec2<f32>(textureDimensions(tables));
    let texel = uv * size - 0.5;
    let whole = floor(texel);
    let f = texel - whole;
    let g = 1.0 - f;
    let before = g * g * g / 6.0;
    let last = f * f * f / 6.0;
    let nearest = 2.0 / 3.0 - f * f + 3.0 * last;
    let share = before + nearest;
    let first = whole - 1.0 + nearest / share;
    let second = whole + 1.0 + last / (1.0 - share);
    return SplinePlaces((first + 0.5) / size, (second + 0.5) / size, share);
}

// A layer's spline there.
fn spline_texel(places: SplinePlaces, layer: u32) -> vec4<f32> {
    let a = textureSampleLevel(tables, bilinear, places.first, layer, 0.0);
    let b = textureSampleLevel(tables, bilinear, vec2<f32>(places.second.x, places.first.y), layer, 0.0);
    let c = textureSampleLevel(tables, bilinear, vec2<f32>(places.first.x, places.second.y), layer, 0.0);
    let d = textureSampleLevel(tables, bilinear, places.second, layer, 0.0);
    return mix(mix(d, c, places.share.x), mix(b, a, places.share.x), places.share.y);
}

// What Lagrange's cubic takes of four texels, x behind the first.
fn lagrange_weights(x: f32) -> vec4<f32> {
    let a = x - 1.0;
    let b = x - 2.0;
    let c = x - 3.0;
    return vec4<f32>(-a * b * c / 6.0, 0.5 * x * b * c, -0.5 * x * a * c, x * a * b / 6.0);
}

// A layer of the cross term at normalised coordinates.
fn cross_texel(uv: vec2<f32>, layer: u32) -> vec4<f32> {
    let size = vec2<i32>(textureDimensions(cross_terms));
    if params.look_up == LINEAR || min(size.x, size.y) < 4 {
        return textureSampleLevel(cross_terms, bilinear, uv, layer, 0.0);
    }
    let at = clamp(uv * vec2<f32>(size) - 0.5, vec2<f32>(0.0, 0.0), vec2<f32>(size - 1));
    let first = clamp(vec2<i32>(at) - 1, vec2<i32>(0, 0), size - 4);
    let across = lagrange_weights(at.x - f32(first.x));
    let down = lagrange_weights(at.y - f32(first.y));
    var sum = vec4<f32>(0.0, 0.0, 0.0, 0.0);
    for (var k = 0; k < 16; k = k + 1) {
        let texel = textureLoad(cross_terms, first + vec2<i32>(k % 4, k / 4), i32(layer), 0);
        sum = sum + across[k % 4] * down[k / 4] * texel;
    }
    return sum;
}
