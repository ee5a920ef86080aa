//! Changes of a document that leave most of it right.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use bolero::TypeGenerator;

use crate::number;

/// The most bytes that a document is made of.
pub const MOST_BYTES: usize = 1 << 20;

/// What opens and closes a group in some language.
const GROUPS: &[(&str, &str)] = &[
    ("(", ")"),
    ("[", "]"),
    ("{", "}"),
    ("<g>", "</g>"),
    ("<g transform='scale(0.5)'>", "</g>"),
    ("-", ""),
    ("{\"a\":", "}"),
    ("[[", "]]"),
    ("sin(", ")"),
    ("(1+", ")"),
    ("\"", "\""),
    ("'", "'"),
    ("<!--", "-->"),
    ("<![CDATA[", "]]>"),
    ("/*", "*/"),
    ("\\frac{1}{", "}"),
    ("2^", ""),
    ("<", ">"),
];

/// A stretch of a document: where it begins, as part of the whole, and how many bytes it has.
#[derive(Clone, Copy, Debug, TypeGenerator)]
pub struct Stretch {
    at: u16,
    length: u8,
}

/// One change.
#[derive(Clone, Debug, TypeGenerator)]
pub enum Change {
    /// A number becomes another one.
    Number { which: u16, kind: u8, bits: u64 },
    /// A word is put in, with a space around it or not.
    Word { at: u16, word: u16, apart: bool },
    /// A stretch gives way to a word.
    Instead { stretch: Stretch, word: u16 },
    /// A stretch is left out.
    Without { stretch: Stretch },
    /// A stretch is there once more, elsewhere.
    Again { stretch: Stretch, to: u16 },
    /// A stretch of another document is put in.
    Of { document: u16, stretch: Stretch, to: u16 },
    /// A line, or a stretch, is there many times: twice to the so-manieth.
    Many { stretch: Stretch, line: bool, doublings: u8 },
    /// A stretch is in groups: twice to the so-manieth of them, closed or not.
    Within { stretch: Stretch, group: u8, doublings: u8, closed: bool },
    /// Some bytes become others.
    Bytes { at: u16, bytes: [u8; 3] },
    /// One bit is another.
    Bit { at: u16, bit: u8 },
    /// The end is cut off.
    Cut { at: u16 },
    /// Within a packed word (base64 in the letters of addresses), bytes become others.
    Packed { which: u16, at: u16, bytes: [u8; 2], count: u8 },
    /// Within a packed word, eight bytes become a double.
    Double { which: u16, at: u16, bits: u64 },
    /// A packed word is longer or shorter.
    Longer { which: u16, by: i8 },
}

/// What changes may take words and stretches from.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    pub words: &'a [&'a str],
    pub documents: &'a [(String, Vec<u8>)],
}

impl Change {
    /// Changes the text, unless it would grow too large.
    pub fn apply(&self, text: &mut Vec<u8>, source: Source<'_>) {
        match *self {
            Self::Number { which, kind, bits } => {
                let places = number::places(text);
                if let Some(place) = pick(&places, which) {
                    text.splice(place.clone(), number::odd(kind, bits).into_bytes());
                }
            }
            Self::Word { at, word, apart } => {
                let word = word_of(word, source);
                let word = if apart { format!(" {word} ") } else { word.to_owned() };
                let at = place(text, at);
                text.splice(at..at, word.into_bytes());
            }
            Self::Instead { stretch, word } => {
                text.splice(stretch.range(text), word_of(word, source).bytes());
            }
            Self::Without { stretch } => drop(text.drain(stretch.range(text))),
            Self::Again { stretch, to } => {
                let copy = text[stretch.range(text)].to_vec();
                let to = place(text, to);
                text.splice(to..to, copy);
            }
            Self::Of { document, stretch, to } => {
                let Some((_, other)) = pick(source.documents, document) else { return };
                let to = place(text, to);
                text.splice(to..to, other[stretch.range(other)].iter().copied());
            }
            Self::Many { stretch, line, doublings } => many(text, stretch, line, doublings),
            Self::Within { stretch, group, doublings, closed } => {
                let range = stretch.range(text);
                let (open, close) = GROUPS[usize::from(group) % GROUPS.len()];
                let times = times(doublings).min(MOST_BYTES / 2 / (open.len() + close.len()));
                let close = if closed { close } else { "" };
                text.splice(range.end..range.end, close.repeat(times).into_bytes());
                text.splice(range.start..range.start, open.repeat(times).into_bytes());
            }
            Self::Bytes { at, bytes } => {
                let at = place(text, at);
                text.splice(at..(at + bytes.len()).min(text.len()), bytes);
            }
            Self::Bit { at, bit } => {
                let at = place(text, at);
                if let Some(byte) = text.get_mut(at) {
                    *byte ^= 1 << (bit % 8);
                }
            }
            Self::Cut { at } => text.truncate(place(text, at)),
            Self::Packed { which, at, bytes, count } => packed(text, which, |word| {
                let at = place(word, at);
                let end = (at + usize::from(count % 3)).min(word.len());
                word.splice(at..end, bytes[..usize::from(count / 3 % 3)].iter().copied());
            }),
            Self::Double { which, at, bits } => packed(text, which, |word| {
                let at = place(word, at);
                let end = (at + 8).min(word.len());
                word.splice(at..end, bits.to_be_bytes());
            }),
            Self::Longer { which, by } => packed(text, which, |word| {
                let length = word.len().saturating_add_signed(isize::from(by));
                word.resize(length, by as u8);
            }),
        }
        text.truncate(MOST_BYTES);
    }
}

impl Stretch {
    fn range(self, text: &[u8]) -> std::ops::Range<usize> {
        let start = place(text, self.at);
        start..(start + usize::from(self.length)).min(text.len())
    }
}

/// A place in a text, by its part of the whole.
fn place(text: &[u8], at: u16) -> usize {
    (usize::from(at) * (text.len() + 1)) >> 16
}

fn pick<T>(list: &[T], which: u16) -> Option<&T> {
    list.get(usize::from(which).checked_rem(list.len())?)
}

fn word_of<'a>(which: u16, source: Source<'a>) -> &'a str {
    pick(source.words, which).copied().unwrap_or_default()
}

/// How many times: seldom so many that little else is tried.
fn times(doublings: u8) -> usize {
    1 << if doublings < 240 { doublings % 8 } else { doublings % 18 }
}

fn many(text: &mut Vec<u8>, stretch: Stretch, line: bool, doublings: u8) {
    let mut range = stretch.range(text);
    if line {
        let end = |byte: &u8| *byte == b'\n';
        range.start = text[..range.start].iter().rposition(end).map_or(0, |at| at + 1);
        range.end = text[range.end..].iter().position(end).map_or(text.len(), |at| range.end + at + 1);
    }
    let copy = text[range.clone()].to_vec();
    let times = times(doublings).min(MOST_BYTES / copy.len().max(1));
    text.splice(range, copy.repeat(times));
}

/// Changes a packed word: eight letters or more that stand for bytes.
fn packed(text: &mut Vec<u8>, which: u16, change: impl FnOnce(&mut Vec<u8>)) {
    let letter = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_');
    let mut words = Vec::new();
    let mut start = 0;
    for at in 0..=text.len() {
        if text.get(at).copied().is_none_or(|byte| !letter(byte)) {
            if at >= start + 8 {
                words.push(start..at);
            }
            start = at + 1;
        }
    }
    let Some(range) = pick(&words, which).cloned() else { return };
    if let Ok(mut bytes) = URL_SAFE_NO_PAD.decode(&text[range.clone()]) {
        change(&mut bytes);
        text.splice(range, URL_SAFE_NO_PAD.encode(bytes).into_bytes());
    }
}
