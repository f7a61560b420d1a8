//! What the report says about the GPU: a headline, the adapter, the comparisons, the frame times.

use minijinja::{Value, context};

use crate::report::embed::Album;
use crate::report::numbers;
use crate::stages::gpu::results::{FrameComparison, GpuResult, GpuRow, GpuSpectralRow, MethodFrame, ReferenceCheck};
use diffraction_brdf::error::Result;
use diffraction_render::render::gpu::GpuInfo;
use diffraction_render::render::gpu_frame::Clock;

/// Everything the template needs; `has_scenes` says whether the run made pictures that could be compared.
pub fn section(result: &GpuResult, has_scenes: bool, album: &mut Album) -> Result<Value> {
    let (tone, text) = headline(result, has_scenes);
    let none: Vec<Value> = Vec::new();
    let GpuResult::Checked { gpu, rows, spectral, frames } = result else {
        let facts = none.clone();
        return Ok(context! { tone, text, facts, rows => none.clone(), pictures => none, frames => Value::from(()) });
    };
    let mut pictures = Vec::new();
    for row in rows {
        if let Some(path) = &row.difference_png {
            let caption = format!("{}, {}", row.specimen, row.cpu.scene);
            let picture = Value::from_safe_string(album.img(path, "Where the GPU differs")?);
            pictures.push(context! { picture, caption });
        }
    }
    let limit = rows
        .iter()
        .find_map(|row| row.reference.as_ref())
        .map_or_else(String::new, |reference| numbers::number(reference.limit, 2));
    let rows: Vec<Value> = rows
        .iter()
        .enumerate()
        .map(|(index, row)| comparison(row, index == 0 || rows[index - 1].specimen != row.specimen))
        .collect();
    let frames = frames.as_deref().map(frame_times);
    Ok(context! { tone, text, facts => facts(gpu, spectral), limit, rows, pictures, frames })
}

fn headline(result: &GpuResult, has_scenes: bool) -> (&'static str, String) {
    match result {
        GpuResult::Off => ("", "check switched off".into()),
        GpuResult::Skipped { why } => ("amber", format!("skipped: {why}")),
        GpuResult::Unusable { why } => ("red", why.clone()),
        GpuResult::Checked { gpu, spectral, .. } if spectral.iter().any(|row| !row.passed()) => {
            ("red", format!("spectral tables beyond limits on {}", gpu.adapter))
        }
        GpuResult::Checked { gpu, rows, .. } => {
            let (all, beyond) = (rows.len(), rows.iter().filter(|row| !row.passed()).count());
            let scenes = format!("{} scene{}", numbers::count(all as u64), if all == 1 { "" } else { "s" });
            if all == 0 && !has_scenes {
                ("", "no scenes to compare".into())
            } else if all == 0 {
                ("amber", format!("nothing compared on {}", gpu.adapter))
            } else if beyond == 0 {
                ("green", format!("{scenes} within limits on {}", gpu.adapter))
            } else {
                ("red", format!("{beyond} of {scenes} beyond limits on {}", gpu.adapter))
            }
        }
    }
}

fn facts(gpu: &GpuInfo, spectral: &[GpuSpectralRow]) -> Vec<Value> {
    let clock = if gpu.timestamps { "on the GPU" } else { "none on the GPU: frames are timed from outside" };
    let limits = format!(
        "textures of {}² in up to {} layers, storage bindings of {}; used are WebGPU's default limits: 8192², 256 layers",
        gpu.texture_side_max,
        numbers::count(u64::from(gpu.texture_layers_max)),
        numbers::bytes(gpu.storage_binding_max_bytes)
    );
    let pixels = if gpu.is_software() {
        "a software driver: of every picture at most 128 pixels along each side, evenly spread"
    } else {
        "all of every picture"
    };
    let used =
        "timestamp queries where there are any; half-float textures filtered by the hardware, 32-bit ones by hand";
    [
        (
            "Adapter",
            format!("{} ({}, {:#06x}:{:#06x})", gpu.adapter, gpu.kind, gpu.vendor_device[0], gpu.vendor_device[1]),
        ),
        ("Driver", format!("{}, {}", gpu.driver, gpu.backend)),
        ("Limits", limits),
        ("Clock", clock.into()),
        ("Pixels", pixels.into()),
        ("Features used", used.into()),
        ("Spectral tables", spectral_tables(spectral)),
    ]
    .map(|(name, text)| context! { name, text })
    .into()
}

/// How the values of spectral tables compare, specimen by specimen.
fn spectral_tables(rows: &[GpuSpectralRow]) -> String {
    if rows.is_empty() {
        return "none compared".into();
    }
    let (within, beyond): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.passed());
    let worst = within.iter().map(|row| row.worst_of_tolerance).fold(0.0, f64::max);
    let values: usize = within.iter().map(|row| row.values).sum();
    let mut parts = vec![format!(
        "{} values of {} specimen{} within what rounding and filtering allow, the worst at {} of it",
        numbers::count(values as u64),
        within.len(),
        if within.len() == 1 { "" } else { "s" },
        numbers::number(worst, 2)
    )];
    let row = |row: &&GpuSpectralRow| format!("{}: {} of {} values beyond", row.specimen, row.beyond, row.values);
    parts.extend(beyond.iter().map(row));
    parts.join("; ")
}

/// A table row; only the first of a specimen names it.
fn comparison(row: &GpuRow, first: bool) -> Value {
    let (cpu, reference) = (&row.cpu, row.reference.as_ref());
    let two = |value: f64| numbers::number(value, 2);
    let verdict = match (row.passed(), reference.is_none_or(|reference| reference.accurate)) {
        (true, true) => ("green", "within"),
        (true, false) => ("amber", "within, tables coarse"),
        (false, _) if row.picture.as_ref().is_some_and(|picture| !picture.passed) => ("red", "picture differs"),
        (false, _) if cpu.passed && reference.is_none_or(|reference| reference.passed) => ("red", "tables off"),
        (false, _) => ("red", "beyond"),
    };
    let of_reference = |part: fn(&ReferenceCheck) -> f64| reference.map_or(f64::NAN, part);
    context! {
        specimen => if first { row.specimen.as_str() } else { "" },
        scene => &cpu.scene,
        cells => [
            cpu.mean,
            cpu.worst,
            cpu.tolerance,
            cpu.worst_of_tolerance,
            row.picture.as_ref().map_or(f64::NAN, |picture| picture.relative_l2),
            of_reference(|reference| reference.mean),
            of_reference(|reference| reference.worst),
            of_reference(|reference| reference.look_up_mean),
            of_reference(|reference| reference.unexplained),
            of_reference(|reference| reference.ciede2000.max),
        ]
        .map(two),
        tone => verdict.0,
        verdict => verdict.1,
    }
}

fn frame_times(frames: &FrameComparison) -> Value {
    let method = |name: &str, frame: &MethodFrame| {
        let time = &frame.time;
        context! {
            name,
            tables => time.tables,
            errors => frame.error_p95.map(|error| numbers::number(error, 2)),
            median => numbers::with_unit(time.median_ms, 3, "ms"),
            shortest => numbers::with_unit(time.shortest_ms, 3, "ms"),
            rate => numbers::round_number(1e3 / time.median_ms, 3),
            bandwidth => numbers::with_unit(time.texel_gb_per_s, 3, "GB/s"),
        }
    };
    let mut methods = vec![method("this atlas", &frames.atlas)];
    methods.extend(frames.taylor.iter().map(|taylor| method("published method (Taylor)", taylor)));
    let time = &frames.atlas.time;
    let clock = match time.clock {
        Clock::Timestamps => "the GPU’s own clock",
        Clock::Wall => "the time from submission to end",
    };
    context! {
        about => format!(
            "The coiled snake in {0} × {0} pixels under one light, {1} pairs of directions a frame, from the tables of {2}: the \
             lighting pass over stored surfaces, {3} frames each, in turns, by {clock}.",
            time.size_px,
            numbers::count(time.evaluations),
            frames.specimen,
            numbers::count(time.frames as u64)
        ),
        methods,
        ratio => frames.ratio().map(|ratio| numbers::number(ratio, 3)),
        refused => &frames.refused,
        copy => numbers::with_unit(frames.copy_gb_per_s, 3, "GB/s"),
    }
}

#[cfg(test)]
mod tests {
    use ndarray::Array3;

    use super::*;
    use crate::stages::gpu::check::{CpuPictures, compare, compare_with_reference};

    fn checked(rows: Vec<GpuRow>) -> GpuResult {
        let gpu = GpuInfo {
            adapter: "some card".into(),
            backend: "vulkan".into(),
            driver: "its driver".into(),
            kind: "discretegpu".into(),
            vendor_device: [1, 2],
            timestamps: true,
            texture_side_max: 16_384,
            texture_layers_max: 2048,
            storage_binding_max_bytes: 1 << 30,
            features: Vec::new(),
        };
        GpuResult::Checked { gpu: Box::new(gpu), rows, spectral: Vec::new(), frames: None }
    }

    /// Pictures of ones whose tables are off by `tables` and whose GPU adds `added`, where 0.01 is allowed.
    fn row(tables: f32, added: f32, promised: bool) -> GpuRow {
        let image = |value: f32| Array3::from_elem((2, 2, 3), value);
        let (by_cpu, by_gpu) = (image(1.0 + tables), image(1.0 + tables + added));
        let cpu = compare(&by_cpu, &by_gpu, &image(0.01), 1.0);
        let pictures = CpuPictures { linear: &by_cpu, cubic: &by_cpu };
        let reference = compare_with_reference(&image(1.0), pictures, &by_gpu, &image(0.01), 1.0, 0.02);
        GpuRow { specimen: "a".into(), cpu, picture: None, reference: Some(reference), promised, difference_png: None }
    }

    #[test]
    fn whose_fault_it_is_can_be_read() {
        let verdict = |row: &GpuRow| {
            let view = comparison(row, true);
            [view.get_attr("tone").unwrap().to_string(), view.get_attr("verdict").unwrap().to_string()].join(": ")
        };
        let good = row(0.01, 0.005, true);
        assert_eq!(verdict(&good), "green: within");
        assert!(good.complaint().is_none());
        let wrong = row(0.01, 0.5, true);
        assert_eq!(verdict(&wrong), "red: beyond");
        assert!(wrong.complaint().unwrap().contains("differs from the CPU by"));
        let inaccurate = row(0.5, 0.005, true);
        assert_eq!(verdict(&inaccurate), "red: tables off");
        assert!(inaccurate.complaint().unwrap().contains("the tables are wrong"));
        let coarse = row(0.5, 0.005, false);
        assert_eq!(verdict(&coarse), "amber: within, tables coarse");
        assert!(coarse.passed() && coarse.complaint().is_none());
        assert_eq!(headline(&checked(vec![good.clone(), coarse]), true).1, "2 scenes within limits on some card");
        assert_eq!(headline(&checked(vec![good, wrong, inaccurate]), true).0, "red");
    }

    #[test]
    fn the_headline_says_what_was_not_done() {
        let skipped = GpuResult::Skipped { why: "no adapter (none)".into() };
        assert_eq!(headline(&skipped, true), ("amber", "skipped: no adapter (none)".into()));
        assert_eq!(headline(&GpuResult::Off, true).0, "");
        assert_eq!(headline(&checked(vec![]), false), ("", "no scenes to compare".into()));
        assert_eq!(headline(&checked(vec![]), true), ("amber", "nothing compared on some card".into()));
        assert_eq!(headline(&GpuResult::Unusable { why: "it hangs".into() }, true), ("red", "it hangs".into()));
    }
}
