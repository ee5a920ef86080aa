//! What a stage draws while nothing is bent.

use frond_core::Colouring;

use crate::coverage::sweep::Progress;
use crate::gpu::device::Gpu;
use crate::gpu::passes::cpu::CpuPass;
use crate::gpu::passes::density::DensityPass;
use crate::gpu::passes::fill::FillPass;
#[cfg(feature = "webgpu")]
use crate::gpu::passes::splats::SplatPass;
use crate::gpu::state::{
    MOST_FINE_POINTS, MOST_POINTS, SWEEP_SIZES, Shown, StageState, VISITS_A_FRAME, Work,
};
use crate::gpu::target::Paint;
#[cfg(all(feature = "webgpu", not(target_arch = "wasm32")))]
use crate::gpu::{passes::points::PointsPass, target::Target};
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::plan::{Detail, Plan};

/// A picture as points, or swept where points would be dear or without end.
#[derive(Debug)]
pub(in crate::gpu) struct PlainPass {
    plan: Plan,
    /// At once, and complete.
    swept: [CpuPass; 2],
    fill: FillPass,
    /// What draws where the card computes, unless pieces overlap too much.
    #[cfg(feature = "webgpu")]
    pub splats: Option<SplatPass>,
    /// Whether it drew what is shown.
    #[cfg(feature = "webgpu")]
    splat: bool,
}

/// Whether vertices make exact pictures, too. In a browser they do not where the card computes: what it does not
/// compute overlaps too much for them as well, and the module is smaller.
const EXACT: bool = cfg!(not(all(feature = "webgpu", target_arch = "wasm32")));

impl PlainPass {
    #[cfg_attr(not(feature = "webgpu"), expect(unused_variables, reason = "WebGL2 does not compute"))]
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            plan: Plan::default(),
            swept: [CpuPass::new(), CpuPass::new()],
            fill: FillPass::default(),
            #[cfg(feature = "webgpu")]
            splats: Some(SplatPass::new(gpu)),
            #[cfg(feature = "webgpu")]
            splat: false,
        }
    }

    /// The next shape is another one.
    pub fn forget(&mut self) {
        #[cfg(feature = "webgpu")]
        if let Some(splats) = &mut self.splats {
            splats.forget();
        }
    }

    /// What was swept, at once or when complete: its codes and the window they are of.
    pub fn codes(&self, back: usize) -> (&[u32], Window) {
        self.swept[back].codes()
    }

    /// Draws more of the picture: about `budget` points.
    pub fn advance(&mut self, state: &mut StageState, frame: &Frame, view: View, budget: u64) {
        #[cfg(feature = "webgpu")]
        if self.compute(state, frame, view, budget) {
            return;
        }
        match state.work {
            Work::Anew | Work::Moved | Work::Plan => {
                state.complete = false;
                state.work = Work::Choose;
                if state.style.colouring == Colouring::Density && state.gpu.densities {
                    state.density.begin(&state.gpu, DensityPass::density(frame, view, state.window, budget));
                    state.add_density(frame, budget);
                } else if state.gpu.software {
                    self.sweep_at_once(state, frame, view, budget);
                } else {
                    self.draw_at_once(state, frame, view, budget);
                }
            }
            Work::Choose => self.choose(state, frame, view, budget),
            Work::Points if EXACT => {
                let Some(back) = &state.back else { return };
                if state.points_pass.go_on(
                    &state.gpu,
                    Paint { pipelines: &state.pipelines, colours: &state.colours },
                    &self.plan,
                    back,
                    budget,
                ) {
                    self.fill.begin(state, self.plan.points());
                }
            }
            Work::Place if EXACT => {
                if let Some(lit) = self.fill.place(&self.plan) {
                    let to_target = state.to_target(frame, view, state.sampling);
                    self.swept[1].begin_on(frame, to_target, lit, SWEEP_SIZES.1);
                    state.work = Work::Fill;
                }
            }
            Work::Fill if EXACT => {
                let Self { plan, swept: [_, swept], fill, .. } = self;
                let progress = swept.find(VISITS_A_FRAME, &mut |pixel, code| fill.light(pixel, code));
                fill.draw(state, plan, progress);
            }
            Work::Sweep => {
                let progress =
                    self.swept[1].go_on(if state.gpu.software { 2 * VISITS_A_FRAME } else { VISITS_A_FRAME });
                if progress != Progress::Working {
                    state.finish(Shown::SweptBack, progress == Progress::Complete, self.swept[1].lit);
                }
            }
            Work::Density => state.add_density(frame, budget),
            Work::Points | Work::Place | Work::Fill | Work::Done => {}
        }
    }

    /// Has the card compute more of the picture, if that is how it is drawn.
    #[cfg(feature = "webgpu")]
    fn compute(&mut self, state: &mut StageState, frame: &Frame, view: View, budget: u64) -> bool {
        let Some(splats) = &mut self.splats else { return false };
        if state.gpu.software || state.style.colouring == Colouring::Density {
            return false;
        }
        match state.work {
            Work::Anew | Work::Moved | Work::Plan => {
                self.splat = splats.draw_at_once(state, frame, view, budget);
                if self.splat {
                    (state.complete, state.work) = (false, Work::Choose);
                }
            }
            Work::Choose if self.splat => self.splat = splats.choose(state, frame, view),
            Work::Place if self.splat => splats.place(state, frame, view),
            Work::Fill if self.splat => splats.fill(state, frame),
            _ => return false,
        }
        self.splat
    }

    /// Draws all points of the plan once more. Returns how many there are.
    #[cfg(all(feature = "webgpu", not(target_arch = "wasm32")))]
    pub fn draw_again(&self, points: &mut PointsPass, gpu: &Gpu, paint: Paint<'_>, target: &Target) -> u64 {
        match &self.splats {
            Some(splats) => splats.draw_again(gpu, target),
            None => {
                points.begin(gpu, &self.plan, target);
                points.go_on(gpu, paint, &self.plan, target, u64::MAX);
                self.plan.points()
            }
        }
    }

    /// Makes a whole picture within the budget, of fewer pixels if need be.
    fn draw_at_once(&mut self, state: &mut StageState, frame: &Frame, view: View, budget: u64) {
        let mut coarser = false;
        loop {
            let factor = state.factor();
            let to_target = state.to_target(frame, view, factor);
            if EXACT {
                self.plan.make(frame, to_target, state.target_window(factor), Detail::LADDER[0]);
            } else {
                self.plan.make_roughly(frame, to_target, state.target_window(factor), Detail::LADDER[0]);
            }
            let points = self.plan.points();
            if !state.resize_for(points, budget, &mut coarser) {
                break;
            }
        }
        let factor = state.factor();
        let target = state.fit(Shown::Front, factor);
        state.points_pass.begin(&state.gpu, &self.plan, &target);
        state.points_pass.go_on(
            &state.gpu,
            Paint { pipelines: &state.pipelines, colours: &state.colours },
            &self.plan,
            &target,
            u64::MAX,
        );
        state.front = Some(target);
        state.show(Shown::Front, factor, self.plan.points());
    }

    /// The same by a sweep: a visit takes about as long as a point does where there is no graphics card.
    fn sweep_at_once(&mut self, state: &mut StageState, frame: &Frame, view: View, budget: u64) {
        let visits = budget.clamp(60_000, 400_000);
        loop {
            let factor = state.factor();
            let to_target = state.to_target(frame, view, factor);
            self.swept[0].begin(frame, to_target, state.target_window(factor), SWEEP_SIZES.0);
            if self.swept[0].go_on(visits) != Progress::Working || !state.halve() {
                break;
            }
        }
        state.show(Shown::SweptFront, state.factor(), self.swept[0].lit);
        if state.halvings > 0 && self.swept[0].visited() * 5 < visits {
            state.halvings -= 1;
        }
    }

    /// Chooses how to draw the complete picture: as points if they are soon drawn, as fine as may be; else
    /// by a sweep.
    fn choose(&mut self, state: &mut StageState, frame: &Frame, view: View, budget: u64) {
        let factor = state.sampling;
        let window = state.target_window(factor);
        let to_target = state.to_target(frame, view, factor);
        let mut finest = None;
        // A sweep takes about as many visits as the coarsest plan has points.
        let mut most = MOST_POINTS;
        for detail in Detail::LADDER.into_iter().filter(|_| EXACT && !state.gpu.software) {
            self.plan.make(frame, to_target, window, detail);
            let points = self.plan.points();
            if finest.is_none() {
                most = most.min(points.div_ceil(VISITS_A_FRAME).saturating_mul(2 * budget));
            }
            if !self.plan.exact || points > most {
                break;
            }
            finest = Some(detail);
            most = most.min(MOST_FINE_POINTS);
            // The next would have two to four times as many.
            if points * 3 > most || self.plan.vertices.len() > 60_000 {
                break;
            }
        }
        if let Some(detail) = finest.filter(|_| EXACT) {
            self.plan.make(frame, to_target, window, detail);
            let target = state.fit(Shown::Back, factor);
            state.points_pass.begin(&state.gpu, &self.plan, &target);
            state.back = Some(target);
            state.work = Work::Points;
        } else {
            self.swept[1].begin(frame, to_target, window, SWEEP_SIZES.1);
            state.work = Work::Sweep;
        }
    }
}
