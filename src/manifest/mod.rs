//! The manifest: what a run is asked to do, read from TOML, checked, and resolved.
//!
//! [`parse`] turns text into a [`Manifest`], plain data in which every default is filled in and
//! every path and pattern is resolved. The first fault found ends it with [`error::Error::Manifest`], which
//! names file, line, column, the key, and what was expected. docs/manifest.md is the reference.

pub mod collection;
pub mod convert;
mod defaults;
mod files;
pub(crate) mod illuminant;
pub(crate) mod inputs;
pub mod keys;
mod material;
mod measured;
mod mesh;
mod model;
mod name;
mod optics;
mod reader;
mod scene;
mod source;
mod specimen;
mod spectrum_csv;
mod tables;

use std::io::Read;
use std::path::Path;

use toml::de::DeTable;

pub use model::{AtlasSection, GpuSection, Manifest};

use crate::error::{self, Result};
use crate::stages::cache::store::CacheConfig;
use crate::stages::config::{Cover, FrameTiming, GpuCheck, Hold, OnFailure, ReportConfig};
use diffraction_brdf::error::Error;
use diffraction_build::tables::model::Basis;
use reader::Section;
use source::Source;

/// The format that this program reads.
pub const SCHEMA: u32 = 1;

/// Largest manifest read: some hundred thousand specimens.
const BYTES_MAX: u64 = 64 << 20;

/// Reads a manifest and hands back its text too, for the report.
///
/// # Errors
/// [`Error::Call`] where there is no readable file, otherwise as [`parse`].
pub fn load(path: &Path) -> Result<(Manifest, String)> {
    let name = path.display().to_string();
    let unreadable = |why: String| Error::Call(format!("cannot read the manifest {name}: {why}"));
    let mut bytes = Vec::new();
    std::fs::File::open(path).and_then(|file| file.take(BYTES_MAX + 1).read_to_end(&mut bytes)).map_err(|error| {
        unreadable(format!("{error}\n  name an existing file; docs/manifest.md tells what goes into it"))
    })?;
    if bytes.len() as u64 > BYTES_MAX {
        return Err(unreadable(format!("it has more than {BYTES_MAX} bytes")).into());
    }
    let text = String::from_utf8(bytes).map_err(|error| not_utf8(&name, &error))?;
    let manifest = parse(&text, &name)?;
    Ok((manifest, text))
}

fn not_utf8(name: &str, error: &std::string::FromUtf8Error) -> error::Error {
    let good = error.utf8_error().valid_up_to();
    let text = String::from_utf8_lossy(error.as_bytes());
    // Everything before the bad byte is valid, so its offset holds in the repaired text too.
    let source = Source { text: &text, file: name };
    source.error(good..good + 1, "not UTF-8 text; save the manifest as UTF-8")
}

/// Reads a manifest's text; `file_name` is used in messages, and relative paths start at its folder.
///
/// Scans, the illuminant's CSV file, measured data, and environments are looked for; that CSV file and the
/// environments are read.
///
/// # Errors
/// [`error::Error::Manifest`] for the first fault found.
pub fn parse(text: &str, file_name: &str) -> Result<Manifest> {
    let source = Source { text, file: file_name };
    let document = DeTable::parse(text).map_err(|error| syntax_error(&source, &error))?;
    // An unsupported version comes first: its keys mean nothing to this program.
    check_schema(&source, document.get_ref())?;
    let top = Section::document(source, &document)?;
    top.require("schema", "schema = 1")?;
    let base = Path::new(file_name).parent().unwrap_or(Path::new(""));

    let atlas = top.require("atlas", "[atlas]")?;
    let atlas = atlas.section(&keys::ATLAS, "[atlas]")?;
    let out = atlas.get("out").map(|out| out.text_not_empty()).transpose()?;
    let atlas = AtlasSection {
        name: name::read(&atlas.require("name", "name = \"snakes\"")?)?,
        out: base.join(out.unwrap_or(defaults::OUT)),
        on_failure: atlas.get("on_failure").map_or(Ok(OnFailure::default()), |item| item.choice(&ON_FAILURE))?,
    };
    let mut optics = match top.get("optics") {
        Some(item) => optics::read(&item, base)?,
        None => defaults::optics(),
    };
    let tables = match top.get("tables") {
        Some(item) => tables::read(&item)?,
        None => defaults::tables(),
    };
    optics.factor = optics::factor(top.get("optics").as_ref(), tables.basis)?;
    let written_nm = optics::written_range(top.get("optics").as_ref())?;
    let is_material_given = match top.get("optics") {
        Some(item) => item.section(&keys::OPTICS, "[optics]")?.has("material"),
        None => false,
    };
    let common = specimen::Common { optics: &optics, written_nm, is_material_given, base };
    let (one_by_one, of_file) = (top.get("specimen"), top.get("specimens"));
    if of_file.is_none() {
        top.require("specimen", "[[specimen]]")?;
    }
    let (specimens, collection) = specimen::read_all(one_by_one.as_ref(), of_file.as_ref(), common)?;
    if let (Some(item), Basis::Taylor) = (top.get("tables"), tables.basis) {
        tables::refuse_sources(&item, &specimens)?;
    }
    let names: Vec<&str> = specimens.iter().map(|specimen| specimen.name.as_str()).collect();
    let mut scenes = match top.get("scene") {
        Some(item) => scene::read_all(&item, &names, base)?,
        None => Vec::new(),
    };
    if let Some(item) = top.get("scene") {
        scene::refuse_mixed_lights(&item, &scenes, &specimens)?;
    }
    let gpu = match top.get("gpu") {
        Some(item) => gpu(&item.section(&keys::GPU, "[gpu]")?)?,
        None => defaults::GPU,
    };
    let report = match top.get("report") {
        Some(item) => report(&item.section(&keys::REPORT, "[report]")?)?,
        None => defaults::REPORT,
    };
    let cache = match top.get("cache") {
        Some(item) => Some(item.section(&keys::CACHE, "[cache]")?),
        None => None,
    };
    let cache = cache_config(cache.as_ref(), &atlas.out, base)?;
    let names: Vec<&str> = scenes.iter().map(|scene| scene.name.as_str()).collect();
    let cover = match top.get("tables") {
        Some(item) => tables::read_cover(&item, &names)?,
        None => Cover::All,
    };
    let scenes_are_given = top.get("scene").is_some();
    if !scenes_are_given && cover.is_all() {
        scenes = defaults::scenes();
    }
    let hold = match top.get("tables") {
        Some(item) => tables::read_hold(&item, &cover)?,
        None => Hold { xyz: true, spectral: true },
    };
    if let (Some(item), Cover::All) = (top.get("scene"), &cover) {
        scene::refuse_tolerances(&item)?;
    }
    let base = base.to_owned();
    Ok(Manifest {
        schema: SCHEMA,
        atlas,
        optics,
        tables,
        cover,
        hold,
        specimens,
        collection,
        scenes,
        scenes_are_given,
        gpu,
        report,
        cache,
        base,
    })
}

fn syntax_error(source: &Source, error: &toml::de::Error) -> error::Error {
    let end = source.text.len();
    let span = error.span().unwrap_or(end..end);
    let hint = syntax_hint(source.text, span.start);
    source.error(span, format!("not valid TOML: {}{hint}", error.message().trim_end()))
}

/// What is likely meant at a place that is not TOML: a path with backslashes in double quotes, or a decimal comma.
fn syntax_hint(text: &str, at: usize) -> &'static str {
    let bytes = text.as_bytes();
    let at = at.min(bytes.len());
    let start = bytes[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |before| before + 1);
    let end = bytes[at..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |after| at + after);
    let line = &bytes[start..end];
    if line.contains(&b'\\') && line.contains(&b'"') {
        return "; write paths with forward slashes, or between single quotes, where a backslash is one";
    }
    let is_digit = |index: usize| line.get(index).is_some_and(u8::is_ascii_digit);
    // The parser stops at the comma, where it expects the line to end.
    let near = (at - start).saturating_sub(1)..=at - start + 1;
    if near
        .into_iter()
        .any(|index| index > 0 && line.get(index) == Some(&b',') && is_digit(index - 1) && is_digit(index + 1))
    {
        return "; numbers have a decimal point, not a comma";
    }
    ""
}

/// Refuses a version that is not this program's; a missing one is seen to later.
fn check_schema(source: &Source, document: &DeTable) -> Result<()> {
    let Some(version) = document.get("schema") else {
        return Ok(());
    };
    if let toml::de::DeValue::Integer(integer) = version.get_ref()
        && integer.radix() == 10
        && integer.as_str().parse() == Ok(SCHEMA)
    {
        return Ok(());
    }
    let message = format!("`schema` must be {SCHEMA}, the manifest format that this program reads");
    Err(source.error(version.span(), message))
}

fn report(section: &Section) -> Result<ReportConfig> {
    let switch = |key: &str, default: bool| section.get(key).map_or(Ok(default), |item| item.boolean());
    Ok(ReportConfig {
        write: switch("write", defaults::REPORT.write)?,
        reference: switch("reference", defaults::REPORT.reference)?,
        savings: switch("savings", defaults::REPORT.savings)?,
    })
}

/// What may become of a specimen that fails.
const ON_FAILURE: [(&str, OnFailure); 3] =
    [("keep", OnFailure::Keep), ("drop", OnFailure::Drop), ("stop", OnFailure::Stop)];

/// Largest cache in MiB.
const CACHE_LIMIT_MIB_MAX: usize = 16 << 20;

fn cache_config(section: Option<&Section>, out: &Path, base: &Path) -> Result<CacheConfig> {
    let get = |key| section.and_then(|section| section.get(key));
    Ok(CacheConfig {
        folder: match get("folder") {
            Some(item) => base.join(item.text_not_empty()?),
            None => out.join(defaults::CACHE_FOLDER),
        },
        limit_mib: match get("limit_mib") {
            Some(item) => item.integer_within(0, CACHE_LIMIT_MIB_MAX, "MiB")? as u64,
            None => defaults::CACHE_LIMIT_MIB,
        },
    })
}

fn gpu(section: &Section) -> Result<GpuSection> {
    let checks = [("auto", GpuCheck::Auto), ("required", GpuCheck::Required), ("off", GpuCheck::Off)];
    let timings = [("auto", FrameTiming::Auto), ("on", FrameTiming::On), ("off", FrameTiming::Off)];
    let gpu = GpuSection {
        check: section.get("check").map_or(Ok(defaults::GPU.check), |item| item.choice(&checks))?,
        frame_time: section.get("frame_time").map_or(Ok(defaults::GPU.frame_time), |item| item.choice(&timings))?,
    };
    if gpu.check == GpuCheck::Off && gpu.frame_time == FrameTiming::On {
        let message = "`frame_time = \"on\"` needs a GPU, which `check = \"off\"` leaves alone";
        return Err(section.error_at_key("frame_time", message));
    }
    Ok(gpu)
}
