//! A stage for attractors of space.

use super::pipelines::Pipelines3;
use super::target::Target3;
use crate::gpu::device::Gpu;
use crate::gpu::interface::{Buffer, ReadBack, Texture, Usage, draw};
use crate::gpu::pass::{Bound, Draw, Pass};
use crate::gpu::words::Format;
use crate::picture::colour::Colours;
use crate::picture::window::Window;
use crate::solid::{Cloud, Eye, Lamp, MAX_OBJECTS, SplatStep};

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
    eye: Buffer,
    lamp: Buffer,
    /// One for each length of a step.
    splats: Vec<Buffer>,
    colours_buffer: Buffer,
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
            pipelines: Pipelines3::new(&gpu.card),
            window: Window { width: 0, height: 0 },
            batches: Vec::new(),
            uniforms: None,
            target: None,
            shown: 0,
            still: None,
            eye: Buffer::new(&gpu.card, "eye", Usage::Uniform),
            lamp: Buffer::new(&gpu.card, "lamp", Usage::Uniform),
            splats: Vec::new(),
            colours_buffer: Buffer::new(&gpu.card, "colours", Usage::Uniform),
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
                vertices: Buffer::new(&self.gpu.card, "points of space", Usage::Items),
                instances: Buffer::new(&self.gpu.card, "pieces of space", Usage::Items),
                counts: [cloud.vertices.len() as u32, cloud.instances.len() as u32],
                gap: cloud.gap,
            };
            batch.vertices.fill(&self.gpu.card, &cloud.vertices);
            batch.instances.fill(&self.gpu.card, &cloud.instances);
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
        let card = &self.gpu.card;
        self.eye.set(card, &[uniforms.eye]);
        self.lamp.set(card, &[uniforms.lamp]);
        let pass = Pass {
            pipeline: &self.pipelines.points,
            bindings: &[(0, Bound::Uniform(&self.eye))],
            onto: &[&targets[0].codes, &targets[0].depths],
            depth: Some(&targets[0].nearest),
            clear: true,
        };
        let some = self.batches.iter().filter(|batch| !batch.counts.contains(&0));
        let draws = some.map(|batch| Draw {
            buffers: [Some((&batch.vertices, 0)), Some((&batch.instances, 0))],
            indices: None,
            count: batch.counts[0],
            instances: batch.counts[1],
        });
        draw(card, &pass, draws);
        let gaps: Vec<f32> = self.batches.iter().map(|batch| batch.gap).collect();
        let Lamp { size, focal, range: [nearest, ..], .. } = uniforms.lamp;
        let steps = SplatStep::steps(size, focal, nearest, &gaps);
        while self.splats.len() < steps.len() {
            self.splats.push(Buffer::new(card, "splat", Usage::Uniform));
        }
        for (buffer, step) in self.splats.iter().zip(&steps) {
            buffer.set(card, &[*step]);
        }
        let splats = self.splats.iter().take(steps.len()).map(|buffer| (&self.pipelines.splat, buffer));
        // From one target to the other and back.
        self.shown = 0;
        for (pipeline, buffer) in splats.chain([(&self.pipelines.fill_holes, &self.lamp)]) {
            let (from, onto) = (&targets[self.shown], &targets[1 - self.shown]);
            let pass = Pass {
                pipeline,
                bindings: &from.bindings(buffer, &self.colours_buffer),
                onto: &[&onto.codes, &onto.depths],
                depth: None,
                clear: true,
            };
            draw(card, &pass, [Draw::SCREEN]);
            self.shown = 1 - self.shown;
        }
    }

    /// Lights what is there into a picture. Returns whether there is anything.
    fn light(&self, picture: &Texture, premultiply: f32) -> bool {
        let Some(uniforms) = &self.uniforms else { return false };
        let (target, lamp) = if self.complete {
            (self.still.as_ref(), &uniforms.still_lamp)
        } else {
            (self.target.as_ref().map(|targets| &targets[self.shown]), &uniforms.lamp)
        };
        let Some(target) = target else { return false };
        let card = &self.gpu.card;
        self.lamp.set(card, &[*lamp]);
        self.colours_buffer.set(card, &[Colours { premultiply, ..uniforms.colours }]);
        let pass = Pass {
            pipeline: &self.pipelines.show,
            bindings: &target.bindings(&self.lamp, &self.colours_buffer),
            onto: &[picture],
            depth: None,
            clear: true,
        };
        draw(card, &pass, [Draw::SCREEN]);
        true
    }

    fn show(&mut self) {
        let Some(frame) = self.gpu.frame() else { return };
        if self.light(&frame.texture, 1.0) {
            self.stale = false;
        }
        self.gpu.present(frame);
    }

    /// Begins to read the picture that is shown, with straight alpha. `None` where there is none.
    #[must_use]
    pub fn read(&self) -> Option<ReadBack> {
        if self.gpu.is_lost() || self.window.width == 0 || self.window.height == 0 {
            return None;
        }
        let texture = Texture::new(&self.gpu.card, "read", self.window, Format::Colours);
        self.light(&texture, 0.0).then(|| self.gpu.read(&texture))
    }
}
