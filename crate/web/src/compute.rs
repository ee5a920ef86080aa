//! What describes and draws shapes of the plane: all that the first picture needs.

mod document;
// With what bends there is one that does both.
#[cfg(not(feature = "bend"))]
mod raster;
mod shape;

#[cfg(not(feature = "bend"))]
pub use raster::*;
pub use {document::*, shape::*};
