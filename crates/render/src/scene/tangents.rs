//! From a mesh as it stands in a file to one with tangents along +u at every vertex.

use diffraction_brdf::direction::{Vec3, dot, normalise};

use super::bvh;
use super::frame::{add_scaled, cross};
use super::triangles::{TriangleMesh, boxes};

/// A mesh as files hold it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RawMesh {
    /// Places of the vertices.
    pub positions: Vec<Vec3>,
    /// Normals at the vertices, outwards, of any length; zero asks for that of the triangle (its vertices must then be its
    /// own).
    pub normals: Vec<Vec3>,
    /// Texture coordinates of the vertices, v up.
    pub uvs: Vec<[f64; 2]>,
    /// Vertices of the triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Material of each triangle.
    pub materials: Vec<u16>,
    /// Names of the materials.
    pub material_names: Vec<String>,
}

/// Area of a triangle below which it is a line, relative to its longest edge squared.
const FLAT: f64 = 1e-12;

/// What a triangle says about the directions of u and v.
struct Axes {
    /// Unit vector along +u in the triangle's plane.
    along: Vec3,
    /// Whether +v lies to the right of +u.
    mirrored: bool,
}

/// A mesh ready for rays. Triangles without area are left out. A vertex between triangles with mirrored and unmirrored
/// coordinates is doubled.
///
/// # Errors
/// The index of a triangle whose texture coordinates lie on a line, so that they give no direction.
pub fn build(raw: RawMesh) -> Result<TriangleMesh, usize> {
    let RawMesh { positions, normals, uvs, triangles, materials, material_names } = raw;
    let mut mesh = TriangleMesh { positions, normals, uvs, material_names, ..TriangleMesh::default() };
    // The copy of a vertex for the other handedness, and the handedness of the vertex itself.
    let mut handed: Vec<Option<(bool, Option<u32>)>> = vec![None; mesh.positions.len()];
    mesh.tangents = vec![[0.0; 3]; mesh.positions.len()];
    for (index, triangle) in triangles.iter().enumerate() {
        let corners = triangle.map(|vertex| mesh.positions[vertex as usize]);
        let Some(facet) = area_normal(corners) else {
            continue;
        };
        for &vertex in triangle {
            let normal = &mut mesh.normals[vertex as usize];
            *normal = if dot(*normal, *normal) > 0.0 { normalise(*normal) } else { facet };
        }
        let outwards = triangle.iter().fold([0.0; 3], |sum, &v| add_scaled(sum, mesh.normals[v as usize], 1.0));
        let facet = if dot(facet, outwards) < 0.0 { facet.map(|c| -c) } else { facet };
        let uvs = triangle.map(|vertex| mesh.uvs[vertex as usize]);
        let axes = axes(corners, uvs, facet).ok_or(index)?;
        let own = triangle.map(|vertex| of_hand(&mut mesh, &mut handed, vertex, axes.mirrored));
        for (corner, vertex) in own.map(|vertex| vertex as usize).into_iter().enumerate() {
            let tangent = add_scaled(axes.along, mesh.normals[vertex], -dot(axes.along, mesh.normals[vertex]));
            let angle = angle_at(corners, corner);
            mesh.tangents[vertex] = add_scaled(mesh.tangents[vertex], normalise(tangent), angle);
        }
        mesh.triangles.push(own);
        mesh.mirrored.push(axes.mirrored);
        mesh.materials.push(materials[index]);
    }
    for tangent in &mut mesh.tangents {
        *tangent = normalise(*tangent);
    }
    mesh.bvh = bvh::build(&boxes(&mesh.positions, &mesh.triangles));
    Ok(mesh)
}

/// The vertex itself, or its copy where it already belongs to triangles of the other handedness.
fn of_hand(mesh: &mut TriangleMesh, handed: &mut [Option<(bool, Option<u32>)>], vertex: u32, mirrored: bool) -> u32 {
    match &mut handed[vertex as usize] {
        slot @ None => {
            *slot = Some((mirrored, None));
            vertex
        }
        Some((hand, _)) if *hand == mirrored => vertex,
        Some((_, Some(copy))) => *copy,
        Some((_, copy)) => {
            let index = vertex as usize;
            mesh.positions.push(mesh.positions[index]);
            mesh.normals.push(mesh.normals[index]);
            mesh.uvs.push(mesh.uvs[index]);
            mesh.tangents.push([0.0; 3]);
            *copy.insert((mesh.positions.len() - 1) as u32)
        }
    }
}

/// Unit normal of a triangle by the order of its corners; `None` where it has no area.
fn area_normal([a, b, c]: [Vec3; 3]) -> Option<Vec3> {
    let edges = [add_scaled(b, a, -1.0), add_scaled(c, b, -1.0), add_scaled(a, c, -1.0)];
    let longest = edges.iter().fold(0.0, |m: f64, e| m.max(dot(*e, *e)));
    let normal = cross(edges[0], edges[1]);
    let area = dot(normal, normal).sqrt();
    (area > FLAT * longest).then(|| normal.map(|c| c / area))
}

/// Directions of the texture's axes; `None` where the coordinates lie on a line.
fn axes([a, b, c]: [Vec3; 3], [p, q, r]: [[f64; 2]; 3], facet: Vec3) -> Option<Axes> {
    let (ab, ac) = (add_scaled(b, a, -1.0), add_scaled(c, a, -1.0));
    let (pq, pr, qr) = ([q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]], [r[0] - q[0], r[1] - q[1]]);
    let area = pq[0] * pr[1] - pq[1] * pr[0];
    let longest = [pq, pr, qr].iter().fold(0.0, |m: f64, e| m.max(e[0] * e[0] + e[1] * e[1]));
    // Only numbers within bounds come here: none of this is NaN or overflows.
    if area.abs() <= FLAT * longest {
        return None;
    }
    // Position is linear in u and v over the triangle: these are its derivatives times the area.
    let along = add_scaled(ab.map(|c| c * pr[1]), ac, -pq[1]);
    let across = add_scaled(ac.map(|c| c * pq[0]), ab, -pr[0]);
    let mirrored = dot(cross(along, across), facet) < 0.0;
    Some(Axes { along: normalise(along.map(|c| c * area.signum())), mirrored })
}

/// Angle of a triangle at one corner.
fn angle_at(corners: [Vec3; 3], corner: usize) -> f64 {
    let to = |other: usize| normalise(add_scaled(corners[other % 3], corners[corner], -1.0));
    dot(to(corner + 1), to(corner + 2)).clamp(-1.0, 1.0).acos()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::triangles::{TriangleHit, surface};

    /// Two triangles of a square in the plane z = 0 whose texture coordinates are a linear map of the place.
    fn square(map: impl Fn(f64, f64) -> [f64; 2]) -> RawMesh {
        let positions = vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        RawMesh {
            normals: vec![[0.0, 0.0, 3.0]; 4],
            uvs: positions.iter().map(|p: &Vec3| map(p[0], p[1])).collect(),
            positions,
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            materials: vec![0, 0],
            material_names: vec!["a".into()],
        }
    }

    fn frame(mesh: &TriangleMesh, triangle: usize) -> super::super::frame::Frame {
        surface(mesh, &TriangleHit { triangle, t: 1.0, shares: [0.2, 0.3, 0.5] }).frame
    }

    #[test]
    fn x_runs_along_u_whatever_turn_scale_and_shear() {
        for turn_deg in [0.0, 30.0, 90.0, 200.0] {
            let (sin, cos) = f64::to_radians(turn_deg).sin_cos();
            // u grows along (cos, sin); v is sheared but stays on its left.
            let mesh = build(square(|x, y| [7.0 * (cos * x + sin * y), 0.4 * x + 2.0 * (cos * y - sin * x)])).unwrap();
            // Along +u means v constant: the direction with dv = 0, not the gradient of u.
            let along = normalise([2.0 * cos, 2.0 * sin - 0.4, 0.0]);
            for triangle in 0..2 {
                let frame = frame(&mesh, triangle);
                assert!((dot(frame.tangent, along) - 1.0).abs() < 1e-12, "{turn_deg}: {frame:?}");
                assert!((dot(cross(frame.tangent, frame.bitangent), frame.normal) - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn mirrored_coordinates_mirror_the_structure() {
        let mesh = build(square(|x, y| [-x, y])).unwrap();
        let frame = frame(&mesh, 0);
        assert_eq!((frame.tangent, frame.normal), ([-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]));
        assert_eq!(frame.bitangent, [0.0, 1.0, 0.0], "y stays on the side of +v");
        assert_eq!(mesh.mirrored, [true, true]);
    }

    #[test]
    fn a_seam_between_mirrored_halves_keeps_both_directions() {
        // u = |x|: the left half is mirrored, and both share the vertices on the seam.
        let positions = vec![
            [-1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [-1.0, 1.0, 0.0],
        ];
        let mesh = build(RawMesh {
            normals: vec![[0.0, 0.0, 1.0]; 6],
            uvs: positions.iter().map(|p: &Vec3| [p[0].abs(), p[1]]).collect(),
            positions,
            triangles: vec![[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4]],
            materials: vec![0; 4],
            material_names: vec!["a".into()],
        })
        .unwrap();
        assert_eq!(mesh.positions.len(), 8, "the two vertices on the seam are doubled");
        for (triangle, expected) in [(0, -1.0), (1, -1.0), (2, 1.0), (3, 1.0)] {
            let frame = frame(&mesh, triangle);
            assert!((frame.tangent[0] - expected).abs() < 1e-12, "triangle {triangle}: {frame:?}");
        }
    }

    #[test]
    fn triangles_without_area_are_left_out_and_without_direction_refused() {
        let mut raw = square(|x, y| [x, y]);
        raw.triangles.push([1, 1, 2]);
        raw.materials.push(0);
        assert_eq!(build(raw).unwrap().triangles.len(), 2);
        assert_eq!(build(square(|x, _| [x, 3.0 * x])), Err(0));
        let mut half = square(|x, y| [x, y]);
        half.uvs[3] = [1.0, 0.5];
        assert_eq!(build(half), Err(1));
    }

    #[test]
    fn a_missing_normal_is_that_of_the_triangle() {
        let mut raw = square(|x, y| [x, y]);
        raw.normals = vec![[0.0; 3]; 4];
        let mesh = build(raw).unwrap();
        assert!(mesh.normals.iter().all(|n| *n == [0.0, 0.0, 1.0]));
    }
}
