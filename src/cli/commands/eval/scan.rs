//! Values straight from a specimen's scans: by their transforms, or sample by sample.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::args::{EvalArgs, Method};
use super::values::{
    Evaluated, Table, check_polarised, polarised_columns, polarised_table, warn_beyond, wavelength_columns, xyz_table,
};
use crate::cli::destination;
use crate::cli::options::Global;
use crate::cli::progress::reporter;
use crate::error::Result;
use crate::manifest;
use crate::manifest::inputs::inputs;
use crate::stages::ingest::{Scans, ingest};
use diffraction_brdf::direction::{Vec3, wave_vector_change};
use diffraction_brdf::error::{self, Error};
use diffraction_build::ground::progress::Progress;
use diffraction_build::optics::light::white;
use diffraction_build::optics::reference;
use diffraction_build::optics::spectra::SpectraConfig;
use diffraction_build::optics::spectral;
use diffraction_build::tables::resolution::usable_radius;

/// Amplitude error of the transforms' interpolation, relative to the window's whole: weak orders keep their digits.
const NODE_TOLERANCE: f64 = 1e-8;

/// Values of a manifest's specimen.
///
/// # Errors
/// A wrong manifest, scans that cannot be read, and those of the reference.
pub(super) fn from_scan(path: &Path, args: &EvalArgs, global: &Global, pairs: &[(Vec3, Vec3)]) -> Result<Evaluated> {
    let (manifest, text) = manifest::load(path)?;
    if let Some(out) = &args.out {
        let inputs = inputs(&manifest, &text);
        destination::check_file(out, &inputs.iter().map(PathBuf::as_path).collect::<Vec<_>>(), args.force)?;
    }
    let Some(specimen) = manifest.specimens.iter().find(|specimen| specimen.name == args.specimen) else {
        let known: Vec<&str> = manifest.specimens.iter().map(|specimen| specimen.name.as_str()).collect();
        return Err(Error::Call(format!(
            "{}: no specimen is called `{}`; there are {}",
            path.display(),
            args.specimen,
            known.join(", ")
        ))
        .into());
    };
    let scans = ingest(specimen)?;
    let usable = scans.fields.iter().map(|f| usable_radius(&scans.optics, f.pitch_nm)).fold(2.0, f64::min);
    warn_beyond(usable, pairs);
    if args.polarised {
        check_polarised(scans.optics.front_factor(), &args.specimen)?;
    }
    let progress = reporter(global.quiet);
    let memory_bytes = (manifest.tables.memory_mib as u64) << 20;
    let table = match args.method {
        // Polarisations are kept apart by the direct sum alone.
        Method::Reference if !args.polarised => by_transforms(&scans, args, pairs, memory_bytes, progress.as_ref())?,
        _ => by_direct_sum(&scans, args, pairs, progress.as_ref())?,
    };
    let is_xyz = args.wavelengths_nm.is_empty();
    let white = is_xyz.then(|| white(&scans.optics.illuminant, scans.optics.wavelength_nm)).transpose()?;
    Ok(Evaluated { table, white })
}

/// By the transforms that these directions need.
fn by_transforms(
    Scans { fields, optics, .. }: &Scans,
    args: &EvalArgs,
    pairs: &[(Vec3, Vec3)],
    memory_bytes: u64,
    progress: &dyn Progress,
) -> Result<Table> {
    let wavelengths_nm = &args.wavelengths_nm;
    let shortest_nm = match wavelengths_nm.is_empty() {
        true => optics.illuminant.reach_nm(optics.wavelength_nm)[0],
        false => wavelengths_nm.iter().copied().fold(f64::MAX, f64::min),
    };
    let asked = pairs.iter().map(|&(wi, wo)| (wave_vector_change(wi, wo), shortest_nm));
    let config = SpectraConfig::holding(optics, asked, NODE_TOLERANCE, memory_bytes);
    progress.stage(&format!("{}: evaluate the reference", args.specimen), 0);
    let table = match wavelengths_nm.is_empty() {
        true => xyz_table(spectral::brdf_xyz_batch(fields, optics, &config, pairs)?),
        false => Table {
            columns: wavelength_columns(wavelengths_nm),
            values: spectral::brdf_spectrum_batch(fields, optics, &config, pairs, wavelengths_nm)?,
        },
    };
    progress.finish();
    Ok(table)
}

/// Sample by sample, direction by direction.
fn by_direct_sum(
    Scans { fields, optics, .. }: &Scans,
    args: &EvalArgs,
    pairs: &[(Vec3, Vec3)],
    progress: &dyn Progress,
) -> Result<Table> {
    progress.stage(&format!("{}: sum over the scan", args.specimen), pairs.len() as u64);
    let wavelengths_nm = &args.wavelengths_nm;
    let names = wavelength_columns(wavelengths_nm);
    let table = match (args.polarised, wavelengths_nm.is_empty()) {
        (true, true) => {
            polarised_table(&of_each(pairs, progress, |wi, wo| reference::brdf_xyz_polarised(fields, optics, wi, wo))?)
        }
        (true, false) => Table {
            columns: polarised_columns(&names),
            values: of_each(pairs, progress, |wi, wo| {
                Ok(reference::brdf_spectrum_polarised(fields, optics, wi, wo, wavelengths_nm)?.concat())
            })?,
        },
        (false, true) => xyz_table(of_each(pairs, progress, |wi, wo| reference::brdf_xyz(fields, optics, wi, wo))?),
        (false, false) => Table {
            columns: names,
            values: of_each(pairs, progress, |wi, wo| {
                reference::brdf_spectrum(fields, optics, wi, wo, wavelengths_nm)
            })?,
        },
    };
    progress.finish();
    Ok(table)
}

fn of_each<T: Send>(
    pairs: &[(Vec3, Vec3)],
    progress: &dyn Progress,
    value: impl Fn(Vec3, Vec3) -> error::Result<T> + Sync,
) -> error::Result<Vec<T>> {
    let of = |&(wi, wo): &(Vec3, Vec3)| {
        let value = value(wi, wo);
        progress.advance(1);
        value
    };
    pairs.par_iter().map(of).collect()
}
