//! Properties of style sheets that bear on where shapes lie and that usvg looks for in attributes alone: transforms as
//! CSS writes them, and the geometry of shapes (SVG 2, Geometry Properties). They are written out as attributes.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::fmt::Write;

use kurbo::{Affine, Rect};
use roxmltree::{Attribute, Document, Node, NodeId};
use simplecss::{AttributeOperator, Declaration, DeclarationTokenizer, PseudoClass, Rule, StyleSheet};

use super::super::problem::{LeftOut, ReadError};
use super::super::text::{Edit, edited};
use super::source;
use super::transforms::{length, origin, property, transform};

const GEOMETRY: [&str; 10] = ["x", "y", "width", "height", "rx", "ry", "cx", "cy", "r", "d"];
const TRANSFORMS: [&str; 6] =
    ["transform", "transform-origin", "transform-box", "translate", "rotate", "scale"];
/// What usvg finds itself, but only attributes are [counted](super::limits).
const LINKS: [&str; 4] = ["clip-path", "mask", "fill", "stroke"];
/// Boxes of boxes: those of the inner ones are found first.
const MAX_PASSES: usize = 4;
/// Letters of elements whose boxes are looked for.
const MAX_COPIED: usize = 4 << 20;
/// Sides of shapes that may be told in parts (%) of what is around them.
const SIDES: [&str; 9] = ["x", "y", "width", "height", "rx", "ry", "cx", "cy", "r"];

fn counts(declaration: &Declaration<'_>) -> bool {
    let Declaration { name, value, .. } = declaration;
    GEOMETRY.contains(name) || TRANSFORMS.contains(name) || LINKS.contains(name) && value.contains("url(")
}

/// An element as style sheets ask for it.
struct Element<'a, 'input>(Node<'a, 'input>);

impl simplecss::Element for Element<'_, '_> {
    fn parent_element(&self) -> Option<Self> {
        self.0.parent_element().map(Self)
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.0.prev_sibling_element().map(Self)
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.0.tag_name().name() == name
    }

    fn attribute_matches(&self, name: &str, operator: AttributeOperator<'_>) -> bool {
        self.0.attribute(name).is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass<'_>) -> bool {
        matches!(class, PseudoClass::FirstChild) && self.prev_sibling_element().is_none()
    }
}

/// What style sheets and the attribute `style` say of an element, where it counts here.
type Properties<'a> = BTreeMap<&'a str, &'a str>;

fn properties<'a>(node: Node<'a, '_>, rules: &'a [Rule<'a>]) -> Properties<'a> {
    let mut found: BTreeMap<&str, (&str, bool)> = BTreeMap::new();
    let mut take = |declaration: &Declaration<'a>| {
        let there = found.get(declaration.name).is_some_and(|&(_, important)| important);
        if counts(declaration) && (declaration.important || !there) {
            found.insert(declaration.name, (declaration.value.trim(), declaration.important));
        }
    };
    let matching = rules.iter().filter(|rule| rule.selector.matches(&Element(node)));
    matching.flat_map(|rule| &rule.declarations).for_each(&mut take);
    DeclarationTokenizer::from(node.attribute("style").unwrap_or_default()).for_each(|one| take(&one));
    found.into_iter().map(|(name, (value, _))| (name, value)).collect()
}

/// The text of the drawing with all this as attributes; none where there is nothing of the kind.
pub fn written_out(document: &Document<'_>, left_out: &mut LeftOut) -> Result<Option<String>, ReadError> {
    let elements = || document.descendants().filter(Node::is_element);
    let sheets =
        || elements().filter(|node| node.tag_name().name() == "style").flat_map(|node| node.children());
    let mut sheet = StyleSheet::new();
    for css in sheets().filter_map(|node| node.text()) {
        sheet.parse_more(css);
        if css.contains("calc(") || css.contains("var(") {
            left_out.add("lengths that style sheets compute");
        }
    }
    sheet.rules.retain(|rule| rule.declarations.iter().any(counts));
    let counts = |node: &Node<'_, '_>| {
        node.has_attribute("transform-box") || is_moved(*node) || parts(*node).next().is_some()
    };
    let styled: Vec<(NodeId, Properties<'_>)> = elements()
        .filter(|node| !sheet.rules.is_empty() || node.has_attribute("style") || counts(node))
        .map(|node| (node.id(), properties(node, &sheet.rules)))
        .filter(|(id, found)| !found.is_empty() || document.get_node(*id).is_some_and(|node| counts(&node)))
        .collect();
    if styled.is_empty() {
        return Ok(None);
    }
    // Where a transform is told in parts of the shape's own box, this is found first.
    let mut boxes: HashMap<NodeId, Rect> = HashMap::new();
    for pass in 0..MAX_PASSES {
        let mut writer =
            Writer { document, boxes: &boxes, edits: Vec::new(), asked: Vec::new(), unknown: false };
        for (id, found) in &styled {
            if let Some(node) = document.get_node(*id) {
                writer.element(node, found);
            }
        }
        let Writer { edits, asked, unknown, .. } = writer;
        // The box of a box hangs on that of the inner one.
        if asked.is_empty() || pass + 1 == MAX_PASSES || (pass == 1 && asked.len() == 1) {
            if unknown {
                left_out.add("transforms that could not be read");
            }
            return Ok(Some(edited(document.input_text(), edits)));
        }
        boxes = found_boxes(document, edits, &asked)?;
    }
    Ok(None)
}

/// The boxes of elements. A copy of each is drawn at the end, out of reach of what hides or uses it.
fn found_boxes(
    document: &Document<'_>,
    mut edits: Vec<Edit>,
    asked: &[NodeId],
) -> Result<HashMap<NodeId, Rect>, ReadError> {
    let text = document.input_text();
    let end = document.root_element().range().end;
    let end = text[..end].rfind("</").unwrap_or(end);
    let name = |id: &NodeId| format!("frond-box-{}", id.get());
    let mut copies = String::new();
    for id in asked {
        let place = document.get_node(*id).map(|node| node.range()).unwrap_or_default();
        let Some(own) = text.get(place.clone()).filter(|own| copies.len() + own.len() <= MAX_COPIED) else {
            continue;
        };
        let inside = edits.iter().filter(|(edit, _)| place.start < edit.start && edit.end < place.end);
        let inside =
            inside.map(|(edit, new)| (edit.start - place.start..edit.end - place.start, new.clone()));
        let _ = write!(copies, "<g id=\"{}\">{}</g>", name(id), edited(own, inside.collect()));
    }
    edits.push((end..end, copies));
    let text = source::checked(Cow::Owned(edited(text, edits)), &mut LeftOut::default())?;
    let tree = source::tree(&source::parse(&text)?)?;
    let found = |id: &NodeId| match tree.node_by_id(&name(id)) {
        Some(usvg::Node::Group(copy)) => copy.children().first().map(|node| {
            let sides = node.bounding_box();
            let [left, top, right, bottom] =
                [sides.left(), sides.top(), sides.right(), sides.bottom()].map(f64::from);
            Rect::new(left, top, right, bottom)
        }),
        _ => None,
    };
    Ok(asked.iter().map(|id| (*id, found(id).unwrap_or_default())).collect())
}

struct Writer<'a, 'input> {
    document: &'a Document<'input>,
    boxes: &'a HashMap<NodeId, Rect>,
    edits: Vec<Edit>,
    /// Elements whose boxes are asked for.
    asked: Vec<NodeId>,
    unknown: bool,
}

impl Writer<'_, '_> {
    fn element(&mut self, node: Node<'_, '_>, found: &Properties<'_>) {
        let start = node.range().start;
        let text = self.document.input_text();
        // What comes of an entity has no place in the text.
        let Some(name) = text.get(start..).and_then(|rest| rest.strip_prefix('<')) else { return };
        let name =
            name.find(|sign: char| sign.is_whitespace() || sign == '>' || sign == '/').unwrap_or(name.len());
        let mut new = String::new();
        // How large the page is does not matter.
        let is_root = node.parent_element().is_none();
        let written = |name: &&str| LINKS.contains(name) || !is_root && GEOMETRY.contains(name);
        for (&property, &value) in found.iter().filter(|(name, _)| written(name)) {
            let value = match property {
                "d" => value.trim_start_matches("path(").trim_end_matches(')').trim_matches(['"', '\'', ' ']),
                "width" | "height" | "rx" | "ry" if value == "auto" => "",
                _ if value.contains('(') && !LINKS.contains(&property) => continue,
                _ => value,
            };
            if let Some(attribute) = node.attribute_node(property) {
                self.edits.push((attribute.range(), String::new()));
            }
            if !value.is_empty() {
                let _ = write!(new, " {property}=\"{}\"", value.replace('"', "'").replace(['<', '&'], " "));
            }
        }
        for (attribute, value) in parts(node).filter(|(attribute, _)| !found.contains_key(attribute.name())) {
            self.edits.push((attribute.range(), format!("{}=\"{value}\"", attribute.name())));
        }
        let moved = is_moved(node)
            || node.tag_name().name() == "use" && LINKS[..2].iter().any(|name| found.contains_key(name));
        if moved {
            let sides = ["x", "y"].iter().filter_map(|name| node.attribute_node(*name));
            self.edits.extend(sides.map(|side| (side.range(), String::new())));
        }
        let transformed = TRANSFORMS.iter().any(|name| found.contains_key(name))
            || node.has_attribute("transform-box")
            || moved;
        if let Some(mut map) = transformed.then(|| self.transform(node, found)).flatten() {
            if moved {
                let around = viewport(node);
                let side =
                    |name, whole| node.attribute(name).and_then(|text| length(text, whole)).unwrap_or(0.0);
                map *= Affine::translate((side("x", around.width()), side("y", around.height())));
            }
            let [a, b, c, d, e, f] = map.as_coeffs();
            let style =
                format!("transform:matrix({a} {b} {c} {d} {e} {f})!important;transform-origin:0 0!important");
            match node.attribute_node("style") {
                Some(attribute) => {
                    let end = attribute.range_value().end;
                    self.edits.push((end..end, format!(";{style}")));
                }
                None => new.push_str(&format!(" style=\"{style}\"")),
            }
        }
        if !new.is_empty() {
            let end = start + 1 + name;
            self.edits.push((end..end, new));
        }
    }

    /// The map of all transforms of an element about its origin.
    fn transform(&mut self, node: Node<'_, '_>, found: &Properties<'_>) -> Option<Affine> {
        let get = |name: &str| found.get(name).copied().or_else(|| node.attribute(name));
        let around = match get("transform-box") {
            Some("fill-box" | "content-box" | "stroke-box" | "border-box") => {
                self.asked.push(node.id());
                self.boxes.get(&node.id()).copied()?
            }
            _ => viewport(node),
        };
        let mut all = Affine::IDENTITY;
        for name in ["translate", "rotate", "scale", "transform"] {
            // The first three are no attributes; `rotate` is one of letters.
            let value = if name == "transform" { get(name) } else { found.get(name).copied() };
            let Some(value) = value else { continue };
            let map =
                if name == "transform" { transform(value, around) } else { property(name, value, around) };
            match map {
                Some(map) => all *= map,
                None => self.unknown = true,
            }
        }
        // Where a property of a style sheet is no map, browsers go on without it.
        let about = get("transform-origin").and_then(|text| origin(text, around)).unwrap_or(around.origin());
        Some(Affine::translate(about.to_vec2()) * all * Affine::translate(-about.to_vec2()))
    }
}

/// Whether an element is used and clipped: it is clipped where it is moved to, which usvg passes over for symbols.
fn is_moved(node: Node<'_, '_>) -> bool {
    let has = |name: &&str| node.has_attribute(*name);
    node.tag_name().name() == "use" && LINKS[..2].iter().any(has)
}

/// Sides in parts (%) of a symbol's own box, and what they are: usvg takes them for parts of where it is used.
fn parts<'a, 'input>(node: Node<'a, 'input>) -> impl Iterator<Item = (Attribute<'a, 'input>, f64)> {
    let is_part =
        move |one: &Attribute<'_, '_>| SIDES.contains(&one.name()) && one.value().trim_end().ends_with('%');
    let symbol = node.attributes().any(|one| is_part(&one)).then(|| {
        let mut around =
            node.ancestors().skip(1).filter(|above| matches!(above.tag_name().name(), "svg" | "symbol"));
        around.next().filter(|above| above.tag_name().name() == "symbol").and_then(size)
    });
    let sides = symbol.flatten();
    node.attributes().filter(is_part).filter_map(move |one| {
        let (width, height) = sides?;
        let whole = match one.name() {
            "x" | "width" | "rx" | "cx" => width,
            "y" | "height" | "ry" | "cy" => height,
            _ => f64::hypot(width, height) / std::f64::consts::SQRT_2,
        };
        Some((one, length(one.value(), whole)?))
    })
}

/// The width and height of what an element shows, if it is a drawing of its own.
fn size(node: Node<'_, '_>) -> Option<(f64, f64)> {
    if let Some(text) = node.attribute("viewBox") {
        let sides: Vec<f64> = text.split([' ', ',']).filter_map(|part| part.trim().parse().ok()).collect();
        if let [_, _, width, height] = sides[..] {
            return Some((width, height));
        }
    }
    let side =
        |name| node.attribute(name).and_then(|text| length(text, f64::NAN)).filter(|side| side.is_finite());
    if node.tag_name().name() == "svg" { side("width").zip(side("height")) } else { None }
}

/// The box that parts (%) are of: as large as what the nearest drawing shows, from its origin on.
fn viewport(node: Node<'_, '_>) -> Rect {
    let mut around =
        node.ancestors().skip(1).filter(|above| matches!(above.tag_name().name(), "svg" | "symbol"));
    let (width, height) = around.find_map(size).unwrap_or((100.0, 100.0));
    Rect::new(0.0, 0.0, width, height)
}
