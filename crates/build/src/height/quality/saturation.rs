//! Heights cut off at the end of the instrument's range.

use super::finding::{Fault, Finding};
use crate::height::HeightField;

/// Least share of samples at an extreme that is told: as much of the surface is replaced by a plane.
const SHARE_MIN: f64 = 1e-3;

/// Fewest of them.
const SAMPLES_MIN: usize = 16;

/// Part of the range next to the extreme whose heights are compared with it.
const NEIGHBOURHOOD: f64 = 0.05;

/// How many times as many samples a cut-off extreme has as any other height next to it: of surfaces rounded to few numbers neighbours
/// have alike many, of sinusoids at most half as many.
const PILE_MIN: usize = 4;

/// A surface that is cut off has heights up to the cut. Where one extreme has more than this times as many samples as all
/// heights next to it, it is a flat piece with walls.
const CLIFF: usize = 30;

/// Share of samples at both extremes together from which on a surface is one of two levels.
const TWO_LEVELS: f64 = 0.5;

/// Tells cuts of a thousandth of all samples and more.
pub(super) fn check(read: &HeightField, lost: &[bool]) -> Option<Finding> {
    let rows = read.heights_nm.rows();
    let mut sorted: Vec<f64> =
        rows.into_iter().zip(lost).filter(|(_, lost)| !**lost).flat_map(|(row, _)| row.to_vec()).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let lowest = pile(sorted.iter().copied());
    let highest = pile(sorted.iter().rev().copied());
    if (lowest.count + highest.count) as f64 > TWO_LEVELS * sorted.len() as f64 && lowest.count.min(highest.count) > 1 {
        return None;
    }
    let is_cut = |pile: &Pile| {
        pile.count >= SAMPLES_MIN
            && pile.count as f64 >= SHARE_MIN * sorted.len() as f64
            && pile.count > PILE_MIN * pile.next_largest
            && pile.count < CLIFF * pile.next_all
    };
    let (pile, end) = [(lowest, "lowest"), (highest, "highest")].into_iter().find(|(pile, _)| is_cut(pile))?;
    let percent = 100.0 * pile.count as f64 / sorted.len() as f64;
    Some(Finding {
        fault: Fault::Saturation,
        in_short: format!("{percent:.1} % of the heights are cut off"),
        sentence: format!(
            "{percent:.1} % of the samples are at the {end} height, {:.4} nm, where heights next to it are rare: the range of the instrument or \
             of the file cut the surface off, and what is missing cannot be mended. Scan again with a larger z range, or export as \
             floating-point numbers.",
            pile.height_nm
        ),
        remedy: None,
    })
}

/// Samples at one end of the range, and next to it.
struct Pile {
    height_nm: f64,
    count: usize,
    /// Most samples of one height next to it.
    next_largest: usize,
    /// Samples of all heights next to it.
    next_all: usize,
}

/// The samples at the beginning of heights in order, seen from one end.
fn pile(ordered: impl DoubleEndedIterator<Item = f64> + Clone) -> Pile {
    let (Some(first), Some(last)) = (ordered.clone().next(), ordered.clone().next_back()) else {
        return Pile { height_nm: f64::NAN, count: 0, next_largest: 0, next_all: 0 };
    };
    let count = ordered.clone().take_while(|height| *height == first).count();
    let reach = NEIGHBOURHOOD * (last - first).abs();
    let mut pile = Pile { height_nm: first, count, next_largest: 0, next_all: 0 };
    let (mut height_nm, mut copies) = (f64::NAN, 0);
    for height in ordered.skip(count).take_while(|height| (height - first).abs() <= reach) {
        copies = if height == height_nm { copies + 1 } else { 1 };
        height_nm = height;
        pile.next_largest = pile.next_largest.max(copies);
        pile.next_all += 1;
    }
    pile
}
