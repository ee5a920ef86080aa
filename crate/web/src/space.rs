//! Space: what its tool and its workers compute.

mod document;
mod intersection;
mod mesh;
mod morph;
mod picture;
mod plane;
mod shape;

pub use document::*;
pub use intersection::*;
pub use mesh::*;
pub use morph::*;
pub use picture::*;
pub use plane::*;
pub use shape::*;
