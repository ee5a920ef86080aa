//! Support functions: how far the attractor reaches in a direction, `h(d) = max { d . x : x in A }`, bounded from above
//! in a table of directions. The convex hull that the values enclose holds the attractor, and so its images hold the
//! pieces.

pub(crate) mod extremes;
pub(crate) mod f64x4;
pub(crate) mod lanes;
pub(crate) mod table;
pub(crate) mod trapping_polygon;
