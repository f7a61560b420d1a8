//! Transforms of `exp(-i s h)` at a few nodes of the phase scale `s = k |w|`, from which every wavelength and every
//! `w` follow.
//!
//! For a fixed frequency `(ξ, η)` the transform `P` is an entire function of `s` of bandwidth
//! `max |h|`, so a Chebyshev interpolant over all `s` replaces all transforms over wavelength and
//! `w`. Stored is `E = (P - c G̃) / s`, with `c(s)` the window's mean phasor and `G̃` its transform:
//! `P - c G̃` vanishes with `s`, hence `|P - c G̃|² / w² = k² |E|²` without cancellation at any `w`.

use std::f64::consts::TAU;

use ndarray::{Array2, Zip};
use rayon::prelude::*;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};

use super::coherence::Coherence;
use super::config::OpticsConfig;
use super::kernel::{Kernel, OVERSAMPLING, semicircle_transform};
use super::window::{Placement, WindowAxis, window_axis};
use crate::height::HeightField;
use diffraction_brdf::chebyshev::{self, Interpolant};
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::error::{Error, Result};

/// What decides size and accuracy of the transforms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectraConfig {
    /// Smallest and largest phase scale `s` in 1/nm: 0 and `2 · 2π / λ_min` for the whole hemisphere.
    pub phase_scale_per_nm: [f64; 2],
    /// Smallest and largest frequency wanted in 1/nm, along x and y.
    pub frequency: [[f64; 2]; 2],
    /// Amplitude error of the interpolation in `s`, relative to the window's whole amplitude.
    pub tolerance: f64,
    /// Bytes that the transforms may take.
    pub memory_bytes: u64,
}

impl SpectraConfig {
    /// Transforms that hold pairs of directions, each given by its `q` and the shortest wavelength in nm that is asked for there.
    pub fn holding(
        optics: &OpticsConfig,
        asked: impl IntoIterator<Item = (Vec3, f64)>,
        tolerance: f64,
        memory_bytes: u64,
    ) -> Self {
        let mut config = Self { phase_scale_per_nm: [0.0; 2], frequency: [[0.0; 2]; 2], tolerance, memory_bytes };
        // A source of fixed size blurs over (u, v) by 5.5 times a quarter of its diameter, at wavelengths that its light lacks too.
        let blur = optics.source_deg.map_or(0.0, |source_deg| 5.5 * 0.25 * source_deg.to_radians());
        for (q, shortest_nm) in asked {
            config.phase_scale_per_nm[1] = config.phase_scale_per_nm[1].max(TAU * q[2].abs() / shortest_nm);
            for (range, component) in config.frequency.iter_mut().zip(q) {
                let reach = (component.abs() + blur) / shortest_nm;
                *range = [range[0].min(-reach), range[1].max(reach)];
            }
        }
        config
    }

    /// Whether transforms hold every frequency that a light asks for at `q`.
    pub fn holds(&self, optics: &OpticsConfig, q: Vec3) -> bool {
        let asked = |axis: usize| optics.illuminant.reach_nm(optics.wavelength_nm).map(|nm| q[axis] / nm);
        (0..2).all(|axis| asked(axis).iter().all(|f| (self.frequency[axis][0]..=self.frequency[axis][1]).contains(f)))
    }
}

/// The transforms of one window on one scan.
#[derive(Debug, Clone)]
pub struct Spectra {
    /// Number of nodes in `s`.
    pub nodes: usize,
    /// The nodes in 1/nm, and how values between them follow.
    pub over_phase: Interpolant,
    /// `E / sqrt(A)` in nm² (nm for the tile's lines) at each node; layout `[η line][ξ line][node]`.
    pub data: Vec<Complex<f32>>,
    /// Index of the first stored line along ξ and η.
    pub first: [i32; 2],
    /// Number of stored lines along ξ and η.
    pub lines: [usize; 2],
    /// Distance of the lines in 1/nm.
    pub step: [f64; 2],
    /// How the spectrum between the lines follows; at which wavelength a window that grows with it is narrowest.
    pub kernel: Kernel,
    /// The window that blurs the lines of a repeated scan.
    pub coherence: Coherence,
    /// Mean phasor `c` at each node.
    pub mean_phasor: Vec<Complex<f64>>,
    /// `(∬ g)² / A` in nm² for the window of the next field: the lobe's peak for `c = 1`.
    pub lobe_peak_nm2: f64,
    /// Standard deviation in nm of the light's coherence, which shapes the lobe; the largest over its wavelengths.
    pub lobe_sigma_nm: f64,
    /// The same at each wavelength.
    pub lobe_coherence: Coherence,
    /// Half the range of the scan's heights in nm.
    pub half_range_nm: f64,
    /// Whether the lines' powers are averaged over all window positions.
    pub mean_power: bool,
    /// The window along x and y.
    pub(crate) axes: [WindowAxis; 2],
}

/// Share of its peak at which the lobe ends: where its table does.
pub(super) const LOBE_LEAST: f64 = 1e-9;

/// Half the peak-to-valley range of the heights in nm: the bandwidth in the phase scale, measured from mid-range.
pub fn half_height_range_nm(field: &HeightField) -> f64 {
    let [low, high] = range_nm(field);
    0.5 * (high - low).max(0.0)
}

fn range_nm(field: &HeightField) -> [f64; 2] {
    field.heights_nm.iter().fold([f64::MAX, f64::MIN], |[low, high], &h| [low.min(h), high.max(h)])
}

/// What one axis of the transform looks like.
pub(super) struct AxisPlan {
    pub(super) window: WindowAxis,
    /// Factor of each sample besides the phasor.
    factor: Vec<f64>,
    padded: usize,
    pub(super) step: f64,
    pub(super) first: i32,
    pub(super) lines: usize,
}

/// The lines that the kernel reads for frequencies from `low` to `high`, and how they come about.
fn axis_plan(
    placement: Placement,
    kernel: Kernel,
    axis: usize,
    field: &HeightField,
    sigma_nm: f64,
    [low, high]: [f64; 2],
) -> AxisPlan {
    let (count, pitch_nm) = (field.size()[axis], field.pitch_nm[axis]);
    let window = window_axis(placement, axis, count, pitch_nm, sigma_nm);
    let samples = window.position_nm.len();
    let inside = matches!(placement, Placement::Inside { .. });
    let padded = if inside { smooth_size((samples as f64 * OVERSAMPLING).ceil() as usize) } else { samples };
    let step = 1.0 / (padded as f64 * pitch_nm);
    let factor = if inside {
        let scale = pitch_nm / window.norm_nm.sqrt();
        let positions = window.position_nm.iter().zip(&window.amplitude);
        positions.map(|(&x, g)| scale * g / semicircle_transform(x, step)).collect()
    } else {
        vec![1.0 / samples as f64; samples]
    };
    // Lines past the sampling's own limit would be aliases: the surface has no information there.
    let limit = (padded as i32 - 1) / 2;
    // The reach is counted in lines, which lie closer the farther a window is padded.
    let reach = kernel.half_width(step, 0.0);
    let first = (((low - reach) / step).floor() as i32).clamp(-limit, limit);
    // Taps are as many everywhere, so the last may lie a line beyond the kernel's reach: it is there whatever else is wanted.
    let last = (((high + reach) / step).ceil() as i32 + 1).clamp(first, limit);
    AxisPlan { window, factor, padded, step, first, lines: (last - first) as usize + 1 }
}

/// Kernel and axes of one window's transforms for frequencies (1/nm) along x and y.
pub(super) fn window_plan(
    field: &HeightField,
    placement: Placement,
    sigma_nm: f64,
    frequency: [[f64; 2]; 2],
) -> (Kernel, [AxisPlan; 2]) {
    let kernel = match placement {
        Placement::Inside { .. } => Kernel::Semicircle,
        Placement::TileCentre => Kernel::GaussianAmplitude { sigma_nm },
        Placement::TileMean => Kernel::GaussianPower { sigma_nm },
    };
    (kernel, std::array::from_fn(|axis| axis_plan(placement, kernel, axis, field, sigma_nm, frequency[axis])))
}

/// How many lines one window's transforms have and an evaluation reads, along x and y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineCounts {
    /// Distance of the lines in 1/nm.
    pub step: [f64; 2],
    /// Lines stored.
    pub stored: [usize; 2],
    /// Lines that one point reads, where all of them are stored.
    pub read: [usize; 2],
    /// Samples under the window.
    pub samples: [usize; 2],
    /// Samples that are transformed.
    pub padded: [usize; 2],
}

/// Counts the lines of one window, for frequencies (1/nm) along x and y.
pub fn line_counts(field: &HeightField, placement: Placement, sigma_nm: f64, frequency: [[f64; 2]; 2]) -> LineCounts {
    let (kernel, plans) = window_plan(field, placement, sigma_nm, frequency);
    let read = |plan: &AxisPlan| (2.0 * kernel.half_width(plan.step, 0.0) / plan.step).ceil().max(1.0) as usize;
    let [x, y] = &plans;
    LineCounts {
        step: [x.step, y.step],
        stored: [x.lines, y.lines],
        read: [read(x), read(y)],
        samples: [x.window.position_nm.len(), y.window.position_nm.len()],
        padded: [x.padded, y.padded],
    }
}

/// Smallest number of at least `size` with prime factors 2, 3 and 5 only: fast for the FFT.
pub(crate) fn smooth_size(size: usize) -> usize {
    (size..)
        .find(|&n| {
            let mut rest = n;
            for p in [2, 3, 5] {
                while rest % p == 0 {
                    rest /= p;
                }
            }
            rest == 1
        })
        .unwrap_or(size)
}

/// Number of nodes in `s` that a field takes.
pub(crate) fn nodes_for(field: &HeightField, config: &SpectraConfig) -> usize {
    chebyshev::nodes_for_exponential(
        half_height_range_nm(field),
        config.phase_scale_per_nm[1] - config.phase_scale_per_nm[0],
        config.tolerance,
    )
}

/// Refuses what [`transform`] would refuse.
///
/// # Errors
/// `Error::Limit` if the transforms would need more memory than allowed.
pub(crate) fn check_memory(
    field: &HeightField,
    placement: Placement,
    optics: &OpticsConfig,
    config: &SpectraConfig,
) -> Result<()> {
    let (_, plans) = window_plan(field, placement, optics.least_sigma_nm(), config.frequency);
    checked_values(&plans, nodes_for(field, config), config.memory_bytes).map(drop)
}

/// Number of values of one window's transforms, if the memory allows for them.
fn checked_values(plans: &[AxisPlan; 2], nodes: usize, memory_bytes: u64) -> Result<usize> {
    let values = plans[0].lines as u64 * plans[1].lines as u64 * nodes as u64;
    let bytes = values * size_of::<Complex<f32>>() as u64;
    if bytes <= memory_bytes {
        return Ok(values as usize);
    }
    Err(Error::limit(
        format!(
            "the transforms need {} MiB ({nodes} nodes in phase scale on {} x {} frequencies) and {} MiB are allowed",
            bytes >> 20,
            plans[0].lines,
            plans[1].lines,
            memory_bytes >> 20
        ),
        "raise tables.memory_mib, clip outliers with despike (the range of heights sets the nodes), or lower tables.tolerance's demand",
    ))
}

/// `(∬ g)² / A` in nm² of the window that shapes the lobe: the light's own where the lines' powers are averaged over all
/// positions, whatever blurs the lines; else the one on the scan.
fn lobe_peak_nm2(placement: Placement, plans: &[AxisPlan; 2], optics: &OpticsConfig) -> f64 {
    let own = |plan: &AxisPlan| plan.window.integral_nm.powi(2) / plan.window.norm_nm;
    let light = |plan: &AxisPlan| {
        let window = window_axis(placement, 0, plan.window.position_nm.len(), 1.0, optics.lobe_sigma_nm());
        window.integral_nm.powi(2) / window.norm_nm
    };
    plans.iter().map(|plan| if placement == Placement::TileMean { light(plan) } else { own(plan) }).product()
}

/// Transforms one window of a prepared height field.
///
/// # Errors
/// `Error::Limit` if the transforms would need more memory than allowed; nothing is computed then.
pub fn transform(
    field: &HeightField,
    placement: Placement,
    optics: &OpticsConfig,
    config: &SpectraConfig,
) -> Result<Spectra> {
    let (kernel, plans) = window_plan(field, placement, optics.least_sigma_nm(), config.frequency);
    let [s_min, s_max] = config.phase_scale_per_nm;
    let nodes = nodes_for(field, config);
    let values = checked_values(&plans, nodes, config.memory_bytes)?;
    let mut spectra = Spectra {
        nodes,
        over_phase: Interpolant::new(nodes, s_min, s_max),
        data: vec![Complex::default(); values],
        first: [plans[0].first, plans[1].first],
        lines: [plans[0].lines, plans[1].lines],
        step: [plans[0].step, plans[1].step],
        kernel,
        coherence: optics.body_coherence(),
        mean_phasor: Vec::with_capacity(nodes),
        lobe_peak_nm2: lobe_peak_nm2(placement, &plans, optics),
        lobe_sigma_nm: optics.lobe_sigma_nm(),
        lobe_coherence: optics.lobe_coherence(),
        half_range_nm: half_height_range_nm(field),
        mean_power: placement == Placement::TileMean,
        axes: [plans[0].window.clone(), plans[1].window.clone()],
    };
    let heights = window_heights(field, &plans);
    let mut engine = Engine::new(&plans);
    for (node, s) in spectra.over_phase.nodes().to_vec().into_iter().enumerate() {
        let phasor = Zip::from(&heights).par_map_collect(|h| Complex::cis(-s * h));
        let mean = mean_phasor(&phasor, &plans);
        spectra.mean_phasor.push(mean);
        engine.run(&phasor, mean, s, &plans);
        engine.store(&mut spectra.data, node, nodes, &plans);
    }
    Ok(spectra)
}

/// The heights under the window from the middle of the field's range, shape `[rows, columns]`: the
/// nodes in `s` are counted for heights of either sign, and no power depends on the level.
pub(super) fn window_heights(field: &HeightField, plans: &[AxisPlan; 2]) -> Array2<f64> {
    let [x, y] = [&plans[0].window, &plans[1].window];
    let [low, high] = range_nm(field);
    let middle = 0.5 * (low + high);
    Array2::from_shape_fn((y.position_nm.len(), x.position_nm.len()), |(row, column)| {
        field.heights_nm[[y.first + row, x.first + column]] - middle
    })
}

/// `Σ g p / Σ g` over the window, row sums first: a fixed order.
fn mean_phasor(phasor: &Array2<Complex<f64>>, plans: &[AxisPlan; 2]) -> Complex<f64> {
    let [gx, gy] = [&plans[0].window.amplitude, &plans[1].window.amplitude];
    let rows: Vec<Complex<f64>> =
        phasor.outer_iter().into_par_iter().map(|row| row.iter().zip(gx).map(|(p, g)| p * g).sum()).collect();
    let sum: Complex<f64> = rows.iter().zip(gy).map(|(p, g)| p * g).sum();
    sum / (gx.iter().sum::<f64>() * gy.iter().sum::<f64>())
}

/// Plans and buffers of the two-dimensional transform, reused for every node.
pub(super) struct Engine {
    along_x: std::sync::Arc<dyn Fft<f64>>,
    along_y: std::sync::Arc<dyn Fft<f64>>,
    /// `[row][ξ line]` after the first pass.
    half_done: Vec<Complex<f64>>,
    /// `[ξ line][η line]` after the second.
    pub(super) done: Vec<Complex<f64>>,
    /// `exp(2πi ξ x_first)` per line, and the same for η.
    phase: [Vec<Complex<f64>>; 2],
}

impl Engine {
    pub(super) fn new(plans: &[AxisPlan; 2]) -> Self {
        let mut planner = FftPlanner::new();
        let phase = [0, 1].map(|axis| {
            let plan = &plans[axis];
            let start = plan.window.position_nm[0];
            (0..plan.lines).map(|line| Complex::cis(TAU * plan.frequency(line) * start)).collect()
        });
        Self {
            // Positions ascend along x and descend along y: opposite signs make both exp(+2πi ξx).
            along_x: planner.plan_fft_inverse(plans[0].padded),
            along_y: planner.plan_fft_forward(plans[1].padded),
            half_done: vec![Complex::default(); plans[1].window.position_nm.len() * plans[0].lines],
            done: vec![Complex::default(); plans[0].lines * plans[1].lines],
            phase,
        }
    }

    /// Transforms `(phasor - mean) / s` times the window.
    pub(super) fn run(&mut self, phasor: &Array2<Complex<f64>>, mean: Complex<f64>, s: f64, plans: &[AxisPlan; 2]) {
        let [x, y] = plans;
        let (along_x, along_y) = (&self.along_x, &self.along_y);
        let [phase_x, phase_y] = &self.phase;
        self.half_done.par_chunks_mut(x.lines).enumerate().for_each_init(
            || Buffers::new(along_x.as_ref()),
            |buffers, (row, out)| {
                let scale = y.factor[row] / s;
                buffers.line.fill(Complex::default());
                for ((slot, p), factor) in buffers.line.iter_mut().zip(phasor.row(row)).zip(&x.factor) {
                    *slot = (p - mean) * (scale * factor);
                }
                along_x.process_with_scratch(&mut buffers.line, &mut buffers.scratch);
                pick(&buffers.line, x, phase_x, out);
            },
        );
        let half_done = &self.half_done;
        self.done.par_chunks_mut(y.lines).enumerate().for_each_init(
            || Buffers::new(along_y.as_ref()),
            |buffers, (column, out)| {
                buffers.line.fill(Complex::default());
                for (slot, row) in buffers.line.iter_mut().zip(half_done.chunks_exact(x.lines)) {
                    *slot = row[column];
                }
                along_y.process_with_scratch(&mut buffers.line, &mut buffers.scratch);
                pick(&buffers.line, y, phase_y, out);
            },
        );
    }

    /// Interleaves the finished transform as one node of the stored layout.
    fn store(&self, data: &mut [Complex<f32>], node: usize, nodes: usize, plans: &[AxisPlan; 2]) {
        let lines_y = plans[1].lines;
        data.par_chunks_mut(plans[0].lines * nodes).enumerate().for_each(|(row, out)| {
            for (column, slot) in out.iter_mut().skip(node).step_by(nodes).enumerate() {
                let value = self.done[column * lines_y + row];
                *slot = Complex::new(value.re as f32, value.im as f32);
            }
        });
    }
}

impl AxisPlan {
    fn frequency(&self, line: usize) -> f64 {
        f64::from(self.first + line as i32) * self.step
    }
}

struct Buffers {
    line: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl Buffers {
    fn new(fft: &dyn Fft<f64>) -> Self {
        Self {
            line: vec![Complex::default(); fft.len()],
            scratch: vec![Complex::default(); fft.get_inplace_scratch_len()],
        }
    }
}

/// Takes the wanted lines out of a transform, times the phase of the first sample's position.
fn pick(line: &[Complex<f64>], plan: &AxisPlan, phase: &[Complex<f64>], out: &mut [Complex<f64>]) {
    let length = line.len() as i32;
    for ((index, slot), phase) in out.iter_mut().enumerate().zip(phase) {
        *slot = line[(plan.first + index as i32).rem_euclid(length) as usize] * phase;
    }
}

impl Spectra {
    /// Weights that interpolate the nodes to `s` (1/nm).
    pub(crate) fn node_weights(&self, s: f64) -> Vec<f64> {
        self.over_phase.weights(s)
    }

    /// The mean phasor `c(s)`.
    pub(crate) fn mean_phasor_at(&self, s: f64) -> Complex<f64> {
        combined(&self.mean_phasor, &self.node_weights(s))
    }

    /// How the spectrum between the lines follows at a wavelength.
    pub(crate) fn kernel_at(&self, wavelength_nm: f64) -> Kernel {
        match self.kernel {
            Kernel::GaussianPower { .. } => {
                Kernel::GaussianPower { sigma_nm: self.coherence.sigma_nm_at(wavelength_nm) }
            }
            kernel => kernel,
        }
    }

    /// `|c G̃|² / A` in nm² of the light's own window in closed form, at a distance from the mirror direction in 1/nm.
    pub(crate) fn lobe_power_nm2(&self, distance_per_nm: f64, s: f64, wavelength_nm: f64) -> f64 {
        let sigma_nm = self.lobe_coherence.sigma_nm_at(wavelength_nm);
        let shape = (-(TAU * sigma_nm * distance_per_nm).powi(2)).exp();
        let peak_nm2 = self.lobe_peak_nm2 * (sigma_nm / self.lobe_sigma_nm).powi(2);
        if shape < LOBE_LEAST { 0.0 } else { shape * peak_nm2 * self.mean_phasor_at(s).norm_sqr() }
    }

    /// Transform of the window along one axis at a frequency (1/nm), divided by the root of the axis'
    /// norm: `G̃ / sqrt(A)` is the product of both axes.
    pub(crate) fn window_transform(&self, axis: usize, frequency: f64, wavelength_nm: f64) -> f64 {
        let [value] = self.window_transforms(axis, [frequency], [wavelength_nm]);
        value
    }

    /// [`Self::window_transform`] at several frequencies and wavelengths.
    pub(super) fn window_transforms<const L: usize>(
        &self,
        axis: usize,
        frequency: [f64; L],
        wavelength_nm: [f64; L],
    ) -> [f64; L] {
        match self.kernel {
            Kernel::Semicircle => self.axes[axis].transforms(frequency),
            Kernel::GaussianAmplitude { .. } | Kernel::GaussianPower { .. } => std::array::from_fn(|i| {
                let sigma_nm = self.lobe_coherence.sigma_nm_at(wavelength_nm[i]);
                Kernel::GaussianAmplitude { sigma_nm }.value(frequency[i], 1.0, 0.0)
            }),
        }
    }
}

fn combined(nodes: &[Complex<f64>], weights: &[f64]) -> Complex<f64> {
    nodes.iter().zip(weights).map(|(e, w)| e * w).sum()
}
