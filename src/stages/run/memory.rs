//! Memory that specimens side by side may take together.

use std::sync::{Condvar, Mutex, PoisonError};

use crate::stages::config::RunConfig;
use crate::stages::usage;

/// What may be held, and what is.
pub(crate) struct Memory {
    allowed_bytes: u64,
    /// Bytes that a single specimen may need, the program with it: what the run was told, else all that was free before it began. Once others
    /// hold some of it, less is free, and that is no reason to refuse one that may wait.
    refused_from_bytes: u64,
    held_bytes: Mutex<u64>,
    freed: Condvar,
}

/// A share of it, until dropped.
pub(super) struct Held<'a> {
    memory: &'a Memory,
    bytes: u64,
}

impl Memory {
    /// Bytes that a run may take in all: what it was told, else a share of what is free.
    pub(super) fn allowed_bytes(config: &RunConfig) -> u64 {
        config.memory_bytes.unwrap_or_else(usage::memory_to_take)
    }

    /// Bytes beyond which a specimen is refused: what the run was told, else all that is free now.
    pub(crate) fn refused_from_bytes(config: &RunConfig) -> u64 {
        config.memory_bytes.unwrap_or_else(usage::memory_free)
    }

    /// For specimens side by side, besides what the program itself holds, as things stand now.
    pub(super) fn of_run(config: &RunConfig, program_bytes: u64) -> Self {
        let allowed_bytes = Self::allowed_bytes(config).saturating_sub(program_bytes);
        Self { refused_from_bytes: Self::refused_from_bytes(config), ..Self::new(allowed_bytes) }
    }

    /// So much of it.
    fn new(allowed_bytes: u64) -> Self {
        Self { allowed_bytes, refused_from_bytes: u64::MAX, held_bytes: Mutex::new(0), freed: Condvar::new() }
    }

    /// Bytes beyond which a specimen of this run is refused.
    pub(super) fn most_bytes(&self) -> u64 {
        self.refused_from_bytes
    }

    /// Waits until so much is free, or nobody else holds any: what is larger than all of it runs alone, for whether a specimen
    /// may be so large is decided elsewhere.
    pub(super) fn hold(&self, bytes: u64) -> Held<'_> {
        let held = self.held_bytes.lock().unwrap_or_else(PoisonError::into_inner);
        let too_much = |held: &mut u64| *held > 0 && held.saturating_add(bytes) > self.allowed_bytes;
        let mut held = self.freed.wait_while(held, too_much).unwrap_or_else(PoisonError::into_inner);
        // One that takes nothing still counts as there.
        let bytes = bytes.max(1);
        *held = held.saturating_add(bytes);
        Held { memory: self, bytes }
    }
}

impl Drop for Held<'_> {
    fn drop(&mut self) {
        *self.memory.held_bytes.lock().unwrap_or_else(PoisonError::into_inner) -= self.bytes;
        self.memory.freed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering};

    use super::*;

    #[test]
    fn no_more_is_held_than_allowed_but_by_one_alone() {
        let memory = Memory::new(10);
        let (now, most) = (AtomicU64::new(0), AtomicU64::new(0));
        std::thread::scope(|scope| {
            for n in 0..40u64 {
                let (memory, now, most) = (&memory, &now, &most);
                scope.spawn(move || {
                    let bytes = if n % 10 == 9 { 25 } else { 3 + n % 3 };
                    let held = memory.hold(bytes);
                    let sum = now.fetch_add(bytes, Ordering::SeqCst) + bytes;
                    assert!(sum <= 10 || sum == bytes, "{sum}");
                    most.fetch_max(sum, Ordering::SeqCst);
                    std::thread::yield_now();
                    now.fetch_sub(bytes, Ordering::SeqCst);
                    drop(held);
                });
            }
        });
        assert_eq!((most.into_inner(), *memory.held_bytes.lock().unwrap()), (25, 0));
    }
}
