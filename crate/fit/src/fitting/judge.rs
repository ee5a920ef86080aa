//! What a fit is measured by in the end, and what it must not be.

use std::collections::VecDeque;

use glam::DVec2;

use crate::closed::ClosedCurve;
use crate::outline::{Fidelity, Gauge, Guard, Outline, to_side};

/// The polyline of a fit leaves the curve by no more than this, in parts of the diagonal of the outline, and opens
/// copies so deep. This is what is drawn, and what is measured.
pub const DRAWING_TOLERANCE: f64 = 1e-4;
/// See [`DRAWING_TOLERANCE`].
pub const DRAWING_LEVELS: usize = 12;

/// A first look takes a coarser drawing: as coarse as this part of the best root mean square, but no coarser than this
/// part of the diagonal.
const ROUGH_SHARE: f64 = 0.2;
const MOST_ROUGH: f64 = 1.5e-3;

/// What lies on a side that is not opened is thought to stray by no more than this times what is seen of its edge.
const UNSEEN: f64 = 1.25;

/// What it takes to draw a point and to look for crossings there, and to measure it, in the refiner's units of work.
const DRAWING_WORK: u64 = 16;
const MEASURING_WORK: u64 = 28;

/// So many curves that were shown are kept in mind.
const MOST_SHOWN: usize = 16;

/// Rounds of taking copies from edges that cross others.
const MOST_REPAIRS: usize = 12;

/// Differences of box dimension below this do not count.
const SLOPE_TOLERANCE: f64 = 0.004;

/// What a difference of 1 beyond it counts.
const SLOPE_WEIGHT: f64 = 1.0;

/// The Hausdorff distance may be so many root mean squares.
const MOST_HAUSDORFF: f64 = 4.5;

/// What each further one counts.
const FAR_WEIGHT: f64 = 0.005;

/// Beyond this, in percent of the diagonal, all of it counts: a spike may take nothing from the root mean square.
const STRAY: f64 = 25.0;

/// What a coarser grid may add to the error, in parts of it: it saves some eight bits a knot.
const COARSE_SHARE: f64 = 0.005;

/// The grid of documents is doubled so many times at most.
const MOST_DOUBLINGS: i32 = 10;

/// A fit that is no farther than this, in percent of the diagonal, cannot be told from its outline: documents keep
/// knots to a thousandth of a percent.
const EXACT_RMS: f64 = 1e-3;
const EXACT_HAUSDORFF: f64 = 5e-3;

/// Whether a fit is all that could be asked of one.
pub(crate) fn is_exact(near: &Fidelity) -> bool {
    near.rms <= EXACT_RMS && near.hausdorff <= EXACT_HAUSDORFF
}

/// How good a fit is, the smaller the better: the root mean square distance, raised a little by how much the
/// roughness is off and by how far the farthest point is.
fn score(near: &Fidelity) -> f64 {
    score_of(near.rms, near.hausdorff, near.slope_difference())
}

/// With a difference of 0 no more than with any other.
fn score_of(rms: f64, hausdorff: f64, slope_difference: f64) -> f64 {
    let slope = (slope_difference.abs() - SLOPE_TOLERANCE).max(0.0);
    let far = if rms > 0.0 { (hausdorff / rms - MOST_HAUSDORFF).max(0.0) } else { 0.0 };
    rms * (1.0 + SLOPE_WEIGHT * slope + FAR_WEIGHT * far) + (hausdorff - STRAY).max(0.0)
}

/// A curve as documents keep it, and how near it is.
#[derive(Clone, Debug)]
pub(crate) struct Judged {
    pub curve: ClosedCurve,
    pub near: Fidelity,
    score: f64,
}

/// Keeps the best of the curves that are shown to it, which is never worse than the polyline that it begins with.
#[derive(Clone, Debug)]
pub(crate) struct Judge {
    gauge: Gauge,
    /// Of the outline.
    diagonal: f64,
    guard: Option<Guard>,
    line: Judged,
    best: Judged,
    /// Whether a rough look comes first.
    roughly: bool,
    /// The curves that were shown last, as documents keep them: none of them will be better now than it was then.
    shown: VecDeque<ClosedCurve>,
    work: u64,
}

impl Judge {
    /// Begins with the best polyline, which is taken as it is. What is shown is looked at `roughly` first, or not.
    pub fn new(outline: &Outline, guard: Option<Guard>, line: ClosedCurve, roughly: bool) -> Self {
        let gauge = Gauge::new(outline);
        let near = gauge.measure(&line.knots);
        let line = Judged { score: score(&near), curve: line, near };
        Self {
            gauge,
            diagonal: outline.diagonal(),
            guard,
            best: line.clone(),
            line,
            roughly,
            shown: VecDeque::new(),
            work: 0,
        }
    }

    /// Where curves may cross themselves.
    pub fn guard(&self) -> Option<&Guard> {
        self.guard.as_ref()
    }

    /// The best so far.
    pub fn best(&self) -> &Judged {
        &self.best
    }

    /// Whether a rough look comes first.
    pub fn looks_roughly(&self) -> bool {
        self.roughly
    }

    /// How much has been done so far, in the refiner's units of work, about.
    pub fn work(&self) -> u64 {
        self.work
    }

    /// Measures a curve as a document brings it back, and keeps it where it is the best so far. Copies that make it
    /// cross itself are taken from it. Whether it was kept.
    pub fn show(&mut self, curve: &ClosedCurve) -> bool {
        let Ok(curve) = curve.quantised() else { return false };
        if self.shown.contains(&curve) {
            return false;
        }
        if self.shown.len() == MOST_SHOWN {
            self.shown.pop_front();
        }
        self.shown.push_back(curve.clone());
        self.measure(&curve, self.roughly)
    }

    /// Keeps a curve where it is the best so far, which a rough look may deny. Whether it was kept.
    #[inline(never)]
    pub fn measure(&mut self, curve: &ClosedCurve, roughly_first: bool) -> bool {
        let Some((curve, line)) = self.untangled(curve, roughly_first) else { return false };
        self.work += MEASURING_WORK * line.len() as u64;
        let keeps = |rms: f64, hausdorff: Option<f64>| self.keeps(rms, hausdorff.unwrap_or(0.0));
        let Some(near) = self.gauge.measure_where(&line, keeps) else { return false };
        let score = score(&near);
        if score >= self.best.score {
            return false;
        }
        self.best = Judged { curve, near, score };
        true
    }

    /// At the same numbers, and so far as is measured: no worse than the polyline, and better than the best.
    fn keeps(&self, rms: f64, hausdorff: f64) -> bool {
        rms <= self.line.near.rms && score_of(rms, hausdorff, 0.0) < self.best.score
    }

    /// Whether a curve may be better than the best, by a drawing that is coarser than what is measured in the end, and
    /// takes much less where copies of copies fill the plane.
    #[inline(never)]
    pub fn may_keep(&mut self, curve: &ClosedCurve) -> bool {
        let tolerance = (ROUGH_SHARE / 100.0 * self.best.near.rms).min(MOST_ROUGH);
        if tolerance <= 2.0 * DRAWING_TOLERANCE || curve.copies() == 0 {
            return true;
        }
        let expansion = curve.expand(tolerance * self.diagonal, DRAWING_LEVELS);
        let line = expansion.points();
        self.work += DRAWING_WORK * line.len() as u64;
        let height = |edge: usize| {
            let (a, b) = (curve.knots[edge], curve.knot(edge + 1));
            let corners = &line[expansion.starts[edge]..expansion.starts[edge + 1]];
            let squares = corners.iter().map(|&p| to_side(p, a, b).1);
            (squares.fold(0.0, f64::max) / a.distance_squared(b)).sqrt()
        };
        let steepest = (0..curve.knots.len()).map(height).fold(0.0, f64::max);
        let least = self.gauge.rms(&line) - 100.0 * UNSEEN * steepest * tolerance;
        self.keeps(least.max(0.0), 0.0)
    }

    /// Puts the best on a coarser grid, doubled as long as it is as good but for a two-hundredth, and no worse than the
    /// polyline: there it takes fewer bytes.
    pub fn coarsen(&mut self) {
        let fine = self.best.clone();
        let rms = self.line.near.rms.min(fine.near.rms * (1.0 + COARSE_SHARE));
        for doublings in 1..=MOST_DOUBLINGS {
            let coarse = fine.curve.coarsened(doublings).ok();
            let Some((curve, line)) = coarse.and_then(|curve| self.untangled(&curve, false)) else { return };
            let near = self.gauge.measure(&line);
            let score = score(&near);
            let whole = curve.numbers() == fine.curve.numbers();
            if !whole || near.rms > rms || score > fine.score * (1.0 + COARSE_SHARE) {
                return;
            }
            self.best = Judged { curve, near, score };
        }
    }

    /// The curve as documents keep it and its drawing, which crosses itself at most where the outline does; none where
    /// its knots do not allow it. None, too, where a rough look says that it will
    /// not be the best.
    #[inline(never)]
    fn untangled(&mut self, curve: &ClosedCurve, roughly_first: bool) -> Option<(ClosedCurve, Vec<DVec2>)> {
        let mut curve = curve.quantised().ok()?;
        for _ in 0..MOST_REPAIRS {
            if roughly_first && !self.may_keep(&curve) {
                return None;
            }
            let expansion = curve.expand(DRAWING_TOLERANCE * self.diagonal, DRAWING_LEVELS);
            let line = expansion.points();
            self.work += DRAWING_WORK * line.len() as u64;
            let Some(guard) = &self.guard else { return Some((curve, line)) };
            let faults = guard.faults(&line);
            if faults.as_ref().is_some_and(Vec::is_empty) {
                return Some((curve, line));
            }
            let edge = |side: usize| expansion.starts.partition_point(|&start| start <= side) - 1;
            let mut straightened = false;
            for (i, j) in faults? {
                for edge in [edge(i), edge(j)] {
                    straightened |= curve.edges.get_mut(edge).and_then(Option::take).is_some();
                }
            }
            if !straightened {
                return None;
            }
            curve = curve.quantised().ok()?;
        }
        None
    }
}
