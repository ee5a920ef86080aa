//! What points of space are drawn into.

use crate::gpu::device::Gpu;
use crate::gpu::interface::{Buffer, Texture};
use crate::gpu::pass::Bound;
use crate::gpu::words::Format;
use crate::picture::window::Window;

/// Codes and depths of one picture.
#[derive(Debug)]
pub(super) struct Target3 {
    pub window: Window,
    pub codes: Texture,
    pub depths: Texture,
    /// What decides which point is nearest.
    pub nearest: Texture,
}

impl Target3 {
    pub fn new(gpu: &Gpu, window: Window) -> Self {
        let texture = |label, format| Texture::new(&gpu.card, label, window, format);
        let (codes, depths) = (texture("codes", Format::Word), texture("depths", Format::Word));
        Self { window, codes, depths, nearest: texture("nearest", Format::Depth) }
    }

    /// Replaces what it holds by a depth buffer of its size.
    pub fn write(&self, gpu: &Gpu, depth: &[f32], codes: &[u32]) {
        // Depths are bits here as they are there.
        for (texture, words) in [(&self.codes, codes), (&self.depths, bytemuck::cast_slice(depth))] {
            texture.write(&gpu.card, 0, self.window, bytemuck::cast_slice(words));
        }
    }

    /// What lights it, or fills its holes.
    pub fn bindings<'a>(&'a self, lamp: &'a Buffer, colours: &'a Buffer) -> [(u32, Bound<'a>); 4] {
        [
            (0, Bound::Uniform(lamp)),
            (1, Bound::Uniform(colours)),
            (2, Bound::Texture(&self.codes)),
            (3, Bound::Texture(&self.depths)),
        ]
    }
}
