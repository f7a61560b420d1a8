//! The study: every method over its settings, its errors against the direct sum, its time, memory and bytes.
//!
//! All methods answer the same question on the same directions: one coherence window, no prefilter, and a
//! window no wider than the tables' grid resolves, so that methods are compared and not their filters.

mod batch;
mod equal;
mod knobs;
mod lent;
mod methods;
mod pictures;
mod sample;
mod texels;
mod timing;
mod tolerance;
mod wave_methods;

pub use batch::stored;
pub use equal::{Contender, EqualError, Filed, Measure};
pub use lent::{GpuClock, SceneSamples};
pub use methods::PURPOSES;
pub use sample::pair_of;
pub use tolerance::{Kept, TOLERANCES, ToleranceRow, automatic, row as tolerance_row};

use timing::Clock;

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use crate::baselines::statistics::{SurfaceStatistics, surface_statistics};
use diffraction_brdf::error::Result;
use diffraction_build::accuracy::directions::FLOOR_SHARE;
use diffraction_build::ground::metrics::ErrorQuantiles;
use diffraction_build::ground::progress::Progress;
use diffraction_build::ground::sampling::Region;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::optics::window::FADE_SIGMAS;
use diffraction_build::tables::build::AUTOMATIC_SIZE_MAX;
use diffraction_build::tables::model::{Basis, Storage};
use diffraction_build::tables::plan::{lobe_width, usable_radius};

/// Standard deviations of the narrowest lobe per texel of the study's tables: cubic interpolation then errs by
/// about `3/128 · 0.5⁴ · 3` = 0.4 % of a lobe's peak at worst, and far less at the median.
const TEXEL_WIDTHS: f64 = 0.5;

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
            gpu: true,
            memory_mib: 8192,
        }
    }
}

/// A whole study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Study {
    /// What was asked.
    pub config: StudyConfig,
    /// Threads that builds used; evaluation is timed on one and on all.
    pub threads: usize,
    /// Share of a matt surface's luminance up to which directions are left out.
    pub floor_share: f64,
    /// The GPU that evaluation was timed on, or why there was none.
    pub gpu: String,
    /// One entry per specimen that could be studied.
    pub specimens: Vec<SpecimenStudy>,
    /// Specimens that could not, with the reason.
    pub failures: Vec<Refusal>,
}

/// Something that was refused, and why.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Refusal {
    /// A specimen, or a method with its setting.
    pub what: String,
    /// The program's own message.
    pub message: String,
}

/// Everything measured on one specimen.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpecimenStudy {
    /// Name of the specimen.
    pub name: String,
    /// Samples along x and y of the first scan.
    pub samples: [usize; 2],
    /// Standard deviation of the coherence window in nm: the manifest's, or what the grid resolves.
    pub sigma_nm: f64,
    /// Radius in (u, v) that the scan's sampling answers for; directions beyond are not compared.
    pub usable_radius: f64,
    /// Luminance in 1/sr up to which directions are left out of pointwise errors.
    pub floor_per_sr: f64,
    /// What the closed forms were fitted to.
    pub statistics: SurfaceStatistics,
    /// Digits that cancel in the published method's series.
    pub taylor_digits_lost: f64,
    /// Tables that the published method needs for 1e-3.
    pub taylor_terms: usize,
    /// One row per method and setting.
    pub methods: Vec<MethodRow>,
    /// One row per knob and setting.
    pub knobs: Vec<KnobRow>,
    /// The published method and ours at equal error.
    pub equal: Vec<EqualError>,
    /// What automatic settings make of a tolerance, under the manifest's own light.
    pub tolerances: Vec<ToleranceRow>,
    /// Settings that were refused.
    pub refusals: Vec<Refusal>,
}

/// One method at one setting.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodRow {
    /// Family: rows of one family are joined in plots.
    pub method: String,
    /// What was set, such as "8 tables".
    pub setting: String,
    /// Expansion, for tables.
    pub basis: Option<Basis>,
    /// Number format, for tables.
    pub storage: Option<Storage>,
    /// Seconds to build or fit; what must be done once.
    pub build_s: f64,
    /// Seconds per direction in a batch on one thread; tables with cubic look-ups, with which errors are measured.
    pub evaluate_s: f64,
    /// Wall seconds per direction with all threads at work.
    pub all_threads_s: f64,
    /// Seconds per direction on one thread with linear look-ups, for tables.
    pub bilinear_s: Option<f64>,
    /// Seconds per direction on the GPU, linear look-ups; for half tables where there is a GPU.
    pub gpu_s: Option<f64>,
    /// Memory that building took on top of what the process held, in bytes, where the system tells.
    pub peak_bytes: Option<u64>,
    /// Bytes a renderer has to hold.
    pub stored_bytes: u64,
    /// Errors by region.
    pub errors: Vec<RegionErrors>,
    /// Errors where (u, v) lies on texels, over the hemisphere: without the grid's share.
    pub on_texels: ErrorQuantiles,
    /// `∫ Y cos_o dω_o` at normal incidence over the usable disc: the share of power sent back. `None` for
    /// methods too slow to integrate.
    pub power_sum: Option<f64>,
    /// Colour differences in every scene, against the picture straight from the transforms.
    pub colours: Vec<SceneColour>,
    /// The pictures; of the reference in the row of the transforms.
    #[serde(skip)]
    pub pictures: Vec<Picture>,
}

/// How a method's picture of a scene differs in colour: CIEDE2000.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneColour {
    /// The scene.
    pub scene: String,
    /// Pixels compared.
    pub pixels: usize,
    /// Mean.
    pub mean: f64,
    /// 95th percentile.
    pub p95: f64,
    /// Largest.
    pub max: f64,
}

/// A small picture for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The scene.
    pub scene: String,
    /// sRGB, `[rows, columns, 3]`.
    pub rgb: Array3<u8>,
}

/// Errors over the directions of one region.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RegionErrors {
    /// Which directions.
    pub region: Region,
    /// `‖Y - Y_ref‖ / ‖Y_ref‖`, directions below the floor included.
    pub relative_l2: f64,
    /// Pointwise relative errors above the floor.
    pub quantiles: ErrorQuantiles,
}

/// One knob changed alone, everything else at its finest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KnobRow {
    /// The knob: "basis", "wavelength step", "grid, bilinear", "grid, cubic", "storage", "windows".
    pub knob: String,
    /// Its value for the axis of a plot: tables, nm, texels; 0 where it is not a number.
    pub value: f64,
    /// The setting for people.
    pub setting: String,
    /// Errors of Y over the whole hemisphere, above the floor.
    pub quantiles: ErrorQuantiles,
}

/// Studies specimens one after another; one that fails never stops the others. `gpu` is one to time evaluation on, or
/// why there is none.
pub fn run_study(
    specimens: &[StudySpecimen],
    config: &StudyConfig,
    gpu: std::result::Result<&dyn GpuClock, &str>,
    progress: &dyn Progress,
) -> Study {
    let mut study = Study {
        config: config.clone(),
        threads: rayon::current_num_threads(),
        floor_share: FLOOR_SHARE,
        gpu: gpu.map_or_else(String::from, GpuClock::adapter),
        specimens: Vec::new(),
        failures: Vec::new(),
    };
    for specimen in specimens {
        match study_specimen(specimen, config, gpu.ok(), progress) {
            Ok(result) => study.specimens.push(result),
            Err(error) => {
                study.failures.push(Refusal { what: specimen.name.clone(), message: error.to_string() });
            }
        }
        progress.finish();
    }
    study
}

fn study_specimen(
    specimen: &StudySpecimen,
    config: &StudyConfig,
    gpu: Option<&dyn GpuClock>,
    progress: &dyn Progress,
) -> Result<SpecimenStudy> {
    let stage = |what: &str, steps: u64| {
        progress.finish();
        progress.stage(&format!("{}: {what}", specimen.name), steps);
    };
    let fields = &specimen.fields;
    let optics = study_optics(&specimen.optics, fields, config.size);
    stage("direct sum", sample::count(config.directions));
    let sample = sample::Sample::measured(fields, &optics, [config.directions, config.size], progress)?;
    stage("reference pictures", 0);
    let (spectra, transforms) = methods::transforms(fields, &optics, config)?;
    let pictures = pictures::Pictures::of(specimen, &optics, &spectra)?;
    let statistics = surface_statistics(fields);
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    let s_max = 2.0 * std::f64::consts::TAU / low_nm;
    let forecast = diffraction_build::tables::taylor::forecast(fields, s_max, 1e-3);
    let (optics, sample, pictures, spectra) = (&optics, &sample, &pictures, &spectra[..]);
    let clock = &Clock::new()?;
    let context = methods::Context { fields, optics, config, sample, spectra, pictures, clock, gpu, progress };
    stage("methods", methods::count(config));
    let mut rows = context.rows(&statistics, transforms)?;
    stage("equal error", equal::count(config));
    let equal = equal::rows(specimen, &context, &mut rows.refusals)?;
    stage("knobs", knobs::count(config));
    let knobs = knobs::rows(&context)?;
    stage("tolerances", config.tolerances.len() as u64);
    let tolerances = tolerance::rows(specimen, config, &|| progress.advance(1))?;
    Ok(SpecimenStudy {
        name: specimen.name.clone(),
        samples: fields.first().map_or([0; 2], HeightField::size),
        sigma_nm: optics.sigma_nm,
        usable_radius: fields.iter().map(|f| usable_radius(optics, f.pitch_nm)).fold(2.0, f64::min),
        floor_per_sr: sample.floor_per_sr,
        statistics,
        taylor_digits_lost: forecast.digits_lost,
        taylor_terms: forecast.terms,
        methods: rows.methods,
        knobs,
        equal,
        tolerances,
        refusals: rows.refusals,
    })
}

/// The specimen's optics with one window inside the scan, no wider than a grid of `size` resolves. Such a window
/// sees only its own patch, so that even the direct sum is quick.
fn study_optics(optics: &OpticsConfig, fields: &[HeightField], size: usize) -> OpticsConfig {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    let resolved_width = 4.0 / (size - 1) as f64 / TEXEL_WIDTHS;
    // The lobe's width is inversely proportional to σ.
    let resolved_nm = lobe_width(1.0, low_nm) / resolved_width;
    let extents = fields.iter().flat_map(HeightField::extent_nm);
    let inside_nm = extents.fold(f64::MAX, f64::min) / (2.0 * FADE_SIGMAS);
    OpticsConfig {
        sigma_nm: optics.sigma_nm.min(resolved_nm).min(inside_nm),
        edge: Edge::Fade,
        windows: Windows::Centre,
        ..optics.clone()
    }
}
