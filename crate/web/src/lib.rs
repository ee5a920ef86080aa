//! Frond for JavaScript: the one crate that exports to the web.
//!
//! The functions are plain: objects in, objects out, typed in `api.d.ts`. Maps are rows
//! `[a, b, c, d, e, f]`, an IFS is `{ maps, probabilities? }`. What goes wrong is thrown as an error with a
//! stable `code` and a `message` that says what to do. [`LocusTiles`] and `Renderer` are handles: call
//! `free()` when they are no longer needed.
//!
//! [`LocusTiles`]: crate::LocusTiles
#![allow(clippy::missing_errors_doc)]

mod connect;
mod document;
mod error;
mod locus;
mod path;
mod raster;
#[cfg(target_arch = "wasm32")]
mod renderer;
mod shape;
mod value;

pub use connect::*;
pub use document::*;
pub use locus::*;
pub use path::*;
pub use raster::*;
#[cfg(target_arch = "wasm32")]
pub use renderer::*;
pub use shape::*;

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("api.d.ts");

/// Makes a failure inside the module say where it was, should one ever happen.
#[wasm_bindgen(start)]
pub fn start() {
    #[cfg(target_arch = "wasm32")]
    console_error_panic_hook::set_once();
}
