//! Sums kept from builds for other scenes: tables put together from them are those of a build that knows nothing.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::common::surfaces::{random, tables_config};
use diffraction_atlas::stages::serve::{Source, domain_of, plan_without};
use diffraction_brdf::direction::wave_vector_change;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::optics::spectra::SpectraConfig;
use diffraction_build::optics::spectral::brdf_xyz_batch;
use diffraction_build::tables::build::build_planned;
use diffraction_build::tables::kept::{Keeper, Piece};
use diffraction_build::tables::model::{TableSet, TablesConfig};
use diffraction_render::scene::model::{Light, Scene, Shape};
use proptest::prelude::*;

/// Keeps everything by what a piece says of itself: enough for one surface under one light, where transforms hold the same
/// depths.
#[derive(Default)]
struct Shelf {
    kept: RefCell<BTreeMap<String, Vec<u8>>>,
    texels: RefCell<[u64; 2]>,
}

impl Shelf {
    /// Texels known and not known since last asked.
    fn texels(&self) -> [u64; 2] {
        self.texels.take()
    }

    /// Changes every piece of a kind.
    fn change(&self, kind: &str, change: impl Fn(&mut Vec<u8>)) {
        let mut kept = self.kept.borrow_mut();
        kept.iter_mut().filter(|(piece, _)| piece.starts_with(kind)).for_each(|(_, bytes)| change(bytes));
    }
}

impl Keeper for Shelf {
    fn load(&self, piece: Piece) -> Option<Vec<u8>> {
        self.kept.borrow().get(&format!("{piece:?}")).cloned()
    }

    fn store(&self, piece: Piece, bytes: &[u8]) {
        self.kept.borrow_mut().insert(format!("{piece:?}"), bytes.to_vec());
    }

    fn count(&self, texels: [u64; 2]) {
        let mut sum = self.texels.borrow_mut();
        sum.iter_mut().zip(texels).for_each(|(sum, texels)| *sum += texels);
    }
}

fn ball(direction: [f64; 3]) -> Scene {
    let sun = Light { direction, angular_diameter_deg: 0.53, irradiance: 1.0 };
    Scene { light_samples: 6, ..Scene::still("ball", Shape::Sphere, vec![sun], 40) }
}

fn built(source: &Source, scene: &Scene, shelf: Option<&Shelf>) -> TableSet {
    let domain = domain_of(source, &[scene]).unwrap();
    let plan = plan_without(None, source, &domain).unwrap();
    let keeper = shelf.map(|shelf| shelf as &dyn Keeper);
    build_planned(source.fields, source.optics, source.tables, &plan, keeper, &|_| ()).unwrap().0
}

/// Bit by bit: what is zero in one is zero in the other, and of the same sign.
fn bits(set: &TableSet) -> Vec<Vec<u32>> {
    let lobe = set.lobe.as_ref();
    let arrays =
        set.tables.iter().chain(lobe.map(|lobe| &lobe.coherent)).chain(lobe.iter().flat_map(|lobe| &lobe.cross));
    arrays.map(|array| array.iter().map(|number| number.to_bits()).collect()).collect()
}

struct Case {
    fields: Vec<HeightField>,
    optics: OpticsConfig,
    tables: TablesConfig,
}

impl Case {
    fn new(sigma_nm: f64, edge: Edge, windows: Windows, size: usize) -> Self {
        let optics = OpticsConfig { windows, ..crate::common::reference_optics(sigma_nm, edge) };
        Self {
            fields: vec![random([96, 96], [100.0; 2], 400.0, 40.0, 7)],
            optics,
            tables: tables_config(1e-3, Some(size)),
        }
    }

    fn source(&self) -> Source<'_> {
        Source { fields: &self.fields, optics: &self.optics, tables: &self.tables }
    }
}

/// Point samples and texels wider than a lobe, one window and several, with a cross term and without; and one window of a
/// scan four times as wide, whose lines lie farther apart than the scan's.
fn cases() -> [Case; 5] {
    [
        Case::new(1_500.0, Edge::Tile, Windows::Grid, 201),
        Case::new(1_500.0, Edge::Tile, Windows::Centre, 201),
        Case::new(1_500.0, Edge::Tile, Windows::Centre, 41),
        Case::new(800.0, Edge::Fade, Windows::Grid, 101),
        Case {
            fields: vec![random([256, 256], [100.0; 2], 400.0, 40.0, 7)],
            ..Case::new(600.0, Edge::Fade, Windows::Centre, 101)
        },
    ]
}

#[test]
fn a_moved_light_leaves_most_sums_as_they_were() {
    for case in cases() {
        let (source, shelf) = (case.source(), Shelf::default());
        let [first, moved] = [[0.3, 0.2, 1.0], [0.36, 0.2, 1.0]].map(ball);
        assert!(bits(&built(&source, &first, Some(&shelf))) == bits(&built(&source, &first, None)));
        let [known, summed] = shelf.texels();
        assert!(known == 0 && summed > 100);
        let expected = bits(&built(&source, &moved, None));
        let before = shelf.kept.borrow().clone();
        assert!(bits(&built(&source, &moved, Some(&shelf))) == expected);
        let [known, lacking] = shelf.texels();
        println!("{:?} {}: {known} known, {lacking} summed", case.optics.windows, source.tables.size.unwrap());
        assert!(known > 5 * lacking, "{known} known, {lacking} summed");
        // Neither light asks for anything now, although the second left out some of the first one's texels.
        for scene in [&first, &moved] {
            built(&source, scene, Some(&shelf));
            assert_eq!(shelf.texels()[1], 0);
        }
        // What is kept is used, each kind of it: with other sums the tables are others.
        let kinds =
            ["Ring", "Cross", "Phasors"].into_iter().filter(|kind| before.keys().any(|key| key.starts_with(kind)));
        let kinds: Vec<&str> = kinds.collect();
        assert_eq!(
            kinds.len(),
            if case.optics.windows == Windows::Centre || case.optics.edge == Edge::Fade { 3 } else { 2 }
        );
        for kind in kinds {
            shelf.kept.replace(before.clone());
            shelf.change(kind, |bytes| {
                let middle = bytes.len() / 8 * 4 + 2;
                bytes[middle] ^= 0x20;
            });
            assert!(bits(&built(&source, &moved, Some(&shelf))) != expected, "{kind}");
        }
    }
}

#[test]
fn what_is_no_sums_is_summed_again() {
    let case = Case::new(1_500.0, Edge::Tile, Windows::Centre, 101);
    let (source, scene) = (case.source(), ball([0.3, 0.2, 1.0]));
    let expected = bits(&built(&source, &scene, None));
    let damages: [fn(&mut Vec<u8>); 5] = [
        |bytes| bytes.truncate(bytes.len() - 4),
        |bytes| bytes.extend([0; 4]),
        |bytes| bytes.truncate(3),
        |bytes| bytes.clear(),
        // More texels than there are numbers.
        |bytes| bytes.iter_mut().take(8).for_each(|byte| *byte = 0xff),
    ];
    for (number, damage) in damages.iter().enumerate() {
        let shelf = Shelf::default();
        built(&source, &scene, Some(&shelf));
        // Phasors and the cross term begin with numbers, whatever their bits.
        shelf.kept.borrow_mut().retain(|name, _| number < 4 || name.starts_with("Ring"));
        shelf.change("", damage);
        shelf.texels();
        assert!(bits(&built(&source, &scene, Some(&shelf))) == expected, "damage {number}");
        assert_eq!(shelf.texels()[0], 0, "damage {number}");
    }
}

#[test]
fn tables_for_every_direction_keep_nothing() {
    let case = Case::new(1_500.0, Edge::Tile, Windows::Grid, 41);
    let plan = diffraction_build::tables::build::plan(&case.fields, &case.optics, &case.tables).unwrap();
    let shelf = Shelf::default();
    build_planned(&case.fields, &case.optics, &case.tables, &plan, Some(&shelf), &|_| ()).unwrap();
    assert!(shelf.kept.borrow().is_empty());
}

/// Transforms that hold a pair's own frequencies, and no others, give the value that those of all frequencies give.
#[test]
fn values_do_not_depend_on_the_frequencies_held() {
    for case in cases() {
        let (optics, pair) = (&case.optics, ([0.6, 0.0, 0.8], [0.1, -0.3, 0.9f64.sqrt()]));
        let q = wave_vector_change(pair.0, pair.1);
        let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
        let own = |axis: usize| {
            let [a, b] = [q[axis] / low_nm, q[axis] / high_nm];
            [a.min(b), a.max(b)]
        };
        let s = [0.0, 2.0 * std::f64::consts::TAU / low_nm];
        let wide =
            SpectraConfig { s, frequency: [[-2.0 / low_nm, 2.0 / low_nm]; 2], tolerance: 1e-6, memory_bytes: 1 << 30 };
        let narrow = SpectraConfig { frequency: [own(0), own(1)], ..wide };
        assert!(narrow.holds(optics, q) && !narrow.holds(optics, q.map(|x| 1.01 * x)));
        let value = |config: &SpectraConfig| brdf_xyz_batch(&case.fields, optics, config, &[pair]).unwrap()[0];
        assert_eq!(value(&narrow).map(f64::to_bits), value(&wide).map(f64::to_bits), "{:?}", optics.windows);
        // One that lacks a line or two of what it reads gives another.
        let [x, y] = narrow.frequency;
        let less = SpectraConfig { frequency: [[x[0] + 0.4 * (x[1] - x[0]), x[1]], y], ..wide };
        assert_ne!(value(&less), value(&wide));
    }
}

fn direction() -> impl Strategy<Value = [f64; 3]> {
    (0.0..std::f64::consts::TAU, 0.05..1.0f64).prop_map(|(phi, z)| {
        let r = (1.0 - z * z).sqrt();
        [r * phi.cos(), r * phi.sin(), z]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4, ..ProptestConfig::default() })]

    /// Whatever was built before, in whatever order.
    #[test]
    fn tables_do_not_tell_what_was_built_before(
        directions in proptest::collection::vec(direction(), 3), case in 0..5usize, turn_deg in -90.0..90.0f64,
    ) {
        let case = &cases()[case];
        let source = Source { tables: &TablesConfig { size: Some(61), ..case.tables.clone() }, ..case.source() };
        let patch = Shape::Patch { width_mm: 30.0, distance_mm: 40.0, tilt_deg: 20.0, turn_deg };
        let scenes = directions.iter().map(|&direction| ball(direction));
        let scenes: Vec<Scene> = scenes.chain([Scene { shape: patch, ..ball(directions[0]) }]).collect();
        // Pieces do not say which depths the transforms hold: each has a shelf of its own.
        let mut shelves: BTreeMap<String, Shelf> = BTreeMap::new();
        for scene in &scenes {
            let domain = domain_of(&source, &[scene]).unwrap();
            if domain.texels() == 0 {
                continue;
            }
            let plan = plan_without(None, &source, &domain).unwrap();
            let shelf = shelves.entry(format!("{:?}", plan.spectra.s)).or_default();
            prop_assert!(bits(&built(&source, scene, Some(shelf))) == bits(&built(&source, scene, None)));
        }
    }
}
