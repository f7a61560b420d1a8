//! Tables for the page in one file: the half floats that graphics hardware takes, packed closer than EXR packs them.
//!
//! Little-endian: the magic `DDAH`, width, height and channels as u32, a scale for each of three channels as f32, and a zlib stream. In it, channel
//! after channel and row after row, what a plane through the left, upper and upper left neighbours leaves of each number's bits, taken as an integer that
//! grows with the value; folded to be not negative; low bytes of all first, then high ones. Tables are smooth: that is little.

use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use half::f16;
use ndarray::{Array3, ArrayView2, Axis};

use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::storage::half_scale;

const MAGIC: [u8; 4] = *b"DDAH";

/// Which channels of a table share a scale.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scales {
    /// All three: X, Y, Z.
    Shared,
    /// None: each is a table of its own.
    Each,
}

/// A table `[rows, columns, 3]` as the page reads it. Numbers that are halves already pass as they are.
pub(crate) fn pack(table: &Array3<f32>, scales: Scales) -> Result<Vec<u8>> {
    let (rows, columns, channels) = table.dim();
    let are_halves = table.iter().all(|&value| f16::from_f32(value).to_f32() == value);
    let peak = |values: &mut dyn Iterator<Item = &f32>| values.fold(0.0f32, |peak, value| peak.max(value.abs()));
    let whole = peak(&mut table.iter());
    let scale_of = |channel: ArrayView2<f32>| match scales {
        _ if are_halves => 1.0,
        Scales::Shared => half_scale(whole),
        Scales::Each => half_scale(peak(&mut channel.iter())),
    };
    let found: Vec<f32> = table.axis_iter(Axis(2)).map(scale_of).collect();
    let mut out = MAGIC.to_vec();
    [columns, rows, channels].iter().for_each(|&n| out.extend((n as u32).to_le_bytes()));
    found.iter().for_each(|scale| out.extend(scale.to_le_bytes()));
    let residuals: Vec<u16> =
        table.axis_iter(Axis(2)).zip(&found).flat_map(|(channel, &scale)| residuals(channel, scale)).collect();
    let bytes: Vec<u8> = [0, 8].iter().flat_map(|shift| residuals.iter().map(move |&r| (r >> shift) as u8)).collect();
    let mut stream = ZlibEncoder::new(out, Compression::best());
    let failed = |error| Error::Call(format!("a table cannot be packed: {error}"));
    stream.write_all(&bytes).map_err(failed)?;
    stream.finish().map_err(failed)
}

/// What a plane through three neighbours leaves of each number of a channel, folded.
fn residuals(channel: ArrayView2<f32>, scale: f32) -> Vec<u16> {
    // Integers in the order of the values.
    let whole = channel.mapv(|value| {
        let bits = f16::from_f32(value / scale).to_bits();
        let size = (bits & 0x7fff) as i16;
        if bits & 0x8000 == 0 { size } else { -1 - size }
    });
    let at = |row: usize, column: usize, up: usize, left: usize| {
        if row < up || column < left { 0 } else { whole[[row - up, column - left]] }
    };
    let fold = |((row, column), value): ((usize, usize), &i16)| {
        let plane = at(row, column, 0, 1).wrapping_add(at(row, column, 1, 0)).wrapping_sub(at(row, column, 1, 1));
        let residual = value.wrapping_sub(plane);
        ((residual << 1) ^ (residual >> 15)) as u16
    };
    whole.indexed_iter().map(fold).collect()
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::*;

    /// The other way, by the format's description.
    fn unpacked(bytes: &[u8]) -> Vec<f32> {
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        let [columns, rows, channels] = [4, 8, 12].map(number);
        let mut raw = Vec::new();
        flate2::read::ZlibDecoder::new(&bytes[28..]).read_to_end(&mut raw).unwrap();
        let count = rows * columns * channels;
        let mut out = vec![0.0; count];
        for c in 0..channels {
            let scale = f32::from_le_bytes(bytes[16 + 4 * c..20 + 4 * c].try_into().unwrap());
            let mut whole = vec![0i16; rows * columns];
            for i in 0..whole.len() {
                let k = c * rows * columns + i;
                let folded = u16::from(raw[k]) | u16::from(raw[count + k]) << 8;
                let residual = (folded >> 1) as i16 ^ -((folded & 1) as i16);
                let [left, up] = [i % columns > 0, i >= columns];
                let near = |is_there: bool, back: usize| if is_there { whole[i - back] } else { 0 };
                let plane = near(left, 1).wrapping_add(near(up, columns)).wrapping_sub(near(left && up, columns + 1));
                whole[i] = residual.wrapping_add(plane);
                let bits = if whole[i] < 0 { 0x8000 | (-1 - whole[i]) as u16 } else { whole[i] as u16 };
                out[i * channels + c] = f16::from_bits(bits).to_f32() * scale;
            }
        }
        out
    }

    #[test]
    fn halves_come_back_and_floats_to_half_precision() {
        let wave = |(row, column, c): (usize, usize, usize)| {
            ((row as f32 * 0.7).sin() - 0.4) * (column as f32 * 0.3 + c as f32).cos() * [1e3, -2.0, 1e-4][c]
        };
        let table = Array3::from_shape_fn((13, 9, 3), wave);
        for scales in [Scales::Shared, Scales::Each] {
            let found = unpacked(&pack(&table, scales).unwrap());
            for (value, (index, wanted)) in found.iter().zip(table.indexed_iter()) {
                let peak = if scales == Scales::Each { [1.4e3, 2.8, 1.4e-4][index.2] } else { 1.4e3 };
                let bound = wanted.abs() / 2048.0 + peak * 2f32.powi(-36);
                assert!((value - wanted).abs() <= bound, "{value} for {wanted}");
            }
        }
        let halves = table.mapv(|value| f16::from_f32(value).to_f32());
        let packed = pack(&halves, Scales::Shared).unwrap();
        assert!(unpacked(&packed).iter().eq(halves.iter()));
        let mut spoilt = packed.clone();
        spoilt[17] ^= 1;
        assert!(!unpacked(&spoilt).iter().eq(halves.iter()), "a wrong scale must be found");
    }
}
