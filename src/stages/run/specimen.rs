//! One specimen from its scans to its finished folder.

use super::build::{build, ingest, more_texels, on_fewer_texels, plan, store};
use super::clock::{Clock, Step};
use super::describe::{Described, describe};
use super::job::Job;
use super::measure::measure;
use super::spectral::{derived, spectral};

/// Ingested, planned, built (on fewer texels first, where these may suffice), stored, with spectral tables, measured, described: each step takes what the one before found out.
/// Where spectral tables alone are stored, those of X, Y, Z come from them.
pub(super) fn run_specimen(job: &Job, clock: &mut Clock) -> Step<Described> {
    let ingested = ingest(job, clock)?;
    let fewer = on_fewer_texels(job, &ingested);
    let mut tables = ingested.tables.clone();
    let mut tried = None;
    if let Some(fewer) = &fewer {
        let planned = plan(job, &ingested, fewer, clock)?;
        let built = build(&planned, clock)?;
        tables.size = more_texels(&built, &planned, clock)?;
        tried = Some((planned, built)).filter(|_| tables.size == fewer.size);
    }
    let (planned, stored) = match tried {
        Some((planned, built)) => {
            let stored = store(job, &planned, built, clock)?;
            (planned, Some(stored))
        }
        None => {
            let planned = plan(job, &ingested, &tables, clock)?;
            let stored = match job.config.hold.xyz {
                false => None,
                true => {
                    let built = build(&planned, clock)?;
                    Some(store(job, &planned, built, clock)?)
                }
            };
            (planned, stored)
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
