//! Buffers that grow.

use bytemuck::Pod;

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
    /// What is read where something is computed.
    Read,
    /// What is computed.
    Computed,
}

/// Numbers on the graphics card.
#[derive(Debug)]
pub struct Buffer {
    pub(super) buffer: wgpu::Buffer,
    label: &'static str,
}

/// The smallest size: nothing is much smaller.
const SMALLEST_BUFFER: u64 = 1 << 12;

impl Buffer {
    /// An empty one.
    pub fn new(card: &Card, label: &'static str, usage: Usage) -> Self {
        let usage = match usage {
            Usage::Items => wgpu::BufferUsages::VERTEX,
            Usage::Indices => wgpu::BufferUsages::INDEX,
            Usage::Uniform => wgpu::BufferUsages::UNIFORM,
            Usage::Read => wgpu::BufferUsages::STORAGE,
            Usage::Computed => wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
        };
        let usage = usage | wgpu::BufferUsages::COPY_DST;
        Self { buffer: Self::create(card, label, SMALLEST_BUFFER, usage), label }
    }

    fn create(card: &Card, label: &'static str, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        let descriptor =
            wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false };
        card.device.create_buffer(&descriptor)
    }

    /// Replaces the contents.
    pub fn fill<T: Pod>(&mut self, card: &Card, items: &[T]) {
        let size = size_of_val(items) as u64;
        if size > self.buffer.size() {
            self.hold(card, size.next_power_of_two());
        }
        self.set(card, items);
    }

    /// Makes it of so many bytes, with nothing in it.
    pub fn hold(&mut self, card: &Card, size: u64) {
        self.buffer = Self::create(card, self.label, size, self.buffer.usage());
    }

    /// Replaces the first items, as far as there is room.
    pub fn set<T: Pod>(&self, card: &Card, items: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(items);
        if !bytes.is_empty() && bytes.len() as u64 <= self.buffer.size() {
            card.queue.write_buffer(&self.buffer, 0, bytes);
        }
    }
}
