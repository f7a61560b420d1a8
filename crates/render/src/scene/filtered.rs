//! Shading samples that each stand for a piece of a light and of a pixel: what filtered look-ups make pictures of.
//!
//! Lights that are small enough take one look-up a pixel. Of larger ones each sample stands for the directions that are its share;
//! surroundings are sampled point by point, for means over their samples' shares were measured to add noise. A pixel that shows one smooth piece of surface is one look-up too, over
//! the (u, v) that it covers: their covariance at the four points of Gauss's rule, whatever turns there: the normal,
//! the structure's axes, the direction to the viewer. Pixels at an edge are sampled. A map of the BRDF over the hemisphere takes
//! the light's disc and the pixel's square; a screen the beam's spot and divergence, whole or in parts, and the pixel's square.

use std::ops::Range;

use rayon::prelude::*;

use diffraction_brdf::Footprint;
use diffraction_brdf::direction::{Vec3, dot, normalise, wave_vector_change};
use diffraction_brdf::error::Result;

use super::frame::to_local;
use super::hit::LitHit;
use super::light::{direction_to, disc_parts, environment_count, polar};
use super::model::{Light, Scene, Shape, check};
use super::samples::{ShadingSamples, pixel_centre, pixel_width, position};
use super::screen::{self, BeamPiece, ScreenSetup};
use super::surface::{self, Surface};
use super::surroundings;

/// Places of Gauss's rule in a pixel: their covariance is that of the whole pixel.
const NODE: f64 = 0.288_675_134_594_812_9;
/// Cosine between the normals at a pixel's centre and at those places, below which the pixel is sampled: 0.35 radians.
const COSINE_MIN: f64 = 0.94;
/// How far normal and tangent may be from varying evenly over a pixel, as a share of how far they vary, and the jump that makes no
/// difference: beyond lies an edge, which is sampled too.
const UNEVEN_MAX: f64 = 0.15;
const JUMP_MIN: f64 = 1e-3;
/// Places in a pixel at an edge, along a side.
const EDGE_PLACES: usize = 4;

/// Largest angular diameter in degrees of a light that one look-up stands for within a tolerance of the luminance at 95 of 100 pairs of
/// directions. Errors grow with the square of the angle, and were measured to be below 1e-2 for a lamp of two degrees and below 1e-3
/// for the sun (docs/optics.md, "Filtered look-ups").
pub fn diameter_max_deg(tolerance: f64) -> f64 {
    2.0 * (tolerance / 1e-2).sqrt()
}

/// Samples, and what each of them stands for.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FilteredSamples {
    /// Centres and weights.
    pub samples: ShadingSamples,
    /// The (u, v) around each.
    pub footprints: Vec<Footprint>,
}

/// One sample.
struct Sample {
    wi: Vec3,
    wo: Vec3,
    weight: f64,
    footprint: Footprint,
}

/// Most samples that a pixel can have.
pub fn filtered_per_pixel(scene: &Scene) -> usize {
    scene.lights.len().max(1) * scene.light_samples.max(EDGE_PLACES * EDGE_PLACES) + environment_count(scene)
}

/// The samples of every `stride`-th pixel in both directions. Lights up to [`diameter_max_deg`] take one look-up, larger ones and
/// surroundings `light_samples`; `pixel_samples` are not asked for.
///
/// # Errors
/// `Error::Call` for a scene that cannot be rendered.
pub fn filtered_samples_of(
    scene: &Scene,
    tolerance: f64,
    rows: Range<usize>,
    stride: usize,
) -> Result<FilteredSamples> {
    check(scene)?;
    let stride = stride.max(1);
    let columns: Vec<usize> = (0..scene.size_px).step_by(stride).collect();
    let lights: Vec<Vec<Piece>> = scene.lights.iter().map(|light| pieces(scene, tolerance, light)).collect();
    let rows: Vec<usize> = rows.step_by(stride).collect();
    let of_pixel: Box<dyn Fn([usize; 2]) -> Vec<Sample> + Sync> = match (surface::surface(scene), &scene.shape) {
        (Some(surface), _) => Box::new(move |at| pixel(scene, &surface, &lights, at)),
        (None, Shape::Screen { .. }) => {
            let setup = screen::setup(scene);
            let beam = screen::beam_pieces(scene, &setup, diameter_max_deg(tolerance));
            Box::new(move |at| of_screen(scene, &setup, &beam, at))
        }
        (None, _) => Box::new(move |at| of_hemisphere(scene, &lights[0], at)),
    };
    let of_row = |row: &usize| columns.iter().map(|&column| of_pixel([*row, column])).collect();
    let gathered: Vec<Vec<Vec<Sample>>> = rows.par_iter().map(of_row).collect();
    let mut out = FilteredSamples::default();
    out.samples.rows = rows.len();
    out.samples.columns = columns.len();
    out.samples.first.push(0);
    for pixel in gathered.into_iter().flatten() {
        for sample in pixel {
            out.samples.wi.push(sample.wi.map(|c| c as f32));
            out.samples.wo.push(sample.wo.map(|c| c as f32));
            out.samples.weight.push(sample.weight as f32);
            out.footprints.push(sample.footprint);
        }
        out.samples.first.push(out.footprints.len() as u32);
    }
    Ok(out)
}

/// A direction to a light, the irradiance from there on a surface that faces it, and the angular radius that it stands for.
#[derive(Debug, Clone, Copy)]
struct Piece {
    direction: Vec3,
    irradiance: f64,
    radius: f64,
}

/// A light as one piece, or as many even ones.
fn pieces(scene: &Scene, tolerance: f64, light: &Light) -> Vec<Piece> {
    let whole = light.angular_diameter_deg <= diameter_max_deg(tolerance);
    let count = if whole { 1 } else { scene.light_samples };
    let directions: Vec<Vec3> = disc_parts(count).into_iter().map(|part| direction_to(light, polar(part))).collect();
    let axis = normalise(light.direction);
    let facing: f64 = directions.iter().map(|direction| dot(*direction, axis)).sum();
    let radius = (0.5 * light.angular_diameter_deg).to_radians() / (count as f64).sqrt();
    let piece = move |direction| Piece { direction, irradiance: light.irradiance / facing, radius };
    directions.into_iter().map(piece).collect()
}

/// A pixel of the map of the BRDF: the viewing directions of its square.
fn of_hemisphere(scene: &Scene, light: &[Piece], [row, column]: [usize; 2]) -> Vec<Sample> {
    let [x, y] = pixel_centre(scene, row, column);
    let cos_squared = 1.0 - x * x - y * y;
    if cos_squared <= 0.0 {
        return Vec::new();
    }
    // A square of side 1 has the variance 1/12 along each side.
    let variance = pixel_width(scene).powi(2) / 12.0;
    let square = Footprint::new(variance, 0.0, variance).unwrap_or_default();
    let of_piece = |piece: &Piece| {
        let (wi, weight) = (piece.direction, 1.0 / light.len() as f64);
        sample(wi, [x, y, cos_squared.sqrt()], weight, piece.radius, square)
    };
    light.iter().filter_map(of_piece).collect()
}

/// A pixel of a screen.
fn of_screen(scene: &Scene, setup: &ScreenSetup, beam: &[BeamPiece], [row, column]: [usize; 2]) -> Vec<Sample> {
    let (at, width) = (pixel_centre(scene, row, column), pixel_width(scene));
    let of_piece = |piece: &BeamPiece| {
        let (wi, wo, weight, [uu, uv, vv]) = screen::seen_of_piece(setup, piece, width, at)?;
        sample(wi, wo, weight, piece.divergence, Footprint::new(uu, uv, vv).unwrap_or_default())
    };
    beam.iter().filter_map(of_piece).collect()
}

fn pixel(scene: &Scene, surface: &Surface, lights: &[Vec<Piece>], [row, column]: [usize; 2]) -> Vec<Sample> {
    let (middle, width) = (pixel_centre(scene, row, column), pixel_width(scene));
    let at = |offset: [f64; 2]| surface::hit(surface, position(middle, offset, width));
    let mut out = Vec::new();
    let place = surroundings::morton(row, column);
    let around = |hit: &LitHit, index: usize, count: usize| -> Option<Piece> {
        let environment = scene.environment.as_ref()?;
        let (direction, irradiance) = surroundings::sample(environment, &hit.hit, place, index, count)?;
        Some(Piece { direction, irradiance, radius: 0.0 })
    };
    let nodes = [[-NODE, -NODE], [NODE, -NODE], [-NODE, NODE], [NODE, NODE]].map(at);
    if let (Some(centre), [Some(a), Some(b), Some(c), Some(d)]) = (at([0.0, 0.0]), nodes) {
        let nodes = [a, b, c, d];
        if is_smooth(&centre, &nodes) {
            let mut add = |piece: Piece| smooth(surface, &centre, &nodes, piece, &mut out);
            lights.iter().flatten().copied().for_each(&mut add);
            let count = environment_count(scene);
            (0..count).filter_map(|index| around(&centre, index, count)).for_each(add);
            return out;
        }
    }
    let places = EDGE_PLACES * EDGE_PLACES;
    for index in 0..places {
        let offset = [index % EDGE_PLACES, index / EDGE_PLACES].map(|k| (k as f64 + 0.5) / EDGE_PLACES as f64 - 0.5);
        let Some(hit) = at(offset) else { continue };
        let mut add = |piece: Piece, share: f64| {
            if let Some((wi, wo)) = lit(surface, &hit, piece.direction) {
                let weight = share * piece.irradiance * wi[2];
                out.extend(sample(wi, wo, weight, piece.radius, Footprint::POINT));
            }
        };
        // Places share out pieces and directions, or those the places.
        for pieces in lights {
            for k in (index..pieces.len().max(places)).step_by(places) {
                let piece = k % pieces.len();
                let uses = if pieces.len() < places { (places - piece).div_ceil(pieces.len()) } else { 1 };
                add(pieces[piece], 1.0 / uses as f64);
            }
        }
        let count = environment_count(scene);
        (index..count).step_by(places).filter_map(|index| around(&hit, index, count)).for_each(|piece| add(piece, 1.0));
    }
    out
}

/// Whether a pixel shows one piece of surface that turns evenly: the four nodes, and the centre, lie on a plane of normals and one of tangents.
fn is_smooth(centre: &LitHit, nodes: &[LitHit; 4]) -> bool {
    let apart = |node: &LitHit| dot(node.hit.frame.normal, centre.hit.frame.normal);
    let is_even = |of: fn(&LitHit) -> Vec3| {
        let [a, b, c, d] = nodes.each_ref().map(of);
        let middle = of(centre);
        let norm = |part: &dyn Fn(usize) -> f64| (0..3).map(|k| part(k).powi(2)).sum::<f64>().sqrt();
        let spread = norm(&|k| a[k] - d[k]).max(norm(&|k| b[k] - c[k]));
        let off_centre = norm(&|k| 0.25 * (a[k] + b[k] + c[k] + d[k]) - middle[k]);
        let twist = norm(&|k| 0.5 * (a[k] + d[k] - b[k] - c[k]));
        off_centre.max(twist) <= UNEVEN_MAX * spread + JUMP_MIN
    };
    nodes.iter().map(apart).all(|cosine| cosine > COSINE_MIN)
        && is_even(|hit| hit.hit.frame.normal)
        && is_even(|hit| hit.hit.frame.tangent)
}

/// A pixel that shows one smooth piece: one look-up, or at the edge of a shadow one at each node that is lit.
fn smooth(surface: &Surface, centre: &LitHit, nodes: &[LitHit; 4], piece: Piece, out: &mut Vec<Sample>) {
    let seen = nodes.map(|node| lit(surface, &node, piece.direction));
    let changes: Vec<Vec3> = seen.iter().flatten().map(|(wi, wo)| wave_vector_change(*wi, *wo)).collect();
    let mean: [f64; 2] = [0, 1].map(|k| changes.iter().map(|q| q[k]).sum::<f64>() / changes.len().max(1) as f64);
    let moment = |j: usize, k: usize| changes.iter().map(|q| (q[j] - mean[j]) * (q[k] - mean[k])).sum::<f64>();
    let covariance = [moment(0, 0), moment(0, 1), moment(1, 1)].map(|sum| sum / changes.len().max(1) as f64);
    let footprint = |share: f64| {
        let [uu, uv, vv] = covariance.map(|value| share * value);
        Footprint::new(uu, uv, vv).unwrap_or_default()
    };
    if let (4, Some((wi, wo))) = (changes.len(), lit(surface, centre, piece.direction)) {
        let cosine = seen.iter().flatten().map(|(wi, _)| wi[2]).sum::<f64>() / 4.0;
        out.extend(sample(wi, wo, piece.irradiance * cosine, piece.radius, footprint(1.0)));
        return;
    }
    for (wi, wo) in seen.into_iter().flatten() {
        // A quarter of the pixel, where its nodes tell; else a point.
        let pixel = if changes.len() == 4 { footprint(0.25) } else { Footprint::POINT };
        out.extend(sample(wi, wo, 0.25 * piece.irradiance * wi[2], piece.radius, pixel));
    }
}

/// Local directions to a light and to the viewer, where both are above the surface and nothing stands between.
fn lit(surface: &Surface, seen: &LitHit, direction: Vec3) -> Option<(Vec3, Vec3)> {
    let frame = &seen.hit.frame;
    let (wi, wo) = (to_local(frame, direction), to_local(frame, seen.hit.to_viewer));
    (wi[2] > 0.0 && wo[2] > 0.0 && surface::is_lit(surface, seen.lifted, direction)).then_some((wi, wo))
}

/// A sample, unless its numbers vanish in single precision.
fn sample(wi: Vec3, wo: Vec3, weight: f64, radius: f64, pixel: Footprint) -> Option<Sample> {
    let light = Footprint::of_light(wi, 2.0 * radius.to_degrees()).unwrap_or_default();
    let is_seen = wi[2] as f32 > 0.0 && wo[2] as f32 > 0.0 && weight as f32 > 0.0;
    is_seen.then_some(Sample { wi, wo, weight, footprint: light + pixel })
}
