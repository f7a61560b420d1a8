//! A snake: a coiled, tapering body built from rings around a centre line, covered with scales.
//!
//! Ground coordinates: X to the right, Y away from the viewer, Z up. The viewer looks down on the coil from
//! `ELEVATION_DEG` above the ground.

use std::f64::consts::{PI, TAU};
use std::sync::LazyLock;

use diffraction_brdf::direction::{Vec3, dot, normalise};

use super::bvh::Ray;
use super::camera::{self, Camera, Field, View};
use super::frame::{Frame, add_scaled, cross};
use super::hit::{Hit, LitHit};
use super::scales::{scale_at, slopes};
use super::tangents::{RawMesh, build};
use super::triangles::{TriangleMesh, first_hit, frame_along, is_open, surface};

/// Height of the viewer above the ground.
pub(crate) const ELEVATION_DEG: f64 = 52.0;
/// Thickest part of the body, as a radius; half the picture's side is about 1.
pub(crate) const BODY_RADIUS: f64 = 0.13;
/// Scales around the body, as on a sunbeam snake.
pub const COLUMNS: u32 = 15;
/// Length of a scale, tip to tip, in widths.
const SCALE_ASPECT: f64 = 1.5;
/// Rings of vertices along the body, and vertices around it.
const RINGS: usize = 1400;
const SIDES: usize = 60;

/// The body, and how scales lie on it.
#[derive(Debug)]
pub struct Snake {
    mesh: TriangleMesh,
    view: View,
}

/// The snake; it is always the same one.
pub fn snake() -> &'static Snake {
    static SNAKE: LazyLock<Snake> =
        LazyLock::new(|| Snake { mesh: body(), view: camera::view(&CAMERA).expect("the camera looks at the coil") });
    &SNAKE
}

const CAMERA: Camera =
    Camera { position: [0.02, 0.08, 6.0], target: [0.02, 0.08, 0.0], up: [0.0, 1.0, 0.0], field: Field::FovDeg(17.4) };

/// Where the camera ray through picture point `(x, y)` meets a scale. The structure's x axis runs along the body from
/// head to tail, in the plane of the scale.
pub(crate) fn hit(snake: &Snake, xy: [f64; 2]) -> Option<LitHit> {
    let ray = camera::ray(&snake.view, xy);
    let point = surface(&snake.mesh, &first_hit(&snake.mesh, &ray)?);
    let [along, around] = point.uv;
    let [rise_along, rise_around] = slopes(&scale_at(along, around, COLUMNS), COLUMNS)?;
    let Frame { tangent, bitangent, normal } = point.frame;
    let normal = add_scaled(add_scaled(normal, tangent, -rise_along), bitangent, -rise_around);
    let frame = frame_along(normalise(normal), tangent, tangent, false);
    let to_viewer = ray.direction.map(|c| -c);
    Some(LitHit { hit: Hit { frame, to_viewer }, lifted: point.lifted })
}

/// Whether no other part of the body stands between a point and a light.
pub(crate) fn is_lit(snake: &Snake, from: Vec3, direction: Vec3) -> bool {
    is_open(&snake.mesh, &Ray { origin: from, direction })
}

/// A point of the centre line.
#[derive(Debug, Clone, Copy)]
struct Ring {
    centre: Vec3,
    /// Unit vector towards the tail.
    along: Vec3,
    radius: f64,
    /// Flattening: half height over half width.
    height: f64,
    /// Rings of scales since the head.
    scales: f64,
}

/// Points that pull the centre line, tail to head, in ground coordinates.
fn controls() -> Vec<Vec3> {
    let mut points = Vec::new();
    let steps = 46;
    for step in 0..=steps {
        let turns = 2.3 * step as f64 / steps as f64;
        let angle = TAU * turns - 2.2;
        // Turns lie beside and upon each other: `0.215² + 0.17²` is just beyond the square of twice the radius.
        let radius = 0.83 - 0.215 * turns;
        let height = BODY_RADIUS + 0.17 * (turns - 0.55).max(0.0);
        points.push([radius * angle.cos(), 0.95 * radius * angle.sin(), height]);
    }
    let top = points[points.len() - 1][2];
    // The neck turns inwards over the coil, and the head rests across its middle.
    points.extend([
        [0.30, 0.18, top + 0.08],
        [0.17, 0.30, top + 0.15],
        [-0.02, 0.29, top + 0.18],
        [-0.18, 0.19, top + 0.17],
        [-0.30, 0.06, top + 0.14],
    ]);
    points
}

/// Uniform cubic B-spline through the controls' neighbourhood, `t` in [0, 1].
fn spline(points: &[Vec3], t: f64) -> Vec3 {
    let spans = points.len() - 3;
    let at = (t * spans as f64).min(spans as f64 - 1e-9);
    let first = at as usize;
    let f = at - first as f64;
    let g = 1.0 - f;
    let weights =
        [g * g * g, 3.0 * f * f * f - 6.0 * f * f + 4.0, -3.0 * f * f * f + 3.0 * f * f + 3.0 * f + 1.0, f * f * f];
    (0..4).fold([0.0; 3], |sum, k| add_scaled(sum, points[first + k], weights[k] / 6.0))
}

/// Radius and flattening at a share of the length from the head (0) to the tail (1).
fn thickness(share: f64) -> (f64, f64) {
    let smooth = |low: f64, high: f64| {
        let x = ((share - low) / (high - low)).clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    };
    let head = 0.052;
    let trunk = 0.70 + 0.30 * smooth(0.05, 0.3);
    // The head is a little wider than the neck and ends in a round snout.
    let skull = 0.16 * (1.0 - smooth(0.022, head));
    let snout = (1.0 - (1.0 - (share / 0.03).min(1.0)).powi(2)).max(0.0).sqrt();
    let tail = ((1.0 - share) / 0.33).min(1.0);
    let tail = (tail * (2.0 - tail)).powf(0.85);
    let height = 0.92 - 0.22 * (1.0 - smooth(0.015, head));
    (BODY_RADIUS * (trunk + skull) * snout * tail, height)
}

/// Rings from head to tail.
fn rings() -> Vec<Ring> {
    let controls = controls();
    let centres: Vec<Vec3> = (0..=RINGS).map(|k| spline(&controls, 1.0 - k as f64 / RINGS as f64)).collect();
    let mut lengths = vec![0.0];
    for pair in centres.windows(2) {
        let step = add_scaled(pair[1], pair[0], -1.0);
        lengths.push(lengths[lengths.len() - 1] + dot(step, step).sqrt());
    }
    let whole = lengths[RINGS];
    let mut scales = 0.0;
    (0..=RINGS)
        .map(|k| {
            let (before, after) = (k.saturating_sub(1), (k + 1).min(RINGS));
            let (radius, height) = thickness(lengths[k] / whole);
            // Scales keep their shape: where the body is thin they are small, but not endlessly so.
            let ring_length = 0.5 * SCALE_ASPECT * TAU * radius.max(0.3 * BODY_RADIUS) / f64::from(COLUMNS);
            scales += (lengths[k] - lengths[before]) / ring_length;
            Ring {
                centre: centres[k],
                along: normalise(add_scaled(centres[after], centres[before], -1.0)),
                radius,
                height,
                scales,
            }
        })
        .collect()
}

/// Place on a ring at an angle from its ridge, in ground coordinates.
fn skin(ring: &Ring, angle: f64) -> Vec3 {
    let up = normalise(add_scaled([0.0, 0.0, 1.0], ring.along, -ring.along[2]));
    let side = cross(up, ring.along);
    let (sin, cos) = angle.sin_cos();
    let out = add_scaled(ring.centre, up, ring.radius * ring.height * cos);
    add_scaled(out, side, ring.radius * sin)
}

/// Ground to world coordinates.
fn to_world([x, y, z]: Vec3) -> Vec3 {
    let (sin, cos) = ELEVATION_DEG.to_radians().sin_cos();
    [x, y * sin + z * cos, -y * cos + z * sin]
}

/// The body as a mesh whose texture coordinates are those of the scales.
fn body() -> TriangleMesh {
    let rings = rings();
    let angle = |side: usize| TAU * side as f64 / SIDES as f64 - PI;
    let mut raw = RawMesh { material_names: vec!["skin".into()], ..RawMesh::default() };
    for (k, ring) in rings.iter().enumerate() {
        let (before, after) = (&rings[k.saturating_sub(1)], &rings[(k + 1).min(RINGS)]);
        for side in 0..=SIDES {
            let a = angle(side);
            let along = add_scaled(skin(after, a), skin(before, a), -1.0);
            let around = add_scaled(skin(ring, a + 1e-4), skin(ring, a - 1e-4), -1.0);
            let normal = cross(along, around);
            // At the tips everything meets in a point, which faces outwards along the body.
            let tip = if k == 0 { ring.along.map(|c| -c) } else { ring.along };
            let normal = if dot(normal, normal) > 0.0 { normal } else { tip };
            raw.positions.push(to_world(skin(ring, a)));
            raw.normals.push(to_world(normal));
            raw.uvs.push([ring.scales, f64::from(COLUMNS) * a / TAU]);
        }
    }
    let vertex = |k: usize, side: usize| (k * (SIDES + 1) + side) as u32;
    for k in 0..RINGS {
        for side in 0..SIDES {
            let [a, b, c, d] = [vertex(k, side), vertex(k + 1, side), vertex(k + 1, side + 1), vertex(k, side + 1)];
            raw.triangles.extend([[a, b, c], [a, c, d]]);
            raw.materials.extend([0, 0]);
        }
    }
    build(raw).expect("scale coordinates give every triangle a direction")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::bvh::Ray;

    /// Centre, direction and radii of every ring, in the world.
    fn world_rings() -> Vec<Ring> {
        rings().into_iter().map(|r| Ring { centre: to_world(r.centre), along: to_world(r.along), ..r }).collect()
    }

    /// Distance of a ring's centre from a ray; infinite behind its start.
    fn distance(ray: &Ray, centre: Vec3) -> f64 {
        let from = add_scaled(centre, ray.origin, -1.0);
        let ahead = dot(from, ray.direction);
        if ahead <= 0.0 {
            return f64::INFINITY;
        }
        let aside = add_scaled(from, ray.direction, -ahead);
        dot(aside, aside).sqrt()
    }

    /// Points of the picture: a grid that no symmetry of the body shares.
    fn points() -> impl Iterator<Item = [f64; 2]> {
        (0..83).flat_map(|i| (0..79).map(move |j| [f64::from(i) / 41.3 - 1.0, f64::from(j) / 39.2 - 1.0]))
    }

    /// Each ring is an ellipse across the body, so the body holds balls of its small radius and lies within balls of its
    /// large one, but for the taper between rings.
    #[test]
    fn the_outline_is_that_of_balls_along_the_body() {
        let (snake, rings) = (snake(), world_rings());
        let (mut inside, mut outside) = (0, 0);
        for xy in points() {
            let ray = camera::ray(&snake.view, xy);
            let hit = first_hit(&snake.mesh, &ray).is_some();
            // A polygon of 60 sides lies within its circle by 1 - cos 3 degrees = 0.0014.
            if rings.iter().any(|r| distance(&ray, r.centre) < 0.99 * r.radius * r.height) {
                assert!(hit, "a hole at {xy:?}");
                inside += 1;
            } else if rings.iter().all(|r| distance(&ray, r.centre) > 1.001 * r.radius) {
                assert!(!hit, "something beside the body at {xy:?}");
                outside += 1;
            }
        }
        // Little is left between the two bounds, and the body fills a good part of the picture without leaving it.
        assert!(inside + outside > 6200 && inside > 2000 && outside > 2000, "{inside} {outside}");
        for edge in (-50..=50).map(|k| f64::from(k) / 50.0) {
            for xy in [[edge, 1.0], [edge, -1.0], [1.0, edge], [-1.0, edge]] {
                assert!(hit(snake, xy).is_none());
            }
        }
    }

    #[test]
    fn frames_are_orthonormal_and_x_runs_along_the_body_to_the_tail() {
        let (snake, rings) = (snake(), world_rings());
        let mut seen = 0;
        for xy in points() {
            let Some(LitHit { hit: Hit { frame, to_viewer }, lifted }) = hit(snake, xy) else {
                continue;
            };
            let Frame { tangent: t, bitangent: b, normal: n } = frame;
            for unit in [t, b, n, to_viewer] {
                assert!((dot(unit, unit) - 1.0).abs() < 1e-12);
            }
            assert!(dot(t, n).abs() < 1e-12 && (dot(cross(t, b), n) - 1.0).abs() < 1e-12);
            let squared = |r: &Ring| {
                let d = add_scaled(lifted, r.centre, -1.0);
                dot(d, d)
            };
            let nearest = rings.iter().min_by(|p, q| squared(p).total_cmp(&squared(q))).unwrap();
            // Where the body neither tapers nor ends, a line of constant angle runs parallel to the centre line, but for
            // its bends out of the plane, which turn the ridge: below 3 degrees.
            if nearest.radius > 0.95 * BODY_RADIUS {
                let sideways = dot(b, nearest.along);
                assert!(sideways.abs() < 0.05 && dot(t, nearest.along) > 0.8, "{xy:?}: {sideways}");
                seen += 1;
            }
        }
        assert!(seen > 1000, "{seen}");
    }

    #[test]
    fn coils_lie_on_each_other_and_not_in_each_other() {
        let rings = rings();
        let mut least = f64::INFINITY;
        for (i, a) in rings.iter().enumerate().step_by(5) {
            for b in rings[i..].iter().step_by(5) {
                if b.scales - a.scales < 12.0 {
                    continue;
                }
                let apart = add_scaled(b.centre, a.centre, -1.0);
                least = least.min(dot(apart, apart).sqrt() / (a.radius + b.radius));
            }
            assert!(a.centre[2] >= a.radius * a.height * 0.9, "ring {i} is in the ground");
        }
        assert!((0.9..1.2).contains(&least), "{least}");
    }

    /// Shadows against balls along the body, as in the test of the outline.
    #[test]
    fn the_body_stands_in_its_own_light() {
        let (snake, rings) = (snake(), world_rings());
        let direction = normalise([-0.8, 0.9, 0.5]);
        let (mut lit, mut dark) = (0, 0);
        for xy in points() {
            let Some(LitHit { hit, lifted }) = hit(snake, xy) else {
                continue;
            };
            // Away from the light's horizon, where the surface itself is met or not by a hair.
            if dot(hit.frame.normal, direction) < 0.5 {
                continue;
            }
            let ray = Ray { origin: lifted, direction };
            let beyond = |factor: f64| rings.iter().any(|r| distance(&ray, r.centre) < factor * r.radius);
            if is_lit(snake, lifted, direction) {
                assert!(!beyond(0.6), "{xy:?} lies in the shade");
                lit += 1;
            } else {
                assert!(beyond(1.001), "nothing shades {xy:?}");
                dark += 1;
            }
        }
        assert!(lit > 300 && dark > 20, "{lit} {dark}");
    }
}
