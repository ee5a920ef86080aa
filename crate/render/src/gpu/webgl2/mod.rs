//! WebGL2, called directly: there is nothing between, so that those with old devices have little to download.

mod buffer;
mod card;
mod chain;
mod draw;
mod pipeline;
mod read_back;
mod texture;

pub use buffer::{Buffer, Usage};
pub use card::Card;
pub use chain::{Chain, Frame};
pub use draw::draw;
pub use pipeline::Pipeline;
pub use read_back::ReadBack;
pub use texture::Texture;
