//! The shapes of a drawing that are shown, in the order in which they are painted.

use std::rc::Rc;

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use kurbo::{Affine, Rect};
use usvg::{Group, ImageKind, Node, Tree};

use super::super::problem::{LeftOut, ReadError};
use super::paths::{FLATNESS, affine, around};
use super::region::{Cutter, Region, bounds, frame, rule};
use super::source;

/// A shape that all is drawn on has no more elements.
const MAX_GROUND: usize = 10;
/// The outline of a shape.
pub enum Drawn<'a> {
    Path(&'a usvg::tiny_skia_path::Path, Affine),
    /// What a clip path or a mask leaves of it.
    Cut(Region),
}

/// A shape that is drawn.
pub struct Shape<'a> {
    /// Its id in the file, or nothing.
    pub name: &'a str,
    /// How many shapes were drawn up to it.
    pub number: usize,
    pub drawn: Drawn<'a>,
    /// Whether it has few elements, as what all is drawn on has.
    pub simple: bool,
    pub hidden: bool,
}

/// What is shown of a drawing.
pub struct Visible<'a> {
    /// Those that are hidden where no other is.
    pub shapes: Vec<Shape<'a>>,
    /// The box around them and the control points of their curves.
    pub around: Option<Rect>,
    /// How many are hidden.
    pub hidden: usize,
}

/// What a group hands down to what is inside of it.
#[derive(Clone)]
struct Within<'a> {
    place: Affine,
    /// What clip paths and masks leave.
    region: Option<Rc<Region>>,
    hidden: bool,
    name: &'a str,
}

impl<'a> Visible<'a> {
    pub fn of(tree: &'a Tree, left_out: &mut LeftOut) -> Result<Self, ReadError> {
        let whole = tree.root().abs_bounding_box();
        let size = f64::hypot(whole.width().into(), whole.height().into());
        let mut walk = Walk {
            cutter: Cutter::new((FLATNESS * size).max(1e-12)),
            found: Vec::new(),
            number: 0,
            left_out,
        };
        walk.group(tree.root(), &Within { place: Affine::IDENTITY, region: None, hidden: false, name: "" });
        let mut shapes = walk.found;
        let hidden = shapes.iter().filter(|shape| shape.hidden).count();
        if hidden < shapes.len() {
            shapes.retain(|shape| !shape.hidden);
        }
        let around = shapes.iter().filter_map(|shape| match &shape.drawn {
            Drawn::Path(path, place) => around(path, *place),
            Drawn::Cut(region) => bounds(region),
        });
        let around = around.reduce(|all, one| all.union(one));
        Ok(Self { shapes, around, hidden })
    }
}

struct Walk<'a, 'b> {
    cutter: Cutter,
    found: Vec<Shape<'a>>,
    number: usize,
    left_out: &'b mut LeftOut,
}

impl<'a> Walk<'a, '_> {
    fn group(&mut self, group: &'a Group, within: &Within<'a>) {
        let mut within = within.clone();
        within.hidden |= group.opacity().get() <= 0.0;
        if !group.id().is_empty() {
            within.name = group.id();
        }
        // What usvg tells as the whole transform leaves out that of symbols which are used.
        let place = within.place * affine(group.transform());
        within.place = place;
        if let Some(clip) = group.clip_path() {
            let region = self.cutter.clip(clip, place);
            self.narrow(&mut within, region, "clip paths that are too large");
        }
        if let Some(mask) = group.mask() {
            let region = self.cutter.mask(mask, place, self.left_out);
            self.narrow(&mut within, region, "masks that are too large");
        }
        for node in group.children() {
            match node {
                Node::Group(group) => self.group(group, &within),
                Node::Path(path) => self.path(path, &within),
                Node::Image(image) => self.image(image, &within),
                Node::Text(_) => {}
            }
        }
    }

    /// Cuts what is left already by one more region.
    fn narrow(&mut self, within: &mut Within<'a>, region: Option<Region>, too_large: &'static str) {
        let both = region.and_then(|region| match &within.region {
            Some(before) => self.cutter.cut(before, &region, OverlayRule::Intersect),
            None => Some(region),
        });
        match both {
            Some(region) => within.region = Some(Rc::new(region)),
            None => self.left_out.add(too_large),
        }
    }

    fn path(&mut self, path: &'a usvg::Path, within: &Within<'a>) {
        self.number += 1;
        let place = within.place;
        let Some(bounds) = around(path.data(), place) else {
            return self.left_out.add("shapes that are empty, or beyond all bounds");
        };
        let painted = path.fill().is_some_and(|fill| fill.opacity().get() > 0.0)
            || path.stroke().is_some_and(|stroke| stroke.opacity().get() > 0.0);
        let rule = path.fill().map_or(FillRule::NonZero, |fill| rule(fill.rule()));
        let drawn = match &within.region {
            Some(region) if !is_within(bounds, region) => {
                let covered = self.cutter.covered(path.data(), place, rule);
                match covered.and_then(|covered| self.cutter.cut(&covered, region, OverlayRule::Intersect)) {
                    // Nothing of it is left.
                    Some(left) if left.is_empty() => return,
                    Some(left) => Drawn::Cut(left),
                    None => {
                        self.left_out.add("clip paths that are too large");
                        Drawn::Path(path.data(), place)
                    }
                }
            }
            _ => Drawn::Path(path.data(), place),
        };
        self.found.push(Shape {
            name: if path.id().is_empty() && matches!(drawn, Drawn::Cut(_)) {
                within.name
            } else {
                path.id()
            },
            number: self.number,
            drawn,
            simple: path.data().len() <= MAX_GROUND,
            hidden: within.hidden || !path.is_visible() || !painted,
        });
    }

    /// A picture has the outline that it is clipped to.
    fn image(&mut self, image: &'a usvg::Image, within: &Within<'a>) {
        let Some(region) = &within.region else { return };
        self.number += 1;
        let sides = image.bounding_box();
        let [left, top, right, bottom] =
            [sides.left(), sides.top(), sides.right(), sides.bottom()].map(f64::from);
        let frame = frame(Rect::new(left, top, right, bottom), within.place);
        // How large a picture is that is elsewhere, nobody knows.
        let elsewhere = matches!(image.kind(), ImageKind::GIF(data) if data.as_slice() == source::ELSEWHERE);
        let left = if elsewhere { None } else { self.cutter.cut(region, &frame, OverlayRule::Intersect) };
        let region = left.unwrap_or_else(|| region.to_vec());
        if region.is_empty() {
            return;
        }
        self.found.push(Shape {
            name: if image.id().is_empty() { within.name } else { image.id() },
            number: self.number,
            drawn: Drawn::Cut(region),
            simple: false,
            hidden: within.hidden || !image.is_visible(),
        });
    }
}

/// Whether a box lies in a region that is a box itself, as those of nested drawings are.
fn is_within(inner: Rect, region: &Region) -> bool {
    let [line] = &region[..] else { return false };
    let Some(outer) = bounds(region) else { return false };
    let corner = |&[x, y]: &[f64; 2]| (x == outer.x0 || x == outer.x1) && (y == outer.y0 || y == outer.y1);
    line.len() == 4 && line.iter().all(corner) && outer.union(inner) == outer
}
