//! Bytes as text.

/// Reads bytes as UTF-8, or UTF-16 where a mark says so. What is wrongly written becomes a replacement character.
pub fn decode(bytes: &[u8]) -> String {
    let wide = |rest: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = rest.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
        char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
    };
    if let Some(rest) = bytes.strip_prefix(b"\xff\xfe") {
        return wide(rest, u16::from_le_bytes);
    }
    if let Some(rest) = bytes.strip_prefix(b"\xfe\xff") {
        return wide(rest, u16::from_be_bytes);
    }
    String::from_utf8_lossy(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)).into_owned()
}

/// At most so many letters, for messages.
pub fn short(text: &str, most: usize) -> String {
    let clean: String =
        text.trim().chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect();
    if clean.chars().count() <= most {
        return clean;
    }
    clean.chars().take(most.saturating_sub(1)).chain(['…']).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_say_how_text_is_written() {
        assert_eq!(decode(b"\xef\xbb\xbf1,2"), "1,2");
        assert_eq!(decode(b"\xff\xfe1\0,\x002\0\n"), "1,2");
        assert_eq!(decode(b"\xfe\xff\x001\0,"), "1,");
        assert_eq!(decode(b"a\xffb"), "a\u{fffd}b");
        assert_eq!(short(" abcdef\n", 4), "abc…");
    }
}
