//! Photographs from JavaScript.

use frond_render::Photo;
use js_sys::{Uint8Array, Uint8ClampedArray};
use wasm_bindgen::{JsCast, JsValue};

use crate::boundary::error::{bad_input, failure};

/// A photograph from its bytes and its size.
pub(crate) fn read_photo(rgba: &JsValue, width: f64, height: f64) -> Result<Photo, JsValue> {
    let bytes = if let Some(bytes) = rgba.dyn_ref::<Uint8Array>() {
        bytes.to_vec()
    } else if let Some(bytes) = rgba.dyn_ref::<Uint8ClampedArray>() {
        bytes.to_vec()
    } else {
        return Err(bad_input("The picture", "an array of bytes is needed"));
    };
    // Casts cut off at 0 and at the largest: what is no size is refused.
    Photo::new(&bytes, width as u32, height as u32).map_err(|error| failure(error.code(), &error.to_string()))
}
