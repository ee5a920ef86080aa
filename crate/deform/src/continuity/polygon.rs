//! Convex polygons.

use frond_core::shared::sort_indices;
use glam::DVec2;

/// Twice the area of a triangle, positive where it goes round counter-clockwise.
pub(crate) fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// The corners of the convex hull, counter-clockwise, as numbers of points: points within `tolerance` of a side, and
/// all but the first of those within `tolerance` of each other, are left out.
pub(crate) fn hull(points: &[DVec2], tolerance: f64) -> Vec<usize> {
    let mut order: Vec<usize> = Vec::new();
    for (i, point) in points.iter().enumerate() {
        if !order.iter().any(|&other| points[other].distance(*point) <= tolerance) {
            order.push(i);
        }
    }
    sort_indices(&mut order, &|a, b| {
        points[a].x.total_cmp(&points[b].x).then(points[a].y.total_cmp(&points[b].y))
    });
    let chain = |order: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for next in order {
            while let [.., a, b] = chain[..] {
                let (p, q, r) = (points[a], points[b], points[next]);
                if turn(p, q, r) > tolerance * p.distance(r) {
                    break;
                }
                chain.pop();
            }
            chain.push(next);
        }
        chain.pop();
        chain
    };
    let mut lower = chain(&mut order.iter().copied());
    lower.extend(chain(&mut order.iter().rev().copied()));
    lower
}

/// Whether two convex polygons, whichever way they go round, overlap by more than `tolerance`: no side of either has
/// them on different hands.
pub(crate) fn overlap(one: &[DVec2], other: &[DVec2], tolerance: f64) -> bool {
    let apart = |polygon: &[DVec2]| {
        (0..polygon.len()).any(|i| {
            let side = polygon[(i + 1) % polygon.len()] - polygon[i];
            let normal = side.perp().normalize_or_zero();
            let range = |points: &[DVec2]| {
                points
                    .iter()
                    .map(|p| p.dot(normal))
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
            };
            let ((a, b), (c, d)) = (range(one), range(other));
            b - c <= tolerance || d - a <= tolerance
        })
    };
    !apart(one) && !apart(other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hulls_leave_out_what_lies_on_a_side() {
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let mut points = square.to_vec();
        points.extend([DVec2::new(0.5, 0.0), DVec2::splat(0.5), DVec2::new(1.0, 1.0 - 1e-13), DVec2::ONE]);
        assert_eq!(hull(&points, 1e-9), [0, 1, 2, 3]);
        assert!(hull(&points[..1], 1e-9).len() < 3);
        assert!(hull(&[], 1e-9).is_empty());
        assert!(hull(&[DVec2::ZERO, DVec2::ONE, DVec2::splat(0.3)], 1e-9).len() < 3);
    }

    #[test]
    fn polygons_that_touch_do_not_overlap() {
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let moved = |by: DVec2| square.map(|p| p + by);
        assert!(!overlap(&square, &moved(DVec2::X), 1e-9));
        assert!(!overlap(&square, &moved(DVec2::ONE), 1e-9));
        assert!(overlap(&square, &moved(DVec2::new(0.9, -0.5)), 1e-9));
        assert!(overlap(&square, &square, 1e-9));
        // A star: neither holds a corner of the other.
        let up = [DVec2::new(-1.0, -0.6), DVec2::new(1.0, -0.6), DVec2::new(0.0, 1.2)];
        assert!(overlap(&up, &up.map(|p| -p), 1e-9));
    }
}
