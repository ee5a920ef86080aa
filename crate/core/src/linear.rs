//! Affine maps, and the factors of their matrices.

pub(crate) mod affine;
mod affine2;
mod affine3;
pub(crate) mod polar2;
pub(crate) mod polar3;
mod sin_cos;
pub(crate) mod svd2;
pub(crate) mod svd3;
pub(crate) mod transform;
