//! Transforms of the powers of the height: the series of `exp(-i s h)` that the published method uses.
//!
//! With `h` in units of a scale `b`, `P(s) = Σ_n (s b)^n D_n` where `D_n` is the transform of
//! `g (-i h/b)^n / n!`. Kept in double precision, because the terms of the series cancel.

use rustfft::num_complex::Complex;

use super::kernel::Kernel;
use super::spectra::{Engine, window_heights, window_plan};
use super::window::Placement;
use crate::height::HeightField;
use diffraction_brdf::error::{Error, Result};

/// What decides the size of the transforms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowersConfig {
    /// Terms `n = 0 .. orders - 1`.
    pub orders: usize,
    /// Unit of height `b` in nm, at least half the peak-to-valley range.
    pub scale_nm: f64,
    /// Smallest and largest frequency wanted in 1/nm, along x and y.
    pub frequency: [[f64; 2]; 2],
    /// Bytes that the result may take.
    pub memory_bytes: u64,
}

/// The series of one window. Per pair of lines either the amplitudes `D_n / sqrt(A)` as (re, im), or,
/// where powers are averaged over all window positions, the coefficients of `|P|²`.
#[derive(Debug, Clone)]
pub struct HeightPowers {
    /// Layout `[η line][ξ line][value]`.
    pub data: Vec<f64>,
    /// Values per pair of lines: `2 orders` for amplitudes, `orders` for powers.
    pub values: usize,
    /// Index of the first stored line along ξ and η.
    pub first: [i32; 2],
    /// Number of stored lines along ξ and η.
    pub lines: [usize; 2],
    /// Distance of the lines in 1/nm.
    pub step: [f64; 2],
    /// How the spectrum between the lines follows.
    pub kernel: Kernel,
}

/// Transforms the powers of the height (measured from mid-range) under one window.
///
/// # Errors
/// `Error::Limit` if the transforms would need more memory than allowed.
pub fn transform_powers(
    field: &HeightField,
    placement: Placement,
    sigma_nm: f64,
    config: &PowersConfig,
) -> Result<HeightPowers> {
    let (kernel, plans) = window_plan(field, placement, sigma_nm, config.frequency);
    let [x, y] = [plans[0].lines, plans[1].lines];
    let bytes = (x * y) as u64 * (2 * config.orders * size_of::<f64>()) as u64;
    if bytes > config.memory_bytes {
        return Err(Error::limit(
            format!(
                "the published method needs {} MiB for the transforms of {} powers of the height and {} MiB are allowed",
                bytes >> 20,
                config.orders,
                config.memory_bytes >> 20
            ),
            "raise tables.memory_mib, or use tables.basis = \"chebyshev\"",
        ));
    }
    let turned = window_heights(field, &plans).mapv(|h| Complex::new(0.0, -h / config.scale_nm));
    let mut power = turned.mapv(|_| Complex::new(1.0, 0.0));
    let values = 2 * config.orders;
    let mut data = vec![0.0; x * y * values];
    let mut engine = Engine::new(&plans);
    for order in 0..config.orders {
        if order > 0 {
            power.zip_mut_with(&turned, |p, t| *p = *p * t / order as f64);
        }
        engine.run(&power, Complex::default(), 1.0, &plans);
        for (line, slot) in data.chunks_exact_mut(values).enumerate() {
            let value = engine.done[(line % x) * y + line / x];
            (slot[2 * order], slot[2 * order + 1]) = (value.re, value.im);
        }
    }
    let mut powers = HeightPowers {
        data,
        values,
        first: [plans[0].first, plans[1].first],
        lines: [x, y],
        step: [plans[0].step, plans[1].step],
        kernel,
    };
    if placement == Placement::TileMean {
        let mut squared = vec![0.0; x * y * config.orders];
        for (amplitude, out) in powers.data.chunks_exact(values).zip(squared.chunks_exact_mut(config.orders)) {
            square_series(amplitude, out);
        }
        (powers.data, powers.values) = (squared, config.orders);
    }
    Ok(powers)
}

/// Coefficients of `|Σ D_n x^n|²` up to the number of terms that `D` has: `Σ_n Re(D_n D*_{p-n})`.
pub(crate) fn square_series(amplitude: &[f64], out: &mut [f64]) {
    let term = |n: usize, m: usize| amplitude[2 * n] * amplitude[2 * m] + amplitude[2 * n + 1] * amplitude[2 * m + 1];
    for (p, slot) in out.iter_mut().enumerate() {
        let pairs: f64 = (0..p.div_ceil(2)).map(|n| term(n, p - n)).sum();
        *slot = 2.0 * pairs + if p % 2 == 0 { term(p / 2, p / 2) } else { 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squared_series_is_the_square_of_the_sum() {
        // (1 + 2i x + 3 x²)(conj) = 1 + (6 + 4) x² + 9 x⁴ for real x; cut after x².
        let mut out = [0.0; 3];
        square_series(&[1.0, 0.0, 0.0, 2.0, 3.0, 0.0], &mut out);
        assert_eq!(out, [1.0, 0.0, 10.0]);
    }
}
