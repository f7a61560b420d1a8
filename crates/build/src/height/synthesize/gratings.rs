//! Gratings whose heights, slopes and diffraction orders are known in closed form.

use std::f64::consts::PI;

use ndarray::Array2;

use super::grid::Grid;
use diffraction_brdf::error::{Error, Result};

/// The grating vector in periods per nm along x and y; exactly along the axes for multiples of 90 degrees.
pub(super) fn vector(period_nm: f64, direction_deg: f64) -> [f64; 2] {
    let (cosine, sine) = match direction_deg.rem_euclid(360.0) {
        0.0 => (1.0, 0.0),
        90.0 => (0.0, 1.0),
        180.0 => (-1.0, 0.0),
        270.0 => (0.0, -1.0),
        degrees => (libm::cos(degrees * PI / 180.0), libm::sin(degrees * PI / 180.0)),
    };
    [cosine / period_nm, sine / period_nm]
}

/// `amplitude cos(2 pi s / period)`, sampled at the cells' centres.
pub(super) fn sinusoid(grid: &Grid, period_nm: f64, amplitude_nm: f64, direction_deg: f64) -> Result<Array2<f64>> {
    check_lengths(&[("period", period_nm), ("amplitude", amplitude_nm)])?;
    if !direction_deg.is_finite() {
        return Err(Error::Call(format!("the direction must be a finite angle, not {direction_deg}")));
    }
    let [u, v] = vector(period_nm, direction_deg);
    // Two samples per period and axis do not tell a cosine from zero, fewer give another period.
    for (axis, per_nm) in [u, v].into_iter().enumerate() {
        check_resolved(per_nm.abs() * grid.pitch_nm[axis], grid, period_nm)?;
    }
    Ok(grid.sample(|x, y| amplitude_nm * libm::cos(2.0 * PI * fraction(u * x + v * y))))
}

/// Sawtooth from 0 at the start of each period to `depth` at its end.
pub(super) fn blazed(grid: &Grid, period_nm: f64, depth_nm: f64) -> Result<Array2<f64>> {
    check_lengths(&[("period", period_nm), ("depth", depth_nm)])?;
    check_resolved(grid.pitch_nm[0] / period_nm, grid, period_nm)?;
    // Integral of the fraction of t from 0 to t.
    let integral = |t: f64| {
        let part = fraction(t);
        0.5 * (t.floor() + part * part)
    };
    Ok(cell_means(grid, period_nm, depth_nm, integral))
}

/// `depth` in the first `duty` of each period, 0 in the rest.
pub(super) fn lamellar(grid: &Grid, period_nm: f64, depth_nm: f64, duty: f64) -> Result<Array2<f64>> {
    check_lengths(&[("period", period_nm), ("depth", depth_nm)])?;
    if !(duty > 0.0 && duty < 1.0) {
        return Err(Error::Call(format!("the duty must lie between 0 and 1, neither included, not {duty}")));
    }
    check_resolved(grid.pitch_nm[0] / period_nm, grid, period_nm)?;
    let integral = |t: f64| t.floor() * duty + fraction(t).min(duty);
    Ok(cell_means(grid, period_nm, depth_nm, integral))
}

/// Means over the cells of a profile along x, given its integral in units of the period: an edge inside a
/// cell keeps its place to a fraction of the pitch, where point samples would jitter.
fn cell_means(grid: &Grid, period_nm: f64, depth_nm: f64, integral: impl Fn(f64) -> f64 + Sync) -> Array2<f64> {
    let width = grid.pitch_nm[0] / period_nm;
    let means: Vec<f64> = (0..grid.size[0])
        .map(|column| {
            let start = column as f64 * width;
            depth_nm * (integral(start + width) - integral(start)) / width
        })
        .collect();
    Array2::from_shape_fn([grid.size[1], grid.size[0]], |(_, column)| means[column])
}

fn fraction(t: f64) -> f64 {
    t - t.floor()
}

fn check_lengths(lengths: &[(&str, f64)]) -> Result<()> {
    for (name, value) in lengths {
        if !(1e-6..=1e9).contains(value) {
            return Err(Error::Call(format!("the {name} must lie between 1e-6 nm and 1 m, not be {value} nm")));
        }
    }
    Ok(())
}

/// `periods` per sample must stay below one half.
fn check_resolved(periods: f64, grid: &Grid, period_nm: f64) -> Result<()> {
    if periods < 0.5 {
        return Ok(());
    }
    Err(Error::Call(format!(
        "a period of {period_nm} nm needs more than two samples; the pitch is {:?} nm",
        grid.pitch_nm
    )))
}
