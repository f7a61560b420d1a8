//! Errors of spectral tables at single wavelengths: drawn places, the reference there, and each cause by itself.

use rayon::prelude::*;

use super::directions::{ABOVE_PER_BELOW, DRAWN, ErrorGroup, Group, floor_per_sr};
use super::rows::{Cause, ErrorRow, row};
use crate::ground::sampling::{Region, direction_pairs_in};
use crate::optics::factors::PairFactors;
use crate::optics::lines::Buffers;
use crate::optics::spectra;
use crate::optics::spectral::{brdf_of_window, diffuse_power};
use crate::tables::input::BuildInput;
use crate::tables::plan::BuildPlan;
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::{Vec3, max_abs_w};
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::spectral::SpectralTables;
use diffraction_brdf::spectrum::SpectralQuadrature;

/// The fractional part of the golden ratio: multiples of it fill an interval evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Two directions and a wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    wi: Vec3,
    wo: Vec3,
    wavelength_nm: f64,
}

/// Places on which errors are counted, group after group.
#[derive(Debug, Clone, Default)]
pub struct Places {
    groups: Vec<ErrorGroup>,
    places: Vec<Place>,
}

/// The BRDF at places, straight from the transforms.
#[derive(Debug, Clone)]
pub struct SpectralReference {
    /// The BRDF in 1/sr.
    brdf: Vec<f64>,
    /// Its diffuse part: exact, and interpolated in `w` as the tables do.
    diffuse: [Vec<f64>; 2],
}

impl Places {
    /// Of each region, with wavelengths evenly over the tables' range, the first that the tables show above the floor, up to
    /// `count`, and a quarter as many below it.
    pub fn drawn(tables: &SpectralTables, count: usize) -> Self {
        let drawn = |region| -> Vec<Place> {
            let pairs = direction_pairs_in(region, 0..DRAWN).into_iter().enumerate();
            let wavelength_nm = |index: usize| {
                tables.shortest_nm + (tables.longest_nm - tables.shortest_nm) * (index as f64 * GOLDEN).fract()
            };
            pairs.map(|(index, (wi, wo))| Place { wi, wo, wavelength_nm: wavelength_nm(index) }).collect()
        };
        let floor = floor_per_sr(
            tables.front_factor.material,
            &values(tables, Interpolation::Cubic, &drawn(Region::Hemisphere)),
        );
        let mut found = Self::default();
        for region in Region::ALL {
            let places = drawn(region);
            let shown = values(tables, Interpolation::Cubic, &places);
            let of = |above: bool, most: usize| {
                let chosen = places.iter().zip(&shown).filter(move |(_, shown)| (**shown > floor) == above);
                chosen.map(|(place, _)| *place).take(most).collect::<Vec<Place>>()
            };
            let [above, below] = [of(true, count), of(false, count.div_ceil(ABOVE_PER_BELOW))];
            found.groups.push(ErrorGroup {
                group: Group::Region(region),
                counts: [above.len(), below.len()],
                share_above: shown.iter().filter(|shown| **shown > floor).count() as f64 / shown.len() as f64,
                floor_per_sr: floor,
                left_out_per_sr: None,
            });
            found.places.extend(above.into_iter().chain(below));
        }
        found
    }
}

/// The tables' values at places, in 1/sr.
fn values(tables: &SpectralTables, interpolation: Interpolation, places: &[Place]) -> Vec<f64> {
    let value = |place: &Place| tables.eval(interpolation, place.wi, place.wo, &[place.wavelength_nm])[0];
    places.par_iter().map(value).collect()
}

/// Evaluates the reference: input and plan are those of the spectral tables, `count` is how many there are.
///
/// # Errors
/// Those of the transforms.
pub fn evaluate(input: &BuildInput, plan: &BuildPlan, count: usize, places: &Places) -> Result<SpectralReference> {
    let zeros = || vec![0.0; places.places.len()];
    let mut reference = SpectralReference { brdf: zeros(), diffuse: [zeros(), zeros()] };
    let share = 1.0 / plan.windows.len().max(1) as f64;
    for &(scan, placement) in &plan.windows {
        let spectra = spectra::transform(&input.fields[scan], placement, input.optics, &plan.spectra)?;
        let at = |place: &Place| -> [f64; 3] {
            let Some(factors) = PairFactors::of(input.optics, place.wi, place.wo) else { return [0.0; 3] };
            let mut brdf = 0.0;
            brdf_of_window(&spectra, &factors, &[place.wavelength_nm], &mut Buffers::default(), |_, value| {
                brdf = value
            });
            let [exact, interpolated] = diffuse(&spectra, input, count, factors.q, place.wavelength_nm);
            [brdf, exact, interpolated]
        };
        let found: Vec<[f64; 3]> = places.places.par_iter().map(at).collect();
        for (index, [brdf, exact, interpolated]) in found.into_iter().enumerate() {
            reference.brdf[index] += share * brdf;
            reference.diffuse[0][index] += share * exact;
            reference.diffuse[1][index] += share * interpolated;
        }
    }
    Ok(reference)
}

/// The diffuse part at `q` and a wavelength as the tables hold it, at the shortest wavelength: exact, and through their nodes.
fn diffuse(spectra: &spectra::Spectra, input: &BuildInput, count: usize, q: Vec3, wavelength_nm: f64) -> [f64; 2] {
    let [shortest_nm, _] = input.wavelength_range_nm;
    let [u, v, w] = q.map(|part| part * shortest_nm / wavelength_nm);
    let reach = max_abs_w(u.hypot(v));
    let mut points = chebyshev::gauss_nodes(count, 0.0, reach);
    let weights = chebyshev::interpolation_weights(count, 0.0, reach, w.abs().min(reach));
    points.push(w.abs());
    let one = SpectralQuadrature { wavelengths_nm: vec![shortest_nm], weights: vec![[1.0; 3]] };
    let values = diffuse_power(spectra, &one, [u, v], &points);
    let interpolated = values.iter().zip(&weights).map(|(value, weight)| value[1] * weight).sum();
    [values[count][1], interpolated]
}

/// Error rows of the stored tables, as read back, and of those before rounding.
pub fn rows(
    places: &Places,
    reference: &SpectralReference,
    stored: &SpectralTables,
    built: &SpectralTables,
) -> Vec<ErrorRow> {
    let all = &places.places;
    let total = |look_up| values(stored, look_up, all);
    let [linear, cubic] = [Interpolation::Bilinear, Interpolation::Cubic].map(total);
    // The diffuse part as bright as it is seen, so that one floor counts for all rows.
    let front: Vec<f64> = all
        .iter()
        .map(|place| {
            let ratio = stored.shortest_nm / place.wavelength_nm;
            ratio.powi(4) * stored.front_factor.diffuse(place.wi, place.wo)
        })
        .collect();
    let seen = |diffuse: &[f64]| -> Vec<f64> { diffuse.iter().zip(&front).map(|(d, front)| d * front).collect() };
    let [exact, interpolated] = [0, 1].map(|i| seen(&reference.diffuse[i]));
    let [on_grid, rounded] = [built, stored].map(|tables| {
        let value = |place: &Place| tables.diffuse(Interpolation::Bilinear, place.wi, place.wo, place.wavelength_nm);
        seen(&all.iter().map(value).collect::<Vec<_>>())
    });
    let mut start = 0;
    let mut rows = Vec::new();
    for group in &places.groups {
        let range = start..start + group.len();
        start = range.end;
        let of = |cause, exact: &[f64], test: &[f64]| row(cause, group, &exact[range.clone()], &test[range.clone()]);
        rows.extend([
            of(Cause::Total, &reference.brdf, &linear),
            of(Cause::TotalCubic, &reference.brdf, &cubic),
            of(Cause::Basis, &exact, &interpolated),
            of(Cause::Grid, &interpolated, &on_grid),
            of(Cause::Storage, &on_grid, &rounded),
        ]);
    }
    rows
}
