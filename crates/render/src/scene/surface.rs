//! Surfaces that a camera sees: what its rays meet, whatever the shape, and whether lights get there.

use diffraction_brdf::direction::Vec3;

use super::hit::{Hit, LitHit};
use super::mesh::{self, MeshView};
use super::model::{Scene, Shape};
use super::patch::{self, PatchView};
use super::snake::{self, Snake};
use super::sphere;
use super::turn::{Turn, back, carried, turned};

/// A scene's surface, ready for rays.
#[derive(Debug)]
pub(crate) enum Surface<'a> {
    /// [`Shape::Sphere`], turned about the viewing axis.
    Sphere(Turn),
    /// [`Shape::Snake`], likewise.
    Snake(&'static Snake, Turn),
    /// [`Shape::Mesh`].
    Mesh(MeshView<'a>),
    /// [`Shape::Patch`].
    Patch(PatchView),
}

/// The surface of a scene that has passed `model::check`; `None` for a map of directions (`Shape::Hemisphere`) and for a
/// screen, of which no camera sees the specimen.
pub(crate) fn surface(scene: &Scene) -> Option<Surface<'_>> {
    match &scene.shape {
        Shape::Hemisphere | Shape::Screen { .. } => None,
        Shape::Sphere => Some(Surface::Sphere(scene.turn)),
        Shape::Snake => Some(Surface::Snake(snake::snake(), scene.turn)),
        Shape::Mesh(shape) => Some(Surface::Mesh(mesh::view(shape, scene.turn))),
        Shape::Patch { .. } => Some(Surface::Patch(patch::turned(&patch::view(&scene.shape), scene.turn))),
    }
}

/// What the camera ray through picture point `(x, y)` meets.
pub(crate) fn hit(surface: &Surface, xy: [f64; 2]) -> Option<LitHit> {
    match surface {
        Surface::Sphere(turn) => turned_in_picture(*turn, xy, |xy| sphere::hit(xy).map(unshaded)),
        Surface::Snake(snake, turn) => turned_in_picture(*turn, xy, |xy| snake::hit(snake, xy)),
        Surface::Mesh(view) => mesh::hit(view, xy),
        Surface::Patch(view) => patch::hit(view, xy).map(unshaded),
    }
}

/// Whether nothing stands between a point of the surface and a light.
pub(crate) fn is_lit(surface: &Surface, from: Vec3, direction: Vec3) -> bool {
    match surface {
        Surface::Sphere(_) | Surface::Patch(_) => true,
        Surface::Snake(snake, turn) => {
            let [from, direction] = [from, direction].map(|v| turned(v, back(*turn)));
            snake::is_lit(snake, from, direction)
        }
        Surface::Mesh(view) => mesh::is_lit(view, from, direction),
    }
}

/// A point of a convex surface, from which no ray to a light starts.
fn unshaded(hit: Hit) -> LitHit {
    LitHit { hit, lifted: [0.0; 3] }
}

/// What a camera ray meets of an object turned about the viewing axis: what the ray through the point turned
/// back meets of the object as it is.
fn turned_in_picture(turn: Turn, [x, y]: [f64; 2], hit: impl Fn([f64; 2]) -> Option<LitHit>) -> Option<LitHit> {
    let [x, y, _] = turned([x, y, 0.0], back(turn));
    let LitHit { hit: Hit { frame, to_viewer }, lifted } = hit([x, y])?;
    let hit = Hit { frame: carried(&frame, turn), to_viewer: turned(to_viewer, turn) };
    Some(LitHit { hit, lifted: turned(lifted, turn) })
}
