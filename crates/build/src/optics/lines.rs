//! Powers between the stored lines and nodes of a window's transforms, in double precision, four points at a time.
//!
//! Neighbouring wavelengths of two directions read nearly the same lines. So four points go over all the lines that any of
//! them reads, each with its own weights, zero where it does not read: a line is fetched and widened once, sums of four
//! points run in step, and how often each loop runs is known before. Of the weights two to three in ten are zero at
//! [`PICTURE_STEP`](super::reference::PICTURE_STEP), fewer at finer steps.

use rustfft::num_complex::Complex;

use super::kernel::Kernel;
use super::spectra::{LineCounts, Spectra};

/// Points at a time.
const FOUR: usize = 4;

/// Lines that four points may read together, in those that one reads: four sums in step take about twice the time of one.
const SHARED_MOST: f64 = 2.0;

/// Where the power is wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Frequency in 1/nm along x and y.
    pub frequency: [f64; 2],
    /// Phase scale `s = k |w|` in 1/nm.
    pub s: f64,
    /// Wavelength in nm, which sets the window under a source of fixed size.
    pub wavelength_nm: f64,
}

/// Which part of a window's power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// `|P|² / A` in nm², the coherent part apart.
    Total,
    /// `|E|² / A` in nm⁴: without the coherent part, divided by `s²`.
    Diffuse,
}

/// A window's power at a point, without cancellation however small `s` is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WindowPower {
    /// `|c G̃|² / A`; 0 where only the diffuse part is asked for.
    pub coherent: f64,
    /// What is left of `|P|² / A`: the diffuse part and its cross term with the coherent one; `|E|² / A` where only the diffuse
    /// part is asked for.
    pub rest: f64,
}

/// What an evaluation needs besides the transforms; one for each thread spares allocations.
#[derive(Debug, Default)]
pub struct Buffers {
    one: Weights<1>,
    four: Weights<FOUR>,
}

/// Weights of `L` points: of the nodes in `s`, and of the lines along x and y.
#[derive(Debug, Default)]
struct Weights<const L: usize> {
    nodes: Vec<[f64; L]>,
    lines: [Vec<[f64; L]>; 2],
}

/// Whether four points are better off together that read so many times the lines that one reads along x and y.
fn are_shared(grown: [f64; 2]) -> bool {
    grown[0] * grown[1] <= SHARED_MOST
}

/// Lines that points fetch which are a distance (1/nm) along x and y from each other: per point, and how many sums each
/// of them enters at a time.
pub fn lines_fetched(counts: &LineCounts, distance: [f64; 2]) -> (f64, usize) {
    let lines = |axis: usize, more: f64| (counts.read[axis] as f64 + more).min(counts.stored[axis] as f64);
    let more = [0, 1].map(|axis| (FOUR - 1) as f64 * distance[axis].abs() / counts.step[axis]);
    if are_shared([0, 1].map(|axis| 1.0 + more[axis] / counts.read[axis] as f64)) {
        (lines(0, more[0]) * lines(1, more[1]) / FOUR as f64, FOUR)
    } else {
        (lines(0, 0.0) * lines(1, 0.0), 1)
    }
}

impl Spectra {
    /// Calls `found` with the index and the power of each of `count` points, in order: straight from the transforms, the
    /// slow path against which grid and basis are measured. Fast where points that follow each other lie close.
    pub(crate) fn powers(
        &self,
        part: Part,
        count: usize,
        point: impl Fn(usize) -> Point,
        buffers: &mut Buffers,
        mut found: impl FnMut(usize, WindowPower),
    ) {
        for first in (0..count).step_by(FOUR) {
            let points: [Point; FOUR] = std::array::from_fn(|i| point((first + i).min(count - 1)));
            let here = first..(first + FOUR).min(count);
            if here.len() > 1 && self.share_lines(&points) {
                let powers = self.powers_of(part, &points, &mut buffers.four);
                here.zip(powers).for_each(|(index, power)| found(index, power));
            } else {
                for (index, point) in here.zip(points) {
                    let [power] = self.powers_of(part, &[point], &mut buffers.one);
                    found(index, power);
                }
            }
        }
    }

    /// Whether points read so much the same lines that they are better off together.
    fn share_lines(&self, points: &[Point]) -> bool {
        let grown = [0, 1].map(|axis| {
            let frequencies = points.iter().map(|point| point.frequency[axis]);
            let [low, high] = frequencies.fold([f64::MAX, f64::MIN], |[low, high], f| [low.min(f), high.max(f)]);
            let width = 2.0 * self.kernel.half_width(self.step[axis], 0.0);
            1.0 + (high - low) / width.max(self.step[axis])
        });
        are_shared(grown)
    }

    #[inline(always)]
    fn powers_of<const L: usize>(&self, part: Part, points: &[Point; L], weights: &mut Weights<L>) -> [WindowPower; L] {
        let s = points.map(|point| point.s);
        self.over_phase.weights_of(s, &mut weights.nodes);
        let frequency = [0, 1].map(|axis| points.map(|point| point.frequency[axis]));
        let nm = points.map(|point| point.wavelength_nm);
        let kernels = nm.map(|nm| self.kernel_at(nm));
        let coherent = match part {
            Part::Diffuse => [Complex::default(); L],
            Part::Total => {
                let [x, y] = [0, 1].map(|axis| self.window_transforms(axis, frequency[axis], nm));
                let mean = self.mean_phasors(&weights.nodes);
                std::array::from_fn(|i| mean[i] * x[i] * y[i])
            }
        };
        let scale = match part {
            Part::Diffuse => [1.0; L],
            Part::Total => s,
        };
        if self.mean_power {
            let power_of = |re: [f64; L], im: [f64; L]| [std::array::from_fn(|i| re[i] * re[i] + im[i] * im[i])];
            let [power] = self.sums_over_lines(kernels, frequency, weights, power_of);
            std::array::from_fn(|i| WindowPower {
                coherent: coherent[i].norm_sqr(),
                rest: scale[i] * scale[i] * power[i],
            })
        } else {
            let [re, im] = self.sums_over_lines(kernels, frequency, weights, |re, im| [re, im]);
            std::array::from_fn(|i| {
                let rest = Complex::new(re[i], im[i]) * scale[i];
                let cross = 2.0 * (coherent[i].conj() * rest).re;
                WindowPower { coherent: coherent[i].norm_sqr(), rest: cross + rest.norm_sqr() }
            })
        }
    }

    fn mean_phasors<const L: usize>(&self, node_weights: &[[f64; L]]) -> [Complex<f64>; L] {
        let mut sums = [Complex::default(); L];
        for (phasor, weights) in self.mean_phasor.iter().zip(node_weights) {
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum += phasor * weight;
            }
        }
        sums
    }

    /// Sums over the lines around each point, with the kernel's weights, of numbers made from `E / sqrt(A)`.
    #[inline(always)]
    fn sums_over_lines<const L: usize, const N: usize>(
        &self,
        kernels: [Kernel; L],
        frequency: [[f64; L]; 2],
        weights: &mut Weights<L>,
        numbers: impl Fn([f64; L], [f64; L]) -> [[f64; L]; N],
    ) -> [[f64; L]; N] {
        let Weights { nodes: node_weights, lines: [along_x, along_y] } = weights;
        let first_column = self.stored_lines(0, kernels, frequency[0], along_x);
        let first_row = self.stored_lines(1, kernels, frequency[1], along_y);
        let mut sums = [[0.0; L]; N];
        for (row, row_weights) in (first_row..).zip(&*along_y) {
            let start = (row * self.lines[0] + first_column) * self.nodes;
            let lines = &self.data[start..start + along_x.len() * self.nodes];
            let mut row_sums = [[0.0; L]; N];
            for (line, line_weights) in lines.chunks_exact(self.nodes).zip(&*along_x) {
                let [re, im] = at_phase_scales(line, node_weights);
                add_products(&mut row_sums, &numbers(re, im), line_weights);
            }
            add_products(&mut sums, &row_sums, row_weights);
        }
        sums
    }

    /// Weights of the stored lines along one axis that points read, and the index of the first; what lies outside of what
    /// is stored is left out.
    fn stored_lines<const L: usize>(
        &self,
        axis: usize,
        kernels: [Kernel; L],
        frequency: [f64; L],
        weights: &mut Vec<[f64; L]>,
    ) -> usize {
        let first = Kernel::line_weights(kernels, frequency, self.step[axis], weights) - i64::from(self.first[axis]);
        let skipped = usize::try_from(-first).unwrap_or(0).min(weights.len());
        weights.drain(..skipped);
        let first = usize::try_from(first).unwrap_or(0).min(self.lines[axis]);
        weights.truncate(self.lines[axis] - first);
        first
    }
}

/// `E` of one line at the phase scales that weights of its nodes stand for: real and imaginary parts.
#[inline(always)]
fn at_phase_scales<const L: usize>(line: &[Complex<f32>], node_weights: &[[f64; L]]) -> [[f64; L]; 2] {
    let mut sums = [[0.0; L]; 2];
    for (e, weights) in line.iter().zip(node_weights) {
        let [re, im] = [f64::from(e.re), f64::from(e.im)];
        for i in 0..L {
            sums[0][i] += re * weights[i];
            sums[1][i] += im * weights[i];
        }
    }
    sums
}

#[inline(always)]
fn add_products<const L: usize, const N: usize>(sums: &mut [[f64; L]; N], numbers: &[[f64; L]; N], weights: &[f64; L]) {
    for (sum, number) in sums.iter_mut().zip(numbers) {
        for i in 0..L {
            sum[i] += number[i] * weights[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::height::HeightField;
    use crate::optics::config::{Edge, OpticsConfig, Windows};
    use crate::optics::spectra::{SpectraConfig, transform};
    use crate::optics::window::Placement;
    use diffraction_brdf::spectrum::Illuminant;
    use ndarray::Array2;

    const SIGMA_NM: f64 = 300.0;
    const NM: f64 = 500.0;

    /// Transforms of a rough surface of 24 by 20 samples, for frequencies up to 2e-3 /nm.
    fn spectra(placement: Placement) -> Spectra {
        let height = |(row, column): (usize, usize)| ((row * 37 + column * 101 + row * column * 13) % 64) as f64 * 4.0;
        let field = HeightField { heights_nm: Array2::from_shape_fn((20, 24), height), pitch_nm: [110.0, 90.0] };
        let optics = OpticsConfig::ideal(Illuminant::E, SIGMA_NM, Edge::Tile, Windows::Grid);
        let config = SpectraConfig {
            phase_scale_per_nm: [0.0, 0.033],
            frequency: [[-2e-3, 2e-3]; 2],
            tolerance: 1e-6,
            memory_bytes: 1 << 24,
        };
        transform(&field, placement, &optics, &config).unwrap()
    }

    /// The power as its formula says: one point, line after line, each weight by itself.
    fn plain(spectra: &Spectra, part: Part, point: Point) -> f64 {
        let node_weights = spectra.over_phase.weights(point.s);
        let mut sum = Complex::new(0.0, 0.0);
        let mut power = 0.0;
        let [reads_x, reads_y] = [0, 1].map(|axis| {
            let (step, frequency) = (spectra.step[axis], point.frequency[axis]);
            let half = spectra.kernel.half_width(step, 0.0) / step;
            let first = (frequency / step - half).ceil() as i32;
            let lines = first..first + (2.0 * half).ceil().max(1.0) as i32;
            let stored = spectra.first[axis]..spectra.first[axis] + spectra.lines[axis] as i32;
            let weight = |line: i32| spectra.kernel.value(frequency - f64::from(line) * step, step, 0.0);
            lines.filter(|line| stored.contains(line)).map(|line| (line, weight(line))).collect::<Vec<_>>()
        });
        for (row, y) in &reads_y {
            for (column, x) in &reads_x {
                let [column, row] = [column - spectra.first[0], row - spectra.first[1]].map(|i| i as usize);
                let nodes = &spectra.data[(row * spectra.lines[0] + column) * spectra.nodes..][..spectra.nodes];
                let wide = nodes.iter().map(|e| Complex::new(f64::from(e.re), f64::from(e.im)));
                let e: Complex<f64> = wide.zip(&node_weights).map(|(e, weight)| e * weight).sum();
                sum += e * x * y;
                power += e.norm_sqr() * x * y;
            }
        }
        let window: f64 = [0, 1]
            .map(|axis| spectra.window_transform(axis, point.frequency[axis], point.wavelength_nm))
            .iter()
            .product();
        let coherent = spectra.mean_phasor_at(point.s) * window;
        match (part, spectra.mean_power) {
            (Part::Diffuse, true) => power,
            (Part::Diffuse, false) => sum.norm_sqr(),
            (Part::Total, true) => coherent.norm_sqr() + point.s.powi(2) * power,
            (Part::Total, false) => (coherent + sum * point.s).norm_sqr(),
        }
    }

    /// Points along a line through the origin, as the wavelengths of two directions are.
    fn ray(count: usize, step: f64, towards: [f64; 2]) -> Vec<Point> {
        let at = |i: usize| 8e-4 + i as f64 * step;
        (0..count).map(|i| Point { frequency: towards.map(|f| f * at(i)), s: 9.0 * at(i), wavelength_nm: NM }).collect()
    }

    #[test]
    fn powers_are_those_of_each_point_by_itself() {
        let inside = Placement::Inside { centre_nm: [40.0, -70.0] };
        for placement in [Placement::TileMean, Placement::TileCentre, inside] {
            let spectra = spectra(placement);
            let node = Point { frequency: [2e-4, -1e-4], s: spectra.over_phase.nodes()[2], wavelength_nm: NM };
            let cases = [
                // Close together and a number that four does not divide; two for each of many phase scales.
                (true, ray(11, 1e-5, [1.0, -0.6])),
                (
                    true,
                    (0..6)
                        .map(|i| Point { frequency: [-3e-4, 4e-4], s: 0.005 * f64::from(i), wavelength_nm: NM })
                        .collect(),
                ),
                // Far apart, and one alone.
                (
                    false,
                    (0..7)
                        .map(|i| Point { frequency: [1.8e-3 * f64::from(i % 3 - 1); 2], s: 0.01, wavelength_nm: NM })
                        .collect(),
                ),
                (false, ray(1, 0.0, [-0.3, 0.1])),
                // At a node; beyond what is stored, by half and wholly.
                (true, vec![node; 3]),
                (true, ray(4, 1e-5, [-2.9, 0.2])),
                (true, ray(4, 1e-5, [0.0, 9.0])),
                (true, ray(4, 1e-5, [9.0, 0.0])),
                (true, ray(4, 1e-5, [9.0, 9.0])),
                (false, ray(1, 0.0, [-9.0, 9.0])),
            ];
            for (are_shared, points) in cases {
                let together = points.len() > 1 && spectra.share_lines(&points[..points.len().min(FOUR)]);
                assert_eq!(together, are_shared, "{placement:?} {points:?}");
                for part in [Part::Total, Part::Diffuse] {
                    let mut found = Vec::new();
                    let mut buffers = Buffers::default();
                    spectra.powers(
                        part,
                        points.len(),
                        |i| points[i],
                        &mut buffers,
                        |index, power| {
                            assert_eq!(index, found.len());
                            found.push(power.coherent + power.rest);
                        },
                    );
                    let expected: Vec<f64> = points.iter().map(|&point| plain(&spectra, part, point)).collect();
                    let largest = expected.iter().copied().fold(0.0, f64::max);
                    for (found, expected) in found.iter().zip(&expected) {
                        // A few hundred sums, and weights whose rounding grows with the square of a dozen lines.
                        assert!(
                            (found - expected).abs() <= 1e-12 * largest,
                            "{placement:?} {part:?} {found} {expected}"
                        );
                    }
                }
            }
            let [a, b] =
                [9e-4, 9.001e-4].map(|at| Point { frequency: [at, -0.6 * at], s: 9.0 * at, wavelength_nm: NM });
            let [a, b] = [a, b].map(|point| plain(&spectra, Part::Total, point));
            assert!((a - b).abs() > 1e-7 * a, "a ten-thousandth of a wavelength shows");
        }
    }

    #[test]
    fn lines_fetched_are_counted_without_fetching() {
        let placement = Placement::TileMean;
        let spectra = spectra(placement);
        let counts = LineCounts {
            step: spectra.step,
            stored: spectra.lines,
            read: [0, 1].map(|axis| {
                let mut weights = Vec::new();
                Kernel::line_weights([spectra.kernel], [0.0], spectra.step[axis], &mut weights);
                weights.len()
            }),
            samples: [24, 20],
            padded: [24, 20],
        };
        for (step, most) in [(1e-6, 1), (1.5e-4, 1), (3e-3, 0)] {
            let points = ray(FOUR, step, [0.3, -0.2]);
            let points: [Point; FOUR] = points.try_into().unwrap();
            let fetched: [usize; 2] = [0, 1].map(|axis| {
                let mut weights = Vec::new();
                spectra.stored_lines(
                    axis,
                    [spectra.kernel; FOUR],
                    points.map(|point| point.frequency[axis]),
                    &mut weights,
                );
                weights.len()
            });
            let (lines, sums) = lines_fetched(&counts, [0.3 * step, 0.2 * step]);
            assert_eq!(sums == FOUR, spectra.share_lines(&points), "{step}");
            assert_eq!(sums == FOUR, most == 1, "{step}");
            if sums == FOUR {
                // Where the first line lies between the points is not known: one line more or less along each axis.
                let found = lines * FOUR as f64;
                let [low, high] = [-1.0, 1.0].map(|more| (fetched[0] as f64 + more) * (fetched[1] as f64 + more));
                assert!((low..=high).contains(&found), "{step}: {found} of {fetched:?}");
            }
        }
    }
}
