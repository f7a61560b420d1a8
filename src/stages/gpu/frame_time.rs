//! Frame time of the atlas's tables against the published method's at equal measured error, in the same run.
//!
//! Equal error: of all numbers of the published tables, the smallest that is as good as the atlas's tables in every
//! region of directions, or as good as that series ever gets there. Errors are those of the tables as the GPU holds them,
//! in half floats, with cubic look-ups: what the linear look-ups of hardware add depends on the grid, which is the same.
//!
//! The frame is the coiled snake under one light: scales that each lie a little differently look tables up all over the
//! place, where a ball's neighbouring pixels share texels.

use std::path::Path;

use super::device::GpuDevice;
use super::results::{FrameComparison, MethodFrame};
use crate::stages::archive::specimen_file;
use crate::stages::config::{RunConfig, SpecimenConfig};
use crate::stages::ingest::{Scans, ingest};
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::Error;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::shader::{TableImage, table_image};
use diffraction_brdf::storage::round_to_half;
use diffraction_build::accuracy::directions::{ErrorDirections, ErrorGroup};
use diffraction_build::accuracy::reference;
use diffraction_build::ground::metrics;
use diffraction_build::tables::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Storage, TableSet, TablesConfig};
use diffraction_build::tables::plan;
use diffraction_render::error::Result;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_frame::{Frame, FramePlan, FrameTime, copy_gb_per_s, time_frames};
use diffraction_render::render::gpu_tables::upload;
use diffraction_render::scene::gbuffer::{GBuffer, gbuffer};
use diffraction_render::scene::model::{Light, Scene, Shape};

/// Side of the frame.
const SIZE_PX: usize = 1024;

/// What the published method's error may be above the atlas's, relative, to count as equal: quantiles over a hundred
/// directions are not better known.
const EQUAL: f64 = 1.05;

/// Times frames of a specimen whose tables are in `folder`.
///
/// # Errors
/// `Error::Gpu`; those of the scans and of the reference. A published method that is refused is part of the result.
pub fn compare(
    device: &GpuDevice,
    config: &RunConfig,
    specimen: &SpecimenConfig,
    folder: &Path,
) -> Result<FrameComparison> {
    let (_, atlas) = specimen_file::load(folder)?;
    let Scans { fields, optics, .. } = ingest(specimen)?;
    let plan = plan::plan(&BuildInput::new(&fields, &optics, &config.tables))?;
    let directions = ErrorDirections::of_regions(&atlas);
    let (groups, pairs) = (directions.groups.clone(), directions.pairs.clone());
    let exact = reference::evaluate(&fields, &optics, &plan, atlas.tables.len(), directions, [])?.xyz;
    let atlas = as_on_gpu(atlas);
    let errors = |set: &TableSet| errors_p95(set, &groups, &pairs, &exact);
    let atlas_errors = errors(&atlas);
    // Wavelengths, grid and averages over it stay as they are; the tables come in full precision and are then rounded.
    let wanted =
        TablesConfig { basis: Basis::Taylor, storage: Some(Storage::Float), count: None, ..config.tables.clone() };
    let (taylor, refused) = match build::build(&BuildInput::new(&fields, &optics, &wanted), &|_| ()) {
        Ok((set, _)) => (Some(at_equal_error(as_on_gpu(set), atlas_errors, errors)), None),
        Err(error @ Error::Limit { .. }) => (None, Some(error.to_string())),
        Err(error) => return Err(error.into()),
    };
    let atlas_image = table_image(&atlas, None)?;
    let taylor_image = taylor.as_ref().map(|(set, _)| table_image(set, None)).transpose()?;
    let light = Light::point([0.3, 0.2, 1.0]);
    let surfaces = gbuffer(&Scene::still("frame", Shape::Snake, vec![light], SIZE_PX))?;
    let ((atlas_time, taylor_time), copy_gb_per_s) =
        device.thread().run("time frames", move |gpu| time(gpu, &surfaces, &atlas_image, taylor_image.as_ref()))?;
    let taylor = taylor.zip(taylor_time).map(|((_, error_p95), time)| MethodFrame { error_p95, time });
    Ok(FrameComparison {
        specimen: specimen.name.clone(),
        atlas: MethodFrame { error_p95: atlas_errors, time: atlas_time },
        taylor,
        refused,
        copy_gb_per_s,
    })
}

/// The tables with the rounding that uploading brings.
fn as_on_gpu(mut set: TableSet) -> TableSet {
    set.tables.iter_mut().for_each(round_to_half);
    set.lobe.iter_mut().flat_map(|lobe| &mut lobe.cross).for_each(round_to_half);
    set
}

/// 95th percentile of the luminance's relative error in each region.
fn errors_p95(set: &TableSet, groups: &[ErrorGroup], pairs: &[(Vec3, Vec3)], exact: &[Xyz]) -> [f64; 3] {
    let luminance = |xyz: &Xyz| xyz[1];
    let found: Vec<f64> =
        pairs.iter().map(|&(wi, wo)| luminance(&brdf_xyz(set, Interpolation::Cubic, wi, wo))).collect();
    let exact: Vec<f64> = exact.iter().map(luminance).collect();
    let mut start = 0;
    std::array::from_fn(|region| {
        let range = start..start + groups[region].len();
        start = range.end;
        metrics::relative_error_quantiles(&exact[range.clone()], &found[range], groups[region].floor_per_sr).p95
    })
}

/// The first so many tables of a series that are as good as `target`, or as good as any number of them; and their errors.
fn at_equal_error(mut set: TableSet, target: [f64; 3], errors: impl Fn(&TableSet) -> [f64; 3]) -> (TableSet, [f64; 3]) {
    let (mut last, mut by_count) = (Vec::new(), Vec::new());
    while !set.tables.is_empty() {
        by_count.push(errors(&set));
        last.extend(set.tables.pop());
    }
    by_count.reverse();
    let count = equal_count(&by_count, target);
    set.tables = last.into_iter().rev().take(count).collect();
    (set, by_count[count - 1])
}

/// The smallest number of terms that is good enough; `errors[n - 1]` are those of `n` terms.
fn equal_count(errors: &[[f64; 3]], target: [f64; 3]) -> usize {
    let best = |region: usize| errors.iter().map(|e| e[region]).fold(f64::INFINITY, f64::min);
    let allowed: [f64; 3] = std::array::from_fn(|region| EQUAL * target[region].max(best(region)));
    let good = |e: &[f64; 3]| e.iter().zip(&allowed).all(|(error, allowed)| error <= allowed);
    // From the end: a small number may be good by chance where a larger one is not.
    errors.len() - errors.iter().rev().take_while(|e| good(e)).count().saturating_sub(1).min(errors.len() - 1)
}

/// Frame times of both sets, and the bandwidth of copying.
fn time(
    gpu: &Gpu,
    surfaces: &GBuffer,
    atlas: &TableImage,
    taylor: Option<&TableImage>,
) -> Result<((FrameTime, Option<FrameTime>), f64)> {
    let plan = FramePlan::suited_to(gpu);
    let atlas = upload(gpu, atlas)?;
    let atlas = Frame::new(gpu, &atlas, surfaces, 1.0)?;
    let times = match taylor {
        Some(taylor) => {
            let taylor = upload(gpu, taylor)?;
            let [atlas, taylor] = time_frames([&atlas, &Frame::new(gpu, &taylor, surfaces, 1.0)?], plan)?;
            (atlas, Some(taylor))
        }
        None => {
            let [atlas] = time_frames([&atlas], plan)?;
            (atlas, None)
        }
    };
    Ok((times, copy_gb_per_s(gpu)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_number_that_is_good_enough_is_taken() {
        let errors = [[0.5, 0.5, 0.5], [0.1, 0.2, 0.1], [0.01, 0.2, 0.02], [0.009, 0.2, 0.01], [0.009, 0.2, 0.01]];
        assert_eq!(equal_count(&errors, [0.011, 0.3, 0.02]), 3);
        // The middle region never gets there: as good as it gets must do.
        assert_eq!(equal_count(&errors, [0.011, 0.01, 0.02]), 3);
        assert_eq!(equal_count(&errors, [0.009, 0.01, 0.01]), 4);
        assert_eq!(equal_count(&errors, [1.0, 1.0, 1.0]), 1);
        // Good by chance, then worse.
        let errors = [[0.5; 3], [0.01; 3], [0.1; 3], [0.01; 3]];
        assert_eq!(equal_count(&errors, [0.01; 3]), 4);
        assert_eq!(equal_count(&errors[..1], [0.01; 3]), 1);
    }
}
