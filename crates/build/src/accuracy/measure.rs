//! Measured errors of a specimen's tables: in total, and each cause by itself.
//!
//! The yardstick is `optics::spectral`, evaluated at directions that the tables show lit and at some that they call dark. One
//! pass over the windows serves the error rows and the scenes' reference pictures.

use super::directions::{ErrorDirections, ErrorGroup};
use super::rows::{ErrorRow, PowerSum};
use crate::ground::metrics;
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::reference::{self, FULL_STEP, PICTURE_STEP};
use crate::optics::spectra::{self, Spectra};
use crate::optics::spectral;
use crate::tables::build::BuildPlan;
use crate::tables::model::{Basis, TableSet};
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::direction::{Vec3, Xyz, from_angles_deg, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, diffuse_window_power, lobe_window_power};
use diffraction_brdf::front_factor::FrontFactor;
use diffraction_brdf::material::Material;
use rayon::prelude::*;

/// What the row is called that holds the yardstick itself against the direct sum.
const DIRECT_ROW: &str = "yardstick against direct sum";

/// Pairs at which it is.
const DIRECT_PAIRS: usize = 2;

/// Everything the yardstick is asked for, in one list.
#[derive(Debug, Clone, Default)]
pub struct Yardstick {
    /// The groups of directions on which errors are counted.
    pub groups: Vec<ErrorGroup>,
    /// Pairs of directions: those of the groups first, then whatever scenes added.
    pub pairs: Vec<(Vec3, Vec3)>,
    /// XYZ of the BRDF at each, in 1/sr.
    pub xyz: Vec<Xyz>,
    /// Diffuse luminance at the regions' pairs: exact, with the tables' wavelengths, and with the tables'
    /// interpolation in `w` too; geometry and reflectance left out.
    pub diffuse: [Vec<f64>; 3],
}

impl Yardstick {
    /// Itself without the pairs beyond the first `count`, those on which errors are counted.
    pub fn counted(mut self, count: usize) -> Self {
        self.pairs.truncate(count);
        self.xyz.truncate(count);
        self
    }
}

/// Evaluates the yardstick on the directions of errors, then on those of pictures.
///
/// # Errors
/// Those of the transforms.
pub fn yardstick(
    fields: &[HeightField],
    optics: &OpticsConfig,
    plan: &BuildPlan,
    nodes: usize,
    errors: ErrorDirections,
    pictures: impl IntoIterator<Item = (Vec3, Vec3)>,
) -> Result<Yardstick> {
    let fixed = errors.pairs.len();
    let ErrorDirections { groups, mut pairs } = errors;
    pairs.extend(pictures);
    let mut yardstick =
        Yardstick { groups, xyz: vec![[0.0; 3]; pairs.len()], pairs, diffuse: [(); 3].map(|()| vec![0.0; fixed]) };
    let share = 1.0 / plan.windows.len().max(1) as f64;
    for &(scan, placement) in &plan.windows {
        let spectra = spectra::transform(&fields[scan], placement, optics, &plan.spectra)?;
        let (exact, pictures) = yardstick.xyz.split_at_mut(fixed);
        spectral::add_window(&spectra, optics, &yardstick.pairs[..fixed], FULL_STEP, exact)?;
        spectral::add_window(&spectra, optics, &yardstick.pairs[fixed..], PICTURE_STEP, pictures)?;
        let rows: Vec<[f64; 3]> = yardstick.pairs[..fixed]
            .par_iter()
            .map(|&(wi, wo)| diffuse_shares(&spectra, optics, plan, nodes, wave_vector_change(wi, wo)))
            .collect::<Result<_>>()?;
        for (index, row) in rows.iter().enumerate() {
            for (sums, value) in yardstick.diffuse.iter_mut().zip(row) {
                sums[index] += share * value;
            }
        }
    }
    yardstick.xyz.iter_mut().for_each(|xyz| *xyz = xyz.map(|x| x * share));
    Ok(yardstick)
}

/// Diffuse luminance at one `q`: exact, with the ring's wavelengths, with the nodes in `w` as well.
fn diffuse_shares(
    spectra: &Spectra,
    optics: &OpticsConfig,
    plan: &BuildPlan,
    nodes: usize,
    q: Vec3,
) -> Result<[f64; 3]> {
    let (uv, w) = ([q[0], q[1]], q[2].abs());
    let exact = spectral::diffuse_power(
        spectra,
        &reference::resolving_wavelengths(optics, q, spectra.half_range_nm, FULL_STEP)?,
        uv,
        &[w],
    )[0][1];
    let rho = uv[0].hypot(uv[1]);
    let Some(ring) = plan.rings.iter().find(|r| rho >= r.rho[0] && rho < r.rho[1]) else {
        return Ok([exact; 3]);
    };
    let [low, high] = match &plan.domain {
        None => ring.w,
        Some(domain) => domain.w_near(uv).unwrap_or(ring.w),
    };
    let mut points = chebyshev::gauss_nodes(nodes, low, high);
    let weights = chebyshev::interpolation_weights(nodes, low, high, w.min(max_abs_w(rho)));
    points.push(w);
    let values = spectral::diffuse_power(spectra, &ring.quadrature, uv, &points);
    let interpolated = values.iter().zip(&weights).map(|(value, weight)| value[1] * weight).sum();
    Ok([exact, values[nodes][1], interpolated])
}

/// Error rows of the stored tables (as read back) and of the tables before rounding.
pub fn error_rows(yardstick: &Yardstick, stored: &TableSet, built: &TableSet) -> Vec<ErrorRow> {
    let mut rows = Vec::new();
    let mut start = 0;
    for group in &yardstick.groups {
        let range = start..start + group.len();
        start = range.end;
        let pairs = &yardstick.pairs[range.clone()];
        let luminance = |values: &[Xyz]| values.iter().map(|xyz| xyz[1]).collect::<Vec<_>>();
        let exact = luminance(&yardstick.xyz[range.clone()]);
        // The diffuse part as bright as it is seen, so that one floor counts for all rows.
        let front: Vec<f64> = pairs.iter().map(|&(wi, wo)| stored.front_factor.value(wi, wo)).collect();
        let seen = |diffuse: &[f64]| -> Vec<f64> { diffuse.iter().zip(&front).map(|(d, front)| d * front).collect() };
        let tables = |set: &TableSet, interpolation| {
            luminance(&pairs.iter().map(|&(wi, wo)| brdf_xyz(set, interpolation, wi, wo)).collect::<Vec<_>>())
        };
        let diffuse = |set: &TableSet| -> Vec<f64> {
            let at = |&(wi, wo): &(Vec3, Vec3)| {
                diffuse_window_power(set, Interpolation::Bilinear, wave_vector_change(wi, wo))[1]
            };
            seen(&pairs.iter().map(at).collect::<Vec<_>>())
        };
        let [fine, ringed, interpolated] = [0, 1, 2].map(|i| seen(&yardstick.diffuse[i][range.clone()]));
        let on_grid = diffuse(built);
        let mut push = |what: &str, reference: &[f64], test: &[f64]| rows.push(row(what, group, reference, test));
        push("total", &exact, &tables(stored, Interpolation::Bilinear));
        push("total, cubic look-up", &exact, &tables(stored, Interpolation::Cubic));
        // The shares below are those of the diffuse part under interpolation in `w`: a power series keeps
        // neither apart.
        if stored.basis == Basis::Taylor {
            continue;
        }
        push("wavelength step", &fine, &ringed);
        push("basis", &ringed, &interpolated);
        push("grid", &interpolated, &on_grid);
        push("storage", &on_grid, &diffuse(stored));
    }
    rows
}

/// Pointwise errors of the directions that the reference has above the floor; the norm of all, each with the share of the
/// group that it stands for. What nothing lit can tell is NaN.
fn row(what: &str, group: &ErrorGroup, reference: &[f64], test: &[f64]) -> ErrorRow {
    let quantiles = metrics::relative_error_quantiles(reference, test, group.floor_per_sr);
    let weights = group.weights();
    let weighed = |values: &[f64]| -> Vec<f64> { values.iter().zip(&weights).map(|(v, w)| v * w.sqrt()).collect() };
    let [lit, dark] = group.counts;
    let is_dark = |values: &[f64]| values.iter().all(|y| y.abs() <= group.floor_per_sr);
    let of_lit = |error: f64| if quantiles.count == 0 { f64::NAN } else { error };
    ErrorRow {
        what: what.into(),
        region: group.name.clone(),
        directions: quantiles.count,
        floor_per_sr: group.floor_per_sr,
        lit_share: group.lit_share,
        dark_directions: dark,
        missed_directions: reference[lit..].iter().filter(|y| y.abs() > group.floor_per_sr).count(),
        relative_l2: match is_dark(reference) && is_dark(test) {
            true => f64::NAN,
            false => metrics::relative_l2(&weighed(reference), &weighed(test)),
        },
        p50: of_lit(quantiles.p50),
        p95: of_lit(quantiles.p95),
        p99: of_lit(quantiles.p99),
        worst: of_lit(quantiles.worst),
    }
}

/// The direct sum's XYZ at pairs of directions.
pub type DirectSum<'a> = &'a dyn Fn(&[(Vec3, Vec3)]) -> Result<Vec<Xyz>>;

/// The yardstick against the direct sum at the brightest directions of the first group: a grating is dark in most of
/// them, and nothing can be compared there. `direct` gives the direct sum's XYZ at pairs of directions.
///
/// # Errors
/// Those of the reference.
pub fn direct_row(yardstick: &Yardstick, direct: DirectSum) -> Result<ErrorRow> {
    let Some(group) = yardstick.groups.first() else {
        return Err(diffraction_brdf::error::Error::Call("errors are counted on no directions".into()));
    };
    let mut brightest: Vec<usize> = (0..group.len()).collect();
    brightest.sort_by(|&a, &b| yardstick.xyz[b][1].total_cmp(&yardstick.xyz[a][1]));
    brightest.truncate(DIRECT_PAIRS);
    let pairs: Vec<(Vec3, Vec3)> = brightest.iter().map(|&index| yardstick.pairs[index]).collect();
    let direct: Vec<f64> = direct(&pairs)?.iter().map(|xyz| xyz[1]).collect();
    let fast: Vec<f64> = brightest.iter().map(|&index| yardstick.xyz[index][1]).collect();
    let group = ErrorGroup { counts: [brightest.len(), 0], ..group.clone() };
    Ok(row(DIRECT_ROW, &group, &direct, &fast))
}

/// Most that the yardstick may differ from the direct sum: beyond, it measures nothing.
const DISAGREEMENT_MAX: f64 = 1e-3;

/// What is wrong with the yardstick itself, if anything is.
pub fn disagreement(rows: &[ErrorRow]) -> Option<String> {
    let row = rows.iter().find(|row| row.what == DIRECT_ROW)?;
    (row.worst > DISAGREEMENT_MAX).then(|| {
        format!(
            "the reference is off the direct sum by {:.1e}, so that measured errors and reference pictures mean nothing: \
             please report this surface",
            row.worst
        )
    })
}

/// A line for each error that breaks the tolerance.
pub fn broken_tolerances(rows: &[ErrorRow], tolerance: f64) -> Vec<String> {
    let broken = rows.iter().filter(|row| row.is_over(tolerance));
    let line = |row: &ErrorRow| {
        format!(
            "the tolerance of {tolerance:.0e} is not kept: {}, {}: one direction in twenty errs by {:.1e} or more",
            row.what, row.region, row.p95
        )
    };
    broken.map(line).collect()
}

/// Luminous sums `∫ f cos_theta_o dω_o` for unit reflectance, from the tables: the diffuse part on a grid
/// over the viewer's disc, the lobe on a fine patch around the mirror direction. Also the lobe's share at
/// normal incidence. Nothing where the tables do not serve the whole hemisphere.
pub fn power_sums(set: &TableSet) -> (Vec<PowerSum>, Option<f64>) {
    if set.served.is_some() {
        return (Vec::new(), None);
    }
    let unit = TableSet { front_factor: FrontFactor { material: Material::Ideal, ..set.front_factor }, ..set.clone() };
    // A step per texel at most, or narrow orders fall between them.
    let steps = (set.size() / 2).max(256);
    let mut sums = Vec::new();
    let mut lobe_share = None;
    for theta_i_deg in [0.0, 30.0, 60.0] {
        let wi = from_angles_deg(theta_i_deg, 0.0);
        let front = |wo: Vec3| unit.front_factor.value(wi, wo);
        let diffuse = integrate([0.0, 0.0], 1.0, steps, |wo| {
            front(wo) * diffuse_window_power(&unit, Interpolation::Bilinear, wave_vector_change(wi, wo))[1]
        });
        let radius = unit.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max);
        let lobe = integrate([-wi[0], -wi[1]], radius, 192, |wo| {
            front(wo) * lobe_window_power(&unit, Interpolation::Bilinear, wave_vector_change(wi, wo))[1]
        });
        if theta_i_deg == 0.0 && unit.lobe.is_some() {
            lobe_share = Some(lobe / (lobe + diffuse));
        }
        sums.push(PowerSum { theta_i_deg, wavelength_nm: None, sum: lobe + diffuse });
    }
    (sums, lobe_share)
}

/// Midpoint rule over the square of half width `half` around a projected direction, inside the unit disc:
/// `cos_theta_o dω_o` is the area element there.
fn integrate(centre: [f64; 2], half: f64, steps: usize, f: impl Fn(Vec3) -> f64 + Sync) -> f64 {
    let cell = 2.0 * half / steps as f64;
    let rows: Vec<f64> = (0..steps)
        .into_par_iter()
        .map(|row| {
            let y = centre[1] - half + (row as f64 + 0.5) * cell;
            let line = (0..steps).map(|column| {
                let x = centre[0] - half + (column as f64 + 0.5) * cell;
                let z2 = 1.0 - x * x - y * y;
                if z2 > 0.0 { f([x, y, z2.sqrt()]) } else { 0.0 }
            });
            line.sum::<f64>()
        })
        .collect();
    rows.iter().sum::<f64>() * cell * cell
}
