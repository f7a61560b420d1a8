//! Errors of the program, and the exit status that each calls for.

use std::path::Path;

/// Shorthand for results of the program.
pub type Result<T> = std::result::Result<T, Error>;

/// Everything that can go wrong in the program, sorted by who can put it right.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The call, a file, the disk, or a limit.
    #[error(transparent)]
    Library(#[from] diffraction_brdf::Error),

    /// No usable GPU, the GPU failed, or a shader has no form for one.
    #[error("GPU: {0}")]
    Gpu(String),

    /// The manifest is wrong; `excerpt` shows the line with a caret below it.
    #[error("{file}:{line}:{column}: {message}\n{excerpt}")]
    Manifest {
        /// The manifest's path as the user gave it.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column in characters, from 1.
        column: usize,
        /// The key, what was found and what was expected.
        message: String,
        /// The offending line and a caret, ready to print.
        excerpt: String,
    },
}

/// Exit status of what is worth trying again: `EX_TEMPFAIL` of sysexits.h, which schedulers know.
pub const RETRY: u8 = 75;

impl From<diffraction_render::error::Error> for Error {
    fn from(error: diffraction_render::error::Error) -> Self {
        match error {
            diffraction_render::error::Error::Library(error) => Self::Library(error),
            diffraction_render::error::Error::Gpu(what) => Self::Gpu(what),
        }
    }
}

impl Error {
    /// Whether the operating system refused to read or write something in this folder.
    pub fn is_of_disk_below(&self, folder: &Path) -> bool {
        matches!(self, Self::Library(error) if error.is_of_disk_below(folder))
    }

    /// The process's exit status: 2 for a wrong call or manifest, [`RETRY`] for what may succeed when it is tried again, 1 otherwise.
    pub fn exit_status(&self) -> u8 {
        match self {
            Self::Manifest { .. } | Self::Library(diffraction_brdf::Error::Call(_)) => 2,
            Self::Library(error) if error.is_worth_retrying() => RETRY,
            _ => 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::Error as Library;
    use diffraction_render::error::Error as Render;

    #[test]
    fn what_comes_from_below_keeps_its_words_and_its_status() {
        let disk = || Library::disk(Path::new("/atlas/v0001"), "write", std::io::ErrorKind::StorageFull.into());
        let cases: [(Error, String, u8); 6] = [
            (Library::Call("no such scene".into()).into(), "no such scene".into(), 2),
            (Library::limit("too much", "ask for less").into(), "too much\n  ask for less".into(), 1),
            (disk().into(), disk().to_string(), RETRY),
            (
                Library::disk(Path::new("/a"), "read", std::io::ErrorKind::NotFound.into()).into(),
                "/a: cannot read: entity not found".into(),
                1,
            ),
            (Render::from(Library::Call("no such scene".into())).into(), "no such scene".into(), 2),
            (Render::Gpu("lost".into()).into(), "GPU: lost".into(), 1),
        ];
        for (error, text, status) in cases {
            assert_eq!((error.to_string(), error.exit_status()), (text, status));
        }
        assert!(Error::from(Render::from(disk())).is_of_disk_below(Path::new("/atlas")));
        assert!(!Error::from(disk()).is_of_disk_below(Path::new("/other")));
    }
}
