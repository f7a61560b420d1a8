//! Pictures by the GPU against those by the CPU and against the reference, pixel by pixel.

use std::ops::Range;
use std::sync::Arc;

use ndarray::{Array3, Axis, Slice};

use super::results::{GpuSceneCheck, PictureCheck, ReferenceCheck};
use crate::stages::pictures::scenes::{reference_samples, reference_stride, with_reference};
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::shader::table_image;
use diffraction_build::ground::colour::NOT_FINITE_RGB8;
use diffraction_build::ground::metrics::{ColourDifference, ciede2000, relative_l2};
use diffraction_build::optics::pigment::Surface;
use diffraction_build::tables::model::Storage;
use diffraction_build::tables::taylor::unit_roundoff;
use diffraction_render::error::Result;
use diffraction_render::render::cpu;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_bound::bound_image;
use diffraction_render::render::gpu_tables::{GpuTables, shade, upload};
use diffraction_render::scene::model::{Scene, exposure_factor};
use diffraction_render::scene::samples::{ShadingSamples, samples_of, samples_per_pixel};

/// Samples of a scene held at a time: 29 MB here and 8 MB on the GPU.
const BAND_SAMPLES: usize = 1 << 20;

/// XYZ picture of samples by the GPU.
pub(crate) type Shade<'a> = &'a dyn Fn(&Arc<ShadingSamples>) -> Result<Array3<f32>>;

/// Checks every scene of a table set.
///
/// # Errors
/// `Error::Gpu`; `Error::Limit` for tables that do not fit every GPU; those of a scene that cannot be rendered. A picture
/// that differs is no error.
pub fn check_specimen(gpu: &Gpu, surface: Surface, scenes: &[Scene]) -> Result<Vec<GpuSceneCheck>> {
    let tables = upload(gpu, &table_image(surface.tables, surface.pigment.map(|pigment| pigment.xyz_per_sr))?)?;
    scenes.iter().map(|scene| check_uploaded(gpu, &tables, surface, scene)).collect()
}

/// Checks one scene with tables that are already on the GPU.
///
/// # Errors
/// As [`check_specimen`].
pub fn check_uploaded(gpu: &Gpu, tables: &GpuTables, surface: Surface, scene: &Scene) -> Result<GpuSceneCheck> {
    check_picture(&|samples| shade(gpu, tables, samples), surface, scene, 1)
}

/// Checks every `stride`-th pixel of a scene, sampled as for its reference, against the CPU: both by linear look-ups of the same points.
///
/// # Errors
/// As [`check_specimen`].
pub(crate) fn check_picture(shade: Shade, surface: Surface, scene: &Scene, stride: usize) -> Result<GpuSceneCheck> {
    let drawn = draw(shade, surface, &with_reference(scene), stride)?;
    let white = 1.0 / f64::from(exposure_factor(scene.exposure, &drawn.by_cpu));
    let mut check = compare(&drawn.by_cpu, &drawn.image, &drawn.bound, white);
    check.scene = scene.name.clone();
    check.samples = drawn.samples;
    Ok(check)
}

/// Checks a scene against its reference, on the pixels that have one.
///
/// # Errors
/// As [`check_specimen`].
pub(crate) fn check_reference(
    shade: Shade,
    surface: Surface,
    scene: &Scene,
    reference: &Array3<f32>,
    limit: f64,
) -> Result<ReferenceCheck> {
    let drawn = draw(shade, surface, &with_reference(scene), reference_stride(scene))?;
    let white = 1.0 / f64::from(exposure_factor(scene.exposure, &drawn.by_cpu));
    let samples = reference_samples(scene)?;
    let cubic = cpu::shade(&samples, &|wi, wo| surface.xyz(Interpolation::Cubic, wi, wo));
    let pictures = CpuPictures { linear: &drawn.by_cpu, cubic: &cubic };
    Ok(compare_with_reference(reference, pictures, &drawn.image, &drawn.bound, white, limit))
}

/// What a picture's values may be off, look-ups aside: the tolerance for each of the two causes that it is asked of,
/// number of tables and wavelength step, and half a unit in the last place of the stored numbers.
pub(crate) fn reference_limit(tolerance: f64, storage: Storage) -> f64 {
    2.0 * tolerance + unit_roundoff(storage)
}

/// A picture by the GPU, the same by the CPU, and how far each value may be from that.
struct Drawn {
    image: Array3<f32>,
    by_cpu: Array3<f32>,
    bound: Array3<f32>,
    samples: usize,
}

fn draw(shade: Shade, surface: Surface, scene: &Scene, stride: usize) -> Result<Drawn> {
    diffraction_render::scene::model::check(scene)?;
    let side = scene.size_px.div_ceil(stride);
    let [image, by_cpu, bound] = [(); 3].map(|()| Array3::zeros((side, side, 3)));
    let mut drawn = Drawn { image, by_cpu, bound, samples: 0 };
    for rows in bands(scene, samples_per_pixel(scene), stride) {
        let samples = Arc::new(samples_of(scene, rows.clone(), stride)?);
        drawn.samples += samples.weight.len();
        let band = Slice::from(rows.start / stride..rows.end.div_ceil(stride));
        drawn.image.slice_axis_mut(Axis(0), band).assign(&shade(&samples)?);
        let by_cpu = cpu::shade(&samples, &|wi, wo| surface.xyz(Interpolation::Bilinear, wi, wo));
        drawn.by_cpu.slice_axis_mut(Axis(0), band).assign(&by_cpu);
        drawn.bound.slice_axis_mut(Axis(0), band).assign(&bound_image(surface, &samples));
    }
    Ok(drawn)
}

/// Row ranges whose samples are gathered together; each starts at a row that is compared.
pub(crate) fn bands(scene: &Scene, samples_per_pixel: usize, stride: usize) -> Vec<Range<usize>> {
    let side = scene.size_px;
    let per_row = samples_per_pixel * side.div_ceil(stride);
    let rows = (BAND_SAMPLES / per_row.max(1)).clamp(1, side) * stride;
    (0..side).step_by(rows).map(|first| first..(first + rows).min(side)).collect()
}

/// Compares two XYZ pictures under a bound for each value; `white` is the luminance shown as white. The scene's name is
/// left empty.
pub fn compare(by_cpu: &Array3<f32>, by_gpu: &Array3<f32>, bound: &Array3<f32>, white: f64) -> GpuSceneCheck {
    assert_eq!(by_cpu.dim(), by_gpu.dim(), "compared pictures differ in size");
    assert_eq!(by_cpu.dim(), bound.dim(), "the bound's size differs");
    let mut check = GpuSceneCheck {
        scene: String::new(),
        pixels: by_cpu.len() / 3,
        samples: 0,
        worst: 0.0,
        mean: 0.0,
        tolerance: 0.0,
        tolerance_mean: 0.0,
        worst_of_tolerance: 0.0,
        worst_pixel: [0, 0],
        not_finite: 0,
        ciede2000: ColourDifference::default(),
        passed: true,
        difference: None,
    };
    for ((index, &expected), (&found, &allowed)) in by_cpu.indexed_iter().zip(by_gpu.iter().zip(bound)) {
        let difference = (f64::from(found) - f64::from(expected)).abs();
        let allowed = f64::from(allowed);
        if !found.is_finite() {
            check.not_finite += 1;
        }
        let share = share_of(difference, allowed);
        check.passed &= share <= 1.0;
        if share > check.worst_of_tolerance {
            check.worst_of_tolerance = share;
            check.worst_pixel = [index.0, index.1];
        }
        if difference.is_finite() {
            check.worst = check.worst.max(difference / white);
            check.mean += difference / white;
        }
        check.tolerance = check.tolerance.max(allowed / white);
        check.tolerance_mean += allowed / white;
    }
    let values = by_cpu.len().max(1) as f64;
    check.mean /= values;
    check.tolerance_mean /= values;
    check.ciede2000 = ciede2000(by_cpu, &finite(by_gpu), white);
    if !check.passed {
        check.difference = Some(difference_picture(by_cpu, by_gpu, bound));
    }
    check
}

/// What a picture by the GPU may differ by from the published one, root of the summed squares: seven places of an ellipse stand for all its texels
/// there. Measured are 1e-7 to 8e-3, the most of a blazed grating on a ball. It tells pictures of other tables, axes or lights; how good
/// the tables are the reference tells.
const PICTURE_L2_MAX: f64 = 5e-2;

/// Compares a published picture with the same by the GPU.
pub(crate) fn compare_pictures(published: &Array3<f32>, by_gpu: &Array3<f32>, white: f64) -> PictureCheck {
    assert_eq!(published.dim(), by_gpu.dim(), "compared pictures differ in size");
    let flat = |image: &Array3<f32>| image.iter().map(|&v| f64::from(v)).collect::<Vec<_>>();
    let error = relative_l2(&flat(published), &flat(by_gpu));
    let passed = error <= PICTURE_L2_MAX;
    let brightest = published.iter().copied().fold(0.0, f32::max);
    let allowed = || Array3::from_elem(published.dim(), PICTURE_L2_MAX as f32 * brightest);
    PictureCheck {
        pixels: published.len() / 3,
        // JSON has no place for what is no number.
        relative_l2: if error.is_finite() { error } else { f64::MAX },
        limit: PICTURE_L2_MAX,
        ciede2000: ciede2000(published, &finite(by_gpu), white),
        passed,
        difference: (!passed).then(|| difference_picture(published, by_gpu, &allowed())),
    }
}

/// The same pixels by the CPU.
#[derive(Debug, Clone, Copy)]
pub struct CpuPictures<'a> {
    /// From the tables with linear look-ups.
    pub linear: &'a Array3<f32>,
    /// From the tables with cubic look-ups.
    pub cubic: &'a Array3<f32>,
}

/// Compares a picture by the GPU with the reference.
pub fn compare_with_reference(
    reference: &Array3<f32>,
    by_cpu: CpuPictures,
    by_gpu: &Array3<f32>,
    bound: &Array3<f32>,
    white: f64,
    limit: f64,
) -> ReferenceCheck {
    for image in [by_cpu.linear, by_cpu.cubic, by_gpu, bound] {
        assert_eq!(image.dim(), reference.dim(), "compared pictures differ in size");
    }
    let values = reference.len();
    let mut allowed = Array3::zeros(reference.dim());
    let (mut worst, mut shares) = (0.0f64, 0.0f64);
    let (mut by_gpu_sum, mut by_cpu_sum, mut look_up_sum, mut left_sum, mut light) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (index, &exact) in reference.indexed_iter() {
        let [linear, cubic] = [by_cpu.linear, by_cpu.cubic].map(|p| f64::from(p[index]));
        let [exact, found, bound] = [exact, by_gpu[index], bound[index]].map(f64::from);
        let unit = white.max(exact.abs());
        let (off, off_by_cpu, look_up) = ((found - exact).abs(), (linear - exact).abs(), (linear - cubic).abs());
        // The sums are exact in 64 bits but for their own rounding.
        let may_be_off = (off_by_cpu + bound) * (1.0 + 1e-12);
        allowed[index] = may_be_off as f32;
        shares = shares.max(share_of(off, may_be_off));
        let left = (off - look_up - bound) / unit;
        // Unlike f64::max this keeps what is no number.
        left_sum += if left <= 0.0 { 0.0 } else { left };
        light += exact.abs() / unit;
        if off.is_finite() {
            worst = worst.max(off / unit);
            by_gpu_sum += off / unit;
        }
        by_cpu_sum += off_by_cpu / unit;
        look_up_sum += look_up / unit;
    }
    let unexplained = if left_sum == 0.0 { 0.0 } else { left_sum / light };
    let unexplained = if unexplained.is_finite() { unexplained } else { f64::MAX };
    let flat = |image: &Array3<f32>| image.iter().map(|&v| f64::from(v)).collect::<Vec<_>>();
    let by_gpu_finite = finite(by_gpu);
    let (passed, accurate) = (shares <= 1.0, unexplained <= limit);
    let mean = |sum: f64| sum / values.max(1) as f64;
    ReferenceCheck {
        pixels: values / 3,
        worst,
        mean: mean(by_gpu_sum),
        mean_by_cpu: mean(by_cpu_sum),
        look_up_mean: mean(look_up_sum),
        unexplained,
        limit,
        worst_of_tolerance: shares,
        relative_l2: relative_l2(&flat(reference), &flat(&by_gpu_finite)).min(f64::MAX),
        ciede2000: ciede2000(reference, &by_gpu_finite, white),
        passed,
        accurate,
        difference: (!passed).then(|| difference_picture(reference, by_gpu, &allowed)),
    }
}

/// A difference as a share of what is allowed. One that is no number exceeds whatever is allowed, and an allowance that is
/// no number allows nothing.
fn share_of(difference: f64, allowed: f64) -> f64 {
    if difference <= allowed && allowed.is_finite() {
        return if difference == 0.0 { 0.0 } else { difference / allowed };
    }
    let share = difference / allowed;
    if share.is_nan() { f64::MAX } else { share.clamp(1.0 + f64::EPSILON, f64::MAX) }
}

fn finite(image: &Array3<f32>) -> Array3<f32> {
    image.mapv(|value| if value.is_finite() { value } else { 0.0 })
}

/// Differences as 8-bit RGB: grey up to what a pixel was allowed (white: all of it), red beyond, magenta where the GPU's
/// value is not finite.
pub(crate) fn difference_picture(by_cpu: &Array3<f32>, by_gpu: &Array3<f32>, bound: &Array3<f32>) -> Array3<u8> {
    let (rows, columns, _) = by_cpu.dim();
    let mut picture = Array3::zeros((rows, columns, 3));
    for row in 0..rows {
        for column in 0..columns {
            let channels = [0, 1, 2].map(|c| [row, column, c]);
            let shares = channels.map(|at| (by_gpu[at] - by_cpu[at]).abs() / bound[at]);
            let rgb = if channels.iter().any(|&at| !by_gpu[at].is_finite()) {
                NOT_FINITE_RGB8
            } else {
                let share = shares[0].max(shares[1]).max(shares[2]);
                if share <= 1.0 { [(share * 255.0) as u8; 3] } else { [255, 0, 0] }
            };
            for (at, value) in channels.into_iter().zip(rgb) {
                picture[at] = value;
            }
        }
    }
    picture
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_render::scene::model::{Light, Shape};

    fn image(value: f32) -> Array3<f32> {
        Array3::from_elem((2, 3, 3), value)
    }

    #[test]
    fn a_difference_passes_up_to_its_own_bound_and_not_beyond() {
        let (cpu, mut bound) = (image(1.0), image(0.25));
        let mut gpu = cpu.clone();
        gpu[[1, 2, 0]] = 1.25;
        let check = compare(&cpu, &gpu, &bound, 2.0);
        assert!(check.passed && check.difference.is_none());
        assert_eq!((check.worst, check.worst_of_tolerance, check.worst_pixel), (0.125, 1.0, [1, 2]));
        bound[[1, 2, 0]] = 0.2;
        let check = compare(&cpu, &gpu, &bound, 2.0);
        assert!(!check.passed);
        let picture = check.difference.unwrap();
        assert_eq!([0, 1, 2].map(|c| picture[[1, 2, c]]), [255, 0, 0]);
        assert_eq!(picture[[0, 0, 0]], 0);
    }

    #[test]
    fn values_that_are_not_finite_fail() {
        for bad in [f32::NAN, f32::INFINITY] {
            let (cpu, bound) = (image(1.0), image(0.25));
            let mut gpu = cpu.clone();
            gpu[[0, 1, 1]] = bad;
            let check = compare(&cpu, &gpu, &bound, 1.0);
            assert!(!check.passed && check.not_finite == 1 && check.worst_of_tolerance > 1.0);
            assert_eq!(check.difference.unwrap()[[0, 1, 1]], 0);
            // A bound that is not finite excuses nothing.
            assert!(!compare(&cpu, &cpu, &image(bad), 1.0).passed);
        }
    }

    /// A reference of ones, tables off by 0.1 of which linear look-ups explain all but `unexplained`.
    fn with_reference(found: f32, unexplained: f32) -> ReferenceCheck {
        let (linear, cubic) = (image(1.1), image(1.0 + unexplained));
        let by_cpu = CpuPictures { linear: &linear, cubic: &cubic };
        compare_with_reference(&image(1.0), by_cpu, &image(found), &image(1e-3), 1.0, 2e-3)
    }

    #[test]
    fn a_reference_is_met_within_tolerance_look_up_and_bound() {
        let check = with_reference(1.1005, 1e-3);
        assert!(check.passed && check.accurate && check.difference.is_none(), "{check:?}");
        assert!((check.mean - 0.1005).abs() < 1e-6 && (check.look_up_mean - 0.099).abs() < 1e-6);
        // Tables worse than the tolerance are told from a GPU that is wrong.
        let check = with_reference(1.1005, 5e-3);
        assert!(check.passed && !check.accurate, "{check:?}");
        let check = with_reference(1.102, 1e-3);
        assert!(!check.passed && check.difference.is_some(), "{check:?}");
        let check = with_reference(f32::NAN, 1e-3);
        assert!(!check.passed && !check.accurate && check.unexplained > 1.0, "{check:?}");
    }

    #[test]
    fn a_reference_has_dark_values_measured_against_white_and_bright_ones_against_themselves() {
        let check = |value: f32| {
            let (exact, tables) = (image(value), image(value + 0.01));
            let by_cpu = CpuPictures { linear: &tables, cubic: &tables };
            compare_with_reference(&exact, by_cpu, &tables, &image(1e-6), 1.0, 2e-3)
        };
        assert!((check(1e-3).worst - 0.01).abs() < 1e-6 && (check(100.0).worst - 1e-4).abs() < 1e-6);
        assert!(!check(1.0).accurate && check(100.0).accurate);
    }

    /// A grating: 1 pixel in 100 is lit. What is wrong with it must show all the same.
    #[test]
    fn dark_surroundings_excuse_nothing() {
        let lit = |value: f32| {
            let mut image = Array3::zeros((10, 10, 3));
            (0..3).for_each(|c| image[[4, 7, c]] = value);
            image
        };
        let check = |tables: &Array3<f32>| {
            let by_cpu = CpuPictures { linear: tables, cubic: tables };
            compare_with_reference(&lit(1.0), by_cpu, tables, &Array3::from_elem((10, 10, 3), 1e-6), 1.0, 2e-3)
        };
        assert!(check(&lit(1.001)).accurate);
        assert!(!check(&lit(1.01)).accurate && !check(&lit(0.0)).accurate);
    }

    #[test]
    fn bands_cover_every_row_that_is_compared() {
        let disc = Light { angular_diameter_deg: 1.0, ..Light::point([0.0, 0.0, 1.0]) };
        let scene =
            |size_px, light_samples| Scene { light_samples, ..Scene::still("s", Shape::Sphere, vec![disc], size_px) };
        for (size_px, light_samples, stride) in [(7, 16, 1), (1000, 4096, 3), (512, 4096, 4), (5, 1, 8)] {
            let scene = scene(size_px, light_samples);
            let bands = bands(&scene, samples_per_pixel(&scene), stride);
            assert!(bands.iter().all(|band| band.start % stride == 0));
            assert!(bands.windows(2).all(|pair| pair[0].end == pair[1].start));
            assert_eq!((bands[0].start, bands[bands.len() - 1].end), (0, size_px));
            assert_eq!(bands.iter().map(|b| b.len().div_ceil(stride)).sum::<usize>(), size_px.div_ceil(stride));
        }
    }
}
