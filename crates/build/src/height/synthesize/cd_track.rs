//! Pits of a compact disc: dimensions of IEC 60908, run lengths of its eight-to-fourteen modulation.

use fastrand::Rng;
use ndarray::Array2;

use super::grid::{Grid, length, round_heights, step};
use diffraction_brdf::error::Result;

/// Distance of the tracks.
const TRACK_NM: f64 = 1600.0;
/// Length of one channel bit at 1.2 m/s and 4.3218 MHz: the shortest pit, of three, is 0.83 um long,
/// the longest, of eleven, 3.05 um.
const BIT_NM: f64 = 277.66;
/// Shortest and longest pit or land, in channel bits.
const RUNS: std::ops::RangeInclusive<usize> = 3..=11;
/// Depth of the pits: about a quarter wavelength in polycarbonate.
const DEPTH_NM: f64 = 120.0;
/// Half the width of a pit at half depth.
const HALF_WIDTH_NM: f64 = 275.0;
/// Half the width of a pit's wall, seen from above.
const WALL_NM: f64 = 90.0;

/// One pit: its ends along the track, `start_nm` within the tile.
struct Pit {
    start_nm: f64,
    end_nm: f64,
}

/// Tracks along x, pits going down from height 0.
pub(super) fn generate(grid: &Grid, seed: u64) -> Result<Array2<f64>> {
    grid.check_pitch(2.0 * WALL_NM, "the walls of the pits")?;
    let tracks = grid.count(1, TRACK_NM, 1, "a track")?;
    // Two pits and two lands of any length.
    let bits = grid.count(0, BIT_NM, 4 * RUNS.end(), "a track of pits")?;
    let [width, height] = grid.extent_nm();
    let (track_nm, bit_nm) = (height / tracks as f64, width / bits as f64);
    let mut rng = Rng::with_seed(seed);
    let weights = weights(bits);
    let pits: Vec<Vec<Pit>> = (0..tracks).map(|_| pits(&weights, bit_nm, &mut rng)).collect();
    let mut heights = grid.sample(|x, y| {
        let track = ((y / track_nm) as usize).min(tracks - 1);
        let across = y - (track as f64 + 0.5) * track_nm;
        -DEPTH_NM * step(-outside_nm(&pits[track], width, x, across) / WALL_NM)
    });
    round_heights(&mut heights);
    Ok(heights)
}

/// For each length in channel bits and each parity, the number of ways to fill it with an even or odd number
/// of runs, divided by `GROWTH` to the length, which keeps it finite.
fn weights(bits: usize) -> Vec<[f64; 2]> {
    let mut weights = vec![[0.0; 2]; bits + 1];
    weights[0] = [1.0, 0.0];
    for length in 1..=bits {
        for run in RUNS.filter(|run| *run <= length) {
            let [even, odd] = weights[length - run];
            let share = libm::pow(GROWTH, -(run as f64));
            weights[length][0] += share * odd;
            weights[length][1] += share * even;
        }
    }
    weights
}

/// Factor by which the number of ways grows per channel bit: the root of `sum over runs of g^-run = 1`.
const GROWTH: f64 = 1.455_8;

/// Draws one closed track: all sequences of runs that fill it are equally likely, which is what a modulation
/// without redundancy looks like, and starts anywhere.
fn pits(weights: &[[f64; 2]], bit_nm: f64, rng: &mut Rng) -> Vec<Pit> {
    let mut left = weights.len() - 1;
    let mut parity = 0;
    let mut edges = vec![0];
    while left > 0 {
        let choices: Vec<(usize, f64)> = RUNS
            .filter(|run| *run <= left)
            .map(|run| (run, libm::pow(GROWTH, -(run as f64)) * weights[left - run][1 - parity]))
            .filter(|(_, weight)| *weight > 0.0)
            .collect();
        let mut mark = rng.f64() * choices.iter().map(|(_, weight)| weight).sum::<f64>();
        let chosen = choices.iter().find(|(_, weight)| {
            mark -= weight;
            mark < 0.0
        });
        // Rounding may leave the mark just above the last choice.
        let Some((run, _)) = chosen.or(choices.last()) else { break };
        left -= run;
        parity = 1 - parity;
        edges.push(weights.len() - 1 - left);
    }
    let bits = weights.len() - 1;
    let turn = rng.usize(0..bits);
    let mut pits: Vec<Pit> = edges
        .windows(2)
        .step_by(2)
        .map(|ends| {
            let start = (ends[0] + turn) % bits;
            let end = start + ends[1] - ends[0];
            Pit { start_nm: start as f64 * bit_nm, end_nm: end as f64 * bit_nm }
        })
        .collect();
    pits.sort_by(|a, b| a.start_nm.total_cmp(&b.start_nm));
    pits
}

/// Distance in nm from the nearest pit's outline, negative inside; pits have round ends.
fn outside_nm(pits: &[Pit], width_nm: f64, along_nm: f64, across_nm: f64) -> f64 {
    let distance = |pit: &Pit, shift: f64| {
        let middle = 0.5 * (pit.start_nm + pit.end_nm) + shift;
        let straight = 0.5 * (pit.end_nm - pit.start_nm) - HALF_WIDTH_NM;
        let beyond = ((along_nm - middle).abs() - straight).max(0.0);
        length(beyond, across_nm) - HALF_WIDTH_NM
    };
    // The last pit that starts before this place and the first after it, around the tile.
    let next = pits.partition_point(|pit| pit.start_nm <= along_nm);
    let before = match next {
        0 => pits.last().map(|pit| distance(pit, -width_nm)),
        _ => pits.get(next - 1).map(|pit| distance(pit, 0.0)),
    };
    let after = match pits.get(next) {
        Some(pit) => Some(distance(pit, 0.0)),
        None => pits.first().map(|pit| distance(pit, width_nm)),
    };
    before.into_iter().chain(after).fold(f64::INFINITY, f64::min)
}
