//! Sums of earlier builds: what texels of a ring came to, kept by whoever has a place for it.
//!
//! The sums of a texel depend on the surface, the light, and the cuts of its ring, and on no other texel. So they may be put
//! together from what several builds summed, each for scenes of its own, and are the same as if one build had.

use std::ops::Range;

use super::accumulate::{GROUP, PowerSums};
use super::domain::Texels;
use super::plan::Ring;
use super::sums::RingNodes;
use crate::ground::spectrum::SpectralQuadrature;

/// What is kept by itself.
#[derive(Debug, Clone, Copy)]
pub enum Piece<'a> {
    /// Sums of some texels of a ring, those in one block of rows.
    Ring(Cut<'a>, usize),
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

/// Rows of the grid whose sums are kept together: few enough for an entry to be small beside all sums, so that
/// reading, joining and writing one takes little memory, and blocks in which nothing is new are not written again.
const BLOCK_ROWS: usize = 64;

/// Sums over so few wavelengths, of all windows together, are sooner computed than read.
const WAVELENGTHS_MIN: usize = 16;

/// Whether the sums of a ring are worth keeping.
pub(super) fn is_worth_keeping(ring: &Ring, windows: usize) -> bool {
    ring.quadrature.wavelengths_nm.len() * windows >= WAVELENGTHS_MIN
}

/// The blocks that hold rows of the texels, by number, each with those of its rows that are theirs.
pub(super) fn blocks(texels: &Texels) -> impl Iterator<Item = (usize, Range<usize>)> {
    let rows = texels.rows.clone();
    let numbers = rows.start / BLOCK_ROWS..rows.end.div_ceil(BLOCK_ROWS);
    numbers.map(move |block| {
        let [start, end] = [block, block + 1].map(|block| block * BLOCK_ROWS);
        (block, start.max(rows.start)..end.min(rows.end))
    })
}

/// The part of a ring that lies in some rows of the grid.
#[derive(Debug, Clone)]
pub(super) struct Part<'a> {
    pub texels: &'a Texels,
    pub rho: [f64; 2],
    pub rows: Range<usize>,
}

impl Part<'_> {
    /// Indices in the grid of its texels, ascending.
    pub fn indices(&self) -> impl Iterator<Item = usize> + '_ {
        let size = self.texels.grid.size;
        let of_row = move |row: usize| {
            self.texels.runs_in(row, self.rho).into_iter().flatten().map(move |column| row * size + column)
        };
        self.rows.clone().flat_map(of_row)
    }

    /// Where the sums of one of its texels lie.
    fn place(&self, index: usize, nodes: usize) -> Range<usize> {
        let Texels { grid, rows, columns, .. } = self.texels;
        let [row, column] = [index / grid.size, index % grid.size];
        let texel = (row - rows.start) * columns.len() + column - columns.start;
        3 * nodes * texel..3 * nodes * (texel + 1)
    }
}

/// Bytes of the number of texels, and of a texel's index.
const COUNT_BYTES: usize = 8;
const INDEX_BYTES: usize = 4;

/// Sums of some texels of a ring, of one block of rows, as bytes: how many texels, their indices in the grid in ascending
/// order, then `[channel][node]` floats of each. All numbers are little-endian.
#[derive(Debug, Clone, PartialEq)]
pub struct KeptSums {
    bytes: Vec<u8>,
    texels: usize,
    nodes: usize,
}

impl KeptSums {
    /// Takes bytes as sums at so many nodes; `None` if they are not.
    pub fn read(bytes: Vec<u8>, nodes: usize) -> Option<Self> {
        let nodes = nodes.next_multiple_of(GROUP);
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

    /// Copies the sums of those texels that are asked for; gives their indices.
    pub(super) fn copy_to(&self, sums: &mut PowerSums, part: &Part) -> Vec<usize> {
        let mut asked = part.indices().peekable();
        let mut copied = Vec::new();
        for (index, values) in self.indices().zip(self.values()) {
            while asked.next_if(|&asked| asked < index).is_some() {}
            if asked.next_if_eq(&index).is_some() {
                let slots = sums.data[part.place(index, sums.nodes)].chunks_exact_mut(sums.nodes);
                for (slots, values) in slots.zip(values.chunks_exact(4 * self.nodes)) {
                    slots.iter_mut().zip(numbers(values)).for_each(|(slot, number)| *slot = number);
                }
                copied.push(index);
            }
        }
        copied
    }

    /// The sums of a part's texels, and of those that were kept before and are not among them.
    pub(super) fn merged(before: Option<&Self>, sums: &PowerSums, part: &Part, nodes: usize) -> Self {
        let nodes = nodes.next_multiple_of(GROUP);
        let count = either(before, part).count();
        let mut bytes = Vec::with_capacity(COUNT_BYTES + count * (INDEX_BYTES + 12 * nodes));
        bytes.extend((count as u64).to_le_bytes());
        bytes.extend(either(before, part).flat_map(|(index, _)| (index as u32).to_le_bytes()));
        for (index, old) in either(before, part) {
            match old {
                Some(values) => bytes.extend(values),
                None => {
                    for channel in sums.data[part.place(index, sums.nodes)].chunks_exact(sums.nodes) {
                        bytes.extend(channel[..nodes].iter().flat_map(|number| number.to_le_bytes()));
                    }
                }
            }
        }
        Self { bytes, texels: count, nodes }
    }
}

/// Indices of a part's texels, and those that were kept before and are not among them with what was kept; ascending.
fn either<'a>(before: Option<&'a KeptSums>, part: &'a Part) -> impl Iterator<Item = (usize, Option<&'a [u8]>)> {
    let mut own = part.indices().peekable();
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

/// Little-endian floats.
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
        let held = sums.nodes;
        let part = whole(texels);
        for index in part.indices() {
            sums.data[part.place(index, held)]
                .iter_mut()
                .enumerate()
                .for_each(|(n, slot)| *slot = sign * (index * 100 + n) as f32);
        }
        sums
    }

    /// All of them that lie within the ring.
    fn whole(texels: &Texels) -> Part<'_> {
        Part { texels, rho: RHO, rows: texels.rows.clone() }
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
            let kept = KeptSums::merged(None, &sums(&first, held, 1.0), &whole(&first), nodes);
            let all = KeptSums::merged(Some(&kept), &sums(&second, held, -1.0), &whole(&second), nodes);
            let all = KeptSums::read(all.bytes().to_vec(), nodes).unwrap();
            let [of_first, of_second] = [&first, &second].map(|texels| whole(texels).indices().collect::<Vec<_>>());
            let mut expected = [of_first.clone(), of_second.clone()].concat();
            expected.sort_unstable();
            expected.dedup();
            prop_assert_eq!(all.indices().collect::<Vec<_>>(), expected);

            let mut back = PowerSums::new(&first, nodes);
            prop_assert_eq!(&all.copy_to(&mut back, &whole(&first)), &of_first);
            for index in of_first {
                let sign = if of_second.contains(&index) { -1.0 } else { 1.0 };
                for (n, &value) in back.data[whole(&first).place(index, back.nodes)].iter().enumerate() {
                    let [channel, node] = [n / 4, n % 4];
                    prop_assert_eq!(value, sign * (index * 100 + channel * held + node) as f32);
                }
            }
            // What is not known is what lacks.
            let known = kept.copy_to(&mut sums(&second, nodes, 0.0), &whole(&second));
            let lacking = second.without(&known);
            let left: Vec<usize> = whole(&lacking).indices().collect();
            prop_assert!(left.iter().all(|index| of_second.contains(index) && !known.contains(index)));
            prop_assert_eq!(left.len() + known.len(), of_second.len());
            prop_assert_eq!(lacking.count_within(RHO), left.len());
        }
    }

    #[test]
    fn blocks_hold_every_row_once() {
        let domain = |size: usize| {
            let mut domain = Domain::new(Grid { size, half_width: 2.0 });
            let directions = Directions { u: [0.0; 2], v: [-1.0, 0.9], t: [0.0, 1.0], q_squared: [0.0, 4.0] };
            domain.mark(&directions, 0.0);
            Texels::reached(&domain)
        };
        for size in [21, 129, 601] {
            let texels = domain(size);
            let rows: Vec<usize> = blocks(&texels).flat_map(|(_, rows)| rows).collect();
            assert_eq!(rows, texels.rows.clone().collect::<Vec<_>>());
            assert!(blocks(&texels).all(|(block, rows)| rows.clone().all(|row| row / BLOCK_ROWS == block)));
        }
    }

    #[test]
    fn bytes_that_are_no_sums_are_refused() {
        let part = texels([-1.0, 1.0], [-1.0, 1.0]);
        let kept = KeptSums::merged(None, &sums(&part, 4, 1.0), &whole(&part), 4);
        let good = kept.bytes().to_vec();
        assert_eq!(KeptSums::read(good.clone(), 4), Some(kept));
        assert_eq!(KeptSums::read(good.clone(), 8), None);
        let mut twice = good.clone();
        twice.copy_within(COUNT_BYTES..COUNT_BYTES + INDEX_BYTES, COUNT_BYTES + INDEX_BYTES);
        assert_eq!(KeptSums::read(twice, 4), None, "indices that do not ascend");
        for cut in [0, 7, 8, good.len() - 1] {
            assert_eq!(KeptSums::read(good[..cut].to_vec(), 4), None, "{cut} bytes");
        }
        let mut huge = good;
        huge[..COUNT_BYTES].fill(0xff);
        assert_eq!(KeptSums::read(huge, 4), None);
    }
}
