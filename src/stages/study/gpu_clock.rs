//! Evaluation time on a GPU: frames of a ball drawn from the tables, per pair of directions.

use diffraction_brdf::shader::{promised_image, table_image};
use diffraction_build::tables::model::TableSet;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_frame::{Frame, FramePlan, FrameTime, time_frames};
use diffraction_render::render::gpu_tables::{GpuTables, upload};
use diffraction_render::scene::gbuffer::{GBuffer, filtered_gbuffer, gbuffer};
use diffraction_render::scene::model::{Light, Scene, Shape};
use diffraction_study::error::{Error, Result};
use diffraction_study::study::{FrameOfLight, GpuClock};

/// Side of the frame, and lights per pixel: some 20 000 pairs of directions.
const SIDE_PX: usize = 96;
const LIGHT_SAMPLES: usize = 4;

/// Side of the frames under lights with a size: the snake, whose scales look tables up all over the place.
const LIT_SIDE_PX: usize = 256;

/// Points of a light that filtered look-ups are compared with.
const POINTS: [usize; 3] = [16, 64, 256];

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
        self.measure(set).map_err(lent)
    }

    fn frames_under_light(&self, set: &TableSet, published: &TableSet, diameter_deg: f64) -> Result<Vec<FrameOfLight>> {
        self.under_light(set, published, diameter_deg).map_err(lent)
    }
}

/// What is timed: its name, the tables, and surfaces with lights.
type Way<'a> = (String, &'a GpuTables, &'a GBuffer);

fn drawn<'a>(gpu: &'a Gpu, way: &Way<'a>) -> diffraction_render::error::Result<Frame<'a>> {
    Frame::new(gpu, way.1, way.2, 1.0)
}

/// What went wrong on the GPU, in the words of a study.
fn lent(error: diffraction_render::error::Error) -> Error {
    match error {
        diffraction_render::error::Error::Library(error) => error.into(),
        gpu @ diffraction_render::error::Error::Gpu(_) => Error::Lent(gpu.to_string()),
    }
}

impl FrameClock {
    fn under_light(
        &self,
        set: &TableSet,
        published: &TableSet,
        diameter_deg: f64,
    ) -> diffraction_render::error::Result<Vec<FrameOfLight>> {
        let gpu = &self.gpu;
        let [linear, published] = [set, published].map(|set| upload(gpu, &table_image(set, None)?));
        let (linear, published, splines) = (linear?, published?, upload(gpu, &promised_image(set, None)?)?);
        let light = Light { angular_diameter_deg: diameter_deg, ..Light::point([0.5, 0.4, 1.0]) };
        let scene =
            |light_samples| Scene { light_samples, ..Scene::still("time", Shape::Snake, vec![light], LIT_SIDE_PX) };
        let (point, filtered) = (gbuffer(&scene(1))?, filtered_gbuffer(&scene(1))?);
        let of_points = POINTS.map(|count| gbuffer(&scene(count)).map(|surfaces| (count, surfaces)));
        let of_points = of_points.into_iter().collect::<std::result::Result<Vec<_>, _>>()?;
        let mut ways = vec![
            ("a point".to_owned(), &linear, &point),
            ("one filtered look-up".into(), &linear, &filtered),
            ("a point, by splines".into(), &splines, &point),
            ("one filtered look-up, by splines".into(), &splines, &filtered),
        ];
        ways.extend(of_points.iter().map(|(count, surfaces)| (format!("{count} points"), &linear, surfaces)));
        ways.push(("published method, a point".into(), &published, &point));
        ways.push((format!("published method, {} points", POINTS[0]), &published, &of_points[0].1));
        let frames = ways.iter().map(|way| drawn(gpu, way)).collect::<diffraction_render::error::Result<Vec<_>>>()?;
        let times = time_frames([0, 1, 2, 3, 4, 5, 6, 7, 8].map(|k| &frames[k]), FramePlan::suited_to(gpu))?;
        let row = |((what, ..), time): (&Way, FrameTime)| FrameOfLight {
            what: what.clone(),
            tables: time.tables,
            look_ups: time.evaluations,
            median_ms: time.median_ms,
        };
        Ok(ways.iter().zip(times).map(row).collect())
    }

    fn measure(&self, set: &TableSet) -> diffraction_render::error::Result<f64> {
        let tables = upload(&self.gpu, &table_image(set, None)?)?;
        let frame = Frame::new(&self.gpu, &tables, &self.surfaces, 1.0)?;
        let [time] = time_frames([&frame], FramePlan::suited_to(&self.gpu))?;
        Ok(time.median_ms * 1e-3 / time.evaluations.max(1) as f64)
    }
}
