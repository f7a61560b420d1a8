//! Text in files of any age: UTF-8 or UTF-16 with or without a mark, or Latin-1.

/// Decodes text up to its first NUL and drops a byte-order mark.
pub(super) fn decode(bytes: &[u8]) -> String {
    match *bytes {
        [0xEF, 0xBB, 0xBF, ref rest @ ..] => eight_bit(rest),
        [0xFF, 0xFE, ref rest @ ..] => sixteen_bit(rest, u16::from_le_bytes),
        [0xFE, 0xFF, ref rest @ ..] => sixteen_bit(rest, u16::from_be_bytes),
        // Unmarked UTF-16 of Latin letters: every other byte is 0.
        [a, 0, b, 0, c, 0, d, 0, ..] if ![a, b, c, d].contains(&0) => sixteen_bit(bytes, u16::from_le_bytes),
        [0, a, 0, b, 0, c, 0, d, ..] if ![a, b, c, d].contains(&0) => sixteen_bit(bytes, u16::from_be_bytes),
        _ => eight_bit(bytes),
    }
}

fn eight_bit(bytes: &[u8]) -> String {
    let bytes = bytes.split(|&byte| byte == 0).next().unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    }
}

fn sixteen_bit(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).take_while(|&unit| unit != 0);
    char::decode_utf16(units).map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_encoding_of_one_text() {
        let text = "ImageJ=1.53\nunit=\u{b5}m";
        let utf8 = text.as_bytes().to_vec();
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        let latin: Vec<u8> = text.chars().map(|character| character as u8).collect();
        for (mark, bytes) in [
            (&b""[..], &utf8),
            (b"\xEF\xBB\xBF", &utf8),
            (b"", &latin),
            (b"\xFF\xFE", &little),
            (b"", &little),
            (b"\xFE\xFF", &big),
            (b"", &big),
        ] {
            let whole = [mark, bytes, &[0, 0], b"rest"].concat();
            assert_eq!(decode(&whole), text, "{mark:?}");
        }
        assert_eq!(decode(b""), "");
        assert_eq!(decode(b"\xFF\xFE"), "");
        assert_eq!(decode(b"a\0b\0"), "a");
    }
}
