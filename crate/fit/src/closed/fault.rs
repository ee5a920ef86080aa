//! What keeps a closed curve from holding together.

use super::{CONTRACTION, ClosedCurve, MAX_SPAN};
use crate::fractal::piece::spectral_norm;

/// What is wrong with a curve. Knots and edges count from 1 in messages.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CurveFault {
    /// Fewer than three knots: how many.
    Few(usize),
    /// Not one edge a knot.
    Edges {
        /// How many knots.
        knots: usize,
        /// How many edges.
        edges: usize,
    },
    /// A number of a knot or an edge is not finite or too large: which.
    NotFinite(&'static str, usize),
    /// An arc that is not there.
    Arc {
        /// Index of its edge.
        edge: usize,
        /// How many knots there are.
        knots: usize,
    },
    /// A copy that does not shrink enough.
    Growing {
        /// Index of its edge.
        edge: usize,
        /// The factor by which it stretches lengths.
        factor: f64,
    },
}

impl CurveFault {
    /// A name that does not change, for programs.
    #[must_use]
    pub fn code(self) -> &'static str {
        match self {
            Self::Few(_) => "too-few-points",
            Self::Edges { .. } => "wrong-count",
            Self::NotFinite(..) => "not-finite",
            Self::Arc { .. } => "bad-arc",
            Self::Growing { .. } => "not-contractive",
        }
    }

    /// What is wrong, and what to do.
    #[must_use]
    pub fn message(self) -> String {
        match self {
            Self::Few(count) => format!("The curve has {count} knots, and it needs three or more. Add some."),
            Self::Edges { knots, edges } => format!(
                "The curve has {knots} knots and {edges} edges. Give one edge a knot, null where it is straight."
            ),
            Self::NotFinite(what, index) => format!(
                "{what} {} holds a number that is not finite or is too large. Mend it or leave it out.",
                index + 1
            ),
            Self::Arc { edge, knots } => format!(
                "Edge {} copies an arc that is not there. Begin at a knot from 0 to {} and span 2 to {} edges.",
                edge + 1,
                knots - 1,
                MAX_SPAN.min(knots - 1)
            ),
            Self::Growing { edge, factor } => format!(
                "Edge {} would be its arc times {factor:.3}, and the most is {CONTRACTION}. Copy a longer arc, or make c smaller.",
                edge + 1
            ),
        }
    }
}

impl ClosedCurve {
    /// What is wrong with it, if anything is.
    #[must_use]
    pub fn fault(&self) -> Option<CurveFault> {
        let (knots, edges) = (self.knots.len(), self.edges.len());
        if knots < 3 {
            return Some(CurveFault::Few(knots));
        }
        if knots != edges {
            return Some(CurveFault::Edges { knots, edges });
        }
        if let Some(i) = self.knots.iter().position(|p| !(p.x.abs() <= 1e100 && p.y.abs() <= 1e100)) {
            return Some(CurveFault::NotFinite("Knot", i));
        }
        for (edge, copy) in self.edges.iter().enumerate() {
            let Some(copy) = copy else { continue };
            if copy.c.is_nan() || copy.c.abs() > 1e100 {
                return Some(CurveFault::NotFinite("Edge", edge));
            }
            if copy.from >= knots || copy.span < 2 || copy.span > MAX_SPAN || copy.span >= knots {
                return Some(CurveFault::Arc { edge, knots });
            }
            let factor = self.map(edge).map_or(0.0, |(linear, _)| spectral_norm(linear));
            if factor.is_nan() || factor > CONTRACTION * (1.0 + 1e-12) {
                return Some(CurveFault::Growing { edge, factor });
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::closed::ArcCopy;

    fn hexagon() -> ClosedCurve {
        let mut curve = ClosedCurve::polygon(
            (0..6).map(|i| DVec2::from_angle(f64::from(i) * 1.0471975511965976)).collect(),
        );
        curve.edges[0] = Some(ArcCopy { from: 2, span: 3, reversed: true, c: -0.4 });
        curve
    }

    #[test]
    fn what_is_wrong_is_named() {
        assert_eq!(hexagon().fault(), None);
        type Break = fn(&mut ClosedCurve);
        let breaks: [(Break, &str); 11] = [
            (|c| c.knots.truncate(2), "too-few-points"),
            (|c| c.edges.truncate(5), "wrong-count"),
            (|c| c.edges.push(None), "wrong-count"),
            (|c| c.knots[3].x = f64::NAN, "not-finite"),
            (|c| c.knots[5].y = -1e200, "not-finite"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { c: f64::NEG_INFINITY, ..copy }), "not-finite"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { from: 6, ..copy }), "bad-arc"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { span: 1, ..copy }), "bad-arc"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { span: usize::MAX, ..copy }), "bad-arc"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { c: 2.0, ..copy }), "not-contractive"),
            (|c| c.knots[2] = c.knots[5], "not-contractive"),
        ];
        for (work, code) in breaks {
            let mut curve = hexagon();
            work(&mut curve);
            let fault = curve.fault().unwrap();
            assert_eq!(fault.code(), code);
            assert!(fault.message().len() > 30 && !curve.is_sound() || code == "not-finite");
        }
    }
}
