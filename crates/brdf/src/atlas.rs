//! The atlas on disk: its index with digests, its versions, and which of them is the newest.
//!
//! `ROOT/v0001`, `ROOT/v0002`, ... are complete and never change. `ROOT/latest` names the newest; it is a convenience
//! for people and scripts, since the newest complete version can always be found without it.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::error::{Error, Result};
use crate::files;
use crate::json;
use crate::specimen::{self, SCHEMA};

/// Name of the index in a version's folder.
pub const INDEX_FILE: &str = "atlas.json";
/// Name of the file that names the newest version.
pub const LATEST_FILE: &str = "latest";
/// Files that hold times, and so differ between runs that compute the same.
pub const TIMED_FILES: [&str; 2] = ["report.html", "report.json"];

/// Folder of the reports of single specimens, where a version holds many; no specimen has a dot in its name.
pub const PAGES_FOLDER: &str = "report.pages";
/// Name of the file in a version's folder with the manifest, word for word.
pub const MANIFEST_FILE: &str = "manifest.toml";
/// Name of the file in a specimen's folder with all that a run found out of it: times too.
pub const RESULT_FILE: &str = "result.json";
/// End of the names of pictures that show what a GPU did wrong: they depend on the machine.
pub const DIFFERENCE_SUFFIX: &str = ".gpu.png";

const FIX: &str = "Restore the atlas from a copy, or run the pipeline again to publish a new version.";

/// An input and what it held.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct InputRecord {
    /// The path as the manifest names it.
    pub path: String,
    /// SHA-256 in hexadecimal.
    pub sha256: String,
}

/// A published file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FileRecord {
    /// Path relative to the version's folder, `/` between its parts.
    pub path: String,
    /// Size in bytes.
    pub bytes: u64,
    /// SHA-256 in hexadecimal.
    pub sha256: String,
}

/// A specimen in the atlas.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SpecimenEntry {
    /// Name in the manifest, and of the folder.
    pub name: String,
    /// Scientific name.
    pub species: String,
    /// Why its files are those of an older version: what kept it from being made again. Absent where they are not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stale: Option<String>,
}

/// Path of the report of one specimen among many.
pub fn page_path(specimen: &str) -> String {
    format!("{PAGES_FOLDER}/{specimen}.html")
}

/// Whether a file of a version may differ between runs that compute the same: it holds times or comments, or depends on the
/// machine.
pub fn may_differ(path: &str) -> bool {
    let name = path.rsplit('/').next().unwrap_or(path);
    let is_page = path.strip_prefix(PAGES_FOLDER).is_some_and(|rest| rest.starts_with('/'));
    TIMED_FILES.contains(&path)
        || is_page
        || path == MANIFEST_FILE
        || name == RESULT_FILE
        || path.ends_with(DIFFERENCE_SUFFIX)
}

/// The file `atlas.json`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct AtlasIndex {
    /// Layout version.
    pub schema: u32,
    /// The atlas's name in the manifest.
    pub name: String,
    /// Version of the program that made it.
    pub program_version: String,
    /// SHA-256 of the manifest's values: comments and layout do not count.
    pub manifest_sha256: String,
    /// Every file read, in the order of the manifest.
    pub inputs: Vec<InputRecord>,
    /// Every specimen, in the order of the manifest.
    pub specimens: Vec<SpecimenEntry>,
    /// Every file but this one, sorted by path; filled in by publishing.
    pub files: Vec<FileRecord>,
    /// SHA-256 of this file with this field empty; filled in by publishing.
    pub index_sha256: String,
}

impl AtlasIndex {
    /// An index to be published: `files` and digests are filled in by publishing.
    pub fn new(name: &str, manifest_sha256: &str, inputs: Vec<InputRecord>, specimens: Vec<SpecimenEntry>) -> Self {
        Self {
            schema: SCHEMA,
            name: name.to_owned(),
            program_version: env!("CARGO_PKG_VERSION").to_owned(),
            manifest_sha256: manifest_sha256.to_owned(),
            inputs,
            specimens,
            files: Vec::new(),
            index_sha256: String::new(),
        }
    }

    /// The index without what may differ between two runs that compute the same.
    pub fn content(&self) -> Self {
        let mut content = Self { index_sha256: String::new(), ..self.clone() };
        content.files.retain(|file| !may_differ(&file.path));
        content
    }

    fn own_digest(&self) -> String {
        let text = json::pretty(&Self { index_sha256: String::new(), ..self.clone() });
        files::sha256_hex(text.expect("strings and whole numbers always become JSON").as_bytes())
    }
}

/// Sizes and digests of every file below a folder but the index.
pub fn record_files(folder: &Path) -> Result<Vec<FileRecord>> {
    let paths = files::list(folder)?;
    paths.into_iter().filter(|path| path != INDEX_FILE).map(|path| record_file(folder, path)).collect()
}

/// Size and digest of one file below a folder.
pub fn record_file(folder: &Path, path: String) -> Result<FileRecord> {
    let (bytes, sha256) = files::sha256_file(&folder.join(&path))?;
    Ok(FileRecord { path, bytes, sha256 })
}

/// Writes the index, with its own digest.
pub fn write_index(folder: &Path, index: &mut AtlasIndex) -> Result<()> {
    index.index_sha256 = index.own_digest();
    json::write(&folder.join(INDEX_FILE), index)
}

/// Reads a version's index and checks it against its own digest: any changed byte is an error.
pub fn read_index(folder: &Path) -> Result<AtlasIndex> {
    let path = folder.join(INDEX_FILE);
    let text = files::read_text(&path)?;
    let not_json = |e: serde_json::Error| Error::bad_file(&path, format!("this is not the JSON expected: {e}"), FIX);
    specimen::check_schema(&path, &serde_json::from_str::<Value>(&text).map_err(not_json)?)?;
    let index: AtlasIndex = serde_json::from_str(&text).map_err(not_json)?;
    if index.own_digest() != index.index_sha256 || json::pretty(&index).ok().as_deref() != Some(&text) {
        return Err(Error::bad_file(&path, "its content does not match its own digest: it was changed", FIX));
    }
    if let Some(file) = index.files.iter().find(|file| !files::stays_below(&file.path)) {
        return Err(Error::bad_file(&path, format!("it lists `{}`, outside its folder", file.path), FIX));
    }
    if let Some(entry) = index.specimens.iter().find(|entry| !is_folder_name(&entry.name)) {
        return Err(Error::bad_file(
            &path,
            format!("it names the specimen `{}`, which is no folder's name", entry.name),
            FIX,
        ));
    }
    Ok(index)
}

/// Whether a name is that of one folder in another.
fn is_folder_name(name: &str) -> bool {
    files::stays_below(name) && !name.contains('/')
}

/// Folder of a specimen in a version.
pub fn specimen_folder(version_folder: &Path, index: &AtlasIndex, name: &str) -> Result<PathBuf> {
    let known: Vec<&str> = index.specimens.iter().map(|entry| entry.name.as_str()).collect();
    if known.contains(&name) && is_folder_name(name) {
        return Ok(version_folder.join(name));
    }
    Err(Error::Call(format!(
        "{}: the atlas holds no specimen `{name}`; it holds {}",
        version_folder.display(),
        known.join(", ")
    )))
}

/// Name of the version of this number.
pub fn version_name(number: u64) -> String {
    format!("v{number:04}")
}

/// Largest number of a version: there is always a next one, however a folder is called.
const VERSION_MAX: u64 = 999_999_999;

/// Number in a version's name.
pub fn version_number(name: &str) -> Option<u64> {
    let number = name.strip_prefix('v')?.parse().ok()?;
    (number <= VERSION_MAX && version_name(number) == name).then_some(number)
}

/// Numbers of all versions present, sorted; complete or not.
pub fn version_numbers(root: &Path) -> Result<Vec<u64>> {
    let names = files::entries(root)?;
    let number = |path: &Path| path.file_name().and_then(|name| name.to_str()).and_then(version_number);
    let mut numbers: Vec<u64> = names.iter().filter_map(|(path, _)| number(path)).collect();
    numbers.sort_unstable();
    Ok(numbers)
}

/// The newest version whose index is sound and whose files are all there in their sizes; `None` for an empty atlas.
pub fn newest_version(root: &Path) -> Result<Option<(String, AtlasIndex)>> {
    search(root, &mut Vec::new())
}

/// The newest sound version; what is wrong with each newer one is added to `damage`.
fn search(root: &Path, damage: &mut Vec<String>) -> Result<Option<(String, AtlasIndex)>> {
    for number in version_numbers(root)?.into_iter().rev() {
        let name = version_name(number);
        match sound_index(&root.join(&name)) {
            Ok(index) => return Ok(Some((name, index))),
            Err(what) => damage.push(what),
        }
    }
    Ok(None)
}

/// The index of a version whose files are all there in their sizes, or what is wrong, in one line.
fn sound_index(folder: &Path) -> std::result::Result<AtlasIndex, String> {
    let index = read_index(folder).map_err(|error| error.to_string().lines().next().unwrap_or_default().to_owned())?;
    for file in &index.files {
        check_size(folder, file).map_err(|what| format!("{}: {what}", folder.join(&file.path).display()))?;
    }
    Ok(index)
}

/// Whether a file of a version is there in its size, or what is wrong with it.
pub fn check_size(version_folder: &Path, file: &FileRecord) -> std::result::Result<(), String> {
    match version_folder.join(&file.path).symlink_metadata() {
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => Err("it is missing".to_owned()),
        Err(e) => Err(format!("it cannot be read: {e}")),
        Ok(data) if !data.is_file() => Err("it is no file".to_owned()),
        Ok(data) if data.len() != file.bytes => {
            Err(format!("it has {} bytes, published were {}", data.len(), file.bytes))
        }
        Ok(_) => Ok(()),
    }
}

/// The version that a path means.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Resolved {
    /// The version's folder.
    pub folder: PathBuf,
    /// What is wrong with newer versions, newest first, which were passed over.
    pub passed_over: Vec<String>,
}

/// The version that a path means: itself where it holds an index, else the newest sound version in it.
///
/// # Errors
/// A path that is no folder, or holds no sound version.
pub fn resolve(path: &Path) -> Result<Resolved> {
    if path.join(INDEX_FILE).exists() {
        return Ok(Resolved { folder: path.to_owned(), passed_over: Vec::new() });
    }
    if !path.is_dir() {
        return Err(Error::Call(format!("{}: there is no such folder", path.display())));
    }
    let mut damage = Vec::new();
    match search(path, &mut damage)? {
        Some((name, _)) => Ok(Resolved { folder: path.join(name), passed_over: damage }),
        None if damage.is_empty() => {
            Err(Error::Call(format!("{}: this is no atlas, and holds no complete version of one", path.display())))
        }
        None => Err(Error::bad_file(path, format!("it holds no complete version: {}", damage.join("; ")), FIX)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_versions_sort_and_parse() {
        assert_eq!(version_name(1), "v0001");
        assert_eq!(version_number("v0012"), Some(12));
        assert_eq!(version_number(&version_name(123_456)), Some(123_456));
        for other in
            ["v12", "v00012", "0001", "v", "v+001", "latest", ".staging-v0001", "v18446744073709551615", "v1000000000"]
        {
            assert_eq!(version_number(other), None, "{other}");
        }
    }

    #[test]
    fn any_change_to_the_index_is_seen() {
        let folder = tempfile::tempdir().unwrap();
        let inputs = vec![InputRecord { path: "a.tif".into(), sha256: "00".into() }];
        let mut index = AtlasIndex::new("test", "11", inputs, vec![]);
        index.files = vec![FileRecord { path: "a/b".into(), bytes: 3, sha256: "22".into() }];
        write_index(folder.path(), &mut index).unwrap();
        assert_eq!(read_index(folder.path()).unwrap(), index);
        let path = folder.path().join(INDEX_FILE);
        let sound = files::read(&path).unwrap();
        for at in 0..sound.len() {
            let mut changed = sound.clone();
            changed[at] ^= 1;
            files::replace(&path, &changed).unwrap();
            assert!(read_index(folder.path()).is_err(), "byte {at}");
        }
    }

    #[test]
    fn an_index_that_points_outside_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let mut index = AtlasIndex::new("test", "", vec![], vec![]);
        index.files = vec![FileRecord { path: "../secret".into(), bytes: 3, sha256: "22".into() }];
        write_index(folder.path(), &mut index).unwrap();
        assert!(read_index(folder.path()).unwrap_err().to_string().contains("outside its folder"));
    }

    #[test]
    fn specimens_that_are_no_folders_of_the_version_are_refused() {
        for name in ["../../etc", "/etc", "a/b", "", ".", "a\\b"] {
            let folder = tempfile::tempdir().unwrap();
            let specimens = vec![SpecimenEntry { name: name.into(), species: String::new(), stale: None }];
            write_index(folder.path(), &mut AtlasIndex::new("test", "", vec![], specimens)).unwrap();
            assert!(read_index(folder.path()).unwrap_err().to_string().contains("no folder's name"), "{name}");
        }
    }

    #[test]
    fn another_schema_is_named_in_the_error() {
        let folder = tempfile::tempdir().unwrap();
        let mut index = AtlasIndex { schema: SCHEMA + 1, ..AtlasIndex::new("test", "", vec![], vec![]) };
        write_index(folder.path(), &mut index).unwrap();
        assert!(
            read_index(folder.path())
                .unwrap_err()
                .to_string()
                .contains(&format!("schema is {}, this program reads 1 to {SCHEMA}", SCHEMA + 1))
        );
    }
}
