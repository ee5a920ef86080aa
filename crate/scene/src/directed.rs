//! Graph-directed shapes: several that are made of copies of each other.

mod document;
mod preset;

pub use document::{Directed, DirectedCopy, DirectedShape};
pub use preset::{DirectedPreset, directed_presets};
