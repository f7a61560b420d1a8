//! The frame of an interactive program against the CPU's picture, and failures of the device.

use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::shader::table_image;
use diffraction_build::ground::colour::xyz_to_linear_srgb;
use diffraction_build::optics::pigment::Surface;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_bound::bound_image;
use diffraction_render::render::gpu_frame::{Frame, FramePlan, copy_gb_per_s, time_frames};
use diffraction_render::render::gpu_tables::{shade, upload};
use diffraction_render::scene::gbuffer::{GBuffer, gbuffer};
use diffraction_render::scene::model::{Scene, Shape};
use diffraction_render::scene::samples::{pixel_range, samples};
use diffraction_render::scene::turn::{Axis, Turn};

use crate::sets::{full_set, gpu, scenes, sphere};

/// What the shader's directions may be off: their components come from three products of numbers rounded to 2^-24, the
/// bitangent's from a vector product besides.
const DIRECTION_ERROR: f64 = 6.0 / (1 << 24) as f64;

/// Largest difference between the frame and the CPU's picture, in units of what is allowed.
///
/// Allowed are the check's bound in the output's primaries (the magnitudes of a row sum to 5.3 at most), the half floats
/// of the output (2^-11), and the rounding of directions: `f` changes by at most its own size over 1 % of the lobe's width
/// 0.07, 3.6e-7 / 7e-4 < 6e-4 of the value, and its geometry factor by that over either cosine.
fn frame_error(scene: &Scene, buffer: &GBuffer) -> Option<f64> {
    let gpu = gpu("frame")?;
    let (set, side, exposure) = (full_set(), scene.size_px, 0.5);
    let tables = upload(gpu, &table_image(set, None).unwrap()).unwrap();
    let frame = Frame::new(gpu, &tables, buffer, exposure).unwrap().draw().unwrap();
    let samples = samples(scene).unwrap();
    let expected =
        diffraction_render::render::cpu::shade(&samples, &|wi, wo| brdf_xyz(set, Interpolation::Bilinear, wi, wo));
    let bound = bound_image(Surface::without_pigment(set), &samples);
    let (mut worst, mut lit) = (0.0f64, 0);
    for (row, column) in (0..side).flat_map(|row| (0..side).map(move |column| (row, column))) {
        let xyz = [0, 1, 2].map(|c| f64::from(exposure) * f64::from(expected[[row, column, c]]));
        let allowed: f64 = [0, 1, 2].map(|c| f64::from(exposure) * f64::from(bound[[row, column, c]])).iter().sum();
        let largest = xyz.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let inverse = |v: [f32; 3]| 1.0 / f64::from(v[2]);
        let grazing = pixel_range(&samples, row, column)
            .map(|index| inverse(samples.wi[index]) + inverse(samples.wo[index]))
            .fold(0.0, f64::max);
        let relative = 5.3 / 2048.0 + 6e-4 + grazing * DIRECTION_ERROR;
        lit += usize::from(largest > 1e-3);
        for (c, value) in xyz_to_linear_srgb(xyz).into_iter().enumerate() {
            let difference = (f64::from(frame[[row, column, c]]) - value).abs();
            worst = worst.max(difference / (5.3 * allowed + largest * relative + 1e-7));
        }
    }
    assert!(lit > side * side / 20, "{lit} lit pixels");
    Some(worst)
}

#[test]
fn frames_show_what_the_pictures_show() {
    let scenes: Vec<Scene> = scenes().into_iter().filter(|scene| gbuffer(scene).is_ok()).collect();
    assert!(scenes.iter().any(|scene| scene.shape == Shape::Snake) && scenes.len() == 3);
    for scene in scenes {
        let turned = Scene { turn: Turn { axis: Axis::Viewing, angle_deg: 35.0 }, pixel_samples: 2, ..scene.clone() };
        for scene in [scene, turned] {
            let mut buffer = gbuffer(&scene).unwrap();
            let Some(worst) = frame_error(&scene, &buffer) else { return };
            println!("{}: {worst:.3} of what is allowed", scene.name);
            assert!(worst < 1.0, "{}: {worst}", scene.name);
            buffer.tangent.iter_mut().for_each(|tangent| tangent[3] = -tangent[3]);
            assert!(frame_error(&scene, &buffer).unwrap() > 1.0, "{}: a mirrored structure must show", scene.name);
        }
    }
    let mut bright = gbuffer(&sphere(64)).unwrap();
    bright.lights.iter_mut().for_each(|light| light.irradiance *= 1.01);
    assert!(frame_error(&sphere(64), &bright).unwrap() > 1.0, "1 % of brightness must show");
}

#[test]
fn frame_times_are_measured() {
    let Some(gpu) = gpu("frame time") else { return };
    let tables = upload(gpu, &table_image(full_set(), None).unwrap()).unwrap();
    let [small, large] = [32, 256].map(|side| Frame::new(gpu, &tables, &gbuffer(&sphere(side)).unwrap(), 1.0).unwrap());
    let plan = FramePlan { warm_up: 2, batches: 5, batch: 4 };
    let [of_small, of_large] = time_frames([&small, &large], plan).unwrap();
    println!("{of_small:?} and {of_large:?} on {:?}", gpu.info());
    for time in [&of_small, &of_large] {
        assert!(time.median_ms > 0.0 && time.shortest_ms <= time.median_ms && time.frames == 20);
        assert_eq!((time.tables, time.light_samples), (full_set().tables.len(), 6));
    }
    let pairs = samples(&sphere(256)).unwrap().weight.len() as u64;
    assert_eq!(of_large.evaluations, pairs);
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
fn frames_that_not_every_gpu_can_hold_are_refused() {
    let Some(gpu) = gpu("refused frames") else { return };
    let tables = upload(gpu, &table_image(full_set(), None).unwrap()).unwrap();
    let scene = Scene { pixel_samples: 300, ..sphere(16) };
    let error = Frame::new(gpu, &tables, &gbuffer(&scene).unwrap(), 1.0).unwrap_err().to_string();
    assert!(error.contains("300 textures") && error.contains("lower its size_px"), "{error}");
}

#[test]
fn a_lost_device_is_an_error_in_every_later_call() {
    if gpu("lost device").is_none() {
        return;
    }
    let gpu = Gpu::require().unwrap();
    let image = table_image(full_set(), None).unwrap();
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
    let mut image = table_image(full_set(), None).unwrap();
    image.tables.size = [20_000; 2];
    image.tables.texels.clear();
    let error = upload(gpu, &image).unwrap_err().to_string();
    assert!(error.contains("cannot upload the tables") && error.contains("20000"), "{error}");
    // And the device goes on.
    upload(gpu, &table_image(full_set(), None).unwrap()).unwrap();
}
