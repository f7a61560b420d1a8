//! Transforms of `exp(-i s h)` at a few nodes of `s = k |w|`, from which every wavelength and every
//! `w` follow.
//!
//! For a fixed frequency `(ξ, η)` the transform `P` is an entire function of `s` of bandwidth
//! `max |h|`, so a Chebyshev interpolant over all `s` replaces all transforms over wavelength and
//! `w`. Stored is `E = (P - c G̃) / s`, with `c(s)` the window's mean phasor and `G̃` its transform:
//! `P - c G̃` vanishes with `s`, hence `|P - c G̃|² / w² = k² |E|²` without cancellation at any `w`.

use std::f64::consts::TAU;
use std::ops::Range;

use ndarray::{Array2, Zip};
use rayon::prelude::*;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};

use super::config::OpticsConfig;
use super::kernel::{Kernel, OVERSAMPLING, semicircle_transform};
use super::window::{Placement, WindowAxis, window_axis};
use crate::ground::chebyshev::{self, Interpolant};
use crate::ground::direction::Vec3;
use crate::ground::error::{Error, Result};
use crate::height::HeightField;

/// What decides size and accuracy of the transforms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectraConfig {
    /// Smallest and largest `s` in 1/nm: 0 and `2 · 2π / λ_min` for the whole hemisphere.
    pub s: [f64; 2],
    /// Smallest and largest frequency wanted in 1/nm, along x and y.
    pub frequency: [[f64; 2]; 2],
    /// Amplitude error of the interpolation in `s`, relative to the window's whole amplitude.
    pub tolerance: f64,
    /// Bytes that the transforms may take.
    pub memory_bytes: u64,
}

impl SpectraConfig {
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
    /// Smallest and largest `s` in 1/nm.
    pub s: [f64; 2],
    /// The nodes in 1/nm, and how values between them follow.
    pub depth: Interpolant,
    /// `E / sqrt(A)` in nm² (nm for the tile's lines) at each node; layout `[η line][ξ line][node]`.
    pub data: Vec<Complex<f32>>,
    /// Index of the first stored line along ξ and η.
    pub first: [i32; 2],
    /// Number of stored lines along ξ and η.
    pub lines: [usize; 2],
    /// Distance of the lines in 1/nm.
    pub step: [f64; 2],
    /// How the spectrum between the lines follows.
    pub kernel: Kernel,
    /// Mean phasor `c` at each node.
    pub mean_phasor: Vec<Complex<f64>>,
    /// `(∬ g)² / A` in nm²: the lobe's peak for `c = 1`.
    pub lobe_peak_nm2: f64,
    /// Half the range of the scan's heights in nm.
    pub half_range_nm: f64,
    /// Whether the lines' powers are averaged over all window positions.
    pub mean_power: bool,
    /// The window along x and y.
    pub axes: [WindowAxis; 2],
}

/// Half the peak-to-valley range of the heights in nm: the bandwidth in `s` after centring.
pub fn bandwidth_nm(field: &HeightField) -> f64 {
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

/// Smallest number of at least `size` with prime factors 2, 3 and 5 only: fast for the FFT.
pub fn smooth_size(size: usize) -> usize {
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
pub fn nodes_for(field: &HeightField, config: &SpectraConfig) -> usize {
    chebyshev::nodes_for_exponential(bandwidth_nm(field), config.s[1] - config.s[0], config.tolerance)
}

/// Refuses what [`transform`] would refuse.
///
/// # Errors
/// `Error::Limit` if the transforms would need more memory than allowed.
pub fn check_memory(
    field: &HeightField,
    placement: Placement,
    optics: &OpticsConfig,
    config: &SpectraConfig,
) -> Result<()> {
    let (_, plans) = window_plan(field, placement, optics.sigma_nm, config.frequency);
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
            "the transforms need {} MiB ({nodes} depth nodes on {} x {} frequencies) and {} MiB are allowed",
            bytes >> 20,
            plans[0].lines,
            plans[1].lines,
            memory_bytes >> 20
        ),
        "raise tables.memory_mib, clip outliers with despike (depth sets the nodes), or lower tables.tolerance's demand",
    ))
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
    let (kernel, plans) = window_plan(field, placement, optics.sigma_nm, config.frequency);
    let [s_min, s_max] = config.s;
    let nodes = nodes_for(field, config);
    let values = checked_values(&plans, nodes, config.memory_bytes)?;
    let mut spectra = Spectra {
        nodes,
        s: config.s,
        depth: Interpolant::new(nodes, s_min, s_max),
        data: vec![Complex::default(); values],
        first: [plans[0].first, plans[1].first],
        lines: [plans[0].lines, plans[1].lines],
        step: [plans[0].step, plans[1].step],
        kernel,
        mean_phasor: Vec::with_capacity(nodes),
        lobe_peak_nm2: plans.iter().map(|p| p.window.integral_nm.powi(2) / p.window.norm_nm).product(),
        half_range_nm: bandwidth_nm(field),
        mean_power: placement == Placement::TileMean,
        axes: [plans[0].window.clone(), plans[1].window.clone()],
    };
    let heights = window_heights(field, &plans);
    let mut engine = Engine::new(&plans);
    for (node, s) in spectra.depth.nodes().to_vec().into_iter().enumerate() {
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
    pub fn node_weights(&self, s: f64) -> Vec<f64> {
        self.depth.weights(s)
    }

    /// The mean phasor `c(s)`.
    pub fn mean_phasor_at(&self, s: f64) -> Complex<f64> {
        combined(&self.mean_phasor, &self.node_weights(s))
    }

    /// Transform of the window along one axis at a frequency (1/nm), divided by the root of the axis'
    /// norm: `G̃ / sqrt(A)` is the product of both axes.
    pub fn window_transform(&self, axis: usize, frequency: f64) -> f64 {
        let window = &self.axes[axis];
        match self.kernel {
            Kernel::Semicircle => {
                let samples = window.position_nm.iter().zip(&window.amplitude);
                let pitch = if window.position_nm.len() > 1 {
                    (window.position_nm[1] - window.position_nm[0]).abs()
                } else {
                    window.integral_nm
                };
                samples.map(|(x, g)| g * (TAU * frequency * x).cos()).sum::<f64>() * pitch / window.norm_nm.sqrt()
            }
            Kernel::GaussianAmplitude { sigma_nm } | Kernel::GaussianPower { sigma_nm } => {
                Kernel::GaussianAmplitude { sigma_nm }.value(frequency, 1.0, 0.0)
            }
        }
    }

    /// `|E|² / A` at one frequency for several `s`, given [`Self::node_weights`] of each: straight from
    /// the transforms in double precision, the slow path against which grid and basis are measured.
    pub fn power_at(&self, frequency: [f64; 2], node_weights: &[Vec<f64>]) -> Vec<f64> {
        if !self.mean_power {
            let nodes = self.amplitude_nodes(frequency);
            return node_weights.iter().map(|weights| combined(&nodes, weights).norm_sqr()).collect();
        }
        let count = node_weights.len();
        let mut power = vec![0.0; count];
        if let [weights] = node_weights {
            self.for_each_row(frequency, |lines, taps, row_tap| power[0] += row_tap * row_power(lines, taps, weights));
            return power;
        }
        // Weights of a node side by side, so that the sums over nodes run in step.
        let turned: Vec<f64> = (0..self.nodes).flat_map(|n| node_weights.iter().map(move |w| w[n])).collect();
        let mut sums = vec![[0.0; 2]; count];
        self.for_each_row(frequency, |lines, taps, row_tap| {
            for (line, tap) in lines.chunks_exact(self.nodes).zip(taps) {
                sums.fill([0.0; 2]);
                for (e, weights) in line.iter().zip(turned.chunks_exact(count)) {
                    let [re, im] = [f64::from(e.re), f64::from(e.im)];
                    for (sum, weight) in sums.iter_mut().zip(weights) {
                        sum[0] += weight * re;
                        sum[1] += weight * im;
                    }
                }
                let tap = row_tap * f64::from(*tap);
                power.iter_mut().zip(&sums).for_each(|(power, [re, im])| *power += tap * (re * re + im * im));
            }
        });
        power
    }

    /// `|P|² / A` at one frequency and `s`, the coherent part included.
    pub fn total_power(&self, frequency: [f64; 2], s: f64) -> f64 {
        let weights = self.node_weights(s);
        let window = self.window_transform(0, frequency[0]) * self.window_transform(1, frequency[1]);
        let mean = combined(&self.mean_phasor, &weights);
        if self.mean_power {
            return mean.norm_sqr() * window * window + s * s * self.power_at(frequency, &[weights])[0];
        }
        (mean * window + combined(&self.amplitude_nodes(frequency), &weights) * s).norm_sqr()
    }

    /// `E / sqrt(A)` at one frequency, at every node.
    fn amplitude_nodes(&self, frequency: [f64; 2]) -> Vec<Complex<f64>> {
        let mut sum = vec![Complex::default(); self.nodes];
        self.for_each_row(frequency, |lines, taps, row_tap| {
            for (line, tap) in lines.chunks_exact(self.nodes).zip(taps) {
                let tap = row_tap * f64::from(*tap);
                for (sum, e) in sum.iter_mut().zip(line) {
                    *sum += Complex::new(f64::from(e.re), f64::from(e.im)) * tap;
                }
            }
        });
        sum
    }

    /// Calls back for each stored row of lines near a frequency: all nodes of its lines, the lines' weights, the row's.
    fn for_each_row(&self, frequency: [f64; 2], mut visit: impl FnMut(&[Complex<f32>], &[f32], f64)) {
        let taps: [_; 2] = std::array::from_fn(|axis| self.kernel.taps(&[frequency[axis]], self.step[axis], 0.0));
        // What lies outside of what is stored is left out.
        let stored: [Range<i32>; 2] = std::array::from_fn(|axis| {
            let first = taps[axis].first[0] - self.first[axis];
            let end = (first + taps[axis].count as i32).min(self.lines[axis] as i32);
            first.max(0)..end
        });
        let [columns, rows] = stored;
        if columns.is_empty() {
            return;
        }
        let skipped = (self.first[0] + columns.start - taps[0].first[0]) as usize;
        let weights = &taps[0].weight[skipped..skipped + columns.len()];
        for row in rows {
            let start = (row as usize * self.lines[0] + columns.start as usize) * self.nodes;
            let tap = taps[1].weight[(self.first[1] + row - taps[1].first[0]) as usize];
            visit(&self.data[start..start + columns.len() * self.nodes], weights, tap.into());
        }
    }
}

/// `Σ tap |Σ weight E|²` over neighbouring lines, each with as many nodes as there are weights.
///
/// Four lines at a time: the sum over one line's nodes has to wait for each of its additions.
fn row_power(lines: &[Complex<f32>], taps: &[f32], weights: &[f64]) -> f64 {
    const AT_ONCE: usize = 4;
    let nodes = weights.len();
    let (blocks, block_taps) = (lines.chunks_exact(AT_ONCE * nodes), taps.chunks_exact(AT_ONCE));
    let rest = blocks.remainder().chunks_exact(nodes).zip(block_taps.remainder());
    let mut power = 0.0;
    for (block, taps) in blocks.zip(block_taps) {
        let line: [&[Complex<f32>]; AT_ONCE] = std::array::from_fn(|i| &block[i * nodes..(i + 1) * nodes]);
        let mut sums = [Complex::new(0.0, 0.0); AT_ONCE];
        for (node, &weight) in weights.iter().enumerate() {
            for (sum, line) in sums.iter_mut().zip(line) {
                sum.re += weight * f64::from(line[node].re);
                sum.im += weight * f64::from(line[node].im);
            }
        }
        power += sums.iter().zip(taps).map(|(sum, tap)| f64::from(*tap) * sum.norm_sqr()).sum::<f64>();
    }
    for (line, tap) in rest {
        let sum: Complex<f64> =
            line.iter().zip(weights).map(|(e, w)| Complex::new(f64::from(e.re), f64::from(e.im)) * w).sum();
        power += f64::from(*tap) * sum.norm_sqr();
    }
    power
}

fn combined(nodes: &[Complex<f64>], weights: &[f64]) -> Complex<f64> {
    nodes.iter().zip(weights).map(|(e, w)| e * w).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_power_of_a_row_is_the_sum_over_its_lines() {
        let weights = [0.3, -1.2, 0.7];
        // One line, whole blocks, and blocks with a rest.
        for count in [1, 4, 8, 11] {
            let number = |i: usize| (i * 37 % 19) as f32 / 19.0 - 0.4;
            let lines: Vec<_> = (0..3 * count).map(|i| Complex::new(number(i), number(2 * i + 5))).collect();
            let taps: Vec<f32> = (0..count).map(|i| 1.0 + number(3 * i + 1)).collect();
            let of_line = |line: &[Complex<f32>]| {
                let wide: Vec<_> = line.iter().map(|e| Complex::new(f64::from(e.re), f64::from(e.im))).collect();
                combined(&wide, &weights).norm_sqr()
            };
            let plain: f64 = lines.chunks_exact(3).zip(&taps).map(|(line, tap)| f64::from(*tap) * of_line(line)).sum();
            let found = row_power(&lines, &taps, &weights);
            // Products and sums of at most a few dozen numbers of order one.
            assert!((found - plain).abs() < 1e-13, "{count}: {found} {plain}");
            let mut other = lines.clone();
            other[3 * (count - 1)].re += 0.1;
            assert!((row_power(&other, &taps, &weights) - plain).abs() > 1e-6, "{count}: every line counts");
        }
    }
}
