//! Which pixels a piece of the attractor reaches into: all of them, on the processor.

pub mod canvas;
pub mod complete;
pub mod flood;
pub mod probe;
pub mod sweep;
