//! What points are drawn into.

use bytemuck::{Pod, Zeroable};

use super::buffer::{Buffer, uniform};
use super::device::Gpu;
use super::pipeline::{DEPTH_FORMAT, colour, draw_full_screen};
use super::pipelines::{CODE_FORMAT, Kind, PICTURE_FORMAT, Pipelines};
use super::texture::{texture, view, write};
use crate::picture::window::Window;
use crate::plan::Batch;
use crate::points::{Instance, Sides, Vertex};

/// A texture of codes, sums or colours, and what is needed to draw points into it and to show it.
#[derive(Debug)]
pub(super) struct Target {
    pub window: Window,
    pub kind: Kind,
    texture: wgpu::Texture,
    pixels: wgpu::TextureView,
    depth: Option<wgpu::TextureView>,
    screen: wgpu::Buffer,
    points: wgpu::BindGroup,
}

/// What `shader/points.wgsl` calls `Screen`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Screen {
    size: [f32; 2],
    mass: f32,
    tinted: f32,
    sides: Sides,
}

impl Target {
    /// A target with nothing on it.
    pub fn new(gpu: &Gpu, pipelines: &Pipelines, colours: &wgpu::Buffer, kind: Kind, window: Window) -> Self {
        let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let format = match kind {
            Kind::Codes => CODE_FORMAT,
            Kind::Density => gpu.sums,
            Kind::Picture => PICTURE_FORMAT,
        };
        let read = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
        let pixels = texture(gpu, "pixels", window, format, drawn | read);
        let depth = (kind == Kind::Codes).then(|| view(&texture(gpu, "depth", window, DEPTH_FORMAT, drawn)));
        let screen = uniform::<Screen>(&gpu.device, "screen");
        let points = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("points"),
            layout: &pipelines.points_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: screen.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: colours.as_entire_binding() },
            ],
        });
        Self { window, kind, pixels: view(&pixels), texture: pixels, depth, screen, points }
    }

    /// Replaces what it holds by a picture, four bytes a pixel, row after row.
    pub fn write(&self, gpu: &Gpu, bytes: &[u8]) {
        write(gpu, self.texture.as_image_copy(), self.window, bytes);
    }

    /// Sets what masses are multiplied by, whether pieces have colours of their own, and along which sides they
    /// are twisted.
    pub fn prepare(&self, gpu: &Gpu, mass: f32, tinted: bool, sides: Sides) {
        let size = [self.window.width as f32, self.window.height as f32];
        let screen = Screen { size, mass, tinted: f32::from(u8::from(tinted)), sides };
        gpu.queue.write_buffer(&self.screen, 0, bytemuck::bytes_of(&screen));
    }

    /// Draws batches of points, on nothing or on what was drawn before.
    pub fn draw(
        &self,
        gpu: &Gpu,
        pipelines: &Pipelines,
        clear: bool,
        vertices: &Buffer,
        instances: &Buffer,
        batches: &[Batch],
    ) {
        let Some(pipeline) = pipelines.points(self.kind) else { return };
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("points"),
                color_attachments: &[colour(&self.pixels, clear)],
                depth_stencil_attachment: self.depth.as_ref().map(|view| {
                    wgpu::RenderPassDepthStencilAttachment {
                        view,
                        depth_ops: Some(wgpu::Operations {
                            load: if clear { wgpu::LoadOp::Clear(0.0) } else { wgpu::LoadOp::Load },
                            store: wgpu::StoreOp::Store,
                        }),
                        stencil_ops: None,
                    }
                }),
                ..wgpu::RenderPassDescriptor::default()
            });
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &self.points, &[]);
            for batch in batches.iter().filter(|batch| batch.points() > 0) {
                // WebGL has no base instance: the ranges are taken from the buffers instead.
                pass.set_vertex_buffer(0, vertices.items::<Vertex>(&batch.vertices));
                pass.set_vertex_buffer(1, instances.items::<Instance>(&batch.instances));
                pass.draw(0..batch.vertices.len() as u32, 0..batch.instances.len() as u32);
            }
        }
        gpu.queue.submit([encoder.finish()]);
    }

    /// Makes a picture of it.
    pub fn resolve(
        &self,
        gpu: &Gpu,
        pipelines: &Pipelines,
        colours: &wgpu::Buffer,
        pipeline: &wgpu::RenderPipeline,
        picture: &wgpu::TextureView,
    ) -> wgpu::CommandEncoder {
        let bindings = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("resolve"),
            layout: pipelines.resolve_layout(self.kind),
            entries: &[
                wgpu::BindGroupEntry { binding: 1, resource: colours.as_entire_binding() },
                wgpu::BindGroupEntry {
                    binding: Pipelines::texture_binding(self.kind),
                    resource: wgpu::BindingResource::TextureView(&self.pixels),
                },
            ],
        });
        draw_full_screen(&gpu.device, pipeline, &bindings, picture)
    }
}
