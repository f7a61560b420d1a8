//! The version of all numbers that this crate computes, by which kept results are told from out-of-date ones.

/// Raised with every change that alters any number of tables, reference or direct sum by more than rounding: results
/// that were kept under another version are computed again. The test below notices.
pub const NUMERICS: u32 = 1;

#[cfg(test)]
mod tests {
    use std::slice::from_ref;

    use super::*;
    use crate::accuracy::directions::ErrorDirections;
    use crate::accuracy::reference::evaluate;
    use crate::height::HeightField;
    use crate::height::prepare::{Level, PrepareConfig, prepare};
    use crate::height::synthesize::{Structure, synthesize};
    use crate::optics::config::{Edge, Factor, Material, OpticsConfig, Windows};
    use crate::optics::reference::brdf_xyz_batch;
    use crate::tables::build::build_planned;
    use crate::tables::input::BuildInput;
    use crate::tables::model::{Basis, Prefilter, TablesConfig};
    use crate::tables::plan::plan;
    use diffraction_brdf::direction::{Vec3, from_angles_deg};
    use diffraction_brdf::spectrum::Illuminant;

    /// What the numbers of [`NUMERICS`] sum to. A new version takes new sums, and only that.
    const SUMS: [(u32, &str, f64); 4] =
        [(1, "prepared heights", 0.0), (1, "tables", 0.0), (1, "reference", 0.0), (1, "direct sum", 0.0)];

    /// Far above what the order of sums and other processors change, which is 1e-7 of tables in single precision.
    const TOLERANCE: f64 = 1e-5;

    /// A sum in which every number counts, and none stands for another.
    fn sum(numbers: impl Iterator<Item = f64>) -> f64 {
        numbers.enumerate().map(|(n, number)| number * (1.0 + (n as f64 * 0.7).sin())).sum()
    }

    fn rough() -> HeightField {
        let structure = Structure::GaussianRough { rms_nm: 40.0, correlation_length_nm: 300.0, seed: 5 };
        let field = synthesize(&structure, [48, 40], [80.0, 90.0]).unwrap();
        prepare(&field, &PrepareConfig { level: Level::Quadratic, despike: None, blend_nm: Some(200.0) }).unwrap().0
    }

    #[test]
    fn numbers_change_with_their_version_alone() {
        let field = rough();
        let optics = OpticsConfig {
            material: Material::Dielectric { n: 1.56 },
            factor: Factor::Vector,
            wavelength_nm: [420.0, 680.0],
            ..OpticsConfig::ideal(Illuminant::D65, 900.0, Edge::Tile, Windows::Grid)
        };
        let tables = TablesConfig {
            basis: Basis::Chebyshev,
            tolerance: 1e-3,
            size: Some(33),
            count: None,
            wavelength_step_nm: None,
            storage: None,
            prefilter: Prefilter::Auto,
            memory_mib: 512,
        };
        let input = BuildInput::new(from_ref(&field), &optics, &tables);
        let plan = plan(&input).unwrap();
        let (set, _) = build_planned(&input, &plan, &|_| ()).unwrap();
        let lobe = set.lobe.iter().flat_map(|lobe| [&lobe.coherent].into_iter().chain(&lobe.cross));
        let texels = set.tables.iter().chain(lobe).flatten().map(|value| f64::from(*value));
        let pairs: Vec<(Vec3, Vec3)> = (0..12)
            .map(|n| (from_angles_deg(5.0 * f64::from(n), 30.0), from_angles_deg(62.0 - 4.0 * f64::from(n), 200.0)))
            .collect();
        let reference =
            evaluate(from_ref(&field), &optics, &plan, set.tables.len(), ErrorDirections::default(), pairs.clone());
        let direct = brdf_xyz_batch(from_ref(&field), &optics, &pairs[..4]).unwrap();
        let now = [
            sum(field.heights_nm.iter().copied()),
            sum(texels),
            sum(reference.unwrap().xyz.into_iter().flatten()),
            sum(direct.into_iter().flatten()),
        ];
        for ((version, what, then), now) in SUMS.into_iter().zip(now) {
            assert_eq!(version, NUMERICS, "a new version takes new sums: {what}: {now:?}");
            let change = (now / then - 1.0).abs();
            assert!(change < TOLERANCE, "{what} moved by {change:.1e}: raise NUMERICS, and write down {now:?}");
        }
    }
}
