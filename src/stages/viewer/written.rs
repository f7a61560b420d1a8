//! The viewer as files on the disk: a folder for any web host, or one page; each is written beside and renamed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::stages::viewer::content::Content;
use crate::stages::viewer::page;
use crate::stages::viewer::single_file::single_file;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

/// Writes the page and what it needs of the atlas into a folder of its own; the bytes that it takes.
///
/// # Errors
/// Something that is there already, a file of the atlas that is not as it was published, the disk's.
pub(crate) fn write_folder(content: &Content, out: &Path) -> Result<u64> {
    refuse_existing(out)?;
    let beside = beside(out)?;
    let written = fill(content, &beside).and_then(|bytes| {
        fs::rename(&beside, out).map_err(|error| Error::disk(out, "write", error))?;
        Ok(bytes)
    });
    if written.is_err() {
        // The error at hand is of interest; what is left is only untidy.
        let _ = fs::remove_dir_all(&beside);
    }
    written
}

/// Writes one HTML file that holds everything; its size in bytes.
///
/// # Errors
/// As [`write_folder`].
pub(crate) fn write_single_file(content: &Content, out: &Path) -> Result<u64> {
    refuse_existing(out)?;
    let text = single_file(content)?;
    if let Some(folder) = out.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        files::create_folder(folder)?;
    }
    files::replace(out, text.as_bytes())?;
    Ok(text.len() as u64)
}

fn fill(content: &Content, folder: &Path) -> Result<u64> {
    files::create_folder(folder)?;
    let mut total = 0;
    let mut put = |path: String, bytes: &[u8]| {
        let file = folder.join(path);
        files::create_folder(file.parent().unwrap_or(folder))?;
        total += bytes.len() as u64;
        files::replace(&file, bytes)
    };
    for (name, text) in page::FILES {
        put(name.to_owned(), text.as_bytes())?;
    }
    for path in content.needed() {
        let bytes = content.read(&path)?.ok_or_else(|| Error::Call(format!("{path}: the atlas does not list it")))?;
        put(format!("{}/{path}", page::ATLAS_FOLDER), &bytes)?;
    }
    Ok(total)
}

fn refuse_existing(out: &Path) -> Result<()> {
    if out.symlink_metadata().is_ok() {
        return Err(Error::Call(format!("{}: is there already; name another `--out`", out.display())));
    }
    Ok(())
}

/// A name in the same folder, hidden, for what is not whole yet.
fn beside(out: &Path) -> Result<PathBuf> {
    let name = out.file_name().ok_or_else(|| Error::Call(format!("{}: name a folder to write", out.display())))?;
    let hidden = format!(".{}.{}{}", name.to_string_lossy(), std::process::id(), files::PART_SUFFIX);
    Ok(out.with_file_name(hidden))
}
