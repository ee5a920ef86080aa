//! Shapes as paths.

use kurbo::{Affine, BezPath, Circle, Ellipse, Rect, RoundedRect, Shape};
use roxmltree::Node;

/// A path with more numbers is not read.
const MAX_NUMBERS: usize = 2_500_000;

/// The path of a shape, or why it has none; None where the element is no shape.
pub fn path_of(node: Node<'_, '_>) -> Option<Result<BezPath, &'static str>> {
    let get = |name| number(node, name);
    let path = match node.tag_name().name() {
        "path" => {
            let data = node.attribute("d").unwrap_or_default();
            if too_long(data) {
                return Some(Err("paths of more than 2,500,000 numbers"));
            }
            return Some(BezPath::from_svg(data).map_err(|_| "paths that are miswritten"));
        }
        "polygon" | "polyline" => {
            let list = node.attribute("points").unwrap_or_default();
            if too_long(list) {
                return Some(Err("paths of more than 2,500,000 numbers"));
            }
            let numbers: Vec<f64> = list
                .split(|sign: char| sign.is_whitespace() || sign == ',')
                .filter(|part| !part.is_empty())
                .map_while(|part| part.parse().ok())
                .collect();
            let mut path = BezPath::new();
            for (i, pair) in numbers.chunks_exact(2).enumerate() {
                let point = (pair[0], pair[1]);
                if i == 0 { path.move_to(point) } else { path.line_to(point) }
            }
            if node.tag_name().name() == "polygon" && !path.is_empty() {
                path.close_path();
            }
            path
        }
        "rect" => {
            let (width, height) = (get("width"), get("height"));
            if width <= 0.0 || height <= 0.0 {
                return Some(Err("rectangles without a size in numbers"));
            }
            let bounds = Rect::new(get("x"), get("y"), get("x") + width, get("y") + height);
            let (rx, ry) = match (get("rx"), get("ry")) {
                (rx, 0.0) => (rx, rx),
                (0.0, ry) => (ry, ry),
                both => both,
            };
            let (rx, ry) = (rx.min(0.5 * width), ry.min(0.5 * height));
            if rx > 0.0 && ry > 0.0 {
                // Corners are round in a plane where both radii are the same.
                let squeeze = Affine::scale_non_uniform(1.0, ry / rx);
                let (top, bottom) = (bounds.y0 * rx / ry, bounds.y1 * rx / ry);
                squeeze * RoundedRect::new(bounds.x0, top, bounds.x1, bottom, rx).to_path(1e-4 * rx)
            } else {
                bounds.to_path(0.1)
            }
        }
        "circle" => {
            let radius = get("r");
            if radius <= 0.0 {
                return Some(Err("circles without a radius in numbers"));
            }
            Circle::new((get("cx"), get("cy")), radius).to_path(1e-4 * radius)
        }
        "ellipse" => {
            let radii = (get("rx"), get("ry"));
            if radii.0 <= 0.0 || radii.1 <= 0.0 {
                return Some(Err("ellipses without radii in numbers"));
            }
            Ellipse::new((get("cx"), get("cy")), radii, 0.0).to_path(1e-4 * radii.0.min(radii.1))
        }
        _ => return None,
    };
    Some(Ok(path))
}

/// A length in the drawing's own units: whatever unit stands after it is passed over. 0 where there is none, and for
/// parts of a page (%).
pub fn number(node: Node<'_, '_>, name: &str) -> f64 {
    let text = node.attribute(name).unwrap_or_default().trim();
    let text = text.trim_end_matches(|sign: char| sign.is_ascii_alphabetic());
    text.parse().ok().filter(|value: &f64| value.abs() <= 1e9).unwrap_or(0.0)
}

/// Counts numbers by the places where one may begin.
fn too_long(data: &str) -> bool {
    if data.len() < MAX_NUMBERS {
        return false;
    }
    let mut before = b' ';
    let mut count = 0;
    for byte in data.bytes() {
        let digit = byte.is_ascii_digit() || byte == b'.';
        if digit && !(before.is_ascii_digit() || before == b'.') {
            count += 1;
        }
        before = byte;
    }
    count > MAX_NUMBERS
}
