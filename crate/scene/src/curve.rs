//! Closed curves in a document.

use frond_fit::{ArcCopy, ClosedCurve, PackError};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// What an edge copies: [`ArcCopy`] as it is written in documents.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct CurveEdge {
    /// Knot where the arc begins.
    pub from: usize,
    /// How many edges it is long.
    pub span: usize,
    /// Whether its end comes to lie where the edge begins.
    pub reversed: bool,
    /// The roughness.
    pub c: f64,
}

/// A closed curve made of smaller copies of its own arcs: [`ClosedCurve`] as it is written in documents.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Curve {
    /// The knots, in order.
    pub knots: Vec<[f64; 2]>,
    /// What the edge from each knot to the next copies; none: it is straight.
    pub edges: Vec<Option<CurveEdge>>,
}

impl From<&ClosedCurve> for Curve {
    fn from(curve: &ClosedCurve) -> Self {
        let edge = |edge: &ArcCopy| CurveEdge {
            from: edge.from,
            span: edge.span,
            reversed: edge.reversed,
            c: edge.c,
        };
        Self {
            knots: curve.knots.iter().map(|p| p.to_array()).collect(),
            edges: curve.edges.iter().map(|e| e.as_ref().map(edge)).collect(),
        }
    }
}

impl From<&Curve> for ClosedCurve {
    fn from(curve: &Curve) -> Self {
        let edge = |e: &CurveEdge| ArcCopy { from: e.from, span: e.span, reversed: e.reversed, c: e.c };
        Self {
            knots: curve.knots.iter().map(|&p| DVec2::from_array(p)).collect(),
            edges: curve.edges.iter().map(|e| e.as_ref().map(edge)).collect(),
        }
    }
}

impl Curve {
    /// The curve of a fit as it is taken into a morph: about the origin, its longer side 2, and as a link keeps it.
    ///
    /// # Errors
    /// As [`ClosedCurve::quantised`].
    pub fn taken(&self) -> Result<Self, PackError> {
        let along = |axis: usize| {
            let all = || self.knots.iter().map(|knot| knot[axis]);
            (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max))
        };
        let ((x0, x1), (y0, y1)) = (along(0), along(1));
        let (x, y) = ((x0 + x1) / 2.0, (y0 + y1) / 2.0);
        let scale = 2.0 / (x1 - x0).max(y1 - y0).max(1e-12);
        let knots = self.knots.iter().map(|&[a, b]| [(a - x) * scale, (b - y) * scale]).collect();
        let moved = Self { knots, edges: self.edges.clone() };
        Ok(Self::from(&ClosedCurve::from(&moved).quantised()?))
    }
}

/// One end of a morph between closed curves.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct CurveShape {
    /// Its id in the gallery, while it is that of the gallery.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Its name.
    pub name: String,
    /// The curve. A link with a `spline` leaves it without knots.
    pub curve: Curve,
    /// The word of the curve of corners and parabolas ([`Spline::to_text`](frond_fit::Spline::to_text)) that it is, as
    /// [`Spline::polygon`](frond_fit::Spline::polygon) and [`Curve::taken`] make it: what a link keeps of it. What
    /// reads it is no part of the module for the first picture, so that this is left to those who draw it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spline: Option<String>,
}

impl CurveShape {
    /// The closed curve.
    ///
    /// # Errors
    /// Where knots or arcs are missing, or copies do not shrink; and where a spline stands for it.
    pub fn closed(&self) -> Result<ClosedCurve, PackError> {
        let curve = ClosedCurve::from(&self.curve);
        if curve.knots.len() > frond_fit::MAX_KNOTS {
            return Err(PackError::TooManyKnots);
        }
        if curve.is_sound() { Ok(curve) } else { Err(PackError::Unsound) }
    }
}

/// The ends of a morph between closed curves.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Curves {
    /// The first.
    pub a: CurveShape,
    /// The last.
    pub b: CurveShape,
}
