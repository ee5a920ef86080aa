//! Bytes as text.

use std::borrow::Cow;

use crate::formula::is_minus;

/// As many bytes are looked at to find out whether a text without a mark is UTF-16.
const SAMPLED_BYTES: usize = 1024;

/// Reads bytes as UTF-8, as UTF-16 where a mark says so, or else as Latin-1: old files name their shapes in it. Every
/// line ends as Rust knows lines to, also where it ended with a carriage return alone.
pub fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let text = decode_lines(bytes);
    let ends_alone = |(at, _): (usize, &str)| text.as_bytes().get(at + 1) != Some(&b'\n');
    if text.match_indices('\r').any(ends_alone) {
        Cow::Owned(text.replace("\r\n", "\n").replace('\r', "\n"))
    } else {
        text
    }
}

fn decode_lines(bytes: &[u8]) -> Cow<'_, str> {
    let wide = |rest: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = rest.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
        char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
    };
    if let Some(rest) = bytes.strip_prefix(b"\xff\xfe") {
        return Cow::Owned(wide(rest, u16::from_le_bytes));
    }
    if let Some(rest) = bytes.strip_prefix(b"\xfe\xff") {
        return Cow::Owned(wide(rest, u16::from_be_bytes));
    }
    // UTF-16 without a mark is known by the zeros in it.
    let (mut pairs, mut first, mut second) = (0, 0, 0);
    for pair in bytes[..bytes.len().min(SAMPLED_BYTES)].chunks_exact(2) {
        pairs += 1;
        first += usize::from(pair[0] == 0);
        second += usize::from(pair[1] == 0);
    }
    let many = |zeros: usize| pairs > 1 && 4 * zeros >= 3 * pairs;
    if first == 0 && many(second) {
        return Cow::Owned(wide(bytes, u16::from_le_bytes));
    }
    if second == 0 && many(first) {
        return Cow::Owned(wide(bytes, u16::from_be_bytes));
    }
    let rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    str::from_utf8(rest)
        .map_or_else(|_| Cow::Owned(rest.iter().map(|&byte| char::from(byte)).collect()), Cow::Borrowed)
}

/// Which line a place of a text is in. Lines are counted once, where one place is asked for after another.
pub struct Lines<'a> {
    text: &'a [u8],
    at: usize,
    line: usize,
}

impl<'a> Lines<'a> {
    pub const fn of(text: &'a str) -> Self {
        Self { text: text.as_bytes(), at: 0, line: 1 }
    }

    /// The line of a byte, from 1.
    pub fn line(&mut self, at: u64) -> usize {
        let at = usize::try_from(at).map_or(self.text.len(), |at| at.min(self.text.len()));
        if at < self.at {
            (self.at, self.line) = (0, 1);
        }
        self.line += self.text[self.at..at].iter().filter(|&&byte| byte == b'\n').count();
        self.at = at;
        self.line
    }
}

/// The longest number that is typeset.
const LONGEST_TYPESET: usize = 100;
/// The most letters of a name.
pub const MAX_NAME: usize = 60;

/// At most so many letters in one line, for names and messages.
pub fn short(text: &str, most: usize) -> String {
    let mut kept = String::new();
    let mut count = 0;
    // What is longer is cut before it is looked at: a name may be a whole file.
    for word in text.split(|c: char| c.is_whitespace() || c.is_control()).filter(|word| !word.is_empty()) {
        let gap = usize::from(count > 0);
        for letter in (0..gap).map(|_| ' ').chain(word.chars()) {
            if count == most {
                kept.pop();
                kept.push('…');
                return kept;
            }
            kept.push(letter);
            count += 1;
        }
    }
    kept
}

/// A name, or what stands for one.
pub fn name_or(text: &str, otherwise: &str) -> String {
    let name = short(text, MAX_NAME);
    if name.is_empty() { otherwise.to_owned() } else { name }
}

/// A finite number, as most programs write it, or as it is typeset: with a minus that is no hyphen.
pub fn number(word: &str) -> Option<f64> {
    if !word.is_ascii() {
        // A number of the sizes that are written has far fewer letters.
        if word.len() > LONGEST_TYPESET || !word.contains(is_minus) {
            return None;
        }
        let plain = word.replace(is_minus, "-");
        return if plain.is_ascii() { number(&plain) } else { None };
    }
    // What Rust reads besides: "inf", "nan", "infinity".
    if word.bytes().any(|byte| byte.is_ascii_alphabetic() && !matches!(byte, b'e' | b'E')) {
        return None;
    }
    word.parse().ok().filter(|x: &f64| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_say_how_text_is_written() {
        assert_eq!(decode(b"\xef\xbb\xbfa { 1 }"), "a { 1 }");
        assert_eq!(decode(b"\xff\xfe1\0,\x002\0\n"), "1,2");
        assert_eq!(decode(b"\xfe\xff\x001\0,"), "1,");
        assert_eq!(decode(b"1\0,\x002\0"), "1,2");
        assert_eq!(decode(b"\x001\0,\x002"), "1,2");
        assert_eq!(decode(b"Foug\xe8re"), "Fougère");
        assert_eq!(decode("Fougère".as_bytes()), "Fougère");
    }

    #[test]
    fn lines_end_as_they_did_on_any_machine() {
        assert_eq!(decode(b"a\rb\r"), "a\nb\n");
        assert_eq!(decode(b"a\rb\r\nc\nd\r\re"), "a\nb\nc\nd\n\ne");
        assert_eq!(decode(b"\xff\xfea\0\r\0b\0"), "a\nb");
        assert_eq!(decode(b"a\r\nb"), "a\r\nb");
    }

    #[test]
    fn lines_are_counted_in_any_order() {
        let text = "\na\n\nbc\n";
        let mut lines = Lines::of(text);
        let wanted = [1, 2, 2, 3, 4, 4, 4, 5];
        for at in [0, 1, 1, 3, 7, 2, 0, 6, 4, 5] {
            assert_eq!(lines.line(at), wanted[at as usize], "{at}");
        }
        assert_eq!((lines.line(u64::MAX), lines.line(3)), (5, 3));
    }

    #[test]
    fn long_names_are_cut() {
        assert_eq!(short(" a  b\tc\u{7}d ", 9), "a b c d");
        assert_eq!(short("abcdef", 4), "abc…");
        assert_eq!(short("abcd", 4), "abcd");
        assert_eq!(name_or(" \n ", "unnamed"), "unnamed");
    }

    #[test]
    fn numbers_are_finite() {
        for (word, wanted) in [
            (".5", Some(0.5)),
            ("-1.", Some(-1.0)),
            ("+2e-3", Some(2e-3)),
            ("1E2", Some(100.0)),
            ("\u{2212}0.04", Some(-0.04)),
            ("–5e−3", Some(-5e-3)),
        ] {
            assert_eq!(number(word), wanted, "{word}");
        }
        for word in ["", ".", "nan", "inf", "-infinity", "1e999", "1d3", "0x1", "1,5", "e", "1e", "−", "ƒ1"]
        {
            assert_eq!(number(word), None, "{word}");
        }
    }
}
