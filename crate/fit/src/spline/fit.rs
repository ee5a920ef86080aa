//! The nearest curve of nodes that is found within so many bytes.

use glam::DVec2;

use super::descent::{Descent, FEWEST};
use super::pack::kept_grid;
use super::{FARTHEST, MAX_NODES, Node, Spline};
use crate::fitting::Straight;
use crate::outline::{Fidelity, Guard, MAX_PREPARED, Outline, decimated, fidelity};

/// The fewest and the most bytes that a fit is asked to come to.
pub const LEAST_BYTES: usize = 32;
/// See [`LEAST_BYTES`].
pub const MOST_BYTES: usize = 4000;

/// How many points are followed for each byte, and how many at least and at most.
const POINTS_A_BYTE: usize = 6;
const POINTS: (usize, usize) = (400, 6000);

/// A curve that has so much of its bytes is put up with.
const FILLED: f64 = 0.985;

/// The most grids on which a descent is run from one beginning.
const MOST_GRIDS: usize = 6;

/// Bytes that every curve takes: the version, the grid, the first node, the law.
const HEAD_BYTES: usize = 13;

/// Sides of a parabola where curves are measured.
const SIDES: usize = 16;

/// How many bits a corner of the plain polylines takes that a fit has to beat.
const CORNER_BITS: [f64; 3] = [9.0, 11.0, 14.0];

/// A curve within so many bytes, and how near it is.
#[derive(Clone, Debug, PartialEq)]
pub struct SplineFit {
    /// The curve.
    pub spline: Spline,
    /// It packed.
    pub bytes: Vec<u8>,
    /// How near the outline it is, a parabola taken as 16 sides.
    pub near: Fidelity,
}

/// What is asked of curves, and the best so far.
struct Contest<'a> {
    outline: &'a Outline,
    budget: usize,
    guard: Option<Guard>,
    best: Option<SplineFit>,
}

impl Contest<'_> {
    /// How many bytes a curve takes; it is kept where it is the nearest of those that fit and cross themselves nowhere
    /// that they should not.
    fn show(&mut self, spline: Spline) -> Option<usize> {
        let bytes = spline.to_bytes().ok()?;
        let many = bytes.len();
        if many <= self.budget {
            let line = spline.polyline(SIDES);
            if line.len() >= 3 && self.guard.as_ref().is_none_or(|guard| guard.passes(&line)) {
                let near = fidelity(self.outline, &line);
                if near.rms.is_finite() && self.best.as_ref().is_none_or(|best| near.rms < best.near.rms) {
                    self.best = Some(SplineFit { spline, bytes, near });
                }
            }
        }
        Some(many)
    }

    /// The polygon on the finest grid on which it fits.
    fn show_polygon(&mut self, corners: &[DVec2]) {
        let diagonal = self.outline.diagonal();
        let (mut fits, mut fails) = (None, None);
        let mut exponent = 6.0_f64;
        for _ in 0..12 {
            let grid = kept_grid(diagonal * (-exponent).exp2());
            let mut nodes: Vec<Node> =
                corners.iter().map(|p| Node { at: (*p / grid).round(), on: true }).collect();
            nodes.dedup();
            let many = self.show(Spline { nodes, grid });
            if many.is_some_and(|many| many <= self.budget) {
                fits = Some(exponent);
            } else {
                fails = Some(exponent);
            }
            exponent = match (fits, fails) {
                (Some(fits), Some(fails)) => 0.5 * (fits + fails),
                (Some(fits), None) => fits + 2.0,
                (None, Some(fails)) => fails - 1.0,
                (None, None) => return,
            };
        }
    }

    /// Descents from corners of the outline, on the grids on which the bytes are just filled.
    fn descend(&mut self, bends: bool, on: bool) {
        let diagonal = self.outline.diagonal();
        let origin = self.outline.points()[0];
        let points = followed(self.outline, self.budget);
        let free = self.budget.saturating_sub(HEAD_BYTES).max(8) as f64;
        let start =
            ((8.0 * free / 9.0) as usize).clamp(FEWEST + 2, MAX_NODES / 2).min(points.points().len() / 2);
        let mut marks = decimated(&points, start);
        let mut nodes: Vec<Node> = marks.iter().map(|&mark| Node { at: points.points()[mark], on }).collect();
        let points: Vec<DVec2> = points.points().iter().map(|p| *p - origin).collect();
        nodes.iter_mut().for_each(|node| node.at -= origin);
        let mut grid = diagonal * 0.7 / free;
        let (mut fine, mut coarse) = (0.0, f64::INFINITY);
        let guarded = self.guard.as_ref().is_some_and(Guard::is_strict);
        for _ in 0..MOST_GRIDS {
            grid = kept_grid(grid);
            if (origin / grid).abs().max_element() > 0.5 * FARTHEST {
                return;
            }
            // Nodes are counted from the plane's origin, points from the outline's first: that is on the grid.
            let shift = (origin / grid).round();
            let scaled: Vec<DVec2> = points.iter().map(|p| (*p + origin - shift * grid) / grid).collect();
            let begin = nodes
                .iter()
                .map(|node| Node { at: ((node.at + origin - shift * grid) / grid).round(), ..*node });
            let mut descent = Descent::new(&scaled, (begin.collect(), marks), bends, guarded);
            descent.run();
            let (found, beside) = descent.finish();
            marks = beside;
            let place = |node: &Node| Node { at: node.at * grid + shift * grid - origin, ..*node };
            nodes = found.iter().map(place).collect();
            let kept = found.iter().map(|node| Node { at: node.at + shift, ..*node }).collect();
            let many = self.show(Spline { nodes: kept, grid });
            let filled = many.map_or(2.0, |many| many.saturating_sub(HEAD_BYTES).max(1) as f64 / free);
            if filled <= 1.0 {
                coarse = f64::min(coarse, grid);
            } else {
                fine = f64::max(fine, grid);
            }
            if (FILLED..=1.0).contains(&filled) {
                break;
            }
            // Bits go with about the root of the width. What was found before may be in the way: the search is no
            // function.
            let guess = grid * (filled / 0.993).powf(1.5).clamp(0.125, 8.0);
            grid = if fine > 0.0 && coarse.is_finite() && 1.02 * fine < coarse {
                guess.clamp(1.005 * fine, 0.995 * coarse)
            } else {
                guess
            };
        }
    }
}

/// Some points of an outline, as many as so many bytes can tell of.
fn followed(outline: &Outline, bytes: usize) -> Outline {
    let points = outline.points();
    let most = (POINTS_A_BYTE * bytes).clamp(POINTS.0, POINTS.1);
    if points.len() < most / 2 {
        return outline.resampled(most);
    }
    let some: Vec<DVec2> = points.iter().copied().step_by(points.len().div_ceil(most)).collect();
    Outline::new(&some).unwrap_or_else(|_| outline.resampled(most))
}

/// The nearest curve of corners and parabolas that is found within so many bytes (held to [`LEAST_BYTES`] and
/// [`MOST_BYTES`]), packed and all.
///
/// Squares of distances and bits are made small together (rate and distortion, or minimum description length): nodes
/// are moved on the grid, taken, added, bent. It is not farther from the outline (root mean square) than polylines of
/// corners chosen by least squares, each on the finest grid on which it fits into as many bytes of the same form. Where
/// the outline meets itself nowhere, the curve does not either.
///
/// None where nothing was found: the outline lies so far from the origin that places take too many bytes, or is so thin
/// that on a grid of some hundred steps it would fall together.
#[must_use]
pub fn fit_within(outline: &Outline, bytes: usize) -> Option<SplineFit> {
    let budget = bytes.clamp(LEAST_BYTES, MOST_BYTES);
    let prepared =
        if outline.points().len() > MAX_PREPARED { outline.resampled(MAX_PREPARED) } else { outline.clone() };
    let guard = Guard::new(&prepared);
    let mut contest = Contest { outline: &prepared, budget, guard: guard.clone(), best: None };
    let bits = 8.0 * budget.saturating_sub(HEAD_BYTES) as f64;
    let most = prepared.points().len();
    let mut counts: Vec<usize> =
        [3, 4, 6, 9].into_iter().chain(CORNER_BITS.map(|each| (bits / each) as usize)).collect();
    counts.retain(|&count| count <= most);
    counts.sort_unstable();
    counts.dedup();
    for count in counts {
        let line = Straight::new(&prepared, count.max(3), guard.clone()).finish();
        contest.show_polygon(&line.knots);
    }
    if contest.best.is_none() && contest.guard.as_ref().is_some_and(|guard| !guard.is_strict()) {
        // So few bytes cannot follow the outline to where it meets itself.
        contest.guard = None;
    }
    for (bends, on) in [(false, true), (true, true), (true, false)] {
        contest.descend(bends, on);
    }
    contest.best
}
