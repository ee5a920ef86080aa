//! Affine maps and the factors of their matrices.

pub(crate) mod affine2;
pub(crate) mod affine3;
pub(crate) mod polar2;
pub(crate) mod polar3;
pub(crate) mod svd3;
pub(crate) mod transform;
