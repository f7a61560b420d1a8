//! Blobs: spikes and pieces of dust that stand far above (or below) everything else.

use ndarray::Array2;

use super::robust::quantile;

/// Share of samples on each side that is left out of the range that a blob is measured against: larger blobs are structure.
const TAIL_SHARE: f64 = 0.01;

/// How far beyond that range a blob's top lies, in its widths. A normal surface would have to deviate by 14 standard
/// deviations; of eight real scans that people took for good, the dustiest has 1.65.
const RISE_MIN: f64 = 2.5;

/// How far beyond the range the flanks of a blob reach, in its widths.
const FLANK: f64 = 0.1;

/// What stands out of a scan.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Blobs {
    /// Number of connected pieces.
    pub count: usize,
    /// Samples of all of them, flanks included.
    pub samples: Vec<[usize; 2]>,
    /// Samples of the largest.
    pub largest: usize,
    /// Row and column of the sample that lies farthest out.
    pub farthest: [usize; 2],
    /// Highest minus lowest height in nm of the whole scan...
    pub range_nm: f64,
    /// ...and of the rest.
    pub rest_nm: f64,
}

/// The blobs of levelled heights.
pub(crate) fn blobs(levelled: &Array2<f64>) -> Blobs {
    let mut values: Vec<f64> = levelled.iter().copied().collect();
    let [low, high] = [TAIL_SHARE, 1.0 - TAIL_SHARE].map(|share| quantile(&mut values, share));
    let width = high - low;
    // By how many widths a height lies outside.
    let beyond = |height: f64| (height - high).max(low - height) / width;
    let is_top = |height: f64| width > 0.0 && beyond(height) > RISE_MIN;
    let mut blobs = Blobs::default();
    let mut seen = Array2::from_elem(levelled.dim(), false);
    let mut farthest = 0.0;
    for (place, &height) in levelled.indexed_iter() {
        if seen[[place.0, place.1]] || !is_top(height) {
            continue;
        }
        let piece = piece(&mut seen, [place.0, place.1], |place| beyond(levelled[place]) > FLANK);
        for &place in &piece {
            if beyond(levelled[place]) > farthest {
                farthest = beyond(levelled[place]);
                blobs.farthest = place;
            }
        }
        blobs.count += 1;
        blobs.largest = blobs.largest.max(piece.len());
        blobs.samples.extend(piece);
    }
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        high - low
    };
    blobs.range_nm = range(&mut levelled.iter().copied());
    let rest = levelled.indexed_iter().filter(|&((row, column), _)| !seen[[row, column]]);
    blobs.rest_nm = range(&mut rest.map(|(_, height)| *height));
    blobs
}

/// All samples that hang together with one by their sides or corners and belong to a blob; marks them.
fn piece(seen: &mut Array2<bool>, start: [usize; 2], belongs: impl Fn([usize; 2]) -> bool) -> Vec<[usize; 2]> {
    let (rows, columns) = seen.dim();
    seen[start] = true;
    let mut piece = vec![start];
    let mut next = 0;
    while next < piece.len() {
        let [row, column] = piece[next];
        next += 1;
        for j in row.saturating_sub(1)..(row + 2).min(rows) {
            for i in column.saturating_sub(1)..(column + 2).min(columns) {
                if !seen[[j, i]] && belongs([j, i]) {
                    seen[[j, i]] = true;
                    piece.push([j, i]);
                }
            }
        }
    }
    piece
}
