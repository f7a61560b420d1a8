//! Picture of a height field's power spectrum.

use ndarray::{Array2, Array3, Axis};
use rayon::prelude::*;
use rustfft::{FftPlanner, num_complex::Complex};

use crate::report::colour_maps::{INFERNO, colour};
use crate::report::pictures::{put, require_area};
use diffraction_brdf::error::{Error, Result};
use diffraction_build::height::HeightField;

/// Side of a spectrum picture in pixels; odd, so that frequency 0 has a pixel of its own.
const SPECTRUM_PX: usize = 385;

/// Largest side that is transformed; of larger scans the middle is.
const SPECTRUM_SAMPLES_MAX: usize = 2048;

/// Range of the spectrum's colours below its maximum.
const SPECTRUM_RANGE_DB: f64 = 60.0;

/// A power spectrum and what its axes and colours mean.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumPicture {
    /// sRGB, shape `[side, side, 3]`, frequency 0 in the middle, +y up.
    pub rgb: Array3<u8>,
    /// Frequency at the middle of each edge, in cycles per µm.
    pub half_range_per_um: f64,
    /// Power of the darkest colour in dB below the brightest, negative.
    pub low_db: f64,
}

/// A range that shows the given periods (nm) and their first overtones: three times the highest of
/// their frequencies, but at least eight steps of the spectrum and at most the sampling limit.
pub fn spectrum_half_range_per_um(field: &HeightField, periods_nm: &[f64]) -> f64 {
    let highest = periods_nm
        .iter()
        .filter(|period| period.is_finite() && **period > 0.0)
        .fold(0.0, |highest: f64, period| highest.max(1e3 / period));
    let [x_nm, y_nm] = field.extent_nm();
    let limit = 500.0 / field.pitch_nm[0].max(field.pitch_nm[1]);
    let wanted = if highest > 0.0 { 3.0 * highest } else { limit / 2.0 };
    wanted.max(8e3 / x_nm.min(y_nm)).min(limit)
}

/// Draws the power spectrum of the heights up to `half_range_per_um` (cycles per µm) along x and
/// y: plane removed, Hann window, decibels below the strongest frequency. Frequencies beyond the
/// sampling limit are grey.
///
/// Fails on a field without samples or area, and on a range that is not positive and finite.
pub fn spectrum_picture(field: &HeightField, half_range_per_um: f64) -> Result<SpectrumPicture> {
    require_area(field)?;
    if !(half_range_per_um.is_finite() && half_range_per_um > 0.0) {
        return Err(Error::limit(
            format!("a power spectrum up to {half_range_per_um} cycles per µm cannot be drawn"),
            "give a positive range",
        ));
    }
    let power = power_spectrum(&middle(&field.heights_nm));
    let side = SPECTRUM_PX;
    let step = 2.0 * half_range_per_um / (side - 1) as f64;
    let (rows, columns) = power.dim();
    // Bins per picture pixel along each axis; the spectrum's row axis runs down, frequency y up.
    let bins_x = step * 1e-3 * field.pitch_nm[0] * columns as f64;
    let bins_y = step * 1e-3 * field.pitch_nm[1] * rows as f64;
    let half = (side / 2) as f64;
    let values: Vec<f64> = (0..side * side)
        .into_par_iter()
        .map(|index| {
            let fx = ((index % side) as f64 - half) * bins_x;
            let fy = ((index / side) as f64 - half) * bins_y;
            mean_power(&power, fx, fy, bins_x, bins_y)
        })
        .collect();
    let peak = values.iter().filter(|value| value.is_finite()).fold(0.0, |peak: f64, &value| peak.max(value));
    let mut rgb = Array3::zeros((side, side, 3));
    for (index, &value) in values.iter().enumerate() {
        let position = if value.is_nan() {
            f64::NAN
        } else if value <= 0.0 {
            0.0
        } else {
            1.0 + 10.0 * (value / peak).log10() / SPECTRUM_RANGE_DB
        };
        put(&mut rgb, index / side, index % side, colour(&INFERNO, position));
    }
    Ok(SpectrumPicture { rgb, half_range_per_um, low_db: -SPECTRUM_RANGE_DB })
}

/// The middle of an array that is too large to transform in bounded memory.
fn middle(values: &Array2<f64>) -> Array2<f64> {
    let (rows, columns) = values.dim();
    let (r, c) = (rows.min(SPECTRUM_SAMPLES_MAX), columns.min(SPECTRUM_SAMPLES_MAX));
    let (r0, c0) = ((rows - r) / 2, (columns - c) / 2);
    Array2::from_shape_fn((r, c), |(row, column)| {
        let height = values[(r0 + row, c0 + column)];
        if height.is_finite() { height } else { 0.0 }
    })
}

/// `|DFT|²` of the heights with their mean plane removed, under a Hann window; frequency 0 first.
fn power_spectrum(heights: &Array2<f64>) -> Array2<f64> {
    let (rows, columns) = heights.dim();
    let count = (rows * columns) as f64;
    let mean = heights.sum() / count;
    let centred = |index: usize, length: usize| index as f64 - (length as f64 - 1.0) / 2.0;
    // On a full regular grid the two slopes of the least-squares plane do not depend on each other.
    let slope = |axis: usize| {
        let length = heights.len_of(Axis(axis));
        let moment: f64 =
            heights.axis_iter(Axis(axis)).enumerate().map(|(i, line)| centred(i, length) * line.sum()).sum();
        let norm: f64 = (0..length).map(|i| centred(i, length).powi(2)).sum();
        if norm > 0.0 { moment / (norm * (count / length as f64)) } else { 0.0 }
    };
    let (slope_y, slope_x) = (slope(0), slope(1));
    let (window_y, window_x) = (hann(rows), hann(columns));
    let mut field = Array2::from_shape_fn((rows, columns), |(row, column)| {
        let plane = mean + slope_y * centred(row, rows) + slope_x * centred(column, columns);
        let value = (heights[(row, column)] - plane) * window_y[row] * window_x[column];
        Complex::new(value, 0.0)
    });
    transform_rows(&mut field);
    let mut turned = field.t().as_standard_layout().into_owned();
    transform_rows(&mut turned);
    turned.t().mapv(|value| value.norm_sqr())
}

/// Hann window; 1 throughout where there are too few samples for its ends.
fn hann(length: usize) -> Vec<f64> {
    if length < 4 {
        return vec![1.0; length];
    }
    (0..length).map(|i| (std::f64::consts::PI * (i as f64 + 0.5) / length as f64).sin().powi(2)).collect()
}

fn transform_rows(field: &mut Array2<Complex<f64>>) {
    let plan = FftPlanner::new().plan_fft_forward(field.ncols());
    field.axis_iter_mut(Axis(0)).into_par_iter().for_each(|mut row| {
        // Rows of a standard layout are contiguous.
        plan.process(row.as_slice_mut().expect("rows are contiguous"));
    });
}

/// Mean power in a pixel of `width_x` by `width_y` bins centred at the signed bin position
/// `(fx, fy)`, `fy` running down with the rows; NaN beyond the sampling limit.
fn mean_power(power: &Array2<f64>, fx: f64, fy: f64, width_x: f64, width_y: f64) -> f64 {
    let (rows, columns) = power.dim();
    // Half a bin of grace: the limit itself belongs to the spectrum.
    if fx.abs() > columns as f64 / 2.0 + 0.5 || fy.abs() > rows as f64 / 2.0 + 0.5 {
        return f64::NAN;
    }
    let steps_x = (width_x.ceil() as usize).clamp(1, 16);
    let steps_y = (width_y.ceil() as usize).clamp(1, 16);
    let mut sum = 0.0;
    for j in 0..steps_y {
        let y = fy + ((j as f64 + 0.5) / steps_y as f64 - 0.5) * width_y;
        for i in 0..steps_x {
            let x = fx + ((i as f64 + 0.5) / steps_x as f64 - 0.5) * width_x;
            sum += bilinear_periodic(power, x, y);
        }
    }
    sum / (steps_x * steps_y) as f64
}

fn bilinear_periodic(power: &Array2<f64>, x: f64, y: f64) -> f64 {
    let (rows, columns) = power.dim();
    let wrap = |index: f64, length: usize| (index as i64).rem_euclid(length as i64) as usize;
    let (x0, y0) = (x.floor(), y.floor());
    let (sx, sy) = (x - x0, y - y0);
    let (c0, c1) = (wrap(x0, columns), wrap(x0 + 1.0, columns));
    let (r0, r1) = (wrap(y0, rows), wrap(y0 + 1.0, rows));
    (1.0 - sy) * ((1.0 - sx) * power[(r0, c0)] + sx * power[(r0, c1)])
        + sy * ((1.0 - sx) * power[(r1, c0)] + sx * power[(r1, c1)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grating of the given wave vector (cycles per µm, y up) on a tilted plane, non-square pixels.
    fn grating(fx_per_um: f64, fy_per_um: f64) -> HeightField {
        let pitch_nm = [40.0, 60.0];
        let (rows, columns) = (200, 256);
        let heights_nm = Array2::from_shape_fn((rows, columns), |(row, column)| {
            let x_um = column as f64 * pitch_nm[0] * 1e-3;
            let y_um = (rows - 1 - row) as f64 * pitch_nm[1] * 1e-3;
            let phase = std::f64::consts::TAU * (fx_per_um * x_um + fy_per_um * y_um);
            20.0 * phase.cos() + 9.0 * x_um - 7.0 * y_um
        });
        HeightField { heights_nm, pitch_nm }
    }

    fn brightness(picture: &SpectrumPicture, row: usize, column: usize) -> u32 {
        (0..3).map(|channel| u32::from(picture.rgb[(row, column, channel)])).sum()
    }

    /// The pixel where a frequency belongs by the documentation of the picture.
    fn pixel(picture: &SpectrumPicture, fx: f64, fy: f64) -> (usize, usize) {
        let half = (SPECTRUM_PX / 2) as f64;
        let place = |f: f64| (half + f / picture.half_range_per_um * half).round() as usize;
        (place(-fy), place(fx))
    }

    #[test]
    fn a_grating_shows_as_two_bright_spots_where_they_belong() {
        let (fx, fy) = (1.2, 0.7);
        let picture = spectrum_picture(&grating(fx, fy), 4.0).unwrap();
        for (sign_x, sign_y, expected) in [(1.0, 1.0, true), (-1.0, -1.0, true), (1.0, -1.0, false), (-1.0, 1.0, false)]
        {
            let (row, column) = pixel(&picture, sign_x * fx, sign_y * fy);
            // The peak falls between bins: a Hann window loses at most 1.4 dB there, of 60 dB.
            assert_eq!(brightness(&picture, row, column) > 500, expected, "{sign_x} {sign_y}");
        }
        let (row, column) = pixel(&picture, 0.0, 0.0);
        assert!(brightness(&picture, row, column) < 300, "the tilt of the plane must not show");
    }

    #[test]
    fn frequencies_beyond_the_sampling_limit_are_grey() {
        // Limits: 12.5 per µm along x, 8.33 along y.
        let picture = spectrum_picture(&grating(1.0, 0.0), 10.0).unwrap();
        let (row, column) = pixel(&picture, 0.0, 9.5);
        assert_eq!(picture.rgb[(row, column, 0)], picture.rgb[(row, column, 2)]);
        let (row, column) = pixel(&picture, 9.5, 0.0);
        assert_ne!(brightness(&picture, row, column), 3 * 128);
    }

    #[test]
    fn ranges() {
        let field = grating(1.0, 0.0);
        assert_eq!(spectrum_half_range_per_um(&field, &[1000.0, 2000.0]), 3.0);
        let limit = 500.0 / 60.0;
        assert_eq!(spectrum_half_range_per_um(&field, &[10.0]), limit);
        assert_eq!(spectrum_half_range_per_um(&field, &[]), limit / 2.0);
        assert!(spectrum_picture(&field, f64::NAN).is_err());
        assert!(spectrum_picture(&field, 0.0).is_err());
    }

    #[test]
    fn odd_shapes_have_spectra() {
        for (rows, columns) in [(1, 1), (1, 50), (50, 1), (2, 2), (3, 7)] {
            let field = HeightField {
                heights_nm: Array2::from_shape_fn((rows, columns), |(r, c)| (r * 3 + c) as f64),
                pitch_nm: [50.0, 50.0],
            };
            let range = spectrum_half_range_per_um(&field, &[f64::NAN, -1.0, 0.0]);
            let picture = spectrum_picture(&field, range).unwrap();
            assert_eq!(picture.rgb.dim(), (SPECTRUM_PX, SPECTRUM_PX, 3));
        }
    }
}
