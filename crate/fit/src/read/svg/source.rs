//! The text of a drawing as a tree of elements, and as a tree of what is shown.

use std::borrow::Cow;
use std::sync::Arc;

use roxmltree::{Document, Error, ParsingOptions};
use usvg::{ImageKind, Options, Tree};

use super::super::problem::{LeftOut, ReadError};
use super::super::text::{edited, short};
use super::limits;

/// Prefixes that are declared for a drawing which uses them undeclared, as parts cut out of a page do.
const MAX_DECLARED: usize = 16;

/// What markers, filters and strokes add is no outline, and can be made to grow without end.
const STYLE: &str = "*{marker-start:none!important;marker-mid:none!important;marker-end:none!important;\
    filter:none!important;stroke-linejoin:bevel!important;stroke-linecap:butt!important;\
    stroke-dasharray:none!important}";

/// Stands for a picture that is elsewhere: a GIF of one pixel, as far as its size is told.
pub const ELSEWHERE: &[u8] = b"GIF89a\x01\x00\x01\x00\x00\x00\x00;";

fn read(text: &str) -> Result<Document<'_>, Error> {
    Document::parse_with_options(text, ParsingOptions { allow_dtd: true, ..ParsingOptions::default() })
}

/// The text with what it lacks to be read: the drawing alone where it stands in a page, and prefixes that are not
/// declared.
pub fn prepared(text: &str) -> Result<Cow<'_, str>, ReadError> {
    limits::scan(text)?;
    match with_prefixes(Cow::Borrowed(text)) {
        outcome @ (Ok(_) | Err(ReadError::Entities)) => outcome,
        // What is wrong with the page is told, if the drawing in it is wrong, too.
        Err(error) => cut_out(text).and_then(|drawing| with_prefixes(Cow::Owned(drawing)).ok()).ok_or(error),
    }
}

/// The text of a drawing, with prefixes that are not declared and signs that are not escaped.
fn with_prefixes(mut text: Cow<'_, str>) -> Result<Cow<'_, str>, ReadError> {
    let mut escaped = false;
    for _ in 0..MAX_DECLARED {
        text = Cow::Owned(match read(&text) {
            Ok(document) if document.root_element().tag_name().name() == "svg" => return Ok(text),
            Ok(_) => break,
            Err(Error::UnknownNamespace(prefix, _)) => declared(&text, &prefix),
            Err(Error::UnknownEntityReference(..) | Error::MalformedEntityReference(_)) if !escaped => {
                escaped = true;
                with_signs(&text)
            }
            Err(error) => return Err(broken(&error)),
        });
    }
    Err(ReadError::Broken { format: "SVG", why: "its first element is no <svg>".into() })
}

/// The text with each & as a sign of its own that begins no name which XML or the drawing knows.
fn with_signs(text: &str) -> String {
    let own: Vec<&str> =
        text.split("<!ENTITY").skip(1).filter_map(|rest| rest.split_whitespace().next()).collect();
    let known = |rest: &str| {
        let name = rest.split_once(';').map_or("", |(name, _)| name);
        name.starts_with('#') || matches!(name, "lt" | "gt" | "amp" | "quot" | "apos") || own.contains(&name)
    };
    let mut parts = text.split('&');
    let mut written = parts.next().unwrap_or_default().to_owned();
    for rest in parts {
        written.push_str(if known(rest) { "&" } else { "&amp;" });
        written.push_str(rest);
    }
    written
}

/// Declares a prefix in the first tag.
fn declared(text: &str, prefix: &str) -> String {
    let space = match prefix {
        "xlink" => "http://www.w3.org/1999/xlink",
        "svg" => "http://www.w3.org/2000/svg",
        _ => "about:blank",
    };
    let name = text.find("<svg").or_else(|| text.find(":svg")).map_or(0, |at| at + 4);
    format!("{} xmlns:{prefix}=\"{space}\"{}", &text[..name], &text[name..])
}

/// The drawing in a page, or between other text.
fn cut_out(text: &str) -> Option<String> {
    let (start, end) = (text.find("<svg")?, text.rfind("</svg>")? + "</svg>".len());
    (start < end && end - start < text.trim().len()).then(|| text[start..end].to_owned())
}

/// The text without attributes that would make a drawing grow without end.
pub fn checked<'a>(text: Cow<'a, str>, left_out: &mut LeftOut) -> Result<Cow<'a, str>, ReadError> {
    let edits = limits::check(&parse(&text)?, left_out)?;
    Ok(if edits.is_empty() { text } else { Cow::Owned(edited(&text, edits)) })
}

/// Parses a text that is [`prepared`].
pub fn parse(text: &str) -> Result<Document<'_>, ReadError> {
    read(text).map_err(|error| broken(&error))
}

/// What is shown.
pub fn tree(document: &Document<'_>) -> Result<Tree, ReadError> {
    let mut options = Options { font_size: 16.0, style_sheet: Some(STYLE.into()), ..Options::default() };
    // Nothing is fetched, and pictures are not looked into: only how large they are counts.
    options.image_href_resolver.resolve_string =
        Box::new(|_, _| Some(ImageKind::GIF(Arc::new(ELSEWHERE.to_vec()))));
    options.image_href_resolver.resolve_data = Box::new(|mime, data, _| match mime {
        "image/jpeg" | "image/jpg" => Some(ImageKind::JPEG(data)),
        "image/webp" => Some(ImageKind::WEBP(data)),
        "image/gif" => Some(ImageKind::GIF(data)),
        "image/png" => Some(ImageKind::PNG(data)),
        _ => Some(ImageKind::GIF(Arc::new(ELSEWHERE.to_vec()))),
    });
    Tree::from_xmltree(document, &options).map_err(|error| match error {
        usvg::Error::ParsingFailed(error) => broken(&error),
        usvg::Error::InvalidSize => ReadError::Broken {
            format: "SVG",
            why: "its width, height or viewBox is 0 or less, so that nothing of it is shown".into(),
        },
        error => ReadError::Broken { format: "SVG", why: short(&error.to_string(), 120) },
    })
}

fn broken(error: &Error) -> ReadError {
    match error {
        Error::EntityReferenceLoop(_) => ReadError::Entities,
        Error::NodesLimitReached => ReadError::TooMany { what: "elements", most: limits::MAX_ELEMENTS },
        Error::AttributesLimitReached => {
            ReadError::TooMany { what: "attributes of one element", most: limits::MAX_ATTRIBUTES }
        }
        error => ReadError::Broken { format: "SVG", why: short(&error.to_string(), 120) },
    }
}
