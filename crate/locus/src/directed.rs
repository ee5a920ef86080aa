//! Graph-directed systems: which of their states are in one piece.

pub(crate) mod certify;
pub(crate) mod connectedness;
pub(crate) mod extent;
pub(crate) mod nearest;
pub(crate) mod sample;
pub(crate) mod shared_points;
pub(crate) mod tied;
