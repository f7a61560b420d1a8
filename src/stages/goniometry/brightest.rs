//! The brightest directions in light from straight above, and their spectra.

use std::f64::consts::PI;

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use super::instrument::{ACCEPTANCE_DEG, Instrument};
use super::maps::{SIZE_PX, cosine_at};
use diffraction_brdf::direction::{Vec3, angles_deg};
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::{Footprint, SpectralTables};
use diffraction_build::ground::hue::Hue;

/// Most directions beside the mirror's.
const DIRECTIONS_MAX: usize = 3;

/// In direction cosines: how far from the mirror's direction and from each other they lie, and how close to opposite each
/// other two are that count once.
const APART: f64 = 0.12;

/// Largest distance from the normal in direction cosines: 75 degrees. Towards grazing everything grows bright.
const RADIUS_MAX: f64 = 0.966;

/// Step of spectra in nm.
const STEP_NM: f64 = 5.0;

/// A direction that is bright in light from straight above.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BrightDirection {
    /// Polar angle in degrees.
    pub theta_deg: f64,
    /// Azimuth in degrees from +x towards +y.
    pub phi_deg: f64,
    /// XYZ of the radiance factor.
    pub xyz: [f64; 3],
    /// Its colour in words and numbers; `None` where it is dark.
    pub hue: Option<Hue>,
    /// Wavelengths in nm of the spectrum; empty where there are no spectral tables.
    pub wavelength_nm: Vec<f64>,
    /// Radiance factor at each.
    pub radiance_factor: Vec<f64>,
}

/// The mirror's direction and the brightest ones beside it, the brightest first, found in a map for light from above.
pub(super) fn brightest(
    instrument: &Instrument,
    map: &Array3<f32>,
    spectral: Option<&SpectralTables>,
) -> Result<Vec<BrightDirection>> {
    let filtered = spectral.map(|tables| (tables, tables.filtered()));
    let light = [0.0, 0.0, 1.0];
    let footprint = Footprint::of_light(light, ACCEPTANCE_DEG)?;
    std::iter::once(light)
        .chain(peaks(map))
        .map(|wo| {
            let xyz = instrument.radiance_factor(light, wo)?;
            let (wavelength_nm, radiance_factor) = match &filtered {
                None => Default::default(),
                Some((tables, filtered)) => {
                    let steps = ((tables.longest_nm - tables.shortest_nm) / STEP_NM).floor() as usize;
                    let nm: Vec<f64> = (0..=steps).map(|n| tables.shortest_nm + STEP_NM * n as f64).collect();
                    let brdf = filtered.eval_filtered(Interpolation::Bilinear, light, wo, footprint, &nm);
                    (nm, brdf.into_iter().map(|value| PI * value).collect())
                }
            };
            let [theta_deg, phi_deg] = angles_deg(wo);
            let hue = Hue::of(xyz, instrument.white());
            Ok(BrightDirection { theta_deg, phi_deg, xyz, hue, wavelength_nm, radiance_factor })
        })
        .collect()
}

/// Directions of the map's maxima of luminance outside the mirror's, apart from each other.
fn peaks(map: &Array3<f32>) -> Vec<Vec3> {
    let all = (1..SIZE_PX - 1).flat_map(|row| (1..SIZE_PX - 1).map(move |column| [row, column]));
    let is_in_reach = |&[row, column]: &[usize; 2]| {
        (APART..RADIUS_MAX).contains(&cosine_at(column).hypot(cosine_at(row))) && is_maximum(map, [row, column])
    };
    let mut pixels: Vec<(f32, [f64; 2])> = all
        .filter(is_in_reach)
        .map(|[row, column]| (map[[row, column, 1]], [cosine_at(column), -cosine_at(row)]))
        .collect();
    // Of two that are equally bright, the one towards +x, then towards +y.
    pixels.sort_by(|a, b| {
        b.0.total_cmp(&a.0).then_with(|| b.1[0].total_cmp(&a.1[0])).then_with(|| b.1[1].total_cmp(&a.1[1]))
    });
    let mut chosen: Vec<[f64; 2]> = Vec::new();
    for (_, [x, y]) in pixels {
        let is_apart = |[a, b]: &[f64; 2]| (x - a).hypot(y - b) >= APART && (x + a).hypot(y + b) >= APART;
        if chosen.iter().all(is_apart) {
            chosen.push([x, y]);
        }
        if chosen.len() == DIRECTIONS_MAX {
            break;
        }
    }
    chosen.into_iter().map(|[x, y]| [x, y, (1.0 - x * x - y * y).max(0.0).sqrt()]).collect()
}

/// Whether a pixel is lit, and no neighbour brighter.
fn is_maximum(map: &Array3<f32>, [row, column]: [usize; 2]) -> bool {
    let own = map[[row, column, 1]];
    let mut around = (row - 1..row + 2).flat_map(|row| (column - 1..column + 2).map(move |column| [row, column, 1]));
    own > 0.0 && around.all(|pixel| map[pixel] <= own)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_are_maxima_that_lie_apart() {
        let mut map = Array3::zeros((SIZE_PX, SIZE_PX, 3));
        let mut set = |x: f64, y: f64, value: f32| {
            let pixel = |cosine: f64| ((cosine + 1.0) * SIZE_PX as f64 / 2.0) as usize;
            map[[pixel(-y), pixel(x), 1]] = value;
        };
        set(0.0, 0.0, 100.0);
        set(0.5, 0.0, 9.0);
        set(-0.5, 0.0, 9.0);
        set(0.55, 0.02, 8.0);
        set(0.0, -0.7, 5.0);
        set(0.99, 0.0, 50.0);
        let found = peaks(&map);
        let expected = [[0.5, 0.0], [0.0, -0.7]];
        assert_eq!(found.len(), 2, "{found:?}");
        for ([x, y, _], [a, b]) in found.iter().zip(expected) {
            assert!((x - a).abs() < 0.01 && (y - b).abs() < 0.01, "{found:?}");
        }
    }
}
