//! Errors of spectral tables at single wavelengths: drawn places, the reference there, and each cause by itself.

use rayon::prelude::*;

use super::directions::{DIRECTIONS, ErrorGroup, Group, chosen, drawn_pairs, floor_per_sr, near_deg};
use super::rows::{Cause, ErrorRow, diffuse_rows, seen, total_rows};
use super::texels::largest_of;
use crate::ground::sampling::Region;
use crate::optics::config::OpticsConfig;
use crate::optics::factors::PairFactors;
use crate::optics::lines::Buffers;
use crate::optics::spectra;
use crate::optics::spectral::{brdf_of_window, diffuse_power};
use crate::tables::input::BuildInput;
use crate::tables::plan::BuildPlan;
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::{Vec3, Xyz, max_abs_w};
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
    /// The BRDF in 1/sr; grey, as all here.
    brdf: Vec<Xyz>,
    /// Its diffuse part: exact, and interpolated in `w` as the tables do.
    diffuse: [Vec<Xyz>; 2],
}

impl Places {
    /// Of each region, with wavelengths evenly over the tables' range, as many places above and below the floor as
    /// [`ErrorDirections::drawn`](super::directions::ErrorDirections::drawn) takes; `lobe_radius` is the lobe's in (u, v) where it
    /// is widest.
    pub fn drawn(tables: &SpectralTables, lobe_radius: f64, count: usize) -> Self {
        let near_deg = near_deg(lobe_radius);
        let wavelength_nm = |index: usize| {
            tables.shortest_nm + (tables.longest_nm - tables.shortest_nm) * (index as f64 * GOLDEN).fract()
        };
        let drawn = |region| -> Vec<Place> {
            let pairs = drawn_pairs(region, near_deg, 0).into_iter().enumerate();
            pairs.map(|(index, (wi, wo))| Place { wi, wo, wavelength_nm: wavelength_nm(index) }).collect()
        };
        let hemisphere = values(tables, Interpolation::Cubic, &drawn(Region::Hemisphere));
        let floor_per_sr = floor_per_sr(tables.front_factor.material, &hemisphere);
        let mut found = Self::default();
        for region in Region::ALL {
            let places = drawn(region);
            let [linear, cubic] =
                [Interpolation::Bilinear, Interpolation::Cubic].map(|look_up| values(tables, look_up, &places));
            // What is no number shall be seen.
            let brightest = |(a, b): (&f64, &f64)| if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(*b) };
            let shown: Vec<f64> = linear.iter().zip(&cubic).map(brightest).collect();
            let (group, places) = chosen(Group::Region(region), &places, &shown, floor_per_sr, count);
            found.groups.push(group);
            found.places.extend(places);
        }
        found
    }
}

/// The tables' values at places, in 1/sr.
fn values(tables: &SpectralTables, interpolation: Interpolation, places: &[Place]) -> Vec<f64> {
    let value = |place: &Place| tables.eval(interpolation, place.wi, place.wo, &[place.wavelength_nm])[0];
    places.par_iter().map(value).collect()
}

/// What spline look-ups in tables err by at 95 of 100 lit places, the largest of the regions, told as
/// [`spline_error`](super::texels::spline_error) does.
pub fn spline_error(tables: &SpectralTables, lobe_radius: f64) -> f64 {
    let Places { groups, places } = Places::drawn(tables, lobe_radius, DIRECTIONS);
    let [spline, cubic] = [Interpolation::Spline, Interpolation::Cubic].map(|kind| grey(values(tables, kind, &places)));
    let pairs: Vec<[Xyz; 2]> = spline.into_iter().zip(cubic).map(|(spline, cubic)| [spline, cubic]).collect();
    largest_of(&groups, &pairs)
}

/// As rows take them: a wavelength by itself counts in every channel.
fn grey(values: impl IntoIterator<Item = f64>) -> Vec<Xyz> {
    values.into_iter().map(|value| [value; 3]).collect()
}

/// Evaluates the reference: input and plan are those of the spectral tables, `optics` is what holds at every wavelength
/// ([`SpectralInput::optics_at_each`](crate::tables::spectral::SpectralInput::optics_at_each)), `count` is how many tables there
/// are.
///
/// # Errors
/// Those of the transforms.
pub fn evaluate(
    input: &BuildInput,
    plan: &BuildPlan,
    optics: &OpticsConfig,
    count: usize,
    places: &Places,
) -> Result<SpectralReference> {
    let mut sums = vec![[0.0; 3]; places.places.len()];
    let share = 1.0 / plan.windows.len().max(1) as f64;
    for &(scan, placement) in &plan.windows {
        let spectra = spectra::transform(&input.fields[scan], placement, optics, &plan.spectra)?;
        let at = |place: &Place| -> [f64; 3] {
            let Some(factors) = PairFactors::of(optics, place.wi, place.wo) else { return [0.0; 3] };
            let mut brdf = 0.0;
            brdf_of_window(&spectra, &factors, &[place.wavelength_nm], &mut Buffers::default(), |_, value| {
                brdf = value
            });
            let [exact, interpolated] = diffuse(&spectra, input, count, factors.q, place.wavelength_nm);
            [brdf, exact, interpolated]
        };
        let found: Vec<[f64; 3]> = places.places.par_iter().map(at).collect();
        for (sums, found) in sums.iter_mut().zip(found) {
            sums.iter_mut().zip(found).for_each(|(sum, value)| *sum += share * value);
        }
    }
    let part = |kind: usize| grey(sums.iter().map(|sums| sums[kind]));
    Ok(SpectralReference { brdf: part(0), diffuse: [part(1), part(2)] })
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
    let front: Vec<f64> = all
        .iter()
        .map(|place| {
            let ratio = stored.shortest_nm / place.wavelength_nm;
            ratio.powi(4) * stored.front_factor.diffuse(place.wi, place.wo)
        })
        .collect();
    let [exact, interpolated] = [0, 1].map(|i| seen(&reference.diffuse[i], &front));
    let [on_grid, rounded] = [built, stored].map(|tables| {
        let value = |place: &Place| tables.diffuse(Interpolation::Spline, place.wi, place.wo, place.wavelength_nm);
        seen(&grey(all.par_iter().map(value).collect::<Vec<f64>>()), &front)
    });
    let mut start = 0;
    let mut rows = Vec::new();
    for group in &places.groups {
        let range = start..start + group.len();
        start = range.end;
        let of = |values: &[Xyz]| values[range.clone()].to_vec();
        rows.extend(total_rows(group, &reference.brdf[range.clone()], Interpolation::Spline, |look_up| {
            grey(values(stored, look_up, &all[range.clone()]))
        }));
        let steps = [(Cause::Basis, of(&interpolated)), (Cause::Grid, of(&on_grid)), (Cause::Storage, of(&rounded))];
        rows.extend(diffuse_rows(group, of(&exact), steps));
    }
    rows
}
