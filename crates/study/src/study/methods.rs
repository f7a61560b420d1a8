//! Error, time, memory and bytes of every method over its settings.

use std::f64::consts::TAU;
use std::time::Instant;

use super::batch::{Batch, PackedTables, Pair, stored};
use super::config::StudyConfig;
use super::lent::GpuClock;
use super::pictures::Pictures;
use super::rows::{MethodRow, Refusal, RegionErrors};
use super::sample::Sample;
use super::timing::Clock;
use crate::baselines::regular::RegularSurface;
use crate::baselines::rough::RoughSurface;
use crate::baselines::statistics::SurfaceStatistics;
use crate::baselines::{self, harmonics};
use crate::error::Result;
use diffraction_brdf::direction::{Vec3, Xyz, wave_vector_change};
use diffraction_brdf::evaluate::{self, Interpolation};
use diffraction_build::ground::memory;
use diffraction_build::ground::progress::Progress;
use diffraction_build::ground::sampling::{Region, direction_pairs, plane};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::reference::FULL_STEP;
use diffraction_build::optics::spectra::{Spectra, transform};
use diffraction_build::optics::spectral::add_window;
use diffraction_build::tables::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};
use diffraction_build::tables::plan;

/// Radii and azimuths of the power sum.
const POWER_GRID: [usize; 2] = [96, 128];

/// The transforms without tables: what pictures are held against.
pub const FFT: &str = "FFT";

/// What each family of methods is for, in a sentence: the beginning of its rows' names first.
pub const PURPOSES: [(&str, &str); 9] = [
    ("direct sum", "The definition itself, in double precision: slow, and what everything else is held against."),
    (FFT, "The same without tables, from transforms at a few heights of phase: a reference for many directions."),
    (
        "chebyshev",
        "The tables of an atlas: every direction, wavelength and light folded into a few images for a renderer.",
    ),
    ("taylor", "The published tables (Dhillon et al. 2014), in powers of w: for shallow surfaces."),
    (
        "Stam",
        "Closed forms of a random surface and of one or two waves (Stam 1999): no scan needed, a few numbers of it kept.",
    ),
    (
        "spherical harmonics",
        "A smooth fit (Lindsay and Agu 2006): for materials without narrow orders, at hardly any memory.",
    ),
    (
        "WBSDF",
        "A Wigner distribution (Cuypers et al. 2012): for gratings lit and seen in one plane, and for light that meets      more than one such surface; a single line of a scan says little of a surface that varies both ways.",
    ),
    (
        "light field",
        "The Wigner distribution as rays, some negative (Oh et al. 2010): for ray tracers that are to show waves      near a thin, slowly varying screen; too few positions or angles alias.",
    ),
    (
        "optical paths",
        "Phases of sampled paths (Ziegler et al. 2008): for arbitrary paths through a scene, with no      preparation; N paths leave 1/N of the mirror's light everywhere.",
    ),
];

/// What every method is given.
pub struct Context<'a> {
    pub fields: &'a [HeightField],
    pub optics: &'a OpticsConfig,
    pub config: &'a StudyConfig,
    pub sample: &'a Sample,
    pub spectra: &'a [Spectra],
    pub pictures: &'a Pictures<'a>,
    pub clock: &'a Clock,
    pub gpu: Option<&'a dyn GpuClock>,
    pub progress: &'a dyn Progress,
}

/// Steps of progress.
pub fn count(config: &StudyConfig) -> u64 {
    (4 + config.chebyshev.len() + config.taylor.len() + config.harmonics.len()) as u64
}

/// What all methods left.
pub struct Rows {
    pub methods: Vec<MethodRow>,
    pub refusals: Vec<Refusal>,
}

/// What a row is about.
pub(crate) struct Label<'a> {
    method: &'a str,
    setting: String,
    tables: Option<(Basis, Storage)>,
    stored_bytes: u64,
}

impl<'a> Label<'a> {
    /// Of a method that keeps other numbers than tables, so many bytes.
    pub(crate) fn without_tables(method: &'a str, setting: String, bytes: usize) -> Self {
        Self { method, setting, tables: None, stored_bytes: bytes as u64 }
    }
}

/// What building took.
#[derive(Clone, Copy, Default)]
pub struct Cost {
    build_s: f64,
    peak_bytes: Option<u64>,
}

impl Context<'_> {
    /// All rows but those of the wave methods; settings that are refused are listed apart.
    pub fn rows(&self, statistics: &SurfaceStatistics, transforms: Cost) -> Result<Rows> {
        let mut rows = Rows { methods: self.references(transforms), refusals: Vec::new() };
        let mut finest = None;
        self.progress.advance(2);
        for (basis, counts) in [(Basis::Chebyshev, &self.config.chebyshev), (Basis::Taylor, &self.config.taylor)] {
            for &count in counts {
                match self.table_rows(basis, count) {
                    Ok((set, found)) => {
                        rows.methods.extend(found);
                        if basis == Basis::Chebyshev {
                            finest = Some(set);
                        }
                    }
                    Err(error) => {
                        let what = format!("{}, {count} tables", family(basis, Storage::Float));
                        rows.refusals.push(Refusal { what, message: error.to_string() });
                    }
                }
                self.progress.advance(1);
            }
        }
        rows.methods.extend(self.closed_forms(statistics));
        self.progress.advance(2);
        match finest {
            Some(finest) => rows.methods.extend(self.harmonic_rows(&finest)?),
            None => self.progress.advance(self.config.harmonics.len() as u64),
        }
        Ok(rows)
    }

    /// The direct sum itself, and fast Fourier transforms without tables.
    fn references(&self, transforms: Cost) -> Vec<MethodRow> {
        let heights: usize = self.fields.iter().map(|f| f.heights_nm.len() * size_of::<f64>()).sum();
        let exact = |y: &[f64]| self.sample.deviation(y, y);
        let regions = self.sample.regions.iter();
        let direct = MethodRow {
            method: "direct sum".into(),
            setting: "every sample".into(),
            basis: None,
            storage: None,
            build_s: 0.0,
            // All threads worked on different directions.
            evaluate_s: self.sample.reference_s * rayon::current_num_threads() as f64,
            all_threads_s: self.sample.reference_s,
            bilinear_s: None,
            gpu_s: None,
            peak_bytes: None,
            stored_bytes: heights as u64,
            errors: regions
                .map(|(region, found)| RegionErrors {
                    region: *region,
                    relative_l2: 0.0,
                    quantiles: exact(&found.luminance),
                })
                .collect(),
            on_texels: exact(&self.sample.on_texels.luminance),
            power_sum: None,
            colours: Vec::new(),
            pictures: Vec::new(),
        };
        let bytes = self.spectra.iter().map(|s| s.data.len() * size_of_val(&s.data[..1])).sum::<usize>();
        let label = Label::without_tables(FFT, "no tables".into(), bytes);
        let share = 1.0 / self.spectra.len().max(1) as f64;
        let batch = |pairs: &[Pair], out: &mut [Xyz]| {
            out.fill([0.0; 3]);
            for window in self.spectra {
                // A light that cannot be seen has failed before; a number that is none would show as the worst.
                if add_window(window, self.optics, pairs, FULL_STEP, out).is_err() {
                    out.fill([f64::NAN; 3]);
                }
            }
            out.iter_mut().flatten().for_each(|x| *x *= share);
        };
        let fft = MethodRow { pictures: self.pictures.shown(), ..self.row(label, transforms, &batch) };
        vec![direct, fft]
    }

    /// Tables of one basis and number, stored in both formats.
    fn table_rows(&self, basis: Basis, count: usize) -> Result<(TableSet, Vec<MethodRow>)> {
        let config = TablesConfig { count: Some(count), ..self.tables_config(basis) };
        let ((set, _), cost) = measured(|| build::build(&BuildInput::new(self.fields, self.optics, &config), &|_| ()))?;
        let mut rows = Vec::new();
        for storage in [Storage::Float, Storage::Half] {
            let packed = PackedTables::new(&set, count, storage);
            let label = Label {
                method: family(basis, storage),
                setting: format!("{count} tables"),
                tables: Some((basis, storage)),
                stored_bytes: packed.bytes(),
            };
            let cubic = |pairs: &[Pair], out: &mut [Xyz]| packed.evaluate(Interpolation::Cubic, pairs, out);
            let bilinear = |pairs: &[Pair], out: &mut [Xyz]| packed.evaluate(Interpolation::Bilinear, pairs, out);
            let gpu_s = match self.gpu {
                // Textures hold halves.
                Some(gpu) if storage == Storage::Half => Some(gpu.seconds_per_direction(&stored(&set, storage))?),
                _ => None,
            };
            rows.push(MethodRow {
                bilinear_s: Some(self.clock.on_one_thread(&bilinear, &self.timed_pairs())),
                gpu_s,
                ..self.row_with_pictures(label, cost, &cubic)
            });
        }
        Ok((set, rows))
    }

    fn closed_forms(&self, statistics: &SurfaceStatistics) -> Vec<MethodRow> {
        let rough = RoughSurface { rms_nm: statistics.rms_nm, correlation_nm: statistics.correlation_nm };
        let regular = RegularSurface::fitted(statistics);
        let label = |method, setting: String, numbers: usize| {
            Label::without_tables(method, setting, numbers * size_of::<f64>())
        };
        let waves = regular.waves.len();
        let sigma_nm = self.optics.sigma_nm;
        let random = self.closed_form(|q, nm| rough.power_nm2(sigma_nm, q, nm));
        let bumps = self.closed_form(|q, nm| regular.power_nm2(sigma_nm, q, nm));
        vec![
            self.row_with_pictures(label("Stam, random", "rms, length".into(), 2), Cost::default(), &random),
            self.row_with_pictures(
                label("Stam, regular", format!("{waves} waves"), 3 * waves),
                Cost::default(),
                &bumps,
            ),
        ]
    }

    /// A closed form of the window's power, integrated over the light's spectrum.
    fn closed_form(&self, power_nm2: impl Fn(Vec3, f64) -> f64 + Sync) -> impl Fn(&[Pair], &mut [Xyz]) + Sync {
        move |pairs, out| {
            out.fill([0.0; 3]);
            // A light that cannot be seen has failed before; a number that is none would show as the worst.
            if baselines::integrate(self.optics, pairs, &power_nm2, out).is_err() {
                out.fill([f64::NAN; 3]);
            }
        }
    }

    /// Spherical harmonics fitted to the best tables at hand.
    fn harmonic_rows(&self, set: &TableSet) -> Result<Vec<MethodRow>> {
        let reach = set.usable_radius;
        let mut rows = Vec::new();
        for &degree in &self.config.harmonics {
            let (fitted, cost) = measured(|| {
                let pairs = direction_pairs(Region::Hemisphere, 20 * (degree + 1).pow(2) * 3);
                let samples: Vec<(Vec3, Xyz)> = pairs
                    .into_iter()
                    .map(|(wi, wo)| wave_vector_change(wi, wo))
                    .filter(|q| q[0].hypot(q[1]) < reach)
                    .map(|q| (q, evaluate::window_power(set, Interpolation::Cubic, q)))
                    .collect();
                harmonics::fit(degree, &samples)
            })?;
            let bytes = fitted.coefficients.len() * size_of::<Xyz>();
            let label = Label::without_tables("spherical harmonics", format!("degree {degree}"), bytes);
            rows.push(self.row_with_pictures(label, cost, &each(|wi, wo| fitted.brdf_xyz(self.optics, wi, wo))));
            self.progress.advance(1);
        }
        Ok(rows)
    }

    /// Errors and evaluation time of one method, with its pictures and power sum: tens of thousands of directions.
    fn row_with_pictures(&self, label: Label, cost: Cost, batch: Batch) -> MethodRow {
        let (colours, pictures) = self.pictures.compared(batch);
        MethodRow { power_sum: Some(self.power_sum(batch)), colours, pictures, ..self.row(label, cost, batch) }
    }

    /// Errors and evaluation time of one method.
    pub fn row(&self, label: Label, cost: Cost, batch: Batch) -> MethodRow {
        let pairs = self.timed_pairs();
        MethodRow {
            method: label.method.into(),
            setting: label.setting,
            basis: label.tables.map(|t| t.0),
            storage: label.tables.map(|t| t.1),
            build_s: cost.build_s,
            evaluate_s: self.clock.on_one_thread(batch, &pairs),
            all_threads_s: self.clock.on_all_threads(batch, &pairs),
            bilinear_s: None,
            gpu_s: None,
            peak_bytes: cost.peak_bytes,
            stored_bytes: label.stored_bytes,
            errors: self.sample.errors(batch),
            on_texels: self.sample.errors_on_texels(batch),
            power_sum: None,
            colours: Vec::new(),
            pictures: Vec::new(),
        }
    }

    /// The directions on which evaluation is timed.
    pub(crate) fn timed_pairs(&self) -> Vec<Pair> {
        direction_pairs(Region::Hemisphere, self.config.timed_directions)
    }

    /// `∫ Y cos_o dω_o` at normal incidence over the disc the scans answer for: midpoint rule over azimuths and
    /// warped radii, dense at the lobe.
    fn power_sum(&self, batch: Batch) -> f64 {
        let limits =
            self.fields.iter().map(|f| diffraction_build::tables::resolution::usable_radius(self.optics, f.pitch_nm));
        let rim = limits.fold(0.999, f64::min);
        let [radii, azimuths] = POWER_GRID;
        let (mut pairs, mut areas) = (Vec::new(), Vec::new());
        for i in 0..radii {
            let [inner, middle, outer] = [0.0, 0.5, 1.0].map(|x| rim * ((i as f64 + x) / radii as f64).powi(2));
            for j in 0..azimuths {
                // A ring's azimuths are turned against its neighbours', or orders along an axis would alias.
                let phi = TAU * (j as f64 + plane(i)[0]) / azimuths as f64;
                let wo = [middle * phi.cos(), middle * phi.sin(), (1.0 - middle * middle).sqrt()];
                pairs.push(([0.0, 0.0, 1.0], wo));
                areas.push(0.5 * (outer * outer - inner * inner) * TAU / azimuths as f64);
            }
        }
        let luminances = super::sample::luminances(batch, &pairs);
        luminances.iter().zip(&areas).map(|(y, area)| y * area).sum()
    }

    /// Settings that leave everything but number and basis at a fine tolerance.
    pub fn tables_config(&self, basis: Basis) -> TablesConfig {
        tables_config(self.config, basis)
    }
}

/// As [`Context::tables_config`].
pub fn tables_config(config: &StudyConfig, basis: Basis) -> TablesConfig {
    TablesConfig {
        basis,
        tolerance: 1e-4,
        size: Some(config.size),
        count: None,
        wavelength_step_nm: None,
        storage: Some(Storage::Float),
        prefilter: Prefilter::None,
        memory_mib: config.memory_mib,
    }
}

/// The transforms of all windows, and what they took.
pub fn transforms(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &StudyConfig,
) -> diffraction_brdf::Result<(Vec<Spectra>, Cost)> {
    measured(|| {
        let plan = plan::plan(&BuildInput::new(fields, optics, &tables_config(config, Basis::Chebyshev)))?;
        let windows = plan.windows.iter();
        windows.map(|&(scan, place)| transform(&fields[scan], place, optics, &plan.spectra)).collect()
    })
}

/// A method for one pair as a method for many.
fn each(brdf: impl Fn(Vec3, Vec3) -> Xyz + Sync) -> impl Fn(&[Pair], &mut [Xyz]) + Sync {
    move |pairs, out| pairs.iter().zip(out).for_each(|(&(wi, wo), xyz)| *xyz = brdf(wi, wo))
}

fn family(basis: Basis, storage: Storage) -> &'static str {
    match (basis, storage) {
        (Basis::Chebyshev, Storage::Float) => "chebyshev, float",
        (Basis::Chebyshev, Storage::Half) => "chebyshev, half",
        (Basis::Taylor, Storage::Float) => "taylor, float",
        (Basis::Taylor, Storage::Half) => "taylor, half",
    }
}

/// The result of some work, and what it took.
pub fn measured<T, E>(work: impl FnOnce() -> std::result::Result<T, E>) -> std::result::Result<(T, Cost), E> {
    let before = memory::restart();
    let started = Instant::now();
    let made = work()?;
    let build_s = started.elapsed().as_secs_f64();
    let peak_bytes = memory::peak_bytes().zip(before).map(|(peak, before)| peak.saturating_sub(before));
    Ok((made, Cost { build_s, peak_bytes }))
}
