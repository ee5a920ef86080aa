//! How curves are measured.

use frond_fit::{MorphedCurve, box_slope_of};
use glam::DVec2;

/// Where boxes are counted, in parts of the box's diagonal: as for outlines.
const BOXES: [f64; 5] = [64.0, 90.5, 128.0, 181.0, 256.0];

/// The parts of the box's diagonal that a polyline is true to which is counted, measured or looked through for crossings.
pub(super) const POLYLINE_TOLERANCE: f64 = 1.0 / 2000.0;

/// The most points of such a polyline.
pub(super) const MOST_CORNERS: usize = 1 << 17;

/// The box dimension that a closed polyline seems to have between 1/64 and 1/256 of its box's diagonal.
pub(super) fn dimension(points: &[DVec2], diagonal: f64) -> f64 {
    if diagonal > 0.0 { box_slope_of(points, true, &BOXES.map(|parts| diagonal / parts)) } else { 0.0 }
}

/// The diagonal of the box around a curve.
pub(super) fn diagonal(woven: &MorphedCurve) -> f64 {
    let [left, bottom, right, top] = woven.bounds();
    f64::hypot(right - left, top - bottom)
}
