//! A stage for attractors of space.

use frond_core::Ifs3;

use super::pipelines::Pipelines3;
use super::target::Target3;
use crate::colour::Look;
use crate::gpu::buffer::{Buffer, uniform};
use crate::gpu::device::Gpu;
use crate::gpu::readback::ReadBack;
use crate::space::{Camera, Carve, Cloud, Eye, Instance3, Lamp, Lighting, MAX_OBJECTS, Vertex3};
use crate::window::Window;

/// What [`Stage3::draw`] came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn3 {
    /// Whether every pixel that a piece reaches is lit.
    pub complete: bool,
    /// The number of points in the picture that is shown; 0 where it is the complete one.
    pub points: u64,
}

/// Pieces that one call of [`Stage3::draw`] carves at most, for each point of its budget.
const CARVED: u64 = 1;

/// Draws attractors of space on one canvas.
///
/// After each change the next call of [`draw`](Self::draw) shows the same clouds of points as the camera has them now.
/// When nothing changes, the calls after it carve the complete picture aside and show it when it is done.
#[derive(Debug)]
pub struct Stage3 {
    gpu: Gpu,
    pipelines: Pipelines3,
    window: Window,
    /// Pixels that are carved for each one shown, each way.
    factor: u32,
    systems: Vec<Ifs3>,
    batches: Vec<Batch3>,
    camera: Option<Camera>,
    lighting: Lighting,
    look: Look,
    target: Option<[Target3; 2]>,
    carved: Option<Target3>,
    carve: Option<Carve>,
    eye: wgpu::Buffer,
    lamp: wgpu::Buffer,
    look_buffer: wgpu::Buffer,
    range: [f32; 2],
    stale: bool,
    complete: bool,
}

#[derive(Debug)]
struct Batch3 {
    vertices: Buffer,
    instances: Buffer,
    counts: [u32; 2],
}

impl Stage3 {
    /// A stage on a device, with nothing on it.
    #[must_use]
    pub fn new(gpu: Gpu, look: Look) -> Self {
        Self {
            pipelines: Pipelines3::new(&gpu.device, gpu.format()),
            window: Window { width: 0, height: 0 },
            factor: 1,
            systems: Vec::new(),
            batches: Vec::new(),
            camera: None,
            lighting: Lighting::default(),
            look,
            target: None,
            carved: None,
            carve: None,
            eye: uniform::<Eye>(&gpu.device, "eye"),
            lamp: uniform::<Lamp>(&gpu.device, "lamp"),
            look_buffer: uniform::<Look>(&gpu.device, "look"),
            range: [0.0, 1.0],
            stale: true,
            complete: false,
            gpu,
        }
    }

    /// The device.
    #[must_use]
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Sets the size of the canvas in pixels, and how many are carved for each one, each way: 1 or 2.
    pub fn resize(&mut self, width: u32, height: u32, factor: u32) {
        let most = self.gpu.max_side;
        let window = Window { width: width.min(most), height: height.min(most) };
        let factor = if factor > 1 && 2 * window.width.max(window.height) <= most { 2 } else { 1 };
        if (window, factor) == (self.window, self.factor) {
            return;
        }
        (self.window, self.factor) = (window, factor);
        self.gpu.resize(window.width, window.height);
        (self.target, self.carved) = (None, None);
        self.change();
    }

    /// Sets what is shown: `points` in all, shared by the systems. Those that are too many are left out.
    pub fn set_systems(&mut self, systems: Vec<Ifs3>, points: usize) {
        let share = points / systems.len().clamp(1, MAX_OBJECTS);
        self.batches = systems
            .iter()
            .take(MAX_OBJECTS)
            .enumerate()
            .map(|(number, ifs)| {
                let cloud = Cloud::new(ifs, number as u32, share, 1 + number as u32);
                let mut batch = Batch3 {
                    vertices: Buffer::new(&self.gpu.device, "points of space"),
                    instances: Buffer::new(&self.gpu.device, "pieces of space"),
                    counts: [cloud.vertices.len() as u32, cloud.instances.len() as u32],
                };
                batch.vertices.fill(&self.gpu.device, &self.gpu.queue, &cloud.vertices);
                batch.instances.fill(&self.gpu.device, &self.gpu.queue, &cloud.instances);
                batch
            })
            .collect();
        self.systems = systems;
        self.change();
    }

    /// Sets where it is seen from.
    pub fn set_camera(&mut self, camera: Camera) {
        if self.camera != Some(camera) {
            self.camera = Some(camera);
            self.change();
        }
    }

    /// Sets light and colours. What was carved stays.
    pub fn set_lighting(&mut self, lighting: Lighting, look: Look) {
        (self.lighting, self.look) = (lighting, look);
        self.stale = true;
    }

    fn change(&mut self) {
        (self.stale, self.complete, self.carve) = (true, false, None);
    }

    /// Shows the present picture, or works on the complete one: looks at `budget` pieces at most.
    pub fn draw(&mut self, budget: u64) -> Drawn3 {
        let points = self.batches.iter().map(|b| u64::from(b.counts[0]) * u64::from(b.counts[1])).sum();
        let ready = self.window.width > 0 && self.window.height > 0 && !self.gpu.is_lost();
        let Some(camera) = self.camera.filter(|_| ready) else {
            return Drawn3 { complete: self.gpu.is_lost(), points: 0 };
        };
        let fresh = self.carve.is_none();
        let [width, height] = [self.window.width, self.window.height].map(|side| side * self.factor);
        let carve = self.carve.get_or_insert_with(|| Carve::new(&self.systems, &camera, width, height));
        self.range = carve.range();
        // The first frame after a change is for the points alone.
        if !fresh && !self.complete && carve.run((budget * CARVED) as usize) {
            let window = Window { width, height };
            let carved = self.carved.get_or_insert_with(|| Target3::new(&self.gpu, window));
            carved.write(&self.gpu, carve.relief());
            (self.complete, self.stale) = (true, true);
        }
        if self.stale {
            if !self.complete {
                self.draw_points(&camera);
            }
            self.show();
        }
        Drawn3 { complete: self.complete, points: if self.complete { 0 } else { points } }
    }

    fn draw_points(&mut self, camera: &Camera) {
        let window = self.window;
        let [raw, mended] =
            self.target.get_or_insert_with(|| [0, 1].map(|_| Target3::new(&self.gpu, window)));
        let eye = Eye::new(camera, window.width, window.height, self.range);
        self.gpu.queue.write_buffer(&self.eye, 0, bytemuck::bytes_of(&eye));
        let lamp = Lamp::new(&self.lighting, camera, [window.width, window.height], 1, self.range);
        self.gpu.queue.write_buffer(&self.lamp, 0, bytemuck::bytes_of(&lamp));
        let bindings = self.gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("eye"),
            layout: &self.pipelines.eye_layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: self.eye.as_entire_binding() }],
        });
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = raw.pass(&mut encoder, true);
            pass.set_pipeline(&self.pipelines.points);
            pass.set_bind_group(0, &bindings, &[]);
            for batch in &self.batches {
                let [vertices, instances] = batch.counts;
                pass.set_vertex_buffer(0, batch.vertices.items::<Vertex3>(&(0..vertices)));
                pass.set_vertex_buffer(1, batch.instances.items::<Instance3>(&(0..instances)));
                pass.draw(0..vertices, 0..instances);
            }
        }
        let bindings = raw.bindings(&self.gpu, &self.pipelines, &self.lamp, &self.look_buffer);
        {
            let mut pass = mended.pass(&mut encoder, false);
            pass.set_pipeline(&self.pipelines.mend);
            pass.set_bind_group(0, &bindings, &[]);
            pass.draw(0..3, 0..1);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// Lights what is there into a picture.
    fn light(
        &self,
        picture: &wgpu::TextureView,
        pipeline: &wgpu::RenderPipeline,
        premultiply: f32,
    ) -> Option<wgpu::CommandEncoder> {
        let camera = self.camera.as_ref()?;
        let (target, factor) =
            if self.complete { (self.carved.as_ref()?, self.factor) } else { (&self.target.as_ref()?[1], 1) };
        let size = [target.window.width, target.window.height];
        let lamp = Lamp::new(&self.lighting, camera, size, factor, self.range);
        self.gpu.queue.write_buffer(&self.lamp, 0, bytemuck::bytes_of(&lamp));
        let look = Look { premultiply, ..self.look };
        self.gpu.queue.write_buffer(&self.look_buffer, 0, bytemuck::bytes_of(&look));
        let bindings = target.bindings(&self.gpu, &self.pipelines, &self.lamp, &self.look_buffer);
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("light"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: picture,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                        store: wgpu::StoreOp::Store,
                    },
                })],
                ..wgpu::RenderPassDescriptor::default()
            });
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &bindings, &[]);
            pass.draw(0..3, 0..1);
        }
        Some(encoder)
    }

    fn show(&mut self) {
        let Some(frame) = self.gpu.frame() else { return };
        let view = frame.texture.create_view(&wgpu::TextureViewDescriptor::default());
        if let Some(encoder) = self.light(&view, &self.pipelines.show, 1.0) {
            self.gpu.queue.submit([encoder.finish()]);
            self.stale = false;
        }
        self.gpu.queue.present(frame);
    }

    /// Begins to read the picture that is shown, with straight alpha. `None` where there is none.
    #[must_use]
    pub fn read(&self) -> Option<ReadBack> {
        if self.gpu.is_lost() || self.window.width == 0 || self.window.height == 0 {
            return None;
        }
        let texture = ReadBack::texture(&self.gpu, self.window);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let encoder = self.light(&view, &self.pipelines.read, 0.0)?;
        Some(ReadBack::begin(&self.gpu, encoder, &texture, self.window))
    }
}
