//! What a file is, by what is in it and not by its name.

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A picture made of pixels that browsers decode.
    Picture(&'static str),
    /// A drawing.
    Svg,
    /// GeoJSON, or other JSON.
    Json,
    /// Lines of text: perhaps a table of numbers.
    Text,
    /// Nothing at all.
    Empty,
    /// Something else, whose name is known or not.
    Other(Option<&'static str>),
}

/// As much of a file as [`sniff`] looks at.
const HEAD_BYTES: usize = 4096;

/// Says what a file is by its first bytes.
///
/// ```
/// use frond_fit::{FileKind, sniff};
///
/// assert_eq!(sniff(b"\x89PNG\r\n\x1a\n.."), FileKind::Picture("PNG"));
/// assert_eq!(sniff(b"x,y\n1,2\n"), FileKind::Text);
/// ```
#[must_use]
pub fn sniff(bytes: &[u8]) -> FileKind {
    let at = |from: usize, magic: &[u8]| bytes.get(from..from + magic.len()) == Some(magic);
    let brand = |brands: &[&[u8]]| at(4, b"ftyp") && brands.iter().any(|brand| at(8, brand));
    if bytes.is_empty() {
        return FileKind::Empty;
    }
    let known: [(bool, FileKind); 17] = [
        (at(0, b"\x89PNG\r\n\x1a\n"), FileKind::Picture("PNG")),
        (at(0, b"\xff\xd8\xff"), FileKind::Picture("JPEG")),
        (at(0, b"RIFF") && at(8, b"WEBP"), FileKind::Picture("WebP")),
        (at(0, b"GIF8"), FileKind::Picture("GIF")),
        (brand(&[b"avif", b"avis"]), FileKind::Picture("AVIF")),
        (at(0, b"BM") && at(6, &[0; 4]), FileKind::Picture("BMP")),
        (brand(&[b"heic", b"heix", b"mif1", b"msf1", b"hevc"]), FileKind::Other(Some("HEIC picture"))),
        (at(0, b"II*\0") || at(0, b"MM\0*"), FileKind::Other(Some("TIFF picture"))),
        (at(0, b"8BPS"), FileKind::Other(Some("Photoshop picture"))),
        (at(0, b"%PDF"), FileKind::Other(Some("PDF"))),
        (at(0, b"%!PS"), FileKind::Other(Some("PostScript"))),
        (at(0, b"PK\x03\x04"), FileKind::Other(Some("ZIP archive or spreadsheet"))),
        (at(0, b"\xd0\xcf\x11\xe0"), FileKind::Other(Some("spreadsheet or document of an old kind"))),
        (at(0, b"\x1f\x8b"), FileKind::Other(Some("packed file (gzip)"))),
        (at(4, b"ftyp"), FileKind::Other(Some("film"))),
        (at(0, b"\x00asm"), FileKind::Other(Some("program"))),
        (at(0, b"\x7fELF") || at(0, b"MZ\x90"), FileKind::Other(Some("program"))),
    ];
    if let Some((_, kind)) = known.iter().find(|(is, _)| *is) {
        return *kind;
    }
    let head = &bytes[..bytes.len().min(HEAD_BYTES)];
    let wide = at(0, b"\xff\xfe") || at(0, b"\xfe\xff");
    // Text has no bytes that steer machines of old, but for tabs and ends of lines and pages.
    if !wide && head.iter().any(|&byte| byte < 32 && !matches!(byte, b'\t' | b'\n' | b'\r' | 12)) {
        return FileKind::Other(None);
    }
    let text = super::text::decode(head);
    let first = text.trim_start();
    if first.is_empty() {
        return FileKind::Empty;
    }
    if first.starts_with('<') {
        return if text.contains("<svg") || text.contains(":svg") { FileKind::Svg } else { FileKind::Text };
    }
    if first.starts_with('{') || first.starts_with('[') { FileKind::Json } else { FileKind::Text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_known_by_what_is_in_them() {
        for (bytes, kind) in [
            (&b""[..], FileKind::Empty),
            (b" \r\n\t ", FileKind::Empty),
            (b"\xff\xd8\xff\xe0", FileKind::Picture("JPEG")),
            (b"RIFF....WEBPVP8 ", FileKind::Picture("WebP")),
            (b"....ftypavif", FileKind::Picture("AVIF")),
            (b"....ftypheic", FileKind::Other(Some("HEIC picture"))),
            (b"\xef\xbb\xbf<?xml version='1.0'?><svg/>", FileKind::Svg),
            (b"<x:svg xmlns:x='http://www.w3.org/2000/svg'/>", FileKind::Svg),
            (b"<html><body>", FileKind::Text),
            (b"  {\"type\": 1}", FileKind::Json),
            (b"BMW,1\n2,3\n4,5", FileKind::Text),
            (b"1;2\n3;4", FileKind::Text),
            (b"\xff\xfe1\0,\x002\0", FileKind::Text),
            (b"\0\0\0\0", FileKind::Other(None)),
            (b"\x89PN", FileKind::Text),
        ] {
            assert_eq!(sniff(bytes), kind, "{:?}", String::from_utf8_lossy(bytes));
        }
    }
}
