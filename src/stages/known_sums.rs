//! Sums of tables that serve scenes, kept in the cache: what the tables floor's builder asks for and leaves there.

use std::cell::Cell;

use serde_json::{Value, json};

use super::cache::Cache;
use super::known::transforms_parts;
use super::serve::Source;
use crate::tables::build::BuildPlan;
use crate::tables::kept::{Cut, Keeper, Piece};

/// The cache's part that belongs to one surface, light and plan of transforms.
#[derive(Debug)]
pub struct KnownSums<'a> {
    cache: &'a Cache,
    /// Everything that the sums of any ring depend on.
    common: Value,
    /// Texels of which sums were known, and of which they were not.
    texels: Cell<[u64; 2]>,
}

impl<'a> KnownSums<'a> {
    /// Of the specimen whose prepared heights have this digest.
    pub fn new(cache: &'a Cache, heights: &str, source: &Source, plan: &BuildPlan) -> Self {
        let common = json!({
            "heights": heights,
            "optics": source.optics,
            "transforms": transforms_parts(plan),
            "grid": plan.texels.grid.size,
            "filter": [plan.filter.width, plan.filter.samples as f64],
        });
        Self { cache, common, texels: Cell::default() }
    }

    /// Texels of which sums were known, and of which they were not.
    pub fn texels(&self) -> [u64; 2] {
        self.texels.get()
    }

    fn key(&self, piece: Piece) -> String {
        let cut = |what: &str, Cut { rho, quadrature, nodes }: Cut| {
            let quadrature = [json!(quadrature.wavelengths_nm), json!(quadrature.weights)];
            json!({ "what": what, "rho": rho, "quadrature": quadrature, "w": nodes.w, "nodes": nodes.count })
        };
        let own = match piece {
            Piece::Ring(ring) => cut("ring", ring),
            Piece::Cross(ring) => cut("cross", ring),
            Piece::Phasors => json!({ "what": "phasors" }),
        };
        self.cache.key("sums", &json!({ "common": self.common, "own": own }))
    }
}

impl Keeper for KnownSums<'_> {
    fn load(&self, piece: Piece) -> Option<Vec<u8>> {
        self.cache.load(&self.key(piece))
    }

    fn store(&self, piece: Piece, bytes: &[u8]) {
        self.cache.store(&self.key(piece), bytes);
    }

    fn count(&self, [known, not]: [u64; 2]) {
        let [known_before, not_before] = self.texels.get();
        self.texels.set([known_before + known, not_before + not]);
    }
}
