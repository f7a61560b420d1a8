//! Symmetries of the BRDF: reciprocity, turns, mirror images, moved tiles, a raised surface, thread counts.

use crate::common::surfaces::{
    PLACEMENTS, half_turn, laser, mirrored_x, quantile, random, rolled, sampled, tables_config,
};
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::reference::brdf_xyz_batch;
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{TableSet, TablesConfig};

type Pair = (Vec3, Vec3);

/// Two lines: X, Y and Z are then different mixtures.
fn optics(edge: Edge, windows: Windows) -> OpticsConfig {
    OpticsConfig {
        material: Material::Conductor { n: 0.27, k: 2.77 },
        shadowing: true,
        ..laser(&[470.0, 610.0], 2_000.0, edge, windows)
    }
}

/// Different along x and y, no symmetry of its own, odd along one axis and even along the other; wide
/// enough for the four windows of `Windows::Grid`.
fn surface() -> HeightField {
    let field = random([101, 120], [200.0, 170.0], 380.0, 70.0, 7);
    crate::common::surfaces::centred(field)
}

/// Directions for which the sampling of the scan, at most 200 nm, can answer at 470 nm.
fn pairs(region: Region) -> Vec<Pair> {
    let within = |a: &Pair| (0..2).all(|c| (a.0[c] + a.1[c]).abs() < 1.17);
    let pairs: Vec<Pair> = direction_pairs(region, 70).into_iter().filter(within).collect();
    assert!(pairs.len() > 30);
    pairs
}

fn reference(field: &HeightField, optics: &OpticsConfig, pairs: &[Pair]) -> Vec<Xyz> {
    brdf_xyz_batch(std::slice::from_ref(field), optics, pairs).unwrap()
}

/// Six tables whatever the surface: the program's own choice may differ between a surface and its image.
fn stored(field: &HeightField, optics: &OpticsConfig) -> TableSet {
    let config = TablesConfig { count: Some(6), ..tables_config(1e-2, Some(201)) };
    build(&BuildInput::new(std::slice::from_ref(field), optics, &config), &|_| ()).unwrap().0
}

fn table(set: &TableSet, pairs: &[Pair]) -> Vec<Xyz> {
    pairs.iter().map(|p| brdf_xyz(set, Interpolation::Cubic, p.0, p.1)).collect()
}

/// Largest relative difference of X + Y + Z, and the median one.
fn difference(a: &[Xyz], b: &[Xyz]) -> [f64; 2] {
    let total = |xyz: &Xyz| xyz.iter().sum::<f64>();
    let errors: Vec<f64> = a.iter().zip(b).map(|(a, b)| (total(a) - total(b)).abs() / total(b).abs()).collect();
    assert!(errors.iter().all(|e| e.is_finite()), "a direction without light decides nothing");
    [quantile(&errors, 1.0), quantile(&errors, 0.5)]
}

/// Double precision, sums of 12120 terms of which a thousandth is left: 1e-16 · sqrt(12120) / 1e-3.
const ROUNDING: f64 = 2e-11;

/// Tables of 32-bit floats: transforms and coefficients are rounded to 6e-8 of the largest depth node or
/// coefficient, of which dark directions keep a hundredth or less.
const FLOAT_ROUNDING: f64 = 1e-4;

#[test]
fn light_and_viewer_may_change_places() {
    for (edge, windows) in PLACEMENTS {
        let (field, optics) = (surface(), optics(edge, windows));
        let set = stored(&field, &optics);
        for region in Region::ALL {
            let pairs = pairs(region);
            let back: Vec<Pair> = pairs.iter().map(|&(wi, wo)| (wo, wi)).collect();
            let worst = difference(&reference(&field, &optics, &pairs), &reference(&field, &optics, &back));
            assert!(worst[0] < ROUNDING, "{edge:?} {windows:?} {region:?}, reference: {worst:?}");
            // Both evaluations read the same texels with the same weights.
            let worst = difference(&table(&set, &pairs), &table(&set, &back));
            assert!(worst[0] < 1e-12, "{edge:?} {windows:?} {region:?}, tables: {worst:?}");
            // Were only one direction mirrored, the surface would look different.
            let wrong: Vec<Pair> = pairs.iter().map(|&(wi, wo)| (wo, [-wi[0], wi[1], wi[2]])).collect();
            assert!(difference(&table(&set, &wrong), &table(&set, &pairs))[1] > 0.05);
        }
    }
}

/// The scan changed in its plane, with the directions changed alike, against the same scan as it was.
fn check_turned(change: impl Fn(&HeightField) -> HeightField, turn: impl Fn(Vec3) -> Vec3) {
    for (edge, windows) in PLACEMENTS {
        let (field, optics) = (surface(), optics(edge, windows));
        let changed = change(&field);
        let pairs = pairs(Region::Hemisphere);
        let turned: Vec<Pair> = pairs.iter().map(|&(wi, wo)| (turn(wi), turn(wo))).collect();
        let still = reference(&field, &optics, &pairs);
        let worst = difference(&reference(&changed, &optics, &turned), &still);
        assert!(worst[0] < ROUNDING, "{edge:?} {windows:?}, reference: {worst:?}");
        let sets = [&field, &changed].map(|field| stored(field, &optics));
        let worst = difference(&table(&sets[1], &turned), &table(&sets[0], &pairs));
        assert!(worst[0] < FLOAT_ROUNDING, "{edge:?} {windows:?}, tables: {worst:?}");
        // The change itself is seen where the directions stay.
        assert!(difference(&reference(&changed, &optics, &pairs), &still)[1] > 0.05);
        assert!(difference(&table(&sets[1], &pairs), &table(&sets[0], &pairs))[1] > 0.05);
    }
}

#[test]
fn a_half_turn_of_the_scan_turns_the_light() {
    check_turned(half_turn, |d| [-d[0], -d[1], d[2]]);
}

#[test]
fn a_mirrored_scan_mirrors_the_light() {
    check_turned(mirrored_x, |d| [-d[0], d[1], d[2]]);
}

#[test]
fn the_mean_over_a_tile_does_not_depend_on_where_the_tile_begins() {
    let field = surface();
    let moved = rolled(&field, 25, 30);
    let pairs = pairs(Region::Hemisphere);
    for windows in [Windows::Grid, Windows::Centre] {
        let optics = optics(Edge::Tile, windows);
        let direct = difference(&reference(&moved, &optics, &pairs), &reference(&field, &optics, &pairs));
        let sets = [&field, &moved].map(|field| stored(field, &optics));
        let tabled = difference(&table(&sets[1], &pairs), &table(&sets[0], &pairs));
        if windows == Windows::Grid {
            assert!(direct[0] < ROUNDING, "reference: {direct:?}");
            assert!(tabled[0] < FLOAT_ROUNDING, "tables: {tabled:?}");
        } else {
            // One window sees another part of the surface: the very thing the mean is free of.
            assert!(direct[1] > 0.1 && tabled[1] > 0.1, "{direct:?} {tabled:?}");
        }
    }
}

#[test]
fn a_raised_surface_looks_the_same() {
    for (edge, windows) in PLACEMENTS {
        let (field, optics) = (surface(), optics(edge, windows));
        let mut raised = field.clone();
        raised.heights_nm += 2_000.0;
        let pairs = pairs(Region::Hemisphere);
        let worst = difference(&reference(&raised, &optics, &pairs), &reference(&field, &optics, &pairs));
        assert!(worst[0] < ROUNDING, "{edge:?} {windows:?}, reference: {worst:?}");
        let sets = [&field, &raised].map(|field| stored(field, &optics));
        let worst = difference(&table(&sets[1], &pairs), &table(&sets[0], &pairs));
        assert!(worst[0] < FLOAT_ROUNDING, "{edge:?} {windows:?}, tables: {worst:?}");
    }
}

#[test]
fn raising_only_half_of_a_surface_is_seen() {
    let optics = optics(Edge::Fade, Windows::Centre);
    let field = surface();
    let step = sampled(field.size(), field.pitch_nm, |x, _| if x > 0.0 { 137.0 } else { 0.0 });
    let mut raised = field.clone();
    raised.heights_nm += &step.heights_nm;
    let pairs = pairs(Region::Hemisphere);
    let seen = difference(&reference(&raised, &optics, &pairs), &reference(&field, &optics, &pairs));
    assert!(seen[1] > 0.05, "{seen:?}");
}

#[test]
fn threads_do_not_change_a_bit() {
    let field = surface();
    let pairs = pairs(Region::Hemisphere);
    for (edge, windows) in PLACEMENTS {
        let optics = optics(edge, windows);
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let config = tables_config(1e-2, Some(151));
                let (set, record) =
                    build(&BuildInput::new(std::slice::from_ref(&field), &optics, &config), &|_| ()).unwrap();
                (reference(&field, &optics, &pairs), set, record)
            })
        };
        let (one, two) = (run(1), run(2));
        let bits = |list: &[Xyz]| list.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&one.0), bits(&two.0), "{edge:?} {windows:?}");
        assert_eq!(one.2, two.2);
        let lobe = |set: &TableSet| {
            let lobe = set.lobe.as_ref().unwrap();
            let arrays = std::iter::once(&lobe.coherent).chain(&lobe.cross).chain(&set.tables);
            arrays.flat_map(|a| a.iter().map(|x| x.to_bits())).collect::<Vec<_>>()
        };
        let (one, two) = (lobe(&one.1), lobe(&two.1));
        assert!(one == two, "{edge:?} {windows:?}: tables differ between 1 and 2 threads");
        assert!(one.iter().any(|&bits| bits != 0));
    }
}
