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
        let mut asked = indices_within(texels, rho).peekable();
        let mut old = before.into_iter().flat_map(|kept| kept.indices().zip(kept.values())).peekable();
        let mut indices: Vec<u32> = Vec::new();
        let mut values: Vec<u8> = Vec::new();
        loop {
            let own = match (asked.peek(), old.peek()) {
                (None, None) => break,
                (Some(own), Some((kept, _))) => own <= kept,
                (own, _) => own.is_some(),
            };
            let index = if own {
                asked.next().inspect(|&index| {
                    old.next_if(|(kept, _)| *kept == index);
                    for channel in sums.data[place(texels, index, sums.nodes)].chunks_exact(sums.nodes) {
                        values.extend(channel[..nodes].iter().flat_map(|number| number.to_le_bytes()));
                    }
                })
            } else {
                old.next().map(|(index, kept)| {
                    values.extend(kept);
                    index
                })
            };
            indices.extend(index.map(|index| index as u32));
        }
        let mut bytes = Vec::with_capacity(COUNT_BYTES + indices.len() * INDEX_BYTES + values.len());
        bytes.extend((indices.len() as u64).to_le_bytes());
        bytes.extend(indices.iter().flat_map(|index| index.to_le_bytes()));
        bytes.append(&mut values);
        Self { bytes, texels: indices.len(), nodes }
    }
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
