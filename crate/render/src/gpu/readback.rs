//! Getting a picture back from the graphics card.

use std::cell::Cell;
use std::rc::Rc;

use super::device::Gpu;
use super::events::Loss;
use super::pipelines::PICTURE_FORMAT;
use super::texture::{extent, texture};
use crate::picture::window::Window;

/// A picture on its way back.
#[derive(Debug)]
pub struct ReadBack {
    device: wgpu::Device,
    buffer: wgpu::Buffer,
    window: Window,
    stride: u32,
    state: Rc<Cell<Option<bool>>>,
    loss: Loss,
}

impl ReadBack {
    /// A texture to draw a picture into that is to be read.
    pub(super) fn texture(gpu: &Gpu, window: Window) -> wgpu::Texture {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        texture(gpu, "read", window, PICTURE_FORMAT, usage)
    }

    /// Begins to read such a texture, after the commands of `encoder`.
    pub(super) fn begin(
        gpu: &Gpu,
        mut encoder: wgpu::CommandEncoder,
        texture: &wgpu::Texture,
        window: Window,
    ) -> Self {
        let stride = (window.width * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read"),
            size: u64::from(stride) * u64::from(window.height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None };
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
            extent(window),
        );
        gpu.queue.submit([encoder.finish()]);
        let state = Rc::new(Cell::new(None));
        let told = Rc::clone(&state);
        buffer.slice(..).map_async(wgpu::MapMode::Read, move |result| told.set(Some(result.is_ok())));
        Self { device: gpu.device.clone(), buffer, window, stride, state, loss: gpu.loss() }
    }

    /// The picture if it has arrived: RGBA with straight alpha, row 0 on top. `Some(None)` when it never
    /// will, because the device is lost. Ask again after letting the browser do something else.
    pub fn take(&self) -> Option<Option<Vec<u8>>> {
        if self.loss.is_lost() {
            return Some(None);
        }
        // WebGPU looks after itself, WebGL must be asked.
        let _ = self.device.poll(wgpu::PollType::Poll);
        let arrived = self.state.get()?;
        if !arrived {
            return Some(None);
        }
        let Ok(mapped) = self.buffer.slice(..).get_mapped_range() else { return Some(None) };
        let row = self.window.width as usize * 4;
        let rows = mapped.chunks_exact(self.stride as usize).take(self.window.height as usize);
        Some(Some(rows.flat_map(|bytes| &bytes[..row]).copied().collect()))
    }
}
