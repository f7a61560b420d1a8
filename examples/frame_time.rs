//! Frame time of the coiled snake by number of tables: `cargo run --release --example frame_time [SIZE_PX [FRAMES]]`.
//!
//! Smooth made-up tables of 501 x 501 texels: the time does not depend on their values. Chebyshev sets have a coherent
//! lobe; 24 tables are what the published powers of w need for an error of 1e-6 at 250 nm of depth.

use diffraction_atlas::error::Result;
use diffraction_brdf::front_factor::{Factor, FrontFactor};
use diffraction_brdf::material::Material;
use diffraction_brdf::shader::table_image;
use diffraction_brdf::table_set::{Basis, Lobe, TableSet};
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_frame::{Frame, FramePlan, time_frames};
use diffraction_render::render::gpu_tables::upload;
use diffraction_render::scene::gbuffer::gbuffer;
use diffraction_render::scene::model::{Light, Scene, Shape};

use ndarray::Array3;

const SIZE: usize = 501;

fn set(basis: Basis, count: usize) -> TableSet {
    let table = |n: usize| {
        Array3::from_shape_fn((SIZE, SIZE, 3), |(row, column, c)| {
            let phase = (row * (c + 1)) as f32 * 0.05 + column as f32 * 0.07;
            phase.sin().powi(2) / (1 << n.min(20)) as f32
        })
    };
    let lobe = Lobe {
        coherent: Array3::from_shape_fn((65, 160, 3), |(_, r, _)| (-(r as f32 / 40.0).powi(2)).exp()),
        radius_max: 0.03,
        cross: Vec::new(),
    };
    TableSet {
        basis,
        tables: (0..count).map(table).collect(),
        lobe: (basis == Basis::Chebyshev).then_some(lobe),
        prefilter_width: 0.0,
        front_factor: FrontFactor {
            material: Material::Dielectric { n: 1.56 },
            shadowing: true,
            factor: Factor::Scalar,
        },
        restriction: None,
        usable_radius: 2.0,
    }
}

fn main() -> Result<()> {
    let arguments: Vec<usize> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let size_px = arguments.first().copied().unwrap_or(1024);
    let gpu = Gpu::require()?;
    let mut plan = FramePlan::suited_to(&gpu);
    if let Some(&frames) = arguments.get(1) {
        plan.batches = frames.div_ceil(plan.batch);
    }
    let info = gpu.info();
    println!("{} ({}), {} {}", info.adapter, info.kind, info.backend, info.driver);
    let light = Light::point([0.3, 0.2, 1.0]);
    let surfaces = gbuffer(&Scene::still("snake", Shape::Snake, vec![light], size_px))?;
    let mut base_ms = None;
    for (basis, count) in [
        (Basis::Chebyshev, 2),
        (Basis::Chebyshev, 4),
        (Basis::Chebyshev, 6),
        (Basis::Taylor, 16),
        (Basis::Taylor, 24),
        (Basis::Taylor, 40),
    ] {
        let tables = upload(&gpu, &table_image(&set(basis, count), None)?)?;
        let frame = Frame::new(&gpu, &tables, &surfaces, 1.0)?;
        let [time] = time_frames([&frame], plan)?;
        let base = *base_ms.get_or_insert(time.median_ms);
        println!(
            "{basis:?} {count:2} tables: median {:.3} ms, shortest {:.3} ms ({:?}, {} frames of {size_px} px), {:.1} GB/s \
             of texels, {:.2} times the first",
            time.median_ms,
            time.shortest_ms,
            time.clock,
            time.frames,
            time.texel_gb_per_s,
            time.median_ms / base
        );
    }
    Ok(())
}
