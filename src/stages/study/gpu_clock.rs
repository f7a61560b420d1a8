//! Evaluation time on a GPU: frames of a ball drawn from the tables, per pair of directions.

use diffraction_brdf::shader::table_image;
use diffraction_build::tables::model::TableSet;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_frame::{Frame, FramePlan, time_frames};
use diffraction_render::render::gpu_tables::upload;
use diffraction_render::scene::gbuffer::{GBuffer, gbuffer};
use diffraction_render::scene::model::{Light, Scene, Shape};
use diffraction_study::error::{Error, Result};
use diffraction_study::study::GpuClock;

/// Side of the frame, and lights per pixel: some 20 000 pairs of directions.
const SIDE_PX: usize = 96;
const LIGHT_SAMPLES: usize = 4;

/// A GPU that draws one scene again and again.
#[derive(Debug)]
pub struct FrameClock {
    gpu: Gpu,
    surfaces: GBuffer,
}

impl FrameClock {
    /// Opens the adapter; `None` where there is none.
    ///
    /// # Errors
    /// `Error::Gpu` if there is one and it fails.
    pub fn open() -> diffraction_render::error::Result<Option<Self>> {
        let Some(gpu) = Gpu::open()? else { return Ok(None) };
        let light = Light { angular_diameter_deg: 0.53, ..Light::point([0.3, 0.2, 1.0]) };
        let scene = Scene { light_samples: LIGHT_SAMPLES, ..Scene::still("ball", Shape::Sphere, vec![light], SIDE_PX) };
        Ok(Some(Self { gpu, surfaces: gbuffer(&scene)? }))
    }
}

impl GpuClock for FrameClock {
    fn adapter(&self) -> String {
        let info = self.gpu.info();
        let software = if info.kind == "cpu" { ", software on the processor's own cores" } else { "" };
        format!("{} ({}{software})", info.adapter, info.backend)
    }

    fn seconds_per_direction(&self, set: &TableSet) -> Result<f64> {
        self.measure(set).map_err(|error| match error {
            diffraction_render::error::Error::Library(error) => error.into(),
            gpu @ diffraction_render::error::Error::Gpu(_) => Error::Lent(gpu.to_string()),
        })
    }
}

impl FrameClock {
    fn measure(&self, set: &TableSet) -> diffraction_render::error::Result<f64> {
        let tables = upload(&self.gpu, &table_image(set, None)?)?;
        let frame = Frame::new(&self.gpu, &tables, &self.surfaces, 1.0)?;
        let [time] = time_frames([&frame], FramePlan::suited_to(&self.gpu))?;
        Ok(time.median_ms * 1e-3 / time.evaluations.max(1) as f64)
    }
}
