//! The best curve so far of those that keep within the bytes.

use glam::DVec2;

use super::pack::kept_grid;
use super::{Node, Spline};
use crate::outline::{Guard, Nearest, Outline};

/// Sides of a parabola where curves are measured.
pub const SIDES: usize = 16;

/// Bytes that every curve takes: the version, the grid, the first node, the law.
const HEAD_BYTES: usize = 9;

/// How many grids are tried for a polygon.
const POLYGON_GRIDS: usize = 12;

/// What is asked of curves, and the best so far.
#[derive(Clone, Debug)]
pub struct Contest {
    outline: Outline,
    budget: usize,
    guard: Option<Guard>,
    best: Option<(f64, Spline, Vec<u8>)>,
}

impl Contest {
    pub fn new(outline: Outline, budget: usize) -> Self {
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

    /// Where nothing was found for an outline that meets itself, curves may cross themselves anywhere.
    pub fn relax(&mut self) {
        if self.best.is_none() && self.guard.as_ref().is_some_and(|guard| !guard.is_strict()) {
            self.guard = None;
        }
    }

    /// The best, and it packed.
    pub fn best(&self) -> Option<(&Spline, &[u8])> {
        self.best.as_ref().map(|(_, spline, bytes)| (spline, &bytes[..]))
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

    /// The polygon on the finest grid on which it fits, and on the next two whose widths are powers of two: drawings
    /// lie on such grids.
    pub fn show_polygon(&mut self, corners: &[DVec2]) {
        let diagonal = self.outline.diagonal();
        let on = |grid: f64| {
            let mut nodes: Vec<Node> =
                corners.iter().map(|p| Node { at: (*p / grid).round(), on: true }).collect();
            nodes.dedup();
            Spline { nodes, grid }
        };
        let (mut fits, mut fails) = (None, None);
        let mut exponent = 6.0_f64;
        for _ in 0..POLYGON_GRIDS {
            let many = self.show(on(kept_grid(diagonal * (-exponent).exp2())));
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
        if let Some(exponent) = fits {
            let finest = (diagonal * (-exponent).exp2()).log2().floor();
            for grid in [finest, finest + 1.0, finest + 2.0].map(f64::exp2) {
                self.show(on(grid));
            }
        }
    }
}
