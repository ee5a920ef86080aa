//! What a stage draws while the attractor is bent.

use frond_core::Colouring;
use frond_deform::Bend;
use glam::DVec2;

use crate::bent::{AnchorError, Bent, BentPlan, BentSweep, Cut, Fineness, Moving};
use crate::coverage::sweep::Progress;
use crate::density::Density;
use crate::gpu::passes::fill::FillPass;
use crate::gpu::passes::points::PointsPass;
use crate::gpu::state::{
    MOST_FINE_POINTS, MOST_POINTS, SWEEP_SIZES, Shown, StageState, VISITS_A_FRAME, Work,
};
use crate::gpu::target::Paint;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::plan::Detail;

/// A bend and what is drawn of it.
#[derive(Debug)]
pub(in crate::gpu) struct DeformedPass {
    /// What is drawn at once, and at rest too where there is no other.
    quick: BentShape,
    /// What is drawn at rest.
    fine: Option<BentShape>,
    /// What makes it when it is first wanted.
    later: Option<Later>,
    /// Where the control points are to be.
    mesh: Vec<DVec2>,
    /// At once, and while the mesh moves.
    front: BentPlan,
    moving: Moving,
    /// Draws what follows the mesh.
    followed: Option<PointsPass>,
    /// What the former was made for.
    made: Option<Made>,
    /// Complete.
    pub back: BentPlan,
    /// At once, and complete, where there is no graphics card.
    pub sweeps: [BentSweep; 2],
    fill: FillPass,
    /// Doublings of the smallest pieces, at once and complete, where there are too many.
    doublings: [u32; 2],
}

/// A bend, and its anchor error once that is known.
#[derive(Debug)]
struct BentShape {
    bend: Bend,
    anchor_error: Option<AnchorError>,
}

/// Makes a bend, if it can.
pub type Make = Box<dyn FnOnce() -> Option<Bend>>;

struct Later(Make);

impl std::fmt::Debug for Later {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Later")
    }
}

impl BentShape {
    /// Lets the bend follow the control points.
    fn follow_mesh(&mut self, frame: &Frame, mesh: &[DVec2]) {
        if self.bend.mesh().displacements() != mesh {
            // They were looked at when they came.
            let _ = self.bend.set_mesh(mesh);
            self.anchor_error = None;
        }
        self.anchor_error.get_or_insert_with(|| AnchorError::of(frame, &self.bend));
    }
}

/// What is asked for: the shape in a view, by about `budget` points, in the colours of the bend or not.
struct Wanted<'a> {
    frame: &'a Frame,
    view: View,
    budget: u64,
    coloured: bool,
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
const PIECES_AT_ONCE: usize = 24_000;
const PIECES_COMPLETE: usize = 600_000;
/// Visits for planning a complete picture in each frame.
const PLANNING_VISITS: u64 = 150_000;
/// The largest pieces, in pixels: at once, and complete, and those of one colour where the bend carries colours.
const LARGEST_PIECES: (f64, f64) = (32.0, 64.0);
const COLOURED_PIECES: (f64, f64) = (6.0, 3.0);
/// The smallest floor, in pixels, and the most times that it is doubled.
const SMALLEST_FLOOR: f64 = 2.0;
const FLOOR_DOUBLINGS: u32 = 8;
/// How far off points may be drawn in a picture that is made at once, in pixels.
const POINT_TOLERANCE: f64 = 0.25;
/// How far out of the window pieces are kept while the mesh moves, for its longer side.
const WINDOW_MARGIN: f64 = 0.25;
/// Densities: the largest pieces, in pixels, their number at most, at once and complete, and points in a pass.
const DENSE_SIZE: f64 = 16.0;
const DENSE_PIECES: (usize, usize) = (8_000, 60_000);
const DENSE_POINTS: u64 = 400_000;

impl DeformedPass {
    /// A bend, in the memory of another one.
    pub fn new(bend: Bend, memory: Option<Self>) -> Self {
        let memory = memory.map(|m| (m.front, m.moving, m.followed, m.back, m.sweeps, m.fill, m.doublings));
        let (front, moving, followed, back, sweeps, fill, doublings) = memory.unwrap_or_default();
        let mesh = bend.mesh().displacements().to_vec();
        let quick = BentShape { bend, anchor_error: None };
        Self {
            quick,
            fine: None,
            later: None,
            mesh,
            front,
            moving,
            followed,
            made: None,
            back,
            sweeps,
            fill,
            doublings,
        }
    }

    /// Forgets what it knows of a shape.
    pub fn forget(&mut self) {
        self.quick.anchor_error = None;
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
    fn follow_mesh(&mut self, frame: &Frame) {
        self.quick.follow_mesh(frame, &self.mesh);
    }

    /// Lets the bend that is drawn at rest follow the control points.
    fn rest(&mut self, frame: &Frame) {
        if let Some(Later(make)) = self.later.take() {
            self.fine = make().map(|bend| BentShape { bend, anchor_error: None });
        }
        self.fine.as_mut().unwrap_or(&mut self.quick).follow_mesh(frame, &self.mesh);
    }
}

/// A view of the attractor on a target.
#[derive(Clone, Copy, Debug)]
pub(in crate::gpu) struct TargetView {
    view: View,
    window: Window,
    target: Window,
    factor: f64,
}

impl TargetView {
    /// `None` before the bend is settled.
    fn bent<'a>(&self, frame: &'a Frame, shape: &'a BentShape) -> Option<Bent<'a>> {
        let anchor_error = shape.anchor_error.as_ref()?;
        Some(Bent::new(
            frame,
            &shape.bend,
            anchor_error,
            (self.view, self.window),
            (self.target, self.factor),
        ))
    }
}

impl DeformedPass {
    /// What makes the bend that is drawn at rest.
    pub fn set_later(&mut self, make: Make) {
        self.later = Some(Later(make));
    }

    /// Moves the control points: as many as there are, finite. Returns whether they have moved, `None` where they are
    /// none of this mesh.
    pub fn move_mesh(&mut self, displacements: &[DVec2]) -> Option<bool> {
        let fits = |d: &DVec2| d.abs().max_element() < 1e100;
        if displacements.len() != self.mesh.len() || !displacements.iter().all(fits) {
            return None;
        }
        let moved = self.mesh != displacements;
        if moved {
            displacements.clone_into(&mut self.mesh);
        }
        Some(moved)
    }

    /// Whether codes are colours that the bend carries.
    pub fn coloured(&self, state: &StageState, frame: &Frame) -> bool {
        let carries = || self.bend().colour(&self.bend().whole(), frame.to_world.translation).is_some();
        state.style.colouring == Colouring::Grid && carries()
    }

    /// Draws more of the bent picture: about `budget` points.
    pub fn advance(&mut self, state: &mut StageState, frame: &Frame, view: View, budget: u64) {
        let coloured = self.coloured(state, frame);
        let wanted = Wanted { frame, view, budget, coloured };
        let dense = state.style.colouring == Colouring::Density && state.gpu.densities;
        let follows = state.work == Work::Moved && !dense && !state.gpu.software;
        if follows && self.follow(state, &wanted) {
            state.complete = false;
            state.work = Work::Choose;
            return;
        }
        match state.work {
            Work::Anew | Work::Moved => {
                state.complete = false;
                state.work = Work::Choose;
                self.follow_mesh(frame);
                if dense {
                    self.begin_density(state, frame, view, false, budget);
                    state.add_density(frame, budget);
                    state.work = Work::Choose;
                } else if state.gpu.software {
                    self.sweep_at_once(state, &wanted);
                } else {
                    self.draw_at_once(state, &wanted);
                }
            }
            Work::Choose => {
                self.rest(frame);
                if dense {
                    self.begin_density(state, frame, view, true, budget);
                    state.add_density(frame, budget);
                } else if state.gpu.software {
                    self.begin_sweep(state, frame, view, coloured);
                } else {
                    self.doublings[1] = 0;
                    self.plan(state, frame, view, coloured, true);
                    state.work = Work::Plan;
                }
            }
            Work::Plan => match self.plan(state, frame, view, coloured, false) {
                Cut::Working => {}
                Cut::TooMany => self.begin_sweep(state, frame, view, coloured),
                Cut::Complete | Cut::Rough => self.choose(state, &wanted),
            },
            Work::Points => {
                let Some(back) = &state.back else { return };
                let plan = &self.back.plan;
                if state.points_pass.go_on(
                    &state.gpu,
                    Paint { pipelines: &state.pipelines, colours: &state.colours },
                    plan,
                    back,
                    budget,
                ) {
                    self.fill.begin(state, plan.points());
                }
            }
            Work::Place | Work::Fill => {
                let Self { quick, fine, back, sweeps: [_, sweep], fill, .. } = self;
                let target_view = target_view(state, view, state.sampling);
                let Some(bent) = target_view.bent(frame, fine.as_ref().unwrap_or(quick)) else { return };
                if state.work == Work::Fill {
                    let progress =
                        sweep.find(&bent, VISITS_A_FRAME, &mut |pixel, code| fill.light(pixel, code));
                    fill.draw(state, &back.plan, progress);
                } else if let Some(lit) = fill.place(&back.plan) {
                    sweep.begin_on(&bent, SWEEP_SIZES.1, coloured, lit);
                    state.work = Work::Fill;
                }
            }
            Work::Sweep => {
                let target_view = target_view(state, view, state.sampling);
                let DeformedPass { quick, fine, sweeps: [_, sweep], .. } = self;
                let Some(bent) = target_view.bent(frame, fine.as_ref().unwrap_or(quick)) else { return };
                let visits = if state.gpu.software { 2 * VISITS_A_FRAME } else { VISITS_A_FRAME };
                let progress = sweep.run(&bent, visits);
                if progress != Progress::Working {
                    let lit = sweep.lit();
                    state.finish(Shown::SweptBack, progress == Progress::Complete, lit);
                }
            }
            Work::Density => state.add_density(frame, budget),
            Work::Done => {}
        }
    }

    /// Draws the pieces at hand where the mesh takes them. Returns whether that could be done.
    fn follow(&mut self, state: &mut StageState, wanted: &Wanted<'_>) -> bool {
        let Wanted { frame, view, budget, coloured } = *wanted;
        let factor = state.factor();
        let target_view = target_view(state, view, factor);
        let mesh = self.mesh().to_vec();
        let fits = self.made.as_ref().is_some_and(|made| {
            let far = made.mesh.iter().zip(&mesh).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
            let same = (made.view, made.target, made.factor, made.coloured)
                == (view, target_view.target, factor, coloured);
            same && far * view.scale * factor <= margin(target_view.target)
        });
        if !fits {
            return false;
        }
        // Single precision may do; if not, the bend itself must follow.
        if !target_view.bent(frame, &self.quick).is_some_and(|bent| Moving::can_skin(&bent)) {
            self.follow_mesh(frame);
        }
        let Some(bent) = target_view.bent(frame, &self.quick) else { return false };
        self.front.follow(&bent, &mesh, &mut self.moving);
        self.front.compose(frame, Detail::LADDER[0]);
        let points = self.front.plan.points();
        if points > 2 * budget {
            return false;
        }
        self.show_front(state, factor);
        true
    }

    fn show_front(&mut self, state: &mut StageState, factor: f64) {
        let target = state.fit(Shown::Front, factor);
        let plan = &self.front.plan;
        let followed = self.followed.get_or_insert_with(|| PointsPass::new(&state.gpu));
        followed.begin(&state.gpu, plan, &target);
        followed.go_on(
            &state.gpu,
            Paint { pipelines: &state.pipelines, colours: &state.colours },
            plan,
            &target,
            u64::MAX,
        );
        state.front = Some(target);
        state.show(Shown::Front, factor, plan.points());
    }

    /// Makes a whole picture within the budget, of fewer pixels and rougher if need be.
    fn draw_at_once(&mut self, state: &mut StageState, wanted: &Wanted<'_>) {
        let Wanted { frame, view, budget, coloured } = *wanted;
        let mut coarser = false;
        self.doublings[0] = self.doublings[0].saturating_sub(u32::from(self.made.is_none()));
        loop {
            let factor = state.factor();
            let target_view = target_view(state, view, factor);
            cut_at_once(self, frame, &target_view, coloured);
            self.front.compose(frame, Detail::LADDER[0]);
            let points = self.front.plan.points();
            if !state.resize_for(points, budget, &mut coarser) {
                break;
            }
        }
        self.show_front(state, state.factor());
    }

    /// The same by a sweep.
    fn sweep_at_once(&mut self, state: &mut StageState, wanted: &Wanted<'_>) {
        let Wanted { frame, view, budget, coloured } = *wanted;
        let visits = budget.clamp(60_000, 400_000);
        let DeformedPass { quick, sweeps: [sweep, _], .. } = self;
        loop {
            let bent = target_view(state, view, state.factor());
            let Some(bent) = bent.bent(frame, quick) else { return };
            sweep.begin(&bent, SWEEP_SIZES.0, coloured);
            if sweep.run(&bent, visits) != Progress::Working || !state.halve() {
                break;
            }
        }
        state.show(Shown::SweptFront, state.factor(), sweep.lit());
        if state.halvings > 0 && sweep.visited() * 5 < visits {
            state.halvings -= 1;
        }
    }

    fn begin_sweep(&mut self, state: &mut StageState, frame: &Frame, view: View, coloured: bool) {
        let DeformedPass { quick, fine, sweeps: [_, sweep], .. } = self;
        let target_view = target_view(state, view, state.sampling);
        let Some(bent) = target_view.bent(frame, fine.as_ref().unwrap_or(quick)) else { return };
        sweep.begin(&bent, SWEEP_SIZES.1, coloured);
        state.work = Work::Sweep;
    }

    fn begin_density(&mut self, state: &mut StageState, frame: &Frame, view: View, rest: bool, budget: u64) {
        let settled = self.fine.as_ref().filter(|_| rest).unwrap_or(&self.quick);
        let Some(bent) = target_view(state, view, 1.0).bent(frame, settled) else { return };
        let points = (budget / 2).min(DENSE_POINTS) as usize;
        let pieces = if rest { DENSE_PIECES.1 } else { DENSE_PIECES.0 };
        state.density.begin(&state.gpu, Density::bent(&bent, DENSE_SIZE, pieces, points));
    }

    /// Plans more of the complete picture, or begins to.
    fn plan(&mut self, state: &StageState, frame: &Frame, view: View, coloured: bool, begin: bool) -> Cut {
        let DeformedPass { quick, fine, back, doublings: [_, doublings], .. } = self;
        let target_view = target_view(state, view, state.sampling);
        let Some(bent) = target_view.bent(frame, fine.as_ref().unwrap_or(quick)) else { return Cut::TooMany };
        let size = if coloured { COLOURED_PIECES.1 } else { LARGEST_PIECES.1 };
        let floor = if *doublings == 0 { 0.0 } else { 0.5 * f64::from(1_u32 << *doublings) };
        if begin {
            back.begin(&bent, PIECES_COMPLETE, coloured);
        }
        let cut = back.run(
            &bent,
            &Fineness { floor, ..Fineness::complete(size.max(floor)) },
            PLANNING_VISITS,
            None,
        );
        if cut == Cut::TooMany && *doublings < FLOOR_DOUBLINGS {
            *doublings += 1;
            back.begin(&bent, PIECES_COMPLETE, coloured);
            return Cut::Working;
        }
        cut
    }

    /// Chooses how to draw the complete picture that was planned: as fine as may be, or by a sweep after all.
    fn choose(&mut self, state: &mut StageState, wanted: &Wanted<'_>) {
        let Wanted { frame, view, budget, coloured } = *wanted;
        let back = &mut self.back;
        let mut finest = None;
        let mut most = MOST_POINTS;
        for detail in Detail::LADDER {
            back.compose(frame, detail);
            let points = back.plan.points();
            if finest.is_none() {
                most = most.min(points.div_ceil(VISITS_A_FRAME).saturating_mul(2 * budget));
            }
            if points > most {
                break;
            }
            finest = Some(detail);
            most = most.min(MOST_FINE_POINTS);
            if points * 3 > most || back.plan.vertices.len() > 60_000 {
                break;
            }
        }
        let Some(detail) = finest else {
            self.begin_sweep(state, frame, view, coloured);
            return;
        };
        back.compose(frame, detail);
        let target = state.fit(Shown::Back, state.sampling);
        state.points_pass.begin(&state.gpu, &back.plan, &target);
        state.back = Some(target);
        state.work = Work::Points;
    }
}

fn target_view(state: &StageState, view: View, factor: f64) -> TargetView {
    TargetView { view, window: state.window, target: state.target_window(factor), factor }
}

fn margin(target: Window) -> f64 {
    WINDOW_MARGIN * f64::from(target.width.max(target.height))
}

/// Cuts pieces that can follow the mesh, fewer and larger ones where there are too many.
fn cut_at_once(deformed: &mut DeformedPass, frame: &Frame, target_view: &TargetView, coloured: bool) {
    let DeformedPass { quick, mesh, front, moving, made, doublings: [doublings, _], .. } = deformed;
    let Some(bent) = target_view.bent(frame, quick) else { return };
    loop {
        let floor = SMALLEST_FLOOR * f64::from(1_u32 << *doublings);
        let size = if coloured { COLOURED_PIECES.0 } else { LARGEST_PIECES.0 };
        let margin = Some(margin(target_view.target));
        let fineness =
            Fineness { floor, margin, tolerance: POINT_TOLERANCE, ..Fineness::complete(size.max(floor)) };
        moving.clear();
        front.begin(&bent, PIECES_AT_ONCE, coloured);
        let cut = front.run(&bent, &fineness, u64::MAX, Some(moving));
        if cut != Cut::TooMany || *doublings >= FLOOR_DOUBLINGS {
            break;
        }
        *doublings += 1;
    }
    let mesh = mesh.clone();
    *made = Some(Made {
        view: target_view.view,
        target: target_view.target,
        factor: target_view.factor,
        coloured,
        mesh,
    });
}
