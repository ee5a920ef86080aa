//! What is known of one parameter, with bounds that are proved.

use glam::{DMat2, DVec2};

use crate::decide::{Sample, State};

/// An ellipse that holds the attractor, and whose shape the maps shrink.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Its centre, in the plane.
    pub centre: DVec2,
    /// Takes differences of points of the plane to coordinates where the ellipse is the unit disc: the
    /// attractor lies where `|to_round (x - centre)| <= 1`.
    pub to_round: DMat2,
    /// Its inverse.
    pub from_round: DMat2,
    /// In these coordinates every block shrinks distances by this factor or less.
    pub factor: f64,
    /// The letters of the longest block: 1 where the blocks are the maps themselves.
    pub length: usize,
}

/// The answer of [`decide_bounds`](crate::decide_bounds).
///
/// With `g` the widest gap (the widest edge of the least spanning tree of the distances between pieces,
/// in the plane), `lower * diameter <= g <= upper * diameter`, rounding reckoned with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// What [`decide`](crate::decide) says.
    pub sample: Sample,
    /// A lower bound of the widest gap over `diameter`: above 0 only where the attractor is proved disconnected.
    pub lower: f64,
    /// An upper bound of the widest gap over `diameter`, shown by points of the attractor; 0 where it is
    /// proved connected. Infinite where nothing is known.
    pub upper: f64,
    /// An upper bound of the diameter of the attractor, in units of the plane: 0 if it is one point, NaN
    /// where it is not known to exist.
    pub diameter: f64,
    /// Where the attractor lies and how fast it contracts; `None` where it is not known to exist, or so small, below 1e-300,
    /// that no double holds the inverse of its size.
    pub ellipse: Option<Ellipse>,
}

impl Bounded {
    /// The answer where it is not known whether there is an attractor, or known that there is none.
    pub(crate) const fn unknown(state: State) -> Self {
        let sample = Sample { state, gap: f32::NAN };
        Self { sample, lower: 0.0, upper: f64::INFINITY, diameter: f64::NAN, ellipse: None }
    }
}
