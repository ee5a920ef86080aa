//! What a stage draws while the attractor is bent.

use frond_deform::Bend;
use glam::DVec2;

use crate::bent::{Bent, BentPlan, BentSweep, Cut, Fineness, Moving, Slack};
use crate::coverage::sweep::Progress;
use crate::density::Density;
use crate::gpu::stage::Stage;
use crate::gpu::work::{MOST_POINTS, SWEEPS, Shown, VISITS, Work};
use crate::picture::colour::Colouring;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::plan::Detail;

/// A bend and what is drawn of it.
#[derive(Debug)]
pub(in crate::gpu) struct Bending {
    /// What is drawn at once, and at rest too where there is no other.
    quick: Settled,
    /// What is drawn at rest.
    fine: Option<Settled>,
    /// What makes it when it is first wanted.
    later: Option<Later>,
    /// Where the control points are to be.
    mesh: Vec<DVec2>,
    /// At once, and while the mesh moves.
    front: BentPlan,
    moving: Moving,
    /// What the former was made for.
    made: Option<Made>,
    /// Complete.
    pub back: BentPlan,
    /// At once, and complete, where there is no graphics card.
    pub sweeps: [BentSweep; 2],
    /// Doublings of the smallest pieces, at once and complete, where there are too many.
    doublings: [u32; 2],
}

/// A bend, and its slack once that is known.
#[derive(Debug)]
struct Settled {
    bend: Bend,
    slack: Option<Slack>,
}

/// Makes a bend, if it can.
pub type Make = Box<dyn FnOnce() -> Option<Bend>>;

struct Later(Make);

impl std::fmt::Debug for Later {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Later")
    }
}

impl Settled {
    /// Lets the bend follow the control points.
    fn settle(&mut self, frame: &Frame, mesh: &[DVec2]) {
        if self.bend.mesh().displacements() != mesh {
            // They were looked at when they came.
            let _ = self.bend.set_mesh(mesh);
            self.slack = None;
        }
        self.slack.get_or_insert_with(|| Slack::of(frame, &self.bend));
    }
}

/// What a plan that the mesh may move was made for.
#[derive(Clone, Debug, PartialEq)]
struct Made {
    view: View,
    target: Window,
    factor: f64,
    coloured: bool,
    /// Where the control points were.
    mesh: Vec<DVec2>,
}

/// The most pieces of a picture that is made at once, and of a complete one.
const AT_ONCE: usize = 24_000;
const COMPLETE: usize = 600_000;
/// Visits for planning a complete picture in each frame.
const PLANNING: u64 = 150_000;
/// The largest pieces, in pixels: at once, and complete, and those of one colour where the bend carries colours.
const LARGEST: (f64, f64) = (32.0, 64.0);
const COLOURED: (f64, f64) = (6.0, 3.0);
/// The smallest floor, in pixels, and the most times that it is doubled.
const FLOOR: f64 = 2.0;
const DOUBLINGS: u32 = 8;
/// How far off points may be drawn in a picture that is made at once, in pixels.
const TOLERANCE: f64 = 0.25;
/// How far out of the window pieces are kept while the mesh moves, for its longer side.
const MARGIN: f64 = 0.25;
/// Densities: the largest pieces, in pixels, their number at most, at once and complete, and points in a pass.
const DENSE_SIZE: f64 = 16.0;
const DENSE: (usize, usize) = (8_000, 60_000);
const DENSE_POINTS: u64 = 400_000;

impl Bending {
    /// A bend, in the memory of another one.
    pub fn new(bend: Bend, memory: Option<Self>) -> Self {
        let memory = memory.map(|m| (m.front, m.moving, m.back, m.sweeps, m.doublings));
        let (front, moving, back, sweeps, doublings) = memory.unwrap_or_default();
        let mesh = bend.mesh().displacements().to_vec();
        let quick = Settled { bend, slack: None };
        Self { quick, fine: None, later: None, mesh, front, moving, made: None, back, sweeps, doublings }
    }

    /// Forgets what it knows of a shape.
    pub fn forget(&mut self) {
        self.quick.slack = None;
        self.fine = None;
        self.later = None;
        self.made = None;
    }

    /// The bend, maybe not where its mesh is to be.
    pub fn bend(&self) -> &Bend {
        &self.quick.bend
    }

    /// The control points as they are to be.
    pub fn mesh(&self) -> &[DVec2] {
        &self.mesh
    }

    /// Lets the bend that is drawn at once follow the control points.
    fn settle(&mut self, frame: &Frame) {
        self.quick.settle(frame, &self.mesh);
    }

    /// Lets the bend that is drawn at rest follow the control points.
    fn rest(&mut self, frame: &Frame) {
        if let Some(Later(make)) = self.later.take() {
            self.fine = make().map(|bend| Settled { bend, slack: None });
        }
        self.fine.as_mut().unwrap_or(&mut self.quick).settle(frame, &self.mesh);
    }
}

/// A view of the attractor on a target.
#[derive(Clone, Copy, Debug)]
pub(in crate::gpu) struct Sight {
    view: View,
    window: Window,
    target: Window,
    factor: f64,
}

impl Sight {
    /// `None` before the bend is settled.
    fn bent<'a>(&self, frame: &'a Frame, settled: &'a Settled) -> Option<Bent<'a>> {
        let slack = settled.slack.as_ref()?;
        Some(Bent::new(frame, &settled.bend, slack, (self.view, self.window), (self.target, self.factor)))
    }
}

impl Stage {
    /// Bends the attractor, or no longer. The bend must have been made for the same maps; what they become is set
    /// before.
    pub fn set_bend(&mut self, bend: Option<Bend>) {
        if let Some(sheeted) = &mut self.sheeted {
            sheeted.forget();
        }
        let memory = self.bending.take();
        if bend.is_none() && memory.is_none() {
            return;
        }
        if bend.is_some() != memory.is_some() {
            // What was swept is not at hand any more.
            self.shown =
                self.shown.filter(|(shown, _)| !matches!(shown, Shown::SweptFront | Shown::SweptBack));
        }
        self.bending = bend.map(|bend| Bending::new(bend, memory));
        self.work = Work::Anew;
    }

    /// What makes the bend that is drawn at rest, where that takes longer than a frame: the one that was set is drawn
    /// while things change. Both must have been made of the same mesh and the same maps.
    pub fn set_bend_at_rest(&mut self, make: Make) {
        if let Some(bending) = &mut self.bending {
            bending.later = Some(Later(make));
        }
    }

    /// Moves the control points of the mesh of the bend: as many as it has, finite. This is cheap. Returns whether there
    /// is such a mesh; if not, nothing changes.
    pub fn move_mesh(&mut self, displacements: &[DVec2]) -> bool {
        let Some(bending) = &mut self.bending else { return false };
        let fits = |d: &DVec2| d.abs().max_element() < 1e100;
        if displacements.len() != bending.mesh().len() || !displacements.iter().all(fits) {
            return false;
        }
        if bending.mesh != displacements {
            displacements.clone_into(&mut bending.mesh);
            if self.work != Work::Anew {
                self.work = Work::Moved;
            }
        }
        true
    }

    /// Whether codes are colours that the bend carries.
    pub(in crate::gpu) fn coloured(&self, frame: &Frame) -> bool {
        let carries = |bending: &Bending| {
            bending.bend().colour(&bending.bend().whole(), frame.to_world.translation).is_some()
        };
        self.style.colouring == Colouring::Grid && self.bending.as_ref().is_some_and(carries)
    }

    /// What [`Stage::advance`] does where nothing is bent.
    pub(in crate::gpu) fn advance_bent(&mut self, frame: &Frame, view: View, budget: u64) {
        let coloured = self.coloured(frame);
        if let Some(mut bending) = self.bending.take() {
            self.work_on(&mut bending, frame, view, budget, coloured);
            self.bending = Some(bending);
        }
    }

    fn work_on(&mut self, bending: &mut Bending, frame: &Frame, view: View, budget: u64, coloured: bool) {
        let dense = self.style.colouring == Colouring::Density && self.gpu.densities;
        let follows = self.work == Work::Moved && !dense && !self.gpu.software;
        if follows && self.follow(bending, frame, view, budget, coloured) {
            self.complete = false;
            self.work = Work::Choose;
            return;
        }
        match self.work {
            Work::Anew | Work::Moved => {
                self.complete = false;
                self.work = Work::Choose;
                bending.settle(frame);
                if dense {
                    self.begin_bent_density(bending, frame, view, false, budget);
                    self.add_density(frame, budget);
                    self.work = Work::Choose;
                } else if self.gpu.software {
                    self.sweep_bent_at_once(bending, frame, view, budget, coloured);
                } else {
                    self.draw_bent_at_once(bending, frame, view, budget, coloured);
                }
            }
            Work::Choose => {
                bending.rest(frame);
                if dense {
                    self.begin_bent_density(bending, frame, view, true, budget);
                    self.add_density(frame, budget);
                } else if self.gpu.software {
                    self.begin_bent_sweep(bending, frame, view, coloured);
                } else {
                    bending.doublings[1] = 0;
                    self.plan_bent(bending, frame, view, coloured, true);
                    self.work = Work::Plan;
                }
            }
            Work::Plan => match self.plan_bent(bending, frame, view, coloured, false) {
                Cut::Working => {}
                Cut::TooMany => self.begin_bent_sweep(bending, frame, view, coloured),
                Cut::Complete | Cut::Rough => self.choose_bent(bending, frame, view, budget, coloured),
            },
            Work::Points => {
                let Some(back) = &self.back else { return };
                let plan = &bending.back.plan;
                if self.planned.go_on(&self.gpu, &self.pipelines, plan, back, budget) {
                    self.finish(Shown::Back, plan.exact, plan.points());
                }
            }
            Work::Sweep => {
                let sight = self.sight(view, self.sampling);
                let Bending { quick, fine, sweeps: [_, sweep], .. } = bending;
                let Some(bent) = sight.bent(frame, fine.as_ref().unwrap_or(quick)) else { return };
                let visits = if self.gpu.software { 2 * VISITS } else { VISITS };
                let progress = sweep.run(&bent, visits);
                if progress != Progress::Working {
                    let lit = sweep.lit();
                    self.finish(Shown::SweptBack, progress == Progress::Complete, lit);
                }
            }
            Work::Density => self.add_density(frame, budget),
            Work::Done => {}
        }
    }

    fn sight(&self, view: View, factor: f64) -> Sight {
        Sight { view, window: self.window, target: self.target_window(factor), factor }
    }

    /// Draws the pieces at hand where the mesh takes them. Returns whether that could be done.
    fn follow(
        &mut self,
        bending: &mut Bending,
        frame: &Frame,
        view: View,
        budget: u64,
        coloured: bool,
    ) -> bool {
        let factor = self.factor();
        let sight = self.sight(view, factor);
        let mesh = bending.mesh().to_vec();
        let fits = bending.made.as_ref().is_some_and(|made| {
            let far = made.mesh.iter().zip(&mesh).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
            let same = (made.view, made.target, made.factor, made.coloured)
                == (view, sight.target, factor, coloured);
            same && far * view.scale * factor <= margin(sight.target)
        });
        if !fits {
            return false;
        }
        // Single precision may do; if not, the bend itself must follow.
        if !sight.bent(frame, &bending.quick).is_some_and(|bent| Moving::can_skin(&bent)) {
            bending.settle(frame);
        }
        let Some(bent) = sight.bent(frame, &bending.quick) else { return false };
        bending.moving.follow(&bent, &mesh, &mut bending.front);
        bending.front.compose(frame, Detail::LADDER[0]);
        let points = bending.front.plan.points();
        if points > 2 * budget {
            return false;
        }
        self.show_bent_front(bending, factor);
        true
    }

    fn show_bent_front(&mut self, bending: &Bending, factor: f64) {
        let target = self.fit(Shown::Front, factor);
        let plan = &bending.front.plan;
        self.followed.begin(&self.gpu, plan, &target);
        self.followed.go_on(&self.gpu, &self.pipelines, plan, &target, u64::MAX);
        self.front = Some(target);
        self.show(Shown::Front, factor, plan.points());
    }

    /// Makes a whole picture within the budget, of fewer pixels and rougher if need be.
    fn draw_bent_at_once(
        &mut self,
        bending: &mut Bending,
        frame: &Frame,
        view: View,
        budget: u64,
        coloured: bool,
    ) {
        let mut coarser = false;
        bending.doublings[0] = bending.doublings[0].saturating_sub(u32::from(bending.made.is_none()));
        loop {
            let factor = self.factor();
            let sight = self.sight(view, factor);
            cut_at_once(bending, frame, &sight, coloured);
            bending.front.compose(frame, Detail::LADDER[0]);
            let points = bending.front.plan.points();
            if points > budget && self.halve() {
                coarser = true;
            } else if !coarser && self.halvings > 0 && points * 5 < budget {
                // Twice the pixels each way take at most some four times the points.
                self.halvings -= 1;
            } else {
                break;
            }
        }
        self.show_bent_front(bending, self.factor());
    }

    /// The same by a sweep.
    fn sweep_bent_at_once(
        &mut self,
        bending: &mut Bending,
        frame: &Frame,
        view: View,
        budget: u64,
        coloured: bool,
    ) {
        let visits = budget.clamp(60_000, 400_000);
        let Bending { quick, sweeps: [sweep, _], .. } = bending;
        loop {
            let bent = self.sight(view, self.factor());
            let Some(bent) = bent.bent(frame, quick) else { return };
            sweep.begin(&bent, SWEEPS.0, coloured);
            if sweep.run(&bent, visits) != Progress::Working || !self.halve() {
                break;
            }
        }
        self.show(Shown::SweptFront, self.factor(), sweep.lit());
        if self.halvings > 0 && sweep.visited() * 5 < visits {
            self.halvings -= 1;
        }
    }

    fn begin_bent_sweep(&mut self, bending: &mut Bending, frame: &Frame, view: View, coloured: bool) {
        let Bending { quick, fine, sweeps: [_, sweep], .. } = bending;
        let sight = self.sight(view, self.sampling);
        let Some(bent) = sight.bent(frame, fine.as_ref().unwrap_or(quick)) else { return };
        sweep.begin(&bent, SWEEPS.1, coloured);
        self.work = Work::Sweep;
    }

    fn begin_bent_density(&mut self, bending: &Bending, frame: &Frame, view: View, rest: bool, budget: u64) {
        let settled = bending.fine.as_ref().filter(|_| rest).unwrap_or(&bending.quick);
        let Some(bent) = self.sight(view, 1.0).bent(frame, settled) else { return };
        let points = (budget / 2).min(DENSE_POINTS) as usize;
        let pieces = if rest { DENSE.1 } else { DENSE.0 };
        self.weighed.begin(&self.gpu, Density::bent(&bent, DENSE_SIZE, pieces, points));
    }

    /// Plans more of the complete picture, or begins to.
    fn plan_bent(
        &self,
        bending: &mut Bending,
        frame: &Frame,
        view: View,
        coloured: bool,
        begin: bool,
    ) -> Cut {
        let Bending { quick, fine, back, doublings: [_, doublings], .. } = bending;
        let sight = self.sight(view, self.sampling);
        let Some(bent) = sight.bent(frame, fine.as_ref().unwrap_or(quick)) else { return Cut::TooMany };
        let size = if coloured { COLOURED.1 } else { LARGEST.1 };
        let floor = if *doublings == 0 { 0.0 } else { 0.5 * f64::from(1_u32 << *doublings) };
        if begin {
            back.begin(&bent, COMPLETE, coloured);
        }
        let cut = back.run(&bent, &Fineness { floor, ..Fineness::complete(size.max(floor)) }, PLANNING, None);
        if cut == Cut::TooMany && *doublings < DOUBLINGS {
            *doublings += 1;
            back.begin(&bent, COMPLETE, coloured);
            return Cut::Working;
        }
        cut
    }

    /// Chooses how to draw the complete picture that was planned: as fine as may be, or by a sweep after all.
    fn choose_bent(&mut self, bending: &mut Bending, frame: &Frame, view: View, budget: u64, coloured: bool) {
        let back = &mut bending.back;
        let mut finest = None;
        let mut most = MOST_POINTS;
        for detail in Detail::LADDER {
            back.compose(frame, detail);
            let points = back.plan.points();
            if finest.is_none() {
                most = most.min(points.div_ceil(VISITS).saturating_mul(2 * budget));
            }
            if points > most {
                break;
            }
            finest = Some(detail);
            if points * 3 > most || back.plan.vertices.len() > 60_000 {
                break;
            }
        }
        let Some(detail) = finest else {
            self.begin_bent_sweep(bending, frame, view, coloured);
            return;
        };
        back.compose(frame, detail);
        let target = self.fit(Shown::Back, self.sampling);
        self.planned.begin(&self.gpu, &back.plan, &target);
        self.back = Some(target);
        self.work = Work::Points;
    }
}

fn margin(target: Window) -> f64 {
    MARGIN * f64::from(target.width.max(target.height))
}

/// Cuts pieces that can follow the mesh, fewer and larger ones where there are too many.
fn cut_at_once(bending: &mut Bending, frame: &Frame, sight: &Sight, coloured: bool) {
    let Bending { quick, mesh, front, moving, made, doublings: [doublings, _], .. } = bending;
    let Some(bent) = sight.bent(frame, quick) else { return };
    loop {
        let floor = FLOOR * f64::from(1_u32 << *doublings);
        let size = if coloured { COLOURED.0 } else { LARGEST.0 };
        let margin = Some(margin(sight.target));
        let fineness =
            Fineness { floor, margin, tolerance: TOLERANCE, ..Fineness::complete(size.max(floor)) };
        moving.clear();
        front.begin(&bent, AT_ONCE, coloured);
        let cut = front.run(&bent, &fineness, u64::MAX, Some(moving));
        if cut != Cut::TooMany || *doublings >= DOUBLINGS {
            break;
        }
        *doublings += 1;
    }
    let mesh = mesh.clone();
    *made = Some(Made { view: sight.view, target: sight.target, factor: sight.factor, coloured, mesh });
}
