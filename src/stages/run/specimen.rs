//! One specimen from its scans to its finished folder.

use super::build::{build, ingest, plan, store};
use super::clock::{Clock, Step};
use super::describe::{Described, describe};
use super::job::Job;
use super::measure::measure;
use super::spectral::spectral;

/// Ingested, planned, built, stored, measured, with spectral tables, described: each step takes what the one before found out.
pub(super) fn run_specimen(job: &Job, clock: &mut Clock) -> Step<Described> {
    let ingested = ingest(job, clock)?;
    let planned = plan(job, &ingested, clock)?;
    let built = build(&planned, clock)?;
    let stored = store(job, &planned, built, clock)?;
    let measured = measure(job, &ingested, &planned, stored, clock)?;
    let spectral = spectral(job, &planned, clock)?;
    describe(job, &ingested, &planned, measured, spectral, clock)
}
