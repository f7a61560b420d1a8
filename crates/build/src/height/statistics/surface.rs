//! Parameters of surface texture after ISO 25178-2, and the radially averaged power spectral density.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::autocorrelation::Decay;
use super::spectrum::Spectrum;
use crate::ground::null_for_nan;
use crate::height::HeightField;

/// Height, hybrid and spatial parameters of the whole field about its mean plane, unfiltered (no S-filter, no L-filter).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SurfaceParameters {
    /// Arithmetic mean height in nm.
    pub sa_nm: f64,
    /// Root mean square height in nm.
    pub sq_nm: f64,
    /// Skewness.
    #[serde(with = "null_for_nan")]
    pub ssk: f64,
    /// Kurtosis; 3 of normal heights.
    #[serde(with = "null_for_nan")]
    pub sku: f64,
    /// Highest minus lowest height in nm.
    pub sz_nm: f64,
    /// Root mean square gradient, each direction averaged over its own differences.
    pub sdq: f64,
    /// Developed interfacial area ratio, 0 for a plane; the mean over both ways to divide a cell into triangles.
    pub sdr: f64,
    /// Autocorrelation length in nm: shortest distance at which the autocorrelation falls to 0.2; NaN where it does not within half the field.
    #[serde(with = "null_for_nan")]
    pub sal_nm: f64,
    /// Texture aspect ratio: shortest over longest such distance; NaN likewise.
    #[serde(with = "null_for_nan")]
    pub str_ratio: f64,
}

impl std::fmt::Display for SurfaceParameters {
    /// On one line; what a scan is too small to tell is left out.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { sa_nm, sq_nm, ssk, sku, sz_nm, sdq, sdr, sal_nm, str_ratio } = *self;
        write!(f, "Sa {sa_nm:.2} nm, Sq {sq_nm:.2} nm, Sz {sz_nm:.1} nm, Ssk {ssk:.2}, Sku {sku:.2}, Sdq {sdq:.3}")?;
        write!(f, ", Sdr {:.2} %", 100.0 * sdr)?;
        if !sal_nm.is_nan() {
            write!(f, ", Sal {sal_nm:.0} nm")?;
        }
        if !str_ratio.is_nan() {
            write!(f, ", Str {str_ratio:.2}")?;
        }
        Ok(())
    }
}

/// The parameters of heights about their mean plane, of which `decay` is the autocorrelation's fall to 0.2.
pub(super) fn parameters(levelled: &HeightField, decay: Decay) -> SurfaceParameters {
    let heights = &levelled.heights_nm;
    let count = heights.len() as f64;
    let mean = |of: fn(f64) -> f64| heights.iter().map(|height| of(*height)).sum::<f64>() / count;
    let sq_nm = mean(|h| h * h).sqrt();
    let (low, high) = crate::height::prepare::range_nm(levelled);
    SurfaceParameters {
        sa_nm: mean(f64::abs),
        sq_nm,
        ssk: mean(|h| h.powi(3)) / sq_nm.powi(3),
        sku: mean(|h| h.powi(4)) / sq_nm.powi(4),
        sz_nm: high - low,
        sdq: gradient(levelled),
        sdr: area_ratio(levelled),
        sal_nm: decay.shortest_nm,
        str_ratio: decay.shortest_nm / decay.longest_nm,
    }
}

fn gradient(field: &HeightField) -> f64 {
    let of_axis = |axis: usize| {
        let axis_of = ndarray::Axis(1 - axis);
        let lines = field.heights_nm.lanes(axis_of);
        let (sum, count) = lines.into_iter().fold((0.0, 0usize), |(sum, count), line| {
            let squares = line.iter().zip(line.iter().skip(1)).map(|(a, b)| (b - a) * (b - a)).sum::<f64>();
            (sum + squares, count + line.len() - 1)
        });
        if count == 0 { 0.0 } else { sum / count as f64 / field.pitch_nm[axis].powi(2) }
    };
    (of_axis(0) + of_axis(1)).sqrt()
}

fn area_ratio(field: &HeightField) -> f64 {
    let h = &field.heights_nm;
    let [dx, dy] = field.pitch_nm;
    let [nx, ny] = field.size();
    if nx < 2 || ny < 2 {
        return 0.0;
    }
    let of_row = |row: usize| {
        (0..nx - 1)
            .map(|column| {
                let [a, b] = [h[[row, column]], h[[row, column + 1]]];
                let [c, d] = [h[[row + 1, column]], h[[row + 1, column + 1]]];
                let corner =
                    |along_x: f64, along_y: f64| (1.0 + (along_x / dx).powi(2) + (along_y / dy).powi(2)).sqrt();
                0.25 * (corner(b - a, c - a) + corner(b - a, d - b) + corner(d - c, d - b) + corner(d - c, c - a)) - 1.0
            })
            .sum::<f64>()
    };
    // Summed row by row in order: the same on any number of threads.
    let rows: Vec<f64> = (0..ny - 1).into_par_iter().map(of_row).collect();
    rows.iter().sum::<f64>() / ((nx - 1) * (ny - 1)) as f64
}

/// One ring of the power spectral density.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PsdRing {
    /// Mean spatial frequency of its lines in 1/µm.
    pub per_um: f64,
    /// Mean two-dimensional density in nm² µm², one for every direction; its integral over the plane of frequencies is the mean square
    /// height.
    pub nm2_um2: f64,
}

/// The power spectral density, averaged over all directions, of heights about their mean plane under a Hann window: a ring for each line of the
/// coarser axis.
pub fn radial_psd(levelled: &HeightField) -> Vec<PsdRing> {
    let spectrum = Spectrum::new(levelled);
    let [x, y] = spectrum.line_per_nm;
    // Of weights with a sum of 1, the sum of squares is 1.5/n along each axis of more than one sample.
    let kept: f64 = levelled.size().iter().map(|&n| if n > 1 { 1.5 / n as f64 } else { 1.0 }).product();
    let count: f64 = levelled.size().iter().map(|&n| n as f64).product();
    let density = 1.0 / (kept * count) / (x * y) * 1e-6;
    let mut rings: Vec<[f64; 3]> = Vec::new();
    for line in spectrum.half_plane() {
        let place = line.map(|line| line as f64);
        let ring = spectrum.ring(place);
        if rings.len() <= ring {
            rings.resize(ring + 1, [0.0; 3]);
        }
        let per_um = (place[0] * x).hypot(place[1] * y) * 1e3;
        let [sum, power, lines] = &mut rings[ring];
        (*sum, *power, *lines) = (*sum + per_um, *power + spectrum.power(line), *lines + 1.0);
    }
    let filled = rings.into_iter().filter(|[_, _, lines]| *lines > 0.0);
    filled.map(|[sum, power, lines]| PsdRing { per_um: sum / lines, nm2_um2: density * power / lines }).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use ndarray::Array2;

    use super::*;
    use crate::height::prepare::repair::levelled;
    use crate::height::statistics::autocorrelation;

    fn of(height: impl Fn(f64, f64) -> f64, size: [usize; 2], pitch_nm: [f64; 2]) -> (HeightField, SurfaceParameters) {
        let heights_nm = Array2::from_shape_fn((size[1], size[0]), |(row, column)| {
            height(column as f64 * pitch_nm[0], row as f64 * pitch_nm[1])
        });
        let field = levelled(&HeightField { heights_nm, pitch_nm });
        let decay = autocorrelation::decay(&field, 0.2);
        let found = parameters(&field, decay);
        (field, found)
    }

    #[test]
    fn a_sinusoid_meets_its_closed_forms() {
        let (amplitude, period) = (40.0, 1000.0);
        let (field, found) = of(|x, _| amplitude * (TAU * x / period).sin(), [800, 60], [12.5, 20.0]);
        // Ten whole periods of 80 samples; the mean plane takes less than 2 % of a sine's height away.
        let close = |found: f64, expected: f64, share: f64| {
            assert!((found / expected - 1.0).abs() < share, "{found} {expected}")
        };
        close(found.sa_nm, amplitude * 2.0 / std::f64::consts::PI, 0.02);
        close(found.sq_nm, amplitude / 2f64.sqrt(), 0.02);
        close(found.sku, 1.5, 0.02);
        assert!(found.ssk.abs() < 0.05);
        // A chord over 1/80 of a period is 1 - 2.6e-4 of the slope.
        close(found.sdq, TAU * amplitude / period / 2f64.sqrt(), 2e-2);
        // For small slopes half of their mean square, less an eighth of their mean fourth power.
        let square = (TAU * amplitude / period).powi(2);
        close(found.sdr, square / 4.0 - 3.0 / 64.0 * square * square, 0.03);
        close(found.sal_nm, period * 0.2f64.acos() / TAU, 0.02);
        assert!(found.str_ratio.is_nan(), "along the grooves it never falls");
        // All its power lies near 1 per µm.
        let rings = radial_psd(&field);
        let highest = rings.iter().max_by(|a, b| a.nm2_um2.total_cmp(&b.nm2_um2)).unwrap();
        assert!((highest.per_um - 1.0).abs() < 0.5, "{highest:?}");
    }

    #[test]
    fn the_density_integrates_to_the_mean_square_height() {
        let mut random = fastrand::Rng::with_seed(9);
        let heights_nm = Array2::from_shape_simple_fn((96, 128), || 20.0 * (random.f64() - 0.5));
        let field = levelled(&HeightField { heights_nm, pitch_nm: [30.0, 40.0] });
        let found = parameters(&field, autocorrelation::decay(&field, 0.2));
        // White: the same density at all frequencies, whose area is that of one sample in the plane of frequencies.
        let expected = found.sq_nm.powi(2) * 0.030 * 0.040;
        let rings = radial_psd(&field);
        let mean = rings[5..45].iter().map(|ring| ring.nm2_um2).sum::<f64>() / 40.0;
        // Some 5000 lines, neighbours of which are correlated by the window: a deviation of 3 %.
        assert!((mean / expected - 1.0).abs() < 0.1, "{mean} {expected}");
        assert!((found.sku - 1.8).abs() < 0.05, "that of a uniform distribution is 9/5");
        assert!(found.sal_nm < 60.0 && found.str_ratio > 0.5, "{found:?}");
    }

    /// Of surfalize 0.19.2 (PyPI), of the bundled scan levelled by NumPy's least squares: `tests/surface_parameters.py`.
    #[test]
    fn a_real_scan_has_the_parameters_that_another_program_finds() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../specimens/grating_nanosurf_314nm.tif");
        let config = crate::height::read::ReadConfig {
            height: Some(crate::height::read::HeightScale::Unit(crate::height::read::LengthUnit::Nm)),
            ..Default::default()
        };
        let scan = crate::height::read::read_scan(&path, &config).unwrap();
        let field = levelled(&scan.field);
        let found = parameters(&field, autocorrelation::decay(&field, 0.2));
        let table = [
            (found.sa_nm, 15.214345670363387),
            (found.sq_nm, 17.288945652963933),
            (found.ssk, 0.2610139440160074),
            (found.sku, 1.7221293493400873),
            (found.sz_nm, 63.76946868629761),
            (found.sdq, 0.38462166781969287),
            (found.sdr, 0.0694117328594166),
        ];
        for (found, expected) in table {
            assert!((found / expected - 1.0).abs() < 1e-8, "{found} {expected}");
        }
        // That program takes the autocorrelation under another weight.
        assert!((found.sal_nm / 65.694 - 1.0).abs() < 0.05, "{found:?}");
        assert!(found.str_ratio.is_nan());
    }
}
