//! Pieces, and pairs of them.

use std::cmp::Ordering;

use frond_core::Affine2;
use glam::DVec2;

/// One piece: the image of the attractor under the map of a word.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    /// The map of the word, in the frame; its translation is the middle of the piece.
    pub map: Affine2,
    /// Half the squared Frobenius norm of the map into the plane: the mean square of its stretches.
    pub size: f64,
    /// The index of its first part, 0 while it is not split.
    pub parts: u32,
}

/// A pair of pieces in two attractorlets `i < j`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    /// What it is ordered by: how deep the two overlap, or their distance.
    pub key: f64,
    pub u: u32,
    pub v: u32,
    pub i: u8,
    pub j: u8,
}

impl PartialEq for Pair {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Pair {}
impl PartialOrd for Pair {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Pair {
    /// Reversed, since the heap gives the greatest first; ties go by the pieces, so that nothing
    /// depends on how the heap is built.
    fn cmp(&self, other: &Self) -> Ordering {
        other.key.total_cmp(&self.key).then_with(|| (other.u, other.v).cmp(&(self.u, self.v)))
    }
}

/// The nearest two points known of a pair of attractorlets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearest {
    /// Their squared distance in the plane.
    pub reach: f64,
    pub from: DVec2,
    pub to: DVec2,
    /// Whether the two were found to meet.
    pub met: bool,
}
