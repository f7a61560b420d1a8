//! Tables for the page in one file: the half floats that graphics hardware takes, packed closer than EXR packs them.
//!
//! Little-endian: the magic `DDAT`, width, height and channels as u32, a scale for each of three channels as f32, and a zlib stream. In it stands a byte
//! for each square of 8 x 8 texels, channel after channel, then low bytes of all numbers and then high ones, in the order of channels and rows.
//!
//! Stored numbers are multiples of a power of two, as coarse as the tolerance allows, and tables are smooth. So a number is told by what a plane through its left, upper and upper left
//! neighbours leaves of it, folded to be not negative: counted in the largest power of two that divides its whole square, whose exponent is the square's
//! byte, as i8; or, where those counts are long, in half floats between, squares of [`BY_ORDER`].

use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use half::f16;
use ndarray::{Array2, Array3, ArrayView2, Axis};

use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::storage::half_scale;

const MAGIC: [u8; 4] = *b"DDAT";

/// Texels along a square's side.
const SQUARE: usize = 8;

/// What stands for an exponent where numbers are counted in half floats: one that no half float has.
const BY_ORDER: i8 = i8::MAX;

/// Exponent of the last place of the smallest half floats.
const LEAST_EXPONENT: i32 = -24;

/// Which channels of a table share a scale.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scales {
    /// All three: X, Y, Z.
    Shared,
    /// None: each is a table of its own.
    Each,
}

/// A table `[rows, columns, 3]` as the page reads it. Numbers that are halves already pass as they are, but for the sign of zeros.
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
    let packed: Vec<Packed> =
        table.axis_iter(Axis(2)).zip(&found).map(|(channel, &scale)| packed(channel, scale)).collect();
    let counts = || packed.iter().flat_map(|channel| &channel.counts);
    let mut bytes: Vec<u8> = packed.iter().flat_map(|channel| &channel.squares).map(|&square| square as u8).collect();
    bytes.extend(counts().map(|&count| count as u8));
    bytes.extend(counts().map(|&count| (count >> 8) as u8));
    let mut stream = ZlibEncoder::new(out, Compression::best());
    let failed = |error| Error::Call(format!("a table cannot be packed: {error}"));
    stream.write_all(&bytes).map_err(failed)?;
    stream.finish().map_err(failed)
}

/// A channel's squares, and its numbers by what neighbours leave of them.
struct Packed {
    squares: Vec<i8>,
    counts: Array2<u16>,
}

fn packed(channel: ArrayView2<f32>, scale: f32) -> Packed {
    let halves = channel.mapv(|value| f16::from_f32(value / scale));
    let orders = halves.mapv(order);
    let values = halves.mapv(f64::from);
    let (rows, columns) = channel.dim();
    let mut counts = Array2::zeros((rows, columns));
    let mut squares = Vec::new();
    for top in (0..rows).step_by(SQUARE) {
        for left in (0..columns).step_by(SQUARE) {
            let [bottom, right] = [(top + SQUARE).min(rows), (left + SQUARE).min(columns)];
            let places: Vec<[usize; 2]> =
                (top..bottom).flat_map(|row| (left..right).map(move |column| [row, column])).collect();
            let exponent = places.iter().filter_map(|&at| last_place(values[at])).min().unwrap_or(0);
            let unit = f64::from(exponent).exp2();
            let by_value: Vec<f64> = places.iter().map(|&at| folded_count(&values, at, unit)).collect();
            let by_order: Vec<u16> = places.iter().map(|&at| folded_order(&orders, at)).collect();
            let bits = |count: f64| (count + 1.0).log2();
            let fits = by_value.iter().all(|&count| count <= f64::from(u16::MAX));
            let shorter = by_value.iter().map(|&count| bits(count)).sum::<f64>()
                <= by_order.iter().map(|&count| bits(count.into())).sum::<f64>();
            let by_value = (fits && shorter).then_some(by_value);
            squares.push(if by_value.is_some() { exponent as i8 } else { BY_ORDER });
            for (index, &at) in places.iter().enumerate() {
                counts[at] = by_value.as_ref().map_or(by_order[index], |counts| counts[index] as u16);
            }
        }
    }
    Packed { squares, counts }
}

/// Half floats as integers in the order of their values.
fn order(half: f16) -> i16 {
    let size = (half.to_bits() & 0x7fff) as i16;
    if half.to_bits() & 0x8000 == 0 { size } else { -1 - size }
}

/// Exponent of the largest power of two that divides a half float; `None` of zero.
fn last_place(value: f64) -> Option<i32> {
    let whole = (value.abs() * f64::from(-LEAST_EXPONENT).exp2()) as u64;
    (whole > 0).then(|| LEAST_EXPONENT + whole.trailing_zeros() as i32)
}

/// A number at `[row - up, column - left]`; 0 outside.
fn near<T: Copy + Default>(numbers: &Array2<T>, [row, column]: [usize; 2], up: usize, left: usize) -> T {
    if row < up || column < left { T::default() } else { numbers[[row - up, column - left]] }
}

/// How many units a number is away from the plane's, folded.
fn folded_count(values: &Array2<f64>, at: [usize; 2], unit: f64) -> f64 {
    let plane = near(values, at, 0, 1) + near(values, at, 1, 0) - near(values, at, 1, 1);
    let count = values[at] / unit - (plane / unit + 0.5).floor();
    if count < 0.0 { -2.0 * count - 1.0 } else { 2.0 * count }
}

/// How many half floats a number is away from the plane's, folded.
fn folded_order(orders: &Array2<i16>, at: [usize; 2]) -> u16 {
    let plane = near(orders, at, 0, 1).wrapping_add(near(orders, at, 1, 0)).wrapping_sub(near(orders, at, 1, 1));
    let residual = orders[at].wrapping_sub(plane);
    ((residual << 1) ^ (residual >> 15)) as u16
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
        let across = columns.div_ceil(8);
        let squares = across * rows.div_ceil(8);
        let count = rows * columns * channels;
        let mut out = vec![0.0; count];
        for c in 0..channels {
            let scale = f32::from_le_bytes(bytes[16 + 4 * c..20 + 4 * c].try_into().unwrap());
            let mut halves = vec![f16::ZERO; rows * columns];
            for i in 0..halves.len() {
                let k = channels * squares + c * rows * columns + i;
                let folded = u16::from(raw[k]) | u16::from(raw[count + k]) << 8;
                let residual = (folded >> 1) as i16 ^ -((folded & 1) as i16);
                let (row, column) = (i / columns, i % columns);
                let near = |up: usize, left: usize| {
                    if row < up || column < left { f16::ZERO } else { halves[i - up * columns - left] }
                };
                halves[i] = match raw[c * squares + row / 8 * across + column / 8] as i8 {
                    127 => {
                        let [left, up, corner] = [near(0, 1), near(1, 0), near(1, 1)].map(order);
                        let whole = residual.wrapping_add(left).wrapping_add(up).wrapping_sub(corner);
                        f16::from_bits(if whole < 0 { 0x8000 | (-1 - whole) as u16 } else { whole as u16 })
                    }
                    exponent => {
                        let plane = near(0, 1).to_f64() + near(1, 0).to_f64() - near(1, 1).to_f64();
                        let unit = f64::from(exponent).exp2();
                        f16::from_f64(((plane / unit + 0.5).floor() + f64::from(residual)) * unit)
                    }
                };
                out[i * channels + c] = halves[i].to_f32() * scale;
            }
        }
        out
    }

    fn waves() -> Array3<f32> {
        Array3::from_shape_fn((21, 13, 3), |(row, column, c)| {
            ((row as f32 * 0.7).sin() - 0.4) * (column as f32 * 0.3 + c as f32).cos() * [1e3, -2.0, 1e-4][c]
        })
    }

    #[test]
    fn halves_come_back_and_floats_to_half_precision() {
        let table = waves();
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

    /// Multiples of four take some bits where half floats of their size take ten; both kinds of squares occur.
    #[test]
    fn coarse_numbers_are_counted_in_what_divides_them() {
        let fine = Array3::from_shape_fn((64, 64, 3), |(row, column, c)| {
            let smooth = 200.0 * (-((row as f32 - 30.0).powi(2) + (column as f32 - 20.0).powi(2)) / 300.0).exp();
            smooth * (1.0 + c as f32) * (1.0 + 0.01 * ((row * 7 + column * 13) % 11) as f32)
        });
        let halves = |table: &Array3<f32>| table.mapv(|value| f16::from_f32(value).to_f32());
        let coarse = fine.mapv(|value| (value / 4.0).round() * 4.0);
        let [fine, coarse] = [halves(&fine), halves(&coarse)];
        let [long, short] = [&fine, &coarse].map(|table| pack(table, Scales::Shared).unwrap());
        assert!(unpacked(&long).iter().eq(fine.iter()) && unpacked(&short).iter().eq(coarse.iter()));
        assert!(2 * short.len() < long.len(), "{} of {}", short.len(), long.len());
        let kinds = |table: &Array3<f32>| packed(table.index_axis(Axis(2), 0), 1.0).squares;
        assert!(kinds(&fine).contains(&BY_ORDER) && kinds(&coarse).contains(&2), "{:?}", kinds(&coarse));
    }
}
