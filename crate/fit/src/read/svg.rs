//! Drawings: each closed part of each shape is an outline.

mod flatten;
mod path;
mod shape;
mod transform;
mod tree;

use std::collections::BTreeMap;

use kurbo::{Affine, PathEl, Rect};

use self::flatten::flatten;
use self::shape::{Drawn, MAX_POINTS, Shape, draw, is_shape};
use self::transform::transform;
use self::tree::{Tag, Tree};
use super::content::FileContent;
use super::problem::{ReadError, Remark};
use super::text::short;

/// Elements that are drawn, with all that is used more than once.
const MAX_DRAWN: usize = 20_000;
/// Letters that are looked through beyond those of the file: what is used more than once is read as often.
const MAX_AGAIN: usize = 16 << 20;
/// Things used within things used.
const MAX_USES: usize = 16;
/// A shape that all is drawn on has no more elements.
const MAX_GROUND: usize = 10;

/// Reads the shapes of an SVG: paths, polygons, polylines, rectangles, circles and ellipses, with their transforms, in
/// groups and wherever they are used. Nothing is run or fetched.
///
/// The text is gone through twice: once to see how large all is, which says how finely curves are to be flattened, and
/// once to flatten them. No shape is ever kept as a whole.
pub fn read_svg(text: &str) -> Result<FileContent, ReadError> {
    if text.contains("<!ENTITY") {
        return Err(ReadError::Entities);
    }
    let tree = Tree::read(text)?;
    let mut drawing =
        Drawing { tree: &tree, shapes: Vec::new(), ignored: Vec::new(), budget: text.len() + MAX_AGAIN };
    drawing.walk()?;
    let around = drawing.measure()?;
    let (gathered, parts) = flatten(&drawing.shapes, around, page(&tree.tag(0)))?;
    let mut remarks = Vec::new();
    if !drawing.ignored.is_empty() {
        let message = format!("Not looked at: {}.", drawing.ignored.join(", "));
        remarks.push(Remark::new("ignored", message));
    }
    // A shape of many parts has one name, and its text may be long.
    let mut names = BTreeMap::new();
    for &(shape, _) in gathered.kept.iter().map(|kept| &kept.label) {
        let Shape { tag, number, .. } = &drawing.shapes[shape];
        names.entry(shape).or_insert_with(|| {
            tag.get("id").map_or_else(|| format!("{} {number}", tag.name), |id| short(&id, 40))
        });
    }
    gathered.finish("svg", remarks, |&(shape, part)| match parts[shape] {
        1 => names[&shape].clone(),
        count => format!("{}, part {} of {count}", names[&shape], part + 1),
    })
}

/// Elements that are still to be drawn: a span of the tree.
struct Todo {
    next: u32,
    end: u32,
    place: Affine,
    uses: usize,
    used: bool,
}

struct Drawing<'a> {
    tree: &'a Tree<'a>,
    shapes: Vec<Shape<'a>>,
    ignored: Vec<&'static str>,
    /// Letters that may still be looked through.
    budget: usize,
}

impl<'a> Drawing<'a> {
    /// Finds the shapes that are drawn.
    fn walk(&mut self) -> Result<(), ReadError> {
        let whole = Todo { next: 0, end: 1, place: Affine::IDENTITY, uses: 0, used: false };
        let mut todo = vec![whole];
        let mut drawn = 0;
        while let Some(span) = todo.last_mut() {
            if span.next >= span.end {
                todo.pop();
                continue;
            }
            let (node, uses, used, mut place) = (span.next, span.uses, span.used, span.place);
            span.next = self.tree.after(node);
            drawn += 1;
            if drawn > MAX_DRAWN {
                return Err(ReadError::TooMany { what: "elements", most: MAX_DRAWN });
            }
            let tag = self.tag(node)?;
            if hidden(&tag) {
                continue;
            }
            if let Some(text) = tag.get("transform") {
                place *= transform(&text);
            }
            match tag.name {
                // What is only defined is drawn where it is used.
                "symbol" if !used => {}
                "svg" | "g" | "a" | "switch" | "symbol" => {
                    if tag.name == "svg" && node != 0 {
                        place *= Affine::translate((tag.number("x"), tag.number("y")));
                    }
                    let (next, end) = self.tree.inside(node);
                    todo.push(Todo { next, end, place, uses, used: false });
                }
                "use" => {
                    place *= Affine::translate((tag.number("x"), tag.number("y")));
                    match (self.target(&tag), uses < MAX_USES) {
                        (Some(node), true) => {
                            todo.push(Todo { next: node, end: node + 1, place, uses: uses + 1, used: true });
                        }
                        (None, _) => self.ignore("uses of what is elsewhere or missing"),
                        (_, false) => self.ignore("uses within uses beyond 16"),
                    }
                }
                "script" => self.ignore("scripts"),
                "text" | "tspan" | "textPath" => self.ignore("texts"),
                "image" => self.ignore("pictures"),
                "foreignObject" => self.ignore("foreign objects"),
                "style" => self.ignore("style sheets"),
                name if is_shape(name) => {
                    self.shapes.push(Shape { tag, place, number: self.shapes.len() + 1, simple: false });
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The tag of an element, if what is left of the budget is enough to look through it.
    fn tag(&mut self, node: u32) -> Result<Tag<'a>, ReadError> {
        let Some(left) = self.budget.checked_sub(self.tree.tag_text(node).len()) else {
            return Err(ReadError::TooMany {
                what: "letters in shapes that are used again",
                most: MAX_AGAIN,
            });
        };
        self.budget = left;
        Ok(self.tree.tag(node))
    }

    /// What a `use` means, if it is in the same drawing.
    fn target(&self, tag: &Tag<'_>) -> Option<u32> {
        let link = tag.get("href")?;
        self.tree.find(link.trim().strip_prefix('#')?)
    }

    fn ignore(&mut self, what: &'static str) {
        if !self.ignored.contains(&what) {
            self.ignored.push(what);
        }
    }

    /// Leaves the shapes that can be seen, and returns the box around them and the control points of their curves.
    fn measure(&mut self) -> Result<Option<Rect>, ReadError> {
        let mut all: Option<Rect> = None;
        let mut elements = 0;
        for mut shape in std::mem::take(&mut self.shapes) {
            let (mut bounds, mut count, mut beyond): (Option<Rect>, usize, bool) = (None, 0, false);
            let drawn = draw(&shape.tag, &mut |element| {
                count += 1;
                let (points, used) = match element {
                    PathEl::MoveTo(p) | PathEl::LineTo(p) => ([p; 3], 1),
                    PathEl::QuadTo(p, q) => ([p, q, q], 2),
                    PathEl::CurveTo(p, q, r) => ([p, q, r], 3),
                    PathEl::ClosePath => return,
                };
                for p in points[..used].iter().map(|&p| shape.place * p) {
                    if !(p.x.abs() <= 1e9 && p.y.abs() <= 1e9) {
                        beyond = true;
                    }
                    bounds = Some(bounds.map_or(Rect::from_points(p, p), |bounds| bounds.union_pt(p)));
                }
            });
            elements += count;
            if elements > MAX_POINTS {
                return Err(ReadError::TooMany { what: "points", most: MAX_POINTS });
            }
            match (drawn, bounds) {
                (Drawn::Not(why), _) => self.ignore(why),
                (Drawn::Partly, None) => self.ignore("paths that are miswritten"),
                (_, Some(bounds)) if !beyond => {
                    if matches!(drawn, Drawn::Partly) {
                        self.ignore("what follows a mistake in a path");
                    }
                    all = Some(all.map_or(bounds, |all| all.union(bounds)));
                    shape.simple = count <= MAX_GROUND;
                    self.shapes.push(shape);
                }
                _ => self.ignore("shapes that are empty, or beyond all bounds"),
            }
        }
        Ok(all)
    }
}

fn hidden(tag: &Tag<'_>) -> bool {
    let none = |style: &str| {
        style.split(';').filter_map(|rule| rule.split_once(':')).any(|(name, value)| {
            name.trim() == "display" && value.split('!').next().is_some_and(|value| value.trim() == "none")
        })
    };
    tag.get("display").as_deref() == Some("none") || tag.get("style").is_some_and(|style| none(&style))
}

/// What is shown of the plane.
fn page(root: &Tag<'_>) -> Option<Rect> {
    let text = root.get("viewBox")?;
    let sides: Vec<f64> = text
        .split(|sign: char| sign.is_whitespace() || sign == ',')
        .filter_map(|part| part.parse().ok())
        .take(5)
        .collect();
    let [x, y, width, height] = sides[..] else { return None };
    Some(Rect::new(x, y, x + width, y + height))
}
