//! The way along a polygon.

use glam::DVec3;

/// The point at the fraction `t` of the length of a polygon.
///
/// # Panics
/// If there are no points.
#[must_use]
pub fn along(points: &[DVec3], t: f64) -> DVec3 {
    let length: f64 = points.windows(2).map(|leg| leg[0].distance(leg[1])).sum();
    let mut left = t.clamp(0.0, 1.0) * length;
    for leg in points.windows(2) {
        let step = leg[0].distance(leg[1]);
        if left <= step && step > 0.0 {
            // Exact at both ends.
            return if left == step { leg[1] } else { leg[0].lerp(leg[1], left / step) };
        }
        left -= step;
    }
    points[points.len() - 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_along_a_polygon() {
        let points = [DVec3::ZERO, DVec3::X, DVec3::X, DVec3::new(1.0, 3.0, 0.0)];
        assert_eq!(along(&points, 0.0), DVec3::ZERO);
        assert_eq!(along(&points, 0.125), DVec3::new(0.5, 0.0, 0.0));
        assert_eq!(along(&points, 0.25), DVec3::X);
        assert_eq!(along(&points, 1.0), DVec3::new(1.0, 3.0, 0.0));
        assert_eq!(along(&points[..1], 0.5), DVec3::ZERO);
    }
}
