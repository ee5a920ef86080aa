//! A complete bent picture, on the processor.

use glam::DVec2;

use super::{Bent, Fineness, Placed, Verdict};
use crate::coverage::sweep::Progress;
use crate::picture::bitmap::Bitmap;
use crate::picture::colour::code_of_colour;
use crate::picture::window::Window;
use crate::pieces::letters::Letters;
use frond_deform::Cursor;

/// A walk like [`crate::Sweep`] down the tree of pieces of a bent attractor: pieces whose pixels are all lit are
/// dropped, and the first to reach a pixel is the one on top.
///
/// Where the bend is even inside of a piece, its parts are placed by its map, and no bend is asked any more.
#[derive(Debug)]
pub struct BentSweep {
    lit: Bitmap,
    codes: Vec<u32>,
    stack: Vec<Node>,
    detail: f64,
    coloured: bool,
    visited: u64,
    count: u64,
}

#[derive(Clone, Debug)]
enum Node {
    /// A piece that must be looked at.
    Piece { cursor: Cursor, letters: Letters, depth: usize },
    /// A part of one that was.
    Part { placed: Placed, letters: Letters, tint: u32 },
}

/// Visits for each pixel of the window, and on top, before there is an end in any case.
const MOST_VISITS: (u64, u64) = (300, 4_000_000);
/// The largest pieces of one colour, in pixels, where the bend carries colours.
const COLOURED_SIZE: f64 = 3.0;

impl BentSweep {
    /// Nothing yet.
    #[must_use]
    pub fn new() -> Self {
        let window = Window { width: 0, height: 0 };
        Self {
            lit: Bitmap::new(window),
            codes: Vec::new(),
            stack: Vec::new(),
            detail: 0.0,
            coloured: false,
            visited: 0,
            count: 0,
        }
    }

    /// Begins a picture. Pieces smaller than `detail` pixels are points. With `coloured` they have the colours that the
    /// bend carries.
    pub fn begin(&mut self, bent: &Bent<'_>, detail: f64, coloured: bool) {
        self.lit.reset(bent.window);
        self.codes.clear();
        self.codes.resize(bent.window.area(), 0);
        self.set(bent, detail, coloured);
    }

    /// Begins a picture on which some pixels are lit already: those that stay dark are swept, by [`BentSweep::find`].
    pub fn begin_on(&mut self, bent: &Bent<'_>, detail: f64, coloured: bool, lit: &Bitmap) {
        self.lit.clone_from(lit);
        self.codes = Vec::new();
        self.set(bent, detail, coloured);
    }

    /// The same of one map alone, by letters.
    pub fn begin_piece_on(&mut self, bent: &Bent<'_>, detail: f64, letter: usize, lit: &Bitmap) {
        self.begin_on(bent, detail, false, lit);
        let cursor = bent.bend.child(&bent.bend.whole(), letter);
        self.stack = vec![Node::Piece { cursor, letters: Letters::NONE.then(letter), depth: 1 }];
    }

    fn set(&mut self, bent: &Bent<'_>, detail: f64, coloured: bool) {
        self.stack.clear();
        self.stack.push(Node::Piece { cursor: bent.bend.whole(), letters: Letters::NONE, depth: 0 });
        (self.detail, self.coloured) = (detail, coloured);
        (self.visited, self.count) = (0, 0);
    }

    /// Visits at most so many pieces of what it began with.
    pub fn run(&mut self, bent: &Bent<'_>, visits: u64) -> Progress {
        let (mut codes, width) = (std::mem::take(&mut self.codes), bent.window.width as usize);
        let progress = self.find(bent, visits, &mut |(x, y), code| {
            if let Some(place) = codes.get_mut(y as usize * width + x as usize) {
                *place = code;
            }
        });
        self.codes = codes;
        progress
    }

    /// The same, which tells the pixels that become lit, with their codes, and keeps none.
    pub fn find(&mut self, bent: &Bent<'_>, visits: u64, light: &mut dyn FnMut((u32, u32), u32)) -> Progress {
        let patience = MOST_VISITS.0 * self.lit.window().area() as u64 + MOST_VISITS.1;
        for _ in 0..visits {
            let Some(node) = self.stack.pop() else { return Progress::Complete };
            if self.visited >= patience {
                return Progress::Probed;
            }
            self.visited += 1;
            match node {
                Node::Piece { cursor, letters, depth } => {
                    self.look(bent, &cursor, letters, depth, light);
                }
                Node::Part { placed, letters, tint } => self.visit(bent, &placed, letters, tint, light),
            }
        }
        if self.stack.is_empty() { Progress::Complete } else { Progress::Working }
    }

    /// Looks at a piece that may be bent in itself.
    fn look(
        &mut self,
        bent: &Bent<'_>,
        cursor: &Cursor,
        letters: Letters,
        depth: usize,
        light: &mut dyn FnMut((u32, u32), u32),
    ) {
        let size = if self.coloured { COLOURED_SIZE } else { f64::INFINITY };
        let (verdict, extent) = bent.judge(cursor, depth, 1.0, &Fineness::complete(size));
        if extent.is_none_or(|extent| self.lit.all(extent.pixels)) {
            return;
        }
        match verdict {
            Verdict::Outside => {}
            Verdict::Whole(placed) | Verdict::Rough(placed) => {
                let tint = if self.coloured { bent.tint(cursor) } else { 0 };
                self.visit(bent, &placed, letters, tint, light);
            }
            Verdict::Split => {
                self.stack.extend((0..bent.frame.maps.len()).map(|letter| Node::Piece {
                    cursor: bent.bend.child(cursor, letter),
                    letters: letters.then(letter),
                    depth: depth + 1,
                }));
            }
        }
    }

    /// Drops a part, lights its pixel, or puts its own parts on the stack.
    fn visit(
        &mut self,
        bent: &Bent<'_>,
        placed: &Placed,
        letters: Letters,
        tint: u32,
        light: &mut dyn FnMut((u32, u32), u32),
    ) {
        let Some(extent) = self.lit.window().extent_within(&placed.map, placed.wobble()) else { return };
        if self.lit.all(extent.pixels) {
            return;
        }
        if extent.size <= self.detail || extent.one_pixel() {
            let code = if self.coloured { code_of_colour(tint) } else { letters.code() };
            self.light(placed.at(bent.frame.anchor), code, light);
            if !extent.one_pixel() {
                for tip in &bent.frame.tips {
                    self.light(placed.at(*tip), code, light);
                }
            }
            return;
        }
        let parts = bent.frame.maps.iter().enumerate();
        self.stack.extend(parts.map(|(letter, map)| Node::Part {
            placed: placed.then(map),
            letters: letters.then(letter),
            tint,
        }));
    }

    fn light(&mut self, point: DVec2, code: u32, light: &mut dyn FnMut((u32, u32), u32)) {
        let Some(pixel) = self.lit.window().pixel(point) else { return };
        if self.lit.set(pixel) {
            self.count += 1;
            light(pixel, code);
        }
    }

    /// The codes of the pixels, row after row, 0 where nothing is, and the window they are of.
    #[must_use]
    pub fn codes(&self) -> (&[u32], Window) {
        (&self.codes, self.lit.window())
    }

    /// The codes alone.
    #[must_use]
    pub fn into_codes(self) -> Vec<u32> {
        self.codes
    }

    /// Pieces visited so far.
    #[must_use]
    pub fn visited(&self) -> u64 {
        self.visited
    }

    /// Pixels that are lit.
    #[must_use]
    pub fn lit(&self) -> u64 {
        self.count
    }
}

impl Default for BentSweep {
    fn default() -> Self {
        Self::new()
    }
}
