//! How a text is written down.

use bolero::TypeGenerator;

/// One of the ways in which programs write a text.
#[derive(Clone, Copy, Debug, TypeGenerator)]
pub enum Form {
    /// As it is: three in four, so that the ways of reading what is within are tried most.
    Plain([bool; 2]),
    /// With a mark that says how it is written.
    Marked,
    /// In units of 16 bits, the low byte first or last, marked or not, with half a pair in it or not.
    Wide { low_first: bool, marked: bool, half: bool },
    /// Lines end as those of Windows or of old Macs do.
    Lines { old: bool },
    /// A comma in each number.
    Commas,
    /// A zero behind each number of so many letters, or all of it.
    Ended,
}

impl Form {
    /// The text, written so.
    pub fn write(self, text: Vec<u8>) -> Vec<u8> {
        match self {
            Self::Plain(_) => text,
            Self::Marked => [b"\xef\xbb\xbf", &text[..]].concat(),
            Self::Wide { low_first, marked, half } => wide(&text, low_first, marked, half),
            Self::Lines { old } => {
                let end: &[u8] = if old { b"\r" } else { b"\r\n" };
                text.split(|byte| *byte == b'\n').collect::<Vec<_>>().join(end)
            }
            Self::Commas => commas(text),
            Self::Ended => [&text[..], b"\0\x1a"].concat(),
        }
    }
}

fn wide(text: &[u8], low_first: bool, marked: bool, half: bool) -> Vec<u8> {
    let mut units: Vec<u16> = Vec::new();
    units.extend(marked.then_some(0xfeff));
    units.extend(String::from_utf8_lossy(text).encode_utf16());
    if half {
        units.insert(units.len() / 2, 0xd83d);
    }
    units
        .into_iter()
        .flat_map(|unit| if low_first { unit.to_le_bytes() } else { unit.to_be_bytes() })
        .collect()
}

/// Decimal points between digits become commas.
fn commas(mut text: Vec<u8>) -> Vec<u8> {
    for at in 1..text.len().saturating_sub(1) {
        if text[at] == b'.' && text[at - 1].is_ascii_digit() && text[at + 1].is_ascii_digit() {
            text[at] = b',';
        }
    }
    text
}
