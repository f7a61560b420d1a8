//! What a filtered look-up costs beside samples and beside the published method: prints the table of docs/accuracy.md.

use std::path::Path;

use diffraction_brdf::Factor;
use diffraction_brdf::shader::{promised_image, table_image};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, TableSet, TablesConfig};
use diffraction_render::render::gpu_frame::{Frame, FramePlan, FrameTime, time_frames};
use diffraction_render::render::gpu_tables::upload;
use diffraction_render::scene::gbuffer::{filtered_gbuffer, gbuffer};
use diffraction_render::scene::model::{Light, Scene, Shape};

use crate::sets::gpu;
use crate::surfaces::tables_config;

/// The bundled corn snake: its tables, and the published method's.
fn snake(basis: Basis) -> TableSet {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("specimens/corn_snake_like.tif");
    let fields = [read_scan(&path, &ReadConfig::default()).unwrap().field];
    let ideal = OpticsConfig::ideal(Illuminant::D65, 4_000.0, Edge::Tile, Windows::Grid);
    let factor = if basis == Basis::Taylor { Factor::Scalar } else { Factor::Vector };
    let optics = OpticsConfig { material: Material::Dielectric { n: 1.56 }, factor, ..ideal };
    let tables = TablesConfig { basis, ..tables_config(1e-3, Some(601)) };
    build(&BuildInput::new(&fields, &optics, &tables), &|_| ()).unwrap().0
}

fn line(what: &str, time: &FrameTime, point: &FrameTime) {
    let pairs = time.evaluations.max(1) as f64;
    println!(
        "| {what} | {} | {:.2} ms | {:.0} ns | {:.2} |",
        time.tables,
        time.median_ms,
        time.median_ms * 1e6 / pairs,
        time.median_ms / point.median_ms
    );
}

#[test]
#[ignore = "measures"]
fn measuring_frames_of_one_look_up_and_of_samples() {
    let Some(gpu) = gpu("time of filtered frames") else { return };
    let set = snake(Basis::Chebyshev);
    let published = snake(Basis::Taylor);
    let [tables, published] = [&set, &published].map(|set| upload(gpu, &table_image(set, None).unwrap()).unwrap());
    let splines = upload(gpu, &promised_image(&set, None).unwrap()).unwrap();
    println!("{:?}", gpu.info().adapter);
    for diameter_deg in [0.53, 2.0] {
        let light = Light { angular_diameter_deg: diameter_deg, ..Light::point([0.5, 0.4, 1.0]) };
        let scene = |light_samples| Scene { light_samples, ..Scene::still("time", Shape::Snake, vec![light], 256) };
        let sampled = |tables, count| Frame::new(gpu, tables, &gbuffer(&scene(count)).unwrap(), 1.0).unwrap();
        let one = Frame::new(gpu, &tables, &filtered_gbuffer(&scene(1)).unwrap(), 1.0).unwrap();
        let spline_point = sampled(&splines, 1);
        let of_splines = Frame::new(gpu, &splines, &filtered_gbuffer(&scene(1)).unwrap(), 1.0).unwrap();
        let frames = [1, 16, 64, 256].map(|count| sampled(&tables, count));
        let [of_published, more] = [1, 16].map(|count| sampled(&published, count));
        let plan = FramePlan { warm_up: 1, batches: 9, batch: 1 };
        let [point, few, some, many, filtered, old, old_few, spline, of_spline] = time_frames(
            [&frames[0], &frames[1], &frames[2], &frames[3], &one, &of_published, &more, &spline_point, &of_splines],
            plan,
        )
        .unwrap();
        println!("| {diameter_deg} degrees | tables | frame | pair | of a point |");
        for (what, time) in [
            ("point", &point),
            ("one filtered look-up", &filtered),
            ("point by splines", &spline),
            ("one filtered look-up of splines", &of_spline),
            ("16 samples", &few),
            ("64 samples", &some),
            ("256 samples", &many),
            ("published method, point", &old),
            ("published method, 16 samples", &old_few),
        ] {
            line(what, time, &point);
        }
        assert!(filtered.evaluations == point.evaluations && filtered.median_ms < few.median_ms);
    }
}
