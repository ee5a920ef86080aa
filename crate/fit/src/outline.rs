//! Outlines: closed polylines that are to be fitted.

mod boxes;
mod corners;
mod crossing;
mod decimate;
mod features;
mod fidelity;
mod guard;
mod near;
mod prepare;
mod thin;

pub use boxes::{box_slope, box_slope_of};
pub(crate) use corners::corners;
pub(crate) use crossing::turn;
pub use crossing::{contacts, crossings};
pub use decimate::decimated;
pub use features::features;
pub(crate) use fidelity::Gauge;
pub use fidelity::{Fidelity, fidelity};
pub use guard::Guard;
pub(crate) use near::to_side;
pub use near::{Near, Nearest};
pub use prepare::MAX_PREPARED;
pub use thin::MAX_OUTLINE;
pub(crate) use thin::thinned;

use glam::DVec2;
use thiserror::Error;

use crate::error::MAX_POINTS;

/// Why points make no outline.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum OutlineError {
    /// Fewer than three points that differ.
    #[error("The outline has {count} points that differ, and it needs three or more. Add some.")]
    TooFewPoints {
        /// How many differ.
        count: usize,
    },
    /// More than 1048576 points.
    #[error("The outline has {count} points, and the most is 1048576. Take every second one, or fewer.")]
    TooManyPoints {
        /// How many there are.
        count: usize,
    },
    /// A coordinate is NaN, infinite or beyond 1e100.
    #[error("Point {} is not finite or is too large. Mend it or leave it out.", .index + 1)]
    NotFinite {
        /// Index of the point, from 0.
        index: usize,
    },
    /// The points lie on one straight line.
    #[error("The outline encloses no area: its points lie on a straight line. Choose another contour.")]
    Flat,
}

impl OutlineError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooFewPoints { .. } => "too-few-points",
            Self::TooManyPoints { .. } => "too-many-points",
            Self::NotFinite { .. } => "not-finite",
            Self::Flat => "flat",
        }
    }
}

/// A closed polyline, counter-clockwise where it does not cross itself; the closing point is not repeated.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    points: Vec<DVec2>,
}

impl Outline {
    /// Cleans points and makes an outline of them: repeated points and a repeated closing point are dropped, a
    /// clockwise one is turned round.
    ///
    /// # Errors
    /// Where fewer than three points differ, there are too many, one is not finite, or all lie on a line.
    pub fn new(points: &[DVec2]) -> Result<Self, OutlineError> {
        if points.len() > MAX_POINTS {
            return Err(OutlineError::TooManyPoints { count: points.len() });
        }
        if let Some(index) = points.iter().position(|p| !(p.x.abs() <= 1e100 && p.y.abs() <= 1e100)) {
            return Err(OutlineError::NotFinite { index });
        }
        let mut kept = points.to_vec();
        kept.dedup();
        while kept.len() > 1 && kept.first() == kept.last() {
            kept.pop();
        }
        if kept.len() < 3 {
            return Err(OutlineError::TooFewPoints { count: kept.len() });
        }
        // Seen from a point of it and in its own size: far from the origin, areas would drown in rounding.
        let (low, high) = bounds(&kept);
        let size = (high - low).length();
        let first = kept[0];
        let direction = kept
            .iter()
            .map(|&p| p - first)
            .max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))
            .unwrap_or_default()
            .normalize_or_zero();
        if kept.iter().all(|&p| direction.perp_dot(p - first).abs() <= 1e-12 * size) {
            return Err(OutlineError::Flat);
        }
        let mut outline = Self { points: kept };
        if outline.area() < 0.0 {
            outline.points.reverse();
        }
        Ok(outline)
    }

    /// Its points, in order.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The lower left and the upper right corner of its box.
    #[must_use]
    pub fn bounds(&self) -> (DVec2, DVec2) {
        bounds(&self.points)
    }

    /// The diagonal of its box: the unit of all errors.
    #[must_use]
    pub fn diagonal(&self) -> f64 {
        let (low, high) = self.bounds();
        low.distance(high)
    }

    /// The length all round.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.lengths().last().copied().unwrap_or(0.0)
    }

    /// The arc length at each point, and the whole at the end: one more than there are points.
    #[must_use]
    pub fn lengths(&self) -> Vec<f64> {
        let mut sum = 0.0;
        let sides = (0..self.points.len()).map(|i| self.points[i].distance(self.points[self.after(i)]));
        let mut lengths = vec![0.0];
        lengths.extend(sides.map(|side| {
            sum += side;
            sum
        }));
        lengths
    }

    /// The area inside; positive, unless it crosses itself.
    #[must_use]
    pub fn area(&self) -> f64 {
        let first = self.points[0];
        let twice = |i: usize| (self.points[i] - first).perp_dot(self.points[self.after(i)] - first);
        0.5 * (0..self.points.len()).map(twice).sum::<f64>()
    }

    fn after(&self, i: usize) -> usize {
        if i + 1 == self.points.len() { 0 } else { i + 1 }
    }

    /// The same outline with `count` points (3 or more, else 3) at equal distances along it.
    #[must_use]
    pub fn resampled(&self, count: usize) -> Self {
        let count = count.clamp(3, MAX_POINTS);
        let lengths = self.lengths();
        let whole = lengths[self.points.len()];
        let mut side = 0;
        let point = |i: usize| {
            let at = whole * i as f64 / count as f64;
            while side + 1 < self.points.len() && lengths[side + 1] <= at {
                side += 1;
            }
            let long = lengths[side + 1] - lengths[side];
            let share = if long > 0.0 { ((at - lengths[side]) / long).clamp(0.0, 1.0) } else { 0.0 };
            self.points[side].lerp(self.points[self.after(side)], share)
        };
        Self { points: (0..count).map(point).collect() }
    }

    /// The same outline with at least `least` points: corners stay, and sides are parted evenly, the longest
    /// into most.
    #[must_use]
    pub fn subdivided(&self, least: usize) -> Self {
        let missing = least.min(MAX_POINTS).saturating_sub(self.points.len()) as f64;
        let whole = self.length();
        let mut points = Vec::with_capacity(self.points.len() + missing as usize);
        for (i, &from) in self.points.iter().enumerate() {
            let to = self.points[self.after(i)];
            let parts = 1 + (missing * from.distance(to) / whole).ceil() as usize;
            points.extend((0..parts).map(|k| from.lerp(to, k as f64 / parts as f64)));
        }
        Self { points }
    }

    /// A smoother outline of as many points at equal distances: averaged along itself with a bell of standard deviation
    /// `width` (in plane units; 0, negative or NaN does nothing, and it is held to a tenth of the length).
    #[must_use]
    pub fn smoothed(&self, width: f64) -> Self {
        let whole = self.length();
        if width.is_nan() || width <= 0.0 {
            return self.clone();
        }
        let width = width.min(0.1 * whole);
        let even = self.resampled(self.points.len());
        let count = even.points.len();
        let step = whole / count as f64;
        // Three running means are a bell as near as can be seen, and cost the same whatever the width.
        let radius = (((4.0 * (width / step).powi(2) + 1.0).sqrt() - 1.0) / 2.0).round() as usize;
        let radius = radius.min((count - 1) / 2);
        let mut points = even.points;
        for _ in 0..3 {
            points = running_mean(&points, radius);
        }
        Self { points }
    }
}

fn running_mean(points: &[DVec2], radius: usize) -> Vec<DVec2> {
    let count = points.len();
    let at = |i: usize| points[i % count];
    let mut sum: DVec2 = (0..=2 * radius).map(at).sum();
    let mut means = vec![DVec2::ZERO; count];
    for i in 0..count {
        means[(i + radius) % count] = sum / (2 * radius + 1) as f64;
        sum += at(i + 2 * radius + 1) - at(i);
    }
    means
}

pub(crate) fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let start = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    points.iter().fold(start, |(low, high), &p| (low.min(p), high.max(p)))
}
