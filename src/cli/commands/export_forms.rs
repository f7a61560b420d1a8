//! What `export` writes of each specimen, form by form.

use std::path::{Path, PathBuf};

use crate::error::Result;
use crate::stages::archive::format_md::write_format;
use crate::stages::archive::materialx::write_materialx;
use crate::stages::archive::osl::{self, write_osl};
use crate::stages::archive::shader_data::{TextureConfig, write_shader_data, write_spectral_data};
use crate::stages::archive::shader_export::{README, SPECTRAL_README, ShaderLanguage, ShaderSource, shader};
use crate::stages::archive::shader_include::{self, IncludeConfig};
use crate::stages::archive::specimen_file::{self, SpecimenFile};
use diffraction_brdf::atlas::{AtlasIndex, record_files, write_index};
use diffraction_brdf::spectral_storage::{StoredSpectral, read_spectral, write_spectral};
use diffraction_brdf::storage::write_tables;
use diffraction_brdf::{Error, files, json};
use diffraction_build::optics::pigment::Surface;
use diffraction_build::tables::model::Storage;

/// Specimens by name, with their folders.
pub(super) type Specimens<'a> = [(&'a str, PathBuf)];

/// Shaders in every language, alone and to include, and each specimen's bytes.
pub(super) fn export_shaders(
    out: &Path,
    specimens: &Specimens,
    textures: TextureConfig,
    include: &IncludeConfig,
) -> Result<()> {
    let sources = [ShaderSource::Tables, ShaderSource::TablesFiltered, ShaderSource::TablesSampled];
    write_shaders(out, &sources, include, "README.md", README)?;
    let names: Vec<&str> = specimens.iter().map(|(name, _)| *name).collect();
    write_materialx(&out.join("materialx"), &include.prefix, &names)?;
    for (name, from) in specimens {
        let to = out.join(name);
        let (file, tables) = specimen_file::load(from)?;
        write_shader_data(&to, Surface { tables: &tables, pigment: file.pigment.as_ref() }, textures)?;
        if let Some(stored) = &file.spectral {
            write_spectral_data(&to, &read_spectral(from, stored, tables.front_factor)?, textures)?;
            let sources = [ShaderSource::Spectral, ShaderSource::SpectralFiltered];
            write_shaders(out, &sources, include, "README_spectral.md", SPECTRAL_README)?;
        }
    }
    Ok(())
}

/// Shaders that share a uniform block, with what an engine needs to know of them.
fn write_shaders(out: &Path, sources: &[ShaderSource], config: &IncludeConfig, name: &str, readme: &str) -> Result<()> {
    let includes = out.join("include");
    files::create_folder(&includes)?;
    for &source in sources {
        for language in ShaderLanguage::ALL {
            files::replace(&out.join(source.file_name(language)), &shader(source, language)?)?;
        }
        for language in shader_include::LANGUAGES {
            let text = shader_include::include(source, language, config)?;
            files::replace(&includes.join(shader_include::file_name(source, language)), text.as_bytes())?;
        }
    }
    let (fields, in_c) = shader_include::block(sources[0], config)?;
    json::write(&includes.join(format!("{}_params.json", sources[0].name())), &fields)?;
    files::replace(&includes.join(format!("{}_params.h", sources[0].name())), in_c.as_bytes())?;
    Ok(files::replace(&out.join(name), readme.as_bytes())?)
}

/// An atlas of the same specimens, whose tables are 32-bit floats: with an index of its files and the page on how to evaluate them.
pub(super) fn export_float(out: &Path, index: &AtlasIndex, specimens: &Specimens) -> Result<()> {
    for (name, from) in specimens {
        let to = out.join(name);
        files::create_folder(&to)?;
        let (file, set) = specimen_file::load(from)?;
        let spectral = file.spectral.as_ref().map(|stored| {
            let tables = read_spectral(from, stored, file.optics.front_factor())?;
            let written = write_spectral(&to, &tables, Storage::Float)?;
            Ok::<_, Error>(StoredSpectral { check_values: stored.check_values.clone(), ..written })
        });
        let (tables, spectral) = (write_tables(&to, &set, Storage::Float)?, spectral.transpose()?);
        specimen_file::write(&to, &SpecimenFile { tables, spectral, ..file })?;
    }
    if let Some((name, _)) = specimens.first() {
        write_format(&out.join(name), out)?;
    }
    let mut index = AtlasIndex { files: record_files(out)?, ..index.clone() };
    index.specimens.retain(|entry| specimens.iter().any(|(name, _)| *name == entry.name));
    Ok(write_index(out, &mut index)?)
}

/// OSL shaders, whose images will lie at `place` in the end.
pub(super) fn export_osl(out: &Path, place: &Path, specimens: &Specimens) -> Result<()> {
    for (name, from) in specimens {
        let to = out.join(name);
        files::create_folder(&to)?;
        let (file, tables) = specimen_file::load(from)?;
        write_osl(&to, &place.join(name), &tables, file.pigment.as_ref().map(|pigment| pigment.xyz_per_sr))?;
    }
    Ok(files::replace(&out.join("README.md"), osl::README.as_bytes())?)
}
