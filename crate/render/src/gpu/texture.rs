//! Textures of the size of a picture.

use super::device::Gpu;
use crate::picture::window::Window;

/// A texture for one picture.
pub(super) fn texture(
    gpu: &Gpu,
    label: &str,
    window: Window,
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: extent(window),
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

/// All of a texture.
pub(super) fn view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

/// Replaces what it holds: four bytes a pixel, row after row.
pub(super) fn write(gpu: &Gpu, texture: wgpu::TexelCopyTextureInfo, window: Window, bytes: &[u8]) {
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(window.width * 4),
        rows_per_image: None,
    };
    gpu.queue.write_texture(texture, bytes, layout, extent(window));
}

pub(super) fn extent(window: Window) -> wgpu::Extent3d {
    wgpu::Extent3d { width: window.width, height: window.height, depth_or_array_layers: 1 }
}
