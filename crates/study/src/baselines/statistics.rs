//! Statistics of height fields that the closed forms ask for: rms height, correlation length, waves.

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use diffraction_build::height::HeightField;

/// What the closed forms know of a surface.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub(crate) struct SurfaceStatistics {
    /// Root mean square height about the mean in nm.
    pub rms_nm: f64,
    /// Distance in nm at which the autocorrelation falls to 1/e: geometric mean of x and y.
    pub correlation_nm: f64,
    /// Frequencies (1/nm along x and y) of the strongest waves, at most two, of different directions or lengths,
    /// each with its share of their common power.
    pub waves: Vec<([f64; 2], f64)>,
}

/// A second wave weaker than this share of the first is none.
const SECOND_WAVE: f64 = 0.1;

/// Statistics averaged over a specimen's scans; waves are those of the first.
pub(crate) fn surface_statistics(fields: &[HeightField]) -> SurfaceStatistics {
    let mean = |of: &dyn Fn(&HeightField) -> f64| fields.iter().map(of).sum::<f64>() / fields.len().max(1) as f64;
    SurfaceStatistics {
        rms_nm: mean(&variance).sqrt(),
        correlation_nm: mean(&correlation_nm),
        waves: fields.first().map(strongest_waves).unwrap_or_default(),
    }
}

fn centred(field: &HeightField) -> ndarray::Array2<f64> {
    &field.heights_nm - field.heights_nm.mean().unwrap_or(0.0)
}

fn variance(field: &HeightField) -> f64 {
    centred(field).iter().map(|h| h * h).sum::<f64>() / field.heights_nm.len().max(1) as f64
}

fn correlation_nm(field: &HeightField) -> f64 {
    let heights = centred(field);
    let [x, y] = [1, 0].map(|axis| {
        let pitch_nm = field.pitch_nm[1 - axis];
        let lines: Vec<Vec<f64>> = heights.lanes(ndarray::Axis(axis)).into_iter().map(|lane| lane.to_vec()).collect();
        let count = heights.len_of(ndarray::Axis(axis));
        let covariance = |lag: usize| -> f64 {
            let sum: f64 = lines.iter().map(|l| l.iter().zip(&l[lag..]).map(|(a, b)| a * b).sum::<f64>()).sum();
            sum / (lines.len() * (count - lag)) as f64
        };
        let (mut before, whole) = (1.0, covariance(0));
        for lag in 1..count.div_ceil(2) {
            let here = if whole > 0.0 { covariance(lag) / whole } else { 0.0 };
            let wanted = (-1.0f64).exp();
            if here <= wanted {
                return (lag as f64 - 1.0 + (before - wanted) / (before - here)) * pitch_nm;
            }
            before = here;
        }
        0.5 * count as f64 * pitch_nm
    });
    (x * y).sqrt()
}

/// Strongest lines of the power spectrum in one half plane.
fn strongest_waves(field: &HeightField) -> Vec<([f64; 2], f64)> {
    let (rows, columns) = field.heights_nm.dim();
    let power = power_spectrum(field);
    let signed =
        |index: usize, count: usize| if 2 * index > count { index as f64 - count as f64 } else { index as f64 };
    let line = |index: usize| [signed(index % columns, columns), -signed(index / columns, rows)];
    let half_plane = |[x, y]: [f64; 2]| y > 0.0 || (y == 0.0 && x > 0.0);
    let strongest = |wanted: &dyn Fn([f64; 2]) -> bool| {
        (0..power.len())
            .filter(|&i| half_plane(line(i)) && wanted(line(i)))
            .max_by(|&a, &b| power[a].total_cmp(&power[b]).then(b.cmp(&a)))
            .filter(|&i| power[i] > 0.0)
    };
    let Some(first) = strongest(&|_| true) else { return Vec::new() };
    // Its own skirts (and those of its mirror image) are not a second wave.
    let at = line(first);
    let away = |[x, y]: [f64; 2]| {
        let reach = 2.0 + 0.2 * at[0].hypot(at[1]);
        (x - at[0]).hypot(y - at[1]) > reach && (x + at[0]).hypot(y + at[1]) > reach
    };
    let mut found = vec![first];
    found.extend(strongest(&away).filter(|&second| power[second] >= SECOND_WAVE * power[first]));
    let total: f64 = found.iter().map(|&i| power[i]).sum();
    let extent = field.extent_nm();
    found.iter().map(|&i| ([0, 1].map(|axis| line(i)[axis] / extent[axis]), power[i] / total)).collect()
}

/// `|DFT|²` of the centred heights, row-major.
fn power_spectrum(field: &HeightField) -> Vec<f64> {
    let heights = centred(field);
    let (rows, columns) = heights.dim();
    let mut planner = FftPlanner::new();
    let (along_x, along_y) = (planner.plan_fft_forward(columns), planner.plan_fft_forward(rows));
    let mut data: Vec<Complex<f64>> = heights.iter().map(|&h| Complex::new(h, 0.0)).collect();
    along_x.process(&mut data);
    let mut column_values = vec![Complex::default(); rows];
    for column in 0..columns {
        for (slot, row) in column_values.iter_mut().zip(data.chunks_exact(columns)) {
            *slot = row[column];
        }
        along_y.process(&mut column_values);
        for (row, value) in data.chunks_exact_mut(columns).zip(&column_values) {
            row[column] = *value;
        }
    }
    data.iter().map(|z| z.norm_sqr()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn two_sinusoids_are_found_with_their_shares_and_signs() {
        let heights_nm = ndarray::Array2::from_shape_fn((60, 80), |(row, column)| {
            // y points up: row 0 is the +y edge.
            let (x, y) = (column as f64 / 80.0, -(row as f64) / 60.0);
            30.0 * (TAU * (7.0 * x + 3.0 * y)).sin() + 20.0 * (TAU * (-2.0 * x + 9.0 * y)).sin()
        });
        let field = HeightField { heights_nm, pitch_nm: [50.0, 40.0] };
        let found = surface_statistics(&[field]);
        assert!((found.rms_nm - 650f64.sqrt()).abs() < 1e-9);
        let expected = [[7.0 / 4000.0, 3.0 / 2400.0], [-2.0 / 4000.0, 9.0 / 2400.0]];
        for ((wave, share), (expected, power)) in found.waves.iter().zip(expected.iter().zip([9.0 / 13.0, 4.0 / 13.0]))
        {
            assert!((wave[0] - expected[0]).abs() < 1e-12 && (wave[1] - expected[1]).abs() < 1e-12, "{found:?}");
            assert!((share - power).abs() < 1e-9);
        }
    }

    #[test]
    fn correlation_of_a_cosine_is_its_arc_cosine() {
        let heights_nm = ndarray::Array2::from_shape_fn((200, 200), |(row, column)| {
            (TAU * column as f64 / 50.0).sin() + (TAU * row as f64 / 50.0).sin()
        });
        let field = HeightField { heights_nm, pitch_nm: [10.0, 10.0] };
        // Covariance along an axis: (1 + cos(2π d / 500 nm)) / 2 = 1/e; lags are cut off, hence 3 %.
        let expected = 500.0 / TAU * (2.0 / std::f64::consts::E - 1.0).acos();
        assert!((surface_statistics(&[field]).correlation_nm / expected - 1.0).abs() < 0.03);
    }

    #[test]
    fn a_flat_surface_has_neither_height_nor_waves() {
        let field = HeightField { heights_nm: ndarray::Array2::zeros((8, 1)), pitch_nm: [10.0, 10.0] };
        let found = surface_statistics(&[field]);
        assert!(found.rms_nm == 0.0 && found.waves.is_empty() && found.correlation_nm.is_finite());
    }
}
