//! The curve step by step: from the polygon of its knots to itself.

use glam::DVec2;

use super::ClosedCurve;
use super::expansion::{Expansion, MAX_VERTICES, Vertex};

/// After so many steps nothing is seen to change: every copy shrinks what it copies to nine tenths at most.
const MOST_STEPS: f64 = 40.0;

/// What is shorter is not opened, in parts of the box's diagonal.
const FINEST: f64 = 2e-4;

impl ClosedCurve {
    /// The curve after a number of steps, as a closed polyline. 0 is the polygon of knots; at each step every copy is
    /// drawn anew from what its arc was before. Between two steps the polygon's own copies rise from straight lines,
    /// and with them what copies these. The curve must be [sound](Self::is_sound).
    ///
    /// What is no number counts as 0; from 40 on it does not change any more.
    #[must_use]
    pub fn grown(&self, steps: f64) -> Vec<DVec2> {
        let steps = if steps > 0.0 { steps.min(MOST_STEPS) } else { 0.0 };
        let count = self.knots.len();
        let knots: Vec<_> = (0..count).map(|i| Vertex::knot(self, i, false)).collect();
        let (low, high) = crate::outline::bounds(&self.knots);
        let tolerance = FINEST * low.distance(high);
        let polygon = Expansion { vertices: knots.clone(), starts: (0..=count).collect() };
        let mut level = polygon;
        if steps.fract() > 0.0 {
            level = self.opened(&level, &knots, tolerance, false);
            self.towards_polygon(&mut level, steps.fract());
        }
        for _ in 0..steps as usize {
            let next = self.opened(&level, &knots, tolerance, false);
            if next.vertices.len() > MAX_VERTICES {
                break;
            }
            level = next;
        }
        level.points()
    }

    /// Moves the first step's corners towards even places on their straight edges: 0 takes them there.
    fn towards_polygon(&self, level: &mut Expansion, share: f64) {
        for edge in 0..self.knots.len() {
            let (from, to) = (level.starts[edge], level.starts[edge + 1]);
            for at in from + 1..to {
                let along = (at - from) as f64 / (to - from) as f64;
                let flat = self.knots[edge].lerp(self.knot(edge + 1), along);
                level.vertices[at].at = flat.lerp(level.vertices[at].at, share);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::ArcCopy;
    use super::*;
    use crate::outline::Nearest;

    fn curve() -> ClosedCurve {
        let knots = [[0.0, 0.0], [0.5, 0.2], [1.0, 0.0], [1.1, 0.5], [1.0, 1.0], [0.0, 1.0]];
        let mut curve = ClosedCurve::polygon(knots.map(DVec2::from).to_vec());
        curve.edges[0] = Some(ArcCopy { from: 1, span: 3, reversed: false, c: 0.7 });
        curve.edges[3] = Some(ArcCopy { from: 0, span: 2, reversed: true, c: -0.4 });
        curve
    }

    /// How far any corner of either is from the other.
    fn apart(a: &[DVec2], b: &[DVec2]) -> f64 {
        let one = |a: &[DVec2], b: &[DVec2]| {
            let near = Nearest::new(b, true);
            a.iter().map(|&p| near.to(p).squared.sqrt()).fold(0.0, f64::max)
        };
        one(a, b).max(one(b, a))
    }

    #[test]
    fn it_begins_with_the_polygon_and_ends_with_the_curve() {
        let curve = curve();
        assert!(curve.is_sound());
        assert_eq!(curve.grown(0.0), curve.knots);
        assert_eq!(curve.grown(f64::NAN), curve.knots);
        assert_eq!(curve.grown(-3.0), curve.knots);
        assert!(apart(&curve.grown(f64::INFINITY), &curve.polyline(1e-5, 60)) < 1e-3);
        // A step is one more look at the arcs: two corners of edge 0, the images of knots 2 and 3.
        let once = curve.grown(1.0);
        assert_eq!(once.len(), 6 + 2 + 1);
        let (linear, origin) = curve.map(0).unwrap();
        for (i, knot) in [(1, 2), (2, 3)] {
            assert!(once[i].distance(curve.knots[0] + linear * (curve.knots[knot] - origin)) < 1e-12);
        }
        assert!(curve.grown(2.0).len() > once.len());
    }

    #[test]
    fn it_grows_without_a_jump() {
        let curve = curve();
        let mut before = curve.grown(0.0);
        for i in 1..=320 {
            let now = curve.grown(f64::from(i) / 80.0);
            let jump = apart(&before, &now);
            assert!(jump < 0.02, "{jump} at {}", f64::from(i) / 80.0);
            before = now;
        }
    }

    #[test]
    fn a_polygon_does_not_grow() {
        let polygon = ClosedCurve::polygon(curve().knots);
        assert_eq!(polygon.grown(7.5), polygon.knots);
    }
}
