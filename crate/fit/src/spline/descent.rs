//! Rate and distortion together: nodes are moved, taken, added and bent as long as squares + price x bits fall.

use glam::DVec2;

use super::law::Steps;
use super::room::meetings;
use super::{Node, joint, pieces};

/// Sides of a parabola while it is fitted.
const SIDES: usize = 6;

/// Nodes on each side of a change that are looked at.
const REACH: usize = 3;

/// The fewest nodes.
pub const FEWEST: usize = 2 * REACH + 4;

/// Quantisation alone makes squares fall by this, for each point of the outline and each bit spent on a node: a node's
/// place is off by 1/12 of a step squared each way, a point between two of them by two thirds of that.
const QUANTISATION_PRICE: f64 = 0.04;

/// The most sweeps.
const SWEEPS: usize = 16;

/// A curve on a grid of width 1 that is fitted to points.
///
/// Where it is guarded, no change makes it meet itself more often than before.
pub struct Descent<'a> {
    points: &'a [DVec2],
    nodes: Vec<Node>,
    /// The index of the point beside each node.
    marks: Vec<usize>,
    steps: Steps,
    kinds: [f64; 2],
    price: f64,
    /// Whether nodes may leave the curve.
    bends: bool,
    guarded: bool,
    line: Vec<DVec2>,
    rest: Vec<DVec2>,
}

/// Nodes and marks before a change.
type Kept = (Vec<Node>, Vec<usize>);

/// Bits for each of two kinds, where some of all are of the first.
fn kinds(first: usize, all: usize) -> [f64; 2] {
    let share = |many: usize| -((many as f64 + 0.5) / (all as f64 + 1.0)).log2();
    [share(first), share(all - first)]
}

impl<'a> Descent<'a> {
    /// Begins with nodes, ten or more, and for each the index of the point beside it, in order.
    pub fn new(points: &'a [DVec2], (nodes, marks): Kept, bends: bool, guarded: bool) -> Self {
        let steps = Steps::of(std::iter::empty());
        let (line, rest) = (Vec::new(), Vec::new());
        Self { points, nodes, marks, steps, kinds: [0.0; 2], price: 0.0, bends, guarded, line, rest }
    }

    /// What was found, and the points beside it.
    pub fn finish(self) -> Kept {
        (self.nodes, self.marks)
    }

    fn node(&self, i: usize) -> &Node {
        &self.nodes[i % self.nodes.len()]
    }

    fn mark_at(&self, i: usize) -> usize {
        self.marks[i % self.marks.len()]
    }

    /// The middle of a node's piece.
    fn middle(&self, i: usize) -> DVec2 {
        let node = self.node(i);
        if node.on {
            return node.at;
        }
        let (from, to) = (joint(self.node(i + self.nodes.len() - 1), node), joint(node, self.node(i + 1)));
        from.midpoint(node.at).midpoint(node.at.midpoint(to))
    }

    /// How often what lies between two nodes meets itself and the rest.
    fn meetings(&mut self, from: usize, to: usize) -> usize {
        if !self.guarded {
            return 0;
        }
        let count = self.nodes.len();
        pieces(&self.nodes, from, to, SIDES, &mut self.line);
        pieces(&self.nodes, to + 1, from + count - 1, SIDES, &mut self.rest);
        meetings(&self.line, &self.rest)
    }

    fn step(&self, i: usize) -> DVec2 {
        self.node(i).at - self.node(i + self.nodes.len() - 1).at
    }

    /// Fits the laws of the code to what is there, and the price of a bit.
    fn learn(&mut self) {
        let count = self.nodes.len();
        self.steps = Steps::of((0..count).map(|i| (self.step(i), self.step(i + count - 1))));
        self.kinds = kinds(self.nodes.iter().filter(|node| node.on).count(), count);
        self.price = QUANTISATION_PRICE * self.points.len() as f64 / count as f64;
    }

    fn node_bits(&self, i: usize) -> f64 {
        let kind = if self.bends { self.kinds[usize::from(!self.node(i).on)] } else { 0.0 };
        self.steps.bits(self.step(i), self.step(i + self.nodes.len() - 1)) + kind
    }

    /// Squares and bits' price between two nodes that do not change.
    fn cost(&mut self, from: usize, to: usize) -> f64 {
        self.cost_below(from, to, f64::INFINITY)
    }

    /// The same where it is below `most`; else at least that.
    fn cost_below(&mut self, from: usize, to: usize, most: f64) -> f64 {
        let bits: f64 = (from + 1..=to + 1).map(|i| self.node_bits(i)).sum();
        let mut sum = self.price * bits;
        if sum >= most {
            return sum;
        }
        let mut line = std::mem::take(&mut self.line);
        pieces(&self.nodes, from, to, SIDES, &mut line);
        let count = self.points.len();
        let (first, last) = (self.mark_at(from), self.mark_at(to));
        let many = (last + count - first) % count;
        let sides: Vec<(DVec2, DVec2, f64)> = line
            .windows(2)
            .map(|w| {
                let chord = w[1] - w[0];
                (w[0], chord, 1.0 / chord.length_squared().max(1e-12))
            })
            .collect();
        for k in 0..=many {
            let p = self.points[(first + k) % count];
            let mut best = f64::INFINITY;
            for &(a, chord, scale) in &sides {
                let off = p - a;
                let share = (off.dot(chord) * scale).clamp(0.0, 1.0);
                let squared = (off - chord * share).length_squared();
                if squared < best {
                    best = squared;
                }
            }
            sum += best;
            if sum >= most {
                break;
            }
        }
        self.line = line;
        sum
    }

    /// The mark of a node, between those of its neighbours.
    fn mark(&mut self, i: usize) {
        let (nodes, count) = (self.nodes.len(), self.points.len());
        let i = i % nodes;
        let (before, after) = (self.mark_at(i + nodes - 1), self.mark_at(i + 1));
        let many = (after + count - before) % count;
        let at = self.middle(i);
        let best = (1..many.max(2)).min_by(|a, b| {
            let off = |k: usize| self.points[(before + k) % count].distance_squared(at);
            off(*a).total_cmp(&off(*b))
        });
        self.marks[i] = (before + best.unwrap_or(0)) % count;
    }

    /// Moves a node from grid point to grid point as long as that helps, between two that stay.
    fn shift(&mut self, i: usize, from: usize, to: usize, now: f64) -> f64 {
        let i = i % self.nodes.len();
        let mut now = now;
        for _ in 0..6 {
            let at = self.nodes[i].at;
            let mut best = (now, at);
            for (x, y) in [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1), (1, -1), (-1, 1)] {
                self.nodes[i].at = at + DVec2::new(f64::from(x), f64::from(y));
                let cost = self.cost_below(from, to, best.0);
                if cost < best.0 {
                    best = (cost, self.nodes[i].at);
                }
            }
            self.nodes[i].at = best.1;
            if best.1 == at {
                break;
            }
            now = best.0;
        }
        now
    }

    /// Where a change at node i is seen: between these two.
    fn window(&self, i: usize) -> (usize, usize) {
        let count = self.nodes.len();
        let from = (i + count - REACH) % count;
        (from, from + 2 * REACH)
    }

    fn try_place(&mut self, i: usize) -> bool {
        let (from, to) = self.window(i);
        let now = self.cost(from, to);
        let (first, met) = (self.nodes[i], self.meetings(from, to));
        let mut best = self.shift(i, from, to, now);
        let mut moved = best < now;
        if moved && self.meetings(from, to) > met {
            self.nodes[i] = first;
            (best, moved) = (now, false);
        }
        if self.bends {
            let kept = self.nodes[i];
            self.nodes[i].on = !kept.on;
            // A control point lies beyond the curve, a corner on it.
            let neighbours = self.node(i + self.nodes.len() - 1).at.midpoint(self.node(i + 1).at);
            let way = if kept.on { kept.at * 1.5 - neighbours * 0.5 } else { kept.at.midpoint(neighbours) };
            let mut found = None;
            for at in [kept.at, way.round()] {
                self.nodes[i].at = at;
                let cost = self.cost(from, to);
                let cost = self.shift(i, from, to, cost);
                if cost < best && self.meetings(from, to) <= met {
                    best = cost;
                    found = Some(self.nodes[i]);
                }
            }
            self.nodes[i] = found.unwrap_or(kept);
            moved |= found.is_some();
        }
        if moved {
            self.mark(i);
        }
        moved
    }

    fn try_drop(&mut self, i: usize) -> bool {
        if self.nodes.len() <= FEWEST {
            return false;
        }
        let (from, to) = self.window(i);
        let now = self.cost(from, to);
        let met = self.meetings(from, to);
        let kept = (self.nodes.clone(), self.marks.clone());
        self.nodes.remove(i);
        self.marks.remove(i);
        let count = self.nodes.len();
        let from = if from > i { from - 1 } else { from };
        let to = from + 2 * REACH - 1;
        let mut cost = self.cost(from, to);
        for k in [i + count - 1, i] {
            cost = self.shift(k, from, to, cost);
        }
        if cost < now && self.meetings(from, to) <= met {
            self.mark(i + count - 1);
            self.mark(i);
            return true;
        }
        (self.nodes, self.marks) = kept;
        false
    }

    fn try_add(&mut self, i: usize) -> bool {
        let count = self.points.len();
        let (first, last) = (self.mark_at(i), self.mark_at(i + 1));
        let many = (last + count - first) % count;
        if many < 2 {
            return false;
        }
        let nodes = self.nodes.len();
        let from = (i + nodes - REACH + 1) % nodes;
        let to = from + 2 * REACH - 1;
        let now = self.cost(from, to);
        let met = self.meetings(from, to);
        let kept = (self.nodes.clone(), self.marks.clone());
        let mut best = now;
        let mut found = None;
        for share in [0.5, 0.25, 0.75] {
            for on in if self.bends { &[true, false][..] } else { &[true][..] } {
                let mark = (first + ((many as f64 * share) as usize).clamp(1, many - 1)) % count;
                self.nodes.clone_from(&kept.0);
                self.marks.clone_from(&kept.1);
                self.nodes.insert(i + 1, Node { at: self.points[mark].round(), on: *on });
                self.marks.insert(i + 1, mark);
                let from = if from > i { from + 1 } else { from };
                let to = from + 2 * REACH;
                let mut cost = self.cost(from, to);
                for k in [i + 1, i, i + 2] {
                    cost = self.shift(k, from, to, cost);
                }
                if cost < best && self.meetings(from, to) <= met {
                    best = cost;
                    found = Some((self.nodes.clone(), self.marks.clone()));
                }
            }
        }
        match found {
            Some(found) => {
                (self.nodes, self.marks) = found;
                for k in [i, i + 1, i + 2] {
                    self.mark(k);
                }
                true
            }
            None => {
                (self.nodes, self.marks) = kept;
                false
            }
        }
    }

    /// To where no single change helps any more.
    pub fn run(&mut self) {
        for sweep in 0..SWEEPS {
            self.learn();
            let mut changes = 0;
            let mut i = 0;
            while i < self.nodes.len() {
                changes += usize::from(self.try_place(i));
                if self.try_drop(i) {
                    changes += 1;
                    continue;
                }
                if sweep + 4 < SWEEPS && self.try_add(i) {
                    changes += 1;
                    i += 1;
                }
                i += 1;
            }
            if changes * 200 < self.nodes.len() {
                break;
            }
        }
    }
}
