//! The `[[specimen]]` tables.

use std::collections::hash_map::Entry;
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};

use super::collection::{self, Collection};
use super::defaults;
use super::files;
use super::keys;
use super::measured;
use super::name;
use super::optics;
use super::reader::{Item, Section};
use crate::error::{Error, Result};
use crate::stages::config::SpecimenConfig;
use diffraction_build::height::PITCH_NM;
use diffraction_build::height::prepare::{Despike, Level, PrepareConfig};
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig};
use diffraction_build::optics::config::{Material, OpticsConfig};

/// Largest lateral length: 1 mm, beyond any structure that diffracts visibly.
const LATERAL_MAX_NM: f64 = 1e6;

/// Largest height: 1 mm.
const HEIGHT_MAX_NM: f64 = 1e6;

/// Most samples along a side.
const SAMPLES_MAX: usize = 1 << 20;

/// Largest page number.
const PAGE_MAX: usize = 65_535;

/// What specimens have in common.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Common<'a> {
    /// What each starts from: the manifest's `[optics]`.
    pub optics: &'a OpticsConfig,
    /// The range of wavelengths that is written down there.
    pub written_nm: Option<[f64; 2]>,
    /// Whether a material is given there.
    pub is_material_given: bool,
    /// Where paths start.
    pub base: &'a Path,
}

/// Reads every specimen: those of `[[specimen]]`, and the rows of a CSV file.
pub(crate) fn read_all(
    items: Option<&Item>,
    collection: Option<&Item>,
    common: Common,
) -> Result<(Vec<SpecimenConfig>, Option<Collection>)> {
    let mut all = Specimens::default();
    if let Some(item) = items {
        if !item.is_list() {
            return Err(item.error("must be written as [[specimen]], with double brackets"));
        }
        let items = item.list()?;
        if items.is_empty() {
            return Err(item.error("must hold at least one specimen"));
        }
        for item in items {
            let section = item.section(&keys::SPECIMEN, "[[specimen]]")?;
            let name = section.require("name", "name = \"corn_snake\"")?;
            all.add(&section.called("specimen", &name), &name, common)?;
        }
    }
    let collection =
        collection.map(|item| collection::read(item, common.base, |section, name| all.add(section, name, common)));
    Ok((all.all, collection.transpose()?))
}

/// Specimens whose names differ in more than case.
#[derive(Default)]
struct Specimens {
    all: Vec<SpecimenConfig>,
    /// Places of names in lower case.
    places: HashMap<String, usize>,
}

impl Specimens {
    fn add(&mut self, section: &Section, name: &Item, common: Common) -> Result<()> {
        for one in of_section(section, name, common)? {
            match self.places.entry(one.name.to_ascii_lowercase()) {
                Entry::Occupied(taken) => return Err(repetition(name, &one, &self.all[*taken.get()])),
                Entry::Vacant(free) => free.insert(self.all.len()),
            };
            self.all.push(one);
        }
        Ok(())
    }
}

/// Of a name that is taken; where names come from files, says from which.
fn repetition(item: &Item, one: &SpecimenConfig, other: &SpecimenConfig) -> Error {
    let is_pattern =
        item.text().is_ok_and(|text| [FILE_PATTERN, FOLDER_PATTERN].iter().any(|part| text.contains(part)));
    let files = match (is_pattern, &one.scans[..], &other.scans[..]) {
        (true, [one], [other, ..]) => format!(" (of {} and {})", other.display(), one.display()),
        _ => String::new(),
    };
    name::repetition(item, &one.name, &other.name, &files)
}

/// What stands in a name for that of the file, without its ending, or of its folder: each file then is a specimen of its own.
const FILE_PATTERN: &str = "{file}";
const FOLDER_PATTERN: &str = "{folder}";

/// The specimen that a section describes, or one for each of its files.
fn of_section(section: &Section, name: &Item, common: Common) -> Result<Vec<SpecimenConfig>> {
    let pattern = name.text()?;
    if !pattern.contains(FILE_PATTERN) && !pattern.contains(FOLDER_PATTERN) {
        return Ok(vec![read(section, name::read(name)?, common)?]);
    }
    // What is wrong with the name beside the files' is the manifest's fault.
    name::checked(name, &pattern.replace(FILE_PATTERN, "a").replace(FOLDER_PATTERN, "a"))?;
    let all = read(section, String::new(), common)?;
    let of_file = |scan: &PathBuf| {
        let text = |part: Option<&std::ffi::OsStr>| part.unwrap_or_default().to_string_lossy().into_owned();
        let folder = scan.parent().and_then(Path::file_name);
        let wanted = pattern.replace(FILE_PATTERN, &text(scan.file_stem())).replace(FOLDER_PATTERN, &text(folder));
        SpecimenConfig { name: name::for_file(&wanted), scans: vec![scan.clone()], ..all.clone() }
    };
    Ok(all.scans.iter().map(of_file).collect())
}

fn read(section: &Section, name: String, common: Common) -> Result<SpecimenConfig> {
    let Common { optics, written_nm, is_material_given, base } = common;
    let mut optics = optics.clone();
    if let Some(item) = section.get("illuminant") {
        optics::read_illuminant(&item, written_nm, base, &mut optics)?;
    }
    optics::read_overrides(section, base, &mut optics)?;
    let species = section.get("species").map(|item| item.text_not_empty());
    let page = section.get("page").map(|item| item.integer_within(0, PAGE_MAX, ""));
    let channel = section.get("channel").map(|item| item.text_not_empty());
    let blend = section.get("blend_nm").map(|item| item.number_above(0.0, LATERAL_MAX_NM, "nm"));
    let missing = section.get("max_missing_share").map(|item| item.number_within(0.0, 0.5, ""));
    Ok(SpecimenConfig {
        name,
        species: species.transpose()?.map(str::to_owned),
        scans: scans(&section.require("scans", "scans = [\"scans/snake_*.tif\"]")?, base)?,
        read: ReadConfig {
            page: page.transpose()?,
            channel: channel.transpose()?.map(str::to_owned),
            pitch_nm: section.get("pitch_nm").map(|item| pitch(&item)).transpose()?,
            height: section.get("height").map(|item| height(&item)).transpose()?,
            max_missing_share: missing.transpose()?.unwrap_or(defaults::MAX_MISSING_SHARE),
            missing_value: section.get("missing_value").map(|item| item.number()).transpose()?,
            crop: section.get("crop").map(|item| crop(&item)).transpose()?,
            ..ReadConfig::default()
        },
        prepare: PrepareConfig {
            level: section.get("level").map_or(Ok(defaults::LEVEL), |item| level(&item))?,
            despike: section.get("despike").map(|item| despike(&item)).transpose()?,
            blend_nm: blend.transpose()?,
        },
        is_material_given: is_material_given || section.has("material"),
        albedo: section.get("albedo").map(|item| albedo(&item, &optics)).transpose()?,
        optics,
        measured: section.get("measured").map(|item| measured::read(&item, base)).transpose()?,
    })
}

/// A pigment's colour, below a surface that light passes.
fn albedo(item: &Item, optics: &OpticsConfig) -> Result<[f64; 3]> {
    let list = item.list_of::<3>("linear sRGB such as [0.45, 0.16, 0.05]")?;
    let [r, g, b] = list.each_ref().map(|item| item.number_within(0.0, 1.0, ""));
    if !matches!(optics.material, Material::Dielectric { .. }) {
        return Err(item.error("needs a transparent material to shine through, such as `material = { n = 1.56 }`"));
    }
    Ok([r?, g?, b?])
}

/// What stands before a pattern whose files are left out.
const EXCLUDED: char = '!';

/// Paths and patterns, or one of them without brackets; those behind `!` are left out.
fn scans(item: &Item, base: &Path) -> Result<Vec<PathBuf>> {
    let patterns = if item.is_list() { item.list()? } else { vec![item.clone()] };
    if patterns.is_empty() {
        return Err(item.error("must name at least one file"));
    }
    let (mut scans, mut left_out) = (Vec::new(), BTreeSet::new());
    for item in patterns {
        let pattern = item.text_not_empty()?;
        if let Some(excluded) = pattern.strip_prefix(EXCLUDED).filter(|_| !base.join(pattern).is_file()) {
            let found = files::expand(base, excluded)
                .map_err(|error| item.error(format!("\"{excluded}\" cannot be looked up: {error}")))?;
            left_out.extend(found);
            continue;
        }
        let found = files::expand(base, pattern)
            .map_err(|error| item.error(format!("\"{pattern}\" cannot be looked up: {error}")))?;
        if found.is_empty() {
            return Err(item.error(match files::has_wildcard(pattern) {
                true => files::no_match(base, pattern),
                false => files::no_file(&base.join(pattern)),
            }));
        }
        scans.extend(found);
    }
    scans.retain(|scan| !left_out.contains(scan));
    if scans.is_empty() {
        return Err(item.error("leaves out every file that it names"));
    }
    // Overlapping patterns must not weigh a scan twice in the average.
    scans.sort();
    scans.dedup();
    Ok(scans)
}

/// First column, first row, width, height.
fn crop(item: &Item) -> Result<[usize; 4]> {
    let [x, y, width, height] =
        item.list_of::<4>("four numbers of samples such as [0, 0, 512, 400]: first column, first row, width, height")?;
    let first = |item: &Item| item.integer_within(0, SAMPLES_MAX, "samples");
    let length = |item: &Item| item.integer_within(1, SAMPLES_MAX, "samples");
    Ok([first(&x)?, first(&y)?, length(&width)?, length(&height)?])
}

fn pitch(item: &Item) -> Result<[f64; 2]> {
    if !item.is_list() {
        return item.number_within(PITCH_NM[0], PITCH_NM[1], "nm").map(|pitch| [pitch; 2]);
    }
    let [x, y] = item.list_of::<2>("a number of nm, or two for x and y")?;
    Ok([x.number_within(PITCH_NM[0], PITCH_NM[1], "nm")?, y.number_within(PITCH_NM[0], PITCH_NM[1], "nm")?])
}

fn height(item: &Item) -> Result<HeightScale> {
    let example = "{ unit = \"nm\" }";
    let section = item.section(&keys::HEIGHT, example)?;
    let forms = ["full_scale_nm", "unit", "nm_per_count"];
    let given: Vec<&str> = forms.into_iter().filter(|key| section.has(key)).collect();
    let [form] = given[..] else {
        return Err(item.error(format!(
            "must hold exactly one of `full_scale_nm`, `unit`, and `nm_per_count`; found {}",
            if given.is_empty() { "none".to_owned() } else { keys::quoted(&given) }
        )));
    };
    if form != "nm_per_count" && section.has("offset_nm") {
        return Err(section.error_at_key(
            "offset_nm",
            format!("`{}.offset_nm` goes with `nm_per_count`, not with `{form}`", item.path()),
        ));
    }
    let value = section.require(form, example)?;
    match form {
        "full_scale_nm" => value.number_above(0.0, HEIGHT_MAX_NM, "nm").map(HeightScale::FullScaleNm),
        "unit" => unit(&value).map(HeightScale::Unit),
        _ => {
            let nm_per_count = value.number_within(-HEIGHT_MAX_NM, HEIGHT_MAX_NM, "nm")?;
            if nm_per_count == 0.0 {
                return Err(value.error("must not be 0: every height would be the same"));
            }
            let offset = section.get("offset_nm").map(|item| item.number_within(-HEIGHT_MAX_NM, HEIGHT_MAX_NM, "nm"));
            Ok(HeightScale::Linear { nm_per_count, offset_nm: offset.transpose()?.unwrap_or(defaults::OFFSET_NM) })
        }
    }
}

fn unit(item: &Item) -> Result<LengthUnit> {
    item.choice(&[
        ("pm", LengthUnit::Pm),
        ("nm", LengthUnit::Nm),
        ("um", LengthUnit::Um),
        ("mm", LengthUnit::Mm),
        ("cm", LengthUnit::Cm),
        ("m", LengthUnit::M),
        ("angstrom", LengthUnit::Angstrom),
        ("inch", LengthUnit::Inch),
    ])
}

fn level(item: &Item) -> Result<Level> {
    item.choice(&[
        ("none", Level::None),
        ("plane", Level::Plane),
        ("quadratic", Level::Quadratic),
        ("rows", Level::Rows),
    ])
}

fn despike(item: &Item) -> Result<Despike> {
    let example = "{ threshold_rms = 8 }";
    let section = item.section(&keys::DESPIKE, example)?;
    let threshold = section.require("threshold_rms", example)?;
    Ok(Despike {
        // Below 1 most of a good scan would count as dust.
        threshold_rms: threshold.number_within(1.0, 1000.0, "robust standard deviations")?,
    })
}
