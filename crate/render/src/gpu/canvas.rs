//! What is drawn on.

#[cfg(target_arch = "wasm32")]
use web_sys::{HtmlCanvasElement, OffscreenCanvas};

/// What is drawn on.
#[derive(Clone, Debug)]
pub enum Canvas {
    /// A canvas of the page.
    #[cfg(target_arch = "wasm32")]
    Html(HtmlCanvasElement),
    /// One without a page, as in a worker.
    #[cfg(target_arch = "wasm32")]
    Offscreen(OffscreenCanvas),
    /// A texture, where there is no browser.
    #[cfg(not(target_arch = "wasm32"))]
    Texture,
}
