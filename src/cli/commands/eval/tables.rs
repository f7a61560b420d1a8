//! Values from the tables of an atlas, as a renderer looks them up.

use std::path::Path;

use rayon::prelude::*;

use super::args::EvalArgs;
use super::values::{Evaluated, Table, check_polarised, polarised_table, warn_beyond, wavelength_columns, xyz_table};
use crate::cli::output;
use crate::error::Result;
use crate::stages::archive::specimen_file;
use diffraction_brdf::Brdf;
use diffraction_brdf::atlas;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::Error;
use diffraction_brdf::evaluate::{answers, brdf_xyz_polarised};
use diffraction_brdf::spectral_storage::read_spectral;
use diffraction_build::optics::light::white;

/// Values of an atlas's specimen.
///
/// # Errors
/// An unreadable atlas, directions that it does not answer for, and what its tables cannot tell.
pub(super) fn from_tables(atlas: &Path, args: &EvalArgs, pairs: &[(Vec3, Vec3)]) -> Result<Evaluated> {
    let folder = output::version_folder(atlas)?;
    let index = atlas::read_index(&folder)?;
    let specimen_folder = atlas::specimen_folder(&folder, &index, &args.specimen)?;
    if args.illuminant.is_some() || !args.wavelengths_nm.is_empty() {
        return from_spectral(&specimen_folder, args, pairs);
    }
    let (file, set) = specimen_file::load(&specimen_folder)?;
    warn_beyond(set.usable_radius, pairs);
    let interpolation = args.interpolation.look_up();
    let beyond: Vec<usize> = (0..pairs.len())
        .filter(|&index| !answers(&set, interpolation, pairs[index].0, pairs[index].1))
        .map(|index| index + 1)
        .collect();
    if let Some(first) = beyond.first() {
        return Err(Error::limit(
            format!(
                "{} of {} directions, row {first} the first, lie outside of what this atlas covers: its tables were made \
                 for the scenes of its manifest alone",
                beyond.len(),
                pairs.len()
            ),
            "set tables.serve = \"all\" and run the pipeline again, or evaluate with `--method reference`",
        )
        .into());
    }
    let white = Some(white(&file.optics.illuminant, file.optics.wavelength_nm)?);
    if args.polarised {
        check_polarised(set.front_factor, &args.specimen)?;
        let value = |&(wi, wo): &(Vec3, Vec3)| brdf_xyz_polarised(&set, interpolation, wi, wo).unwrap_or_default();
        let values: Vec<[Xyz; 4]> = pairs.par_iter().map(value).collect();
        return Ok(Evaluated { table: polarised_table(&values), white });
    }
    let brdf = Brdf::new(set)?.with_interpolation(interpolation);
    let values: Vec<Xyz> = pairs.par_iter().map(|&(wi, wo)| brdf.eval(wi, wo)).collect();
    Ok(Evaluated { table: xyz_table(values), white })
}

/// From the spectral tables: single wavelengths, or X, Y, Z under a light.
fn from_spectral(folder: &Path, args: &EvalArgs, pairs: &[(Vec3, Vec3)]) -> Result<Evaluated> {
    let file = specimen_file::read(folder)?;
    let Some(stored) = &file.spectral else {
        return Err(Error::limit(
            format!("`{}` has no spectral tables in this atlas", args.specimen),
            "run the pipeline with tables.hold = [\"spectral\", \"xyz\"], or evaluate with `--method reference`",
        )
        .into());
    };
    let tables = read_spectral(folder, stored, file.optics.front_factor())?;
    warn_beyond(tables.usable_radius, pairs);
    let look_up = args.interpolation.look_up();
    if let Some(illuminant) = &args.illuminant {
        let light = tables.under(look_up, &illuminant.light)?;
        let values: Vec<Xyz> = pairs.par_iter().map(|&(wi, wo)| light.eval(wi, wo)).collect();
        let white = Some(white(&illuminant.light, file.optics.wavelength_nm)?);
        return Ok(Evaluated { table: xyz_table(values), white });
    }
    tables.check_wavelengths(&args.wavelengths_nm)?;
    let values = pairs.par_iter().map(|&(wi, wo)| tables.eval(look_up, wi, wo, &args.wavelengths_nm)).collect();
    let table = Table { columns: wavelength_columns(&args.wavelengths_nm), values };
    Ok(Evaluated { table, white: None })
}
