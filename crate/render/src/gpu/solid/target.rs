//! What points of space are drawn into.

use super::pipelines::{Pipelines3, WORD_FORMAT};
use crate::gpu::device::Gpu;
use crate::gpu::pipeline::{DEPTH_FORMAT, colour};
use crate::gpu::texture::{texture, view, write};
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
        let texture = |label, format, usage| texture(gpu, label, window, format, usage);
        let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let kept = drawn | wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
        let (codes, depths) = (texture("codes", WORD_FORMAT, kept), texture("depths", WORD_FORMAT, kept));
        let views = [view(&codes), view(&depths)];
        Self { window, views, test: view(&texture("nearest", DEPTH_FORMAT, drawn)), codes, depths }
    }

    /// Replaces what it holds by a depth buffer of its size.
    pub fn write(&self, gpu: &Gpu, depth: &[f32], codes: &[u32]) {
        // Depths are bits here as they are there.
        for (texture, words) in [(&self.codes, codes), (&self.depths, bytemuck::cast_slice(depth))] {
            write(gpu, texture.as_image_copy(), self.window, bytemuck::cast_slice(words));
        }
    }

    /// A pass that draws into it, on nothing.
    pub fn pass<'a>(&self, encoder: &'a mut wgpu::CommandEncoder, nearest: bool) -> wgpu::RenderPass<'a> {
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("space"),
            color_attachments: &[colour(&self.views[0], true), colour(&self.views[1], true)],
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
        colours: &wgpu::Buffer,
    ) -> wgpu::BindGroup {
        let [codes, depths] = [0, 1].map(|k| wgpu::BindingResource::TextureView(&self.views[k]));
        gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("light"),
            layout: &pipelines.light_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: lamp.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: colours.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 2, resource: codes },
                wgpu::BindGroupEntry { binding: 3, resource: depths },
            ],
        })
    }
}
