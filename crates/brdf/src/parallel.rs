//! Work on slices: on several threads with the feature `rayon`, one item after the other without it.

use crate::error::Result;

/// Results in the order of the items; the error of one of those that failed.
#[cfg(feature = "rayon")]
pub(crate) fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> Result<R> + Send + Sync) -> Result<Vec<R>> {
    use rayon::prelude::*;
    items.par_iter().map(work).collect()
}

/// Results in the order of the items; the error of the first that failed.
#[cfg(not(feature = "rayon"))]
pub(crate) fn map<T, R>(items: &[T], work: impl Fn(&T) -> Result<R>) -> Result<Vec<R>> {
    items.iter().map(work).collect()
}
