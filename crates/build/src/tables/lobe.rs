//! The coherent lobe: what the mean phasor reflects around the mirror direction, and its cross term.

use std::f64::consts::{SQRT_2, TAU};
use std::ops::Range;

use ndarray::{Array3, Axis};
use rayon::prelude::*;

use super::grid::Grid;
use super::input::BuildInput;
use super::resolution::narrowest_lobe;
use crate::optics::config::OpticsConfig;
use crate::optics::spectra::Spectra;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::{Interpolation, stencil};
use diffraction_brdf::material::{Material, reflectance};
use diffraction_brdf::spectrum::SpectralQuadrature;

/// Texels per standard deviation of the narrowest lobe, along its radius and in the cross patch.
const TEXELS_PER_WIDTH: [f64; 2] = [12.0, 4.0];

/// Fewest wavelengths over which the lobe is integrated: it is a smooth function of `1/λ`...
const WAVELENGTHS: usize = 200;

/// ...but for surfaces with a high relief. `|c|²` consists of waves in `1/λ` at lags `|w| Δh` of height differences, whose standard
/// deviation is `√2 |w|` times the rms height: nodes 0.57 deviations apart, as for the reference.
fn wavelengths_needed(optics: &OpticsConfig, rms_nm: f64) -> usize {
    let [low_nm, high_nm] = optics.wavelength_nm;
    let deviation = 1.0 / (TAU * SQRT_2 * max_abs_w(0.0) * rms_nm);
    WAVELENGTHS.max(((1.0 / low_nm - 1.0 / high_nm) / (0.57 * deviation)).ceil() as usize)
}

/// Radians of the fastest wave between two entries of a [`PhasorPower`]: the cubic through four of them errs by
/// `3/128 0.05⁴` = 1.5e-7 of that wave.
const PHASE_STEP: f64 = 0.05;

/// `|c(s)|² (∬g)² / A` in nm² as a function of the phase scale `s`, averaged over windows: the lobe without the window's shape.
#[derive(Debug, Clone)]
pub(super) struct PhasorPower {
    s_min: f64,
    step: f64,
    /// Values at `s_min`, `s_min + step`, and so on; at least four.
    values: Vec<f64>,
}

impl PhasorPower {
    /// Zero over an interval of `s`, for surfaces whose heights lie within `half_range_nm` of their middle.
    pub fn new([s_min, s_max]: [f64; 2], half_range_nm: f64) -> Self {
        let steps = ((s_max - s_min) * 2.0 * half_range_nm / PHASE_STEP).ceil().max(8.0);
        Self { s_min, step: (s_max - s_min) / steps, values: vec![0.0; steps as usize + 1] }
    }

    /// Adds a window.
    pub fn add(&mut self, spectra: &Spectra, share: f64) {
        let Self { s_min, step, .. } = *self;
        self.values.par_iter_mut().enumerate().for_each(|(index, value)| {
            let c = spectra.mean_phasor_at(s_min + index as f64 * step);
            *value += share * c.norm_sqr() * spectra.lobe_peak_nm2;
        });
    }

    /// The value at `s`. Where transforms stop short of the whole hemisphere, no direction that is covered asks for more:
    /// what lies beyond takes the value at their end.
    fn at(&self, s: f64) -> f64 {
        if self.step <= 0.0 {
            return self.values[0];
        }
        let at = ((s - self.s_min) / self.step).clamp(0.0, (self.values.len() - 1) as f64);
        let (first, weights) = stencil(Interpolation::Cubic, at, self.values.len());
        self.values[first..first + 4].iter().zip(weights).map(|(value, weight)| weight * value).sum()
    }
}

/// Most rows: what every GPU takes as an image's side. An rms height of 16 µm needs as many for a tolerance of 1e-3.
const ROWS_MAX: usize = 8192;

/// Rows of `t` that a linear interpolation needs: near `w = 0`, `|c|² = 1 - (k w h_rms)²`, whose second
/// difference over a step `Δw` is `2 (k h_rms Δw)²`, an eighth of it the error.
fn rows_needed(rms_nm: f64, wavelength_min_nm: f64, tolerance: f64) -> usize {
    let step = (4.0 * tolerance).sqrt() / (TAU / wavelength_min_nm * rms_nm).max(1e-9);
    ((2.0 / step).ceil() as usize).clamp(32, ROWS_MAX - 1) + 1
}

/// Rows beyond those between which a `t` lies that cubics read.
const ROWS_MARGIN: usize = 2;

/// How the coherent table is sampled.
#[derive(Debug, Clone, PartialEq)]
struct Layout {
    rows: usize,
    columns: usize,
    /// The rows that are computed.
    read: Range<usize>,
    quadrature: SpectralQuadrature,
}

/// Rows that look-ups from `t[0]` to `t[1]` read, among those that the tolerance asks for.
fn layout(input: &BuildInput, radius_max: f64, t: [f64; 2]) -> Result<Layout> {
    let BuildInput { optics, rms_nm, wavelength_range_nm: [low_nm, _], .. } = *input;
    let rows = rows_needed(rms_nm, low_nm, input.tables.tolerance);
    let [first, last] = t.map(|t| t * (rows - 1) as f64);
    Ok(Layout {
        rows,
        columns: (radius_max / narrowest_lobe(optics) * TEXELS_PER_WIDTH[0]).ceil() as usize + 1,
        read: (first as usize).saturating_sub(ROWS_MARGIN)..(last.ceil() as usize + ROWS_MARGIN + 1).min(rows),
        quadrature: optics.quadrature(wavelengths_needed(optics, rms_nm))?,
    })
}

/// Texels times wavelengths of the coherent table: arguments as for [`coherent`].
///
/// # Errors
/// `Error::Call` for an invisible light.
pub(super) fn samples(input: &BuildInput, radius_max: f64, t: [f64; 2]) -> Result<f64> {
    let Layout { columns, read, quadrature, .. } = layout(input, radius_max, t)?;
    Ok((read.len() * columns * quadrature.wavelengths_nm.len()) as f64)
}

/// The coherent table, shape `[t, radius, 3]`: rows that look-ups from `t[0]` to `t[1]` read, zero elsewhere.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub(super) fn coherent(power: &PhasorPower, input: &BuildInput, radius_max: f64, t: [f64; 2]) -> Result<Array3<f32>> {
    let Layout { rows, columns, read, quadrature } = layout(input, radius_max, t)?;
    let dispersive = input.optics.dispersion.as_ref();
    let materials = dispersive.map(|dispersive| quadrature.wavelengths_nm.iter().map(|nm| dispersive.material_at(*nm)));
    let materials: Option<Vec<Material>> = materials.map(Iterator::collect);
    // A texel knows the angle at which the lobe is reflected, so its colour is that of this angle.
    let relative = |index: usize, cos_theta_d: f64| {
        let of = |material| reflectance(material, cos_theta_d);
        materials.as_ref().map_or(1.0, |materials| of(materials[index]) / of(input.optics.material))
    };
    let coherence = input.optics.lobe_coherence();
    let mut table = Array3::<f32>::zeros((rows, columns, 3));
    let mut lines = table.slice_axis_mut(Axis(0), read.clone().into());
    lines.axis_iter_mut(Axis(0)).into_par_iter().zip(read).for_each(|(mut line, row)| {
        let t = row as f64 / (rows - 1) as f64;
        for (column, mut texel) in line.outer_iter_mut().enumerate() {
            let radius = radius_max * column as f64 / (columns - 1) as f64;
            let mut sum = [0.0; 3];
            let w = t * max_abs_w(radius);
            let cos_theta_d = 0.5 * radius.hypot(w);
            for (index, (nm, weight)) in quadrature.wavelengths_nm.iter().zip(&quadrature.weights).enumerate() {
                let sigma_nm = coherence.sigma_nm_at(*nm);
                // Transforms know the peak of the largest window.
                let peak = (sigma_nm / input.optics.lobe_sigma_nm()).powi(2);
                let shape = peak * (-(TAU * sigma_nm * radius / nm).powi(2)).exp();
                let s = TAU / nm * t * max_abs_w(radius);
                let power = power.at(s) * relative(index, cos_theta_d);
                for c in 0..3 {
                    sum[c] += weight[c] / (nm * nm) * power * shape;
                }
            }
            texel.iter_mut().zip(sum).for_each(|(slot, value)| *slot = value as f32);
        }
    });
    Ok(table)
}

/// Share of the tolerance that linear interpolation of the power of the mean phasor takes where it is largest, at `w = 0`.
/// A row of numbers costs nothing, and where phases have decayed the error is relative to little: of normally distributed heights
/// the power is `exp(-x²)`, `x = k |w| h_rms`, whose second derivative relative to itself is `2x² - 1` times that at 0. With a fiftieth the
/// error is half the tolerance at `x` = 3.6, where the lobe is 2e-6 of a mirror's.
const POWER_SHARE: f64 = 0.02;

/// The power of the mean phasor at one wavelength, the shortest, in 1/sr: over `|w|/2` evenly from 0 to 1, in as many steps
/// as a linear interpolation needs.
pub(super) fn power_over_t(power: &PhasorPower, input: &BuildInput) -> Vec<f32> {
    let [shortest_nm, _] = input.wavelength_range_nm;
    let rows = rows_needed(input.rms_nm, shortest_nm, POWER_SHARE * input.tables.tolerance);
    let s_max = TAU / shortest_nm * max_abs_w(0.0);
    let at = |row: usize| power.at(s_max * row as f64 / (rows - 1) as f64) / (shortest_nm * shortest_nm);
    (0..rows).map(|row| at(row) as f32).collect()
}

/// The grid of the cross-term patch.
pub(super) fn patch_grid(optics: &OpticsConfig, radius_max: f64) -> Grid {
    let half = (radius_max / narrowest_lobe(optics) * TEXELS_PER_WIDTH[1]).ceil() as usize;
    Grid { size: 2 * half + 1, half_width: radius_max }
}
