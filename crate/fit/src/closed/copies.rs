//! Which edge copies which arc, and how it lies to it.

use glam::DVec2;

use super::{ClosedCurve, over};

/// How an edge lies to the arc that it copies: it is the arc, made smaller, turned, and perhaps mirrored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CopyFacts {
    /// The edge, from the knot of this index to the next.
    pub edge: usize,
    /// Knot where the arc begins.
    pub from: usize,
    /// How many edges it is long.
    pub span: usize,
    /// How many times as long the edge's chord is as the arc's.
    pub ratio: f64,
    /// The same across the chord: how many times as far points are from it. 0 is a straight edge.
    pub across: f64,
    /// By how many degrees the arc's chord is turned, above -180 and at most 180, counterclockwise where y points up.
    pub degrees: f64,
    /// Whether what lies left of the arc's chord comes to lie right of the edge's.
    pub mirrored: bool,
}

impl ClosedCurve {
    /// How each copied edge lies to its arc, in the order of the edges. The curve must be [sound](Self::is_sound).
    #[must_use]
    pub fn copy_facts(&self) -> Vec<CopyFacts> {
        let facts = |(edge, copy): (usize, &Option<super::ArcCopy>)| {
            let copy = copy.as_ref()?;
            let (first, last) = self.arc_ends(copy);
            let turn: DVec2 =
                over(self.knot(edge + 1) - self.knots[edge], self.knots[last] - self.knots[first]);
            let degrees = turn.to_angle().to_degrees();
            Some(CopyFacts {
                edge,
                from: copy.from,
                span: copy.span,
                ratio: turn.length(),
                across: turn.length() * copy.c.abs(),
                degrees: if degrees <= -180.0 { 180.0 } else { degrees },
                mirrored: copy.c < 0.0,
            })
        };
        self.edges.iter().enumerate().filter_map(facts).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::ArcCopy;
    use super::*;

    /// An arc over two edges from (0, 0) to (4, 0) whose middle is at (2, 2), and an edge from (6, 0) up to (6, 1).
    fn curve(copy: ArcCopy) -> ClosedCurve {
        let knots = [[0.0, 0.0], [2.0, 2.0], [4.0, 0.0], [6.0, 0.0], [6.0, 1.0], [0.0, -3.0]];
        let mut curve = ClosedCurve::polygon(knots.map(DVec2::from).to_vec());
        curve.edges[3] = Some(copy);
        curve
    }

    #[test]
    fn size_turn_and_mirror_are_those_of_the_map() {
        let facts = curve(ArcCopy { from: 0, span: 2, reversed: false, c: 0.5 }).copy_facts();
        assert_eq!(facts.len(), 1);
        let CopyFacts { edge, from, span, ratio, across, degrees, mirrored } = facts[0];
        assert_eq!((edge, from, span, mirrored), (3, 0, 2, false));
        assert!((ratio - 0.25).abs() < 1e-12 && (across - 0.125).abs() < 1e-12);
        assert!((degrees - 90.0).abs() < 1e-9);
        // Its other end first, it is turned the other way.
        let back = curve(ArcCopy { from: 0, span: 2, reversed: true, c: -0.5 }).copy_facts()[0];
        assert!((back.degrees + 90.0).abs() < 1e-9 && back.mirrored);
    }

    #[test]
    fn they_say_where_each_point_of_the_arc_goes() {
        for (reversed, c) in [(false, 0.6), (false, -0.6), (true, 0.9), (true, -0.2)] {
            let curve = curve(ArcCopy { from: 0, span: 2, reversed, c });
            let facts = curve.copy_facts()[0];
            let (linear, origin) = curve.map(3).unwrap();
            let told = curve.knots[3] + linear * (curve.knots[1] - origin);
            // By hand: along and across the arc's chord, mirrored, made smaller, turned.
            let (first, last) = if reversed { (2, 0) } else { (0, 2) };
            let along = (curve.knots[last] - curve.knots[first]).normalize();
            let off = curve.knots[1] - curve.knots[first];
            let side = if facts.mirrored { -facts.across } else { facts.across };
            let shape =
                along * (along.dot(off) * facts.ratio) + along.perp() * (along.perp().dot(off) * side);
            let ours = curve.knots[3] + DVec2::from_angle(facts.degrees.to_radians()).rotate(shape);
            assert!(told.distance(ours) < 1e-12, "{reversed} {c}: {told} {ours}");
        }
    }

    #[test]
    fn a_turn_is_never_minus_half_a_circle() {
        let knots = [[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [4.0, -2.0], [3.0, -2.0]];
        let mut curve = ClosedCurve::polygon(knots.map(DVec2::from).to_vec());
        curve.edges[3] = Some(ArcCopy { from: 0, span: 2, reversed: false, c: 0.3 });
        assert_eq!(curve.copy_facts()[0].degrees, 180.0);
        assert!(ClosedCurve::polygon(curve.knots).copy_facts().is_empty());
    }
}
