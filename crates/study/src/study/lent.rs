//! What a study is lent by a program that can draw: scenes as samples of their pixels, shapes under lights, and a GPU's clock.

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use super::batch::Pair;
use crate::error::Result;
use diffraction_brdf::Brdf;
use diffraction_brdf::direction::Xyz;
use diffraction_build::tables::model::TableSet;

/// One scene on a coarse lattice of its pixels: the directions it asks for, and how they make up a picture.
pub trait SceneSamples: std::fmt::Debug + Sync {
    /// The scene's name.
    fn name(&self) -> &str;
    /// Pairs of directions, in an order that [`Self::image`] knows.
    fn pairs(&self) -> &[Pair];
    /// The picture, `[rows, columns, 3]` in XYZ, from the BRDF in 1/sr at each pair.
    fn image(&self, brdf: &[Xyz]) -> Array3<f32>;
    /// Factor with which a picture is shown, given the reference.
    fn exposure(&self, reference: &Array3<f32>) -> f32;
}

/// How a light with a size is averaged in a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LookUps {
    /// So many points of the light and of the pixel.
    Points(usize),
    /// So many filtered look-ups, each of a part of the light and of the pixel.
    Filtered(usize),
}

/// A picture, and what it took.
#[derive(Debug, Clone, PartialEq)]
pub struct LightPicture {
    /// XYZ of some pixels, `[rows, columns, 3]`; pixels that show nothing are 0.
    pub image: Array3<f32>,
    /// Seconds on all threads, the geometry aside.
    pub seconds: f64,
}

/// A shape under one light of any size.
pub trait LightScene: std::fmt::Debug + Sync {
    /// What is shown, such as "ball".
    fn shape(&self) -> &str;
    /// The picture under a light of this angular diameter.
    ///
    /// # Errors
    /// A scene that cannot be rendered.
    fn picture(&self, brdf: &Brdf, diameter_deg: f64, look_ups: LookUps) -> Result<LightPicture>;
}

/// Time of frames on a GPU with one way to average a light.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrameOfLight {
    /// The way, such as "16 points".
    pub what: String,
    /// Tables looked up.
    pub tables: usize,
    /// Pairs of directions in a frame.
    pub look_ups: u64,
    /// Median time of a frame in milliseconds.
    pub median_ms: f64,
}

/// A GPU that evaluates tables and tells how long it took.
pub trait GpuClock: Sync {
    /// Its name for people; says where it is software.
    fn adapter(&self) -> String;
    /// Seconds per pair of directions with half-float textures and the hardware's linear look-ups.
    ///
    /// # Errors
    /// [`Error::Lent`](crate::error::Error::Lent) in the GPU's words; a limit, for more tables than a texture has layers.
    fn seconds_per_direction(&self, set: &TableSet) -> Result<f64>;
    /// Frames of one scene under a light of this angular diameter, timed in turn: a point of light first, then filtered
    /// look-ups, points, and the published method's tables.
    ///
    /// # Errors
    /// As [`Self::seconds_per_direction`].
    fn frames_under_light(&self, set: &TableSet, published: &TableSet, diameter_deg: f64) -> Result<Vec<FrameOfLight>>;
}
