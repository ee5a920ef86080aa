//! How far two pieces of the attractor are apart, from both sides.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::outline::Outline;

/// What was found out about one pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Look {
    /// A lower bound of the distance in the plane; not above 0 where the pieces may meet.
    pub apart: f64,
    /// How near their middles are, against what reaches from one to the other: 0 if they coincide, 1 if the
    /// hulls touch.
    pub overlap: f64,
    /// The square of the distance between two points of the attractor, one in each piece.
    pub reach: f64,
    /// These points, in the frame.
    pub from: DVec2,
    pub to: DVec2,
}

/// How lengths and directions are measured.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Gauge {
    metric: DMat2,
    dual: DMat2,
    /// In which metric to look for lines that separate pieces.
    lean: DMat2,
    rounding: f64,
}

impl Gauge {
    /// To tell pieces apart: they are round in the frame, and most easily told apart there, however flat they
    /// are in the plane.
    pub fn to_separate(frame: &Frame) -> Self {
        Self { metric: frame.metric, dual: frame.dual, lean: DMat2::IDENTITY, rounding: frame.rounding }
    }

    /// To measure how far apart they are: distances are those of the plane, and so are the directions that
    /// show them best.
    pub fn to_measure(frame: &Frame) -> Self {
        Self { lean: frame.metric, ..Self::to_separate(frame) }
    }

    /// Bounds the distance of the images of the attractor under two maps of the frame: support functions along the line between their middles, then
    /// along better ones (steps of Frank & Wolfe's algorithm on their difference).
    #[inline]
    pub fn look(&self, outline: &Outline, a: &Affine2, b: &Affine2) -> Look {
        let (at, bt) = (a.linear.transpose(), b.linear.transpose());
        let mut step = b.translation - a.translation;
        let mut best = Look {
            apart: 0.0,
            overlap: f64::INFINITY,
            reach: f64::INFINITY,
            from: DVec2::ZERO,
            to: DVec2::ZERO,
        };
        let middle = step;
        for round in 0..ROUNDS {
            let normal = self.lean * step;
            let (far_a, p) = outline.support(at * normal);
            let (far_b, q) = outline.support(-(bt * normal));
            let along = normal.dot(middle);
            let reach = far_a + far_b;
            let apart = along - reach;
            let (from, to) = (a.apply(p), b.apply(q));
            let between = to - from;
            let squared = between.dot(self.metric * between);
            if squared < best.reach {
                best = Look { reach: squared, from, to, ..best };
            }
            if apart > 0.0 {
                let off = self.rounding * normal.length();
                best.apart = (apart - off) / normal.dot(self.dual * normal).sqrt();
                if best.apart > 0.0 {
                    return best;
                }
            }
            best.overlap = best.overlap.min(along / reach);
            if round + 1 < ROUNDS {
                // The point nearest to the origin between `step` and `between`, both differences of points
                // of the two hulls.
                let turn = step - between;
                let length = turn.dot(self.lean * turn);
                let t = (normal.dot(turn) / length).clamp(0.0, 1.0);
                step -= turn * t;
            }
        }
        best
    }
}

/// Directions tried on a pair.
const ROUNDS: usize = 2;
