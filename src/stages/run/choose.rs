//! Which specimens a run has to make, and which it finds as it would make them.
//!
//! A finished specimen carries what it was made from. Where that is what it would be made from now, and every file is
//! as it was recorded, its folder is taken over: from the newest version, or from what an interrupted run or another machine finished.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde_json::{Value, json};

use super::made_from::{made_from, scene_value};
use crate::stages::archive::diff::{self, Change};
use crate::stages::archive::result_file::SpecimenRecord;
use crate::stages::archive::units;
use crate::stages::config::{RunConfig, SpecimenConfig};
use crate::stages::coverage::asked;
use crate::stages::pictures::shared_scenes::SharedRecord;
use crate::stages::pictures::sharing::specimens_of;
use diffraction_brdf::atlas::{self, AtlasIndex, FileRecord, SpecimenEntry};
use diffraction_brdf::error::Result;
use diffraction_brdf::files;
use diffraction_brdf::json;

/// A specimen that is there; of very many no more than an overview shows.
pub(super) struct Found {
    /// Its folder.
    pub(super) folder: PathBuf,
    pub(super) record: SpecimenRecord,
    /// Its files, as a version's index lists them.
    pub(super) files: Vec<FileRecord>,
    /// Whether the newest version holds it.
    pub(super) is_published: bool,
}

impl Found {
    /// As it is kept while others are looked for.
    pub(super) fn kept(self, is_one_of_many: bool) -> Self {
        if is_one_of_many { Self { record: self.record.in_short(), ..self } } else { self }
    }
}

/// Where a specimen comes from.
pub(super) enum Choice {
    /// It is there.
    Found(Box<Found>),
    /// It has to be made.
    Make {
        /// From what; `None` where that cannot be told, as of a scan that cannot be read.
        made_from: Option<Value>,
        /// Why, in words.
        why: String,
    },
}

impl Choice {
    /// What it is, or is going to be, made from.
    pub(super) fn made_from(&self) -> Option<&Value> {
        match self {
            Self::Found(found) => Some(&found.record.made_from),
            Self::Make { made_from, .. } => made_from.as_ref(),
        }
    }
}

/// Scenes that several specimens share and that are there, by name.
pub(super) type FoundScenes = BTreeMap<String, SharedRecord>;

/// The newest version.
pub(super) struct Newest {
    pub(super) name: String,
    pub(super) folder: PathBuf,
    pub(super) index: AtlasIndex,
    /// Places of specimens in the index.
    places: HashMap<String, usize>,
}

impl Newest {
    /// That of an atlas, where there is one.
    ///
    /// # Errors
    /// The disk's.
    pub(super) fn of(atlas_root: &Path) -> Result<Option<Self>> {
        let one = |(name, index): (String, AtlasIndex)| {
            let places = index.specimens.iter().enumerate().map(|(place, entry)| (entry.name.clone(), place)).collect();
            Self { folder: atlas_root.join(&name), name, index, places }
        };
        Ok(atlas::newest_version(atlas_root)?.map(one))
    }

    /// Its record of a file, by its path.
    pub(super) fn file(&self, path: &str) -> Option<&FileRecord> {
        let place = self.index.files.binary_search_by(|listed| listed.path.as_str().cmp(path));
        place.ok().map(|at| &self.index.files[at])
    }

    /// Its entry of a specimen.
    pub(super) fn entry(&self, name: &str) -> Option<&SpecimenEntry> {
        self.places.get(name).map(|place| &self.index.specimens[*place])
    }

    /// A specimen that it holds, undamaged, whatever it was made from.
    pub(super) fn specimen(&self, name: &str) -> Option<Found> {
        self.whole(name, self.record(name)?)
    }

    fn lists(&self, name: &str) -> bool {
        self.places.contains_key(name)
    }

    fn record(&self, name: &str) -> Option<SpecimenRecord> {
        if self.lists(name) { SpecimenRecord::read(&self.folder.join(name)) } else { None }
    }

    /// The specimen of a record, if all its files are as they were published; the record is itself one of them.
    fn whole(&self, name: &str, record: SpecimenRecord) -> Option<Found> {
        let folder = self.folder.join(name);
        let files = record.checked_files(&folder)?;
        let listed = |file: &FileRecord| self.file(&file.path) == Some(file);
        files.iter().all(listed).then_some(Found { folder, record, files, is_published: true })
    }
}

/// Looks for every specimen, and for the scenes that several share: those are there only together with all their specimens.
pub(super) fn choose(
    config: &RunConfig,
    specimens: &[&SpecimenConfig],
    newest: Option<&Newest>,
) -> (Vec<Choice>, FoundScenes) {
    let is_of_many = asked::is_of_many(config);
    let one = |specimen: &&SpecimenConfig| {
        let made_from = made_from(config, specimen);
        if !config.reuse {
            return Choice::Make { made_from, why: "everything is asked to be computed anew".into() };
        }
        match look_for(config, &specimen.name, made_from, newest) {
            Choice::Found(found) => Choice::Found(Box::new(found.kept(is_of_many))),
            make => make,
        }
    };
    let mut choices: Vec<Choice> = specimens.par_iter().map(one).collect();
    let scenes = found_scenes(config, specimens, &mut choices, newest);
    (choices, scenes)
}

/// A specimen that would be made from this.
fn look_for(config: &RunConfig, name: &str, made_from: Option<Value>, newest: Option<&Newest>) -> Choice {
    let Some(made_from) = made_from else {
        return Choice::Make { made_from, why: "a file that it is made from cannot be read".into() };
    };
    let why = match newest.and_then(|newest| Some((newest, newest.record(name)?))) {
        Some((newest, record)) if record.made_from == made_from => match newest.whole(name, record) {
            Some(found) => return Choice::Found(Box::new(found)),
            None => "its files in the newest version are damaged".into(),
        },
        Some((_, record)) => in_words(&diff::changes(&record.made_from, &made_from)),
        None if newest.is_some_and(|newest| newest.lists(name)) => {
            "the newest version does not tell what it was made from".into()
        }
        None => "it is new".into(),
    };
    let place = units::place(&config.atlas_root, name, &made_from);
    match found(place, name).filter(|found| found.record.made_from == made_from) {
        Some(found) => Choice::Found(Box::new(found)),
        None => Choice::Make { made_from: Some(made_from), why },
    }
}

/// A finished folder of the store, if all of it is as it was finished.
pub(super) fn found(folder: PathBuf, name: &str) -> Option<Found> {
    let record = SpecimenRecord::read(&folder).filter(|record| record.result.name == name)?;
    let files = record.checked_files(&folder)?;
    Some(Found { folder, record, files, is_published: false })
}

/// Most changes that are told one by one.
const CHANGES_TOLD: usize = 3;

/// What changed, on one line.
fn in_words(changes: &[Change]) -> String {
    let one = |change: &Change| {
        let value = |value: &Option<Value>| value.as_ref().map_or("(absent)".into(), diff::short);
        match change.what.as_str() {
            "program" => "another build of the program".to_owned(),
            what => format!("{what}: {} -> {}", value(&change.a), value(&change.b)),
        }
    };
    let told: Vec<String> = changes.iter().take(CHANGES_TOLD).map(one).collect();
    match changes.len().saturating_sub(CHANGES_TOLD) {
        0 => told.join("; "),
        more => format!("{}; and {more} more", told.join("; ")),
    }
}

/// Shares of a picture are not kept: a scene of several specimens is there with all of them, or all of them are made.
fn found_scenes(
    config: &RunConfig,
    specimens: &[&SpecimenConfig],
    choices: &mut [Choice],
    newest: Option<&Newest>,
) -> FoundScenes {
    let records = newest.map_or_else(Vec::new, |newest| SharedRecord::read_all(&newest.folder));
    let mut known = FoundScenes::new();
    loop {
        known.clear();
        let mut missing = None;
        for scene in config.scenes.iter().filter(|scene| !specimens_of(scene).is_empty()) {
            let wanted = shared_made_from(specimens_of(scene), scene_value(scene), specimens, choices);
            match records.iter().find(|record| Some(&record.made_from) == wanted.as_ref()) {
                Some(record) => drop(known.insert(scene.name.clone(), record.clone())),
                None => missing = missing.or(is_any_found(specimens_of(scene), specimens, choices).then_some(scene)),
            }
        }
        let Some(scene) = missing else { return known };
        for (specimen, choice) in specimens.iter().zip(&mut *choices) {
            if let (true, Choice::Found(found)) = (specimens_of(scene).contains(&specimen.name), &*choice) {
                let made_from = Some(found.record.made_from.clone());
                *choice =
                    Choice::Make { made_from, why: format!("its share of the scene \"{}\" is needed", scene.name) };
            }
        }
    }
}

fn is_any_found(members: &[String], specimens: &[&SpecimenConfig], choices: &[Choice]) -> bool {
    let mut all = specimens.iter().zip(choices);
    all.any(|(specimen, choice)| members.contains(&specimen.name) && matches!(choice, Choice::Found(_)))
}

/// What a shared picture is made from: the scene, and its specimens, all of which are there.
fn shared_made_from(
    members: &[String],
    scene: Option<Value>,
    specimens: &[&SpecimenConfig],
    choices: &[Choice],
) -> Option<Value> {
    let digest_of = |name: &String| {
        let at = specimens.iter().position(|specimen| specimen.name == *name)?;
        match &choices[at] {
            Choice::Found(found) if found.is_published => Some(digest(&found.record.made_from)),
            _ => None,
        }
    };
    let members: Option<BTreeMap<&String, String>> =
        members.iter().map(|name| Some((name, digest_of(name)?))).collect();
    Some(json!({ "scene": scene?, "specimens": members? }))
}

/// Names what something was made from.
pub(super) fn digest(made_from: &Value) -> String {
    files::sha256_hex(json::canonical(made_from).as_bytes())
}
