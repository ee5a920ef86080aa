//! What a stage and its passes share: the device, what is drawn into, and how far the work is.

use frond_core::{Affine2, Colouring};

use super::device::Gpu;
use super::interface::{Buffer, Usage};
use super::passes::density::DensityPass;
use super::passes::points::PointsPass;
use super::pipelines::{Kind, Pipelines};
use super::target::{Paint, Target};
use crate::picture::colour::{Colours, is_for_light_ground};
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::raster::MAX_SIDE;

/// The most points of a complete picture, and of one that has finer ones than the coarsest: they tell better which map
/// lies on top, and what they miss is filled in either case.
pub(super) const MOST_POINTS: u64 = 32_000_000;
pub(super) const MOST_FINE_POINTS: u64 = 6_000_000;
/// Visits of a sweep in each frame: some milliseconds. Twice that where nothing else is to be done.
pub(super) const VISITS_A_FRAME: u64 = 150_000;
/// How fine sweeps are, in pixels of what is drawn to: at once, and when complete.
pub(super) const SWEEP_SIZES: (f64, f64) = (0.5, 0.125);
/// The most halvings of the number of pixels each way in a picture that is made at once.
const MOST_HALVINGS: u32 = 4;

/// How a picture looks.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// How pieces are coloured.
    pub colouring: Colouring,
    /// One sRGB colour a map, repeated when there are more maps; empty for Okabe and Ito's.
    pub palette: Vec<[u8; 3]>,
    /// How bright a density is: 1 by default.
    pub exposure: f32,
    /// Whether what is dense is darkened, for a light ground, and not lightened. By default it is where the colours of
    /// the palette are dark.
    pub light_ground: Option<bool>,
}

impl Default for Style {
    fn default() -> Self {
        Self { colouring: Colouring::Map, palette: Vec::new(), exposure: 1.0, light_ground: None }
    }
}

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
    /// To find out which pixels its points light.
    Place,
    /// To light those that they left dark.
    Fill,
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

/// What all passes of a stage draw with and into.
#[derive(Debug)]
pub(super) struct StageState {
    pub gpu: Gpu,
    pub pipelines: Pipelines,
    pub window: Window,
    /// Pixels that are drawn for each one shown, each way, when the picture is complete.
    pub sampling: f64,
    pub style: Style,
    pub work: Work,
    /// Whether the picture must be shown again.
    pub stale: bool,
    pub complete: bool,
    pub points: u64,
    /// The picture that is shown, and its pixels for each one shown.
    pub shown: Option<(Shown, f64)>,
    pub front: Option<Target>,
    pub back: Option<Target>,
    pub sums: Option<Target>,
    pub painted: Option<Target>,
    pub colours: Buffer,
    /// What is drawn into the back, bit by bit.
    pub points_pass: PointsPass,
    pub density: DensityPass,
    /// How often the pixels of a picture that is made at once are halved, each way.
    pub halvings: u32,
}

impl StageState {
    pub fn new(gpu: Gpu) -> Self {
        Self {
            pipelines: Pipelines::new(&gpu.card),
            window: Window { width: 0, height: 0 },
            sampling: 2.0,
            style: Style::default(),
            work: Work::Anew,
            stale: false,
            complete: false,
            points: 0,
            shown: None,
            front: None,
            back: None,
            sums: None,
            painted: None,
            colours: Buffer::new(&gpu.card, "colours", Usage::Uniform),
            points_pass: PointsPass::new(&gpu),
            density: DensityPass::new(&gpu),
            halvings: 1,
            gpu,
        }
    }

    /// What targets are drawn with.
    pub fn paint(&self) -> Paint<'_> {
        Paint { pipelines: &self.pipelines, colours: &self.colours }
    }

    /// Sets the size of the canvas, and how finely it is sampled.
    pub fn resize(&mut self, width: u32, height: u32, pixel_ratio: f64) {
        let side = self.gpu.max_side.min(MAX_SIDE);
        let window = Window { width: width.min(side), height: height.min(side) };
        let fits = window.width.max(window.height) * 2 <= self.gpu.max_side;
        self.sampling = if fits && pixel_ratio < 2.0 { 2.0 } else { 1.0 };
        self.window = window;
        self.gpu.resize(window.width, window.height);
        self.work = Work::Anew;
    }

    /// The window of a target of `factor` times as many pixels each way.
    pub fn target_window(&self, factor: f64) -> Window {
        let side = |pixels: u32| ((f64::from(pixels) * factor).ceil() as u32).max(1);
        Window { width: side(self.window.width), height: side(self.window.height) }
    }

    pub fn to_target(&self, frame: &Frame, view: View, factor: f64) -> Affine2 {
        view.onto_target(frame.to_world, self.window, factor)
    }

    /// Takes one of the targets out, of the right size.
    pub fn fit(&mut self, shown: Shown, factor: f64) -> Target {
        let window = self.target_window(factor);
        let (kept, kind) = match shown {
            Shown::Front => (self.front.take(), Kind::Codes),
            Shown::Back => (self.back.take(), Kind::Codes),
            Shown::Sums => (self.sums.take(), Kind::Density),
            _ => (self.painted.take(), Kind::Picture),
        };
        let kept = kept.filter(|target| target.window == window);
        kept.unwrap_or_else(|| Target::new(&self.gpu, kind, window))
    }

    /// Pixels of a picture that is made at once, each way, for each one shown.
    pub fn factor(&self) -> f64 {
        self.sampling * 0.5_f64.powi(self.halvings as i32)
    }

    /// Takes half of the pixels each way, if that is allowed.
    pub fn halve(&mut self) -> bool {
        let may = self.halvings < MOST_HALVINGS;
        self.halvings += u32::from(may);
        may
    }

    /// Whether a picture of so many points is to be made anew: of fewer pixels where they are more than the budget,
    /// else of more where far fewer are, unless `coarser` says that more were too many.
    pub fn resize_for(&mut self, points: u64, budget: u64, coarser: &mut bool) -> bool {
        if points > budget && self.halve() {
            *coarser = true;
            return true;
        }
        // Twice the pixels each way take at most some four times the points.
        let finer = !*coarser && self.halvings > 0 && points * 5 < budget;
        self.halvings -= u32::from(finer);
        finer
    }

    /// The colours of a picture: what it is made from, the pixels of that for each one shown, and what sums are
    /// multiplied by. `tinted` says whether its codes are colours.
    pub fn colours(&self, frame: &Frame, tinted: bool, source: Window, factor: f64, gain: f32) -> Colours {
        let light = self.style.light_ground.unwrap_or_else(|| is_for_light_ground(&self.style.palette));
        Colours {
            source: [source.width as i32, source.height as i32],
            factor: factor as f32,
            gain: self.style.exposure.max(0.0) * gain,
            tinted: f32::from(u8::from(tinted)),
            slope: self.density.slope(),
            towards: f32::from(u8::from(!light)),
            ..Colours::new(self.style.colouring, &self.style.palette, frame.maps.len())
        }
    }

    /// The complete picture is ready.
    pub fn finish(&mut self, shown: Shown, complete: bool, points: u64) {
        self.complete = complete;
        self.work = Work::Done;
        self.show(shown, self.sampling, points);
    }

    pub fn show(&mut self, shown: Shown, factor: f64, points: u64) {
        self.shown = Some((shown, factor));
        self.points = points;
        self.stale = true;
    }

    /// Adds samples to a density. Points are coloured as they are drawn.
    pub fn add_density(&mut self, frame: &Frame, budget: u64) {
        let colours = self.colours(frame, false, self.window, 1.0, 0.0);
        let (enough, shown) = if self.gpu.software {
            (self.density.go_on_without(frame, &colours, self.window), Shown::SoftSums)
        } else {
            let target = self.fit(Shown::Sums, 1.0);
            self.colours.set(&self.gpu.card, &[colours]);
            let paint = Paint { pipelines: &self.pipelines, colours: &self.colours };
            let enough = self.density.go_on(&self.gpu, paint, frame, &target, budget);
            self.sums = Some(target);
            (enough, Shown::Sums)
        };
        self.complete = enough;
        self.work = if enough { Work::Done } else { Work::Density };
        self.show(shown, 1.0, self.density.points);
    }
}
