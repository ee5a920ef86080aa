//! The best curve so far of those that keep within the bytes.

use super::{MAX_NODES, Spline};
use crate::outline::{Guard, MAX_PREPARED, Nearest, Outline, corners};

/// Sides of a parabola where curves are measured.
pub const SIDES: usize = 16;

/// Bytes that every curve takes: the version, the grid, the first node, the law.
const HEAD_BYTES: usize = 9;

/// A root mean square that nobody sees, in parts of the diagonal: closed curves are kept as finely.
const ENOUGH: f64 = 5e-6;

/// What is asked of curves, and the best so far.
#[derive(Clone, Debug)]
pub struct Contest {
    outline: Outline,
    budget: usize,
    guard: Option<Guard>,
    best: Option<(f64, Spline, Vec<u8>)>,
}

impl Contest {
    /// An outline of more than [`MAX_PREPARED`] points is measured at so many places along it, at half as many where
    /// its corners are few.
    pub fn new(outline: &Outline, budget: usize) -> Self {
        let outline = if outline.points().len() <= MAX_PREPARED {
            outline.clone()
        } else if let Some(few) = corners(outline, MAX_NODES).and_then(|few| Outline::new(&few).ok()) {
            // Places at even distances would miss its corners.
            few.subdivided(MAX_PREPARED / 2)
        } else {
            outline.resampled(MAX_PREPARED)
        };
        let guard = Guard::new(&outline);
        Self { outline, budget, guard, best: None }
    }

    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// Where curves may cross themselves; none where they may anywhere.
    pub fn guard(&self) -> Option<&Guard> {
        self.guard.as_ref()
    }

    /// Where nothing was found for an outline that meets itself, curves may cross themselves anywhere. Whether that is
    /// new.
    pub fn relax(&mut self) -> bool {
        let relaxes = self.best.is_none() && self.guard.as_ref().is_some_and(|guard| !guard.is_strict());
        if relaxes {
            self.guard = None;
        }
        relaxes
    }

    /// How many bytes a curve may take.
    pub fn budget(&self) -> usize {
        self.budget
    }

    /// Whether a curve takes no more bytes than that.
    pub fn fits(&self, spline: &Spline) -> bool {
        spline.clone().cut_where_it_costs().to_bytes().is_ok_and(|bytes| bytes.len() <= self.budget)
    }

    /// The best, and it packed.
    pub fn best(&self) -> Option<(&Spline, &[u8])> {
        self.best.as_ref().map(|(_, spline, bytes)| (spline, &bytes[..]))
    }

    /// Whether no curve can be nearer than the best.
    pub fn is_exact(&self) -> bool {
        self.best.as_ref().is_some_and(|best| best.0 == 0.0)
    }

    /// Whether the best is so near that it cannot be told from the outline: then there is nothing to look for.
    pub fn is_enough(&self) -> bool {
        let most = ENOUGH * self.outline.diagonal();
        let squares = self.outline.points().len() as f64 * most * most;
        self.best.as_ref().is_some_and(|best| best.0 <= squares)
    }

    /// How many bits are there for nodes.
    pub fn free_bits(&self) -> f64 {
        8.0 * self.budget.saturating_sub(HEAD_BYTES) as f64
    }

    /// What part of the bits for nodes so many bytes are.
    pub fn filled(&self, bytes: usize) -> f64 {
        8.0 * bytes.saturating_sub(HEAD_BYTES).max(1) as f64 / self.free_bits()
    }

    /// How many bytes a curve takes; it is kept where it is the nearest of those that fit and cross themselves nowhere
    /// that they should not.
    pub fn show(&mut self, spline: Spline) -> Option<usize> {
        let spline = spline.cut_where_it_costs();
        let bytes = spline.to_bytes().ok()?;
        let many = bytes.len();
        if many <= self.budget {
            let line = spline.polyline(SIDES);
            let most = self.best.as_ref().map_or(f64::INFINITY, |best| best.0);
            if line.len() >= 3 {
                let near = Nearest::new(&line, true);
                let squares: f64 = self.outline.points().iter().map(|&p| near.to(p).squared).sum();
                if squares < most && self.guard.as_ref().is_none_or(|guard| guard.passes(&line)) {
                    self.best = Some((squares, spline, bytes));
                }
            }
        }
        Some(many)
    }
}
