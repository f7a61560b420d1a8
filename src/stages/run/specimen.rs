//! One specimen from its scans to its finished folder.

use super::build::{build, ingest, plan, store};
use super::clock::{Clock, Step};
use super::describe::{Described, describe};
use super::job::Job;
use super::measure::measure;
use super::spectral::{derived, spectral};

/// Ingested, planned, built, stored, with spectral tables, measured, described: each step takes what the one before found out.
/// Where spectral tables alone are stored, those of X, Y, Z come from them.
pub(super) fn run_specimen(job: &Job, clock: &mut Clock) -> Step<Described> {
    let ingested = ingest(job, clock)?;
    let planned = plan(job, &ingested, clock)?;
    let stored = match job.config.hold.xyz {
        false => None,
        true => {
            let built = build(&planned, clock)?;
            Some(store(job, &planned, built, clock)?)
        }
    };
    let spectral = spectral(job, &planned, clock)?;
    let stored = match (stored, &spectral) {
        (Some(stored), _) => stored,
        (None, Some(spectral)) => derived(job, &planned, spectral, clock)?,
        (None, None) => unreachable!("a specimen without tables has failed"),
    };
    let measured =
        measure(job, &ingested, &planned, stored, spectral.as_ref().map(|spectral| &spectral.tables), clock)?;
    describe(job, &ingested, &planned, measured, spectral, clock)
}
