//! The table shaders in other shading languages, each translated from its one WGSL source.

use naga::back::{glsl, hlsl, msl, spv};
use naga::proc::BoundsCheckPolicies;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::error::{Error, Result};
use diffraction_render::render::wgsl::{self, SHADE_MATERIAL, SHADE_SPECTRAL, material, spectral_material};

/// What an engine needs to know: bindings in every language, inputs and result.
pub const README: &str = include_str!("shader_readme.md");

/// What an engine needs to know of the shader of spectral tables.
pub const SPECTRAL_README: &str = include_str!("shader_spectral_readme.md");

/// Which tables a shader evaluates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShaderSource {
    /// Those of XYZ.
    Tables,
    /// Those of XYZ, as means over footprints.
    TablesFiltered,
    /// Those of XYZ, as means over footprints, and directions drawn from them.
    TablesSampled,
    /// Spectral ones.
    Spectral,
    /// Spectral ones, as means over footprints.
    SpectralFiltered,
}

impl ShaderSource {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Tables, Self::TablesFiltered, Self::TablesSampled, Self::Spectral, Self::SpectralFiltered];

    /// Name of its files without what tells the language.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tables => "tables",
            Self::TablesFiltered => "tables_filtered",
            Self::TablesSampled => "tables_sampled",
            Self::Spectral => "spectral",
            Self::SpectralFiltered => "spectral_filtered",
        }
    }

    /// Its fragment entry point.
    pub(super) fn entry_point(self) -> &'static str {
        match self {
            Self::Tables => SHADE_MATERIAL,
            Self::TablesFiltered => wgsl::SHADE_MATERIAL_FILTERED,
            Self::TablesSampled => wgsl::SHADE_MATERIAL_SAMPLED,
            Self::Spectral => SHADE_SPECTRAL,
            Self::SpectralFiltered => wgsl::SHADE_SPECTRAL_FILTERED,
        }
    }

    /// Its source in WGSL.
    pub(super) fn wgsl(self) -> String {
        match self {
            Self::Tables => material(),
            Self::TablesFiltered => wgsl::material_filtered(),
            Self::TablesSampled => wgsl::material_sampled(),
            Self::Spectral => spectral_material(),
            Self::SpectralFiltered => wgsl::spectral_material_filtered(),
        }
    }

    /// Name of the file in an export. GLSL of either version has the same ending, so there the name tells which it is.
    pub fn file_name(self, language: ShaderLanguage) -> String {
        let (name, extension) = (self.name(), language.extension());
        match language {
            ShaderLanguage::GlslEs300 | ShaderLanguage::Glsl450 => format!("{name}.{}.{extension}", language.name()),
            _ => format!("{name}.{extension}"),
        }
    }
}

/// What the shader is translated into.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShaderLanguage {
    /// The source itself.
    Wgsl,
    /// GLSL ES 3.00: WebGL 2.
    GlslEs300,
    /// GLSL 4.50.
    Glsl450,
    /// HLSL, shader model 5.1.
    Hlsl,
    /// Metal Shading Language 2.0.
    Msl,
    /// SPIR-V 1.3, as bytes in little-endian order.
    Spirv,
}

impl ShaderLanguage {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Wgsl, Self::GlslEs300, Self::Glsl450, Self::Hlsl, Self::Msl, Self::Spirv];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wgsl => "wgsl",
            Self::GlslEs300 => "glsl-es-300",
            Self::Glsl450 => "glsl-450",
            Self::Hlsl => "hlsl",
            Self::Msl => "msl",
            Self::Spirv => "spirv",
        }
    }

    /// The usual ending of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Wgsl => "wgsl",
            Self::GlslEs300 | Self::Glsl450 => "frag",
            Self::Hlsl => "hlsl",
            Self::Msl => "metal",
            Self::Spirv => "spv",
        }
    }
}

/// The fragment shader with all that it calls, in a language: text in UTF-8, or SPIR-V's words.
///
/// # Errors
/// `Error::Gpu` if a translation fails, which would be a fault of this program.
pub fn shader(source: ShaderSource, language: ShaderLanguage) -> Result<Vec<u8>> {
    let (text, entry) = (source.wgsl(), source.entry_point());
    if language == ShaderLanguage::Wgsl {
        return Ok(text.into_bytes());
    }
    match language {
        ShaderLanguage::Wgsl => unreachable!("returned above"),
        ShaderLanguage::GlslEs300 | ShaderLanguage::Glsl450 => Ok(glsl_fragment(&text, entry, language)?.into_bytes()),
        ShaderLanguage::Hlsl => Ok(hlsl(&text, Some(entry), "bilinear", 4)?.into_bytes()),
        ShaderLanguage::Msl => Ok(msl(&text, Some(entry))?.into_bytes()),
        ShaderLanguage::Spirv => to_spirv(&text, entry),
    }
}

/// A source of WGSL as naga holds it.
pub(super) fn parsed(wgsl: &str) -> Result<(naga::Module, ModuleInfo)> {
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|error| fault("WGSL", error.emit_to_string(wgsl)))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| fault("WGSL", error.emit_to_string(wgsl)))?;
    Ok((module, info))
}

pub(super) fn fault(language: &str, message: impl std::fmt::Display) -> Error {
    Error::Gpu(format!("a table shader has no {language} form, a fault of this program: {message}"))
}

/// Where each binding of group 0 goes in GLSL: the number it has in WGSL.
fn glsl_bindings(module: &naga::Module) -> glsl::BindingMap {
    let bindings = module.global_variables.iter().filter_map(|(_, variable)| variable.binding);
    bindings.map(|binding| (binding, binding.binding as u8)).collect()
}

/// A fragment shader of either GLSL.
pub(super) fn glsl_fragment(wgsl: &str, entry: &str, language: ShaderLanguage) -> Result<String> {
    let (module, info) = parsed(wgsl)?;
    let es = language == ShaderLanguage::GlslEs300;
    let options = glsl::Options {
        version: if es { glsl::Version::new_gles(300) } else { glsl::Version::Desktop(450) },
        // Fragment shader only: no coordinate space to adjust.
        writer_flags: glsl::WriterFlags::empty(),
        binding_map: glsl_bindings(&module),
        zero_initialize_workgroup_memory: true,
    };
    let pipeline =
        glsl::PipelineOptions { shader_stage: naga::ShaderStage::Fragment, entry_point: entry.into(), multiview: None };
    let mut text = String::new();
    glsl::Writer::new(&mut text, &module, &info, &options, &pipeline, BoundsCheckPolicies::default())
        .and_then(|mut writer| writer.write())
        .map_err(|error| fault("GLSL", error))?;
    Ok(text)
}

/// HLSL of functions alone, with a sampler of this name and register.
pub(super) fn hlsl_text(wgsl: &str, sampler: &str, register: u32) -> Result<String> {
    hlsl(wgsl, None, sampler, register)
}

fn hlsl(wgsl: &str, entry: Option<&str>, sampler: &str, register: u32) -> Result<String> {
    let (module, info) = parsed(wgsl)?;
    let options = hlsl::Options { shader_model: hlsl::ShaderModel::V5_1, ..Default::default() };
    let pipeline =
        hlsl::PipelineOptions { entry_point: entry.map(|entry| (naga::ShaderStage::Fragment, entry.into())) };
    let mut text = String::new();
    hlsl::Writer::new(&mut text, &options, &pipeline)
        .write(&module, &info, None)
        .map_err(|error| fault("HLSL", error))?;
    with_a_sampler_of_its_own(&text, sampler, register)
}

/// naga takes samplers from a heap, by an index that a buffer holds; engines bind one sampler.
fn with_a_sampler_of_its_own(text: &str, name: &str, register: u32) -> Result<String> {
    let (mut out, mut heap, mut sampler) = (String::with_capacity(text.len()), 0, 0);
    let from_heap = format!("static const SamplerState {name} = nagaSamplerHeap[");
    for line in text.lines() {
        if line.starts_with(&from_heap) {
            out += &format!("SamplerState {name} : register(s{register});\n");
            sampler += 1;
        } else if line.contains("nagaSamplerHeap")
            || line.contains("nagaComparisonSamplerHeap")
            || line.contains("nagaGroup0SamplerIndexArray")
        {
            heap += 1;
        } else {
            out += line;
            out.push('\n');
        }
    }
    if (heap, sampler) == (3, 1) { Ok(out) } else { Err(fault("HLSL", "its samplers are not where they were")) }
}

/// MSL of functions alone; what they read is handed to them.
pub(super) fn msl_text(wgsl: &str) -> Result<String> {
    msl(wgsl, None)
}

fn msl(wgsl: &str, entry: Option<&str>) -> Result<String> {
    let (module, info) = parsed(wgsl)?;
    let slot = |binding: naga::ResourceBinding| {
        let slot = binding.binding as u8;
        let target = msl::BindTarget {
            buffer: (slot == 0).then_some(0),
            texture: match slot {
                1..=3 => Some(slot - 1),
                5 | 6 => Some(slot - 2),
                _ => None,
            },
            sampler: (slot == 4).then_some(msl::BindSamplerTarget::Resource(0)),
            ..Default::default()
        };
        (binding, target)
    };
    let resources = module.global_variables.iter().filter_map(|(_, variable)| variable.binding).map(slot).collect();
    let of_entry = msl::EntryPointResources { resources, ..Default::default() };
    let options = msl::Options {
        lang_version: (2, 0),
        per_entry_point_map: entry.map(|entry| (entry.to_owned(), of_entry)).into_iter().collect(),
        fake_missing_bindings: false,
        ..Default::default()
    };
    let entry_point = entry.map(|entry| (naga::ShaderStage::Fragment, entry.into()));
    let pipeline = msl::PipelineOptions { entry_point, ..Default::default() };
    let (text, _) = msl::write_string(&module, &info, &options, &pipeline).map_err(|error| fault("MSL", error))?;
    Ok(text)
}

fn to_spirv(wgsl: &str, entry: &str) -> Result<Vec<u8>> {
    let (module, info) = parsed(wgsl)?;
    let options = spv::Options { lang_version: (1, 3), ..Default::default() };
    let pipeline = spv::PipelineOptions { shader_stage: naga::ShaderStage::Fragment, entry_point: entry.into() };
    let words = spv::write_vec(&module, &info, &options, Some(&pipeline)).map_err(|error| fault("SPIR-V", error))?;
    Ok(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}
