//! Error, time, memory and bytes of every method over its settings.

use std::f64::consts::TAU;
use std::time::Instant;

use half::f16;
use ndarray::Array3;

use super::sample::{RegionSample, Sample, deviation};
use super::{MethodRow, Refusal, RegionErrors, StudyConfig, memory};
use crate::ground::direction::{Vec3, Xyz, wave_vector_change};
use crate::ground::error::Result;
use crate::ground::sampling::{Region, direction_pairs, plane};
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::reference::{FULL_STEP, prefactor, resolving_wavelengths};
use crate::optics::spectra::{Spectra, transform};
use crate::stages::progress::Progress;
use crate::tables::baselines::harmonics;
use crate::tables::baselines::regular::RegularSurface;
use crate::tables::baselines::rough::RoughSurface;
use crate::tables::baselines::statistics::SurfaceStatistics;
use crate::tables::build;
use crate::tables::evaluate::{self, Interpolation};
use crate::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};

/// Time spent on timing one method's evaluation, and fewest directions.
const TIMING_S: f64 = 0.2;
const TIMED_MIN: usize = 4;

/// Radii and azimuths of the power sum.
const POWER_GRID: [usize; 2] = [96, 128];

/// What every method is given.
pub struct Context<'a> {
    pub fields: &'a [HeightField],
    pub optics: &'a OpticsConfig,
    pub config: &'a StudyConfig,
    pub sample: &'a Sample,
    pub progress: &'a dyn Progress,
}

/// Steps of progress.
pub fn count(config: &StudyConfig) -> u64 {
    (4 + config.chebyshev.len() + config.taylor.len() + config.harmonics.len()) as u64
}

/// What a row is about.
struct Label<'a> {
    method: &'a str,
    setting: String,
    tables: Option<(Basis, Storage)>,
    stored_bytes: u64,
}

/// Whether a method can be integrated over the hemisphere in reasonable time.
#[derive(Clone, Copy)]
enum Speed {
    Quick,
    Slow,
}

/// What building took.
#[derive(Clone, Copy)]
struct Cost {
    build_s: f64,
    peak_bytes: Option<u64>,
}

impl Context<'_> {
    /// All rows; settings that are refused go to `refusals`.
    pub fn rows(&self, statistics: &SurfaceStatistics, refusals: &mut Vec<Refusal>) -> Result<Vec<MethodRow>> {
        let mut rows = self.references()?;
        self.progress.advance(2);
        for (basis, counts) in [(Basis::Chebyshev, &self.config.chebyshev), (Basis::Taylor, &self.config.taylor)] {
            for &count in counts {
                match self.table_rows(basis, count) {
                    Ok(found) => rows.extend(found),
                    Err(error) => {
                        let what = format!("{}, {count} tables", family(basis, Storage::Float));
                        refusals.push(Refusal { what, message: error.to_string() });
                    }
                }
                self.progress.advance(1);
            }
        }
        rows.extend(self.closed_forms(statistics)?);
        self.progress.advance(2);
        rows.extend(self.harmonic_rows()?);
        Ok(rows)
    }

    /// The direct sum itself, and fast Fourier transforms without tables.
    fn references(&self) -> Result<Vec<MethodRow>> {
        let heights: usize = self.fields.iter().map(|f| f.heights_nm.len() * size_of::<f64>()).sum();
        let exact = |r: &RegionSample| RegionErrors {
            region: r.region,
            relative_l2: 0.0,
            quantiles: deviation(&r.luminance, &r.luminance),
        };
        let direct = MethodRow {
            method: "direct sum".into(),
            setting: "every sample".into(),
            basis: None,
            storage: None,
            build_s: 0.0,
            // All threads worked on different directions.
            evaluate_s: self.sample.reference_s * rayon::current_num_threads() as f64,
            peak_bytes: None,
            stored_bytes: heights as u64,
            errors: self.sample.regions.iter().map(exact).collect(),
            power_sum: None,
        };
        let (spectra, cost) = measured(|| self.spectra())?;
        let bytes = spectra.iter().map(|s| s.data.len() * size_of_val(&s.data[..1])).sum::<usize>();
        let fft = Label { method: "FFT", setting: "no tables".into(), tables: None, stored_bytes: bytes as u64 };
        let fft = self.row(fft, cost, Speed::Slow, &|wi, wo| fft_brdf(&spectra, self.optics, wi, wo))?;
        Ok(vec![direct, fft])
    }

    fn spectra(&self) -> Result<Vec<Spectra>> {
        let plan = build::plan(self.fields, self.optics, &self.tables_config(Basis::Chebyshev))?;
        let windows = plan.windows.iter();
        windows.map(|&(scan, place)| transform(&self.fields[scan], place, self.optics, &plan.spectra)).collect()
    }

    /// Tables of one basis and number, stored in both formats.
    fn table_rows(&self, basis: Basis, count: usize) -> Result<Vec<MethodRow>> {
        let config = TablesConfig { count: Some(count), ..self.tables_config(basis) };
        let (set, cost) = measured(|| Ok(build::build(self.fields, self.optics, &config, &|_| ())?.0))?;
        [Storage::Float, Storage::Half]
            .into_iter()
            .map(|storage| {
                let set = stored(&set, storage);
                let label = Label {
                    method: family(basis, storage),
                    setting: format!("{count} tables"),
                    tables: Some((basis, storage)),
                    stored_bytes: stored_bytes(&set, storage),
                };
                self.row(label, cost, Speed::Quick, &|wi, wo| {
                    Ok(evaluate::brdf_xyz(&set, Interpolation::Cubic, wi, wo))
                })
            })
            .collect()
    }

    fn closed_forms(&self, statistics: &SurfaceStatistics) -> Result<Vec<MethodRow>> {
        let rough = RoughSurface { rms_nm: statistics.rms_nm, correlation_nm: statistics.correlation_nm };
        let regular = RegularSurface::fitted(statistics);
        let nothing = Cost { build_s: 0.0, peak_bytes: None };
        let label = |method, setting: String, numbers: usize| Label {
            method,
            setting,
            tables: None,
            stored_bytes: (numbers * size_of::<f64>()) as u64,
        };
        let waves = regular.waves.len();
        Ok(vec![
            self.row(label("Stam, random", "rms, length".into(), 2), nothing, Speed::Slow, &|wi, wo| {
                rough.brdf_xyz(self.optics, wi, wo)
            })?,
            self.row(label("Stam, regular", format!("{waves} waves"), 3 * waves), nothing, Speed::Slow, &|wi, wo| {
                regular.brdf_xyz(self.optics, wi, wo)
            })?,
        ])
    }

    /// Spherical harmonics fitted to the best tables at hand.
    fn harmonic_rows(&self) -> Result<Vec<MethodRow>> {
        let set = build::build(self.fields, self.optics, &self.tables_config(Basis::Chebyshev), &|_| ())?.0;
        let reach = set.usable_radius;
        let mut rows = Vec::new();
        for &degree in &self.config.harmonics {
            let (fitted, cost) = measured(|| {
                let pairs = direction_pairs(Region::Hemisphere, 20 * (degree + 1).pow(2) * 3);
                let samples: Vec<(Vec3, Xyz)> = pairs
                    .into_iter()
                    .map(|(wi, wo)| wave_vector_change(wi, wo))
                    .filter(|q| q[0].hypot(q[1]) < reach)
                    .map(|q| (q, evaluate::window_power(&set, Interpolation::Cubic, q)))
                    .collect();
                harmonics::fit(degree, &samples)
            })?;
            let label = Label {
                method: "spherical harmonics",
                setting: format!("degree {degree}"),
                tables: None,
                stored_bytes: (fitted.coefficients.len() * size_of::<Xyz>()) as u64,
            };
            rows.push(self.row(label, cost, Speed::Quick, &|wi, wo| Ok(fitted.brdf_xyz(self.optics, wi, wo)))?);
            self.progress.advance(1);
        }
        Ok(rows)
    }

    /// Errors, evaluation time and, for methods quick enough, the power sum.
    fn row(
        &self,
        label: Label,
        cost: Cost,
        speed: Speed,
        brdf: &dyn Fn(Vec3, Vec3) -> Result<Xyz>,
    ) -> Result<MethodRow> {
        Ok(MethodRow {
            method: label.method.into(),
            setting: label.setting,
            basis: label.tables.map(|t| t.0),
            storage: label.tables.map(|t| t.1),
            build_s: cost.build_s,
            evaluate_s: seconds_per_direction(self.config.timed_directions, brdf)?,
            peak_bytes: cost.peak_bytes,
            stored_bytes: label.stored_bytes,
            errors: self.sample.errors(brdf)?,
            power_sum: match speed {
                Speed::Quick => Some(self.power_sum(brdf)?),
                Speed::Slow => None,
            },
        })
    }

    /// `∫ Y cos_o dω_o` at normal incidence over the disc the scans answer for: midpoint rule over azimuths and
    /// warped radii, dense at the lobe.
    fn power_sum(&self, brdf: &dyn Fn(Vec3, Vec3) -> Result<Xyz>) -> Result<f64> {
        let limits = self.fields.iter().map(|f| crate::tables::plan::usable_radius(self.optics, f.pitch_nm));
        let rim = limits.fold(0.999, f64::min);
        let [radii, azimuths] = POWER_GRID;
        let mut sum = 0.0;
        for i in 0..radii {
            let [inner, middle, outer] = [0.0, 0.5, 1.0].map(|x| rim * ((i as f64 + x) / radii as f64).powi(2));
            for j in 0..azimuths {
                // A ring's azimuths are turned against its neighbours', or orders along an axis would alias.
                let phi = TAU * (j as f64 + plane(i)[0]) / azimuths as f64;
                let wo = [middle * phi.cos(), middle * phi.sin(), (1.0 - middle * middle).sqrt()];
                let area = 0.5 * (outer * outer - inner * inner) * TAU / azimuths as f64;
                sum += brdf([0.0, 0.0, 1.0], wo)?[1] * area;
            }
        }
        Ok(sum)
    }

    /// Settings that leave everything but number and basis at a fine tolerance.
    pub fn tables_config(&self, basis: Basis) -> TablesConfig {
        TablesConfig {
            basis,
            tolerance: 1e-4,
            size: Some(self.config.size),
            count: None,
            wavelength_step_nm: None,
            storage: Storage::Float,
            prefilter: Prefilter::None,
            memory_mib: self.config.memory_mib,
        }
    }
}

fn family(basis: Basis, storage: Storage) -> &'static str {
    match (basis, storage) {
        (Basis::Chebyshev, Storage::Float) => "chebyshev, float",
        (Basis::Chebyshev, Storage::Half) => "chebyshev, half",
        (Basis::Taylor, Storage::Float) => "taylor, float",
        (Basis::Taylor, Storage::Half) => "taylor, half",
    }
}

fn measured<T>(work: impl FnOnce() -> Result<T>) -> Result<(T, Cost)> {
    memory::restart();
    let started = Instant::now();
    let made = work()?;
    Ok((made, Cost { build_s: started.elapsed().as_secs_f64(), peak_bytes: memory::peak_bytes() }))
}

/// Wall seconds per direction on this thread, over as many directions as a fraction of a second allows.
fn seconds_per_direction(most: usize, brdf: &dyn Fn(Vec3, Vec3) -> Result<Xyz>) -> Result<f64> {
    let pairs = direction_pairs(Region::Hemisphere, most);
    let started = Instant::now();
    for (done, &(wi, wo)) in pairs.iter().enumerate() {
        std::hint::black_box(brdf(wi, wo)?);
        if done + 1 >= TIMED_MIN && started.elapsed().as_secs_f64() > TIMING_S {
            return Ok(started.elapsed().as_secs_f64() / (done + 1) as f64);
        }
    }
    Ok(started.elapsed().as_secs_f64() / pairs.len().max(1) as f64)
}

/// The BRDF from the transforms: as the direct sum, with `|P|²` interpolated.
fn fft_brdf(spectra: &[Spectra], optics: &OpticsConfig, wi: Vec3, wo: Vec3) -> Result<Xyz> {
    let q = wave_vector_change(wi, wo);
    let front = prefactor(optics, wi, wo);
    let mut xyz = [0.0; 3];
    if front == 0.0 {
        return Ok(xyz);
    }
    let quadrature = resolving_wavelengths(optics, q, FULL_STEP)?;
    for (&nm, weight) in quadrature.wavelengths_nm.iter().zip(&quadrature.weights) {
        let s = TAU / nm * q[2].abs();
        let power: f64 = spectra.iter().map(|e| e.whole_power_at([q[0] / nm, q[1] / nm], &[s])[0]).sum();
        let f = front * power / (spectra.len() as f64 * nm * nm * q[2] * q[2]);
        xyz.iter_mut().zip(weight).for_each(|(sum, weight)| *sum += weight * f);
    }
    Ok(xyz)
}

/// The tables as a renderer reads them back: each array over its peak, rounded to the format.
pub fn stored(set: &TableSet, storage: Storage) -> TableSet {
    let mut set = set.clone();
    if storage == Storage::Half {
        let lobe = set.lobe.iter_mut().flat_map(|lobe| std::iter::once(&mut lobe.coherent).chain(&mut lobe.cross));
        set.tables.iter_mut().chain(lobe).for_each(round_to_half);
    }
    set
}

fn round_to_half(table: &mut Array3<f32>) {
    let peak = table.iter().fold(0.0f32, |peak, v| peak.max(v.abs()));
    if peak > 0.0 {
        // A peak of 2^14 leaves 28 binary orders above the denormals.
        let scale = peak / 16_384.0;
        table.mapv_inplace(|v| f16::from_f32(v / scale).to_f32() * scale);
    }
}

fn stored_bytes(set: &TableSet, storage: Storage) -> u64 {
    let lobe = set.lobe.iter().flat_map(|lobe| std::iter::once(&lobe.coherent).chain(&lobe.cross));
    let numbers: usize = set.tables.iter().chain(lobe).map(Array3::len).sum();
    let width = if storage == Storage::Half { 2 } else { 4 };
    (numbers * width) as u64
}
