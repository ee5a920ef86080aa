//! What describes and draws shapes of the plane: all that the first picture needs.

mod deform;
mod document;
mod raster;
mod shape;
mod sheet;
mod view;

pub use {deform::*, document::*, raster::*, shape::*, sheet::*};
