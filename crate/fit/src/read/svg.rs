//! Drawings: each closed part of each shape is an outline.

mod shape;
mod transform;

use glam::DVec2;
use kurbo::{Affine, BezPath, PathEl, Rect, Shape};
use roxmltree::{Document, Node, ParsingOptions};

use self::shape::{number, path_of};
use self::transform::transform;
use super::Raw;
use super::problem::{ReadError, Remark};
use super::text::short;

/// Elements in the file, and elements drawn with all that is used more than once.
const MAX_ELEMENTS: usize = 200_000;
const MAX_DRAWN: usize = 20_000;
/// Things used within things used.
const MAX_USES: usize = 16;
/// Points of all curves once they are flattened.
const MAX_FLAT: usize = 1 << 21;
/// Curves are flattened to this part of the diagonal of all.
const FLATNESS: f64 = 5e-5;

/// Reads the shapes of an SVG: paths, polygons, polylines, rectangles, circles and ellipses, with their transforms, in
/// groups and wherever they are used. Nothing is run or fetched.
pub fn read_svg(text: &str) -> Result<(Vec<Raw>, Vec<Remark>), ReadError> {
    if text.contains("<!ENTITY") {
        return Err(ReadError::Entities);
    }
    let options =
        ParsingOptions { allow_dtd: true, nodes_limit: MAX_ELEMENTS as u32, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| match error {
        roxmltree::Error::NodesLimitReached => ReadError::TooMany { most: MAX_ELEMENTS },
        error => ReadError::Broken { format: "SVG", why: short(&error.to_string(), 120) },
    })?;
    let mut drawing = Drawing::default();
    drawing.walk(&document)?;
    let (raws, mut remarks) = drawing.flattened()?;
    if !drawing.ignored.is_empty() {
        let message = format!("Not looked at: {}.", drawing.ignored.join(", "));
        remarks.push(Remark::new("ignored", message));
    }
    if raws.is_empty() { Err(ReadError::Nothing { format: "SVG" }) } else { Ok((raws, remarks)) }
}

#[derive(Default)]
struct Drawing {
    shapes: Vec<(String, BezPath)>,
    ignored: Vec<&'static str>,
    /// What is shown of the plane.
    page: Option<Rect>,
}

/// An element that is still to be drawn.
struct Todo<'a, 'b> {
    node: Node<'a, 'b>,
    place: Affine,
    uses: usize,
    used: bool,
}

impl Drawing {
    fn walk(&mut self, document: &Document<'_>) -> Result<(), ReadError> {
        let root = document.root_element();
        self.page = page(root);
        let mut todo = vec![Todo { node: root, place: Affine::IDENTITY, uses: 0, used: false }];
        let mut drawn = 0;
        while let Some(Todo { node, place, uses, used }) = todo.pop() {
            drawn += 1;
            if drawn > MAX_DRAWN {
                return Err(ReadError::TooMany { most: MAX_DRAWN });
            }
            if !node.is_element() || hidden(node) {
                continue;
            }
            let name = node.tag_name().name();
            let mut place = place * node.attribute("transform").map_or(Affine::IDENTITY, transform);
            match name {
                "svg" | "g" | "a" | "switch" | "symbol" => {
                    if name == "symbol" && !used {
                        continue;
                    }
                    if name == "svg" && node != root {
                        place *= Affine::translate((number(node, "x"), number(node, "y")));
                    }
                    // The last one is taken from the stack first: their order stays.
                    let children: Vec<_> = node.children().filter(Node::is_element).collect();
                    todo.extend(children.into_iter().rev().map(|node| Todo {
                        node,
                        place,
                        uses,
                        used: false,
                    }));
                }
                "use" => {
                    let place = place * Affine::translate((number(node, "x"), number(node, "y")));
                    match (target(document, node), uses < MAX_USES) {
                        (Some(node), true) => todo.push(Todo { node, place, uses: uses + 1, used: true }),
                        (None, _) => self.ignore("uses of what is elsewhere or missing"),
                        (_, false) => self.ignore("uses within uses beyond 16"),
                    }
                }
                "script" => self.ignore("scripts"),
                "text" | "tspan" | "textPath" => self.ignore("texts"),
                "image" => self.ignore("pictures"),
                "foreignObject" => self.ignore("foreign objects"),
                "style" => self.ignore("style sheets"),
                _ => match path_of(node) {
                    Some(Ok(path)) => {
                        let kind = self.shapes.len() + 1;
                        let name =
                            node.attribute("id").map_or_else(|| format!("{name} {kind}"), |id| short(id, 40));
                        self.shapes.push((name, place * path));
                    }
                    Some(Err(why)) => self.ignore(why),
                    None => {}
                },
            }
        }
        Ok(())
    }

    fn ignore(&mut self, what: &'static str) {
        if !self.ignored.contains(&what) {
            self.ignored.push(what);
        }
    }

    /// The parts of all shapes as polylines with y up.
    fn flattened(&mut self) -> Result<(Vec<Raw>, Vec<Remark>), ReadError> {
        let finite = |path: &BezPath| {
            let bounds = path.control_box();
            [bounds.x0, bounds.y0, bounds.x1, bounds.y1].iter().all(|side| side.abs() <= 1e9)
        };
        let before = self.shapes.len();
        self.shapes.retain(|(_, path)| !path.is_empty() && finite(path));
        if self.shapes.len() < before {
            self.ignore("shapes that are empty, or beyond all bounds");
        }
        let mut raws = Vec::new();
        let mut count = 0;
        let around = self.shapes.iter().map(|(_, path)| path.control_box()).reduce(|a, b| a.union(b));
        let Some(around) = around else { return Ok((raws, Vec::new())) };
        let tolerance = (FLATNESS * around.size().to_vec2().hypot()).max(1e-12);
        for (name, path) in &self.shapes {
            let first = raws.len();
            let (mut points, mut closed): (Vec<DVec2>, bool) = (Vec::new(), false);
            let ground =
                path.elements().len() <= 6 && self.page.is_some_and(|page| covers(path.bounding_box(), page));
            let mut take = |points: &mut Vec<DVec2>, closed: bool| {
                if points.len() > 1 {
                    let points = std::mem::take(points);
                    let closed = closed || points.first() == points.last();
                    raws.push(Raw { name: name.clone(), points, closed, ground });
                }
                points.clear();
            };
            kurbo::flatten(path, tolerance, |element| {
                count += 1;
                match element {
                    PathEl::MoveTo(p) => {
                        take(&mut points, closed);
                        closed = false;
                        points.push(DVec2::new(p.x, -p.y));
                    }
                    PathEl::LineTo(p) if count < MAX_FLAT => points.push(DVec2::new(p.x, -p.y)),
                    PathEl::ClosePath => closed = true,
                    _ => {}
                }
            });
            take(&mut points, closed);
            let parts = raws.len() - first;
            if parts > 1 {
                for (k, raw) in raws[first..].iter_mut().enumerate() {
                    raw.name = format!("{name}, part {} of {parts}", k + 1);
                }
            }
        }
        if count >= MAX_FLAT {
            return Err(ReadError::TooMany { most: MAX_FLAT });
        }
        Ok((raws, Vec::new()))
    }
}

fn hidden(node: Node<'_, '_>) -> bool {
    let style: String = node.attribute("style").unwrap_or_default().split_whitespace().collect();
    node.attribute("display") == Some("none") || style.contains("display:none")
}

/// What a `use` means, if it is in the same drawing.
fn target<'a, 'b>(document: &'a Document<'b>, node: Node<'_, '_>) -> Option<Node<'a, 'b>> {
    let link = node.attribute("href").or_else(|| node.attribute(("http://www.w3.org/1999/xlink", "href")))?;
    let id = link.trim().strip_prefix('#')?;
    document.descendants().find(|node| node.attribute("id") == Some(id))
}

fn page(root: Node<'_, '_>) -> Option<Rect> {
    let sides: Vec<f64> = root
        .attribute("viewBox")?
        .split(|sign: char| sign.is_whitespace() || sign == ',')
        .filter_map(|part| part.parse().ok())
        .collect();
    let [x, y, width, height] = sides[..] else { return None };
    Some(Rect::new(x, y, x + width, y + height))
}

/// Whether a box is as good as all of the page, as grounds are.
fn covers(bounds: Rect, page: Rect) -> bool {
    let slack = 0.01 * page.width().max(page.height());
    bounds.inflate(slack, slack).union(page) == bounds.inflate(slack, slack)
}
