//! The frame of an interactive program against the CPU's picture, and failures of the device.

use diffraction_atlas::ground::colour::xyz_to_linear_srgb;
use diffraction_atlas::render::gpu::Gpu;
use diffraction_atlas::render::gpu_bound::bound_image;
use diffraction_atlas::render::gpu_frame::{Frame, FramePlan, copy_gb_per_s, time_frames};
use diffraction_atlas::render::gpu_layout::table_image;
use diffraction_atlas::render::gpu_tables::{shade, upload};
use diffraction_atlas::scene::model::{Scene, Shape};
use diffraction_atlas::scene::samples::samples;
use diffraction_atlas::scene::sphere::RADIUS;
use diffraction_atlas::tables::evaluate::{Interpolation, brdf_xyz};

use crate::sets::{full_set, gpu, scenes, sphere};

/// Largest difference between the frame and the CPU's picture, in units of what is allowed.
///
/// Allowed are the check's bound in the output's primaries (the magnitudes of a row sum to 5.3 at most), the half floats
/// of the output (2^-11), and the rounding of positions: the normal is off by about 4 u / z < 2.4e-6, and `f` changes by at
/// most its own size over 1 % of the lobe's width 0.07: 2.4e-6 / 7e-4 < 4e-3 of the largest value at the worst place.
fn frame_error(exposure_of_cpu: f32) -> Option<f64> {
    let gpu = gpu("frame")?;
    let (set, scene, exposure) = (full_set(), sphere(64), 0.5);
    let tables = upload(gpu, &table_image(set).unwrap()).unwrap();
    let frame = Frame::new(gpu, &tables, &scene, exposure).unwrap().draw().unwrap();
    let samples = samples(&scene).unwrap();
    let expected =
        diffraction_atlas::render::cpu::shade(&samples, &|wi, wo| brdf_xyz(set, Interpolation::Bilinear, wi, wo));
    let bound = bound_image(set, &samples);
    let mut worst = 0.0f64;
    let mut lit = 0;
    for row in 0..64 {
        for column in 0..64 {
            let at = [row, column].map(|i| ((i as f64 + 0.5) / 32.0 - 1.0) / RADIUS);
            // Away from the limb, where a pixel is or is not on the sphere.
            if at[0] * at[0] + at[1] * at[1] > 0.99 {
                continue;
            }
            let xyz = [0, 1, 2].map(|c| f64::from(exposure_of_cpu) * f64::from(expected[[row, column, c]]));
            let allowed: f64 = [0, 1, 2].map(|c| f64::from(exposure) * f64::from(bound[[row, column, c]])).iter().sum();
            let largest = xyz.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            lit += usize::from(largest > 1e-3);
            for (c, value) in xyz_to_linear_srgb(xyz).into_iter().enumerate() {
                let difference = (f64::from(frame[[row, column, c]]) - value).abs();
                worst = worst.max(difference / (5.3 * allowed + largest * (5.3 / 2048.0 + 4e-3) + 1e-7));
            }
        }
    }
    assert!(lit > 500, "{lit} lit pixels");
    Some(worst)
}

#[test]
fn a_frame_shows_the_sphere() {
    let Some(worst) = frame_error(0.5) else { return };
    println!("frame: {worst:.3} of what is allowed");
    assert!(worst < 1.0, "{worst}");
    assert!(frame_error(0.505).unwrap() > 1.0, "1 % of brightness must show");
}

#[test]
fn frame_times_are_measured() {
    let Some(gpu) = gpu("frame time") else { return };
    let tables = upload(gpu, &table_image(full_set()).unwrap()).unwrap();
    let [small, large] = [32, 256].map(|side| Frame::new(gpu, &tables, &sphere(side), 1.0).unwrap());
    let plan = FramePlan { warm_up: 2, batches: 5, batch: 4 };
    let [of_small, of_large] = time_frames([&small, &large], plan).unwrap();
    println!("{of_small:?} and {of_large:?} on {:?}", gpu.info());
    for time in [&of_small, &of_large] {
        assert!(time.median_ms > 0.0 && time.shortest_ms <= time.median_ms && time.frames == 20);
        assert_eq!((time.tables, time.light_samples), (full_set().tables.len(), 6));
    }
    // 64 times as many pixels: a clock that is not the GPU's, or in another unit for one of them, would not see it.
    assert!(of_large.median_ms > 2.0 * of_small.median_ms, "{of_large:?} {of_small:?}");
}

#[test]
fn copying_has_a_bandwidth() {
    let Some(gpu) = gpu("copy bandwidth") else { return };
    let copied = copy_gb_per_s(gpu).unwrap();
    println!("{copied:.1} GB/s");
    // From the slowest memory of a small board to well above today's fastest.
    assert!((0.1..1e5).contains(&copied), "{copied}");
}

#[test]
fn frames_of_other_shapes_are_refused() {
    let Some(gpu) = gpu("refused frames") else { return };
    let tables = upload(gpu, &table_image(full_set()).unwrap()).unwrap();
    let scene = Scene { shape: Shape::Snake, ..sphere(64) };
    assert!(Frame::new(gpu, &tables, &scene, 1.0).unwrap_err().to_string().contains("sphere"));
}

#[test]
fn a_lost_device_is_an_error_in_every_later_call() {
    if gpu("lost device").is_none() {
        return;
    }
    let gpu = Gpu::require().unwrap();
    let image = table_image(full_set()).unwrap();
    let tables = upload(&gpu, &image).unwrap();
    let samples = samples(&scenes()[0]).unwrap();
    shade(&gpu, &tables, &samples).unwrap();
    gpu.lose();
    let error = shade(&gpu, &tables, &samples).unwrap_err().to_string();
    assert!(error.starts_with("GPU: ") && error.contains("lost"), "{error}");
    assert!(upload(&gpu, &image).unwrap_err().to_string().contains("lost"));
}

#[test]
fn what_the_driver_rejects_is_an_error() {
    let Some(gpu) = gpu("rejected upload") else { return };
    let mut image = table_image(full_set()).unwrap();
    image.tables.size = [20_000; 2];
    image.tables.texels.clear();
    let error = upload(gpu, &image).unwrap_err().to_string();
    assert!(error.contains("cannot upload the tables") && error.contains("20000"), "{error}");
    // And the device goes on.
    upload(gpu, &table_image(full_set()).unwrap()).unwrap();
}
