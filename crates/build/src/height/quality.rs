//! What is wrong with a scan, in the user's words, and which setting mends it.
//!
//! Each check says in its file from which size on it finds its fault, and why good surfaces do not raise it.

mod advice;
mod blobs;
mod checks;
mod finding;
mod hum;
mod lines;
mod lost;
mod marks;
mod pixels;
mod prepared;
mod saturation;
mod scars;
mod shape;
mod steps;
mod verdict;

pub use self::advice::{Advice, advise};
pub use self::checks::findings;
pub use self::finding::{Fault, Finding, Remedy};
pub use self::verdict::{Grade, Verdict, scan_verdict};

#[cfg(test)]
mod tests;
