//! The shaders of space and how they are fed.

use crate::gpu::pipeline::{Pipeline, full_screen, layout, module, texture, uniform};
use crate::gpu::pipelines::PICTURE_FORMAT;
use crate::solid::{Instance3, Vertex3};

/// What codes and the bits of depths are written to.
pub(super) const WORD_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;

const POINTS: &str = concat!(
    include_str!(concat!(env!("OUT_DIR"), "/shader/solid/kept.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/solid/points.wgsl"))
);
const SPLAT: &str = concat!(
    include_str!(concat!(env!("OUT_DIR"), "/shader/screen.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/solid/kept.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/solid/splat.wgsl"))
);
const SHADE: &str = concat!(
    include_str!(concat!(env!("OUT_DIR"), "/shader/colour.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/screen.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/solid/kept.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/solid/shade.wgsl")),
    include_str!(concat!(env!("OUT_DIR"), "/shader/solid/hole_fill.wgsl"))
);

/// Everything that is the same for all pictures of space.
#[derive(Debug)]
pub(super) struct Pipelines3 {
    pub points: wgpu::RenderPipeline,
    pub splat: wgpu::RenderPipeline,
    pub fill_holes: wgpu::RenderPipeline,
    /// On the canvas.
    pub show: wgpu::RenderPipeline,
    /// The same into a texture that can be read.
    pub read: wgpu::RenderPipeline,
    pub eye_layout: wgpu::BindGroupLayout,
    /// Lamp, colours, codes and depths; what splats them has its steps in the lamp's place.
    pub light_layout: wgpu::BindGroupLayout,
}

impl Pipelines3 {
    pub fn new(device: &wgpu::Device, canvas: wgpu::TextureFormat) -> Self {
        let (points, light) = (module(device, "space points", POINTS), module(device, "space light", SHADE));
        let splat = module(device, "space splat", SPLAT);
        let eye_layout = layout(device, "eye", &[uniform(0)]);
        let words = wgpu::TextureSampleType::Uint;
        let entries = [uniform(0), uniform(1), texture(2, words), texture(3, words)];
        let light_layout = layout(device, "light", &entries);
        let kept = [Some(WORD_FORMAT.into()), Some(WORD_FORMAT.into())];
        let on_screen = |fragment, targets: &[Option<wgpu::ColorTargetState>]| {
            full_screen(device, &light, &light_layout, ["screen_vertex", fragment], targets)
        };
        Self {
            points: draw(device, &points, &eye_layout, &kept),
            splat: full_screen(device, &splat, &light_layout, ["screen_vertex", "splat_fragment"], &kept),
            fill_holes: on_screen("hole_fill_fragment", &kept),
            show: on_screen("light_fragment", &[Some(canvas.into())]),
            read: on_screen("light_fragment", &[Some(PICTURE_FORMAT.into())]),
            eye_layout,
            light_layout,
        }
    }
}

fn draw(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    bindings: &wgpu::BindGroupLayout,
    targets: &[Option<wgpu::ColorTargetState>],
) -> wgpu::RenderPipeline {
    let vertices = wgpu::VertexBufferLayout {
        array_stride: size_of::<Vertex3>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Uint32],
    };
    let instances = wgpu::VertexBufferLayout {
        array_stride: size_of::<Instance3>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![
            2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Uint32, 6 => Uint32
        ],
    };
    Pipeline {
        module,
        bindings,
        vertex: "points_vertex",
        fragment: "points_fragment",
        buffers: &[Some(vertices), Some(instances)],
        topology: wgpu::PrimitiveTopology::PointList,
        depth: Some(wgpu::CompareFunction::Less),
        targets,
    }
    .create(device)
}
