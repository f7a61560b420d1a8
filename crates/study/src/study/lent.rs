//! What a study is lent by a program that can draw: scenes as samples of their pixels, and a GPU's clock.

use ndarray::Array3;

use super::batch::Pair;
use crate::error::Result;
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

/// A GPU that evaluates tables and tells how long it took.
pub trait GpuClock: Sync {
    /// Its name for people; says where it is software.
    fn adapter(&self) -> String;
    /// Seconds per pair of directions with half-float textures and the hardware's linear look-ups.
    ///
    /// # Errors
    /// [`Error::Lent`](crate::error::Error::Lent) in the GPU's words; a limit, for more tables than a texture has layers.
    fn seconds_per_direction(&self, set: &TableSet) -> Result<f64>;
}
