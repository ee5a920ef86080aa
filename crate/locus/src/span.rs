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
                let (parts, first) = self.parts_of_larger(frame, u, v);
                let mut nearest = (f64::INFINITY, u, v);
                for part in parts {
                    let (u, v) = if first { (part, v) } else { (u, part) };
                    let look = self.look(outline, u, v);
                    self.note(&look, i, j);
                    if look.reach < nearest.0 {
                        nearest = (look.reach, u, v);
                    }
                }
                (_, u, v) = nearest;
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

    /// The widest edge of the least spanning tree of the nearest points known (Prim's algorithm): an upper bound
    /// of the widest gap.
    pub fn bottleneck(&self) -> f64 {
        let count = self.count;
        let between = |i: usize, j: usize| self.nearest[i.min(j) * count + i.max(j)].reach;
        // How far each piece is from the tree, which begins with piece 0.
        let mut distance: Vec<f64> = (0..count).map(|i| between(0, i)).collect();
        let mut outside: Vec<usize> = (1..count).collect();
        let mut widest = 0.0_f64;
        while let Some(k) =
            (0..outside.len()).min_by(|&a, &b| distance[outside[a]].total_cmp(&distance[outside[b]]))
        {
            let next = outside.swap_remove(k);
            widest = widest.max(distance[next]);
            for &i in &outside {
                distance[i] = distance[i].min(between(next, i));
            }
        }
        widest.sqrt()
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
