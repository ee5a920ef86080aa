//! What graphics cards draw and decide: in a browser, in a worker where no page is; and natively, where nobody sees it,
//! by the card of this machine (`cargo xtask test card`).
#![cfg(any(target_arch = "wasm32", frond_card))]
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail so")]

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test_configure;

mod card;
#[cfg(feature = "webgpu")]
mod locus;
mod render;
mod sheet;
mod space;
#[cfg(feature = "webgpu")]
mod splats;

#[cfg(target_arch = "wasm32")]
wasm_bindgen_test_configure!(run_in_dedicated_worker);
