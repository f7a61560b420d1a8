//! What long work says about its progress, whoever listens.

/// A listener; calls may come from any thread.
pub trait Progress: Sync {
    /// A stage begins, of `total` equal steps; 0 where their number is not known.
    fn stage(&self, name: &str, total: u64);
    /// So many more steps of the current stage are done.
    fn advance(&self, n: u64);
    /// A message worth reading by itself.
    fn message(&self, text: &str);
    /// The current stage ends.
    fn finish(&self);
}

/// A listener that says nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Progress for Silent {
    fn stage(&self, _name: &str, _total: u64) {}
    fn advance(&self, _n: u64) {}
    fn message(&self, _text: &str) {}
    fn finish(&self) {}
}
