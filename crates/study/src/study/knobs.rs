//! The share of each knob in the error: one is changed, the others stay at their finest.

use super::batch::{Pair, stored};
use super::config::StudyConfig;
use super::methods::Context;
use super::rows::KnobRow;
use super::sample::luminances;
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{OpticsConfig, Windows};
use diffraction_build::optics::spectral::brdf_xyz_batch;
use diffraction_build::optics::window::FADE_SIGMAS;
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Storage, TableSet, TablesConfig};
use diffraction_build::tables::plan::plan;
use ndarray::Array2;

/// Windows along each axis whose mean is compared; the last that fits is what the others are held against.
const WINDOWS: [usize; 5] = [1, 2, 3, 5, 7];

/// Significant bits of numbers; halves have 11, floats 24.
const SIGNIFICANDS: [i32; 5] = [5, 8, 11, 14, 17];

/// Steps of progress.
pub fn count(config: &StudyConfig) -> u64 {
    (2 + config.chebyshev.len() + config.wavelength_steps_nm.len() + config.sizes.len()) as u64
}

/// All knobs. The grid is judged against the direct sum, every other knob against the finest tables, so that
/// the grid's own error cancels.
pub fn rows(context: &Context) -> Result<Vec<KnobRow>> {
    let base = context.tables_config(Basis::Chebyshev);
    let finest = built(context, &base)?;
    let fine = values(context, &finest, Interpolation::Cubic);
    let mut rows = Vec::new();
    let mut push = |knob: &str, value: f64, setting: String, reference: &[f64], found: &[f64]| {
        rows.push(KnobRow { knob: knob.into(), value, setting, quantiles: context.sample.deviation(reference, found) });
    };
    for &count in &context.config.chebyshev {
        let set = built(context, &TablesConfig { count: Some(count), ..base.clone() })?;
        push("basis", count as f64, format!("{count} tables"), &fine, &values(context, &set, Interpolation::Cubic));
    }
    for &step in &context.config.wavelength_steps_nm {
        let set = built(context, &TablesConfig { wavelength_step_nm: Some(step), ..base.clone() })?;
        push("wavelength step", step, format!("{step} nm"), &fine, &values(context, &set, Interpolation::Cubic));
    }
    let exact = &context.sample.hemisphere().luminance;
    for &size in &context.config.sizes {
        let set = built(context, &TablesConfig { size: Some(size), ..base.clone() })?;
        for (knob, look_up) in [("grid, bilinear", Interpolation::Bilinear), ("grid, cubic", Interpolation::Cubic)] {
            push(knob, size as f64, format!("{size} texels"), exact, &values(context, &set, look_up));
        }
    }
    for bits in SIGNIFICANDS {
        let rounded = values(context, &with_significand(&finest, bits), Interpolation::Cubic);
        push("storage", f64::from(bits), format!("{bits} bits"), &fine, &rounded);
    }
    let half = values(context, &stored(&finest, Storage::Half), Interpolation::Cubic);
    push("storage, half", 11.0, "half".into(), &fine, &half);
    let mut means = windows(context, &context.sample.hemisphere().pairs)?;
    if let Some((_, most)) = means.pop() {
        for (count, mean) in means {
            push("windows", count as f64, format!("mean of {count}"), &most, &mean);
        }
    }
    context.progress.advance(1);
    Ok(rows)
}

fn built(context: &Context, config: &TablesConfig) -> Result<TableSet> {
    let set = build(&BuildInput::new(context.fields, context.optics, config), &|_| ())?.0;
    context.progress.advance(1);
    Ok(set)
}

/// Y of tables in the hemisphere's directions.
fn values(context: &Context, set: &TableSet, interpolation: Interpolation) -> Vec<f64> {
    let batch = |pairs: &[Pair], out: &mut [Xyz]| {
        pairs.iter().zip(out).for_each(|(&(wi, wo), xyz)| *xyz = brdf_xyz(set, interpolation, wi, wo));
    };
    luminances(&batch, &context.sample.hemisphere().pairs)
}

/// A set whose tables are rounded to so many significant bits, the exponent left free.
fn with_significand(set: &TableSet, bits: i32) -> TableSet {
    let mut set = set.clone();
    let round = |value: f32| {
        if value == 0.0 {
            return value;
        }
        let unit = 2f64.powi(f64::from(value).abs().log2().floor() as i32 + 1 - bits);
        ((f64::from(value) / unit).round() * unit) as f32
    };
    let cross = set.lobe.iter_mut().flat_map(|lobe| &mut lobe.cross);
    set.tables.iter_mut().chain(cross).for_each(|table| table.mapv_inplace(round));
    set
}

/// Y averaged over ever more windows two σ apart in the middle of the scans, straight from the transforms; with their
/// number, up to the most that fit.
fn windows(context: &Context, pairs: &[Pair]) -> Result<Vec<(usize, Vec<f64>)>> {
    let sigma_nm = context.optics.sigma_nm;
    let extents = context.fields.iter().flat_map(HeightField::extent_nm);
    let smallest = extents.fold(f64::MAX, f64::min);
    let optics = OpticsConfig { windows: Windows::Grid, ..context.optics.clone() };
    // Speckle is as large as the signal: a coarse tolerance measures it.
    let coarse = TablesConfig { tolerance: 1e-2, ..context.tables_config(Basis::Chebyshev) };
    let mut means = Vec::new();
    for count in WINDOWS.into_iter().filter(|&count| side_nm(count, sigma_nm) < smallest) {
        let patches: Vec<HeightField> = context.fields.iter().map(|f| patch(f, side_nm(count, sigma_nm))).collect();
        let spectra = plan(&BuildInput::new(&patches, &optics, &coarse))?.spectra;
        let xyz = brdf_xyz_batch(&patches, &optics, &spectra, pairs)?;
        means.push((count * count, xyz.iter().map(|xyz| xyz[1]).collect()));
    }
    Ok(means)
}

/// Side of a square that holds `count` windows two σ apart along each axis, and no more.
fn side_nm(count: usize, sigma_nm: f64) -> f64 {
    (2.0 * FADE_SIGMAS + 2.0 * (count - 1) as f64) * sigma_nm
}

/// The middle of a scan, at least `side_nm` wide.
fn patch(field: &HeightField, side_nm: f64) -> HeightField {
    let [columns, rows] = [0, 1].map(|axis| {
        let count = field.size()[axis];
        let wanted = (side_nm / field.pitch_nm[axis]).ceil() as usize + 1;
        // The same parity keeps the middle of the patch on the middle of the scan.
        let kept = (wanted + (count - wanted.min(count)) % 2).min(count);
        let first = (count - kept) / 2;
        first..first + kept
    });
    let heights_nm = Array2::from_shape_fn((rows.len(), columns.len()), |(row, column)| {
        field.heights_nm[[rows.start + row, columns.start + column]]
    });
    HeightField { heights_nm, pitch_nm: field.pitch_nm }
}
