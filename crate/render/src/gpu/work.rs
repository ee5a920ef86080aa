//! What a stage does in each frame.

use frond_core::Affine2;

use super::passes::density::Weighed;
use super::pipelines::Kind;
use super::stage::Stage;
use super::target::Target;
use crate::coverage::sweep::Progress;
use crate::picture::colour::Colouring;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::plan::Detail;

/// The most points of a complete picture.
pub(super) const MOST_POINTS: u64 = 32_000_000;
/// Visits of a sweep in each frame: some milliseconds. Twice that where nothing else is to be done.
pub(super) const VISITS: u64 = 150_000;
/// How fine sweeps are, in pixels of what is drawn to: at once, and when complete.
pub(super) const SWEEPS: (f64, f64) = (0.5, 0.125);
/// The most halvings of the number of pixels each way in a picture that is made at once.
const HALVINGS: u32 = 4;

/// What is left to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Work {
    /// Everything.
    Anew,
    /// Everything, but only the mesh of the bend has moved.
    Moved,
    /// To choose how to draw the complete picture.
    Choose,
    /// To plan more of a bent one.
    Plan,
    /// To draw more of its points.
    Points,
    /// To sweep more of its pixels.
    Sweep,
    /// To add samples to a density.
    Density,
    /// Nothing.
    Done,
}

/// Where the picture that is shown is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shown {
    /// Points, at once.
    Front,
    /// Points, complete.
    Back,
    /// A density by the graphics card.
    Sums,
    /// Swept, at once.
    SweptFront,
    /// Swept, complete.
    SweptBack,
    /// A density by the processor.
    SoftSums,
}

impl Stage {
    pub(super) fn advance(&mut self, frame: &Frame, view: View, budget: u64) {
        if self.bending.is_some() {
            self.advance_bent(frame, view, budget);
            return;
        }
        match self.work {
            Work::Anew | Work::Moved | Work::Plan => {
                self.complete = false;
                self.work = Work::Choose;
                if self.style.colouring == Colouring::Density && self.gpu.densities {
                    self.weighed.begin(&self.gpu, Weighed::density(frame, view, self.window, budget));
                    self.add_density(frame, budget);
                } else if self.gpu.software {
                    self.sweep_at_once(frame, view, budget);
                } else {
                    self.draw_at_once(frame, view, budget);
                }
            }
            Work::Choose => self.choose(frame, view, budget),
            Work::Points => {
                let Some(back) = &self.back else { return };
                if self.planned.go_on(&self.gpu, &self.pipelines, &self.plan, back, budget) {
                    self.finish(Shown::Back, self.plan.exact, self.plan.points());
                }
            }
            Work::Sweep => {
                let progress = self.swept[1].go_on(if self.gpu.software { 2 * VISITS } else { VISITS });
                if progress != Progress::Working {
                    self.finish(Shown::SweptBack, progress == Progress::Complete, self.swept[1].lit);
                }
            }
            Work::Density => self.add_density(frame, budget),
            Work::Done => {}
        }
    }

    /// The window of a target of `factor` times as many pixels each way.
    pub(super) fn target_window(&self, factor: f64) -> Window {
        let side = |pixels: u32| ((f64::from(pixels) * factor).ceil() as u32).max(1);
        Window { width: side(self.window.width), height: side(self.window.height) }
    }

    fn to_target(&self, frame: &Frame, view: View, factor: f64) -> Affine2 {
        view.onto_target(frame.to_world, self.window, factor)
    }

    /// Takes one of the targets out, of the right size.
    pub(super) fn fit(&mut self, shown: Shown, factor: f64) -> Target {
        let window = self.target_window(factor);
        let (kept, kind) = match shown {
            Shown::Front => (self.front.take(), Kind::Codes),
            Shown::Back => (self.back.take(), Kind::Codes),
            Shown::Sums => (self.sums.take(), Kind::Density),
            _ => (self.painted.take(), Kind::Picture),
        };
        let kept = kept.filter(|target| target.window == window);
        kept.unwrap_or_else(|| Target::new(&self.gpu, &self.pipelines, &self.look, kind, window))
    }

    /// Pixels of a picture that is made at once, each way, for each one shown.
    pub(super) fn factor(&self) -> f64 {
        self.sampling * 0.5_f64.powi(self.halvings as i32)
    }

    /// Takes half of the pixels each way, if that is allowed.
    pub(super) fn halve(&mut self) -> bool {
        let may = self.halvings < HALVINGS;
        self.halvings += u32::from(may);
        may
    }

    /// Makes a whole picture within the budget, of fewer pixels if need be.
    fn draw_at_once(&mut self, frame: &Frame, view: View, budget: u64) {
        let mut coarser = false;
        loop {
            let factor = self.factor();
            let to_target = self.to_target(frame, view, factor);
            self.plan.make(frame, to_target, self.target_window(factor), Detail::LADDER[0]);
            let points = self.plan.points();
            if points > budget && self.halve() {
                coarser = true;
            } else if !coarser && self.halvings > 0 && points * 5 < budget {
                // Twice the pixels each way take at most some four times the points.
                self.halvings -= 1;
            } else {
                break;
            }
        }
        let factor = self.factor();
        let target = self.fit(Shown::Front, factor);
        self.planned.begin(&self.gpu, &self.plan, &target);
        self.planned.go_on(&self.gpu, &self.pipelines, &self.plan, &target, u64::MAX);
        self.front = Some(target);
        self.show(Shown::Front, factor, self.plan.points());
    }

    /// The same by a sweep: a visit takes about as long as a point does where there is no graphics card.
    fn sweep_at_once(&mut self, frame: &Frame, view: View, budget: u64) {
        let visits = budget.clamp(60_000, 400_000);
        loop {
            let factor = self.factor();
            let to_target = self.to_target(frame, view, factor);
            self.swept[0].begin(frame, to_target, self.target_window(factor), SWEEPS.0);
            if self.swept[0].go_on(visits) != Progress::Working || !self.halve() {
                break;
            }
        }
        self.show(Shown::SweptFront, self.factor(), self.swept[0].lit);
        if self.halvings > 0 && self.swept[0].visited() * 5 < visits {
            self.halvings -= 1;
        }
    }

    /// Chooses how to draw the complete picture: as points if they are soon drawn, as fine as may be; else
    /// by a sweep.
    fn choose(&mut self, frame: &Frame, view: View, budget: u64) {
        let factor = self.sampling;
        let window = self.target_window(factor);
        let to_target = self.to_target(frame, view, factor);
        let mut finest = None;
        // A sweep takes about as many visits as the coarsest plan has points.
        let mut most = MOST_POINTS;
        for detail in Detail::LADDER.into_iter().filter(|_| !self.gpu.software) {
            self.plan.make(frame, to_target, window, detail);
            let points = self.plan.points();
            if finest.is_none() {
                most = most.min(points.div_ceil(VISITS).saturating_mul(2 * budget));
            }
            if !self.plan.exact || points > most {
                break;
            }
            finest = Some(detail);
            // The next would have two to four times as many.
            if points * 3 > most || self.plan.vertices.len() > 60_000 {
                break;
            }
        }
        if let Some(detail) = finest {
            self.plan.make(frame, to_target, window, detail);
            let target = self.fit(Shown::Back, factor);
            self.planned.begin(&self.gpu, &self.plan, &target);
            self.back = Some(target);
            self.work = Work::Points;
        } else {
            self.swept[1].begin(frame, to_target, window, SWEEPS.1);
            self.work = Work::Sweep;
        }
    }

    /// The complete picture is ready.
    pub(super) fn finish(&mut self, shown: Shown, complete: bool, points: u64) {
        self.complete = complete;
        self.work = Work::Done;
        self.show(shown, self.sampling, points);
    }

    pub(super) fn show(&mut self, shown: Shown, factor: f64, points: u64) {
        self.shown = Some((shown, factor));
        self.points = points;
        self.stale = true;
    }

    /// Adds samples to a density. Points are coloured as they are drawn.
    pub(super) fn add_density(&mut self, frame: &Frame, budget: u64) {
        let look = self.look(frame, self.window, 1.0, 0.0);
        let (enough, shown) = if self.gpu.software {
            (self.weighed.go_on_without(frame, &look, self.window), Shown::SoftSums)
        } else {
            let target = self.fit(Shown::Sums, 1.0);
            self.gpu.queue.write_buffer(&self.look, 0, bytemuck::bytes_of(&look));
            let enough = self.weighed.go_on(&self.gpu, &self.pipelines, frame, &target, budget);
            self.sums = Some(target);
            (enough, Shown::Sums)
        };
        self.complete = enough;
        self.work = if enough { Work::Done } else { Work::Density };
        self.show(shown, 1.0, self.weighed.points);
    }
}
