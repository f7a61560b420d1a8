//! What `eval` is told.

use std::path::{Path, PathBuf};

use crate::cli::options::MANIFEST;
use crate::error::Result;
use crate::manifest::illuminant;
use diffraction_brdf::error::Error;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::spectrum::Illuminant;

/// Arguments of `eval`.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(after_help = "Examples:
  diffraction-atlas eval --directions d.csv --atlas out/atlas/squamates --specimen elaphe_guttata
  diffraction-atlas eval --directions d.csv --method reference --manifest pipeline.toml --specimen elaphe_guttata
  diffraction-atlas eval --directions d.csv --atlas out/atlas/squamates --specimen elaphe_guttata --wavelengths-nm 450,550,650
  diffraction-atlas eval --directions d.csv --atlas out/atlas/squamates --specimen elaphe_guttata --illuminant F11

The CSV has the columns theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg, thetas below 90 either way, or wi_x, wi_y, wi_z, wo_x, wo_y,
wo_z, vectors of any length, between commas, semicolons or tabs; lines that start with # are comments. X, Y, Z in 1/sr are added to them, X, Y, Z under
another light, or one column for each of the wavelengths asked for; with --polarised X_ss, X_sp, X_ps, X_pp, Y_ss and so on.
With --colour follow the colour beside a matt white in the same light: sRGB_R, sRGB_G, sRGB_B (encoded, 0 to 1), x, y, and
dominant_nm, negative for the complement of a purple, nan for white and for what is dark. With --long each wavelength has a row of
its own, wavelength_nm and brdf_per_sr, the form that `measured` in a manifest reads.")]
pub(crate) struct EvalArgs {
    /// Directions to the light and to the viewer, in degrees or as vectors; `-` reads standard input
    #[arg(long, value_name = "CSV")]
    pub directions: PathBuf,
    /// What is evaluated
    #[arg(long, value_enum, default_value_t = Method::Tables)]
    pub method: Method,
    /// Atlas, or one version of it (with --method tables)
    #[arg(long, value_name = "DIR")]
    pub atlas: Option<PathBuf>,
    /// Manifest that names the scans (with --method reference and direct-sum) [default: pipeline.toml]
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
    #[arg(long, value_name = "LIGHT", conflicts_with_all = ["wavelengths_nm", "polarised"])]
    pub illuminant: Option<LightArgument>,
    /// Four values for each: ss, sp, ps, pp, the light's polarisation first, s across the plane that holds the normal. Half
    /// their sum is the value without. Needs the factor "vector" and a material with a refractive index
    #[arg(long)]
    pub polarised: bool,
    /// Columns of the colour besides X, Y, Z: sRGB, chromaticity, dominant wavelength
    #[arg(long, conflicts_with_all = ["wavelengths_nm", "polarised"])]
    pub colour: bool,
    /// A row for each wavelength, as measured files have, in place of a column
    #[arg(long, requires = "wavelengths_nm", conflicts_with = "polarised")]
    pub long: bool,
    /// How values between texels are found (with --method tables)
    #[arg(long, value_enum, default_value_t = Lookup::Spline)]
    pub interpolation: Lookup,
    /// Write here in place of stdout
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Replace a file that is there already
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Write JSON in place of CSV: a list of objects with the columns' names
    #[arg(long)]
    pub json: bool,
    /// Write NumPy's .npy in place of CSV: a structured array of 64-bit floats with the columns' names
    #[arg(long, requires = "out", conflicts_with = "json")]
    pub npy: bool,
}

/// What is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Method {
    /// The tables of an atlas, as a renderer does
    Tables,
    /// The integral over the scan itself, without tables, by its transforms: as a run measures errors, to 1e-6 and better
    Reference,
    /// The same integral sample by sample: slow, and exact to rounding
    DirectSum,
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
    pub(super) fn look_up(self) -> Interpolation {
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

/// A light as the command line names it, and the file that holds it, where one does.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LightArgument {
    pub(super) light: Illuminant,
    file: Option<PathBuf>,
}

impl std::str::FromStr for LightArgument {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let light = illuminant::from_argument(text)?;
        let is_file = matches!(light, Illuminant::Tabulated { .. });
        Ok(Self { light, file: is_file.then(|| text.into()) })
    }
}

impl EvalArgs {
    /// The files that are read whatever the manifest says.
    pub(super) fn inputs(&self) -> Vec<&Path> {
        let light = self.illuminant.as_ref().and_then(|argument| argument.file.as_deref());
        let manifest = match (self.method, &self.manifest) {
            (Method::Tables, _) => None,
            (Method::Reference | Method::DirectSum, manifest) => {
                Some(manifest.as_deref().unwrap_or(Path::new(MANIFEST)))
            }
        };
        [Some(self.directions.as_path()), light, manifest].into_iter().flatten().collect()
    }

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
            (Method::Reference | Method::DirectSum, _, _) if self.illuminant.is_some() => {
                wrong("`--illuminant` goes with `--method tables`; for scans optics.illuminant of the manifest says it")
            }
            (Method::Tables, Some(atlas), None) => Ok(EvalSource::Tables(atlas)),
            (Method::Reference | Method::DirectSum, Some(_), _) => wrong("`--atlas` goes with `--method tables`"),
            (Method::Reference | Method::DirectSum, None, manifest) => {
                Ok(EvalSource::Reference(manifest.as_deref().unwrap_or(Path::new(MANIFEST))))
            }
        }
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
