//! Scales on a body: rows of overlapping rounded rhombs, each a little facet with an edge.
//!
//! Scale coordinates: `along` counts rings of scales from head to tail, `around` counts scales around the body. Ring i
//! has its scales' middles at `along = i`; odd rings are shifted by half a scale, as tiles are. A scale reaches one ring
//! forwards and back; where two overlap, the one nearer to the head lies on top, so each shows its hind part.

/// Superellipse exponent of the outline: 1 is a rhomb, 2 an ellipse. Rhombs just meet, so anything above covers.
const OUTLINE: f64 = 1.45;
/// Where the scale begins to bend down towards its edge, in [`Scale::outline`].
const RIM: f64 = 0.62;
/// Slope at the very edge.
const RIM_SLOPE: f64 = 0.35;
/// Beyond this the edge is skin without the structure: dark.
const SKIN: f64 = 0.93;
/// How much the hind end stands off, as a slope.
const RISE: f64 = 0.05;
/// Share of the body's roundness that a scale does not follow: 0 lies flush, 1 is a flat facet.
const FLATNESS: f64 = 0.5;
/// Largest chance slope of a scale as a whole, in either direction.
const UNEVEN: f64 = 0.02;

/// Where a point lies on its scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Which ring, from the head.
    pub ring: i64,
    /// Which scale of the ring.
    pub column: i64,
    /// Place on the scale: -1 at its front tip, 1 at its hind tip.
    pub lengthwise: f64,
    /// -1 and 1 at its sides.
    pub crosswise: f64,
    /// 0 in the middle, 1 on the outline.
    pub outline: f64,
}

/// The scale that lies on top at a place, of `columns` around the body.
pub(crate) fn scale_at(along: f64, around: f64, columns: u32) -> Scale {
    let ring = along.floor() as i64;
    let upper = on_ring(ring, along, around, columns);
    if upper.outline <= 1.0 { upper } else { on_ring(ring + 1, along, around, columns) }
}

fn on_ring(ring: i64, along: f64, around: f64, columns: u32) -> Scale {
    let shift = if ring.rem_euclid(2) == 1 { 0.5 } else { 0.0 };
    let column = (around - shift).round();
    let (lengthwise, crosswise) = (along - ring as f64, 2.0 * (around - shift - column));
    Scale {
        ring,
        column: (column as i64).rem_euclid(i64::from(columns)),
        lengthwise,
        crosswise,
        outline: (lengthwise.abs().powf(OUTLINE) + crosswise.abs().powf(OUTLINE)).powf(1.0 / OUTLINE),
    }
}

/// Slopes of the scale against the smooth body, along it (towards the tail) and around it: how fast its surface rises.
/// `None` on the skin between scales.
pub fn slopes(scale: &Scale, columns: u32) -> Option<[f64; 2]> {
    if scale.outline > SKIN {
        return None;
    }
    let bend = ((scale.outline - RIM) / (SKIN - RIM)).clamp(0.0, 1.0);
    let fall = RIM_SLOPE * bend * bend;
    // Away from the middle: the gradient of the outline, not its length.
    let away = [scale.lengthwise, scale.crosswise].map(|c| c.signum() * c.abs().powf(OUTLINE - 1.0));
    // Half a scale spans π / columns of the body's roundness.
    let roundness = std::f64::consts::PI / f64::from(columns) * scale.crosswise;
    let [chance_along, chance_around] = chance(scale.ring, scale.column);
    Some([
        RISE - fall * away[0] + UNEVEN * chance_along,
        FLATNESS * roundness.tan() - fall * away[1] + UNEVEN * chance_around,
    ])
}

/// Two numbers in [-1, 1) that belong to a scale: SplitMix64 of its place.
fn chance(ring: i64, column: i64) -> [f64; 2] {
    let mut state = (ring as u64).wrapping_mul(0x1_0000).wrapping_add(column as u64);
    std::array::from_fn(|_| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const COLUMNS: u32 = 15;

    proptest! {
        #[test]
        fn scales_cover_the_body(along in -3.0..200.0f64, around in -7.5..7.5f64) {
            let scale = scale_at(along, around, COLUMNS);
            prop_assert!(scale.outline <= 1.0 && scale.lengthwise.abs() <= 1.0 && scale.crosswise.abs() <= 1.0);
        }

        #[test]
        fn the_scale_nearer_to_the_head_lies_on_top(along in 0.0..50.0f64, around in -7.5..7.5f64) {
            let scale = scale_at(along, around, COLUMNS);
            // Every scale that reaches there, tried one by one.
            let first = (along.floor() as i64 - 2..=along.ceil() as i64 + 2)
                .find(|&ring| on_ring(ring, along, around, COLUMNS).outline <= 1.0);
            prop_assert_eq!(Some(scale.ring), first);
        }

        #[test]
        fn the_pattern_closes_around_the_body(along in 0.0..50.0f64, around in -7.5..7.5f64) {
            let (a, b) = (scale_at(along, around, COLUMNS), scale_at(along, around + f64::from(COLUMNS), COLUMNS));
            prop_assert_eq!((a.ring, a.column), (b.ring, b.column));
            prop_assert!((a.crosswise - b.crosswise).abs() < 1e-12);
        }

        #[test]
        fn slopes_are_gentle_but_at_the_edge(along in 0.0..50.0f64, around in -7.5..7.5f64) {
            let scale = scale_at(along, around, COLUMNS);
            match slopes(&scale, COLUMNS) {
                None => prop_assert!(scale.outline > SKIN),
                Some(slopes) => {
                    let middle = RISE + UNEVEN + FLATNESS * (std::f64::consts::PI / f64::from(COLUMNS)).tan();
                    let most = if scale.outline < RIM { middle } else { middle + RIM_SLOPE };
                    prop_assert!(slopes.iter().all(|s| s.abs() <= most), "{:?} {:?}", scale, slopes);
                }
            }
        }
    }

    #[test]
    fn each_scale_is_tilted_by_its_own_small_amount() {
        let all: Vec<[f64; 2]> = (0..40).flat_map(|ring| (0..15).map(move |column| chance(ring, column))).collect();
        assert!(all.iter().flatten().all(|c| (-1.0..1.0).contains(c)));
        // Mean of 1200 uniform numbers: standard deviation 1 / sqrt(3 · 1200) = 0.017; five of them.
        let mean = all.iter().flatten().sum::<f64>() / 1200.0;
        assert!(mean.abs() < 0.085, "{mean}");
        assert!(all.iter().enumerate().all(|(i, a)| !all[..i].contains(a)));
    }
}
