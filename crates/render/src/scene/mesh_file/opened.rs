//! The bytes of a mesh file and of the files it names.

use std::path::{Path, PathBuf};

use super::growing::bad;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

/// Largest mesh file, and largest sum of the files it names.
pub(super) const BYTES_MAX: u64 = 512 << 20;
/// A mesh file, and what has been read of it and of the files it names.
pub(super) struct Opened {
    pub(super) path: PathBuf,
    pub(super) files: Vec<(PathBuf, String)>,
    bytes: u64,
}

impl Opened {
    pub(super) fn new(path: &Path) -> Self {
        Self { path: path.to_owned(), files: Vec::new(), bytes: 0 }
    }

    /// A file's bytes, unless there are too many.
    pub(super) fn read(&mut self, path: &Path) -> Result<Vec<u8>> {
        let metadata = path.metadata().map_err(|e| Error::disk(path, "read", e))?;
        if !metadata.is_file() {
            return Err(bad(path, "it is not a file"));
        }
        self.bytes += metadata.len();
        if self.bytes > BYTES_MAX {
            let what =
                format!("{}: with it the mesh takes {} bytes, more than {BYTES_MAX}", path.display(), self.bytes);
            return Err(Error::limit(what, "Simplify the mesh."));
        }
        let bytes = files::read(path)?;
        self.files.push((path.to_owned(), files::sha256_hex(&bytes)));
        Ok(bytes)
    }
}
