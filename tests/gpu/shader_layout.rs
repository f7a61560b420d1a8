//! The shaders as naga reads them: byte layouts against the Rust side.

use diffraction_brdf::shader::{LAYERS_MAX, TABLES_WGSL, TableParams};
use diffraction_brdf::shader_spectral::{SPECTRAL_WGSL, SpectralParams};
use diffraction_render::render::gpu_filtered::FilteredQuery;
use diffraction_render::render::gpu_layout::{FrameLight, FrameParams, Run, ShadingSample};
use diffraction_render::render::gpu_sampled::SampledQuery;
use diffraction_render::render::gpu_spectral::SpectralQuery;
use diffraction_render::render::wgsl;
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
        restricted,
        grid_last,
        first_column,
        first_row,
        factor,
        look_up,
        permittivity,
        pigment,
        table_scales,
        cross_scales
    });
    assert_eq!(layout_in_shader(&check, "TableParams"), params);
    assert_eq!(layout_in_shader(&check, "ShadingSample"), layout_in_rust!(ShadingSample { wi, weight, wo }));
    assert_eq!(layout_in_shader(&check, "Run"), layout_in_rust!(Run { first, count }));
    let params = layout_in_rust!(FrameParams { size_px, light_count, lit_words, exposure });
    assert_eq!(layout_in_shader(&frame, "FrameParams"), params);
    let light = layout_in_rust!(FrameLight { direction, irradiance, layer, angular_radius });
    assert_eq!(layout_in_shader(&frame, "FrameLight"), light);
}

#[test]
fn structs_of_spectral_tables_have_the_same_bytes() {
    let check = module(&wgsl::spectral_check());
    let params = layout_in_rust!(SpectralParams {
        table_layers,
        cross_layers,
        lobe_count,
        material,
        factor,
        shadowing,
        index_n,
        index_k,
        permittivity,
        shortest_nm,
        lobe_sigma_nm,
        cross_radius,
        of_source,
        look_up,
        table_scales,
        cross_scales
    });
    assert_eq!(layout_in_shader(&check, "SpectralParams"), params);
    let query = layout_in_rust!(SpectralQuery { wi, wavelength_nm, wo, own_index, index });
    assert_eq!(layout_in_shader(&check, "SpectralQuery"), query);
    let query = layout_in_rust!(FilteredQuery { wi, wavelength_nm, wo, angular_radius, normals, more });
    let drawn = module(&wgsl::sampled_check());
    assert_eq!(layout_in_shader(&drawn, "SampledQuery"), layout_in_rust!(SampledQuery { wo, more }));
    for source in [wgsl::filtered_check(), wgsl::filtered_spectral_check()] {
        assert_eq!(layout_in_shader(&module(&source), "FilteredQuery"), query);
    }
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
    for source in [TABLES_WGSL, SPECTRAL_WGSL] {
        let module = module(source);
        let arrays = module.types.iter().filter_map(|(_, ty)| match ty.inner {
            TypeInner::Array { size: naga::ArraySize::Constant(count), stride, .. } => Some((count.get(), stride)),
            _ => None,
        });
        assert_eq!(arrays.collect::<Vec<_>>(), [(LAYERS_MAX as u32 / 4, 16)]);
    }
}
