//! Every kind of table set, in every kind of scene, agrees with the CPU within the derived bound.

use diffraction_atlas::stages::gpu::check::{check_specimen, check_uploaded};
use diffraction_brdf::shader::table_image;
use diffraction_build::optics::config::{Material, Windows};
use diffraction_build::optics::pigment::{Surface, pigment};
use diffraction_build::tables::model::{Basis, TableSet};
use diffraction_render::render::gpu_tables::upload;
use half::f16;

use crate::sets::{self, build_set, full_set, gpu, restricted_set, scenes, sphere};

fn agrees(name: &str, surface: Surface) {
    let Some(gpu) = gpu(name) else { return };
    for check in check_specimen(gpu, surface, &scenes()).unwrap() {
        println!(
            "{name} {}: worst {:.2e}, mean {:.2e} of white; allowed {:.2e}, {:.2e}; share {:.3}; dE {:.4}",
            check.scene,
            check.worst,
            check.mean,
            check.tolerance,
            check.tolerance_mean,
            check.worst_of_tolerance,
            check.ciede2000.max
        );
        assert!(check.samples > 100, "{}: nothing to see", check.scene);
        assert!(check.worst > 0.0, "{}: no difference at all is no comparison", check.scene);
        assert!(check.passed, "{name}: {check:?}");
    }
}

#[test]
fn lobe_and_cross_term_with_a_conductor_and_shadowing() {
    let set = full_set();
    assert!(set.lobe.as_ref().is_some_and(|lobe| !lobe.cross.is_empty()));
    agrees("full", Surface::without_pigment(set));
}

#[test]
fn lobe_without_cross_term_on_a_dielectric() {
    let set = build_set(Basis::Chebyshev, Windows::Grid, Material::Dielectric { n: 1.56 }, false);
    assert!(set.lobe.as_ref().is_some_and(|lobe| lobe.cross.is_empty()));
    agrees("mean", Surface::without_pigment(&set));
}

#[test]
fn a_pigment_below_the_structure() {
    let material = Material::Dielectric { n: 1.56 };
    let set = build_set(Basis::Chebyshev, Windows::Grid, material, true);
    let mut pigment = pigment([0.4, 0.2, 0.1], &sets::optics(Windows::Grid, material, true)).unwrap();
    let image = table_image(&set, Some(pigment.xyz_per_sr)).unwrap();
    agrees("pigment", Surface { tables: &set, pigment: Some(&pigment) });
    // A pigment 0.1 % off is another picture.
    let Some(gpu) = gpu("pigment") else { return };
    let tables = upload(gpu, &image).unwrap();
    pigment.xyz_per_sr[1] *= 1.001;
    let other = Surface { tables: &set, pigment: Some(&pigment) };
    assert!(!check_uploaded(gpu, &tables, other, &sphere(32)).unwrap().passed);
}

#[test]
fn powers_of_w_on_an_ideal_reflector() {
    agrees("taylor", Surface::without_pigment(&build_set(Basis::Taylor, Windows::Centre, Material::Ideal, false)));
}

/// Tables for one scene: a window of the grid, a range of `|w|` in each texel.
#[test]
fn tables_restricted_to_one_scene() {
    let Some(gpu) = gpu("restricted tables") else { return };
    for scene in scenes() {
        let set = restricted_set(&scene);
        assert!(set.restriction.is_some());
        let check =
            check_specimen(gpu, Surface::without_pigment(&set), std::slice::from_ref(&scene)).unwrap().remove(0);
        println!("{}: share {:.3} of {:.2e}", check.scene, check.worst_of_tolerance, check.tolerance);
        assert!(check.passed && check.worst > 0.0, "{check:?}");
    }
}

/// What they do not cover has no answer on the GPU either.
#[test]
fn look_ups_beyond_what_is_covered_fail() {
    let Some(gpu) = gpu("beyond what is covered") else { return };
    let patch = scenes().swap_remove(2);
    let set = restricted_set(&patch);
    let check = check_specimen(gpu, Surface::without_pigment(&set), &[sphere(24)]).unwrap().remove(0);
    assert!(!check.passed && check.not_finite > 0, "{check:?}");
}

/// Where the atlas stores halves nothing is lost on the way to the GPU, and the tolerance knows it.
#[test]
fn stored_halves_tighten_the_tolerance() {
    let Some(gpu) = gpu("stored halves") else { return };
    let mut set = full_set().clone();
    let check = |set: &TableSet| check_specimen(gpu, Surface::without_pigment(set), &[sphere(32)]).unwrap().remove(0);
    let float = check(&set);
    for table in &mut set.tables {
        let scale = diffraction_brdf::storage::half_scale(diffraction_brdf::shader::peak(table));
        table.mapv_inplace(|value| f16::from_f32(value / scale).to_f32() * scale);
    }
    let half = check(&set);
    println!(
        "allowed {:.2e} for floats, {:.2e} for halves; share {:.3}, {:.3}",
        float.tolerance_mean, half.tolerance_mean, float.worst_of_tolerance, half.worst_of_tolerance
    );
    assert!(half.passed && half.tolerance_mean < float.tolerance_mean, "{half:?} {float:?}");
}
