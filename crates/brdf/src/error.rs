//! Errors by whose fault they are: the call, a file, the disk, or a limit.

use std::path::{Path, PathBuf};

/// Shorthand for results of this crate.
pub type Result<T> = std::result::Result<T, Error>;

/// Everything that can go wrong, sorted by who can put it right.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// What was asked for is wrong.
    #[error("{0}")]
    Call(String),

    /// A file is damaged or does not hold what it must; `fix` says what to do about it.
    #[error("{}: {what}\n  {fix}", path.display())]
    BadFile {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        what: String,
        /// What the user can do, naming manifest keys where they help.
        fix: String,
    },

    /// The operating system refused to read or write.
    #[error("{}: cannot {doing}: {source}", path.display())]
    Disk {
        /// The file or folder.
        path: PathBuf,
        /// A verb phrase: "read", "create the folder".
        doing: &'static str,
        /// The system's own message.
        source: std::io::Error,
    },

    /// Somebody else is at work who will have done; the same is worth trying again.
    #[error("{what}\n  {fix}")]
    Busy {
        /// Who is doing what.
        what: String,
        /// What to do meanwhile.
        fix: String,
    },

    /// The request is beyond what the method or the machine can do; said before computing.
    #[error("{what}\n  {fix}")]
    Limit {
        /// What was asked, with the number needed and the number allowed.
        what: String,
        /// What to change.
        fix: String,
    },
}

impl Error {
    /// A damaged or unsuitable file.
    pub fn bad_file(path: &Path, what: impl Into<String>, fix: impl Into<String>) -> Self {
        Self::BadFile { path: path.to_owned(), what: what.into(), fix: fix.into() }
    }

    /// A refusal of the operating system, with what was being done.
    pub fn disk(path: &Path, doing: &'static str, source: std::io::Error) -> Self {
        Self::Disk { path: path.to_owned(), doing, source }
    }

    /// A request beyond a limit.
    pub fn limit(what: impl Into<String>, fix: impl Into<String>) -> Self {
        Self::Limit { what: what.into(), fix: fix.into() }
    }

    /// Whether the same may succeed later without anything about it being changed: somebody else was at work, or the disk was full.
    pub fn is_worth_retrying(&self) -> bool {
        use std::io::ErrorKind::{
            Interrupted, OutOfMemory, QuotaExceeded, ResourceBusy, StaleNetworkFileHandle, StorageFull, TimedOut,
            WouldBlock,
        };
        let passes = |kind| {
            matches!(
                kind,
                Interrupted
                    | OutOfMemory
                    | QuotaExceeded
                    | ResourceBusy
                    | StaleNetworkFileHandle
                    | StorageFull
                    | TimedOut
                    | WouldBlock
            )
        };
        match self {
            Self::Busy { .. } => true,
            Self::Disk { source, .. } => passes(source.kind()),
            _ => false,
        }
    }

    /// Whether there was no room left to write to.
    pub fn is_of_full_disk(&self) -> bool {
        use std::io::ErrorKind::{QuotaExceeded, StorageFull};
        matches!(self, Self::Disk { source, .. } if matches!(source.kind(), StorageFull | QuotaExceeded))
    }

    /// Whether the operating system refused to read or write something in this folder.
    pub fn is_of_disk_below(&self, folder: &Path) -> bool {
        matches!(self, Self::Disk { path, .. } if path.starts_with(folder))
    }
}
