//! What a study is given: specimens, and how much is measured.

use serde::{Deserialize, Serialize};

use super::lent::{LightScene, SceneSamples};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::tables::plan::AUTOMATIC_SIZE_MAX;

/// Tolerances asked for.
pub const TOLERANCES: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// One specimen: its prepared scans.
#[derive(Debug)]
pub struct StudySpecimen {
    /// Name for people.
    pub name: String,
    /// Prepared (levelled, centred) scans.
    pub fields: Vec<HeightField>,
    /// As in the manifest.
    pub optics: OpticsConfig,
    /// The pictures that methods are compared in.
    pub scenes: Vec<Box<dyn SceneSamples>>,
    /// Shapes that are seen under lights with a size; none leaves that out.
    pub lights: Vec<Box<dyn LightScene>>,
}

/// How much is measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudyConfig {
    /// Pairs of directions per region.
    pub directions: usize,
    /// Pairs of directions on which evaluation is timed.
    pub timed_directions: usize,
    /// Texels along u and v.
    pub size: usize,
    /// Numbers of Chebyshev tables.
    pub chebyshev: Vec<usize>,
    /// Numbers of Taylor tables.
    pub taylor: Vec<usize>,
    /// Degrees of the spherical harmonics.
    pub harmonics: Vec<usize>,
    /// Positions and angles of the light fields.
    pub light_fields: Vec<[usize; 2]>,
    /// Numbers of optical paths.
    pub paths: Vec<usize>,
    /// Largest wavelength steps in nm.
    pub wavelength_steps_nm: Vec<f64>,
    /// Numbers of texels of the grid's own study.
    pub sizes: Vec<usize>,
    /// Side of the tables of the comparison at equal error.
    pub equal_size: usize,
    /// Tolerances asked for with automatic settings.
    pub tolerances: Vec<f64>,
    /// Largest side of those tables.
    pub size_max: usize,
    /// Samples of a scene that are compared.
    pub picture_samples: usize,
    /// Pixels along a side that are compared of pictures under lights with a size.
    pub light_pixels: usize,
    /// Points of the light that their truth takes.
    pub light_points: usize,
    /// Whether evaluation is timed on a GPU, where there is one.
    pub gpu: bool,
    /// Working memory of a build in MiB.
    pub memory_mib: usize,
}

impl StudyConfig {
    /// A few seconds per specimen.
    pub fn quick() -> Self {
        Self {
            directions: 96,
            timed_directions: 20_000,
            size: 201,
            chebyshev: vec![1, 2, 3, 4, 5, 6, 8],
            taylor: vec![4, 8, 16, 24, 32],
            harmonics: vec![2, 4, 6],
            light_fields: vec![[16, 64], [64, 256]],
            paths: vec![64, 256, 1024, 4096],
            wavelength_steps_nm: vec![20.0, 10.0, 5.0, 2.5],
            sizes: vec![51, 101, 201],
            equal_size: 301,
            tolerances: TOLERANCES.to_vec(),
            size_max: AUTOMATIC_SIZE_MAX,
            picture_samples: 6_000,
            light_pixels: 15,
            light_points: 1_024,
            gpu: true,
            memory_mib: 2048,
        }
    }

    /// Minutes per specimen.
    pub fn thorough() -> Self {
        Self {
            directions: 400,
            timed_directions: 400_000,
            size: 501,
            chebyshev: vec![1, 2, 3, 4, 5, 6, 7, 8, 10],
            taylor: vec![4, 8, 12, 16, 20, 24, 32, 40],
            harmonics: vec![2, 4, 6, 8, 10],
            light_fields: vec![[16, 64], [64, 256], [256, 1024]],
            paths: vec![64, 256, 1024, 4096, 16_384],
            wavelength_steps_nm: vec![20.0, 10.0, 5.0, 2.5, 1.25],
            sizes: vec![63, 125, 251, 501],
            equal_size: 1001,
            tolerances: TOLERANCES.to_vec(),
            size_max: 2001,
            picture_samples: 20_000,
            light_pixels: 30,
            light_points: 4_096,
            gpu: true,
            memory_mib: 8192,
        }
    }
}
