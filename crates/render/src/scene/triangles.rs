//! Triangles with smooth frames: what a ray meets, which way the structure lies there, and what is in the shade.

use diffraction_brdf::direction::{Vec3, dot, normalise};

use super::bvh::{self, Bounds, Bvh, Ray};
use super::frame::{Frame, add_scaled, cross};

/// A triangle mesh, ready for rays: arrays per vertex and per triangle. Made by [`tangents::build`](super::tangents::build).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TriangleMesh {
    /// Places of the vertices.
    pub positions: Vec<Vec3>,
    /// Unit normals at the vertices, outwards.
    pub normals: Vec<Vec3>,
    /// Unit vectors along +u at the vertices, perpendicular to the normals.
    pub tangents: Vec<Vec3>,
    /// Texture coordinates of the vertices, v up.
    pub uvs: Vec<[f64; 2]>,
    /// Vertices of the triangles.
    pub triangles: Vec<[u32; 3]>,
    /// Whether +v lies to the right of +u, seen from outside, in each triangle.
    pub mirrored: Vec<bool>,
    /// Material of each triangle.
    pub materials: Vec<u16>,
    /// Names of the materials.
    pub material_names: Vec<String>,
    /// Which triangles a ray may meet.
    pub(crate) bvh: Bvh,
}

/// Where a ray meets a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TriangleHit {
    /// Which one.
    pub triangle: usize,
    /// Along the ray, in lengths of its direction.
    pub t: f64,
    /// Shares of the three vertices.
    pub shares: Vec3,
}

/// A point on a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Axes of the structure: x along +u, y towards +v, z the interpolated normal. Left-handed where the texture is mirrored.
    pub frame: Frame,
    /// Texture coordinates, v up.
    pub uv: [f64; 2],
    /// Normal of the flat triangle, on the side of the vertices' normals.
    pub facet: Vec3,
    /// Where rays to lights start: off the triangle, and on the smooth surface it stands for.
    pub lifted: Vec3,
    /// Material of the triangle.
    pub material: usize,
}

/// How far rays to lights start from the surface, relative to the largest coordinate: far above rounding, far below
/// anything that shows.
const LIFT: f64 = 1e-9;

/// Smallest boxes around the triangles, widened by what rounding may move a hit.
pub(crate) fn boxes(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Bounds> {
    let of = |triangle: &[u32; 3]| {
        let bounds = bvh::around(triangle.iter().map(|&vertex| positions[vertex as usize]));
        let pad = |axis: usize| 16.0 * f64::EPSILON * bounds.low[axis].abs().max(bounds.high[axis].abs());
        Bounds {
            low: std::array::from_fn(|axis| bounds.low[axis] - pad(axis)),
            high: std::array::from_fn(|axis| bounds.high[axis] + pad(axis)),
        }
    };
    triangles.iter().map(of).collect()
}

/// A ray turned and sheared so that it runs along z, for any number of triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShearedRay {
    origin: Vec3,
    axes: [usize; 3],
    shear: Vec3,
}

/// Prepares a ray for [`intersect`].
pub(crate) fn shear(ray: &Ray) -> ShearedRay {
    let d = ray.direction;
    let z = (0..3).max_by(|&a, &b| d[a].abs().total_cmp(&d[b].abs()).then(b.cmp(&a))).expect("three axes");
    let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
    if d[z] < 0.0 {
        (x, y) = (y, x);
    }
    ShearedRay { origin: ray.origin, axes: [x, y, z], shear: [d[x] / d[z], d[y] / d[z], 1.0 / d[z]] }
}

/// Where a ray meets a triangle, and the shares of its vertices; edges belong to both neighbours, so that nothing
/// slips between them. The watertight test of Woop, Benthin and Wald (2013).
pub fn intersect(ray: &ShearedRay, corners: [Vec3; 3]) -> Option<(f64, Vec3)> {
    let [x, y, z] = ray.axes;
    let [a, b, c] = corners.map(|corner| {
        let from = add_scaled(corner, ray.origin, -1.0);
        [from[x] - ray.shear[0] * from[z], from[y] - ray.shear[1] * from[z], ray.shear[2] * from[z]]
    });
    let edges = [c[0] * b[1] - c[1] * b[0], a[0] * c[1] - a[1] * c[0], b[0] * a[1] - b[1] * a[0]];
    if edges.iter().any(|&e| e < 0.0) && edges.iter().any(|&e| e > 0.0) {
        return None;
    }
    let sum = edges[0] + edges[1] + edges[2];
    if sum == 0.0 {
        return None;
    }
    let t = (edges[0] * a[2] + edges[1] * b[2] + edges[2] * c[2]) / sum;
    (t > 0.0).then(|| (t, edges.map(|e| e / sum)))
}

fn corners(mesh: &TriangleMesh, triangle: usize) -> [Vec3; 3] {
    mesh.triangles[triangle].map(|vertex| mesh.positions[vertex as usize])
}

/// The first triangle that a ray meets.
pub(crate) fn first_hit(mesh: &TriangleMesh, ray: &Ray) -> Option<TriangleHit> {
    let sheared = shear(ray);
    let meet = |index: u32| intersect(&sheared, corners(mesh, index as usize));
    let (t, index) = bvh::closest(&mesh.bvh, ray, f64::INFINITY, |index| meet(index).map(|(t, _)| t))?;
    let (_, shares) = meet(index)?;
    Some(TriangleHit { triangle: index as usize, t, shares })
}

/// Whether a ray gets away without meeting a triangle.
pub(crate) fn is_open(mesh: &TriangleMesh, ray: &Ray) -> bool {
    let sheared = shear(ray);
    !bvh::meets_any(&mesh.bvh, ray, f64::INFINITY, |index| intersect(&sheared, corners(mesh, index as usize)).is_some())
}

/// Normal of the flat triangle, on the side of its vertices' normals.
pub fn facet_normal(mesh: &TriangleMesh, triangle: usize) -> Vec3 {
    let [a, b, c] = corners(mesh, triangle);
    let normal = normalise(cross(add_scaled(b, a, -1.0), add_scaled(c, a, -1.0)));
    let outwards =
        mesh.triangles[triangle].iter().fold([0.0; 3], |sum, &v| add_scaled(sum, mesh.normals[v as usize], 1.0));
    if dot(normal, outwards) < 0.0 { normal.map(|c| -c) } else { normal }
}

/// Everything about the place of a hit.
pub fn surface(mesh: &TriangleMesh, hit: &TriangleHit) -> SurfacePoint {
    let vertices = mesh.triangles[hit.triangle].map(|vertex| vertex as usize);
    let mix = |values: &[Vec3]| {
        let [a, b, c] = vertices;
        let ab = add_scaled(values[a].map(|v| v * hit.shares[0]), values[b], hit.shares[1]);
        add_scaled(ab, values[c], hit.shares[2])
    };
    let facet = facet_normal(mesh, hit.triangle);
    let mut normal = mix(&mesh.normals);
    if dot(normal, facet) <= 0.0 {
        // Vertex normals that cancel or turn inside say nothing.
        normal = facet;
    }
    let normal = normalise(normal);
    let along = mix(&mesh.tangents);
    let frame = frame_along(normal, along, mesh.tangents[vertices[0]], mesh.mirrored[hit.triangle]);
    let uv = std::array::from_fn(|c| (0..3).map(|k| hit.shares[k] * mesh.uvs[vertices[k]][c]).sum());
    let position = mix(&mesh.positions);
    SurfacePoint {
        frame,
        uv,
        facet,
        lifted: lifted(mesh, vertices, hit.shares, position, facet),
        material: usize::from(mesh.materials[hit.triangle]),
    }
}

/// The frame about a unit normal whose x axis is nearest to a direction, or to another one where that is the normal.
pub fn frame_along(normal: Vec3, direction: Vec3, otherwise: Vec3, mirrored: bool) -> Frame {
    let flat = |v: Vec3| add_scaled(v, normal, -dot(normal, v));
    let tangent = [direction, otherwise].map(flat).into_iter().find(|t| dot(*t, *t) > 1e-24);
    let tangent = tangent.map_or_else(|| super::frame::about(normal).tangent, normalise);
    let bitangent = cross(normal, tangent);
    Frame { tangent, bitangent: if mirrored { bitangent.map(|c| -c) } else { bitangent }, normal }
}

/// A point on the smooth surface that the vertices' normals speak of, where that lies outside the triangle: shadows
/// then end as smoothly as the shading (Hanika 2021, "Hacking the shadow terminator").
fn lifted(mesh: &TriangleMesh, vertices: [usize; 3], shares: Vec3, position: Vec3, facet: Vec3) -> Vec3 {
    let mut point = position;
    for (vertex, share) in vertices.into_iter().zip(shares) {
        let normal = mesh.normals[vertex];
        let below = dot(add_scaled(position, mesh.positions[vertex], -1.0), normal).min(0.0);
        point = add_scaled(point, normal, -share * below);
    }
    let size = position.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    add_scaled(point, facet, LIFT * size.max(extent(mesh)))
}

/// Longest side of the box around the mesh.
fn extent(mesh: &TriangleMesh) -> f64 {
    let bounds = bvh::bounds(&mesh.bvh);
    (0..3).map(|axis| bounds.high[axis] - bounds.low[axis]).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tangents::{RawMesh, build};

    /// A square of four triangles around the origin, in the plane z = 0.
    fn square() -> TriangleMesh {
        let positions = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0; 3]];
        build(RawMesh {
            normals: vec![[0.0, 0.0, 1.0]; 5],
            uvs: positions.iter().map(|p: &Vec3| [p[0], p[1]]).collect(),
            positions,
            triangles: vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
            materials: vec![0; 4],
            material_names: vec!["a".into()],
        })
        .unwrap()
    }

    #[test]
    fn nothing_slips_between_neighbours() {
        let mesh = square();
        // Through the common corner, along the diagonals, and from the side at which rounding is at work.
        for (x, y) in (-40..=40).flat_map(|i| (-40..=40).map(move |j| (f64::from(i) / 41.0, f64::from(j) / 41.0))) {
            for origin in [[x, y, 1.0], [0.3, -0.7, 0.9], [5.0, 4.0, 0.01]] {
                let direction = add_scaled([x, y, 0.0], origin, -1.0);
                let hit = first_hit(&mesh, &Ray { origin, direction }).expect("the square has no gaps");
                assert!((hit.t - 1.0).abs() < 1e-12 && (hit.shares.iter().sum::<f64>() - 1.0).abs() < 1e-15);
                let uv = surface(&mesh, &hit).uv;
                assert!((uv[0] - x).abs() < 1e-12 && (uv[1] - y).abs() < 1e-12);
            }
        }
        assert!(first_hit(&mesh, &Ray { origin: [1.0 + 1e-9, 0.0, 1.0], direction: [0.0, 0.0, -1.0] }).is_none());
        assert!(first_hit(&mesh, &Ray { origin: [0.0, 0.0, 1.0], direction: [0.0, 0.0, 1.0] }).is_none());
    }

    #[test]
    fn a_flat_surface_does_not_shade_itself() {
        let mesh = square();
        for (x, y) in [(0.0, 0.0), (0.5, 0.5), (0.31, -0.72), (-0.99, 0.2)] {
            let ray = Ray { origin: [x, y, 1.0], direction: [0.0, 0.0, -1.0] };
            let point = surface(&mesh, &first_hit(&mesh, &ray).unwrap());
            assert!(is_open(&mesh, &Ray { origin: point.lifted, direction: [1.0, 0.3, 1e-6] }));
            assert!(!is_open(&mesh, &Ray { origin: point.lifted, direction: [0.0, 0.0, -1.0] }));
        }
    }

    #[test]
    fn rays_to_lights_start_on_the_smooth_surface() {
        // Normals of the unit sphere on a triangle inscribed in it: the middle is lifted outwards, the corners are not.
        let positions: Vec<Vec3> = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mesh = build(RawMesh {
            normals: positions.clone(),
            uvs: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            positions,
            triangles: vec![[0, 1, 2]],
            materials: vec![0],
            material_names: vec!["a".into()],
        })
        .unwrap();
        let at = |shares: Vec3| surface(&mesh, &TriangleHit { triangle: 0, t: 1.0, shares }).lifted;
        // Each corner's plane is 2/3 above the middle, along that corner's axis; shares of a third.
        let middle = at([1.0 / 3.0; 3]);
        assert!(middle.iter().all(|c| (c - (1.0 / 3.0 + 2.0 / 9.0)).abs() < 1e-8), "{middle:?}");
        let corner = at([1.0, 0.0, 0.0]);
        assert!((corner[0] - 1.0).abs() < 1e-8 && corner[1].abs() < 1e-8, "{corner:?}");
    }
}
