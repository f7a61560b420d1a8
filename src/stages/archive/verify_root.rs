//! Verifying what lies beside an atlas's versions: the file `latest`, and whatever is no part of the atlas.

use std::path::Path;

use super::verify_files::Failure;
use diffraction_brdf::atlas::{LATEST_FILE, version_name, version_number, version_numbers};
use diffraction_brdf::error::Result;
use diffraction_brdf::files;

/// Longest name that `latest` can hold.
const NAME_BYTES_MAX: u64 = 64;

/// What is wrong in the folder of an atlas besides its versions. Hidden files are those of runs under way, of locks, and of the
/// system, and say nothing.
///
/// # Errors
/// [`Error::Disk`](diffraction_brdf::error::Error::Disk) for a folder that cannot be listed.
pub(super) fn verify_root(root: &Path) -> Result<Vec<Failure>> {
    let mut failures = Vec::new();
    let mut failed = |file: &str, what: String| failures.push(Failure { file: file.to_owned(), what });
    let newest = version_numbers(root)?.last().map(|&number| version_name(number));
    if let Some(what) = newest.as_deref().and_then(|newest| latest_fault(&root.join(LATEST_FILE), newest)) {
        failed(LATEST_FILE, what);
    }
    let mut entries = files::entries(root)?;
    entries.sort_by(|a, b| a.0.cmp(&b.0));
    for (path, kind) in entries {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        match version_number(&name) {
            Some(_) if !kind.is_dir() => failed(&name, "it has a version's name and is no folder".into()),
            None if name != LATEST_FILE && !name.starts_with('.') => {
                failed(&name, "it is no part of the atlas; move it elsewhere".into());
            }
            _ => {}
        }
    }
    Ok(failures)
}

/// What is wrong with the file that names the newest version, if anything.
fn latest_fault(path: &Path, newest: &str) -> Option<String> {
    match path.symlink_metadata() {
        Err(_) => Some("it is missing; the next run writes it".into()),
        Ok(found) if !found.is_file() => Some("it is no plain file; remove it, the next run writes it".into()),
        Ok(found) if found.len() > NAME_BYTES_MAX => Some("it holds more than the name of a version".into()),
        Ok(_) => match files::read_text(path) {
            Ok(text) if text.trim_end() == newest => None,
            Ok(text) => Some(format!("it names `{}`, the newest version is {newest}", text.trim_end())),
            Err(_) => Some("it cannot be read".into()),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn latest_and_foreign_entries_are_named() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir(at("v0001")).unwrap();
        std::fs::create_dir(at("v0002")).unwrap();
        std::fs::write(at(".lock"), "").unwrap();
        let names = || verify_root(folder.path()).unwrap().into_iter().map(|failure| failure.file).collect::<Vec<_>>();
        assert_eq!(names(), ["latest"]);
        for (text, expected) in
            [("v0002\n", 0), ("v0002", 0), ("v0001\n", 1), ("../../etc", 1), ("", 1), ("\u{1b}[2J", 1)]
        {
            std::fs::write(at("latest"), text).unwrap();
            assert_eq!(names().len(), expected, "{text:?}");
        }
        #[cfg(unix)]
        {
            std::fs::remove_file(at("latest")).unwrap();
            std::fs::write(at(".target"), "v0002\n").unwrap();
            std::os::unix::fs::symlink(".target", at("latest")).unwrap();
            assert_eq!(names(), ["latest"]);
            std::fs::remove_file(at("latest")).unwrap();
        }
        std::fs::write(at("latest"), "v0002\n").unwrap();
        for foreign in ["v3", "v00002", "v18446744073709551615", "notes"] {
            std::fs::create_dir(at(foreign)).unwrap();
            assert_eq!(names(), [foreign]);
            std::fs::remove_dir(at(foreign)).unwrap();
        }
        std::fs::write(at("v0000"), "").unwrap();
        assert_eq!(names(), ["v0000"]);
    }
}
