//! What the viewer reads of an atlas: the files of one version, each as it was published.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::stages::viewer::halves::{self, Scales};
use crate::stages::viewer::page::report_beside;
use diffraction_brdf::atlas::{self, AtlasIndex, FileRecord, INDEX_FILE};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::exr_image;
use diffraction_brdf::files;
use diffraction_brdf::json;

/// Name of the file that tells the page what to show.
const VIEWER_FILE: &str = "viewer.json";
/// Name of a specimen's height map.
const HEIGHTS_FILE: &str = "heights.png";
/// Name of the report, which gets a link to the page.
const REPORT_FILE: &str = "report.html";
/// Name of the report's numbers, which hold what was measured.
const REPORT_NUMBERS: &str = "report.json";
/// Pictures that the page shows.
const PICTURES: [&str; 3] = [HEIGHTS_FILE, "spectrum.png", "preview.png"];
/// What the atlas says of a specimen.
const SPECIMEN_FILE: &str = "specimen.json";
const FIX: &str = "Restore the atlas from a copy, or run the pipeline again to publish a new version.";

/// A version of an atlas as the page reads it.
#[derive(Debug)]
pub(crate) struct Content {
    /// The version's folder.
    folder: PathBuf,
    /// The index.
    index: AtlasIndex,
    /// Its bytes.
    index_bytes: Vec<u8>,
    /// Published files by their paths.
    records: BTreeMap<String, FileRecord>,
    /// Specimens that the page shows.
    specimens: Vec<String>,
    /// What the page is told beside them.
    viewer: Vec<u8>,
}

impl Content {
    /// Opens a version's folder, for these specimens, or all where none is named. Every file is there in its size.
    ///
    /// # Errors
    /// A damaged version, one that holds a link, or an unknown specimen.
    pub(crate) fn open(folder: &Path, specimens: &[String]) -> Result<Self> {
        let index = atlas::read_index(folder)?;
        // A link anywhere below is refused: it might lead out.
        files::list(folder)?;
        for file in &index.files {
            let damaged = |what| Error::bad_file(&folder.join(&file.path), what, FIX);
            atlas::check_size(folder, file).map_err(damaged)?;
        }
        let specimens = chosen(folder, &index, specimens)?;
        let records: BTreeMap<_, _> = index.files.iter().map(|file| (file.path.clone(), file.clone())).collect();
        let heights = |name: &String| {
            let path = format!("{name}/{HEIGHTS_FILE}");
            (name.clone(), records.contains_key(&path).then_some(path).into())
        };
        let heights: serde_json::Map<_, _> = specimens.iter().map(heights).collect();
        let measured = measured(folder, &records, &specimens)?;
        let told = json!({ "schema": 1, "specimens": specimens, "heights": heights, "measured": measured });
        let viewer = json::pretty(&told).expect("strings always become JSON").into_bytes();
        let index_bytes = files::read(&folder.join(INDEX_FILE))?;
        Ok(Self { folder: folder.to_owned(), index, index_bytes, records, specimens, viewer })
    }

    /// The atlas's name.
    pub(crate) fn name(&self) -> &str {
        &self.index.name
    }

    /// The bytes that go with a path below the page's `atlas/`; `None` where the version lists no such file.
    ///
    /// # Errors
    /// A file that is not as it was published, or that cannot be read.
    pub(crate) fn read(&self, path: &str) -> Result<Option<Vec<u8>>> {
        match path {
            INDEX_FILE => return Ok(Some(self.index_bytes.clone())),
            VIEWER_FILE => return Ok(Some(self.viewer.clone())),
            _ => {}
        }
        let Some(record) = self.records.get(path) else { return Ok(None) };
        let on_disk = self.folder.join(path);
        let bytes = files::read(&on_disk)?;
        if bytes.len() as u64 != record.bytes || files::sha256_hex(&bytes) != record.sha256 {
            return Err(Error::bad_file(&on_disk, "its content does not match its digest: it was changed", FIX));
        }
        if path == REPORT_FILE {
            return Ok(Some(report_beside(&String::from_utf8_lossy(&bytes)).into_bytes()));
        }
        Ok(Some(bytes))
    }

    /// A table as the half floats that the page makes of it, where they take less than its file; `None` for all else.
    ///
    /// # Errors
    /// A file that is not as it was published, or that cannot be read.
    pub(crate) fn halves(&self, path: &str) -> Result<Option<Vec<u8>>> {
        let file = path.rsplit('/').next().unwrap_or(path);
        let scales = match file.split('.').collect::<Vec<_>>()[..] {
            ["table", _, "exr"] => Scales::Shared,
            ["spectral", _, "exr"] => Scales::Each,
            _ => return Ok(None),
        };
        let Some(stored) = self.read(path)? else { return Ok(None) };
        let (table, _) = exr_image::read_rgb(&self.folder.join(path))?;
        let packed = halves::pack(&table, scales)?;
        Ok((packed.len() < stored.len()).then_some(packed))
    }

    /// Paths of what the page reads, sorted: the index, what it is told, and of each specimen's own folder tables, facts and the pictures
    /// that it shows.
    pub(crate) fn needed(&self) -> Vec<String> {
        let is_read = |file: &str| {
            let is_image = file.ends_with(".exr") && !file.contains('/');
            is_image || file == SPECIMEN_FILE || PICTURES.contains(&file)
        };
        let shown = |path: &&String| {
            let of = path.split_once('/').filter(|(_, file)| is_read(file));
            of.is_some_and(|(name, _)| self.specimens.iter().any(|shown| shown == name))
        };
        let mut paths: Vec<String> = self.records.keys().filter(shown).cloned().collect();
        paths.extend([INDEX_FILE.to_owned(), VIEWER_FILE.to_owned()]);
        paths.sort_unstable();
        paths
    }
}

/// What was measured of each of these specimens, as the report has it: the page lays it over its spectra.
fn measured(
    folder: &Path,
    records: &BTreeMap<String, FileRecord>,
    specimens: &[String],
) -> Result<serde_json::Map<String, Value>> {
    if !records.contains_key(REPORT_NUMBERS) {
        return Ok(serde_json::Map::new());
    }
    let path = folder.join(REPORT_NUMBERS);
    let report: Value = serde_json::from_slice(&files::read(&path)?)
        .map_err(|error| Error::bad_file(&path, format!("it is no JSON: {error}"), FIX))?;
    let of = |name: &String| {
        let found = report["specimens"].as_array()?.iter().find(|specimen| specimen["name"] == **name)?;
        let columns = &found["measured"]["columns"];
        columns.is_array().then(|| (name.clone(), columns.clone()))
    };
    Ok(specimens.iter().filter_map(of).collect())
}

/// The specimens of these names in the atlas's order; all where none is named.
fn chosen(folder: &Path, index: &AtlasIndex, specimens: &[String]) -> Result<Vec<String>> {
    for name in specimens {
        atlas::specimen_folder(folder, index, name)?;
    }
    let wanted = |name: &&String| specimens.is_empty() || specimens.contains(name);
    Ok(index.specimens.iter().map(|entry| &entry.name).filter(wanted).cloned().collect())
}
