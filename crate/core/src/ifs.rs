//! Iterated function systems, why they have an attractor, and what can be read off their maps.

pub(crate) mod address;
pub(crate) mod contraction2;
pub(crate) mod contraction3;
pub(crate) mod fractal_dimension2;
pub(crate) mod fractal_dimension3;
pub(crate) mod ifs2;
pub(crate) mod ifs3;
pub(crate) mod symmetry;
