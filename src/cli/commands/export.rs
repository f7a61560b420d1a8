//! `export`: the atlas in other forms.

use std::path::{Path, PathBuf};

use crate::cli::destination;
use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::stages::archive::shader_data::{write_shader_data, write_spectral_data};
use crate::stages::archive::shader_export::{README, SPECTRAL_README, ShaderLanguage, ShaderSource, shader};
use crate::stages::archive::specimen_file;
use crate::stages::viewer::content::Content;
use crate::stages::viewer::single_file::single_file;
use crate::stages::viewer::written::fill_folder;
use diffraction_brdf::atlas;
use diffraction_brdf::error::Error;
use diffraction_brdf::files;
use diffraction_brdf::spectral_storage::read_spectral;
use diffraction_brdf::storage::write_tables;
use diffraction_build::optics::pigment::Surface;
use diffraction_build::tables::model::Storage;

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
}

/// Other forms of an atlas.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Form {
    /// The same tables as 32-bit floats, scales multiplied in
    FloatTables,
    /// Code that evaluates the tables in several shading languages, with the bytes to upload
    Shaders,
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
        Form::Shaders => export_all_shaders(out, &specimens),
        Form::FloatTables | Form::Viewer => export_float(out, &specimens),
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

/// Specimens by name, with their folders.
type Specimens<'a> = [(&'a str, PathBuf)];

fn export_all_shaders(out: &Path, specimens: &Specimens) -> Result<()> {
    export_shaders(out, [ShaderSource::Tables, ShaderSource::TablesFiltered], "README.md", README)?;
    for (name, from) in specimens {
        let to = out.join(name);
        let (file, tables) = specimen_file::load(from)?;
        write_shader_data(&to, Surface { tables: &tables, pigment: file.pigment.as_ref() })?;
        if let Some(stored) = &file.spectral {
            write_spectral_data(&to, &read_spectral(from, stored, tables.front_factor)?)?;
            let sources = [ShaderSource::Spectral, ShaderSource::SpectralFiltered];
            export_shaders(out, sources, "README_spectral.md", SPECTRAL_README)?;
        }
    }
    Ok(())
}

/// Shaders in every language, with what an engine needs to know of them.
fn export_shaders(out: &Path, sources: [ShaderSource; 2], name: &str, readme: &str) -> Result<()> {
    for source in sources {
        for language in ShaderLanguage::ALL {
            files::replace(&out.join(source.file_name(language)), &shader(source, language)?)?;
        }
    }
    Ok(files::replace(&out.join(name), readme.as_bytes())?)
}

fn export_float(out: &Path, specimens: &Specimens) -> Result<()> {
    for (name, from) in specimens {
        let to = out.join(name);
        files::create_folder(&to)?;
        let (file, set) = specimen_file::load(from)?;
        let tables = write_tables(&to, &set, Storage::Float)?;
        specimen_file::write(&to, &specimen_file::SpecimenFile { tables, ..file })?;
    }
    Ok(())
}
