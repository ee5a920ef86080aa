//! Buffers that grow.

use bytemuck::Pod;

/// Vertices or instances on the graphics card.
#[derive(Debug)]
pub(super) struct Buffer {
    buffer: wgpu::Buffer,
    label: &'static str,
}

/// The smallest size: nothing is smaller than a few instances.
const SMALLEST_BUFFER: u64 = 1 << 12;

impl Buffer {
    pub fn new(device: &wgpu::Device, label: &'static str) -> Self {
        Self { buffer: Self::create(device, label, SMALLEST_BUFFER), label }
    }

    fn create(device: &wgpu::Device, label: &'static str, size: u64) -> wgpu::Buffer {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size,
            usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    }

    /// Replaces the contents.
    pub fn fill<T: Pod>(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, items: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(items);
        let size = bytes.len() as u64;
        if size > self.buffer.size() {
            self.buffer = Self::create(device, self.label, size.next_power_of_two());
        }
        if size > 0 {
            queue.write_buffer(&self.buffer, 0, bytes);
        }
    }

    /// The items of a range.
    pub fn items<T: Pod>(&self, range: &std::ops::Range<u32>) -> wgpu::BufferSlice<'_> {
        let size = size_of::<T>() as u64;
        self.buffer.slice(u64::from(range.start) * size..u64::from(range.end) * size)
    }
}

/// A uniform buffer of one value.
pub(super) fn uniform<T: Pod>(device: &wgpu::Device, label: &'static str) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: size_of::<T>() as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
