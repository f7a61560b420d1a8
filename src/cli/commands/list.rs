//! `list`: the atlases in a folder, their versions and specimens, by what lies on disk.

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::cli::terminal;
use crate::manifest::{self, convert::run_config};
use crate::stages::run::outlook::outlook;
use diffraction_brdf::error::{Error, Result};

/// Arguments of `list`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas list out/atlas --json")]
pub(crate) struct ListArgs {
    /// A folder of atlases, or one atlas
    #[arg(default_value = "out/atlas")]
    pub folder: PathBuf,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
    /// In place of all that: the specimens that a run of this manifest would make, a name a line
    #[arg(long, value_name = "MANIFEST", conflicts_with_all = ["folder", "json"])]
    pub missing: Option<PathBuf>,
}

/// One atlas.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct AtlasListing {
    /// The atlas's name, that of its folder.
    pub name: String,
    /// The version that `latest` names; `None` where there is no such version.
    pub latest: Option<String>,
    /// Published versions, oldest first.
    pub versions: Vec<VersionListing>,
}

/// One version of an atlas.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct VersionListing {
    /// `v0001` and so on.
    pub name: String,
    /// Specimens, sorted.
    pub specimens: Vec<String>,
    /// Number of files.
    pub files: u64,
    /// What they take on disk.
    pub bytes: u64,
    /// What no other version holds too; `None` where the system does not tell.
    pub own_bytes: Option<u64>,
}

/// Lists and prints.
pub(crate) fn run(args: &ListArgs, global: &Global) -> crate::error::Result<Outcome> {
    if let Some(path) = &args.missing {
        let (manifest, text) = manifest::load(path)?;
        let missing = outlook(&run_config(manifest, text))?.into_iter().filter(|outlook| outlook.make);
        output::print(&missing.map(|outlook| outlook.name + "\n").collect::<String>())?;
        return Ok(Outcome::Done);
    }
    let atlases = list(&args.folder)?;
    if args.json {
        output::print_json(&atlases)?;
    } else {
        output::print(&render(&atlases))?;
    }
    if atlases.is_empty() && !global.quiet {
        terminal::say(&format!("no atlas in {}\n", args.folder.display()));
    }
    Ok(Outcome::Done)
}

/// The atlas that a folder is, or the atlases that it holds, sorted by name.
///
/// # Errors
/// [`Error::Call`] where there is no such folder, [`Error::Disk`] where it cannot be read.
pub(crate) fn list(folder: &Path) -> Result<Vec<AtlasListing>> {
    if !folder.is_dir() {
        return Err(Error::Call(format!("{} is not a folder", folder.display())));
    }
    if let Some(atlas) = atlas(folder)? {
        return Ok(vec![atlas]);
    }
    let mut atlases = Vec::new();
    for path in entries(folder)? {
        if path.is_dir()
            && let Some(atlas) = atlas(&path)?
        {
            atlases.push(atlas);
        }
    }
    Ok(atlases)
}

/// A folder as an atlas, if it holds any version.
fn atlas(folder: &Path) -> Result<Option<AtlasListing>> {
    let mut versions = Vec::new();
    for path in entries(folder)? {
        let name = file_name(&path);
        if is_version(&name) && path.join("atlas.json").is_file() {
            versions.push(version(&path, name)?);
        }
    }
    if versions.is_empty() {
        return Ok(None);
    }
    versions.sort_by_key(|version| (version.name.len(), version.name.clone()));
    let latest = std::fs::read_to_string(folder.join("latest")).unwrap_or_default();
    let latest = latest.trim();
    let known = versions.iter().any(|version| version.name == latest);
    let absolute = std::path::absolute(folder).map_err(|error| Error::disk(folder, "find", error))?;
    Ok(Some(AtlasListing { name: file_name(&absolute), latest: known.then(|| latest.to_owned()), versions }))
}

/// Whether a name is `v` and at least four digits.
fn is_version(name: &str) -> bool {
    name.strip_prefix('v').is_some_and(|digits| digits.len() >= 4 && digits.bytes().all(|byte| byte.is_ascii_digit()))
}

fn version(folder: &Path, name: String) -> Result<VersionListing> {
    let specimens = entries(folder)?
        .into_iter()
        .filter(|path| path.join("specimen.json").is_file())
        .map(|path| file_name(&path))
        .collect();
    let Size { files, bytes, own_bytes } = size(folder)?;
    Ok(VersionListing { name, specimens, files, bytes, own_bytes: cfg!(unix).then_some(own_bytes) })
}

/// Files below a folder; links are not followed.
#[derive(Default)]
struct Size {
    files: u64,
    bytes: u64,
    /// Of those that have no second name.
    own_bytes: u64,
}

fn size(folder: &Path) -> Result<Size> {
    let mut all = Size::default();
    for path in entries(folder)? {
        let about = path.symlink_metadata().map_err(|error| Error::disk(&path, "read", error))?;
        let Size { files, bytes, own_bytes } = match about.is_dir() {
            true => size(&path)?,
            false => {
                Size { files: 1, bytes: about.len(), own_bytes: if has_one_name(&about) { about.len() } else { 0 } }
            }
        };
        all = Size { files: all.files + files, bytes: all.bytes + bytes, own_bytes: all.own_bytes + own_bytes };
    }
    Ok(all)
}

#[cfg(unix)]
fn has_one_name(about: &std::fs::Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(about) == 1
}

#[cfg(not(unix))]
fn has_one_name(_: &std::fs::Metadata) -> bool {
    true
}

/// The entries of a folder, sorted.
fn entries(folder: &Path) -> Result<Vec<PathBuf>> {
    let unreadable = |error| Error::disk(folder, "list the folder", error);
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        paths.push(entry.map_err(unreadable)?.path());
    }
    paths.sort();
    Ok(paths)
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn render(atlases: &[AtlasListing]) -> String {
    let mut text = String::new();
    for atlas in atlases {
        text.push_str(&atlas.name);
        text.push('\n');
        for version in &atlas.versions {
            let mark = if atlas.latest.as_ref() == Some(&version.name) { " (latest)" } else { "" };
            let mut size = output::bytes_in_words(version.bytes);
            if let Some(own_bytes) = version.own_bytes.filter(|own_bytes| *own_bytes < version.bytes) {
                size += &format!(" ({} held by no other)", output::bytes_in_words(own_bytes));
            }
            let count = version.specimens.len();
            let noun = if count == 1 { "specimen" } else { "specimens" };
            let names = version.specimens.join(", ");
            text.push_str(&format!("  {}{mark}: {count} {noun}, {size}: {names}\n", version.name));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn write(folder: &Path, name: &str, bytes: usize) {
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, vec![b'x'; bytes]).unwrap();
    }

    #[test]
    fn versions_and_specimens_are_found() {
        let folder = tempfile::tempdir().unwrap();
        for (name, bytes) in [
            ("snakes/v0001/atlas.json", 10),
            ("snakes/v0001/b/specimen.json", 5),
            ("snakes/v0001/a/specimen.json", 5),
            ("snakes/v0001/a/table.000.exr", 1004),
            ("snakes/v10000/atlas.json", 1),
            ("snakes/v9999/atlas.json", 1),
            ("snakes/v0003/unfinished", 1),
            ("snakes/.staging-1/atlas.json", 1),
            ("notes/readme", 1),
        ] {
            write(folder.path(), name, bytes);
        }
        std::fs::write(folder.path().join("snakes/latest"), "v10000\n").unwrap();
        let atlases = list(folder.path()).unwrap();
        assert_eq!(atlases, list(&folder.path().join("snakes")).unwrap());
        let [snakes] = &atlases[..] else { panic!("{atlases:?}") };
        assert_eq!(snakes.latest.as_deref(), Some("v10000"));
        let versions: Vec<&str> = snakes.versions.iter().map(|version| version.name.as_str()).collect();
        assert_eq!(versions, ["v0001", "v9999", "v10000"]);
        assert_eq!(snakes.versions[0].specimens, ["a", "b"]);
        assert_eq!((snakes.versions[0].files, snakes.versions[0].bytes), (4, 1024));
        let text = render(&atlases);
        assert!(text.starts_with("snakes\n  v0001: 2 specimens, 1.0 KiB: a, b\n"), "{text}");
        assert!(text.contains("v10000 (latest): 0 specimens"), "{text}");
    }

    #[test]
    fn a_dangling_latest_is_not_repeated() {
        let folder = tempfile::tempdir().unwrap();
        write(folder.path(), "v0001/atlas.json", 1);
        std::fs::write(folder.path().join("latest"), "v0002").unwrap();
        assert_eq!(list(folder.path()).unwrap()[0].latest, None);
        assert!(matches!(list(&folder.path().join("none")), Err(Error::Call(_))));
    }
}
