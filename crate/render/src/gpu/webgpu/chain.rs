//! The frames of a canvas.

use super::card::{Card, adapter};
use super::texture::Texture;
use crate::gpu::canvas::Canvas;
use crate::gpu::events::Loss;
use crate::gpu::words::Format;
use crate::picture::window::Window;

/// What a canvas shows, one frame after the other.
#[derive(Debug)]
pub struct Chain {
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
}

/// What is shown next.
#[derive(Debug)]
pub struct Frame {
    surface: wgpu::SurfaceTexture,
    pub texture: Texture,
}

impl Chain {
    /// Opens a device for a canvas. The device comes before the surface: a canvas that has once been used for WebGPU
    /// cannot go back.
    pub async fn open(canvas: &Canvas, loss: Loss) -> Result<(Card, Self), String> {
        let (instance, adapter) = adapter().await?;
        let device = Card::request(&adapter).await?;
        let target = match canvas.clone() {
            Canvas::Html(canvas) => wgpu::SurfaceTarget::Canvas(canvas),
            Canvas::Offscreen(canvas) => wgpu::SurfaceTarget::OffscreenCanvas(canvas),
        };
        let surface = instance.create_surface(target).map_err(|e| e.to_string())?;
        let mut config = surface.get_default_config(&adapter, 1, 1).ok_or("the canvas cannot be drawn on")?;
        // Colours are sRGB already: the first format that leaves them alone.
        if let Some(format) = surface.get_capabilities(&adapter).formats.iter().find(|f| !f.is_srgb()) {
            config.format = *format;
        }
        // wgpu lists but one mode for canvases, yet hands this one on.
        config.alpha_mode = wgpu::CompositeAlphaMode::PreMultiplied;
        let card = Card::new(&adapter, device, config.format, loss).await;
        Ok((card, Self { surface, config }))
    }

    /// Sets the size of the canvas, in pixels.
    pub fn resize(&mut self, card: &Card, width: u32, height: u32) {
        (self.config.width, self.config.height) = (width, height);
        self.surface.configure(&card.device, &self.config);
    }

    /// A frame, if the canvas can be had now.
    pub fn next(&self, card: &Card) -> Option<Frame> {
        use wgpu::CurrentSurfaceTexture as Current;
        match self.surface.get_current_texture() {
            Current::Success(frame) | Current::Suboptimal(frame) => return Some(self.frame(frame)),
            Current::Timeout | Current::Occluded => return None,
            _ => {}
        }
        // Outdated: once more with a new chain of frames.
        self.surface.configure(&card.device, &self.config);
        match self.surface.get_current_texture() {
            Current::Success(frame) | Current::Suboptimal(frame) => Some(self.frame(frame)),
            _ => None,
        }
    }

    fn frame(&self, surface: wgpu::SurfaceTexture) -> Frame {
        let window = Window { width: self.config.width, height: self.config.height };
        Frame { texture: Texture::of(surface.texture.clone(), window, Format::Canvas), surface }
    }

    /// Shows a frame.
    pub fn present(&self, card: &Card, frame: Frame) {
        card.queue.present(frame.surface);
    }
}
