//! Digests of files with the processor's own instructions: a run without anything to do reads all that a version holds.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use sha2::{Digest, Sha256};

use diffraction_brdf::atlas::FileRecord;
use diffraction_brdf::error::{Error, Result};

/// Bytes that are read at a time.
const PIECE: usize = 1 << 18;

/// Size and SHA-256 in hexadecimal of a file: what [`diffraction_brdf::files::sha256_file`] gives, several times as fast.
pub(crate) fn sha256_file(path: &Path) -> Result<(u64, String)> {
    let digest = || -> std::io::Result<(u64, String)> {
        let mut file = File::open(path)?;
        let (mut hasher, mut piece, mut total) = (Sha256::new(), vec![0; PIECE], 0);
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

/// Size and digest of one file below a folder.
pub(crate) fn record_file(folder: &Path, path: String) -> Result<FileRecord> {
    let (bytes, sha256) = sha256_file(&folder.join(&path))?;
    Ok(FileRecord { path, bytes, sha256 })
}

fn hex(digest: &[u8]) -> String {
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digests_are_those_of_the_atlas() {
        let folder = tempfile::tempdir().unwrap();
        for length in [0, 1, 63, 64, PIECE - 1, PIECE, 2 * PIECE + 17] {
            let bytes: Vec<u8> = (0..length).map(|n| (n * n % 251) as u8).collect();
            std::fs::write(folder.path().join("a"), &bytes).unwrap();
            let expected = diffraction_brdf::atlas::record_file(folder.path(), "a".into()).unwrap();
            assert_eq!(record_file(folder.path(), "a".into()).unwrap(), expected);
        }
        assert!(sha256_file(&folder.path().join("none")).is_err());
    }
}
