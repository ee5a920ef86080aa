//! Drawing an attractor, coarse at once and complete after some frames.

use frond_core::{Affine2, Hull, Ifs};

use super::buffer::uniform;
use super::device::Gpu;
use super::pipelines::{Kind, Pipelines};
use super::planned::Planned;
use super::readback::ReadBack;
use super::swept::Swept;
use super::target::Target;
use super::weighed::Weighed;
use crate::colour::{Colouring, Look};
use crate::frame::Frame;
use crate::plan::Detail;
use crate::raster::MAX_SIDE;
use crate::sweep::Progress;
use crate::view::View;
use crate::window::Window;

/// How a picture looks.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// How pieces are coloured.
    pub colouring: Colouring,
    /// One sRGB colour a map, repeated when there are more maps; empty for Okabe and Ito's.
    pub palette: Vec<[u8; 3]>,
    /// How bright a density is: 1 by default.
    pub exposure: f32,
}

impl Default for Style {
    fn default() -> Self {
        Self { colouring: Colouring::Map, palette: Vec::new(), exposure: 1.0 }
    }
}

/// What [`Stage::draw`] came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// Whether the picture that is shown is complete: every pixel that holds a piece of the attractor
    /// smaller than half a pixel is lit.
    pub complete: bool,
    /// Whether drawing on would change nothing. Without being complete, this is a shape whose pieces
    /// overlap too much to visit them all, or a lost device.
    pub settled: bool,
    /// The number of points in the picture that is shown.
    pub points: u64,
}

/// The most points of a complete picture.
const MOST_POINTS: u64 = 32_000_000;
/// Visits of a sweep in each frame: some milliseconds. Twice that where nothing else is to be done.
const VISITS: u64 = 150_000;
/// How fine sweeps are, in pixels of what is drawn to: at once, and when complete.
const SWEEPS: (f64, f64) = (0.5, 0.125);
/// The most halvings of the number of pixels each way in a picture that is made at once.
const HALVINGS: u32 = 4;

/// What is left to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Work {
    /// Everything.
    Anew,
    /// To choose how to draw the complete picture.
    Choose,
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
enum Shown {
    Front,
    Back,
    Sums,
}

/// Draws one attractor on one canvas.
///
/// While things change each call of [`Stage::draw`] makes a whole picture of as many pixels as the budget
/// allows: fewer and larger ones where it is small. When they rest, the next calls draw the complete picture
/// aside and show it when it is ready.
///
/// Pictures are points, drawn by the graphics card. Where an attractor overlaps itself so much that points
/// would be drawn without end, or where there is no card and each point is dear, they are swept on the
/// processor instead, which lights each pixel but once.
#[derive(Debug)]
pub struct Stage {
    gpu: Gpu,
    pipelines: Pipelines,
    window: Window,
    /// Pixels that are drawn for each one shown, each way, when the picture is complete.
    sampling: f64,
    frame: Option<Frame>,
    view: Option<View>,
    style: Style,
    work: Work,
    /// Whether the picture must be shown again.
    stale: bool,
    complete: bool,
    points: u64,
    /// The picture that is shown, and its pixels for each one shown.
    shown: Option<(Shown, f64)>,
    front: Option<Target>,
    back: Option<Target>,
    sums: Option<Target>,
    look: wgpu::Buffer,
    straight_look: wgpu::Buffer,
    planned: Planned,
    swept: Swept,
    weighed: Weighed,
    halvings: u32,
}

impl Stage {
    /// A stage on a device, with nothing on it.
    #[must_use]
    pub fn new(gpu: Gpu) -> Self {
        Self {
            pipelines: Pipelines::new(&gpu.device, gpu.format(), gpu.sums),
            window: Window { width: 0, height: 0 },
            sampling: 2.0,
            frame: None,
            view: None,
            style: Style::default(),
            work: Work::Anew,
            stale: false,
            complete: false,
            points: 0,
            shown: None,
            front: None,
            back: None,
            sums: None,
            look: uniform::<Look>(&gpu.device, "look"),
            straight_look: uniform::<Look>(&gpu.device, "straight look"),
            planned: Planned::new(&gpu),
            swept: Swept::default(),
            weighed: Weighed::new(&gpu),
            halvings: 1,
            gpu,
        }
    }

    /// The device.
    #[must_use]
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Sets the size of the canvas in device pixels. Edges are smoothed where `pixel_ratio` (device pixels
    /// for each CSS pixel) is below 2; beyond, pixels are too small to see.
    pub fn resize(&mut self, width: u32, height: u32, pixel_ratio: f64) {
        let side = self.gpu.max_side.min(MAX_SIDE);
        let window = Window { width: width.min(side), height: height.min(side) };
        let fits = window.width.max(window.height) * 2 <= self.gpu.max_side;
        self.sampling = if fits && pixel_ratio < 2.0 { 2.0 } else { 1.0 };
        self.window = window;
        self.gpu.resize(window.width, window.height);
        self.work = Work::Anew;
    }

    /// Sets what is drawn.
    pub fn set_ifs(&mut self, ifs: &Ifs) {
        let hull = Hull::of(ifs);
        self.frame = Some(Frame::within(ifs, &hull));
        self.work = Work::Anew;
    }

    /// Sets the part of the plane that is shown. Returns whether it is a view; if not, nothing changes.
    pub fn set_view(&mut self, view: View) -> bool {
        if !view.is_valid() {
            return false;
        }
        if self.view != Some(view) {
            self.view = Some(view);
            self.work = Work::Anew;
        }
        true
    }

    /// Sets how it looks.
    pub fn set_style(&mut self, style: Style) {
        let dense = |style: &Style| style.colouring == Colouring::Density;
        // Codes hold for all colours, sums for one palette.
        if dense(&style) != dense(&self.style) || (dense(&style) && style.palette != self.style.palette) {
            self.work = Work::Anew;
        }
        self.stale |= style != self.style;
        self.style = style;
    }

    /// Draws what is new, or goes on with the complete picture: about `budget` points.
    pub fn draw(&mut self, budget: u64) -> Drawn {
        let ready = self.window.area() > 0 && !self.gpu.is_lost() && self.view.is_some();
        let Some(frame) = self.frame.take() else {
            return Drawn { complete: false, settled: true, points: 0 };
        };
        if let Some(view) = self.view.filter(|_| ready) {
            self.advance(&frame, view, budget.max(10_000));
            if self.stale {
                self.present(&frame);
            }
        }
        self.frame = Some(frame);
        let settled = !ready || (self.work == Work::Done && !self.stale);
        Drawn { complete: self.complete && settled && ready, settled, points: self.points }
    }

    fn advance(&mut self, frame: &Frame, view: View, budget: u64) {
        match self.work {
            Work::Anew => {
                self.complete = false;
                self.work = Work::Choose;
                if self.style.colouring == Colouring::Density && self.gpu.densities {
                    let target = self.fit(Shown::Sums, 1.0);
                    self.weighed.begin(&self.gpu, frame, view, &target, budget);
                    self.sums = Some(target);
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
                if self.planned.go_on(&self.gpu, &self.pipelines, back, budget) {
                    self.finish(self.planned.plan.exact, self.planned.plan.points());
                }
            }
            Work::Sweep => {
                let progress = self.swept.go_on(if self.gpu.software { 2 * VISITS } else { VISITS });
                if let Some(back) = self.back.as_ref().filter(|_| progress != Progress::Working) {
                    self.swept.write(&self.gpu, back);
                    self.finish(progress == Progress::Complete, self.swept.lit);
                }
            }
            Work::Density => self.add_density(frame, budget),
            Work::Done => {}
        }
    }

    /// The window of a target of `factor` times as many pixels each way.
    fn target_window(&self, factor: f64) -> Window {
        let side = |pixels: u32| ((f64::from(pixels) * factor).ceil() as u32).max(1);
        Window { width: side(self.window.width), height: side(self.window.height) }
    }

    fn to_target(&self, frame: &Frame, view: View, factor: f64) -> Affine2 {
        view.onto_target(frame.to_world, self.window, factor)
    }

    /// Takes one of the targets out, of the right size.
    fn fit(&mut self, shown: Shown, factor: f64) -> Target {
        let window = self.target_window(factor);
        let (kept, kind) = match shown {
            Shown::Front => (self.front.take(), Kind::Codes),
            Shown::Back => (self.back.take(), Kind::Codes),
            Shown::Sums => (self.sums.take(), Kind::Density),
        };
        let kept = kept.filter(|target| target.window == window);
        kept.unwrap_or_else(|| Target::new(&self.gpu, &self.pipelines, &self.look, kind, window))
    }

    /// Pixels of a picture that is made at once, each way, for each one shown.
    fn factor(&self) -> f64 {
        self.sampling * 0.5_f64.powi(self.halvings as i32)
    }

    /// Makes a whole picture within the budget, of fewer pixels if need be.
    fn draw_at_once(&mut self, frame: &Frame, view: View, budget: u64) {
        let mut coarser = false;
        loop {
            let factor = self.factor();
            let to_target = self.to_target(frame, view, factor);
            self.planned.make(frame, to_target, self.target_window(factor), Detail::LADDER[0]);
            let points = self.planned.plan.points();
            if points > budget && self.halvings < HALVINGS {
                self.halvings += 1;
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
        self.planned.begin(&self.gpu, &target);
        self.planned.go_on(&self.gpu, &self.pipelines, &target, u64::MAX);
        self.front = Some(target);
        self.show(Shown::Front, factor, self.planned.plan.points());
    }

    /// The same by a sweep: a visit takes about as long as a point does where there is no graphics card.
    fn sweep_at_once(&mut self, frame: &Frame, view: View, budget: u64) {
        let visits = budget.clamp(60_000, 400_000);
        loop {
            let factor = self.factor();
            let to_target = self.to_target(frame, view, factor);
            self.swept.begin(frame, to_target, self.target_window(factor), SWEEPS.0);
            if self.swept.go_on(visits) != Progress::Working || self.halvings >= HALVINGS {
                break;
            }
            self.halvings += 1;
        }
        let factor = self.factor();
        let target = self.fit(Shown::Front, factor);
        self.swept.write(&self.gpu, &target);
        self.front = Some(target);
        self.show(Shown::Front, factor, self.swept.lit);
        if self.halvings > 0 && self.swept.visited() * 5 < visits {
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
            self.planned.make(frame, to_target, window, detail);
            let points = self.planned.plan.points();
            if finest.is_none() {
                most = most.min(points.div_ceil(VISITS).saturating_mul(2 * budget));
            }
            if !self.planned.plan.exact || points > most {
                break;
            }
            finest = Some(detail);
            // The next would have two to four times as many.
            if points * 3 > most || self.planned.plan.vertices.len() > 60_000 {
                break;
            }
        }
        let target = self.fit(Shown::Back, factor);
        if let Some(detail) = finest {
            self.planned.make(frame, to_target, window, detail);
            self.planned.begin(&self.gpu, &target);
            self.work = Work::Points;
        } else {
            self.swept.begin(frame, to_target, window, SWEEPS.1);
            self.work = Work::Sweep;
        }
        self.back = Some(target);
    }

    /// The complete picture is ready.
    fn finish(&mut self, complete: bool, points: u64) {
        self.complete = complete;
        self.work = Work::Done;
        self.show(Shown::Back, self.sampling, points);
    }

    fn show(&mut self, shown: Shown, factor: f64, points: u64) {
        self.shown = Some((shown, factor));
        self.points = points;
        self.stale = true;
    }

    /// Adds samples to a density.
    fn add_density(&mut self, frame: &Frame, budget: u64) {
        let Some(target) = &self.sums else { return };
        // Points are coloured as they are drawn.
        let look = target.look(&look_of(&self.style, frame), 1.0, 0.0, true);
        let enough = if self.gpu.software {
            self.weighed.go_on_without(&self.gpu, frame, target, &look)
        } else {
            self.gpu.queue.write_buffer(&self.look, 0, bytemuck::bytes_of(&look));
            self.weighed.go_on(&self.gpu, &self.pipelines, frame, target, budget)
        };
        self.complete = enough;
        self.work = if enough { Work::Done } else { Work::Density };
        self.show(Shown::Sums, 1.0, self.weighed.points);
    }

    /// The target that is shown, and the look to show it with.
    fn picture(&self, frame: &Frame, premultiply: bool) -> Option<(&Target, Look)> {
        let (shown, factor) = self.shown?;
        let target = match shown {
            Shown::Front => &self.front,
            Shown::Back => &self.back,
            Shown::Sums => &self.sums,
        };
        let target = target.as_ref()?;
        let gain = self.style.exposure.max(0.0) * self.weighed.gain();
        Some((target, target.look(&look_of(&self.style, frame), factor, gain, premultiply)))
    }

    /// Puts the picture on the canvas.
    fn present(&mut self, frame: &Frame) {
        let Some((target, look)) = self.picture(frame, true) else { return };
        let Some(canvas) = self.gpu.frame() else { return };
        let view = canvas.texture.create_view(&wgpu::TextureViewDescriptor::default());
        self.gpu.queue.write_buffer(&self.look, 0, bytemuck::bytes_of(&look));
        let pipeline = self.pipelines.show(target.kind);
        let encoder = target.resolve(&self.gpu, &self.pipelines, &self.look, pipeline, &view);
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.queue.present(canvas);
        self.stale = false;
    }

    /// Begins to read the picture that is shown, or `None` if there is none.
    #[must_use]
    pub fn read(&self) -> Option<ReadBack> {
        let frame = self.frame.as_ref().filter(|_| !self.gpu.is_lost() && self.window.area() > 0)?;
        let (target, look) = self.picture(frame, false)?;
        let texture = ReadBack::texture(&self.gpu, self.window);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        self.gpu.queue.write_buffer(&self.straight_look, 0, bytemuck::bytes_of(&look));
        let pipeline = self.pipelines.read(target.kind);
        let encoder = target.resolve(&self.gpu, &self.pipelines, &self.straight_look, pipeline, &view);
        Some(ReadBack::begin(&self.gpu, encoder, &texture, self.window))
    }
}

fn look_of(style: &Style, frame: &Frame) -> Look {
    Look::new(style.colouring, &style.palette, frame.maps.len())
}
