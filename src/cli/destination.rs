//! Where commands write: never onto what they read or what was published, over what is there only where that is asked for, and
//! whole or not at all.

use std::fs;
use std::path::{Path, PathBuf};

use diffraction_brdf::atlas::INDEX_FILE;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

/// The option that allows replacing a file.
const FORCE: &str = "--force";

/// Refuses a file that must not be written, before anything is computed: one of the inputs under any name, part of a published
/// version, anything but a plain file, and without `force` whatever is there.
///
/// # Errors
/// [`Error::Call`] with the reason.
pub(crate) fn check_file(out: &Path, inputs: &[&Path], force: bool) -> Result<()> {
    check_place(out)?;
    let Ok(found) = out.symlink_metadata() else { return Ok(()) };
    if let Some(input) = inputs.iter().find(|input| is_same(out, input)) {
        return Err(refusal(out, &format!("is what this command reads ({}); write to another file", input.display())));
    }
    if out.is_dir() {
        return Err(refusal(out, "is a folder; name a file to write"));
    }
    // A device or a pipe would be replaced by a file; a link to nothing is only a name.
    if out.metadata().is_ok_and(|target| !target.is_file()) {
        return Err(refusal(out, "is no plain file; leave the option out to write to standard output"));
    }
    if !force {
        let what = if found.is_symlink() { "is a link that is there already" } else { "is there already" };
        return Err(refusal(out, &format!("{what}; name another file, or replace it with `{FORCE}`")));
    }
    Ok(())
}

/// Refuses a file that must not be appended to: one of the inputs under any name, part of a published version, a folder.
///
/// # Errors
/// As [`check_file`].
pub(crate) fn check_log(log: &Path, inputs: &[&Path]) -> Result<()> {
    check_place(log)?;
    if let Some(input) = inputs.iter().find(|input| is_same(log, input)) {
        return Err(refusal(log, &format!("is what this command reads ({}); write to another file", input.display())));
    }
    if log.is_dir() {
        return Err(refusal(log, "is a folder; name a file to write"));
    }
    Ok(())
}

/// Makes the folder that a file goes to, right before it is written.
///
/// # Errors
/// The disk's.
pub(crate) fn create_parent(out: &Path) -> Result<()> {
    files::create_folder(&parent(out))
}

/// Writes a folder by `fill`, which is lent an empty one beside it, and gives it its name at the end. One that holds something is
/// never replaced: nobody can say what else is in it.
///
/// # Errors
/// [`Error::Call`] for a place that is taken, those of `fill`, and the disk's; nothing is left then.
pub(crate) fn write_folder<T, E: From<Error>>(
    out: &Path,
    fill: impl FnOnce(&Path) -> std::result::Result<T, E>,
) -> std::result::Result<T, E> {
    check_folder(out, None)?;
    create_parent(out)?;
    let beside = beside(out)?;
    let written = fill_and_rename(&beside, out, fill);
    if written.is_err() {
        // The error at hand is of interest; what is left is only untidy.
        let _ = fs::remove_dir_all(&beside);
    }
    written
}

/// Refuses a folder that must not be written, before anything is computed; `force` is that of commands which may replace single
/// files in one that is there.
///
/// # Errors
/// As [`write_folder`].
pub(crate) fn check_folder(out: &Path, force: Option<bool>) -> Result<()> {
    check_place(out)?;
    if out.symlink_metadata().is_err() || is_empty_folder(out) || (force == Some(true) && out.is_dir()) {
        return Ok(());
    }
    let hint = force.map_or(String::new(), |_| format!(", or replace files in it with `{FORCE}`"));
    Err(refusal(out, &format!("is there already; name another folder, or remove it{hint}")))
}

fn fill_and_rename<T, E: From<Error>>(
    beside: &Path,
    out: &Path,
    fill: impl FnOnce(&Path) -> std::result::Result<T, E>,
) -> std::result::Result<T, E> {
    files::create_folder(beside)?;
    let filled = fill(beside)?;
    // Only an empty folder may stand in the way, and not every system renames onto that.
    let _ = fs::remove_dir(out);
    fs::rename(beside, out).map_err(|error| Error::disk(out, "write", error))?;
    Ok(filled)
}

/// Nothing is written into a published version: it never changes.
fn check_place(out: &Path) -> Result<()> {
    if out.file_name().is_none() {
        return Err(refusal(out, "names no file or folder to write"));
    }
    // A folder that is not there yet lies in the nearest one above it that is.
    let folder = parent(out);
    let above = folder.ancestors().find(|above| !above.as_os_str().is_empty() && above.exists());
    let above = above.unwrap_or(Path::new("."));
    let Ok(above) = above.canonicalize() else { return Ok(()) };
    match above.ancestors().find(|above| above.join(INDEX_FILE).is_file()) {
        None => Ok(()),
        Some(version) => Err(refusal(
            out,
            &format!("lies in the published version {}, which never changes; write elsewhere", version.display()),
        )),
    }
}

fn refusal(out: &Path, what: &str) -> Error {
    Error::Call(format!("{}: {what}", out.display()))
}

/// Whether two names are of one file: by links, other spellings, other letters on systems that pass over them.
fn is_same(a: &Path, b: &Path) -> bool {
    same_file::is_same_file(a, b).unwrap_or(false)
}

fn is_empty_folder(path: &Path) -> bool {
    path.symlink_metadata().is_ok_and(|found| found.is_dir())
        && fs::read_dir(path).is_ok_and(|mut entries| entries.next().is_none())
}

fn parent(path: &Path) -> PathBuf {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned()
}

/// A name in the same folder, hidden, for what is not whole yet.
fn beside(out: &Path) -> Result<PathBuf> {
    let name = out.file_name().ok_or_else(|| refusal(out, "names no folder to write"))?;
    let hidden = format!(".{}.{}{}", name.to_string_lossy(), std::process::id(), files::PART_SUFFIX);
    Ok(out.with_file_name(hidden))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_read_is_not_written_under_any_name() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("scan.tif"), "heights").unwrap();
        fs::create_dir(at("below")).unwrap();
        fs::hard_link(at("scan.tif"), at("hard.tif")).unwrap();
        let mut names = vec![at("scan.tif"), at("below/../scan.tif"), at("./scan.tif"), at("hard.tif")];
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("scan.tif", at("soft.tif")).unwrap();
            std::os::unix::fs::symlink(".", at("here")).unwrap();
            names.extend([at("soft.tif"), at("here/scan.tif")]);
        }
        for name in names {
            for force in [false, true] {
                let message = check_file(&name, &[&at("scan.tif")], force).unwrap_err().to_string();
                assert!(message.contains("is what this command reads"), "{message}");
            }
            // As an input under that name, too.
            assert!(check_file(&at("scan.tif"), &[&name], true).is_err(), "{}", name.display());
        }
        assert!(check_file(&at("new.tif"), &[&at("scan.tif")], false).is_ok());
    }

    #[test]
    fn what_is_there_is_replaced_only_where_that_is_asked_for() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("old.csv"), "old").unwrap();
        assert!(check_file(&at("old.csv"), &[], false).unwrap_err().to_string().contains("`--force`"));
        assert!(check_file(&at("old.csv"), &[], true).is_ok());
        assert!(check_file(folder.path(), &[], true).unwrap_err().to_string().contains("a folder"));
        fs::create_dir_all(at("v0001")).unwrap();
        fs::write(at("v0001/atlas.json"), "{}").unwrap();
        for inside in ["v0001/new.csv", "v0001/deep/down/new.csv", "v0001/../v0001/new.csv"] {
            let message = check_file(&at(inside), &[], true).unwrap_err().to_string();
            assert!(message.contains("never changes"), "{message}");
            assert!(check_folder(&at(inside), Some(true)).is_err());
        }
        #[cfg(unix)]
        assert!(check_file(Path::new("/dev/null"), &[], true).unwrap_err().to_string().contains("no plain file"));
    }

    #[test]
    fn a_folder_appears_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("a/export");
        let failed: Result<()> = write_folder(&out, |beside| {
            fs::write(beside.join("half"), "half").unwrap();
            Err(Error::Call("no".into()))
        });
        assert_eq!(failed.unwrap_err().to_string(), "no");
        assert!(fs::read_dir(folder.path().join("a")).unwrap().next().is_none(), "nothing is left");
        fs::create_dir(&out).unwrap();
        let fill = |beside: &Path| -> Result<u8> {
            fs::write(beside.join("whole"), "whole").unwrap();
            Ok(1)
        };
        assert_eq!(write_folder(&out, fill).unwrap(), 1, "an empty folder is taken");
        assert_eq!(fs::read_to_string(out.join("whole")).unwrap(), "whole");
        let message = write_folder(&out, fill).unwrap_err().to_string();
        assert!(message.contains("is there already"), "{message}");
        assert_eq!(fs::read_dir(folder.path().join("a")).unwrap().count(), 1);
    }
}
