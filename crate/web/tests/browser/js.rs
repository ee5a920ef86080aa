//! Values of JavaScript, asked.

use js_sys::Reflect;
use wasm_bindgen::JsValue;

pub fn get(value: &JsValue, key: &str) -> JsValue {
    Reflect::get(value, &key.into()).unwrap()
}
