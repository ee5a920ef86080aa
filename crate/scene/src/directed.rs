//! Graph-directed shapes: several that are made of copies of each other.

mod document;
mod preset;

pub use document::{Directed, DirectedCopy, DirectedShape, OutlineError};
pub use preset::{DirectedPreset, directed_presets};
