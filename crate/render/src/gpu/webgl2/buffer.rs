//! Buffers that grow.

use bytemuck::Pod;
use web_sys::{WebGl2RenderingContext as Gl, WebGlBuffer};

use super::card::Card;

/// What a buffer is for.
#[derive(Clone, Copy, Debug)]
pub enum Usage {
    /// What vertices or instances have.
    Items,
    /// Which vertices, one after the other.
    Indices,
    /// Numbers that are the same for all of a pass.
    Uniform,
}

/// Numbers on the graphics card.
#[derive(Debug)]
pub struct Buffer {
    gl: Gl,
    pub(super) buffer: Option<WebGlBuffer>,
    place: u32,
}

impl Buffer {
    /// An empty one.
    pub fn new(card: &Card, _label: &'static str, usage: Usage) -> Self {
        let place = match usage {
            Usage::Items => Gl::ARRAY_BUFFER,
            Usage::Indices => Gl::ELEMENT_ARRAY_BUFFER,
            Usage::Uniform => Gl::UNIFORM_BUFFER,
        };
        Self { buffer: card.gl.create_buffer(), gl: card.gl.clone(), place }
    }

    /// Replaces the contents.
    pub fn fill<T: Pod>(&mut self, card: &Card, items: &[T]) {
        self.set(card, items);
    }

    /// Replaces the contents. The browser takes new memory where the card still reads from the old.
    pub fn set<T: Pod>(&self, card: &Card, items: &[T]) {
        if !items.is_empty() {
            card.gl.bind_buffer(self.place, self.buffer.as_ref());
            card.gl.buffer_data_with_u8_array(self.place, bytemuck::cast_slice(items), Gl::DYNAMIC_DRAW);
        }
    }
}

impl Drop for Buffer {
    fn drop(&mut self) {
        self.gl.delete_buffer(self.buffer.as_ref());
    }
}
