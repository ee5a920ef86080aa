//! Getting a picture back from the graphics card.

use std::sync::{Arc, OnceLock};

use super::card::Card;
use super::texture::{Texture, extent};
use crate::gpu::events::Loss;
use crate::picture::window::Window;

/// A picture on its way back.
#[derive(Debug)]
pub struct ReadBack {
    /// It is there until the picture has arrived.
    device: wgpu::Device,
    buffer: wgpu::Buffer,
    window: Window,
    stride: u32,
    state: Arc<OnceLock<bool>>,
    loss: Loss,
}

impl ReadBack {
    /// Begins to read a texture of colours.
    pub(in crate::gpu) fn begin(card: &Card, texture: &Texture, loss: Loss) -> Self {
        let window = texture.window;
        let stride = (window.width * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = card.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read"),
            size: u64::from(stride) * u64::from(window.height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None };
        let mut encoder = card.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_texture_to_buffer(
            texture.texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
            extent(window),
        );
        card.queue.submit([encoder.finish()]);
        let state = Arc::new(OnceLock::new());
        let told = Arc::clone(&state);
        buffer.slice(..).map_async(wgpu::MapMode::Read, move |result| {
            let _ = told.set(result.is_ok());
        });
        Self { device: card.device.clone(), buffer, window, stride, state, loss }
    }

    /// The picture if it has arrived: RGBA with straight alpha, row 0 on top. `Some(None)` when it never
    /// will, because the device is lost. Ask again after letting the browser do something else.
    pub fn take(&self) -> Option<Option<Vec<u8>>> {
        if self.loss.is_lost() {
            return Some(None);
        }
        // A browser does this by itself.
        let _ = self.device.poll(wgpu::PollType::Poll);
        if !*self.state.get()? {
            return Some(None);
        }
        let Ok(mapped) = self.buffer.slice(..).get_mapped_range() else { return Some(None) };
        let row = self.window.width as usize * 4;
        let rows = mapped.chunks_exact(self.stride as usize).take(self.window.height as usize);
        Some(Some(rows.flat_map(|bytes| &bytes[..row]).copied().collect()))
    }
}
