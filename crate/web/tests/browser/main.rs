//! What the browser gets, in a browser: one program, which is linked, bound and started once.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail so")]

use wasm_bindgen_test::wasm_bindgen_test_configure;

mod card;
mod js;
mod locus;
mod render;
mod sheet;
mod space;

wasm_bindgen_test_configure!(run_in_browser);
