//! The error of sampling itself: the scan against every second sample of itself.
//!
//! Where neighbouring samples differ by more than a quarter wavelength in height, the phase between them is a guess. What the
//! half as fine scan of the same surface shows tells how much hangs on it; the scan's own error as a rule is smaller.

use ndarray::Array2;

use super::directions::ErrorGroup;
use super::reference::Reference;
use super::rows::{Cause, ErrorRow, row};
use crate::height::HeightField;
use crate::height::statistics::{AMBIGUOUS_SHARE_WARNED, Statistics};
use crate::optics::config::{Edge, OpticsConfig};
use crate::tables::resolution::usable_radius;
use diffraction_brdf::direction::{Vec3, Xyz, wave_vector_change};
use diffraction_brdf::error::Result;

/// Whether sampling is in question: some scan rises by more than a quarter of the shortest wavelength between samples in more
/// than one place of a hundred.
pub fn is_in_question(statistics: &[Statistics]) -> bool {
    statistics.iter().any(|found| found.ambiguous_share > AMBIGUOUS_SHARE_WARNED)
}

/// Every second sample of each scan along the axes that have an even number of them, or any under `Edge::Fade`: what repeats has
/// to keep its period. `None` where that thins nothing of some scan.
pub fn thinned(fields: &[HeightField], edge: Edge) -> Option<Vec<HeightField>> {
    let of = |field: &HeightField| {
        let steps = field.size().map(|count| if count > 2 && (count % 2 == 0 || edge == Edge::Fade) { 2 } else { 1 });
        let [x, y] = steps;
        let pitch_nm = std::array::from_fn(|axis| field.pitch_nm[axis] * steps[axis] as f64);
        let [columns, rows] = [0, 1].map(|axis| field.size()[axis].div_ceil(steps[axis]));
        let heights_nm =
            Array2::from_shape_fn((rows, columns), |(row, column)| field.heights_nm[[y * row, x * column]]);
        (steps != [1, 1]).then_some(HeightField { heights_nm, pitch_nm })
    };
    fields.iter().map(of).collect()
}

/// A row for each group of directions: the reference of the thinned scans against that of the scans, where the thinned ones still
/// hold every frequency. `evaluate` gives the thinned scans' XYZ at pairs of directions.
///
/// # Errors
/// Those of the reference.
pub fn sampling_rows(
    reference: &Reference,
    thinned: &[HeightField],
    optics: &OpticsConfig,
    evaluate: impl FnOnce(&[(Vec3, Vec3)]) -> Result<Vec<Xyz>>,
) -> Result<Vec<ErrorRow>> {
    let radius = thinned.iter().map(|field| usable_radius(optics, field.pitch_nm)).fold(2.0, f64::min);
    let holds = |index: &usize| {
        let (wi, wo) = reference.pairs[*index];
        let [u, v, _] = wave_vector_change(wi, wo);
        u.hypot(v) <= radius
    };
    let mut start = 0;
    let kept: Vec<(ErrorGroup, Vec<usize>)> = reference
        .groups
        .iter()
        .map(|group| {
            let middle = start + group.counts[0];
            let [above, below] = [start..middle, middle..start + group.len()].map(|part| part.filter(holds).collect());
            start += group.len();
            let (above, below): (Vec<usize>, Vec<usize>) = (above, below);
            (ErrorGroup { counts: [above.len(), below.len()], ..group.clone() }, [above, below].concat())
        })
        .collect();
    let pairs: Vec<(Vec3, Vec3)> =
        kept.iter().flat_map(|(_, indices)| indices.iter().map(|&index| reference.pairs[index])).collect();
    let found = evaluate(&pairs)?;
    let mut rest = found.iter().copied();
    let rows = kept.iter().map(|(group, indices)| {
        let exact: Vec<Xyz> = indices.iter().map(|&index| reference.xyz[index]).collect();
        let coarse: Vec<Xyz> = rest.by_ref().take(indices.len()).collect();
        (!indices.is_empty()).then(|| row(Cause::Sampling, group, &exact, &coarse))
    });
    Ok(rows.flatten().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::directions::Group;
    use crate::ground::sampling::{Region, direction_pairs};
    use crate::height::statistics::statistics;
    use crate::optics::config::{Factor, Material, Windows};
    use crate::optics::reference::brdf_xyz_batch;
    use diffraction_brdf::spectrum::Illuminant;

    const OPTICS: OpticsConfig = OpticsConfig {
        illuminant: Illuminant::D65,
        wavelength_nm: [380.0, 780.0],
        sigma_nm: 600.0,
        lobe_sigma_nm: None,
        source_deg: None,
        sigma_follows_scan: false,
        edge: Edge::Tile,
        windows: Windows::Grid,
        material: Material::Dielectric { n: 1.5 },
        dispersion: None,
        shadowing: false,
        factor: Factor::Vector,
    };

    /// Waves across each other, of this height.
    fn egg_box(amplitude_nm: f64, count: usize) -> HeightField {
        let pitch_nm = 3200.0 / count as f64;
        let wave = |index: usize| (std::f64::consts::TAU * (index as f64 + 0.3) * pitch_nm / 800.0).sin();
        HeightField {
            heights_nm: Array2::from_shape_fn((count, count), |(row, column)| amplitude_nm * wave(row) * wave(column)),
            pitch_nm: [pitch_nm; 2],
        }
    }

    /// The row of the hemisphere, and whether sampling is in question.
    fn sampled(field: &HeightField) -> (ErrorRow, bool) {
        let fields = std::slice::from_ref(field);
        let pairs = direction_pairs(Region::Hemisphere, 12);
        let group = ErrorGroup {
            group: Group::Region(Region::Hemisphere),
            counts: [9, 3],
            share_above: 0.75,
            floor_per_sr: 1e-9,
            left_out_per_sr: None,
        };
        let xyz = brdf_xyz_batch(fields, &OPTICS, &pairs).unwrap();
        let reference = Reference { groups: vec![group], pairs, xyz, ..Reference::default() };
        let thin = thinned(fields, OPTICS.edge).unwrap();
        assert_eq!(thin[0].size(), field.size().map(|count| count / 2));
        assert_eq!(thin[0].extent_nm(), field.extent_nm());
        let rows = sampling_rows(&reference, &thin, &OPTICS, |pairs| brdf_xyz_batch(&thin, &OPTICS, pairs)).unwrap();
        assert_eq!((rows.len(), rows[0].cause), (1, Cause::Sampling));
        (rows[0].clone(), is_in_question(&[statistics(field, 380.0)]))
    }

    #[test]
    fn steps_of_more_than_a_quarter_wavelength_cost_what_the_row_says() {
        let [(gentle, doubt), (steep, steep_doubt)] = [egg_box(20.0, 64), egg_box(600.0, 64)].map(|f| sampled(&f));
        println!("gentle: {gentle:?}\nsteep: {steep:?}");
        assert!(!doubt && steep_doubt);
        // A smooth wave of 16 samples is known between them; one of 600 nm rises by up to 235 nm from one to the next.
        assert!(gentle.relative_l2 < 1e-3, "{gentle:?}");
        assert!(steep.relative_l2 > 0.02, "{steep:?}");
        // What a finer scan of the same surface shows is nearer than that.
        let (fine, _) = sampled(&egg_box(600.0, 128));
        assert!(fine.relative_l2 < 0.5 * steep.relative_l2, "{fine:?}");
    }

    #[test]
    fn thinning_keeps_the_period_and_says_where_it_cannot() {
        let of = |size: [usize; 2], edge| {
            let field = HeightField {
                heights_nm: Array2::from_shape_fn((size[1], size[0]), |(row, column)| (10 * row + column) as f64),
                pitch_nm: [30.0, 40.0],
            };
            thinned(&[field], edge)
        };
        let thin = of([6, 5], Edge::Tile).unwrap().remove(0);
        assert_eq!((thin.size(), thin.pitch_nm), ([3, 5], [60.0, 40.0]));
        assert_eq!(thin.heights_nm.row(1).to_vec(), [10.0, 12.0, 14.0]);
        assert_eq!(of([6, 5], Edge::Fade).unwrap()[0].size(), [3, 3]);
        assert_eq!(of([7, 5], Edge::Tile), None);
        assert_eq!(of([7, 1], Edge::Auto), None);
    }
}
