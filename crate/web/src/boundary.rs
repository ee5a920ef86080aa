//! What crosses the boundary to JavaScript, and how: values, shapes and errors, read and written once for all modules.

#[cfg(any(feature = "compute", feature = "curve", feature = "webgpu", feature = "webgl2"))]
pub(crate) mod bend;
pub(crate) mod error;
pub(crate) mod look;
#[cfg(any(feature = "compute", feature = "curve", feature = "webgpu", feature = "webgl2"))]
pub(crate) mod photo;
#[cfg(any(feature = "compute", feature = "proof"))]
pub(crate) mod polygon;
pub(crate) mod value;
