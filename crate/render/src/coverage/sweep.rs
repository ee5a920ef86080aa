//! The complete picture, on the CPU: every pixel that a piece of the attractor touches.

use frond_core::Affine2;

use crate::coverage::canvas::{Canvas, Hit, Node};
use crate::coverage::probe::Probe;
use crate::picture::bitmap::Bitmap;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::Letters;

/// How far a [`Sweep`] got.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// There is more to visit.
    Working,
    /// Every piece was visited: the picture is complete.
    Complete,
    /// The pieces overlap so much that they could not all be visited. The picture was filled by probing
    /// at random until nothing new came to light: it is as good as complete, but that is not certain.
    Probed,
}

/// A walk down the tree of pieces that lights pixels, in portions.
///
/// Pieces are visited later maps first, so that the first piece to reach a pixel is the one on top. A
/// piece is dropped when it is outside of the window or every pixel of its bounding box is lit; it lights
/// a pixel when its box lies within it, or when it is smaller than `detail` and its anchor (a point of the
/// attractor) lies there. So no pixel without a point of the attractor is ever lit, and a pixel is missed
/// only if the attractor reaches less than `detail` into it.
///
/// Where pieces cover each other many times over (two maps of ratio 0.9: more words than could ever be
/// visited), the walk would be stuck at the rim of the shape, in pixels that boxes touch and pieces do
/// not. It then draws large pieces as clouds of points, found by a [`Flood`](crate::Flood).
#[derive(Debug)]
pub struct Sweep {
    frame: Frame,
    root: Node,
    detail: f64,
    canvas: Canvas,
    stack: Vec<Node>,
    visited: u64,
    probe: Option<Probe>,
}

/// Visits before overlap is suspected, for each pixel of the window and at most, and those allowed for each
/// lit pixel: plain shapes take 5 to 100.
const VISITS_BEFORE_DOUBT: (u64, u64) = (8, 100_000);
/// Where the window shows a small part only, it takes a while to find anything in it.
const CLOSE_PATIENCE: u64 = 2_000_000;
const VISITS_A_PIXEL: u64 = 300;
/// So many pixels that were lit before count as one: what is left of plain shapes takes up to 14 visits for each.
const LIT_BEFORE: u64 = 16;
/// Points a probe draws before the budget is looked at again.
const POINTS_A_PORTION: u64 = 4096;

impl Sweep {
    /// A sweep over a picture of the attractor under `to_screen`, the map from the unit
    /// coordinates of `frame` to pixels. `detail` is in pixels.
    #[must_use]
    pub fn new(frame: &Frame, to_screen: Affine2, window: Window, detail: f64) -> Self {
        let root = Node { map: to_screen, letters: Letters::NONE };
        let mut sweep = Self {
            frame: frame.clone(),
            root,
            detail,
            canvas: Canvas { lit: Bitmap::new(window), count: 0 },
            stack: Vec::new(),
            visited: 0,
            probe: None,
        };
        sweep.restart(frame, to_screen, window, detail);
        sweep
    }

    /// Begins another picture in the same memory, on which some pixels are lit already: those that stay dark are
    /// swept. With what was lit it is as complete as a picture from nothing.
    pub fn restart_on(&mut self, frame: &Frame, to_screen: Affine2, lit: &Bitmap, detail: f64) {
        self.restart(frame, to_screen, lit.window(), detail);
        self.canvas.lit.clone_from(lit);
        self.canvas.count = lit.count() as u64;
    }

    /// The same of one piece of the attractor alone, whose map to the screen and first letters these are.
    pub(crate) fn restart_piece_on(&mut self, frame: &Frame, piece: Node, lit: &Bitmap, detail: f64) {
        self.restart_on(frame, piece.map, lit, detail);
        // What is lit already needs no visits but those of its rim.
        self.canvas.count /= LIT_BEFORE;
        self.root = piece;
        for node in &mut self.stack {
            *node = piece;
        }
    }

    /// Begins another picture in the same memory.
    pub fn restart(&mut self, frame: &Frame, to_screen: Affine2, window: Window, detail: f64) {
        self.frame.clone_from(frame);
        self.root = Node { map: to_screen, letters: Letters::NONE };
        self.detail = detail;
        self.canvas.lit.reset(window);
        self.canvas.count = 0;
        self.stack.clear();
        self.visited = 0;
        self.probe = None;
        if to_screen.is_finite() {
            self.stack.push(self.root);
        }
    }

    /// Pieces visited so far.
    #[must_use]
    pub fn visited(&self) -> u64 {
        self.visited
    }

    /// The lit pixels.
    #[must_use]
    pub fn lit(&self) -> &Bitmap {
        &self.canvas.lit
    }

    /// Visits at most about `budget` pieces, reports each pixel that becomes lit, and says how far it got.
    pub fn run(&mut self, budget: u64, mut light: impl FnMut(Hit)) -> Progress {
        self.run_for(budget, &mut light)
    }

    /// The same, compiled once for whatever is told of the pixels: a module that is sent is smaller so.
    fn run_for(&mut self, budget: u64, mut light: &mut dyn FnMut(Hit)) -> Progress {
        let end = self.visited.saturating_add(budget);
        if self.probe.is_none() {
            match self.walk_for(budget, light) {
                Walk::Complete => return Progress::Complete,
                Walk::Working => return Progress::Working,
                Walk::Stuck => self.probe = Some(Probe::new(&self.frame, self.root, &self.canvas.lit)),
            }
        }
        let Some(probe) = &mut self.probe else { return Progress::Working };
        while self.visited < end {
            let portion = (end - self.visited).min(POINTS_A_PORTION);
            let visits = probe.run(&self.frame, self.root, &mut self.canvas, portion, &mut light);
            self.visited += visits;
            if visits == 0 {
                return Progress::Probed;
            }
        }
        Progress::Working
    }

    /// The same without going over to a probe.
    pub(crate) fn walk(&mut self, budget: u64, mut light: impl FnMut(Hit)) -> Walk {
        self.walk_for(budget, &mut light)
    }

    fn walk_for(&mut self, budget: u64, mut light: &mut dyn FnMut(Hit)) -> Walk {
        let end = self.visited.saturating_add(budget);
        let window = self.canvas.lit.window();
        let whole = 2.0 * f64::from(window.width.max(window.height));
        let patience = match window.extent(&self.root.map) {
            Some(extent) if extent.size > whole => CLOSE_PATIENCE,
            _ => (VISITS_BEFORE_DOUBT.0 * window.area() as u64).clamp(2000, VISITS_BEFORE_DOUBT.1),
        };
        while self.visited < end {
            let Some(node) = self.stack.pop() else { return Walk::Complete };
            self.visited += 1;
            visit(&self.frame, self.detail, node, &mut self.canvas, &mut self.stack, &mut light);
            if self.visited > patience + VISITS_A_PIXEL * self.canvas.count {
                return Walk::Stuck;
            }
        }
        Walk::Working
    }
}

/// How far a [`Sweep::walk`] got.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Walk {
    /// There is more to visit.
    Working,
    /// Every piece was visited.
    Complete,
    /// Pieces overlap too much to visit them all.
    Stuck,
}

/// Drops a piece, lights its pixel, or puts its parts on the stack, the last on top.
#[inline]
fn visit(
    frame: &Frame,
    detail: f64,
    node: Node,
    canvas: &mut Canvas,
    stack: &mut Vec<Node>,
    light: &mut impl FnMut(Hit),
) {
    let Some(extent) = canvas.lit.window().extent(&node.map) else { return };
    if canvas.lit.all(extent.pixels) {
        return;
    }
    // Each pixel needs a colour, so that the whole shape has to be taken apart at least once.
    let lettered = node.letters.count() > 0;
    if lettered && (extent.size <= detail || extent.one_pixel()) {
        canvas.light(node.map.apply(frame.anchor), node.letters, light);
        if !extent.one_pixel() {
            for tip in &frame.tips {
                canvas.light(node.map.apply(*tip), node.letters, light);
            }
        }
        return;
    }
    for (letter, map) in frame.maps.iter().enumerate() {
        stack.push(Node { map: node.map * *map, letters: node.letters.then(letter) });
    }
}
