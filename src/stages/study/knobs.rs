//! The share of each knob in the error: one is changed, the others stay at their finest.

use super::methods::{Context, stored};
use super::sample::{deviation, luminances};
use super::{KnobRow, StudyConfig};
use crate::ground::error::Result;
use crate::height::HeightField;
use crate::optics::config::{OpticsConfig, Windows};
use crate::optics::window::FADE_SIGMAS;
use crate::tables::build::build;
use crate::tables::evaluate::{Interpolation, brdf_xyz};
use crate::tables::model::{Basis, Storage, TableSet, TablesConfig};
use ndarray::Array2;

/// Steps of progress.
pub fn count(config: &StudyConfig) -> u64 {
    (2 + config.chebyshev.len() + config.wavelength_steps_nm.len() + config.sizes.len()) as u64
}

/// All knobs. The grid is judged against the direct sum, every other knob against the finest tables, so that
/// the grid's own error cancels.
pub fn rows(context: &Context) -> Result<Vec<KnobRow>> {
    let base = context.tables_config(Basis::Chebyshev);
    let made = |config: &TablesConfig, optics: &OpticsConfig| -> Result<TableSet> {
        let set = build(context.fields, optics, config, &|_| ())?.0;
        context.progress.advance(1);
        Ok(set)
    };
    let directions = context.sample.hemisphere();
    let values = |set: &TableSet, interpolation: Interpolation| {
        luminances(&directions.pairs, &|wi, wo| Ok(brdf_xyz(set, interpolation, wi, wo)))
    };
    let finest = made(&base, context.optics)?;
    let fine = values(&finest, Interpolation::Cubic)?;
    let mut rows = Vec::new();
    let mut push = |knob: &str, value: f64, setting: String, reference: &[f64], found: &[f64]| {
        rows.push(KnobRow { knob: knob.into(), value, setting, quantiles: deviation(reference, found) });
    };
    for &count in &context.config.chebyshev {
        let set = made(&TablesConfig { count: Some(count), ..base.clone() }, context.optics)?;
        push("basis", count as f64, format!("{count} tables"), &fine, &values(&set, Interpolation::Cubic)?);
    }
    for &step in &context.config.wavelength_steps_nm {
        let set = made(&TablesConfig { wavelength_step_nm: Some(step), ..base.clone() }, context.optics)?;
        push("wavelength step", step, format!("{step} nm"), &fine, &values(&set, Interpolation::Cubic)?);
    }
    for &size in &context.config.sizes {
        let set = made(&TablesConfig { size: Some(size), ..base.clone() }, context.optics)?;
        for (knob, interpolation) in
            [("grid, bilinear", Interpolation::Bilinear), ("grid, cubic", Interpolation::Cubic)]
        {
            push(knob, size as f64, format!("{size} texels"), &directions.luminance, &values(&set, interpolation)?);
        }
    }
    for (storage, name) in [(Storage::Half, "half"), (Storage::Float, "float")] {
        let found = values(&stored(&finest, storage), Interpolation::Cubic)?;
        push("storage", 0.0, name.into(), &fine, &found);
    }
    let patches: Vec<HeightField> = context.fields.iter().map(|f| patch(f, context.optics.sigma_nm)).collect();
    let several = OpticsConfig { windows: Windows::Grid, ..context.optics.clone() };
    // Speckle is as large as the signal: a coarse tolerance measures it in a fraction of the time.
    let coarse = TablesConfig { tolerance: 1e-2, ..base };
    let averaged = build(&patches, &several, &coarse, &|_| ())?.0;
    context.progress.advance(1);
    let setting = "mean of nine neighbouring windows against the middle one".into();
    push("windows", 0.0, setting, &fine, &values(&averaged, Interpolation::Cubic)?);
    Ok(rows)
}

/// The middle of a scan, wide enough for three by three windows two σ apart.
fn patch(field: &HeightField, sigma_nm: f64) -> HeightField {
    let [columns, rows] = [0, 1].map(|axis| {
        let count = field.size()[axis];
        let wanted = ((2.0 * FADE_SIGMAS + 4.0) * sigma_nm / field.pitch_nm[axis]).ceil() as usize + 1;
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
