//! What bends: the grid of Fujimoto et al. as functions, and what it bends, drawn without a canvas.

mod deform;
mod raster;
mod sheet;

pub use {deform::*, raster::*, sheet::*};
