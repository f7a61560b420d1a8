//! Bounding volume hierarchy: which of many primitives a ray meets first, and whether it meets any.

use diffraction_brdf::direction::Vec3;

/// A half line `origin + t direction`, t > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes; of any length but zero, which is the unit of `t`.
    pub direction: Vec3,
}

/// An axis-aligned box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounds {
    /// Smallest coordinates.
    pub low: Vec3,
    /// Largest coordinates.
    pub high: Vec3,
}

/// The box that holds nothing.
pub(crate) const NOTHING: Bounds = Bounds { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

/// Most primitives of a leaf, but where splitting does not pay.
const LEAF_MAX: usize = 4;
/// Planes between which the cheapest split along an axis is sought.
const BINS: usize = 16;
/// Depth from which on nodes are halved by number: bounds the depth to this and the logarithm of the number.
const DEPTH_OF_HALVES: usize = 40;
/// Deepest tree: 2^32 primitives halved, below [`DEPTH_OF_HALVES`].
const DEPTH_MAX: usize = DEPTH_OF_HALVES + 33;

/// A box with primitives, or with two boxes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Node {
    bounds: Bounds,
    /// First primitive in `order`; of an inner node, the first of two children, which are neighbours.
    first: u32,
    /// Number of primitives; 0 for an inner node.
    count: u32,
}

/// The hierarchy. Without primitives it has no node.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Bvh {
    nodes: Vec<Node>,
    /// Indices of primitives, leaf after leaf.
    order: Vec<u32>,
}

/// The smallest box that holds both.
pub fn union(a: &Bounds, b: &Bounds) -> Bounds {
    Bounds {
        low: std::array::from_fn(|axis| a.low[axis].min(b.low[axis])),
        high: std::array::from_fn(|axis| a.high[axis].max(b.high[axis])),
    }
}

/// The smallest box that holds some points.
pub fn around(points: impl IntoIterator<Item = Vec3>) -> Bounds {
    points.into_iter().fold(NOTHING, |bounds, p| union(&bounds, &Bounds { low: p, high: p }))
}

/// Half the surface.
fn half_area(bounds: &Bounds) -> f64 {
    let [x, y, z] = std::array::from_fn(|axis| (bounds.high[axis] - bounds.low[axis]).max(0.0));
    x * y + y * z + z * x
}

fn centre(bounds: &Bounds, axis: usize) -> f64 {
    0.5 * (bounds.low[axis] + bounds.high[axis])
}

/// The middle of a box.
pub fn middle(bounds: &Bounds) -> Vec3 {
    std::array::from_fn(|axis| centre(bounds, axis))
}

/// The hierarchy over finite boxes, fewer than 2^32, split by the surface-area heuristic. The same boxes give the same
/// hierarchy.
pub fn build(boxes: &[Bounds]) -> Bvh {
    let count = u32::try_from(boxes.len()).expect("fewer than 2^32 primitives");
    let mut order: Vec<u32> = (0..count).collect();
    if boxes.is_empty() {
        return Bvh::default();
    }
    let mut nodes = vec![leaf(boxes, &order, 0, boxes.len())];
    let mut open = vec![(0usize, 0usize)];
    while let Some((index, depth)) = open.pop() {
        let Node { bounds, first, count } = nodes[index];
        let (first, count) = (first as usize, count as usize);
        let range = &mut order[first..first + count];
        let Some(left) = split(boxes, range, &bounds, depth) else {
            continue;
        };
        let children = nodes.len();
        nodes.push(leaf(boxes, &order, first, left));
        nodes.push(leaf(boxes, &order, first + left, count - left));
        nodes[index] = Node { bounds, first: children as u32, count: 0 };
        open.push((children + 1, depth + 1));
        open.push((children, depth + 1));
    }
    Bvh { nodes, order }
}

fn leaf(boxes: &[Bounds], order: &[u32], first: usize, count: usize) -> Node {
    let range = &order[first..first + count];
    let bounds = range.iter().fold(NOTHING, |bounds, &index| union(&bounds, &boxes[index as usize]));
    Node { bounds, first: first as u32, count: count as u32 }
}

/// Sorts a node's primitives into two parts and says how many are in the first; `None` leaves them together.
fn split(boxes: &[Bounds], range: &mut [u32], bounds: &Bounds, depth: usize) -> Option<usize> {
    if range.len() <= LEAF_MAX {
        return None;
    }
    let centres = around(range.iter().map(|&i| std::array::from_fn(|axis| centre(&boxes[i as usize], axis))));
    let cheapest = if depth < DEPTH_OF_HALVES { cheapest_plane(boxes, range, bounds, &centres) } else { None };
    if let Some((axis, plane, cost)) = cheapest {
        // A look at a box costs about as much as one at a primitive.
        if cost + 1.0 >= range.len() as f64 && range.len() <= 4 * LEAF_MAX {
            return None;
        }
        let scale = bin_scale(&centres, axis);
        let is_left = |&i: &u32| bin(centre(&boxes[i as usize], axis), &centres, axis, scale) < plane;
        range.sort_by_key(|i| !is_left(i));
        return Some(range.iter().filter(|i| is_left(i)).count());
    }
    // All centres in one place, or very deep: by number, along the longest axis.
    let axis = (0..3).max_by(|&a, &b| {
        (centres.high[a] - centres.low[a]).total_cmp(&(centres.high[b] - centres.low[b])).then(b.cmp(&a))
    })?;
    let half = range.len() / 2;
    range.sort_by(|&a, &b| {
        centre(&boxes[a as usize], axis).total_cmp(&centre(&boxes[b as usize], axis)).then(a.cmp(&b))
    });
    Some(half)
}

fn bin_scale(centres: &Bounds, axis: usize) -> f64 {
    BINS as f64 / (centres.high[axis] - centres.low[axis])
}

fn bin(centre: f64, centres: &Bounds, axis: usize, scale: f64) -> usize {
    (((centre - centres.low[axis]) * scale) as usize).min(BINS - 1)
}

/// Axis, plane between bins, and expected number of primitives looked at, of the best split; `None` where all centres
/// coincide.
fn cheapest_plane(boxes: &[Bounds], range: &[u32], bounds: &Bounds, centres: &Bounds) -> Option<(usize, usize, f64)> {
    let mut best: Option<(usize, usize, f64)> = None;
    for axis in 0..3 {
        let scale = bin_scale(centres, axis);
        if !scale.is_finite() {
            continue;
        }
        let mut bins = [(NOTHING, 0usize); BINS];
        for &index in range {
            let bounds = &boxes[index as usize];
            let slot = &mut bins[bin(centre(bounds, axis), centres, axis, scale)];
            *slot = (union(&slot.0, bounds), slot.1 + 1);
        }
        let mut right = [(NOTHING, 0usize); BINS + 1];
        for plane in (0..BINS).rev() {
            right[plane] = (union(&right[plane + 1].0, &bins[plane].0), right[plane + 1].1 + bins[plane].1);
        }
        let mut left = (NOTHING, 0usize);
        for plane in 1..BINS {
            left = (union(&left.0, &bins[plane - 1].0), left.1 + bins[plane - 1].1);
            if left.1 == 0 || right[plane].1 == 0 {
                continue;
            }
            let seen = half_area(&left.0) * left.1 as f64 + half_area(&right[plane].0) * right[plane].1 as f64;
            let cost = seen / half_area(bounds).max(f64::MIN_POSITIVE);
            if best.is_none_or(|(_, _, least)| cost < least) {
                best = Some((axis, plane, cost));
            }
        }
    }
    best
}

/// A ray prepared for boxes.
struct Slabs {
    origin: Vec3,
    direction: Vec3,
    inverse: Vec3,
}

/// Where the ray enters a box, no later than `t_max`; 0 where it starts inside. Never later than it does: what a box
/// holds is not missed by rounding.
fn enter(slabs: &Slabs, bounds: &Bounds, t_max: f64) -> Option<f64> {
    // Each bound takes three roundings of 2^-53.
    const SLACK: f64 = 8.0 * f64::EPSILON;
    let (mut near, mut far) = (0.0f64, t_max);
    for axis in 0..3 {
        let (low, high) = (bounds.low[axis] - slabs.origin[axis], bounds.high[axis] - slabs.origin[axis]);
        if slabs.direction[axis] == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
            continue;
        }
        let (a, b) = (low * slabs.inverse[axis], high * slabs.inverse[axis]);
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        near = near.max(a - SLACK * a.abs());
        far = far.min(b + SLACK * b.abs());
    }
    (near <= far).then_some(near)
}

/// The first primitive that a ray meets at `0 < t <= t_max`: where, and which. Of several at the same place it is the
/// one with the smallest index. `test` says where the ray meets one primitive, if it does.
pub fn closest(bvh: &Bvh, ray: &Ray, t_max: f64, mut test: impl FnMut(u32) -> Option<f64>) -> Option<(f64, u32)> {
    let mut best: Option<(f64, u32)> = None;
    visit(bvh, ray, t_max, |index, reach| {
        let Some(t) = test(index).filter(|&t| t <= reach) else {
            return reach;
        };
        if best.is_none_or(|(least, first)| t < least || (t == least && index < first)) {
            best = Some((t, index));
        }
        t
    });
    best
}

/// Whether a ray meets any primitive that passes `test` before `t_max`.
pub(crate) fn meets_any(bvh: &Bvh, ray: &Ray, t_max: f64, mut test: impl FnMut(u32) -> bool) -> bool {
    let mut found = false;
    visit(bvh, ray, t_max, |index, reach| {
        found |= test(index);
        // Nothing lies before a negative reach: the walk ends.
        if found { -1.0 } else { reach }
    });
    found
}

/// Shows the primitives of every box that the ray enters within reach, near boxes first; each answers with the reach
/// from then on.
fn visit(bvh: &Bvh, ray: &Ray, t_max: f64, mut see: impl FnMut(u32, f64) -> f64) {
    let slabs = Slabs { origin: ray.origin, direction: ray.direction, inverse: ray.direction.map(|c| 1.0 / c) };
    let mut reach = t_max;
    let mut stack = [(0u32, 0.0f64); DEPTH_MAX + 1];
    let mut height = 0;
    let Some(root) = bvh.nodes.first() else {
        return;
    };
    let Some(near) = enter(&slabs, &root.bounds, reach) else {
        return;
    };
    let mut current = (0u32, near);
    loop {
        let node = &bvh.nodes[current.0 as usize];
        if current.1 <= reach {
            if node.count > 0 {
                for &index in &bvh.order[node.first as usize..(node.first + node.count) as usize] {
                    reach = see(index, reach);
                }
            } else {
                let child =
                    |index: u32| enter(&slabs, &bvh.nodes[index as usize].bounds, reach).map(|near| (index, near));
                match (child(node.first), child(node.first + 1)) {
                    (Some(a), Some(b)) => {
                        let (sooner, later) = if b.1 < a.1 { (b, a) } else { (a, b) };
                        stack[height] = later;
                        height += 1;
                        current = sooner;
                        continue;
                    }
                    (Some(only), None) | (None, Some(only)) => {
                        current = only;
                        continue;
                    }
                    (None, None) => {}
                }
            }
        }
        if height == 0 {
            return;
        }
        height -= 1;
        current = stack[height];
    }
}

/// The box around everything.
pub fn bounds(bvh: &Bvh) -> Bounds {
    bvh.nodes.first().map_or(NOTHING, |root| root.bounds)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::triangles::{intersect, shear};
    use proptest::prelude::*;

    type Triangle = [Vec3; 3];

    fn hierarchy(triangles: &[Triangle]) -> Bvh {
        let boxes: Vec<Bounds> = triangles.iter().map(|corners| around(*corners)).collect();
        build(&boxes)
    }

    fn meet(triangles: &[Triangle], ray: &Ray, index: u32) -> Option<f64> {
        intersect(&shear(ray), triangles[index as usize]).map(|(t, _)| t)
    }

    fn brute_force(triangles: &[Triangle], ray: &Ray, t_max: f64) -> Option<(f64, u32)> {
        let hits = (0..triangles.len() as u32).filter_map(|index| meet(triangles, ray, index).map(|t| (t, index)));
        hits.filter(|hit| hit.0 <= t_max).min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
    }

    fn coordinates() -> impl Strategy<Value = Vec3> {
        // Few values, so that boxes touch, corners coincide and rays run along axes and through edges; or any.
        let some = proptest::sample::select(vec![-1.0, -0.5, 0.0, 0.5, 1.0]);
        prop_oneof![proptest::array::uniform3(some), proptest::array::uniform3(-1.0..1.0f64)]
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(600) })]

        #[test]
        fn it_finds_what_brute_force_finds(
            triangles in proptest::collection::vec(proptest::array::uniform3(coordinates()), 0..120),
            origin in coordinates(), direction in coordinates(), t_max in prop_oneof![Just(f64::INFINITY), 0.0..3.0f64],
        ) {
            prop_assume!(direction != [0.0; 3]);
            let bvh = hierarchy(&triangles);
            let ray = Ray { origin: origin.map(|c| 2.0 * c), direction };
            let expected = brute_force(&triangles, &ray, t_max);
            prop_assert_eq!(closest(&bvh, &ray, t_max, |index| meet(&triangles, &ray, index)), expected);
            let hit = |index| meet(&triangles, &ray, index).is_some_and(|t| t <= t_max);
            prop_assert_eq!(meets_any(&bvh, &ray, t_max, hit), expected.is_some());
        }

        #[test]
        fn each_primitive_stands_in_one_leaf_inside_its_boxes(
            triangles in proptest::collection::vec(proptest::array::uniform3(coordinates()), 1..300),
        ) {
            let bvh = hierarchy(&triangles);
            let mut seen = vec![0; triangles.len()];
            let mut open = vec![(0usize, bvh.nodes[0].bounds)];
            while let Some((index, outer)) = open.pop() {
                let node = &bvh.nodes[index];
                prop_assert_eq!(union(&outer, &node.bounds), outer);
                if node.count == 0 {
                    open.extend([0, 1].map(|child| (node.first as usize + child, node.bounds)));
                }
                for &primitive in &bvh.order[node.first as usize..][..node.count as usize] {
                    let own = around(triangles[primitive as usize]);
                    prop_assert_eq!(union(&node.bounds, &own), node.bounds);
                    seen[primitive as usize] += 1;
                }
            }
            prop_assert!(seen.iter().all(|&times| times == 1));
        }
    }

    #[test]
    fn a_thousand_primitives_in_one_place_are_searched_without_end() {
        let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let triangles = vec![triangle; 1000];
        let bvh = hierarchy(&triangles);
        let ray = Ray { origin: [0.2, 0.2, 1.0], direction: [0.0, 0.0, -1.0] };
        // All at the same distance: the first one counts.
        assert_eq!(closest(&bvh, &ray, 9.0, |index| meet(&triangles, &ray, index)), Some((1.0, 0)));
    }

    #[test]
    fn a_search_looks_at_few_of_many() {
        // A row of 10,000 small triangles, seen from above one of them.
        let at = |k: usize| [[k as f64, 0.0, 0.0], [k as f64 + 0.9, 0.0, 0.0], [k as f64, 0.9, 0.0]];
        let triangles: Vec<Triangle> = (0..10_000).map(at).collect();
        let bvh = hierarchy(&triangles);
        let ray = Ray { origin: [7_123.2, 0.2, 5.0], direction: [0.0, 0.0, -1.0] };
        let mut looked = 0;
        let found = closest(&bvh, &ray, f64::INFINITY, |index| {
            looked += 1;
            meet(&triangles, &ray, index)
        });
        assert_eq!(found.map(|(_, index)| index), Some(7_123));
        assert!(looked <= 3 * LEAF_MAX, "{looked}");
    }

    #[test]
    fn without_primitives_there_is_nothing_to_meet() {
        let ray = Ray { origin: [0.0; 3], direction: [1.0, 0.0, 0.0] };
        assert_eq!(closest(&build(&[]), &ray, f64::INFINITY, |_| Some(1.0)), None);
        assert!(!meets_any(&build(&[]), &ray, f64::INFINITY, |_| true));
    }
}
