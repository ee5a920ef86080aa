//! Carrying out a pass.

use super::card::Card;
use crate::gpu::pass::{Bound, Draw, Pass};
use crate::gpu::words::{Format, OnTop, stride};

/// Draws, onto nothing or onto what is there.
pub fn draw<'a>(card: &Card, pass: &Pass<'_>, draws: impl IntoIterator<Item = Draw<'a>>) {
    let Pass { pipeline, bindings, onto, depth, clear } = *pass;
    let mut entries = Vec::new();
    for (binding, bound) in bindings {
        let mut add = |binding, resource| entries.push(wgpu::BindGroupEntry { binding, resource });
        match bound {
            Bound::Uniform(buffer) => add(*binding, buffer.buffer.as_entire_binding()),
            Bound::Texture(texture) => {
                add(*binding, wgpu::BindingResource::TextureView(&texture.view));
                if let Some(sampler) = &texture.sampler {
                    add(*binding + 1, wgpu::BindingResource::Sampler(sampler));
                }
            }
        }
    }
    let layout = &pipeline.bindings;
    let descriptor = wgpu::BindGroupDescriptor { label: None, layout, entries: &entries };
    let group = card.device.create_bind_group(&descriptor);
    let load = if clear { wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT) } else { wgpu::LoadOp::Load };
    let ops = wgpu::Operations { load, store: wgpu::StoreOp::Store };
    let colours: Vec<_> = onto
        .iter()
        .map(|texture| {
            let view = &texture.view;
            Some(wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops })
        })
        .collect();
    let depth = depth.zip(pipeline.on_top).map(|(texture, on_top)| {
        let load = if clear { wgpu::LoadOp::Clear(on_top.nothing()) } else { wgpu::LoadOp::Load };
        let store = match on_top {
            OnTop::Largest => wgpu::StoreOp::Store,
            OnTop::Smallest => wgpu::StoreOp::Discard,
        };
        let depth_ops = Some(wgpu::Operations { load, store });
        wgpu::RenderPassDepthStencilAttachment { view: &texture.view, depth_ops, stencil_ops: None }
    });
    let mut encoder = card.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &colours,
            depth_stencil_attachment: depth,
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_pipeline(pipeline.onto(onto.first().map_or(Format::Colours, |texture| texture.format)));
        pass.set_bind_group(0, &group, &[]);
        for Draw { buffers, indices, count, instances } in draws {
            for (place, (layout, (buffer, first))) in
                (0..).zip(pipeline.buffers.iter().zip(buffers.into_iter().flatten()))
            {
                let from = u64::from(first) * u64::from(stride(*layout));
                pass.set_vertex_buffer(place, buffer.buffer.slice(from..));
            }
            if let Some(indices) = indices {
                pass.set_index_buffer(indices.buffer.slice(..), wgpu::IndexFormat::Uint32);
                pass.draw_indexed(0..count, 0, 0..instances);
            } else {
                pass.draw(0..count, 0..instances);
            }
        }
    }
    card.queue.submit([encoder.finish()]);
}
