//! WebGPU, by wgpu.

mod buffer;
mod card;
#[cfg(target_arch = "wasm32")]
mod chain;
mod compute;
mod draw;
#[cfg(not(target_arch = "wasm32"))]
mod off_screen;
mod pipeline;
mod read_back;
mod texture;

pub use buffer::{Buffer, Usage};
pub use card::{Card, adapter, name};
#[cfg(target_arch = "wasm32")]
pub use chain::{Chain, Frame};
pub use compute::Compute;
pub use draw::draw;
#[cfg(not(target_arch = "wasm32"))]
pub use off_screen::{Chain, Frame};
pub use pipeline::Pipeline;
pub use read_back::ReadBack;
pub use texture::Texture;
