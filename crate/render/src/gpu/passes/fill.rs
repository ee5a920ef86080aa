//! What the points of a complete picture left dark.

use crate::coverage::sweep::Progress;
use crate::gpu::state::{Shown, StageState, Work};
use crate::gpu::target::Paint;
use crate::picture::bitmap::Bitmap;
use crate::picture::window::Window;
use crate::plan::{PlacedPoints, Plan};
use crate::points::Instance;

/// Lights the pixels that points are too far apart for: finds out which are lit, and draws those that a sweep of the
/// dark ones finds.
///
/// Where points lie half a pixel apart, up to a pixel in ten of a thin shape stays dark, and one in a hundred of a
/// full one. Four times the points would halve that; to sweep what is left takes a tenth of a whole sweep.
#[derive(Debug)]
pub(in crate::gpu) struct FillPass {
    placed: PlacedPoints,
    dots: Vec<Instance>,
    /// Pixels lit so far.
    lit: u64,
}

/// Points placed in a frame: some milliseconds.
const PLACED_A_FRAME: u64 = 600_000;

impl Default for FillPass {
    fn default() -> Self {
        let nowhere = Window { width: 0, height: 0 };
        Self { placed: PlacedPoints::new(nowhere), dots: Vec::new(), lit: 0 }
    }
}

impl FillPass {
    /// All points of the picture are drawn: shows it, and goes on to fill it.
    pub fn begin(&mut self, state: &mut StageState, points: u64) {
        state.show(Shown::Back, state.sampling, points);
        state.work = Work::Place;
        self.placed.begin(state.target_window(state.sampling));
        self.lit = 0;
    }

    /// Places more points. Gives the pixels that they light, once all are placed.
    pub fn place(&mut self, plan: &Plan) -> Option<&Bitmap> {
        self.placed.go_on(plan, PLACED_A_FRAME).then(|| self.placed.lit())
    }

    /// Lights a pixel that was found.
    pub fn light(&mut self, pixel: (u32, u32), code: u32) {
        self.dots.push(Instance::dot(pixel, code));
    }

    /// Draws the pixels that were found, after a sweep got so far.
    pub fn draw(&mut self, state: &mut StageState, plan: &Plan, progress: Progress) {
        self.lit += self.dots.len() as u64;
        if let Some(back) = state.back.as_ref().filter(|_| !self.dots.is_empty()) {
            let paint = Paint { pipelines: &state.pipelines, colours: &state.colours };
            state.points_pass.dots(&state.gpu, paint, back, &self.dots);
            state.stale = true;
        }
        self.dots.clear();
        if progress != Progress::Working {
            let complete = progress == Progress::Complete && plan.exact;
            state.finish(Shown::Back, complete, plan.points() + self.lit);
        }
    }
}
