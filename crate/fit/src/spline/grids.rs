//! Descents from one beginning, on the grids on which the bytes are just filled.

use glam::DVec2;

use super::beginning::{Beginning, Start};
use super::contest::Contest;
use super::descent::Descent;
use super::pack::kept_grid;
use super::{FARTHEST, Node, Spline};
use crate::outline::{Guard, Outline};

/// A curve that has so much of its bytes is put up with.
const FILLED: f64 = 0.985;

/// Descents, each from what the one before has found.
#[derive(Clone, Debug)]
pub struct Grids {
    /// What is followed, and the outline's first point, which it is seen from.
    points: Vec<DVec2>,
    origin: DVec2,
    nodes: Vec<Node>,
    marks: Vec<usize>,
    guarded: bool,
    bends: bool,
    grid: f64,
    /// How dear a bit is in the first sweep of the first descent.
    greed: f64,
    /// The widest grid that was too fine, and the narrowest that was not.
    fine: f64,
    coarse: f64,
    round: usize,
    most: usize,
    descent: Option<Descent>,
}

impl Grids {
    /// On so many grids at most.
    pub fn new(followed: &Outline, contest: &Contest, from: Beginning, most: usize) -> Self {
        let origin = followed.points()[0];
        let Start { mut nodes, marks, grid, greed, bends } = from.start(followed, contest);
        nodes.iter_mut().for_each(|node| node.at -= origin);
        Self {
            points: followed.points().iter().map(|p| *p - origin).collect(),
            origin,
            nodes,
            marks,
            guarded: contest.guard().is_some_and(Guard::is_strict),
            bends,
            grid,
            greed,
            fine: 0.0,
            coarse: f64::INFINITY,
            round: 0,
            most,
            descent: None,
        }
    }

    /// About how far it is, from 0 to 1.
    pub fn share(&self) -> f64 {
        (self.round as f64 + self.descent.as_ref().map_or(0.0, Descent::share)) / self.most as f64
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
        self.end(contest) && self.round < self.most
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
        self.descent =
            Some(Descent::new(scaled, (nodes, self.marks.clone()), self.greed, (self.guarded, self.bends)));
        self.greed = 1.0;
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
