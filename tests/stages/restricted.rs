//! Tables made for certain scenes show them as tables for every direction do, and answer nothing else.

use diffraction_atlas::stages::coverage::savings::{account, cover, measure};
use diffraction_brdf::evaluate::{Interpolation, answers, brdf_xyz};
use diffraction_build::height::HeightField;
use diffraction_build::height::prepare::{Level, PrepareConfig, prepare};
use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::tables::build::{build, build_planned};
use diffraction_build::tables::coverage::budget::Pruning;
use diffraction_build::tables::coverage::find::looked_up;
use diffraction_build::tables::coverage::ranges::Coverage;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{TableSet, TablesConfig};
use diffraction_build::tables::plan::{grid, plan_for};
use diffraction_render::render::cpu;
use diffraction_render::scene::model::{Exposure, Light, Scene, Shape, exposure_factor};
use diffraction_render::scene::reach::SceneLookUps;
use diffraction_render::scene::samples::samples;
use ndarray::Array3;
use proptest::prelude::*;

const TOLERANCE: f64 = 1e-3;

fn surface() -> HeightField {
    crate::common::surfaces::random([96, 96], [100.0; 2], 400.0, 40.0, 7)
}

fn daylight(windows: Windows) -> OpticsConfig {
    OpticsConfig { windows, ..crate::common::reference_optics(1_500.0, Edge::Tile) }
}

fn config(size: usize) -> TablesConfig {
    crate::common::surfaces::tables_config(TOLERANCE, Some(size))
}

fn scene(shape: Shape, lights: Vec<Light>) -> Scene {
    Scene { light_samples: 6, ..Scene::still("s", shape, lights, 40) }
}

fn light(direction: [f64; 3], angular_diameter_deg: f64) -> Light {
    Light { direction, angular_diameter_deg, irradiance: 1.0 }
}

fn picture(scene: &Scene, set: &TableSet) -> Array3<f32> {
    cpu::render(scene, &|wi, wo| brdf_xyz(set, Interpolation::Bilinear, wi, wo)).unwrap()
}

/// A pair of directions above the surface with this `(u, v)` and `|w|`.
fn pair_at([u, v]: [f64; 2], w: f64) -> ([f64; 3], [f64; 3]) {
    // Half of -q each, and apart by a horizontal vector at a right angle to it.
    let apart = (1.0 - 0.25 * (u * u + v * v + w * w)).sqrt() / u.hypot(v);
    let half = [-0.5 * u, -0.5 * v, 0.5 * w];
    let [x, y] = [-v * apart, u * apart];
    ([half[0] + x, half[1] + y, half[2]], [half[0] - x, half[1] - y, half[2]])
}

/// Tables restricted to a scene, and what they cover.
fn restricted(input: &BuildInput, scene: &Scene) -> (TableSet, Coverage) {
    let covered = cover(input, &[scene]).unwrap();
    let plan = plan_for(input, Some(covered.clone())).unwrap();
    (build_planned(input, &plan, &|_| ()).unwrap().0, covered)
}

/// Largest difference of a pixel in units of the display's white, or of the pixel itself where it is brighter: a
/// highlight far beyond white shows nothing of an absolute difference.
fn difference(expected: &Array3<f32>, found: &Array3<f32>, exposure: Exposure) -> f64 {
    let white = 1.0 / f64::from(exposure_factor(exposure, expected));
    let pairs = expected.iter().zip(found).map(|(&a, &b)| (f64::from(a), f64::from(b)));
    // A NaN anywhere is the worst of all.
    pairs
        .map(|(a, b)| (a - b).abs() / a.abs().max(white))
        .fold(0.0, |worst, d| if d.is_nan() { d } else { worst.max(d) })
}

/// What leaving out the rest may change of a pixel.
const ALLOWED: f64 = TOLERANCE;

#[test]
fn pictures_are_the_same_in_every_kind_of_scene() {
    let fields = [surface()];
    let tables = config(201);
    for windows in [Windows::Grid, Windows::Centre] {
        let optics = daylight(windows);
        let input = BuildInput::new(&fields, &optics, &tables);
        let (full, _) = build(&input, &|_| ()).unwrap();
        let sun = light([0.3, 0.2, 1.0], 0.53);
        for shape in [
            Shape::Hemisphere,
            Shape::Sphere,
            Shape::Snake,
            Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 30.0, turn_deg: 15.0 },
            Shape::Patch { width_mm: 20.0, distance_mm: 9_000.0, tilt_deg: 50.0, turn_deg: 0.0 },
            Shape::Screen {
                distance_mm: 50.0,
                width_mm: 100.0,
                beam_diameter_mm: 1.0,
                hole_diameter_mm: None,
                incidence_deg: 10.0,
            },
        ] {
            let scene = scene(shape.clone(), vec![sun]);
            let (set, covered) = restricted(&input, &scene);
            let (expected, found) = (picture(&scene, &full), picture(&scene, &set));
            let worst = difference(&expected, &found, scene.exposure);
            println!(
                "{windows:?} {shape:?}: {} texels, {} tables against {}, worst {worst:.1e}",
                covered.count(),
                set.tables.len(),
                full.tables.len()
            );
            assert!(worst <= ALLOWED, "{windows:?} {shape:?}: {worst:e}");
            // The comparison sees a table that is a little too bright.
            let mut wrong = set.clone();
            wrong.tables[0].mapv_inplace(|value| 1.01 * value);
            assert!(difference(&expected, &picture(&scene, &wrong), scene.exposure) > ALLOWED, "{shape:?}");
        }
    }
}

/// Light from one direction and parallel rays: `|q|² = 2 + 2 wi·wo` is one number, and `t` follows from the radius.
#[test]
fn a_ball_asks_for_one_depth_at_each_texel() {
    let (fields, optics, tables) = ([surface()], daylight(Windows::Grid), config(601));
    let sun = [0.3, 0.2, 1.0];
    let scene = Scene { size_px: 200, ..scene(Shape::Sphere, vec![light(sun, 0.53)]) };
    let input = BuildInput::new(&fields, &optics, &tables);
    let covered = looked_up(&SceneLookUps::new(&scene), grid(&input), 2).unwrap();
    let [reached, all] = covered.disc_texels();
    // Whatever faces neither light nor camera is missing, and the disc beyond |q|: sin² of half the angle between them.
    let cosine = 1.0 / (sun[0] * sun[0] + sun[1] * sun[1] + 1.0f64).sqrt();
    let share = reached as f64 / all as f64;
    assert!(share < 0.5 + 0.5 * cosine + 0.02 && share > 0.9, "{share}");
    assert!(covered.count() < all, "{} of {all}", covered.count());
    // The sun's disc spreads |q|² by its diameter times the sine; and a texel's look-ups lie up to a diagonal away.
    let spread = 2.0 * 0.53f64.to_radians() * (1.0 - cosine * cosine).sqrt() * (1.0 + 2.0 / 16.0);
    let diagonal = 1.01 * std::f64::consts::SQRT_2 * covered.grid.texel();
    for (row, column, t) in covered.iter() {
        let radius = covered.grid.u(column).hypot(covered.grid.v(row));
        let [low, high] = covered.abs_w_at(row, column, t).map(|w| w * w + radius * radius);
        let expected = 2.0 + 2.0 * cosine;
        assert!(
            (low - expected).abs().max((high - expected).abs()) < spread + 4.0 * radius.max(0.1) * diagonal,
            "{radius}"
        );
    }
    // Every texel lies in one ring, which holds its `|w|`, and rings lie side by side.
    let plan = plan_for(&input, Some(covered.clone())).unwrap();
    assert!(plan.rings.windows(2).all(|pair| pair[0].radius[0] == pair[1].radius[1]));
    for (row, column, t) in covered.iter() {
        let radius = covered.grid.u(column).hypot(covered.grid.v(row));
        let own: Vec<_> = plan.rings.iter().filter(|ring| ring.holds(radius)).collect();
        let [low, high] = covered.abs_w_at(row, column, t);
        assert!(own.len() == 1 && own[0].abs_w[0] <= low && high <= own[0].abs_w[1], "{radius}");
    }
}

#[test]
fn what_is_not_covered_has_no_answer() {
    let (fields, optics, tables) = ([surface()], daylight(Windows::Grid), config(101));
    let input = BuildInput::new(&fields, &optics, &tables);
    let patch = Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 30.0, turn_deg: 0.0 };
    let scene = scene(patch, vec![light([0.35, 0.866, 0.5], 0.53)]);
    let (set, covered) = restricted(&input, &scene);
    let gathered = samples(&scene).unwrap();
    for (wi, wo) in gathered.wi.iter().zip(&gathered.wo) {
        assert!(answers(&set, Interpolation::Bilinear, wi.map(f64::from), wo.map(f64::from)));
    }
    let normal = [0.0, 0.0, 1.0];
    // Normal to normal lies at u = v = 0, where this patch does not look; so does a pair of the covered (u, v) at
    // another depth.
    let (wi, wo) = (gathered.wi[0].map(f64::from), gathered.wo[0].map(f64::from));
    let shallower = pair_at([-wi[0] - wo[0], -wi[1] - wo[1]], 0.3 * (wi[2] + wo[2]));
    for (wi, wo) in [(normal, normal), shallower] {
        assert!(!answers(&set, Interpolation::Bilinear, wi, wo));
        assert!(brdf_xyz(&set, Interpolation::Bilinear, wi, wo).iter().all(|value| value.is_nan()));
    }
    assert!(covered.count() < 1_000);
    // Below the surface there is nothing to look up, covered or not.
    assert_eq!(brdf_xyz(&set, Interpolation::Bilinear, normal, [0.0, 0.0, -1.0]), [0.0; 3]);
    // Another light asks for what is not there: the picture shows it.
    let elsewhere = Scene { lights: vec![light([-0.5, 0.866, 0.5], 0.53)], ..scene };
    assert!(picture(&elsewhere, &set).iter().all(|value| value.is_nan() || *value == 0.0));
}

/// What every step saves: predicted from the plan, and counted while building without it.
#[test]
fn every_step_taken_back_costs_what_the_plan_says() {
    // A window wide enough for the wavelengths to depend on the radius.
    let optics = OpticsConfig { sigma_nm: 9_000.0, ..daylight(Windows::Grid) };
    let (fields, tables) = ([surface()], config(301));
    let input = BuildInput::new(&fields, &optics, &tables);
    let patch = Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 30.0, turn_deg: 0.0 };
    let scene = scene(patch, vec![light([0.9, 0.4, 0.3], 0.53)]);
    let covered = cover(&input, &[&scene]).unwrap();
    let taken = measure(&input, &plan_for(&input, Some(covered.clone())).unwrap()).unwrap();
    // Tables for every direction would be asked for ten times the accuracy.
    let whole = TablesConfig { tolerance: 0.1 * TOLERANCE, ..tables.clone() };
    let budget = account(&input, &[&scene], &covered, &whole, taken, true).unwrap();
    let steps: Vec<_> = budget.rows.iter().filter_map(|row| row.step).collect();
    let expected = [Pruning::Texels, Pruning::Ranges, Pruning::Wavelengths, Pruning::Lobe, Pruning::Tolerance];
    assert_eq!(steps, expected, "daylight, and a patch that does not look into the lobe");
    for row in &budget.rows {
        let (predicted, without) = (row.with_it, row.measured.unwrap());
        println!(
            "{}: predicted {:.2e} sums and {:.2e} bytes, counted {:.2e} and {:.2e}; with the step {:.2e} and {:.2e}",
            row.what,
            predicted.node_samples,
            predicted.stored_bytes,
            without.node_samples,
            without.stored_bytes,
            taken.node_samples,
            taken.stored_bytes
        );
        match row.step {
            // The lobe costs no sums but a file of its own.
            Some(Pruning::Lobe) => assert!(without.stored_bytes > taken.stored_bytes + 1_000.0),
            _ => {
                assert!(without.node_samples > 1.2 * taken.node_samples, "{} saves next to nothing", row.what);
                // The number of nodes is a forecast; texels and wavelengths are counted.
                let ratio = predicted.node_samples / without.node_samples;
                assert!((0.5..2.0).contains(&ratio), "{}: predicted {ratio} times what it takes", row.what);
            }
        }
    }
    // The same accuracy asked of all: nothing is saved by asking for less.
    let same = account(&input, &[&scene], &covered, &tables, taken, false).unwrap();
    assert!(same.rows.iter().all(|row| row.step != Some(Pruning::Tolerance)));
}

/// Two of the bundled manifest's specimens at its own settings: a snake, and a grating, dark between its orders.
#[test]
fn bundled_specimens_look_the_same() {
    for name in ["corn_snake_like", "blazed_2500nm"] {
        let path = format!("{}/specimens/{name}.tif", env!("CARGO_MANIFEST_DIR"));
        let scan = read_scan(std::path::Path::new(&path), &ReadConfig::default()).unwrap();
        let prepared = PrepareConfig { level: Level::None, despike: None, blend_nm: None };
        let fields = [prepare(&scan.field, &prepared).unwrap().0];
        let optics = crate::common::reference_optics(4_000.0, Edge::Tile);
        let optics = OpticsConfig { windows: Windows::Grid, ..optics };
        let tables = config(601);
        let input = BuildInput::new(&fields, &optics, &tables);
        let scene = Scene { size_px: 96, ..scene(Shape::Snake, vec![light([0.3, 0.2, 1.0], 0.53)]) };
        let (set, covered) = restricted(&input, &scene);
        let (full, _) = build(&input, &|_| ()).unwrap();
        let worst = difference(&picture(&scene, &full), &picture(&scene, &set), scene.exposure);
        println!("{name}: {} tables against {}, worst {worst:.1e}", set.tables.len(), full.tables.len());
        assert!(worst <= ALLOWED && set.tables.len() < full.tables.len());
        // Exposed by hand, a picture may look into the dark: no less is asked for than before dark places were left out.
        let by_hand = Scene { exposure: Exposure::Ev(20.0), ..scene };
        let (deep, covered_by_hand) = restricted(&input, &by_hand);
        println!("{} tables for the dark", deep.tables.len());
        assert!(deep.tables.len() >= set.tables.len() + usize::from(name.starts_with("blazed")));
        assert!(
            covered.iter().eq(covered_by_hand.iter()) && covered != covered_by_hand,
            "only what counts as dark differs"
        );
    }
}

fn direction() -> impl Strategy<Value = [f64; 3]> {
    // Down to the horizon, where lights graze.
    (0.0..std::f64::consts::TAU, 0.02..1.0f64).prop_map(|(phi, z)| {
        let r = (1.0 - z * z).sqrt();
        [r * phi.cos(), r * phi.sin(), z]
    })
}

fn any_shape() -> impl Strategy<Value = Shape> {
    prop_oneof![
        Just(Shape::Sphere),
        Just(Shape::Hemisphere),
        Just(Shape::Snake),
        (2.0..50.0f64, -40.0..10.0f64, -90.0..90.0f64).prop_map(|(ratio, tilt_deg, turn_deg)| Shape::Patch {
            width_mm: 10.0,
            distance_mm: 10.0 * ratio,
            tilt_deg,
            turn_deg,
        }),
        (10.0..100.0f64, -60.0..60.0f64).prop_map(|(distance_mm, incidence_deg)| Shape::Screen {
            distance_mm,
            width_mm: 80.0,
            beam_diameter_mm: 1.0,
            hole_diameter_mm: None,
            incidence_deg,
        }),
    ]
}

/// Tables for a scene show it as tables for every direction do, if it looks at anything.
fn check_scene(scene: &Scene) -> Result<(), TestCaseError> {
    let (fields, optics, tables) = ([surface()], daylight(Windows::Grid), config(101));
    let input = BuildInput::new(&fields, &optics, &tables);
    prop_assume!(cover(&input, &[scene]).unwrap().count() > 0);
    let (set, _) = restricted(&input, scene);
    static FULL: std::sync::OnceLock<TableSet> = std::sync::OnceLock::new();
    let full = FULL.get_or_init(|| {
        // More tables than the tolerance asks for: what is compared is the restricted set.
        let many = TablesConfig { count: Some(8), ..config(101) };
        build(&BuildInput::new(&[surface()], &daylight(Windows::Grid), &many), &|_| ()).unwrap().0
    });
    let worst = difference(&picture(scene, full), &picture(scene, &set), scene.exposure);
    prop_assert!(worst <= ALLOWED, "{worst:e}");
    Ok(())
}

/// A scene with one light or two, where its shape takes two.
fn any_scene() -> impl Strategy<Value = Scene> {
    let lights = (direction(), direction(), 0.0..8.0f64, any::<bool>());
    (any_shape(), lights, 16..48usize).prop_map(|(shape, (a, b, wide, two), size_px)| {
        let hemisphere = matches!(shape, Shape::Hemisphere | Shape::Screen { .. });
        let lights = if two && !hemisphere { vec![light(a, wide), light(b, 0.0)] } else { vec![light(a, wide)] };
        Scene { size_px, ..scene(shape, lights) }
    })
}

/// What lies between the samples is covered too: another renderer's samples, anywhere in the same pixels and lights.
fn check_other_samples(scene: Scene) -> Result<(), TestCaseError> {
    let (fields, optics, tables) = ([surface()], daylight(Windows::Grid), config(101));
    let input = BuildInput::new(&fields, &optics, &tables);
    prop_assume!(cover(&input, &[&scene]).unwrap().count() > 0);
    let (set, _) = restricted(&input, &scene);
    let other = samples(&Scene { pixel_samples: 13, light_samples: 13, ..scene }).unwrap();
    let asked = other.weight.len();
    let missed = other
        .wi
        .iter()
        .zip(&other.wo)
        .filter(|(wi, wo)| !answers(&set, Interpolation::Bilinear, wi.map(f64::from), wo.map(f64::from)));
    // At the outline of a ball a pixel's surface turns away without end: its last half pixel is not foreseen.
    let missed = missed.count();
    prop_assert!(missed * 100 <= asked, "{missed} of {asked}");
    Ok(())
}

fn ball_or_patch() -> impl Strategy<Value = Scene> {
    let shape = prop_oneof![
        Just(Shape::Sphere),
        Just(Shape::Patch { width_mm: 10.0, distance_mm: 30.0, tilt_deg: -20.0, turn_deg: 30.0 }),
    ];
    (shape, direction(), 0.0..5.0f64)
        .prop_map(|(shape, a, wide)| Scene { size_px: 32, ..scene(shape, vec![light(a, wide)]) })
}

/// Two scenes that tables once covered badly: a beam along the horizon, and a patch turned away from its light.
#[test]
fn scenes_at_the_horizon_look_the_same() {
    let grazing = [0.999_799_979_995_999, 0.0, 0.02];
    let screen = Shape::Screen {
        distance_mm: 24.133_629_829_311_886,
        width_mm: 80.0,
        beam_diameter_mm: 1.0,
        hole_diameter_mm: None,
        incidence_deg: 39.863_292_560_652_12,
    };
    let patch = Shape::Patch {
        width_mm: 10.0,
        distance_mm: 26.769_978_677_030_654,
        tilt_deg: -32.985_597_566_792_83,
        turn_deg: 0.0,
    };
    let away = [-0.428_234_836_387_242_1, -0.830_646_150_672_190_8, 0.355_867_195_001_268_6];
    for (shape, direction, size_px) in [(screen, grazing, 21), (patch, away, 16)] {
        check_scene(&Scene { size_px, ..scene(shape, vec![light(direction, 0.0)]) }).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(6) })]

    /// Random cameras and lights, down to grazing: the same picture, and every sample has an answer.
    #[test]
    fn random_scenes_look_the_same(scene in any_scene()) {
        check_scene(&scene)?;
    }

    #[test]
    fn other_samples_of_the_same_scene_are_answered(scene in ball_or_patch()) {
        check_other_samples(scene)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    #[ignore = "slow: as the one above in more scenes"]
    fn many_random_scenes_look_the_same(scene in any_scene()) {
        check_scene(&scene)?;
    }

    #[test]
    #[ignore = "slow: as the one above in more scenes"]
    fn other_samples_of_many_scenes_are_answered(scene in ball_or_patch()) {
        check_other_samples(scene)?;
    }
}
