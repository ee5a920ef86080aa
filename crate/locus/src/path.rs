//! Paths through the parameters of a morph on which the shape stays in one piece.

pub(crate) mod check;
pub(crate) mod distance_transform;
pub(crate) mod end_lines;
pub(crate) mod field;
pub(crate) mod plan;
pub(crate) mod rate;
pub(crate) mod repair;
pub(crate) mod search;
pub(crate) mod simplify;
pub(crate) mod volume;
