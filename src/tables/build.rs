//! Building a table set: transforms, pilot, sums over wavelengths, conversion to coefficients.

use ndarray::Array3;
use rayon::prelude::*;

use super::accumulate::{BoxFilter, PowerSums, Quantity, RingSum, add_ring};
use super::lobe::{PhasorPower, coherent, patch_grid};
use super::model::{Basis, BuildRecord, Lobe, Prefilter, TableSet, TablesConfig};
use super::pilot;
use super::plan::{self, Grid, Ring, lobe_radius, lobe_width, w_reach};
use crate::ground::chebyshev::{self, Interpolant};
use crate::ground::error::{Error, Result};
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::spectra::{self, Spectra, SpectraConfig, bandwidth_nm};
use crate::optics::window::{Placement, placements};

/// Largest table chosen without being asked for.
pub const AUTOMATIC_SIZE_MAX: usize = 1001;

/// Texels beyond the rim of the disc that are filled, so that interpolation at the rim sees no zeros.
const RIM_TEXELS: f64 = 3.0;

/// Share of the tolerance that the interpolation in depth may take, as an amplitude of the window's
/// whole: weak orders must keep their digits too.
const DEPTH_SHARE: f64 = 1e-3;

/// Receives progress: wavelengths times windows done.
pub type Advance<'a> = &'a (dyn Fn(u64) + Sync);

/// What a build will do; everything that can be known without transforming.
#[derive(Debug, Clone)]
pub struct BuildPlan {
    /// Texels of the tables.
    pub grid: Grid,
    /// Average over (u, v) of a texel.
    pub filter: BoxFilter,
    /// Rings with their wavelengths, from the outside in.
    pub rings: Vec<Ring>,
    /// Windows to average, by scan.
    pub windows: Vec<(usize, Placement)>,
    /// How to transform.
    pub spectra: SpectraConfig,
    /// Upper bound of the numbers of nodes in `w`.
    pub nodes_bound: usize,
    /// Largest half range of the heights in nm.
    pub bandwidth_nm: f64,
}

/// Plans a build.
///
/// # Errors
/// A scan too small for the window, an invisible light, or sums beyond the allowed memory.
pub fn plan(fields: &[HeightField], optics: &OpticsConfig, config: &TablesConfig) -> Result<BuildPlan> {
    check_heights(fields)?;
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    let resolving = plan::resolving_size(optics, config.tolerance);
    let size = config.size.unwrap_or(resolving.min(AUTOMATIC_SIZE_MAX));
    let grid = Grid { size, half_width: 2.0 };
    let width = match config.prefilter {
        Prefilter::None => 0.0,
        Prefilter::Width(width) => width,
        Prefilter::Auto if grid.texel() > lobe_width(optics.sigma_nm, low_nm) => grid.texel(),
        Prefilter::Auto => 0.0,
    };
    let bandwidth = fields.iter().map(bandwidth_nm).fold(0.0, f64::max);
    let rho_max = 2.0 + RIM_TEXELS * grid.texel();
    let rings = plan::rings(optics, bandwidth, rho_max, config.tolerance, config.wavelength_step_nm)?;
    let mut windows = Vec::new();
    for (scan, field) in fields.iter().enumerate() {
        windows.extend(placements(field, optics)?.into_iter().map(|placement| (scan, placement)));
    }
    let memory_bytes = (config.memory_mib as u64) << 20;
    let nodes_bound = plan::nodes_bound(bandwidth, low_nm, 0.1 * config.tolerance);
    let sums_bytes = (size * size * 3 * 4) as u64 * config.count.unwrap_or(4).next_multiple_of(4) as u64;
    if sums_bytes > memory_bytes {
        return Err(Error::limit(
            format!(
                "sums over {size} x {size} texels need {} MiB, {} MiB are allowed",
                sums_bytes >> 20,
                config.memory_mib
            ),
            "lower tables.size or raise tables.memory_mib",
        ));
    }
    Ok(BuildPlan {
        grid,
        filter: BoxFilter { width, samples: plan::box_samples(optics, width) },
        rings,
        windows,
        spectra: SpectraConfig {
            s_max: 2.0 * std::f64::consts::TAU / low_nm,
            frequency_max: (rho_max + 0.5 * width) / low_nm,
            tolerance: DEPTH_SHARE * config.tolerance,
            memory_bytes,
        },
        nodes_bound,
        bandwidth_nm: bandwidth,
    })
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

/// Builds the tables of one specimen from its prepared scans.
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
    match config.basis {
        Basis::Chebyshev => build_chebyshev(fields, optics, config, advance),
        Basis::Taylor => super::taylor::build_taylor(fields, optics, config, advance),
    }
}

fn build_chebyshev(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &TablesConfig,
    advance: Advance,
) -> Result<(TableSet, BuildRecord)> {
    let plan = plan(fields, optics, config)?;
    let mut state: Option<Sums> = None;
    let mut phasors = Vec::with_capacity(plan.windows.len());
    let mut transforms = 0;
    let radius_max = lobe_radius(optics);
    let share = 1.0 / plan.windows.len() as f64;
    for &(scan, placement) in &plan.windows {
        let spectra = spectra::transform(&fields[scan], placement, optics, &plan.spectra)?;
        transforms = transforms.max(spectra.nodes);
        if state.is_none() {
            let nodes = match config.count {
                Some(count) => count,
                None => pilot::nodes_for_tolerance(&spectra, &plan, config.tolerance),
            };
            state = Some(Sums::new(&plan, optics, nodes, radius_max, spectra.mean_power)?);
        }
        if let Some(sums) = &mut state {
            sums.add(&spectra, &plan, share, advance);
        }
        phasors.push(PhasorPower::of(&spectra));
    }
    let Some(sums) = state else {
        return Err(Error::Call("a specimen needs at least one scan".into()));
    };
    let rms_nm = fields.iter().map(rms_nm).fold(0.0, f64::max);
    let record = BuildRecord { transforms, windows: plan.windows.len(), ..record(&plan) };
    let lobe = Lobe {
        coherent: coherent(&phasors, optics, radius_max, rms_nm, config.tolerance)?,
        radius_max,
        cross: sums.cross_tables(),
    };
    let usable = fields.iter().map(|f| plan::usable_radius(optics, f.pitch_nm)).fold(2.0, f64::min);
    let set = TableSet {
        basis: Basis::Chebyshev,
        tables: to_tables(&sums.main, &plan.grid, &plan.rings, sums.nodes),
        lobe: Some(lobe),
        prefilter_width: plan.filter.width,
        optics: optics.clone(),
        usable_radius: usable,
    };
    Ok((set, record))
}

/// The sums under way: the tables and, where windows are not averaged away, the cross term.
struct Sums {
    nodes: usize,
    main: PowerSums,
    cross: Option<(PowerSums, Grid, [Ring; 1])>,
}

impl Sums {
    fn new(plan: &BuildPlan, optics: &OpticsConfig, nodes: usize, radius_max: f64, mean_power: bool) -> Result<Self> {
        let cross = if mean_power {
            None
        } else {
            let grid = patch_grid(optics, radius_max);
            let corner = radius_max * std::f64::consts::SQRT_2;
            let count = plan::wavelengths_needed(optics, plan.bandwidth_nm, corner, 1e-6);
            let quadrature =
                crate::ground::spectrum::uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, count)?;
            // The square patch is one ring without a hole that reaches past its corners.
            Some((PowerSums::new(&grid, nodes), grid, [Ring { rho: [0.0, corner * 1.01], quadrature }]))
        };
        Ok(Self { nodes, main: PowerSums::new(&plan.grid, nodes), cross })
    }

    fn add(&mut self, spectra: &Spectra, plan: &BuildPlan, share: f64, advance: Advance) {
        for ring in &plan.rings {
            let nodes = chebyshev::gauss_nodes(self.nodes, 0.0, ring.w_max());
            let what = RingSum { grid: &plan.grid, ring, filter: plan.filter, quantity: Quantity::Power, share };
            add_ring(spectra, what, &nodes, &mut self.main);
            advance(ring.quadrature.wavelengths_nm.len() as u64);
        }
        if let Some((sums, grid, [ring])) = &mut self.cross {
            let nodes = chebyshev::gauss_nodes(self.nodes, 0.0, ring.w_max());
            let filter = BoxFilter { width: 0.0, samples: 1 };
            add_ring(spectra, RingSum { grid, ring, filter, quantity: Quantity::Cross, share }, &nodes, sums);
        }
    }

    fn cross_tables(&self) -> Vec<Array3<f32>> {
        match &self.cross {
            Some((sums, grid, rings)) => to_tables(sums, grid, rings, self.nodes),
            None => Vec::new(),
        }
    }
}

/// Values at a ring's nodes of `w` to coefficients of `T_n(2t - 1)` at each texel.
fn to_tables(sums: &PowerSums, grid: &Grid, rings: &[Ring], count: usize) -> Vec<Array3<f32>> {
    let size = grid.size;
    let matrix = chebyshev::coefficient_matrix(count);
    let t_nodes = chebyshev::gauss_nodes(count, 0.0, 1.0);
    let interpolants: Vec<Interpolant> = rings.iter().map(|r| Interpolant::new(count, 0.0, r.w_max())).collect();
    let mut interleaved = vec![0.0f32; size * size * 3 * count];
    let row_length = size * 3;
    interleaved.par_chunks_mut(row_length * count).enumerate().for_each(|(row, out)| {
        for column in 0..size {
            let rho = grid.u(column).hypot(grid.v(row));
            let Some(ring) = rings.iter().position(|r| rho >= r.rho[0] && rho < r.rho[1]) else { continue };
            let reach = w_reach(rho);
            let to_t: Vec<Vec<f64>> = t_nodes.iter().map(|t| interpolants[ring].weights(t * reach)).collect();
            for channel in 0..3 {
                let start = ((row * size + column) * 3 + channel) * sums.nodes;
                let values = &sums.data[start..start + count];
                let at_t: Vec<f64> =
                    to_t.iter().map(|w| w.iter().zip(values).map(|(w, &v)| w * f64::from(v)).sum()).collect();
                for (n, matrix) in matrix.iter().enumerate() {
                    let value: f64 = matrix.iter().zip(&at_t).map(|(m, v)| m * v).sum();
                    out[n * row_length + column * 3 + channel] = value as f32;
                }
            }
        }
    });
    (0..count)
        .map(|n| {
            Array3::from_shape_fn((size, size, 3), |(row, column, channel)| {
                interleaved[(row * count + n) * row_length + column * 3 + channel]
            })
        })
        .collect()
}

/// Root mean square of the heights about their mean, in nm.
pub fn rms_nm(field: &HeightField) -> f64 {
    let mean = field.heights_nm.mean().unwrap_or(0.0);
    let variance = field.heights_nm.iter().map(|h| (h - mean).powi(2)).sum::<f64>();
    (variance / field.heights_nm.len().max(1) as f64).sqrt()
}

/// Counts of a plan for reports.
pub(super) fn record(plan: &BuildPlan) -> BuildRecord {
    let mut record = BuildRecord { wavelength_step_nm: [f64::MAX, 0.0], ..BuildRecord::default() };
    for ring in &plan.rings {
        let nm = &ring.quadrature.wavelengths_nm;
        record.wavelengths_max = record.wavelengths_max.max(nm.len());
        let area = std::f64::consts::PI * (ring.rho[1].powi(2) - ring.rho[0].powi(2)) / plan.grid.texel().powi(2);
        record.samples += (area * nm.len() as f64) as u64;
        for pair in nm.windows(2) {
            let step = (pair[0] - pair[1]).abs();
            record.wavelength_step_nm[0] = record.wavelength_step_nm[0].min(step);
            record.wavelength_step_nm[1] = record.wavelength_step_nm[1].max(step);
        }
    }
    record.wavelength_step_nm[0] = record.wavelength_step_nm[0].min(record.wavelength_step_nm[1]);
    record
}
