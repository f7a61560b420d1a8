//! Scan files: from the bytes of a microscope's or an image program's file to a calibrated height field.
//!
//! A scan is accepted only if both its pitch and the meaning of its numbers are known, from the file or
//! from the caller; they are never guessed. Formats are told apart by their first bytes and private
//! tags, not by their names. Every size a file claims is checked against the bytes it has before
//! anything is allocated.

mod calibration;
mod directory;
mod free_text;
mod gsf;
mod imagej;
mod jpk;
mod missing;
mod ome;
mod park;
mod stored;
mod tiff_pixels;
mod tiff_scan;
mod unit;

use std::fs::File;
use std::io::Read;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::height::HeightField;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files::sha256_hex;

pub use unit::LengthUnit;

/// What a file's numbers mean, said by the caller.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum HeightScale {
    /// Height in nm of the whole range of an integer type: its smallest value is 0 nm, its largest
    /// this. Refused for floating-point samples, which have no such range.
    FullScaleNm(f64),
    /// The file's numbers are heights in this unit. Where the file has its own straight line from
    /// samples to numbers (ImageJ's `c0` and `c1`, Park's gain, JPK's slot), that line applies first.
    Unit(LengthUnit),
    /// `height = nm_per_count * sample + offset_nm`, of the samples as they are stored.
    Linear {
        /// Height of one count in nm; not zero.
        nm_per_count: f64,
        /// Height of sample value 0 in nm.
        offset_nm: f64,
    },
}

/// What messages and provenance call the things that a caller can say of a scan: keys of a manifest, or whatever else the
/// user has at hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CallerWords {
    /// Where the user says it.
    pub source: &'static str,
    /// Sample spacing.
    pub pitch: &'static str,
    /// What to do where the file does not tell the spacing.
    pub add_pitch: &'static str,
    /// What the numbers mean.
    pub height: &'static str,
    /// What to do where the file does not tell what its integers mean...
    pub add_integer_height: &'static str,
    /// ...and its floating-point numbers.
    pub add_float_height: &'static str,
    /// Where more missing samples may be accepted, as the end of a sentence; empty where they may not.
    pub or_accept_missing: &'static str,
}

impl CallerWords {
    /// A specimen's keys in a manifest.
    pub const MANIFEST: Self = Self {
        source: "manifest",
        pitch: "pitch_nm",
        add_pitch: "add `pitch_nm = N` (or `pitch_nm = [X, Y]`, nm per sample) to the specimen",
        height: "height",
        add_integer_height: "add `height = { full_scale_nm = N }` (nm from the smallest to the largest value of the integer \
                             type) or `height = { nm_per_count = N, offset_nm = M }` to the specimen",
        add_float_height: "add `height = { unit = \"U\" }` to the specimen, U being pm, nm, um, mm, cm, m, angstrom or inch",
        or_accept_missing: ", or raise max_missing_share",
    };
}

/// How to read a scan, and what the caller knows that its file may not say.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadConfig {
    /// Which page of a file with several, counted from 0; `None` where there is one choice only.
    pub page: Option<usize>,
    /// Sample spacing in nm along x and y; overrules the file.
    pub pitch_nm: Option<[f64; 2]>,
    /// What the numbers mean; overrules the file.
    pub height: Option<HeightScale>,
    /// Largest accepted share of missing samples, 0 to 1. Those there are get filled in.
    pub max_missing_share: f64,
    /// Largest accepted number of samples: bounds the memory, about 60 bytes each, 120
    /// for missing ones.
    pub max_samples: usize,
    /// What messages and provenance call all this.
    pub words: CallerWords,
}

impl Default for ReadConfig {
    fn default() -> Self {
        Self {
            page: None,
            pitch_nm: None,
            height: None,
            max_missing_share: 0.05,
            max_samples: 1 << 26,
            words: CallerWords::MANIFEST,
        }
    }
}

/// Where a height field comes from and how its numbers were understood.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Provenance {
    /// The file's name without its folder.
    pub file_name: String,
    /// SHA-256 of the whole file, hexadecimal.
    pub sha256: String,
    /// "ImageJ TIFF", "OME-TIFF", "Park TIFF", "JPK TIFF", "TIFF" or "GSF".
    pub format: String,
    /// The page read, counted from 0.
    pub page: usize,
    /// Type of the stored samples: "u8" to "u32", "i8" to "i32", "f16", "f32", "f64".
    pub sample_format: String,
    /// Samples along x and y.
    pub size: [usize; 2],
    /// Sample spacing in nm along x and y.
    pub pitch_nm: [f64; 2],
    /// Who said so: "file: ...", or the caller: "manifest: pitch_nm".
    pub pitch_from: String,
    /// Who gave the numbers their meaning: "file: ...", or the caller: "manifest: height".
    pub height_from: String,
    /// Samples that were missing and have been filled in.
    pub missing_samples: usize,
    /// The channel's name, where the file gives one.
    pub channel: Option<String>,
    /// What a careful user wants to know: overruled or contradictory statements, filled samples.
    pub warnings: Vec<String>,
}

/// A calibrated scan.
#[derive(Debug, Clone, PartialEq)]
pub struct Scan {
    /// Heights in nm, none missing.
    pub field: HeightField,
    /// Where they come from.
    pub provenance: Provenance,
}

/// Reads a height scan: TIFF (plain, ImageJ, OME, Park Systems, JPK) or Gwyddion simple field.
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

/// [`read_scan`] for bytes already in memory; `path` serves messages and the file's name.
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
        return Err(Error::bad_file(path, "this is not a regular file", "name a TIFF or .gsf file"));
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

/// Tells the format by the first bytes.
fn parse(bytes: &[u8], config: &ReadConfig) -> Parsed<stored::RawScan> {
    const EXPORT: &str = "export the height channel as a TIFF with 16-bit or floating-point samples, \
                          or as Gwyddion simple field (.gsf)";
    match bytes {
        [] => Err(Refusal::new("the file is empty", "copy it again")),
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => tiff_scan::read(bytes, config),
        _ if bytes.starts_with(gsf::MAGIC) => match config.page {
            None | Some(0) => gsf::read(bytes, config.max_samples),
            Some(page) => Err(Refusal::new(format!("a Gwyddion simple field has no page {page}"), "leave `page` out")),
        },
        _ if bytes.starts_with(b"GWYP") => Err(Refusal::new(
            "a Gwyddion native file (.gwy) is not read",
            "save the channel from Gwyddion as Gwyddion simple field (.gsf)",
        )),
        _ if bytes.starts_with(b"\x89PNG") || bytes.starts_with(b"\xff\xd8\xff") => {
            Err(Refusal::new("this is a picture (PNG or JPEG), not a height scan", EXPORT))
        }
        _ => Err(Refusal::new("neither a TIFF nor a Gwyddion simple field, going by its first bytes", EXPORT)),
    }
}

/// Why a file is not accepted, before it is known where the file lies.
#[derive(Debug, Clone, PartialEq)]
struct Refusal {
    what: String,
    fix: String,
    limit: bool,
}

/// Result of a parsing step.
type Parsed<T> = std::result::Result<T, Refusal>;

impl Refusal {
    fn new(what: impl Into<String>, fix: impl Into<String>) -> Self {
        Self { what: what.into(), fix: fix.into(), limit: false }
    }

    /// Damage: nothing to be done but to fetch the file anew.
    fn damaged(what: impl Into<String>) -> Self {
        Self::new(what, "the file is damaged or cut short: copy or export it again")
    }

    /// More samples than allowed.
    fn too_large([nx, ny]: [u64; 2], max_samples: usize) -> Self {
        Self {
            what: format!("the file claims {nx} x {ny} samples; the limit is {max_samples}"),
            fix: "crop or bin the scan".to_owned(),
            limit: true,
        }
    }

    fn at(self, path: &Path) -> Error {
        if self.limit {
            Error::limit(format!("{}: {}", path.display(), self.what), self.fix)
        } else {
            Error::bad_file(path, self.what, self.fix)
        }
    }
}
