//! Pictures without a canvas.

use frond_core::Colouring;
use frond_render::{RasterOptions, View, rasterize as draw};
use js_sys::Uint8ClampedArray;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::bend::bend_on;
use crate::boundary::error::failure;
use crate::boundary::palette::read_palette;
use crate::boundary::value::{read, read_ifs};
use crate::compute::view::PlainView;

#[derive(Deserialize)]
struct Plain {
    width: f64,
    height: f64,
    view: Option<PlainView>,
    #[serde(default)]
    colouring: Colouring,
    #[serde(default)]
    palette: Vec<String>,
    smooth: Option<bool>,
    exposure: Option<f32>,
}

/// Draws an attractor, complete: RGBA with straight alpha, row 0 on top, on a transparent background. Ready for
/// `new ImageData(pixels, width, height)`.
#[wasm_bindgen(unchecked_return_type = "Uint8ClampedArray")]
pub fn rasterize(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "RasterOptions")] options: JsValue,
) -> Result<Uint8ClampedArray, JsValue> {
    let ifs = read_ifs(&ifs)?;
    let bend = js_sys::Reflect::get(&options, &"bend".into()).ok().filter(|bend| bend.is_object());
    let bend = bend.map(|bend| bend_on(ifs.maps(), &bend)).transpose()?;
    let plain: Plain = read("The options", options)?;
    let palette = read_palette(&plain.palette)?;
    let options = RasterOptions {
        // A cast of NaN or a negative number gives 0: an empty picture.
        width: plain.width as u32,
        height: plain.height as u32,
        view: plain.view.map(View::from),
        colouring: plain.colouring,
        palette: &palette,
        smooth: plain.smooth.unwrap_or(true),
        exposure: plain.exposure.unwrap_or(1.0),
        bend: bend.as_ref(),
    };
    let pixels = draw(&ifs, &options).map_err(|error| failure(error.code(), &error.to_string()))?;
    Ok(Uint8ClampedArray::from(&pixels[..]))
}
