//! Whole files on disk: atomic writing, durability, digests, listings of a folder.

use std::fs::{self, File, OpenOptions};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use hmac_sha256::Hash;

use crate::error::{Error, Result};

/// End of the name of a file that is still being written; it starts with a dot.
pub const PART_SUFFIX: &str = ".part";

/// All bytes of a plain file. Pipes and devices, which may never end, are refused.
pub fn read(path: &Path) -> Result<Vec<u8>> {
    check_plain(path)?;
    fs::read(path).map_err(|e| Error::disk(path, "read", e))
}

/// Refuses what is no plain file, or a link to one.
///
/// # Errors
/// [`Error::BadFile`], and [`Error::Disk`] where there is nothing.
pub fn check_plain(path: &Path) -> Result<()> {
    let found = fs::metadata(path).map_err(|e| Error::disk(path, "read", e))?;
    if found.is_file() {
        return Ok(());
    }
    let what = if found.is_dir() { "this is a folder" } else { "this is a pipe or a device, which may never end" };
    Err(Error::bad_file(path, what, "Name a file."))
}

/// All of a UTF-8 text file.
pub fn read_text(path: &Path) -> Result<String> {
    String::from_utf8(read(path)?).map_err(|e| {
        Error::bad_file(path, format!("this is not UTF-8 text: {e}"), "Restore the file from where it was written.")
    })
}

/// Replaces a file as a whole: written beside, then renamed, so that nobody ever sees half of it.
/// Its bytes may still be lost if the power fails; see [`replace_durably`].
pub fn replace(path: &Path, bytes: &[u8]) -> Result<()> {
    replace_with(path, &mut |file| file.write_all(bytes), false)
}

/// As [`replace`], of bytes that `write` writes one after another.
pub fn replace_by(path: &Path, mut write: impl FnMut(&mut dyn Write) -> std::io::Result<()>) -> Result<()> {
    replace_with(path, &mut |file| write(file), false)
}

/// As [`replace`], and on the disk when it returns.
pub fn replace_durably(path: &Path, bytes: &[u8]) -> Result<()> {
    replace_with(path, &mut |file| file.write_all(bytes), true)?;
    sync_folder(parent(path))
}

fn replace_with(path: &Path, write: &mut dyn FnMut(&mut File) -> std::io::Result<()>, durable: bool) -> Result<()> {
    let beside = part_path(path);
    let written = (|| {
        let mut file = OpenOptions::new().write(true).create_new(true).open(&beside)?;
        write(&mut file)?;
        if durable {
            file.sync_all()?;
        }
        fs::rename(&beside, path)
    })();
    written.map_err(|e| {
        // The error of interest is the one at hand; a leftover part file is only untidy.
        let _ = fs::remove_file(&beside);
        Error::disk(path, "write", e)
    })
}

/// A name in the same folder that no other writer uses, in this process or another.
fn part_path(path: &Path) -> PathBuf {
    static COUNTER: AtomicU64 = AtomicU64::new(0);
    let count = COUNTER.fetch_add(1, Ordering::Relaxed);
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    parent(path).join(format!(".{name}.{}-{count}{PART_SUFFIX}", std::process::id()))
}

fn parent(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Creates a folder and those above it.
pub fn create_folder(path: &Path) -> Result<()> {
    fs::create_dir_all(path).map_err(|e| Error::disk(path, "create the folder", e))
}

/// Gives every file below a folder a second name below another, which is made: the bytes are stored once. Where a file system
/// has no such names they are copied; gives whether nothing was.
pub fn link_tree(from: &Path, to: &Path) -> Result<bool> {
    create_folder(to)?;
    let mut linked = true;
    for (path, kind) in entries(from)? {
        let target = to.join(path.file_name().unwrap_or_default());
        if kind.is_dir() {
            linked &= link_tree(&path, &target)?;
        } else if kind.is_file() {
            linked &= link(&path, &target)?;
        }
    }
    Ok(linked)
}

/// One file, as [`link_tree`].
pub fn link(from: &Path, to: &Path) -> Result<bool> {
    match fs::hard_link(from, to) {
        Ok(()) => Ok(true),
        Err(_) => fs::copy(from, to).map(|_| false).map_err(|e| Error::disk(to, "write", e)),
    }
}

/// Waits until the bytes of a file are on the disk.
fn sync_file(path: &Path) -> Result<()> {
    let synced = OpenOptions::new().read(true).write(true).open(path).and_then(|file| file.sync_all());
    synced.map_err(|e| Error::disk(path, "bring to the disk", e))
}

/// Waits until the entries of a folder are on the disk, where the system can.
pub fn sync_folder(path: &Path) -> Result<()> {
    if cfg!(unix) {
        let synced = File::open(path).and_then(|folder| folder.sync_all());
        return synced.map_err(|e| Error::disk(path, "bring to the disk", e));
    }
    Ok(())
}

/// Waits until everything below a folder is on the disk, but for the bytes of files that `is_there` knows to be, by their paths from
/// the folder, `/` between their parts.
pub fn sync_tree(folder: &Path, is_there: &dyn Fn(&str) -> bool) -> Result<()> {
    sync_below(folder, "", is_there)
}

fn sync_below(folder: &Path, prefix: &str, is_there: &dyn Fn(&str) -> bool) -> Result<()> {
    for (path, kind) in entries(folder)? {
        let relative = format!("{prefix}{}", path.file_name().unwrap_or_default().to_string_lossy());
        if kind.is_dir() {
            sync_below(&path, &format!("{relative}/"), is_there)?;
        } else if kind.is_file() && !is_there(&relative) {
            sync_file(&path)?;
        }
    }
    sync_folder(folder)
}

/// Paths of all files below a folder, relative to it, `/` between their parts, sorted by bytes.
/// Anything but plain files and folders is an error: a link would make a digest meaningless.
pub fn list(folder: &Path) -> Result<Vec<String>> {
    let mut found = Vec::new();
    list_into(folder, "", &mut found)?;
    found.sort_unstable();
    Ok(found)
}

fn list_into(folder: &Path, prefix: &str, found: &mut Vec<String>) -> Result<()> {
    for (path, kind) in entries(folder)? {
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
            return Err(Error::bad_file(&path, "its name is not UTF-8", "Rename it."));
        };
        let relative = format!("{prefix}{name}");
        if kind.is_dir() {
            list_into(&path, &format!("{relative}/"), found)?;
        } else if kind.is_file() {
            found.push(relative);
        } else {
            return Err(Error::bad_file(&path, "this is neither a file nor a folder", "Replace it by a plain file."));
        }
    }
    Ok(())
}

/// Entries of a folder with their kinds; links are not followed. The order is the system's.
pub fn entries(folder: &Path) -> Result<Vec<(PathBuf, fs::FileType)>> {
    let listed = || -> std::io::Result<Vec<_>> {
        fs::read_dir(folder)?.map(|entry| entry.and_then(|entry| Ok((entry.path(), entry.file_type()?)))).collect()
    };
    listed().map_err(|e| Error::disk(folder, "list the folder", e))
}

/// Whether a path from a file stays below its folder: relative, `/` between plain names.
pub fn stays_below(relative: &str) -> bool {
    let plain = |part: &str| !matches!(part, "" | "." | "..") && !part.contains(['\\', ':', '\0']);
    relative.split('/').all(plain)
}

/// SHA-256 in lower-case hexadecimal.
pub fn sha256_hex(bytes: &[u8]) -> String {
    hex(&Hash::hash(bytes))
}

/// Size in bytes and SHA-256 of a file, read in pieces.
pub fn sha256_file(path: &Path) -> Result<(u64, String)> {
    let digest = || -> std::io::Result<(u64, String)> {
        let mut file = File::open(path)?;
        let mut hasher = Hash::new();
        let mut piece = vec![0; 1 << 16];
        let mut total = 0;
        loop {
            let count = file.read(&mut piece)?;
            if count == 0 {
                return Ok((total, hex(&hasher.finalize())));
            }
            hasher.update(&piece[..count]);
            total += count as u64;
        }
    };
    digest().map_err(|e| Error::disk(path, "read", e))
}

fn hex(bytes: &[u8]) -> String {
    use std::fmt::Write;
    bytes.iter().fold(String::new(), |mut text, byte| {
        write!(text, "{byte:02x}").expect("writing to a string cannot fail");
        text
    })
}

/// Bytes of a file.
///
/// # Errors
/// [`Error::Disk`] where there is none.
pub fn size(path: &Path) -> Result<u64> {
    Ok(path.metadata().map_err(|e| Error::disk(path, "read the size of", e))?.len())
}

/// Bytes of all files in a folder, not below it, with an extension.
pub fn bytes_of(folder: &Path, extension: &str) -> Result<u64> {
    let mut bytes = 0;
    for (path, kind) in entries(folder)? {
        if kind.is_file() && path.extension().is_some_and(|found| found == extension) {
            bytes += size(&path)?;
        }
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digest_meets_the_published_test_vector() {
        // FIPS 180-2, appendix B.1.
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256_hex(b"abc"), expected);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("abc");
        replace(&path, b"abc").unwrap();
        assert_eq!(sha256_file(&path).unwrap(), (3, expected.to_owned()));
    }

    #[test]
    fn replacing_leaves_one_file_and_listing_is_sorted() {
        let folder = tempfile::tempdir().unwrap();
        create_folder(&folder.path().join("b")).unwrap();
        for name in ["b/2", "b/1", "c", "b.x"] {
            replace(&folder.path().join(name), b"old").unwrap();
            replace_durably(&folder.path().join(name), b"new").unwrap();
        }
        assert_eq!(list(folder.path()).unwrap(), ["b.x", "b/1", "b/2", "c"]);
        assert_eq!(read_text(&folder.path().join("b/1")).unwrap(), "new");
        sync_tree(folder.path(), &|path| path == "c").unwrap();
    }

    #[test]
    fn a_linked_tree_holds_the_same_and_stays_when_the_first_goes() {
        let folder = tempfile::tempdir().unwrap();
        let [from, to] = ["from", "to"].map(|name| folder.path().join(name));
        create_folder(&from.join("inner")).unwrap();
        replace(&from.join("inner/a"), b"a").unwrap();
        replace(&from.join("b"), b"b").unwrap();
        assert!(link_tree(&from, &to).unwrap());
        // Replacing makes a new file, so that the other name keeps the old bytes.
        replace(&from.join("b"), b"new").unwrap();
        fs::remove_dir_all(from.join("inner")).unwrap();
        assert_eq!(list(&to).unwrap(), ["b", "inner/a"]);
        assert_eq!((read(&to.join("b")).unwrap(), read(&to.join("inner/a")).unwrap()), (b"b".to_vec(), b"a".to_vec()));
    }

    #[test]
    fn writing_into_a_missing_folder_says_where() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("missing/file");
        assert!(replace(&path, b"x").unwrap_err().to_string().contains("missing/file: cannot write"));
    }

    #[test]
    fn paths_that_leave_the_folder_are_seen() {
        assert!(stays_below("elaphe/table.000.exr"));
        for bad in ["", "/etc/passwd", "../x", "a/../x", "a//b", "./a", "a\\b", "c:/x"] {
            assert!(!stays_below(bad), "{bad}");
        }
    }
}
