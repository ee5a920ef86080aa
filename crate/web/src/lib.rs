//! Frond for JavaScript: the one crate that exports to the web.
//!
//! The functions are plain: objects in, objects out, typed in `api.d.ts`. Maps are rows
//! `[a, b, c, d, e, f]`, an IFS is `{ maps, probabilities? }`. What goes wrong is thrown as an error with a
//! stable `code` and a `message` that says what to do. [`LocusTiles`] and `Renderer` are handles: call
//! `free()` when they are no longer needed.
//!
//! [`LocusTiles`]: crate::LocusTiles
#![allow(clippy::missing_errors_doc)]
#![cfg_attr(not(feature = "compute"), expect(dead_code, reason = "a renderer alone needs few conversions"))]

#[cfg(any(feature = "compute", feature = "webgpu", feature = "webgl2"))]
mod bend;
#[cfg(all(target_arch = "wasm32", feature = "webgpu"))]
mod card;
#[cfg(feature = "compute")]
mod certify;
#[cfg(feature = "compute")]
mod connect;
#[cfg(feature = "compute")]
mod deform;
#[cfg(feature = "compute")]
mod document;
mod error;
#[cfg(feature = "compute")]
mod family;
#[cfg(feature = "compute")]
mod locus;
mod look;
#[cfg(feature = "compute")]
mod path;
#[cfg(any(feature = "compute", feature = "webgpu", feature = "webgl2"))]
mod photo;
#[cfg(feature = "compute")]
mod proof;
#[cfg(feature = "compute")]
mod raster;
#[cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl2")))]
mod renderer;
#[cfg(feature = "compute")]
mod routes;
#[cfg(feature = "compute")]
mod settle;
#[cfg(feature = "compute")]
mod shape;
#[cfg(feature = "compute")]
mod sheet;
mod value;

#[cfg(feature = "compute")]
pub use {
    certify::*, connect::*, deform::*, document::*, family::*, locus::*, path::*, proof::*, raster::*,
    routes::*, shape::*, sheet::*,
};

#[cfg(all(target_arch = "wasm32", feature = "webgpu"))]
pub use card::*;
#[cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl2")))]
pub use renderer::*;
#[cfg(feature = "compute")]
pub use settle::*;

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("api.d.ts");

/// Makes a failure inside the module say where it was, should one ever happen.
#[wasm_bindgen(start)]
pub fn start() {
    #[cfg(target_arch = "wasm32")]
    console_error_panic_hook::set_once();
}
