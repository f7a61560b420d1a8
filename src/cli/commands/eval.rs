//! `eval`: BRDF values for a list of directions, from an atlas or straight from the scan.

use std::path::{Path, PathBuf};

use crate::ground::error::{Error, Result};

/// Arguments of `eval`.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(after_help = "Examples:
  diffraction-atlas eval --directions d.csv --atlas out/atlas/squamates --specimen elaphe_guttata
  diffraction-atlas eval --directions d.csv --method reference --manifest pipeline.toml --specimen elaphe_guttata
  diffraction-atlas eval --directions d.csv --method reference --specimen elaphe_guttata --wavelengths-nm 450,550,650

The CSV has the columns theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg; X, Y, Z in 1/sr are added to them, or one
column for each of the wavelengths asked for.")]
pub struct EvalArgs {
    /// Directions to the light and to the viewer, in degrees
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
    /// Values at these wavelengths in place of X, Y, Z (with --method reference)
    #[arg(long, value_name = "NM", value_delimiter = ',', value_parser = crate::cli::lengths::positive)]
    pub wavelengths_nm: Vec<f64>,
    /// Write here in place of stdout
    #[arg(long, value_name = "CSV")]
    pub out: Option<PathBuf>,
}

/// What is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Method {
    /// The tables of an atlas, as a renderer does
    Tables,
    /// The integral over the scan itself, without tables
    Reference,
}

/// Where the values come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EvalSource<'a> {
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
    pub fn source(&self) -> Result<EvalSource<'_>> {
        let wrong = |message: &str| Err(Error::Call(message.to_owned()));
        match (self.method, &self.atlas, &self.manifest) {
            (Method::Tables, _, Some(_)) => wrong("`--manifest` goes with `--method reference`"),
            (Method::Tables, None, None) => {
                wrong("`--atlas DIR` is missing; `--method reference` evaluates scans instead")
            }
            (Method::Tables, Some(_), None) if !self.wavelengths_nm.is_empty() => {
                wrong("tables hold X, Y, Z alone; `--wavelengths-nm` goes with `--method reference`")
            }
            (Method::Tables, Some(atlas), None) => Ok(EvalSource::Tables(atlas)),
            (Method::Reference, Some(_), _) => wrong("`--atlas` goes with `--method tables`"),
            (Method::Reference, None, manifest) => {
                Ok(EvalSource::Reference(manifest.as_deref().unwrap_or(Path::new(super::MANIFEST))))
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
            ("--atlas a --wavelengths-nm 500", "X, Y, Z alone"),
        ] {
            let message = parse(line).source().unwrap_err().to_string();
            assert!(message.contains(expected), "{line}: {message}");
        }
    }
}
