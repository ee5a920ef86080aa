//! Shaders and how they are fed.

use super::card::Card;
use crate::gpu::words::{Attribute, Blend, Each, Format, Layout, OnTop, Recipe, Slot, stride};

/// What draws.
#[derive(Debug)]
pub struct Pipeline {
    /// Into textures.
    texture: wgpu::RenderPipeline,
    /// On the canvas, whose bytes may have another order.
    canvas: Option<wgpu::RenderPipeline>,
    pub(super) bindings: wgpu::BindGroupLayout,
    pub(super) buffers: Vec<Layout>,
    pub(super) on_top: Option<OnTop>,
}

impl Pipeline {
    pub fn new(card: &Card, recipe: &Recipe<'_>) -> Self {
        let source = wgpu::ShaderSource::Wgsl(recipe.shader.0.into());
        let label = Some(recipe.fragment);
        let module = card.device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source });
        let entries: Vec<_> =
            recipe.slots.iter().flat_map(|(binding, slot)| entries(*binding, *slot)).collect();
        let descriptor = wgpu::BindGroupLayoutDescriptor { label, entries: &entries };
        let bindings = card.device.create_bind_group_layout(&descriptor);
        let on_canvas = recipe.onto == [Format::Canvas];
        let texture = if on_canvas { &[Format::Colours][..] } else { recipe.onto };
        Self {
            texture: create(card, recipe, &module, &bindings, texture),
            canvas: on_canvas.then(|| create(card, recipe, &module, &bindings, recipe.onto)),
            bindings,
            buffers: recipe.buffers.to_vec(),
            on_top: recipe.on_top,
        }
    }

    /// What draws into such a format.
    pub(super) fn onto(&self, format: Format) -> &wgpu::RenderPipeline {
        self.canvas.as_ref().filter(|_| format == Format::Canvas).unwrap_or(&self.texture)
    }
}

fn entries(binding: u32, slot: Slot) -> Vec<wgpu::BindGroupLayoutEntry> {
    let fragment = wgpu::ShaderStages::FRAGMENT;
    let entry = |binding, visibility, ty| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let texture = |sample_type| {
        let view_dimension = wgpu::TextureViewDimension::D2;
        entry(
            binding,
            fragment,
            wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false },
        )
    };
    match slot {
        Slot::Uniform => {
            let ty = wgpu::BufferBindingType::Uniform;
            let ty = wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
            vec![entry(binding, wgpu::ShaderStages::VERTEX_FRAGMENT, ty)]
        }
        Slot::Words => vec![texture(wgpu::TextureSampleType::Uint)],
        Slot::Pixels => vec![texture(wgpu::TextureSampleType::Float { filterable: false })],
        Slot::Photo => {
            let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
            let photo = texture(wgpu::TextureSampleType::Float { filterable: true });
            vec![photo, entry(binding + 1, fragment, sampler)]
        }
    }
}

fn create(
    card: &Card,
    recipe: &Recipe<'_>,
    module: &wgpu::ShaderModule,
    bindings: &wgpu::BindGroupLayout,
    onto: &[Format],
) -> wgpu::RenderPipeline {
    let layout = card.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        bind_group_layouts: &[Some(bindings)],
        ..wgpu::PipelineLayoutDescriptor::default()
    });
    let mut location = 0;
    let attributes: Vec<Vec<_>> =
        recipe.buffers.iter().map(|(_, list)| attributes(list, &mut location)).collect();
    let buffers: Vec<_> = recipe
        .buffers
        .iter()
        .zip(&attributes)
        .map(|(layout, attributes)| {
            let step_mode = match layout.0 {
                Each::Vertex => wgpu::VertexStepMode::Vertex,
                Each::Instance => wgpu::VertexStepMode::Instance,
            };
            Some(wgpu::VertexBufferLayout { array_stride: stride(*layout).into(), step_mode, attributes })
        })
        .collect();
    let targets: Vec<_> = onto
        .iter()
        .map(|format| {
            let (format, blend) = (card.format(*format), recipe.blend.map(blend_state));
            Some(wgpu::ColorTargetState { format, blend, write_mask: wgpu::ColorWrites::ALL })
        })
        .collect();
    let topology = if recipe.points {
        wgpu::PrimitiveTopology::PointList
    } else {
        wgpu::PrimitiveTopology::TriangleList
    };
    card.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(recipe.fragment),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(recipe.vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &buffers,
        },
        primitive: wgpu::PrimitiveState { topology, ..wgpu::PrimitiveState::default() },
        depth_stencil: recipe.on_top.map(|on_top| wgpu::DepthStencilState {
            format: card.format(Format::Depth),
            depth_write_enabled: Some(true),
            depth_compare: Some(match on_top {
                OnTop::Largest => wgpu::CompareFunction::GreaterEqual,
                OnTop::Smallest => wgpu::CompareFunction::Less,
            }),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(recipe.fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}

fn attributes(list: &[Attribute], location: &mut u32) -> Vec<wgpu::VertexAttribute> {
    let mut offset = 0;
    list.iter()
        .map(|attribute| {
            let format = match attribute {
                Attribute::Floats(1) => wgpu::VertexFormat::Float32,
                Attribute::Floats(2) => wgpu::VertexFormat::Float32x2,
                Attribute::Floats(3) => wgpu::VertexFormat::Float32x3,
                Attribute::Floats(_) => wgpu::VertexFormat::Float32x4,
                Attribute::Word => wgpu::VertexFormat::Uint32,
            };
            let one = wgpu::VertexAttribute { format, offset, shader_location: *location };
            offset += u64::from(attribute.size());
            *location += 1;
            one
        })
        .collect()
}

fn blend_state(blend: Blend) -> wgpu::BlendState {
    let src_factor = match blend {
        Blend::Add => wgpu::BlendFactor::One,
        Blend::Under => wgpu::BlendFactor::OneMinusDstAlpha,
    };
    let dst_factor = wgpu::BlendFactor::One;
    let part = wgpu::BlendComponent { src_factor, dst_factor, operation: wgpu::BlendOperation::Add };
    wgpu::BlendState { color: part, alpha: part }
}
