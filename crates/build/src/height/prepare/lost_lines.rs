//! Scan lines without a measurement: one value all along, or a copy of the line before.

use ndarray::Array2;

/// Share of neighbours with equal heights above which a surface is made of flat pieces, as a generated disc is (0.83 and
/// 0.91); measured surfaces on 8 bits have 0.2.
const EQUAL_SHARE_MAX: f64 = 0.5;

/// Fewest samples of a line. With half of all neighbours equal, a line of 40 is so throughout by chance once in 2³⁹.
const SAMPLES_MIN: usize = 40;

/// Which lines hold no measurement; none where lines are too short to tell, where the surface is made of flat pieces, and
/// where every line is constant or all are equal, as in generated gratings.
pub(crate) fn lost_lines(heights: &Array2<f64>) -> Vec<bool> {
    let rows = heights.nrows();
    let mut lost = vec![false; rows];
    if heights.ncols() < SAMPLES_MIN || rows < 2 {
        return lost;
    }
    let constant: Vec<bool> = heights.rows().into_iter().map(|row| row.iter().all(|h| *h == row[0])).collect();
    if constant.iter().all(|constant| *constant) {
        return lost;
    }
    let along = heights.rows().into_iter().zip(&constant).filter(|(_, constant)| !**constant);
    let equal_along = share(along.flat_map(|(row, _)| (1..row.len()).map(move |i| row[i] == row[i - 1])));
    if equal_along.is_some_and(|share| share < EQUAL_SHARE_MAX) {
        lost.copy_from_slice(&constant);
    }
    let repeats = |row: usize| row > 0 && heights.row(row) == heights.row(row - 1);
    let copies: Vec<bool> = (0..rows).map(repeats).collect();
    let others = (1..rows).filter(|&row| !copies[row] && !constant[row] && !constant[row - 1]);
    let equal_across =
        share(others.flat_map(|row| heights.row(row).into_iter().zip(heights.row(row - 1)).map(|(a, b)| a == b)));
    if equal_across.is_some_and(|share| share < EQUAL_SHARE_MAX) {
        lost.iter_mut().zip(&copies).for_each(|(lost, copy)| *lost |= copy);
    }
    lost
}

/// Share of what is true; `None` of nothing.
fn share(values: impl Iterator<Item = bool>) -> Option<f64> {
    let (count, true_count) = values.fold((0usize, 0usize), |(n, t), value| (n + 1, t + usize::from(value)));
    (count > 0).then(|| true_count as f64 / count as f64)
}

/// First and length of the longest block of lines that are `wanted`; the first of equal ones, `None` where there is none.
pub(crate) fn longest_block(lines: &[bool], wanted: bool) -> Option<[usize; 2]> {
    let mut longest: Option<[usize; 2]> = None;
    let mut first = 0;
    for block in lines.chunk_by(|a, b| a == b) {
        if block[0] == wanted && longest.is_none_or(|[_, length]| block.len() > length) {
            longest = Some([first, block.len()]);
        }
        first += block.len();
    }
    longest
}
