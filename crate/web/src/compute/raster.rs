//! Pictures without a canvas, where nothing is bent.

use frond_render::rasterize_colours;
use js_sys::{Reflect, Uint8ClampedArray};
use wasm_bindgen::prelude::*;

use crate::boundary::error::bad_input;
use crate::boundary::picture::picture;
use crate::boundary::value::read_ifs;

/// Draws an attractor in the colours of its pieces, complete: RGBA with straight alpha, row 0 on top, on a transparent
/// background. Ready for `new ImageData(pixels, width, height)`.
#[wasm_bindgen(unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
pub fn rasterize(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Omit<RasterOptions, \"bend\"> & { bend?: never }")]
    options: JsValue,
) -> Result<Uint8ClampedArray, JsValue> {
    let ifs = read_ifs(&ifs)?;
    // What draws densities is in the module of what bends.
    if Reflect::get(&options, &"colouring".into()).is_ok_and(|colouring| colouring == "density") {
        return Err(bad_input("The options", "this module draws no density"));
    }
    picture(options, |options| rasterize_colours(&ifs, options))
}
