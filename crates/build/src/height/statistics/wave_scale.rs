//! Slopes and walls of the surface at the scale of the wavelength, nearly the same at any pitch.

use rayon::prelude::*;

use crate::height::HeightField;

/// Length over which slopes are taken, in wavelengths.
const SLOPE_LENGTH: f64 = 0.25;

/// Length within which a wall rises, in wavelengths.
const WALL_LENGTH: f64 = 0.1;

/// Least height of a wall, in wavelengths.
const WALL_HEIGHT: f64 = 0.1;

/// Coarsest pitch in wavelengths that tells steep slopes from gentle ones.
const PITCH_MAX: f64 = 0.2;

/// Root mean square slope over a quarter of a wavelength in nm: `sqrt(D_x(L) + D_y(L)) / L`, where `D_x(L)` is the mean over all
/// pairs in the scan of `(h(x + L, y) - h(x, y))²`.
///
/// Between whole steps `D` is interpolated linearly: of vertical walls it is linear in the length. An axis with a pitch
/// above `L` answers for one step.
pub fn wave_slope(field: &HeightField, wavelength_nm: f64) -> f64 {
    let of_axis = |axis: usize| {
        let steps = (SLOPE_LENGTH * wavelength_nm / field.pitch_nm[axis]).max(1.0);
        let low = steps as usize;
        let share = steps - steps.floor();
        let square = |steps: usize| mean_over_pairs(field, axis, steps, |rise_nm| rise_nm * rise_nm);
        let above = if share > 0.0 { share * square(low + 1) } else { 0.0 };
        ((1.0 - share) * square(low) + above) / (steps * field.pitch_nm[axis]).powi(2)
    };
    (of_axis(0) + of_axis(1)).sqrt()
}

/// Share of points at walls, 0 to 1: where the height changes by more than a tenth of a wavelength in nm within a tenth of it,
/// along x or along y, whichever has more.
///
/// A wall is seen from as many points as the length has steps, so the share is that over the length's true size: walls ten to
/// a wavelength are 1, one in ten wavelengths is 0.01.
pub fn wall_share(field: &HeightField, wavelength_nm: f64) -> f64 {
    let of_axis = |axis: usize| {
        let pitch_nm = field.pitch_nm[axis];
        let steps = (WALL_LENGTH * wavelength_nm / pitch_nm).round().max(1.0);
        let jump = |rise_nm: f64| if rise_nm.abs() > WALL_HEIGHT * wavelength_nm { 1.0 } else { 0.0 };
        mean_over_pairs(field, axis, steps as usize, jump) * WALL_LENGTH * wavelength_nm / (steps * pitch_nm)
    };
    of_axis(0).max(of_axis(1))
}

/// Shortest wavelength in nm at which a scan tells steep slopes from gentle ones: five times its coarser pitch, axes of
/// one sample left out, along which a surface has no structure.
pub(crate) fn wavelength_told_nm(field: &HeightField) -> f64 {
    let axes = field.size().into_iter().zip(field.pitch_nm).filter(|(count, _)| *count > 1);
    axes.map(|(_, pitch_nm)| pitch_nm / PITCH_MAX).fold(0.0, f64::max)
}

/// The largest [`wave_slope`] that a surface of this rms height can have: `D` is at most four times the mean square height,
/// along both axes.
pub(crate) fn wave_slope_max(rms_height_nm: f64, wavelength_nm: f64) -> f64 {
    8f64.sqrt() * rms_height_nm / (SLOPE_LENGTH * wavelength_nm)
}

/// Mean of `of(rise in nm)` over all pairs of samples that lie `steps` apart along an axis; pairs as far apart as the scan
/// allows where it is shorter. Summed row by row in order: the same on any number of threads.
fn mean_over_pairs(field: &HeightField, axis: usize, steps: usize, of: impl Fn(f64) -> f64 + Sync) -> f64 {
    let heights = &field.heights_nm;
    let [nx, ny] = field.size();
    let steps = steps.min(field.size()[axis] - 1);
    let [columns, rows] = if axis == 0 { [nx - steps, ny] } else { [nx, ny - steps] };
    let line = |row: usize| {
        let from = heights.row(row);
        match axis {
            0 => from.iter().skip(steps).zip(from).map(|(to, from)| of(to - from)).sum::<f64>(),
            _ => heights.row(row + steps).iter().zip(from).map(|(to, from)| of(to - from)).sum(),
        }
    };
    let lines: Vec<f64> = (0..rows).into_par_iter().map(line).collect();
    lines.iter().sum::<f64>() / (rows * columns) as f64
}
