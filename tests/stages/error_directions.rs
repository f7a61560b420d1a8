//! The directions on which a run counts errors: enough above the floor even of a grating, and light that tables miss is found.

use std::f64::consts::TAU;

use crate::common::surfaces::{random, sampled, tables_config};
use diffraction_brdf::direction::{from_angles_deg, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::accuracy::directions::{Candidates, ErrorDirections, Group};
use diffraction_build::accuracy::reference;
use diffraction_build::accuracy::rows::{Cause, ErrorRow, error_rows};
use diffraction_build::ground::sampling::{Region, direction_pairs, near_specular_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::TableSet;
use diffraction_build::tables::plan::plan;

fn daylight() -> OpticsConfig {
    OpticsConfig::ideal(Illuminant::D65, 1500.0, Edge::Tile, Windows::Grid)
}

fn tables(field: &HeightField) -> TableSet {
    build(&BuildInput::new(std::slice::from_ref(field), &daylight(), &tables_config(1e-3, Some(201))), &|_| ())
        .unwrap()
        .0
}

/// Rows of tables against the field's reference, at directions that the tables themselves choose.
fn rows(field: &HeightField, set: &TableSet) -> Vec<ErrorRow> {
    let fields = std::slice::from_ref(field);
    let plan = plan(&BuildInput::new(fields, &daylight(), &tables_config(1e-3, Some(201)))).unwrap();
    let directions = ErrorDirections::of_regions(set);
    let reference = reference::evaluate(fields, &daylight(), &plan, set.tables.len(), directions, []).unwrap();
    error_rows(&reference, set, set)
}

fn total(rows: &[ErrorRow], region: Region) -> &ErrorRow {
    rows.iter().find(|row| row.cause == Cause::TotalCubic && row.group == Group::Region(region)).unwrap()
}

#[test]
fn a_grating_shows_as_many_lit_directions_as_anything() {
    let grating = sampled([128, 32], [50.0, 200.0], |x, _| 60.0 * (TAU * x / 1600.0).sin());
    let set = tables(&grating);
    let found = rows(&grating, &set);
    let floor = total(&found, Region::Hemisphere).floor_per_sr;
    for region in Region::ALL {
        let row = total(&found, region);
        println!(
            "{}: {} above the floor of {:.3}, 95 % {:.1e}, L2 {:.1e}",
            row.group, row.directions, row.share_above, row.p95, row.relative_l2
        );
        assert!((110..=160).contains(&row.directions) && row.floor_per_sr == floor, "{row:?}");
        assert_eq!(row.missed_directions, 0, "{row:?}");
    }
    // Drawn as they come, few would be.
    let above = |&(wi, wo): &_| brdf_xyz(&set, Interpolation::Cubic, wi, wo)[1] > floor;
    let unselected = direction_pairs(Region::Hemisphere, 128).iter().filter(|pair| above(pair)).count();
    assert!(unselected < 32 && total(&found, Region::Hemisphere).share_above < 0.25, "{unselected}");
    // 1 % of a matt surface that reflects everything, or more.
    assert!(floor >= 1e-2 / std::f64::consts::PI);
}

/// A lobe that reaches far beyond five degrees: what is said of "near specular" holds on its flank too.
#[test]
fn errors_near_the_mirror_are_those_of_the_lobes_flank() {
    let smooth = random([96, 96], [100.0, 100.0], 400.0, 15.0, 3);
    let optics = OpticsConfig { sigma_nm: 700.0, ..daylight() };
    let fields = std::slice::from_ref(&smooth);
    let config = tables_config(1e-3, Some(201));
    let input = BuildInput::new(fields, &optics, &config);
    let set = build(&input, &|_| ()).unwrap().0;
    let plan = plan(&input).unwrap();
    let spectra = diffraction_build::optics::spectral::brdf_xyz_batch;
    // Where the lobe has fallen to a hundredth to a millionth of its peak, three deviations and more from the mirror.
    let deviation = 550.0 / (TAU * std::f64::consts::SQRT_2 * optics.sigma_nm);
    let flank = |&(wi, wo): &(_, _)| {
        let [u, v, _] = wave_vector_change(wi, wo);
        (3.0..5.0).contains(&(u.hypot(v) / deviation))
    };
    let on_flank: Vec<_> =
        near_specular_pairs(60.0, 1 << 20..(1 << 20) + 4000).into_iter().filter(flank).take(160).collect();
    let exact = spectra(fields, &optics, &plan.spectra, &on_flank).unwrap();
    let mut errors: Vec<f64> = on_flank
        .iter()
        .zip(&exact)
        .map(|(&(wi, wo), exact)| (brdf_xyz(&set, Interpolation::Cubic, wi, wo)[1] / exact[1] - 1.0).abs())
        .collect();
    errors.sort_by(f64::total_cmp);
    let true_p95 = errors[errors.len() * 95 / 100];
    let stated = |candidates: Vec<Candidates>| {
        let directions = ErrorDirections::drawn(&set, candidates, 128);
        let reference = reference::evaluate(fields, &optics, &plan, set.tables.len(), directions, []).unwrap();
        total(&error_rows(&reference, &set, &set), Region::NearSpecular).clone()
    };
    let candidates = || Candidates::of_regions(&set, 0);
    let told = stated(candidates());
    let narrow = |of: Candidates| match of.group {
        Group::Region(Region::NearSpecular) => {
            Candidates { pairs: direction_pairs(Region::NearSpecular, of.pairs.len()), ..of }
        }
        _ => of,
    };
    let before = stated(candidates().into_iter().map(narrow).collect());
    println!("flank {true_p95:.1e}; stated {:.1e}, within five degrees {:.1e}", told.p95, before.p95);
    assert!(told.p95 > 0.5 * true_p95, "{} {true_p95}", told.p95);
    assert!(before.p95 < 0.5 * true_p95, "{} {true_p95}", before.p95);
}

#[test]
fn light_that_the_tables_miss_is_found() {
    let rough = random([96, 96], [100.0, 100.0], 400.0, 60.0, 3);
    let whole = tables(&rough);
    let mut torn = whole.clone();
    for table in &mut torn.tables {
        let right = ndarray::Slice::from(100..);
        table.slice_axis_mut(ndarray::Axis(1), right).fill(0.0);
    }
    for region in [Region::Hemisphere, Region::Grazing] {
        let [good, bad] = [&whole, &torn].map(|set| total(&rows(&rough, set), region).clone());
        println!("{good:?}\n{bad:?}");
        assert!(good.missed_directions == 0 && good.worst < 0.2 && good.relative_l2 < 0.05, "{good:?}");
        // Of what these tables show below the floor, as much is above it as they lack; so many of 32 drawn within four deviations. They
        // call above what has half of the floor, which makes it a few less.
        let lacking = (good.share_above - bad.share_above) / (1.0 - bad.share_above);
        let fewest = 32.0 * lacking - 4.0 * (32.0 * lacking * (1.0 - lacking)).sqrt();
        assert!(bad.missed_directions as f64 >= fewest.max(8.0) && bad.worst > 0.9, "{fewest}: {bad:?}");
        assert!(bad.relative_l2 > 4.0 * good.relative_l2, "{} {}", bad.relative_l2, good.relative_l2);
    }
}

#[test]
fn tables_without_light_are_not_right_for_it() {
    let rough = random([96, 96], [100.0, 100.0], 400.0, 60.0, 3);
    let mut dark = tables(&rough);
    dark.tables.iter_mut().for_each(|table| table.fill(0.0));
    dark.lobe = None;
    for row in rows(&rough, &dark).iter().filter(|row| row.cause == Cause::Total) {
        assert!(row.share_above == 0.0 && row.directions_below == 160, "{row:?}");
        assert!(row.missed_directions > 80 && row.p50 == 1.0 && row.relative_l2 == 1.0, "{row:?}");
    }
}

#[test]
fn directions_stand_for_their_share_and_depend_on_nothing_else() {
    let rough = random([96, 96], [100.0, 100.0], 400.0, 60.0, 3);
    let set = tables(&rough);
    let drawn = |turn, count| ErrorDirections::drawn(&set, Candidates::of_regions(&set, turn), count);
    let few = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap().install(|| drawn(0, 128));
    let many = drawn(0, 128);
    assert!(few.pairs == many.pairs && few.groups == many.groups);
    assert_eq!(many.pairs.len(), many.groups.iter().map(|group| group.len()).sum::<usize>());
    for group in &many.groups {
        let weights = group.weights();
        let [above, _] = group.counts;
        assert!((weights[..above].iter().sum::<f64>() - group.share_above).abs() < 1e-12, "{group:?}");
        assert!(group.counts[1] == 0 || (weights.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{group:?}");
    }
    // Another turn has other directions, not one in common.
    let others = drawn(1, 64);
    assert!(others.pairs.iter().all(|pair| !many.pairs.contains(pair)));
}

/// Where both directions graze on one side, (u, v) lies at the rim of the disc: look-ups err by how many texels away it is.
#[test]
fn cubic_look_ups_err_within_two_texels_of_the_rim() {
    let rough = random([160, 160], [80.0, 80.0], 400.0, 40.0, 9);
    let fields = std::slice::from_ref(&rough);
    let plan = plan(&BuildInput::new(fields, &daylight(), &tables_config(1e-3, Some(51)))).unwrap();
    let at = |theta_deg: f64| -> Vec<_> {
        let pair = |i: u32| {
            let phi = 11.0 + 17.0 * f64::from(i);
            (from_angles_deg(theta_deg, phi), from_angles_deg(theta_deg - 1.0, phi + 2.0 * f64::from(i % 3)))
        };
        (0..20).map(pair).collect()
    };
    let (mut inside, mut at_rim) = (0.0f64, 0.0f64);
    for theta in [72.0, 76.0, 80.0, 83.0, 86.0, 89.0] {
        let pairs = at(theta);
        let exact =
            diffraction_build::optics::spectral::brdf_xyz_batch(fields, &daylight(), &plan.spectra, &pairs).unwrap();
        for size in [201, 401, 801] {
            let set =
                build(&BuildInput::new(fields, &daylight(), &tables_config(1e-3, Some(size))), &|_| ()).unwrap().0;
            for (&(wi, wo), exact) in pairs.iter().zip(&exact) {
                let [u, v, _] = wave_vector_change(wi, wo);
                let texels = (2.0 - u.hypot(v)) * (size as f64 - 1.0) / 4.0;
                let error = (brdf_xyz(&set, Interpolation::Cubic, wi, wo)[1] / exact[1] - 1.0).abs();
                if texels > 2.0 {
                    inside = inside.max(error);
                } else if texels < 0.5 {
                    at_rim = at_rim.max(error);
                }
            }
        }
    }
    println!("more than two texels from the rim {inside:.1e}, within half a texel {at_rim:.1e}");
    assert!(inside < 3e-3 && at_rim > 0.05, "{inside} {at_rim}");
}
