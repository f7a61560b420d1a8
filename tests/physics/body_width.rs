//! How wide a window the diffuse part of a scan takes under `edge = "auto"`, by its mean square error against the mean over many
//! surfaces of one kind; and what the seams of a repeated scan add to it.

use std::f64::consts::{SQRT_2, TAU};

use crate::common::surfaces::{laser, lobe_deviation, outgoing};
use diffraction_brdf::direction::{Vec3, Xyz, from_angles_deg};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::height::prepare::{Level, PrepareConfig, prepare};
use diffraction_build::height::synthesize::{Structure, synthesize};
use diffraction_build::optics::config::{Edge, OpticsConfig, TILE_SIGMAS, Windows};
use diffraction_build::optics::spectra::SpectraConfig;
use diffraction_build::optics::spectral;
use ndarray::Array2;

type Pair = (Vec3, Vec3);

const WAVELENGTH_NM: f64 = 550.0;

/// Side of a scan, and its samples along it; a surface that scans are cut from is four times as wide.
const SIDE_NM: f64 = 10_000.0;
const SAMPLES: usize = 100;
const PITCH_NM: f64 = SIDE_NM / SAMPLES as f64;
const WIDE_SAMPLES: usize = 4 * SAMPLES;

/// What scans show.
#[derive(Clone, Copy)]
enum Kind {
    /// Rough, without a period: 25 nm rms.
    Film { correlation_length_nm: f64 },
    /// Fingers 1.14 µm apart, as a corn snake's.
    CornSnake,
    /// Rows of short fingers 1.55 µm apart, as a sunbeam snake's.
    SunbeamSnake,
    /// A sinusoid, 80 nm from valley to peak and turned by [`TURN_DEG`], of so many periods.
    Grating { periods: f64 },
}

const AMPLITUDE_NM: f64 = 40.0;
const TURN_DEG: f64 = 7.0;

impl Kind {
    /// The first order in sine, or where a film is looked at.
    fn order(self) -> f64 {
        match self {
            Kind::Film { .. } => 0.35,
            Kind::CornSnake => WAVELENGTH_NM / 1_140.0,
            Kind::SunbeamSnake => WAVELENGTH_NM / 1_550.0,
            Kind::Grating { periods } => WAVELENGTH_NM * periods / SIDE_NM,
        }
    }

    /// A surface four times as wide as a scan, which repeats.
    fn wide(self, seed: u64) -> HeightField {
        let structure = match self {
            Kind::Film { correlation_length_nm } => {
                Structure::GaussianRough { rms_nm: 25.0, correlation_length_nm, seed }
            }
            Kind::CornSnake => Structure::CornSnake { seed },
            Kind::SunbeamSnake => Structure::SunbeamSnake { seed },
            Kind::Grating { .. } => unreachable!("a grating is known in closed form"),
        };
        synthesize(&structure, [WIDE_SAMPLES; 2], [PITCH_NM; 2]).unwrap()
    }

    /// A scan as it comes out of preparing by default: a plane taken away, opposite edges as they are.
    fn scan(self, seed: u64) -> HeightField {
        let heights_nm = match self {
            Kind::Grating { periods } => {
                let (sin, cos) = TURN_DEG.to_radians().sin_cos();
                let (per_nm, phase) = (TAU * periods / SIDE_NM, TAU * fastrand::Rng::with_seed(seed).f64());
                Array2::from_shape_fn([SAMPLES; 2], |(row, column)| {
                    let (x, y) = (column as f64 * PITCH_NM, -(row as f64) * PITCH_NM);
                    AMPLITUDE_NM * (per_nm * (x * cos + y * sin) + phase).cos()
                })
            }
            _ => {
                let wide = self.wide(seed);
                Array2::from_shape_fn([SAMPLES; 2], |place| wide.heights_nm[place])
            }
        };
        prepared(HeightField { heights_nm, pitch_nm: [PITCH_NM; 2] }, Level::Plane, None)
    }

    /// XYZ of the mean over all surfaces under a light of this coherence: of a grating from one period, which repeats, of others
    /// from so many wide surfaces.
    fn truth(self, light: &Illuminant, light_nm: f64, count: u64) -> Vec<Xyz> {
        let at = self.directions(light, light_nm, 0.0);
        let optics = optics(light, light_nm, light_nm);
        if let Kind::Grating { periods } = self {
            let heights_nm = Array2::from_shape_fn([1, 64], |(_, i)| AMPLITUDE_NM * (TAU * i as f64 / 64.0).cos());
            return values(&HeightField { heights_nm, pitch_nm: [SIDE_NM / periods / 64.0, 100.0] }, &optics, &at);
        }
        let mut sum = vec![[0.0; 3]; at.len()];
        for seed in 0..count {
            for (sum, found) in sum.iter_mut().zip(values(&self.wide(seed), &optics, &at)) {
                (0..3).for_each(|c| sum[c] += found[c] / count as f64);
            }
        }
        sum
    }

    /// Directions around the first order, near enough to each other to see the light's own lobes, turned by an angle.
    fn directions(self, light: &Illuminant, light_nm: f64, turned_deg: f64) -> Vec<Pair> {
        let step = 1.5 * lobe_deviation(light_nm, WAVELENGTH_NM);
        // Daylight draws an order out to a spectrum.
        let wide = if *light == Illuminant::D65 { 0.35 * self.order() } else { 0.0 };
        let half = [(0.12 + wide).min(self.order() - 0.06), 0.13].map(|half| (half / step).ceil() as i32);
        let (sin, cos) = f64::to_radians(turned_deg).sin_cos();
        let wi = from_angles_deg(20.0, turned_deg);
        let mut pairs = Vec::new();
        for j in -half[1]..=half[1] {
            for i in -half[0]..=half[0] {
                let (u, v) = (f64::from(i) * step - self.order(), f64::from(j) * step);
                pairs.push((wi, outgoing(wi, u * cos - v * sin, u * sin + v * cos).unwrap()));
            }
        }
        pairs
    }

    /// Mean square error over directions and `count` scans of X, Y and Z, relative to their mean square in truth, for windows
    /// of a side over each of `sides`.
    fn errors(self, light: &Illuminant, light_nm: f64, sides: &[f64], count: u64) -> Vec<f64> {
        let truth = self.truth(light, light_nm, count);
        let turned_deg = if matches!(self, Kind::Grating { .. }) { TURN_DEG } else { 0.0 };
        let at = self.directions(light, light_nm, turned_deg);
        let square = |xyz: Xyz| xyz.iter().map(|x| x * x).sum::<f64>();
        let whole = count as f64 * truth.iter().copied().map(square).sum::<f64>();
        // Other surfaces than those of the truth.
        let scans: Vec<HeightField> = (0..count).map(|seed| self.scan(1_000 + seed)).collect();
        let of_window = |sides: &f64| {
            let body = optics(light, SIDE_NM / sides, light_nm);
            let of_scan = |scan| values(scan, &body, &at).into_iter().zip(&truth);
            let differences = scans.iter().flat_map(of_scan);
            differences.map(|(found, truth)| square([0, 1, 2].map(|c| found[c] - truth[c]))).sum::<f64>() / whole
        };
        sides.iter().map(of_window).collect()
    }
}

fn prepared(field: HeightField, level: Level, blend_nm: Option<f64>) -> HeightField {
    prepare(&field, &PrepareConfig { level, despike: None, blend_nm }).unwrap().0
}

fn optics(light: &Illuminant, body_nm: f64, light_nm: f64) -> OpticsConfig {
    let auto = laser(&[WAVELENGTH_NM], body_nm, Edge::Auto, Windows::Grid);
    OpticsConfig { illuminant: light.clone(), lobe_sigma_nm: Some(light_nm), ..auto }
}

fn values(field: &HeightField, optics: &OpticsConfig, pairs: &[Pair]) -> Vec<Xyz> {
    let [low_nm, _] = optics.illuminant.reach_nm(optics.wavelength_nm);
    let config = SpectraConfig {
        phase_scale_per_nm: [0.0, 2.0 * TAU / low_nm],
        frequency: [[-2.0 / low_nm, 2.0 / low_nm]; 2],
        tolerance: 1e-5,
        memory_bytes: 1 << 31,
    };
    spectral::brdf_xyz_batch(std::slice::from_ref(field), optics, &config, pairs).unwrap()
}

const FILMS: [Kind; 3] = [
    Kind::Film { correlation_length_nm: 250.0 },
    Kind::Film { correlation_length_nm: 500.0 },
    Kind::Film { correlation_length_nm: 1_000.0 },
];
const GRATINGS: [Kind; 3] =
    [Kind::Grating { periods: 3.3 }, Kind::Grating { periods: 6.4 }, Kind::Grating { periods: 12.7 }];

/// Films want narrow windows and orders wide ones. A quarter of the side costs least where each kind counts the same: under daylight,
/// half as coherent as the scan is wide.
#[test]
fn a_quarter_of_the_side_costs_least_over_films_snakes_and_gratings() {
    let kinds = [FILMS[1], Kind::CornSnake, Kind::SunbeamSnake, GRATINGS[1]];
    let sides = [2.0 * TILE_SIGMAS, TILE_SIGMAS, TILE_SIGMAS / 1.6];
    let errors = kinds.map(|kind| kind.errors(&Illuminant::D65, 0.5 * SIDE_NM, &sides, 3));
    let means = [0, 1, 2].map(|i| errors.iter().map(|of_kind| of_kind[i]).sum::<f64>() / kinds.len() as f64);
    println!("mean square errors {errors:.2?}, their means {means:.3?}");
    let [eighth, quarter, wide] = means;
    assert!(1.08 * quarter < eighth && 1.08 * quarter < wide, "{means:?}");
    // What the mean hides: neither kind alone would choose it.
    let [film, corn, _, grating] = &errors;
    assert!(film[0] < 0.6 * film[1] && corn[0] > 1.5 * corn[1] && grating[0] > 1.1 * grating[1], "{errors:?}");
}

/// Root mean square errors by kind and window, as docs/optics.md has them.
#[test]
#[ignore = "measures: a few minutes"]
fn measuring_windows_of_the_diffuse_part() {
    let sides = [12.0, 8.0, 6.0, 4.0, 3.0, 2.5];
    println!("light, sigma over L, kind: root mean square error at L over {sides:?}");
    let one_line = laser(&[WAVELENGTH_NM], SIDE_NM, Edge::Auto, Windows::Grid).illuminant;
    for (name, light) in [("daylight", Illuminant::D65), ("550 nm", one_line)] {
        for share in [0.5, 1.0] {
            let groups: [(&str, &[Kind]); 4] = [
                ("films", &FILMS),
                ("corn snake", &[Kind::CornSnake]),
                ("sunbeam snake", &[Kind::SunbeamSnake]),
                ("gratings", &GRATINGS),
            ];
            let mut all = vec![0.0; sides.len()];
            for (group, kinds) in groups {
                let mut of_group = vec![0.0; sides.len()];
                for kind in kinds {
                    let errors = kind.errors(&light, share * SIDE_NM, &sides, 8);
                    println!("  {name} {share} {:.3} {errors:.3?}", kind.order());
                    of_group.iter_mut().zip(errors).for_each(|(sum, error)| *sum += error / kinds.len() as f64);
                }
                all.iter_mut().zip(&of_group).for_each(|(sum, error)| *sum += error / groups.len() as f64);
                println!("{name}, {share}, {group}: {:.2?}", of_group.iter().map(|e| e.sqrt()).collect::<Vec<_>>());
            }
            println!("{name}, {share}, all: {:.2?}", all.iter().map(|e| e.sqrt()).collect::<Vec<_>>());
        }
    }
}

/// Mean of Y on the two axes of (u, v), where the seams of a repeated scan shine, over that beside them: of the first `count`
/// surfaces that `scan` makes, under a window of a quarter of their side.
fn cross(count: u64, scan: impl Fn(u64) -> HeightField) -> f64 {
    let optics = optics(&Illuminant::D65, SIDE_NM / TILE_SIGMAS, SIDE_NM);
    let width = WAVELENGTH_NM / (TAU * SQRT_2 * optics.sigma_nm);
    let wi = from_angles_deg(20.0, 0.0);
    let beside = [-5.5, -4.0, 4.0, 5.5];
    let at = |off: f64| {
        (0..30).flat_map(move |i| {
            let along = 0.15 + 0.02 * f64::from(i);
            [[-along, off * width], [off * width, along], [off * width, -along]]
        })
    };
    let mean = |field: &HeightField, offs: &[f64]| {
        let pairs: Vec<Pair> =
            offs.iter().flat_map(|off| at(*off)).map(|[u, v]| (wi, outgoing(wi, u, v).unwrap())).collect();
        values(field, &optics, &pairs).iter().map(|xyz| xyz[1]).sum::<f64>() / pairs.len() as f64
    };
    let fields: Vec<HeightField> = (0..count).map(scan).collect();
    let sum = |offs: &[f64]| fields.iter().map(|field| mean(field, offs)).sum::<f64>();
    sum(&[0.0]) / sum(&beside)
}

const FILM: Kind = FILMS[1];

/// A film that repeats on the side of a scan: no seam.
fn seamless(seed: u64) -> HeightField {
    let rough = Structure::GaussianRough { rms_nm: 25.0, correlation_length_nm: 500.0, seed };
    synthesize(&rough, [SAMPLES; 2], [PITCH_NM; 2]).unwrap()
}

/// A scan of a film on a slope of 1 %, 100 nm over its side: as it is, or prepared.
fn tilted(level: Level, blend_nm: Option<f64>) -> impl Fn(u64) -> HeightField {
    move |seed| {
        let mut field = FILM.scan(seed);
        field.heights_nm.indexed_iter_mut().for_each(|((_, column), h)| *h += 0.01 * column as f64 * PITCH_NM);
        prepared(field, level, blend_nm)
    }
}

#[test]
fn a_levelled_film_shows_no_cross_and_a_tilted_one_does() {
    let [without, levelled, slope] =
        [cross(6, seamless), cross(6, tilted(Level::Plane, None)), cross(6, tilted(Level::None, None))];
    println!("without seams {without:.3}, levelled {levelled:.3}, tilted {slope:.3}");
    assert!((levelled / without - 1.0).abs() < 0.15, "{levelled} {without}");
    assert!(slope > 1.5 * without, "{slope} {without}");
}

#[test]
#[ignore = "measures"]
fn measuring_what_blending_does_to_seams() {
    println!("without seams {:.2}, levelled {:.2}", cross(24, seamless), cross(24, tilted(Level::Plane, None)));
    for blend_nm in [400.0, 800.0, 1_600.0, 3_000.0, 5_000.0] {
        let of = |level| cross(24, tilted(level, Some(blend_nm)));
        println!("blended over {blend_nm} nm: levelled {:.2}, tilted {:.2}", of(Level::Plane), of(Level::None));
    }
    println!("tilted {:.2}", cross(24, tilted(Level::None, None)));
}
