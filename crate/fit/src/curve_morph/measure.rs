//! How curves are measured.

use glam::DVec2;

use super::morphed_curve::MorphedCurve;
use crate::outline::{box_slope_of, crossings};

/// Where boxes are counted, in parts of the box's diagonal: as for outlines.
const BOXES: [f64; 5] = [64.0, 90.5, 128.0, 181.0, 256.0];

/// The parts of the box's diagonal that a polyline is true to which is counted, measured or looked through for
/// crossings.
const POLYLINE_TOLERANCE: f64 = 1.0 / 2000.0;

/// The most points of such a polyline.
const MOST_CORNERS: usize = 1 << 17;

/// The parts of the box's diagonal that a polyline is true to which is looked through for crossings.
const CROSSING_TOLERANCE: f64 = 1.0 / 500.0;

/// The most crossings that are counted.
const MOST_CROSSINGS: usize = 10_000;

impl MorphedCurve {
    /// The box dimension that the curve seems to have between 1/64 and 1/256 of its box's diagonal, and the length of a
    /// polyline that is true to 1/2000 of it.
    #[must_use]
    pub fn dimension_and_length(&self) -> (f64, f64) {
        let diagonal = self.diagonal();
        let points = self.line(POLYLINE_TOLERANCE * diagonal);
        let dimension = if diagonal > 0.0 {
            box_slope_of(&points, true, &BOXES.map(|parts| diagonal / parts))
        } else {
            0.0
        };
        let length = points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a.distance(*b)).sum();
        (dimension, length)
    }

    /// How often its polyline at a five-hundredth of the box crosses itself, 10,000 at most.
    #[must_use]
    pub fn crossings(&self) -> usize {
        // A search that is given up has found more than anybody wants to know.
        crossings(&self.line(CROSSING_TOLERANCE * self.diagonal()), MOST_CROSSINGS)
            .map_or(MOST_CROSSINGS, |list| list.len())
    }

    fn diagonal(&self) -> f64 {
        let [left, bottom, right, top] = self.bounds();
        f64::hypot(right - left, top - bottom)
    }

    fn line(&self, tolerance: f64) -> Vec<DVec2> {
        self.trace(tolerance, None, MOST_CORNERS).into_iter().map(|(_, p)| p).collect()
    }
}
