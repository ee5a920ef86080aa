//! Textures of the size of a picture.

use super::card::Card;
use crate::gpu::words::Format;
use crate::picture::window::Window;

/// A texture for one picture.
#[derive(Debug)]
pub struct Texture {
    pub(super) texture: wgpu::Texture,
    pub(super) view: wgpu::TextureView,
    pub window: Window,
    pub(super) format: Format,
    /// What reads between the pixels of a photograph.
    pub(super) sampler: Option<wgpu::Sampler>,
}

impl Texture {
    /// One with nothing on it, to be drawn to.
    pub fn new(card: &Card, label: &'static str, window: Window, format: Format) -> Self {
        let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let usage = match format {
            Format::Depth => drawn,
            _ => {
                drawn
                    | wgpu::TextureUsages::TEXTURE_BINDING
                    | wgpu::TextureUsages::COPY_DST
                    | wgpu::TextureUsages::COPY_SRC
            }
        };
        Self::of(create(card, label, window, 1, card.format(format), usage), window, format)
    }

    /// A photograph of so many levels, each half of the one before, to be written.
    pub fn photo(card: &Card, window: Window, levels: u32) -> Self {
        let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
        let texture = create(card, "photograph", window, levels, card.format(Format::Colours), usage);
        let sampler = card.device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("between"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            ..wgpu::SamplerDescriptor::default()
        });
        Self { sampler: Some(sampler), ..Self::of(texture, window, Format::Colours) }
    }

    pub(super) fn of(texture: wgpu::Texture, window: Window, format: Format) -> Self {
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self { texture, view, window, format, sampler: None }
    }

    /// Replaces what a level holds: four bytes a pixel, row after row.
    pub fn write(&self, card: &Card, level: u32, window: Window, bytes: &[u8]) {
        let place = wgpu::TexelCopyTextureInfo { mip_level: level, ..self.texture.as_image_copy() };
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(window.width * 4),
            rows_per_image: None,
        };
        card.queue.write_texture(place, bytes, layout, extent(window));
    }
}

fn create(
    card: &Card,
    label: &'static str,
    window: Window,
    levels: u32,
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    card.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: extent(window),
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

pub(super) fn extent(window: Window) -> wgpu::Extent3d {
    wgpu::Extent3d { width: window.width, height: window.height, depth_or_array_layers: 1 }
}
