//! Values of JavaScript, made and asked.

use js_sys::{JSON, Reflect};
use wasm_bindgen::JsValue;

pub fn json(text: &str) -> JsValue {
    JSON::parse(text).unwrap()
}

pub fn get(value: &JsValue, key: &str) -> JsValue {
    Reflect::get(value, &key.into()).unwrap()
}

pub fn text(value: &JsValue, key: &str) -> String {
    get(value, key).as_string().unwrap()
}

/// The code of an error, whose message has to help.
pub fn code<T>(result: Result<T, JsValue>) -> String {
    let error = result.err().unwrap();
    assert!(text(&error, "message").len() > 20, "a message says what to do");
    text(&error, "code")
}

/// A shape of the gallery of the plane.
pub fn maps_of(id: &str) -> JsValue {
    let all = js_sys::Array::from(&frond_web::presets().unwrap());
    all.find(&mut |preset, _, _| text(&preset, "id") == id)
}
