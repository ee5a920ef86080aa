//! What graphics cards draw and decide, in a browser: in a worker, where no page is.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail so")]

use wasm_bindgen_test::wasm_bindgen_test_configure;

mod card;
#[cfg(feature = "webgpu")]
mod locus;
mod render;
mod sheet;
mod space;

wasm_bindgen_test_configure!(run_in_dedicated_worker);
