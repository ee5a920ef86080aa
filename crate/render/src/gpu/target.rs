//! What points are drawn into.

use bytemuck::{Pod, Zeroable};

use super::device::Gpu;
#[cfg(feature = "webgpu")]
use super::interface::Compute;
use super::interface::{Buffer, ReadBack, Texture, Usage, draw};
use super::pass::{Bound, Draw, Pass};
use super::pipelines::{Kind, Pipelines};
use super::words::Format;
use crate::picture::window::Window;
use crate::plan::Batch;
use crate::points::Sides;

/// A texture of codes, sums or colours, and what is needed to draw points into it and to show it.
#[derive(Debug)]
pub(super) struct Target {
    pub window: Window,
    pub kind: Kind,
    pixels: Texture,
    depth: Option<Texture>,
    screen: Buffer,
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

/// What is drawn with: the pipelines, and colours for what is coloured as it is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paint<'a> {
    pub pipelines: &'a Pipelines,
    pub colours: &'a Buffer,
}

impl Target {
    /// A target with nothing on it.
    pub fn new(gpu: &Gpu, kind: Kind, window: Window) -> Self {
        let depth = || Texture::new(&gpu.card, "depth", window, Format::Depth);
        Self {
            window,
            kind,
            pixels: Texture::new(&gpu.card, "pixels", window, kind.format()),
            depth: (kind == Kind::Codes).then(depth),
            screen: Buffer::new(&gpu.card, "screen", Usage::Uniform),
        }
    }

    /// Replaces what it holds by a picture, four bytes a pixel, row after row.
    pub fn write(&self, gpu: &Gpu, bytes: &[u8]) {
        self.pixels.write(&gpu.card, 0, self.window, bytes);
    }

    /// Sets what masses are multiplied by, whether pieces have colours of their own, and along which sides they
    /// are twisted.
    pub fn prepare(&self, gpu: &Gpu, mass: f32, tinted: bool, sides: Sides) {
        let size = [self.window.width as f32, self.window.height as f32];
        let screen = Screen { size, mass, tinted: f32::from(u8::from(tinted)), sides };
        self.screen.set(&gpu.card, &[screen]);
    }

    /// Draws batches of points, on nothing or on what was drawn before.
    pub fn draw(
        &self,
        gpu: &Gpu,
        paint: Paint<'_>,
        clear: bool,
        vertices: &Buffer,
        instances: &Buffer,
        batches: &[Batch],
    ) {
        let Some(pipeline) = paint.pipelines.points(self.kind) else { return };
        let pass = Pass {
            pipeline,
            bindings: &[(0, Bound::Uniform(&self.screen)), (1, Bound::Uniform(paint.colours))],
            onto: &[&self.pixels],
            depth: self.depth.as_ref(),
            clear,
        };
        let some = batches.iter().filter(|batch| batch.points() > 0);
        // WebGL has no base instance: the ranges are taken from the buffers instead.
        let draws = some.map(|batch| Draw {
            buffers: [Some((vertices, batch.vertices.start)), Some((instances, batch.instances.start))],
            indices: None,
            count: batch.vertices.len() as u32,
            instances: batch.instances.len() as u32,
        });
        draw(&gpu.card, &pass, draws);
    }

    /// Replaces its codes by what so many groups compute into the last of the buffers.
    #[cfg(feature = "webgpu")]
    pub fn compute(&self, gpu: &Gpu, compute: &Compute, buffers: &[&Buffer], groups: u32) {
        compute.run(&gpu.card, buffers, groups, true, &self.pixels);
    }

    /// Begins to read what it holds, four bytes a pixel: its codes, or its colours.
    pub fn read(&self, gpu: &Gpu) -> ReadBack {
        gpu.read(&self.pixels)
    }

    /// Makes a picture of it.
    pub fn resolve(&self, gpu: &Gpu, paint: Paint<'_>, picture: &Texture) {
        let pass = Pass {
            pipeline: paint.pipelines.show(self.kind),
            bindings: &[
                (1, Bound::Uniform(paint.colours)),
                (self.kind.texture_binding(), Bound::Texture(&self.pixels)),
            ],
            onto: &[picture],
            depth: None,
            clear: true,
        };
        draw(&gpu.card, &pass, [Draw::SCREEN]);
    }
}
