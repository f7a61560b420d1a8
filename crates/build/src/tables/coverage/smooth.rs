//! Ranges of normalised `|w|` that change so little from texel to texel that look-ups may interpolate between them.

use half::f16;

use super::ranges::Coverage;
use super::shares::RANGE_SHARES;
use crate::tables::input::BuildInput;
use crate::tables::resolution::lobe_width;
use diffraction_brdf::direction::max_abs_w;

/// What ranges of `t` are widened by at both ends: a look-up never lies at an end, nor is a range a point.
const RANGE_PAD: f64 = 2e-3;

/// Lets the ranges of texels differ so little from one to the next that interpolating between them keeps its share of the
/// tolerance: see [`Coverage::with_smooth_ranges`].
///
/// Two texels whose ranges are `δ` apart in `|w|` answer for `|w|` that differ by it. In first order they err by
/// `x (1 - x) δ` times the difference of their derivatives, a sixth of `δ` in the mean over their distance. The power
/// of heights with this rms changes with `|w|` by about `2 (k rms)² |w|` times itself, and from texel to texel by itself
/// where the grid does not resolve a lobe, less where it does. In second order they err by `δ²/8` times the second
/// derivative, at most about `(2 k rms)²` times the power.
pub(super) fn smooth(coverage: Coverage, input: &BuildInput) -> Coverage {
    let [low_nm, high_nm] = input.wavelength_range_nm;
    let middle_nm = 2.0 / (1.0 / low_nm + 1.0 / high_nm);
    let rms_nm = input.rms_nm.max(1.0);
    let tolerance = input.tables.tolerance;
    let phase = |nm: f64| std::f64::consts::TAU / nm * rms_nm;
    let sigma_nm = input.optics.body_coherence().sigma_nm_at(middle_nm);
    let unlike = (coverage.grid.texel() / lobe_width(sigma_nm, middle_nm)).min(1.0);
    let first = 6.0 * RANGE_SHARES[0] * tolerance / (2.0 * phase(middle_nm).powi(2) * unlike);
    let second = (8.0 * RANGE_SHARES[1] * tolerance).sqrt() / (2.0 * phase(low_nm));
    coverage.with_smooth_ranges(RANGE_PAD, first.min(second) / max_abs_w(0.0))
}

impl Coverage {
    /// Widens every range by `pad` at both ends, within [0, 1], then lets neighbours differ by at most `slope` per
    /// texel in the middle, and by as much in `|w|` anywhere, again by widening; at last the ends become half floats,
    /// which is how they are stored.
    ///
    /// Between texels a look-up interpolates coefficients and ranges with the same shares `s_i`. That is the mean of
    /// the texels' polynomials at `t_i`, which lie as far up in the ranges of the texels as `t` does in the range
    /// between them: `Σ s_i t_i = t`. So what errs is the part of the polynomials' slopes that differs from texel to
    /// texel, and their second order.
    pub(super) fn with_smooth_ranges(mut self, pad: f64, slope: f64) -> Self {
        self.each_range(|low, high| [(low - pad as f32).max(0.0), (high + pad as f32).min(1.0)]);
        let texels = self.low.len();
        let slopes: Vec<f32> = (0..texels)
            .map(|index| {
                let [row, column] = [index / self.grid.size, index % self.grid.size];
                let reach = max_abs_w(self.grid.u(column).hypot(self.grid.v(row)));
                // No two ends differ by more than 1.
                (slope * max_abs_w(0.0) / reach).min(1.0) as f32
            })
            .collect();
        // Down and up once settles texels without holes; around a hole ranges spread in further rounds.
        loop {
            let down = (0..texels).fold(false, |changed, index| self.relax(index, &slopes, 1) | changed);
            let up = (0..texels).rev().fold(false, |changed, index| self.relax(index, &slopes, -1) | changed);
            if !down && !up {
                break;
            }
        }
        self.each_range(|low, high| [half_below(low), half_above(high)]);
        self
    }

    /// Changes the range of every texel covered.
    fn each_range(&mut self, changed: impl Fn(f32, f32) -> [f32; 2]) {
        for (low, high) in self.low.iter_mut().zip(&mut self.high).filter(|(low, high)| low <= high) {
            [*low, *high] = changed(*low, *high);
        }
    }

    /// Widens the range of a texel to what its neighbours in the rows and columns before it allow, or after it if
    /// `direction` is -1; whether that changed anything.
    fn relax(&mut self, index: usize, slopes: &[f32], direction: isize) -> bool {
        const BEFORE: [[isize; 2]; 4] = [[-1, -1], [-1, 0], [-1, 1], [0, -1]];
        let size = self.grid.size as isize;
        let mut changed = false;
        if self.low[index] > self.high[index] {
            return changed;
        }
        let (row, column) = (index as isize / size, index as isize % size);
        for [dr, dc] in BEFORE.map(|offset| offset.map(|step| direction * step)) {
            let (r, c) = (row + dr, column + dc);
            if !(0..size).contains(&r) || !(0..size).contains(&c) {
                continue;
            }
            let other = (r * size + c) as usize;
            if self.low[other] <= self.high[other] {
                let distance = if dr != 0 && dc != 0 { std::f32::consts::SQRT_2 } else { 1.0 };
                let step = distance * slopes[index].min(slopes[other]);
                let [low, high] = [self.low[other] + step, self.high[other] - step];
                changed |= low < self.low[index] || high > self.high[index];
                self.low[index] = self.low[index].min(low);
                self.high[index] = self.high[index].max(high);
            }
        }
        changed
    }
}

/// The next half float at or below a number in [0, 1].
fn half_below(number: f32) -> f32 {
    let half = f16::from_f32(number);
    let above = half.to_f32() > number;
    if above { f16::from_bits(half.to_bits() - 1).to_f32() } else { half.to_f32() }
}

/// The next half float at or above a number in [0, 1].
fn half_above(number: f32) -> f32 {
    let half = f16::from_f32(number);
    let below = half.to_f32() < number;
    if below { f16::from_bits(half.to_bits() + 1).to_f32() } else { half.to_f32() }
}
