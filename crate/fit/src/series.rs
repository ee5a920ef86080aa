//! A time series or an elevation profile, as it comes.

use glam::DVec2;

use crate::error::MAX_POINTS;
use crate::hough::{Features, HoughError};

/// How far the bell reaches that heights are averaged under, in its widths.
const BELL_WIDTHS: f64 = 3.0;

/// More points than this are averaged in groups before they are smoothed.
const MOST_UNGROUPED: usize = 1 << 13;

/// Measured heights x at moments or places t, in order, each t once.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    points: Vec<DVec2>,
    left_out: usize,
}

impl Series {
    /// Sorts points (t, x), takes the mean of those at the same t, and leaves out what is not finite.
    ///
    /// # Errors
    /// Where fewer than three remain, or more than [`MAX_POINTS`] are given.
    pub fn new(points: &[DVec2]) -> Result<Self, HoughError> {
        if points.len() > MAX_POINTS {
            return Err(HoughError::TooManyPoints { count: points.len() });
        }
        let mut sorted: Vec<_> =
            points.iter().copied().filter(|p| p.x.abs() <= 1e100 && p.y.abs() <= 1e100).collect();
        let left_out = points.len() - sorted.len();
        sorted.sort_by(|p, q| p.x.total_cmp(&q.x));
        let mut points: Vec<DVec2> = Vec::with_capacity(sorted.len());
        let mut from = 0;
        while from < sorted.len() {
            let same = sorted[from..].iter().take_while(|p| p.x == sorted[from].x).count();
            let mean = sorted[from..from + same].iter().map(|p| p.y / same as f64).sum();
            points.push(DVec2::new(sorted[from].x, mean));
            from += same;
        }
        if points.len() < 3 {
            return Err(HoughError::TooFewFeatures { count: points.len() });
        }
        Ok(Self { points, left_out })
    }

    /// The points, from left to right.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// How many were not finite.
    #[must_use]
    pub fn left_out(&self) -> usize {
        self.left_out
    }

    /// `count` feature points at equal distances of t, from 3 to 1025.
    ///
    /// With no `smoothing` they lie on the polyline through the points. With some, each is the mean of what lies around
    /// it, under a bell that is `smoothing` parts of the whole interval wide (its standard deviation; 0.1 is the most):
    /// noise is averaged away, and so is the finest roughness. Both ends keep their place in t.
    ///
    /// # Errors
    /// Where `count` is less than 3 or more than 1025.
    pub fn features(&self, count: usize, smoothing: f64) -> Result<Features, HoughError> {
        let plain = Features::resample(&self.points, count)?;
        // NaN smooths nothing.
        if smoothing.is_nan() || smoothing <= 0.0 {
            return Ok(plain);
        }
        let [start, end] = plain.interval();
        let width = smoothing.min(0.1) * (end - start);
        let dense = grouped(&self.points);
        let smooth: Vec<_> =
            plain.points().iter().map(|p| DVec2::new(p.x, mean(&dense, p.x, width, p.y))).collect();
        Features::new(&smooth)
    }
}

/// At most [`MOST_UNGROUPED`] points: each the mean of its group.
fn grouped(points: &[DVec2]) -> Vec<DVec2> {
    let group = points.len().div_ceil(MOST_UNGROUPED);
    points.chunks(group.max(1)).map(|group| group.iter().sum::<DVec2>() / group.len() as f64).collect()
}

/// The height of the line of least squares under the bell. A plain mean would pull the ends in.
fn mean(points: &[DVec2], t: f64, width: f64, fallback: f64) -> f64 {
    let from = points.partition_point(|p| p.x < t - BELL_WIDTHS * width);
    let until = points.partition_point(|p| p.x <= t + BELL_WIDTHS * width);
    let (mut s, mut x) = ([0.0; 3], [0.0; 2]);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for (index, p) in points.iter().enumerate().take(until).skip(from) {
        // Where points lie densely each stands for little.
        let before = points[index.saturating_sub(1)].x;
        let after = points[(index + 1).min(points.len() - 1)].x;
        let off = (p.x - t) / width;
        let weight = (-0.5 * off * off).exp() * (after - before) / width;
        (low, high) = (low.min(p.y), high.max(p.y));
        s[0] += weight;
        s[1] += weight * off;
        s[2] += weight * off * off;
        x[0] += weight * p.y;
        x[1] += weight * off * p.y;
    }
    if s[0] <= 0.0 {
        return fallback;
    }
    let determinant = s[0] * s[2] - s[1] * s[1];
    // Beside all points a line would lead anywhere.
    let leans = determinant > 1e-6 * s[0] * s[0];
    let height = if leans { (s[2] * x[0] - s[1] * x[1]) / determinant } else { x[0] / s[0] };
    height.clamp(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(count: usize, x: impl Fn(f64) -> f64) -> Series {
        let points: Vec<_> = (0..count)
            .map(|i| i as f64 / (count - 1) as f64)
            .map(|t| DVec2::new(2000.0 + 24.0 * t, x(t)))
            .collect();
        Series::new(&points).unwrap()
    }

    #[test]
    fn points_are_sorted_and_those_at_one_place_are_one() {
        let points = [(3.0, 1.0), (1.0, 2.0), (3.0, 5.0), (f64::NAN, 0.0), (2.0, f64::INFINITY), (0.0, 0.5)];
        let series = Series::new(&points.map(DVec2::from)).unwrap();
        assert_eq!(series.points(), [(0.0, 0.5), (1.0, 2.0), (3.0, 3.0)].map(DVec2::from));
        assert_eq!(series.left_out(), 2);
    }

    #[test]
    fn points_that_are_there_are_hit() {
        let given = series(129, |t| (9.0 * t).sin());
        let features = given.features(65, 0.0).unwrap();
        for (i, p) in features.points().iter().enumerate() {
            assert!((p.y - given.points()[2 * i].y).abs() < 1e-12);
        }
    }

    #[test]
    fn smoothing_takes_noise_away_and_leaves_lines() {
        let line = series(1001, |t| 3.0 * t - 1.0).features(65, 0.02).unwrap();
        let told = |p: &DVec2| (p.y - (3.0 * (p.x - 2000.0) / 24.0 - 1.0)).abs();
        assert!(line.points().iter().map(told).fold(0.0, f64::max) < 1e-9, "up to the ends");
        let zigzag = series(1001, |t| if (t * 1000.0).round() as i64 % 2 == 0 { 1.0 } else { -1.0 });
        let [raw, calm] = [0.0, 0.01].map(|smoothing| zigzag.features(65, smoothing).unwrap());
        let most = |f: &Features| f.points().iter().map(|p| p.y.abs()).fold(0.0, f64::max);
        assert!(most(&raw) > 0.2 && most(&calm) < 0.1, "{} {}", most(&raw), most(&calm));
    }

    #[test]
    fn odd_series_are_told_or_taken() {
        assert_eq!(Series::new(&[]).unwrap_err().code(), "too-few-features");
        assert_eq!(Series::new(&[DVec2::NAN; 9]).unwrap_err().code(), "too-few-features");
        assert_eq!(Series::new(&[DVec2::ONE; 9]).unwrap_err().code(), "too-few-features");
        assert_eq!(Series::new(&vec![DVec2::ZERO; MAX_POINTS + 1]).unwrap_err().code(), "too-many-points");
        // Few points far apart, and a bell that meets none of them.
        let sparse = Series::new(&[(0.0, 1.0), (1.0, 2.0), (100.0, 0.0)].map(DVec2::from)).unwrap();
        for smoothing in [f64::NAN, -1.0, 1e-9, 0.01, 5.0] {
            let features = sparse.features(129, smoothing).unwrap();
            assert!(features.points().iter().all(|p| p.y.is_finite() && p.y.abs() < 10.0), "{smoothing}");
        }
        assert!(sparse.features(2, 0.0).is_err() && sparse.features(2000, 0.0).is_err());
    }
}
