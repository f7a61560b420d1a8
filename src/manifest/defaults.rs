//! What holds where a manifest says nothing; docs/manifest.md lists the same values.

use super::model::GpuSection;
use crate::stages::config::{FrameTiming, GpuCheck, ReportConfig};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::prepare::Level;
use diffraction_build::optics::config::{Edge, Factor, Material, OpticsConfig, Windows};
use diffraction_build::tables::model::{Basis, Prefilter, TablesConfig};
use diffraction_render::scene::model::{Light, Scene, Shape};
use diffraction_render::scene::turn::Axis;

/// `[atlas] out`.
pub const OUT: &str = "out/atlas";
/// `[gpu]`.
pub const GPU: GpuSection = GpuSection { check: GpuCheck::Auto, frame_time: FrameTiming::Auto };
/// `[report]`.
pub(crate) const REPORT: ReportConfig = ReportConfig { write: true, reference: true, savings: false };
/// `[cache] folder`, in the folder of atlases.
pub(crate) const CACHE_FOLDER: &str = ".cache";
/// `[cache] limit_mib`.
pub(crate) const CACHE_LIMIT_MIB: u64 = 1024;
/// `[[specimen]] level`.
pub(crate) const LEVEL: Level = Level::Plane;
/// `[[specimen]] max_missing_share`.
pub(crate) const MAX_MISSING_SHARE: f64 = 0.05;
/// `measured.acceptance_deg`: a single direction.
pub(crate) const ACCEPTANCE_DEG: f64 = 0.0;
/// `measured.bandwidth_nm`: a single wavelength.
pub(crate) const BANDWIDTH_NM: f64 = 0.0;
/// `measured.white_reflectance`: values relative to what reflects all light.
pub(crate) const WHITE_REFLECTANCE: f64 = 1.0;
/// `height.offset_nm`, beside `nm_per_count`.
pub(crate) const OFFSET_NM: f64 = 0.0;
/// `[[scene]] size_px`.
pub const SIZE_PX: usize = 512;
/// `[[scene]] light_samples`.
pub(crate) const LIGHT_SAMPLES: usize = 16;
/// `[[scene]] light_samples` where an environment lights the scene: a light from all around needs more.
pub(crate) const ENVIRONMENT_SAMPLES: usize = 256;
/// `environment.rotate_deg`.
pub(crate) const ENVIRONMENT_ROTATE_DEG: f64 = 0.0;
/// `environment.scale`.
pub(crate) const ENVIRONMENT_SCALE: f64 = 1.0;
/// `animate.axis`.
pub(crate) const ANIMATE_AXIS: Axis = Axis::Vertical;
/// `animate.frames`.
pub(crate) const ANIMATE_FRAMES: usize = 24;
/// `animate.degrees`: once round.
pub(crate) const ANIMATE_DEGREES: f64 = 360.0;
/// `animate.fps`.
pub(crate) const ANIMATE_FPS: usize = 12;
/// `[[scene]] light`: the sun, high and a little to the right.
pub const LIGHT: Light = Light { direction: [0.3, 0.2, 1.0], angular_diameter_deg: 0.53, irradiance: 1.0 };
/// `[[scene]] pixel_samples`.
pub(crate) const PIXEL_SAMPLES: usize = 1;
/// Patch.
pub const PATCH: Shape = Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 0.0, turn_deg: 0.0 };
/// Camera of a mesh: what points up in the picture.
pub(crate) const CAMERA_UP: [f64; 3] = [0.0, 1.0, 0.0];
/// Camera of a mesh: `fov_deg`.
pub(crate) const CAMERA_FOV_DEG: f64 = 25.0;
/// Screen: about the published set-up.
pub(crate) const SCREEN: Shape = Shape::Screen {
    width_mm: 200.0,
    distance_mm: 100.0,
    beam_diameter_mm: 1.0,
    hole_diameter_mm: None,
    incidence_deg: 0.0,
};
/// Screen: `beam_divergence_deg`.
pub(crate) const BEAM_DIVERGENCE_DEG: f64 = 0.0;

/// `[optics]`: filtered sunlight as in the published measurements, and a perfect reflector.
pub fn optics() -> OpticsConfig {
    OpticsConfig {
        illuminant: Illuminant::D65,
        wavelength_nm: [380.0, 780.0],
        sigma_nm: 16_250.0,
        lobe_sigma_nm: None,
        source_deg: None,
        sigma_follows_scan: false,
        edge: Edge::Auto,
        windows: Windows::Grid,
        material: Material::Ideal,
        dispersion: None,
        shadowing: false,
        factor: Factor::Vector,
    }
}

/// The scenes of a manifest without any, where tables answer for every direction: a ball, which shows all of them at once, and an
/// animal. Four samples of the sun will do for its half degree.
pub(crate) fn scenes() -> Vec<Scene> {
    let scene = |name, shape| Scene { light_samples: 4, ..Scene::still(name, shape, vec![LIGHT], 256) };
    vec![scene("sphere", Shape::Sphere), scene("snake", Shape::Snake)]
}

/// `[tables]`.
pub fn tables() -> TablesConfig {
    TablesConfig {
        basis: Basis::Chebyshev,
        tolerance: 1e-3,
        size: None,
        count: None,
        wavelength_step_nm: None,
        storage: None,
        prefilter: Prefilter::Auto,
        memory_mib: 2048,
    }
}
