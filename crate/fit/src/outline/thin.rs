//! Fewer points for an outline of very many.

use glam::DVec2;

/// The most points of an outline.
pub const MAX_OUTLINE: usize = 100_000;

/// Every so many-th of a closed line's points, `most` at the most.
pub(crate) fn thinned(points: &[DVec2], most: usize) -> Vec<DVec2> {
    let count = points.len();
    if count <= most {
        return points.to_vec();
    }
    (0..most).map(|k| points[(k as u128 * count as u128 / most as u128) as usize]).collect()
}
