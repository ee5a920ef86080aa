//! Pictures without a canvas, bent or not.

use frond_render::rasterize_bent;
use js_sys::{Reflect, Uint8ClampedArray};
use wasm_bindgen::prelude::*;

use crate::boundary::bend::with_bend;
use crate::boundary::picture::picture;
use crate::boundary::value::read_ifs;

/// Draws an attractor, complete: RGBA with straight alpha, row 0 on top, on a transparent background. Ready for
/// `new ImageData(pixels, width, height)`.
#[wasm_bindgen(unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
pub fn rasterize(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "RasterOptions")] options: JsValue,
) -> Result<Uint8ClampedArray, JsValue> {
    let ifs = read_ifs(&ifs)?;
    match Reflect::get(&options, &"bend".into()).ok().filter(JsValue::is_object) {
        Some(bend) => with_bend(ifs.maps(), &bend, |bend| {
            picture(options, |options| rasterize_bent(&ifs, bend, options))
        }),
        #[cfg(feature = "compute")]
        None => picture(options, |options| frond_render::rasterize_unbent(&ifs, options)),
        // What draws the colours of pieces at rest is in the other module.
        #[cfg(not(feature = "compute"))]
        None => picture(options, |options| frond_render::rasterize_density(&ifs, options)),
    }
}
