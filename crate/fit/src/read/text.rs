//! Bytes as text.

use std::borrow::Cow;

/// Reads bytes as UTF-8, or UTF-16 where a mark says so. What is wrongly written becomes a replacement character.
pub fn decode(bytes: &[u8]) -> Cow<'_, str> {
    if let Some(rest) = bytes.strip_prefix(b"\xff\xfe") {
        return Cow::Owned(wide(rest, u16::from_le_bytes));
    }
    if let Some(rest) = bytes.strip_prefix(b"\xfe\xff") {
        return Cow::Owned(wide(rest, u16::from_be_bytes));
    }
    let rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if let Ok(text) = str::from_utf8(rest) {
        return Cow::Borrowed(text);
    }
    // The room is measured first: a text that grows as it is written takes up to three times as much.
    let mark = |bad: bool| if bad { char::REPLACEMENT_CHARACTER.len_utf8() } else { 0 };
    let chunks = || rest.utf8_chunks().map(|chunk| (chunk.valid(), !chunk.invalid().is_empty()));
    let mut text = String::with_capacity(chunks().map(|(valid, bad)| valid.len() + mark(bad)).sum());
    for (valid, bad) in chunks() {
        text.push_str(valid);
        if bad {
            text.push(char::REPLACEMENT_CHARACTER);
        }
    }
    Cow::Owned(text)
}

fn wide(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let letters = || {
        let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
        char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER))
    };
    let mut text = String::with_capacity(letters().map(char::len_utf8).sum());
    text.extend(letters());
    text
}

/// At most so many letters, for messages.
pub fn short(text: &str, most: usize) -> String {
    let mut letters = text.trim().chars().map(|letter| if letter.is_control() { ' ' } else { letter });
    let mut kept: String = letters.by_ref().take(most).collect();
    if letters.next().is_some() {
        kept.pop();
        kept.push('…');
    }
    kept
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
