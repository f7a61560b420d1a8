//! Spectral tables against the direct sum at single wavelengths, and against the tables of XYZ.

use crate::common::surfaces::{PLACEMENTS, quantile, random, tables_config};
use diffraction_brdf::SpectralTables;
use diffraction_brdf::derived::DerivedLight;
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::front_factor::Factor;
use diffraction_brdf::spectral::SpectralLobe;
use diffraction_brdf::spectral_storage::{StoredSpectral, read_spectral, write_spectral};
use diffraction_brdf::spectrum::{Illuminant, Line};
use diffraction_build::ground::metrics::colour_error_quantiles;
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::reference::brdf_spectrum;
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Storage, TableSet, TablesConfig};
use diffraction_build::tables::spectral::{SpectralInput, build_spectral, obstacle};

const TOLERANCE: f64 = 1e-3;

fn optics(edge: Edge, windows: Windows, sigma_nm: f64, factor: Factor) -> OpticsConfig {
    let material = Material::Dielectric { n: 1.56 };
    OpticsConfig { material, factor, ..OpticsConfig::ideal(Illuminant::D65, sigma_nm, edge, windows) }
}

fn spectral_tables(fields: &[HeightField], optics: &OpticsConfig, tables: &TablesConfig) -> SpectralTables {
    let spectral = SpectralInput::new(optics, tables);
    let input = BuildInput::new(fields, optics, tables);
    let built = build_spectral(&input, &spectral, &|_| ()).unwrap();
    built.rounded(&spectral).set
}

/// Pairs of directions with a wavelength each, over the hemisphere, near the mirror direction, and at grazing angles.
fn places(count: usize) -> Vec<(Vec3, Vec3, f64)> {
    let pairs = Region::ALL.into_iter().flat_map(|region| direction_pairs(region, count));
    pairs.enumerate().map(|(index, (wi, wo))| (wi, wo, 380.0 + 400.0 * ((index as f64 * 0.618_034).fract()))).collect()
}

/// Relative errors at places that are no darker than a tenth of the median.
fn errors(
    tables: &SpectralTables,
    fields: &[HeightField],
    optics: &OpticsConfig,
    places: &[(Vec3, Vec3, f64)],
) -> Vec<f64> {
    let exact: Vec<f64> =
        places.iter().map(|&(wi, wo, nm)| brdf_spectrum(fields, optics, wi, wo, &[nm]).unwrap()[0]).collect();
    let floor = 0.1 * quantile(&exact, 0.5);
    let found = places.iter().map(|&(wi, wo, nm)| tables.eval(Interpolation::Cubic, wi, wo, &[nm])[0]);
    let pairs = exact.iter().zip(found).filter(|(exact, _)| **exact > floor);
    pairs.map(|(exact, found)| (found / exact - 1.0).abs()).collect()
}

#[test]
fn single_wavelengths_meet_the_direct_sum() {
    let fields = [random([101, 120], [170.0, 150.0], 380.0, 70.0, 7)];
    for (edge, windows) in PLACEMENTS {
        for factor in [Factor::Vector, Factor::Scalar] {
            let optics = optics(edge, windows, 1_500.0, factor);
            let tables = tables_config(TOLERANCE, None);
            let set = spectral_tables(&fields, &optics, &tables);
            let within = |a: &(Vec3, Vec3, f64)| (0..2).all(|c| (a.0[c] + a.1[c]).abs() < 1.1);
            let places: Vec<_> = places(40).into_iter().filter(within).collect();
            let errors = errors(&set, &fields, &optics, &places);
            let [median, p95] = [0.5, 0.95].map(|share| quantile(&errors, share));
            assert!(errors.len() > 50 && p95 < TOLERANCE, "{edge:?} {windows:?} {factor:?}: {median:e} {p95:e}");
        }
    }
}

/// Relative differences of Y between the tables of XYZ and the spectral ones under a light, and their count.
fn against_xyz(tables: &SpectralTables, xyz: &TableSet, illuminant: &Illuminant) -> Vec<f64> {
    let light = tables.under(Interpolation::Cubic, illuminant).unwrap();
    let pairs: Vec<(Vec3, Vec3)> = Region::ALL.into_iter().flat_map(|region| direction_pairs(region, 60)).collect();
    let of = |xyz: [f64; 3]| xyz.iter().sum::<f64>();
    let exact: Vec<f64> = pairs.iter().map(|&(wi, wo)| of(brdf_xyz(xyz, Interpolation::Cubic, wi, wo))).collect();
    let floor = 0.1 * quantile(&exact, 0.5);
    let lit = pairs.iter().zip(&exact).filter(|(_, exact)| **exact > floor);
    lit.map(|((wi, wo), exact)| (of(light.eval(*wi, *wo)) / exact - 1.0).abs()).collect()
}

#[test]
fn any_light_gives_what_tables_made_for_it_hold() {
    let fields = [random([101, 120], [170.0, 150.0], 380.0, 70.0, 7)];
    let tables = tables_config(TOLERANCE, None);
    let made_with = optics(Edge::Tile, Windows::Grid, 1_500.0, Factor::Vector);
    let set = spectral_tables(&fields, &made_with, &tables);
    let lines = [450.0, 532.0, 632.8].map(|wavelength_nm| Line { wavelength_nm, power: 1.0 });
    for illuminant in [Illuminant::D65, Illuminant::A, Illuminant::F(11), Illuminant::Lines(lines.to_vec())] {
        let optics = OpticsConfig { illuminant: illuminant.clone(), ..made_with.clone() };
        let (xyz, _) = build(&BuildInput::new(&fields, &optics, &tables), &|_| ()).unwrap();
        let errors = against_xyz(&set, &xyz, &illuminant);
        // Both keep the tolerance in 95 % of directions.
        let [count, p95] = [errors.len() as f64, quantile(&errors, 0.95)];
        assert!(count > 100.0 && p95 < 2.0 * TOLERANCE, "{illuminant:?}: {count} {p95:e}");
    }
}

#[test]
fn derived_tables_are_those_that_are_built() {
    let fields = [random([101, 120], [170.0, 150.0], 380.0, 70.0, 7)];
    let tables = tables_config(TOLERANCE, None);
    let lines = [450.0, 532.0, 632.8].map(|wavelength_nm| Line { wavelength_nm, power: 1.0 });
    let lights = [Illuminant::D65, Illuminant::A, Illuminant::Lines(lines.to_vec())];
    let pairs: Vec<(Vec3, Vec3)> = Region::ALL.into_iter().flat_map(|region| direction_pairs(region, 60)).collect();
    for (index, (edge, windows)) in PLACEMENTS.into_iter().enumerate() {
        let made_with = optics(edge, windows, 1_500.0, Factor::Vector);
        let spectral = spectral_tables(&fields, &made_with, &tables);
        // Every light for one placement, one light for every other.
        for illuminant in &lights[..if index == 0 { lights.len() } else { 1 }] {
            let optics = OpticsConfig { illuminant: illuminant.clone(), ..made_with.clone() };
            let (built, _) = build(&BuildInput::new(&fields, &optics, &tables), &|_| ()).unwrap();
            let light = DerivedLight { illuminant: illuminant.clone(), wavelength_nm: optics.wavelength_nm };
            let derived = spectral.xyz_tables(&light).unwrap();
            let of = |set: &TableSet| -> Vec<[f64; 3]> {
                pairs.iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Cubic, wi, wo)).collect()
            };
            let floor = 0.1 * quantile(&of(&built).iter().map(|xyz| xyz[1]).collect::<Vec<_>>(), 0.5);
            let found = colour_error_quantiles(&of(&built), &of(&derived), floor);
            assert!(found.count > 100 && found.p95 < 2.0 * TOLERANCE, "{edge:?} {windows:?} {illuminant:?}: {found:?}");
            if *illuminant != Illuminant::A {
                continue;
            }
            // Another light is seen.
            let other = DerivedLight { illuminant: Illuminant::F(2), ..light };
            let found = colour_error_quantiles(&of(&built), &of(&spectral.xyz_tables(&other).unwrap()), floor);
            assert!(found.p95 > 10.0 * TOLERANCE, "{found:?}");
        }
    }
}

#[test]
fn a_source_of_fixed_size_is_held_where_the_scan_limits_the_rest() {
    // A source of 3 degrees: windows of 3.3 to 6.7 um, of which a scan 8 um wide resolves 2 um.
    let fields = [random([64, 64], [125.0, 125.0], 300.0, 60.0, 11)];
    let source = OpticsConfig { source_deg: Some(3.0), ..optics(Edge::Auto, Windows::Grid, 1.0, Factor::Vector) };
    let made_for = source.for_scans(&fields);
    assert!(obstacle(&made_for).is_none());
    let set = spectral_tables(&fields, &made_for, &tables_config(TOLERANCE, None));
    let lobe = set.lobe.as_ref().unwrap();
    assert!(lobe.is_of_source && set.sigma_nm == 2_000.0 && (lobe.sigma_nm / 3_267.0 - 1.0).abs() < 1e-3, "{lobe:?}");
    let within = |a: &(Vec3, Vec3, f64)| (0..2).all(|c| (a.0[c] + a.1[c]).abs() < 1.1);
    let places: Vec<_> = places(40).into_iter().filter(within).collect();
    // Within the lobe, half of it the mirror direction itself.
    let mirror = |(n, (wi, _, nm)): (usize, &(Vec3, Vec3, f64))| {
        let off = if n % 2 == 0 { 0.0 } else { 0.01 };
        let [x, y] = [off - wi[0], -wi[1]];
        (*wi, [x, y, (1.0 - x * x - y * y).max(1e-6).sqrt()], *nm)
    };
    let in_lobe: Vec<_> = places.iter().enumerate().map(mirror).collect();
    for places in [&places, &in_lobe] {
        let errors = errors(&set, &fields, &made_for, places);
        let [median, p95] = [0.5, 0.95].map(|share| quantile(&errors, share));
        assert!(errors.len() > 40 && p95 < TOLERANCE, "{median:e} {p95:e}");
    }
    // A lobe of one width at every wavelength is found.
    let constant = SpectralLobe { is_of_source: false, ..lobe.clone() };
    let wrong = SpectralTables { lobe: Some(constant), ..set.clone() };
    assert!(quantile(&errors(&wrong, &fields, &made_for, &in_lobe), 0.5) > 0.1);
    // Files keep it.
    let folder = tempfile::tempdir().unwrap();
    let stored = write_spectral(folder.path(), &set, Storage::Float).unwrap();
    assert!(stored.formula.contains("C lobe") && !stored.formula.contains("r^2 C lobe"));
    assert_eq!(read_spectral(folder.path(), &stored, set.front_factor).unwrap(), set);
    // A scan that tells windows of 3.3 and 6.7 um apart has no such tables, and says why.
    let large = [random([256, 256], [125.0, 125.0], 300.0, 60.0, 11)];
    let optics = source.for_scans(&large);
    let why = obstacle(&optics).unwrap();
    assert!(why.contains("3.3 and 6.7 um"), "{why}");
    let tables = tables_config(TOLERANCE, None);
    let settings = SpectralInput::new(&optics, &tables);
    let error = build_spectral(&BuildInput::new(&large, &optics, &tables), &settings, &|_| ()).unwrap_err();
    assert!(error.to_string().contains(&why), "{error}");
}

#[test]
fn a_wrong_power_of_the_wavelength_and_a_wrong_reach_are_found() {
    let fields = [random([101, 120], [170.0, 150.0], 380.0, 70.0, 7)];
    let optics = optics(Edge::Tile, Windows::Grid, 1_500.0, Factor::Vector);
    let set = spectral_tables(&fields, &optics, &tables_config(TOLERANCE, None));
    let places = places(25);
    let p95 = |set: &SpectralTables| quantile(&errors(set, &fields, &optics, &places), 0.95);
    assert!(p95(&set) < TOLERANCE);
    // A shortest wavelength that is off by a percent shifts powers, frequencies and the largest phase scale.
    for shortest_nm in [1.01 * set.shortest_nm, 0.99 * set.shortest_nm] {
        assert!(p95(&SpectralTables { shortest_nm, ..set.clone() }) > 10.0 * TOLERANCE);
    }
    // One power of λ0/λ less.
    let short =
        |(wi, wo, nm): (Vec3, Vec3, f64)| set.eval(Interpolation::Cubic, wi, wo, &[nm])[0] * nm / set.shortest_nm;
    let exact = |(wi, wo, nm)| brdf_spectrum(&fields, &optics, wi, wo, &[nm]).unwrap()[0];
    let errors: Vec<f64> = places.iter().map(|&place| (short(place) / exact(place) - 1.0).abs()).collect();
    assert!(quantile(&errors, 0.5) > 0.1);
}

#[test]
fn files_give_back_what_was_built() {
    let fields = [random([101, 120], [170.0, 150.0], 380.0, 70.0, 7)];
    for (edge, windows) in PLACEMENTS {
        let optics = optics(edge, windows, 1_500.0, Factor::Vector);
        let set =
            spectral_tables(&fields, &optics, &TablesConfig { size: Some(101), ..tables_config(TOLERANCE, None) });
        let folder = tempfile::tempdir().unwrap();
        let stored = write_spectral(folder.path(), &set, Storage::Float).unwrap();
        assert_eq!(read_spectral(folder.path(), &stored, set.front_factor).unwrap(), set);
        // Halves are off by their rounding, and no more.
        let halves = write_spectral(folder.path(), &set, Storage::Half).unwrap();
        let read = read_spectral(folder.path(), &halves, set.front_factor).unwrap();
        let images = read.images.iter().zip(&set.images).zip(&halves.images);
        for ((read, built), stored) in images {
            let worst = read.iter().zip(built).map(|(a, b)| f64::from((a - b).abs())).fold(0.0, f64::max);
            assert!(worst > 0.0 && worst <= stored.peak / 2048.0, "{worst:e}");
        }
        let moved = StoredSpectral { shortest_nm: 400.0, ..stored };
        let error = read_spectral(folder.path(), &moved, set.front_factor).unwrap_err().to_string();
        assert!(error.contains("axis xi"), "{error}");
    }
}

#[test]
fn what_the_tables_cannot_tell_is_said() {
    let fields = [random([101, 120], [170.0, 150.0], 380.0, 70.0, 7)];
    let optics = optics(Edge::Tile, Windows::Grid, 1_500.0, Factor::Vector);
    let set = spectral_tables(&fields, &optics, &TablesConfig { size: Some(51), ..tables_config(TOLERANCE, None) });
    let up = [0.0, 0.0, 1.0];
    let error = set.check_wavelengths(&[500.0, 379.0]).unwrap_err().to_string();
    assert!(error.contains("begin at 380 nm") && error.contains("379"), "{error}");
    assert!(set.check_wavelengths(&[380.0, 1064.0]).is_ok());
    assert!(set.eval(Interpolation::Bilinear, up, up, &[379.0])[0].is_nan());
    assert_eq!(set.eval(Interpolation::Bilinear, [0.6, 0.0, -0.8], up, &[500.0]), [0.0]);
    let laser = Illuminant::Lines(vec![Line { wavelength_nm: 355.0, power: 1.0 }]);
    assert!(set.under(Interpolation::Bilinear, &laser).unwrap_err().to_string().contains("355"));
}
