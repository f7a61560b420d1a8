//! Removing old versions of an atlas, by policy.

use std::fs;
use std::path::Path;

use super::publish;
use diffraction_brdf::atlas;
use diffraction_brdf::error::{Error, Result};

/// Removes all versions but the newest `keep`, the one that `latest` names, the newest that is sound, and those that are `locked`; gives
/// the names of those that go, oldest first. With `only_say` nothing is removed.
///
/// A version vanishes by one rename. Files that versions share stay as long as one of them does.
///
/// # Errors
/// [`Error::Busy`] where a run is publishing, or the disk's.
pub(crate) fn prune(atlas_root: &Path, keep: usize, locked: &[String], only_say: bool) -> Result<Vec<String>> {
    let _lock = publish::take_lock(atlas_root)?;
    let latest = fs::read_to_string(atlas_root.join(atlas::LATEST_FILE)).unwrap_or_default();
    let sound = atlas::newest_version(atlas_root)?.map(|(name, _)| name);
    let numbers = atlas::version_numbers(atlas_root)?;
    let old = numbers.len().saturating_sub(keep);
    let goes = |name: &String| name != latest.trim() && !locked.contains(name) && sound.as_ref() != Some(name);
    let gone: Vec<String> = numbers[..old].iter().map(|number| atlas::version_name(*number)).filter(goes).collect();
    for name in gone.iter().filter(|_| !only_say) {
        let (from, to) = (atlas_root.join(name), publish::leftover(atlas_root, name));
        fs::rename(&from, &to).map_err(|e| Error::disk(&from, "remove", e))?;
        fs::remove_dir_all(&to).map_err(|e| Error::disk(&to, "remove", e))?;
    }
    Ok(gone)
}
