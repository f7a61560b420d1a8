//! What a whole run will take, stage by stage, from plans alone.

use serde::Serialize;

use super::reference_forecast::ReferenceForecast;
use crate::stages::config::{FrameTiming, GpuCheck, RunConfig};
use diffraction_build::tables::forecast::Forecast;
use diffraction_render::scene::model::{LookUps, Scene};

/// Nanoseconds on one thread of the machine that `tables::forecast` speaks of, fitted to runs of the bundled specimens and of eight real
/// scans. Another machine scales them alike (`ground::speed`).
const READ_NS: f64 = 0.08e9;
const NS_PER_SAMPLE_READ: f64 = 300.0;
/// Counting texels, rounding, storing, reading back: for each number of a table.
const NS_PER_VALUE_STORED: f64 = 65.0;
/// Looking whether the texels that were tried suffice.
const TRIED_NS: f64 = 0.9e9;
const NS_PER_SPECTRAL_VALUE: f64 = 180.0;
/// A look-up in a picture: what it costs whatever the tables, and for each of them.
const NS_PER_LOOK_UP: f64 = 6_000.0;
const NS_PER_TABLE_LOOKED_UP: f64 = 600.0;
/// Splines and coarser levels of the tables that pictures are made of: for each number of a table.
const NS_PER_VALUE_PICTURED: f64 = 90.0;
/// What the forecast of the reference leaves out: the direct sum that it is held against.
const REFERENCE_FACTOR: f64 = 1.15;
/// Errors take a part that does not change, one for each table, and one for each sample of the scans; and a share of the reference,
/// whose directions theirs are among.
const ERRORS_NS: [f64; 3] = [0.25e9, 0.04e9, 1200.0];
const ERRORS_SHARE: f64 = 0.3;
const SPECTRAL_ERRORS_NS: [f64; 2] = [0.08e9, 240.0];
/// The albedo from hundreds of directions, which surfaces that may reflect more than arrives are limited by: for each texel of a table.
const NS_PER_TEXEL_LIMITED: f64 = 340.0;
const LOOK_AROUND_NS: f64 = 0.2e9;
const WRITE_NS: [f64; 2] = [0.25e9, 0.04e9];
/// A software driver on the processor: its start, each specimen, each scene, what is sent there, and timing frames. On hardware most of
/// it remains: the processor's own pictures and the bounds of each pixel.
const GPU_START_NS: f64 = 2e9;
const GPU_SPECIMEN_NS: f64 = 0.4e9;
const GPU_SCENE_NS: f64 = 0.45e9;
/// For each number of a table that is sent there.
const GPU_NS_PER_VALUE: f64 = 75.0;
const GPU_FRAMES_NS: f64 = 13e9;

/// Degrees up to which a light is one look-up: wider ones are divided.
const ONE_LOOK_UP_DEG: f64 = 2.0;

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
    /// Those on fewer texels that are built before and do not suffice.
    pub tried: Option<&'a Forecast>,
    /// Whether its surface may reflect more than arrives, as ideal ones and those under the scalar factor do.
    pub may_exceed: bool,
    /// Its spectral tables, where there are both kinds.
    pub spectral: Option<&'a Forecast>,
    /// Its reference, where one is asked for.
    pub reference: Option<ReferenceForecast>,
    /// What is pictured.
    pub scenes: &'a [Scene],
}

/// Parts of making a specimen, on `threads` threads of a machine that takes `slowdown` times as long.
pub fn specimen_parts(config: &RunConfig, known: &Known, threads: usize, slowdown: f64) -> Vec<Part> {
    let Known { samples, tables, tried, may_exceed, spectral, reference, scenes } = *known;
    let on_all = |forecast: &Forecast| 1e9 * forecast.seconds * threads as f64;
    let values = |forecast: &Forecast, channels: f64| channels * forecast.texels as f64 * forecast.tables as f64;
    let pictures = scenes.iter().map(|scene| picture_ns(scene, tables.tables)).sum::<f64>();
    let made_ready = if scenes.is_empty() { 0.0 } else { values(tables, 3.0) * NS_PER_VALUE_PICTURED };
    let tried_ns = tried.map_or(0.0, |tried| on_all(tried) + TRIED_NS);
    let mut parts = vec![
        ("reading scans", READ_NS + samples as f64 * NS_PER_SAMPLE_READ),
        ("tables", tried_ns + on_all(tables) + values(tables, 3.0) * NS_PER_VALUE_STORED),
        ("looking around", LOOK_AROUND_NS),
        ("pictures", made_ready + pictures + WRITE_NS[0] + WRITE_NS[1] * scenes.len() as f64),
    ];
    if let Some(spectral) = spectral {
        parts.push(("spectral tables", on_all(spectral) + values(spectral, 1.0) * NS_PER_SPECTRAL_VALUE));
    }
    if let Some(reference) = reference {
        let [fixed_ns, sample_ns] = SPECTRAL_ERRORS_NS;
        let of_spectral = if spectral.is_some() { fixed_ns + sample_ns * samples as f64 } else { 0.0 };
        let [fixed_ns, table_ns, sample_ns] = ERRORS_NS;
        let of_tables = fixed_ns + table_ns * tables.tables as f64 + sample_ns * samples as f64;
        let reference_ns = 1e9 * reference.seconds * threads as f64;
        let limit_ns = if may_exceed { values(tables, 1.0) * NS_PER_TEXEL_LIMITED } else { 0.0 };
        parts.push(("the reference", REFERENCE_FACTOR * reference_ns));
        parts.push(("errors", of_tables + ERRORS_SHARE * reference_ns + of_spectral + limit_ns));
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
    let samples = scene.light_samples.max(scene.pixel_samples);
    let of_light = |diameter_deg: f64| match scene.look_ups {
        LookUps::Filtered if diameter_deg <= ONE_LOOK_UP_DEG => 1,
        LookUps::Filtered | LookUps::Points => samples,
    };
    let of_lights: usize = scene.lights.iter().map(|light| of_light(light.angular_diameter_deg)).sum();
    let of_surroundings = if scene.environment.is_some() { samples } else { 0 };
    let look_ups = pixels * (of_lights + of_surroundings).max(1) as f64;
    look_ups * (NS_PER_LOOK_UP + NS_PER_TABLE_LOOKED_UP * tables as f64)
}

/// The same parts of a run under two assumptions, each with the mean of both.
pub fn mean_of(one: &[Part], other: &[Part]) -> Vec<Part> {
    let both = one.iter().chain(other).map(|part| Part { seconds: 0.5 * part.seconds, ..*part });
    summed(both)
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
