//! How much work the sums of a build are, counted from sizes alone.

use std::f64::consts::{PI, SQRT_2, TAU};

use super::grid::Grid;
use super::input::BuildInput;
use super::rings::Ring;
use crate::height::HeightField;
use crate::optics::kernel::{OVERSAMPLING, SEMICIRCLE_TAPS};
use crate::optics::spectra::{SpectraConfig, smooth_size};
use crate::optics::window::{Placement, SUPPORT_SIGMAS};
use diffraction_brdf::chebyshev;

/// What the transforms of one window consist of, and the sums over them.
pub(super) struct WindowWork {
    /// Samples within the window.
    pub samples: [f64; 2],
    /// Samples that are transformed.
    pub padded: [f64; 2],
    /// Distance of the lines in 1/nm.
    pub step: [f64; 2],
    /// Lines stored.
    pub lines: [f64; 2],
    /// Lines that a point reads.
    pub taps: [f64; 2],
    /// Transforms.
    pub transforms: f64,
    /// Numbers for each line: 1 for powers, 2 for amplitudes.
    pub parts: f64,
    /// Box samples per texel and axis.
    pub box_samples: f64,
}

/// What summing a ring consists of, for one window and all wavelengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RingWork {
    /// Wavelengths.
    pub wavelengths: f64,
    /// Values of the kernel.
    pub kernel_values: f64,
    /// Products of transforms and weights that combine them to one lane of nodes in `w`.
    pub line_products: f64,
    /// Products of lines and taps that interpolate one lane.
    pub tap_products: f64,
    /// Box samples whose power is added to one lane.
    pub powers: f64,
}

/// The work of every window, in order; `box_samples` as of amplitudes.
pub(super) fn window_works(
    input: &BuildInput,
    windows: &[(usize, Placement)],
    spectra: &SpectraConfig,
    box_samples: usize,
) -> Vec<WindowWork> {
    let [low, high] = spectra.phase_scale_per_nm;
    let transforms = chebyshev::nodes_for_exponential(input.half_height_range_nm, high - low, spectra.tolerance) as f64;
    let of_window = |&(scan, placement): &(usize, Placement)| {
        let is_power = placement == Placement::TileMean;
        let work =
            WindowWork { transforms, ..lines(&input.fields[scan], placement, input.optics.least_sigma_nm(), spectra) };
        // A mean over window positions is a sum of powers: its kernel averages the box exactly.
        if is_power { work } else { WindowWork { parts: 2.0, box_samples: box_samples as f64, ..work } }
    };
    windows.iter().map(of_window).collect()
}

/// Sizes of one window's transforms, for powers and point samples.
fn lines(field: &HeightField, placement: Placement, sigma_nm: f64, spectra: &SpectraConfig) -> WindowWork {
    let zero = [0.0; 2];
    let mut work = WindowWork {
        samples: zero,
        padded: zero,
        step: zero,
        lines: zero,
        taps: zero,
        transforms: 0.0,
        parts: 1.0,
        box_samples: 1.0,
    };
    let inside = matches!(placement, Placement::Inside { .. });
    for (axis, (samples, pitch)) in field.size().into_iter().zip(field.pitch_nm).enumerate() {
        let within = 2.0 * SUPPORT_SIGMAS * sigma_nm / pitch;
        work.samples[axis] = if inside { (within + 1.0).floor().min(samples as f64) } else { samples as f64 };
        work.padded[axis] = match inside {
            true => smooth_size((OVERSAMPLING * work.samples[axis]).ceil() as usize) as f64,
            false => work.samples[axis],
        };
        work.step[axis] = 1.0 / (work.padded[axis] * pitch);
        // A Gaussian of 5.5 standard deviations on each side, or the fixed kernel.
        let gaussian = 11.0 / (TAU * sigma_nm * work.step[axis]);
        let taps = match placement {
            Placement::Inside { .. } => SEMICIRCLE_TAPS as f64,
            Placement::TileCentre => gaussian.ceil(),
            Placement::TileMean => (gaussian / SQRT_2).ceil(),
        };
        // Lines that do not exist are not read.
        work.taps[axis] = taps.min(work.padded[axis]);
        let [low, high] = spectra.frequency[axis];
        work.lines[axis] = ((high - low) / work.step[axis] + taps + 1.0).min(work.padded[axis]);
    }
    work
}

impl WindowWork {
    /// The sums over a ring with so many texels of a grid.
    pub fn ring(&self, ring: &Ring, texels: f64, grid: &Grid) -> RingWork {
        let Self { step, taps, transforms, parts, box_samples, .. } = self;
        let texel = grid.texel();
        let area = texels * texel.powi(2);
        let annulus = |[inner, outer]: [f64; 2]| PI * (outer * outer - inner.max(0.0).powi(2));
        let share = (area / annulus(ring.radius)).min(1.0);
        let targets = box_samples * 2.0 * area.sqrt().max(share * 2.0 * ring.radius[1]) / texel;
        let mut work = RingWork {
            wavelengths: ring.wavelengths() as f64,
            kernel_values: 0.5 * (taps[0] + taps[1]) * targets * ring.wavelengths() as f64,
            line_products: 0.0,
            tap_products: 0.0,
            powers: texels * box_samples.powi(2) * ring.wavelengths() as f64,
        };
        for nm in &ring.quadrature.wavelengths_nm {
            // Lines whose blur reaches into the ring.
            let reach = 0.5 * nm * (taps[0] * step[0]).max(taps[1] * step[1]);
            let wide = (share * annulus([ring.radius[0] - reach, ring.radius[1] + reach]))
                .max((area.sqrt() + 2.0 * reach).powi(2));
            let cells = wide / (nm * nm * step[0] * step[1]);
            let rows = texels * texel / (nm * step[1]).min(texel * 8.0);
            work.line_products += 2.0 * cells * transforms;
            work.tap_products += parts * (taps[0] * rows * box_samples + taps[1] * texels * box_samples.powi(2));
        }
        work
    }
}
