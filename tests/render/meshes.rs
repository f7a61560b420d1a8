//! Meshes against the closed forms of the same bodies, and what lies in the shade.

use std::f64::consts::{FRAC_1_PI, PI, TAU};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use diffraction_brdf::direction::{Vec3, Xyz, dot, normalise};
use diffraction_build::ground::colour::to_srgb8;
use diffraction_render::render::cpu::render;
use diffraction_render::render::png_image::write_png;
use diffraction_render::scene::camera::{Camera, Field};
use diffraction_render::scene::mesh::MeshShape;
use diffraction_render::scene::mesh_file::Model;
use diffraction_render::scene::model::{Scene, Shape, share_of};
use diffraction_render::scene::samples::{ShadingSamples, pixel_centre, pixel_range, samples};
use diffraction_render::scene::sphere;
use diffraction_render::scene::tangents::{RawMesh, build};
use diffraction_render::scene::turn::{Axis, Turn, turned};
use ndarray::Array3;

use super::scene;

/// Parallel rays along -z that show [-1, 1]².
const FROM_AFAR: Camera =
    Camera { position: [0.0, 0.0, 5.0], target: [0.0; 3], up: [0.0, 1.0, 0.0], field: Field::Width(2.0) };

fn mesh(raw: RawMesh, camera: Camera) -> MeshShape {
    let model = Model { mesh: build(raw).unwrap(), files: Vec::new() };
    MeshShape {
        path: PathBuf::from("test.obj"),
        camera: Some(camera),
        specimens: Vec::new(),
        specimen_of_material: Vec::new(),
        shown: None,
        model: Arc::new(model),
    }
}

/// A sphere of circles of longitude and latitude; the upper half is one material, the lower half another.
fn ball(radius: f64, steps: usize) -> RawMesh {
    let mut raw = RawMesh { material_names: vec!["upper".into(), "lower".into()], ..RawMesh::default() };
    for i in 0..=steps {
        let (sin_t, cos_t) = (PI * i as f64 / steps as f64).sin_cos();
        for j in 0..=2 * steps {
            let share = j as f64 / (2 * steps) as f64;
            let (sin_p, cos_p) = (TAU * share - PI).sin_cos();
            let normal = [sin_t * sin_p, cos_t, sin_t * cos_p];
            raw.positions.push(normal.map(|c| radius * c));
            raw.normals.push(normal);
            raw.uvs.push([share, 1.0 - i as f64 / steps as f64]);
        }
    }
    let vertex = |i: usize, j: usize| (i * (2 * steps + 1) + j) as u32;
    for i in 0..steps {
        for j in 0..2 * steps {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            raw.triangles.extend([[a, b, c], [a, c, d]]);
            raw.materials.extend([u16::from(2 * i >= steps); 2]);
        }
    }
    raw
}

/// A rectangle in a plane of constant z, in two triangles, facing +z; `uv` gives texture coordinates.
fn rectangle(low: [f64; 2], high: [f64; 2], z: f64, uv: impl Fn(f64, f64) -> [f64; 2]) -> RawMesh {
    let positions = vec![[low[0], low[1], z], [high[0], low[1], z], [high[0], high[1], z], [low[0], high[1], z]];
    RawMesh {
        normals: vec![[0.0, 0.0, 1.0]; 4],
        uvs: positions.iter().map(|p: &Vec3| uv(p[0], p[1])).collect(),
        positions,
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![0, 0],
        material_names: vec!["a".into()],
    }
}

/// Depends on every component, so that a turned, mirrored or tilted frame shows.
fn lopsided(wi: Vec3, wo: Vec3) -> Xyz {
    [1.0 + wi[0] + 0.5 * wo[1], 1.0 + wi[1] - 0.4 * wo[0], 1.0 + wi[2] * wo[2] + 0.3 * wi[0] * wo[1]]
}

/// Leaves picture, reference and difference in the target's tmp folder where two pictures differ by more than a tolerance.
#[track_caller]
fn assert_alike(name: &str, image: &Array3<f32>, reference: &Array3<f32>, tolerance: f32) {
    let difference = (image - reference).mapv(f32::abs);
    let worst = difference.iter().copied().fold(0.0, f32::max);
    if worst <= tolerance {
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    for (ending, picture, exposure) in
        [("", image, 1.0), (".reference", reference, 1.0), (".difference", &difference, 0.2 / tolerance.max(1e-9))]
    {
        write_png(&folder.join(format!("{name}{ending}.png")), &to_srgb8(picture, exposure)).unwrap();
    }
    panic!("{name}: differs by {worst}, allowed are {tolerance}; see {}", folder.display());
}

/// With `n` steps of `d = π/n` from pole to pole the facets lie up to `s = d²/4` (half a cell's diagonal, squared and
/// halved) below the sphere. Positions and normals are interpolated alike, so the normal at picture point r points to the
/// facet's own point: it is turned by `s r/z`, that is by less than 5 s where z > 0.2, and the cosine by no more. Values
/// of the sphere are `cos/π` times up to 2.
#[test]
fn a_fine_ball_is_the_sphere() {
    let steps = 128;
    let allowed = 5.0 * (PI / f64::from(steps)).powi(2) / 4.0 * 2.0 * FRAC_1_PI + 3e-7;
    let lambertian = |_: Vec3, _: Vec3| [0.5 * FRAC_1_PI, FRAC_1_PI, 2.0 * FRAC_1_PI];
    for direction in [[0.3, 0.2, 1.0], [0.9, -0.4, 0.2], [-0.5, 0.8, -0.3]] {
        let shape = Shape::Mesh(mesh(ball(sphere::RADIUS, steps as usize), FROM_AFAR));
        // Around the terminator no triangle may shade its neighbours.
        let mut image = render(&scene(shape, direction, 96), &lambertian).unwrap();
        let analytic = |direction| {
            let scene = scene(Shape::Sphere, direction, 96);
            (render(&scene, &lambertian).unwrap(), scene)
        };
        let (mut reference, scene) = analytic(direction);
        let (mut other, _) = analytic([direction[0] + 0.01, direction[1], direction[2]]);
        for ((row, column, channel), value) in image.indexed_iter_mut() {
            let [x, y] = pixel_centre(&scene, row, column).map(|c| c / sphere::RADIUS);
            if x * x + y * y > 1.0 - 0.04 {
                *value = 0.0;
                reference[[row, column, channel]] = 0.0;
                other[[row, column, channel]] = 0.0;
            }
        }
        assert_alike("mesh_ball", &image, &reference, allowed as f32);
        let moved = (&image - &other).iter().fold(0.0f32, |m, d| m.max(d.abs()));
        assert!(f64::from(moved) > 2.0 * allowed, "a light moved by half a degree is noticed: {moved} {allowed}");
    }
}

/// The structure follows the sphere's own circles of latitude.
#[test]
fn x_runs_along_the_circles_of_latitude() {
    let shape = Shape::Mesh(mesh(ball(sphere::RADIUS, 128), FROM_AFAR));
    let direction = [0.3, 0.2, 1.0];
    let (of_mesh, of_sphere) =
        (samples(&scene(shape, direction, 40)).unwrap(), samples(&scene(Shape::Sphere, direction, 40)).unwrap());
    let scene = scene(Shape::Sphere, direction, 40);
    let mut compared = 0;
    for (row, column) in (0..40).flat_map(|row| (0..40).map(move |column| (row, column))) {
        let [x, y] = pixel_centre(&scene, row, column);
        // Away from rim and poles, where longitude changes within a facet.
        if x.hypot(y) > 0.6 {
            continue;
        }
        let (a, b) = (pixel_range(&of_mesh, row, column).start, pixel_range(&of_sphere, row, column).start);
        for (m, s) in [(of_mesh.wi[a], of_sphere.wi[b]), (of_mesh.wo[a], of_sphere.wo[b])] {
            for (m, s) in m.iter().zip(s) {
                // The normal as above; tangents of one facet's corners lie within a step of π/128 of each other, and their
                // mean within a step squared of the true one.
                assert!((m - s).abs() < 1.5e-3, "row {row}, column {column}: {m} {s}");
            }
        }
        compared += 1;
    }
    assert!(compared > 400);
}

/// What a patch of 30 mm at 80 mm shows, with the camera that its documentation describes.
fn patch_and_mesh(turn_deg: f64, uv: impl Fn(f64, f64) -> [f64; 2]) -> [ShadingSamples; 2] {
    let (width_mm, distance_mm) = (30.0, 80.0);
    let half_field = 1.04 * 0.5 * width_mm;
    let camera = Camera {
        position: [0.0, 0.0, distance_mm],
        field: Field::FovDeg(2.0 * f64::atan(half_field / distance_mm).to_degrees()),
        ..FROM_AFAR
    };
    let half = 0.5 * width_mm;
    let shape = Shape::Mesh(mesh(rectangle([-half; 2], [half; 2], 0.0, uv), camera));
    let patch = Shape::Patch { width_mm, distance_mm, tilt_deg: 0.0, turn_deg };
    [patch, shape].map(|shape| samples(&scene(shape, [0.3, 0.7, 1.0], 63)).unwrap())
}

/// Largest difference of any direction's component or weight; infinite where samples differ in number.
fn largest_difference(a: &ShadingSamples, b: &ShadingSamples) -> f32 {
    if a.first != b.first {
        return f32::INFINITY;
    }
    let directions = a.wi.iter().chain(&a.wo).flatten().zip(b.wi.iter().chain(&b.wo).flatten());
    directions.chain(a.weight.iter().zip(&b.weight)).fold(0.0, |m: f32, (a, b)| m.max((a - b).abs()))
}

#[test]
fn a_rectangle_is_a_patch_and_u_turns_the_structure() {
    for turn_deg in [0.0, 30.0, 90.0, -120.0] {
        let (sin, cos) = f64::to_radians(turn_deg).sin_cos();
        let uv = |x: f64, y: f64| [0.1 * (cos * x + sin * y), 0.3 * (cos * y - sin * x) + 4.0];
        let [patch, mesh] = patch_and_mesh(turn_deg, uv);
        // Both are rounded to f32 once from values that agree to 1e-14.
        assert!(largest_difference(&patch, &mesh) <= f32::EPSILON, "{turn_deg}");
        let [other, _] = patch_and_mesh(turn_deg + 0.1, uv);
        assert!(largest_difference(&other, &mesh) > 1e-4);
    }
}

#[test]
fn mirrored_coordinates_show_the_mirrored_structure() {
    let [patch, mirrored] = patch_and_mesh(0.0, |x, y| [-x, y]);
    let mut expected = patch;
    for v in expected.wi.iter_mut().chain(&mut expected.wo) {
        v[0] = -v[0];
    }
    assert!(largest_difference(&expected, &mirrored) <= f32::EPSILON);
}

fn halves() -> Scene {
    let mut shape = mesh(ball(sphere::RADIUS, 32), FROM_AFAR);
    shape.specimens = vec!["first".into(), "second".into()];
    // The upper half is covered with the second specimen.
    shape.specimen_of_material = vec![1, 0];
    scene(Shape::Mesh(shape), [0.4, 0.3, 1.0], 64)
}

#[test]
fn each_specimen_covers_its_own_half_and_nothing_else() {
    let scene = halves();
    let [first, second] = [0.5f64, 2.0].map(|factor| move |wi: Vec3, wo: Vec3| lopsided(wi, wo).map(|c| factor * c));
    let shares = [render(&share_of(&scene, 0), &first).unwrap(), render(&share_of(&scene, 1), &second).unwrap()];
    let wholes = [render(&scene, &first).unwrap(), render(&scene, &second).unwrap()];
    for ((row, column, channel), &value) in (&shares[0] + &shares[1]).indexed_iter() {
        // 64 rows: the equator lies between two of them.
        let (covering, other) = if row < 32 { (1, 0) } else { (0, 1) };
        let at = [row, column, channel];
        assert_eq!(value, wholes[covering][at], "{at:?}");
        assert_eq!(shares[other][at], 0.0, "{at:?}");
    }
    assert!(wholes.iter().all(|image| image.iter().any(|&value| value > 0.1)));
}

/// A floor over [-1, 1]² and a roof one unit above it.
fn floor_and_roof(low: [f64; 2], high: [f64; 2]) -> RawMesh {
    let mut raw = rectangle([-1.0; 2], [1.0; 2], 0.0, |x, y| [x, y]);
    let roof = rectangle(low, high, 1.0, |x, y| [x, y]);
    raw.positions.extend(roof.positions);
    raw.normals.extend(roof.normals);
    raw.uvs.extend(roof.uvs);
    raw.triangles.extend(roof.triangles.iter().map(|t| t.map(|v| v + 4)));
    raw.materials.extend(roof.materials);
    raw
}

#[test]
fn a_turned_mesh_is_what_a_camera_and_a_light_turned_back_see() {
    let raw = || floor_and_roof([0.1, -0.3], [1.5, 0.4]);
    // The middle of the box that holds both.
    let middle = [0.25, 0.0, 0.5];
    let camera = Camera { position: [1.0, 2.0, 6.0], field: Field::FovDeg(35.0), ..FROM_AFAR };
    let direction = [0.5, 0.3, 1.0];
    for axis in [Axis::Vertical, Axis::Viewing] {
        let turn = Turn { axis, angle_deg: 25.0 };
        let image = |turn| {
            let still = scene(Shape::Mesh(mesh(raw(), camera)), direction, 48);
            render(&Scene { turn, ..still }, &lopsided).unwrap()
        };
        let turned_back_about = |middle: Vec3| {
            let back = |v| turned(v, Turn { angle_deg: -25.0, ..turn });
            let about = |p: Vec3| {
                let moved = back([p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]]);
                [moved[0] + middle[0], moved[1] + middle[1], moved[2] + middle[2]]
            };
            let camera = Camera {
                position: about(camera.position),
                target: about(camera.target),
                up: back(camera.up),
                ..camera
            };
            render(&scene(Shape::Mesh(mesh(raw(), camera)), back(direction), 48), &lopsided).unwrap()
        };
        assert_alike("turned_mesh", &image(turn), &turned_back_about(middle), 1e-5);
        let differs = |other: Array3<f32>| image(turn).iter().zip(&other).any(|(a, b)| (a - b).abs() > 0.1);
        assert!(differs(image(Turn { angle_deg: -25.0, ..turn })), "{axis:?}: the other way round");
        assert!(differs(image(Turn { angle_deg: 0.0, ..turn })), "{axis:?}: not turned");
        assert!(differs(turned_back_about([0.0; 3])), "{axis:?}: turned about another point");
    }
}

#[test]
fn a_roof_throws_a_shadow_where_geometry_says() {
    let raw = floor_and_roof([-0.5; 2], [0.5; 2]);
    let scene = scene(Shape::Mesh(mesh(raw, FROM_AFAR)), [0.5, 0.0, 1.0], 52);
    let image = render(&scene, &|_, _| [1.0; 3]).unwrap();
    let cos = dot([0.0, 0.0, 1.0], normalise([0.5, 0.0, 1.0])) as f32;
    for row in 0..52 {
        for column in 0..52 {
            let [x, y] = pixel_centre(&scene, row, column);
            // The roof's shadow is the roof moved by half a unit; from above, the roof hides part of it.
            let under_roof = x.abs() < 0.5 && y.abs() < 0.5;
            let in_shadow = (x + 0.5).abs() < 0.5 && y.abs() < 0.5 && !under_roof;
            let expected = if in_shadow { 0.0 } else { cos };
            assert!((image[[row, column, 0]] - expected).abs() < 1e-6, "at {x}, {y}");
        }
    }
}

#[test]
fn what_is_seen_from_behind_is_dark() {
    let camera = Camera { position: [0.0, 0.0, -5.0], ..FROM_AFAR };
    let raw = || rectangle([-0.8; 2], [0.8; 2], 0.0, |x, y| [x, y]);
    for (camera, bright) in [(FROM_AFAR, true), (camera, false)] {
        for direction in [[0.1, 0.2, 1.0], [0.1, 0.2, -1.0]] {
            let image = render(&scene(Shape::Mesh(mesh(raw(), camera)), direction, 16), &lopsided).unwrap();
            assert_eq!(image.iter().any(|&value| value > 0.0), bright && direction[2] > 0.0);
        }
    }
}

#[test]
fn meshes_that_cannot_be_shown_are_refused() {
    let refused = |change: &dyn Fn(&mut MeshShape)| {
        let mut scene = halves();
        let Shape::Mesh(shape) = &mut scene.shape else { unreachable!() };
        change(shape);
        samples(&scene).unwrap_err().to_string()
    };
    assert!(refused(&|shape| shape.model = Arc::default()).contains("has not been read"));
    assert!(refused(&|shape| shape.specimen_of_material = vec![0]).contains("1 of the 2 materials"));
    assert!(refused(&|shape| shape.specimen_of_material = vec![0, 2]).contains("out of range"));
    assert!(
        refused(&|shape| shape.camera = Some(Camera { target: FROM_AFAR.position, ..FROM_AFAR })).contains("camera")
    );
}
