//! What a stage draws with, one file for each way.

pub mod cpu;
pub mod deformed;
pub mod density;
pub mod fill;
pub mod image;
pub mod plain;
pub mod points;
#[cfg(feature = "webgpu")]
pub mod splats;
