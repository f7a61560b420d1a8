//! Pictures from filtered look-ups against pictures from many samples.

use std::path::Path;
use std::sync::OnceLock;

use diffraction_brdf::spectrum::Illuminant;
use diffraction_brdf::{Brdf, Factor};
use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TablesConfig};
use diffraction_render::render::cpu::{render, render_filtered};
use diffraction_render::scene::filtered::{diameter_max_deg, filtered_samples_of};
use diffraction_render::scene::model::{Light, Scene, Shape};
use ndarray::Array3;

/// The tables of the bundled manifest for the corn snake.
fn snake() -> &'static Brdf {
    static BRDF: OnceLock<Brdf> = OnceLock::new();
    BRDF.get_or_init(|| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("specimens/corn_snake_like.tif");
        let fields = [read_scan(&path, &ReadConfig::default()).unwrap().field];
        let ideal = OpticsConfig::ideal(Illuminant::D65, 4_000.0, Edge::Tile, Windows::Grid);
        let optics = OpticsConfig { material: Material::Dielectric { n: 1.56 }, factor: Factor::Vector, ..ideal };
        let tables = TablesConfig {
            basis: Basis::Chebyshev,
            tolerance: 1e-3,
            size: Some(601),
            count: None,
            wavelength_step_nm: None,
            storage: Some(Storage::Float),
            prefilter: Prefilter::None,
            memory_mib: 2048,
        };
        Brdf::new(build(&BuildInput::new(&fields, &optics, &tables), &|_| ()).unwrap().0).unwrap()
    })
}

fn lit(shape: Shape, diameter_deg: f64, size_px: usize) -> Scene {
    let light = Light { angular_diameter_deg: diameter_deg, ..Light::point([0.5, 0.4, 1.0]) };
    Scene { light_samples: 16, ..Scene::still("lit", shape, vec![light], size_px) }
}

fn sampled(scene: &Scene, light_samples: usize, pixel_samples: usize) -> Array3<f32> {
    let scene = Scene { light_samples, pixel_samples, ..scene.clone() };
    render(&scene, &|wi, wo| snake().eval(wi, wo)).unwrap()
}

fn filtered(scene: &Scene, tolerance: f64) -> Array3<f32> {
    render_filtered(scene, tolerance, &|wi, wo, footprint| snake().eval_filtered(wi, wo, footprint)).unwrap()
}

/// Median and 95th percentile of the luminance's relative error over lit pixels, and the root mean square over the mean.
fn errors(found: &Array3<f32>, truth: &Array3<f32>) -> [f64; 3] {
    let luminances = |image: &Array3<f32>| image.rows().into_iter().map(|xyz| f64::from(xyz[1])).collect::<Vec<_>>();
    let (found, truth) = (luminances(found), luminances(truth));
    let brightest = truth.iter().copied().fold(0.0, f64::max);
    let pairs = || found.iter().zip(&truth).filter(|(_, truth)| **truth > 1e-6 * brightest);
    let mut relative: Vec<f64> = pairs().map(|(found, truth)| (found - truth).abs() / truth).collect();
    assert!(relative.len() > 100 && relative.iter().all(|error| error.is_finite()), "{}", relative.len());
    relative.sort_by(f64::total_cmp);
    let count = relative.len();
    let mean = pairs().map(|(_, truth)| truth).sum::<f64>() / count as f64;
    let square = pairs().map(|(found, truth)| (found - truth).powi(2)).sum::<f64>() / count as f64;
    [relative[count / 2], relative[(count - 1) * 95 / 100], square.sqrt() / mean]
}

fn shown([median, p95, rms]: [f64; 3]) -> String {
    format!("{median:.1e} / {p95:.1e}, RMS {rms:.1e}")
}

#[test]
fn lights_take_one_look_up_up_to_the_size_that_keeps_the_tolerance() {
    assert!(diameter_max_deg(1e-3) > 0.53 && diameter_max_deg(1e-3) < 1.0 && diameter_max_deg(1e-2) == 2.0);
    let count = |diameter_deg: f64, tolerance: f64| {
        let scene = lit(Shape::Sphere, diameter_deg, 24);
        let pixels = filtered_samples_of(&scene, tolerance, 0..24, 1).unwrap();
        let middle = 12 * 24 + 12;
        pixels.samples.first[middle + 1] - pixels.samples.first[middle]
    };
    assert_eq!([count(0.53, 1e-3), count(2.0, 1e-3), count(2.0, 1e-2), count(5.0, 1e-2)], [1, 16, 1, 16]);
}

/// The pixel is left alone here: its centre, under a light whose disc is seen whole.
#[test]
fn one_look_up_is_the_light() {
    let (shape, size_px) = (Shape::Sphere, 600);
    for (diameter_deg, tolerance) in [(0.53, 1e-3), (2.0, 1e-2)] {
        // Every tenth pixel of a large picture: its pixels are smaller than the light by far.
        let scene = lit(shape.clone(), diameter_deg, size_px);
        let part = filtered_samples_of(&scene, tolerance, 0..size_px, 10).unwrap();
        let found = diffraction_render::render::cpu::shade_filtered(&part, &|wi, wo, footprint| {
            snake().eval_filtered(wi, wo, footprint)
        });
        let of = |light_samples: usize, pixel_samples: usize| {
            let scene = Scene { light_samples, pixel_samples, ..scene.clone() };
            let samples = diffraction_render::scene::samples::samples_of(&scene, 0..size_px, 10).unwrap();
            diffraction_render::render::cpu::shade(&samples, &|wi, wo| snake().eval(wi, wo))
        };
        let truth = of(1024, 1024);
        let one = errors(&found, &truth);
        let by_samples = [16, 64, 256].map(|count| errors(&of(count, count), &truth));
        let point = errors(&of(1, 1), &truth);
        println!(
            "{shape:?}, {diameter_deg} degrees: one look-up {}; 16, 64, 256 samples {:?}; point {}",
            shown(one),
            by_samples.map(shown),
            shown(point)
        );
        assert!(one[1] < tolerance && point[1] > 3.0 * one[1], "{shape:?} {diameter_deg}: {one:?} {point:?}");
    }
}

#[test]
fn pixels_of_a_small_ball_are_filtered() {
    let scene = lit(Shape::Sphere, 0.53, 30);
    let truth = sampled(&scene, 1024, 1024);
    let before = errors(&sampled(&scene, 16, 1), &truth);
    let with_pixels = errors(&sampled(&scene, 16, 16), &truth);
    let after = errors(&filtered(&scene, 1e-3), &truth);
    println!(
        "ball of 30 px: 16 samples of the light {}; of light and pixel {}; filtered {}",
        shown(before),
        shown(with_pixels),
        shown(after)
    );
    assert!(after[0] < 0.5 * before[0] && after[2] < before[2], "{before:?} {after:?}");
}

/// Lamps too wide for one look-up take parts, and pixels with edges of scales in them sixteen places.
#[test]
fn wide_lamps_and_edges_take_more() {
    let size_px = 600;
    for (what, shape, diameter_deg, tolerance) in
        [("ball, lamp of 5 degrees", Shape::Sphere, 5.0, 1e-3), ("snake, sun", Shape::Snake, 0.53, 1e-3)]
    {
        let scene = lit(shape, diameter_deg, size_px);
        let stride = 20;
        let part = filtered_samples_of(&scene, tolerance, 0..size_px, stride).unwrap();
        let found = diffraction_render::render::cpu::shade_filtered(&part, &|wi, wo, footprint| {
            snake().eval_filtered(wi, wo, footprint)
        });
        let of = |count: usize| {
            let scene = Scene { light_samples: count, pixel_samples: count, ..scene.clone() };
            let samples = diffraction_render::scene::samples::samples_of(&scene, 0..size_px, stride).unwrap();
            diffraction_render::render::cpu::shade(&samples, &|wi, wo| snake().eval(wi, wo))
        };
        let truth = of(2048);
        let (filtered, by_points) = (errors(&found, &truth), [16, 64].map(|count| errors(&of(count), &truth)));
        let look_ups = part.footprints.len() as f64 / (found.len() / 3) as f64;
        println!(
            "{what}: filtered {} with {look_ups:.1} a pixel; 16, 64 points {:?}",
            shown(filtered),
            by_points.map(shown)
        );
        assert!(filtered[0] < 0.5 * by_points[0][0] && filtered[1] < by_points[0][1], "{filtered:?} {by_points:?}");
    }
}

/// Maps of the BRDF and screens: one look-up where light and beam are narrow, parts of them where not.
#[test]
fn a_map_and_a_screen_are_filtered() {
    let screen = |beam_diameter_mm| Shape::Screen {
        distance_mm: 100.0,
        width_mm: 200.0,
        beam_diameter_mm,
        hole_diameter_mm: None,
        incidence_deg: 20.0,
    };
    for (what, shape, diameter_deg, tolerance, per_pixel) in [
        ("map, sun", Shape::Hemisphere, 0.53, 1e-3, 1),
        ("map, lamp of 2 degrees", Shape::Hemisphere, 2.0, 1e-2, 1),
        ("screen, narrow beam", screen(1.0), 0.0, 1e-3, 1),
        ("screen, beam that diverges", screen(1.0), 0.53, 1e-3, 1),
        ("screen, wide beam", screen(4.0), 0.0, 1e-3, 16),
        ("screen, beam that diverges more", screen(1.0), 2.0, 1e-3, 1),
        ("screen, beam that diverges much", screen(1.0), 12.0, 1e-3, 16),
    ] {
        let scene = lit(shape, diameter_deg, 48);
        let samples = filtered_samples_of(&scene, tolerance, 0..48, 1).unwrap().samples;
        let most = samples.first.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap();
        let truth = sampled(&scene, 1024, 1024);
        let [found, few] = [filtered(&scene, tolerance), sampled(&scene, 16, 16)].map(|image| errors(&image, &truth));
        println!("{what}: {most} filtered {}; 16 samples {}", shown(found), shown(few));
        assert_eq!(most, per_pixel, "{what}");
        // The truth's own samples of light and pixel leave a thousandth; parts of a beam overlap and leave gaps.
        let (most, share) = if per_pixel == 1 { (4e-3, 0.5) } else { (5e-2, 0.9) };
        assert!(found[0] < most && found[0] < share * few[0] && found[2] < 0.9 * few[2], "{what}: {found:?} {few:?}");
    }
}
