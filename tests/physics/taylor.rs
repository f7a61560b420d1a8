//! The published method against the direct sum and the Chebyshev tables.

use diffraction_brdf::direction::Vec3;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::ground::metrics::relative_error_quantiles;
use diffraction_build::ground::sampling::four;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::optics::reference::brdf_xyz_batch;
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};
use ndarray::Array2;

/// A quasi-periodic relief of 12 µm without a seam.
fn relief(depth_nm: f64) -> HeightField {
    let heights_nm = Array2::from_shape_fn((96, 96), |(row, column)| {
        let (x, y) = (column as f64 / 96.0, row as f64 / 96.0);
        let wave = |a: f64, b: f64, phase: f64| (std::f64::consts::TAU * (a * x + b * y) + phase).sin();
        0.5 * depth_nm * (wave(9.0, 1.0, 0.3) + 0.6 * wave(4.0, -7.0, 1.1) + 0.4 * wave(1.0, 15.0, 2.0)) / 2.0
    });
    HeightField { heights_nm, pitch_nm: [125.0, 125.0] }
}

fn optics(edge: Edge, windows: Windows) -> OpticsConfig {
    let sigma_nm = 1_200.0;
    OpticsConfig::ideal(Illuminant::D65, sigma_nm, edge, windows)
}

fn config(basis: Basis) -> TablesConfig {
    TablesConfig {
        basis,
        tolerance: 1e-3,
        size: Some(81),
        count: None,
        wavelength_step_nm: None,
        storage: Some(Storage::Float),
        prefilter: Prefilter::None,
        memory_mib: 1024,
    }
}

/// Directions whose `(u, v)` lies on a texel, so that no interpolation error enters: both half a `w` high,
/// turned about `q` by the horizontal that is normal to it.
fn on_texels(set: &TableSet, count: usize) -> Vec<(Vec3, Vec3)> {
    let texel = 4.0 / (set.size() - 1) as f64;
    (0..)
        .map(|index| {
            let [a, b, c, _] = four(index);
            let [u, v] = [a, b].map(|share| ((share - 0.5) * 4.0 / texel).round() * texel);
            (u, v, 0.05 + 0.95 * c)
        })
        // On the axes the cut of a window at the scan's edge throws a faint cross, which tables of a lobe apart
        // leave out.
        .filter(|(u, v, _)| u.abs().min(v.abs()) > 0.2)
        .filter(|(u, v, _)| (0.05..set.usable_radius).contains(&u.hypot(*v)))
        .map(|(u, v, t)| {
            let rho = u.hypot(v);
            let w = t * (4.0 - rho * rho).sqrt();
            let turn = (1.0 - 0.25 * (rho * rho + w * w)).sqrt();
            let wi = |sign: f64| [-0.5 * u - sign * turn * v / rho, -0.5 * v + sign * turn * u / rho, 0.5 * w];
            (wi(1.0), wi(-1.0))
        })
        .take(count)
        .collect()
}

/// 95th percentile of the relative error of Y; a relief of few waves is dark between its
/// orders, where the kernels' own 3e-6 of the order's amplitude is all there is: below 1 % of the mean is left out.
fn error(set: &TableSet, optics: &OpticsConfig, field: &HeightField) -> f64 {
    let pairs = on_texels(set, 60);
    let reference = brdf_xyz_batch(std::slice::from_ref(field), optics, &pairs).unwrap();
    let exact: Vec<f64> = reference.iter().map(|xyz| xyz[1]).collect();
    let found: Vec<f64> = pairs.iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Cubic, wi, wo)[1]).collect();
    let mean = exact.iter().sum::<f64>() / exact.len() as f64;
    let quantiles = relative_error_quantiles(&exact, &found, 1e-2 * mean);
    assert!(quantiles.count > 20);
    quantiles.p95
}

#[test]
fn meets_the_direct_sum_inside_a_scan_and_on_a_tile_and_a_wrong_sign_is_seen() {
    let field = relief(150.0);
    for (edge, windows) in [(Edge::Fade, Windows::Grid), (Edge::Tile, Windows::Centre)] {
        let optics = optics(edge, windows);
        let fields = std::slice::from_ref(&field);
        let (chebyshev, _) = build(&BuildInput::new(fields, &optics, &config(Basis::Chebyshev)), &|_| ()).unwrap();
        let (mut taylor, record) = build(&BuildInput::new(fields, &optics, &config(Basis::Taylor)), &|_| ()).unwrap();
        assert_eq!(record.transforms, taylor.tables.len());
        let errors = [error(&chebyshev, &optics, &field), error(&taylor, &optics, &field)];
        println!(
            "{edge:?} {windows:?}: {} and {} tables, errors {errors:?}",
            chebyshev.tables.len(),
            taylor.tables.len()
        );
        // Basis and wavelengths may each take the tolerance.
        assert!(errors.iter().all(|&e| e < 2e-3), "{errors:?}");
        taylor.tables[4].mapv_inplace(|v| -v);
        assert!(error(&taylor, &optics, &field) > 3e-2);
    }
}

#[test]
fn refuses_a_depth_whose_terms_cancel_but_chebyshev_goes_on() {
    let (deep, optics) = (relief(1_500.0), optics(Edge::Tile, Windows::Grid));
    let fields = std::slice::from_ref(&deep);
    let refused = build(&BuildInput::new(fields, &optics, &config(Basis::Taylor)), &|_| ()).unwrap_err();
    assert!(matches!(refused, diffraction_brdf::error::Error::Limit { .. }), "{refused}");
    let (chebyshev, _) = build(&BuildInput::new(fields, &optics, &config(Basis::Chebyshev)), &|_| ()).unwrap();
    let found = error(&chebyshev, &optics, &deep);
    assert!(found < 2e-3, "{found:e}");
}
