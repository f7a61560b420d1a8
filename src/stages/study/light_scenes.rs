//! Shapes under lights with a size: some pixels of large pictures, by filtered look-ups and by points.

use std::time::Instant;

use diffraction_brdf::Brdf;
use diffraction_render::render::cpu::{shade, shade_filtered};
use diffraction_render::scene::filtered::filtered_samples_of;
use diffraction_render::scene::model::{Light, Scene, Shape};
use diffraction_render::scene::samples::samples_of;
use diffraction_study::error::Result;
use diffraction_study::study::{LightPicture, LightScene, LookUps};

/// Side of the pictures, whose pixels are smaller than any of the lights.
const SIDE_PX: usize = 600;

/// Rows of pixels gathered at a time, so that thousands of samples of each fit into memory.
const BAND_ROWS: usize = 2;

/// A tolerance that takes every light as a whole, and one that takes none so.
const WHOLE: f64 = f64::MAX;
const IN_PARTS: f64 = 0.0;

/// One shape, and every how manieth pixel is drawn.
#[derive(Debug)]
pub struct LitShape {
    name: &'static str,
    scene: Scene,
    stride: usize,
}

/// The shapes, `pixels` along a side each.
pub fn lit_shapes(pixels: usize) -> Vec<Box<dyn LightScene>> {
    let shapes = [
        ("ball", Shape::Sphere),
        ("snake", Shape::Snake),
        ("patch", Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 30.0, turn_deg: 0.0 }),
        (
            "screen",
            Shape::Screen {
                distance_mm: 100.0,
                width_mm: 200.0,
                beam_diameter_mm: 0.2,
                hole_diameter_mm: None,
                incidence_deg: 0.0,
            },
        ),
    ];
    // Above the mirror direction of the patch, beside that of the ball.
    let light = Light::point([0.35, 0.866, 0.5]);
    let stride = SIDE_PX.div_ceil(pixels.max(1));
    let lit = |(name, shape)| LitShape { name, scene: Scene::still(name, shape, vec![light], SIDE_PX), stride };
    shapes.map(|shape| Box::new(lit(shape)) as Box<dyn LightScene>).into()
}

impl LightScene for LitShape {
    fn shape(&self) -> &str {
        self.name
    }

    fn picture(&self, brdf: &Brdf, diameter_deg: f64, look_ups: LookUps) -> Result<LightPicture> {
        let light = Light { angular_diameter_deg: diameter_deg, ..self.scene.lights[0] };
        let (LookUps::Points(count) | LookUps::Filtered(count)) = look_ups;
        let scene = Scene { lights: vec![light], light_samples: count, pixel_samples: count, ..self.scene.clone() };
        let (mut parts, mut seconds) = (Vec::new(), 0.0);
        for first in (0..SIDE_PX).step_by(BAND_ROWS * self.stride) {
            let rows = first..SIDE_PX.min(first + BAND_ROWS * self.stride);
            let part = match look_ups {
                LookUps::Points(_) => {
                    let samples = samples_of(&scene, rows, self.stride)?;
                    timed(&mut seconds, || shade(&samples, &|wi, wo| brdf.eval(wi, wo)))
                }
                LookUps::Filtered(count) => {
                    let tolerance = if count == 1 { WHOLE } else { IN_PARTS };
                    let samples = filtered_samples_of(&scene, tolerance, rows, self.stride)?;
                    timed(&mut seconds, || shade_filtered(&samples, &|wi, wo, area| brdf.eval_filtered(wi, wo, area)))
                }
            };
            parts.push(part);
        }
        let views: Vec<_> = parts.iter().map(|part| part.view()).collect();
        let image = ndarray::concatenate(ndarray::Axis(0), &views).expect("bands of one picture are as wide");
        Ok(LightPicture { image, seconds })
    }
}

fn timed<T>(seconds: &mut f64, work: impl FnOnce() -> T) -> T {
    let started = Instant::now();
    let found = work();
    *seconds += started.elapsed().as_secs_f64();
    found
}
