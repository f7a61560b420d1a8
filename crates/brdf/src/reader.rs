//! An atlas that is opened for reading: its specimens, and their BRDFs.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use crate::atlas::{self, AtlasIndex, FileRecord, INDEX_FILE, SpecimenEntry};
use crate::brdf::Brdf;
use crate::error::{Error, Result};
use crate::files;
use crate::parallel;
use crate::specimen::{self, SpecimenRecord};
use crate::spectral_storage::StoredSpectral;

const FIX: &str = "Restore the file from a copy of the atlas, or run the pipeline again to publish a new version.";

/// One version of an atlas. Nothing is kept open; files are read when a specimen is asked for.
///
/// ```
/// # mod tiny { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tiny_atlas/mod.rs")); }
/// # let folder = tempfile::tempdir()?;
/// # tiny::write_tiny_atlas(folder.path());
/// # let path = folder.path();
/// let atlas = diffraction_brdf::Atlas::open(path)?;
/// for specimen in atlas.specimens() {
///     println!("{}: {}", specimen.name, specimen.species);
/// }
/// let grating = atlas.brdf("grating")?;
/// assert!(grating.eval([0.0, 0.0, 1.0], [0.0, 0.0, 1.0])[1] > 0.0);
/// // Errors say what is there instead.
/// let error = atlas.brdf("grateing").unwrap_err();
/// assert!(error.to_string().contains("it holds grating"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Atlas {
    folder: PathBuf,
    index: AtlasIndex,
    passed_over: Vec<String>,
}

impl Atlas {
    /// Opens an atlas: its newest version that is sound, or the version whose folder `path` is.
    ///
    /// A version is sound if its index is unchanged and all its files are there in their sizes. Newer ones that are not are
    /// passed over, and told by [`Self::passed_over`].
    ///
    /// # Errors
    /// [`Error::Call`] for a path that is no folder, or no atlas; [`Error::BadFile`] for an index that is damaged or of a
    /// newer schema, and for an atlas without a sound version; [`Error::Disk`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let found = atlas::resolve(path.as_ref())?;
        let index = atlas::read_index(&found.folder)?;
        Ok(Self { folder: found.folder, index, passed_over: found.passed_over })
    }

    /// The atlas's name in its manifest.
    pub fn name(&self) -> &str {
        &self.index.name
    }

    /// Folder of the version that was opened.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// What is wrong with newer versions that were passed over, newest first; empty for a sound atlas.
    pub fn passed_over(&self) -> &[String] {
        &self.passed_over
    }

    /// Names and species, in the order of the manifest.
    pub fn specimens(&self) -> &[SpecimenEntry] {
        &self.index.specimens
    }

    /// What `specimen.json` says of a specimen, without its tables.
    ///
    /// # Errors
    /// As for [`Self::brdf`].
    pub fn record(&self, name: &str) -> Result<SpecimenRecord> {
        let folder = atlas::specimen_folder(&self.folder, &self.index, name)?;
        self.check_digest(&self.listed(), &format!("{name}/{}", specimen::FILE))?;
        specimen::read(&folder)
    }

    /// Reads a specimen's tables.
    ///
    /// Every file is held against its digest in the index first, so that tables are as published, or an error.
    ///
    /// # Errors
    /// [`Error::Call`] for a name that the atlas does not hold; [`Error::BadFile`] for a file that is missing, changed, or
    /// does not hold what it must; [`Error::Disk`].
    pub fn brdf(&self, name: &str) -> Result<Brdf> {
        let record = self.record(name)?;
        let spectral = record.spectral.iter().flat_map(StoredSpectral::files);
        let paths: Vec<String> = record.tables.files().chain(spectral).map(|file| format!("{name}/{file}")).collect();
        let listed = self.listed();
        parallel::map(&paths, |path| self.check_digest(&listed, path))?;
        Brdf::read(&self.folder.join(name), record)
    }

    fn listed(&self) -> HashMap<&str, &FileRecord> {
        self.index.files.iter().map(|file| (file.path.as_str(), file)).collect()
    }

    /// Whether a file is the one that was published.
    fn check_digest(&self, listed: &HashMap<&str, &FileRecord>, relative: &str) -> Result<()> {
        let path = self.folder.join(relative);
        let Some(record) = listed.get(relative) else {
            return Err(Error::bad_file(&path, format!("{INDEX_FILE} does not list this file"), FIX));
        };
        atlas::check_size(&self.folder, record).map_err(|what| Error::bad_file(&path, what, FIX))?;
        if files::sha256_file(&path)?.1 != record.sha256 {
            return Err(Error::bad_file(&path, "it is not the file that was published: its digest differs", FIX));
        }
        Ok(())
    }
}
