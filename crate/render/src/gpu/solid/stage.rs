//! A stage for attractors of space.

use super::pipelines::Pipelines3;
use super::target::Target3;
use crate::gpu::buffer::{Buffer, uniform};
use crate::gpu::device::Gpu;
use crate::gpu::pipeline::draw_full_screen;
use crate::gpu::readback::ReadBack;
use crate::picture::colour::Colours;
use crate::picture::window::Window;
use crate::solid::{Cloud, Eye, Instance3, Lamp, MAX_OBJECTS, SplatStep, Vertex3};

/// What [`Stage3::draw`] came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn3 {
    /// Whether it is the carved picture that is shown: every pixel that a piece reaches is lit.
    pub complete: bool,
    /// The number of points in the picture that is shown; 0 where it is the complete one.
    pub points: u64,
}

/// How a picture is seen and lit, as the shaders read it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniforms3 {
    /// Where points are seen.
    pub eye: Eye,
    /// What lights them.
    pub lamp: Lamp,
    /// What lights the carved picture, which may have more pixels.
    pub still_lamp: Lamp,
    /// Their colours.
    pub colours: Colours,
}

/// Draws attractors of space on one canvas.
///
/// A change of the clouds, the size or the eye shows points; a carved picture, which somebody makes meanwhile, is shown
/// from when it is [put](Self::put_still) there until the next such change. Where nothing changes nothing is done.
#[derive(Debug)]
pub struct Stage3 {
    gpu: Gpu,
    pipelines: Pipelines3,
    window: Window,
    batches: Vec<Batch3>,
    uniforms: Option<Uniforms3>,
    target: Option<[Target3; 2]>,
    /// Which of them holds the picture.
    shown: usize,
    still: Option<Target3>,
    eye: wgpu::Buffer,
    lamp: wgpu::Buffer,
    /// One for each length of a step.
    splats: Vec<wgpu::Buffer>,
    colours_buffer: wgpu::Buffer,
    stale: bool,
    complete: bool,
}

#[derive(Debug)]
struct Batch3 {
    vertices: Buffer,
    instances: Buffer,
    counts: [u32; 2],
    gap: f32,
}

impl Stage3 {
    /// A stage on a device, with nothing on it.
    #[must_use]
    pub fn new(gpu: Gpu) -> Self {
        Self {
            pipelines: Pipelines3::new(&gpu.device, gpu.format()),
            window: Window { width: 0, height: 0 },
            batches: Vec::new(),
            uniforms: None,
            target: None,
            shown: 0,
            still: None,
            eye: uniform::<Eye>(&gpu.device, "eye"),
            lamp: uniform::<Lamp>(&gpu.device, "lamp"),
            splats: Vec::new(),
            colours_buffer: uniform::<Colours>(&gpu.device, "colours"),
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

    /// Sets the size of the canvas in pixels.
    pub fn resize(&mut self, width: u32, height: u32) {
        let most = self.gpu.max_side;
        let window = Window { width: width.min(most), height: height.min(most) };
        if window == self.window {
            return;
        }
        self.window = window;
        self.gpu.resize(window.width, window.height);
        (self.target, self.still) = (None, None);
        self.change();
    }

    /// Sets the points, a cloud for each object. Those that are too many are left out.
    pub fn set_clouds(&mut self, clouds: &[Cloud]) {
        let batch = |cloud: &Cloud| {
            let mut batch = Batch3 {
                vertices: Buffer::new(&self.gpu.device, "points of space"),
                instances: Buffer::new(&self.gpu.device, "pieces of space"),
                counts: [cloud.vertices.len() as u32, cloud.instances.len() as u32],
                gap: cloud.gap,
            };
            batch.vertices.fill(&self.gpu.device, &self.gpu.queue, &cloud.vertices);
            batch.instances.fill(&self.gpu.device, &self.gpu.queue, &cloud.instances);
            batch
        };
        self.batches = clouds.iter().take(MAX_OBJECTS).map(batch).collect();
        self.change();
    }

    /// Sets where it is seen from, and light and colours. As long as the eye stays, so does a carved picture.
    pub fn set_uniforms(&mut self, uniforms: Uniforms3) {
        if self.uniforms.is_none_or(|before| before.eye != uniforms.eye) {
            self.change();
        }
        self.uniforms = Some(uniforms);
        self.stale = true;
    }

    /// Shows what was carved of the present clouds with the present eye: depths and codes, row by row from the top.
    /// Whether it is of the size of `still_lamp`.
    pub fn put_still(&mut self, [width, height]: [u32; 2], depth: &[f32], codes: &[u32]) -> bool {
        let Some(uniforms) = self.uniforms else { return false };
        let window = Window { width, height };
        let pixels = width as usize * height as usize;
        let size = [window.width, window.height].map(|side| side as i32);
        let most = self.gpu.max_side;
        let fits = depth.len() == pixels && codes.len() == pixels && pixels > 0 && width.max(height) <= most;
        if !fits || size != uniforms.still_lamp.size || self.gpu.is_lost() {
            return false;
        }
        if self.still.as_ref().is_none_or(|still| still.window != window) {
            self.still = Some(Target3::new(&self.gpu, window));
        }
        if let Some(still) = &self.still {
            still.write(&self.gpu, depth, codes);
        }
        (self.complete, self.stale) = (true, true);
        true
    }

    fn change(&mut self) {
        (self.stale, self.complete) = (true, false);
    }

    /// Shows the present picture, if it is not shown already.
    pub fn draw(&mut self) -> Drawn3 {
        let points = self.batches.iter().map(|b| u64::from(b.counts[0]) * u64::from(b.counts[1])).sum();
        let ready = self.window.width > 0 && self.window.height > 0 && !self.gpu.is_lost();
        let Some(uniforms) = self.uniforms.filter(|_| ready) else {
            return Drawn3 { complete: self.gpu.is_lost(), points: 0 };
        };
        if self.stale {
            if !self.complete {
                self.draw_points(&uniforms);
            }
            self.show();
        }
        Drawn3 { complete: self.complete, points: if self.complete { 0 } else { points } }
    }

    fn draw_points(&mut self, uniforms: &Uniforms3) {
        let window = self.window;
        let targets = self.target.get_or_insert_with(|| [0, 1].map(|_| Target3::new(&self.gpu, window)));
        self.gpu.queue.write_buffer(&self.eye, 0, bytemuck::bytes_of(&uniforms.eye));
        self.gpu.queue.write_buffer(&self.lamp, 0, bytemuck::bytes_of(&uniforms.lamp));
        let bindings = self.gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("eye"),
            layout: &self.pipelines.eye_layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: self.eye.as_entire_binding() }],
        });
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = targets[0].pass(&mut encoder, true);
            pass.set_pipeline(&self.pipelines.points);
            pass.set_bind_group(0, &bindings, &[]);
            for batch in &self.batches {
                let [vertices, instances] = batch.counts;
                pass.set_vertex_buffer(0, batch.vertices.items::<Vertex3>(&(0..vertices)));
                pass.set_vertex_buffer(1, batch.instances.items::<Instance3>(&(0..instances)));
                pass.draw(0..vertices, 0..instances);
            }
        }
        let gaps: Vec<f32> = self.batches.iter().map(|batch| batch.gap).collect();
        let Lamp { size, focal, range: [nearest, ..], .. } = uniforms.lamp;
        let steps = SplatStep::steps(size, focal, nearest, &gaps);
        while self.splats.len() < steps.len() {
            self.splats.push(uniform::<SplatStep>(&self.gpu.device, "splat"));
        }
        for (buffer, step) in self.splats.iter().zip(&steps) {
            self.gpu.queue.write_buffer(buffer, 0, bytemuck::bytes_of(step));
        }
        let splats = self.splats.iter().take(steps.len()).map(|buffer| (&self.pipelines.splat, buffer));
        // From one target to the other and back.
        self.shown = 0;
        for (pipeline, buffer) in splats.chain([(&self.pipelines.fill_holes, &self.lamp)]) {
            let bindings =
                targets[self.shown].bindings(&self.gpu, &self.pipelines, buffer, &self.colours_buffer);
            self.shown = 1 - self.shown;
            let mut pass = targets[self.shown].pass(&mut encoder, false);
            pass.set_pipeline(pipeline);
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
        let uniforms = self.uniforms.as_ref()?;
        let (target, lamp) = if self.complete {
            (self.still.as_ref()?, &uniforms.still_lamp)
        } else {
            (&self.target.as_ref()?[self.shown], &uniforms.lamp)
        };
        self.gpu.queue.write_buffer(&self.lamp, 0, bytemuck::bytes_of(lamp));
        let colours = Colours { premultiply, ..uniforms.colours };
        self.gpu.queue.write_buffer(&self.colours_buffer, 0, bytemuck::bytes_of(&colours));
        let bindings = target.bindings(&self.gpu, &self.pipelines, &self.lamp, &self.colours_buffer);
        Some(draw_full_screen(&self.gpu.device, pipeline, &bindings, picture))
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
