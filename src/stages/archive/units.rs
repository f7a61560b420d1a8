//! Finished specimens that no version holds yet: the store through which interrupted runs and other machines hand them over.
//!
//! `ROOT/.units/NAME.KEY` is the folder of a specimen as it will lie in a version. It appears by one rename, so it is
//! there whole or not at all, and whoever comes second with the same removes his own: no lock is needed, and a file system without
//! locks serves. `KEY` names everything that it was made from.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::Value;

use crate::stages::results::Failure;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;
use diffraction_brdf::json;

/// The store's folder in that of the atlas.
pub(crate) const FOLDER: &str = ".units";

/// Digits of the key in a unit's name: enough that two never meet.
const KEY_DIGITS: usize = 32;

/// The folder of a specimen in the store, there or not.
pub(crate) fn place(atlas_root: &Path, name: &str, made_from: &Value) -> PathBuf {
    let key = files::sha256_hex(json::canonical(made_from).as_bytes());
    atlas_root.join(FOLDER).join(format!("{name}.{}", &key[..KEY_DIGITS]))
}

/// Takes a finished folder into the store, unless there is one already that `is_whole`; gives whether it did.
///
/// # Errors
/// The disk's.
pub(crate) fn keep(finished: &Path, place: &Path, is_whole: impl Fn(&Path) -> bool) -> Result<bool> {
    files::create_folder(place.parent().unwrap_or(Path::new(".")))?;
    let remove = |folder: &Path| fs::remove_dir_all(folder).map_err(|e| Error::disk(folder, "remove", e));
    match fs::rename(finished, place) {
        Ok(()) => Ok(true),
        Err(_) if place.is_dir() && is_whole(place) => remove(finished).map(|()| false),
        Err(_) if place.is_dir() => {
            remove(place)?;
            fs::rename(finished, place).map_err(|e| Error::disk(place, "keep the specimen", e)).map(|()| true)
        }
        Err(e) => Err(Error::disk(place, "keep the specimen", e)),
    }
}

/// Why a specimen could not be made, beside its place: for whoever merges.
///
/// # Errors
/// The disk's.
pub(crate) fn keep_failure(place: &Path, failure: &Failure) -> Result<()> {
    files::create_folder(place.parent().unwrap_or(Path::new(".")))?;
    json::write(&failure_file(place), failure)
}

/// Why the specimen of a place could not be made, where that is known.
pub(crate) fn failure(place: &Path) -> Option<Failure> {
    json::read(&failure_file(place), "").ok()
}

/// `NAME.KEY-failed`.
fn failure_file(place: &Path) -> PathBuf {
    let mut name = place.file_name().unwrap_or_default().to_owned();
    name.push("-failed");
    place.with_file_name(name)
}

/// A private folder in the store, in which specimens are made; removed when dropped.
#[derive(Debug)]
pub(crate) struct Work(PathBuf);

impl Work {
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        // What is left is removed by the next run that publishes.
        let _ = fs::remove_dir_all(&self.0);
        let _ = fs::remove_dir(self.0.parent().unwrap_or(Path::new(".")));
    }
}

/// Start of the names of private folders; the machine and the process follow.
const WORK: &str = ".work-";

/// Makes a private folder, and removes those that dead processes of this machine left.
///
/// # Errors
/// The disk's.
pub(crate) fn begin(atlas_root: &Path) -> Result<Work> {
    let folder = atlas_root.join(FOLDER);
    sweep(&folder);
    let work = folder.join(format!("{}{}", work_prefix(), std::process::id()));
    files::create_folder(&work)?;
    Ok(Work(work))
}

fn work_prefix() -> String {
    let machine = fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default();
    let machine: String = machine.trim().chars().filter(char::is_ascii_alphanumeric).collect();
    format!("{WORK}{machine}-")
}

/// How long a private folder of another machine is taken to be in use after it was last written to.
const IN_USE: Duration = Duration::from_secs(24 * 3600);

/// Removes private folders of processes that are gone: of this machine by their number, of others by their age.
fn sweep(folder: &Path) {
    let own = work_prefix();
    for (path, _) in files::entries(folder).unwrap_or_default() {
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else { continue };
        let process = name.strip_prefix(&own).and_then(|id| id.parse::<u32>().ok());
        let age = || path.metadata().ok()?.modified().ok()?.elapsed().ok();
        let is_gone = match process {
            Some(process) => Path::new("/proc/self").exists() && !Path::new(&format!("/proc/{process}")).exists(),
            None => name.starts_with(WORK) && age().is_some_and(|age| age > IN_USE),
        };
        if is_gone {
            let _ = fs::remove_dir_all(&path);
        }
    }
}

/// Removes what the store holds of a specimen, whatever it was made from: a version has it, or it is out of date.
pub(crate) fn forget<'a>(atlas_root: &Path, names: impl IntoIterator<Item = &'a str>) {
    let folder = atlas_root.join(FOLDER);
    let names: HashSet<&str> = names.into_iter().collect();
    // Whatever stays is found, or forgotten, by the next run.
    for (path, _) in files::entries(&folder).unwrap_or_default() {
        let unit = path.file_name().and_then(|unit| unit.to_str()).and_then(|unit| unit.rsplit_once('.'));
        if unit.is_some_and(|(name, _)| names.contains(name)) {
            let _ = fs::remove_dir_all(&path).or_else(|_| fs::remove_file(&path));
        }
    }
    sweep(&folder);
    let _ = fs::remove_dir(folder);
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_first_of_two_whole_units_stays_and_other_names_are_not_forgotten() {
        let root = tempfile::tempdir().unwrap();
        let unit = |name: &str, text: &str, is_whole: bool| {
            let folder = root.path().join("work");
            fs::create_dir(&folder).unwrap();
            fs::write(folder.join("a"), text).unwrap();
            let place = place(root.path(), name, &json!({"scan": 1}));
            keep(&folder, &place, |_| is_whole).unwrap();
            assert!(!folder.exists());
            fs::read_to_string(place.join("a")).unwrap()
        };
        assert_eq!(unit("snake", "first", true), "first");
        assert_eq!(unit("snake", "second", true), "first");
        assert_eq!(unit("snake", "third", false), "third");
        assert_eq!(unit("snake_b", "b", true), "b");
        assert_ne!(place(root.path(), "snake", &json!(1)), place(root.path(), "snake", &json!(2)));
        forget(root.path(), ["snake"]);
        let left = files::entries(&root.path().join(FOLDER)).unwrap();
        assert_eq!(left.len(), 1);
        forget(root.path(), ["snake_b"]);
        assert!(!root.path().join(FOLDER).exists());
    }
}
