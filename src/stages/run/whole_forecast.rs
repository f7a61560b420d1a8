//! What a whole run will take, stage by stage, from plans alone.

use serde::Serialize;

use super::reference_forecast::ReferenceForecast;
use crate::stages::config::{FrameTiming, GpuCheck, RunConfig};
use diffraction_build::tables::forecast::Forecast;
use diffraction_render::scene::model::Scene;

/// Nanoseconds on one thread of the machine that `tables::forecast` speaks of, fitted to runs of the bundled specimens, of eight real
/// scans and of one small one. Another machine scales them alike (`ground::speed`).
const NS_PER_SAMPLE_READ: f64 = 300.0;
/// Counting texels, rounding, storing, reading back: for each number of a table.
const NS_PER_VALUE_STORED: f64 = 120.0;
const NS_PER_SPECTRAL_VALUE: f64 = 130.0;
const NS_PER_PIXEL: f64 = 3000.0;
const NS_PER_LOOK_UP: f64 = 8.0;
/// What the forecast of the reference leaves out: the direct sum that it is held against.
const REFERENCE_FACTOR: f64 = 1.15;
/// Errors take a part that does not change, one for each table, and one for each sample of the scans.
const ERRORS_NS: [f64; 3] = [0.15e9, 0.04e9, 1400.0];
const SPECTRAL_ERRORS_NS: [f64; 2] = [0.08e9, 240.0];
const LOOK_AROUND_NS: f64 = 0.15e9;
const WRITE_NS: [f64; 2] = [0.12e9, 0.04e9];
/// A software driver on the processor: its start, each specimen, each scene, what is sent there, and timing frames. Hardware takes a part of it.
const GPU_START_NS: f64 = 2e9;
const GPU_SPECIMEN_NS: f64 = 0.4e9;
const GPU_SCENE_NS: f64 = 0.7e9;
/// For each number of a table that is sent there.
const GPU_NS_PER_VALUE: f64 = 200.0;
const GPU_FRAMES_NS: f64 = 5.5e9;

/// Share of a picture's pixels that show the object.
const SEEN: f64 = 0.7;

/// A part of a run and the seconds of one thread that it takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Part {
    /// What is done.
    pub what: &'static str,
    /// Seconds on this machine.
    pub seconds: f64,
}

/// What is known of a specimen before it is made.
#[derive(Debug, Clone, Copy)]
pub struct Known<'a> {
    /// Samples of all its scans.
    pub samples: usize,
    /// Its tables; of spectral ones alone, those.
    pub tables: &'a Forecast,
    /// Its spectral tables, where there are both kinds.
    pub spectral: Option<&'a Forecast>,
    /// Its reference, where one is asked for.
    pub reference: Option<ReferenceForecast>,
    /// What is pictured.
    pub scenes: &'a [Scene],
}

/// Parts of making a specimen, on `threads` threads of a machine that takes `slowdown` times as long.
pub fn specimen_parts(config: &RunConfig, known: &Known, threads: usize, slowdown: f64) -> Vec<Part> {
    let Known { samples, tables, spectral, reference, scenes } = *known;
    let on_all = |forecast: &Forecast| 1e9 * forecast.seconds * threads as f64;
    let values = |forecast: &Forecast, channels: f64| channels * forecast.texels as f64 * forecast.tables as f64;
    let pictures = scenes.iter().map(|scene| picture_ns(scene, tables.tables)).sum::<f64>();
    let mut parts = vec![
        ("reading scans", samples as f64 * NS_PER_SAMPLE_READ),
        ("tables", on_all(tables) + values(tables, 3.0) * NS_PER_VALUE_STORED),
        ("looking around", LOOK_AROUND_NS),
        ("pictures", pictures + WRITE_NS[0] + WRITE_NS[1] * scenes.len() as f64),
    ];
    if let Some(spectral) = spectral {
        parts.push(("spectral tables", on_all(spectral) + values(spectral, 1.0) * NS_PER_SPECTRAL_VALUE));
    }
    if let Some(reference) = reference {
        let [fixed_ns, sample_ns] = SPECTRAL_ERRORS_NS;
        let of_spectral = if spectral.is_some() { fixed_ns + sample_ns * samples as f64 } else { 0.0 };
        let [fixed_ns, table_ns, sample_ns] = ERRORS_NS;
        let of_tables = fixed_ns + table_ns * tables.tables as f64 + sample_ns * samples as f64;
        parts.push(("the reference", REFERENCE_FACTOR * 1e9 * reference.seconds * threads as f64));
        parts.push(("errors", of_tables + of_spectral));
    }
    if config.gpu != GpuCheck::Off {
        parts.push((
            "the check on the GPU",
            GPU_SPECIMEN_NS + GPU_SCENE_NS * scenes.len() as f64 + GPU_NS_PER_VALUE * values(tables, 3.0),
        ));
    }
    parts.into_iter().map(|(what, ns)| Part { what, seconds: 1e-9 * ns * slowdown / threads as f64 }).collect()
}

/// Parts that a run has once.
pub fn shared_parts(config: &RunConfig, threads: usize, slowdown: f64) -> Vec<Part> {
    let is_pictured = config.gpu != GpuCheck::Off && !config.scenes.is_empty();
    let frames = if config.frame_time == FrameTiming::On { GPU_FRAMES_NS } else { 0.0 };
    let ns = if is_pictured { GPU_START_NS + frames } else { 0.0 };
    [("the check on the GPU", ns)]
        .into_iter()
        .filter(|(_, ns)| *ns > 0.0)
        .map(|(what, ns)| Part { what, seconds: 1e-9 * ns * slowdown / threads as f64 })
        .collect()
}

/// A picture from the tables, with its frames where it is animated.
fn picture_ns(scene: &Scene, tables: usize) -> f64 {
    let of_side = |side_px: usize| SEEN * (side_px * side_px) as f64;
    let frames = scene.animation.map_or(0.0, |animation| animation.frames as f64 * of_side(animation.size_px));
    let pixels = of_side(scene.size_px) + frames;
    let lights = scene.lights.len() + usize::from(scene.environment.is_some());
    let look_ups = pixels * (lights.max(1) * scene.light_samples.max(scene.pixel_samples) * tables) as f64;
    pixels * NS_PER_PIXEL + look_ups * NS_PER_LOOK_UP
}

/// All parts of one kind together, the longest first.
pub fn summed(parts: impl IntoIterator<Item = Part>) -> Vec<Part> {
    let mut sums: Vec<Part> = Vec::new();
    for part in parts {
        match sums.iter_mut().find(|sum| sum.what == part.what) {
            Some(sum) => sum.seconds += part.seconds,
            None => sums.push(part),
        }
    }
    sums.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
    sums
}
