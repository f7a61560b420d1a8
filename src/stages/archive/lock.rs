//! The lock beside a manifest: what its atlas was made from and came to, by digest, so that a later run can be held to it.
//!
//! It is a version's own account, without what may differ between runs that compute the same: specimens with all that they were made
//! from, and every file's digest. Which build of the program made them is told and not compared: what it makes is.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::diff::{self, Change};
use super::result_file::SpecimenRecord;
use diffraction_brdf::atlas::{self, AtlasIndex, FileRecord};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::json;

/// Layout of the file.
const SCHEMA: u32 = 1;

/// Key of `made_from` that names the build of the program.
const PROGRAM: &str = "program";

/// What an atlas was made from and came to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lock {
    schema: u32,
    /// The atlas's name.
    atlas: String,
    /// The version that held it all.
    version: String,
    /// Version of the program that made it.
    program_version: String,
    /// What each specimen was made from: inputs by digest, settings, scenes.
    specimens: BTreeMap<String, Value>,
    /// Digests of all files that depend on nothing else, by their paths.
    files: BTreeMap<String, String>,
}

impl Lock {
    /// The lock of a version, by its folder.
    ///
    /// # Errors
    /// A damaged version, or one whose specimens do not tell what they were made from.
    pub fn of_version(folder: &Path) -> Result<Self> {
        let index = atlas::read_index(folder)?;
        let one = |name: &String| {
            let record = SpecimenRecord::read(&folder.join(name)).ok_or_else(|| {
                let what = "this does not tell what the specimen was made from, so it cannot be locked";
                Error::bad_file(&folder.join(name), what, "Run with `--no-cache`, which makes it anew.")
            })?;
            Ok((name.clone(), without_program(record.made_from)))
        };
        Ok(Self {
            schema: SCHEMA,
            atlas: index.name.clone(),
            version: folder.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            program_version: index.program_version.clone(),
            specimens: index.specimens.iter().map(|entry| one(&entry.name)).collect::<Result<_>>()?,
            files: digests(&index),
        })
    }

    /// Reads a lock.
    ///
    /// # Errors
    /// [`Error::Call`] where there is none, or something else in its place.
    pub fn read(path: &Path) -> Result<Self> {
        let call = |why: String| Error::Call(format!("{}: {why}", path.display()));
        if !path.exists() {
            return Err(call("there is no lock; `run --lock` writes it".into()));
        }
        let lock: Self = json::read(path, "Restore it from a copy, or write it anew with `run --lock`.")
            .map_err(|error| call(format!("this is no lock: {error}")))?;
        match lock.schema {
            SCHEMA => Ok(lock),
            other => Err(call(format!("its layout has the number {other}; this program knows {SCHEMA}"))),
        }
    }

    /// Writes it, over none but a lock.
    ///
    /// # Errors
    /// Something else under its name, or the disk's.
    pub fn write(&self, path: &Path) -> Result<()> {
        if path.exists() && json::read::<Self>(path, "").is_err() {
            let what = "this is no lock, and is left as it is";
            return Err(Error::bad_file(path, what, "Give it another name, or the manifest."));
        }
        json::write(path, self)
    }

    /// The version that it names, with its atlas.
    pub fn names(&self) -> [&str; 2] {
        [&self.atlas, &self.version]
    }

    /// Whether specimens are going to be made from what it says; `now` has them in order, with `None` where a file cannot be read.
    ///
    /// # Errors
    /// [`Error::Limit`] with the first difference.
    pub(crate) fn check_specimens<'a>(
        &self,
        atlas: &str,
        now: impl Iterator<Item = (&'a str, Option<&'a Value>)>,
    ) -> Result<()> {
        if atlas != self.atlas {
            return Err(differs(format!("it locks the atlas {:?}, and this is {atlas:?}", self.atlas)));
        }
        let mut seen = 0;
        for (name, made_from) in now {
            let Some(then) = self.specimens.get(name) else {
                return Err(differs(format!("{name}: it is not in the lock")));
            };
            let Some(made_from) = made_from else {
                return Err(differs(format!("{name}: a file that it is made from cannot be read")));
            };
            if let Some(change) = diff::changes(then, &without_program(made_from.clone())).first() {
                return Err(differs(format!("{name}: {}", in_words(change))));
            }
            seen += 1;
        }
        match seen == self.specimens.len() {
            true => Ok(()),
            false => Err(differs(format!("it holds {} specimens, and the manifest {seen}", self.specimens.len()))),
        }
    }

    /// Whether files came out as it says.
    ///
    /// # Errors
    /// [`Error::Limit`] with the first difference.
    pub(crate) fn check_files(&self, index: &AtlasIndex) -> Result<()> {
        let value = |files: &BTreeMap<String, String>| {
            let text = |(path, digest): (&String, &String)| (path.clone(), Value::String(digest.clone()));
            files.iter().map(text).collect::<BTreeMap<_, _>>()
        };
        match diff::leaf_changes(value(&self.files), value(&digests(index))).first() {
            None => Ok(()),
            Some(change) => Err(differs(in_words(change))),
        }
    }
}

fn without_program(mut made_from: Value) -> Value {
    if let Some(fields) = made_from.as_object_mut() {
        fields.remove(PROGRAM);
    }
    made_from
}

fn digests(index: &AtlasIndex) -> BTreeMap<String, String> {
    let listed = index.files.iter().filter(|file| !atlas::may_differ(&file.path));
    listed.map(|FileRecord { path, sha256, .. }| (path.clone(), sha256.clone())).collect()
}

fn in_words(change: &Change) -> String {
    let value = |value: &Option<Value>| value.as_ref().map_or("(absent)".into(), diff::short);
    format!("{}: {} in the lock, {} now", change.what, value(&change.a), value(&change.b))
}

fn differs(what: String) -> Error {
    Error::limit(
        format!("not as locked: {what}"),
        "Nothing was published. Restore what changed; or, where the change is meant, run with `--lock` in place of `--frozen`.",
    )
}
