//! From an outline to its formula: what the workers of the fit do.

mod curve;
mod hough;
mod once;
mod trace;

pub use curve::*;
pub use hough::*;
pub use once::*;
pub use trace::*;

use glam::DVec2;
use wasm_bindgen::JsValue;

use crate::boundary::error::failure;

/// Points from a flat list x0, y0, x1, y1, ..
pub(crate) fn points(list: &[f64]) -> Result<Vec<DVec2>, JsValue> {
    if !list.len().is_multiple_of(2) {
        return Err(failure("bad-input", "A list of points holds two numbers for each point."));
    }
    Ok(list.chunks_exact(2).map(DVec2::from_slice).collect())
}
