//! Verifying a version's files: digests, sizes, what is missing, what was added, and EXR headers.

use std::collections::BTreeSet;
use std::path::Path;

use rayon::prelude::*;
use serde::Serialize;

use crate::stages::archive::specimen_file;
use crate::stages::digest::sha256_file;
use diffraction_brdf::atlas::{self, FileRecord, INDEX_FILE};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::exr_image;
use diffraction_brdf::files;

/// A file that is not as it was published.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Failure {
    /// Path relative to the version's folder.
    pub file: String,
    /// What is wrong.
    pub what: String,
}

/// What was checked and what failed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct VerifyReport {
    /// Files compared with their digests, the index included.
    pub files_checked: usize,
    /// Failures, sorted by path.
    pub failures: Vec<Failure>,
}

/// Checks every file of a version. Where the index itself is damaged nothing else can be judged, and that alone is
/// reported. Errors are for folders that cannot be read at all.
pub fn verify_files(version_folder: &Path) -> Result<VerifyReport> {
    let present: BTreeSet<String> = files::list(version_folder)?.into_iter().collect();
    let index = match atlas::read_index(version_folder) {
        Ok(index) => index,
        Err(e) => {
            let failures = vec![Failure { file: INDEX_FILE.to_owned(), what: reason(&e) }];
            return Ok(VerifyReport { files_checked: 1, failures });
        }
    };
    let listed: BTreeSet<&str> = index.files.iter().map(|file| file.path.as_str()).collect();
    let check = |file: &FileRecord| check_file(version_folder, file).err();
    let mut failures: Vec<Failure> = index.files.par_iter().filter_map(check).collect();
    let added = present.iter().filter(|path| *path != INDEX_FILE && !listed.contains(path.as_str()));
    failures.extend(added.map(|path| failure(path, format!("it is not listed in {INDEX_FILE}"))));
    let is_used = |folder: &String| listed.iter().any(|path| path.starts_with(&format!("{folder}/")));
    // Specimens without scenes have an empty folder for them.
    let is_empty = |folder: &String| {
        !present.iter().any(|path| path.starts_with(&format!("{folder}/"))) && folder.ends_with("/scenes")
    };
    let foreign = folders(version_folder, "")?.into_iter().filter(|folder| !is_used(folder) && !is_empty(folder));
    failures.extend(foreign.map(|folder| failure(&folder, "the folder holds nothing that is listed in the index")));
    for entry in &index.specimens {
        let path = format!("{}/{}", entry.name, diffraction_brdf::specimen::FILE);
        if !listed.contains(path.as_str()) {
            failures.push(failure(&path, format!("the specimen is listed in {INDEX_FILE}, its file is not")));
        }
    }
    failures.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(VerifyReport { files_checked: index.files.len() + 1, failures })
}

/// All folders below one, relative to it.
fn folders(folder: &Path, prefix: &str) -> Result<Vec<String>> {
    let mut found = Vec::new();
    for (path, kind) in files::entries(folder)? {
        if kind.is_dir() {
            let name = format!("{prefix}{}", path.file_name().unwrap_or_default().to_string_lossy());
            found.extend(folders(&path, &format!("{name}/"))?);
            found.push(name);
        }
    }
    Ok(found)
}

fn failure(file: &str, what: impl Into<String>) -> Failure {
    Failure { file: file.to_owned(), what: what.into() }
}

fn check_file(version_folder: &Path, file: &FileRecord) -> std::result::Result<(), Failure> {
    let path = version_folder.join(&file.path);
    let failed = |what: String| Err(failure(&file.path, what));
    if let Err(what) = atlas::check_size(version_folder, file) {
        return failed(what);
    }
    match sha256_file(&path) {
        Err(e) => return failed(reason(&e)),
        Ok((_, sha256)) if sha256 != file.sha256 => return failed("its content does not match its digest".to_owned()),
        Ok(_) => {}
    }
    // Right by its digest, but is it readable? What was published broken is found here.
    let readable = if file.path.ends_with(".exr") {
        exr_image::check_file(&path).map(|_| ())
    } else if file.path.ends_with(&format!("/{}", diffraction_brdf::specimen::FILE)) {
        specimen_file::read(path.parent().unwrap_or(version_folder)).map(|_| ())
    } else {
        Ok(())
    };
    readable.or_else(|e| failed(reason(&e)))
}

/// The error without its path and advice, which the report has its own place for.
fn reason(error: &Error) -> String {
    match error {
        Error::BadFile { what, .. } => what.clone(),
        Error::Disk { doing, source, .. } => format!("cannot {doing} it: {source}"),
        other => other.to_string(),
    }
}
