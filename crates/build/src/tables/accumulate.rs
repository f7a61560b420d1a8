//! The inner loops: spectra of one wavelength interpolated to every texel, squared, summed into XYZ.
//!
//! For a few wavelengths at a time: (A) for every line of η, the nodes in phase scale are combined into a few values of `w`
//! and interpolated along ξ to the texel columns; (B) for every texel row, those rows are interpolated along
//! η, squared and added. Both are loops over lanes of four `w` values; A and B run in parallel over rows
//! that nobody else writes, wavelengths follow one another: the sums never depend on the threads.

use std::f64::consts::TAU;
use std::ops::Range;

use glam::Vec4;
use rayon::prelude::*;
use rustfft::num_complex::Complex;

use super::grid::Grid;
use super::rings::Ring;
use super::texels::{Texels, inner_columns};
use crate::optics::kernel::{Kernel, Taps};
use crate::optics::spectra::Spectra;

/// Values of `w` in a lane, which a processor handles as one: sums are kept at multiples of so many nodes.
pub(super) const SIMD_WIDTH: usize = 4;

/// One lane of values.
type Lane = Vec4;

/// Most lanes handled in one pass; more nodes take further passes.
pub(super) const LANES_PER_PASS: usize = 4;

/// Wavelengths summed in one pass: the sums, far larger than any cache, are read and written once for all of them.
pub(super) const WAVELENGTHS_PER_PASS: usize = 4;

/// Columns of a row that a pass takes together.
const BLOCK: usize = 16;

/// Sums of XYZ, or of one channel, at the nodes of `w`: layout `[row][column][channel][node]` over the texels' window.
#[derive(Debug, Clone)]
pub struct PowerSums {
    /// Three for XYZ, one for a wavelength by itself.
    pub channels: usize,
    /// Nodes of `w` per texel, a multiple of the SIMD width.
    pub nodes: usize,
    /// The sums in 1/sr (before geometry and reflectance).
    pub data: Vec<f32>,
}

impl PowerSums {
    /// Zero everywhere.
    pub fn new(texels: &Texels, channels: usize, nodes: usize) -> Self {
        assert!(matches!(channels, 1 | 3), "sums have one channel or three");
        let nodes = nodes.next_multiple_of(SIMD_WIDTH);
        Self { channels, nodes, data: vec![0.0; texels.window_texels() * channels * nodes] }
    }

    /// Numbers of one texel.
    pub fn per_texel(&self) -> usize {
        self.channels * self.nodes
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

/// What is summed, and over which texels.
#[derive(Debug, Clone, Copy)]
pub struct RingSum<'a> {
    /// The texels of the table or patch that count.
    pub texels: &'a Texels,
    /// Those of them that are summed now, and their wavelengths.
    pub ring: &'a Ring,
    /// Average over (u, v) of a texel.
    pub filter: BoxFilter,
    /// What is summed.
    pub quantity: Quantity,
    /// Weight of this window among all.
    pub share: f64,
}

/// Adds one window's contribution over a ring, for the values of `w` in `w_nodes`.
pub fn add_ring(spectra: &Spectra, what: RingSum, w_nodes: &[f64], sums: &mut PowerSums) {
    let quadrature = &what.ring.quadrature;
    let Some(part) = RingTexels::new(what.texels, what.ring.radius) else { return };
    let mut scratch = vec![Vec::new(); WAVELENGTHS_PER_PASS];
    let bands =
        quadrature.wavelengths_nm.chunks(WAVELENGTHS_PER_PASS).zip(quadrature.weights.chunks(WAVELENGTHS_PER_PASS));
    for (wavelengths_nm, weights) in bands {
        let wave = |(&wavelength_nm, weights): (&f64, &[f64; 3])| {
            let scale = what.share / (wavelength_nm * wavelength_nm);
            Wave::new(spectra, what, &part, wavelength_nm, weights.map(|weight| (weight * scale) as f32))
        };
        let waves: Vec<Wave> = wavelengths_nm.iter().zip(weights).map(wave).collect();
        for first_node in (0..w_nodes.len()).step_by(SIMD_WIDTH * LANES_PER_PASS) {
            let nodes = &w_nodes[first_node..w_nodes.len().min(first_node + SIMD_WIDTH * LANES_PER_PASS)];
            match sums.channels {
                1 => pass_of_channels::<1>(&waves, nodes, first_node, &mut scratch, sums),
                _ => pass_of_channels::<3>(&waves, nodes, first_node, &mut scratch, sums),
            }
        }
    }
}

/// Adds a few wavelengths to `C` channels: the pass for as many lanes as the nodes fill.
fn pass_of_channels<const C: usize>(
    waves: &[Wave],
    nodes: &[f64],
    first_node: usize,
    scratch: &mut [Vec<Lane>],
    sums: &mut PowerSums,
) {
    let is_power = waves.first().is_some_and(|wave| wave.spectra.mean_power);
    match (nodes.len().div_ceil(SIMD_WIDTH), is_power) {
        (1, true) => pass::<1, 1, C>(waves, nodes, first_node, scratch, sums),
        (2, true) => pass::<2, 2, C>(waves, nodes, first_node, scratch, sums),
        (3, true) => pass::<3, 3, C>(waves, nodes, first_node, scratch, sums),
        (_, true) => pass::<4, 4, C>(waves, nodes, first_node, scratch, sums),
        (1, false) => pass::<1, 2, C>(waves, nodes, first_node, scratch, sums),
        (2, false) => pass::<2, 4, C>(waves, nodes, first_node, scratch, sums),
        (3, false) => pass::<3, 6, C>(waves, nodes, first_node, scratch, sums),
        (_, false) => pass::<4, 8, C>(waves, nodes, first_node, scratch, sums),
    }
}

/// The frequencies a ring's texels ask for at one wavelength, and the taps that interpolate them.
pub(super) struct Targets {
    /// Box samples per texel and axis.
    pub samples: usize,
    /// Frequencies in 1/nm along x and y, box samples of a texel side by side.
    pub frequency: [Vec<f64>; 2],
    /// Their taps.
    pub taps: [Taps; 2],
}

impl Targets {
    /// For the texels of some rows and columns of a grid.
    pub(super) fn new(
        grid: &Grid,
        [rows, columns]: [Range<usize>; 2],
        filter: BoxFilter,
        kernel: Kernel,
        step: [f64; 2],
        wavelength_nm: f64,
    ) -> Self {
        // A mean over window positions is a sum of powers: its kernel averages the box exactly.
        let mean_power = matches!(kernel, Kernel::GaussianPower { .. });
        let (samples, box_width) = if mean_power { (1, filter.width) } else { (filter.samples, 0.0) };
        let offsets: Vec<f64> =
            (0..samples).map(|i| ((i as f64 + 0.5) / samples as f64 - 0.5) * filter.width).collect();
        let frequencies = |texels: Range<usize>, at: &dyn Fn(usize) -> f64| -> Vec<f64> {
            let samples = texels.flat_map(|i| offsets.iter().map(move |o| (i, o)));
            samples.map(|(i, o)| (at(i) + o) / wavelength_nm).collect()
        };
        let frequency = [frequencies(columns, &|i| grid.u(i)), frequencies(rows, &|i| grid.v(i))];
        let taps = [0, 1].map(|axis| kernel.taps(&frequency[axis], step[axis], box_width / wavelength_nm));
        Self { samples, frequency, taps }
    }
}

/// Adds a few wavelengths to `C` channels. `B` lanes of `w`; `N` lanes in flight: twice as many for amplitudes (real, then
/// imaginary). `scratch` is kept from pass to pass.
fn pass<const B: usize, const N: usize, const C: usize>(
    waves: &[Wave],
    nodes: &[f64],
    first_node: usize,
    scratch: &mut [Vec<Lane>],
    sums: &mut PowerSums,
) {
    let filled: Vec<Filled<B, N>> =
        waves.iter().zip(scratch).map(|(wave, scratch)| wave.filled::<B, N>(nodes, scratch)).collect();
    let Some(Wave { texels, part, .. }) = waves.first() else { return };
    let row_length = texels.columns.len() * sums.per_texel();
    let per_channel = sums.nodes;
    let skipped = part.rows.start - texels.rows.start;
    let lines = sums.data[skipped * row_length..].par_chunks_mut(row_length);
    lines.zip(&part.runs).enumerate().for_each(|(row, (out, runs))| {
        let blocks = runs.iter().flat_map(|run| run.clone().step_by(BLOCK).map(|at| at..run.end.min(at + BLOCK)));
        for block in blocks {
            let mut added = [[[Lane::ZERO; B]; C]; BLOCK];
            for wave in &filled {
                wave.add_block(row, block.clone(), &mut added);
            }
            let first = (block.start - texels.columns.start) * C * per_channel;
            let channels = out[first..first + block.len() * C * per_channel].chunks_exact_mut(per_channel);
            for (channel, added) in channels.zip(added.as_flattened()) {
                let lanes = channel[first_node..].as_chunks_mut::<SIMD_WIDTH>().0.iter_mut().zip(added);
                lanes.for_each(|(slot, added)| *slot = (Lane::from_array(*slot) + *added).to_array());
            }
        }
    });
}

/// A wavelength after pass A.
struct Filled<'a, const B: usize, const N: usize> {
    wave: &'a Wave<'a>,
    /// Lines of η from the first one on, each interpolated to the ring's columns.
    rows: &'a [[Lane; N]],
    first_row: i32,
    /// Mean phasor at the values of `w`: real parts, imaginary parts.
    phasor: [[Lane; B]; 2],
}

/// Everything one wavelength needs on one ring.
struct Wave<'a> {
    spectra: &'a Spectra,
    texels: &'a Texels,
    ring: &'a Ring,
    part: &'a RingTexels,
    quantity: Quantity,
    wavelength_nm: f64,
    /// Weights of the channels; a single one has the first.
    colour: [f32; 3],
    /// Box samples per axis.
    samples: usize,
    taps_x: Taps,
    /// Taps of every texel row (and box sample) from the ring's first row on.
    taps_y: Taps,
    /// Lines of η that each texel row reads.
    lines_of_rows: Vec<Range<i32>>,
    /// Window transforms at the taps' targets, for the cross term.
    window: [Vec<f32>; 2],
}

impl<'a> Wave<'a> {
    fn new(
        spectra: &'a Spectra,
        what: RingSum<'a>,
        part: &'a RingTexels,
        wavelength_nm: f64,
        colour: [f32; 3],
    ) -> Self {
        let RingSum { texels, ring, filter, quantity, .. } = what;
        let box_of = [part.rows.clone(), part.columns.clone()];
        let targets =
            Targets::new(&texels.grid, box_of, filter, spectra.kernel_at(wavelength_nm), spectra.step, wavelength_nm);
        let [taps_x, taps_y] = targets.taps;
        let [xi, eta] = targets.frequency;
        let transforms = |axis: usize, f: &[f64]| match quantity {
            Quantity::Power => Vec::new(),
            Quantity::Cross => f.iter().map(|&f| spectra.window_transform(axis, f, wavelength_nm) as f32).collect(),
        };
        // Box samples go up within a row.
        let lines = |firsts: &[i32]| firsts[0]..firsts[firsts.len() - 1] + taps_y.count as i32;
        Self {
            lines_of_rows: taps_y.first.chunks_exact(targets.samples).map(lines).collect(),
            taps_x,
            taps_y,
            window: [transforms(0, &xi), transforms(1, &eta)],
            spectra,
            texels,
            ring,
            part,
            quantity,
            wavelength_nm,
            colour,
            samples: targets.samples,
        }
    }

    /// Pass A.
    fn filled<'s, const B: usize, const N: usize>(
        &'s self,
        nodes: &[f64],
        scratch: &'s mut Vec<Lane>,
    ) -> Filled<'s, B, N> {
        let k = TAU / self.wavelength_nm;
        let mut weights = vec![[Lane::ZERO; B]; self.spectra.nodes];
        let mut phasor = [[Lane::ZERO; B]; 2];
        for (j, w) in nodes.iter().enumerate() {
            for (row, weight) in weights.iter_mut().zip(self.spectra.node_weights(k * w)) {
                row[j / SIMD_WIDTH][j % SIMD_WIDTH] = (k * weight) as f32;
            }
            let mean = self.spectra.mean_phasor_at(k * w);
            (phasor[0][j / SIMD_WIDTH][j % SIMD_WIDTH], phasor[1][j / SIMD_WIDTH][j % SIMD_WIDTH]) =
                (mean.re as f32, mean.im as f32);
        }
        let (first_row, rows) = self.interpolated_rows::<B, N>(&weights, scratch);
        Filled { wave: self, rows, first_row, phasor }
    }

    /// Rows of η lines, interpolated along ξ to the targets; also the first line's index.
    ///
    /// Only what pass B will read is filled: for each line, the columns of the ring's texels whose
    /// kernel reaches it. The rest of the scratch holds what it held.
    fn interpolated_rows<'s, const B: usize, const N: usize>(
        &self,
        weights: &[[Lane; B]],
        scratch: &'s mut Vec<Lane>,
    ) -> (i32, &'s [[Lane; N]]) {
        let (first_x, last_x) = span(&self.taps_x);
        let (first_y, last_y) = span(&self.taps_y);
        let targets = self.taps_x.first.len();
        let cells = (last_y - first_y) as usize * targets;
        if scratch.len() < cells * N {
            // Wavelengths get shorter and lines more: a little room spares most allocations, and what is there is not
            // needed any more.
            *scratch = Vec::new();
            *scratch = vec![Lane::ZERO; cells * N * 9 / 8];
        }
        let rows = &mut scratch.as_chunks_mut::<N>().0[..cells];
        rows.par_chunks_mut(targets).enumerate().for_each_init(
            || vec![[Lane::ZERO; N]; (last_x - first_x) as usize],
            |line, (index, out)| {
                let row = first_y + index as i32;
                for run in self.columns_of_line(row) {
                    let target = |column: usize| (column - self.part.columns.start) * self.samples;
                    self.fill_segment::<B, N>(row, target(run.start)..target(run.end), weights, line, out);
                }
            },
        );
        (first_y, rows)
    }

    /// Columns whose texels read a line of η.
    fn columns_of_line(&self, line: i32) -> Vec<Range<usize>> {
        if self.texels.is_whole() {
            return self.annulus_of_line(line);
        }
        // Rows go down, and so do the lines they read: the rows that read this line follow one another.
        let start = self.lines_of_rows.partition_point(|lines| lines.start > line);
        let end = self.lines_of_rows.partition_point(|lines| lines.end > line);
        union(&self.part.runs[start.min(end)..end])
    }

    /// The same where all texels of the ring count: left and right of its hole.
    fn annulus_of_line(&self, line: i32) -> Vec<Range<usize>> {
        let grid = &self.texels.grid;
        let step = self.spectra.step[1];
        let reach = self.taps_y.count as f64 * 0.5 * step;
        let v = f64::from(line).abs() * step * self.wavelength_nm;
        // Half a texel more for the box samples around a texel's centre.
        let slack = reach * self.wavelength_nm + grid.texel();
        let (nearest, farthest) = ((v - slack).max(0.0), v + slack);
        let [inner, outer] = self.ring.radius;
        let outer = grid.columns_within((outer * outer - nearest * nearest).max(0.0).sqrt());
        let hole = inner_columns(grid, inner, farthest);
        let own = &self.part.columns;
        let clipped = |run: Range<usize>| run.start.max(own.start)..run.end.min(own.end);
        let runs = if hole.is_empty() { vec![outer] } else { vec![outer.start..hole.start, hole.end..outer.end] };
        runs.into_iter().map(clipped).filter(|run| !run.is_empty()).collect()
    }

    /// One run of targets on one line: combines the nodes in phase scale, then interpolates along ξ.
    #[inline(always)]
    fn fill_segment<const B: usize, const N: usize>(
        &self,
        row: i32,
        segment: Range<usize>,
        weights: &[[Lane; B]],
        line: &mut [[Lane; N]],
        out: &mut [[Lane; N]],
    ) {
        let spectra = self.spectra;
        let row = row - spectra.first[1];
        if segment.is_empty() {
            return;
        }
        if !(0..spectra.lines[1] as i32).contains(&row) {
            // Past the sampling's limit: nothing is known, nothing is added.
            out[segment].fill([Lane::ZERO; N]);
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
                _ => [Lane::ZERO; N],
            };
        }
        let taps = self.taps_x.weight[segment.start * self.taps_x.count..].chunks_exact(self.taps_x.count);
        for ((out, first), weight) in out[segment].iter_mut().zip(firsts).zip(taps) {
            let start = (first - first_x) as usize;
            *out = weighted_sum(&line[start..start + weight.len()], weight);
        }
    }
}

impl<const B: usize, const N: usize> Filled<'_, B, N> {
    /// Pass B for some columns of a row of the ring: adds `C` channels at each `w`, averaged over the box samples.
    #[inline(always)]
    fn add_block<const C: usize>(&self, row: usize, columns: Range<usize>, added: &mut [[[Lane; B]; C]; BLOCK]) {
        let wave = self.wave;
        let (samples, targets) = (wave.samples, wave.taps_x.first.len());
        let count = columns.len();
        let column = (columns.start - wave.part.columns.start) * samples;
        let mut power = [[Lane::ZERO; B]; BLOCK];
        for ty in row * samples..(row + 1) * samples {
            let line = (wave.taps_y.first[ty] - self.first_row) as usize;
            let weights = &wave.taps_y.weight[ty * wave.taps_y.count..(ty + 1) * wave.taps_y.count];
            for first in column..column + samples {
                let mut values = [[Lane::ZERO; N]; BLOCK];
                for (tap, weight) in weights.iter().enumerate() {
                    let cells = &self.rows[(line + tap) * targets..][first..first + (count - 1) * samples + 1];
                    if samples == 1 {
                        values.iter_mut().zip(cells).for_each(|(value, cell)| add_scaled(value, cell, *weight));
                    } else {
                        let cells = cells.iter().step_by(samples);
                        values.iter_mut().zip(cells).for_each(|(value, cell)| add_scaled(value, cell, *weight));
                    }
                }
                let each = power.iter_mut().zip(&values).take(count);
                match wave.quantity {
                    Quantity::Power => each.for_each(|(power, value)| add_power::<B, N>(power, value)),
                    Quantity::Cross => each.enumerate().for_each(|(index, (power, value))| {
                        let window = 2.0 * wave.window[0][first + index * samples] * wave.window[1][ty];
                        add_cross::<B, N>(power, value, &self.phasor, window);
                    }),
                }
            }
        }
        let share = 1.0 / (samples * samples) as f32;
        let colour = wave.colour.map(|colour| colour * share);
        for (added, power) in added.iter_mut().zip(&power).take(count) {
            added.iter_mut().zip(colour).for_each(|(added, colour)| add_scaled(added, power, colour));
        }
    }
}

#[inline(always)]
fn add_scaled<const N: usize>(sum: &mut [Lane; N], value: &[Lane; N], factor: f32) {
    sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += *value * factor);
}

/// First line any tap reads, and one past the last.
pub(super) fn span(taps: &Taps) -> (i32, i32) {
    let first = taps.first.iter().copied().min().unwrap_or(0);
    let last = taps.first.iter().copied().max().unwrap_or(0);
    (first, last + taps.count as i32)
}

/// The texels of one ring: the box around them, and the runs of columns of each row of the box.
pub(super) struct RingTexels {
    pub rows: Range<usize>,
    pub columns: Range<usize>,
    pub runs: Vec<Vec<Range<usize>>>,
}

impl RingTexels {
    /// `None` where the ring has no texel that counts.
    pub(super) fn new(texels: &Texels, radius: [f64; 2]) -> Option<Self> {
        let reached = texels.grid.columns_within(radius[1]);
        let rows = reached.start.max(texels.rows.start)..reached.end.min(texels.rows.end);
        let mut runs: Vec<Vec<Range<usize>>> = rows.clone().map(|row| texels.runs_in(row, radius)).collect();
        let first = runs.iter().position(|runs| !runs.is_empty())?;
        let last = runs.iter().rposition(|runs| !runs.is_empty())?;
        runs.truncate(last + 1);
        runs.drain(..first);
        let columns = runs.iter().flatten();
        let start = columns.clone().map(|run| run.start).min()?;
        let end = columns.map(|run| run.end).max()?;
        Some(Self { rows: rows.start + first..rows.start + last + 1, columns: start..end, runs })
    }
}

/// The runs of several rows, joined where they touch or overlap, ascending.
fn union(rows: &[Vec<Range<usize>>]) -> Vec<Range<usize>> {
    let mut joined: Vec<Range<usize>> = rows.first().cloned().unwrap_or_default();
    for runs in rows {
        // Neighbouring rows mostly have as many runs, each over the one before.
        let overlaps = |(own, run): (&Range<usize>, &Range<usize>)| own.start <= run.end && run.start <= own.end;
        if joined.len() == runs.len() && joined.iter().zip(runs).all(overlaps) {
            for (own, run) in joined.iter_mut().zip(runs) {
                *own = own.start.min(run.start)..own.end.max(run.end);
            }
        } else {
            joined.extend(runs.iter().cloned());
            joined.sort_unstable_by_key(|run| run.start);
            merge(&mut joined);
        }
    }
    merge(&mut joined);
    joined
}

/// Joins ascending runs where they touch or overlap.
fn merge(runs: &mut Vec<Range<usize>>) {
    runs.dedup_by(|run, before| {
        let touches = run.start <= before.end;
        if touches {
            before.end = before.end.max(run.end);
        }
        touches
    });
}

/// Nodes in phase scale to values of `w`: amplitudes (real lanes, then imaginary), or their powers if `N == B`.
#[inline(always)]
fn combine<const B: usize, const N: usize>(nodes: &[Complex<f32>], weights: &[[Lane; B]]) -> [Lane; N] {
    let (mut re, mut im) = ([Lane::ZERO; B], [Lane::ZERO; B]);
    for (value, weight) in nodes.iter().zip(weights) {
        add_scaled(&mut re, weight, value.re);
        add_scaled(&mut im, weight, value.im);
    }
    std::array::from_fn(|n| match (N == B, n < B) {
        (true, _) => re[n] * re[n] + im[n] * im[n],
        (false, true) => re[n],
        (false, false) => im[n - B],
    })
}

#[inline(always)]
fn weighted_sum<const N: usize>(cells: &[[Lane; N]], weights: &[f32]) -> [Lane; N] {
    let mut sum = [Lane::ZERO; N];
    cells.iter().zip(weights).for_each(|(cell, weight)| add_scaled(&mut sum, cell, *weight));
    sum
}

#[inline(always)]
fn add_power<const B: usize, const N: usize>(power: &mut [Lane; B], value: &[Lane; N]) {
    for (b, power) in power.iter_mut().enumerate() {
        *power += if N == B { value[b] } else { value[b] * value[b] + value[B + b] * value[B + b] };
    }
}

/// `window · Re(c* E)`; the mean over window positions has no cross term and never comes here.
#[inline(always)]
fn add_cross<const B: usize, const N: usize>(
    sum: &mut [Lane; B],
    value: &[Lane; N],
    [re, im]: &[[Lane; B]; 2],
    window: f32,
) {
    if N == B {
        return;
    }
    for (b, sum) in sum.iter_mut().enumerate() {
        *sum += (re[b] * value[b] + im[b] * value[B + b]) * window;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// What a line of η is interpolated to holds every column of every row that reads it, in ascending runs.
        #[test]
        fn unions_hold_all_runs(
            rows in proptest::collection::vec(proptest::collection::vec((0usize..60, 1usize..9), 0..4), 0..6),
        ) {
            let rows: Vec<Vec<Range<usize>>> = rows
                .into_iter()
                .map(|mut row| {
                    row.sort_unstable();
                    let mut runs: Vec<_> = row.into_iter().map(|(start, length)| start..start + length).collect();
                    merge(&mut runs);
                    runs
                })
                .collect();
            let joined = union(&rows);
            prop_assert!(joined.windows(2).all(|pair| pair[0].end < pair[1].start));
            for column in 0..70 {
                let wanted = rows.iter().flatten().any(|run| run.contains(&column));
                prop_assert_eq!(joined.iter().any(|run| run.contains(&column)), wanted);
            }
        }
    }
}
