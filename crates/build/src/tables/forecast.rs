//! What building a table set will take, from its plan alone.

use serde::Serialize;

use super::accumulate::{LANES_PER_PASS, SIMD_WIDTH, WAVELENGTHS_PER_PASS};
use super::coverage::shares::RING_SHARE;
use super::input::BuildInput;
use super::lobe;
use super::look_ups::{LookUpForecast, look_up_forecasts};
use super::model::Storage;
use super::order;
use super::plan::{BuildPlan, plan};
use super::resolution::nodes_expected;
use super::rings::Ring;
use super::rounding;
use super::work::{RingWork, WindowWork, window_works};
use crate::optics::window::speckle_deviation;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::Result;

/// What a build will take.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Forecast {
    /// Windows averaged.
    pub windows: usize,
    /// By how much their mean still moves at one wavelength, on a rough surface: see [`speckle_deviation`].
    pub speckle_deviation: f64,
    /// Transforms per window.
    pub transforms: usize,
    /// Tables, estimated from the heights' spread.
    pub tables: usize,
    /// Texels along u and v.
    pub size: usize,
    /// Smallest wavelength step in nm; `None` for a single line.
    pub step_min_nm: Option<f64>,
    /// Texels computed.
    pub texels: u64,
    /// Texels times wavelengths.
    pub samples: f64,
    /// Texels times wavelengths times nodes in `w`.
    pub node_samples: f64,
    /// Predicted seconds.
    pub seconds: f64,
    /// Predicted peak memory in bytes.
    pub memory_bytes: u64,
    /// Bytes while a window is transformed alone, as for the reference.
    pub transforms_bytes: u64,
    /// Bytes of a table in memory.
    pub table_bytes: u64,
    /// Predicted bytes of the table files before compression.
    pub stored_bytes: u64,
    /// Number format, where not asked for the likely one: what the tables lose decides once they are built.
    pub storage: Storage,
    /// Whether it was asked for.
    pub storage_asked: bool,
    /// What look-ups between the texels will err by.
    pub look_ups: [LookUpForecast; 3],
}

/// Nanoseconds per elementary operation on one thread, measured on a server processor of 2023; another machine scales all
/// predictions alike. They predict, and decide nothing.
const NS_PER_FFT_POINT: f64 = 12.0;
const NS_PER_LINE_NODE: f64 = 0.6;
const NS_PER_LANE_TAP: f64 = 0.6;
const NS_PER_LANE_SUM: f64 = 2.0;
const NS_PER_KERNEL_VALUE: f64 = 8.0;
const NS_PER_WAVE: f64 = 2e4;
const NS_PER_COMPLEX_PRODUCT: f64 = 0.6;
const NS_PER_TEXEL_AND_TABLE: f64 = 60.0;

/// What a build takes besides: threads woken, memory fetched, files of one texel.
const FIXED_NS: f64 = 1e7;

/// For each texel and wavelength of the coherent table.
const NS_PER_LOBE_SAMPLE: f64 = 12.0;

/// Predicts a build for every direction.
///
/// # Errors
/// Those of planning.
pub fn forecast(input: &BuildInput, threads: usize) -> Result<Forecast> {
    Ok(forecast_of(input, &plan(input)?, threads))
}

/// Predicts what [`super::build::build_planned`] will take.
pub fn forecast_of(input: &BuildInput, plan: &BuildPlan, threads: usize) -> Forecast {
    let windows = window_works(input, &plan.windows, &plan.spectra, plan.filter.samples);
    let tables = input.tables.count.unwrap_or_else(|| expected_tables(input, plan));
    let nodes = ring_nodes(input, plan, tables);
    let samples = plan.ring_samples();
    let texels = plan.texels.window_texels() as f64;
    let counted = match &plan.coverage {
        None => std::f64::consts::FRAC_PI_4 * texels,
        Some(coverage) => coverage.count() as f64,
    };
    let work_ns = transforms_ns(input, plan, &windows)
        + sums_ns(plan, &windows, &nodes)
        // Values at the nodes become coefficients; the lobe is a table of its own.
        + counted * tables as f64 * NS_PER_TEXEL_AND_TABLE
        + lobe_ns(input, plan);
    let storage = rounding::expected(input.tables.storage, input.tables.tolerance);
    let value_bytes = if storage == Storage::Half { 2.0 } else { 4.0 };
    let steps = plan.rings.iter().flat_map(|r| r.quadrature.wavelengths_nm.windows(2).map(|p| (p[0] - p[1]).abs()));
    // Halves, whatever the tables are.
    let range_bytes = if plan.coverage.is_some() { texels * 3.0 * 2.0 } else { 0.0 };
    let in_groups = |nodes: usize| nodes.next_multiple_of(SIMD_WIDTH) as f64;
    Forecast {
        windows: plan.windows.len(),
        speckle_deviation: speckle_deviation(&plan.windows, input.optics.sigma_nm),
        transforms: windows.first().map_or(0, |window| window.transforms as usize),
        tables,
        size: plan.texels.grid.size,
        texels: counted as u64,
        step_min_nm: steps.reduce(f64::min),
        samples: samples.iter().sum(),
        node_samples: samples.iter().zip(&nodes).map(|(samples, &nodes)| samples * in_groups(nodes)).sum(),
        seconds: 1e-9 * (FIXED_NS + work_ns / threads as f64),
        memory_bytes: memory_bytes(plan, &windows, &nodes, tables) as u64,
        transforms_bytes: windows.iter().map(transforming_bytes).fold(0.0, f64::max) as u64,
        table_bytes: (plan.texels.window_texels() * plan.channels * size_of::<f32>()) as u64,
        stored_bytes: (counted * plan.channels as f64 * value_bytes * tables as f64 + range_bytes) as u64,
        storage,
        storage_asked: input.tables.storage.is_some(),
        look_ups: look_up_forecasts(input.optics, plan.texels.grid.size, input.tables.tolerance),
    }
}

/// Transforms, and the order estimator on the first of them.
fn transforms_ns(input: &BuildInput, plan: &BuildPlan, windows: &[WindowWork]) -> f64 {
    let of_window = |WindowWork { padded, lines, transforms, .. }: &WindowWork| {
        // Along x every line is transformed, along y only the wanted ones.
        transforms * 0.5 * (padded[0] * padded[1] + lines[0] * padded[1]) * NS_PER_FFT_POINT
    };
    let first = windows.first().filter(|_| input.tables.count.is_none());
    windows.iter().map(of_window).sum::<f64>() + first.map_or(0.0, |window| order_ns(plan, window))
}

/// The sums of all windows over all rings, each with its nodes.
fn sums_ns(plan: &BuildPlan, windows: &[WindowWork], nodes: &[usize]) -> f64 {
    let of_ring = |(ring, &nodes): (&Ring, &usize)| -> f64 {
        let texels = plan.texels.count_within(ring.radius) as f64;
        windows.iter().map(|window| ring_ns(&window.ring(ring, texels, &plan.texels.grid), nodes)).sum()
    };
    plan.rings.iter().zip(nodes).map(of_ring).sum()
}

/// The coherent table; at a single wavelength the lobe is a row of numbers.
fn lobe_ns(input: &BuildInput, plan: &BuildPlan) -> f64 {
    if !plan.lobe_seen || input.is_grey {
        return 0.0;
    }
    // An invisible light has been refused before there was a plan.
    NS_PER_LOBE_SAMPLE * lobe::samples(input, plan.lobe_radius, plan.t_in_lobe()).unwrap_or(0.0)
}

/// Most bytes on the heap at once: while a window is transformed, while it is summed, or while the sums become tables.
fn memory_bytes(plan: &BuildPlan, windows: &[WindowWork], nodes: &[usize], tables: usize) -> f64 {
    let numbers = (plan.texels.window_texels() * plan.channels * size_of::<f32>()) as f64;
    let sums = numbers * nodes.iter().copied().max().unwrap_or(tables).next_multiple_of(SIMD_WIDTH) as f64;
    // Sums and tables stand side by side, the transforms are gone.
    let mut most = sums + numbers * tables as f64;
    for (index, window) in windows.iter().enumerate() {
        let sums_before = if index == 0 { 0.0 } else { sums };
        let of_ring = |(ring, &nodes): (&Ring, &usize)| scratch_bytes(plan, window, ring, nodes);
        let scratch = plan.rings.iter().zip(nodes).map(of_ring).fold(0.0, f64::max);
        most = most.max(transforming_bytes(window) + sums_before).max(transforms_bytes(window) + sums + scratch);
    }
    most
}

/// The transforms of a window.
fn transforms_bytes(WindowWork { lines, transforms, .. }: &WindowWork) -> f64 {
    8.0 * lines[0] * lines[1] * transforms
}

/// The same while they come about: heights and phasors of the samples; lines between the two passes, and after them.
fn transforming_bytes(window: &WindowWork) -> f64 {
    let WindowWork { samples, lines, .. } = window;
    transforms_bytes(window)
        + (8.0 + 16.0) * samples[0] * samples[1]
        + 16.0 * (samples[1] * lines[0] + lines[0] * lines[1])
}

/// What summing a ring holds besides: for a few wavelengths at once, every line that its texels read, interpolated to its
/// columns, with up to four lanes of four nodes each.
fn scratch_bytes(plan: &BuildPlan, window: &WindowWork, ring: &Ring, nodes: usize) -> f64 {
    let WindowWork { step, taps, parts, box_samples, .. } = window;
    let texel = plan.texels.grid.texel();
    let extent = |texels: usize| (2.0 * ring.radius[1]).min(texels as f64 * texel);
    let lines = extent(plan.texels.rows.len()) / (plan.wavelength_min_nm * step[1]) + taps[1];
    let columns = extent(plan.texels.columns.len()) / texel * box_samples;
    let lanes = (nodes.div_ceil(SIMD_WIDTH) as f64).min(LANES_PER_PASS as f64) * parts;
    // It is allocated with up to an eighth to spare.
    17.0 / 16.0 * WAVELENGTHS_PER_PASS.min(ring.wavelengths()) as f64 * lines * columns * lanes * 16.0
}

/// Rms heights of a ring's texels, of that of all: few of them lie where the relief is deepest.
const RING_ROUGHNESS: f64 = 0.77;

/// Nodes that each ring will likely have, for so many tables.
fn ring_nodes(input: &BuildInput, plan: &BuildPlan, tables: usize) -> Vec<usize> {
    let of_ring = |ring: &Ring| match &plan.coverage {
        None => tables,
        Some(_) => {
            let tolerance = RING_SHARE * input.tables.tolerance;
            expected_nodes(plan, RING_ROUGHNESS * input.rms_nm, ring.abs_w, tolerance).max(tables)
        }
    };
    plan.rings.iter().map(of_ring).collect()
}

/// One window's sums over a ring with so many nodes, on one thread.
fn ring_ns(work: &RingWork, nodes: usize) -> f64 {
    let in_lanes =
        NS_PER_LINE_NODE * work.line_products + NS_PER_LANE_TAP * work.tap_products + NS_PER_LANE_SUM * work.powers;
    NS_PER_WAVE * work.wavelengths
        + NS_PER_KERNEL_VALUE * work.kernel_values
        + nodes.div_ceil(SIMD_WIDTH) as f64 * in_lanes
}

/// The order estimator: every tested texel at all its wavelengths and fine nodes, once per tap where powers are summed.
fn order_ns(plan: &BuildPlan, window: &WindowWork) -> f64 {
    let WindowWork { taps: [x, y], transforms, parts, .. } = window;
    let wavelengths: usize = plan.rings.iter().map(Ring::wavelengths).sum();
    let each = wavelengths as f64 / plan.rings.len() as f64;
    let fine = plan.nodes_bound as f64;
    let products = if *parts == 1.0 { x * y * fine } else { x * y + fine };
    order::TEXELS as f64 * each * products * transforms * NS_PER_COMPLEX_PRODUCT
}

/// Tables that dim directions ask for besides, in which a relative error is small by nothing: at one wavelength, and under a light of many.
const MORE_AT_ONE: usize = 3;
const MORE_UNDER_MANY: usize = 1;

/// Tables that the order estimator will likely choose.
fn expected_tables(input: &BuildInput, plan: &BuildPlan) -> usize {
    let (rms_nm, tolerance) = (input.rms_nm, input.tables.tolerance);
    let Some(coverage) = &plan.coverage else {
        // At one wavelength no sum averages errors out.
        let more = if plan.rings.iter().all(|ring| ring.wavelengths() == 1) { MORE_AT_ONE } else { MORE_UNDER_MANY };
        return (expected_nodes(plan, rms_nm, [0.0, max_abs_w(0.0)], tolerance) + more).min(plan.nodes_bound).max(2);
    };
    // As many as the widest ranges but one in twenty need.
    let ranges = coverage.iter().map(|(row, column, t)| coverage.abs_w_at(row, column, t));
    let mut lengths: Vec<f64> = ranges.map(|[low, high]| high - low).collect();
    let at = lengths.len() * 19 / 20;
    let length = if lengths.is_empty() { 0.0 } else { *lengths.select_nth_unstable_by(at, f64::total_cmp).1 };
    expected_nodes(plan, rms_nm, [0.0, length], tolerance)
}

/// Nodes that a range of `|w|` will likely need.
fn expected_nodes(plan: &BuildPlan, rms_nm: f64, [low, high]: [f64; 2], tolerance: f64) -> usize {
    nodes_expected(rms_nm, plan.wavelength_min_nm, high - low, tolerance).min(plan.nodes_bound)
}
