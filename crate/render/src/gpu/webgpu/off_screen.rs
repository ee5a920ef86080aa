//! Frames that nobody sees, where there is no browser.

use super::card::{Card, adapter};
use super::texture::Texture;
use crate::gpu::canvas::Canvas;
use crate::gpu::events::Loss;
use crate::gpu::words::Format;
use crate::picture::window::Window;

/// A texture in place of a canvas.
#[derive(Debug)]
pub struct Chain {
    texture: Option<(wgpu::Texture, Window)>,
}

/// What is drawn next.
#[derive(Debug)]
pub struct Frame {
    pub texture: Texture,
}

impl Chain {
    /// Opens a device.
    pub async fn open(_: &Canvas, loss: Loss) -> Result<(Card, Self), String> {
        let (_, adapter) = adapter().await?;
        let device = Card::request(&adapter).await?;
        // The order of bytes that most canvases have.
        let card = Card::new(&adapter, device, wgpu::TextureFormat::Bgra8Unorm, loss).await;
        Ok((card, Self { texture: None }))
    }

    /// Sets the size, in pixels.
    pub fn resize(&mut self, card: &Card, width: u32, height: u32) {
        let window = Window { width, height };
        self.texture = Some((Texture::new(card, "frame", window, Format::Canvas).texture, window));
    }

    /// The same texture each time.
    pub fn next(&self, _: &Card) -> Option<Frame> {
        let (texture, window) = self.texture.as_ref()?;
        Some(Frame { texture: Texture::of(texture.clone(), *window, Format::Canvas) })
    }

    /// Leaves it there, and lets the device tell what happened.
    pub fn present(&self, card: &Card, _: Frame) {
        let _ = card.device.poll(wgpu::PollType::Poll);
    }
}
