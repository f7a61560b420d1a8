//! Spectral tables in files: three tables to an EXR image, as its channels R, G and B.
//!
//! Images of three channels are what every reader opens; a channel per file would be three times as many look-ups and
//! files, and more than four channels or layers are lost in some readers.

use std::path::Path;

use ndarray::Array3;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::direction::Vec3;
use crate::dispersion::Dispersion;
use crate::error::{Error, Result};
use crate::front_factor::FrontFactor;
use crate::parallel;
use crate::spectral::{SpectralCross, SpectralLobe, SpectralTables, TABLES_PER_IMAGE};
use crate::stored_image::{Axis, FIX, ImageJob, StoredArray, read_array};
use crate::table_set::{Rounding, Storage};

/// What a renderer computes from spectral tables.
const FORMULA: &str = "f = r^4 D (sum_n table_n T_n(2t - 1) + sum_n cross_n T_n(2t - 1) / |w'|) + r^2 C lobe(|w'| / 2) \
(exp(-(2 pi sigma rho / lambda)^2) + exp(-(2 pi sigma rho_h / lambda)^2)), r = lambda_0 / lambda, (u', v', w') = r (u, v, w), \
t = |w'| / sqrt(4 - u'^2 - v'^2)";

/// The same under a source of fixed size.
const SOURCE_FORMULA: &str = "f = r^4 D sum_n table_n T_n(2t - 1) + C lobe(|w'| / 2) \
(exp(-(2 pi sigma rho / lambda_0)^2) + exp(-(2 pi sigma rho_h / lambda_0)^2)), r = lambda_0 / lambda, \
(u', v', w') = r (u, v, w), t = |w'| / sqrt(4 - u'^2 - v'^2)";

/// Directions and the BRDF that the stored spectral tables give there at some wavelengths: a test for other programs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpectralCheckValue {
    /// Unit vector to the light.
    pub wi: Vec3,
    /// Unit vector to the viewer.
    pub wo: Vec3,
    /// Wavelengths in nm.
    pub wavelength_nm: Vec<f64>,
    /// The BRDF in 1/sr at each, from linear look-ups in the stored tables.
    pub brdf: Vec<f64>,
    /// The same by splines; empty in older atlases.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub brdf_spline: Vec<f64>,
}

/// Everything needed to read the spectral tables of a specimen again, apart from its material.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredSpectral {
    /// The formula in words of a program.
    pub formula: String,
    /// `lambda_0` in nm: the shortest wavelength that is answered for.
    pub shortest_nm: f64,
    /// Longest wavelength in nm over which lights are summed.
    pub longest_nm: f64,
    /// Number format of tables and cross term.
    pub storage: Storage,
    /// What storing did to the values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rounding: Option<Rounding>,
    /// Columns of the tables: the spatial frequency along x in 1/nm, `u / lambda`.
    pub xi_per_nm: Axis,
    /// Rows of the tables: the same along y, `v / lambda`.
    pub eta_per_nm: Axis,
    /// Side of the square in (u', v') over which each texel is averaged; 0 for point samples.
    pub prefilter_width: f64,
    /// Radius in (u', v') up to which the scans' sampling can answer.
    pub usable_radius: f64,
    /// Standard deviation in nm of the coherence window of the diffuse part.
    pub sigma_nm: f64,
    /// Half the scans' range of heights in nm.
    pub half_height_range_nm: f64,
    /// The material's index by wavelength; absent where it is that of `optics.material` at every one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dispersion: Option<Dispersion>,
    /// Number of tables.
    pub tables: usize,
    /// Their images: table `3 i + c` is channel `c`, R before G before B, of image `i`.
    pub images: Vec<StoredArray>,
    /// The lobe; absent where the surface has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lobe: Option<StoredSpectralLobe>,
    /// Directions with values, for testing a reader.
    #[serde(default)]
    pub check_values: Vec<SpectralCheckValue>,
}

/// The lobe's files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredSpectralLobe {
    /// Standard deviation in nm of the light's coherence window, at the shortest wavelength.
    pub sigma_nm: f64,
    /// Whether it grows in proportion to the wavelength, as under a source of fixed size; absent where it does not.
    #[serde(default, rename = "sigma_grows", skip_serializing_if = "std::ops::Not::not")]
    pub is_of_source: bool,
    /// Columns of the lobe's image, which has one row of three equal channels: `|w'| / 2`.
    pub half_abs_w: Axis,
    /// The power of the mean phasor; always 32-bit floats.
    pub power: StoredArray,
    /// The cross term; absent where it vanishes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cross: Option<StoredSpectralCross>,
}

/// The cross term's files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredSpectralCross {
    /// Number of patches.
    pub patches: usize,
    /// Columns, in 1/nm.
    pub xi_per_nm: Axis,
    /// Rows, in 1/nm.
    pub eta_per_nm: Axis,
    /// Packed as the tables are.
    pub images: Vec<StoredArray>,
}

impl StoredSpectral {
    /// Names of all files in the specimen's folder.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        let lobe = self.lobe.iter().flat_map(|lobe| {
            let patches = lobe.cross.iter().flat_map(|cross| &cross.images);
            std::iter::once(&lobe.power).chain(patches)
        });
        self.images.iter().chain(lobe).map(|array| array.file.as_str())
    }
}

/// Writes `spectral.NNN.exr` and, where there is a lobe, `spectral_lobe.exr` and `spectral_cross.NNN.exr` into an existing folder.
///
/// # Errors
/// The disk's, and values that the number format cannot hold.
pub fn write_spectral(folder: &Path, tables: &SpectralTables, storage: Storage) -> Result<StoredSpectral> {
    let [xi, eta] = axes(2.0 / tables.shortest_nm, tables.size());
    let mut jobs = Vec::new();
    packed_jobs(&mut jobs, ["spectral", "spectral table"], &tables.images, storage, [xi, eta]);
    let power = tables.lobe.as_ref().map(power_image);
    if let (Some(lobe), Some(power)) = (&tables.lobe, &power) {
        jobs.push(ImageJob {
            file: "spectral_lobe.exr".into(),
            kind: "spectral lobe",
            order: 0,
            values: power,
            storage: Storage::Float,
            axes: vec![("half_abs_w", power_axis(lobe))],
            place: None,
        });
        if let Some(cross) = &lobe.cross {
            let axes = cross_axes(cross, tables.shortest_nm);
            packed_jobs(&mut jobs, ["spectral_cross", "spectral cross"], &cross.images, storage, axes);
        }
    }
    let of_set = json!({
        "basis": "chebyshev", "shortest_nm": tables.shortest_nm, "prefilter_width": tables.prefilter_width,
        "usable_radius": tables.usable_radius, "channels": "three tables in 1/sr",
    });
    let mut stored: Vec<StoredArray> = parallel::map(&jobs, |job| job.write(folder, &of_set))?;
    let mut of_lobe = stored.split_off(tables.images.len());
    let lobe = tables.lobe.as_ref().map(|lobe| {
        let images = of_lobe.split_off(1);
        StoredSpectralLobe {
            sigma_nm: lobe.sigma_nm,
            is_of_source: lobe.is_of_source,
            half_abs_w: power_axis(lobe),
            power: of_lobe.remove(0),
            cross: lobe.cross.as_ref().map(|cross| {
                let [xi_per_nm, eta_per_nm] = cross_axes(cross, tables.shortest_nm);
                StoredSpectralCross { patches: cross.count, xi_per_nm, eta_per_nm, images }
            }),
        }
    });
    let is_of_source = tables.lobe.as_ref().is_some_and(|lobe| lobe.is_of_source);
    Ok(StoredSpectral {
        formula: if is_of_source { SOURCE_FORMULA } else { FORMULA }.into(),
        shortest_nm: tables.shortest_nm,
        longest_nm: tables.longest_nm,
        storage,
        rounding: None,
        xi_per_nm: xi,
        eta_per_nm: eta,
        prefilter_width: tables.prefilter_width,
        usable_radius: tables.usable_radius,
        sigma_nm: tables.sigma_nm,
        half_height_range_nm: tables.half_height_range_nm,
        dispersion: tables.dispersion.clone(),
        tables: tables.count,
        images: stored,
        lobe,
        check_values: Vec::new(),
    })
}

/// Columns and rows of a square in spatial frequency that reaches so far either way, in 1/nm.
fn axes(reach_per_nm: f64, samples: usize) -> [Axis; 2] {
    let columns = Axis { first: -reach_per_nm, last: reach_per_nm, samples };
    [columns, columns.reversed()]
}

fn cross_axes(cross: &SpectralCross, shortest_nm: f64) -> [Axis; 2] {
    axes(cross.radius_max / shortest_nm, cross.images.first().map_or(0, |image| image.dim().0))
}

fn power_axis(lobe: &SpectralLobe) -> Axis {
    Axis { first: 0.0, last: 1.0, samples: lobe.power.len() }
}

/// One row of three equal channels.
fn power_image(lobe: &SpectralLobe) -> Array3<f32> {
    Array3::from_shape_fn((1, lobe.power.len(), 3), |(_, column, _)| lobe.power[column])
}

fn packed_jobs<'a>(
    jobs: &mut Vec<ImageJob<'a>>,
    [name, kind]: [&'static str; 2],
    images: &'a [Array3<f32>],
    storage: Storage,
    [xi, eta]: [Axis; 2],
) {
    jobs.extend(images.iter().enumerate().map(|(index, values)| ImageJob {
        file: format!("{name}.{index:03}.exr"),
        kind,
        order: TABLES_PER_IMAGE * index,
        values,
        storage,
        axes: vec![("xi_per_nm", xi), ("eta_per_nm", eta)],
        place: None,
    }));
}

/// Reads what [`write_spectral`] wrote; `front_factor` is that of their material.
///
/// # Errors
/// Files that are missing or damaged, and shapes that do not fit: what is returned can be evaluated everywhere.
pub fn read_spectral(folder: &Path, stored: &StoredSpectral, front_factor: FrontFactor) -> Result<SpectralTables> {
    let read_all = |arrays: &[StoredArray], [xi, eta]: [Axis; 2]| {
        parallel::map(arrays, |array| read_array(folder, array, (eta.samples, xi.samples)))
    };
    let lobe = match &stored.lobe {
        None => None,
        Some(lobe) => Some(SpectralLobe {
            power: read_array(folder, &lobe.power, (1, lobe.half_abs_w.samples))?.iter().step_by(3).copied().collect(),
            sigma_nm: lobe.sigma_nm,
            is_of_source: lobe.is_of_source,
            cross: match &lobe.cross {
                None => None,
                Some(cross) => Some(SpectralCross {
                    count: cross.patches,
                    images: read_all(&cross.images, [cross.xi_per_nm, cross.eta_per_nm])?,
                    radius_max: cross.xi_per_nm.last * stored.shortest_nm,
                }),
            },
        }),
    };
    let tables = SpectralTables {
        shortest_nm: stored.shortest_nm,
        longest_nm: stored.longest_nm,
        count: stored.tables,
        images: read_all(&stored.images, [stored.xi_per_nm, stored.eta_per_nm])?,
        lobe,
        prefilter_width: stored.prefilter_width,
        front_factor,
        usable_radius: stored.usable_radius,
        sigma_nm: stored.sigma_nm,
        half_height_range_nm: stored.half_height_range_nm,
        dispersion: stored.dispersion.clone(),
    };
    let bad = |what: String| Error::bad_file(&folder.join("specimen.json"), what, FIX);
    tables.check().map_err(|what| bad(format!("it describes tables that cannot be evaluated: {what}")))?;
    let [xi, eta] = axes(2.0 / stored.shortest_nm, tables.size());
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
    for ((name, said), due) in [("xi", stored.xi_per_nm), ("eta", stored.eta_per_nm)].into_iter().zip([xi, eta]) {
        if !(near(said.first, due.first) && near(said.last, due.last)) {
            let (first, last) = (said.first, said.last);
            return Err(bad(format!("its axis {name} runs from {first} to {last}, not {} to {}", due.first, due.last)));
        }
    }
    Ok(tables)
}
