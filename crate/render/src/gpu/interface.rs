//! The interface to the graphics card that this is compiled for. Both have the same words.

#[cfg(not(feature = "webgpu"))]
pub use super::webgl2::*;
#[cfg(feature = "webgpu")]
pub use super::webgpu::*;
