// Directions drawn in proportion to the BRDF times the cosine: a mixture of the lobe above the horizon, of the tables, and of an even
// remainder that bounds the weights; the same functions under the same names as in Rust, but for what they are called there by module.
// Follows tables.wgsl and tables_filtered.wgsl; sampling_tables.wgsl follows it.
//
// No trigonometric function of the hardware is called: their errors may reach 5e-4, and densities would be those of the machine.

// Numbers by row: 0 the grid (u of its left edge, v of its upper edge, a cell's side, rows, columns, rows of a band), 1 the lobe's front
// factor at cosines of k / 64, 2 to 9 the nodes (shares of the even part, of the lobe and of the tables, what 32 strips reflect), from 10 on
// each node's sums along rows of cells, then along bands of rows, up to every edge.
@group(0) @binding(6) var sampling: texture_2d<f32>;

// Polar angles of the viewer for which there are numbers.
const NODES: i32 = 8;
const FIRST_NODE: i32 = 2;
const FIRST_SUM: i32 = 10;
// Strips across the lobe, and cells along a strip.
const STRIPS: i32 = 32;
const CELLS: i32 = 32;
// What every cell gets at least, as a share of the mean.
const CELL_FLOOR: f32 = 0.02;
const HALF_PI: f32 = 1.57079633;

fn number(column: i32, row: i32) -> f32 {
    return textureLoad(sampling, vec2<i32>(column, row), 0).x;
}

fn node_of(cos_o: f32) -> i32 {
    return min(i32(f32(NODES) * sqrt(cos_o)), NODES - 1);
}

// Angle of (z, x) from the z axis, for z that is not negative: to 2e-7 of itself (Moshier, Cephes, atanf).
fn angle_from_z(x: f32, z: f32) -> f32 {
    let longer = max(abs(x), z);
    if !(longer > 0.0) {
        return 0.0;
    }
    var tangent = min(abs(x), z) / longer;
    var angle = 0.0;
    if tangent > 0.41421356 {
        tangent = (tangent - 1.0) / (tangent + 1.0);
        angle = 0.5 * HALF_PI;
    }
    let s = tangent * tangent;
    let series = ((0.0805374450 * s - 0.138776856) * s + 0.199777106) * s - 0.333329491;
    angle = angle + (series * s * tangent + tangent);
    if abs(x) > z {
        angle = HALF_PI - angle;
    }
    return select(angle, -angle, x < 0.0);
}

// Sine and cosine of an angle of at most a quarter turn, to 1e-7 (Moshier, Cephes, sinf).
fn sine_and_cosine(angle: f32) -> vec2<f32> {
    let far = abs(angle) > 0.5 * HALF_PI;
    let x = select(abs(angle), HALF_PI - abs(angle), far);
    let s = x * x;
    let sine = ((-1.95152959e-4 * s + 8.33216087e-3) * s - 0.166666546) * s * x + x;
    let cosine = ((2.44331571e-5 * s - 1.38873163e-3) * s + 0.0416666457) * s * s - 0.5 * s + 1.0;
    let both = select(vec2<f32>(sine, cosine), vec2<f32>(cosine, sine), far);
    return vec2<f32>(select(both.x, -both.x, angle < 0.0), both.y);
}

// What each of up to 32 things counts.
struct Masses {
    each: array<f32, 32>,
}

// One of several things, what is left of the number that chose it, and the probability with which it does.
struct Choice {
    index: i32,
    rest: f32,
    probability: f32,
}

// One of the first `count` with probabilities in proportion to masses, all alike where there is none.
fn choose(masses: Masses, count: i32, u: f32) -> Choice {
    var left = masses;
    var total = 0.0;
    for (var k = 0; k < count; k = k + 1) {
        total = total + left.each[k];
    }
    if !(total > 0.0) {
        let at = u * f32(count);
        let index = min(i32(at), count - 1);
        return Choice(index, min(at - f32(index), 1.0), 1.0 / f32(count));
    }
    let wanted = u * total;
    var below = 0.0;
    var chosen = Choice(0, 0.0, 0.0);
    for (var k = 0; k < count; k = k + 1) {
        let here = left.each[k];
        if here > 0.0 {
            chosen = Choice(k, clamp((wanted - below) / here, 0.0, 1.0), here / total);
            if wanted < below + here {
                break;
            }
        }
        below = below + here;
    }
    return chosen;
}

fn probability_of(masses: Masses, count: i32, index: i32) -> f32 {
    var all = masses;
    var total = 0.0;
    for (var k = 0; k < count; k = k + 1) {
        total = total + all.each[k];
    }
    if total > 0.0 {
        return all.each[index] / total;
    }
    return 1.0 / f32(count);
}

// Unit vector along the viewer's projection (x where it has none), and the projection's length.
fn projection(wo: vec3<f32>) -> vec3<f32> {
    let sin_o = length(wo.xy);
    if sin_o < 1e-9 {
        return vec3<f32>(1.0, 0.0, 0.0);
    }
    return vec3<f32>(wo.xy / sin_o, sin_o);
}

// The part of a strip across the lobe that is above the horizon: angles from `first` on in cells of `step`, and what they reflect. With x along
// the viewer's projection a direction is (h sin, -y, h cos), h = sqrt(1 - y²). No length where nothing is above.
struct Strip {
    first: f32,
    step: f32,
    cells: Masses,
}

fn strip_width() -> f32 {
    return 2.0 * params.radius_max / f32(STRIPS);
}

fn strip_at(sin_o: f32, cos_o: f32, y: f32) -> Strip {
    let h = sqrt(max(1.0 - y * y, 0.0));
    let half_length = sqrt(max(params.radius_max * params.radius_max - y * y, 0.0));
    let low = clamp(-sin_o - half_length, -h, h);
    let high = clamp(-sin_o + half_length, -h, h);
    var strip: Strip;
    strip.first = angle_from_z(low, sqrt(max((h - low) * (h + low), 0.0)));
    let last = angle_from_z(high, sqrt(max((h - high) * (h + high), 0.0)));
    strip.step = (last - strip.first) / f32(CELLS);
    if !(strip.step > 1e-7) {
        strip.step = 0.0;
        return strip;
    }
    var before = lobe_shape(sin_o, cos_o, y, h * sine_and_cosine(strip.first));
    var total = 0.0;
    for (var k = 0; k < CELLS; k = k + 1) {
        let next = lobe_shape(sin_o, cos_o, y, h * sine_and_cosine(strip.first + f32(k + 1) * strip.step));
        strip.cells.each[k] = max(before, next);
        total = total + strip.cells.each[k];
        before = next;
    }
    let least = CELL_FLOOR * total / f32(CELLS);
    for (var k = 0; k < CELLS; k = k + 1) {
        strip.cells.each[k] = strip.cells.each[k] + least;
    }
    return strip;
}

// The BRDF of the lobe alone times the light's cosine, channels added, without shadowing; the direction's x and z in the viewer's frame.
fn lobe_shape(sin_o: f32, cos_o: f32, y: f32, at: vec2<f32>) -> f32 {
    let light = vec3<f32>(at.x, -y, max(at.y, 0.0));
    let view = vec3<f32>(sin_o, 0.0, cos_o);
    let lateral = at.x + sin_o;
    let radius2 = lateral * lateral + y * y;
    let w = light.z + cos_o;
    let q2 = radius2 + w * w;
    var shape = lobe_sum_at(sqrt(radius2), w);
    if params.factor == VECTOR {
        shape = (shape + lobe_sum_at(sqrt(image_radius2(light, view)), w)) * light.z;
    } else {
        shape = shape * q2 * q2 / (4.0 * cos_o * w * w);
    }
    let place = min(0.5 * sqrt(q2), 1.0) * 64.0;
    let index = min(i32(place), 63);
    return mix(number(index, 1), number(index + 1, 1), place - f32(index)) * shape;
}

// Channels of the coherent part added, by linear look-ups: 0 from radius_max on.
fn lobe_sum_at(radius: f32, w: f32) -> f32 {
    if radius >= params.radius_max {
        return 0.0;
    }
    let last = vec2<i32>(textureDimensions(lobe)) - 1;
    let t = min(w / max_abs_w(radius), 1.0);
    let place = vec2<f32>(radius / params.radius_max, t) * vec2<f32>(last);
    let first = min(vec2<i32>(place), last - 1);
    let share = place - vec2<f32>(first);
    let upper = mix(lobe_sum(first), lobe_sum(first + vec2<i32>(1, 0)), share.x);
    let lower = mix(lobe_sum(first + vec2<i32>(0, 1)), lobe_sum(first + vec2<i32>(1, 1)), share.x);
    return mix(upper, lower, share.y);
}

fn lobe_sum(at: vec2<i32>) -> f32 {
    let xyz = textureLoad(lobe, at, 0).rgb;
    return max(xyz.x + xyz.y + xyz.z, 0.0);
}

fn strip_masses(node: i32) -> Masses {
    var masses: Masses;
    for (var k = 0; k < STRIPS; k = k + 1) {
        masses.each[k] = number(3 + k, FIRST_NODE + node);
    }
    return masses;
}

// A direction drawn from the lobe; 0 where there is none.
fn sample_lobe(node: i32, wo: vec3<f32>, u: vec2<f32>) -> vec3<f32> {
    let along = projection(wo);
    let chosen = choose(strip_masses(node), STRIPS, u.x);
    let y = -params.radius_max + (f32(chosen.index) + chosen.rest) * strip_width();
    let strip = strip_at(along.z, wo.z, y);
    if strip.step == 0.0 {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    let cell = choose(strip.cells, CELLS, u.y);
    let place = sine_and_cosine(strip.first + (f32(cell.index) + cell.rest) * strip.step);
    let h = sqrt(max(1.0 - y * y, 0.0));
    let x = h * place.x;
    return vec3<f32>(x * along.x + y * along.y, x * along.y - y * along.x, h * place.y);
}

// Density of sample_lobe in 1/sr.
fn pdf_lobe(node: i32, wi: vec3<f32>, wo: vec3<f32>) -> f32 {
    let along = projection(wo);
    let y = wi.x * along.y - wi.y * along.x;
    let place = (y + params.radius_max) / strip_width();
    let x = dot(wi.xy, along.xy);
    if !(place >= 0.0 && place < f32(STRIPS)) || abs(x + along.z) > params.radius_max {
        return 0.0;
    }
    let strip = strip_at(along.z, wo.z, y);
    if strip.step == 0.0 {
        return 0.0;
    }
    let cell = (angle_from_z(x, wi.z) - strip.first) / strip.step;
    if !(cell >= 0.0 && cell < f32(CELLS)) {
        return 0.0;
    }
    let across = probability_of(strip_masses(node), STRIPS, i32(place)) / strip_width();
    return across * probability_of(strip.cells, CELLS, i32(cell)) / strip.step;
}
