//! The check fails when anything of what is uploaded is wrong.

use diffraction_atlas::stages::gpu::check::check_uploaded;
use diffraction_atlas::stages::gpu::results::GpuSceneCheck;
use diffraction_brdf::shader::{TableImage, table_image};
use diffraction_build::optics::pigment::Surface;
use diffraction_render::render::gpu_tables::upload;
use half::f16;

use crate::sets::{full_set, gpu, restricted_set, sphere};

/// The check of the full set with an upload that was tampered with.
fn check_with(test: &str, tamper: impl FnOnce(&mut TableImage)) -> Option<GpuSceneCheck> {
    let gpu = gpu(test)?;
    let set = full_set();
    let mut image = table_image(set, None).unwrap();
    tamper(&mut image);
    Some(check_uploaded(gpu, &upload(gpu, &image).unwrap(), Surface::without_pigment(set), &sphere(48)).unwrap())
}

fn must_fail(what: &str, tamper: impl FnOnce(&mut TableImage)) {
    let Some(check) = check_with(what, tamper) else { return };
    println!("{what}: {:.1e} times what is allowed", check.worst_of_tolerance);
    assert!(!check.passed && check.difference.is_some(), "{what} went unnoticed: {check:?}");
}

fn layer(image: &mut TableImage, n: usize) -> &mut [[f16; 4]] {
    let texels = image.tables.size[0] * image.tables.size[1];
    &mut image.tables.texels[n * texels..(n + 1) * texels]
}

#[test]
fn nothing_changed_passes() {
    if let Some(check) = check_with("untouched", |_| ()) {
        assert!(check.passed);
    }
}

#[test]
fn a_table_set_to_zero() {
    for n in 0..full_set().tables.len() {
        must_fail(&format!("table {n} zero"), |image| layer(image, n).fill([f16::ZERO; 4]));
    }
}

#[test]
fn a_flipped_sign() {
    for n in 0..full_set().tables.len() {
        must_fail(&format!("table {n} negative"), |image| {
            for texel in layer(image, n) {
                *texel = texel.map(|value| -value);
            }
        });
    }
}

#[test]
fn a_wrong_scale() {
    must_fail("scale 0 up by 2 %", |image| image.params.table_scales[0][0] *= 1.02);
    must_fail("scale 1 doubled", |image| image.params.table_scales[0][1] *= 2.0);
    must_fail("scale of a cross term doubled", |image| image.params.cross_scales[0][0] *= 2.0);
}

#[test]
fn exchanged_layers() {
    must_fail("tables 0 and 1 exchanged", |image| {
        let texels = image.tables.size[0] * image.tables.size[1];
        let (first, second) = image.tables.texels.split_at_mut(texels);
        first.swap_with_slice(&mut second[..texels]);
        image.params.table_scales[0].swap(0, 1);
    });
    must_fail("last table left out", |image| image.params.table_count -= 1);
}

#[test]
fn a_mirrored_or_shifted_table() {
    must_fail("rows upside down", |image| {
        let side = image.tables.size[0];
        let rows: Vec<_> = layer(image, 0).chunks(side).rev().flatten().copied().collect();
        layer(image, 0).copy_from_slice(&rows);
    });
    must_fail("one column further", |image| layer(image, 0).rotate_right(1));
}

/// What holds where tables are restricted to one scene.
#[test]
fn a_wrong_range_or_window() {
    let scene = sphere(32);
    let set = restricted_set(&scene);
    let Some(gpu) = gpu("range") else { return };
    let check = |tamper: &dyn Fn(&mut TableImage)| {
        let mut image = table_image(&set, None).unwrap();
        tamper(&mut image);
        check_uploaded(gpu, &upload(gpu, &image).unwrap(), Surface::without_pigment(&set), &scene).unwrap()
    };
    assert!(check(&|_| ()).passed);
    let range = |image: &mut TableImage, change: &dyn Fn([f16; 4]) -> [f16; 4]| {
        let layer = layer(image, set.tables.len());
        layer.iter_mut().for_each(|texel| *texel = change(*texel));
    };
    type Tamper<'a> = &'a dyn Fn(&mut TableImage);
    let tampers: [(&str, Tamper); 5] = [
        ("lowest `t` 5 % down", &|image| {
            range(image, &|[low, high, there, x]| [low * f16::from_f32(0.95), high, there, x])
        }),
        ("nothing covered", &|image| range(image, &|[low, high, _, x]| [low, high, f16::ZERO, x])),
        ("window one column further", &|image| image.params.first_column += 1.0),
        ("window one row further", &|image| image.params.first_row += 1.0),
        ("range not looked at", &|image| image.params.restricted = 0),
    ];
    for (what, tamper) in tampers {
        let check = check(tamper);
        println!("{what}: {:.1e} times what is allowed", check.worst_of_tolerance);
        assert!(!check.passed, "{what} went unnoticed: {check:?}");
    }
}

#[test]
fn a_wrong_lobe() {
    must_fail("lobe 2 % up", |image| image.coherent.iter_mut().for_each(|texel| *texel = texel.map(|v| 1.02 * v)));
    must_fail("lobe 1 % wider", |image| image.params.radius_max *= 1.01);
    must_fail("cross term left out", |image| image.params.cross_count = 0);
}

#[test]
fn a_wrong_material() {
    must_fail("no reflectance", |image| image.params.material = 0);
    must_fail("1 % of the index", |image| image.params.index_k *= 1.01);
    must_fail("no shadowing", |image| image.params.shadowing = 0);
}

#[test]
fn a_number_that_is_not_finite() {
    must_fail("infinite texel", |image| {
        let middle = image.tables.size[0] * image.tables.size[1] / 2;
        layer(image, 0)[middle][1] = f16::INFINITY;
    });
}
