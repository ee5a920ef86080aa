//! Pictures of points that the card computes.

use crate::coverage::complete::Completion;
use crate::coverage::sweep::Progress;
use crate::gpu::device::Gpu;
use crate::gpu::interface::{Buffer, Compute, Usage};
use crate::gpu::shaders::SPLAT;
use crate::gpu::state::{SWEEP_SIZES, Shown, StageState, VISITS_A_FRAME, Work};
use crate::gpu::target::Target;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::splat::SplatPlan;

/// A [`SplatPlan`] that is drawn, and completed at rest.
#[derive(Debug)]
pub(in crate::gpu) struct SplatPass {
    compute: Compute,
    plan: SplatPlan,
    job: Buffer,
    pieces: Buffer,
    points: Buffer,
    codes: Buffer,
    /// What the codes are of.
    window: Window,
    /// The same placed by the processor: the piece that is next, and the codes.
    placed: (usize, Vec<u32>),
    completion: Option<Completion<u32>>,
}

/// About how many points a picture at rest has.
const POINTS_AT_REST: u64 = 3_000_000;
/// Points that the processor places in a frame: some milliseconds.
const PLACED_A_FRAME: u64 = 1_000_000;

impl SplatPass {
    pub fn new(gpu: &Gpu) -> Self {
        let card = &gpu.card;
        Self {
            compute: Compute::new(card, SPLAT, "splat"),
            plan: SplatPlan::default(),
            job: Buffer::new(card, "job", Usage::Uniform),
            pieces: Buffer::new(card, "pieces", Usage::Read),
            points: Buffer::new(card, "points", Usage::Read),
            codes: Buffer::new(card, "codes", Usage::Computed),
            window: Window { width: 0, height: 0 },
            placed: (0, Vec::new()),
            completion: None,
        }
    }

    /// The next shape is another one.
    pub fn forget(&mut self) {
        self.plan.forget();
    }

    /// Makes a whole picture within the budget, of fewer pixels if need be. Returns whether it can: not where pieces
    /// overlap too much, nor in a window that is too large for the card.
    pub fn draw_at_once(&mut self, state: &mut StageState, frame: &Frame, view: View, budget: u64) -> bool {
        let mut coarser = false;
        let mut factor;
        loop {
            factor = state.factor();
            if !self.plan(state, frame, view, factor) {
                return false;
            }
            if !state.resize_for(self.plan.count, budget, &mut coarser) {
                break;
            }
        }
        let target = state.fit(Shown::Front, factor);
        self.draw(&state.gpu, &target);
        state.front = Some(target);
        state.show(Shown::Front, factor, self.plan.count);
        true
    }

    /// Begins the complete picture. Returns whether it can.
    pub fn choose(&mut self, state: &mut StageState, frame: &Frame, view: View) -> bool {
        let factor = state.sampling;
        let (to_target, window) = (state.to_target(frame, view, factor), state.target_window(factor));
        let planned = self.plan(state, frame, view, factor)
            && self.plan.refine(frame, to_target, window, POINTS_AT_REST);
        if !planned {
            return false;
        }
        let target = state.fit(Shown::Back, factor);
        self.draw(&state.gpu, &target);
        state.back = Some(target);
        state.show(Shown::Back, factor, self.plan.count);
        self.placed = (0, vec![0; Self::row(window) * window.height as usize]);
        self.completion = None;
        state.work = Work::Place;
        true
    }

    /// Places more of the points that the card has placed: the processor comes to the same pixels.
    pub fn place(&mut self, state: &mut StageState, frame: &Frame, view: View) {
        let (next, codes) = &mut self.placed;
        *next = self.plan.place(*next, PLACED_A_FRAME, |at, code| {
            if let Some(pixel) = codes.get_mut(at) {
                *pixel = (*pixel).max(code);
            }
        });
        if *next < self.plan.pieces.len() {
            return;
        }
        let window = state.target_window(state.sampling);
        let row = Self::row(window);
        let rows = std::mem::take(&mut self.placed.1);
        let codes = rows.chunks(row).flat_map(|row| &row[..window.width as usize]).copied().collect();
        let to_target = state.to_target(frame, view, state.sampling);
        self.completion = Some(Completion::new(frame, to_target, window, SWEEP_SIZES.1, codes));
        state.work = Work::Fill;
    }

    /// Looks for more of the pixels that points left dark, and shows them when all are found.
    pub fn fill(&mut self, state: &mut StageState, frame: &Frame) {
        let Some(completion) = &mut self.completion else { return };
        let progress = completion.run(frame, VISITS_A_FRAME);
        if progress == Progress::Working {
            return;
        }
        if let Some(back) = &state.back {
            back.write(&state.gpu, bytemuck::cast_slice(&completion.codes));
        }
        let points = self.plan.count + completion.lit;
        self.completion = None;
        state.finish(Shown::Back, progress == Progress::Complete, points);
    }

    /// Plans a picture of so many pixels each way for each that is shown.
    fn plan(&mut self, state: &StageState, frame: &Frame, view: View, factor: f64) -> bool {
        let window = state.target_window(factor);
        let row = Self::row(window);
        let fits = row as u64 * u64::from(window.height) <= state.gpu.card.most_codes;
        fits && self.plan.make(frame, state.to_target(frame, view, factor), window, row as u32)
    }

    /// The places of a row.
    fn row(window: Window) -> usize {
        Compute::row(window.width) as usize
    }

    /// Draws what was planned.
    fn draw(&mut self, gpu: &Gpu, target: &Target) {
        self.pieces.fill(&gpu.card, &self.plan.pieces);
        self.points.fill(&gpu.card, &self.plan.points);
        let row = Compute::row(target.window.width);
        if self.window != target.window {
            self.window = target.window;
            self.codes.hold(&gpu.card, 4 * u64::from(row) * u64::from(self.window.height));
        }
        self.job.set(&gpu.card, &[row, self.plan.kept, self.plan.pieces.len() as u32, 0]);
        self.draw_again(gpu, target);
    }

    /// Draws it once more. Returns how many points that are.
    pub fn draw_again(&self, gpu: &Gpu, target: &Target) -> u64 {
        let buffers = [&self.job, &self.pieces, &self.points, &self.codes];
        target.compute(gpu, &self.compute, &buffers, self.plan.pieces.len() as u32);
        self.plan.count
    }
}
