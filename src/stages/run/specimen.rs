//! One specimen from its scans to its finished folder.

use super::build::{Ingested, Planned, build, ingest, more_texels, on_fewer_texels, plan, store};
use super::clock::{Clock, Step};
use super::describe::{Described, describe};
use super::job::Job;
use super::measure::measure;
use super::spectral::{derived, spectral};
use diffraction_build::tables::forecast::forecast_of;
use diffraction_build::tables::model::Basis;

/// Ingested, planned, built (on fewer texels first, where these may suffice), stored, with spectral tables, measured, described: each step takes what the one before found out.
/// Where spectral tables alone are stored, those of X, Y, Z come from them.
pub(super) fn run_specimen(job: &Job, clock: &mut Clock) -> Step<Described> {
    let ingested = ingest(job, clock)?;
    let fewer = on_fewer_texels(job, &ingested);
    let mut tables = ingested.tables.clone();
    let (mut tried, mut held) = (None, None);
    if let Some(fewer) = &fewer {
        let planned = plan(job, &ingested, fewer, clock)?;
        held = Some(job.memory.hold(held_bytes(&ingested, &planned)));
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
            held = Some(job.memory.hold(held_bytes(&ingested, &planned)));
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

/// Bytes that making the specimen holds at most: its scans, and what building takes besides.
fn held_bytes(ingested: &Ingested, planned: &Planned) -> u64 {
    let samples: usize = ingested.scans.fields.iter().map(|field| field.heights_nm.len()).sum();
    let Planned { input, plan, .. } = planned;
    let building = match input.tables.basis {
        Basis::Chebyshev => forecast_of(input, plan, rayon::current_num_threads()).memory_bytes,
        // Which no forecast knows: as much as it may take.
        Basis::Taylor => (input.tables.memory_mib as u64) << 20,
    };
    (samples * size_of::<f64>()) as u64 + building
}
