//! Boxes of parameters, and where their lanes are.

use glam::DVec2;

/// A box of parameters; a segment where `half.y` is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    pub middle: DVec2,
    pub half: DVec2,
}

impl Extent {
    /// Between two corners.
    pub fn between(a: DVec2, b: DVec2) -> Self {
        // Half a digit more, so that rounding leaves no corner outside.
        let half = (b - a).abs() * (0.5 + f64::EPSILON);
        Self { middle: a.midpoint(b), half }
    }

    /// Whether it is of a size that numbers do not overflow for.
    pub fn is_usual(&self) -> bool {
        self.middle.is_finite() && self.half.max_element() < 1e3 && self.half.min_element() >= 0.0
    }

    /// The place of a lane: of six lanes the first three below and the others above, of three all in the middle; each
    /// three from left to right. One lane is a system on its own.
    pub fn place<const L: usize>(&self, lane: usize) -> DVec2 {
        let across = if L == 1 { 0.0 } else { (lane % 3) as f64 - 1.0 };
        let up = if L == 6 { (lane / 3) as f64 * 2.0 - 1.0 } else { 0.0 };
        self.middle + self.half * DVec2::new(across, up)
    }

    /// How far its points are from 0, at least and at most.
    pub fn distances(&self) -> [f64; 2] {
        let middle = self.middle.abs();
        [(middle - self.half).max(DVec2::ZERO).length(), (middle + self.half).length()]
    }
}
