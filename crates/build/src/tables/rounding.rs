//! How coarsely a set's numbers may be stored: bits that the tolerance does not ask for, and the number format.
//!
//! A table of high order is small beside the first; stored with all bits of its format it keeps digits that nobody asked
//! for and that no compressor removes. [`to_tolerance`] rounds each number to a multiple of a power of two that the
//! tolerance allows at its texel. [`choose`] then decides whether 16-bit floats keep what is left.

use std::path::Path;

use ndarray::Array3;
use rayon::prelude::*;

use super::grid::Grid;
use super::model::{Basis, Rounding, Storage, TableSet};
use super::order::{FLOOR_SHARE, PLACES_TESTED, quantile, spread_texels};
use super::plan::RIM_TEXELS;
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::{Xyz, max_abs_w};
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::{Interpolation, window_power};
use diffraction_brdf::spectral::{SpectralTables, TABLES_PER_IMAGE};
use diffraction_brdf::storage::{StoredTables, round_to_half, write_tables};
use diffraction_brdf::table_set::Restriction;

/// Share of the tolerance that the bits left out may take at any `|w|` of a texel, all tables together and in the worst
/// case. One place in twenty errs by 0.15 of the tolerance or more, beside the 0.7 of [`STORED_SHARE`] next to nothing.
pub(crate) const ROUNDED_SHARE: f64 = 0.25;

/// Share of the tolerance that storing as a whole may take in 95 % of places: what basis and wavelength step, with a
/// half each, leave of it where independent errors add as squares, `sqrt(1 - 2/4)`.
pub(crate) const STORED_SHARE: f64 = 0.7;

/// Least that halves change one number in twenty by, relatively, and values about as much. Rounded to nearest,
/// `e = 2^-11 U / m` with `U` even over [0, 1] and the significand `m` over [1, 2) with the density `1 / (m ln 2)`; hence
/// `P(e > 2^-11 y) = (y - 1 - ln y) / ln 2` for `y > 1/2`, which is 0.05 at y = 0.757.
pub(crate) const HALF_P95: f64 = 0.757 / 2048.0;

/// Places at which a texel's least value is looked for: two for each polynomial, and no more than these.
const PLACES: [usize; 2] = [8, 32];

/// Lowest of them, as a share of the texel's range: series in powers of `w` are over `w²`.
const PLACE_LEAST: f64 = PLACES_TESTED[0];

/// Texels of each group on which rounding is measured; of the patches of the cross term all.
const TEXELS: usize = 4_096;

/// Luminance in 1/sr, reflectance and geometry left out, below which nothing is to be seen.
const FLOOR_PER_SR: f64 = 1e-6;

/// Tables as rounding sees them: which numbers there are, and what they add up to.
pub trait Stack: Clone + Sync {
    /// Which expansion in `w`.
    fn basis(&self) -> Basis;
    /// Number of tables.
    fn count(&self) -> usize;
    /// Whether a number stands for itself, and not for X, Y and Z.
    fn is_grey(&self) -> bool;
    /// The image that holds a table, and the channel in which it holds one of X, Y and Z.
    fn place(&self, table: usize, channel: usize) -> [usize; 2];
    /// The tables' images, of three channels each.
    fn images(&self) -> &[Array3<f32>];
    /// The same to be changed.
    fn images_mut(&mut self) -> &mut [Array3<f32>];
    /// Texels along u and v of the whole grid.
    fn size(&self) -> usize;
    /// What they can answer for; `None` for everything.
    fn restriction(&self) -> Option<&Restriction>;
    /// Images of the cross term's patches, and half their side.
    fn patches(&self) -> (&[Array3<f32>], f64);
    /// The images to be changed.
    fn patches_mut(&mut self) -> &mut [Array3<f32>];
    /// The window's power at `q` in 1/sr, by linear look-ups.
    fn power(&self, q: [f64; 3]) -> Xyz;
}

impl Stack for TableSet {
    fn basis(&self) -> Basis {
        self.basis
    }

    fn count(&self) -> usize {
        self.tables.len()
    }

    fn is_grey(&self) -> bool {
        false
    }

    fn place(&self, table: usize, channel: usize) -> [usize; 2] {
        [table, channel]
    }

    fn images(&self) -> &[Array3<f32>] {
        &self.tables
    }

    fn images_mut(&mut self) -> &mut [Array3<f32>] {
        &mut self.tables
    }

    fn size(&self) -> usize {
        self.size()
    }

    fn restriction(&self) -> Option<&Restriction> {
        self.restriction.as_ref()
    }

    fn patches(&self) -> (&[Array3<f32>], f64) {
        self.lobe.as_ref().map_or((&[], 0.0), |lobe| (&lobe.cross, lobe.radius_max))
    }

    fn patches_mut(&mut self) -> &mut [Array3<f32>] {
        self.lobe.as_mut().map_or(&mut [], |lobe| &mut lobe.cross)
    }

    fn power(&self, q: [f64; 3]) -> Xyz {
        window_power(self, Interpolation::Bilinear, q)
    }
}

impl Stack for SpectralTables {
    fn basis(&self) -> Basis {
        Basis::Chebyshev
    }

    fn count(&self) -> usize {
        self.count
    }

    fn is_grey(&self) -> bool {
        true
    }

    fn place(&self, table: usize, _: usize) -> [usize; 2] {
        [table / TABLES_PER_IMAGE, table % TABLES_PER_IMAGE]
    }

    fn images(&self) -> &[Array3<f32>] {
        &self.images
    }

    fn images_mut(&mut self) -> &mut [Array3<f32>] {
        &mut self.images
    }

    fn size(&self) -> usize {
        self.size()
    }

    fn restriction(&self) -> Option<&Restriction> {
        None
    }

    fn patches(&self) -> (&[Array3<f32>], f64) {
        let cross = self.lobe.as_ref().and_then(|lobe| lobe.cross.as_ref());
        cross.map_or((&[], 0.0), |cross| (&cross.images, cross.radius_max))
    }

    fn patches_mut(&mut self) -> &mut [Array3<f32>] {
        let cross = self.lobe.as_mut().and_then(|lobe| lobe.cross.as_mut());
        cross.map_or(&mut [], |cross| &mut cross.images)
    }

    fn power(&self, q: [f64; 3]) -> Xyz {
        [self.window_power(Interpolation::Bilinear, q); 3]
    }
}

/// A set ready to be written.
#[derive(Debug, Clone)]
pub struct Chosen<T = TableSet> {
    /// Its numbers without the bits that the tolerance leaves out.
    pub set: T,
    /// The format asked for, or the one that was found sufficient.
    pub storage: Storage,
    /// What storing does.
    pub rounding: Rounding,
}

/// Rounds a set to its tolerance and measures what number formats do to it. Where none is asked for, halves are taken if
/// they keep 0.7 of the tolerance, else floats. Texels within `lobe_radius` in (u, v) are looked at apart.
pub fn choose<T: Stack>(built: &T, asked: Option<Storage>, tolerance: f64, lobe_radius: f64) -> Chosen<T> {
    let set = to_tolerance(built, tolerance);
    let places = Places::of(built, lobe_radius);
    let rounding = Rounding {
        half: places.change(built, &to_halves(&set)),
        float: places.change(built, &set),
        allowed: STORED_SHARE * tolerance,
    };
    let storage = asked.unwrap_or(if rounding.half <= rounding.allowed { Storage::Half } else { Storage::Float });
    Chosen { set, storage, rounding }
}

impl Chosen {
    /// Writes the set into an existing folder, and records what that did to its values.
    ///
    /// # Errors
    /// As [`write_tables`].
    pub fn write(&self, folder: &Path) -> Result<StoredTables> {
        let stored = write_tables(folder, &self.set, self.storage)?;
        Ok(StoredTables { rounding: Some(self.rounding), ..stored })
    }
}

/// The format that is likely to be chosen, before there are tables.
pub fn expected(asked: Option<Storage>, tolerance: f64) -> Storage {
    asked.unwrap_or(if HALF_P95 <= STORED_SHARE * tolerance { Storage::Half } else { Storage::Float })
}

/// The set as halves give it back.
fn to_halves<T: Stack>(set: &T) -> T {
    let mut set = set.clone();
    set.images_mut().iter_mut().for_each(round_to_half);
    set.patches_mut().iter_mut().for_each(round_to_half);
    set
}

/// The set with every number of its tables rounded to a multiple of a power of two, as coarse as the tolerance allows.
///
/// At a texel and `t`, tables `a_n` rounded by `e_n` shift the value `Σ a_n b_n` by at most `Σ |e_n b_n|`. This is
/// kept below a quarter of the tolerance times the value at every `t` of the texel: Y times Y itself, X and Z
/// times X + Y + Z, for it is their share in the sum that a colour shows. Chebyshev polynomials are at most 1, so all of
/// a texel's tables have one step; the powers of `w` have steps that grow as powers fall, each so that it costs the same
/// share where it hurts most. Linear look-ups between texels keep the bound, being means. The lobe stays as it is: its
/// files are small.
pub fn to_tolerance<T: Stack>(set: &T, tolerance: f64) -> T {
    let mut rounded = set.clone();
    let Some((_, columns, _)) = set.images().first().map(Array3::dim) else { return rounded };
    let steps = Steps::of(set, ROUNDED_SHARE * tolerance);
    let (count, is_grey) = (set.count(), set.is_grey());
    // Of a grey texel one channel is its number; the others are not looked at.
    let place = |n: usize, c: usize| set.place(n, c);
    let mut rows: Vec<Vec<&mut [f32]>> = Vec::new();
    for image in rounded.images_mut() {
        let numbers = image.as_slice_mut().expect("tables are built in row order");
        for (row, line) in numbers.chunks_exact_mut(3 * columns).enumerate() {
            if row == rows.len() {
                rows.push(Vec::new());
            }
            rows[row].push(line);
        }
    }
    rows.par_iter_mut().enumerate().for_each(|(row, lines)| {
        let mut texel = vec![[0.0; 3]; count];
        let mut scratch = Scratch::new(count);
        for column in 0..columns {
            let number = |lines: &[&mut [f32]], n: usize, c: usize| {
                let [image, channel] = place(n, c);
                f64::from(lines[image][3 * column + channel])
            };
            for (n, numbers) in texel.iter_mut().enumerate() {
                *numbers = std::array::from_fn(|c| number(lines, n, c));
            }
            if texel.iter().flatten().all(|number| *number == 0.0) {
                continue;
            }
            steps.round(&mut texel, [row, column], is_grey, &mut scratch);
            for (n, numbers) in texel.iter().enumerate() {
                for c in if is_grey { GREY } else { 0..3 } {
                    let [image, channel] = place(n, c);
                    lines[image][3 * column + channel] = numbers[c] as f32;
                }
            }
        }
    });
    rounded
}

/// The channel that is looked at where all three are the same.
const GREY: std::ops::Range<usize> = 1..2;

/// What the steps of a set's texels depend on.
struct Steps {
    basis: Basis,
    grid: Grid,
    /// Relative change allowed.
    allowed: f64,
    /// Values of the basis at each place; powers of the share of the reach.
    at_places: Vec<Vec<f64>>,
}

impl Steps {
    fn of(set: &impl Stack, allowed: f64) -> Self {
        let count = set.count();
        let places = (2 * count).clamp(PLACES[0], PLACES[1]);
        let place = |k: usize| {
            let x = (std::f64::consts::PI * k as f64 / (places - 1) as f64).cos();
            PLACE_LEAST + (1.0 - PLACE_LEAST) * 0.5 * (1.0 + x)
        };
        let at_places = (0..places).map(|k| basis_values(set.basis(), count, place(k))).collect();
        Self { basis: set.basis(), grid: Grid { size: set.size(), half_width: 2.0 }, allowed, at_places }
    }

    /// Rounds the numbers of the texel in this row and column, `[table][channel]`.
    fn round(&self, texel: &mut [Xyz], at: [usize; 2], is_grey: bool, scratch: &mut Scratch) {
        self.set_magnitudes(at, scratch);
        let Scratch { powers, magnitudes, terms, limits: [luminance, sum], trial } = scratch;
        let mut limits = |of: fn(&Xyz) -> f64, limits: &mut Vec<f64>| {
            terms.iter_mut().zip(&*texel).zip(&*powers).for_each(|((term, xyz), power)| *term = of(xyz) * power);
            self.limits(terms, limits)
        };
        let kept = [limits(|xyz| xyz[1], luminance), !is_grey && limits(|xyz| xyz.iter().sum(), sum)];
        for c in if is_grey { GREY } else { 0..3 } {
            let limits = if c == 1 { &*luminance } else { &*sum };
            // What can vanish keeps all its digits.
            let vanishes = if c == 1 { !kept[0] } else { !kept[1] };
            trial.numbers.iter_mut().zip(&*texel).for_each(|(number, xyz)| *number = xyz[c]);
            if !vanishes && trial.round(magnitudes, limits) {
                texel.iter_mut().zip(&trial.rounded).for_each(|(xyz, number)| xyz[c] = *number);
            }
        }
    }

    /// Powers of the largest `|w|` at which a look-up may read a texel, and how large the basis is at each place.
    /// Polynomials in shares of a range have neither, and are at most 1 wherever they are looked up.
    fn set_magnitudes(&self, [row, column]: [usize; 2], scratch: &mut Scratch) {
        if self.basis == Basis::Chebyshev {
            return;
        }
        let radius = self.grid.u(column).hypot(self.grid.v(row));
        let reach = max_abs_w((radius - RIM_TEXELS * self.grid.texel()).max(0.0));
        scratch.powers.iter_mut().enumerate().for_each(|(n, power)| *power = reach.powi(n as i32));
        let powers = &scratch.powers;
        scratch.magnitudes.clear();
        scratch.magnitudes.extend(self.at_places.iter().flat_map(|basis| basis.iter().zip(powers).map(|(b, p)| b * p)));
    }

    /// What rounding may shift a texel's values by, given its terms: at each place, or for polynomials anywhere. False
    /// where what it is relative to is not above zero everywhere.
    fn limits(&self, terms: &[f64], limits: &mut Vec<f64>) -> bool {
        let value = |basis: &Vec<f64>| terms.iter().zip(basis).map(|(term, b)| term * b).sum::<f64>();
        limits.clear();
        limits.extend(self.at_places.iter().map(|basis| self.allowed * value(basis)));
        let kept = limits.iter().all(|limit| *limit > 0.0 && limit.is_finite());
        if self.basis == Basis::Chebyshev {
            let least = limits.iter().copied().fold(f64::INFINITY, f64::min);
            limits.clear();
            limits.push(least);
        }
        kept
    }
}

/// Working memory of one thread.
struct Scratch {
    powers: Vec<f64>,
    /// Sizes of the basis functions, `[limit][table]`.
    magnitudes: Vec<f64>,
    terms: Vec<f64>,
    /// Of the luminance and of the sum of the channels.
    limits: [Vec<f64>; 2],
    trial: Trial,
}

impl Scratch {
    fn new(count: usize) -> Self {
        let zeros = || vec![0.0; count];
        Self {
            powers: vec![1.0; count],
            magnitudes: vec![1.0; count],
            terms: zeros(),
            limits: [Vec::new(), Vec::new()],
            trial: Trial { numbers: zeros(), rounded: zeros(), errors: zeros(), steps: zeros() },
        }
    }
}

/// The numbers of one channel of a texel, and what rounding makes of them.
struct Trial {
    numbers: Vec<f64>,
    rounded: Vec<f64>,
    errors: Vec<f64>,
    steps: Vec<f64>,
}

/// Halvings of the steps that are tried: with as many, no bit of a float is left out.
const HALVINGS: i32 = 64;

/// Largest step: any number becomes zero.
const STEP_MAX: f64 = 1e30;

impl Trial {
    /// Rounds to multiples of the largest steps whose errors keep `Σ errors[n] magnitudes[k][n] <= limits[k]`; false where
    /// there are none.
    fn round(&mut self, magnitudes: &[f64], limits: &[f64]) -> bool {
        let Self { numbers, rounded, errors, steps } = self;
        let count = numbers.len();
        for (n, step) in steps.iter_mut().enumerate() {
            // Twice what one table alone may err.
            let alone = limits.iter().zip(magnitudes[n..].iter().step_by(count)).map(|(limit, size)| limit / size);
            *step = power_of_two_below((2.0 * alone.fold(f64::INFINITY, f64::min)).clamp(f64::MIN_POSITIVE, STEP_MAX));
        }
        for _ in 0..HALVINGS {
            for (n, step) in steps.iter_mut().enumerate() {
                rounded[n] = to_multiple(numbers[n], *step);
                errors[n] = (numbers[n] - rounded[n]).abs();
                *step *= 0.5;
            }
            let shift = |sizes: &[f64]| errors.iter().zip(sizes).map(|(error, size)| error * size).sum::<f64>();
            if magnitudes.chunks_exact(count).zip(limits).all(|(sizes, limit)| shift(sizes) <= *limit) {
                return true;
            }
        }
        false
    }
}

/// The largest power of two that is no larger than a normal number above zero: its sign and significand cleared.
fn power_of_two_below(number: f64) -> f64 {
    f64::from_bits(number.to_bits() & (0x7ff << 52))
}

/// Added to a smaller number and taken away again, it leaves a whole one, the nearest: doubles of this size are whole.
/// Much faster than the call that processors without an instruction for it take.
const ROUNDING: f64 = 1.5 * (1u64 << 52) as f64;

/// The multiple of a power of two that is nearest to a 32-bit number; the number where that has fewer bits.
fn to_multiple(number: f64, step: f64) -> f64 {
    let steps = number / step;
    if steps.abs() < f64::from(1 << 24) { (steps + ROUNDING - ROUNDING) * step } else { number }
}

/// Values of the basis functions at a share of a texel's range.
fn basis_values(basis: Basis, count: usize, share: f64) -> Vec<f64> {
    match basis {
        Basis::Chebyshev => chebyshev::shifted_values(count, share),
        Basis::Taylor => (0..count).map(|n| share.powi(n as i32)).collect(),
    }
}

/// Texels `[row, column]` at which rounding is measured, in three groups, and the luminance below which nothing is.
struct Places {
    groups: [Vec<[usize; 2]>; 3],
    floor_per_sr: f64,
}

impl Places {
    fn of(set: &impl Stack, lobe_radius: f64) -> Self {
        let grid = Grid { size: set.size(), half_width: 2.0 };
        let Some((rows, columns, _)) = set.images().first().map(Array3::dim) else {
            return Self { groups: [const { Vec::new() }; 3], floor_per_sr: 0.0 };
        };
        let first = set.restriction().map_or([0; 2], |restriction| restriction.first);
        let covers = |[row, column]: [usize; 2]| {
            set.restriction().is_none_or(|restriction| restriction.range[[row, column, 2]] != 0.0)
        };
        let distance = |[row, column]: [usize; 2]| grid.u(column + first[1]).hypot(grid.v(row + first[0]));
        let inside: Vec<[usize; 2]> = (0..rows * columns)
            .map(|index| [index / columns, index % columns])
            .filter(|&at| distance(at) < 2.0 && covers(at))
            .collect();
        let middle_place = PLACES_TESTED[PLACES_TESTED.len() / 2];
        let luminance: Vec<f64> = inside.par_iter().map(|&at| value(set, at, middle_place)[1]).collect();
        // A grating is dark between its orders, and there a relative error says nothing.
        let floor = FLOOR_PER_SR.max(FLOOR_SHARE * luminance.iter().copied().fold(0.0, f64::max));
        let bright = inside.iter().zip(&luminance).filter(|(_, y)| **y > floor).map(|(at, _)| *at).collect();
        let near = 0.5 * lobe_radius;
        let middle = inside.iter().copied().filter(|&at| distance(at) < near).collect();
        let at = |[u, v]: [f64; 2]| -> Option<[usize; 2]> {
            let of = |x: f64, first: usize, count: usize| {
                let index = ((x + 2.0) / grid.texel()).round() - first as f64;
                (index >= 0.0 && index < count as f64).then_some(index as usize)
            };
            Some([of(-v, first[0], rows)?, of(u, first[1], columns)?])
        };
        let spread = spread_texels(TEXELS).into_iter().filter_map(at).filter(|&at| distance(at) < 2.0 && covers(at));
        Self { groups: [spread.collect(), drawn(bright), drawn(middle)], floor_per_sr: floor }
    }

    /// Largest of the groups' 95th percentiles of what another set's values are off, and of the cross term's patches.
    fn change<T: Stack>(&self, exact: &T, other: &T) -> f64 {
        let floor = self.floor_per_sr;
        let changes = |texels: &Vec<[usize; 2]>| {
            let at = |&at: &[usize; 2]| {
                PLACES_TESTED
                    .into_iter()
                    .filter_map(move |place| change(value(exact, at, place), value(other, at, place), floor))
            };
            texels.par_iter().flat_map_iter(at).collect()
        };
        let of_cross = cross_changes(exact, other, floor);
        self.groups.iter().map(changes).chain([of_cross]).map(largest_quantile).fold(0.0, f64::max)
    }
}

/// At most [`TEXELS`] of a list, evenly.
fn drawn(texels: Vec<[usize; 2]>) -> Vec<[usize; 2]> {
    let count = texels.len().min(TEXELS);
    (0..count).map(|index| texels[index * texels.len() / count]).collect()
}

/// The sum of a set's tables at a texel and a share of its range, in 1/sr.
fn value(set: &impl Stack, [row, column]: [usize; 2], share: f64) -> Xyz {
    let mut sum = [0.0; 3];
    let (t, front) = match set.basis() {
        Basis::Chebyshev => (share, 1.0),
        Basis::Taylor => {
            let grid = Grid { size: set.size(), half_width: 2.0 };
            let w = share * max_abs_w(grid.u(column).hypot(grid.v(row)));
            (w, 1.0 / (w * w))
        }
    };
    for (n, b) in basis_values(set.basis(), set.count(), t).into_iter().enumerate() {
        for (c, sum) in sum.iter_mut().enumerate() {
            let [image, channel] = set.place(n, c);
            *sum += front * b * f64::from(set.images()[image][[row, column, channel]]);
        }
    }
    sum
}

/// Relative changes of Y, and of X and Z as shares of X + Y + Z; `None` below the floor.
fn change(exact: Xyz, other: Xyz, floor_per_sr: f64) -> Option<Xyz> {
    let sum: f64 = exact.iter().sum();
    let relative = |c: usize| (other[c] - exact[c]).abs() / if c == 1 { exact[1] } else { sum };
    (exact[1] > floor_per_sr && sum > 0.0).then(|| std::array::from_fn(relative))
}

/// The 95th percentile of the channel that changes most.
fn largest_quantile(changes: Vec<Xyz>) -> f64 {
    (0..3).map(|c| quantile(changes.iter().map(|change| change[c]).collect())).fold(0.0, f64::max)
}

/// Changes of the whole value at the texels of the cross term's patches.
fn cross_changes<T: Stack>(exact: &T, other: &T, floor_per_sr: f64) -> Vec<Xyz> {
    let (patches, radius_max) = exact.patches();
    let Some((size, _, _)) = patches.first().map(Array3::dim) else { return Vec::new() };
    let grid = Grid { size, half_width: radius_max };
    let texels = (0..grid.size * grid.size).into_par_iter().map(|index| [index / grid.size, index % grid.size]);
    let at = |[row, column]: [usize; 2]| {
        let (u, v) = (grid.u(column), grid.v(row));
        let reach = max_abs_w(u.hypot(v));
        PLACES_TESTED.into_iter().filter_map(move |place| {
            let [exact, other] = [exact, other].map(|set| set.power([u, v, -place * reach]));
            change(exact, other, floor_per_sr)
        })
    };
    texels.flat_map_iter(at).collect()
}

#[cfg(test)]
#[path = "rounding_tests.rs"]
mod tests;
