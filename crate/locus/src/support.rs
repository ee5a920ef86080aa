//! Support functions: how far the attractor reaches in a direction, bounded from above in a table of directions.

pub(crate) mod f64x4;
pub(crate) mod lanes;
pub(crate) mod table;
pub(crate) mod trapping_polygon;
