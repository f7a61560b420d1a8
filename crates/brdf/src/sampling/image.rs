//! What a sampler has prepared, as the numbers of a texture that shaders read.

use super::lobe::{LobeDensity, STRIPS};
use super::nodes::NODES;
use super::tables::TableDensity;

/// Columns that the numbers of a node take: three shares and the strips of its lobe.
const NODE_COLUMNS: usize = 3 + STRIPS;
/// Rows before those of the tables' sums: the grid, the reflectance, and the nodes.
const ROWS_BEFORE: usize = 2 + NODES;

/// Numbers by row and column.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct NumbersForShaders {
    /// Number of rows and columns.
    pub size: [usize; 2],
    /// Row by row; 0 where a row has no more.
    pub numbers: Vec<f32>,
}

impl NumbersForShaders {
    /// Rows of numbers: the grid, the reflectance, each node with its shares of the even part, the lobe and the tables, and each node's sums
    /// along rows and along bands of rows. The shader sampling.wgsl says what is in them.
    pub(super) fn new(lobe: Option<&LobeDensity>, tables: &TableDensity, shares: &[[f64; 3]; NODES]) -> Self {
        let reflectance = lobe.map_or(vec![0.0], |lobe| lobe.reflectance.0.clone());
        let columns = (tables.columns + 1).max(reflectance.len()).max(NODE_COLUMNS);
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(ROWS_BEFORE);
        let counts = [tables.rows, tables.columns, tables.band].map(|count| count as f64);
        rows.push([tables.first[0], tables.first[1], tables.step].into_iter().chain(counts).collect());
        rows.push(reflectance);
        for (node, shares) in shares.iter().enumerate() {
            let strips = lobe.map_or([0.0; STRIPS], |lobe| lobe.strips[node]);
            rows.push(shares.iter().copied().chain(strips).collect());
        }
        let mut numbers = Vec::new();
        let mut push = |row: &mut dyn Iterator<Item = f32>| {
            let end = numbers.len() + columns;
            numbers.extend(row);
            numbers.resize(end, 0.0);
        };
        rows.iter().for_each(|row| push(&mut row.iter().map(|value| *value as f32)));
        for node in &tables.nodes {
            let sums = node.rows.chunks(tables.columns + 1).chain(node.bands.chunks(tables.columns + 1));
            sums.for_each(|row| push(&mut row.iter().copied()));
        }
        Self { size: [numbers.len() / columns, columns], numbers }
    }
}
