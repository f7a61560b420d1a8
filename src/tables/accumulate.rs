//! The inner loops: spectra of one wavelength interpolated to every texel, squared, summed into XYZ.
//!
//! Per wavelength: (A) for every line of η, the depth nodes are combined into a few values of `w` and
//! interpolated along ξ to the texel columns; (B) for every texel row, those rows are interpolated along
//! η, squared and added. Both are loops over lanes of four `w` values; A and B run in parallel over rows
//! that nobody else writes, wavelengths follow one another: the sums never depend on the threads.

use std::f64::consts::TAU;

use rayon::prelude::*;
use rustfft::num_complex::Complex;

use super::plan::{Grid, Ring};
use crate::optics::kernel::{Kernel, Taps};
use crate::optics::spectra::Spectra;

/// Four values of `w`.
type Lane = [f32; 4];

/// Most lanes handled in one sweep; more nodes take further sweeps.
const LANES_MAX: usize = 4;

/// Sums of XYZ at the nodes of `w`: layout `[row][column][channel][node]`.
#[derive(Debug, Clone)]
pub struct PowerSums {
    /// Nodes of `w` per texel, a multiple of four.
    pub nodes: usize,
    /// The sums in 1/sr (before geometry and reflectance).
    pub data: Vec<f32>,
}

impl PowerSums {
    /// Zero everywhere.
    pub fn new(grid: &Grid, nodes: usize) -> Self {
        let nodes = nodes.next_multiple_of(4);
        Self { nodes, data: vec![0.0; grid.size * grid.size * 3 * nodes] }
    }
}

/// How texels average over (u, v).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoxFilter {
    /// Side of the averaged square; 0 for point samples.
    pub width: f64,
    /// Samples per axis that represent it where amplitudes are squared after interpolation.
    pub samples: usize,
}

/// What is summed for every texel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// `k² |E|²`: the tables.
    Power,
    /// `2 k Re(c* G̃* E)`: the lobe's cross term.
    Cross,
}

/// Adds one window's contribution over a ring, for the values of `w` in `w_nodes`.
pub fn add_ring(
    spectra: &Spectra,
    grid: &Grid,
    ring: &Ring,
    w_nodes: &[f64],
    filter: BoxFilter,
    quantity: Quantity,
    share: f64,
    sums: &mut PowerSums,
) {
    for (index, &wavelength_nm) in ring.quadrature.wavelengths_nm.iter().enumerate() {
        let scale = share / (wavelength_nm * wavelength_nm);
        let colour = ring.quadrature.weights[index].map(|weight| (weight * scale) as f32);
        let wave = Wave::new(spectra, grid, ring, filter, quantity, wavelength_nm, colour);
        for group in (0..w_nodes.len()).step_by(4 * LANES_MAX) {
            let nodes = &w_nodes[group..w_nodes.len().min(group + 4 * LANES_MAX)];
            match (nodes.len().div_ceil(4), spectra.mean_power) {
                (1, true) => wave.sweep::<1, 1>(nodes, group, sums),
                (2, true) => wave.sweep::<2, 2>(nodes, group, sums),
                (3, true) => wave.sweep::<3, 3>(nodes, group, sums),
                (_, true) => wave.sweep::<4, 4>(nodes, group, sums),
                (1, false) => wave.sweep::<1, 2>(nodes, group, sums),
                (2, false) => wave.sweep::<2, 4>(nodes, group, sums),
                (3, false) => wave.sweep::<3, 6>(nodes, group, sums),
                (_, false) => wave.sweep::<4, 8>(nodes, group, sums),
            }
        }
    }
}

/// The frequencies a ring's texels ask for at one wavelength, and the taps that interpolate them.
pub(super) struct Targets {
    /// Box samples per texel and axis.
    pub samples: usize,
    /// First to last column (and row) of the ring.
    pub columns: std::ops::Range<usize>,
    /// Frequencies in 1/nm along x and y, box samples of a texel side by side.
    pub frequency: [Vec<f64>; 2],
    /// Their taps.
    pub taps: [Taps; 2],
}

impl Targets {
    pub(super) fn new(
        grid: &Grid,
        ring: &Ring,
        filter: BoxFilter,
        kernel: Kernel,
        step: [f64; 2],
        wavelength_nm: f64,
    ) -> Self {
        let columns = grid.columns_within(ring.rho[1]);
        // A mean over window positions is a sum of powers: its kernel averages the box exactly.
        let mean_power = matches!(kernel, Kernel::GaussianPower { .. });
        let (samples, box_width) = if mean_power { (1, filter.width) } else { (filter.samples, 0.0) };
        let offsets: Vec<f64> =
            (0..samples).map(|i| ((i as f64 + 0.5) / samples as f64 - 0.5) * filter.width).collect();
        let frequencies = |at: &dyn Fn(usize) -> f64| -> Vec<f64> {
            columns
                .clone()
                .flat_map(|i| offsets.iter().map(move |o| (i, o)))
                .map(|(i, o)| (at(i) + o) / wavelength_nm)
                .collect()
        };
        let frequency = [frequencies(&|i| grid.u(i)), frequencies(&|i| grid.v(i))];
        let taps = [0, 1].map(|axis| kernel.taps(&frequency[axis], step[axis], box_width / wavelength_nm));
        Self { samples, columns, frequency, taps }
    }
}

/// Everything one wavelength needs on one ring.
struct Wave<'a> {
    spectra: &'a Spectra,
    grid: &'a Grid,
    ring: &'a Ring,
    quantity: Quantity,
    wavelength_nm: f64,
    colour: [f32; 3],
    /// Box samples per axis, and the first column of the ring.
    samples: usize,
    columns: std::ops::Range<usize>,
    taps_x: Taps,
    /// Taps of every texel row (and box sample) from the ring's first row on.
    taps_y: Taps,
    /// Window transforms at the taps' targets, for the cross term.
    window: [Vec<f32>; 2],
}

impl<'a> Wave<'a> {
    fn new(
        spectra: &'a Spectra,
        grid: &'a Grid,
        ring: &'a Ring,
        filter: BoxFilter,
        quantity: Quantity,
        wavelength_nm: f64,
        colour: [f32; 3],
    ) -> Self {
        let targets = Targets::new(grid, ring, filter, spectra.kernel, spectra.step, wavelength_nm);
        let [taps_x, taps_y] = targets.taps;
        let [xi, eta] = targets.frequency;
        let transforms = |axis: usize, f: &[f64]| match quantity {
            Quantity::Power => Vec::new(),
            Quantity::Cross => f.iter().map(|&f| spectra.window_transform(axis, f) as f32).collect(),
        };
        Self {
            taps_x,
            taps_y,
            window: [transforms(0, &xi), transforms(1, &eta)],
            spectra,
            grid,
            ring,
            quantity,
            wavelength_nm,
            colour,
            samples: targets.samples,
            columns: targets.columns,
        }
    }

    /// `B` lanes of `w`; `N` lanes in flight: twice as many for amplitudes (real, then imaginary).
    fn sweep<const B: usize, const N: usize>(&self, nodes: &[f64], group: usize, sums: &mut PowerSums) {
        let k = TAU / self.wavelength_nm;
        let mut weights = vec![[[0.0f32; 4]; B]; self.spectra.nodes];
        let mut phasor = [[Complex::<f32>::default(); 4]; B];
        for (j, w) in nodes.iter().enumerate() {
            for (row, weight) in weights.iter_mut().zip(self.spectra.node_weights(k * w)) {
                row[j / 4][j % 4] = (k * weight) as f32;
            }
            let mean = self.spectra.mean_phasor_at(k * w);
            phasor[j / 4][j % 4] = Complex::new(mean.re as f32, mean.im as f32);
        }
        let (first_row, rows) = self.interpolated_rows::<B, N>(&weights);
        let targets = self.taps_x.first.len();
        let row_length = self.grid.size * 3 * sums.nodes;
        let per_texel = sums.nodes;
        let ring_rows = self.columns.clone();
        sums.data.par_chunks_mut(row_length).enumerate().filter(|(row, _)| ring_rows.contains(row)).for_each(
            |(row, out)| {
                let v = self.grid.v(row);
                let outer = self.grid.columns_within((self.ring.rho[1].powi(2) - v * v).max(0.0).sqrt());
                let inner = inner_columns(self.grid, self.ring.rho[0], v);
                for column in outer.filter(|c| !inner.contains(c)) {
                    let power = self.texel::<B, N>(row, column, &rows, first_row, targets, &phasor);
                    let texel = &mut out[column * 3 * per_texel..(column + 1) * 3 * per_texel];
                    for (channel, colour) in texel.chunks_exact_mut(per_texel).zip(self.colour) {
                        for (slot, value) in channel[group..].iter_mut().zip(power.as_flattened()) {
                            *slot += colour * value;
                        }
                    }
                }
            },
        );
    }

    /// Pass A: rows of η lines, interpolated along ξ to the targets; also the first line's index.
    ///
    /// Only what pass B will read is filled: for each line, the columns of the ring's texels whose
    /// kernel reaches it.
    fn interpolated_rows<const B: usize, const N: usize>(&self, weights: &[[Lane; B]]) -> (i32, Vec<[Lane; N]>) {
        let (first_x, last_x) = span(&self.taps_x);
        let (first_y, last_y) = span(&self.taps_y);
        let targets = self.taps_x.first.len();
        let mut rows = vec![[[0.0f32; 4]; N]; (last_y - first_y) as usize * targets];
        rows.par_chunks_mut(targets).enumerate().for_each_init(
            || vec![[[0.0f32; 4]; N]; (last_x - first_x) as usize],
            |line, (index, out)| {
                let row = first_y + index as i32;
                for segment in self.targets_of_line(row) {
                    self.fill_segment::<B, N>(row, segment, weights, line, out);
                }
            },
        );
        (first_y, rows)
    }

    /// Targets along x that some texel of the ring reads from a line of η: left and right of the hole.
    fn targets_of_line(&self, row: i32) -> [std::ops::Range<usize>; 2] {
        let step = self.spectra.step[1];
        let reach = self.taps_y.count as f64 * 0.5 * step;
        let v = f64::from(row).abs() * step * self.wavelength_nm;
        // Half a texel more for the box samples around a texel's centre.
        let slack = reach * self.wavelength_nm + self.grid.texel();
        let (nearest, farthest) = ((v - slack).max(0.0), v + slack);
        let [inner, outer] = self.ring.rho;
        let outer = self.grid.columns_within((outer * outer - nearest * nearest).max(0.0).sqrt());
        let hole = inner_columns(self.grid, inner, farthest);
        let local = |column: usize| (column.max(self.columns.start) - self.columns.start) * self.samples;
        if hole.is_empty() {
            return [local(outer.start)..local(outer.end), 0..0];
        }
        [local(outer.start)..local(hole.start), local(hole.end)..local(outer.end)]
    }

    /// One run of targets on one line: combines the depth nodes, then interpolates along ξ.
    #[inline(always)]
    fn fill_segment<const B: usize, const N: usize>(
        &self,
        row: i32,
        segment: std::ops::Range<usize>,
        weights: &[[Lane; B]],
        line: &mut [[Lane; N]],
        out: &mut [[Lane; N]],
    ) {
        let spectra = self.spectra;
        let row = row - spectra.first[1];
        if segment.is_empty() || !(0..spectra.lines[1] as i32).contains(&row) {
            return;
        }
        let firsts = &self.taps_x.first[segment.clone()];
        let first_x = firsts[0];
        let cells = (firsts[firsts.len() - 1] - first_x) as usize + self.taps_x.count;
        let stored = spectra.lines[0] * spectra.nodes;
        let data = &spectra.data[row as usize * stored..(row as usize + 1) * stored];
        for (cell, column) in line[..cells].iter_mut().zip(first_x - spectra.first[0]..) {
            *cell = match usize::try_from(column) {
                Ok(column) if column < spectra.lines[0] => {
                    combine::<B, N>(&data[column * spectra.nodes..(column + 1) * spectra.nodes], weights)
                }
                // Past the sampling's limit: nothing is known, nothing is added.
                _ => [[0.0; 4]; N],
            };
        }
        let taps = self.taps_x.weight[segment.start * self.taps_x.count..].chunks_exact(self.taps_x.count);
        for ((out, first), weight) in out[segment].iter_mut().zip(firsts).zip(taps) {
            let start = (first - first_x) as usize;
            *out = weighted_sum(&line[start..start + weight.len()], weight);
        }
    }

    /// Pass B for one texel: the quantity at each `w`, averaged over the box samples.
    #[inline(always)]
    fn texel<const B: usize, const N: usize>(
        &self,
        row: usize,
        column: usize,
        rows: &[[Lane; N]],
        first_row: i32,
        targets: usize,
        phasor: &[[Complex<f32>; 4]; B],
    ) -> [Lane; B] {
        let mut power = [[0.0f32; 4]; B];
        let (local_row, local_column) = (row - self.columns.start, column - self.columns.start);
        for sy in 0..self.samples {
            let ty = local_row * self.samples + sy;
            let start = (self.taps_y.first[ty] - first_row) as usize;
            let weights = &self.taps_y.weight[ty * self.taps_y.count..(ty + 1) * self.taps_y.count];
            for sx in 0..self.samples {
                let tx = local_column * self.samples + sx;
                let mut value = [[0.0f32; 4]; N];
                for (tap, weight) in weights.iter().enumerate() {
                    let cell = &rows[(start + tap) * targets + tx];
                    for (value, cell) in value.iter_mut().zip(cell) {
                        for lane in 0..4 {
                            value[lane] += weight * cell[lane];
                        }
                    }
                }
                match self.quantity {
                    Quantity::Power => add_power::<B, N>(&mut power, &value),
                    Quantity::Cross => {
                        let window = 2.0 * self.window[0][tx] * self.window[1][ty];
                        add_cross::<B, N>(&mut power, &value, phasor, window);
                    }
                }
            }
        }
        let share = 1.0 / (self.samples * self.samples) as f32;
        power.map(|lane| lane.map(|value| value * share))
    }
}

/// First line any tap reads, and one past the last.
pub(super) fn span(taps: &Taps) -> (i32, i32) {
    let first = taps.first.iter().copied().min().unwrap_or(0);
    let last = taps.first.iter().copied().max().unwrap_or(0);
    (first, last + taps.count as i32)
}

/// Columns of a row that lie inside a ring's hole.
pub(super) fn inner_columns(grid: &Grid, rho: f64, v: f64) -> std::ops::Range<usize> {
    let reach = rho * rho - v * v;
    if reach <= 0.0 {
        return 0..0;
    }
    let columns = grid.columns_within(reach.sqrt());
    // The ring includes its inner radius.
    let on_rim = |column: usize| grid.u(column).hypot(v) >= rho;
    let start = columns.start + usize::from(on_rim(columns.start));
    let end = columns.end - usize::from(columns.end > start && on_rim(columns.end - 1));
    start..end.max(start)
}

/// Depth nodes to values of `w`: amplitudes (real lanes, then imaginary), or their powers if `N == B`.
#[inline(always)]
fn combine<const B: usize, const N: usize>(nodes: &[Complex<f32>], weights: &[[Lane; B]]) -> [Lane; N] {
    let (mut re, mut im) = ([[0.0f32; 4]; B], [[0.0f32; 4]; B]);
    for (value, weight) in nodes.iter().zip(weights) {
        for b in 0..B {
            for lane in 0..4 {
                re[b][lane] += weight[b][lane] * value.re;
                im[b][lane] += weight[b][lane] * value.im;
            }
        }
    }
    let mut out = [[0.0f32; 4]; N];
    for b in 0..B {
        if N == B {
            for lane in 0..4 {
                out[b][lane] = re[b][lane] * re[b][lane] + im[b][lane] * im[b][lane];
            }
        } else {
            out[b] = re[b];
            out[B + b] = im[b];
        }
    }
    out
}

#[inline(always)]
fn weighted_sum<const N: usize>(cells: &[[Lane; N]], weights: &[f32]) -> [Lane; N] {
    let mut sum = [[0.0f32; 4]; N];
    for (cell, weight) in cells.iter().zip(weights) {
        for (sum, cell) in sum.iter_mut().zip(cell) {
            for lane in 0..4 {
                sum[lane] += weight * cell[lane];
            }
        }
    }
    sum
}

#[inline(always)]
fn add_power<const B: usize, const N: usize>(power: &mut [Lane; B], value: &[Lane; N]) {
    for b in 0..B {
        for lane in 0..4 {
            power[b][lane] += if N == B {
                value[b][lane]
            } else {
                value[b][lane] * value[b][lane] + value[B + b][lane] * value[B + b][lane]
            };
        }
    }
}

/// `window · Re(c* E)`; the mean over window positions has no cross term and never comes here.
#[inline(always)]
fn add_cross<const B: usize, const N: usize>(
    sum: &mut [Lane; B],
    value: &[Lane; N],
    phasor: &[[Complex<f32>; 4]; B],
    window: f32,
) {
    if N == B {
        return;
    }
    for b in 0..B {
        for lane in 0..4 {
            let c = phasor[b][lane];
            sum[b][lane] += window * (c.re * value[b][lane] + c.im * value[B + b][lane]);
        }
    }
}
