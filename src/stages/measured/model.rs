//! The model as an instrument sees it: the BRDF from spectral tables or the scan, averaged over the detector's cone and slit.

use std::f64::consts::{PI, SQRT_2, TAU};

use rayon::prelude::*;

use super::measurement::Measurement;
use diffraction_brdf::SpectralTables;
use diffraction_brdf::direction::{Vec3, from_angles_deg, wave_vector_change};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::evaluate::Interpolation;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::factors::PairFactors;
use diffraction_build::optics::lines::Buffers;
use diffraction_build::optics::spectra::{self, Spectra, SpectraConfig};
use diffraction_build::optics::spectral::brdf_of_window;
use diffraction_build::optics::window::placements;
use diffraction_render::scene::light::{direction_to, sunflower};
use diffraction_render::scene::model::Light;

/// Amplitude error of the interpolation in the phase scale, relative to the window's whole: weak orders keep their
/// digits.
const NODE_TOLERANCE: f64 = 1e-7;

/// Fewest and most directions of a cone.
const DIRECTIONS: [usize; 2] = [64, 1024];

/// Fewest and most wavelengths of a slit.
const WAVELENGTHS: [usize; 2] = [16, 64];

/// Most values of the BRDF for one specimen: about a minute on one thread.
const EVALUATIONS_MAX: usize = 1 << 26;

/// What the model says to each row of a measurement.
#[derive(Debug, Clone, PartialEq)]
pub struct Modelled {
    /// `⟨f cos_theta⟩` in 1/sr over cone and slit.
    pub scatter_per_sr: Vec<f64>,
    /// `⟨cos_theta⟩` over the cone, above the horizon.
    pub mean_cosine: Vec<f64>,
    /// Solid angle of the cone in sr.
    pub cone_sr: f64,
    /// Directions and wavelengths averaged in the row that has most.
    pub samples: [usize; 2],
    /// What a reader of the figures must know.
    pub notes: Vec<String>,
}

/// Directions and wavelengths that stand for cone and slit in one row.
struct RowSamples {
    wi: Vec3,
    wo: Vec<Vec3>,
    wavelengths_nm: Vec<f64>,
    wanted: [usize; 2],
}

/// The model at every row: from spectral tables by splines, or from the scan where there are none, or none that answer.
///
/// # Errors
/// As the transforms, a wavelength at which the material is not known, and [`Error::Limit`] for too many evaluations.
pub fn modelled(
    fields: &[HeightField],
    optics: &OpticsConfig,
    tables: Option<&SpectralTables>,
    measurement: &Measurement,
    memory_bytes: u64,
) -> Result<Modelled> {
    let config = &measurement.config;
    let rows: Vec<RowSamples> = (0..measurement.wavelength_nm.len())
        .map(|row| {
            let place = (measurement.angles_deg[row], measurement.wavelength_nm[row]);
            row_samples(place, config.acceptance_deg, config.bandwidth_nm, optics.body_coherence().sigma_nm_at(place.1))
        })
        .collect();
    for row in &rows {
        optics.check_material_at(&row.wavelengths_nm)?;
    }
    let unfit = tables.and_then(|tables| unfit(tables, &rows));
    let scatter_per_sr = match tables.filter(|_| unfit.is_none()) {
        Some(tables) => {
            check_evaluations(&rows, 1)?;
            rows.par_iter().map(|row| scatter_of_tables(tables, row)).collect()
        }
        None => scatter_of_scan(fields, optics, &rows, memory_bytes)?,
    };
    let mean_cosine =
        rows.iter().map(|row| row.wo.iter().map(|wo| wo[2].max(0.0)).sum::<f64>() / row.wo.len() as f64).collect();
    let most = |of: fn(&RowSamples) -> usize| rows.iter().map(of).max().unwrap_or(1);
    Ok(Modelled {
        scatter_per_sr,
        mean_cosine,
        cone_sr: TAU * 2.0 * (0.25 * config.acceptance_deg.to_radians()).sin().powi(2),
        samples: [most(|row| row.wo.len()), most(|row| row.wavelengths_nm.len())],
        notes: unfit.into_iter().chain(notes(&rows, fields)).collect(),
    })
}

/// Why spectral tables do not answer for single directions at the wavelengths of rows, as a note; `None` where they do.
fn unfit(tables: &SpectralTables, rows: &[RowSamples]) -> Option<String> {
    let why = match rows.iter().find_map(|row| tables.check_wavelengths(&row.wavelengths_nm).err()) {
        Some(error) => error.to_string(),
        None if tables.prefilter_width > 0.0 => {
            "the spectral tables hold means over texels that are wider than a coherence lobe".to_owned()
        }
        None => return None,
    };
    Some(format!("the model is evaluated from the scan: {why}"))
}

/// `⟨f cos_theta⟩` by spectral tables.
fn scatter_of_tables(tables: &SpectralTables, row: &RowSamples) -> f64 {
    let above = row.wo.iter().filter(|wo| wo[2] > 0.0);
    let of = |wo: &Vec3| {
        let brdf = tables.eval(Interpolation::Spline, row.wi, *wo, &row.wavelengths_nm);
        wo[2] * brdf.iter().sum::<f64>()
    };
    above.map(of).sum::<f64>() / (row.wo.len() * row.wavelengths_nm.len()) as f64
}

/// The same of every row by the transforms of the scans, averaged over their windows.
fn scatter_of_scan(
    fields: &[HeightField],
    optics: &OpticsConfig,
    rows: &[RowSamples],
    memory_bytes: u64,
) -> Result<Vec<f64>> {
    let mut windows = Vec::new();
    for (scan, field) in fields.iter().enumerate() {
        windows.extend(placements(field, optics)?.into_iter().map(|placement| (scan, placement)));
    }
    check_evaluations(rows, windows.len())?;
    let spectra_config = spectra_config(rows, optics, memory_bytes);
    let share = 1.0 / windows.len().max(1) as f64;
    let mut scatter_per_sr = vec![0.0; rows.len()];
    for (scan, placement) in windows {
        let spectra = spectra::transform(&fields[scan], placement, optics, &spectra_config)?;
        scatter_per_sr.par_iter_mut().zip(rows).for_each(|(sum, row)| *sum += share * scatter(&spectra, optics, row));
    }
    Ok(scatter_per_sr)
}

/// `⟨f cos_theta⟩` of one window: f vanishes for directions below the horizon.
fn scatter(spectra: &Spectra, optics: &OpticsConfig, row: &RowSamples) -> f64 {
    let mut buffers = Buffers::default();
    let mut sum = 0.0;
    for &wo in &row.wo {
        let Some(factors) = PairFactors::of(optics, row.wi, wo) else { continue };
        brdf_of_window(spectra, &factors, &row.wavelengths_nm, &mut buffers, |_, brdf| sum += brdf * wo[2]);
    }
    sum / (row.wo.len() * row.wavelengths_nm.len()) as f64
}

/// The samples of one row: directions evenly over the cone, half a lobe apart; wavelengths at equal
/// shares of a triangle, half as far apart as a lobe takes to pass.
fn row_samples((angles_deg, nm): ([f64; 4], f64), acceptance_deg: f64, bandwidth_nm: f64, sigma_nm: f64) -> RowSamples {
    let [theta_i, phi_i, theta_r, phi_r] = angles_deg;
    let (wi, axis) = (from_angles_deg(theta_i, phi_i), from_angles_deg(theta_r, phi_r));
    let q = wave_vector_change(wi, axis);
    let lobe = nm / (2.0 * SQRT_2 * PI * sigma_nm);
    let wanted_directions = if acceptance_deg > 0.0 {
        let radius = (0.5 * acceptance_deg).to_radians();
        (4.0 * PI * (radius / lobe).powi(2)).ceil() as usize
    } else {
        1
    };
    let wanted_wavelengths = if bandwidth_nm > 0.0 {
        // The triangle spans twice its width at half maximum.
        (4.0 * bandwidth_nm * q[0].hypot(q[1]) / (lobe * nm)).ceil() as usize
    } else {
        1
    };
    let within = |wanted: usize, [low, high]: [usize; 2], used: bool| if used { wanted.clamp(low, high) } else { 1 };
    let directions = within(wanted_directions, DIRECTIONS, acceptance_deg > 0.0);
    let wavelengths = within(wanted_wavelengths, WAVELENGTHS, bandwidth_nm > 0.0);
    let cone = Light { direction: axis, angular_diameter_deg: acceptance_deg, irradiance: 1.0 };
    RowSamples {
        wi,
        wo: match directions {
            1 => vec![axis],
            count => cone_points(count).map(|point| direction_to(&cone, point)).collect(),
        },
        wavelengths_nm: (0..wavelengths)
            .map(|index| nm + bandwidth_nm * triangle_quantile((index as f64 + 0.5) / wavelengths as f64))
            .collect(),
        wanted: [wanted_directions, wanted_wavelengths],
    }
}

/// An even number of points on a disc, radius squared and angle: a sunflower and its mirror image, so that
/// their centroid is the centre and a lobe's flank is averaged without bias.
fn cone_points(count: usize) -> impl Iterator<Item = [f64; 2]> {
    let half = count.div_ceil(2).max(2);
    (0..half)
        .map(move |index| sunflower(index, half))
        .flat_map(|[radius, angle]| [[radius, angle], [radius, angle + PI]])
}

/// Where a triangle over [-1, 1] has a share of its area to the left.
fn triangle_quantile(share: f64) -> f64 {
    if share < 0.5 { (2.0 * share).sqrt() - 1.0 } else { 1.0 - (2.0 * (1.0 - share)).sqrt() }
}

/// Transforms that hold every sample.
fn spectra_config(rows: &[RowSamples], optics: &OpticsConfig, memory_bytes: u64) -> SpectraConfig {
    let asked = rows.iter().flat_map(|row| {
        let shortest_nm = row.wavelengths_nm.iter().copied().fold(f64::MAX, f64::min);
        row.wo.iter().map(move |&wo| (wave_vector_change(row.wi, wo), shortest_nm))
    });
    SpectraConfig::holding(optics, asked, NODE_TOLERANCE, memory_bytes)
}

fn check_evaluations(rows: &[RowSamples], windows: usize) -> Result<()> {
    let per_window: usize = rows.iter().map(|row| row.wo.len() * row.wavelengths_nm.len()).sum();
    let needed = per_window.saturating_mul(windows);
    if needed <= EVALUATIONS_MAX {
        return Ok(());
    }
    Err(Error::limit(
        format!("comparing with `measured` takes {needed} values of the BRDF, more than {EVALUATIONS_MAX}"),
        "thin out the rows of the file, or lower `acceptance_deg` or `bandwidth_nm` of `measured`",
    ))
}

fn notes(rows: &[RowSamples], fields: &[HeightField]) -> Vec<String> {
    let mut notes = Vec::new();
    let beyond = |row: &&RowSamples| {
        let q = wave_vector_change(row.wi, row.wo[0]);
        let nm = row.wavelengths_nm[0];
        fields.iter().any(|field| (0..2).any(|axis| q[axis].abs() / nm * field.pitch_nm[axis] > 0.5))
    };
    let count = rows.iter().filter(beyond).count();
    if count > 0 {
        notes.push(format!(
            "{count} of {} rows lie beyond what the scan's sampling answers for: the model is 0 there",
            rows.len()
        ));
    }
    let coarse = |axis: usize, most: usize| rows.iter().any(|row| row.wanted[axis] > most);
    if coarse(0, DIRECTIONS[1]) {
        notes.push(format!(
            "the cone is many coherence lobes wide: its {} directions are further apart than half a lobe, and the \
             mean over it is uncertain by what falls between them",
            DIRECTIONS[1]
        ));
    }
    if coarse(1, WAVELENGTHS[1]) {
        notes.push(format!(
            "the slit passes many coherence lobes: its {} wavelengths do not resolve them all",
            WAVELENGTHS[1]
        ));
    }
    notes
}
