//! The study: every method over its settings, its errors against the direct sum, its time, memory and bytes.
//!
//! All methods answer the same question on the same directions: one coherence window, no prefilter, and a
//! window no wider than the tables' grid resolves, so that methods are compared and not their filters.

mod batch;
mod config;
mod equal;
mod knobs;
mod lent;
mod lights;
mod methods;
mod pictures;
mod rows;
mod sample;
mod texels;
mod timing;
mod tolerance;
mod wave_methods;

pub use batch::stored;
pub use config::{StudyConfig, StudySpecimen, TOLERANCES};
pub use equal::{Contender, EqualError, Filed, Measure};
pub use lent::{FrameOfLight, GpuClock, LightPicture, LightScene, LookUps, SceneSamples};
pub use lights::{DIAMETERS_DEG, LightFrames, LightRow, Lights};
pub use methods::PURPOSES;
pub use rows::{KnobRow, MethodRow, Picture, Refusal, RegionErrors, SceneColour};
pub use sample::pair_of;
pub use tolerance::{Kept, ToleranceRow, automatic, row as tolerance_row};

use timing::Clock;

use serde::{Deserialize, Serialize};

use crate::baselines::statistics::{SurfaceStatistics, surface_statistics};
use crate::error::Result;
use diffraction_build::accuracy::directions::FLOOR_SHARE;
use diffraction_build::ground::progress::Progress;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::optics::window::FADE_SIGMAS;
use diffraction_build::tables::resolution::{lobe_width, usable_radius};

/// Standard deviations of the narrowest lobe per texel of the study's tables: cubic interpolation then errs by
/// about `3/128 · 0.5⁴ · 3` = 0.4 % of a lobe's peak at worst, and far less at the median.
const TEXEL_WIDTHS: f64 = 0.5;

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
    pub(crate) statistics: SurfaceStatistics,
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
    /// Pictures and frames under lights with a size, under the manifest's own light.
    pub lights: Lights,
    /// Settings that were refused.
    pub refusals: Vec<Refusal>,
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
    if specimen.optics.front_factor().polarised([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).is_some() {
        return Err(diffraction_brdf::error::Error::Call(
            "the methods of a study are compared under the scalar front factor, the only one that the published series has: \
             set the factor of its optics to scalar"
                .into(),
        )
        .into());
    }
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
    stage("methods", methods::count(config) + wave_methods::count(config) as u64);
    let mut rows = context.rows(&statistics, transforms)?;
    rows.methods.extend(context.wave_rows()?);
    stage("equal error", equal::count(config));
    let equal = equal::rows(specimen, &context, &mut rows.refusals)?;
    stage("knobs", knobs::count(config));
    let knobs = knobs::rows(&context)?;
    stage("tolerances", config.tolerances.len() as u64);
    let tolerances = tolerance::rows(specimen, config, &|| progress.advance(1))?;
    stage("lights", lights::count(specimen));
    let lights = lights::lights(specimen, config, gpu, &mut rows.refusals, &|| progress.advance(1))?;
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
        lights,
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
