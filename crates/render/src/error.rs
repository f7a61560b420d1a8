//! Errors of drawing: those of the library below, or the GPU's.

/// Shorthand for results of what uses a GPU.
pub type Result<T> = std::result::Result<T, Error>;

/// What can go wrong where a GPU draws.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The call, a file, the disk, or a limit.
    #[error(transparent)]
    Library(#[from] diffraction_brdf::Error),

    /// No usable GPU, or the GPU failed.
    #[error("GPU: {0}")]
    Gpu(String),
}
