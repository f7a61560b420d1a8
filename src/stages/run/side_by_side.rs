//! Pieces of work on several threads, and what they come to on one.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::sync_channel;
use std::thread;

/// Does `pieces` pieces of work, so many at once, and hands over on this thread what each comes to, as they are done. The first
/// error of `take` ends it: pieces under way are finished, no further one is begun.
///
/// No more results wait than there are threads, so that memory does not grow with the number of pieces.
///
/// # Errors
/// The first of `take`.
pub(super) fn side_by_side<T: Send, E>(
    pieces: usize,
    at_once: usize,
    work: impl Fn(usize) -> T + Sync,
    mut take: impl FnMut(usize, T) -> Result<(), E>,
) -> Result<(), E> {
    let next = AtomicUsize::new(0);
    let (done, finished) = sync_channel(0);
    thread::scope(|scope| {
        for _ in 0..at_once.min(pieces) {
            let done = done.clone();
            scope.spawn(|| {
                let done = done;
                loop {
                    let piece = next.fetch_add(1, Ordering::Relaxed);
                    // Nobody listens any more after an error.
                    if piece >= pieces || done.send((piece, work(piece))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(done);
        finished.into_iter().try_for_each(|(piece, value)| take(piece, value))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_piece_is_done_once_and_an_error_ends_it() {
        for at_once in [1, 3, 50] {
            let mut seen = vec![0; 20];
            let all = side_by_side(
                seen.len(),
                at_once,
                |piece| piece * piece,
                |piece, square| {
                    assert_eq!(square, piece * piece);
                    seen[piece] += 1;
                    Ok::<(), ()>(())
                },
            );
            assert_eq!((all, seen), (Ok(()), vec![1; 20]));
            let begun = AtomicUsize::new(0);
            let work = |_| begun.fetch_add(1, Ordering::Relaxed);
            assert_eq!(side_by_side(1000, at_once, work, |_, _| Err("full")), Err("full"));
            assert!(begun.into_inner() <= 2 * at_once, "of those under way each is finished, no more is begun");
        }
        assert_eq!(side_by_side(0, 4, |_| (), |_, ()| Err(())), Ok(()));
    }
}
