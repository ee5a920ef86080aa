//! Self-affine closed curves: knots, and edges that are straight or copies of arcs.

mod copies;
pub(crate) mod expansion;
mod fault;
mod growth;
mod pack;
mod states;
mod text;

pub use copies::CopyFacts;
pub use fault::CurveFault;
pub use pack::{MAX_KNOTS, PackError};
pub use text::MAX_TEXT;

use glam::{DMat2, DVec2};

/// The most edges an arc that is copied has.
pub const MAX_SPAN: usize = 8;

/// No map of a copy stretches lengths by more than this, in the Euclidean norm.
pub const CONTRACTION: f64 = 0.9;

/// While fitting, copies stretch by no more than this part of it.
pub(crate) const FITTING_SHARE: f64 = 0.95;

/// What an edge copies: the arc over `span` edges from knot `from` on.
///
/// A similarity takes the arc's chord to the edge's, the far end first where `reversed`; then distances from the chord
/// are multiplied by `c`. So it is one affine map, a mirror where c < 0, the chord itself at c = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcCopy {
    /// Knot where the arc begins.
    pub from: usize,
    /// How many edges it is long, 2 or more.
    pub span: usize,
    /// Whether its end comes to lie where the edge begins.
    pub reversed: bool,
    /// The roughness: what distances from the chord are multiplied by.
    pub c: f64,
}

/// A closed curve through knots whose edges are straight or smaller copies of its own arcs.
///
/// It is closed and has no gaps by construction: every edge, whatever it copies, runs from knot to knot. With one
/// affine map an edge it is a recurrent system (Cochran, Hart & Flynn, eqs 4 to 6, with the non-separable maps of eq
/// 9). It costs 2 numbers a knot and 2 a copied edge.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedCurve {
    /// The knots, in order.
    pub knots: Vec<DVec2>,
    /// What the edge from each knot to the next copies; none: it is straight.
    pub edges: Vec<Option<ArcCopy>>,
}

/// The matrix of the multiplication by a complex number.
pub(crate) fn complex(z: DVec2) -> DMat2 {
    DMat2::from_cols(z, z.perp())
}

/// a / b of complex numbers.
pub(crate) fn over(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.dot(b), b.perp_dot(a)) / b.length_squared()
}

impl ClosedCurve {
    /// The polygon of knots.
    #[must_use]
    pub fn polygon(knots: Vec<DVec2>) -> Self {
        let edges = vec![None; knots.len()];
        Self { knots, edges }
    }

    /// How many numbers it is made of: 2 a knot, 2 a copied edge.
    #[must_use]
    pub fn numbers(&self) -> usize {
        2 * (self.knots.len() + self.copies())
    }

    /// How many edges are copies.
    #[must_use]
    pub fn copies(&self) -> usize {
        self.edges.iter().flatten().count()
    }

    pub(crate) fn knot(&self, index: usize) -> DVec2 {
        self.knots[index % self.knots.len()]
    }

    /// The arc's ends, the one that comes to lie at the edge's beginning first, as indices of knots.
    pub(crate) fn arc_ends(&self, copy: &ArcCopy) -> (usize, usize) {
        let count = self.knots.len();
        let (first, last) = (copy.from % count, (copy.from + copy.span) % count);
        if copy.reversed { (last, first) } else { (first, last) }
    }

    /// The linear part of the map that makes edge `index` of its arc, and where the arc begins; none where it is
    /// straight.
    #[must_use]
    pub fn map(&self, index: usize) -> Option<(DMat2, DVec2)> {
        let copy = self.edges.get(index)?.as_ref()?;
        let (first, last) = self.arc_ends(copy);
        let chord = self.knots[last] - self.knots[first];
        let edge = self.knot(index + 1) - self.knots[index];
        let squash = DMat2::from_diagonal(DVec2::new(1.0, copy.c));
        Some((complex(edge) * squash * complex(over(DVec2::X, chord)), self.knots[first]))
    }

    /// Whether all is finite, arcs exist, and every copy shrinks by [`CONTRACTION`] at least: then there is one curve.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let count = self.knots.len();
        count >= 3
            && self.edges.len() == count
            && self.knots.iter().all(|p| p.is_finite())
            && (0..count).all(|i| self.shrinks(i))
    }

    /// Whether it is sound with something to spare: rounded a little, it still is.
    pub(crate) fn is_safe(&self) -> bool {
        let count = self.knots.len();
        self.is_sound() && (0..count).all(|i| self.shrinks_by(i, FITTING_SHARE * CONTRACTION))
    }

    /// Whether an edge is straight, or copies an arc that exists and shrinks it enough.
    pub(crate) fn shrinks(&self, index: usize) -> bool {
        self.shrinks_by(index, CONTRACTION)
    }

    fn shrinks_by(&self, index: usize, most: f64) -> bool {
        let count = self.knots.len();
        let Some(copy) = &self.edges[index] else { return true };
        let exists = copy.span >= 2 && copy.span <= MAX_SPAN && copy.span < count && copy.from < count;
        if !exists || !copy.c.is_finite() {
            return false;
        }
        let (first, last) = self.arc_ends(copy);
        let edge = self.knots[index].distance(self.knot(index + 1));
        edge / self.knots[first].distance(self.knots[last]) * copy.c.abs().max(1.0) <= most
    }
}
