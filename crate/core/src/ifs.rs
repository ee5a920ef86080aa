//! Iterated function systems, why they have an attractor, and what can be read off their maps.

pub(crate) mod contraction;
pub(crate) mod ellipse;
pub(crate) mod ellipsoid;
pub(crate) mod fractal_dimension;
pub(crate) mod probabilities;
pub(crate) mod symmetry;
pub(crate) mod system;
