//! Building a table set: transforms, pilot, sums over wavelengths, conversion to coefficients.

use ndarray::Array3;
use rayon::prelude::*;

use super::accumulate::{BoxFilter, GROUP, PowerSums};
use super::domain::{Domain, Hull, Texels};
use super::forecast;
use super::lobe::{PhasorPower, coherent};
use super::model::{Basis, BuildRecord, Lobe, Prefilter, TableSet, TablesConfig};
use super::plan::{self, Grid, Ring, lobe_radius, lobe_width, nodes_bound_over};
use super::sums::{Nodes, RingNodes, Sums};
use crate::ground::spectrum::{SpectralQuadrature, uniform_wavenumbers};
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::spectra::{self, SpectraConfig, bandwidth_nm};
use crate::optics::window::{Placement, placements, rms_within_nm};
use diffraction_brdf::chebyshev::{self, Interpolant};
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::{Error, Result};

/// Largest table chosen without being asked for.
pub const AUTOMATIC_SIZE_MAX: usize = 1001;

/// Share of the tolerance that the interpolation in depth may take, as an amplitude of the window's
/// whole: weak orders must keep their digits too.
const DEPTH_SHARE: f64 = 1e-3;

/// Shares of the tolerance that interpolating between texels with ranges of their own may take, in first and in second
/// order of how much the ranges differ.
const RANGE_SHARES: [f64; 2] = [0.5, 0.1];

/// Both together.
pub const RANGE_SHARE: f64 = RANGE_SHARES[0] + RANGE_SHARES[1];

/// What ranges of `t` are widened by at both ends: a look-up never lies at an end, nor is a range a point.
const RANGE_PAD: f64 = 2e-3;

/// Share of the tolerance that is left to nodes by which others are judged.
const FINE_SHARE: f64 = 0.1;

/// Receives progress: wavelengths times windows done.
pub type Advance<'a> = &'a (dyn Fn(u64) + Sync);

/// What a build will do; everything that can be known without transforming.
#[derive(Debug, Clone)]
pub struct BuildPlan {
    /// Texels of the tables.
    pub texels: Texels,
    /// The texels that are asked for, with their ranges of `t`; `None` for all of them over their whole reach.
    pub domain: Option<Domain>,
    /// Average over (u, v) of a texel.
    pub filter: BoxFilter,
    /// Rings with their wavelengths, from the outside in.
    pub rings: Vec<Ring>,
    /// Wavelengths that the rim of the disc needs.
    pub rim: SpectralQuadrature,
    /// Windows to average, by scan.
    pub windows: Vec<(usize, Placement)>,
    /// How to transform.
    pub spectra: SpectraConfig,
    /// Upper bound of the numbers of nodes in `w`.
    pub nodes_bound: usize,
    /// The `|w|` that transforms hold: those of the domain, widened to multiples of a power of two.
    pub depths: [f64; 2],
    /// Largest half range of the heights in nm.
    pub bandwidth_nm: f64,
    /// Shortest wavelength in nm.
    pub wavelength_min_nm: f64,
    /// Error left to nodes that others are judged by.
    pub fine_tolerance: f64,
    /// Radius of the coherent lobe in (u, v).
    pub lobe_radius: f64,
    /// Whether some direction asked for lies within it.
    pub lobe_seen: bool,
    /// Whether it has a cross term, which vanishes in the mean over all positions of a window.
    pub crosses: bool,
}

impl BuildPlan {
    /// The `|w|` that transforms hold and directions in a ring can have.
    pub(super) fn depths_within(&self, ring: &Ring) -> [f64; 2] {
        [self.depths[0], self.depths[1].min(max_abs_w(ring.rho[0]))]
    }

    /// Gives every ring the wavelengths of the rim: what they would be if no radius needed fewer.
    pub fn use_rim_wavelengths(&mut self) {
        self.rings.iter_mut().for_each(|ring| ring.quadrature = self.rim.clone());
    }
}

/// The grid that a configuration asks for.
pub fn grid(optics: &OpticsConfig, config: &TablesConfig) -> Grid {
    let resolving = plan::resolving_size(optics, config.tolerance);
    Grid { size: config.size.unwrap_or(resolving.min(AUTOMATIC_SIZE_MAX)), half_width: 2.0 }
}

/// Lets the ranges of a domain's texels differ so little from one to the next that interpolating between them keeps its
/// share of the tolerance: see [`Domain::with_smooth_ranges`].
///
/// Two texels whose ranges are `δ` apart in `|w|` answer for depths that differ by it. In first order they err by
/// `x (1 - x) δ` times the difference of their derivatives, a sixth of `δ` in the mean over their distance. The power
/// of heights with this rms changes with `|w|` by about `2 (k rms)² |w|` times itself, and from texel to texel by itself
/// where the grid does not resolve a lobe, less where it does. In second order they err by `δ²/8` times the second
/// derivative, at most about `(2 k rms)²` times the power.
pub fn smooth(domain: Domain, fields: &[HeightField], optics: &OpticsConfig, tolerance: f64) -> Domain {
    let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
    let middle_nm = 2.0 / (1.0 / low_nm + 1.0 / high_nm);
    let rms = fields.iter().map(rms_nm).fold(0.0, f64::max).max(1.0);
    let phase = |nm: f64| std::f64::consts::TAU / nm * rms;
    let unlike = (domain.grid.texel() / lobe_width(optics.sigma_nm, middle_nm)).min(1.0);
    let first = 6.0 * RANGE_SHARES[0] * tolerance / (2.0 * phase(middle_nm).powi(2) * unlike);
    let second = (8.0 * RANGE_SHARES[1] * tolerance).sqrt() / (2.0 * phase(low_nm));
    domain.with_smooth_ranges(RANGE_PAD, first.min(second) / max_abs_w(0.0))
}

/// Plans tables for every direction.
///
/// # Errors
/// A scan too small for the window, an invisible light, or sums beyond the allowed memory.
pub fn plan(fields: &[HeightField], optics: &OpticsConfig, config: &TablesConfig) -> Result<BuildPlan> {
    plan_for(fields, optics, config, None)
}

/// Plans tables for the directions of a domain over [`grid`], with ranges made smooth by [`smooth`]; for all where
/// there is none.
///
/// # Errors
/// As [`plan()`]; a domain that reaches nothing.
pub fn plan_for(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &TablesConfig,
    domain: Option<Domain>,
) -> Result<BuildPlan> {
    check_heights(fields)?;
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    let grid = grid(optics, config);
    let width = match config.prefilter {
        Prefilter::None => 0.0,
        Prefilter::Width(width) => width,
        Prefilter::Auto if grid.texel() > lobe_width(optics.sigma_nm, low_nm) => grid.texel(),
        Prefilter::Auto => 0.0,
    };
    let bandwidth = fields.iter().map(bandwidth_nm).fold(0.0, f64::max);
    let rho_max = 2.0 + plan::RIM_TEXELS * grid.texel();
    let (tolerance, step_nm) = (config.tolerance, config.wavelength_step_nm);
    let make_rings = if domain.is_some() { plan::fine_rings } else { plan::rings };
    let mut windows = Vec::new();
    for (scan, field) in fields.iter().enumerate() {
        windows.extend(placements(field, optics)?.into_iter().map(|placement| (scan, placement)));
    }
    roughest_first(&mut windows, fields, optics.sigma_nm);
    let whole = Hull::whole(rho_max);
    let at_rim = plan::wavelengths_of(optics, bandwidth, [rho_max; 2], tolerance, step_nm);
    let mut plan = BuildPlan {
        rim: uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, at_rim)?,
        filter: BoxFilter { width, samples: plan::box_samples(optics, width) },
        rings: make_rings(optics, bandwidth, rho_max, tolerance, step_nm)?,
        spectra: spectra_config(&whole, optics, width, config),
        depths: whole.w,
        nodes_bound: nodes_bound_over(bandwidth, low_nm, FINE_SHARE * tolerance, max_abs_w(0.0)),
        bandwidth_nm: bandwidth,
        wavelength_min_nm: low_nm,
        fine_tolerance: FINE_SHARE * tolerance,
        lobe_radius: lobe_radius(optics),
        lobe_seen: true,
        crosses: windows.iter().any(|(_, placement)| *placement != Placement::TileMean),
        windows,
        texels: Texels::whole(grid),
        domain: None,
    };
    if let Some(domain) = domain {
        forecast::join_rings(&mut plan, fields, optics, config);
        narrow(&mut plan, domain, optics, config)?;
    }
    // As few nodes as there can be; how many it will be is known later.
    check_memory(&plan.texels, config.count.unwrap_or(GROUP), 0, plan.spectra.memory_bytes)?;
    if config.basis == Basis::Chebyshev {
        // Windows of one scan are alike.
        for (scan, field) in fields.iter().enumerate() {
            if let Some((_, placement)) = plan.windows.iter().find(|window| window.0 == scan) {
                spectra::check_memory(field, *placement, optics, &plan.spectra)?;
            }
        }
    }
    Ok(plan)
}

/// Leaves out of a plan for every direction what a domain does not ask for.
///
/// What remains of the rings, of depths and of the transforms' nodes is cut at places that do not move with every texel of
/// the domain: sums then are what they were for a domain that differs little, bit for bit.
fn narrow(plan: &mut BuildPlan, domain: Domain, optics: &OpticsConfig, config: &TablesConfig) -> Result<()> {
    let hull = domain.hull().ok_or_else(|| {
        Error::limit("no scene sees and lights any of this surface", "change the scene, or set tables.serve = \"all\"")
    })?;
    plan.lobe_seen = hull.rho[0] < plan.lobe_radius;
    plan.crosses &= plan.lobe_seen;
    let [mut u, mut v] = [hull.u, hull.v];
    if plan.crosses {
        // The cross term keeps its whole patch and reach in depth.
        let patch = plan.lobe_radius;
        [u, v] = [u, v].map(|[low, high]| [low.min(-patch), high.max(patch)]);
    } else {
        let step = max_abs_w(0.0) * (0.25 * (hull.w[1] - hull.w[0]) / max_abs_w(0.0)).max(1e-6).log2().floor().exp2();
        plan.depths = plan::widened(hull.w, step, plan.depths);
    }
    plan.spectra = spectra_config(&Hull { w: plan.depths, u, v, ..hull }, optics, plan.filter.width, config);
    plan.nodes_bound =
        nodes_bound_over(plan.bandwidth_nm, plan.wavelength_min_nm, plan.fine_tolerance, hull.w[1] - hull.w[0]);
    plan.rings = plan::reached_rings(std::mem::take(&mut plan.rings), &domain);
    plan.texels = Texels::reached(&domain);
    plan.domain = Some(domain);
    Ok(())
}

/// Refuses sums over so many nodes, and tables beside them, that exceed the memory allowed.
fn check_memory(texels: &Texels, nodes: usize, tables: usize, memory_bytes: u64) -> Result<()> {
    let numbers = 3 * (nodes.next_multiple_of(GROUP) + tables) as u64;
    let bytes = texels.window_texels() as u64 * size_of::<f32>() as u64 * numbers;
    if bytes <= memory_bytes {
        return Ok(());
    }
    let besides = if tables > 0 { format!(" and {tables} tables") } else { String::new() };
    Err(Error::limit(
        format!(
            "sums over {} x {} texels{besides} need {} MiB, {} MiB are allowed",
            texels.columns.len(),
            texels.rows.len(),
            bytes >> 20,
            memory_bytes >> 20
        ),
        "lower tables.size, fix tables.count, or raise tables.memory_mib",
    ))
}

/// Puts the window with the highest relief first: the pilot looks at that one alone, and none asks for more depths.
fn roughest_first(windows: &mut [(usize, Placement)], fields: &[HeightField], sigma_nm: f64) {
    if windows.len() < 2 {
        return;
    }
    let rms_nm: Vec<f64> =
        windows.par_iter().map(|&(scan, placement)| rms_within_nm(&fields[scan], placement, sigma_nm)).collect();
    // Of equal ones the first.
    let roughest = (0..windows.len()).rev().max_by(|&a, &b| rms_nm[a].total_cmp(&rms_nm[b])).unwrap_or(0);
    windows[..=roughest].rotate_right(1);
}

/// Depths and frequencies that a hull of directions asks for at the light's wavelengths.
fn spectra_config(hull: &Hull, optics: &OpticsConfig, width: f64, config: &TablesConfig) -> SpectraConfig {
    let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
    let tau = std::f64::consts::TAU;
    // The farther end of an interval is reached by the shortest wavelength.
    let frequencies = |[low, high]: [f64; 2]| {
        let (low, high) = (low - 0.5 * width, high + 0.5 * width);
        [low / if low < 0.0 { low_nm } else { high_nm }, high / if high > 0.0 { low_nm } else { high_nm }]
    };
    SpectraConfig {
        s: [tau / high_nm * hull.w[0], tau / low_nm * hull.w[1]],
        frequency: [frequencies(hull.u), frequencies(hull.v)],
        tolerance: DEPTH_SHARE * config.tolerance,
        memory_bytes: (config.memory_mib as u64) << 20,
    }
}

/// Half range of the heights beyond which no surface is meant: phases of 3000 rad at the shortest visible
/// wavelength. Counting the nodes alone would take for ever long before the memory's limit is reached.
const BANDWIDTH_MAX_NM: f64 = 1e5;

/// Refuses heights that are not numbers, or that cannot be a relief that diffracts.
fn check_heights(fields: &[HeightField]) -> Result<()> {
    for (scan, field) in fields.iter().enumerate() {
        if let Some(((row, column), height)) = field.heights_nm.indexed_iter().find(|(_, h)| !h.is_finite()) {
            return Err(Error::limit(
                format!("scan {} holds a height of {height} nm at row {row}, column {column}", scan + 1),
                "fill or cut out missing samples before tables are built",
            ));
        }
        let half_range = bandwidth_nm(field);
        if half_range > BANDWIDTH_MAX_NM {
            return Err(Error::limit(
                format!(
                    "scan {} is {:.3e} nm from valley to peak, {:.0e} nm are the most",
                    scan + 1,
                    2.0 * half_range,
                    2.0 * BANDWIDTH_MAX_NM
                ),
                "check the unit of height, or clip outliers with despike",
            ));
        }
    }
    Ok(())
}

/// Builds the tables of one specimen from its prepared scans, for every direction.
///
/// # Errors
/// Those of [`plan()`], transforms beyond the allowed memory, and for `Basis::Taylor` those of
/// [`super::taylor::build_taylor`].
pub fn build(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &TablesConfig,
    advance: Advance,
) -> Result<(TableSet, BuildRecord)> {
    build_planned(fields, optics, config, &plan(fields, optics, config)?, advance)
}

/// Builds what [`plan_for`] planned for the same scans and settings.
///
/// # Errors
/// As [`build`].
pub fn build_planned(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &TablesConfig,
    plan: &BuildPlan,
    advance: Advance,
) -> Result<(TableSet, BuildRecord)> {
    match config.basis {
        Basis::Chebyshev => build_chebyshev(fields, optics, config, plan, advance),
        Basis::Taylor => super::taylor::build_taylor(fields, optics, config, advance),
    }
}

fn build_chebyshev(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &TablesConfig,
    plan: &BuildPlan,
    advance: Advance,
) -> Result<(TableSet, BuildRecord)> {
    let mut state: Option<Sums> = None;
    let mut phasors = plan.lobe_seen.then(|| PhasorPower::new(plan.spectra.s, plan.bandwidth_nm));
    let share = 1.0 / plan.windows.len() as f64;
    for &(scan, placement) in &plan.windows {
        let spectra = spectra::transform(&fields[scan], placement, optics, &plan.spectra)?;
        let sums = match &mut state {
            Some(sums) => sums,
            None => {
                let nodes = Nodes::choose(&spectra, plan, config);
                check_memory(&plan.texels, nodes.most(), nodes.tables, plan.spectra.memory_bytes)?;
                state.insert(Sums::new(plan, optics, nodes)?)
            }
        };
        sums.add(&spectra, plan, share, advance);
        if let Some(phasors) = &mut phasors {
            phasors.add(&spectra, share);
        }
    }
    let Some(sums) = state else {
        return Err(Error::Call("a specimen needs at least one scan".into()));
    };
    let lobe = match &phasors {
        None => None,
        Some(power) => Some(Lobe {
            coherent: coherent(
                power,
                optics,
                plan.lobe_radius,
                lobe_depths(plan),
                fields.iter().map(rms_nm).fold(0.0, f64::max),
                config.tolerance,
            )?,
            radius_max: plan.lobe_radius,
            cross: sums.cross_tables(),
        }),
    };
    let set = TableSet {
        basis: Basis::Chebyshev,
        tables: to_tables(
            &sums.main,
            &plan.texels,
            plan.domain.as_ref(),
            &plan.rings,
            &sums.nodes.rings,
            sums.nodes.tables,
        ),
        lobe,
        prefilter_width: plan.filter.width,
        front_factor: optics.front_factor(),
        served: plan.domain.as_ref().and_then(Domain::served),
        usable_radius: fields.iter().map(|f| plan::usable_radius(optics, f.pitch_nm)).fold(2.0, f64::min),
    };
    let record = BuildRecord {
        transforms: fields.iter().map(|field| spectra::nodes_for(field, &plan.spectra)).max().unwrap_or(0),
        windows: plan.windows.len(),
        node_samples: node_samples(plan, &sums.nodes),
        ..record(plan)
    };
    Ok((set, record))
}

/// The `t` that directions within the lobe have.
pub(super) fn lobe_depths(plan: &BuildPlan) -> [f64; 2] {
    plan.domain.as_ref().and_then(|domain| domain.t_inside(plan.lobe_radius)).unwrap_or([0.0, 1.0])
}

/// Values at a ring's nodes of `w` to coefficients of `T_n(2t - 1)` over each texel's range.
pub(super) fn to_tables(
    sums: &PowerSums,
    texels: &Texels,
    domain: Option<&Domain>,
    rings: &[Ring],
    nodes: &[RingNodes],
    count: usize,
) -> Vec<Array3<f32>> {
    let width = texels.columns.len();
    let t_nodes = chebyshev::gauss_nodes(count, 0.0, 1.0);
    let matrix = chebyshev::coefficient_matrix(count).concat();
    let interpolants: Vec<Interpolant> =
        nodes.iter().map(|nodes| Interpolant::new(nodes.count, nodes.w[0], nodes.w[1])).collect();
    let row_length = width * 3;
    let mut tables: Vec<Vec<f32>> = (0..count).map(|_| vec![0.0; texels.rows.len() * row_length]).collect();
    // Each row of all tables together, so that rows are written side by side and no copy is held.
    let mut rows: Vec<Vec<&mut [f32]>> = texels.rows.clone().map(|_| Vec::with_capacity(count)).collect();
    for table in &mut tables {
        rows.iter_mut().zip(table.chunks_exact_mut(row_length)).for_each(|(row, part)| row.push(part));
    }
    rows.par_iter_mut().enumerate().for_each(|(line, out)| {
        let row = texels.rows.start + line;
        let mut at_t = vec![0.0; 3 * count];
        let mut coefficients = vec![0.0; 3 * count];
        for (ring, interpolant) in rings.iter().zip(&interpolants) {
            let mut weights = vec![0.0; interpolant.nodes().len()];
            for column in texels.runs_in(row, ring.rho).into_iter().flatten() {
                let index = column - texels.columns.start;
                let [low, high] = match domain {
                    None => [0.0, max_abs_w(texels.grid.u(column).hypot(texels.grid.v(row)))],
                    Some(domain) => domain.w_at(row, column, domain.range(row, column)),
                };
                let values = &sums.data[(line * width + index) * 3 * sums.nodes..][..3 * sums.nodes];
                for (place, t) in t_nodes.iter().enumerate() {
                    interpolant.weights_into(low + t * (high - low), &mut weights);
                    for (channel, values) in values.chunks_exact(sums.nodes).enumerate() {
                        at_t[channel * count + place] = dot(&weights, values);
                    }
                }
                for (channel, at_t) in at_t.chunks_exact(count).enumerate() {
                    for (n, row) in matrix.chunks_exact(count).enumerate() {
                        coefficients[channel * count + n] = row.iter().zip(at_t).map(|(m, v)| m * v).sum();
                    }
                }
                for (channel, coefficients) in coefficients.chunks_exact(count).enumerate() {
                    for (out, &coefficient) in out.iter_mut().zip(coefficients) {
                        out[index * 3 + channel] = coefficient as f32;
                    }
                }
            }
        }
    });
    let array = |table| {
        Array3::from_shape_vec((texels.rows.len(), width, 3), table).expect("one number for each texel and channel")
    };
    tables.into_iter().map(array).collect()
}

fn dot(weights: &[f64], values: &[f32]) -> f64 {
    weights.iter().zip(values).map(|(weight, &value)| weight * f64::from(value)).sum()
}

/// Root mean square of the heights about their mean, in nm.
pub fn rms_nm(field: &HeightField) -> f64 {
    let mean = field.heights_nm.mean().unwrap_or(0.0);
    let variance = field.heights_nm.iter().map(|h| (h - mean).powi(2)).sum::<f64>();
    (variance / field.heights_nm.len().max(1) as f64).sqrt()
}

/// Texels times wavelengths of each ring.
pub fn ring_samples(plan: &BuildPlan) -> Vec<f64> {
    let rings = plan.rings.iter();
    let texels = |ring: &Ring| -> usize {
        let rows = plan.texels.rows.clone();
        rows.map(|row| plan.texels.runs_in(row, ring.rho).iter().map(ExactSizeIterator::len).sum::<usize>()).sum()
    };
    rings.map(|ring| texels(ring) as f64 * ring.quadrature.wavelengths_nm.len() as f64).collect()
}

/// Texels times wavelengths times nodes: what tables are summed of, in the groups that are summed together.
fn node_samples(plan: &BuildPlan, nodes: &Nodes) -> u64 {
    let groups = nodes.rings.iter().map(|nodes| nodes.count.next_multiple_of(GROUP) as f64);
    ring_samples(plan).iter().zip(groups).map(|(samples, nodes)| samples * nodes).sum::<f64>() as u64
}

/// Counts of a plan for reports.
pub(super) fn record(plan: &BuildPlan) -> BuildRecord {
    let samples = ring_samples(plan).iter().sum::<f64>() as u64;
    let mut record = BuildRecord { wavelength_step_nm: [f64::MAX, 0.0], samples, ..BuildRecord::default() };
    for ring in &plan.rings {
        let nm = &ring.quadrature.wavelengths_nm;
        record.wavelengths_max = record.wavelengths_max.max(nm.len());
        for pair in nm.windows(2) {
            let step = (pair[0] - pair[1]).abs();
            record.wavelength_step_nm[0] = record.wavelength_step_nm[0].min(step);
            record.wavelength_step_nm[1] = record.wavelength_step_nm[1].max(step);
        }
    }
    record.wavelength_step_nm[0] = record.wavelength_step_nm[0].min(record.wavelength_step_nm[1]);
    record
}
