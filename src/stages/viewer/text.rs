//! Bytes as the text of an HTML element: eight bits take a byte and a seventh, where base64 takes a third more.
//!
//! Seven bits at a time, the first in the byte's highest places, are the character of that number. Three of them an element cannot hold as they are: NUL, the
//! carriage return, and `<`. With the seven bits that follow they make one character from U+0100 on, two bytes of UTF-8: 128 times the place among the
//! three, and the seven bits. The last character's missing bits are 0.

/// What an HTML element changes, or takes for markup.
const REFUSED: [u8; 3] = [0, b'\r', b'<'];

/// First of the characters that hold twice seven bits.
const PAIRS: u32 = 0x100;

/// Bytes as text without NUL, carriage return and `<`.
pub(crate) fn encoded(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len() / 7 * 8 + 8);
    let mut sevens = sevens(bytes);
    while let Some(seven) = sevens.next() {
        match REFUSED.iter().position(|&refused| refused == seven) {
            None => text.push(char::from(seven)),
            Some(place) => {
                let both = PAIRS + 128 * place as u32 + u32::from(sevens.next().unwrap_or(0));
                text.push(char::from_u32(both).expect("none of them is a surrogate"));
            }
        }
    }
    text
}

/// The bits of bytes, seven at a time.
fn sevens(bytes: &[u8]) -> impl Iterator<Item = u8> + '_ {
    let count = (8 * bytes.len()).div_ceil(7);
    (0..count).map(move |index| {
        let (byte, bit) = (7 * index / 8, 7 * index % 8);
        let next = bytes.get(byte + 1).copied().unwrap_or(0);
        (u16::from_be_bytes([bytes[byte], next]) >> (9 - bit)) as u8 & 0x7f
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The other way, by the description.
    fn decoded(text: &str) -> Vec<u8> {
        let both = |c: char| match u32::from(c) {
            code if code < PAIRS => vec![code as u8],
            code => vec![REFUSED[((code - PAIRS) / 128) as usize], ((code - PAIRS) % 128) as u8],
        };
        let bits: Vec<u8> =
            text.chars().flat_map(both).flat_map(|seven| (0..7).rev().map(move |k| seven >> k & 1)).collect();
        bits.chunks_exact(8).map(|byte| byte.iter().fold(0, |all, bit| all << 1 | bit)).collect()
    }

    #[test]
    fn bytes_come_back_whatever_they_are() {
        let mut state = 1u32;
        let mut noise = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        };
        for length in (0..40).chain([997]) {
            let drawn: Vec<u8> = (0..length).map(|_| noise()).collect();
            for bytes in [drawn, vec![0; length], vec![255; length], b"\r<\0".repeat(length)] {
                let text = encoded(&bytes);
                assert!(!text.contains(['\0', '\r', '<']), "{text:?}");
                assert!(text.len() <= 8 * bytes.len() / 7 + 2, "{} for {}", text.len(), bytes.len());
                // What a character holds beyond the bytes is less than another byte, or a whole seven after a refused one.
                assert_eq!(decoded(&text)[..bytes.len()], bytes);
                assert!(decoded(&text).len() <= bytes.len() + 1);
            }
        }
    }
}
