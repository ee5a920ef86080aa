//! The attractor in its frame, and the pieces that it is cut into.

pub mod cut;
pub mod frame;
pub mod letters;
pub mod measure;
