//! What points of space are drawn into.

use super::pipelines::{Pipelines3, WORD_FORMAT};
use crate::gpu::device::Gpu;
use crate::gpu::pipelines::DEPTH_FORMAT;
use crate::picture::window::Window;

/// Codes and depths of one picture.
#[derive(Debug)]
pub(super) struct Target3 {
    pub window: Window,
    codes: wgpu::Texture,
    depths: wgpu::Texture,
    views: [wgpu::TextureView; 2],
    /// What decides which point is nearest.
    test: wgpu::TextureView,
}

impl Target3 {
    pub fn new(gpu: &Gpu, window: Window) -> Self {
        let texture = |label, format, usage| {
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
        };
        let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let kept = drawn | wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
        let (codes, depths) = (texture("codes", WORD_FORMAT, kept), texture("depths", WORD_FORMAT, kept));
        let view = |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let views = [view(&codes), view(&depths)];
        Self { window, views, test: view(&texture("nearest", DEPTH_FORMAT, drawn)), codes, depths }
    }

    /// Replaces what it holds by a depth buffer of its size.
    pub fn write(&self, gpu: &Gpu, depth: &[f32], codes: &[u32]) {
        // Depths are bits here as they are there.
        for (texture, words) in [(&self.codes, codes), (&self.depths, bytemuck::cast_slice(depth))] {
            gpu.queue.write_texture(
                texture.as_image_copy(),
                bytemuck::cast_slice(words),
                wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(self.window.width * 4),
                    rows_per_image: None,
                },
                extent(self.window),
            );
        }
    }

    /// A pass that draws into it, on nothing.
    pub fn pass<'a>(&self, encoder: &'a mut wgpu::CommandEncoder, nearest: bool) -> wgpu::RenderPass<'a> {
        let colour = |view| {
            Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })
        };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("space"),
            color_attachments: &[colour(&self.views[0]), colour(&self.views[1])],
            depth_stencil_attachment: nearest.then_some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.test,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..wgpu::RenderPassDescriptor::default()
        })
    }

    /// What lights it, or fills its holes.
    pub fn bindings(
        &self,
        gpu: &Gpu,
        pipelines: &Pipelines3,
        lamp: &wgpu::Buffer,
        look: &wgpu::Buffer,
    ) -> wgpu::BindGroup {
        let [codes, depths] = [0, 1].map(|k| wgpu::BindingResource::TextureView(&self.views[k]));
        gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("light"),
            layout: &pipelines.light_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: lamp.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: look.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 2, resource: codes },
                wgpu::BindGroupEntry { binding: 3, resource: depths },
            ],
        })
    }
}

fn extent(window: Window) -> wgpu::Extent3d {
    wgpu::Extent3d { width: window.width, height: window.height, depth_or_array_layers: 1 }
}
