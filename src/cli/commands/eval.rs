//! `eval`: BRDF values for a list of directions, from an atlas or straight from the scan.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::cli::directions;
use crate::cli::options::{Global, MANIFEST};
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::manifest;
use crate::manifest::illuminant;
use crate::stages::archive::specimen_file;
use crate::stages::ingest::{Scans, ingest};
use diffraction_brdf::Brdf;
use diffraction_brdf::atlas;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::{self, Error};
use diffraction_brdf::evaluate::{Interpolation, answers, brdf_xyz_polarised};
use diffraction_brdf::files;
use diffraction_brdf::front_factor::{Factor, FrontFactor};
use diffraction_brdf::json;
use diffraction_brdf::spectral_storage::read_spectral;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::optics::reference;
use diffraction_build::tables::resolution::usable_radius;

/// Arguments of `eval`.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(after_help = "Examples:
  diffraction-atlas eval --directions d.csv --atlas out/atlas/squamates --specimen elaphe_guttata
  diffraction-atlas eval --directions d.csv --method reference --manifest pipeline.toml --specimen elaphe_guttata
  diffraction-atlas eval --directions d.csv --atlas out/atlas/squamates --specimen elaphe_guttata --wavelengths-nm 450,550,650
  diffraction-atlas eval --directions d.csv --atlas out/atlas/squamates --specimen elaphe_guttata --illuminant F11

The CSV has the columns theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg, thetas below 90 either way, between commas,
semicolons or tabs; lines that start with # are comments. X, Y, Z in 1/sr are added to them, X, Y, Z under
another light, or one column for each of the wavelengths asked for; with --polarised X_ss, X_sp, X_ps, X_pp, Y_ss and so on.")]
pub(crate) struct EvalArgs {
    /// Directions to the light and to the viewer, in degrees; `-` reads standard input
    #[arg(long, value_name = "CSV")]
    pub directions: PathBuf,
    /// What is evaluated
    #[arg(long, value_enum, default_value_t = Method::Tables)]
    pub method: Method,
    /// Atlas, or one version of it (with --method tables)
    #[arg(long, value_name = "DIR")]
    pub atlas: Option<PathBuf>,
    /// Manifest that names the scans (with --method reference) [default: pipeline.toml]
    #[arg(long, value_name = "FILE")]
    pub manifest: Option<PathBuf>,
    /// Specimen
    #[arg(long, value_name = "NAME")]
    pub specimen: String,
    /// Values at these wavelengths in place of X, Y, Z: from the scan, or from an atlas with spectral tables
    #[arg(long, value_name = "NM", value_delimiter = ',', value_parser = crate::cli::lengths::positive)]
    pub wavelengths_nm: Vec<f64>,
    /// X, Y, Z under this light in place of the atlas's own, from its spectral tables: D65, A, E, F1 to F12, a CSV file with the
    /// columns wavelength_nm and power, or laser lines in nm (632.8, or 450,532)
    #[arg(long, value_name = "LIGHT", value_parser = illuminant::from_argument, conflicts_with_all = ["wavelengths_nm", "polarised"])]
    pub illuminant: Option<Illuminant>,
    /// Four values for each: ss, sp, ps, pp, the light's polarisation first, s across the plane that holds the normal. Half
    /// their sum is the value without. Needs the factor "vector" and a material with a refractive index
    #[arg(long)]
    pub polarised: bool,
    /// How values between texels are found (with --method tables)
    #[arg(long, value_enum, default_value_t = Lookup::Spline)]
    pub interpolation: Lookup,
    /// Write here in place of stdout
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Write JSON in place of CSV: a list of objects with the columns' names
    #[arg(long)]
    pub json: bool,
}

/// What is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Method {
    /// The tables of an atlas, as a renderer does
    Tables,
    /// The integral over the scan itself, without tables
    Reference,
}

/// How values between texels are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Lookup {
    /// Two by two texels, as graphics hardware does
    Bilinear,
    /// Four by four texels
    Cubic,
    /// The cubic B-spline through all texels: closest to the scan, and what the atlas's FORMAT.md describes
    Spline,
}

impl Lookup {
    fn look_up(self) -> Interpolation {
        match self {
            Self::Bilinear => Interpolation::Bilinear,
            Self::Cubic => Interpolation::Cubic,
            Self::Spline => Interpolation::Spline,
        }
    }
}

/// Where the values come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EvalSource<'a> {
    /// An atlas's folder.
    Tables(&'a Path),
    /// A manifest.
    Reference(&'a Path),
}

impl EvalArgs {
    /// The source that the arguments name.
    ///
    /// # Errors
    /// [`Error::Call`] where they do not fit together.
    pub(crate) fn source(&self) -> Result<EvalSource<'_>> {
        let wrong = |message: &str| Err(Error::Call(message.to_owned()).into());
        match (self.method, &self.atlas, &self.manifest) {
            (Method::Tables, _, Some(_)) => wrong("`--manifest` goes with `--method reference`"),
            (Method::Tables, None, None) => {
                wrong("`--atlas DIR` is missing; `--method reference` evaluates scans instead")
            }
            (Method::Tables, Some(_), None) if !self.wavelengths_nm.is_empty() && self.polarised => {
                wrong("`--polarised` with `--wavelengths-nm` goes with `--method reference`")
            }
            (Method::Reference, _, _) if self.illuminant.is_some() => {
                wrong("`--illuminant` goes with `--method tables`; for scans optics.illuminant of the manifest says it")
            }
            (Method::Tables, Some(atlas), None) => Ok(EvalSource::Tables(atlas)),
            (Method::Reference, Some(_), _) => wrong("`--atlas` goes with `--method tables`"),
            (Method::Reference, None, manifest) => {
                Ok(EvalSource::Reference(manifest.as_deref().unwrap_or(Path::new(MANIFEST))))
            }
        }
    }
}

/// Evaluates and writes the table.
///
/// # Errors
/// Wrong directions, an unreadable atlas or manifest, or the reference's.
pub(crate) fn run(args: &EvalArgs, _global: &Global) -> Result<Outcome> {
    let source = args.source()?;
    let rows = directions::read(&args.directions)?;
    let pairs: Vec<(Vec3, Vec3)> = rows.iter().map(directions::Row::pair).collect();
    let table = match source {
        EvalSource::Tables(atlas) => from_tables(atlas, args, &pairs)?,
        EvalSource::Reference(path) => from_reference(path, args, &pairs)?,
    };
    let text = if args.json {
        json::pretty(&directions::to_json(&rows, &table.columns, &table.values))
            .map_err(|error| Error::Call(format!("these values have no form in JSON: {error}")))?
    } else {
        directions::write(&rows, &table.columns, &table.values)
    };
    match &args.out {
        Some(path) => files::replace(path, text.as_bytes())?,
        None => output::print(&text)?,
    }
    Ok(Outcome::Done)
}

/// Columns beside the angles, and a row of values per pair.
struct Table {
    columns: Vec<String>,
    values: Vec<Vec<f64>>,
}

fn polarised_table(values: &[[Xyz; 4]]) -> Table {
    Table {
        columns: polarised_columns(&["X", "Y", "Z"].map(String::from)),
        values: values.iter().map(polarised_row).collect(),
    }
}

fn xyz_table(values: impl IntoIterator<Item = Xyz>) -> Table {
    Table {
        columns: ["X", "Y", "Z"].map(String::from).to_vec(),
        values: values.into_iter().map(|xyz| xyz.to_vec()).collect(),
    }
}

/// Suffixes of the columns of polarised values.
const POLARISATIONS: [&str; 4] = ["ss", "sp", "ps", "pp"];

/// Four columns for each of these.
fn polarised_columns(names: &[String]) -> Vec<String> {
    names.iter().flat_map(|name| POLARISATIONS.map(|kind| format!("{name}_{kind}"))).collect()
}

/// Polarised values side by side in the order of [`polarised_columns`], from XYZ by polarisation.
fn polarised_row(by_kind: &[Xyz; 4]) -> Vec<f64> {
    (0..3).flat_map(|c| by_kind.map(|xyz| xyz[c])).collect()
}

/// Refuses to keep polarisations apart where the front factor does not.
fn check_polarised(front: FrontFactor, specimen: &str) -> Result<()> {
    let up = [0.0, 0.0, 1.0];
    if front.polarised(up, up).is_some() {
        return Ok(());
    }
    let what = match front.factor {
        Factor::Scalar => "has the scalar factor",
        Factor::Vector => "is an ideal reflector, which has no refractive index",
    };
    Err(Error::limit(
        format!("`{specimen}` {what}, and so knows no polarisation"),
        "leave `--polarised` out, or set optics.factor = \"vector\" and a material such as { n = 1.56 } for it",
    )
    .into())
}

fn from_tables(atlas: &Path, args: &EvalArgs, pairs: &[(Vec3, Vec3)]) -> Result<Table> {
    let folder = output::version_folder(atlas)?;
    let index = atlas::read_index(&folder)?;
    let specimen_folder = atlas::specimen_folder(&folder, &index, &args.specimen)?;
    if args.illuminant.is_some() || !args.wavelengths_nm.is_empty() {
        return from_spectral(&specimen_folder, args, pairs);
    }
    let (_, set) = specimen_file::load(&specimen_folder)?;
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
    if args.polarised {
        check_polarised(set.front_factor, &args.specimen)?;
        let value = |&(wi, wo): &(Vec3, Vec3)| brdf_xyz_polarised(&set, interpolation, wi, wo).unwrap_or_default();
        let values: Vec<[Xyz; 4]> = pairs.par_iter().map(value).collect();
        return Ok(polarised_table(&values));
    }
    let brdf = Brdf::new(set)?.with_interpolation(interpolation);
    Ok(xyz_table(pairs.par_iter().map(|&(wi, wo)| brdf.eval(wi, wo)).collect::<Vec<_>>()))
}

/// From the spectral tables: single wavelengths, or X, Y, Z under a light.
fn from_spectral(folder: &Path, args: &EvalArgs, pairs: &[(Vec3, Vec3)]) -> Result<Table> {
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
        let light = tables.under(look_up, illuminant)?;
        return Ok(xyz_table(pairs.par_iter().map(|&(wi, wo)| light.eval(wi, wo)).collect::<Vec<_>>()));
    }
    tables.check_wavelengths(&args.wavelengths_nm)?;
    let values = pairs.par_iter().map(|&(wi, wo)| tables.eval(look_up, wi, wo, &args.wavelengths_nm)).collect();
    Ok(Table { columns: wavelength_columns(&args.wavelengths_nm), values })
}

fn wavelength_columns(wavelengths_nm: &[f64]) -> Vec<String> {
    wavelengths_nm.iter().map(|nm| format!("f_{nm}_nm")).collect()
}

fn from_reference(path: &Path, args: &EvalArgs, pairs: &[(Vec3, Vec3)]) -> Result<Table> {
    let (manifest, _) = manifest::load(path)?;
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
    let Scans { fields, optics, .. } = ingest(specimen)?;
    let usable = fields.iter().map(|f| usable_radius(&optics, f.pitch_nm)).fold(2.0, f64::min);
    warn_beyond(usable, pairs);
    let names = wavelength_columns(&args.wavelengths_nm);
    if args.polarised {
        check_polarised(optics.front_factor(), &args.specimen)?;
        if names.is_empty() {
            let xyz = |&(wi, wo): &(Vec3, Vec3)| reference::brdf_xyz_polarised(&fields, &optics, wi, wo);
            return Ok(polarised_table(&pairs.par_iter().map(xyz).collect::<error::Result<Vec<_>>>()?));
        }
        let spectrum = |&(wi, wo): &(Vec3, Vec3)| {
            let spectrum = reference::brdf_spectrum_polarised(&fields, &optics, wi, wo, &args.wavelengths_nm)?;
            Ok(spectrum.concat())
        };
        let values = pairs.par_iter().map(spectrum).collect::<error::Result<_>>()?;
        return Ok(Table { columns: polarised_columns(&names), values });
    }
    if names.is_empty() {
        return Ok(xyz_table(reference::brdf_xyz_batch(&fields, &optics, pairs)?));
    }
    let spectrum = |&(wi, wo): &(Vec3, Vec3)| reference::brdf_spectrum(&fields, &optics, wi, wo, &args.wavelengths_nm);
    Ok(Table { columns: names, values: pairs.par_iter().map(spectrum).collect::<error::Result<_>>()? })
}

/// Values past the scan's sampling are too dark: said, not hidden.
fn warn_beyond(usable_radius: f64, pairs: &[(Vec3, Vec3)]) {
    let beyond = pairs.iter().filter(|(wi, wo)| (wi[0] + wo[0]).hypot(wi[1] + wo[1]) > usable_radius).count();
    if beyond > 0 {
        eprintln!(
            "warning: {beyond} of {} directions lie beyond |(u, v)| = {usable_radius:.3}, where the scan's sampling no \
             longer answers for every wavelength: their values are too dark",
            pairs.len()
        );
    }
}

#[cfg(test)]
mod tests {
    use clap::FromArgMatches;

    use super::*;

    fn parse(line: &str) -> EvalArgs {
        let command = <EvalArgs as clap::Args>::augment_args(clap::Command::new("eval"));
        let words = ["eval", "--directions", "d.csv", "--specimen", "s"].into_iter();
        let matches = command.get_matches_from(words.chain(line.split_whitespace()));
        EvalArgs::from_arg_matches(&matches).unwrap()
    }

    #[test]
    fn sources_that_fit_are_taken() {
        let args = parse("--atlas a");
        assert_eq!(args.source().unwrap(), EvalSource::Tables(Path::new("a")));
        let args = parse("--method reference");
        assert_eq!(args.source().unwrap(), EvalSource::Reference(Path::new("pipeline.toml")));
        let args = parse("--method reference --manifest m.toml --wavelengths-nm 450,550.5");
        assert_eq!(args.source().unwrap(), EvalSource::Reference(Path::new("m.toml")));
        assert_eq!(args.wavelengths_nm, [450.0, 550.5]);
    }

    #[test]
    fn sources_that_do_not_fit_are_refused() {
        for (line, expected) in [
            ("", "`--atlas DIR` is missing"),
            ("--manifest m.toml", "--method reference"),
            ("--atlas a --manifest m.toml", "--method reference"),
            ("--atlas a --method reference", "--method tables"),
            ("--atlas a --wavelengths-nm 500 --polarised", "--method reference"),
            ("--method reference --illuminant A", "--method tables"),
        ] {
            let message = parse(line).source().unwrap_err().to_string();
            assert!(message.contains(expected), "{line}: {message}");
        }
    }
}
