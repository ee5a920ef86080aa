//! Shadows of shapes of space in the plane: exactly, and by a scale that goes to 0.

pub(crate) mod epsilon;
pub(crate) mod parallel;
