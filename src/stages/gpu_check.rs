//! The check stage: every scene shaded by the GPU from the published tables, against the CPU, pixel by pixel.

use ndarray::{Array3, Axis, Slice};
use serde::{Deserialize, Serialize};

use crate::ground::colour::{NOT_FINITE_RGB8, auto_exposure};
use crate::ground::error::{Error, Result};
use crate::ground::metrics::{ColourDifference, ciede2000};
use crate::render::cpu;
use crate::render::gpu::Gpu;
use crate::render::gpu_bound::bound_image;
use crate::render::gpu_layout::table_image;
use crate::render::gpu_tables::{GpuTables, shade, upload};
use crate::scene::model::{Scene, exposure_factor};
use crate::scene::samples::{ShadingSamples, samples_of, samples_per_pixel};
use crate::tables::evaluate::{Interpolation, brdf_xyz};
use crate::tables::model::TableSet;

/// Samples of a scene held at a time: 29 MB here and 8 MB on the GPU.
const BAND_SAMPLES: usize = 1 << 20;

/// How a scene on the GPU compares with the CPU. Differences are those of X, Y or Z, as shares of the display's white.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GpuSceneCheck {
    /// The scene's name.
    pub scene: String,
    /// Samples shaded.
    pub samples: usize,
    /// Largest difference.
    pub worst: f64,
    /// Mean difference.
    pub mean: f64,
    /// Largest difference that a pixel was allowed, derived from the hardware's rounding and filtering.
    pub tolerance: f64,
    /// Mean difference that the pixels were allowed.
    pub tolerance_mean: f64,
    /// The largest share that a difference takes of what its own pixel was allowed; above 1 fails.
    pub worst_of_tolerance: f64,
    /// Row and column of that pixel.
    pub worst_pixel: [usize; 2],
    /// Values from the GPU that are not finite; any fails.
    pub not_finite: usize,
    /// Colour differences between the two pictures.
    pub ciede2000: ColourDifference,
    /// Whether every value is finite and within its pixel's tolerance.
    pub passed: bool,
    /// Picture of the differences where the check fails, for a PNG: see [`difference_picture`].
    #[serde(skip)]
    pub difference: Option<Array3<u8>>,
}

/// Checks gathered samples against their picture by `render::cpu::shade`. `set` is what was read back from the atlas.
///
/// # Errors
/// `Error::Gpu`; `Error::Limit` for tables that do not fit every GPU. A picture that differs is no error.
pub fn check_scene(
    gpu: &Gpu,
    set: &TableSet,
    samples: &ShadingSamples,
    cpu_image: &Array3<f32>,
) -> Result<GpuSceneCheck> {
    let tables = upload(gpu, &table_image(set)?)?;
    let gpu_image = shade(gpu, &tables, samples)?;
    let white = 1.0 / f64::from(auto_exposure(cpu_image));
    let mut check = compare(cpu_image, &gpu_image, &bound_image(set, samples), white);
    check.samples = samples.weight.len();
    Ok(check)
}

/// Checks every scene of a specimen. `set` is what was read back from the atlas.
///
/// # Errors
/// As [`check_scene`], and for a scene that cannot be rendered.
pub fn check_specimen(gpu: &Gpu, set: &TableSet, scenes: &[Scene]) -> Result<Vec<GpuSceneCheck>> {
    let tables = upload(gpu, &table_image(set)?)?;
    scenes.iter().map(|scene| check_uploaded(gpu, &tables, set, scene)).collect()
}

/// Checks one scene with tables that are already on the GPU.
///
/// # Errors
/// As [`check_specimen`].
pub fn check_uploaded(gpu: &Gpu, tables: &GpuTables, set: &TableSet, scene: &Scene) -> Result<GpuSceneCheck> {
    crate::scene::model::check(scene)?;
    let side = scene.size_px;
    let [mut by_cpu, mut by_gpu, mut bound] = [(); 3].map(|()| Array3::zeros((side, side, 3)));
    let mut count = 0;
    for rows in bands(scene) {
        let samples = samples_of(scene, rows.clone(), 1)?;
        count += samples.weight.len();
        let band = Slice::from(rows);
        let brdf = |wi, wo| brdf_xyz(set, Interpolation::Bilinear, wi, wo);
        by_cpu.slice_axis_mut(Axis(0), band).assign(&cpu::shade(&samples, &brdf));
        by_gpu.slice_axis_mut(Axis(0), band).assign(&shade(gpu, tables, &samples)?);
        bound.slice_axis_mut(Axis(0), band).assign(&bound_image(set, &samples));
    }
    let white = 1.0 / f64::from(exposure_factor(scene.exposure, &by_cpu));
    let mut check = compare(&by_cpu, &by_gpu, &bound, white);
    check.scene = scene.name.clone();
    check.samples = count;
    Ok(check)
}

/// Picture of a scene by the GPU, XYZ `[rows, columns, 3]`, as `render::cpu::render` makes it.
///
/// # Errors
/// As [`check_specimen`].
pub fn render(gpu: &Gpu, tables: &GpuTables, scene: &Scene) -> Result<Array3<f32>> {
    crate::scene::model::check(scene)?;
    let mut image = Array3::zeros((scene.size_px, scene.size_px, 3));
    for rows in bands(scene) {
        let samples = samples_of(scene, rows.clone(), 1)?;
        image.slice_axis_mut(Axis(0), Slice::from(rows)).assign(&shade(gpu, tables, &samples)?);
    }
    Ok(image)
}

/// Row ranges whose samples are gathered together.
fn bands(scene: &Scene) -> Vec<std::ops::Range<usize>> {
    let side = scene.size_px;
    let rows = (BAND_SAMPLES / (samples_per_pixel(scene) * side).max(1)).clamp(1, side);
    (0..side).step_by(rows).map(|first| first..(first + rows).min(side)).collect()
}

/// Compares two XYZ pictures under a bound for each value; `white` is the luminance shown as white. The scene's name is
/// left empty.
pub fn compare(by_cpu: &Array3<f32>, by_gpu: &Array3<f32>, bound: &Array3<f32>, white: f64) -> GpuSceneCheck {
    assert_eq!(by_cpu.dim(), by_gpu.dim(), "compared pictures differ in size");
    assert_eq!(by_cpu.dim(), bound.dim(), "the bound's size differs");
    let mut check = GpuSceneCheck {
        scene: String::new(),
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
        // A difference or a bound that is not a number fails.
        let share = if difference <= allowed && allowed.is_finite() {
            if difference == 0.0 { 0.0 } else { difference / allowed }
        } else {
            check.passed = false;
            let share = difference / allowed;
            if share.is_nan() { f64::MAX } else { share.clamp(1.0 + f64::EPSILON, f64::MAX) }
        };
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
    let finite = by_gpu.mapv(|value| if value.is_finite() { value } else { 0.0 });
    check.ciede2000 = ciede2000(by_cpu, &finite, white);
    if !check.passed {
        check.difference = Some(difference_picture(by_cpu, by_gpu, bound));
    }
    check
}

/// Differences as 8-bit RGB: grey up to what a pixel was allowed (white: all of it), red beyond, magenta where the GPU's
/// value is not finite.
pub fn difference_picture(by_cpu: &Array3<f32>, by_gpu: &Array3<f32>, bound: &Array3<f32>) -> Array3<u8> {
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

/// The error that a failed check is under `gpu.check = "required"`; names the first scene that failed.
///
/// # Errors
/// `Error::Gpu` if any failed.
pub fn require_passed(specimen: &str, checks: &[GpuSceneCheck]) -> Result<()> {
    match checks.iter().find(|check| !check.passed) {
        None => Ok(()),
        Some(failed) => Err(Error::Gpu(format!(
            "specimen \"{specimen}\", scene \"{}\": row {}, column {} differs from the CPU by {:.1e} times what rounding \
             and filtering allow (worst difference {:.2e} of white, {} values not finite)",
            failed.scene,
            failed.worst_pixel[0],
            failed.worst_pixel[1],
            failed.worst_of_tolerance,
            failed.worst,
            failed.not_finite
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert!(!check.passed && require_passed("x", std::slice::from_ref(&check)).is_err());
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
}
