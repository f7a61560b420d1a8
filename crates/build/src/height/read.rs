//! Scan files: from the bytes of a microscope's or an image program's file to a calibrated height field.
//!
//! A scan is accepted only if both its pitch and the meaning of its numbers are known, from the file or
//! from the caller; they are never guessed. Formats are told apart by their first bytes and private
//! tags, not by their names. Every size a file claims is checked against the bytes it has before
//! anything is allocated.

mod archive;
mod ascii;
mod binary;
mod calibration;
mod channels;
mod config;
mod directory;
mod foreign;
mod free_text;
mod gsf;
mod gwy;
mod ibw;
mod imagej;
mod jpk;
pub(crate) mod missing;
mod nanoscope;
mod nid;
mod ome;
mod park;
mod refusal;
mod scan;
mod stored;
mod sur;
mod text;
mod tiff_pixels;
mod tiff_scan;
mod unit;
mod wsxm;
mod x3p;

use std::fs::File;
use std::io::Read;
use std::path::Path;

use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files::sha256_hex;

use self::refusal::{Parsed, Refusal};

pub use self::config::{CallerWords, HeightScale, ReadConfig};
pub use self::scan::{Provenance, Scan};
pub use self::unit::LengthUnit;

/// Reads a height scan: TIFF (plain, ImageJ, OME, Park Systems, JPK), Gwyddion's native files and simple fields, Nanoscope, Igor
/// binary waves, Nanosurf, Digital Surf, X3P, WSxM, or a matrix as text; `docs/formats.md` has the table.
///
/// Heights come out in nm with row 0 at the +y edge. NaN, infinities and declared no-data values are
/// missing samples, filled by the smoothest surface through their surroundings and counted.
///
/// # Errors
/// [`Error::Disk`] if the file cannot be read, [`Error::Limit`] if it is larger than
/// `config.max_samples`, [`Error::BadFile`] for everything else: damage, an unsupported kind, pictures
/// instead of heights, no calibration, too many missing samples, heights or pitches out of reason.
pub fn read_scan(path: &Path, config: &ReadConfig) -> Result<Scan> {
    let bytes = read_file(path)?;
    scan_from_bytes(path, &bytes, config)
}

/// [`read_scan`] for bytes already in memory; `path` is for messages and the file's name.
///
/// # Errors
/// As [`read_scan`], without [`Error::Disk`].
pub fn scan_from_bytes(path: &Path, bytes: &[u8], config: &ReadConfig) -> Result<Scan> {
    let file_name = path.file_name().unwrap_or(path.as_os_str());
    parse(bytes, config)
        .and_then(|raw| calibration::calibrate(raw, config))
        .map(|mut scan| {
            scan.provenance.file_name = file_name.to_string_lossy().into_owned();
            scan.provenance.sha256 = sha256_hex(bytes);
            scan
        })
        .map_err(|refusal| refusal.at(path))
}

/// Reads a regular file whole. Pipes and devices are refused: they may never end.
fn read_file(path: &Path) -> Result<Vec<u8>> {
    let cannot_read = |source| Error::disk(path, "read", source);
    let metadata = std::fs::metadata(path).map_err(cannot_read)?;
    if !metadata.is_file() {
        return Err(Error::bad_file(path, "this is not a regular file", "name a scan's file"));
    }
    let mut bytes = Vec::new();
    // One byte beyond the announced length is enough to see that the file is being written to.
    File::open(path).and_then(|file| file.take(metadata.len() + 1).read_to_end(&mut bytes)).map_err(cannot_read)?;
    if bytes.len() as u64 != metadata.len() {
        return Err(Error::bad_file(
            path,
            "the file's length changed while it was read",
            "wait until it is written, then try again",
        ));
    }
    Ok(bytes)
}

/// Reads by whichever format the content is in.
fn parse(bytes: &[u8], config: &ReadConfig) -> Parsed<stored::RawScan> {
    let raw = match bytes {
        [] => return Err(Refusal::new("the file is empty", "copy it again")),
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => tiff_scan::read(bytes, config),
        _ if bytes.starts_with(gsf::MAGIC) => gsf::read(bytes, config),
        _ if bytes.starts_with(gwy::MAGIC) => gwy::read(bytes, config),
        _ if bytes.starts_with(nid::MAGIC) => nid::read(bytes, config),
        _ if bytes.starts_with(wsxm::MAGIC) => wsxm::read(bytes, config),
        _ if bytes.starts_with(archive::MAGIC) => read_archive(bytes, config),
        _ if nanoscope::is_nanoscope(bytes) => nanoscope::read(bytes, config),
        _ if sur::is_surf(bytes) => sur::read(bytes, config),
        _ if ascii::is_matrix(bytes) => ascii::read(bytes, config),
        _ => match ibw::byte_order(bytes) {
            Some(little_endian) => ibw::read(bytes, little_endian, config),
            None => Err(foreign::refusal(bytes)),
        },
    }?;
    channels::check_name(&raw, config)?;
    Ok(raw)
}

/// A zip archive is an X3P file if it has that one's index.
fn read_archive(bytes: &[u8], config: &ReadConfig) -> Parsed<stored::RawScan> {
    let archive = archive::Archive::new(bytes)?;
    if archive.has(x3p::MAIN) { x3p::read(&archive, config) } else { Err(foreign::archive_refusal(&archive)) }
}
