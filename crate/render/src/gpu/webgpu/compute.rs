//! Computing what a texture holds.

use super::buffer::Buffer;
use super::card::Card;
use super::texture::{Texture, extent};
use crate::gpu::shaders::Shader;

/// What computes.
#[derive(Debug)]
pub struct Compute {
    pipeline: wgpu::ComputePipeline,
}

/// The words of a row of a texture are computed with some behind them, up to a multiple of this.
const ROW: u32 = wgpu::COPY_BYTES_PER_ROW_ALIGNMENT / 4;
/// Groups along the first side of a grid of them.
const GROUPS: u32 = 1 << 15;

impl Compute {
    pub fn new(card: &Card, shader: Shader, entry: &'static str) -> Self {
        let source = wgpu::ShaderSource::Wgsl(shader.0.into());
        let label = Some(entry);
        let module = card.device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source });
        let pipeline = card.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label,
            layout: None,
            module: &module,
            entry_point: label,
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        Self { pipeline }
    }

    /// The words of a row of a texture.
    pub fn row(width: u32) -> u32 {
        width.next_multiple_of(ROW)
    }

    /// Computes with so many groups, which are to look how many they are, and puts the last of the buffers, words row
    /// after row, into a texture. Before that it is emptied if that is wanted.
    pub fn run(&self, card: &Card, buffers: &[&Buffer], groups: u32, clear: bool, onto: &Texture) {
        let entries: Vec<_> = (0..)
            .zip(buffers)
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding,
                resource: buffer.buffer.as_entire_binding(),
            })
            .collect();
        let layout = &self.pipeline.get_bind_group_layout(0);
        let descriptor = wgpu::BindGroupDescriptor { label: None, layout, entries: &entries };
        let bindings = card.device.create_bind_group(&descriptor);
        let mut encoder = card.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let Some(words) = buffers.last() else { return };
        if clear {
            encoder.clear_buffer(&words.buffer, 0, None);
        }
        if groups > 0 {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &bindings, &[]);
            pass.dispatch_workgroups(groups.min(GROUPS), groups.div_ceil(GROUPS), 1);
        }
        let bytes_per_row = Some(Self::row(onto.window.width) * 4);
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image: None };
        encoder.copy_buffer_to_texture(
            wgpu::TexelCopyBufferInfo { buffer: &words.buffer, layout },
            onto.texture.as_image_copy(),
            extent(onto.window),
        );
        card.queue.submit([encoder.finish()]);
    }
}
