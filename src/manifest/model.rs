//! The manifest as plain data: every default filled in, every path and pattern resolved.

use std::path::PathBuf;

use serde::Serialize;

pub use crate::stages::cache::CacheConfig;
pub use crate::stages::config::{FrameTiming, GpuCheck, ReportConfig, Serve};
use crate::stages::measured::MeasuredConfig;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::tables::model::TablesConfig;
use diffraction_render::scene::environment::Environment;
use diffraction_render::scene::mesh::MeshShape;
use diffraction_render::scene::model::Animation;

/// A whole manifest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Manifest {
    /// Version of the manifest's format.
    pub schema: u32,
    /// What the atlas is called and where it goes.
    pub atlas: AtlasSection,
    /// The optics that specimens start from.
    pub optics: OpticsConfig,
    /// What is asked of the tables.
    pub tables: TablesConfig,
    /// Which directions the tables answer for.
    pub serve: Serve,
    /// The specimens, at least one, in the manifest's order; names are unique.
    pub specimens: Vec<SpecimenSection>,
    /// The pictures, in the manifest's order; names are unique.
    pub scenes: Vec<SceneSection>,
    /// What a GPU is used for.
    pub gpu: GpuSection,
    /// What is found out besides the tables.
    pub report: ReportConfig,
    /// Where intermediate results are kept.
    pub cache: CacheConfig,
    /// The folder that relative paths start at.
    pub base: PathBuf,
}

/// What a GPU is used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct GpuSection {
    /// Whether tables are checked on one.
    pub check: GpuCheck,
    /// Whether frames are timed on it.
    pub frame_time: FrameTiming,
}

/// What the atlas is called and where it goes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AtlasSection {
    /// Safe as a folder's name.
    pub name: String,
    /// The folder that holds atlases; this one's versions go to `out/name`.
    pub out: PathBuf,
}

/// One specimen.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpecimenSection {
    /// Safe as a folder's name.
    pub name: String,
    /// The species, for people.
    pub species: Option<String>,
    /// Existing files, sorted, none twice; their BRDFs are averaged.
    pub scans: Vec<PathBuf>,
    /// Page of a file with several, from 0.
    pub page: Option<usize>,
    /// Sample spacing along x and y in nm, overruling the file.
    pub pitch_nm: Option<[f64; 2]>,
    /// What the stored numbers mean, overruling the file.
    pub height: Option<HeightSection>,
    /// What is subtracted before anything else is done with the heights.
    pub level: LevelSection,
    /// Removal of single outliers.
    pub despike: Option<DespikeSection>,
    /// Width over which opposite edges are blended for `edge = "tile"`, in nm.
    pub blend_nm: Option<f64>,
    /// Largest share of missing samples that may be filled in.
    pub max_missing_share: f64,
    /// The manifest's optics with this specimen's own settings in their place.
    pub optics: OpticsConfig,
    /// Albedo of a pigment below the structure, linear sRGB.
    pub albedo: Option<[f64; 3]>,
    /// Measured reflectance to compare with.
    pub measured: Option<MeasuredConfig>,
}

/// What the stored numbers of a scan mean.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HeightSection {
    /// The whole range of the integer type spans this height in nm.
    FullScaleNm(f64),
    /// Numbers are heights in this unit.
    Unit(HeightUnit),
    /// `height = nm_per_count * number + offset_nm`.
    Linear {
        /// Height of one count in nm; negative where the instrument counts downwards.
        nm_per_count: f64,
        /// Height of the number 0 in nm.
        offset_nm: f64,
    },
}

/// A unit of height.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum HeightUnit {
    /// 1e-12 m.
    Pm,
    /// 1e-9 m.
    Nm,
    /// 1e-6 m.
    Um,
    /// 1e-3 m.
    Mm,
    /// 1e-2 m.
    Cm,
    /// Metre.
    M,
    /// 1e-10 m.
    Angstrom,
    /// 25.4 mm.
    Inch,
}

/// What levelling subtracts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum LevelSection {
    /// Nothing.
    None,
    /// The best plane.
    Plane,
    /// The best second-order surface.
    Quadratic,
    /// A plane, then each scan line's own offset and slope.
    Rows,
}

/// Removal of single outliers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DespikeSection {
    /// How far from its surroundings a sample may lie, in robust standard deviations.
    pub threshold_rms: f64,
}

/// One picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneSection {
    /// Safe as a file's name.
    pub name: String,
    /// What is looked at.
    pub shape: ShapeSection,
    /// The lights; exactly one for a hemisphere, and for a screen, whose beam it stands for (the
    /// shape holds the beam's direction, so this one's is +z).
    pub lights: Vec<LightSection>,
    /// Light from all around.
    pub environment: Option<Environment>,
    /// Frames besides the still.
    pub animation: Option<Animation>,
    /// Width and height of the picture.
    pub size_px: usize,
    /// How luminance becomes brightness.
    pub exposure: ExposureSection,
    /// What tables made for it may err by; `None` for the tolerance of all tables.
    pub tolerance: Option<f64>,
    /// Directions that stand for the disc of each light, or points that stand for a screen's beam.
    pub light_samples: usize,
    /// Positions within each pixel.
    pub pixel_samples: usize,
    /// The one specimen to show; `None` for each in turn.
    pub specimen: Option<String>,
}

/// What a scene shows.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ShapeSection {
    /// The BRDF over all viewing directions.
    Hemisphere,
    /// A ball.
    Sphere,
    /// A coiled snake.
    Snake,
    /// A mesh file, read and checked.
    Mesh(MeshShape),
    /// A flat square in perspective.
    Patch {
        /// Side of the square.
        width_mm: f64,
        /// From the camera to its centre; more than its width.
        distance_mm: f64,
        /// Leans the upper edge away from the camera.
        tilt_deg: f64,
        /// Turns the structure within the square, counter-clockwise.
        turn_deg: f64,
    },
    /// A screen that catches the light a beam sends back from the specimen.
    Screen {
        /// Side of the screen.
        width_mm: f64,
        /// From the specimen to the screen.
        distance_mm: f64,
        /// Diameter of the beam.
        beam_diameter_mm: f64,
        /// Diameter of the hole that the beam passes; `None` for the beam's own.
        hole_diameter_mm: Option<f64>,
        /// Between the beam and the specimen's normal.
        incidence_deg: f64,
    },
}

/// One light.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LightSection {
    /// Towards the light, of any length but zero; above the horizon of flat shapes.
    pub direction: [f64; 3],
    /// Apparent diameter; 0 for a point.
    pub angular_diameter_deg: f64,
    /// Relative luminous irradiance on a surface facing the light.
    pub irradiance: f64,
}

/// How luminance becomes brightness.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ExposureSection {
    /// From the picture itself.
    Auto,
    /// Fixed, in stops; at 0 a white Lambertian surface facing a light of irradiance 1 is white.
    Ev(f64),
}
