//! Numbers at places of an untrusted file, and blocks of samples whose size is checked before memory is taken.

use super::refusal::{Parsed, Refusal};
use super::stored::SampleKind;
use super::text;

/// A file and the order of its bytes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Binary<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) little_endian: bool,
}

impl<'a> Binary<'a> {
    pub(super) fn little(bytes: &'a [u8]) -> Self {
        Self { bytes, little_endian: true }
    }

    /// `length` bytes from `at` on.
    pub(super) fn range(self, at: usize, length: usize) -> Parsed<&'a [u8]> {
        at.checked_add(length).and_then(|end| self.bytes.get(at..end)).ok_or_else(|| {
            Refusal::damaged(format!(
                "{length} bytes at byte {at} lie outside the file, which has {}",
                self.bytes.len()
            ))
        })
    }

    /// The bytes of a number, lowest first.
    fn array<const N: usize>(self, at: usize) -> Parsed<[u8; N]> {
        let mut array = [0; N];
        array.copy_from_slice(self.range(at, N)?);
        if !self.little_endian {
            array.reverse();
        }
        Ok(array)
    }

    pub(super) fn u16(self, at: usize) -> Parsed<u16> {
        self.array(at).map(u16::from_le_bytes)
    }

    pub(super) fn u32(self, at: usize) -> Parsed<u32> {
        self.array(at).map(u32::from_le_bytes)
    }

    pub(super) fn i32(self, at: usize) -> Parsed<i32> {
        self.array(at).map(i32::from_le_bytes)
    }

    pub(super) fn f32(self, at: usize) -> Parsed<f64> {
        self.array(at).map(f32::from_le_bytes).map(f64::from)
    }

    pub(super) fn f64(self, at: usize) -> Parsed<f64> {
        self.array(at).map(f64::from_le_bytes)
    }

    /// A field of text, without what pads it.
    pub(super) fn text(self, at: usize, length: usize) -> Parsed<String> {
        Ok(text::decode(self.range(at, length)?).trim().to_owned())
    }

    /// `size[0] * size[1]` samples from `at` on, in the file's order. The caller has bounded their number.
    pub(super) fn samples(self, at: usize, size: [u32; 2], kind: SampleKind) -> Parsed<Vec<f64>> {
        let needed = u64::from(size[0]) * u64::from(size[1]) * kind.bytes() as u64;
        let block = usize::try_from(needed).ok().and_then(|needed| self.bytes.get(at..at.checked_add(needed)?));
        let Some(block) = block else {
            return Err(Refusal::damaged(format!(
                "{} x {} samples at byte {at} need {needed} bytes; the file ends before",
                size[0], size[1]
            )));
        };
        Ok(numbers(block, kind, self.little_endian))
    }
}

/// Widens samples in a row; exact.
fn numbers(block: &[u8], kind: SampleKind, little_endian: bool) -> Vec<f64> {
    /// Samples of `N` bytes, given lowest byte first.
    fn of<const N: usize>(block: &[u8], little_endian: bool, number: impl Fn([u8; N]) -> f64) -> Vec<f64> {
        let sample = |bytes: &[u8]| {
            let mut array = [0; N];
            array.copy_from_slice(bytes);
            if !little_endian {
                array.reverse();
            }
            number(array)
        };
        block.chunks_exact(N).map(sample).collect()
    }
    match kind {
        SampleKind::U8 => of(block, little_endian, |[byte]| f64::from(byte)),
        SampleKind::I8 => of(block, little_endian, |bytes| f64::from(i8::from_le_bytes(bytes))),
        SampleKind::U16 => of(block, little_endian, |bytes| f64::from(u16::from_le_bytes(bytes))),
        SampleKind::I16 => of(block, little_endian, |bytes| f64::from(i16::from_le_bytes(bytes))),
        SampleKind::U32 => of(block, little_endian, |bytes| f64::from(u32::from_le_bytes(bytes))),
        SampleKind::I32 => of(block, little_endian, |bytes| f64::from(i32::from_le_bytes(bytes))),
        SampleKind::F16 => of(block, little_endian, |bytes| half::f16::from_le_bytes(bytes).to_f64()),
        SampleKind::F32 => of(block, little_endian, |bytes| f64::from(f32::from_le_bytes(bytes))),
        SampleKind::F64 => of(block, little_endian, f64::from_le_bytes),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_orders_and_every_kind() {
        for little_endian in [true, false] {
            let ordered = |mut bytes: Vec<u8>| {
                if !little_endian {
                    bytes.reverse();
                }
                bytes
            };
            for (kind, bytes, value) in [
                (SampleKind::U8, vec![200], 200.0),
                (SampleKind::I8, vec![200], -56.0),
                (SampleKind::U16, 65_000u16.to_le_bytes().to_vec(), 65_000.0),
                (SampleKind::I16, (-2i16).to_le_bytes().to_vec(), -2.0),
                (SampleKind::U32, 4_000_000_000u32.to_le_bytes().to_vec(), 4e9),
                (SampleKind::I32, (-70_000i32).to_le_bytes().to_vec(), -70_000.0),
                (SampleKind::F32, 1.5f32.to_le_bytes().to_vec(), 1.5),
                (SampleKind::F64, (-0.1f64).to_le_bytes().to_vec(), -0.1),
            ] {
                let file = [vec![9], ordered(bytes)].concat();
                let binary = Binary { bytes: &file, little_endian };
                assert_eq!(binary.samples(1, [1, 1], kind).unwrap(), [value], "{kind:?}");
                assert!(binary.samples(1, [1, 2], kind).is_err(), "{kind:?}");
            }
        }
    }

    #[test]
    fn sizes_that_lie_take_no_memory() {
        let binary = Binary::little(&[0; 16]);
        assert!(binary.samples(8, [u32::MAX, u32::MAX], SampleKind::F64).is_err());
        assert!(binary.samples(usize::MAX, [1, 1], SampleKind::U8).is_err());
        assert!(binary.range(usize::MAX, 2).is_err() && binary.range(2, usize::MAX).is_err());
        assert!(binary.f64(9).is_err() && binary.f64(8).is_ok());
    }
}
