//! The arrows of a graph-directed system.

use crate::linear::affine::Affine2;

/// A map of a graph-directed system: an arrow from the state that it copies into the one that it is a part of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectedMap {
    /// The state that is copied, from 0.
    pub from: usize,
    /// Where the copy lies.
    pub map: Affine2,
}
