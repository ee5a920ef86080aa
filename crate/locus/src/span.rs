//! How wide the widest gap is.

use crate::frame::Frame;
use crate::look::Gauge;
use crate::outline::Outline;
use crate::pair::{Nearest, Pair};
use crate::search::Search;

/// The widest gap, in the plane.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Span {
    pub lower: f64,
    pub upper: f64,
    /// The points that realise the upper bound.
    pub widest: Option<Nearest>,
}

impl Span {
    fn widen(&mut self, reach: f64, nearest: Nearest) {
        if reach >= self.upper {
            self.upper = reach;
            self.widest = Some(nearest);
        }
    }
}

/// How many pairs are followed down after a search that was cut short, and how far.
const DIVES: usize = 8;
const DEPTH: usize = 24;

impl Search {
    /// Joins the components in the order of their distances until one is left, or `budget` looks are
    /// spent, and so measures the widest gap.
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
        self.resolution = -1.0;
        self.gauge = Gauge::to_measure(frame);
        // Unless they were left open: then they may meet, as far as the lower bound goes.
        let found = self.components.count();
        for pair in self.open.iter().chain(&self.later) {
            self.components.join(usize::from(pair.i), usize::from(pair.j));
        }
        let settled = self.components.count() == found;
        let mut span = Span::default();
        while self.components.count() > 1 {
            self.by_distance.extend(self.apart.drain(..));
            let Some(pair) = self.by_distance.pop() else { break };
            let (i, j) = (usize::from(pair.i), usize::from(pair.j));
            if self.components.joined(i, j) {
                continue;
            }
            // Whatever is still to be joined is at least as far apart as the nearest pair left.
            span.lower = span.lower.max(pair.key);
            let nearest = self.nearest[i * self.count + j];
            let reach = nearest.reach.sqrt();
            if reach - pair.key <= (relative * reach).max(absolute) {
                self.components.join(i, j);
                span.widen(reach, nearest);
            } else if self.nodes < budget {
                self.split(frame, outline, pair, pair.key);
            } else {
                self.dive(frame, outline, pair);
                break;
            }
        }
        if settled {
            self.bridge(&mut span);
            span
        } else {
            Span { lower: span.lower, ..self.reach() }
        }
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

    /// An upper bound of the widest gap from the nearest points known alone.
    pub fn reach(&mut self) -> Span {
        let mut span = Span::default();
        self.components.reset(self.count);
        self.bridge(&mut span);
        span
    }

    /// Joins what is left by the nearest points known.
    fn bridge(&mut self, span: &mut Span) {
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
            let Some((reach, i, j)) = best else { return };
            self.components.join(i, j);
            span.widen(reach.sqrt(), self.nearest[i * self.count + j]);
        }
    }
}
