//! Pictures without a canvas, where nothing is bent.

use frond_render::rasterize_unbent;
use js_sys::Uint8ClampedArray;
use wasm_bindgen::prelude::*;

use crate::boundary::picture::picture;
use crate::boundary::value::read_ifs;

/// Draws an attractor, complete: RGBA with straight alpha, row 0 on top, on a transparent background. Ready for
/// `new ImageData(pixels, width, height)`.
#[wasm_bindgen(unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
pub fn rasterize(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Omit<RasterOptions, \"bend\"> & { bend?: never }")]
    options: JsValue,
) -> Result<Uint8ClampedArray, JsValue> {
    let ifs = read_ifs(&ifs)?;
    picture(options, |options| rasterize_unbent(&ifs, options))
}
