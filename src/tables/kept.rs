//! Sums of earlier builds: what texels of a ring came to, kept by whoever has a place for it.
//!
//! The sums of a texel depend on the surface, the light, and the cuts of its ring, and on no other texel. So they may be put
//! together from what several builds summed, each for scenes of its own, and are the same as if one build had.

use std::ops::Range;

use super::accumulate::PowerSums;
use super::domain::Texels;
use super::plan::Ring;
use super::sums::RingNodes;
use crate::ground::spectrum::SpectralQuadrature;

/// What is kept by itself.
#[derive(Debug, Clone, Copy)]
pub enum Piece<'a> {
    /// Sums of some texels of a ring.
    Ring(Cut<'a>),
    /// Those of the cross term's patch.
    Cross(Cut<'a>),
    /// The power of the mean phasor over the transforms' depths.
    Phasors,
}

/// How a ring is cut out of (u, v, w) and the light: all of it that its texels' sums depend on.
#[derive(Debug, Clone, Copy)]
pub struct Cut<'a> {
    /// Inner and outer radius.
    pub rho: [f64; 2],
    /// Wavelengths with XYZ weights.
    pub quadrature: &'a SpectralQuadrature,
    /// Nodes in depth.
    pub nodes: RingNodes,
}

impl<'a> Cut<'a> {
    /// Of a ring and its nodes.
    pub fn new(ring: &'a Ring, nodes: RingNodes) -> Self {
        Self { rho: ring.rho, quadrature: &ring.quadrature, nodes }
    }
}

/// Whoever keeps sums from build to build, for one surface, light and plan of transforms.
pub trait Keeper {
    /// The bytes last stored for a piece, if they are still there.
    fn load(&self, piece: Piece) -> Option<Vec<u8>>;
    /// Keeps bytes for a piece, in place of those before.
    fn store(&self, piece: Piece, bytes: &[u8]);
    /// Hears of how many texels the sums were known, and of how many they were not.
    fn count(&self, texels: [u64; 2]);
}

/// Bytes of the number of texels, and of a texel's index.
const COUNT_BYTES: usize = 8;
const INDEX_BYTES: usize = 4;

/// Sums of some texels of a ring as bytes: their number, their indices in the grid from the least on, and of each texel
/// `[channel][node]` floats; all from the least byte on.
#[derive(Debug, Clone, PartialEq)]
pub struct KeptRing {
    bytes: Vec<u8>,
    texels: usize,
    nodes: usize,
}

impl KeptRing {
    /// Takes bytes as sums at so many nodes; `None` if they are not.
    pub fn read(bytes: Vec<u8>, nodes: usize) -> Option<Self> {
        let nodes = nodes.next_multiple_of(4);
        let (count, rest) = bytes.split_first_chunk::<COUNT_BYTES>()?;
        let texels = usize::try_from(u64::from_le_bytes(*count)).ok()?;
        let whole = texels.checked_mul(INDEX_BYTES + 12 * nodes)? == rest.len();
        let kept = Self { bytes, texels, nodes };
        let ascend = |kept: &Self| kept.indices().zip(kept.indices().skip(1)).all(|(index, next)| index < next);
        (whole && ascend(&kept)).then_some(kept)
    }

    /// The bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Indices of its texels in the grid, row by row, ascending.
    pub fn indices(&self) -> impl Iterator<Item = usize> + '_ {
        let end = COUNT_BYTES + self.texels * INDEX_BYTES;
        let words = self.bytes[COUNT_BYTES..end].as_chunks::<INDEX_BYTES>().0.iter();
        words.map(|word| u32::from_le_bytes(*word) as usize)
    }

    /// `[channel][node]` of every texel as bytes.
    fn values(&self) -> impl Iterator<Item = &[u8]> + '_ {
        self.bytes[COUNT_BYTES + self.texels * INDEX_BYTES..].chunks_exact(12 * self.nodes)
    }

    /// Copies the sums of those texels that are asked for within a ring; gives their indices.
    pub fn copy_to(&self, sums: &mut PowerSums, texels: &Texels, rho: [f64; 2]) -> Vec<usize> {
        let mut asked = indices_within(texels, rho).peekable();
        let mut copied = Vec::new();
        for (index, values) in self.indices().zip(self.values()) {
            while asked.next_if(|&asked| asked < index).is_some() {}
            if asked.next_if_eq(&index).is_some() {
                let slots = sums.data[place(texels, index, sums.nodes)].chunks_exact_mut(sums.nodes);
                for (slots, values) in slots.zip(values.chunks_exact(4 * self.nodes)) {
                    slots.iter_mut().zip(numbers(values)).for_each(|(slot, number)| *slot = number);
                }
                copied.push(index);
            }
        }
        copied
    }

    /// The sums of a ring's texels, and of those that were kept before and are not among them.
    pub fn merged(before: Option<&Self>, sums: &PowerSums, texels: &Texels, rho: [f64; 2], nodes: usize) -> Self {
        let nodes = nodes.next_multiple_of(4);
        let count = either(before, texels, rho).count();
        let mut bytes = Vec::with_capacity(COUNT_BYTES + count * (INDEX_BYTES + 12 * nodes));
        bytes.extend((count as u64).to_le_bytes());
        bytes.extend(either(before, texels, rho).flat_map(|(index, _)| (index as u32).to_le_bytes()));
        for (index, old) in either(before, texels, rho) {
            match old {
                Some(values) => bytes.extend(values),
                None => {
                    for channel in sums.data[place(texels, index, sums.nodes)].chunks_exact(sums.nodes) {
                        bytes.extend(channel[..nodes].iter().flat_map(|number| number.to_le_bytes()));
                    }
                }
            }
        }
        Self { bytes, texels: count, nodes }
    }
}

/// Indices of a ring's texels, and those that were kept before and are not among them with what was kept; ascending.
fn either<'a>(
    before: Option<&'a KeptRing>,
    texels: &'a Texels,
    rho: [f64; 2],
) -> impl Iterator<Item = (usize, Option<&'a [u8]>)> {
    let mut own = indices_within(texels, rho).peekable();
    let mut old = before.into_iter().flat_map(|kept| kept.indices().zip(kept.values())).peekable();
    std::iter::from_fn(move || {
        let next = own.peek().copied().unwrap_or(usize::MAX);
        match old.next_if(|(index, _)| *index < next) {
            Some((index, values)) => Some((index, Some(values))),
            None => {
                old.next_if(|(index, _)| *index == next);
                own.next().map(|index| (index, None))
            }
        }
    })
}

/// Where the sums of a texel of the window lie.
fn place(texels: &Texels, index: usize, nodes: usize) -> Range<usize> {
    let [row, column] = [index / texels.grid.size, index % texels.grid.size];
    let texel = (row - texels.rows.start) * texels.columns.len() + column - texels.columns.start;
    3 * nodes * texel..3 * nodes * (texel + 1)
}

/// Indices in the grid of a ring's texels, ascending.
fn indices_within(texels: &Texels, rho: [f64; 2]) -> impl Iterator<Item = usize> + '_ {
    let of_row = move |row: usize| {
        texels.runs_in(row, rho).into_iter().flatten().map(move |column| row * texels.grid.size + column)
    };
    texels.rows.clone().flat_map(of_row)
}

/// Floats from the least byte on.
pub(super) fn numbers(bytes: &[u8]) -> impl Iterator<Item = f32> + '_ {
    bytes.as_chunks::<4>().0.iter().map(|four| f32::from_le_bytes(*four))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::domain::{Directions, Domain};
    use crate::tables::plan::Grid;
    use proptest::prelude::*;

    const RHO: [f64; 2] = [0.4, 1.5];

    fn texels(u: [f64; 2], v: [f64; 2]) -> Texels {
        let mut domain = Domain::new(Grid { size: 21, half_width: 2.0 });
        domain.mark(&Directions { u, v, t: [0.0, 1.0], q_squared: [0.0, 4.0] }, 0.0);
        Texels::reached(&domain)
    }

    /// Sums that tell texel, channel and node; `sign` tells which build they are of.
    fn sums(texels: &Texels, nodes: usize, sign: f32) -> PowerSums {
        let mut sums = PowerSums::new(texels, nodes);
        for index in indices_within(texels, RHO) {
            let own = place(texels, index, sums.nodes);
            sums.data[own].iter_mut().enumerate().for_each(|(n, slot)| *slot = sign * (index * 100 + n) as f32);
        }
        sums
    }

    fn interval() -> impl Strategy<Value = [f64; 2]> {
        (-1.8..1.8f64, 0.0..1.5f64).prop_map(|(low, length)| [low, (low + length).min(1.9)])
    }

    proptest! {
        /// Texels of two builds: the later one's values where it has some, and none lost.
        #[test]
        fn two_builds_make_one(u in [interval(), interval()], v in [interval(), interval()], more in any::<bool>()) {
            let [first, second] = [0, 1].map(|n| texels(u[n], v[n]));
            // More nodes elsewhere in the window change nothing.
            let (nodes, held) = (3, if more { 8 } else { 4 });
            let kept = KeptRing::merged(None, &sums(&first, held, 1.0), &first, RHO, nodes);
            let all = KeptRing::merged(Some(&kept), &sums(&second, held, -1.0), &second, RHO, nodes);
            let all = KeptRing::read(all.bytes().to_vec(), nodes).unwrap();
            let [of_first, of_second] = [&first, &second].map(|part| indices_within(part, RHO).collect::<Vec<_>>());
            let mut expected = [of_first.clone(), of_second.clone()].concat();
            expected.sort_unstable();
            expected.dedup();
            prop_assert_eq!(all.indices().collect::<Vec<_>>(), expected);

            let mut back = PowerSums::new(&first, nodes);
            prop_assert_eq!(&all.copy_to(&mut back, &first, RHO), &of_first);
            for index in of_first {
                let sign = if of_second.contains(&index) { -1.0 } else { 1.0 };
                for (n, &value) in back.data[place(&first, index, back.nodes)].iter().enumerate() {
                    let [channel, node] = [n / 4, n % 4];
                    prop_assert_eq!(value, sign * (index * 100 + channel * held + node) as f32);
                }
            }
            // What is not known is what lacks.
            let known = kept.copy_to(&mut sums(&second, nodes, 0.0), &second, RHO);
            let lacking = second.without(&known);
            let left: Vec<usize> = indices_within(&lacking, RHO).collect();
            prop_assert!(left.iter().all(|index| of_second.contains(index) && !known.contains(index)));
            prop_assert_eq!(left.len() + known.len(), of_second.len());
            prop_assert_eq!(lacking.count_within(RHO), left.len());
        }
    }

    #[test]
    fn bytes_that_are_no_sums_are_refused() {
        let part = texels([-1.0, 1.0], [-1.0, 1.0]);
        let kept = KeptRing::merged(None, &sums(&part, 4, 1.0), &part, RHO, 4);
        let good = kept.bytes().to_vec();
        assert_eq!(KeptRing::read(good.clone(), 4), Some(kept));
        assert_eq!(KeptRing::read(good.clone(), 8), None);
        let mut twice = good.clone();
        twice.copy_within(COUNT_BYTES..COUNT_BYTES + INDEX_BYTES, COUNT_BYTES + INDEX_BYTES);
        assert_eq!(KeptRing::read(twice, 4), None, "indices that do not ascend");
        for cut in [0, 7, 8, good.len() - 1] {
            assert_eq!(KeptRing::read(good[..cut].to_vec(), 4), None, "{cut} bytes");
        }
        let mut huge = good;
        huge[..COUNT_BYTES].fill(0xff);
        assert_eq!(KeptRing::read(huge, 4), None);
    }
}
