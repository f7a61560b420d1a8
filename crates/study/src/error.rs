//! Errors of a study: those of the library below, or of what it is lent.

/// Shorthand for results of a study.
pub type Result<T> = std::result::Result<T, Error>;

/// What can go wrong in a study.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The call, a file, the disk, or a limit.
    #[error(transparent)]
    Library(#[from] diffraction_brdf::Error),

    /// What the study was lent failed; the lender's own words.
    #[error("{0}")]
    Lent(String),
}
