//! How far a fit has come.

use crate::closed::ClosedCurve;

/// What a fitter is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// Polygons: the first usable fit, then the best straight one.
    Straight,
    /// The first copies.
    Copies,
    /// Numbers go where they do most.
    Trade,
    /// All numbers together, on all points.
    Polish,
    /// There is nothing more to do.
    Done,
}

impl Stage {
    /// The word for it. What is done was polished last.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Straight => "straight",
            Self::Copies => "copies",
            Self::Trade => "trade",
            Self::Polish | Self::Done => "polish",
        }
    }
}

/// How far a fitter has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// What was done.
    pub stage: Stage,
    /// From 0 to 1; it never falls.
    pub share: f64,
    /// Root mean square distance from the outline's points to the best fit, in percent of the diagonal.
    pub rms: f64,
}

/// The best fit so far.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedFit {
    /// The curve.
    pub curve: ClosedCurve,
    /// The sum of squared distances from the points that are followed.
    pub error: f64,
}
