//! Pictures of densities.

use crate::density::Density;
use crate::gpu::device::Gpu;
use crate::gpu::interface::{Buffer, Usage};
use crate::gpu::target::{Paint, Target};
use crate::picture::colour::Colours;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::measure::Sample;
use crate::plan::Batch;
use crate::points::{Instance, Vertex};

/// A [`Density`] that is drawn in passes.
#[derive(Debug)]
pub(in crate::gpu) struct DensityPass {
    density: Option<Density>,
    vertices: Buffer,
    instances: Buffer,
    samples: Vec<Sample>,
    cloud: Vec<Vertex>,
    /// Where there is no graphics card: what it would have added up.
    sums: Vec<[f32; 4]>,
    passes: u16,
    /// Points drawn so far.
    pub points: u64,
}

/// How many pieces there are.
const PIECES_MEASURED: usize = 384;
/// The fewest and the most samples for each of them in a pass.
const SAMPLE_RANGE: (usize, usize) = (32, 2048);
/// Points for each lit pixel until a picture is complete, and at most in all.
const POINTS_A_PIXEL: u64 = 96;
const MOST_POINTS: u64 = 32_000_000;
/// The same without a graphics card.
const SOFTWARE_POINTS: u64 = 1_000_000;
/// Weights are scaled down so that their sums stay within a half float.
const WEIGHT_SCALE: f32 = 1.0 / 64.0;

impl DensityPass {
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            density: None,
            vertices: Buffer::new(&gpu.card, "samples", Usage::Items),
            instances: Buffer::new(&gpu.card, "heavy pieces", Usage::Items),
            samples: Vec::new(),
            cloud: Vec::new(),
            sums: Vec::new(),
            passes: 0,
            points: 0,
        }
    }

    /// The density of a picture, in passes of at most about half of `budget` points.
    pub fn density(frame: &Frame, view: View, window: Window, budget: u64) -> Density {
        let samples = (budget as usize / (2 * PIECES_MEASURED)).clamp(SAMPLE_RANGE.0, SAMPLE_RANGE.1);
        Density::new(frame, view, window, PIECES_MEASURED, samples)
    }

    /// Begins a picture.
    pub fn begin(&mut self, gpu: &Gpu, density: Density) {
        let pieces = density.pieces.iter();
        let instances: Vec<_> = pieces
            .map(|piece| Instance::new(&piece.map, piece.letters, piece.mass as f32 * density.gain))
            .collect();
        self.instances.fill(&gpu.card, &instances);
        self.density = Some(density);
        self.sums.clear();
        self.passes = 0;
        self.points = 0;
    }

    /// Adds about `budget` points. Returns whether there are enough.
    pub fn go_on(
        &mut self,
        gpu: &Gpu,
        paint: Paint<'_>,
        frame: &Frame,
        target: &Target,
        budget: u64,
    ) -> bool {
        let Some(density) = &mut self.density else { return true };
        let wanted = (density.lit as u64 * POINTS_A_PIXEL).min(MOST_POINTS);
        let end = (self.points + budget).min(wanted);
        target.prepare(gpu, WEIGHT_SCALE, false, [0.0; 4]);
        loop {
            density.sampler.fill(frame, &mut self.samples);
            self.cloud.clear();
            let samples = self.samples.iter();
            self.cloud.extend(samples.map(|s| Vertex::new(s.position, s.letters, s.mass)));
            self.vertices.fill(&gpu.card, &self.cloud);
            let all =
                Batch { vertices: 0..self.cloud.len() as u32, instances: 0..density.pieces.len() as u32 };
            let clear = self.passes == 0;
            let batches = std::slice::from_ref(&all);
            target.draw(gpu, paint, clear, &self.vertices, &self.instances, batches);
            self.passes = self.passes.saturating_add(1);
            self.points += all.points();
            if all.points() == 0 || self.passes == u16::MAX {
                return true;
            }
            if self.points + all.points() > end {
                return self.points + all.points() > wanted;
            }
        }
    }

    /// The same on the processor.
    pub fn go_on_without(&mut self, frame: &Frame, colours: &Colours, window: Window) -> bool {
        let Some(density) = &mut self.density else { return true };
        self.sums.resize(window.area(), [0.0; 4]);
        let wanted = (density.lit as u64 * POINTS_A_PIXEL).min(MOST_POINTS);
        let end = (self.points + SOFTWARE_POINTS).min(wanted);
        loop {
            let points = density.accumulate(frame, colours, window, &mut self.samples, &mut self.sums) as u64;
            self.passes = self.passes.saturating_add(1);
            self.points += points;
            let enough = points == 0 || self.passes == u16::MAX || self.points >= wanted;
            if enough || self.points >= end {
                return enough;
            }
        }
    }

    /// The sums that the processor added up.
    pub fn sums(&self) -> &[[f32; 4]] {
        &self.sums
    }

    /// What those are multiplied by to have 1 for a middle tone.
    pub fn software_gain(&self) -> f32 {
        self.density.as_ref().map_or(0.0, Density::tone_gain) / f32::from(self.passes.max(1))
    }

    /// The same for the sums of the graphics card.
    pub fn gain(&self) -> f32 {
        self.software_gain() / WEIGHT_SCALE
    }

    /// How steep tones are.
    pub fn slope(&self) -> f32 {
        self.density.as_ref().map_or(1.0, |density| density.tone.slope)
    }
}
