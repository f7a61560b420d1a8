//! What building a table set will take, from its plan alone.

use serde::Serialize;

use super::accumulate::{GROUP, LANES_MAX, WAVES};
use super::build::{BuildPlan, lobe_depths, plan, ring_samples};
use super::lobe;
use super::model::{Storage, TablesConfig};
use super::pilot::{self, RING_SHARE};
use super::plan::Ring;
use super::rounding;
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::kernel::{OVERSAMPLING, SEMICIRCLE_TAPS};
use crate::optics::spectra::smooth_size;
use crate::optics::window::{Placement, SUPPORT_SIGMAS, speckle_deviation};
use diffraction_brdf::chebyshev;
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
    /// Predicted bytes of the table files before compression.
    pub stored_bytes: u64,
    /// Number format, where not asked for the likely one: what the tables lose decides once they are built.
    pub storage: Storage,
    /// Whether it was asked for.
    pub storage_asked: bool,
}

/// Nanoseconds per elementary operation on one thread, measured on a server processor of 2023; another
/// machine scales all predictions alike.
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

/// Predicts a build.
///
/// # Errors
/// Those of planning.
pub fn forecast(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &TablesConfig,
    threads: usize,
) -> Result<Forecast> {
    Ok(forecast_of(fields, optics, config, &plan(fields, optics, config)?, threads))
}

/// Predicts what [`super::build::build_planned`] will take.
pub fn forecast_of(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &TablesConfig,
    plan: &BuildPlan,
    threads: usize,
) -> Forecast {
    let depth = plan.spectra.s[1] - plan.spectra.s[0];
    let transforms = chebyshev::nodes_for_exponential(plan.bandwidth_nm, depth, plan.spectra.tolerance);
    let rms = fields.iter().map(super::build::rms_nm).fold(0.0, f64::max);
    let tables = config.count.unwrap_or_else(|| expected_tables(rms, plan, config.tolerance));
    let nodes = ring_nodes(fields, plan, config);
    let samples = ring_samples(plan);
    let windows = window_work(fields, optics, plan);
    let mut work_ns = 0.0;
    for (index, (&(_, placement), window)) in plan.windows.iter().zip(&windows).enumerate() {
        let Lines { padded, lines, taps, .. } = &window.lines;
        // Along x every line is transformed, along y only the wanted ones.
        work_ns += transforms as f64 * 0.5 * (padded[0] * padded[1] + lines[0] * padded[1]) * NS_PER_FFT_POINT;
        if config.count.is_none() && index == 0 {
            work_ns += pilot_ns(plan, transforms, *taps, placement);
        }
    }
    for ((ring, samples), &nodes) in plan.rings.iter().zip(&samples).zip(&nodes) {
        let texels = samples / ring.quadrature.wavelengths_nm.len() as f64;
        work_ns += windows.iter().map(|window| ring_ns(plan, window, ring, texels, nodes)).sum::<f64>();
    }
    let texels = plan.texels.window_texels() as f64;
    let counted = match &plan.domain {
        None => std::f64::consts::FRAC_PI_4 * texels,
        Some(domain) => domain.texels() as f64,
    };
    // Values at the nodes become coefficients; the lobe is a table of its own.
    work_ns += counted * tables as f64 * NS_PER_TEXEL_AND_TABLE;
    if plan.lobe_seen {
        // An invisible light has been refused before there was a plan.
        let samples = lobe::samples(optics, plan.lobe_radius, lobe_depths(plan), rms, config.tolerance).unwrap_or(0.0);
        work_ns += samples * NS_PER_LOBE_SAMPLE;
    }
    let storage = rounding::expected(config.storage, config.tolerance);
    let value_bytes = if storage == Storage::Half { 2.0 } else { 4.0 };
    let steps = plan.rings.iter().flat_map(|r| r.quadrature.wavelengths_nm.windows(2).map(|p| (p[0] - p[1]).abs()));
    // Halves, whatever the tables are.
    let range_bytes = if plan.domain.is_some() { texels * 3.0 * 2.0 } else { 0.0 };
    Forecast {
        windows: plan.windows.len(),
        speckle_deviation: speckle_deviation(&plan.windows, optics.sigma_nm),
        transforms,
        tables,
        size: plan.texels.grid.size,
        texels: counted as u64,
        step_min_nm: steps.reduce(f64::min),
        samples: samples.iter().sum(),
        node_samples: samples
            .iter()
            .zip(&nodes)
            .map(|(samples, nodes)| samples * nodes.next_multiple_of(GROUP) as f64)
            .sum(),
        seconds: 1e-9 * (FIXED_NS + work_ns / threads as f64),
        memory_bytes: memory_bytes(plan, &windows, &nodes, tables) as u64,
        stored_bytes: (counted * 3.0 * value_bytes * tables as f64 + range_bytes) as u64,
        storage,
        storage_asked: config.storage.is_some(),
    }
}

/// Most bytes on the heap at once: while a window is transformed, while it is summed, or while the sums become tables.
fn memory_bytes(plan: &BuildPlan, windows: &[WindowWork], nodes: &[usize], tables: usize) -> f64 {
    let numbers = plan.texels.window_texels() as f64 * 3.0 * 4.0;
    let sums = numbers * nodes.iter().copied().max().unwrap_or(tables).next_multiple_of(GROUP) as f64;
    // Sums and tables stand side by side, the transforms are gone.
    let mut most = sums + numbers * tables as f64;
    for (index, window) in windows.iter().enumerate() {
        let Lines { samples, lines, .. } = &window.lines;
        let cells = lines[0] * lines[1];
        let transforms = 8.0 * cells * window.transforms;
        // Heights and phasors of the samples; lines between the two passes, and after them.
        let passes = (8.0 + 16.0) * samples[0] * samples[1] + 16.0 * (samples[1] * lines[0] + cells);
        let sums_before = if index == 0 { 0.0 } else { sums };
        let of_ring = |(ring, &nodes): (&Ring, &usize)| scratch_bytes(plan, window, ring, nodes);
        let scratch = plan.rings.iter().zip(nodes).map(of_ring).fold(0.0, f64::max);
        most = most.max(transforms + passes + sums_before).max(transforms + sums + scratch);
    }
    most
}

/// What summing a ring holds besides: for a few wavelengths at once, every line that its texels read, interpolated to its
/// columns, with up to four lanes of four nodes each.
fn scratch_bytes(plan: &BuildPlan, window: &WindowWork, ring: &Ring, nodes: usize) -> f64 {
    let WindowWork { lines: Lines { step, taps, .. }, parts, box_samples, .. } = window;
    let texel = plan.texels.grid.texel();
    let extent = |texels: usize| (2.0 * ring.rho[1]).min(texels as f64 * texel);
    let lines = extent(plan.texels.rows.len()) / (plan.wavelength_min_nm * step[1]) + taps[1];
    let columns = extent(plan.texels.columns.len()) / texel * box_samples;
    let lanes = (nodes.div_ceil(GROUP) as f64).min(LANES_MAX as f64) * parts;
    // It is allocated with up to an eighth to spare.
    17.0 / 16.0 * WAVES as f64 * lines * columns * lanes * 16.0
}

/// Rms heights of a ring's texels, of that of all: few of them lie where the relief is deepest.
const RING_ROUGHNESS: f64 = 0.77;

/// Nodes that each ring will likely have.
fn ring_nodes(fields: &[HeightField], plan: &BuildPlan, config: &TablesConfig) -> Vec<usize> {
    let rms = fields.iter().map(super::build::rms_nm).fold(0.0, f64::max);
    let tables = config.count.unwrap_or_else(|| expected_tables(rms, plan, config.tolerance));
    let of_ring = |ring: &Ring| match &plan.domain {
        None => tables,
        Some(_) => expected_nodes(RING_ROUGHNESS * rms, plan, ring.w, RING_SHARE * config.tolerance).max(tables),
    };
    plan.rings.iter().map(of_ring).collect()
}

/// Joins the rings of a plan for every direction with their neighbours wherever the sums then take less: narrow rings have
/// few depths, but every one interpolates all lines whose blur reaches into it.
pub fn join_rings(plan: &mut BuildPlan, fields: &[HeightField], optics: &OpticsConfig, config: &TablesConfig) {
    let rms = fields.iter().map(super::build::rms_nm).fold(0.0, f64::max);
    let windows = window_work(fields, optics, plan);
    let cost = |(ring, texels): &(Ring, f64)| -> f64 {
        let nodes = expected_nodes(rms, plan, ring.w, RING_SHARE * config.tolerance).max(config.count.unwrap_or(1));
        windows.iter().map(|window| ring_ns(plan, window, ring, *texels, nodes)).sum()
    };
    let mut kept: Vec<(Ring, f64)> = Vec::new();
    for (ring, samples) in plan.rings.iter().zip(ring_samples(plan)) {
        let next = (ring.clone(), samples / ring.quadrature.wavelengths_nm.len() as f64);
        if let Some(last) = kept.last_mut() {
            // The outer radius asks for more wavelengths.
            let w = [last.0.w[0].min(ring.w[0]), last.0.w[1].max(ring.w[1])];
            let quadrature = last.0.quadrature.clone();
            let both = (Ring { rho: [ring.rho[0], last.0.rho[1]], w, quadrature }, last.1 + next.1);
            if cost(&both) <= cost(last) + cost(&next) {
                *last = both;
                continue;
            }
        }
        kept.push(next);
    }
    plan.rings = kept.into_iter().map(|(ring, _)| ring).collect();
}

/// What the sums of one window depend on.
struct WindowWork {
    lines: Lines,
    transforms: f64,
    /// 1 for powers, 2 for amplitudes.
    parts: f64,
    /// Box samples per texel and axis.
    box_samples: f64,
}

fn window_work(fields: &[HeightField], optics: &OpticsConfig, plan: &BuildPlan) -> Vec<WindowWork> {
    let depth = plan.spectra.s[1] - plan.spectra.s[0];
    let transforms = chebyshev::nodes_for_exponential(plan.bandwidth_nm, depth, plan.spectra.tolerance) as f64;
    let of_window = |&(scan, placement): &(usize, Placement)| {
        let lines = lines(&fields[scan], placement, optics, plan);
        let is_power = placement == Placement::TileMean;
        let box_samples = if is_power { 1.0 } else { plan.filter.samples as f64 };
        WindowWork { lines, transforms, parts: if is_power { 1.0 } else { 2.0 }, box_samples }
    };
    plan.windows.iter().map(of_window).collect()
}

/// One window's sums over a ring with so many texels and nodes, on one thread.
fn ring_ns(plan: &BuildPlan, window: &WindowWork, ring: &Ring, texels: f64, nodes: usize) -> f64 {
    let WindowWork { lines: Lines { step, taps, .. }, transforms, parts, box_samples } = window;
    let lanes = nodes.div_ceil(GROUP) as f64;
    let texel = plan.texels.grid.texel();
    let area = texels * texel.powi(2);
    let annulus = |[inner, outer]: [f64; 2]| std::f64::consts::PI * (outer * outer - inner.max(0.0).powi(2));
    let share = (area / annulus(ring.rho)).min(1.0);
    let targets = box_samples * 2.0 * area.sqrt().max(share * 2.0 * ring.rho[1]) / texel;
    let of_wave = |nm: &f64| {
        // Lines whose blur reaches into the ring.
        let reach = 0.5 * nm * (taps[0] * step[0]).max(taps[1] * step[1]);
        let wide =
            (share * annulus([ring.rho[0] - reach, ring.rho[1] + reach])).max((area.sqrt() + 2.0 * reach).powi(2));
        let cells = wide / (nm * nm * step[0] * step[1]);
        let rows = texels * texel / (nm * step[1]).min(texel * 8.0);
        let taps_read = parts * (taps[0] * rows * box_samples + taps[1] * texels * box_samples.powi(2));
        let in_lanes = NS_PER_LINE_NODE * 2.0 * cells * transforms
            + NS_PER_LANE_TAP * taps_read
            + NS_PER_LANE_SUM * texels * box_samples.powi(2);
        NS_PER_WAVE + NS_PER_KERNEL_VALUE * 0.5 * (taps[0] + taps[1]) * targets + lanes * in_lanes
    };
    ring.quadrature.wavelengths_nm.iter().map(of_wave).sum()
}

/// The pilot: every tested texel at all its wavelengths and fine nodes, once per tap where powers are summed.
fn pilot_ns(plan: &BuildPlan, transforms: usize, [x, y]: [f64; 2], placement: Placement) -> f64 {
    let wavelengths: usize = plan.rings.iter().map(|ring| ring.quadrature.wavelengths_nm.len()).sum();
    let each = wavelengths as f64 / plan.rings.len() as f64;
    let fine = plan.nodes_bound as f64;
    let products = if placement == Placement::TileMean { x * y * fine } else { x * y + fine };
    pilot::TEXELS as f64 * each * products * transforms as f64 * NS_PER_COMPLEX_PRODUCT
}

/// Tables that the pilot will likely choose.
fn expected_tables(rms_nm: f64, plan: &BuildPlan, tolerance: f64) -> usize {
    let Some(domain) = &plan.domain else {
        return expected_nodes(rms_nm, plan, [0.0, max_abs_w(0.0)], tolerance).max(2);
    };
    // As many as the widest ranges but one in twenty need.
    let mut lengths: Vec<f64> =
        domain.iter().map(|(row, column, t)| domain.w_at(row, column, t)).map(|[low, high]| high - low).collect();
    let at = lengths.len() * 19 / 20;
    let length = if lengths.is_empty() { 0.0 } else { *lengths.select_nth_unstable_by(at, f64::total_cmp).1 };
    expected_nodes(rms_nm, plan, [0.0, length], tolerance)
}

/// Nodes that a range of `w` will likely need: as for a surface of bandwidth 1.5 rms in each phasor.
fn expected_nodes(rms_nm: f64, plan: &BuildPlan, w: [f64; 2], tolerance: f64) -> usize {
    let depth = (w[1] - w[0]) * std::f64::consts::TAU / plan.wavelength_min_nm;
    chebyshev::nodes_for_exponential(1.5 * rms_nm, depth, tolerance).min(plan.nodes_bound)
}

/// Sizes of one window's transforms.
struct Lines {
    /// Samples within the window.
    samples: [f64; 2],
    padded: [f64; 2],
    step: [f64; 2],
    lines: [f64; 2],
    /// Lines that a point reads.
    taps: [f64; 2],
}

fn lines(field: &HeightField, placement: Placement, optics: &OpticsConfig, plan: &BuildPlan) -> Lines {
    let size = field.size();
    let mut lines = Lines { samples: [0.0; 2], padded: [0.0; 2], step: [0.0; 2], lines: [0.0; 2], taps: [0.0; 2] };
    for (axis, (samples, pitch)) in size.into_iter().zip(field.pitch_nm).enumerate() {
        let inside = matches!(placement, Placement::Inside { .. });
        let within = 2.0 * SUPPORT_SIGMAS * optics.sigma_nm / pitch;
        lines.samples[axis] = if inside { (within + 1.0).floor().min(samples as f64) } else { samples as f64 };
        lines.padded[axis] = match inside {
            true => smooth_size((OVERSAMPLING * lines.samples[axis]).ceil() as usize) as f64,
            false => lines.samples[axis],
        };
        lines.step[axis] = 1.0 / (lines.padded[axis] * pitch);
        // A Gaussian of 5.5 standard deviations on each side, or the fixed kernel.
        let gaussian = 11.0 / (std::f64::consts::TAU * optics.sigma_nm * lines.step[axis]);
        let taps = match placement {
            Placement::Inside { .. } => SEMICIRCLE_TAPS as f64,
            Placement::TileCentre => gaussian.ceil(),
            Placement::TileMean => (gaussian / std::f64::consts::SQRT_2).ceil(),
        };
        // Lines that do not exist are not read.
        lines.taps[axis] = taps.min(lines.padded[axis]);
        let [low, high] = plan.spectra.frequency[axis];
        lines.lines[axis] = ((high - low) / lines.step[axis] + taps + 1.0).min(lines.padded[axis]);
    }
    lines
}
