//! The directions on which the errors of tables are counted: those above the luminance floor, and a few that the tables
//! show below it.
//!
//! A grating is below it nearly everywhere, and a relative error says nothing there. Directions are drawn by the thousand,
//! the tables tell in no time how bright each is, and the reference is evaluated for the first few above the floor. Light
//! that the tables miss is looked for in directions which they show below it.

use std::f64::consts::PI;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::ground::metrics::quantile_of_sorted;
use crate::ground::sampling::{NEAR_DEG, Region, direction_pairs_in, near_specular_pairs};
use crate::tables::model::TableSet;
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::material::{Material, reflectance};

/// Directions above the floor of each group in a run.
pub const DIRECTIONS: usize = 128;

/// Directions drawn for each group. Of a grating of parallel lines one in thirty is above the floor.
pub const DRAWN: usize = 1 << 14;

/// As many directions above the floor come with one below it.
pub const ABOVE_PER_BELOW: usize = 4;

/// Share of the floor up to which a direction counts as below it in the tables: one above is missed only where they show
/// less than half of its light.
const BELOW_SHARE: f64 = 0.5;

/// Share of a matt surface's luminance, one that reflects as much, up to which directions are left out of pointwise
/// errors.
pub const FLOOR_SHARE: f64 = 1e-2;

/// Share of the brightest directions' luminance up to which they are left out as well: a grating has a few orders, and
/// between them a relative error says nothing.
pub(crate) const FLOOR_SHARE_BRIGHT: f64 = 1e-3;

/// Share of the directions that are no brighter than what counts as bright.
const BRIGHT: f64 = 0.98;

type Pair = (Vec3, Vec3);

/// Luminance in 1/sr up to which directions are left out of pointwise errors: a share of what a matt surface of the
/// material's reflectance at normal incidence would show everywhere, or a smaller one of the brightest directions but
/// for one in fifty, given Y over the hemisphere: a grating sends its light into fewer than the rest, and a lobe's
/// flank a thousand times below its peak lies between orders.
pub fn floor_per_sr(material: Material, hemisphere: &[f64]) -> f64 {
    let matt = FLOOR_SHARE * reflectance(material, 1.0) / PI;
    let mut sorted = hemisphere.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let bright = if sorted.is_empty() { 0.0 } else { quantile_of_sorted(&sorted, BRIGHT) };
    // Tables of infinite values shall not hide behind an infinite floor.
    if bright.is_finite() { matt.max(FLOOR_SHARE_BRIGHT * bright) } else { matt }
}

/// What a group of directions stands for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub enum Group {
    /// A region of the hemisphere.
    Region(Region),
    /// What the scene of this name looks up.
    Scene(String),
}

/// Before a scene's name.
const SCENE: &str = "scene ";

impl std::fmt::Display for Group {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Region(region) => f.write_str(region.name()),
            Self::Scene(name) => write!(f, "{SCENE}{name}"),
        }
    }
}

impl From<Group> for String {
    fn from(group: Group) -> Self {
        group.to_string()
    }
}

impl TryFrom<String> for Group {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let region = Region::ALL.into_iter().find(|region| region.name() == text);
        let scene = || text.strip_prefix(SCENE).map(|name| Self::Scene(name.into()));
        region.map(Self::Region).or_else(scene).ok_or_else(|| format!("`{text}` is no region and no scene"))
    }
}

/// Directions to draw from, evenly spread over what a group stands for.
#[derive(Debug, Clone)]
pub struct Candidates {
    /// The group.
    pub group: Group,
    /// Pairs `(wi, wo)`.
    pub pairs: Vec<Pair>,
    /// Luminance in 1/sr up to which they do not count pointwise.
    pub floor_per_sr: f64,
}

impl Candidates {
    /// [`DRAWN`] of every region, with one floor for all: that of the hemisphere as the tables show it. `turn` chooses
    /// which: 0 for those of a run, another for others.
    pub fn of_regions(set: &TableSet, turn: usize) -> Vec<Self> {
        let near_deg = near_deg(set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max));
        let drawn = |region| drawn_pairs(region, near_deg, turn);
        let hemisphere = luminances(set, &drawn(Region::Hemisphere));
        let floor_per_sr = floor_per_sr(set.front_factor.material, &hemisphere);
        Region::ALL.into_iter().map(|r| Self { group: Group::Region(r), pairs: drawn(r), floor_per_sr }).collect()
    }

    /// Those of one scene, given some of its pairs.
    pub fn of_scene(set: &TableSet, scene: &str, pairs: Vec<Pair>) -> Self {
        let floor_per_sr = floor_per_sr(set.front_factor.material, &luminances(set, &pairs));
        Self { group: Group::Scene(scene.into()), pairs: in_turns(pairs), floor_per_sr }
    }
}

/// [`DRAWN`] pairs of a region; `near_deg` as of [`near_deg`], `turn` as of [`Candidates::of_regions`].
pub(super) fn drawn_pairs(region: Region, near_deg: f64, turn: usize) -> Vec<Pair> {
    let places = turn * DRAWN..(turn + 1) * DRAWN;
    match region {
        Region::NearSpecular => near_specular_pairs(near_deg, places),
        _ => direction_pairs_in(region, places),
    }
}

/// Degrees from the mirror direction that count as near it: as far as a lobe of this radius in (u, v) reaches, [`NEAR_DEG`] at
/// least. On the flank of a lobe that is wider than that, look-ups err most.
pub(super) fn near_deg(lobe_radius: f64) -> f64 {
    lobe_radius.min(1.0).asin().to_degrees().max(NEAR_DEG)
}

/// In an order of which any first few are spread over all of them.
fn in_turns(pairs: Vec<Pair>) -> Vec<Pair> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let mut order: Vec<(f64, Pair)> =
        pairs.into_iter().enumerate().map(|(index, pair)| ((index as f64 * GOLDEN).fract(), pair)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    order.into_iter().map(|(_, pair)| pair).collect()
}

/// One group of directions.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorGroup {
    /// What it stands for.
    pub group: Group,
    /// Directions that the tables show above the floor, which come first, and those that they show below it.
    pub counts: [usize; 2],
    /// Share of all candidates that the tables show above it.
    pub share_above: f64,
    /// Luminance in 1/sr up to which directions do not count pointwise.
    pub floor_per_sr: f64,
    /// Most of luminance in 1/sr that the reference leaves out in any of them; `None` where that is not bounded, and until it is
    /// evaluated.
    pub left_out_per_sr: Option<f64>,
}

impl ErrorGroup {
    /// Number of directions.
    pub fn len(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Whether it has none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// What share of the group's candidates each direction stands for.
    pub fn weights(&self) -> Vec<f64> {
        let shares = [self.share_above, 1.0 - self.share_above];
        let of = |part: usize| std::iter::repeat_n(shares[part] / self.counts[part].max(1) as f64, self.counts[part]);
        of(0).chain(of(1)).collect()
    }
}

/// Directions on which errors are counted, group after group.
#[derive(Debug, Clone, Default)]
pub struct ErrorDirections {
    /// The groups.
    pub groups: Vec<ErrorGroup>,
    /// The pairs of all groups in order.
    pub pairs: Vec<Pair>,
}

impl ErrorDirections {
    /// Of each group the first candidates that the tables do not show below the floor, until `count` of them are above
    /// it, or twice as many are taken; then a quarter as many that they do show below it, and one for each that is
    /// lacking: tables that show nothing are not right for it.
    pub fn drawn(set: &TableSet, candidates: Vec<Candidates>, count: usize) -> Self {
        let mut directions = Self::default();
        for Candidates { group, pairs, floor_per_sr } in candidates {
            let shown: Vec<f64> = pairs.par_iter().map(|pair| brightest(set, pair)).collect();
            let (group, pairs) = chosen(group, &pairs, &shown, floor_per_sr, count);
            directions.groups.push(group);
            directions.pairs.extend(pairs);
        }
        directions
    }

    /// Those of a run over every region.
    pub fn of_regions(set: &TableSet) -> Self {
        Self::drawn(set, Candidates::of_regions(set, 0), DIRECTIONS)
    }
}

/// [`ErrorDirections::drawn`] for one group, given what the tables show at each of its candidates, in 1/sr.
pub(super) fn chosen<P: Copy>(
    group: Group,
    candidates: &[P],
    shown: &[f64],
    floor_per_sr: f64,
    count: usize,
) -> (ErrorGroup, Vec<P>) {
    let above = candidates.iter().zip(shown).filter(|(_, shown)| **shown > BELOW_SHARE * floor_per_sr);
    let share_above = above.clone().count() as f64 / candidates.len().max(1) as f64;
    let mut surely_above = 0;
    let until_enough = above.take(2 * count).take_while(|(_, shown)| {
        let is_wanted = surely_above < count;
        surely_above += usize::from(**shown > floor_per_sr);
        is_wanted
    });
    let mut taken: Vec<P> = until_enough.map(|(candidate, _)| *candidate).collect();
    let below = candidates.iter().zip(shown).filter(|(_, shown)| **shown <= BELOW_SHARE * floor_per_sr);
    let lacking = count - surely_above.min(count);
    let wanted_below = count.div_ceil(ABOVE_PER_BELOW) + lacking;
    let above_count = taken.len();
    taken.extend(below.map(|(candidate, _)| *candidate).take(wanted_below));
    let counts = [above_count, taken.len() - above_count];
    (ErrorGroup { group, counts, share_above, floor_per_sr, left_out_per_sr: None }, taken)
}

/// The larger luminance of both look-ups; what is no number shall be seen, and counts as infinite.
fn brightest(set: &TableSet, &(wi, wo): &Pair) -> f64 {
    let [a, b] = [Interpolation::Cubic, Interpolation::Bilinear].map(|look_up| brdf_xyz(set, look_up, wi, wo)[1]);
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}

fn luminances(set: &TableSet, pairs: &[Pair]) -> Vec<f64> {
    pairs.par_iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Cubic, wi, wo)[1]).collect()
}
