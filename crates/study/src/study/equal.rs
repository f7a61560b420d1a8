//! Half-float Chebyshev tables against the published method in floats, at equal error: bytes and time.
//!
//! Bytes are counted in a renderer's memory and in the atlas's files. In files, both methods' numbers are rounded to the
//! error as their tolerance and compressed alike.
//!
//! Settings follow from measured errors: of each method the fewest tables that reach an error at texels
//! outside the mirror lobe, so that the grid, the same for both, hides neither. Light, windows and prefilter are the
//! specimen's own.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::batch::{PackedTables, Pair, stored};
use super::config::{StudyConfig, StudySpecimen};
use super::methods::Context;
use super::rows::Refusal;
use super::sample::{floor_per_sr, luminances};
use super::texels::Texels;
use crate::error::Result;
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::{self, Error};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::files;
use diffraction_brdf::storage::write_tables;
use diffraction_build::ground::metrics::{ErrorQuantiles, relative_error_quantiles};
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::tables::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};
use diffraction_build::tables::plan;
use diffraction_build::tables::rounding::to_tolerance;

/// Errors at which the methods are compared.
const TARGETS: [f64; 4] = [3e-2, 1e-2, 3e-3, 1e-3];

/// The published method's best is the least number of tables within this factor of its smallest error.
const BEST_WITHIN: f64 = 1.05;

/// Which error is made equal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// 95th percentile over the hemisphere.
    P95,
    /// 95th percentile with both directions within 30° of the normal, where a specimen is usually looked at.
    Steep,
    /// Worst over the hemisphere.
    Worst,
}

/// Errors of one setting, by measure.
#[derive(Clone, Copy)]
struct Errors {
    hemisphere: ErrorQuantiles,
    steep: ErrorQuantiles,
}

impl Measure {
    fn of(self, errors: &Errors) -> f64 {
        match self {
            Self::P95 => errors.hemisphere.p95,
            Self::Steep => errors.steep.p95,
            Self::Worst => errors.hemisphere.worst,
        }
    }
}

/// Directions drawn over the hemisphere, of which the first that meet texels above the floor are taken; 2.5 % lie within 30° of the
/// normal.
const DRAWN: usize = 8_192;

/// Cosine of 30°.
const STEEP_COS: f64 = 0.866_025_403_784_438_6;

fn steep((wi, wo): &Pair) -> bool {
    wi[2] > STEEP_COS && wo[2] > STEEP_COS
}

/// Both methods at one error.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EqualError {
    /// Which error.
    pub measure: Measure,
    /// What both reach.
    pub target: f64,
    /// Whether it is the smallest error the published method reaches at all.
    pub taylors_best: bool,
    /// Half-float Chebyshev tables; `None` where no number that was tried reaches it.
    pub chebyshev: Option<Contender>,
    /// The published method in floats; likewise.
    pub taylor: Option<Contender>,
}

/// The fewest tables of one method that reach an error.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Contender {
    /// Tables.
    pub tables: usize,
    /// Relative error of Y on texels.
    pub error: f64,
    /// Bytes a renderer holds.
    pub bytes: u64,
    /// Seconds per direction on one thread, cubic look-ups.
    pub cubic_s: f64,
    /// The same with linear look-ups.
    pub bilinear_s: f64,
    /// Seconds per direction on the GPU, whose textures hold halves either way.
    pub gpu_s: Option<f64>,
    /// What files take; `None` where they were not asked for, or no number of tables reaches the error once rounded.
    pub files: Option<Filed>,
}

/// The fewest tables that reach an error with their numbers rounded to it, in the atlas's files.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Filed {
    /// Tables.
    pub tables: usize,
    /// Relative error of Y on texels, rounded.
    pub error: f64,
    /// Bytes of all files, compressed.
    pub bytes: u64,
}

impl EqualError {
    /// How many times smaller and faster the Chebyshev tables are: bytes, cubic and linear look-ups, GPU.
    pub fn ratios(&self) -> Option<[Option<f64>; 4]> {
        let (ours, theirs) = (self.chebyshev.as_ref()?, self.taylor.as_ref()?);
        let gpu = theirs.gpu_s.zip(ours.gpu_s).map(|(theirs, ours)| theirs / ours);
        let bytes = theirs.bytes as f64 / ours.bytes as f64;
        Some([Some(bytes), Some(theirs.cubic_s / ours.cubic_s), Some(theirs.bilinear_s / ours.bilinear_s), gpu])
    }
}

impl EqualError {
    /// How many times smaller the Chebyshev tables' files are.
    pub fn files_ratio(&self) -> Option<f64> {
        let [ours, theirs] = [&self.chebyshev, &self.taylor].map(|one| one.as_ref().and_then(|one| one.files));
        Some(theirs?.bytes as f64 / ours?.bytes as f64)
    }
}

/// A set cut to a number of tables, with its error.
struct Candidate<'a> {
    set: &'a TableSet,
    tables: usize,
    storage: Storage,
    errors: Errors,
}

impl Candidate<'_> {
    /// The set with no more than its own number of tables.
    fn cut(&self) -> TableSet {
        let Self { set, tables, .. } = self;
        TableSet {
            basis: set.basis,
            tables: set.tables[..*tables].to_vec(),
            lobe: set.lobe.clone(),
            prefilter_width: set.prefilter_width,
            front_factor: set.front_factor,
            restriction: None,
            usable_radius: set.usable_radius,
        }
    }
}

/// The first of the candidates that keeps the target with its numbers rounded to it, in files.
fn filed(list: &[Candidate], target: f64, error_of: &dyn Fn(&PackedTables) -> f64) -> error::Result<Option<Filed>> {
    for candidate in list {
        let &Candidate { tables, storage, .. } = candidate;
        let rounded = to_tolerance(&candidate.cut(), target);
        let error = error_of(&PackedTables::new(&rounded, tables, storage));
        if error <= target {
            let folder =
                tempfile::tempdir().map_err(|e| Error::disk(Path::new("."), "create a temporary folder", e))?;
            write_tables(folder.path(), &rounded, storage)?;
            return Ok(Some(Filed { tables, error, bytes: files::bytes_of(folder.path(), "exr")? }));
        }
    }
    Ok(None)
}

/// What settings are tried.
struct Trials {
    chebyshev: Vec<TableSet>,
    /// The longest series; a shorter one is it cut off, for its terms do not depend on how many there are.
    taylor: Option<TableSet>,
}

/// Steps of progress.
pub fn count(config: &StudyConfig) -> u64 {
    config.chebyshev.len() as u64 + 1
}

/// Compares at every target, and at the published method's best, under the specimen's own light and windows.
pub fn rows(specimen: &StudySpecimen, context: &Context, refusals: &mut Vec<Refusal>) -> Result<Vec<EqualError>> {
    let trials = build_trials(specimen, context, refusals)?;
    let Some(finest) = trials.chebyshev.last() else { return Ok(Vec::new()) };
    let places = Places::of(specimen, context, finest)?;
    let candidate = |set, tables, storage| {
        let errors = places.errors(&PackedTables::new(set, tables, storage));
        Candidate { set, tables, storage, errors }
    };
    let ours: Vec<Candidate> =
        trials.chebyshev.iter().map(|set| candidate(set, set.tables.len(), Storage::Half)).collect();
    let theirs: Vec<Candidate> = match &trials.taylor {
        Some(set) => (1..=set.tables.len()).map(|tables| candidate(set, tables, Storage::Float)).collect(),
        None => Vec::new(),
    };
    let mut found = Vec::new();
    for measure in [Measure::P95, Measure::Steep, Measure::Worst] {
        let best = theirs.iter().map(|c| measure.of(&c.errors)).fold(f64::INFINITY, f64::min) * BEST_WITHIN;
        let targets = TARGETS.into_iter().map(|target| (target, false)).chain([(best, true)]);
        for (target, taylors_best) in targets.filter(|(target, _)| target.is_finite()) {
            // Rounded to the published method's best, and in single directions, there is little to learn.
            let asks_files = !taylors_best && measure != Measure::Worst;
            let first = |list: &[Candidate]| contender(context, &places, list, (measure, target), asks_files);
            found.push(EqualError { measure, target, taylors_best, chebyshev: first(&ours)?, taylor: first(&theirs)? });
        }
    }
    Ok(found)
}

/// The first of the candidates that reaches an error, timed.
fn contender(
    context: &Context,
    places: &Places,
    list: &[Candidate],
    (measure, target): (Measure, f64),
    asks_files: bool,
) -> Result<Option<Contender>> {
    let Some(first) = list.iter().position(|c| measure.of(&c.errors) <= target) else { return Ok(None) };
    let contender = timed(context, &list[first], measure.of(&list[first].errors))?;
    let files = match asks_files {
        true => filed(&list[first..], target, &|packed| measure.of(&places.errors(packed)))?,
        false => None,
    };
    Ok(Some(Contender { files, ..contender }))
}

/// Texels over the hemisphere and near the normal, with what they should hold.
struct Places {
    texels: [(Vec<Pair>, Vec<f64>); 2],
    floor_per_sr: f64,
}

impl Places {
    fn of(specimen: &StudySpecimen, context: &Context, finest: &TableSet) -> Result<Self> {
        let config = config_of(context, Basis::Chebyshev, 1);
        let plan = plan::plan(&BuildInput::new(&specimen.fields, &specimen.optics, &config))?;
        let drawn = direction_pairs(Region::Hemisphere, DRAWN);
        let steep_pairs: Vec<Pair> = drawn.iter().copied().filter(steep).collect();
        let bright = |(wi, wo): &Pair| brdf_xyz(finest, Interpolation::Cubic, *wi, *wo)[1];
        let floor_per_sr = floor_per_sr(specimen.optics.material, &drawn.iter().map(bright).collect::<Vec<_>>());
        let near = |pairs: &[Pair]| -> Result<(Vec<Pair>, Vec<f64>)> {
            let texels = Texels::of(finest, &specimen.optics, plan.filter, pairs, floor_per_sr);
            let reference = texels.reference(&specimen.fields, &specimen.optics, &plan)?;
            Ok((texels.centres, reference))
        };
        Ok(Self { texels: [near(&drawn)?, near(&steep_pairs)?], floor_per_sr })
    }

    fn errors(&self, packed: &PackedTables) -> Errors {
        let batch = |pairs: &[Pair], out: &mut [Xyz]| packed.evaluate(Interpolation::Cubic, pairs, out);
        let [hemisphere, steep] = self.texels.each_ref().map(|(pairs, reference)| {
            relative_error_quantiles(reference, &luminances(&batch, pairs), self.floor_per_sr)
        });
        Errors { hemisphere, steep }
    }
}

fn config_of(context: &Context, basis: Basis, count: usize) -> TablesConfig {
    let size = Some(context.config.equal_size);
    TablesConfig { size, count: Some(count), prefilter: Prefilter::Auto, ..context.tables_config(basis) }
}

fn build_trials(specimen: &StudySpecimen, context: &Context, refusals: &mut Vec<Refusal>) -> error::Result<Trials> {
    let made = |basis, count| {
        let built = build::build(
            &BuildInput::new(&specimen.fields, &specimen.optics, &config_of(context, basis, count)),
            &|_| (),
        );
        context.progress.advance(1);
        built.map(|(set, _)| set)
    };
    let counts = context.config.chebyshev.iter();
    let chebyshev = counts.map(|&count| made(Basis::Chebyshev, count)).collect::<error::Result<_>>()?;
    let longest = context.config.taylor.iter().copied().max().unwrap_or(0);
    let taylor = match made(Basis::Taylor, longest) {
        Ok(set) => Some(set),
        Err(error) => {
            let what = format!("taylor, float, {longest} tables at equal error");
            refusals.push(Refusal { what, message: error.to_string() });
            None
        }
    };
    Ok(Trials { chebyshev, taylor })
}

fn timed(context: &Context, candidate: &Candidate, error: f64) -> Result<Contender> {
    let &Candidate { tables, storage, .. } = candidate;
    let cut = candidate.cut();
    let packed = PackedTables::new(&cut, tables, storage);
    let pairs = context.timed_pairs();
    let time = |interpolation| {
        let batch = |pairs: &[Pair], out: &mut [Xyz]| packed.evaluate(interpolation, pairs, out);
        context.clock.on_one_thread(&batch, &pairs)
    };
    let gpu_s = context.gpu.map(|gpu| gpu.seconds_per_direction(&stored(&cut, Storage::Half))).transpose()?;
    Ok(Contender {
        tables,
        error,
        bytes: packed.bytes(),
        cubic_s: time(Interpolation::Cubic),
        bilinear_s: time(Interpolation::Bilinear),
        gpu_s,
        files: None,
    })
}
