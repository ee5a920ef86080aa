//! The widest gap of one parameter, bracketed.

use std::collections::BinaryHeap;

use crate::frame::Frame;
use crate::graph::Components;
use crate::look::{Distances, Gauge};
use crate::outline::Outline;
use crate::pair::Pair;
use crate::pieces::Pieces;

/// What the search for the widest gap needs, kept for the next.
///
/// The widest gap `g` is the greatest, over all ways to cut the pieces into two groups, of the least distance between the
/// groups. So points that are near show it to be no more than the widest edge of the least spanning tree between
/// them, and whatever cut is proved to be wide shows it to be no less. The cut to try is the one that this
/// widest edge bridges: pairs of pieces that lie on one side of it need not be looked into at all, and of the
/// others only those parts that may be nearer than what bridges it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rift {
    pieces: Pieces,
    stack: Vec<Pair>,
    /// The parts of one, by how deep they overlap.
    parts: Vec<(f64, Pair, f64)>,
    /// Pairs that are apart.
    apart: Vec<Pair>,
    by_distance: BinaryHeap<Pair>,
    edges: Vec<Edge>,
    order: Vec<(f64, u8, u8)>,
    tree: Tree,
    gauge: Gauge,
    /// Pieces that meet, as far as the resolution tells.
    met: Components,
    /// The same, and those that were not told apart within the budget.
    coarse: Components,
    count: usize,
    resolution: f64,
    small: f64,
    /// Pairs looked at.
    pub nodes: usize,
}

/// What is known of two attractorlets.
#[derive(Clone, Copy, Debug)]
struct Edge {
    /// A lower bound of their distance.
    lower: f64,
    /// The square of the least distance known of two points.
    reach: f64,
    /// Whether they were told apart: then the pairs of parts that this took are among those that are apart.
    apart: bool,
}

/// Prim's algorithm.
#[derive(Clone, Debug, Default)]
struct Tree {
    distance: Vec<f64>,
    from: Vec<u8>,
    outside: Vec<u8>,
    /// Which end each piece hangs on, in the order they were taken in.
    steps: Vec<(u8, u8)>,
    /// Whether a piece lies beyond the widest edge.
    beyond: Vec<bool>,
}

/// The widest gap, in the plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    pub lower: f64,
    pub upper: f64,
}

/// How far, relative to it, the lower bound of a gap may be below the upper one.
const CLOSE: f64 = 0.095;
/// Looks spent at most on measuring a gap that is there.
const MEASURE: usize = 2000;
/// After so many looks a finer outline pays.
const ROUGH: usize = 150;
/// How many pairs are followed down after a search that was cut short, and how far.
const DIVES: usize = 8;
const DEPTH: usize = 24;

impl Rift {
    /// Begins with the pieces of the maps; those that are known to meet may be joined in `met` then.
    pub fn begin(&mut self, frame: &Frame, count: usize) {
        self.count = count;
        self.met.reset(count);
        self.edges.clear();
        self.edges.resize(count * count, Edge { lower: 0.0, reach: f64::INFINITY, apart: false });
        self.nodes = 0;
        for i in 0..count {
            for j in i + 1..count {
                if frame.maps[i] == frame.maps[j] {
                    self.join(i, j, 0.0);
                }
            }
        }
    }

    /// Takes note that points of two pieces, `i < j`, are near: the square of their distance is `reach`.
    pub fn join(&mut self, i: usize, j: usize, reach: f64) {
        self.met.join(i, j);
        let edge = &mut self.edges[i * self.count + j];
        edge.reach = edge.reach.min(reach);
    }

    /// Joins pieces for which `meet` gives the square of a small distance, until all hang together or some do
    /// not.
    pub fn join_near(&mut self, mut meet: impl FnMut(usize, usize) -> Option<f64>) {
        for i in 0..self.count {
            for j in i + 1..self.count {
                if !self.met.joined(i, j)
                    && let Some(reach) = meet(i, j)
                {
                    self.join(i, j, reach);
                }
            }
            // All that could join these to the others was tried.
            if !self.is_whole() && (i + 1..self.count).all(|j| !self.met.joined(i, j)) {
                return;
            }
        }
    }

    /// Bounds the widest gap until it is known whether it is one and how wide about, or `budget` looks are spent.
    /// The lower bound is 0 unless the attractor is proved to be in several pieces.
    ///
    /// `resolution` is in the plane, `diameter` that of the attractor in the frame.
    pub fn bracket(
        &mut self,
        frame: &Frame,
        outline: &mut Outline,
        resolution: f64,
        diameter: f64,
        budget: usize,
    ) -> Bracket {
        self.resolution = resolution;
        // Where rounding is coarser than the resolution, nothing is small.
        self.small = if frame.rounding * frame.stretch <= resolution { resolution / diameter } else { -1.0 };
        self.gauge = Gauge::to_separate(frame);
        self.pieces.begin(frame);
        self.apart.clear();
        self.look_at_all(outline);
        self.coarse.clone_from(&self.met);
        let (mut spent, mut rounds) = (0, 0);
        let mut found = Bracket { lower: 0.0, upper: f64::INFINITY };
        while self.coarse.count() > 1 {
            let bridge = self.cut();
            if !self.prove(frame, outline, budget) {
                // The cut is none.
                continue;
            }
            let before = self.nodes;
            let lower = self.measure(frame, outline, bridge, MEASURE.saturating_sub(spent));
            spent += self.nodes - before;
            let upper = self.cut();
            // Each cut shows that the gap is at least so wide.
            let stuck = spent >= MEASURE && (upper >= found.upper || rounds > self.count);
            found = Bracket { lower: lower.max(found.lower), upper };
            if found.lower >= (1.0 - CLOSE) * upper || stuck {
                return found;
            }
            rounds += 1;
        }
        Bracket { lower: 0.0, upper: self.bottleneck() }
    }

    /// Tells all pairs apart that lie across the cut, the nearest first; `false` if two turn out to meet, or this is not found out.
    fn prove(&mut self, frame: &Frame, outline: &mut Outline, budget: usize) -> bool {
        self.order.clear();
        for i in 0..self.count {
            for j in i + 1..self.count {
                let edge = &self.edges[i * self.count + j];
                if self.tree.beyond[i] != self.tree.beyond[j] && !edge.apart {
                    self.order.push((edge.reach, i as u8, j as u8));
                }
            }
        }
        self.order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let order = std::mem::take(&mut self.order);
        let done = order.iter().all(|&(_, i, j)| self.tell_apart(frame, outline, i, j, budget));
        self.order = order;
        done
    }

    /// Whether all pieces hang together, as far as the resolution tells.
    pub fn is_whole(&self) -> bool {
        self.met.count() == 1
    }

    /// Looks at every two attractorlets once.
    fn look_at_all(&mut self, outline: &mut Outline) {
        let count = self.count as u32;
        for i in 0..count {
            for first in (i + 1..count).step_by(4) {
                let others = first..count.min(first + 4);
                let looks =
                    self.gauge.distances(outline, self.pieces.range(others.clone()), &self.pieces.get(i).map);
                self.nodes += others.len();
                for (k, j) in others.enumerate() {
                    let (i, j) = (i as usize, j as usize);
                    let edge = &mut self.edges[i * self.count + j];
                    edge.lower = looks.apart[k];
                    edge.reach = edge.reach.min(looks.reach[k]);
                    if edge.reach <= self.resolution * self.resolution {
                        self.met.join(i, j);
                    }
                }
            }
        }
    }

    /// Finds the least spanning tree of the components by the points known, and the cut that its widest edge bridges;
    /// returns the length of that edge.
    fn cut(&mut self) -> f64 {
        let Self { tree, edges, coarse, count, .. } = self;
        let count = *count;
        let between = |i: u8, j: u8| {
            let (i, j) = (usize::from(i), usize::from(j));
            if coarse.joined(i, j) { 0.0 } else { edges[i.min(j) * count + i.max(j)].reach }
        };
        let widest = tree.grow(count, between);
        tree.beyond.clear();
        tree.beyond.resize(count, false);
        if let Some((bridge, _)) = widest {
            for k in bridge..tree.steps.len() {
                let (piece, from) = tree.steps[k];
                tree.beyond[usize::from(piece)] = k == bridge || tree.beyond[usize::from(from)];
            }
        }
        widest.map_or(0.0, |(_, length)| length.sqrt())
    }

    /// The widest edge of the least spanning tree of the nearest points known: an upper bound of the widest gap.
    pub fn bottleneck(&mut self) -> f64 {
        let Self { tree, edges, count, .. } = self;
        let between = |i: u8, j: u8| edges[usize::from(i.min(j)) * *count + usize::from(i.max(j))].reach;
        tree.grow(*count, between).map_or(0.0, |(_, length)| length.sqrt())
    }

    /// Looks into two attractorlets until all pairs of parts are apart; `false` if they turn out to meet, or it is
    /// not found out.
    fn tell_apart(&mut self, frame: &Frame, outline: &mut Outline, i: u8, j: u8, budget: usize) -> bool {
        self.gauge = Gauge::to_separate(frame);
        let edge = self.edges[usize::from(i) * self.count + usize::from(j)];
        let found = self.apart.len();
        self.stack.clear();
        self.stack.push(Pair { key: edge.lower, u: u32::from(i), v: u32::from(j), i, j });
        while let Some(pair) = self.stack.pop() {
            if pair.key > 0.0 {
                self.apart.push(pair);
                continue;
            }
            let small = self.pieces.are_small(pair.u, pair.v, self.small);
            let near = !small && self.nodes < budget && self.split(frame, outline, pair) <= self.resolution;
            if small || near {
                self.met.join(usize::from(i), usize::from(j));
            } else if self.nodes < budget {
                continue;
            }
            self.coarse.join(usize::from(i), usize::from(j));
            self.apart.truncate(found);
            return false;
        }
        self.edges[usize::from(i) * self.count + usize::from(j)].apart = true;
        true
    }

    /// Looks into the pairs across the cut, which are all apart, the nearest first, until the nearest is not much nearer than the
    /// `bridge`, or `budget` looks are spent; returns a lower bound of their distances.
    fn measure(&mut self, frame: &Frame, outline: &mut Outline, mut bridge: f64, budget: usize) -> f64 {
        self.gauge = Gauge::to_measure(frame);
        let limit = self.nodes + budget;
        let Self { apart, by_distance, tree, .. } = self;
        by_distance.clear();
        by_distance.extend(
            apart.extract_if(.., |pair| tree.beyond[usize::from(pair.i)] != tree.beyond[usize::from(pair.j)]),
        );
        for k in 0..self.edges.len() {
            let (i, j) = (k / self.count, k % self.count);
            if i < j && self.tree.beyond[i] != self.tree.beyond[j] {
                bridge = bridge.min(self.edges[k].reach.sqrt());
            }
        }
        let mut lower = f64::INFINITY;
        while let Some(pair) = self.by_distance.pop() {
            lower = pair.key;
            if lower >= (1.0 - CLOSE) * bridge {
                self.apart.push(pair);
                break;
            }
            if self.nodes >= limit {
                self.follow(frame, outline, pair);
                break;
            }
            bridge = bridge.min(self.split(frame, outline, pair));
            self.by_distance.extend(self.stack.drain(..));
        }
        self.apart.extend(self.by_distance.drain());
        lower
    }

    /// Follows the nearest parts of some of the nearest pairs down, for points that are nearer than those met
    /// by a search that was cut short.
    fn follow(&mut self, frame: &Frame, outline: &mut Outline, first: Pair) {
        let mut next = Some(first);
        for _ in 0..DIVES {
            let Some(mut pair) = next else { return };
            self.apart.push(pair);
            for _ in 0..DEPTH {
                self.split(frame, outline, pair);
                let near = self.parts.iter().min_by(|a, b| a.2.total_cmp(&b.2));
                pair = near.map_or(pair, |part| part.1);
                self.stack.clear();
            }
            next = self.by_distance.pop();
        }
        self.apart.extend(next);
    }

    /// Puts the parts of the larger piece of a pair on the stack, the nearest on top; returns the least distance
    /// known of the two attractorlets.
    fn split(&mut self, frame: &Frame, outline: &mut Outline, pair: Pair) -> f64 {
        if self.nodes > ROUGH && !outline.is_fine() {
            outline.set(&frame.maps, 0.012 * (1.0 - frame.factor), 64);
        }
        let (parts, first) = self.pieces.parts_of_larger(frame, pair.u, pair.v);
        let other = if first { pair.v } else { pair.u };
        let mut least = f64::INFINITY;
        self.parts.clear();
        for four in parts.clone().step_by(4) {
            let four = four..parts.end.min(four + 4);
            let Distances { apart, overlap, reach } =
                self.gauge.distances(outline, self.pieces.range(four.clone()), &self.pieces.get(other).map);
            self.nodes += four.len();
            for (k, part) in four.enumerate() {
                let (u, v) = if first { (part, other) } else { (other, part) };
                least = least.min(reach[k]);
                // Parts are no nearer than what they are parts of.
                self.parts.push((overlap[k], Pair { key: apart[k].max(pair.key), u, v, ..pair }, reach[k]));
            }
        }
        self.parts.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        self.stack.extend(self.parts.iter().map(|part| part.1));
        let edge = &mut self.edges[usize::from(pair.i) * self.count + usize::from(pair.j)];
        edge.reach = edge.reach.min(least);
        edge.reach.sqrt()
    }
}

impl Tree {
    /// Grows the least spanning tree of `count` pieces from the first; returns the place of its widest edge among the steps, and its
    /// weight.
    fn grow(&mut self, count: usize, between: impl Fn(u8, u8) -> f64) -> Option<(usize, f64)> {
        let Self { distance, from, outside, steps, .. } = self;
        distance.clear();
        distance.extend((0..count).map(|i| if i == 0 { 0.0 } else { between(0, i as u8) }));
        from.clear();
        from.resize(count, 0);
        outside.clear();
        outside.extend(1..count as u8);
        steps.clear();
        let mut widest: Option<(usize, f64)> = None;
        while !outside.is_empty() {
            let far = |k: &usize| distance[usize::from(outside[*k])];
            let nearest = (0..outside.len()).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0);
            let next = outside.swap_remove(nearest);
            let weight = distance[usize::from(next)];
            if widest.is_none_or(|(_, most)| weight > most) {
                widest = Some((steps.len(), weight));
            }
            steps.push((next, from[usize::from(next)]));
            for &i in outside.iter() {
                let d = between(next, i);
                if d < distance[usize::from(i)] {
                    distance[usize::from(i)] = d;
                    from[usize::from(i)] = next;
                }
            }
        }
        widest
    }
}
