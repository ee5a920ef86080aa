//! Bytes as text.

use std::borrow::Cow;

/// As much of a text is decoded to find out what it is.
const HEAD_BYTES: usize = 64 << 10;
/// As many bytes are looked at to find out whether a text without a mark is UTF-16.
const SAMPLED_BYTES: usize = 1024;
/// What old machines put at the end of a text.
const CTRL_Z: u8 = 0x1a;

/// What the bytes from 0x80 to 0x9f are on Windows.
const WINDOWS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// The bytes of a letter.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Unit {
    Byte,
    LittleEndian,
    BigEndian,
}

impl Unit {
    fn pair(self, pair: [u8; 2]) -> u16 {
        if self == Self::BigEndian { u16::from_be_bytes(pair) } else { u16::from_le_bytes(pair) }
    }
}

/// How a text is written, and what follows its mark. UTF-16 without a mark is known by the zeros in it.
fn body(bytes: &[u8]) -> (Unit, &[u8]) {
    for (mark, unit) in [
        (&b"\xff\xfe"[..], Unit::LittleEndian),
        (b"\xfe\xff", Unit::BigEndian),
        (b"\xef\xbb\xbf", Unit::Byte),
    ] {
        if let Some(rest) = bytes.strip_prefix(mark) {
            return (unit, rest);
        }
    }
    let (mut pairs, mut first, mut second) = (0, 0, 0);
    for pair in bytes[..bytes.len().min(SAMPLED_BYTES)].chunks_exact(2) {
        pairs += 1;
        first += usize::from(pair[0] == 0);
        second += usize::from(pair[1] == 0);
    }
    match (first, second) {
        (0, zeros) if pairs > 1 && 4 * zeros >= 3 * pairs => (Unit::LittleEndian, bytes),
        (zeros, 0) if pairs > 1 && 4 * zeros >= 3 * pairs => (Unit::BigEndian, bytes),
        _ => (Unit::Byte, bytes),
    }
}

/// Reads bytes as UTF-8, as UTF-16 where a mark or its zeros say so, or else as Windows writes western languages. What
/// ends a text on old machines is left out.
pub fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let (unit, rest) = body(bytes);
    decoded(unit, rest)
}

fn decoded(unit: Unit, rest: &[u8]) -> Cow<'_, str> {
    // The room is measured first: a text that grows as it is written takes up to three times as much.
    if unit != Unit::Byte {
        let letters = || {
            let units = rest.chunks_exact(2).map(|pair| unit.pair([pair[0], pair[1]]));
            char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER))
        };
        let mut text = String::with_capacity(letters().map(char::len_utf8).sum());
        text.extend(letters());
        return Cow::Owned(text);
    }
    let end = rest.iter().rposition(|&byte| byte != CTRL_Z && byte != 0).map_or(0, |at| at + 1);
    let rest = &rest[..end];
    if let Ok(text) = str::from_utf8(rest) {
        return Cow::Borrowed(text);
    }
    let letters = || {
        rest.iter().map(|&byte| match byte {
            0x80..0xa0 => WINDOWS[usize::from(byte - 0x80)],
            _ => char::from(byte),
        })
    };
    let mut text = String::with_capacity(letters().map(char::len_utf8).sum());
    text.extend(letters());
    Cow::Owned(text)
}

/// The beginning of a text without the blanks before it, however many there are, cut where a letter may be cut.
pub fn head(bytes: &[u8]) -> Cow<'_, str> {
    let (unit, rest) = body(bytes);
    if unit != Unit::Byte {
        let blank = |pair: &[u8]| {
            char::from_u32(u32::from(unit.pair([pair[0], pair[1]]))).is_some_and(char::is_whitespace)
        };
        let from = 2 * rest.chunks_exact(2).take_while(|pair| blank(pair)).count();
        return decoded(unit, &rest[from..rest.len().min(from + HEAD_BYTES)]);
    }
    let rest = rest.trim_ascii_start();
    if rest.len() <= HEAD_BYTES {
        return decoded(unit, rest);
    }
    let cut = &rest[..HEAD_BYTES];
    let cut = cut
        .utf8_chunks()
        .next()
        .filter(|chunk| chunk.valid().len() + 4 > cut.len())
        .map_or(cut, |chunk| &cut[..chunk.valid().len()]);
    decoded(unit, cut)
}

/// What follows blanks and remarks (`# ..`, `// ..`, `/* .. */`).
pub fn past_remarks(text: &str) -> &str {
    let mut rest = text.trim_start();
    loop {
        let end = if rest.starts_with('#') || rest.starts_with("//") {
            rest.find(['\n', '\r'])
        } else if rest.starts_with("/*") {
            rest.find("*/").map(|at| at + 2)
        } else {
            return rest;
        };
        rest = end.map_or("", |end| rest[end..].trim_start());
    }
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

/// A place in a text, in bytes, and what is to stand there.
#[cfg(feature = "svg")]
pub type Edit = (std::ops::Range<usize>, String);

/// The text with all changes; of two that overlap the later one is passed over.
#[cfg(feature = "svg")]
pub fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|(range, _)| (range.start, range.end));
    let mut written = String::with_capacity(text.len() + 64 * edits.len());
    let mut at = 0;
    for (range, new) in edits {
        if range.start >= at && range.end <= text.len() {
            written.push_str(&text[at..range.start]);
            written.push_str(&new);
            at = range.end;
        }
    }
    written.push_str(&text[at..]);
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_say_how_text_is_written() {
        assert_eq!(decode(b"\xef\xbb\xbf1,2"), "1,2");
        assert_eq!(decode(b"\xff\xfe1\0,\x002\0\n"), "1,2");
        assert_eq!(decode(b"\xfe\xff\x001\0,"), "1,");
        assert_eq!(short(" abcdef\n", 4), "abc…");
    }

    #[test]
    fn text_without_a_mark_is_known_by_its_bytes() {
        assert_eq!(decode(b"1\0,\x002\0\n\0"), "1,2\n");
        assert_eq!(decode(b"\x001\0,\x002\0\n"), "1,2\n");
        assert_eq!(decode(b"a\xffb"), "aÿb");
        assert_eq!(decode(b"\x965"), "–5");
        assert_eq!(decode(b"1,2\r\n\x1a\x1a\0"), "1,2\r\n");
        assert_eq!(decode("Blatt – ä".as_bytes()), "Blatt – ä");
    }

    #[test]
    fn a_head_begins_where_the_text_does() {
        assert_eq!(head(format!("{}x", " \r\n".repeat(99_999)).as_bytes()), "x");
        let wide: Vec<u8> = "\u{feff}\n  äx".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(head(&wide), "äx");
        // It is cut before a letter of several bytes, and not within it.
        let long = format!("a{}", "字".repeat(HEAD_BYTES));
        assert!(long.starts_with(&*head(long.as_bytes())));
    }

    #[test]
    fn remarks_are_passed_over() {
        assert_eq!(past_remarks("# a\n // b\r\n/* c\n d */ [1]"), "[1]");
        assert_eq!(past_remarks("/* c"), "");
        assert_eq!(past_remarks("# c"), "");
    }
}
