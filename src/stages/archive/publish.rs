//! Publishing: a private staging folder becomes a version by one rename, or nothing changes.
//!
//! Killed at any moment, a run leaves every published version as it was; what it leaves beside them is removed by the
//! next run. In order: files on the disk, index on the disk, rename, `latest`.

use std::collections::{BTreeMap, HashSet};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::stages::archive::verify_files;
use diffraction_brdf::atlas::{self, AtlasIndex, FileRecord, LATEST_FILE};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

const LOCK_FILE: &str = ".lock";
const STAGING_PREFIX: &str = ".staging-";
/// Folder in the staging folder that is removed before publishing.
const WORK: &str = ".work";

/// A run's private folder; it holds the atlas's lock. Dropped without being published, it is removed.
#[derive(Debug)]
pub struct Staging {
    root: PathBuf,
    folder: PathBuf,
    /// Files of which an older version made sure that they are on the disk, by their paths from the folder.
    on_disk: HashSet<String>,
    /// Released by the system when the process dies.
    lock: File,
}

/// What publishing came to; the version's name.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Published {
    /// A new version was published.
    Version(String),
    /// The newest version holds the same already.
    Unchanged(String),
}

impl Published {
    /// Name of the version that holds the result.
    pub fn version(&self) -> &str {
        match self {
            Self::Version(name) | Self::Unchanged(name) => name,
        }
    }
}

impl Staging {
    /// The folder to write into.
    pub fn path(&self) -> &Path {
        &self.folder
    }

    /// A folder for what is not of the version: specimens while they are made.
    pub(crate) fn work(&self) -> PathBuf {
        self.folder.join(WORK)
    }

    /// Says of files that they are those of a published version, which publishing then does not wait for once more.
    pub(crate) fn note_published<'f>(&mut self, files: impl Iterator<Item = &'f FileRecord>) {
        self.on_disk.extend(files.map(|file| file.path.clone()));
    }

    /// Name of the version that it becomes if it is published: the lock keeps others from taking it.
    pub(crate) fn next_version(&self) -> Result<String> {
        let newest = atlas::version_numbers(&self.root)?.last().copied().unwrap_or(0);
        Ok(atlas::version_name(newest + 1))
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // After publishing it is gone already; a failure leaves what the next run removes.
        let _ = fs::remove_dir_all(&self.folder);
        // Closing alone would leave the lock with a child process that was just forked off and still has a copy.
        let _ = self.lock.unlock();
    }
}

/// Starts a run: takes the atlas's lock, removes what dead runs left, sets `latest` right, makes the staging folder.
pub fn begin(atlas_root: &Path) -> Result<Staging> {
    files::create_folder(atlas_root)?;
    let lock = take_lock(atlas_root)?;
    remove_leftovers(atlas_root)?;
    if let Some((newest, _)) = atlas::newest_version(atlas_root)? {
        point_latest_to(atlas_root, &newest)?;
    }
    // In the atlas's own folder, so that the rename stays on one file system.
    let folder = atlas_root.join(format!("{STAGING_PREFIX}{}", std::process::id()));
    files::create_folder(&folder)?;
    Ok(Staging { root: atlas_root.to_owned(), folder, on_disk: HashSet::new(), lock })
}

/// Publishes the staging folder as the next version, unless the newest one holds the same and is undamaged. Files that
/// hold times do not count as a change. Of the files in `known` size and digest are taken as they are.
pub fn publish(staging: Staging, index: AtlasIndex, known: Vec<FileRecord>) -> Result<Published> {
    let index = recorded(&staging, index, known)?;
    publish_recorded(staging, index)
}

/// The index with all that the staging folder holds. Of the files in `known` size and digest are taken as they are.
pub(crate) fn recorded(staging: &Staging, mut index: AtlasIndex, known: Vec<FileRecord>) -> Result<AtlasIndex> {
    match fs::remove_dir_all(staging.work()) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => return Err(Error::disk(&staging.work(), "remove", e)),
        _ => {}
    }
    let known: BTreeMap<String, FileRecord> = known.into_iter().map(|file| (file.path.clone(), file)).collect();
    let record = |path: String| known.get(&path).cloned().map_or_else(|| atlas::record_file(&staging.folder, path), Ok);
    index.files = files::list(&staging.folder)?.into_iter().map(record).collect::<Result<_>>()?;
    Ok(index)
}

/// As [`publish`], with an index of [`recorded`].
pub(crate) fn publish_recorded(staging: Staging, mut index: AtlasIndex) -> Result<Published> {
    if let Some((newest, published)) = atlas::newest_version(&staging.root)?
        && published.content() == index.content()
        && verify_files::verify_files(&staging.root.join(&newest))?.failures.is_empty()
    {
        return Ok(Published::Unchanged(newest));
    }
    atlas::write_index(&staging.folder, &mut index)?;
    files::sync_tree(&staging.folder, &|path| staging.on_disk.contains(path))?;
    let name = staging.next_version()?;
    let target = staging.root.join(&name);
    fs::rename(&staging.folder, &target).map_err(|e| Error::disk(&target, "publish the version", e))?;
    files::sync_folder(&staging.root)?;
    point_latest_to(&staging.root, &name)?;
    Ok(Published::Version(name))
}

/// The lock of an atlas, released when dropped or when the process dies.
pub(super) fn take_lock(root: &Path) -> Result<File> {
    let path = root.join(LOCK_FILE);
    let opened = OpenOptions::new().create(true).truncate(false).write(true).open(&path);
    let lock = opened.map_err(|e| Error::disk(&path, "open the lock", e))?;
    match lock.try_lock() {
        Ok(()) => Ok(lock),
        Err(TryLockError::WouldBlock) => Err(Error::Busy {
            what: format!("{}: another run is publishing into this atlas", root.display()),
            fix: "Wait until it has ended, or give this manifest another `atlas.name` or `atlas.out`.".into(),
        }),
        Err(TryLockError::Error(e)) => Err(Error::disk(&path, "take the lock", e)),
    }
}

/// A name for a folder that the next run removes, should nobody else.
pub(super) fn leftover(root: &Path, name: &str) -> PathBuf {
    root.join(format!("{STAGING_PREFIX}{name}"))
}

/// Only called with the lock held: whoever wrote these is dead.
fn remove_leftovers(root: &Path) -> Result<()> {
    for (path, kind) in files::entries(root)? {
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else { continue };
        let removed = if kind.is_dir() && name.starts_with(STAGING_PREFIX) {
            fs::remove_dir_all(&path)
        } else if kind.is_file() && name.starts_with('.') && name.ends_with(files::PART_SUFFIX) {
            fs::remove_file(&path)
        } else {
            Ok(())
        };
        removed.map_err(|e| Error::disk(&path, "remove what a dead run left", e))?;
    }
    Ok(())
}

fn point_latest_to(root: &Path, name: &str) -> Result<()> {
    let path = root.join(LATEST_FILE);
    let text = format!("{name}\n");
    if fs::read(&path).is_ok_and(|found| found == text.as_bytes()) {
        return Ok(());
    }
    files::replace_durably(&path, text.as_bytes())
}
