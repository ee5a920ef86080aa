//! How wide the widest gap is.

use crate::frame::Frame;
use crate::gap::pair::{Nearest, Pair};
use crate::gap::piece_distance::Gauge;
use crate::gap::search::Search;
use crate::support::table::Outline;

/// The widest gap, in the plane.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Span {
    pub lower: f64,
    pub upper: f64,
    /// The points that realise the upper bound.
    pub widest: Option<Nearest>,
}

/// How many pairs are followed down after a search that was cut short, and how far.
const DIVES: usize = 8;
const DEPTH: usize = 24;

impl Search {
    /// Joins the components in the order of their distances until one is left, or `budget` looks are
    /// spent, and so measures the widest gap. Pieces that were joined before for being near count as far apart as their
    /// nearest known points: the upper bound is that of all pieces.
    ///
    /// A distance is known well enough when its bounds differ by `relative` of it or by `absolute`.
    pub fn span(
        &mut self,
        frame: &Frame,
        outline: &Outline,
        relative: f64,
        absolute: f64,
        budget: usize,
    ) -> Span {
        // From here on pieces are known to be apart, however near they come.
        self.stop_joining();
        self.gauge = Gauge::to_measure(frame);
        // Unless they were left open: then they may meet, as far as the lower bound goes.
        for pair in self.open.iter().chain(&self.later) {
            self.components.join(usize::from(pair.i), usize::from(pair.j));
        }
        let mut lower = 0.0_f64;
        while self.components.count() > 1 {
            self.by_distance.extend(self.apart.drain(..));
            let Some(pair) = self.by_distance.pop() else { break };
            let (i, j) = (usize::from(pair.i), usize::from(pair.j));
            if self.components.joined(i, j) {
                continue;
            }
            // Whatever is still to be joined is at least as far apart as the nearest pair left.
            lower = lower.max(pair.key);
            let nearest = self.nearest[i * self.count + j];
            let reach = nearest.reach.sqrt();
            if reach - pair.key <= (relative * reach).max(absolute) {
                self.components.join(i, j);
            } else if self.nodes < budget {
                self.split(frame, outline, pair, pair.key);
            } else {
                self.dive(frame, outline, pair);
                break;
            }
        }
        Span { lower, ..self.reach() }
    }

    /// Follows the nearest parts of some of the nearest pairs down, for points that are nearer than those met
    /// by a search that was cut short.
    fn dive(&mut self, frame: &Frame, outline: &Outline, first: Pair) {
        let mut pairs = vec![first];
        pairs.extend(std::iter::from_fn(|| self.by_distance.pop()).take(DIVES));
        for Pair { mut u, mut v, i, j, .. } in pairs {
            for _ in 0..DEPTH {
                let (parts, first) = self.pieces.parts_of_larger(frame, u, v);
                let other = if first { v } else { u };
                let mut nearest = (f64::INFINITY, parts.start);
                for four in parts.clone().step_by(4) {
                    let four = four..parts.end.min(four + 4);
                    let looks = self.look(outline, four.clone(), other);
                    for (k, part) in four.enumerate() {
                        self.note(&looks, k, first, i, j);
                        if looks.reach[k] < nearest.0 {
                            nearest = (looks.reach[k], part);
                        }
                    }
                }
                (u, v) = if first { (nearest.1, v) } else { (u, nearest.1) };
            }
        }
    }

    /// An upper bound of the widest gap: the widest edge of the least spanning tree of the nearest points known, and what
    /// rounding may add.
    pub fn reach(&mut self) -> Span {
        let mut span = Span::default();
        self.components.reset(self.count);
        while self.components.count() > 1 {
            let mut best: Option<(f64, usize, usize)> = None;
            for i in 0..self.count {
                for j in i + 1..self.count {
                    let reach = self.nearest[i * self.count + j].reach;
                    if best.is_none_or(|(least, ..)| reach < least) && !self.components.joined(i, j) {
                        best = Some((reach, i, j));
                    }
                }
            }
            let Some((reach, i, j)) = best else { break };
            self.components.join(i, j);
            if reach.sqrt() >= span.upper {
                span.upper = reach.sqrt();
                span.widest = Some(self.nearest[i * self.count + j]);
            }
        }
        // No two points are farther apart than the diameter.
        span.upper = (span.upper * (1.0 + 4.0 * f64::EPSILON) + self.off).min(self.plane_diameter);
        span
    }
}
