//! Mip chains of tables: coarser levels for filtered look-ups on graphics hardware.
//!
//! A level has half as many texels a side, rounded down, as graphics interfaces ask for. Each texel is the mean over its share of the
//! finer level, whose texels count by how much of them lies there: so a place in normalised coordinates is the same on
//! every level, odd sides included.

use ndarray::{Array3, ArrayView3, Axis};

/// Fewest texels a side of a level below the finest.
const SIDE_MIN: usize = 4;

/// The levels below an image `[rows, columns, channels]`, from the finer to the coarser.
pub(crate) fn coarser(image: ArrayView3<f32>) -> Vec<Array3<f32>> {
    let mut levels: Vec<Array3<f32>> = Vec::new();
    loop {
        let finer = levels.last().map_or(image, |finer| finer.view());
        let (rows, columns, _) = finer.dim();
        if rows.min(columns) < 2 * SIDE_MIN {
            return levels;
        }
        levels.push(halved(finer));
    }
}

fn halved(image: ArrayView3<f32>) -> Array3<f32> {
    let (rows, columns, channels) = image.dim();
    let [of_rows, of_columns] = [rows, columns].map(shares);
    // Along columns first: rows lie together in memory.
    let mut narrow = Array3::<f64>::zeros((rows, of_columns.len(), channels));
    for (column, (first, weights)) in of_columns.iter().enumerate() {
        for (k, weight) in weights.iter().enumerate().filter(|(_, weight)| **weight > 0.0) {
            let texels = image.index_axis(Axis(1), first + k);
            narrow
                .index_axis_mut(Axis(1), column)
                .zip_mut_with(&texels, |sum, value| *sum += weight * f64::from(*value));
        }
    }
    let mut out = Array3::<f64>::zeros((of_rows.len(), of_columns.len(), channels));
    for (row, (first, weights)) in of_rows.iter().enumerate() {
        for (k, weight) in weights.iter().enumerate().filter(|(_, weight)| **weight > 0.0) {
            out.index_axis_mut(Axis(0), row).scaled_add(*weight, &narrow.index_axis(Axis(0), first + k));
        }
    }
    out.mapv(|value| value as f32)
}

/// For each texel along a side of half as many: the first of the texels that it covers, and how much it covers of three.
fn shares(count: usize) -> Vec<(usize, [f64; 3])> {
    let half = count / 2;
    let step = count as f64 / half as f64;
    let share = |n: usize| {
        let [low, high] = [n, n + 1].map(|n| n as f64 * step);
        let first = low as usize;
        let covered = |k: usize| {
            let [from, to] = [first + k, first + k + 1].map(|texel| texel as f64);
            // What rounding leaves beyond the side belongs to no texel.
            if first + k < count { (high.min(to) - low.max(from)).max(0.0) } else { 0.0 }
        };
        let weights = [0, 1, 2].map(covered);
        let sum: f64 = weights.iter().sum();
        (first, weights.map(|weight| weight / sum))
    };
    (0..half).map(share).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_stays_where_it_is_on_every_level() {
        for [rows, columns] in [[64, 64], [61, 97], [8, 31]] {
            // In normalised coordinates.
            let plane = |row: f64, column: f64| 3.0 + column - 2.0 * row;
            let level = |rows: usize, columns: usize| {
                Array3::from_shape_fn((rows, columns, 2), |(row, column, c)| {
                    let [y, x] = [(row as f64 + 0.5) / rows as f64, (column as f64 + 0.5) / columns as f64];
                    (plane(y, x) * [1.0, -0.5][c]) as f32
                })
            };
            let image = level(rows, columns);
            let levels = coarser(image.view());
            assert!(!levels.is_empty());
            let mut side = [rows, columns];
            // Single precision; and of an odd side a texel covered by the share p is as far off as (1 - p) / 2 with the
            // weight p / 2: a sixteenth of a finer texel at most.
            let mut bound = 2e-6;
            for found in levels {
                let slopes = [2.0, 1.0].into_iter().zip(side).filter(|(_, side)| side % 2 == 1);
                bound += slopes.map(|(slope, side)| slope / (16.0 * side as f32)).sum::<f32>();
                side = side.map(|side| side / 2);
                assert!(side[0].min(side[1]) >= SIDE_MIN && found.dim() == (side[0], side[1], 2));
                let expected = level(side[0], side[1]);
                assert!(found.iter().zip(&expected).all(|(found, expected)| (found - expected).abs() < bound));
                let mut turned = expected.clone();
                turned.invert_axis(Axis(0));
                assert!(found.iter().zip(&turned).any(|(found, turned)| (found - turned).abs() > 0.1));
            }
            assert!(side[0].min(side[1]) < 2 * SIDE_MIN);
        }
    }

    #[test]
    fn every_texel_counts_alike() {
        for count in [8, 9, 31, 601] {
            let mut sums = vec![0.0; count];
            for (first, weights) in shares(count) {
                for (k, weight) in weights.into_iter().enumerate().filter(|(_, weight)| *weight > 0.0) {
                    sums[first + k] += weight;
                }
            }
            let each = (count / 2) as f64 / count as f64;
            assert!(sums.iter().all(|sum| (sum - each).abs() < 1e-9), "{count}: {sums:?}");
        }
    }
}
