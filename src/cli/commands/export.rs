//! `export`: the atlas in other forms.

use std::path::{Path, PathBuf};

use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::stages::archive::shader_data::{write_shader_data, write_spectral_data};
use crate::stages::archive::shader_export::{README, SPECTRAL_README, ShaderLanguage, ShaderSource, shader};
use crate::stages::archive::specimen_file;
use crate::stages::viewer::content::Content;
use crate::stages::viewer::written::{write_folder, write_single_file};
use diffraction_brdf::atlas;
use diffraction_brdf::error::{self, Error};
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
    /// Folder to write to, or the file with `--single-file`; what is there is not overwritten
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
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
    let folder = output::version_folder(&args.atlas)?;
    if args.form == Form::Viewer {
        return export_viewer(&folder, args);
    }
    let index = atlas::read_index(&folder)?;
    let all: Vec<String> = index.specimens.iter().map(|entry| entry.name.clone()).collect();
    let names = if args.specimen.is_empty() { &all } else { &args.specimen };
    let specimens = names.iter().map(|name| Ok((name, atlas::specimen_folder(&folder, &index, name)?)));
    let specimens = specimens.collect::<Result<Vec<_>>>()?;
    if args.form == Form::Shaders {
        fresh_folder(&args.out)?;
        export_shaders(&args.out, [ShaderSource::Tables, ShaderSource::TablesFiltered], "README.md", README)?;
    }
    for (name, from) in &specimens {
        let to = args.out.join(name);
        fresh_folder(&to)?;
        match args.form {
            Form::FloatTables => export_float(from, &to)?,
            Form::Viewer => unreachable!("returned above"),
            Form::Shaders => {
                let (file, tables) = specimen_file::load(from)?;
                write_shader_data(&to, Surface { tables: &tables, pigment: file.pigment.as_ref() })?;
                if let Some(stored) = &file.spectral {
                    write_spectral_data(&to, &read_spectral(from, stored, tables.front_factor)?)?;
                    let sources = [ShaderSource::Spectral, ShaderSource::SpectralFiltered];
                    export_shaders(&args.out, sources, "README_spectral.md", SPECTRAL_README)?;
                }
            }
        }
    }
    output::print(&format!("exported {} to {}\n", specimens.len(), args.out.display()))?;
    Ok(Outcome::Done)
}

/// The page, with what it reads of a version.
fn export_viewer(folder: &Path, args: &ExportArgs) -> Result<Outcome> {
    let content = Content::open(folder, &args.specimen)?;
    let write = if args.single_file { write_single_file } else { write_folder };
    let bytes = write(&content, &args.out)?;
    output::print(&format!("exported the viewer to {}, {}\n", args.out.display(), output::bytes_in_words(bytes)))?;
    Ok(Outcome::Done)
}

/// A folder of its own: nothing is overwritten.
fn fresh_folder(folder: &Path) -> error::Result<()> {
    if folder.exists() {
        return Err(Error::Call(format!("{}: is there already; name another `--out`", folder.display())));
    }
    files::create_folder(folder)
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

fn export_float(from: &Path, to: &Path) -> error::Result<()> {
    let (file, set) = specimen_file::load(from)?;
    let tables = write_tables(to, &set, Storage::Float)?;
    specimen_file::write(to, &specimen_file::SpecimenFile { tables, ..file })
}
