//! A store of intermediate results, addressed by everything they depend on.
//!
//! An entry is one file: its key, the bytes, a digest of both. A file that is not exactly that is taken for absent, as is
//! one that cannot be read; a result that cannot be kept is computed again next time. So a cache can cost time, never
//! a run, and never a value. The key names the program by its digest: another build's results are not this one's.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::SystemTime;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::stages::program;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;
use diffraction_brdf::json as json_text;

/// Layout of the entries; another number is another cache.
const FORMAT: u32 = 1;

/// First bytes of an entry.
const MAGIC: &[u8] = b"diffraction-atlas cache 1\n";

/// Length of a digest in bytes.
const DIGEST: usize = 32;

/// Ending of an entry's name, after its key.
const SUFFIX: &str = ".entry";

/// Where intermediate results are kept.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct CacheConfig {
    /// The folder.
    pub folder: PathBuf,
    /// Most that its entries may take together, in MiB; 0 keeps nothing.
    pub limit_mib: u64,
}

/// What a run found in the cache and what it had to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct CacheUse {
    /// Specimens whose tables were found.
    pub tables_found: u64,
    /// Specimens whose tables were built.
    pub tables_built: u64,
    /// Pairs of directions whose reference values were found.
    pub pairs_found: u64,
    /// Pairs of directions whose reference values were computed.
    pub pairs_computed: u64,
    /// Bytes of the entries read.
    pub bytes_read: u64,
    /// Bytes of the entries written.
    pub bytes_written: u64,
}

impl CacheUse {
    /// Together with what another specimen found; `traffic` is the run's so far.
    pub fn with(&self, other: &Self, [bytes_read, bytes_written]: [u64; 2]) -> Self {
        Self {
            tables_found: self.tables_found + other.tables_found,
            tables_built: self.tables_built + other.tables_built,
            pairs_found: self.pairs_found + other.pairs_found,
            pairs_computed: self.pairs_computed + other.pairs_computed,
            bytes_read,
            bytes_written,
        }
    }
}

/// The store, open for one run.
#[derive(Debug)]
pub(crate) struct Cache {
    /// `None` where nothing is kept.
    folder: Option<PathBuf>,
    limit_bytes: u64,
    /// Whether it has given way to what was more urgent on a full disk.
    gone: AtomicBool,
    read: AtomicU64,
    written: AtomicU64,
}

impl Cache {
    /// A cache that keeps and knows nothing.
    pub fn off() -> Self {
        Self { folder: None, limit_bytes: 0, gone: false.into(), read: 0.into(), written: 0.into() }
    }

    /// Opens the store; one that keeps nothing where the limit is 0 or the program cannot read itself.
    pub fn open(config: &CacheConfig) -> Self {
        match (config.limit_mib, program::digest()) {
            (0, _) | (_, None) => Self::off(),
            (limit_mib, Some(_)) => Self {
                folder: Some(config.folder.clone()),
                limit_bytes: limit_mib.saturating_mul(1 << 20),
                ..Self::off()
            },
        }
    }

    /// Whether anything is kept.
    pub(crate) fn is_on(&self) -> bool {
        self.folder.is_some()
    }

    /// Removes every entry of the folder, for a disk is full, and keeps nothing from now on. Gives the bytes; `None` where there were
    /// none.
    pub(crate) fn give_way(&self, config: &CacheConfig) -> Option<u64> {
        self.gone.store(true, Ordering::Relaxed);
        clear(&config.folder).ok().map(|(_, bytes)| bytes).filter(|bytes| *bytes > 0)
    }

    /// Most bytes that the entries may take together.
    pub(crate) fn limit_bytes(&self) -> u64 {
        self.limit_bytes
    }

    /// Bytes of entries read and written so far.
    pub(crate) fn traffic(&self) -> [u64; 2] {
        [self.read.load(Ordering::Relaxed), self.written.load(Ordering::Relaxed)]
    }

    /// The key of a kind of result that depends on this program and on `parts`.
    pub fn key(&self, kind: &str, parts: &Value) -> String {
        let all = json!({ "format": FORMAT, "program": program::digest(), "kind": kind, "parts": parts });
        files::sha256_hex(json_text::canonical(&all).as_bytes())
    }

    /// The bytes kept under a key; `None` unless they are all there, unchanged.
    pub fn load(&self, key: &str) -> Option<Vec<u8>> {
        let path = self.path(key)?;
        let mut bytes = std::fs::read(&path).ok()?;
        let start = MAGIC.len() + key.len();
        let end = bytes.len().checked_sub(DIGEST).filter(|&end| end >= start)?;
        let whole = bytes.starts_with(MAGIC)
            && bytes[MAGIC.len()..start] == *key.as_bytes()
            && Sha256::digest(&bytes[..end])[..] == bytes[end..];
        if !whole {
            return None;
        }
        self.read.fetch_add(bytes.len() as u64, Ordering::Relaxed);
        // The time of the last use decides what goes first; without it the entry only goes sooner.
        let _ = std::fs::File::options().append(true).open(&path).and_then(|file| file.set_modified(SystemTime::now()));
        bytes.truncate(end);
        bytes.drain(..start);
        Some(bytes)
    }

    /// Keeps bytes under a key, and drops what was used longest ago where the limit is passed.
    pub(crate) fn store(&self, key: &str, value: &[u8]) {
        self.store_parts(key, &mut |take| take(value));
    }

    /// The same of a value that comes part by part, each time it is asked for the same: first for its length, then for its bytes.
    pub(crate) fn store_parts(&self, key: &str, parts: Parts) {
        let Some(path) = self.path(key) else { return };
        let mut length = MAGIC.len() + key.len() + DIGEST;
        parts(&mut |part| length += part.len());
        if length as u64 > self.limit_bytes || self.gone.load(Ordering::Relaxed) {
            return;
        }
        let write = |file: &mut dyn Write| {
            let (mut digest, mut written) = (Sha256::new(), Ok(()));
            let mut take = |part: &[u8]| {
                if written.is_ok() {
                    digest.update(part);
                    written = file.write_all(part);
                }
            };
            take(MAGIC);
            take(key.as_bytes());
            parts(&mut take);
            written.and_then(|()| file.write_all(&digest.finalize()))
        };
        let folder = path.parent().unwrap_or(Path::new("."));
        // A full disk or a folder that may not be written to: the result is computed again next time.
        if files::create_folder(folder).and_then(|()| files::replace_by(&path, write)).is_ok() {
            self.written.fetch_add(length as u64, Ordering::Relaxed);
            trim(folder, self.limit_bytes);
        }
    }

    fn path(&self, key: &str) -> Option<PathBuf> {
        Some(self.folder.as_ref()?.join(format!("{key}{SUFFIX}")))
    }
}

/// Hands a value over, part by part.
pub(crate) type Parts<'a> = &'a mut dyn FnMut(Take);

/// Takes a part of a value.
pub(crate) type Take<'a> = &'a mut dyn FnMut(&[u8]);

/// One entry on the disk.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Entry {
    used: SystemTime,
    path: PathBuf,
    bytes: u64,
}

/// The entries of a folder, the one used longest ago first; other files are nobody's concern. One that another run
/// removes meanwhile is not listed.
fn entries(folder: &Path) -> Result<Vec<Entry>> {
    let mut found = Vec::new();
    for (path, kind) in files::entries(folder)? {
        if kind.is_file()
            && is_entry(&path)
            && let Ok(about) = path.metadata()
            && let Ok(used) = about.modified()
        {
            found.push(Entry { used, path, bytes: about.len() });
        }
    }
    found.sort_unstable();
    Ok(found)
}

/// Whether a file is named as this store names entries, or what a killed run left of one.
fn is_entry(path: &Path) -> bool {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or("");
    let name = match name.strip_prefix('.') {
        Some(part) if part.ends_with(files::PART_SUFFIX) => part,
        Some(_) => return false,
        None => name,
    };
    name.get(..64).is_some_and(|key| key.bytes().all(|b| b.is_ascii_hexdigit())) && name[64..].starts_with(SUFFIX)
}

fn trim(folder: &Path, limit_bytes: u64) {
    let Ok(found) = entries(folder) else { return };
    let mut total: u64 = found.iter().map(|entry| entry.bytes).sum();
    for entry in found {
        if total <= limit_bytes {
            return;
        }
        // Another run may have been faster.
        let _ = std::fs::remove_file(&entry.path);
        total -= entry.bytes;
    }
}

/// Number and bytes of the entries in a folder, which need not exist.
///
/// # Errors
/// A folder that cannot be listed.
pub fn size(folder: &Path) -> Result<(usize, u64)> {
    if !folder.exists() {
        return Ok((0, 0));
    }
    let found = entries(folder)?;
    Ok((found.len(), found.iter().map(|entry| entry.bytes).sum()))
}

/// Removes all entries and tells what [`size`] was; other files in the folder stay.
///
/// # Errors
/// The disk's.
pub fn clear(folder: &Path) -> Result<(usize, u64)> {
    let before = size(folder)?;
    if before.0 > 0 {
        for entry in entries(folder)? {
            match std::fs::remove_file(&entry.path) {
                Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
                    return Err(Error::disk(&entry.path, "remove", e));
                }
                _ => {}
            }
        }
    }
    Ok(before)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cache(folder: &Path, limit_mib: u64) -> Cache {
        Cache::open(&CacheConfig { folder: folder.to_owned(), limit_mib })
    }

    #[test]
    fn what_was_stored_is_found_under_its_key_alone() {
        let folder = tempfile::tempdir().unwrap();
        let cache = cache(folder.path(), 1);
        let [one, other] = [1, 2].map(|part| cache.key("kind", &json!({ "part": part })));
        assert_ne!(one, cache.key("another kind", &json!({ "part": 1 })));
        assert_eq!(cache.load(&one), None);
        cache.store(&one, b"value");
        assert_eq!(cache.load(&one).unwrap(), b"value");
        assert_eq!(cache.load(&other), None);
        // An entry under a name that is not its key.
        std::fs::rename(cache.path(&one).unwrap(), cache.path(&other).unwrap()).unwrap();
        assert_eq!(cache.load(&other), None);
    }

    #[test]
    fn every_damage_is_seen() {
        let folder = tempfile::tempdir().unwrap();
        let cache = cache(folder.path(), 1);
        let key = cache.key("kind", &json!(null));
        cache.store(&key, b"value");
        let path = cache.path(&key).unwrap();
        let good = std::fs::read(&path).unwrap();
        for at in 0..good.len() {
            let mut bad = good.clone();
            bad[at] ^= 1;
            std::fs::write(&path, &bad).unwrap();
            assert_eq!(cache.load(&key), None, "byte {at}");
            std::fs::write(&path, &good[..at]).unwrap();
            assert_eq!(cache.load(&key), None, "cut to {at} bytes");
        }
        std::fs::write(&path, &good).unwrap();
        assert_eq!(cache.load(&key).unwrap(), b"value");
    }

    #[test]
    fn what_was_used_longest_ago_goes_first_and_other_files_stay() {
        let folder = tempfile::tempdir().unwrap();
        let cache = cache(folder.path(), 1);
        let mine = folder.path().join("notes.txt");
        std::fs::write(&mine, vec![0; 2 << 20]).unwrap();
        let keys: Vec<String> = (0..3).map(|part| cache.key("kind", &json!(part))).collect();
        let pause = || std::thread::sleep(std::time::Duration::from_millis(20));
        for key in &keys[..2] {
            cache.store(key, &vec![7; 400 << 10]);
            pause();
        }
        assert!(cache.load(&keys[0]).is_some());
        pause();
        cache.store(&keys[2], &vec![7; 400 << 10]);
        assert_eq!([0, 1, 2].map(|n| cache.load(&keys[n]).is_some()), [true, false, true]);
        // What alone is too large displaces nothing.
        cache.store(&keys[1], &vec![7; 2 << 20]);
        assert_eq!(size(folder.path()).unwrap().0, 2);
        assert_eq!(clear(folder.path()).unwrap().0, 2);
        assert_eq!(size(folder.path()).unwrap(), (0, 0));
        assert!(mine.exists());
    }

    #[test]
    fn two_writers_leave_one_whole_entry() {
        let folder = tempfile::tempdir().unwrap();
        let caches = [cache(folder.path(), 1), cache(folder.path(), 1)];
        let key = caches[0].key("kind", &json!(null));
        std::thread::scope(|scope| {
            for (cache, byte) in caches.iter().zip([1, 2]) {
                let key = &key;
                scope.spawn(move || (0..50).for_each(|_| cache.store(key, &vec![byte; 10_000])));
            }
            for _ in 0..100 {
                if let Some(value) = caches[0].load(&key) {
                    assert!(value.len() == 10_000 && value.iter().all(|byte| *byte == value[0]));
                }
            }
        });
        assert!(caches[1].load(&key).is_some());
        assert_eq!(files::entries(folder.path()).unwrap().len(), 1, "no leftovers");
    }

    #[test]
    fn a_cache_that_is_off_or_cannot_be_written_is_no_error() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        std::fs::write(&file, b"").unwrap();
        for cache in [cache(&folder.path().join("none"), 0), cache(&file, 1)] {
            let key = cache.key("kind", &json!(null));
            cache.store(&key, b"value");
            assert_eq!(cache.load(&key), None);
        }
        assert_eq!(size(&folder.path().join("none")).unwrap(), (0, 0));
    }
}
