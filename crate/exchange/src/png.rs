//! The link in a picture: an `iTXt` chunk of a PNG (PNG specification, third edition, section 11.3.3.4).

/// What every PNG begins with.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
/// What the link stands under.
const KEYWORD: &[u8] = b"Frond link";
/// The longest link that is read or written.
const MAX_LINK: usize = 1 << 20;

pub fn is_png(bytes: &[u8]) -> bool {
    bytes.starts_with(SIGNATURE)
}

/// The chunks: the type and the data of each, and where it begins.
fn chunks(png: &[u8]) -> impl Iterator<Item = (&[u8], &[u8], usize)> {
    let mut at = SIGNATURE.len();
    std::iter::from_fn(move || {
        let head = png.get(at..at.checked_add(8)?)?;
        let length = u32::from_be_bytes(head[..4].try_into().ok()?) as usize;
        let data = png.get(at + 8..(at + 8).checked_add(length)?)?;
        let start = at;
        at += 12 + length;
        Some((&head[4..], data, start))
    })
}

/// The fragment of the link in a picture, if it has one.
#[must_use]
pub fn link_in_png(png: &[u8]) -> Option<String> {
    if !is_png(png) {
        return None;
    }
    chunks(png).find_map(|(kind, data, _)| if kind == b"iTXt" { link_in(data) } else { None })
}

fn link_in(data: &[u8]) -> Option<String> {
    let rest = data.strip_prefix(KEYWORD)?;
    // Not compressed, by no method, in no language, without a translated keyword.
    let text = str::from_utf8(rest.strip_prefix(b"\0\0\0\0\0")?).ok()?;
    let fragment = text.split_once('#').map_or(text, |(_, fragment)| fragment);
    (text.len() <= MAX_LINK && !fragment.is_empty()).then(|| fragment.to_owned())
}

/// The same picture with a link in it. `None` where it is no PNG, or the link is longer than a megabyte.
#[must_use]
pub fn png_with_link(png: &[u8], link: &str) -> Option<Vec<u8>> {
    if !is_png(png) || link.len() > MAX_LINK {
        return None;
    }
    // Behind the head of the picture, which must be first.
    let (kind, data, start) = chunks(png).next()?;
    let at = start + 12 + data.len();
    if kind != b"IHDR" || at > png.len() {
        return None;
    }
    let mut chunk = b"iTXt".to_vec();
    chunk.extend(KEYWORD);
    chunk.extend(b"\0\0\0\0\0");
    chunk.extend(link.as_bytes());
    let mut made = Vec::with_capacity(png.len() + chunk.len() + 8);
    made.extend(&png[..at]);
    made.extend((chunk.len() as u32 - 4).to_be_bytes());
    made.extend(&chunk);
    made.extend(checksum(&chunk).to_be_bytes());
    made.extend(&png[at..]);
    Some(made)
}

/// The CRC-32 of a chunk (ISO 3309).
fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture() -> Vec<u8> {
        let mut png = SIGNATURE.to_vec();
        for (kind, data) in [(b"IHDR", &[0_u8; 13][..]), (b"IDAT", b"xyz"), (b"IEND", b"")] {
            let chunk = [kind, data].concat();
            png.extend((data.len() as u32).to_be_bytes());
            png.extend(&chunk);
            png.extend(checksum(&chunk).to_be_bytes());
        }
        png
    }

    #[test]
    fn a_link_is_written_and_found_again() {
        // As in the specification: the checksum of the last chunk.
        assert_eq!(checksum(b"IEND"), 0xae42_6082);
        let made =
            png_with_link(&picture(), "https://example.org/frond/#v=1&a=fern&a-name=F%C3%BCr").unwrap();
        assert_eq!(link_in_png(&made).as_deref(), Some("v=1&a=fern&a-name=F%C3%BCr"));
        let kinds: Vec<&[u8]> = chunks(&made).map(|(kind, _, _)| kind).collect();
        assert_eq!(kinds, [b"IHDR", b"iTXt", b"IDAT", b"IEND"]);
        assert_eq!(link_in_png(&picture()), None);
    }

    #[test]
    fn what_is_no_picture_is_left_alone() {
        for bytes in [&b""[..], b"GIF8", SIGNATURE, &picture()[..20], &[SIGNATURE, &[0xff; 40]].concat()] {
            assert_eq!(png_with_link(bytes, "v=1"), None);
            assert_eq!(link_in_png(bytes), None);
        }
        assert_eq!(png_with_link(&picture(), &"x".repeat(2 << 20)), None);
    }
}
