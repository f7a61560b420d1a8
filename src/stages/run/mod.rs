//! A run: specimen by specimen from scans to a published version.
//!
//! [`pipeline`] holds the loop and what concerns all specimens; `specimen` the chain of steps of one, each a function from
//! what is known to what is known next: ingested, planned, built, stored (`build`), measured (`measure`), with spectral tables (`spectral`), described
//! (`describe`).

mod build;
mod check_values;
mod clock;
mod describe;
pub(crate) mod job;
mod measure;
pub mod pipeline;
pub mod reference_forecast;
mod specimen;
mod spectral;
mod verdict;
pub(crate) mod warnings;
