//! The file `result.json`: what a finished specimen was made from, what it came to, and the digests of its files.
//!
//! It lies in the specimen's folder. A run that would make the specimen from the same takes the folder over as it is.

use std::path::Path;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::stages::digest::record_file;
use crate::stages::gpu::results::{GpuRow, GpuSpectralRow};
use crate::stages::results::{Failure, SpecimenResult};
use diffraction_brdf::atlas::{FileRecord, InputRecord, RESULT_FILE};
use diffraction_brdf::error::Result;
use diffraction_brdf::files;
use diffraction_brdf::json;

/// Layout of the file; another number is taken for none.
const SCHEMA: u32 = 1;

/// A finished specimen. Times in it differ from run to run; everything else follows from `made_from`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpecimenRecord {
    /// Layout version.
    pub schema: u32,
    /// Everything that the specimen's files depend on: inputs by digest, settings, scenes, the program.
    pub made_from: Value,
    /// Sizes and digests of its files, this one not, by their paths from its folder.
    pub files: Vec<FileRecord>,
    /// The files that it was made from, as the atlas's index lists them.
    pub inputs: Vec<InputRecord>,
    /// What was found out, as the report shows it.
    pub result: SpecimenResult,
    /// What went wrong without keeping the specimen from being made.
    pub failures: Vec<Failure>,
    /// Its scenes on the GPU; none where there was none.
    pub gpu: Vec<GpuRow>,
    /// Its spectral tables on the GPU.
    pub gpu_spectral: Vec<GpuSpectralRow>,
}

impl SpecimenRecord {
    /// Writes the record of a folder in which all other files are in place, and gives it with the folder's files as
    /// [`Self::checked_files`].
    ///
    /// # Errors
    /// The disk's.
    pub fn write(mut self, folder: &Path) -> Result<(Self, Vec<FileRecord>)> {
        let paths = files::list(folder)?.into_iter().filter(|path| path != RESULT_FILE);
        self.files = paths.map(|path| record_file(folder, path)).collect::<Result<_>>()?;
        self.schema = SCHEMA;
        // Plain structs with string keys: there is nothing in them that JSON could refuse.
        let text = json::pretty(&self).expect("plain data can always be written as JSON");
        files::replace(&folder.join(RESULT_FILE), text.as_bytes())?;
        let listed = self.listed(folder)?;
        Ok((self, listed))
    }

    /// Reads the record of a folder; `None` where there is none that this program understands.
    pub fn read(folder: &Path) -> Option<Self> {
        let text = files::read_text(&folder.join(RESULT_FILE)).ok()?;
        serde_json::from_str(&text).ok().filter(|record: &Self| record.schema == SCHEMA)
    }

    /// Without what a version of many specimens tells of each on its own page alone, which is read back when that is written.
    pub(crate) fn in_short(self) -> Self {
        Self { result: self.result.in_short(), files: Vec::new(), ..self }
    }

    /// Its files and itself as a version's index lists them, by paths from the version's folder; `None` unless every file is
    /// as it was recorded.
    pub fn checked_files(&self, folder: &Path) -> Option<Vec<FileRecord>> {
        let whole = self.files.par_iter().all(|file| {
            let same = |found: FileRecord| found == *file;
            files::stays_below(&file.path) && record_file(folder, file.path.clone()).is_ok_and(same)
        });
        if whole { self.listed(folder).ok() } else { None }
    }

    fn listed(&self, folder: &Path) -> Result<Vec<FileRecord>> {
        let own = record_file(folder, RESULT_FILE.to_owned())?;
        let name = &self.result.name;
        let below = |file: FileRecord| FileRecord { path: format!("{name}/{}", file.path), ..file };
        Ok(self.files.iter().cloned().chain([own]).map(below).collect())
    }
}
