//! Pictures by the graphics card.

mod canvas;
#[cfg(feature = "webgpu")]
mod card;
mod renderer;
mod space_renderer;

#[cfg(feature = "webgpu")]
pub use card::*;
pub use {renderer::*, space_renderer::*};
