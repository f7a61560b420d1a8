//! What evaluating the reference will take, from plan and scenes alone.

use serde::Serialize;

use crate::stages::pictures::scenes::pairs_of;
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::{Vec3, wave_vector_change};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::accuracy::directions::{ABOVE_PER_BELOW, DIRECTIONS};
use diffraction_build::ground::sampling::{Region, direction_pairs_in};
use diffraction_build::optics::kernel::SEMICIRCLE_TAPS;
use diffraction_build::optics::lines::lines_fetched;
use diffraction_build::optics::reference::{FULL_STEP, PICTURE_STEP, WavenumberStep, resolving_count};
use diffraction_build::optics::spectra::{LineCounts, half_height_range_nm, line_counts};
use diffraction_build::optics::window::Placement;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::plan::BuildPlan;
use diffraction_render::scene::samples::ShadingSamples;

/// What the reference of one specimen will take, with nothing of it known from earlier runs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ReferenceForecast {
    /// Pairs of directions of all pictures: those that a run evaluates.
    pub picture_pairs: u64,
    /// Pairs on which errors are counted, where as many are above the luminance floor as are asked for.
    pub error_pairs: u64,
    /// Pairs times wavelengths times windows.
    pub evaluations: f64,
    /// Predicted seconds.
    pub seconds: f64,
}

/// Nanoseconds on one thread, on the processor that `tables::forecast` speaks of: for each sample and node transformed;
/// for each evaluation, whatever it reads; for its node weights; for a node of a line that enters one sum, or four in step;
/// and for windows inside a scan, for each value of their kernel and each of their samples, which their transform sums.
const NS_PER_SAMPLE_AND_NODE: f64 = 30.0;
const NS_PER_EVALUATION: f64 = 80.0;
const NS_PER_NODE: f64 = 3.0;
const NS_PER_LINE_NODE: f64 = 0.45;
const NS_PER_SHARED_LINE_NODE: f64 = 0.75;
const NS_PER_KERNEL_VALUE: f64 = 8.0;
const NS_PER_WINDOW_SAMPLE: f64 = 0.55;

/// Predicts the evaluation of the reference, given the samples of all pictures and the likely number of tables.
pub fn reference_forecast(
    input: &BuildInput,
    plan: &BuildPlan,
    tables: usize,
    pictures: &[&ShadingSamples],
    threads: usize,
) -> ReferenceForecast {
    let [low, high] = plan.spectra.phase_scale_per_nm;
    let nodes = chebyshev::nodes_for_exponential(plan.half_height_range_nm, high - low, plan.spectra.tolerance) as f64;
    let counted = counted_pairs(plan, pictures);
    let mut forecast = ReferenceForecast {
        picture_pairs: pictures.iter().map(|samples| samples.wi.len() as u64).sum(),
        error_pairs: counted.len() as u64,
        evaluations: 0.0,
        seconds: 0.0,
    };
    let mut work_ns = 0.0;
    for &(scan, placement) in &plan.windows {
        let field = &input.fields[scan];
        let counts = line_counts(field, placement, input.optics.least_sigma_nm(), plan.spectra.frequency);
        let own_ns = match placement {
            Placement::Inside { .. } => {
                (2 * SEMICIRCLE_TAPS) as f64 * NS_PER_KERNEL_VALUE
                    + counts.samples.iter().sum::<usize>() as f64 * NS_PER_WINDOW_SAMPLE
            }
            Placement::TileCentre | Placement::TileMean => 0.0,
        };
        let evaluation_ns = NS_PER_EVALUATION + own_ns;
        let window = Window { input, counts, nodes, half_range_nm: half_height_range_nm(field), evaluation_ns };
        work_ns += nodes * counts.padded.iter().product::<usize>() as f64 * NS_PER_SAMPLE_AND_NODE;
        let mut add = |(evaluations, ns): (f64, f64), times: f64| {
            forecast.evaluations += times * evaluations;
            work_ns += times * ns;
        };
        for pair in pictures.iter().flat_map(|samples| pairs_of(samples)) {
            add(window.pair(pair, PICTURE_STEP), 1.0);
        }
        for &pair in &counted {
            // With the coherent part and without, and with the tables' own wavelengths at all their nodes.
            add(window.pair(pair, FULL_STEP), 2.0);
            add(window.tables(plan, pair), (tables + 1) as f64);
        }
    }
    forecast.seconds = 1e-9 * work_ns / threads as f64;
    forecast
}

/// Pairs as those on which errors are counted: which they are, the tables decide.
fn counted_pairs(plan: &BuildPlan, pictures: &[&ShadingSamples]) -> Vec<(Vec3, Vec3)> {
    let count = DIRECTIONS + DIRECTIONS.div_ceil(ABOVE_PER_BELOW);
    if plan.coverage.is_none() {
        return Region::ALL.into_iter().flat_map(|region| direction_pairs_in(region, 0..count)).collect();
    }
    let of_picture = |samples: &&ShadingSamples| {
        let step = samples.wi.len().div_ceil(count).max(1);
        pairs_of(samples).step_by(step).collect::<Vec<_>>()
    };
    pictures.iter().flat_map(of_picture).collect()
}

/// One window, as far as it decides what an evaluation takes.
struct Window<'a> {
    input: &'a BuildInput<'a>,
    counts: LineCounts,
    nodes: f64,
    half_range_nm: f64,
    /// Nanoseconds of an evaluation, whatever it reads.
    evaluation_ns: f64,
}

impl Window<'_> {
    /// Evaluations of a pair at all its wavelengths, and their nanoseconds.
    fn pair(&self, (wi, wo): (Vec3, Vec3), step: WavenumberStep) -> (f64, f64) {
        let optics = self.input.optics;
        if optics.front_factor().diffuse(wi, wo) == 0.0 {
            return (0.0, 0.0);
        }
        let q = wave_vector_change(wi, wo);
        let count = match &optics.illuminant {
            Illuminant::Lines(lines) => lines.len(),
            _ => resolving_count(optics, q, self.half_range_nm, step),
        };
        self.wavelengths(q, count)
    }

    /// The same at one `|w|` with the wavelengths of the tables.
    fn tables(&self, plan: &BuildPlan, (wi, wo): (Vec3, Vec3)) -> (f64, f64) {
        let q = wave_vector_change(wi, wo);
        plan.ring_at(q[0].hypot(q[1])).map_or((0.0, 0.0), |ring| self.wavelengths(q, ring.wavelengths()))
    }

    fn wavelengths(&self, q: Vec3, count: usize) -> (f64, f64) {
        let [low_nm, high_nm] = self.input.wavelength_range_nm;
        let step = (1.0 / low_nm - 1.0 / high_nm) / count.saturating_sub(1).max(1) as f64;
        let (lines, sums) = lines_fetched(&self.counts, [q[0] * step, q[1] * step]);
        let ns_per_line = if sums == 1 { NS_PER_LINE_NODE } else { NS_PER_SHARED_LINE_NODE };
        let ns = self.evaluation_ns + self.nodes * (NS_PER_NODE + lines * ns_per_line);
        (count as f64, count as f64 * ns)
    }
}
