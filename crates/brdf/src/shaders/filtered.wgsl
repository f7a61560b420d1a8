// Means over ellipses of (u, v), for lights with a size and pixels of curved surfaces: what look-ups of XYZ and of spectral tables
// have in common. No bindings; follows optics.wgsl.
//
// A footprint is a covariance (uu, uv, vv) around the (u, v) of the two directions; those of light and pixel add. It stands
// for the ellipse that has it when evenly filled.

// Places along a chord's direction across the ellipse.
const CHORDS: u32 = 14u;
const PI: f32 = 3.14159265;

// Footprint of a light that is even over a disc of this angular radius around wi.
fn footprint_of_light(wi: vec3<f32>, angular_radius: f32) -> vec3<f32> {
    let sine = sin(angular_radius);
    return 0.25 * sine * sine * vec3<f32>(1.0 - wi.x * wi.x, -wi.x * wi.y, 1.0 - wi.y * wi.y);
}

// Footprint of a pixel over which the normal tilts by (a, b) along x and y in radians with the covariance (aa, ab, bb).
fn footprint_of_normals(wi: vec3<f32>, wo: vec3<f32>, normals: vec3<f32>) -> vec3<f32> {
    let w = wi.z + wo.z;
    return w * w * normals;
}

// A footprint by its axes.
struct Ellipse {
    // Unit vector of the longer axis in (u, v).
    axis: vec2<f32>,
    // Variances along and across it.
    variances: vec2<f32>,
}

fn ellipse_of(footprint: vec3<f32>) -> Ellipse {
    let middle = 0.5 * (footprint.x + footprint.z);
    let difference = 0.5 * (footprint.x - footprint.z);
    let spread = length(vec2<f32>(difference, footprint.y));
    var axis = vec2<f32>(1.0, 0.0);
    if spread > 0.0 {
        // Half of the angle of (difference, uv), from the larger of the two components.
        let larger = sqrt(0.5 + 0.5 * abs(difference) / spread);
        let smaller = 0.5 * abs(footprint.y) / (spread * larger);
        let turn = select(-1.0, 1.0, footprint.y >= 0.0);
        axis = select(vec2<f32>(smaller, turn * larger), vec2<f32>(larger, turn * smaller), difference >= 0.0);
    }
    return Ellipse(axis, vec2<f32>(middle + spread, max(middle - spread, 0.0)));
}

// Seven places that stand for an ellipse: its centre, and a ring of six with `along` and `across` for half axes. On a
// level of a mip chain, whose texels are means already, they lie closer, so that second and fourth moments are the ellipse's.
struct Taps {
    level: f32,
    // Weight of the centre; the rest is the ring's.
    centre: f32,
    // In (u, v).
    along: vec2<f32>,
    across: vec2<f32>,
}

// For an image with so many texels to a unit of (u, v), of which the levels up to `level_max` may be read.
fn taps_of(ellipse: Ellipse, texels_per_unit: f32, level_max: f32) -> Taps {
    let variances = ellipse.variances * texels_per_unit * texels_per_unit;
    // A level's means of 2^level texels, and interpolation between them, add (4^level - 1) / 4 to the variance.
    let wanted = max(BLUR_SHARE * variances.y, BLUR_SHARE_MAJOR * variances.x);
    let level = clamp(floor(0.5 * log2(1.0 + 4.0 * wanted)), 0.0, level_max);
    let blur = 0.25 * (exp2(2.0 * level) - 1.0);
    let share = min(blur / max(sqrt(variances.x * variances.y), 1e-20), BLUR_SHARE);
    let rest = 1.0 - share;
    let ring = min(4.0 * rest * rest / (16.0 / 3.0 - 16.0 * share * rest - 8.0 * share * share), 1.0);
    let axes = sqrt(2.0 * max(variances - blur, vec2<f32>(0.0, 0.0)) / ring) / texels_per_unit;
    return Taps(level, 1.0 - ring, axes.x * ellipse.axis, axes.y * vec2<f32>(-ellipse.axis.y, ellipse.axis.x));
}

// Linear fetches of coefficients blur by 1/6 of a squared texel, the spline itself by 1/3: an ellipse that is so much larger makes the
// difference up.
fn for_coefficients(ellipse: Ellipse, texels_per_unit: f32) -> Ellipse {
    return Ellipse(ellipse.axis, ellipse.variances + 1.0 / (6.0 * texels_per_unit * texels_per_unit));
}

// Larger variance of an ellipse in squared texels up to which it is a point for a spline.
const SPLINE_POINT_MAX: f32 = 0.003;

// Share of an ellipse's variance that a level's blur may take: with it a ring alone has the fourth moment of an even disc.
const BLUR_SHARE: f32 = 0.1835;
// Likewise along the longer axis of a narrow ellipse.
const BLUR_SHARE_MAJOR: f32 = 0.05;
const RING: u32 = 6u;

// The next of the ring's places, seen from the centre of a unit circle: a sixth of a turn on.
fn next_of_ring(at: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(0.5 * at.x - 0.8660254 * at.y, 0.8660254 * at.x + 0.5 * at.y);
}

// The coarsest level of an image of this size, restricted to those that have at least four texels a side.
fn coarsest_level(size: vec2<u32>) -> f32 {
    return max(floor(log2(0.25 * f32(min(size.x, size.y)))), 0.0);
}

// Where a lobe lies, seen from the centre of an ellipse, in the frame of its axes.
struct LobePlace {
    centre: vec2<f32>,
    semi_axes: vec2<f32>,
}

fn direct_lobe(at: vec2<f32>, ellipse: Ellipse) -> LobePlace {
    let axis = ellipse.axis;
    return LobePlace(vec2<f32>(dot(at, axis), at.y * axis.x - at.x * axis.y), 2.0 * sqrt(ellipse.variances));
}

// The same for the lobe's mirror image in the horizon, in the plane of the two directions' mirror.
fn image_lobe(wi: vec3<f32>, wo: vec3<f32>, footprint: vec3<f32>) -> LobePlace {
    let difference = wo.xy - wi.xy;
    let apart = length(difference);
    var e = vec2<f32>(1.0, 0.0);
    if apart > 0.0 {
        e = difference / apart;
    }
    let sum = wi.xy + wo.xy;
    let along = sum.y * e.x - sum.x * e.y;
    let across = sqrt(max(image_radius2(wi, wo) - along * along, 0.0));
    let variances = vec2<f32>(
        e.x * e.x * footprint.x + 2.0 * e.x * e.y * footprint.y + e.y * e.y * footprint.z,
        e.y * e.y * footprint.x - 2.0 * e.x * e.y * footprint.y + e.x * e.x * footprint.z,
    );
    return LobePlace(vec2<f32>(across, along), 2.0 * sqrt(max(variances, vec2<f32>(0.0, 0.0))));
}

// Whether the ellipse's bounding rectangle comes within a distance of the lobe's centre.
fn reaches(place: LobePlace, reach: f32) -> bool {
    return length(max(abs(place.centre) - place.semi_axes, vec2<f32>(0.0, 0.0))) < reach;
}

// The part of [-limit, limit] where |centre + semi_axis x| < reach; of no length where there is none.
fn within(centre: f32, semi_axis: f32, reach: f32, limit: f32) -> vec2<f32> {
    if semi_axis > 0.0 {
        let ends = vec2<f32>(max((-reach - centre) / semi_axis, -limit), min((reach - centre) / semi_axis, limit));
        return vec2<f32>(ends.x, max(ends.x, ends.y));
    }
    return select(vec2<f32>(0.0, 0.0), vec2<f32>(-limit, limit), abs(centre) < reach);
}

// Widths of a Gaussian beyond which it counts as zero: 1e-9.
const GAUSSIAN_REACH: f32 = 4.55;

// Mean over the ellipse of exp(-(distance / width)²): along chords in closed form, between them by Gauss's rule for functions
// that vanish at the ends like a chord's length.
fn gaussian_mean(place: LobePlace, width: f32) -> f32 {
    let reach = GAUSSIAN_REACH * width;
    let rows = within(place.centre.y, place.semi_axes.y, reach, 1.0);
    let middle = 0.5 * (rows.x + rows.y);
    let half_length = 0.5 * (rows.y - rows.x);
    if half_length <= 0.0 {
        return 0.0;
    }
    let step = PI / f32(CHORDS + 1u);
    var sum = 0.0;
    for (var k = 0u; k < CHORDS; k = k + 1u) {
        let angle = f32(k + 1u) * step;
        let eta = middle - half_length * cos(angle);
        let y = place.centre.y + place.semi_axes.y * eta;
        let chord = sqrt(max(1.0 - eta * eta, 0.0));
        let ends = within(place.centre.x, place.semi_axes.x, sqrt(max(reach * reach - y * y, 0.0)), chord);
        let lateral = (place.centre.x + place.semi_axes.x * ends) / width;
        let off = y / width;
        sum = sum + sin(angle) * (ends.y - ends.x) * exp(-off * off) * gaussian_between(lateral.x, lateral.y);
    }
    return sum * half_length * step / PI;
}

// Mean of exp(-x²) between two places.
fn gaussian_between(low: f32, high: f32) -> f32 {
    let apart = high - low;
    if apart < 0.05 {
        let middle = 0.5 * (low + high);
        let square = middle * middle;
        return exp(-square) * (1.0 + apart * apart * (2.0 * square - 1.0) / 12.0);
    }
    var area = 0.0;
    if low >= 0.0 {
        area = erfc(low) - erfc(high);
    } else if high <= 0.0 {
        area = erfc(-high) - erfc(-low);
    } else {
        area = 2.0 - erfc(-low) - erfc(high);
    }
    return 0.8862269 * area / apart;
}

// The complementary error function of what is not negative, to 1.2e-7 of itself (Press et al., "Numerical Recipes", 6.2).
fn erfc(x: f32) -> f32 {
    let t = 1.0 / (1.0 + 0.5 * x);
    var p = 0.17087277;
    p = -0.82215223 + t * p;
    p = 1.48851587 + t * p;
    p = -1.13520398 + t * p;
    p = 0.27886807 + t * p;
    p = -0.18628806 + t * p;
    p = 0.09678418 + t * p;
    p = 0.37409196 + t * p;
    p = 1.00002368 + t * p;
    return t * exp(-x * x - 1.26551223 + t * p);
}
