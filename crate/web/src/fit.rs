//! From an outline to its formula: what the workers of the fit do.

mod collage;
mod curve;
mod hough;
mod once;
mod outline;
mod trace;
mod within;

pub use collage::*;
pub use curve::*;
pub use hough::*;
pub use once::*;
pub use trace::*;
pub use within::*;
