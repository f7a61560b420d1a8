//! The published method: tables of the powers of `w` (Dhillon et al. 2014, eq. 8), for comparison.
//!
//! `|P|² = Σ_p (k |w|)^p Σ_{n+m=p} Re(F_n F*_m)` with `F_n` the transform of `g (-i h)^n / n!`, so
//! `table_p = ∫ S x̄ k^p Σ Re(F_n F*_m) / (λ² A) dλ`. The terms grow like `exp(k |w| |h - h'|)` before
//! they cancel down to the result: the height of a relief that the method takes is limited by the digits of the storage.

use std::f64::consts::TAU;

use ndarray::Array3;
use rayon::prelude::*;

use super::accumulate::{Targets, span};
use super::input::BuildInput;
use super::model::{Advance, Basis, BuildRecord, Storage, TableSet, TablesConfig};
use super::plan::BuildPlan;
use super::rings::Ring;
use super::texels::inner_columns;
use crate::height::HeightField;
use crate::optics::kernel::Kernel;
use crate::optics::powers::{HeightPowers, PowersConfig, square_series, transform_powers};
use diffraction_brdf::error::{Error, Result};

/// Most terms: 1/n! still is a normal number.
pub const TERMS_MAX: usize = 160;

/// Share of the tolerance that the remainder of the series may take.
const REMAINDER_SHARE: f64 = 0.1;

/// Rounding error, relative to the result, from which on the tables are worthless.
pub const CATASTROPHE: f64 = 0.1;

/// Steps of the histogram of height differences over their whole range.
const BINS: usize = 512;

/// What the series needs and loses on a surface.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SeriesForecast {
    /// Tables for the tolerance.
    pub terms: usize,
    /// Decimal digits that cancel: log10 of the sum of the terms' magnitudes over the result.
    pub digits_lost: f64,
}

impl SeriesForecast {
    /// Relative error that rounding each term causes: unit roundoff times the cancellation.
    pub fn rounding(&self, storage: Storage) -> f64 {
        unit_roundoff(storage) * 10f64.powf(self.digits_lost)
    }
}

/// Largest relative error of rounding to the nearest stored number.
pub fn unit_roundoff(storage: Storage) -> f64 {
    match storage {
        Storage::Half => 2f64.powi(-11),
        Storage::Float => 2f64.powi(-24),
    }
}

/// Forecasts terms and loss at `s_max` (1/nm).
///
/// `|P|² = ∬ g g' exp(-i s (h - h') + ..)`: with `T` terms the remainder is at most `(∬g)² ⟨(s |h - h'|)^T⟩ / T!`.
///
/// What cancels is counted over all lines of the spectrum, where the deep parts of a surface scatter: `|P(s)|²` of a line
/// is a power series in `s` whose terms, all taken alike, add to what it is at the imaginary `s = ix`, the product of the
/// line's transforms of `exp(x h)` and `exp(-x h)`. By Parseval's theorem and Schwarz's inequality these add over all lines
/// to at most `(⟨exp(2xh)⟩ ⟨exp(-2xh)⟩)^½ = ⟨cosh 2x(h - h')⟩^½`, while the lines' own powers add to one. The mirror
/// direction alone would give `⟨exp(x |h - h'|)⟩`, a hundred times less from a micrometre on: there terms are much larger
/// than their average, but so is the light.
///
/// Averages are taken over all pairs of samples of a scan, from a histogram whose differences are rounded up.
pub fn forecast(fields: &[HeightField], s_max: f64, tolerance: f64) -> SeriesForecast {
    let spreads: Vec<_> = fields.iter().map(height_differences).collect();
    let log_mean = |log_of: &dyn Fn(f64) -> f64| -> f64 {
        spreads.iter().map(|spread| log_mean_exp(spread, log_of)).fold(f64::MIN, f64::max)
    };
    let remainder = |terms: usize| log_mean(&|d| terms as f64 * (s_max * d).ln() - libm::lgamma(terms as f64 + 1.0));
    let allowed = (REMAINDER_SHARE * tolerance).ln();
    let deepest = spreads.iter().flatten().map(|&(d, _)| s_max * d).fold(0.0, f64::max);
    // From e times the largest argument on the terms fall by at least e each: search downwards from where
    // none can matter, because dust makes the remainder rise again after a first dip.
    let far = (deepest * std::f64::consts::E - allowed).ceil().min(1e5) as usize + 2;
    let terms = (1..far).rev().find(|&terms| remainder(terms) > allowed).map_or(1, |last| last + 1);
    // ln cosh x without overflow.
    let log_cosh = |x: f64| x + (-2.0 * x).exp().ln_1p() - std::f64::consts::LN_2;
    SeriesForecast { terms, digits_lost: 0.5 * log_mean(&|d| log_cosh(2.0 * s_max * d)) / std::f64::consts::LN_10 }
}

/// `ln Σ p exp(log_of(d))` without overflow.
fn log_mean_exp(spread: &[(f64, f64)], log_of: &dyn Fn(f64) -> f64) -> f64 {
    let logs: Vec<f64> = spread.iter().map(|&(d, share)| share.ln() + log_of(d)).collect();
    let largest = logs.iter().copied().fold(f64::MIN, f64::max);
    largest + logs.iter().map(|log| (log - largest).exp()).sum::<f64>().ln()
}

/// Differences `|h - h'|` in nm over all pairs of samples with their shares, differences rounded up.
fn height_differences(field: &HeightField) -> Vec<(f64, f64)> {
    let (low, high) = field.heights_nm.iter().fold((f64::MAX, f64::MIN), |(low, high), &h| (low.min(h), high.max(h)));
    let width = (high - low) / BINS as f64;
    if width <= 0.0 {
        return vec![(0.0, 1.0)];
    }
    let mut histogram = [0.0; BINS];
    for h in &field.heights_nm {
        histogram[(((h - low) / width) as usize).min(BINS - 1)] += 1.0 / field.heights_nm.len() as f64;
    }
    let pairs = |lag: usize| -> f64 { (lag..BINS).map(|i| histogram[i] * histogram[i - lag]).sum() };
    (0..BINS)
        .map(|lag| ((lag + 1) as f64 * width, pairs(lag) * if lag == 0 { 1.0 } else { 2.0 }))
        .filter(|&(_, share)| share > 0.0)
        .collect()
}

/// Builds the published method's tables, for every direction; they contain the coherent lobe.
///
/// # Errors
/// `Error::Limit` where the terms would cancel catastrophically in the wanted storage, and transforms or sums beyond the
/// allowed memory; `Error::Call` for a plan restricted to some directions.
pub(crate) fn build_taylor(input: &BuildInput, plan: &BuildPlan, advance: Advance) -> Result<(TableSet, BuildRecord)> {
    if plan.coverage.is_some() {
        return Err(Error::Call("the published method's tables are for every direction".into()));
    }
    let BuildInput { fields, optics, tables: config, .. } = *input;
    let forecast = forecast(fields, plan.spectra.phase_scale_per_nm[1], config.tolerance);
    refuse_catastrophe(&forecast, config.storage.unwrap_or(Storage::Float))?;
    let terms = config.count.unwrap_or(forecast.terms).max(1);
    check_limits(plan, terms, config)?;
    let powers = PowersConfig {
        orders: terms,
        scale_nm: if plan.half_height_range_nm > 0.0 { plan.half_height_range_nm } else { 1.0 },
        frequency: plan.spectra.frequency,
        memory_bytes: plan.spectra.memory_bytes,
    };
    let mut sums = vec![0.0; plan.texels.grid.size * plan.texels.grid.size * 3 * terms];
    let share = 1.0 / plan.windows.len() as f64;
    for &(scan, placement) in &plan.windows {
        let series = transform_powers(&fields[scan], placement, optics.sigma_nm, &powers)?;
        for ring in &plan.rings {
            for (&nm, weight) in ring.quadrature.wavelengths_nm.iter().zip(&ring.quadrature.weights) {
                let x = TAU / nm * powers.scale_nm;
                let factors: Vec<f64> = (0..terms).map(|p| share * x.powi(p as i32) / (nm * nm)).collect();
                Wave::new(&series, plan, ring, terms, nm).add(&factors, *weight, &mut sums);
            }
            advance(ring.wavelengths() as u64);
        }
    }
    let record = BuildRecord { transforms: terms, ..plan.record() };
    let size = plan.texels.grid.size;
    let table = |p: usize| {
        Array3::from_shape_fn((size, size, 3), |(row, column, channel)| {
            sums[((row * size + column) * 3 + channel) * terms + p] as f32
        })
    };
    let set = TableSet {
        basis: Basis::Taylor,
        tables: (0..terms).map(table).collect(),
        lobe: None,
        prefilter_width: plan.filter.width,
        front_factor: optics.front_factor(),
        restriction: None,
        usable_radius: input.usable_radius(),
    };
    Ok((set, record))
}

fn refuse_catastrophe(forecast: &SeriesForecast, storage: Storage) -> Result<()> {
    if forecast.rounding(storage) <= CATASTROPHE {
        return Ok(());
    }
    let name = if storage == Storage::Half { "half" } else { "float" };
    let instead = if storage == Storage::Half && forecast.rounding(Storage::Float) <= CATASTROPHE {
        "use tables.storage = \"float\", or tables.basis = \"chebyshev\""
    } else {
        "use tables.basis = \"chebyshev\", or clip outliers if they set the range of heights"
    };
    Err(Error::limit(
        format!(
            "the published method would need {} tables here, whose terms grow to 1e{:.1} times their sum: \
             {:.1} digits cancel and storage = \"{name}\" has {:.1}",
            forecast.terms,
            forecast.digits_lost,
            forecast.digits_lost,
            -unit_roundoff(storage).log10()
        ),
        instead,
    ))
}

fn check_limits(plan: &BuildPlan, terms: usize, config: &TablesConfig) -> Result<()> {
    if terms > TERMS_MAX {
        return Err(Error::limit(
            format!("the published method would need {terms} tables, more than its {TERMS_MAX}"),
            "use tables.basis = \"chebyshev\", or set tables.count lower",
        ));
    }
    let bytes = (plan.texels.grid.size * plan.texels.grid.size * 3 * terms * size_of::<f64>()) as u64;
    if bytes > plan.spectra.memory_bytes {
        return Err(Error::limit(
            format!(
                "sums of {terms} tables over {} x {} texels need {} MiB, {} MiB are allowed",
                plan.texels.grid.size,
                plan.texels.grid.size,
                bytes >> 20,
                config.memory_mib
            ),
            "lower tables.size or tables.count, or raise tables.memory_mib",
        ));
    }
    Ok(())
}

/// One wavelength on one ring: lines interpolated along ξ, then along η, squared and added.
struct Wave<'a> {
    series: &'a HeightPowers,
    plan: &'a BuildPlan,
    ring: &'a Ring,
    terms: usize,
    /// First to last column (and row) of the ring.
    columns: std::ops::Range<usize>,
    targets: Targets,
    /// `[η line][target][value]` after the interpolation along ξ, and the first line's index.
    rows: Vec<f64>,
    first_row: i32,
}

impl<'a> Wave<'a> {
    fn new(series: &'a HeightPowers, plan: &'a BuildPlan, ring: &'a Ring, terms: usize, wavelength_nm: f64) -> Self {
        let columns = plan.texels.grid.columns_within(ring.radius[1]);
        let box_of = [columns.clone(), columns.clone()];
        let targets = Targets::new(&plan.texels.grid, box_of, plan.filter, series.kernel, series.step, wavelength_nm);
        let (first_row, last_row) = span(&targets.taps[1]);
        let taps = &targets.taps[0];
        let mut rows = vec![0.0; (last_row - first_row) as usize * taps.first.len() * series.values];
        rows.par_chunks_mut(taps.first.len() * series.values).enumerate().for_each(|(line, out)| {
            let Some(stored) = stored_line(series, first_row + line as i32) else { return };
            let weights = taps.weight.chunks_exact(taps.count);
            for ((slot, &first), weights) in out.chunks_exact_mut(series.values).zip(&taps.first).zip(weights) {
                for (column, &weight) in (first - series.first[0]..).zip(weights) {
                    // Past the sampling's limit nothing is known, and nothing is added.
                    if (0..series.lines[0] as i32).contains(&column) {
                        let values = &stored[column as usize * series.values..][..series.values];
                        slot.iter_mut().zip(values).for_each(|(sum, value)| *sum += f64::from(weight) * value);
                    }
                }
            }
        });
        Self { series, plan, ring, terms, columns, targets, rows, first_row }
    }

    /// Adds `factors[p] weight[c] a_p` to every texel; layout of the sums `[row][column][channel][term]`.
    fn add(&self, factors: &[f64], weight: [f64; 3], sums: &mut [f64]) {
        let grid = &self.plan.texels.grid;
        let per_texel = 3 * self.terms;
        let per_row = grid.size * per_texel;
        sums.par_chunks_mut(per_row).enumerate().filter(|(row, _)| self.columns.contains(row)).for_each_init(
            || (vec![0.0; self.series.values], vec![0.0; self.terms]),
            |(values, power), (row, out)| {
                let v = grid.v(row);
                let outer = grid.columns_within((self.ring.radius[1].powi(2) - v * v).max(0.0).sqrt());
                let inner = inner_columns(grid, self.ring.radius[0], v);
                for column in outer.filter(|c| !inner.contains(c)) {
                    self.texel(row, column, values, power);
                    let texel = &mut out[column * per_texel..(column + 1) * per_texel];
                    for (channel, weight) in texel.chunks_exact_mut(self.terms).zip(weight) {
                        for ((sum, a), factor) in channel.iter_mut().zip(&*power).zip(factors) {
                            *sum += weight * factor * a;
                        }
                    }
                }
            },
        );
    }

    /// Coefficients of `|P|²` in one texel, averaged over its box samples.
    fn texel(&self, row: usize, column: usize, values: &mut [f64], power: &mut [f64]) {
        let Targets { samples, taps: [taps_x, taps_y], .. } = &self.targets;
        let columns = &self.columns;
        let mean_power = matches!(self.series.kernel, Kernel::GaussianPower { .. });
        let share = 1.0 / (samples * samples) as f64;
        let mut squared = vec![0.0; self.terms];
        power.fill(0.0);
        for sample in 0..samples * samples {
            let tx = (column - columns.start) * samples + sample % samples;
            let ty = (row - columns.start) * samples + sample / samples;
            values.fill(0.0);
            let start = (taps_y.first[ty] - self.first_row) as usize;
            for (tap, &weight) in taps_y.weight[ty * taps_y.count..][..taps_y.count].iter().enumerate() {
                let at = ((start + tap) * taps_x.first.len() + tx) * self.series.values;
                let line = &self.rows[at..at + self.series.values];
                values.iter_mut().zip(line).for_each(|(sum, value)| *sum += f64::from(weight) * value);
            }
            if mean_power {
                squared.copy_from_slice(values);
            } else {
                square_series(values, &mut squared);
            }
            power.iter_mut().zip(&squared).for_each(|(sum, value)| *sum += share * value);
        }
    }
}

fn stored_line(series: &HeightPowers, row: i32) -> Option<&[f64]> {
    let row = usize::try_from(row - series.first[1]).ok().filter(|&row| row < series.lines[1])?;
    let length = series.lines[0] * series.values;
    Some(&series.data[row * length..(row + 1) * length])
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array2;

    fn field(height_nm: f64) -> HeightField {
        let heights_nm = Array2::from_shape_fn((32, 64), |(_, x)| 0.5 * height_nm * (x as f64 * TAU / 64.0).sin());
        HeightField { heights_nm, pitch_nm: [60.0, 60.0] }
    }

    #[test]
    fn forecast_meets_the_closed_form_of_two_levels() {
        // Half the samples at 0, half at d: ⟨cosh 2s(h - h')⟩ = (1 + cosh 2sd) / 2 = cosh² sd, up to the rounding of the
        // histogram's differences (one bin in 512: a factor exp(s d / 512)).
        let heights_nm = Array2::from_shape_fn((4, 4), |(row, _)| if row < 2 { 0.0 } else { 200.0 });
        let two = HeightField { heights_nm, pitch_nm: [50.0, 50.0] };
        let s = 2.0 * TAU / 380.0;
        let expected = (200.0 * s).cosh().log10();
        let found = forecast(&[two], s, 1e-3).digits_lost;
        let slack = 200.0 * s / 512.0 / std::f64::consts::LN_10;
        assert!(found >= expected - 1e-12 && found <= expected + slack, "{found} {expected}");
    }

    #[test]
    fn terms_grow_with_relief_and_tolerance_and_a_flat_surface_needs_one() {
        let s = 2.0 * TAU / 380.0;
        let terms = |height_nm, tolerance| forecast(&[field(height_nm)], s, tolerance).terms;
        assert_eq!(terms(0.0, 1e-6), 1);
        assert!(terms(100.0, 1e-3) < terms(200.0, 1e-3) && terms(100.0, 1e-3) < terms(100.0, 1e-6));
        // Stirling: x^T / T! = 1e-4 at x = 6.6 (200 nm) for T = 24; the mean over pairs lies below the worst pair.
        assert!((16..=25).contains(&terms(200.0, 1e-3)), "{}", terms(200.0, 1e-3));
    }

    #[test]
    fn refuses_where_terms_cancel_and_names_the_numbers() {
        let s = 2.0 * TAU / 380.0;
        let deep = forecast(&[field(1_500.0)], s, 1e-3);
        let message = refuse_catastrophe(&deep, Storage::Float).unwrap_err().to_string();
        assert!(message.contains(&format!("{} tables", deep.terms)) && message.contains("chebyshev"), "{message}");
        let middle = forecast(&[field(400.0)], s, 1e-3);
        assert!(refuse_catastrophe(&middle, Storage::Float).is_ok());
        let message = refuse_catastrophe(&middle, Storage::Half).unwrap_err().to_string();
        assert!(message.contains("storage = \"float\""), "{message}");
        assert!(refuse_catastrophe(&forecast(&[field(50.0)], s, 1e-3), Storage::Half).is_ok());
    }
}
