//! Filtered look-ups on the GPU against exact means over the same ellipses in Rust, on tables of bundled scans.

use std::path::Path;
use std::sync::OnceLock;

use bytemuck::Zeroable;
use diffraction_brdf::shader::{HalfLayers, TableImage, promised_image, table_image};
use diffraction_brdf::shader_spectral::{SpectralImage, promised_spectral_image, spectral_image};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_brdf::{Brdf, Factor, Footprint, Interpolation, SpectralTables, Vec3};
use diffraction_build::ground::sampling::{Region, direction_pairs, plane};
use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::spectral::{SpectralInput, build_spectral};
use diffraction_render::render::cpu::shade_filtered as shade_by_cpu;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_filtered::{FilteredQuery, eval_filtered, eval_spectral_filtered, shade_filtered};
use diffraction_render::render::gpu_spectral::upload_spectral;
use diffraction_render::render::gpu_tables::upload;
use diffraction_render::scene::filtered::filtered_samples_of;
use diffraction_render::scene::model::{Light, Scene, Shape};
use ndarray::Array3;
use rayon::prelude::*;

use crate::sets::{full_set, gpu, restricted_set, sphere};
use crate::surfaces::{quantile, tables_config};

/// Pairs of directions, half of them near the mirror direction.
const PAIRS: usize = 600;
/// Half-angles of lights in degrees, with what 95 of 100 pairs may be off: twice what the same seven places miss of these tables'
/// exact means in double precision, 8.4e-4, 4.7e-3, 1.9e-2 and 8.7e-2.
const LIGHTS: [(f64, f64); 4] = [(0.265, 1.7e-3), (1.0, 9.4e-3), (2.5, 3.8e-2), (5.0, 0.174)];
/// The same of coefficients, against means of the spline: halves for a point; twice what seven linear fetches of coefficients miss in double
/// precision on a snake's table with two texels to a line's deviation, 4.3e-3 and 1.1e-2, where seven of values miss 2.9e-2.
const SPLINE_LIGHTS: [(f64, f64); 3] = [(0.0, 5e-3), (0.265, 8.6e-3), (1.0, 2.2e-2)];
/// Covariances of normals like those of a pixel on a small ball: a twentieth of a radian, turned against the grid.
const NORMALS: [f64; 3] = [2.5e-3, 8e-4, 6e-4];
/// What half of the pairs may be off over that, on top of a light.
const NORMALS_ERROR: f64 = 0.1;
/// Twice as wide, over which means are mostly those of the third level.
const NORMALS_WIDE: [f64; 3] = [1e-2, 3.2e-3, 2.4e-3];
/// Colours are narrower at single wavelengths.
const WAVELENGTH_SHARE: f64 = 2.0;

pub struct Specimen {
    pub brdf: Brdf,
    spectral: SpectralTables,
}

/// The tables of the bundled manifest for the corn snake.
pub fn snake() -> &'static Specimen {
    static SPECIMEN: OnceLock<Specimen> = OnceLock::new();
    SPECIMEN.get_or_init(|| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("specimens/corn_snake_like.tif");
        let fields = [read_scan(&path, &ReadConfig::default()).unwrap().field];
        let ideal = OpticsConfig::ideal(Illuminant::D65, 4_000.0, Edge::Tile, Windows::Grid);
        let optics = OpticsConfig { material: Material::Dielectric { n: 1.56 }, factor: Factor::Vector, ..ideal };
        let tables = tables_config(1e-3, Some(601));
        let input = BuildInput::new(&fields, &optics, &tables);
        let of_wavelengths = SpectralInput::new(&optics, &tables);
        let spectral = build_spectral(&input, &of_wavelengths, &|_| ()).unwrap().tables;
        Specimen { brdf: Brdf::new(build(&input, &|_| ()).unwrap().0).unwrap(), spectral }
    })
}

fn queries(half_angle_deg: f64, normals: [f64; 3]) -> Vec<FilteredQuery> {
    let pairs = [Region::Hemisphere, Region::NearSpecular].into_iter().flat_map(|r| direction_pairs(r, PAIRS / 2));
    let query = |(n, (wi, wo)): (usize, (Vec3, Vec3))| FilteredQuery {
        wi: wi.map(|c| c as f32),
        wavelength_nm: (400.0 + 350.0 * plane(n)[0]) as f32,
        wo: wo.map(|c| c as f32),
        angular_radius: half_angle_deg.to_radians() as f32,
        normals: normals.map(|c| c as f32),
        ..Zeroable::zeroed()
    };
    pairs.enumerate().map(query).collect()
}

fn footprint(query: &FilteredQuery) -> (Vec3, Vec3, Footprint) {
    let [wi, wo, normals] = [query.wi, query.wo, query.normals].map(|v| v.map(f64::from));
    let light = Footprint::of_light(wi, 2.0 * f64::from(query.angular_radius).to_degrees()).unwrap();
    (wi, wo, light + Footprint::of_normals(wi, wo, normals).unwrap())
}

/// Values of Y by the CPU.
fn exact(brdf: &Brdf, queries: &[FilteredQuery]) -> Vec<f64> {
    let value = |query| {
        let (wi, wo, footprint) = footprint(query);
        brdf.eval_filtered(wi, wo, footprint)[1]
    };
    queries.par_iter().map(value).collect()
}

fn found(gpu: &Gpu, image: &TableImage, queries: &[FilteredQuery]) -> Vec<f64> {
    let values = eval_filtered(gpu, &upload(gpu, image).unwrap(), queries).unwrap();
    values.into_iter().map(|xyz| f64::from(xyz[1])).collect()
}

/// Median and 95th percentile of relative differences.
fn percentiles(found: &[f64], expected: &[f64]) -> [f64; 2] {
    let floor = 1e-7 * expected.iter().copied().fold(0.0, f64::max);
    let errors: Vec<f64> = found.iter().zip(expected).map(|(f, e)| (f - e).abs() / e.max(floor)).collect();
    assert!(errors.iter().all(|error| error.is_finite()));
    [0.5, 0.95].map(|share| quantile(&errors, share))
}

#[test]
fn a_look_up_is_the_mean_over_the_light() {
    let Some(gpu) = gpu("filtered look-ups") else { return };
    let Specimen { brdf, spectral } = snake();
    let image = table_image(brdf.tables(), None).unwrap();
    let tables = upload_spectral(gpu, &spectral_image(spectral).unwrap()).unwrap();
    let filtered = spectral.filtered();
    for (angle, bound) in LIGHTS {
        let queries = queries(angle, [0.0; 3]);
        let errors = percentiles(&found(gpu, &image, &queries), &exact(brdf, &queries));
        let at = |query| {
            let (wi, wo, footprint) = footprint(query);
            let nm = [f64::from(query.wavelength_nm)];
            filtered.eval_filtered(Interpolation::Bilinear, wi, wo, footprint, &nm)[0]
        };
        let expected: Vec<f64> = queries.par_iter().map(at).collect();
        let values: Vec<f64> =
            eval_spectral_filtered(gpu, &tables, &queries).unwrap().into_iter().map(f64::from).collect();
        let of_wavelengths = percentiles(&values, &expected);
        println!(
            "{angle} degrees: {:.1e} / {:.1e}; at one wavelength {:.1e} / {:.1e}",
            errors[0], errors[1], of_wavelengths[0], of_wavelengths[1]
        );
        assert!(errors[1] < bound, "{angle} degrees: {errors:?}");
        assert!(of_wavelengths[1] < WAVELENGTH_SHARE * bound, "{angle} degrees at a wavelength: {of_wavelengths:?}");
    }
}

#[test]
fn exchanged_axes_are_found() {
    let Some(gpu) = gpu("exchanged axes") else { return };
    let brdf = &snake().brdf;
    let image = table_image(brdf.tables(), None).unwrap();
    let right = queries(0.265, NORMALS);
    let turned = |change: fn([f32; 3]) -> [f32; 3]| -> Vec<FilteredQuery> {
        right.iter().map(|query| FilteredQuery { normals: change(query.normals), ..*query }).collect()
    };
    let expected = exact(brdf, &right);
    let errors = percentiles(&found(gpu, &image, &right), &expected);
    println!("over normals: {:.1e} / {:.1e}", errors[0], errors[1]);
    assert!(errors[0] < NORMALS_ERROR, "{errors:?}");
    for (what, wrong) in [
        ("exchanged", turned(|[aa, ab, bb]| [bb, ab, aa])),
        ("mirrored", turned(|[aa, ab, bb]| [aa, -ab, bb])),
        ("of a point", turned(|_| [0.0; 3])),
    ] {
        let wrong = percentiles(&found(gpu, &image, &wrong), &expected);
        println!("{what}: {:.1e} / {:.1e}", wrong[0], wrong[1]);
        assert!(wrong[0] > 2.0 * errors[0], "{what}: {wrong:?} {errors:?}");
    }
}

/// Exchanges rows and columns of every coarser level.
fn transposed(layers: &mut HalfLayers) {
    for level in &mut layers.coarser {
        let [rows, columns] = level.size;
        assert_eq!(rows, columns);
        for layer in level.texels.chunks_exact_mut(rows * columns) {
            for row in 0..rows {
                (0..row).for_each(|column| layer.swap(row * columns + column, column * columns + row));
            }
        }
    }
}

#[test]
fn wrong_levels_are_found() {
    let Some(gpu) = gpu("wrong levels") else { return };
    let brdf = &snake().brdf;
    let image = table_image(brdf.tables(), None).unwrap();
    let queries = queries(5.0, NORMALS_WIDE);
    let expected = exact(brdf, &queries);
    let right = percentiles(&found(gpu, &image, &queries), &expected);
    println!("levels as they are: {:.1e} / {:.1e}", right[0], right[1]);
    type Tamper<'a> = &'a dyn Fn(&mut TableImage);
    let tampers: [(&str, f64, Tamper); 3] = [
        ("axes of the levels exchanged", 1.5, &|image| transposed(&mut image.tables)),
        ("no level below the finest", 1.3, &|image| image.tables.coarser.clear()),
        ("missing levels", 1.5, &|image| {
            for level in &mut image.tables.coarser[1..4] {
                level.texels.fill(Default::default());
            }
        }),
    ];
    for (what, factor, tamper) in tampers {
        let mut wrong = image.clone();
        tamper(&mut wrong);
        let wrong = percentiles(&found(gpu, &wrong, &queries), &expected);
        println!("{what}: {:.1e} / {:.1e}", wrong[0], wrong[1]);
        assert!(wrong[0] > factor * right[0], "{what}: {wrong:?} {right:?}");
    }
    // The lobe in closed form, near the mirror direction.
    let mut wrong = image.clone();
    wrong.gaussians.iter_mut().for_each(|texel| *texel = texel.map(|v| 1.5 * v));
    let queries = queries_near_the_mirror();
    let expected = exact(brdf, &queries);
    let [right, wrong] = [&image, &wrong].map(|image| percentiles(&found(gpu, image, &queries), &expected));
    println!("lobe: {right:?}, factors half as large again {wrong:?}");
    assert!(right[0] < 2e-3 && wrong[0] > 5.0 * right[0], "{right:?} {wrong:?}");
}

/// Under a lamp wider than the lobe.
fn queries_near_the_mirror() -> Vec<FilteredQuery> {
    let mirrored = |(n, query): (usize, FilteredQuery)| {
        let [x, y, _] = query.wi;
        let off = plane(n).map(|c| 0.02 * (c - 0.5) as f32);
        let [x, y] = [off[0] - x, off[1] - y];
        FilteredQuery { wo: [x, y, (1.0 - x * x - y * y).max(1e-3).sqrt()], ..query }
    };
    let steep = queries(1.0, [0.0; 3]).into_iter().filter(|query| query.wi[2] > 0.3);
    steep.enumerate().map(mirrored).collect()
}

#[test]
fn spectral_levels_are_used() {
    let Some(gpu) = gpu("spectral levels") else { return };
    let spectral = &snake().spectral;
    let image = spectral_image(spectral).unwrap();
    let queries = queries(5.0, NORMALS_WIDE);
    let filtered = spectral.filtered();
    let at = |query| {
        let (wi, wo, footprint) = footprint(query);
        filtered.eval_filtered(Interpolation::Bilinear, wi, wo, footprint, &[f64::from(query.wavelength_nm)])[0]
    };
    let expected: Vec<f64> = queries.par_iter().map(at).collect();
    let errors = |image: &SpectralImage| {
        let tables = upload_spectral(gpu, image).unwrap();
        let values = eval_spectral_filtered(gpu, &tables, &queries).unwrap();
        percentiles(&values.into_iter().map(f64::from).collect::<Vec<_>>(), &expected)
    };
    let right = errors(&image);
    let mut wrong = image.clone();
    transposed(&mut wrong.tables);
    let exchanged = errors(&wrong);
    let mut wrong = image.clone();
    wrong.tables.coarser.clear();
    let missing = errors(&wrong);
    println!("right {right:?}, exchanged {exchanged:?}, missing {missing:?}");
    assert!(exchanged[0] > 1.5 * right[0] && missing[0] > 1.3 * right[0], "{exchanged:?} {missing:?} {right:?}");
}

/// Cross terms, a metal, shadowing.
#[test]
fn every_part_is_averaged() {
    let Some(gpu) = gpu("parts of filtered look-ups") else { return };
    let brdf = Brdf::new(full_set().clone()).unwrap();
    let image = table_image(full_set(), None).unwrap();
    assert!(image.cross.coarser.len() > 1);
    let queries = queries_near_the_mirror();
    let expected = exact(&brdf, &queries);
    let right = percentiles(&found(gpu, &image, &queries), &expected);
    let mut wrong = image.clone();
    wrong.params.cross_count = 0;
    let without = percentiles(&found(gpu, &wrong, &queries), &expected);
    println!("one window: {right:?}, without cross terms {without:?}");
    assert!(right[0] < 5e-3 && without[0] > 2.0 * right[0], "{right:?} {without:?}");
}

/// They have no coarser levels: a range of its own in each texel has no mean.
#[test]
fn restricted_tables_are_averaged() {
    let Some(gpu) = gpu("filtered look-ups of restricted tables") else { return };
    let scene = sphere(32);
    let set = restricted_set(&scene);
    let image = table_image(&set, None).unwrap();
    assert!(image.tables.coarser.is_empty());
    let samples = diffraction_render::scene::samples::samples(&scene).unwrap();
    let query = |n: usize| FilteredQuery {
        wi: samples.wi[n],
        wo: samples.wo[n],
        angular_radius: 0.265f32.to_radians(),
        ..Zeroable::zeroed()
    };
    let queries: Vec<FilteredQuery> = (0..samples.wi.len()).step_by(7).map(query).collect();
    let expected = exact(&Brdf::new(set).unwrap(), &queries);
    let found = found(gpu, &image, &queries);
    let both: Vec<(f64, f64)> =
        found.into_iter().zip(expected).filter(|(f, e)| f.is_finite() && e.is_finite()).collect();
    assert!(both.len() > queries.len() / 2, "{} of {}", both.len(), queries.len());
    let (found, expected): (Vec<f64>, Vec<f64>) = both.into_iter().unzip();
    let errors = percentiles(&found, &expected);
    println!("restricted: {errors:?}");
    assert!(errors[1] < 5e-3, "{errors:?}");
}

#[test]
fn a_point_is_looked_up_as_a_point() {
    let Some(gpu) = gpu("filtered points") else { return };
    let brdf = &snake().brdf;
    let queries = queries(0.0, [0.0; 3]);
    let expected: Vec<f64> = queries.iter().map(|query| brdf.eval(footprint(query).0, footprint(query).1)[1]).collect();
    let errors = percentiles(&found(gpu, &table_image(brdf.tables(), None).unwrap(), &queries), &expected);
    println!("points: {errors:?}");
    // Halves, and places on a grid of 1/256 texel.
    assert!(errors[0] < 3e-4 && errors[1] < 5e-3, "{errors:?}");
}

/// With coefficients on the finest level a point is the spline's, by four linear fetches, and a light's mean that of the spline, by
/// seven: within what halves, places on a grid of 1/256 texel, and seven places leave.
#[test]
fn coefficients_are_looked_up_as_splines() {
    let Some(gpu) = gpu("splines") else { return };
    let Specimen { brdf, spectral } = snake();
    let brdf = brdf.clone().with_interpolation(Interpolation::Spline);
    let image = promised_image(brdf.tables(), None).unwrap();
    let tables = upload_spectral(gpu, &promised_spectral_image(spectral).unwrap()).unwrap();
    let mut values = table_image(brdf.tables(), None).unwrap();
    values.params.look_up = 1;
    for (angle, bound) in SPLINE_LIGHTS {
        let queries = queries(angle, [0.0; 3]);
        let expected = exact(&brdf, &queries);
        let errors = percentiles(&found(gpu, &image, &queries), &expected);
        println!("splines, {angle} degrees: {:.1e} / {:.1e}", errors[0], errors[1]);
        assert!(errors[1] < bound, "{angle} degrees: {errors:?}");
        let smoothed = percentiles(&found(gpu, &values, &queries), &expected);
        assert!(angle > 0.5 || smoothed[1] > 3.0 * bound, "values for coefficients, {angle} degrees: {smoothed:?}");
    }
    let queries = queries(0.0, [0.0; 3]);
    let at = |query: &FilteredQuery| {
        let (wi, wo, _) = footprint(query);
        spectral.eval(Interpolation::Spline, wi, wo, &[f64::from(query.wavelength_nm)])[0]
    };
    let expected: Vec<f64> = queries.par_iter().map(at).collect();
    let found: Vec<f64> = eval_spectral_filtered(gpu, &tables, &queries).unwrap().into_iter().map(f64::from).collect();
    let errors = percentiles(&found, &expected);
    println!("splines at one wavelength: {:.1e} / {:.1e}", errors[0], errors[1]);
    assert!(errors[1] < 1e-2, "{errors:?}");
}

/// A small ball, whose pixels are filtered by how normals turn in them: the same samples on the CPU and on the GPU.
#[test]
fn pictures_are_those_of_the_cpu() {
    let Some(gpu) = gpu("filtered pictures") else { return };
    let brdf = &snake().brdf;
    let light = Light { angular_diameter_deg: 0.53, ..Light::point([0.5, 0.4, 1.0]) };
    let samples = filtered_samples_of(&Scene::still("ball", Shape::Sphere, vec![light], 30), 1e-3, 0..30, 1).unwrap();
    let by_cpu = shade_by_cpu(&samples, &|wi, wo, footprint| brdf.eval_filtered(wi, wo, footprint));
    let mut image = table_image(brdf.tables(), None).unwrap();
    let luminances = |image: &Array3<f32>| image.rows().into_iter().map(|xyz| f64::from(xyz[1])).collect::<Vec<_>>();
    let errors = |image: &TableImage| {
        let by_gpu = shade_filtered(gpu, &upload(gpu, image).unwrap(), &samples).unwrap();
        let both = luminances(&by_gpu).into_iter().zip(luminances(&by_cpu)).filter(|(_, expected)| *expected > 0.0);
        let (found, expected): (Vec<f64>, Vec<f64>) = both.unzip();
        assert!(found.len() > 300, "{}", found.len());
        percentiles(&found, &expected)
    };
    let right = errors(&image);
    transposed(&mut image.tables);
    let wrong = errors(&image);
    println!("ball of 30 px: {right:?}, levels exchanged {wrong:?}");
    assert!(right[0] < 3e-2 && wrong[0] > 1.5 * right[0], "{right:?} {wrong:?}");
}
