//! One specimen from its scans to its finished folder.

use super::account::account_of;
use super::build::{Ingested, Planned, build, ingest, more_texels, on_fewer_texels, plan, store};
use super::clock::{Clock, Failed, Step};
use super::describe::{Described, describe};
use super::job::Job;
use super::measure::measure;
use super::memory::Held;
use super::spectral::{derived, spectral};
use crate::stages::stage::Stage;

/// Ingested, planned, built (on fewer texels first, where these may suffice), stored, with spectral tables, measured, described: each step takes what the one before found out.
/// Where spectral tables alone are stored, those of X, Y, Z come from them.
pub(super) fn run_specimen(job: &Job, clock: &mut Clock) -> Step<Described> {
    let ingested = ingest(job, clock)?;
    let fewer = on_fewer_texels(job, &ingested);
    let mut tables = ingested.tables.clone();
    let (mut tried, mut held) = (None, None);
    if let Some(fewer) = &fewer {
        let planned = plan(job, &ingested, fewer, clock)?;
        held = Some(hold(job, &ingested, &planned)?);
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
            // Given back before more is asked for: else two could wait for each other.
            drop(held.take());
            held = Some(hold(job, &ingested, &planned)?);
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
    let described = describe(job, &ingested, &planned, measured, spectral, clock);
    drop(held);
    described
}

/// Waits until there is room for the specimen.
///
/// # Errors
/// One that there will never be room for.
fn hold<'a>(job: &Job<'a>, ingested: &Ingested, planned: &Planned) -> Step<Held<'a>> {
    let account = account_of(job.config, &planned.input, &planned.plan, planned.asked, &ingested.scenes);
    let fits = account.and_then(|account| account.check(job.config, job.memory.most_bytes()).map(|()| account));
    let account = fits.map_err(|error| Failed { stage: Stage::Plan, error })?;
    Ok(job.memory.hold(account.most().1))
}
