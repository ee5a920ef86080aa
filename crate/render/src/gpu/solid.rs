//! Drawing space: clouds of points while things move, the complete depth buffer when they rest.

mod pipelines;
mod stage;
mod target;

pub use stage::{Drawn3, Stage3, Uniforms3};
