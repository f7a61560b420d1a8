//! A source of fixed angular size: its own disc blurs everything over (u, v), by as much at every wavelength.

use std::f64::consts::PI;

use crate::common::optics_forms::front;
use crate::common::surfaces::{centred, flat, laser, outgoing, quantile, random, sampled, tables_config};
use diffraction_brdf::direction::{Vec3, from_angles_deg, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Factor, Material, OpticsConfig, Windows};
use diffraction_build::optics::{reference, spectral};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::plan::plan;

type Pair = (Vec3, Vec3);

const SOURCE_DEG: f64 = 2.0;

/// Deviation of a uniform disc of the source's diameter along an axis.
fn disc_deviation() -> f64 {
    0.25 * SOURCE_DEG.to_radians()
}

/// One wavelength of a source of this size on the repeated scan.
fn under(source_deg: f64, wavelength_nm: f64) -> OpticsConfig {
    laser(&[wavelength_nm], 1.0, Edge::Tile, Windows::Grid).with_source(source_deg)
}

/// The light that a wrong account of the source makes of it: twice as wide; coherent as at 550 nm, whatever the wavelength.
fn wrong(wavelength_nm: f64) -> [OpticsConfig; 2] {
    let constant_nm = under(SOURCE_DEG, 550.0).sigma_nm;
    [under(2.0 * SOURCE_DEG, wavelength_nm), laser(&[wavelength_nm], constant_nm, Edge::Tile, Windows::Grid)]
}

/// Y of one scan by the direct sum, and from its transforms.
fn both(field: &HeightField, optics: &OpticsConfig, pairs: &[Pair]) -> [Vec<f64>; 2] {
    let fields = std::slice::from_ref(field);
    let spectra = plan(&BuildInput::new(fields, optics, &tables_config(1e-3, Some(51)))).unwrap().spectra;
    let direct = reference::brdf_xyz_batch(fields, optics, pairs).unwrap();
    let fast = spectral::brdf_xyz_batch(fields, optics, &spectra, pairs).unwrap();
    [direct, fast].map(|values| values.iter().map(|xyz| xyz[1]).collect())
}

#[test]
fn a_mirror_shows_the_source_itself_whatever_the_wavelength() {
    let mirror = flat([64, 64], [200.0; 2]);
    let wi = from_angles_deg(25.0, 60.0);
    let s = disc_deviation();
    let offsets = [[0.0, 0.0], [s, 0.0], [0.6 * s, -1.5 * s], [-2.0 * s, 1.0 * s]];
    let pairs = offsets.map(|[u, v]| (wi, outgoing(wi, u, v).unwrap()));
    // ∫ f cos θo dω = R G / w², spread over (u, v) as a Gaussian of the disc's deviation.
    let exact = |(pair, [u, v]): (&Pair, [f64; 2])| {
        front(Material::Ideal, pair.0, pair.1) * (-0.5 * (u * u + v * v) / (s * s)).exp() / (2.0 * PI * s * s)
    };
    let exact: Vec<f64> = pairs.iter().zip(offsets).map(exact).collect();
    let off = |found: &[f64]| found.iter().zip(&exact).map(|(f, e)| (f / e - 1.0).abs()).fold(0.0, f64::max);
    for wavelength_nm in [450.0, 550.0, 650.0] {
        let [direct, fast] = both(&mirror, &under(SOURCE_DEG, wavelength_nm), &pairs);
        println!("{wavelength_nm} nm: direct sum {:.1e}, transforms {:.1e}", off(&direct), off(&fast));
        assert!(off(&direct) < 1e-9 && off(&fast) < 1e-9, "{wavelength_nm}: {direct:?} {fast:?} {exact:?}");
        let [wide, constant] = wrong(wavelength_nm).map(|optics| off(&both(&mirror, &optics, &pairs)[0]));
        assert!(wide > 0.5 && (constant > 0.1) == (wavelength_nm != 550.0), "{wavelength_nm}: {wide} {constant}");
    }
}

/// A grating of whole periods, which resolves any coherence.
const PERIOD_NM: f64 = 2_000.0;

#[test]
fn orders_are_as_wide_in_the_blue_as_in_the_red() {
    let grating = sampled([100, 100], [100.0; 2], |x, _| 40.0 * (std::f64::consts::TAU * x / PERIOD_NM).cos());
    let wi = from_angles_deg(20.0, 0.0);
    let s = disc_deviation();
    for wavelength_nm in [450.0, 650.0] {
        let order = -wavelength_nm / PERIOD_NM;
        let pairs = [0.0, 1.5 * s].map(|v| (wi, outgoing(wi, order, v).unwrap()));
        let fall = |optics: &OpticsConfig, by: usize| {
            let found = both(&grating, &optics.for_scans(std::slice::from_ref(&grating)), &pairs);
            let [peak, flank] = [0, 1].map(|i| found[by][i] / front(Material::Ideal, pairs[i].0, pairs[i].1));
            (flank / peak / (-0.5f64 * 1.5 * 1.5).exp() - 1.0).abs()
        };
        // The order's own power is a Bessel function of w, nearly the same at both.
        let auto = OpticsConfig { edge: Edge::Auto, ..under(SOURCE_DEG, wavelength_nm) };
        let [direct, fast] = [0, 1].map(|by| fall(&auto, by));
        println!("{wavelength_nm} nm: direct sum {direct:.1e}, transforms {fast:.1e}");
        assert!(direct < 2e-3 && fast < 2e-3, "{wavelength_nm}: {direct} {fast}");
        let [wide, constant] = wrong(wavelength_nm).map(|optics| fall(&optics, 0));
        assert!(wide > 0.5 && constant > 0.1, "{wavelength_nm}: {wide} {constant}");
    }
}

/// A rough film, daylight on a dielectric, as much of the source's coherence as the scan resolves.
fn film_by_day(side_nm: f64, source_deg: f64) -> (HeightField, OpticsConfig) {
    let count = (side_nm / 100.0).round() as usize;
    let field = centred(random([count; 2], [side_nm / count as f64; 2], 200.0, 20.0, 11));
    let light = OpticsConfig {
        illuminant: Illuminant::D65,
        material: Material::Dielectric { n: 1.5 },
        factor: Factor::Vector,
        ..laser(&[550.0], 1.0, Edge::Auto, Windows::Grid)
    };
    let optics = light.with_source(source_deg).for_scans(std::slice::from_ref(&field));
    (field, optics)
}

#[test]
fn transforms_and_tables_meet_the_direct_sum_under_a_source() {
    // A scan that resolves the source's coherence at every wavelength, at some, and at none of them.
    for (side_nm, source_deg, capped) in
        [(6_000.0, 14.0, false), (5_000.0, 10.0, true), (4_000.0, 6.0, true), (4_000.0, 2.0, true)]
    {
        let (field, optics) = film_by_day(side_nm, source_deg);
        assert_eq!(optics.lobe_sigma_nm.is_some(), capped, "{source_deg} {}", optics.sigma_nm);
        let fields = std::slice::from_ref(&field);
        let wi = from_angles_deg(35.0, 40.0);
        let s = 0.25 * source_deg.to_radians();
        let near = [0.0, 0.7, 1.5, 2.5].map(|widths| (wi, outgoing(wi, widths * s, 0.3 * widths * s).unwrap()));
        let low = from_angles_deg(88.0, 10.0);
        let grazing = [0.0, 0.5, 1.0].map(|by| (low, from_angles_deg(88.0 + by, 190.3)));
        let is_away = |pair: &Pair| {
            let [u, v, _] = wave_vector_change(pair.0, pair.1);
            (0.25..0.9).contains(&u.hypot(v))
        };
        let away = direction_pairs(Region::Hemisphere, 200).into_iter().filter(is_away).take(20);
        let pairs: Vec<Pair> = away.chain(near).chain(grazing).collect();
        let [direct, fast] = both(&field, &optics, &pairs);
        let errors = |found: &[f64]| -> Vec<f64> {
            found.iter().zip(&direct).map(|(found, direct)| (found / direct - 1.0).abs()).collect()
        };
        let worst = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
        let (set, _) = build(&BuildInput::new(fields, &optics, &tables_config(1e-3, Some(401))), &|_| ()).unwrap();
        let of_tables = |p: &Pair| brdf_xyz(&set, Interpolation::Cubic, p.0, p.1)[1];
        let tables = errors(&pairs.iter().map(of_tables).collect::<Vec<_>>());
        println!("{source_deg} degrees: transforms {:.1e}, tables {:.1e}", worst(&errors(&fast)), worst(&tables));
        assert!(worst(&errors(&fast)) < 1e-4, "{source_deg}: {:?}", errors(&fast));
        assert!(worst(&tables) < 5e-3, "{source_deg}: {tables:?}");
        // One coherence at every wavelength, that of 550 nm, is another light.
        let at_550 = |coherence: diffraction_build::optics::coherence::Coherence| coherence.sigma_nm_at(550.0);
        let constant = OpticsConfig {
            sigma_nm: at_550(optics.body_coherence()),
            lobe_sigma_nm: Some(at_550(optics.lobe_coherence())),
            source_deg: None,
            ..optics.clone()
        };
        let by_constant = errors(&both(&field, &constant, &pairs)[1]);
        println!("  one coherence: median {:.1e}, worst {:.1e}", quantile(&by_constant, 0.5), worst(&by_constant));
        assert!(worst(&by_constant) > 0.02, "{source_deg}: {by_constant:?}");
    }
}

#[test]
fn windows_on_the_scan_itself_are_refused() {
    let field = flat([640, 640], [100.0; 2]);
    for (edge, windows) in [(Edge::Fade, Windows::Grid), (Edge::Tile, Windows::Centre)] {
        let optics = OpticsConfig { edge, windows, ..under(SOURCE_DEG, 550.0) };
        let refused =
            reference::brdf_xyz(std::slice::from_ref(&field), &optics, [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).unwrap_err();
        assert!(refused.to_string().contains("source"), "{refused}");
    }
}
