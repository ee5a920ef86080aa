//! Systems of affine maps with exact numbers.

pub(crate) mod build;
pub(crate) mod frame;
pub(crate) mod numbers;
pub(crate) mod projected;
pub(crate) mod real;
pub(crate) mod sizes;
pub(crate) mod space;
