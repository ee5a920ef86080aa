//! Errors as JavaScript sees them.

use frond_core::{IfsError, MorphError};
use js_sys::{Error, Reflect};
use wasm_bindgen::JsValue;

/// An error object with a stable `code` and a `message` that says what to do.
pub(crate) fn failure(code: &str, message: &str) -> JsValue {
    let error = Error::new(message);
    error.set_name("FrondError");
    // Setting a property of a fresh object cannot fail.
    let _ = Reflect::set(&error, &"code".into(), &code.into());
    error.into()
}

/// A value of the wrong form: a wrong type, a missing field.
pub(crate) fn bad_input(what: &str, why: &str) -> JsValue {
    failure("bad-input", &format!("{what} cannot be read: {why}."))
}

pub(crate) fn of_ifs(error: &IfsError) -> JsValue {
    failure(error.code(), &error.to_string())
}

pub(crate) fn of_morph(error: &MorphError) -> JsValue {
    failure(error.code(), &error.to_string())
}
