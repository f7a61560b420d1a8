//! Lights with a size: the error of pictures against the number of look-ups a pixel takes, filtered ones beside points.
//!
//! All are made from the same tables, by splines: what is compared is how a light's disc is averaged. The truth takes
//! thousands of points of the light.

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use super::config::{StudyConfig, StudySpecimen};
use super::lent::{FrameOfLight, GpuClock, LightPicture, LookUps};
use super::methods::tables_config;
use super::rows::Refusal;
use super::tolerance::automatic;
use crate::error::Result;
use diffraction_brdf::Brdf;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_build::tables::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, TableSet, TablesConfig};

/// Angular diameters in degrees: the sun's, and lamps.
pub const DIAMETERS_DEG: [f64; 4] = [0.53, 2.0, 5.0, 10.0];

/// Look-ups of a light in a pixel, of points and of filtered ones.
const POINTS: [usize; 4] = [1, 16, 64, 256];
const FILTERED: [usize; 3] = [1, 4, 16];

/// Tolerance of the tables.
const TOLERANCE: f64 = 1e-3;

/// Pixels below this share of the brightest are left out.
const FLOOR: f64 = 1e-6;

/// One way to make a picture of one shape under one light.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LightRow {
    /// What is shown: "ball", "snake", "patch", "screen".
    pub shape: String,
    /// Angular diameter of the light in degrees; of a screen, of its beam's divergence.
    pub diameter_deg: f64,
    /// Whether look-ups are filtered.
    pub is_filtered: bool,
    /// Look-ups of the light asked for in each pixel.
    pub look_ups: usize,
    /// Pixels compared.
    pub pixels: usize,
    /// Median and 95th percentile of the luminance's relative error over them, and the root mean square over the mean luminance.
    pub errors: [f64; 3],
    /// Seconds for the picture on all threads.
    pub seconds: f64,
}

/// Frames of one way to light a picture on the GPU.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LightFrames {
    /// Angular diameter of the light in degrees.
    pub diameter_deg: f64,
    /// One row for each way, the first being a point of light.
    pub frames: Vec<FrameOfLight>,
}

/// Everything about lights.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Lights {
    /// Errors of pictures.
    pub rows: Vec<LightRow>,
    /// Points of the light that the truth takes.
    pub truth_points: usize,
    /// Texels along u and v, and number of tables.
    pub tables: [usize; 2],
    /// Times of frames; none without a GPU.
    pub frames: Vec<LightFrames>,
}

/// Steps that [`lights`] tells of.
pub fn count(specimen: &StudySpecimen) -> u64 {
    (specimen.lights.len() * DIAMETERS_DEG.len()) as u64
}

/// Measures pictures and, where there is a GPU, frames. What the GPU refuses is told among `refusals`.
///
/// # Errors
/// Those of building, and of scenes that cannot be rendered.
pub fn lights(
    specimen: &StudySpecimen,
    config: &StudyConfig,
    gpu: Option<&dyn GpuClock>,
    refusals: &mut Vec<Refusal>,
    advance: &dyn Fn(),
) -> Result<Lights> {
    if specimen.lights.is_empty() {
        return Ok(Lights::default());
    }
    let settings = automatic(&specimen.optics, config, TOLERANCE);
    let of = |settings: &TablesConfig| {
        let input = BuildInput::new(&specimen.fields, &specimen.optics, settings);
        build::build(&input, &|_| ()).map(|(set, _)| set)
    };
    let set = of(&settings)?;
    let mut found =
        Lights { truth_points: config.light_points, tables: [set.size(), set.tables.len()], ..Lights::default() };
    if let Some(gpu) = gpu {
        let published = TablesConfig { size: settings.size, ..tables_config(config, Basis::Taylor) };
        match of(&published).map_err(crate::error::Error::from).and_then(|published| frames(gpu, &set, &published)) {
            Ok(frames) => found.frames = frames,
            Err(error) => refusals.push(Refusal { what: "frames under lights".into(), message: error.to_string() }),
        }
    }
    let brdf = Brdf::new(set)?.with_interpolation(Interpolation::Spline);
    for scene in &specimen.lights {
        for diameter_deg in DIAMETERS_DEG {
            let picture = |look_ups| scene.picture(&brdf, diameter_deg, look_ups);
            let truth = picture(LookUps::Points(config.light_points))?;
            let ways = FILTERED.map(LookUps::Filtered).into_iter().chain(POINTS.map(LookUps::Points));
            for look_ups in ways {
                found.rows.push(row(scene.shape(), diameter_deg, look_ups, &picture(look_ups)?, &truth));
            }
            advance();
        }
    }
    Ok(found)
}

fn frames(gpu: &dyn GpuClock, set: &TableSet, published: &TableSet) -> Result<Vec<LightFrames>> {
    let of_light =
        |diameter_deg| Ok(LightFrames { diameter_deg, frames: gpu.frames_under_light(set, published, diameter_deg)? });
    DIAMETERS_DEG[..2].iter().copied().map(of_light).collect()
}

fn row(shape: &str, diameter_deg: f64, look_ups: LookUps, found: &LightPicture, truth: &LightPicture) -> LightRow {
    let (is_filtered, count) = match look_ups {
        LookUps::Filtered(count) => (true, count),
        LookUps::Points(count) => (false, count),
    };
    let (errors, pixels) = errors(&found.image, &truth.image);
    LightRow { shape: shape.into(), diameter_deg, is_filtered, look_ups: count, pixels, errors, seconds: found.seconds }
}

/// Median, 95th percentile, and root mean square over the mean, and how many pixels were lit.
fn errors(found: &Array3<f32>, truth: &Array3<f32>) -> ([f64; 3], usize) {
    let luminances = |image: &Array3<f32>| image.rows().into_iter().map(|xyz| f64::from(xyz[1])).collect::<Vec<_>>();
    let (found, truth) = (luminances(found), luminances(truth));
    let brightest = truth.iter().copied().fold(0.0, f64::max);
    let pairs = || found.iter().zip(&truth).filter(|(_, truth)| **truth > FLOOR * brightest);
    let mut relative: Vec<f64> = pairs().map(|(found, truth)| (found - truth).abs() / truth).collect();
    relative.sort_by(f64::total_cmp);
    let count = relative.len();
    if count == 0 {
        return ([0.0; 3], 0);
    }
    let mean = pairs().map(|(_, truth)| truth).sum::<f64>() / count as f64;
    let square = pairs().map(|(found, truth)| (found - truth).powi(2)).sum::<f64>() / count as f64;
    ([relative[count / 2], relative[(count - 1) * 95 / 100], square.sqrt() / mean], count)
}
