//! What is refused before it is resolved: a small drawing can be made to grow without end.

use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;

use roxmltree::{Attribute, Document, Node, NodeId};
use svgtypes::{PathParser, PathSegment, PointsParser};

use super::super::problem::{LeftOut, ReadError};
use super::super::text::{Edit, edited};

/// Elements of a file.
pub const MAX_ELEMENTS: usize = 32_000;
/// Attributes of one element: that none comes twice takes the square of their number to find out.
pub const MAX_ATTRIBUTES: usize = 1000;
/// Declarations of prefixes, times the most of one element: each element may keep all that are above it.
const MAX_PREFIXES: usize = 200_000;
/// Elements that are drawn, with all that is used more than once.
const MAX_DRAWN: usize = 20_000;
/// Points of all paths that are drawn, control points among them.
const MAX_POINTS: usize = 1 << 21;
/// Elements within elements: each takes room on the stack.
const MAX_DEPTH: usize = 200;
/// Things used within things used.
const MAX_USES: usize = 16;
/// Rules of style sheets, times elements.
const MAX_MATCHES: usize = 50_000_000;

/// How often in a row a path is closed.
const MAX_CLOSED: usize = 100;
/// The largest number: around what is larger, curves are without number.
const MAX_NUMBER: f64 = 1e9;
/// The smallest number of path data beside 0.
const MIN_NUMBER: f64 = 1e-30;
/// Attributes that say how large a shape is, or what is around it.
const NUMBERS: [&str; 12] =
    ["x", "y", "cx", "cy", "r", "rx", "ry", "width", "height", "viewBox", "font-size", "stroke-width"];

/// Refuses a text of too many elements, attributes or prefixes, before a tree is made of it.
pub fn scan(text: &str) -> Result<(), ReadError> {
    let bytes = text.as_bytes();
    let (mut elements, mut depth, mut prefixes, mut most_prefixes) = (0, 0_usize, 0, 0);
    let mut at = 0;
    while let Some(found) = text[at..].find('<') {
        at += found + 1;
        let rest = &text[at..];
        let end = match bytes.get(at) {
            Some(b'!') if rest.starts_with("!--") => rest.find("-->"),
            Some(b'!') if rest.starts_with("![CDATA[") => rest.find("]]>"),
            Some(b'!' | b'?') | None => Some(0),
            Some(b'/') => {
                depth = depth.saturating_sub(1);
                Some(0)
            }
            Some(_) => {
                elements += 1;
                let (end, attributes) = tag(rest);
                if attributes > MAX_ATTRIBUTES {
                    let what = "attributes of one element";
                    return Err(ReadError::TooMany { what, most: MAX_ATTRIBUTES });
                }
                depth += usize::from(!rest[..end].ends_with('/'));
                if depth > MAX_DEPTH {
                    return Err(ReadError::TooMany { what: "elements within elements", most: MAX_DEPTH });
                }
                let own = rest[..end].matches("xmlns").count();
                prefixes += own;
                most_prefixes = own.max(most_prefixes);
                Some(end)
            }
        };
        at += end.unwrap_or(rest.len());
    }
    if elements > MAX_ELEMENTS {
        return Err(ReadError::TooMany { what: "elements", most: MAX_ELEMENTS });
    }
    if prefixes * most_prefixes > MAX_PREFIXES {
        let most = MAX_PREFIXES / most_prefixes;
        return Err(ReadError::TooMany { what: "prefixes that are declared (xmlns)", most });
    }
    Ok(())
}

/// Where a tag ends, and how many attributes it has.
fn tag(text: &str) -> (usize, usize) {
    let (mut quote, mut attributes) = (None, 0);
    for (at, byte) in text.bytes().enumerate() {
        match (quote, byte) {
            (Some(open), byte) if open == byte => quote = None,
            (Some(_), _) => {}
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'=') => attributes += 1,
            (None, b'>' | b'<') => return (at, attributes),
            (None, _) => {}
        }
    }
    (text.len(), attributes)
}

/// What is being used, and what it is used by.
struct Use<'a, 'input> {
    node: Node<'a, 'input>,
    by: Option<Rc<Self>>,
}

/// An element that is still to be drawn.
struct Todo<'a, 'input> {
    node: Node<'a, 'input>,
    depth: usize,
    uses: usize,
    used: Option<Rc<Use<'a, 'input>>>,
}

impl<'a, 'input> Todo<'a, 'input> {
    /// Whether it is drawn as a part of an element, there or where that is used.
    fn is_part_of(&self, whole: Node<'a, 'input>) -> bool {
        let mut used = self.used.as_ref();
        let mut chain = std::iter::from_fn(|| {
            let link = used?;
            used = link.by.as_ref();
            Some(link.node)
        });
        self.node.ancestors().any(|above| above == whole) || chain.any(|node| node == whole)
    }
}

/// Goes through all that would be drawn, and refuses what is too much of it. Returns what is to be changed in the text:
/// links of elements that use themselves and numbers beyond all bounds are taken out.
pub fn check(document: &Document<'_>, left_out: &mut LeftOut) -> Result<Vec<Edit>, ReadError> {
    let mut ids: HashMap<&str, Node<'_, '_>> = HashMap::new();
    let (mut rules, mut elements) = (0, 0);
    let mut edits = Vec::new();
    for node in document.descendants().filter(Node::is_element) {
        elements += 1;
        if let Some(id) = node.attribute("id") {
            ids.entry(id).or_insert(node);
        }
        for attribute in node.attributes() {
            let is_path = attribute.name() == "d";
            // A size below 0 says nothing: browsers go on as if it were not there.
            let is_below =
                matches!(attribute.name(), "width" | "height") && attribute.value().trim().starts_with('-');
            if is_below && node == document.root_element() {
                edits.push((attribute.range(), String::new()));
                continue;
            }
            if NUMBERS.contains(&attribute.name()) && is_beyond(attribute.value())
                || is_path && is_endless(attribute.value())
            {
                left_out.add("shapes that are empty, or beyond all bounds");
                edits.push((attribute.range(), String::new()));
            } else if let Some(path) = is_path.then(|| without_dust(attribute.value())).flatten() {
                edits.push((attribute.range(), format!("d='{}'", path.replace(['\'', '&', '<'], " "))));
            }
        }
        let sheet =
            (node.tag_name().name() == "style").then(|| node.descendants().filter_map(|node| node.text()));
        for css in sheet.into_iter().flatten().chain(node.attribute("style")) {
            rules += css.matches('{').count();
            if is_beyond(css) {
                let why = format!("a style has a number beyond {MAX_NUMBER:e}");
                return Err(ReadError::Broken { format: "SVG", why });
            }
        }
    }
    if rules * elements > MAX_MATCHES {
        return Err(ReadError::TooMany { what: "rules in style sheets", most: MAX_MATCHES / elements });
    }
    let (mut drawn, mut points) = (0, 0);
    let mut known: HashMap<NodeId, usize> = HashMap::new();
    let mut todo = vec![Todo { node: document.root_element(), depth: 0, uses: 0, used: None }];
    while let Some(here) = todo.pop() {
        let Todo { node, depth, uses, .. } = here;
        if depth > MAX_DEPTH {
            return Err(ReadError::TooMany { what: "elements within elements", most: MAX_DEPTH });
        }
        drawn += 1;
        if drawn > MAX_DRAWN {
            return Err(ReadError::TooMany { what: "elements", most: MAX_DRAWN });
        }
        points += *known.entry(node.id()).or_insert_with(|| count(node, left_out));
        if points > MAX_POINTS {
            return Err(ReadError::TooMany { what: "points", most: MAX_POINTS });
        }
        let name = node.tag_name().name();
        for attribute in node.attributes() {
            let is_use = name == "use" && attribute.name() == "href";
            for id in links(&attribute, is_use) {
                match ids.get(id) {
                    Some(&target) if here.is_part_of(target) => {
                        left_out.add("uses of what they are a part of");
                        edits.push((attribute.range(), String::new()));
                    }
                    Some(_) if uses == MAX_USES => {
                        return Err(ReadError::TooMany { what: "uses within uses", most: MAX_USES });
                    }
                    Some(&target) => {
                        let used = Some(Rc::new(Use { node: target, by: here.used.clone() }));
                        todo.push(Todo { node: target, depth: depth + 1, uses: uses + 1, used });
                    }
                    // What is painted or clipped with something that is missing is no matter here.
                    None if is_use => left_out.add("uses of what is elsewhere or missing"),
                    None => {}
                }
            }
        }
        // What is only defined is drawn where it is used.
        let defines = matches!(name, "defs" | "symbol" | "clipPath" | "mask" | "pattern" | "marker");
        if defines && here.used.as_ref().is_none_or(|used| used.node != node) {
            continue;
        }
        let inside = node.children().filter(Node::is_element);
        todo.extend(inside.map(|node| Todo { node, depth: depth + 1, uses, used: here.used.clone() }));
    }
    Ok(edits)
}

/// The ids of what an attribute links to, as far as that is drawn with its element.
fn links<'a>(attribute: &Attribute<'a, '_>, is_use: bool) -> Vec<&'a str> {
    let value = attribute.value();
    if is_use {
        return value.trim().strip_prefix('#').into_iter().collect();
    }
    if !matches!(attribute.name(), "clip-path" | "mask" | "style" | "fill" | "stroke") {
        return Vec::new();
    }
    let id = |link: &'a str| {
        let link = link.split(')').next().unwrap_or_default();
        link.trim_matches(|sign: char| sign.is_whitespace() || matches!(sign, '"' | '\'' | '#'))
    };
    value.split("url(").skip(1).map(id).collect()
}

/// The numbers in a text without their signs, and where they stand. Names and colours have none.
fn numbers(text: &str) -> impl Iterator<Item = (Range<usize>, f64)> {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut at = 0;
    std::iter::from_fn(move || {
        let start = at + bytes[at..].iter().position(u8::is_ascii_digit)?;
        at = start + digits(start);
        if bytes.get(at) == Some(&b'.') {
            at += 1 + digits(at + 1);
        }
        if matches!(bytes.get(at), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
            let count = bytes.get(at + 1 + sign..).map_or(0, |_| digits(at + 1 + sign));
            at += if count > 0 { 1 + sign + count } else { 0 };
        }
        let first = if start > 0 && bytes[start - 1] == b'.' { start - 1 } else { start };
        Some((first..at, text[first..at].parse().unwrap_or(0.0)))
    })
}

/// Whether a text has a number that is too large, but for names and colours, and path data in style sheets.
fn is_beyond(text: &str) -> bool {
    let part_of_name = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'#' | b'_');
    numbers(text).any(|(place, number)| {
        number > MAX_NUMBER
            && !place.start.checked_sub(1).is_some_and(|before| part_of_name(text.as_bytes()[before]))
    })
}

/// Path data without numbers that are too small to be told from 0 in single precision: their squares are 0, and what is
/// divided by them is nothing (kurbo's arcs).
fn without_dust(path: &str) -> Option<String> {
    let dust = |number: f64| number > 0.0 && number < MIN_NUMBER;
    if !path.contains("e-") && !path.contains("E-") || !numbers(path).any(|(_, number)| dust(number)) {
        return None;
    }
    let edits = numbers(path).filter(|&(_, number)| dust(number)).map(|(place, _)| (place, "0".to_owned()));
    Some(edited(path, edits.collect()))
}

/// Whether a path cannot be followed: its arcs are so large that curves along them are without number, or it is closed
/// again and again, each time a step deeper (svgtypes).
fn is_endless(path: &str) -> bool {
    let mut closed = 0;
    let endless = |segment: Result<PathSegment, _>| match segment {
        Ok(PathSegment::EllipticalArc { rx, ry, .. }) => rx.abs().max(ry.abs()) > MAX_NUMBER,
        Ok(PathSegment::ClosePath { .. }) => {
            closed += 1;
            closed > MAX_CLOSED
        }
        _ => {
            closed = 0;
            false
        }
    };
    PathParser::from(path).any(endless)
}

/// How many points an element has of its own; says what it is where it has no outline.
fn count(node: Node<'_, '_>, left_out: &mut LeftOut) -> usize {
    match node.tag_name().name() {
        "path" => {
            let (mut points, mut mistaken) = (0, false);
            for segment in PathParser::from(node.attribute("d").unwrap_or_default()) {
                points += match segment {
                    Ok(PathSegment::ClosePath { .. }) => 0,
                    Ok(PathSegment::EllipticalArc { rx, ry, .. }) => {
                        // Curves of three points: four for a whole turn, more where the radius is large (kurbo).
                        3 * (11.2 * rx.abs().max(ry.abs()).min(MAX_NUMBER)).powf(1.0 / 6.0).max(4.0) as usize
                    }
                    Ok(PathSegment::CurveTo { .. } | PathSegment::SmoothCurveTo { .. }) => 3,
                    Ok(PathSegment::Quadratic { .. } | PathSegment::SmoothQuadratic { .. }) => 2,
                    Ok(_) => 1,
                    Err(_) => {
                        mistaken = true;
                        0
                    }
                };
                if points > MAX_POINTS {
                    break;
                }
            }
            match (mistaken, points) {
                (false, _) => {}
                (true, 0) => left_out.add("paths that are miswritten"),
                (true, _) => left_out.add("what follows a mistake in a path"),
            }
            points
        }
        "polygon" | "polyline" => {
            PointsParser::from(node.attribute("points").unwrap_or_default()).take(MAX_POINTS + 1).count()
        }
        "rect" | "circle" | "ellipse" => 48,
        name => {
            match name {
                "script" => left_out.add("scripts"),
                "text" => left_out.add("texts"),
                "image" => left_out.add("pictures"),
                "foreignObject" => left_out.add("foreign objects"),
                "animate" | "animateTransform" | "animateMotion" => left_out.add("animations"),
                _ => {}
            }
            0
        }
    }
}
