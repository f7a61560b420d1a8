//! Why a scan file is refused, as long as it is not known where the file lies.

use std::path::Path;

use diffraction_brdf::error::Error;

/// Why a file is not accepted, before it is known where the file lies.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Refusal {
    pub(super) what: String,
    pub(super) fix: String,
    pub(super) limit: bool,
}

/// Result of a parsing step.
pub(super) type Parsed<T> = std::result::Result<T, Refusal>;

impl Refusal {
    pub(super) fn new(what: impl Into<String>, fix: impl Into<String>) -> Self {
        Self { what: what.into(), fix: fix.into(), limit: false }
    }

    /// Damage: nothing to be done but to fetch the file anew.
    pub(super) fn damaged(what: impl Into<String>) -> Self {
        Self::new(what, "the file is damaged or cut short: copy or export it again")
    }

    /// More samples than allowed.
    pub(super) fn too_large([nx, ny]: [u64; 2], max_samples: usize) -> Self {
        Self {
            what: format!("the file claims {nx} x {ny} samples; the limit is {max_samples}"),
            fix: "crop or bin the scan".to_owned(),
            limit: true,
        }
    }

    pub(super) fn at(self, path: &Path) -> Error {
        if self.limit {
            Error::limit(format!("{}: {}", path.display(), self.what), self.fix)
        } else {
            Error::bad_file(path, self.what, self.fix)
        }
    }
}
