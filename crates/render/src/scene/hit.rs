//! What a camera's ray meets, whatever the shape.

use diffraction_brdf::direction::Vec3;

use super::frame::Frame;

/// What a camera ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Hit {
    /// Frame of the surface there.
    pub frame: Frame,
    /// Unit vector to the viewer in the world.
    pub to_viewer: Vec3,
}

/// What a camera ray meets on a body that may stand in its own light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LitHit {
    /// Frame and viewer.
    pub hit: Hit,
    /// Where rays to lights start.
    pub lifted: Vec3,
}
