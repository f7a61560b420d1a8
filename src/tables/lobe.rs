//! The coherent lobe: what the mean phasor reflects around the mirror direction, and its cross term.

use std::f64::consts::{SQRT_2, TAU};
use std::ops::Range;

use ndarray::{Array3, Axis};
use rayon::prelude::*;
use rustfft::num_complex::Complex;

use super::plan::{Grid, lobe_width, w_reach};
use crate::ground::chebyshev::Interpolant;
use crate::ground::error::Result;
use crate::ground::spectrum::{SpectralQuadrature, uniform_wavenumbers};
use crate::optics::config::OpticsConfig;
use crate::optics::spectra::Spectra;

/// Texels per standard deviation of the narrowest lobe, along its radius and in the cross patch.
const TEXELS_PER_WIDTH: [f64; 2] = [12.0, 4.0];

/// Fewest wavelengths over which the lobe is integrated: it is a smooth function of `1/λ`...
const WAVELENGTHS: usize = 200;

/// ...but for deep surfaces. `|c|²` consists of waves in `1/λ` at lags `|w| Δh` of height differences, whose standard
/// deviation is `√2 |w|` times the rms height: nodes 0.57 deviations apart, as for the reference.
fn wavelengths_needed(optics: &OpticsConfig, rms_nm: f64) -> usize {
    let [low_nm, high_nm] = optics.wavelength_nm;
    let deviation = 1.0 / (TAU * SQRT_2 * w_reach(0.0) * rms_nm);
    WAVELENGTHS.max(((1.0 / low_nm - 1.0 / high_nm) / (0.57 * deviation)).ceil() as usize)
}

/// `|c|²` of every window as a function of `s`, without the window's shape.
#[derive(Debug, Clone)]
pub struct PhasorPower {
    s: [f64; 2],
    depth: Interpolant,
    mean_phasor: Vec<Complex<f64>>,
    lobe_peak_nm2: f64,
}

impl PhasorPower {
    /// Keeps what the lobe needs of a window's transforms.
    pub fn of(spectra: &Spectra) -> Self {
        Self {
            s: spectra.s,
            depth: spectra.depth.clone(),
            mean_phasor: spectra.mean_phasor.clone(),
            lobe_peak_nm2: spectra.lobe_peak_nm2,
        }
    }

    /// `|c(s)|² (∬g)² / A` in nm². Where transforms stop short of the whole hemisphere, no direction that is served asks
    /// for more: what lies beyond takes the value at their end.
    fn at(&self, s: f64) -> f64 {
        let weights = self.depth.weights(s.clamp(self.s[0], self.s[1]));
        let c: Complex<f64> = weights.iter().zip(&self.mean_phasor).map(|(w, c)| c * w).sum();
        c.norm_sqr() * self.lobe_peak_nm2
    }
}

/// Rows of `t` that a linear interpolation needs: near `w = 0`, `|c|² = 1 - (k w h_rms)²`, whose second
/// difference over a step `Δw` is `2 (k h_rms Δw)²`, an eighth of it the error.
fn rows_needed(rms_nm: f64, wavelength_min_nm: f64, tolerance: f64) -> usize {
    let step = (4.0 * tolerance).sqrt() / (TAU / wavelength_min_nm * rms_nm).max(1e-9);
    ((2.0 / step).ceil() as usize).clamp(32, 1024) + 1
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

/// Rows that look-ups from `depths[0]` to `depths[1]` of `t` read, among those that a tolerance asks for.
fn layout(optics: &OpticsConfig, radius_max: f64, depths: [f64; 2], [rms_nm, tolerance]: [f64; 2]) -> Result<Layout> {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    let rows = rows_needed(rms_nm, low_nm, tolerance);
    let [first, last] = depths.map(|t| t * (rows - 1) as f64);
    Ok(Layout {
        rows,
        columns: (radius_max / lobe_width(optics.sigma_nm, low_nm) * TEXELS_PER_WIDTH[0]).ceil() as usize + 1,
        read: (first as usize).saturating_sub(ROWS_MARGIN)..(last.ceil() as usize + ROWS_MARGIN + 1).min(rows),
        quadrature: uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, wavelengths_needed(optics, rms_nm))?,
    })
}

/// Texels times wavelengths of the coherent table: arguments as for [`coherent`].
///
/// # Errors
/// `Error::Call` for an invisible light.
pub fn samples(optics: &OpticsConfig, radius_max: f64, depths: [f64; 2], rms_nm: f64, tolerance: f64) -> Result<f64> {
    let Layout { columns, read, quadrature, .. } = layout(optics, radius_max, depths, [rms_nm, tolerance])?;
    Ok((read.len() * columns * quadrature.wavelengths_nm.len()) as f64)
}

/// The coherent table, shape `[t, radius, 3]`, averaged over the windows: rows that look-ups from `depths[0]` to
/// `depths[1]` of `t` read, zero elsewhere.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub fn coherent(
    windows: &[PhasorPower],
    optics: &OpticsConfig,
    radius_max: f64,
    depths: [f64; 2],
    rms_nm: f64,
    tolerance: f64,
) -> Result<Array3<f32>> {
    let Layout { rows, columns, read, quadrature } = layout(optics, radius_max, depths, [rms_nm, tolerance])?;
    let mut table = Array3::<f32>::zeros((rows, columns, 3));
    let mut lines = table.slice_axis_mut(Axis(0), read.clone().into());
    lines.axis_iter_mut(Axis(0)).into_par_iter().zip(read).for_each(|(mut line, row)| {
        let t = row as f64 / (rows - 1) as f64;
        for (column, mut texel) in line.outer_iter_mut().enumerate() {
            let radius = radius_max * column as f64 / (columns - 1) as f64;
            let mut sum = [0.0; 3];
            for (nm, weight) in quadrature.wavelengths_nm.iter().zip(&quadrature.weights) {
                let shape = (-(TAU * optics.sigma_nm * radius / nm).powi(2)).exp();
                let s = TAU / nm * t * w_reach(radius);
                let power = windows.iter().map(|w| w.at(s)).sum::<f64>() / windows.len() as f64;
                for c in 0..3 {
                    sum[c] += weight[c] / (nm * nm) * power * shape;
                }
            }
            texel.iter_mut().zip(sum).for_each(|(slot, value)| *slot = value as f32);
        }
    });
    Ok(table)
}

/// The grid of the cross-term patch.
pub fn patch_grid(optics: &OpticsConfig, radius_max: f64) -> Grid {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    let half = (radius_max / lobe_width(optics.sigma_nm, low_nm) * TEXELS_PER_WIDTH[1]).ceil() as usize;
    Grid { size: 2 * half + 1, half_width: radius_max }
}
