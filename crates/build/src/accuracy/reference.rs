//! The reference of a set of pairs of directions: the BRDF straight from the transforms (`optics::spectral`), without tables.
//!
//! One pass over the windows gives the error rows' values and those of the scenes' reference pictures.

use rayon::prelude::*;

use super::directions::{ErrorDirections, ErrorGroup};
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::factors::PairFactors;
use crate::optics::left_out::left_out_per_sr;
use crate::optics::reference::{FULL_STEP, PICTURE_STEP, resolving_count};
use crate::optics::spectra::{self, Spectra};
use crate::optics::spectral;
use crate::tables::plan::BuildPlan;
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::{Vec3, Xyz, max_abs_w, wave_vector_change};
use diffraction_brdf::error::Result;

/// What the surface does in all directions that are asked for, in one list.
#[derive(Debug, Clone, Default)]
pub struct Reference {
    /// The groups of directions on which errors are counted.
    pub groups: Vec<ErrorGroup>,
    /// Pairs of directions: those of the groups first, then whatever scenes added.
    pub pairs: Vec<(Vec3, Vec3)>,
    /// XYZ of the BRDF at each, in 1/sr.
    pub xyz: Vec<Xyz>,
    /// The same at the pairs of the groups with the front factor at one wavelength, as tables have it; empty where the material is
    /// the same at every wavelength.
    pub as_tables: Vec<Xyz>,
    /// XYZ of the diffuse part at the regions' pairs: exact, with the tables' wavelengths, and with the tables'
    /// interpolation in `w` too; geometry and reflectance left out.
    pub diffuse: [Vec<Xyz>; 3],
}

impl Reference {
    /// Itself without the pairs beyond the first `count`, those on which errors are counted.
    pub fn counted(mut self, count: usize) -> Self {
        self.pairs.truncate(count);
        self.xyz.truncate(count);
        self
    }
}

/// Evaluates the reference on the directions of errors, then on those of pictures.
///
/// # Errors
/// Those of the transforms.
pub fn evaluate(
    fields: &[HeightField],
    optics: &OpticsConfig,
    plan: &BuildPlan,
    nodes: usize,
    errors: ErrorDirections,
    pictures: impl IntoIterator<Item = (Vec3, Vec3)>,
) -> Result<Reference> {
    let fixed = errors.pairs.len();
    let ErrorDirections { mut groups, mut pairs } = errors;
    bound_groups(fields, optics, &mut groups, &pairs)?;
    pairs.extend(pictures);
    let counted_as_tables = if optics.dispersion.is_some() { fixed } else { 0 };
    let mut reference = Reference {
        groups,
        xyz: vec![[0.0; 3]; pairs.len()],
        pairs,
        as_tables: vec![[0.0; 3]; counted_as_tables],
        diffuse: [(); 3].map(|()| vec![[0.0; 3]; fixed]),
    };
    let share = 1.0 / plan.windows.len().max(1) as f64;
    for &(scan, placement) in &plan.windows {
        let spectra = spectra::transform(&fields[scan], placement, optics, &plan.spectra)?;
        let (exact, pictures) = reference.xyz.split_at_mut(fixed);
        spectral::add_window(&spectra, optics, &reference.pairs[..fixed], FULL_STEP, exact)?;
        spectral::add_window(&spectra, optics, &reference.pairs[fixed..], PICTURE_STEP, pictures)?;
        let as_tables = (&reference.pairs[..counted_as_tables], &mut reference.as_tables);
        spectral::add_window_with(&spectra, optics, as_tables.0, FULL_STEP, PairFactors::as_tables, as_tables.1)?;
        let rows: Vec<[Xyz; 3]> = reference.pairs[..fixed]
            .par_iter()
            .map(|&(wi, wo)| diffuse_shares(&spectra, optics, plan, nodes, wave_vector_change(wi, wo)))
            .collect::<Result<_>>()?;
        for (index, row) in rows.iter().enumerate() {
            for (sums, value) in reference.diffuse.iter_mut().zip(row) {
                sums[index].iter_mut().zip(value).for_each(|(sum, value)| *sum += share * value);
            }
        }
    }
    reference.xyz.iter_mut().chain(&mut reference.as_tables).for_each(|xyz| *xyz = xyz.map(|x| x * share));
    Ok(reference)
}

/// Says of each group what the reference may leave out at its pairs, which follow each other group by group.
///
/// # Errors
/// Those of the bound.
pub fn bound_groups(
    fields: &[HeightField],
    optics: &OpticsConfig,
    groups: &mut [ErrorGroup],
    pairs: &[(Vec3, Vec3)],
) -> Result<()> {
    let mut first = 0;
    for group in groups {
        let end = first + group.len();
        group.left_out_per_sr = left_out_per_sr(fields, optics, &pairs[first..end])?;
        first = end;
    }
    Ok(())
}

/// The diffuse part at one `q`: exact, with the annulus's wavelengths, with the nodes in `w` as well.
fn diffuse_shares(
    spectra: &Spectra,
    optics: &OpticsConfig,
    plan: &BuildPlan,
    nodes: usize,
    q: Vec3,
) -> Result<[Xyz; 3]> {
    let (uv, w) = ([q[0], q[1]], q[2].abs());
    let fine = optics.tables_quadrature(resolving_count(optics, q, spectra.half_range_nm, FULL_STEP))?;
    let exact = spectral::diffuse_power(spectra, &fine, uv, &[w])[0];
    let radius = uv[0].hypot(uv[1]);
    let Some(ring) = plan.ring_at(radius) else {
        return Ok([exact; 3]);
    };
    let [low, high] = match &plan.coverage {
        None => ring.abs_w,
        Some(coverage) => coverage.abs_w_near(uv).unwrap_or(ring.abs_w),
    };
    let mut points = chebyshev::gauss_nodes(nodes, low, high);
    let weights = chebyshev::interpolation_weights(nodes, low, high, w.min(max_abs_w(radius)));
    points.push(w);
    let values = spectral::diffuse_power(spectra, &ring.quadrature, uv, &points);
    let mut interpolated = [0.0; 3];
    for (value, weight) in values.iter().zip(&weights) {
        interpolated.iter_mut().zip(value).for_each(|(sum, value)| *sum += value * weight);
    }
    Ok([exact, values[nodes], interpolated])
}
