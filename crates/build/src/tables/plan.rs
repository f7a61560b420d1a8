//! What a build will do: everything that can be known without transforming.

use super::accumulate::{BoxFilter, SIMD_WIDTH};
use super::coverage::ranges::{Coverage, Hull};
use super::coverage::restrict::{Restricted, Whole, restrict};
use super::grid::Grid;
use super::input::BuildInput;
use super::model::{Basis, BuildRecord, Prefilter};
use super::resolution::{box_samples, lobe_radius, narrowest_blur, nodes_bound_over, resolving_size};
use super::rings::{Ring, quadrature, rings, wavelengths_of};
use super::texels::Texels;
use super::work::window_works;
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::spectra::{self, SpectraConfig, half_height_range_nm};
use crate::optics::window::{Placement, placements, rms_within_nm};
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::spectrum::SpectralQuadrature;
use rayon::prelude::*;

/// Largest table chosen without being asked for.
pub const AUTOMATIC_SIZE_MAX: usize = 1001;

/// Texels beyond the rim of the disc that are filled, so that interpolation at the rim sees no zeros.
pub(super) const RIM_TEXELS: f64 = 3.0;

/// Share of the tolerance that the interpolation in phase scale may take, as an amplitude of the window's whole: weak
/// orders must keep their digits too.
const PHASE_SHARE: f64 = 1e-3;

/// Share of the tolerance that is left to nodes by which others are judged.
const FINE_SHARE: f64 = 0.1;

/// What a build will do.
#[derive(Debug, Clone)]
pub struct BuildPlan {
    /// Texels of the tables.
    pub texels: Texels,
    /// Channels of a texel: X, Y and Z, or one where a wavelength stands for itself.
    pub channels: usize,
    /// What the tables are restricted to; `None` for all texels over their whole `|w|`.
    pub coverage: Option<Coverage>,
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
    /// The `|w|` that transforms hold: those of the coverage, widened to multiples of a power of two.
    pub abs_w: [f64; 2],
    /// Largest half range of the heights in nm.
    pub half_height_range_nm: f64,
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

/// What tables are restricted to. By default everything that it leaves out is left out.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope {
    /// The directions; `None` for all.
    pub coverage: Option<Coverage>,
    /// Whether every ring has the wavelengths of the rim, as if no radius needed fewer.
    pub rim_wavelengths: bool,
    /// Whether the coherent lobe is there even where no direction lies in it.
    pub keeps_lobe: bool,
}

/// Plans tables for every direction.
///
/// # Errors
/// A scan too small for the window, heights that are no relief, an invisible light, or sums beyond the allowed memory.
pub fn plan(input: &BuildInput) -> Result<BuildPlan> {
    plan_within(input, Scope::default())
}

/// Plans tables for the directions of a coverage on [`grid`], or for all where there is none.
///
/// # Errors
/// As [`plan()`]; a coverage of nothing.
pub fn plan_for(input: &BuildInput, coverage: Option<Coverage>) -> Result<BuildPlan> {
    plan_within(input, Scope { coverage, ..Scope::default() })
}

/// Plans tables.
///
/// # Errors
/// As [`plan()`]; a coverage of nothing.
pub(super) fn plan_within(input: &BuildInput, scope: Scope) -> Result<BuildPlan> {
    check_heights(input.fields)?;
    let windows = windows(input)?;
    let grid = grid(input);
    let filter = box_filter(input, &grid);
    let radius_max = 2.0 + RIM_TEXELS * grid.texel();
    let rim = quadrature(input, wavelengths_of(input, [radius_max; 2]))?;
    let lobe_radius = lobe_radius(input.optics);
    let fine_tolerance = FINE_SHARE * input.tables.tolerance;
    let [wavelength_min_nm, _] = input.wavelength_range_nm;
    let half_height_range_nm = input.half_height_range_nm;
    let nodes_over =
        |[low, high]: [f64; 2]| nodes_bound_over(half_height_range_nm, wavelength_min_nm, fine_tolerance, high - low);
    let hull = Hull::whole(radius_max);
    let whole = Whole {
        texels: &Texels::whole(grid),
        hull,
        nodes_bound: nodes_over(hull.abs_w),
        lobe_radius,
        crosses: windows.iter().any(|(_, placement)| *placement != Placement::TileMean),
    };
    let part = match &scope.coverage {
        None => everything(input, &whole)?,
        Some(coverage) => {
            let spectra = spectra_config(input, &hull, filter.width);
            let work = window_works(input, &windows, &spectra, filter.samples);
            restrict(input, coverage, &whole, &work)?
        }
    };
    let with_wavelengths = |ring: Ring| match scope.rim_wavelengths {
        false => ring,
        true => Ring { quadrature: rim.clone(), ..ring },
    };
    let plan = BuildPlan {
        rings: part.rings.into_iter().map(with_wavelengths).collect(),
        texels: scope.coverage.as_ref().map_or_else(|| whole.texels.clone(), Coverage::texels),
        spectra: spectra_config(input, &part.transformed, filter.width),
        nodes_bound: nodes_over(part.covered.abs_w),
        abs_w: part.transformed.abs_w,
        lobe_seen: part.lobe_seen || scope.keeps_lobe,
        crosses: part.crosses,
        coverage: scope.coverage,
        channels: input.channels(),
        filter,
        rim,
        windows,
        half_height_range_nm,
        wavelength_min_nm,
        fine_tolerance,
        lobe_radius,
    };
    plan.check_memory(input)?;
    Ok(plan)
}

/// All that there is to plan.
fn everything(input: &BuildInput, whole: &Whole) -> Result<Restricted> {
    let rings = rings(input, whole.hull.radius[1])?;
    Ok(Restricted { rings, transformed: whole.hull, covered: whole.hull, lobe_seen: true, crosses: whole.crosses })
}

impl BuildPlan {
    /// The ring of a direction at this distance from the centre of (u, v).
    pub fn ring_at(&self, radius: f64) -> Option<&Ring> {
        self.rings.iter().find(|ring| ring.holds(radius))
    }

    /// The `|w|` that transforms hold and directions in a ring can have.
    pub(super) fn abs_w_within(&self, ring: &Ring) -> [f64; 2] {
        [self.abs_w[0], self.abs_w[1].min(max_abs_w(ring.radius[0]))]
    }

    /// Most nodes that an interval of `|w|` can need.
    pub(super) fn nodes_over(&self, [low, high]: [f64; 2]) -> usize {
        nodes_bound_over(self.half_height_range_nm, self.wavelength_min_nm, self.fine_tolerance, high - low)
    }

    /// The `t` that directions within the lobe have.
    pub(super) fn t_in_lobe(&self) -> [f64; 2] {
        self.coverage.as_ref().and_then(|coverage| coverage.t_inside(self.lobe_radius)).unwrap_or([0.0, 1.0])
    }

    /// Texels times wavelengths of each ring.
    pub(super) fn ring_samples(&self) -> Vec<f64> {
        let samples = |ring: &Ring| self.texels.count_within(ring.radius) as f64 * ring.wavelengths() as f64;
        self.rings.iter().map(samples).collect()
    }

    /// Counts for reports.
    pub(super) fn record(&self) -> BuildRecord {
        let steps = self.rings.iter().flat_map(|ring| ring.quadrature.wavelengths_nm.windows(2));
        let steps = steps.map(|pair| (pair[0] - pair[1]).abs());
        let [least, most] = steps.fold([f64::MAX, 0.0], |[least, most], step| [least.min(step), most.max(step)]);
        BuildRecord {
            windows: self.windows.len(),
            wavelengths_max: self.rings.iter().map(Ring::wavelengths).max().unwrap_or(0),
            samples: self.ring_samples().iter().sum::<f64>() as u64,
            wavelength_step_nm: [least.min(most), most],
            ..BuildRecord::default()
        }
    }

    /// Refuses what is known to exceed the memory allowed.
    fn check_memory(&self, input: &BuildInput) -> Result<()> {
        // As few nodes as there can be; how many it will be is known later.
        self.check_sums(input.tables.count.unwrap_or(SIMD_WIDTH), 0)?;
        if input.tables.basis == Basis::Chebyshev {
            // Windows of one scan are alike.
            for (scan, field) in input.fields.iter().enumerate() {
                if let Some((_, placement)) = self.windows.iter().find(|window| window.0 == scan) {
                    spectra::check_memory(field, *placement, input.optics, &self.spectra)?;
                }
            }
        }
        Ok(())
    }

    /// Refuses sums over so many nodes, and tables beside them, that exceed the memory allowed.
    pub(super) fn check_sums(&self, nodes: usize, tables: usize) -> Result<()> {
        let memory_bytes = self.spectra.memory_bytes;
        let numbers = self.channels as u64 * (nodes.next_multiple_of(SIMD_WIDTH) + tables) as u64;
        let bytes = self.texels.window_texels() as u64 * size_of::<f32>() as u64 * numbers;
        if bytes <= memory_bytes {
            return Ok(());
        }
        let besides = if tables > 0 { format!(" and {tables} tables") } else { String::new() };
        Err(Error::limit(
            format!(
                "sums over {} x {} texels{besides} need {} MiB, {} MiB are allowed",
                self.texels.columns.len(),
                self.texels.rows.len(),
                bytes >> 20,
                memory_bytes >> 20
            ),
            "lower tables.size, fix tables.count, or raise tables.memory_mib",
        ))
    }
}

/// The grid that tables have.
pub fn grid(input: &BuildInput) -> Grid {
    let automatic = || automatic_size(input.optics, input.tables.tolerance);
    Grid { size: input.tables.size.unwrap_or_else(automatic), half_width: 2.0 }
}

/// Texels a side where nobody asks for others: as many as resolve the lobes of the shortest wavelength to the tolerance.
pub fn automatic_size(optics: &OpticsConfig, tolerance: f64) -> usize {
    resolving_size(optics, tolerance).min(AUTOMATIC_SIZE_MAX)
}

/// What a texel averages over.
fn box_filter(input: &BuildInput, grid: &Grid) -> BoxFilter {
    let width = match input.tables.prefilter {
        Prefilter::None => 0.0,
        Prefilter::Width(width) => width,
        Prefilter::Auto if grid.texel() > narrowest_blur(input.optics) => grid.texel(),
        Prefilter::Auto => 0.0,
    };
    BoxFilter { width, samples: box_samples(input.optics, width) }
}

/// The windows of all scans, the one with the highest relief first: the order estimator looks at that one alone, and none
/// asks for more nodes.
fn windows(input: &BuildInput) -> Result<Vec<(usize, Placement)>> {
    let mut windows = Vec::new();
    for (scan, field) in input.fields.iter().enumerate() {
        windows.extend(placements(field, input.optics)?.into_iter().map(|placement| (scan, placement)));
    }
    if windows.len() < 2 {
        return Ok(windows);
    }
    let rms_nm: Vec<f64> = windows
        .par_iter()
        .map(|&(scan, placement)| rms_within_nm(&input.fields[scan], placement, input.optics.sigma_nm))
        .collect();
    // Of equal ones the first.
    let roughest = (0..windows.len()).rev().max_by(|&a, &b| rms_nm[a].total_cmp(&rms_nm[b])).unwrap_or(0);
    windows[..=roughest].rotate_right(1);
    Ok(windows)
}

/// Phase scales and frequencies that an extent of directions asks for at the light's wavelengths.
fn spectra_config(input: &BuildInput, hull: &Hull, width: f64) -> SpectraConfig {
    let [low_nm, high_nm] = input.wavelength_range_nm;
    let tau = std::f64::consts::TAU;
    // The farther end of an interval is reached by the shortest wavelength.
    let frequencies = |[low, high]: [f64; 2]| {
        let (low, high) = (low - 0.5 * width, high + 0.5 * width);
        [low / if low < 0.0 { low_nm } else { high_nm }, high / if high > 0.0 { low_nm } else { high_nm }]
    };
    SpectraConfig {
        phase_scale_per_nm: [tau / high_nm * hull.abs_w[0], tau / low_nm * hull.abs_w[1]],
        frequency: [frequencies(hull.u), frequencies(hull.v)],
        tolerance: PHASE_SHARE * input.tables.tolerance,
        memory_bytes: (input.tables.memory_mib as u64) << 20,
    }
}

/// Half range of the heights beyond which no surface is meant: phases of 3000 rad at the shortest visible
/// wavelength. Counting the nodes alone would take for ever long before the memory's limit is reached.
const HALF_HEIGHT_RANGE_MAX_NM: f64 = 1e5;

/// Refuses heights that are not numbers, or that cannot be a relief that diffracts.
fn check_heights(fields: &[HeightField]) -> Result<()> {
    for (scan, field) in fields.iter().enumerate() {
        if let Some(((row, column), height)) = field.heights_nm.indexed_iter().find(|(_, h)| !h.is_finite()) {
            return Err(Error::limit(
                format!("scan {} holds a height of {height} nm at row {row}, column {column}", scan + 1),
                "fill or cut out missing samples before tables are built",
            ));
        }
        let half_range = half_height_range_nm(field);
        if half_range > HALF_HEIGHT_RANGE_MAX_NM {
            return Err(Error::limit(
                format!(
                    "scan {} is {:.3e} nm from valley to peak, {:.0e} nm are the most",
                    scan + 1,
                    2.0 * half_range,
                    2.0 * HALF_HEIGHT_RANGE_MAX_NM
                ),
                "check the unit of height, or clip outliers with despike",
            ));
        }
    }
    Ok(())
}
