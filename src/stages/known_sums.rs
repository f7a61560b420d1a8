//! Sums of tables that serve scenes, kept in the cache: what the tables floor's builder asks for and leaves there.

use std::cell::Cell;

use serde_json::{Value, json};

use super::cache::Cache;
use super::known::transforms_parts;
use super::serve::Source;
use diffraction_build::optics::config::{Material, OpticsConfig};
use diffraction_build::tables::build::BuildPlan;
use diffraction_build::tables::kept::{Cut, Keeper, Piece};

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
        // Reflectance is no part of a sum.
        let optics = OpticsConfig { material: Material::Ideal, shadowing: false, ..source.optics.clone() };
        let common = json!({
            "heights": heights,
            "optics": optics,
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
        let cut = |what: [Value; 2], Cut { rho, quadrature, nodes }: Cut| {
            let quadrature = [json!(quadrature.wavelengths_nm), json!(quadrature.weights)];
            json!({ "what": what, "rho": rho, "quadrature": quadrature, "w": nodes.w, "nodes": nodes.count })
        };
        let own = match piece {
            Piece::Ring(ring, block) => cut([json!("ring"), json!(block)], ring),
            Piece::Cross(ring) => cut([json!("cross"), json!(0)], ring),
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

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::front_factor::Factor;
    use crate::stages::cache::CacheConfig;
    use diffraction_build::ground::spectrum::Illuminant;
    use diffraction_build::height::HeightField;
    use diffraction_build::optics::config::{Edge, Windows};
    use diffraction_build::tables::build;
    use diffraction_build::tables::model::{Basis, Prefilter, TablesConfig};
    use diffraction_build::tables::sums::RingNodes;

    /// Whatever the sums of a ring depend on, another value of it finds nothing.
    #[test]
    fn other_inputs_are_other_sums() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::open(&CacheConfig { folder: folder.path().to_owned(), limit_mib: 1 });
        let fields = [HeightField {
            heights_nm: ndarray::Array2::from_shape_fn((32, 32), |(y, x)| ((x * 7 + y * 3) % 11) as f64 * 9.0),
            pitch_nm: [200.0; 2],
        }];
        let optics = OpticsConfig {
            illuminant: Illuminant::D65,
            wavelength_nm: [380.0, 780.0],
            sigma_nm: 800.0,
            edge: Edge::Tile,
            windows: Windows::Grid,
            material: Material::Ideal,
            shadowing: false,
            factor: Factor::Scalar,
        };
        let tables = TablesConfig {
            basis: Basis::Chebyshev,
            tolerance: 1e-3,
            size: Some(41),
            count: None,
            wavelength_step_nm: None,
            prefilter: Prefilter::None,
            storage: None,
            memory_mib: 256,
        };
        let plan = |optics: &OpticsConfig, tables: &TablesConfig| build::plan(&fields, optics, tables).unwrap();
        let nodes = RingNodes { w: [0.0, 1.0], count: 4 };
        let finds =
            |heights: &str, optics: &OpticsConfig, plan: &BuildPlan, nodes: RingNodes, [ring, block]: [usize; 2]| {
                let source = Source { fields: &fields, optics, tables: &tables };
                let known = KnownSums::new(&cache, heights, &source, plan);
                known.load(Piece::Ring(Cut::new(&plan.rings[ring], nodes), block)).is_some()
            };
        let own = plan(&optics, &tables);
        assert!(own.rings.len() > 1);
        let source = Source { fields: &fields, optics: &optics, tables: &tables };
        KnownSums::new(&cache, "a", &source, &own).store(Piece::Ring(Cut::new(&own.rings[0], nodes), 1), b"sums");
        assert!(finds("a", &optics, &own, nodes, [0, 1]));
        // What tables are made of.
        assert!(!finds("b", &optics, &own, nodes, [0, 1]), "heights");
        for other in [
            OpticsConfig { illuminant: Illuminant::A, ..optics.clone() },
            OpticsConfig { wavelength_nm: [400.0, 780.0], ..optics.clone() },
            OpticsConfig { sigma_nm: 801.0, ..optics.clone() },
            OpticsConfig { windows: Windows::Centre, ..optics.clone() },
        ] {
            assert!(!finds("a", &other, &plan(&other, &tables), nodes, [0, 1]), "{other:?}");
        }
        for other in [
            TablesConfig { tolerance: 2e-3, ..tables.clone() },
            TablesConfig { size: Some(43), ..tables.clone() },
            TablesConfig { wavelength_step_nm: Some(2.0), ..tables.clone() },
            TablesConfig { prefilter: Prefilter::Width(0.1), ..tables.clone() },
        ] {
            assert!(!finds("a", &optics, &plan(&optics, &other), nodes, [0, 1]), "{other:?}");
        }
        let mut deeper = own.clone();
        deeper.spectra.s[1] *= 0.5;
        assert!(!finds("a", &optics, &deeper, nodes, [0, 1]), "the transforms' depths");
        // Which of them.
        assert!(!finds("a", &optics, &own, RingNodes { count: 8, ..nodes }, [0, 1]));
        assert!(!finds("a", &optics, &own, RingNodes { w: [0.0, 1.5], ..nodes }, [0, 1]));
        assert!(!finds("a", &optics, &own, nodes, [1, 1]) && !finds("a", &optics, &own, nodes, [0, 2]));
        // Reflectance is none of it, nor what memory is allowed.
        let shiny = OpticsConfig { material: Material::Dielectric { n: 1.5 }, shadowing: true, ..optics.clone() };
        let roomy = TablesConfig { memory_mib: 512, ..tables.clone() };
        assert!(finds("a", &shiny, &plan(&shiny, &roomy), nodes, [0, 1]));
    }
}
