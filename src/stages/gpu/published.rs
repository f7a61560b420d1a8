//! A specimen's published files drawn on the GPU and compared with the CPU, and with the published pictures and the reference's.
//!
//! All comes from files of a specimen's folder: tables, pictures, reference pictures.

use std::path::Path;
use std::sync::Arc;

use ndarray::Array3;

use super::check::{Shade, bands, check_picture, check_reference, compare_pictures, reference_limit};
use super::device::GpuDevice;
use super::results::{GpuRow, PictureCheck, ReferenceCheck};
use crate::stages::archive::specimen_file::{self, SpecimenFile};
use crate::stages::pictures::scenes::reference_stride;
use diffraction_brdf::atlas::DIFFERENCE_SUFFIX;
use diffraction_brdf::error::Error;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::exr_image::read_rgb;
use diffraction_brdf::shader::{LAYERS_MAX, SIDE_MAX, promised_image, table_image};
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::pigment::Surface;
use diffraction_build::tables::model::{Basis, Storage, TableSet, TablesConfig};
use diffraction_build::tables::resolution::narrowest_blur;
use diffraction_render::error::Result;
use diffraction_render::render::gpu_filtered::shade_filtered;
use diffraction_render::render::gpu_tables::{shade as shade_points, upload};
use diffraction_render::render::png_image::write_png;
use diffraction_render::scene::filtered::{FilteredSamples, filtered_per_pixel, filtered_samples_of};
use diffraction_render::scene::model::{LookUps, Scene, exposure_factor};
use diffraction_render::scene::samples::{ShadingSamples, samples_of, samples_per_pixel};

/// Most pixels compared along each side on a software driver, which takes seconds beyond: every which pixel then.
/// Hardware draws whole pictures.
const SOFTWARE_SIDE_MAX_PX: usize = 128;

/// Checks scenes from the files in a specimen's folder; where a comparison fails, a picture of the differences is written
/// beside the scene's. `reference` says whether there are reference pictures.
///
/// # Errors
/// `Error::Gpu` above all; the disk's. A picture that differs is no error.
pub fn check_files(
    device: &GpuDevice,
    folder: &Path,
    specimen: &str,
    scenes: &[&Scene],
    config: &TablesConfig,
    reference: bool,
) -> Result<Vec<GpuRow>> {
    let (file, set) = specimen_file::load(folder)?;
    let thread = device.thread();
    let pigment = file.pigment;
    let surface = Surface { tables: &set, pigment: pigment.as_ref() };
    let image = table_image(&set, pigment.map(|pigment| pigment.xyz_per_sr))?;
    let promised = promised_image(&set, pigment.map(|pigment| pigment.xyz_per_sr))?;
    let uploaded = thread.run("upload the tables", move |gpu| Ok([upload(gpu, &image)?, upload(gpu, &promised)?]))?;
    let [tables, promised] = uploaded.map(Arc::new);
    let shade = |samples: &Arc<ShadingSamples>| {
        let (tables, samples) = (tables.clone(), samples.clone());
        thread.run("shade samples", move |gpu| shade_points(gpu, &tables, &samples))
    };
    let by_promised = |samples: Looked| {
        let tables = promised.clone();
        thread.run("shade a picture", move |gpu| match samples {
            Looked::Points(samples) => shade_points(gpu, &tables, &Arc::new(samples)),
            Looked::Filtered(samples) => shade_filtered(gpu, &tables, &samples),
        })
    };
    let storage = file.tables.storage;
    let job = Job {
        shade: &shade,
        by_promised: &by_promised,
        surface,
        optics: &file.optics,
        storage,
        folder,
        specimen,
        config,
        reference,
    };
    let side_max = if device.info().is_software() { SOFTWARE_SIDE_MAX_PX } else { usize::MAX };
    scenes.iter().map(|scene| job.check(scene, scene.size_px.div_ceil(side_max))).collect()
}

/// The samples of a published picture.
enum Looked {
    Points(ShadingSamples),
    Filtered(FilteredSamples),
}

/// What the scenes of a specimen have in common.
struct Job<'a> {
    shade: Shade<'a>,
    /// Shades with the look-ups that pictures are made with.
    by_promised: &'a dyn Fn(Looked) -> Result<Array3<f32>>,
    surface: Surface<'a>,
    optics: &'a OpticsConfig,
    storage: Storage,
    folder: &'a Path,
    specimen: &'a str,
    config: &'a TablesConfig,
    reference: bool,
}

impl Job<'_> {
    fn check(&self, scene: &Scene, stride: usize) -> Result<GpuRow> {
        let mut cpu = check_picture(self.shade, self.surface, scene, stride)?;
        let mut picture = self.against_picture(scene, stride)?;
        let mut reference = match self.reference {
            false => None,
            true => Some(self.against_reference(scene)?),
        };
        let of_reference = reference.as_mut().and_then(|check| check.difference.take());
        let difference = cpu.difference.take().or_else(|| picture.difference.take()).or(of_reference);
        let difference_png = difference.map(|picture| self.write_difference(&picture, &scene.name)).transpose()?;
        let promised = tolerance_holds(self.surface.tables, self.optics, self.config);
        let picture = Some(picture);
        Ok(GpuRow { specimen: self.specimen.to_owned(), cpu, picture, reference, promised, difference_png })
    }

    fn against_reference(&self, scene: &Scene) -> Result<ReferenceCheck> {
        let side = scene.size_px.div_ceil(reference_stride(scene));
        let reference = self.picture(scene, ".reference.exr", side)?;
        let limit = reference_limit(self.config.tolerance, self.storage);
        check_reference(self.shade, self.surface, scene, &reference, limit)
    }

    /// Every `stride`-th pixel of the published picture.
    fn against_picture(&self, scene: &Scene, stride: usize) -> Result<PictureCheck> {
        let published = self.picture(scene, ".exr", scene.size_px)?;
        let is_filtered = scene.look_ups == LookUps::Filtered && self.surface.tables.restriction.is_none();
        let (per_pixel, tolerance) = match is_filtered {
            true => (filtered_per_pixel(scene), scene.tolerance.unwrap_or(self.config.tolerance)),
            false => (samples_per_pixel(scene), 0.0),
        };
        let parts = bands(scene, per_pixel, stride).into_iter().map(|rows| {
            (self.by_promised)(match is_filtered {
                true => Looked::Filtered(filtered_samples_of(scene, tolerance, rows, stride)?),
                false => Looked::Points(samples_of(scene, rows, stride)?),
            })
        });
        let parts = parts.collect::<Result<Vec<_>>>()?;
        let views: Vec<_> = parts.iter().map(|part| part.view()).collect();
        let by_gpu = ndarray::concatenate(ndarray::Axis(0), &views).expect("bands of one picture are as wide");
        let white = 1.0 / f64::from(exposure_factor(scene.exposure, &published));
        Ok(compare_pictures(&every(&published, stride), &by_gpu, white))
    }

    fn picture(&self, scene: &Scene, ending: &str, side: usize) -> Result<Array3<f32>> {
        let path = self.folder.join(format!("scenes/{}{ending}", scene.name));
        let (image, _) = read_rgb(&path)?;
        if image.dim() == (side, side, 3) {
            return Ok(image);
        }
        let what = format!("has {} by {} pixels where the scene has {side} by {side}", image.dim().1, image.dim().0);
        Err(Error::bad_file(&path, what, "run the pipeline again to draw it anew").into())
    }

    /// Path of the written picture, relative to the report.
    fn write_difference(&self, picture: &Array3<u8>, scene: &str) -> Result<String> {
        let file = format!("scenes/{scene}{DIFFERENCE_SUFFIX}");
        write_png(&self.folder.join(&file), picture)?;
        Ok(format!("{}/{file}", self.specimen))
    }
}

/// Every `stride`-th pixel of an image.
fn every(image: &Array3<f32>, stride: usize) -> Array3<f32> {
    let (rows, columns, channels) = image.dim();
    Array3::from_shape_fn((rows.div_ceil(stride), columns.div_ceil(stride), channels), |(row, column, channel)| {
        image[[row * stride, column * stride, channel]]
    })
}

/// Whether tables must be as good as the tolerance says: number and steps were left to it, texels hold point values of a
/// grid that resolves the lobes, and the scan answers for the whole hemisphere. A size that follows from splines promises nothing to the
/// linear look-ups of pictures.
fn tolerance_holds(set: &TableSet, optics: &OpticsConfig, config: &TablesConfig) -> bool {
    let texel = 4.0 / (set.size().max(2) - 1) as f64;
    set.basis == Basis::Chebyshev
        && config.count.is_none()
        && (config.size.is_some() || set.look_up() == Interpolation::Bilinear)
        && config.wavelength_step_nm.is_none()
        && set.prefilter_width == 0.0
        && set.usable_radius >= 2.0
        && texel <= narrowest_blur(optics)
}

/// Why the tables in a specimen's folder are more than every GPU takes, if they are.
pub(super) fn beyond_limits(folder: &Path) -> Option<String> {
    let SpecimenFile { tables, spectral, .. } = specimen_file::read(folder).ok()?;
    // Derived tables are as many as those that they come from.
    let derived = spectral.filter(|_| tables.derived_under.is_some()).map_or(0, |spectral| spectral.tables);
    let (layers, side) = (tables.tables.len().max(derived), tables.u.samples.max(tables.v.samples));
    let layers_max = LAYERS_MAX - usize::from(tables.restriction.is_some());
    if layers > layers_max {
        return Some(format!("its {layers} tables are more than the {layers_max} layers that every GPU takes"));
    }
    (side > SIDE_MAX)
        .then(|| format!("its tables are {side} texels wide, more than the {SIDE_MAX} that every GPU takes"))
}
