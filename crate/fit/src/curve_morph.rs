//! The morph of two closed curves: one structure for both, and a fractal curve between them at every moment.

mod dtw;
mod file;
mod knot_ring;
mod matching;
mod measure;
mod morphed_curve;
mod origin;
mod polyline;

pub use file::MAX_FILE_POINTS;
pub use morphed_curve::MorphedCurve;

use thiserror::Error;

use crate::closed::{ClosedCurve, MAX_KNOTS};
use knot_ring::Ring;

/// Why two curves are not brought together.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum MorphError {
    /// A curve is not [sound](ClosedCurve::is_sound).
    #[error(
        "The curve does not hold together: a knot or an arc is missing, or a copy does not shrink. Fit the outline again."
    )]
    Unsound,
    /// A curve has more than [`MAX_KNOTS`] knots.
    #[error("The curve has {knots} knots, and the most is 4096. Fit the outline with fewer numbers.")]
    TooManyKnots {
        /// How many there are.
        knots: usize,
    },
}

impl MorphError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Unsound => "unsound",
            Self::TooManyKnots { .. } => "too-many-knots",
        }
    }
}

/// Two closed curves with knots in common, or one alone.
///
/// Each curve gets further knots, without changing, until both have as many, and each has its partner. At s an edge is
/// the chord between blended knots, plus 1 - s times what the first curve's edge copies of the residual (curve less
/// chord) of an arc, plus s times what the second's copies, both of the curve at s itself. So it is a fractal curve
/// with two copies an edge: closed and without gaps at every s, the first curve at 0, the second at 1.
#[derive(Clone, Debug)]
pub struct CurveMorph {
    rings: [Ring; 2],
    /// Where knots are, by the length of chords, from 0 to 1; one more than there are knots.
    places: [Vec<f64>; 2],
}

impl CurveMorph {
    /// Brings two curves to one structure; without a second curve there is the first at every s.
    ///
    /// Both are taken counter-clockwise. What is matched is where points lie, seen from the middle and in the size of
    /// each curve, and which way the curves run there.
    ///
    /// # Errors
    /// Where a curve is not sound or has more than [`MAX_KNOTS`] knots.
    pub fn new(a: &ClosedCurve, b: Option<&ClosedCurve>) -> Result<Self, MorphError> {
        for curve in [Some(a), b].into_iter().flatten() {
            if curve.knots.len() > MAX_KNOTS {
                return Err(MorphError::TooManyKnots { knots: curve.knots.len() });
            }
            if !curve.is_sound() {
                return Err(MorphError::Unsound);
            }
        }
        let first = Ring::new(a);
        let rings = match b {
            Some(b) if a != b => {
                let last = Ring::new(b);
                // From whichever end, the search begins with the same curve: swapped, a morph runs backwards.
                if last.numbers().lt(first.numbers()) {
                    let [last, first] = matching::share(last, first);
                    [first, last]
                } else {
                    matching::share(first, last)
                }
            }
            _ => [first.clone(), first],
        };
        let places = [rings[0].places(), rings[1].places()];
        Ok(Self { rings, places })
    }

    /// The curve at s, held to 0 to 1; the first where s is NaN.
    #[must_use]
    pub fn at(&self, s: f64) -> MorphedCurve {
        MorphedCurve::new(&self.rings, &self.places, if s.is_nan() { 0.0 } else { s.clamp(0.0, 1.0) })
    }

    /// How many knots the curve has between its ends.
    #[must_use]
    pub fn knots(&self) -> usize {
        self.rings[0].knots.len()
    }
}
