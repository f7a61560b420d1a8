//! The lines of a surface that the direct sum adds up along one axis, with the weights of its samples.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::rc::Rc;

use rustfft::num_complex::Complex;

use super::config::OpticsConfig;
use super::kernel::Kernel;
use super::window::{Placement, WindowAxis, window_axis};
use crate::height::HeightField;
use diffraction_brdf::direction::Vec3;

/// One axis of a window on a scan, and the standard deviation of what blurs its lines.
pub(super) struct Along<'a> {
    pub(super) axis: &'a WindowAxis,
    pub(super) count: usize,
    pub(super) pitch_nm: f64,
    pub(super) sigma_nm: f64,
}

/// Complex weights of the samples along one axis for one line.
pub(super) struct Line {
    pub(super) re: Vec<f64>,
    pub(super) im: Vec<f64>,
}

impl Line {
    fn new(samples: impl Iterator<Item = Complex<f64>>) -> Rc<Self> {
        let (re, im) = samples.map(|sample| (sample.re, sample.im)).unzip();
        Rc::new(Self { re, im })
    }
}

/// Lines of a repeated scan by their number: their weights are the same at every wavelength that reaches them.
pub(super) type KnownLines = BTreeMap<i64, Rc<Line>>;

/// The lines along one axis (one unless the mean over all positions is taken), and the factor of each line's power.
pub(super) struct AxisLines {
    pub(super) lines: Vec<Rc<Line>>,
    pub(super) power: Vec<f64>,
    /// Which of the lines has the frequency 0.
    pub(super) middle: Option<usize>,
}

impl AxisLines {
    fn one(samples: impl Iterator<Item = Complex<f64>>, power: f64) -> Self {
        Self { lines: vec![Line::new(samples)], power: vec![power], middle: None }
    }
}

/// What the direct sum needs along an axis at a frequency in 1/nm; lines that were met before are taken from `known`.
pub(super) fn axis_lines(placement: Placement, along: &Along, frequency: f64, known: &mut KnownLines) -> AxisLines {
    let positions = &along.axis.position_nm;
    let nothing = || AxisLines::one(positions.iter().map(|_| Complex::default()), 0.0);
    // Past the sampling's own limit the surface is unknown; its alias would be a wrong answer.
    if frequency.abs() * along.pitch_nm > 0.5 && along.count > 1 {
        return nothing();
    }
    match placement {
        Placement::Inside { .. } => {
            let samples = positions.iter().zip(&along.axis.amplitude);
            let scale = along.pitch_nm / along.axis.norm_nm.sqrt();
            AxisLines::one(samples.map(|(x, g)| Complex::from_polar(scale * g, TAU * frequency * x)), 1.0)
        }
        Placement::TileCentre => AxisLines::one(tile_centre_weights(along, frequency).into_iter(), 1.0),
        Placement::TileMean => {
            let weights = tile_mean_weights(along, frequency, known);
            if weights.lines.is_empty() { nothing() } else { weights }
        }
    }
}

/// The lines of a repeated scan that its window's power reaches.
fn tile_lines(along: &Along, frequency: f64) -> impl Iterator<Item = i64> {
    let period = along.count as f64 * along.pitch_nm;
    let half = Kernel::GaussianPower { sigma_nm: along.sigma_nm }.half_width(1.0 / period, 0.0) * period;
    let centre = frequency * period;
    let lines = (centre - half).ceil() as i64..=(centre + half).floor() as i64;
    // A single sample is a surface without structure along this axis: its other lines are aliases.
    let single = along.count == 1;
    lines.filter(move |&line| !single || line == 0)
}

/// One window on the repeated scan: a sample counts with all its images.
fn tile_centre_weights(along: &Along, frequency: f64) -> Vec<Complex<f64>> {
    let period = along.count as f64 * along.pitch_nm;
    let reach = (8.0 * along.sigma_nm / period).ceil() as i64 + 1;
    let scale = along.pitch_nm / (PI.sqrt() * along.sigma_nm).sqrt();
    let of_sample = |x: &f64| {
        let images = (-reach..=reach).map(|j| {
            let x = x + j as f64 * period;
            let g = (-0.5 * (x / along.sigma_nm).powi(2)).exp();
            Complex::from_polar(scale * g, TAU * frequency * x)
        });
        images.sum()
    };
    along.axis.position_nm.iter().map(of_sample).collect()
}

/// The mean over all windows: the lines of the repeated scan that the window's power reaches, each with its share.
fn tile_mean_weights(along: &Along, frequency: f64, known: &mut KnownLines) -> AxisLines {
    let period = along.count as f64 * along.pitch_nm;
    let kernel = Kernel::GaussianPower { sigma_nm: along.sigma_nm };
    let scale = 1.0 / along.count as f64;
    let positions = &along.axis.position_nm;
    let samples = |at: f64| positions.iter().map(move |x| Complex::from_polar(scale, TAU * at * x));
    let mut of_line = |line: i64| {
        let at = line as f64 / period;
        let weights = known.entry(line).or_insert_with(|| Line::new(samples(at)));
        (Rc::clone(weights), kernel.value(frequency - at, 1.0 / period, 0.0))
    };
    let (lines, power) = tile_lines(along, frequency).map(&mut of_line).unzip();
    AxisLines { lines, power, middle: tile_lines(along, frequency).position(|line| line == 0) }
}

/// Bytes that the direct sum holds under one window in one direction, at so many wavelengths: weights, and a sum for each two lines.
pub(super) fn held_bytes_at(
    field: &HeightField,
    placement: Placement,
    optics: &OpticsConfig,
    q: Vec3,
    wavelengths: usize,
) -> usize {
    let coherence = optics.body_coherence();
    // Weights of an axis, and the lines at a wavelength.
    let of_axis = |axis: usize| {
        let (count, pitch_nm) = (field.size()[axis], field.pitch_nm[axis]);
        let samples = window_axis(placement, axis, count, pitch_nm, optics.sigma_nm);
        let [shortest, longest] = optics.wavelength_nm.map(|nm| {
            let along = Along { axis: &samples, count, pitch_nm, sigma_nm: coherence.sigma_nm_at(nm) };
            tile_lines(&along, q[axis] / nm).map(|line| [line, line]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
        });
        let (known, at_once) = match (placement, shortest, longest) {
            (Placement::TileMean, Some([a, b]), Some([c, d])) => (b.max(d) - a.min(c) + 1, (b - a).max(d - c) + 1),
            (Placement::TileMean, ..) => (1, 1),
            // They have the same line at each wavelength, with other weights.
            (Placement::Inside { .. } | Placement::TileCentre, ..) => (wavelengths as i64, 1),
        };
        (known as usize * samples.position_nm.len() * size_of::<Complex<f64>>(), at_once as usize)
    };
    let ([x_bytes, x_lines], [y_bytes, y_lines]) = (<[usize; 2]>::from(of_axis(0)), <[usize; 2]>::from(of_axis(1)));
    x_bytes + y_bytes + wavelengths * x_lines * y_lines * size_of::<Complex<f64>>()
}
