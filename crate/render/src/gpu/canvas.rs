//! What is drawn on.

use web_sys::{HtmlCanvasElement, OffscreenCanvas};

/// What is drawn on.
#[derive(Clone, Debug)]
pub enum Canvas {
    /// A canvas of the page.
    Html(HtmlCanvasElement),
    /// One without a page, as in a worker.
    Offscreen(OffscreenCanvas),
}
