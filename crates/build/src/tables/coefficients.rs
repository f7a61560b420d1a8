//! From values at nodes in `w` to coefficients of the basis.

use ndarray::Array3;
use rayon::prelude::*;

use super::accumulate::PowerSums;
use super::coverage::ranges::Coverage;
use super::rings::{Ring, RingNodes};
use super::texels::Texels;
use diffraction_brdf::chebyshev::{self, Interpolant};
use diffraction_brdf::direction::max_abs_w;

/// Sums at the nodes of rings.
pub(super) struct Values<'a> {
    pub sums: &'a PowerSums,
    /// The texels that are summed.
    pub texels: &'a Texels,
    pub rings: &'a [Ring],
    /// Of each ring.
    pub nodes: &'a [RingNodes],
}

/// What turns values into so many coefficients of `T_n(2t - 1)`.
struct Basis {
    count: usize,
    t_nodes: Vec<f64>,
    /// `[coefficient][node in t]`.
    matrix: Vec<f64>,
    /// From the nodes of each ring.
    interpolants: Vec<Interpolant>,
}

/// Coefficients of `T_n(2t - 1)` over each texel's range of `t`: that of a coverage, or all of it. Images have as many channels
/// as the sums.
pub(super) fn to_tables(values: &Values, coverage: Option<&Coverage>, count: usize) -> Vec<Array3<f32>> {
    let texels = values.texels;
    let basis = Basis {
        count,
        t_nodes: chebyshev::gauss_nodes(count, 0.0, 1.0),
        matrix: chebyshev::coefficient_matrix(count).concat(),
        interpolants: values
            .nodes
            .iter()
            .map(|nodes| Interpolant::new(nodes.count, nodes.abs_w[0], nodes.abs_w[1]))
            .collect(),
    };
    let channels = values.sums.channels;
    let row_length = texels.columns.len() * channels;
    let mut tables: Vec<Vec<f32>> = (0..count).map(|_| vec![0.0; texels.rows.len() * row_length]).collect();
    // Each row of all tables together, so that rows are written side by side and no copy is held.
    let mut rows: Vec<Vec<&mut [f32]>> = texels.rows.clone().map(|_| Vec::with_capacity(count)).collect();
    for table in &mut tables {
        rows.iter_mut().zip(table.chunks_exact_mut(row_length)).for_each(|(row, part)| row.push(part));
    }
    rows.par_iter_mut().enumerate().for_each(|(line, out)| basis.fill_row(values, coverage, line, out));
    let array = |table| {
        let shape = (texels.rows.len(), texels.columns.len(), channels);
        Array3::from_shape_vec(shape, table).expect("one number for each texel and channel")
    };
    tables.into_iter().map(array).collect()
}

impl Basis {
    /// One row of the texels' window, in all tables.
    fn fill_row(&self, values: &Values, coverage: Option<&Coverage>, line: usize, out: &mut [&mut [f32]]) {
        let Values { sums, texels, rings, .. } = values;
        let row = texels.rows.start + line;
        let channels = sums.channels;
        let mut at_t = vec![0.0; channels * self.count];
        for (ring, interpolant) in rings.iter().zip(&self.interpolants) {
            let mut weights = vec![0.0; interpolant.nodes().len()];
            for column in texels.runs_in(row, ring.radius).into_iter().flatten() {
                let index = column - texels.columns.start;
                let [low, high] = match coverage {
                    None => [0.0, max_abs_w(texels.grid.u(column).hypot(texels.grid.v(row)))],
                    Some(coverage) => coverage.abs_w_at(row, column, coverage.range(row, column)),
                };
                let first = (line * texels.columns.len() + index) * sums.per_texel();
                let values = &sums.data[first..first + sums.per_texel()];
                for (place, t) in self.t_nodes.iter().enumerate() {
                    interpolant.weights_into(low + t * (high - low), &mut weights);
                    for (channel, values) in values.chunks_exact(sums.nodes).enumerate() {
                        at_t[channel * self.count + place] = dot(&weights, values);
                    }
                }
                for (n, out) in out.iter_mut().enumerate() {
                    let coefficients = &self.matrix[n * self.count..][..self.count];
                    for (channel, at_t) in at_t.chunks_exact(self.count).enumerate() {
                        let coefficient: f64 = coefficients.iter().zip(at_t).map(|(m, v)| m * v).sum();
                        out[index * channels + channel] = coefficient as f32;
                    }
                }
            }
        }
    }
}

fn dot(weights: &[f64], values: &[f32]) -> f64 {
    weights.iter().zip(values).map(|(weight, &value)| weight * f64::from(value)).sum()
}
