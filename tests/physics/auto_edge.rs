//! `edge = "auto"`: what a scan that is smaller than the light's coherence shows, and what it does not invent.

use std::f64::consts::{PI, TAU};

use crate::common::optics_forms::front;
use crate::common::surfaces::{centred, laser, lobe_deviation, outgoing, quantile, random, sampled, tables_config};
use diffraction_brdf::direction::{Vec3, from_angles_deg, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::accuracy::power_sums::reflected;
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Factor, Material, OpticsConfig, TILE_SIGMAS, Windows};
use diffraction_build::optics::{reference, spectral};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Prefilter, TablesConfig};
use diffraction_build::tables::plan::plan;

type Pair = (Vec3, Vec3);

const WAVELENGTH_NM: f64 = 550.0;

/// A rough film of this side without any period.
fn film(side_nm: f64, seed: u64) -> HeightField {
    let count = (side_nm / 100.0).round() as usize;
    centred(random([count; 2], [side_nm / count as f64; 2], 200.0, 20.0, seed))
}

/// Daylight on a dielectric, as much coherence as the scan resolves where the edge asks for that.
fn daylight(field: &HeightField, sigma_nm: f64, edge: Edge) -> OpticsConfig {
    let optics = OpticsConfig {
        illuminant: Illuminant::D65,
        material: Material::Dielectric { n: 1.5 },
        factor: Factor::Vector,
        ..laser(&[WAVELENGTH_NM], sigma_nm, edge, Windows::Grid)
    };
    optics.for_scans(std::slice::from_ref(field))
}

/// Directions outside of the mirror's surroundings, near enough for the spectrum not to blur a comb into an even light.
fn away(count: usize) -> Vec<Pair> {
    let pairs = direction_pairs(Region::Hemisphere, 16 * count);
    let is_away = |pair: &Pair| {
        let [u, v, _] = wave_vector_change(pair.0, pair.1);
        (0.25..0.6).contains(&u.hypot(v))
    };
    pairs.into_iter().filter(is_away).take(count).collect()
}

fn luminances(field: &HeightField, optics: &OpticsConfig, pairs: &[Pair]) -> Vec<f64> {
    let fields = std::slice::from_ref(field);
    let spectra = plan(&BuildInput::new(fields, optics, &tables_config(1e-3, Some(51)))).unwrap().spectra;
    spectral::brdf_xyz_batch(fields, optics, &spectra, pairs).unwrap().iter().map(|xyz| xyz[1]).collect()
}

/// Median over mean of Y: near 1 where light is even, near 0 where it is gathered in combs with dark gaps.
fn evenness(field: &HeightField, optics: &OpticsConfig, pairs: &[Pair]) -> f64 {
    let y = luminances(field, optics, pairs);
    quantile(&y, 0.5) / (y.iter().sum::<f64>() / y.len() as f64)
}

/// How much less even a scan may be than one four times as wide, whose lines are sixteen times as many: speckle.
const LESS_EVEN: f64 = 0.88;

#[test]
fn a_small_scan_of_a_film_shows_no_comb() {
    const SIDE_NM: f64 = 10_000.0;
    let (small, large) = (film(SIDE_NM, 1), film(4.0 * SIDE_NM, 2));
    let pairs = away(240);
    for sides in [0.2, 0.5, 1.0, 2.0, 2.5, 3.0, 4.0, 8.0, 20.0] {
        let sigma_nm = SIDE_NM / sides;
        let of = |field: &HeightField, edge| evenness(field, &daylight(field, sigma_nm, edge), &pairs);
        let (auto, tile, wide) = (of(&small, Edge::Auto), of(&small, Edge::Tile), of(&large, Edge::Auto));
        println!("L = {sides} sigma: auto {auto:.3}, tile {tile:.3}, four times as wide {wide:.3}");
        assert!((LESS_EVEN..1.0 / LESS_EVEN).contains(&(auto / wide)), "L = {sides} sigma: {auto} {wide}");
        // A repeated scan shows its own repetition up to three deviations a side.
        let is_even = (LESS_EVEN..1.0 / LESS_EVEN).contains(&(tile / wide));
        assert_eq!(is_even, sides > 3.5, "L = {sides} sigma, tile: {tile} {wide}");
    }
}

/// A grating of five periods along x under a light of three times the scan's side.
const PERIOD_NM: f64 = 1_600.0;
const LIGHT_SIGMA_NM: f64 = 24_000.0;

fn grating() -> HeightField {
    sampled([80, 80], [100.0; 2], |x, _| 40.0 * (TAU * x / PERIOD_NM).cos())
}

/// Y of the BRDF of a scan at pairs of directions, by one of the evaluations that are compared.
type Evaluation<'a> = &'a dyn Fn(&HeightField, &OpticsConfig, &[Pair]) -> Vec<f64>;

/// How far the mirror's peak is off that of the light's width, and the first order's width off what the scan resolves.
fn widths(optics: &OpticsConfig, value: Evaluation) -> [f64; 2] {
    let field = grating();
    let wi = from_angles_deg(20.0, 0.0);
    let (wide_nm, light_nm) = (8_000.0 / TILE_SIGMAS, LIGHT_SIGMA_NM);
    let order = -WAVELENGTH_NM / PERIOD_NM;
    let deviation = lobe_deviation(wide_nm, WAVELENGTH_NM);
    let at = |u: f64, v: f64| (wi, outgoing(wi, u, v).unwrap());
    let pairs = [at(0.0, 0.0), at(order, 0.0), at(order, 1.5 * deviation)];
    let found = value(&field, optics, &pairs);
    // The mean phasor of whole periods is a Bessel function; the diffuse part below the peak is a hundredth of it.
    let mean = |w: f64| {
        let phase = |t: usize| TAU / WAVELENGTH_NM * w * 40.0 * (TAU * t as f64 / 256.0).cos();
        (0..256).map(|t| phase(t).cos()).sum::<f64>() / 256.0
    };
    let (mirror, w) = (pairs[0], pairs[0].0[2] + pairs[0].1[2]);
    let peak =
        front(Material::Ideal, mirror.0, mirror.1) * mean(w).powi(2) * 4.0 * PI * (light_nm / WAVELENGTH_NM).powi(2);
    let bright = |pair: &Pair| front(Material::Ideal, pair.0, pair.1);
    // Along v only the order's own lines are seen: exp(-1.5²/2), front factor apart; J_1 at two nearby w is nearly the same.
    let fall = found[2] / bright(&pairs[2]) / (found[1] / bright(&pairs[1]));
    [(found[0] / peak - 1.0).abs(), (fall / (-0.5f64 * 1.5 * 1.5).exp() - 1.0).abs()]
}

#[test]
fn the_lobe_is_as_wide_as_the_light_says_and_orders_as_the_scan_can_tell() {
    let light = laser(&[WAVELENGTH_NM], LIGHT_SIGMA_NM, Edge::Auto, Windows::Grid);
    // Whole periods resolve any coherence, a film of that size a quarter of its side.
    assert_eq!(light.for_scans(&[grating()]), light);
    let film = light.for_scans(&[film(8_000.0, 3)]);
    assert_eq!((film.sigma_nm, film.lobe_sigma_nm), (2_000.0, Some(LIGHT_SIGMA_NM)));
    // Its widths in closed form take the grating.
    let right = film;
    let exchanged = OpticsConfig { sigma_nm: LIGHT_SIGMA_NM, lobe_sigma_nm: Some(right.sigma_nm), ..right.clone() };
    let direct = |field: &HeightField, optics: &OpticsConfig, pairs: &[Pair]| {
        let values = reference::brdf_xyz_batch(std::slice::from_ref(field), optics, pairs).unwrap();
        values.iter().map(|xyz| xyz[1]).collect()
    };
    for (name, value) in [("direct sum", &direct as &dyn Fn(&_, &_, &_) -> _), ("transforms", &luminances)] {
        let [peak, fall] = widths(&right, value);
        println!("{name}: peak off by {peak:.1e}, fall by {fall:.1e}");
        assert!(peak < 0.03 && fall < 0.05, "{name}: {peak} {fall}");
        let [peak, fall] = widths(&exchanged, value);
        assert!(peak > 0.5 && fall > 0.5, "{name}, exchanged: {peak} {fall}");
    }
}

#[test]
fn blurring_the_diffuse_part_keeps_its_power() {
    let side_nm = 8_000.0;
    for (name, field) in [("film", film(side_nm, 5)), ("grating", grating())] {
        let sums = [Edge::Auto, Edge::Tile].map(|edge| {
            let told = daylight(&film(side_nm, 5), 4_000.0, edge);
            assert_eq!(told.lobe_sigma_nm.is_some(), edge == Edge::Auto);
            // The grating too, although its whole periods would resolve more: power knows no difference.
            let optics = OpticsConfig { material: Material::Ideal, ..told };
            // Texels that average over themselves lose nothing between them.
            let config = TablesConfig { prefilter: Prefilter::Auto, ..tables_config(1e-3, Some(301)) };
            let fields = std::slice::from_ref(&field);
            let set = build(&BuildInput::new(fields, &optics, &config), &|_| ()).unwrap().0;
            reflected(&set).power_sums
        });
        for (auto, tile) in sums[0].iter().zip(&sums[1]) {
            println!("{name}, {} degrees: auto {:.4}, tile {:.4}", auto.theta_i_deg, auto.sum, tile.sum);
            assert!((auto.sum / tile.sum - 1.0).abs() < 0.01, "{name}: {auto:?} {tile:?}");
        }
    }
}

#[test]
fn transforms_and_tables_meet_the_direct_sum_where_the_scan_resolves_less_than_the_light() {
    for material in [Material::Ideal, Material::Dielectric { n: 1.5 }] {
        let field = film(4_000.0, 7);
        let optics = OpticsConfig { material, ..daylight(&field, 4_000.0, Edge::Auto) };
        assert_eq!((optics.sigma_nm, optics.lobe_sigma_nm), (1_000.0, Some(4_000.0)));
        let fields = std::slice::from_ref(&field);
        let wi = from_angles_deg(35.0, 40.0);
        let width = lobe_deviation(4_000.0, WAVELENGTH_NM);
        let near =
            [0.0, 0.7, 1.5, 2.5, 4.0].map(|widths| (wi, outgoing(wi, widths * width, 0.3 * widths * width).unwrap()));
        // At grazing angles the lobe's image in the horizon counts.
        let low = from_angles_deg(88.0, 10.0);
        let grazing = [0.0, 0.5, 1.0].map(|by| (low, from_angles_deg(88.0 + by, 190.3)));
        let pairs: Vec<Pair> = away(20).into_iter().chain(near).chain(grazing).collect();
        let y = |xyz: &[f64; 3]| xyz[1];
        let direct: Vec<f64> = reference::brdf_xyz_batch(fields, &optics, &pairs).unwrap().iter().map(y).collect();
        let errors = |found: &[f64]| -> Vec<f64> {
            found.iter().zip(&direct).map(|(found, direct)| (found / direct - 1.0).abs()).collect()
        };
        let worst = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
        let fast = errors(&luminances(&field, &optics, &pairs));
        let (set, _) = build(&BuildInput::new(fields, &optics, &tables_config(1e-3, Some(401))), &|_| ()).unwrap();
        let of_tables = |p: &Pair| brdf_xyz(&set, Interpolation::Cubic, p.0, p.1)[1];
        let tables = errors(&pairs.iter().map(of_tables).collect::<Vec<_>>());
        println!("{material:?}: transforms {:.1e}, tables {:.1e}", worst(&fast), worst(&tables));
        assert!(worst(&fast) < 1e-4, "{fast:?}");
        assert!(worst(&tables) < 5e-3, "{tables:?}");
        // The window of the light in place of the scan's is another surface.
        let tile = OpticsConfig { sigma_nm: 4_000.0, lobe_sigma_nm: None, edge: Edge::Tile, ..optics.clone() };
        assert!(quantile(&errors(&luminances(&field, &tile, &pairs)), 0.5) > 0.02);
    }
}
