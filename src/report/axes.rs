//! Axes of plots: where values lie between two places, round values to mark, and the lines and numbers drawn there.

use crate::report::numbers::superscript;
use crate::report::svg::{at, escape, ticks};

/// An axis from one place to another; values beyond its range stand at its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Smallest and largest value; their decimal logarithms, whole numbers, where the axis is logarithmic.
    range: [f64; 2],
    is_logarithmic: bool,
    /// Places of the two in SVG units.
    ends: [f64; 2],
}

/// A value to mark, and what is written there.
pub(crate) type Tick = (f64, String);

impl Axis {
    /// An even axis.
    pub fn linear(range: [f64; 2], ends: [f64; 2]) -> Self {
        Self { range, is_logarithmic: false, ends }
    }

    /// A logarithmic axis over the whole decades around positive values, one decade at least; at most `decades_max` of
    /// them, the uninteresting end being the small one.
    pub fn logarithmic([low, high]: [f64; 2], decades_max: usize, ends: [f64; 2]) -> Self {
        let last = high.log10().ceil();
        let first = low.log10().floor().min(last - 1.0).max(last - decades_max as f64);
        Self { range: [first, last], is_logarithmic: true, ends }
    }

    /// The place of a value.
    pub fn at(&self, value: f64) -> f64 {
        let value = if self.is_logarithmic { value.log10() } else { value };
        let [low, high] = self.range;
        let share = ((value - low) / (high - low)).clamp(0.0, 1.0);
        self.ends[0] + share * (self.ends[1] - self.ends[0])
    }

    /// Round values of a linear axis, at most `wanted` steps apart.
    pub fn ticks(&self, wanted: usize) -> Vec<Tick> {
        ticks(self.range[0], self.range[1], wanted)
    }

    /// The decades of a logarithmic axis; so many that none touches its neighbour have a label, counted from the last.
    pub fn decades(&self, labels_max: usize, label: impl Fn(i32) -> String) -> Vec<Tick> {
        let [first, last] = self.range.map(|power| power as i32);
        let every = ((last - first) as usize).div_ceil(labels_max.max(1)).max(1) as i32;
        let labelled = |power| if (last - power) % every == 0 { label(power) } else { String::new() };
        (first..=last).map(|power| (10f64.powi(power), labelled(power))).collect()
    }
}

/// Round values from `low` to `high` for an axis, in units of a power of ten where their digits would not fit, and what its title then
/// says of them.
pub(crate) fn ticks_in_powers([low, high]: [f64; 2], wanted: usize) -> (Vec<Tick>, String) {
    let exponent = high.max(-low).log10().floor() as i32;
    let power = if (-2..3).contains(&exponent) { 0 } else { exponent };
    let unit = 10f64.powi(power);
    let in_units = ticks(low / unit, high / unit, wanted).into_iter();
    let note = if power == 0 { String::new() } else { format!(" (values × 10{})", superscript(power)) };
    (in_units.map(|(value, text)| (value * unit, text)).collect(), note)
}

/// Upright lines of a class over the whole height at the ticks of an axis that runs across, numbers below them.
pub(crate) fn upright_lines(x: &Axis, ticks: &[Tick], [top, bottom]: [f64; 2], class: &str) -> String {
    ticks.iter().map(|(value, text)| upright(at(x.at(*value)), [top, bottom], bottom, class, text)).collect()
}

/// Short marks below an axis that runs across, and their numbers.
pub(crate) fn marks_below(x: &Axis, ticks: &[Tick], bottom: f64) -> String {
    ticks.iter().map(|(value, text)| upright(at(x.at(*value)), [bottom, bottom + 4.0], bottom, "tick", text)).collect()
}

fn upright(x: String, [from, to]: [f64; 2], bottom: f64, class: &str, text: &str) -> String {
    let line = format!(r#"<path class="{class}" d="M{x} {}V{}"/>"#, at(from), at(to));
    line + &label(text, &x, bottom + 17.0, "middle")
}

/// Level lines of a class over the whole width at the ticks of an axis that runs up, numbers left of them.
pub(crate) fn level_lines(y: &Axis, ticks: &[Tick], [left, right]: [f64; 2], class: &str) -> String {
    let level = |(value, text): &Tick| {
        let place = y.at(*value);
        let line = format!(r#"<path class="{class}" d="M{} {}H{}"/>"#, at(left), at(place), at(right));
        line + &label(text, &at(left - 6.0), place + 4.0, "end")
    };
    ticks.iter().map(level).collect()
}

/// What an axis holds, below its numbers.
pub(crate) fn title_below(text: &str, [left, right]: [f64; 2], bottom: f64) -> String {
    label(text, &at(0.5 * (left + right)), bottom + 34.0, "middle")
}

fn label(text: &str, x: &str, y: f64, anchor: &str) -> String {
    if text.is_empty() {
        return String::new();
    }
    format!(r#"<text x="{x}" y="{}" text-anchor="{anchor}">{}</text>"#, at(y), escape(text))
}

/// A line through points, which are values of both axes; nothing for none.
pub(crate) fn polyline(points: impl Iterator<Item = (f64, f64)>, x: &Axis, y: &Axis, style: &str) -> String {
    let places: Vec<String> = points.map(|(a, b)| format!("{} {}", at(x.at(a)), at(y.at(b)))).collect();
    if places.is_empty() {
        return String::new();
    }
    format!(r#"<path style="fill:none;{style}" d="M{}"/>"#, places.join("L"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_are_evenly_apart_and_hold_the_values() {
        let axis = Axis::logarithmic([3e-4, 0.2], 12, [0.0, 400.0]);
        let labels = axis.decades(3, |power| power.to_string());
        assert_eq!(labels.iter().map(|tick| tick.1.as_str()).collect::<Vec<_>>(), ["-4", "", "-2", "", "0"]);
        for (index, (value, _)) in labels.iter().enumerate() {
            assert!((axis.at(*value) - 100.0 * index as f64).abs() < 1e-9);
        }
        assert_eq!((axis.at(1e-9), axis.at(1e9)), (0.0, 400.0), "the ends hold what is beyond");
        let single = Axis::logarithmic([1.0, 1.0], 12, [0.0, 1.0]);
        assert_eq!(single.decades(9, |_| String::new()).len(), 2);
        assert_eq!(Axis::logarithmic([1e-30, 1.0], 12, [0.0, 1.0]).decades(99, |_| String::new()).len(), 13);
    }
}
