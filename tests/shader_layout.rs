//! The shaders as naga reads them: byte layouts and names against the Rust side.

use std::collections::BTreeSet;

use diffraction_atlas::render::gpu_layout::{FrameLight, FrameParams, LAYERS_MAX, Run, ShadingSample, TableParams};
use diffraction_atlas::render::wgsl;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{Module, TypeInner};

fn module(source: &str) -> Module {
    let module = naga::front::wgsl::parse_str(source).unwrap_or_else(|e| panic!("{}", e.emit_to_string(source)));
    // No capability beyond WebGPU's core.
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|e| panic!("{}", e.emit_to_string(source)));
    module
}

type Layout = (Vec<(String, usize)>, usize);

fn layout_in_shader(module: &Module, name: &str) -> Layout {
    let (_, ty) = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name)).expect(name);
    let TypeInner::Struct { members, span } = &ty.inner else { panic!("{name} is no struct") };
    let members = members.iter().map(|m| (m.name.clone().unwrap(), m.offset as usize)).collect();
    (members, *span as usize)
}

/// Names and offsets of the fields, and the size, of a Rust struct.
macro_rules! layout_in_rust {
    ($name:ident { $($field:ident),* }) => {
        (vec![$((stringify!($field).to_owned(), std::mem::offset_of!($name, $field))),*], size_of::<$name>())
    };
}

#[test]
fn structs_have_the_same_bytes() {
    let (check, frame) = (module(&wgsl::check()), module(&wgsl::frame()));
    let params = layout_in_rust!(TableParams {
        basis,
        table_count,
        cross_count,
        material,
        shadowing,
        radius_max,
        index_n,
        index_k,
        served,
        grid_last,
        first_column,
        first_row,
        pigment,
        table_scales,
        cross_scales
    });
    assert_eq!(layout_in_shader(&check, "TableParams"), params);
    assert_eq!(layout_in_shader(&check, "ShadingSample"), layout_in_rust!(ShadingSample { wi, weight, wo }));
    assert_eq!(layout_in_shader(&check, "Run"), layout_in_rust!(Run { first, count }));
    let params = layout_in_rust!(FrameParams { size_px, light_count, lit_words, exposure });
    assert_eq!(layout_in_shader(&frame, "FrameParams"), params);
    let light = layout_in_rust!(FrameLight { direction, irradiance, layer });
    assert_eq!(layout_in_shader(&frame, "FrameLight"), light);
}

#[test]
fn a_moved_field_is_noticed() {
    let source = wgsl::check()
        .replace("    basis: u32,\n", "")
        .replace("    index_k: f32,\n", "    index_k: f32,\n    basis: u32,\n");
    let moved = layout_in_shader(&module(&source), "TableParams");
    assert_ne!(moved, layout_in_shader(&module(&wgsl::check()), "TableParams"));
}

#[test]
fn lists_of_scales_hold_every_layer() {
    let module = module(wgsl::TABLES);
    let arrays = module.types.iter().filter_map(|(_, ty)| match ty.inner {
        TypeInner::Array { size: naga::ArraySize::Constant(count), stride, .. } => Some((count.get(), stride)),
        _ => None,
    });
    assert_eq!(arrays.collect::<Vec<_>>(), [(LAYERS_MAX as u32 / 4, 16)]);
}

/// Shader functions with their counterparts, file by file in the order of both.
const COUNTERPARTS: [(&str, &[&str]); 8] = [
    (include_str!("../src/ground/direction.rs"), &["wave_vector_change", "geometry_factor", "v_cavity_shadowing"]),
    (include_str!("../src/optics/fresnel.rs"), &["reflectance", "cos_half_angle"]),
    (include_str!("../src/optics/pigment.rs"), &["pigment_xyz"]),
    (include_str!("../src/optics/reference.rs"), &["prefactor"]),
    (include_str!("../src/tables/plan.rs"), &["w_reach"]),
    (include_str!("../src/ground/chebyshev.rs"), &["shifted_values"]),
    (
        include_str!("../src/tables/evaluate.rs"),
        &[
            "surface_xyz",
            "brdf_xyz",
            "window_power",
            "serves",
            "share_of_range",
            "t_of",
            "lobe_value",
            "expansion",
            "sample",
        ],
    ),
    (include_str!("../src/ground/colour.rs"), &["xyz_to_linear_srgb"]),
];

/// Functions only a shader needs: complex numbers, the second texture, texture coordinates, powers in registers.
const SHADER_ONLY: [&str; 7] = [
    "complex_product",
    "complex_quotient",
    "complex_root",
    "cross_expansion",
    "texel_centred",
    "table_place",
    "powers",
];

#[test]
fn functions_carry_the_names_and_the_order_of_the_rust_side() {
    let module = module(wgsl::TABLES);
    let in_shader: BTreeSet<String> = module.functions.iter().map(|(_, f)| f.name.clone().unwrap()).collect();
    let named = COUNTERPARTS.iter().flat_map(|(_, names)| names.iter()).chain(&SHADER_ONLY);
    assert_eq!(in_shader, named.map(|name| (*name).to_owned()).collect());
    for (rust, names) in COUNTERPARTS {
        for source in [rust, wgsl::TABLES] {
            let places = names.iter().map(|name| source.find(&format!("fn {name}(")).expect(name));
            assert!(places.clone().zip(places.skip(1)).all(|(a, b)| a < b), "order of {names:?}");
        }
    }
}
