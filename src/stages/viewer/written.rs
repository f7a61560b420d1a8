//! The viewer as files on the disk: a folder for any web host.

use std::path::Path;

use crate::stages::viewer::content::Content;
use crate::stages::viewer::page;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

/// Writes the page and what it needs of the atlas into an empty folder; the bytes that it takes.
///
/// # Errors
/// A file of the atlas that is not as it was published, the disk's.
pub(crate) fn fill_folder(content: &Content, folder: &Path) -> Result<u64> {
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
