//! Places and parameters that change over time.

pub(crate) mod keyframes;
pub(crate) mod placement;
pub(crate) mod spline;
