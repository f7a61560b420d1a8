//! How to read a scan, and what the caller knows of it.

use serde::{Deserialize, Serialize};

use super::unit::LengthUnit;

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
    /// How to choose a page of a file, `{}` standing for its number...
    pub page: &'static str,
    /// ...and a channel, `{}` standing for its name.
    pub channel: &'static str,
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
        page: "`page = {}`",
        channel: "`channel = \"{}\"`",
        or_accept_missing: ", or raise max_missing_share",
    };
}

/// How to read a scan, and what the caller knows that its file may not say.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadConfig {
    /// Which page of a file with several, counted from 0; `None` where there is one choice only.
    pub page: Option<usize>,
    /// Which channel of a file with several: its name or a part of it, in any case. Likewise.
    pub channel: Option<String>,
    /// Sample spacing in nm along x and y; overrules the file.
    pub pitch_nm: Option<[f64; 2]>,
    /// What the numbers mean; overrules the file.
    pub height: Option<HeightScale>,
    /// Largest accepted share of missing samples, 0 to 1. Those there are get filled in.
    pub max_missing_share: f64,
    /// Number in the file that stands for a missing sample, besides those that the file declares.
    pub missing_value: Option<f64>,
    /// The part that is kept: first column, first row, width, height, in samples of the file. `None` for all.
    pub crop: Option<[usize; 4]>,
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
            channel: None,
            pitch_nm: None,
            height: None,
            max_missing_share: 0.05,
            missing_value: None,
            crop: None,
            max_samples: 1 << 26,
            words: CallerWords::MANIFEST,
        }
    }
}
