//! A photograph on a sheet, by the graphics card.

use bytemuck::{Pod, Zeroable};
use glam::DVec2;

use super::buffer::uniform;
use super::device::Gpu;
use super::pipeline::{
    Pipeline, begin, draw_full_screen, full_screen, layout, module, texture as texture_entry,
    uniform as uniform_entry,
};
use super::pipelines::PICTURE_FORMAT;
use super::texture::{extent, texture, view, write};
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::sheet::{Level, Photo, Sheet, SheetOptions, draw_sheet, on_target};

/// Corners further away than so many pixels have too few digits on the card: such a close view is drawn on the
/// processor, where it has few triangles.
const FARTHEST_CORNER_PIXELS: f64 = 1e6;
/// The most layers on the average before a sheet is drawn coarser: by a card, and by the processor in its place.
const MOST_LAYERS: (f64, f64) = (64.0, 16.0);

/// What `shader/sheet.wgsl` calls `Shown`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Shown {
    size: [f32; 2],
    factor: i32,
    premultiply: f32,
}

/// The photograph on the card, the sheet, and what it was drawn to.
#[derive(Debug)]
pub(super) struct SheetGpu {
    draw: wgpu::RenderPipeline,
    show: wgpu::RenderPipeline,
    read: wgpu::RenderPipeline,
    resolve_layout: wgpu::BindGroupLayout,
    photo: wgpu::BindGroup,
    /// While drawing, while showing, while reading.
    shown: [wgpu::Buffer; 3],
    corners: wgpu::Buffer,
    places: wgpu::Buffer,
    indices: wgpu::Buffer,
    /// How many indices there are, and the sheet's cells and step that they are for.
    count: u32,
    cells: (usize, usize),
    screen: Vec<[f32; 2]>,
    target: Option<Drawn>,
}

/// What was drawn.
#[derive(Debug)]
struct Drawn {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    window: Window,
    factor: u32,
}

impl SheetGpu {
    pub fn new(gpu: &Gpu, photo: &Photo) -> Self {
        let device = &gpu.device;
        let source = include_str!(concat!(env!("OUT_DIR"), "/shader/sheet.wgsl"));
        let module = module(device, "sheet", source);
        let colours = |filterable| wgpu::TextureSampleType::Float { filterable };
        let photo_layout = layout(
            device,
            "photograph",
            &[uniform_entry(0), texture_entry(1, colours(true)), sampler_entry(2)],
        );
        let resolve_layout = layout(device, "sheet", &[uniform_entry(0), texture_entry(3, colours(false))]);
        let shown = ["drawn sheet", "shown sheet", "read sheet"].map(|label| uniform::<Shown>(device, label));
        let resolve = |format: wgpu::TextureFormat| {
            let shader = ["sheet_screen", "sheet_resolve"];
            full_screen(device, &module, &resolve_layout, shader, &[Some(format.into())])
        };
        Self {
            draw: draw_pipeline(device, &module, &photo_layout),
            show: resolve(gpu.format()),
            read: resolve(PICTURE_FORMAT),
            resolve_layout,
            photo: upload(gpu, photo, &photo_layout, &shown[0]),
            shown,
            corners: buffer(device, "corners", 4, wgpu::BufferUsages::VERTEX),
            places: buffer(device, "places", 4, wgpu::BufferUsages::VERTEX),
            indices: buffer(device, "triangles", 4, wgpu::BufferUsages::INDEX),
            count: 0,
            cells: (0, 0),
            screen: Vec::new(),
            target: None,
        }
    }

    /// Draws a sheet, with `factor` x `factor` samples for each pixel of the window. Returns how many triangles it
    /// took.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        photo: &Photo,
        sheet: &Sheet,
        view: View,
        window: Window,
        factor: u32,
    ) -> u64 {
        let target = Window { width: window.width * factor, height: window.height * factor };
        let screen: Vec<DVec2> = on_target(sheet, view, window, f64::from(factor)).collect();
        // Not a number is not near either.
        if !screen.iter().all(|p| p.x.abs() < FARTHEST_CORNER_PIXELS && p.y.abs() < FARTHEST_CORNER_PIXELS) {
            self.draw_without(gpu, photo, sheet, view, window);
            return sheet.side().pow(2) as u64 * 2;
        }
        let step = sheet.step(&screen, target, if gpu.software { MOST_LAYERS.1 } else { MOST_LAYERS.0 });
        self.prepare(gpu, sheet, step);
        self.screen.clear();
        self.screen.extend(screen.iter().map(|p| p.as_vec2().to_array()));
        gpu.queue.write_buffer(&self.corners, 0, bytemuck::cast_slice(&self.screen));
        let size = [target.width as f32, target.height as f32];
        let shown = Shown { size, factor: factor as i32, premultiply: 1.0 };
        gpu.queue.write_buffer(&self.shown[0], 0, bytemuck::bytes_of(&shown));
        let drawn = self.fit(gpu, target, factor);
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = begin(&mut encoder, "sheet", &drawn.view);
            pass.set_pipeline(&self.draw);
            pass.set_bind_group(0, &self.photo, &[]);
            pass.set_vertex_buffer(0, self.corners.slice(..));
            pass.set_vertex_buffer(1, self.places.slice(..));
            pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..self.count, 0, 0..1);
        }
        gpu.queue.submit([encoder.finish()]);
        self.target = Some(drawn);
        u64::from(self.count / 3)
    }

    /// The same on the processor.
    fn draw_without(&mut self, gpu: &Gpu, photo: &Photo, sheet: &Sheet, view: View, window: Window) {
        let options =
            SheetOptions { width: window.width, height: window.height, view: Some(view), smooth: true };
        let Ok(mut picture) = draw_sheet(photo, sheet, &options) else { return };
        for pixel in picture.as_chunks_mut::<4>().0 {
            let [r, g, b, a] = pixel.map(u32::from);
            *pixel = [r, g, b, 255].map(|c| ((c * a + 127) / 255) as u8);
        }
        let drawn = self.fit(gpu, window, 1);
        write(gpu, drawn.texture.as_image_copy(), window, &picture);
        self.target = Some(drawn);
    }

    /// The target, of the right size.
    fn fit(&mut self, gpu: &Gpu, window: Window, factor: u32) -> Drawn {
        if let Some(kept) = self.target.take().filter(|kept| kept.window == window) {
            return Drawn { factor, ..kept };
        }
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT
            | wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_DST;
        let texture = texture(gpu, "sheet", window, PICTURE_FORMAT, usage);
        let view = view(&texture);
        Drawn { texture, view, window, factor }
    }

    /// Fills the buffers that hold whatever the corners are, but where they are.
    fn prepare(&mut self, gpu: &Gpu, sheet: &Sheet, step: usize) {
        if self.cells == (sheet.side(), step) {
            return;
        }
        let vertices = sheet.corners().len();
        if self.cells.0 != sheet.side() {
            let places: Vec<[f32; 2]> = (0..vertices).map(|i| sheet.place(i).as_vec2().to_array()).collect();
            let size = size_of_val(sheet.corners());
            self.corners = buffer(&gpu.device, "corners", size, wgpu::BufferUsages::VERTEX);
            self.places = buffer(&gpu.device, "places", size, wgpu::BufferUsages::VERTEX);
            gpu.queue.write_buffer(&self.places, 0, bytemuck::cast_slice(&places));
        }
        let indices: Vec<u32> = sheet.triangles(step).flatten().collect();
        self.indices = buffer(&gpu.device, "triangles", size_of_val(&indices[..]), wgpu::BufferUsages::INDEX);
        gpu.queue.write_buffer(&self.indices, 0, bytemuck::cast_slice(&indices));
        self.count = indices.len() as u32;
        self.cells = (sheet.side(), step);
    }

    /// Makes a picture of what was drawn, if anything was: for the canvas, or straight for reading.
    pub fn resolve(
        &self,
        gpu: &Gpu,
        straight: bool,
        picture: &wgpu::TextureView,
    ) -> Option<wgpu::CommandEncoder> {
        let drawn = self.target.as_ref()?;
        let (pipeline, buffer, premultiply) =
            if straight { (&self.read, &self.shown[2], 0.0) } else { (&self.show, &self.shown[1], 1.0) };
        let size = [drawn.window.width as f32, drawn.window.height as f32];
        let shown = Shown { size, factor: drawn.factor as i32, premultiply };
        gpu.queue.write_buffer(buffer, 0, bytemuck::bytes_of(&shown));
        let bindings = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("sheet"),
            layout: &self.resolve_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() },
                wgpu::BindGroupEntry {
                    binding: 3,
                    resource: wgpu::BindingResource::TextureView(&drawn.view),
                },
            ],
        });
        Some(draw_full_screen(&gpu.device, pipeline, &bindings, picture))
    }
}

/// The photograph with its halvings, as far as the card takes them.
fn upload(gpu: &Gpu, photo: &Photo, layout: &wgpu::BindGroupLayout, shown: &wgpu::Buffer) -> wgpu::BindGroup {
    let fits = |level: &&Level| level.width.max(level.height) <= gpu.max_side;
    let levels: Vec<_> = photo.levels().iter().filter(fits).collect();
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("photograph"),
        size: extent(levels.first().map_or(Window { width: 1, height: 1 }, |level| window_of(level))),
        mip_level_count: levels.len().max(1) as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: PICTURE_FORMAT,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (i, level) in levels.iter().enumerate() {
        let place = wgpu::TexelCopyTextureInfo { mip_level: i as u32, ..texture.as_image_copy() };
        write(gpu, place, window_of(level), level.pixels.as_flattened());
    }
    let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("between"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..wgpu::SamplerDescriptor::default()
    });
    let view = view(&texture);
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("photograph"),
        layout,
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: shown.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&view) },
            wgpu::BindGroupEntry { binding: 2, resource: wgpu::BindingResource::Sampler(&sampler) },
        ],
    })
}

fn window_of(level: &Level) -> Window {
    Window { width: level.width, height: level.height }
}

fn buffer(
    device: &wgpu::Device,
    label: &'static str,
    size: usize,
    usage: wgpu::BufferUsages,
) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: size as u64,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

fn sampler_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        count: None,
    }
}

fn draw_pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    bindings: &wgpu::BindGroupLayout,
) -> wgpu::RenderPipeline {
    let corner = |attributes| wgpu::VertexBufferLayout {
        array_stride: size_of::<[f32; 2]>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes,
    };
    // Triangles come from the front to the back: each is laid under what is there.
    let under = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::OneMinusDstAlpha,
        dst_factor: wgpu::BlendFactor::One,
        operation: wgpu::BlendOperation::Add,
    };
    let blend = Some(wgpu::BlendState { color: under, alpha: under });
    Pipeline {
        module,
        bindings,
        vertex: "sheet_vertex",
        fragment: "sheet_fragment",
        buffers: &[
            Some(corner(&wgpu::vertex_attr_array![0 => Float32x2])),
            Some(corner(&wgpu::vertex_attr_array![1 => Float32x2])),
        ],
        topology: wgpu::PrimitiveTopology::TriangleList,
        depth: None,
        targets: &[Some(wgpu::ColorTargetState {
            format: PICTURE_FORMAT,
            blend,
            write_mask: wgpu::ColorWrites::ALL,
        })],
    }
    .create(device)
}
