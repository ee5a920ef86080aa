//! The paths of usvg in double precision.

use kurbo::{Affine, PathEl, Point, Rect};
use usvg::tiny_skia_path::PathSegment;

/// Curves are flattened to this part of the diagonal of all.
pub const FLATNESS: f64 = 5e-5;
/// No place of a shape is farther off than this.
const MAX_COORDINATE: f64 = 1e9;

/// A matrix in double precision.
pub fn affine(matrix: usvg::Transform) -> Affine {
    Affine::new([matrix.sx, matrix.ky, matrix.kx, matrix.sy, matrix.tx, matrix.ty].map(f64::from))
}

/// The elements of a path.
pub fn elements(path: &usvg::tiny_skia_path::Path) -> impl Iterator<Item = PathEl> {
    let point = |p: usvg::tiny_skia_path::Point| Point::new(p.x.into(), p.y.into());
    path.segments().map(move |segment| match segment {
        PathSegment::MoveTo(p) => PathEl::MoveTo(point(p)),
        PathSegment::LineTo(p) => PathEl::LineTo(point(p)),
        PathSegment::QuadTo(a, p) => PathEl::QuadTo(point(a), point(p)),
        PathSegment::CubicTo(a, b, p) => PathEl::CurveTo(point(a), point(b), point(p)),
        PathSegment::Close => PathEl::ClosePath,
    })
}

/// The box around a path, none where it has no place or is too far off.
pub fn around(path: &usvg::tiny_skia_path::Path, place: Affine) -> Option<Rect> {
    let sides = path.bounds();
    let corner = |x: f32, y: f32| place * Point::new(x.into(), y.into());
    let [a, b, c, d] = [
        (sides.left(), sides.top()),
        (sides.right(), sides.top()),
        (sides.right(), sides.bottom()),
        (sides.left(), sides.bottom()),
    ]
    .map(|(x, y)| corner(x, y));
    let bounds = Rect::from_points(a, c).union(Rect::from_points(b, d));
    let far =
        [bounds.x0, bounds.y0, bounds.x1, bounds.y1].into_iter().all(|side| side.abs() <= MAX_COORDINATE);
    far.then_some(bounds)
}
