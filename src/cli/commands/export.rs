//! `export`: the atlas in other forms.

use std::path::{Path, PathBuf};

use super::export_forms;
use crate::cli::destination;
use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::stages::archive::shader_data::{Container, Texels, TextureConfig};
use crate::stages::archive::shader_include::IncludeConfig;
use crate::stages::viewer::content::Content;
use crate::stages::viewer::single_file::single_file;
use crate::stages::viewer::written::fill_folder;
use diffraction_brdf::atlas;
use diffraction_brdf::error::Error;
use diffraction_brdf::files;

/// Arguments of `export`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas export out/atlas/squamates --form float-tables --out export")]
pub(crate) struct ExportArgs {
    /// An atlas, or one version of it
    pub atlas: PathBuf,
    /// What to write
    #[arg(long, value_enum)]
    pub form: Form,
    /// Only these specimens; may be given several times
    #[arg(long, value_name = "NAME")]
    pub specimen: Vec<String>,
    /// Folder to write, or the file with `--single-file`; a folder that holds something is never replaced
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// With `--single-file`: replace a file that is there already
    #[arg(long, requires = "single_file")]
    pub force: bool,
    /// With `--form viewer`: one HTML file that holds everything and works from the disk
    #[arg(long)]
    pub single_file: bool,
    /// With `--form shaders`: what begins every global name of the files to include
    #[arg(long, value_name = "TEXT", default_value = "diffraction_")]
    pub prefix: String,
    /// With `--form shaders`: binding of the uniform block in the files to include; textures and sampler follow it
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u32).range(0..=240))]
    pub first_binding: u32,
    /// With `--form shaders`: textures of 32-bit floats, for tables that 16 bits round too much
    #[arg(long)]
    pub float_texels: bool,
    /// With `--form shaders`: textures as KTX 2.0 files with their levels, in place of bytes to upload
    #[arg(long)]
    pub ktx2: bool,
}

/// Other forms of an atlas.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Form {
    /// An atlas with the same tables as 32-bit floats, scales multiplied in
    FloatTables,
    /// Code that evaluates the tables in several shading languages, with the bytes to upload
    Shaders,
    /// Shaders in the Open Shading Language, for Blender's Cycles
    Osl,
    /// The page of `view` with what it reads of the atlas, for any web host or, with `--single-file`, as one file
    Viewer,
}

/// Exports.
///
/// # Errors
/// A folder that is no atlas, an unknown specimen, or files that are there already.
pub(crate) fn run(args: &ExportArgs, _global: &Global) -> Result<Outcome> {
    if args.single_file && args.form != Form::Viewer {
        return Err(Error::Call("`--single-file` goes with `--form viewer` alone".into()).into());
    }
    if (args.ktx2 || args.float_texels) && args.form != Form::Shaders {
        return Err(Error::Call("`--ktx2` and `--float-texels` go with `--form shaders` alone".into()).into());
    }
    match args.single_file {
        true => destination::check_file(&args.out, &[], args.force)?,
        false => destination::check_folder(&args.out, None)?,
    }
    let folder = output::version_folder(&args.atlas)?;
    if args.form == Form::Viewer {
        return export_viewer(&folder, args);
    }
    let index = atlas::read_index(&folder)?;
    let all: Vec<String> = index.specimens.iter().map(|entry| entry.name.clone()).collect();
    let names = if args.specimen.is_empty() { &all } else { &args.specimen };
    let specimens = names.iter().map(|name| Ok((name.as_str(), atlas::specimen_folder(&folder, &index, name)?)));
    let specimens = specimens.collect::<Result<Vec<_>>>()?;
    destination::write_folder(&args.out, |out| match args.form {
        Form::Shaders => {
            let include = IncludeConfig { prefix: args.prefix.clone(), first_binding: args.first_binding };
            let texels = if args.float_texels { Texels::Float } else { Texels::Half };
            let container = if args.ktx2 { Container::Ktx2 } else { Container::Raw };
            export_forms::export_shaders(out, &specimens, TextureConfig { texels, container }, &include)
        }
        Form::Osl => export_forms::export_osl(out, &args.out, &specimens),
        Form::FloatTables | Form::Viewer => export_forms::export_float(out, &index, &specimens),
    })?;
    output::print(&format!("exported {} to {}\n", specimens.len(), args.out.display()))?;
    Ok(Outcome::Done)
}

/// The page, with what it reads of a version.
fn export_viewer(folder: &Path, args: &ExportArgs) -> Result<Outcome> {
    let content = Content::open(folder, &args.specimen)?;
    let bytes = if args.single_file {
        let page = single_file(&content)?;
        destination::create_parent(&args.out)?;
        files::replace(&args.out, page.as_bytes())?;
        page.len() as u64
    } else {
        destination::write_folder(&args.out, |out| fill_folder(&content, out))?
    };
    output::print(&format!("exported the viewer to {}, {}\n", args.out.display(), output::bytes_in_words(bytes)))?;
    Ok(Outcome::Done)
}
