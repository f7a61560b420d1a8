//! A specimen's published spectral tables on the GPU, value by value against the CPU.

use std::path::Path;

use super::device::GpuDevice;
use super::results::GpuSpectralRow;
use crate::stages::archive::specimen_file;
use diffraction_brdf::SpectralTables;
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::shader_spectral::spectral_image;
use diffraction_brdf::spectral_storage::read_spectral;
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_render::error::Result;
use diffraction_render::render::gpu_bound_spectral::SpectralBound;
use diffraction_render::render::gpu_spectral::{SpectralQuery, eval_spectral, upload_spectral};
use rayon::prelude::*;

/// Pairs of directions of each region, each at a wavelength of its own.
const PAIRS: usize = 256;

/// Multiples of it fill an interval evenly: the fractional part of the golden ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Share of the tables' range of wavelengths that is left out at either end, where rounding to 32 bits might leave it.
const MARGIN: f64 = 1e-3;

/// Checks the spectral tables in a specimen's folder; `None` where it has none.
///
/// # Errors
/// `Error::Gpu` above all; the disk's; `Error::Limit` for tables that not every GPU takes. A value that differs is no error.
pub(super) fn check_spectral(device: &GpuDevice, folder: &Path, specimen: &str) -> Result<Option<GpuSpectralRow>> {
    let file = specimen_file::read(folder)?;
    let Some(stored) = &file.spectral else { return Ok(None) };
    let tables = read_spectral(folder, stored, file.optics.front_factor())?;
    let image = spectral_image(&tables)?;
    let queries = queries(&tables);
    let asked = queries.clone();
    let found = device
        .thread()
        .run("evaluate the spectral tables", move |gpu| eval_spectral(gpu, &upload_spectral(gpu, &image)?, &asked))?;
    Ok(Some(compared(&tables, specimen, &queries, &found)))
}

/// Pairs over the hemisphere, near the mirror direction and at grazing angles.
fn queries(tables: &SpectralTables) -> Vec<SpectralQuery> {
    let pairs = Region::ALL.into_iter().flat_map(|region| direction_pairs(region, PAIRS));
    let query = |(index, (wi, wo)): (usize, (Vec3, Vec3))| {
        let share = MARGIN + (1.0 - 2.0 * MARGIN) * (index as f64 * GOLDEN).fract();
        let nm = (tables.shortest_nm + share * (tables.longest_nm - tables.shortest_nm)) as f32;
        let own = tables.dispersion.as_ref().and_then(|dispersion| dispersion.index_at(f64::from(nm)));
        SpectralQuery {
            wi: wi.map(|part| part as f32),
            wavelength_nm: nm,
            wo: wo.map(|part| part as f32),
            own_index: u32::from(own.is_some()),
            index: own.unwrap_or_default().map(|part| part as f32),
            unused: [0; 2],
        }
    };
    pairs.enumerate().map(query).collect()
}

/// The GPU's values against those of the CPU at the same rounded directions and wavelengths.
fn compared(tables: &SpectralTables, specimen: &str, queries: &[SpectralQuery], found: &[f32]) -> GpuSpectralRow {
    let bound = SpectralBound::new(tables);
    let share = |(query, found): (&SpectralQuery, &f32)| {
        let [wi, wo] = [query.wi, query.wo].map(|v| v.map(f64::from));
        let nm = f64::from(query.wavelength_nm);
        let exact = tables.eval(Interpolation::Bilinear, wi, wo, &[nm])[0];
        let share = (f64::from(*found) - exact).abs() / bound.at(wi, wo, nm);
        // What is no number exceeds whatever is allowed.
        if share.is_nan() { f64::MAX } else { share }
    };
    let shares: Vec<f64> = queries.par_iter().zip(found).map(share).collect();
    GpuSpectralRow {
        specimen: specimen.to_owned(),
        values: found.len(),
        not_finite: found.iter().filter(|value| !value.is_finite()).count(),
        beyond: shares.iter().filter(|share| **share > 1.0).count(),
        worst_of_tolerance: shares.iter().copied().fold(0.0, f64::max),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::front_factor::{Factor, FrontFactor};
    use diffraction_brdf::material::Material;
    use ndarray::Array3;

    #[test]
    fn a_value_beyond_its_bound_is_counted() {
        let tables = SpectralTables {
            shortest_nm: 400.0,
            longest_nm: 700.0,
            count: 1,
            images: vec![Array3::from_elem((5, 5, 3), 0.25)],
            lobe: None,
            prefilter_width: 0.0,
            front_factor: FrontFactor { material: Material::Ideal, shadowing: false, factor: Factor::Scalar },
            dispersion: None,
            usable_radius: 2.0,
            sigma_nm: 4_000.0,
            half_height_range_nm: 100.0,
        };
        let queries = queries(&tables);
        assert!(queries.len() > 700 && queries.iter().all(|query| (400.0..700.0).contains(&query.wavelength_nm)));
        let value = |query: &SpectralQuery| {
            let [wi, wo] = [query.wi, query.wo].map(|v| v.map(f64::from));
            tables.eval(Interpolation::Bilinear, wi, wo, &[f64::from(query.wavelength_nm)])[0] as f32
        };
        let mut found: Vec<f32> = queries.iter().map(value).collect();
        let right = compared(&tables, "flat", &queries, &found);
        assert!(right.passed() && right.complaint().is_none() && right.worst_of_tolerance < 1.0, "{right:?}");
        (found[3], found[9]) = (1.01 * found[3], f32::NAN);
        let wrong = compared(&tables, "flat", &queries, &found);
        assert_eq!((wrong.beyond, wrong.not_finite, wrong.passed()), (2, 1, false));
        assert!(wrong.complaint().unwrap().contains("2 of "), "{:?}", wrong.complaint());
    }
}
