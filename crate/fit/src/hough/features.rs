//! Feature points of a graph.

use glam::DVec2;

use super::error::HoughError;
use crate::fractal::function::FractalFunction;

/// The most feature points that are taken.
pub const MAX_FEATURES: usize = 1025;

/// Points (t, x) of a graph, from left to right.
#[derive(Clone, Debug, PartialEq)]
pub struct Features {
    points: Vec<DVec2>,
    step: Option<f64>,
}

impl Features {
    /// Feature points as they are. Counting is fastest where they are at equal distances of t.
    ///
    /// # Errors
    /// Where there are fewer than 3 or more than [`MAX_FEATURES`], t does not increase, or a number is not finite.
    pub fn new(points: &[DVec2]) -> Result<Self, HoughError> {
        let count = points.len();
        if count > MAX_FEATURES {
            return Err(HoughError::TooManyFeatures { count });
        }
        Self::checked(points)
    }

    fn checked(points: &[DVec2]) -> Result<Self, HoughError> {
        let count = points.len();
        if count < 3 {
            return Err(HoughError::TooFewFeatures { count });
        }
        if let Some(index) = points.iter().position(|p| !(p.x.abs() <= 1e100 && p.y.abs() <= 1e100)) {
            return Err(HoughError::NotFinite { index });
        }
        if let Some(index) = (1..count).find(|&i| points[i].x <= points[i - 1].x) {
            return Err(HoughError::NotIncreasing { index });
        }
        let (start, end) = (points[0].x, points[count - 1].x);
        let step = (end - start) / (count - 1) as f64;
        let even = |(i, p): (usize, &DVec2)| (p.x - start - step * i as f64).abs() <= 1e-6 * step;
        let step = points.iter().enumerate().all(even).then_some(step);
        Ok(Self { points: points.to_vec(), step })
    }

    /// `count` points of a function at equal distances of t.
    ///
    /// # Errors
    /// Where `count` is less than 3 or more than [`MAX_FEATURES`].
    pub fn sample(function: &FractalFunction, count: usize) -> Result<Self, HoughError> {
        let [start, end] = function.curve().interval();
        Self::spaced([start, end], count, |t| function.at(t))
    }

    /// `count` points at equal distances of t of the polyline through any number of points: a time series or a profile.
    ///
    /// # Errors
    /// As [`new`](Self::new), but for the number of points given.
    pub fn resample(points: &[DVec2], count: usize) -> Result<Self, HoughError> {
        let given = Self::checked(points)?;
        Self::spaced(given.interval(), count, |t| given.at(t))
    }

    fn spaced([start, end]: [f64; 2], count: usize, at: impl Fn(f64) -> f64) -> Result<Self, HoughError> {
        if count > MAX_FEATURES {
            return Err(HoughError::TooManyFeatures { count });
        }
        let t = |i: usize| start + (end - start) * i as f64 / (count - 1) as f64;
        let points: Vec<_> = (0..count).map(|i| DVec2::new(t(i), at(t(i)))).collect();
        Self::new(&points)
    }

    /// The points.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Whether they are at equal distances of t.
    #[must_use]
    pub fn is_even(&self) -> bool {
        self.step.is_some()
    }

    /// The first and the last t.
    #[must_use]
    pub fn interval(&self) -> [f64; 2] {
        [self.points[0].x, self.points[self.points.len() - 1].x]
    }

    /// The least and the largest x.
    #[must_use]
    pub fn heights(&self) -> [f64; 2] {
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        self.points.iter().fold(start, |[low, high], p| [low.min(p.y), high.max(p.y)])
    }

    /// The height of the polyline through the points.
    #[must_use]
    pub fn at(&self, t: f64) -> f64 {
        let after = self.points.partition_point(|p| p.x <= t).clamp(1, self.points.len() - 1);
        let (a, b) = (self.points[after - 1], self.points[after]);
        let share = ((t - a.x) / (b.x - a.x)).clamp(0.0, 1.0);
        a.y + share * (b.y - a.y)
    }

    /// Index of the point nearest to `t`, the first of two that are as near.
    #[must_use]
    pub fn nearest(&self, t: f64) -> usize {
        let after = self.points.partition_point(|p| p.x < t).min(self.points.len() - 1);
        let Some(before) = after.checked_sub(1) else { return after };
        let (low, high) = (self.points[before].x, self.points[after].x);
        // As near to rounding is as near.
        if t - low <= high - t + 1e-9 * (high - low) { before } else { after }
    }
}
