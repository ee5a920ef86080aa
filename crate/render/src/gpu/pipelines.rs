//! The shaders and how they are fed.

use super::pipeline::{Pipeline, full_screen, layout, module, texture, uniform};
use crate::points::{Instance, Vertex};

/// What pixels of a target hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The code of the topmost piece.
    Codes,
    /// Sums of weights.
    Density,
    /// Colours, made on the processor.
    Picture,
}

const KINDS: [Kind; 3] = [Kind::Codes, Kind::Density, Kind::Picture];

/// Everything that is the same for all pictures.
#[derive(Debug)]
pub(super) struct Pipelines {
    /// Draw points into a target.
    points: [wgpu::RenderPipeline; 2],
    /// Show a target on the canvas.
    shows: [wgpu::RenderPipeline; 3],
    /// The same into a texture that can be read.
    reads: [wgpu::RenderPipeline; 3],
    /// Bindings of the first.
    pub points_layout: wgpu::BindGroupLayout,
    /// Bindings of the others.
    resolve_layouts: [wgpu::BindGroupLayout; 3],
}

/// What pictures are read from.
pub(super) const PICTURE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// What codes are written to.
pub(super) const CODE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;

const POINTS: &str = concat!(
    include_str!(concat!(env!("OUT_DIR"), "/shader/colour.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/points.wgsl"))
);
const RESOLVE: &str = concat!(
    include_str!(concat!(env!("OUT_DIR"), "/shader/colour.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/tone.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/screen.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/resolve.wgsl"))
);

impl Pipelines {
    pub fn new(device: &wgpu::Device, canvas: wgpu::TextureFormat, sums: wgpu::TextureFormat) -> Self {
        let points = module(device, "points", POINTS);
        let resolve = module(device, "resolve", RESOLVE);
        let points_layout = layout(device, "points", &[uniform(0), uniform(1)]);
        let resolve_layouts = KINDS.map(|kind| {
            let sample_type = match kind {
                Kind::Codes => wgpu::TextureSampleType::Uint,
                Kind::Density | Kind::Picture => wgpu::TextureSampleType::Float { filterable: false },
            };
            layout(device, "resolve", &[uniform(1), texture(Self::texture_binding(kind), sample_type)])
        });
        let draws =
            [Kind::Codes, Kind::Density].map(|kind| draw(device, &points, &points_layout, kind, sums));
        let shows = KINDS.map(|kind| show(device, &resolve, &resolve_layouts[kind as usize], kind, canvas));
        let reads =
            KINDS.map(|kind| show(device, &resolve, &resolve_layouts[kind as usize], kind, PICTURE_FORMAT));
        Self { points: draws, shows, reads, points_layout, resolve_layouts }
    }

    /// Nothing is drawn into pictures.
    pub fn points(&self, kind: Kind) -> Option<&wgpu::RenderPipeline> {
        self.points.get(kind as usize)
    }

    pub fn show(&self, kind: Kind) -> &wgpu::RenderPipeline {
        &self.shows[kind as usize]
    }

    pub fn read(&self, kind: Kind) -> &wgpu::RenderPipeline {
        &self.reads[kind as usize]
    }

    /// The binding of a target's texture in [`Pipelines::resolve_layout`].
    pub fn texture_binding(kind: Kind) -> u32 {
        match kind {
            Kind::Codes => 2,
            Kind::Density => 3,
            Kind::Picture => 4,
        }
    }

    pub fn resolve_layout(&self, kind: Kind) -> &wgpu::BindGroupLayout {
        &self.resolve_layouts[kind as usize]
    }
}

/// A pipeline that draws points.
fn draw(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    bindings: &wgpu::BindGroupLayout,
    kind: Kind,
    sums: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let add = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::One,
        dst_factor: wgpu::BlendFactor::One,
        operation: wgpu::BlendOperation::Add,
    };
    let (vertex, fragment, format, blend) = match kind {
        Kind::Codes => ("codes_vertex", "codes_fragment", CODE_FORMAT, None),
        Kind::Density | Kind::Picture => {
            let blend = wgpu::BlendState { color: add, alpha: add };
            ("density_vertex", "density_fragment", sums, Some(blend))
        }
    };
    let vertices = wgpu::VertexBufferLayout {
        array_stride: size_of::<Vertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![0 => Float32x2, 1 => Uint32, 2 => Float32],
    };
    let instances = wgpu::VertexBufferLayout {
        array_stride: size_of::<Instance>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![
            3 => Float32x4, 4 => Float32x2, 5 => Uint32, 6 => Float32, 7 => Float32x2, 8 => Uint32
        ],
    };
    Pipeline {
        module,
        bindings,
        vertex,
        fragment,
        buffers: &[Some(vertices), Some(instances)],
        topology: wgpu::PrimitiveTopology::PointList,
        // Later maps lie over earlier ones, in whatever order they are drawn.
        depth: (kind == Kind::Codes).then_some(wgpu::CompareFunction::GreaterEqual),
        targets: &[Some(wgpu::ColorTargetState { format, blend, write_mask: wgpu::ColorWrites::ALL })],
    }
    .create(device)
}

/// A pipeline that makes a picture of a target.
fn show(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    bindings: &wgpu::BindGroupLayout,
    kind: Kind,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let fragment = match kind {
        Kind::Codes => "codes_resolve",
        Kind::Density => "density_resolve",
        Kind::Picture => "picture_resolve",
    };
    full_screen(device, module, bindings, ["screen_vertex", fragment], &[Some(format.into())])
}
