//! `export`: the atlas in other forms.

use std::path::PathBuf;

/// Arguments of `export`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas export out/atlas/squamates --form exr-stack --out export")]
pub struct ExportArgs {
    /// An atlas, or one version of it
    pub atlas: PathBuf,
    /// What to write
    #[arg(long, value_enum)]
    pub form: Form,
    /// Only these specimens; may be given several times
    #[arg(long, value_name = "NAME")]
    pub specimen: Vec<String>,
    /// Folder to write to; what is there is not overwritten
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// Other forms of an atlas.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Form {
    /// One single-part EXR file per specimen, with a layer per table
    ExrStack,
    /// Code that evaluates the tables, in the shading languages translated from WGSL
    Shaders,
}
