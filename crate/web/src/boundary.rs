//! What crosses the boundary to JavaScript, and how: values, shapes and errors, read and written once for all modules.

#[cfg(any(feature = "bend", feature = "curve", feature = "webgpu", feature = "webgl2"))]
pub(crate) mod bend;
pub(crate) mod error;
#[cfg(any(feature = "exact", feature = "proof"))]
pub(crate) mod evidence;
#[cfg(any(feature = "directed", feature = "proof", feature = "space", feature = "webgpu"))]
pub(crate) mod grid;
pub(crate) mod palette;
#[cfg(any(feature = "proof", feature = "space"))]
pub(crate) mod path;
#[cfg(any(feature = "bend", feature = "webgpu", feature = "webgl2"))]
pub(crate) mod photo;
#[cfg(any(feature = "compute", feature = "bend"))]
pub(crate) mod picture;
#[cfg(any(feature = "compute", feature = "proof"))]
pub(crate) mod polygon;
#[cfg(any(feature = "exact", feature = "proof", feature = "space"))]
pub(crate) mod resolution;
#[cfg(feature = "space")]
pub(crate) mod space;
pub(crate) mod value;
