//! Pictures without a canvas.

use frond_core::Colouring;
use frond_render::{RasterOptions, RenderError, View};
use js_sys::Uint8ClampedArray;
use serde::Deserialize;
use wasm_bindgen::JsValue;

use super::error::failure;
use super::palette::read_palette;
use super::value::read;

/// Which part of the plane a picture shows.
#[derive(Deserialize)]
pub(crate) struct PlainView {
    x: f64,
    y: f64,
    scale: f64,
}

impl From<PlainView> for View {
    fn from(PlainView { x, y, scale }: PlainView) -> Self {
        Self { x, y, scale }
    }
}

/// `RasterOptions` of `api.d.ts`, but for what bends.
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
    #[serde(rename = "lightGround")]
    light_ground: Option<bool>,
    #[serde(default)]
    draft: bool,
}

/// The picture that `draw` makes with these options.
pub(crate) fn picture(
    options: JsValue,
    draw: impl FnOnce(&RasterOptions<'_>) -> Result<Vec<u8>, RenderError>,
) -> Result<Uint8ClampedArray, JsValue> {
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
        light_ground: plain.light_ground,
        draft: plain.draft,
        bend: None,
    };
    let pixels = draw(&options).map_err(|error| failure(error.code(), &error.to_string()))?;
    Ok(Uint8ClampedArray::from(&pixels[..]))
}
