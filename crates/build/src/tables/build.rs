//! Building a table set: transforms, order, sums over wavelengths, conversion to coefficients.

use super::accumulate::SIMD_WIDTH;
use super::coverage::ranges::Coverage;
use super::input::BuildInput;
use super::lobe::{PhasorPower, coherent};
use super::model::{Advance, Basis, BuildRecord, Lobe, TableSet};
use super::nodes::Nodes;
use super::plan::{BuildPlan, plan};
use super::sums::Sums;
use super::taylor::build_taylor;
use crate::optics::spectra;
use diffraction_brdf::error::{Error, Result};

/// Builds the tables of one specimen from its prepared scans, for every direction.
///
/// # Errors
/// Those of [`plan()`], transforms beyond the allowed memory, and for `Basis::Taylor` terms that would cancel in the wanted storage.
pub fn build(input: &BuildInput, advance: Advance) -> Result<(TableSet, BuildRecord)> {
    build_planned(input, &plan(input)?, advance)
}

/// Builds what was planned for the same input.
///
/// # Errors
/// As [`build`].
pub fn build_planned(input: &BuildInput, plan: &BuildPlan, advance: Advance) -> Result<(TableSet, BuildRecord)> {
    match input.tables.basis {
        Basis::Chebyshev => build_chebyshev(input, plan, advance),
        Basis::Taylor => build_taylor(input, plan, advance),
    }
}

/// What a build sums: tables and lobe follow from it.
pub(super) struct Summed {
    pub(super) sums: Sums,
    /// The lobe's power; `None` where no direction asked for lies in the lobe.
    pub(super) phasors: Option<PhasorPower>,
    pub(super) record: BuildRecord,
}

/// Transforms window after window, and sums.
pub(super) fn summed(input: &BuildInput, plan: &BuildPlan, advance: Advance) -> Result<Summed> {
    let mut begun: Option<Sums> = None;
    let mut phasors =
        plan.lobe_seen.then(|| PhasorPower::new(plan.spectra.phase_scale_per_nm, plan.half_height_range_nm));
    let share = 1.0 / plan.windows.len() as f64;
    for &(scan, placement) in &plan.windows {
        let spectra = spectra::transform(&input.fields[scan], placement, input.optics, &plan.spectra)?;
        let sums = match &mut begun {
            Some(sums) => sums,
            None => {
                let nodes = Nodes::choose(&spectra, input, plan);
                plan.check_sums(nodes.most(), nodes.tables)?;
                begun.insert(Sums::new(input, plan, nodes)?)
            }
        };
        sums.add(&spectra, plan, share, advance);
        if let Some(phasors) = &mut phasors {
            phasors.add(&spectra, share);
        }
    }
    let Some(sums) = begun else {
        return Err(Error::Call("a specimen needs at least one scan".into()));
    };
    let transforms = input.fields.iter().map(|field| spectra::nodes_for(field, &plan.spectra)).max();
    let record = BuildRecord {
        transforms: transforms.unwrap_or(0),
        node_samples: node_samples(plan, &sums.nodes),
        ..plan.record()
    };
    Ok(Summed { sums, phasors, record })
}

fn build_chebyshev(input: &BuildInput, plan: &BuildPlan, advance: Advance) -> Result<(TableSet, BuildRecord)> {
    let Summed { sums, phasors, record } = summed(input, plan, advance)?;
    let lobe = phasors.map(|power| -> Result<Lobe> {
        Ok(Lobe {
            coherent: coherent(&power, input, plan.lobe_radius, plan.t_in_lobe())?,
            radius_max: plan.lobe_radius,
            cross: sums.cross_tables(),
        })
    });
    let set = TableSet {
        basis: Basis::Chebyshev,
        tables: sums.tables(plan),
        lobe: lobe.transpose()?,
        prefilter_width: plan.filter.width,
        front_factor: input.optics.front_factor(),
        restriction: plan.coverage.as_ref().and_then(Coverage::range_texture),
        usable_radius: input.usable_radius(),
    };
    Ok((set, record))
}

/// Texels times wavelengths times nodes: what tables are summed of, in the groups that are summed together.
fn node_samples(plan: &BuildPlan, nodes: &Nodes) -> u64 {
    let groups = nodes.rings.iter().map(|nodes| nodes.count.next_multiple_of(SIMD_WIDTH) as f64);
    plan.ring_samples().iter().zip(groups).map(|(samples, nodes)| samples * nodes).sum::<f64>() as u64
}
