//! Descents from one beginning, on the grids on which the bytes are just filled.

use glam::DVec2;

use super::contest::Contest;
use super::descent::{Descent, FEWEST};
use super::pack::kept_grid;
use super::{FARTHEST, MAX_NODES, Node, Spline};
use crate::outline::{Guard, Outline, decimated};

/// A curve that has so much of its bytes is put up with.
const FILLED: f64 = 0.985;

/// The most grids on which a descent is run from one beginning.
const MOST_GRIDS: usize = 6;

/// About how many bits a node takes.
const NODE_BITS: f64 = 9.0;

/// Descents, each from what the one before has found.
#[derive(Clone, Debug)]
pub struct Grids {
    /// What is followed, and the outline's first point, which it is seen from.
    points: Vec<DVec2>,
    origin: DVec2,
    nodes: Vec<Node>,
    marks: Vec<usize>,
    bends: bool,
    guarded: bool,
    grid: f64,
    /// The widest grid that was too fine, and the narrowest that was not.
    fine: f64,
    coarse: f64,
    round: usize,
    descent: Option<Descent>,
}

impl Grids {
    pub fn new(followed: &Outline, contest: &Contest, bends: bool, on: bool) -> Self {
        let points = followed.points();
        let free = contest.free_bits().max(64.0);
        let start = ((free / NODE_BITS) as usize).clamp(FEWEST + 2, MAX_NODES / 2).min(points.len() / 2);
        let marks = decimated(followed, start);
        let origin = points[0];
        let nodes = marks.iter().map(|&mark| Node { at: points[mark] - origin, on }).collect();
        Self {
            points: points.iter().map(|p| *p - origin).collect(),
            origin,
            nodes,
            marks,
            bends,
            guarded: contest.guard().is_some_and(Guard::is_strict),
            grid: contest.outline().diagonal() * 5.6 / free,
            fine: 0.0,
            coarse: f64::INFINITY,
            round: 0,
            descent: None,
        }
    }

    /// About how far it is, from 0 to 1.
    pub fn share(&self) -> f64 {
        (self.round as f64 + self.descent.as_ref().map_or(0.0, Descent::share)) / MOST_GRIDS as f64
    }

    /// The grid point that the first point lies on: nodes are counted from the plane's origin, points from it.
    fn shift(&self) -> DVec2 {
        (self.origin / self.grid).round()
    }

    /// One step; false where there is nothing more to do.
    pub fn step(&mut self, contest: &mut Contest) -> bool {
        let Some(descent) = &mut self.descent else { return self.begin() };
        if descent.step() {
            return true;
        }
        self.round += 1;
        self.end(contest) && self.round < MOST_GRIDS
    }

    fn begin(&mut self) -> bool {
        self.grid = kept_grid(self.grid);
        if (self.origin / self.grid).abs().max_element() > 0.5 * FARTHEST {
            return false;
        }
        let off = self.origin - self.shift() * self.grid;
        let scaled = self.points.iter().map(|p| (*p + off) / self.grid).collect();
        let place = |node: &Node| Node { at: ((node.at + off) / self.grid).round(), ..*node };
        let nodes = self.nodes.iter().map(place).collect();
        self.descent = Some(Descent::new(scaled, (nodes, self.marks.clone()), self.bends, self.guarded));
        true
    }

    /// Shows what was found, and chooses the next grid.
    fn end(&mut self, contest: &mut Contest) -> bool {
        let Some(descent) = self.descent.take() else { return false };
        let (found, marks) = descent.finish();
        let (grid, shift) = (self.grid, self.shift());
        self.marks = marks;
        let place = |node: &Node| Node { at: (node.at + shift) * grid - self.origin, ..*node };
        self.nodes = found.iter().map(place).collect();
        let nodes = found.iter().map(|node| Node { at: node.at + shift, ..*node }).collect();
        let filled = contest.show(Spline { nodes, grid }).map_or(2.0, |many| contest.filled(many));
        if filled <= 1.0 {
            self.coarse = f64::min(self.coarse, grid);
        } else {
            self.fine = f64::max(self.fine, grid);
        }
        // Bits go with about the root of the width. What was found before may be in the way: the search is no
        // function.
        let guess = grid * (filled / 0.993).powf(1.5).clamp(0.125, 8.0);
        self.grid = if self.fine > 0.0 && self.coarse.is_finite() && 1.02 * self.fine < self.coarse {
            guess.clamp(1.005 * self.fine, 0.995 * self.coarse)
        } else {
            guess
        };
        !(FILLED..=1.0).contains(&filled)
    }
}
