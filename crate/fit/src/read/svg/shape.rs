//! Shapes as paths.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use kurbo::{Affine, PathEl, Point, Rect, Vec2};

use super::path::{Sink, arc, corners, path};
use super::tree::Tag;

/// Elements of all paths, and points of all lines once their curves are flattened.
pub const MAX_POINTS: usize = 1 << 23;

/// A shape that is drawn.
pub struct Shape<'a> {
    pub tag: Tag<'a>,
    pub place: Affine,
    /// How many shapes were drawn up to it.
    pub number: usize,
    /// Whether it has few elements, as what all is drawn on has.
    pub simple: bool,
}

/// What came of a shape.
#[derive(Clone, Copy)]
pub enum Drawn {
    /// All of it went to the sink.
    Whole,
    /// What stands before a mistake went to the sink.
    Partly,
    /// It has no outline, and why.
    Not(&'static str),
}

/// Whether an element is a shape.
pub fn is_shape(name: &str) -> bool {
    matches!(name, "path" | "polygon" | "polyline" | "rect" | "circle" | "ellipse")
}

/// Sends the outline of a shape to `sink`, element by element. Nothing hangs on how large or small it is: as many
/// curves go round a circle of any radius.
pub fn draw(tag: &Tag<'_>, sink: Sink<'_>) -> Drawn {
    let get = |name| tag.number(name);
    let whole = match tag.name {
        "path" => path(&tag.get("d").unwrap_or_default(), sink),
        name @ ("polygon" | "polyline") => {
            corners(&tag.get("points").unwrap_or_default(), name == "polygon", sink)
        }
        "rect" => {
            let (width, height) = (get("width"), get("height"));
            if width <= 0.0 || height <= 0.0 {
                return Drawn::Not("rectangles without a size in numbers");
            }
            let bounds = Rect::new(get("x"), get("y"), get("x") + width, get("y") + height);
            let radii = match (get("rx"), get("ry")) {
                (rx, 0.0) => (rx, rx),
                (0.0, ry) => (ry, ry),
                both => both,
            };
            rectangle(bounds, Vec2::new(radii.0.min(0.5 * width), radii.1.min(0.5 * height)), sink);
            true
        }
        "circle" => {
            let radius = get("r");
            if radius <= 0.0 {
                return Drawn::Not("circles without a radius in numbers");
            }
            ellipse(Point::new(get("cx"), get("cy")), Vec2::new(radius, radius), sink);
            true
        }
        "ellipse" => {
            let radii = Vec2::new(get("rx"), get("ry"));
            if radii.x <= 0.0 || radii.y <= 0.0 {
                return Drawn::Not("ellipses without radii in numbers");
            }
            ellipse(Point::new(get("cx"), get("cy")), radii, sink);
            true
        }
        _ => true,
    };
    if whole { Drawn::Whole } else { Drawn::Partly }
}

fn ellipse(centre: Point, radii: Vec2, sink: Sink<'_>) {
    sink(PathEl::MoveTo(centre + Vec2::new(radii.x, 0.0)));
    arc(centre, radii, 0.0, 0.0, TAU, sink);
    sink(PathEl::ClosePath);
}

/// A rectangle whose corners are quarters of ellipses, or sharp.
fn rectangle(bounds: Rect, radii: Vec2, sink: Sink<'_>) {
    let round = radii.x > 0.0 && radii.y > 0.0;
    let inner = if round { bounds.inflate(-radii.x, -radii.y) } else { bounds };
    // Each corner with the place where it begins.
    let corners = [
        ((bounds.x0, inner.y0), (inner.x0, inner.y0)),
        ((inner.x1, bounds.y0), (inner.x1, inner.y0)),
        ((bounds.x1, inner.y1), (inner.x1, inner.y1)),
        ((inner.x0, bounds.y1), (inner.x0, inner.y1)),
    ];
    for (k, (start, centre)) in corners.into_iter().enumerate() {
        sink(if k == 0 { PathEl::MoveTo(start.into()) } else { PathEl::LineTo(start.into()) });
        if round {
            arc(centre.into(), radii, 0.0, PI + FRAC_PI_2 * k as f64, FRAC_PI_2, sink);
        }
    }
    sink(PathEl::ClosePath);
}
