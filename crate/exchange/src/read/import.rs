//! A file of any kind: what it is, and the systems in it.

use super::flame::SIGNS;
use super::problem::{Gathered, ImportError};
use super::tex::is_tex;
use super::{flame, fractint, ifstile, json, table};
use crate::png::{is_png, link_in_png};
use crate::system::System;
use crate::text::decode;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileFormat {
    /// Fractint's, and of programs that write like it.
    Fractint,
    /// XML of flam3, Apophysis and others.
    Flame,
    /// IFStile's.
    IfsTile,
    /// Frond's own maps, or a document.
    Json,
    /// A map a line.
    Table,
    /// A picture with a link in it.
    Png,
}

impl FileFormat {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Fractint => "fractint",
            Self::Flame => "flame",
            Self::IfsTile => "ifstile",
            Self::Json => "json",
            Self::Table => "table",
            Self::Png => "png",
        }
    }

    /// The most MiB that are read of it.
    const fn most(self) -> usize {
        match self {
            Self::Fractint | Self::Table | Self::Json => 1,
            Self::IfsTile => 2,
            Self::Flame => 8,
            Self::Png => 256,
        }
    }

    const fn words(self) -> &'static str {
        match self {
            Self::Fractint => "an .ifs file",
            Self::Flame => "a .flame file",
            Self::IfsTile => "an .aifs file",
            Self::Json => "JSON",
            Self::Table => "a table",
            Self::Png => "a PNG",
        }
    }
}

/// What was in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// What it is.
    pub format: FileFormat,
    /// Its systems, in their order; none where it holds a document.
    pub systems: Vec<System>,
    /// What is to be said of the file as a whole, a sentence or two each.
    pub remarks: Vec<String>,
    /// The fragment of the link of a document.
    pub link: Option<String>,
}

/// As much of a text as says what it is.
const HEAD_BYTES: usize = 64 << 10;

/// Reads a file, whatever its name is.
///
/// # Errors
/// [`ImportError`], with the line where there are lines. Where several systems are in a file, one that is miswritten is
/// passed over and said.
pub fn import(bytes: &[u8]) -> Result<Imported, ImportError> {
    let mut format = format_of(bytes)?;
    let most = format.most();
    if bytes.len() > most << 20 {
        let megabytes = bytes.len().div_ceil(1 << 20);
        return Err(ImportError::TooLarge { format: format.words(), megabytes, most });
    }
    let document =
        |format, link| Imported { format, systems: Vec::new(), remarks: Vec::new(), link: Some(link) };
    if format == FileFormat::Png {
        return link_in_png(bytes).map(|link| document(format, link)).ok_or(ImportError::NoLink);
    }
    let text = decode(bytes);
    let read = match format {
        FileFormat::Fractint => fractint::read_fractint(&text),
        FileFormat::Flame => flame::read_flames(&text),
        FileFormat::IfsTile => ifstile::read_ifstile(&text),
        FileFormat::Table => table::read_table(&text),
        FileFormat::Json | FileFormat::Png => match json::read_json(&text) {
            Ok(json::Content::Link(link)) => return Ok(document(format, link)),
            Ok(json::Content::Systems(systems)) => Ok(systems),
            // Rows in brackets, as programs print them, are no JSON.
            Err(error) if error.code() == "json-broken" && text.trim_start().starts_with('[') => {
                format = FileFormat::Table;
                table::read_table(&text).map_err(|_| error)
            }
            Err(error) => Err(error),
        },
    };
    let Gathered { systems, remarks, .. } = read?;
    Ok(Imported { format, systems, remarks, link: None })
}

/// What follows the remarks that a file begins with: there may be more of them than is looked at.
fn past_remarks(bytes: &[u8]) -> &[u8] {
    // What marks how text is written stands before everything.
    let mut rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    while rest.first() == Some(&b';') {
        let line = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        rest = rest[line..].trim_ascii_start();
    }
    rest
}

fn format_of(bytes: &[u8]) -> Result<FileFormat, ImportError> {
    if is_png(bytes) {
        return Ok(FileFormat::Png);
    }
    let said = past_remarks(bytes);
    let bytes = if said.is_empty() { bytes } else { said };
    let head = decode(&bytes[..bytes.len().min(HEAD_BYTES)]);
    let text = head.trim_start();
    if text.is_empty() {
        return Err(if bytes.len() > HEAD_BYTES { ImportError::Unknown } else { ImportError::Empty });
    }
    // Text has no bytes that steer machines of old, but for tabs and ends of lines, pages and files.
    if text
        .chars()
        .any(|c| c.is_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{c}' | '\u{1a}' | '\u{80}'..))
    {
        return Err(ImportError::Unknown);
    }
    if text.starts_with('<') {
        // The name ends there: programs have tags like flame_transform.
        let ends = |at: usize| !text[at..].starts_with(|c: char| c.is_alphanumeric() || "_-.".contains(c));
        let begins = |at: usize, name: &str| {
            let end = at + 1 + name.len();
            text.get(at + 1..end).is_some_and(|tag| tag.eq_ignore_ascii_case(name)) && ends(end)
        };
        let known = text.match_indices('<').any(|(at, _)| SIGNS.iter().any(|name| begins(at, name)));
        return if known { Ok(FileFormat::Flame) } else { Err(ImportError::Unknown) };
    }
    // A system of Fractint without a name begins with a brace, too.
    let object = text.strip_prefix('{').is_some_and(|rest| rest.trim_start().starts_with(['"', '}']));
    if text.starts_with('[') || object {
        return Ok(FileFormat::Json);
    }
    // A script of IFStile ends with a line of its own.
    if text.lines().any(|line| line.trim() == "@@") {
        return Ok(FileFormat::IfsTile);
    }
    // Within braces there may be anything: a remark, or an address.
    let mut lines = text.lines().take_while(|line| !line.contains('{')).map(str::trim_start);
    if lines.any(|line| line.starts_with('@') || line.starts_with("$dim")) {
        return Ok(FileFormat::IfsTile);
    }
    // LaTeX and lists of Mathematica have braces, too.
    if is_tex(text) || text.starts_with("{{") {
        return Ok(FileFormat::Table);
    }
    let braces =
        text.lines().any(|line| line.split(';').next().is_some_and(|line| line.contains(['{', '}'])));
    Ok(if braces { FileFormat::Fractint } else { FileFormat::Table })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_remarks_hide_no_system() {
        let remarks = "; a line\r\n".repeat(90_000);
        for (entry, format) in
            [("a { .5 0 0 .5 0 0 1 }", FileFormat::Fractint), (".5 0 0 .5 0 0\n", FileFormat::Table)]
        {
            let found = import(format!("{remarks}{entry}").as_bytes()).unwrap();
            assert_eq!((found.format, found.systems.len()), (format, 1));
        }
        assert!(import(remarks.as_bytes()).is_err());
        let marked = format!("\u{feff}{remarks}a {{ .5 0 0 .5 0 0 1 }}");
        assert_eq!(import(marked.as_bytes()).unwrap().systems.len(), 1);
    }

    #[test]
    fn lines_may_end_with_a_carriage_return() {
        let text = "; a remark\ra { ; another\r.5 0 0 .5 0 0 1\r.5 0 0 .5 1 0 1\r}\r";
        let found = import(text.as_bytes()).unwrap();
        assert_eq!((found.format, found.systems[0].maps.len()), (FileFormat::Fractint, 2));
        let table = import(b".5 0 0 .5 0 0\r.5 0 0 .5 1 0\r").unwrap();
        assert_eq!((table.format, table.systems[0].maps.len()), (FileFormat::Table, 2));
        let wrong = import(b"a {\r.5 0 0 .5 0 0 1\r.5 0 x .5 1 0 1\r}").unwrap_err();
        assert!(wrong.to_string().starts_with("Line 3"), "{wrong}");
    }

    #[test]
    fn files_are_known_by_what_is_in_them() {
        for (text, wanted) in [
            (&b"; a remark\nfern { 1 2 3 4 5 6 }"[..], "fractint"),
            (b"{ .5 0 0 .5 0 0 }", "fractint"),
            (b"\xef\xbb\xbffern\r\n{\r\n}", "fractint"),
            (b"<?xml version='1.0'?>\n<flames><flame/></flames>", "flame"),
            (b"<?xml version='1.0'?>\n<FLAME/>", "flame"),
            (b"<jwf-flame name='a'/>", "flame"),
            (b"comment {\n@ 1993, by hand\n}\nfern { 1 2 3 4 5 6 }", "fractint"),
            (b"@home { 1 2 3 4 5 6 }", "fractint"),
            (b"<flames name='a'/>", "flame"),
            (b"<html><body>", "file-unknown"),
            (b"<IFS><flame_transform/></IFS>", "file-unknown"),
            (b"<svg xmlns='http://www.w3.org/2000/svg'/>", "file-unknown"),
            (b" {\"maps\": []}", "json"),
            (b"[[1,2,3,4,5,6]]", "json"),
            (b"# by hand\n@\n$dim=2\nA=A", "ifstile"),
            (b"export const f = (x) => { return x; };\n@@\n@\nA=A", "ifstile"),
            (b"a,b,c,d,e,f\n1,2,3,4,5,6\n", "table"),
            (b"{{1,2,3,4,5,6}}", "table"),
            (b"\\begin{tabular}{c}\n1&2\\\\", "table"),
            (b"\x89PNG\r\n\x1a\n", "png"),
            (b"", "file-empty"),
            (b" \r\n\t", "file-empty"),
            (b"\0\0\0\x18ftypmp42", "file-unknown"),
        ] {
            let known = format_of(text).map_or_else(|error| error.code(), FileFormat::id);
            assert_eq!(known, wanted, "{:?}", String::from_utf8_lossy(text));
        }
    }

    #[test]
    fn sizes_are_looked_at_first() {
        let mut large = b"fern { ".to_vec();
        large.resize(3 << 20, b' ');
        let told = import(&large).unwrap_err();
        assert_eq!(told.code(), "file-too-large");
        assert_eq!(
            told.to_string(),
            "The file has 3 MB, and of an .ifs file at most 1 MB are read. Cut it into several."
        );
    }
}
