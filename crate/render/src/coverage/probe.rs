//! Filling a picture whose pieces cannot all be visited.

use frond_core::{Affine2, hash};
use glam::DVec2;

use crate::coverage::canvas::{Canvas, Hit, Node};
use crate::coverage::flood::Flood;
use crate::picture::bitmap::Bitmap;
use crate::pieces::frame::Frame;

/// Large pieces drawn as clouds of points.
///
/// The points come from a [`Flood`], which no overlap can slow down. A shape that is seen whole is drawn
/// at once. Where the view is closer, the pieces that may hold dark pixels are found by random descents;
/// a pixel in the box of a piece that leaves it dark is blamed, and after enough of that it is closed and
/// draws no more probes. The pieces are from all over the tree, so that a pixel that many of them cover is
/// soon lit, and one that is closed was hardly touched by any.
#[derive(Debug)]
pub(crate) struct Probe {
    flood: Flood,
    flooded: bool,
    /// Pieces are at most this large, in pixels.
    piece: f64,
    /// Pixels that are lit or closed.
    settled: Bitmap,
    blame: Vec<u8>,
    /// Pieces to be drawn, and how many points of the topmost are.
    waiting: Vec<Node>,
    drawn: usize,
    random: u32,
    idle: u32,
    left: u64,
}

/// Pixels between the points of a cloud.
const CLOUD_SPACING: f64 = 0.5;
/// The finest grid, and the most points to be taken through steps for it.
const FINEST_GRID: f64 = 2048.0;
const MOST_FLOOD_POINTS: f64 = 2.4e7;
/// The largest pieces, in pixels, where the shape is not seen whole.
const LARGEST_PIECE: f64 = 512.0;
/// Probes that must find nothing in a pixel before it is closed.
const FAILED_PROBES: u8 = 24;
/// Probes in a row that change nothing before there is an end.
const IDLE_PROBES: u32 = 64;
/// Steps of one descent, at most.
const MOST_STEPS: u64 = 4000;
/// Points and steps, for each pixel of the window and on top, before there is an end in any case.
const MOST_WORK: (u64, u64) = (64, 8_000_000);

impl Probe {
    pub fn new(frame: &Frame, root: Node, lit: &Bitmap) -> Self {
        let size = lit.window().extent_once(&root.map).map_or(1.0, |extent| extent.size);
        let whole = size * 0.5 < FINEST_GRID * CLOUD_SPACING * 2.0;
        let piece = if whole { f64::INFINITY } else { LARGEST_PIECE };
        let finest = FINEST_GRID.min((MOST_FLOOD_POINTS / frame.steps.len() as f64).sqrt());
        let cells = (size.min(piece) / CLOUD_SPACING).min(finest).max(16.0);
        let waiting = if whole { parts(frame, root).collect() } else { Vec::new() };
        Self {
            flood: Flood::new(frame, cells as u32),
            flooded: false,
            piece,
            settled: lit.clone(),
            blame: if whole { Vec::new() } else { vec![0; lit.window().area()] },
            waiting,
            drawn: 0,
            random: 0,
            idle: 0,
            left: MOST_WORK.0 * lit.window().area() as u64 + MOST_WORK.1,
        }
    }

    /// Works for about `budget` points. Returns how many it were, 0 when nothing more is to be found.
    pub fn run(
        &mut self,
        frame: &Frame,
        root: Node,
        canvas: &mut Canvas,
        budget: u64,
        light: &mut impl FnMut(Hit),
    ) -> u64 {
        if !self.flooded {
            self.flooded = self.flood.run(budget);
            return budget;
        }
        if self.left == 0 {
            return 0;
        }
        let visits = match self.waiting.last().copied() {
            Some(piece) => self.draw(piece, canvas, budget, light),
            None if self.piece.is_infinite() || self.idle > IDLE_PROBES => 0,
            None => {
                self.idle += 1;
                let (piece, visits) = self.descend(frame, root);
                self.waiting.extend(piece);
                visits
            }
        };
        self.left = self.left.saturating_sub(visits);
        visits
    }

    /// Draws more points of a piece.
    fn draw(&mut self, piece: Node, canvas: &mut Canvas, budget: u64, light: &mut impl FnMut(Hit)) -> u64 {
        let points = &self.flood.points()[self.drawn..];
        let portion = points.len().min(budget as usize);
        let before = canvas.count;
        for point in &points[..portion] {
            let [x, y] = point.position.map(f64::from);
            let letters = piece.letters.join(point.letters);
            canvas.light(piece.map.apply(DVec2::new(x, y)), letters, light);
        }
        if canvas.count > before {
            self.idle = 0;
        }
        self.drawn += portion;
        if self.drawn == self.flood.points().len() {
            self.drawn = 0;
            self.waiting.pop();
            self.settle(&piece.map, canvas);
        }
        portion.max(1) as u64
    }

    /// Goes down to a piece that may hold dark pixels, by chance.
    fn descend(&mut self, frame: &Frame, root: Node) -> (Option<Node>, u64) {
        let mut visits = 1;
        let mut node = root;
        loop {
            let Some(extent) = self.settled.window().extent_once(&node.map) else { return (None, visits) };
            if extent.size <= self.piece && node.letters.count() > 0 {
                return (Some(node), visits);
            }
            if visits > MOST_STEPS {
                return (None, visits);
            }
            let count = frame.steps.len();
            // From a random step on, the first whose piece may hold a dark pixel.
            self.random = self.random.wrapping_add(1);
            let first = hash::counter(23, self.random) as usize % count;
            let next = (0..count).map(|i| (first + i) % count).find_map(|i| {
                visits += 1;
                let (step, letters) = frame.steps[i];
                let map = node.map * step;
                let extent = self.settled.window().extent_once(&map)?;
                let part = Node { map, letters: node.letters.join(letters) };
                (!self.settled.all(extent.pixels)).then_some(part)
            });
            let Some(next) = next else { return (None, visits) };
            node = next;
        }
    }

    /// Notes what a piece that has been drawn lit and what it left dark.
    fn settle(&mut self, piece: &Affine2, canvas: &Canvas) {
        if self.blame.is_empty() {
            return;
        }
        let Some(extent) = self.settled.window().extent_once(piece) else { return };
        for y in extent.pixels.y.0..=extent.pixels.y.1 {
            for x in extent.pixels.x.0..=extent.pixels.x.1 {
                if self.settled.get((x, y)) {
                    continue;
                }
                let blame = &mut self.blame[self.settled.index((x, y))];
                *blame += 1;
                if canvas.lit.get((x, y)) || *blame >= FAILED_PROBES {
                    self.settled.set((x, y));
                    self.idle = 0;
                }
            }
        }
    }
}

/// The parts of a piece, the last map last.
fn parts(frame: &Frame, node: Node) -> impl Iterator<Item = Node> {
    frame
        .maps
        .iter()
        .enumerate()
        .map(move |(letter, map)| Node { map: node.map * *map, letters: node.letters.then(letter) })
}
