//! A run: specimen by specimen from scans to a published version.
//!
//! [`pipeline`] holds the order of a run: `choose` finds what is there already, of what `made_from` says; `side_by_side` does the rest
//! on several threads, each specimen by `make`; `version` puts it all together. `specimen` holds the chain of steps of one, each a function from
//! what is known to what is known next: ingested, planned, built, stored (`build`), measured (`measure`), with spectral tables (`spectral`), described
//! (`describe`).

pub(crate) mod account;
mod build;
mod check_values;
mod choose;
mod clock;
mod describe;
pub(crate) mod job;
mod made_from;
mod make;
mod measure;
pub(crate) mod memory;
pub(crate) mod outlook;
pub mod pipeline;
pub mod reference_forecast;
mod side_by_side;
mod specimen;
mod spectral;
mod taken;
mod underway;
mod verdict;
mod version;
pub(crate) mod warnings;
pub mod whole_forecast;
