//! What a file is, by what is in it and not by its name.

use super::text::{head, past_remarks};

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
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

/// In what stands before the root of XML this much is looked through where it is not written byte by byte.
const WIDE_BYTES: usize = 1 << 20;
/// A drawing within another document is looked for in as many bytes.
const WITHIN_BYTES: usize = 4096;
/// In an archive the names of what is in it are looked for in as many bytes.
const ARCHIVE_BYTES: usize = 64 << 10;

/// What files begin with, and where.
const MAGIC: [(usize, &[u8], FileKind); 26] = [
    (0, b"\x89PNG\r\n\x1a\n", FileKind::Picture("PNG")),
    (0, b"\xff\xd8\xff", FileKind::Picture("JPEG")),
    (0, b"GIF8", FileKind::Picture("GIF")),
    (0, b"II*\0", FileKind::Other(Some("TIFF picture"))),
    (0, b"MM\0*", FileKind::Other(Some("TIFF picture"))),
    (0, b"II+\0", FileKind::Other(Some("TIFF picture"))),
    (0, b"MM\0+", FileKind::Other(Some("TIFF picture"))),
    (0, b"\xff\x0a", FileKind::Other(Some("JPEG XL picture"))),
    (4, b"JXL \r\n", FileKind::Other(Some("JPEG XL picture"))),
    (4, b"jP  \r\n", FileKind::Other(Some("JPEG 2000 picture"))),
    (0, b"8BPS", FileKind::Other(Some("Photoshop picture"))),
    (0, b"%PDF", FileKind::Other(Some("PDF"))),
    (0, b"%!PS", FileKind::Other(Some("PostScript file"))),
    (0, b"\xc5\xd0\xd3\xc6", FileKind::Other(Some("PostScript file"))),
    (0, b"\xd0\xcf\x11\xe0", FileKind::Other(Some("spreadsheet or document of an old kind"))),
    (0, b"{\\rtf", FileKind::Other(Some("text with formatting (RTF)"))),
    (0, b"\x1f\x8b", FileKind::Other(Some("packed file (gzip)"))),
    (0, b"7z\xbc\xaf", FileKind::Other(Some("packed file (7z)"))),
    (0, b"Rar!", FileKind::Other(Some("packed file (RAR)"))),
    (0, b"\0\0\x27\x0a", FileKind::Other(Some("shapefile"))),
    (0, b"SQLite format 3", FileKind::Other(Some("database"))),
    (4, b"ftyp", FileKind::Other(Some("film"))),
    (0, b"\x1aE\xdf\xa3", FileKind::Other(Some("film"))),
    (0, b"\x00asm", FileKind::Other(Some("program"))),
    (0, b"\x7fELF", FileKind::Other(Some("program"))),
    (0, b"MZ\x90", FileKind::Other(Some("program"))),
];

/// Says what a file is by what it begins with; blanks, remarks and declarations before that are passed over.
///
/// ```
/// use frond_fit::{FileKind, sniff};
///
/// assert_eq!(sniff(b"\x89PNG\r\n\x1a\n.."), FileKind::Picture("PNG"));
/// assert_eq!(sniff(b"x,y\n1,2\n"), FileKind::Text);
/// ```
#[must_use]
pub fn sniff(bytes: &[u8]) -> FileKind {
    if bytes.is_empty() {
        return FileKind::Empty;
    }
    if let Some(kind) = by_magic(bytes) {
        return kind;
    }
    let head = head(bytes);
    if head.trim_matches(['\u{1a}', '\0']).is_empty() {
        return if bytes.contains(&0) { FileKind::Other(None) } else { FileKind::Empty };
    }
    // Text has no letters that steer machines of old, but for tabs and ends of lines, pages and files.
    if head.contains(|c: char| c < ' ' && !matches!(c, '\t' | '\n' | '\r' | '\u{c}' | '\u{1a}')) {
        return FileKind::Other(None);
    }
    if head.starts_with('<') {
        return of_xml(bytes);
    }
    let is_json = |text: &str| text.starts_with(['{', '[']);
    if is_json(past_remarks(&head)) {
        return FileKind::Json;
    }
    // A long remark may hide what follows.
    let remarks = head.starts_with('#') || head.starts_with("//") || head.starts_with("/*");
    if remarks && str::from_utf8(bytes).is_ok_and(|text| is_json(past_remarks(text))) {
        return FileKind::Json;
    }
    FileKind::Text
}

fn by_magic(bytes: &[u8]) -> Option<FileKind> {
    let at = |from: usize, magic: &[u8]| bytes.get(from..from + magic.len()) == Some(magic);
    if at(0, b"RIFF") && at(8, b"WEBP") {
        return Some(FileKind::Picture("WebP"));
    }
    if at(0, b"BM") && at(6, &[0; 4]) {
        return Some(FileKind::Picture("BMP"));
    }
    if at(4, b"ftyp") {
        // The brands of a container: its own, a version, and those that it can be read as.
        let brands = || bytes[8..bytes.len().min(64)].chunks_exact(4);
        let any = |names: &[&[u8]]| brands().any(|brand| names.contains(&brand));
        if any(&[b"avif", b"avis"]) {
            return Some(FileKind::Picture("AVIF"));
        }
        if any(&[b"heic", b"heix", b"heim", b"heis", b"mif1", b"msf1", b"hevc", b"hevx"]) {
            return Some(FileKind::Other(Some("HEIC picture")));
        }
    }
    if at(0, b"PK\x03\x04") {
        let head = &bytes[..bytes.len().min(ARCHIVE_BYTES)];
        let has = |name: &[u8]| head.windows(name.len()).any(|part| part == name);
        let what = [
            (&b"xl/"[..], "spreadsheet (xlsx)"),
            (b"word/", "document (docx)"),
            (b"ppt/", "presentation (pptx)"),
            (b"opendocument.spreadsheet", "spreadsheet (ods)"),
            (b"opendocument.text", "document (odt)"),
            (b"doc.kml", "map (KMZ)"),
        ];
        let what = what.iter().find(|(name, _)| has(name)).map_or("ZIP archive", |(_, what)| what);
        return Some(FileKind::Other(Some(what)));
    }
    MAGIC.iter().find(|(from, magic, _)| at(*from, magic)).map(|(.., kind)| *kind)
}

/// Whether the root of XML is a drawing.
fn of_xml(bytes: &[u8]) -> FileKind {
    let wide;
    let mut rest = bytes;
    // Names of XML are bytes of ASCII, but in UTF-16.
    if bytes[..bytes.len().min(4)].contains(&0) || bytes.starts_with(b"\xff\xfe") {
        wide = super::text::decode(&bytes[..bytes.len().min(WIDE_BYTES)]).into_owned();
        rest = wide.as_bytes();
    }
    rest = past_prolog(rest.strip_prefix(b"\xef\xbb\xbf").unwrap_or(rest));
    let head = &rest[..rest.len().min(WITHIN_BYTES)];
    let has = |name: &[u8]| head.windows(name.len()).any(|part| part == name);
    if has(b"<svg") || has(b":svg") { FileKind::Svg } else { FileKind::Text }
}

/// What follows the declarations, remarks and document type before the root of XML.
fn past_prolog(bytes: &[u8]) -> &[u8] {
    let mut rest = bytes.trim_ascii_start();
    let after = |rest: &[u8], sign: &[u8]| {
        rest.windows(sign.len()).position(|part| part == sign).map(|at| at + sign.len())
    };
    loop {
        let end = if rest.starts_with(b"<!--") {
            after(&rest[4..], b"-->").map(|end| 4 + end)
        } else if rest.starts_with(b"<?") {
            after(rest, b"?>")
        } else if rest.starts_with(b"<!") {
            document_type_end(rest)
        } else {
            return rest;
        };
        let Some(end) = end else { return &[] };
        rest = rest[end..].trim_ascii_start();
    }
}

/// Where a document type ends: it may have declarations in brackets, with remarks and quoted texts.
fn document_type_end(bytes: &[u8]) -> Option<usize> {
    let (mut k, mut inside) = (2, false);
    while let Some(&byte) = bytes.get(k) {
        match byte {
            b'"' | b'\'' => k += 1 + bytes[k + 1..].iter().position(|&other| other == byte)?,
            b'<' if bytes[k..].starts_with(b"<!--") => {
                k += 5 + bytes[k + 4..].windows(3).position(|part| part == b"-->")?;
            }
            b'[' => inside = true,
            b']' => inside = false,
            b'>' if !inside => return Some(k + 1),
            _ => {}
        }
        k += 1;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_known_by_what_is_in_them() {
        for (bytes, kind) in [
            (&b""[..], FileKind::Empty),
            (b" \r\n\t ", FileKind::Empty),
            (b"\x1a", FileKind::Empty),
            (b"\xff\xd8\xff\xe0", FileKind::Picture("JPEG")),
            (b"RIFF....WEBPVP8 ", FileKind::Picture("WebP")),
            (b"....ftypavif", FileKind::Picture("AVIF")),
            (b"....ftypheic", FileKind::Other(Some("HEIC picture"))),
            (b"\0\0\0\x20ftypmif1\0\0\0\0mif1avif", FileKind::Picture("AVIF")),
            (b"\0\0\0\x20ftypmif1\0\0\0\0mif1heic", FileKind::Other(Some("HEIC picture"))),
            (b"....ftypisom", FileKind::Other(Some("film"))),
            (
                b"PK\x03\x04....[Content_Types].xml..xl/workbook.xml",
                FileKind::Other(Some("spreadsheet (xlsx)")),
            ),
            (b"PK\x03\x04....[Content_Types].xml..word/a.xml", FileKind::Other(Some("document (docx)"))),
            (b"PK\x03\x04....a.txt", FileKind::Other(Some("ZIP archive"))),
            (b"{\\rtf1 ", FileKind::Other(Some("text with formatting (RTF)"))),
            (b"\xef\xbb\xbf<?xml version='1.0'?><svg/>", FileKind::Svg),
            (b"<x:svg xmlns:x='http://www.w3.org/2000/svg'/>", FileKind::Svg),
            (b"<html><body>", FileKind::Text),
            (b"  {\"type\": 1}", FileKind::Json),
            (b"BMW,1\n2,3\n4,5", FileKind::Text),
            (b"1;2\n3;4", FileKind::Text),
            (b"1;2\r\n3;4\r\n\x1a", FileKind::Text),
            (b"\xff\xfe1\0,\x002\0", FileKind::Text),
            (b"1\0,\x002\0\n\0", FileKind::Text),
            (b"<\0s\0v\0g\0/\0>\0", FileKind::Svg),
            (b"\0\0\0\0", FileKind::Other(None)),
            (b"\x89PN", FileKind::Text),
        ] {
            assert_eq!(sniff(bytes), kind, "{:?}", String::from_utf8_lossy(bytes));
        }
    }

    #[test]
    fn what_stands_before_the_beginning_may_be_long() {
        let words = "the words of a licence <svg> are many, ] > and so on\n".repeat(5_000);
        for (text, kind) in [
            (format!("<?xml version='1.0'?><!-- {words} --><svg/>"), FileKind::Svg),
            (format!("<!DOCTYPE svg [ <!ENTITY a \"{words}\"> <!-- ' --> ]><svg/>"), FileKind::Svg),
            (format!("{}<svg/>", " \n".repeat(99_999)), FileKind::Svg),
            (format!("<!-- {words} --><html/>"), FileKind::Text),
            (format!("<!-- {words}"), FileKind::Text),
            (format!("{}[1]", " \n".repeat(99_999)), FileKind::Json),
            (format!("# {}\n[1]", words.replace('\n', "\n# ")), FileKind::Json),
            (format!("/* {words} */ {{}}"), FileKind::Json),
            (format!("# {}\n1,2", words.replace('\n', "\n# ")), FileKind::Text),
        ] {
            assert_eq!(sniff(text.as_bytes()), kind, "{}", &text[..40]);
            let wide: Vec<u8> = format!("\u{feff}{text}").encode_utf16().flat_map(u16::to_le_bytes).collect();
            if text.starts_with(['<', ' ']) {
                assert_eq!(sniff(&wide), kind, "{}", &text[..40]);
            }
        }
    }
}
