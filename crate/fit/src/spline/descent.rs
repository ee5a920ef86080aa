//! Rate and distortion together: nodes are moved, taken, added and bent as long as squares + price x bits fall.

use glam::DVec2;

use super::law::StepLaw;
use super::room::meetings;
use super::window::Window;
use super::{Node, joint};

/// Nodes on each side of a change that are looked at.
const REACH: usize = 3;

/// The fewest nodes.
pub const FEWEST: usize = 2 * REACH + 4;

/// What a bit more on each node makes squares fall by, for each point of the outline. Quantisation alone would say .04,
/// since a node is off by 1/12 of a step squared each way, and a point between two of them by two thirds of that. But
/// nodes are moved until their errors make up for each other, which leaves less of it: of .015 to .04, tried on leaves
/// within 50 to 500 bytes, this came nearest.
const PRICE: f64 = 0.02;

/// The most sweeps, and how many are the last in which nodes are not added.
const SWEEPS: usize = 16;
const LAST_SWEEPS: usize = 4;

/// How many nodes one step of the work is about.
const NODES_A_STEP: usize = 16;

/// The most moves of a node in a row.
const MOVES: usize = 6;

/// Where a node is moved in one move.
const NEIGHBOURS: [(i32, i32); 8] = [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1), (1, -1), (-1, 1)];

/// How far a node is moved, in steps each way, so that a curve crosses itself less.
const UNTANGLING: i32 = 2;

/// A price that changes by so much has all nodes looked at again.
const OTHER_PRICE: f64 = 1.02;

/// A curve on a grid of width 1 that is fitted to points.
///
/// Where it is guarded, no change makes it meet itself more often than before.
#[derive(Clone, Debug)]
pub struct Descent {
    points: Vec<DVec2>,
    nodes: Vec<Node>,
    /// The index of the point beside each node.
    marks: Vec<usize>,
    /// Where nothing helped, and nothing near has changed since.
    settled: Vec<bool>,
    steps: StepLaw,
    kinds: [f64; 2],
    price: f64,
    guarded: bool,
    /// Whether corners may become control points, and these be added.
    bends: bool,
    /// How many times that price a bit has in this sweep.
    greed: f64,
    window: Window,
    /// Which sweep it is, which node comes next, and how much has changed in it.
    sweep: usize,
    next: usize,
    changes: usize,
}

/// Bits for each of two kinds, where some of all are of the first.
fn kinds(first: usize, all: usize) -> [f64; 2] {
    let share = |many: usize| -((many as f64 + 0.5) / (all as f64 + 1.0)).log2();
    [share(first), share(all - first)]
}

impl Descent {
    /// Begins with nodes, ten or more, and for each the index of the point beside it, in order. In the first sweep a
    /// bit is `greed` times as dear as it should be. It may be guarded, and may have more control points than it has.
    pub fn new(
        points: Vec<DVec2>,
        (nodes, marks): (Vec<Node>, Vec<usize>),
        greed: f64,
        (guarded, bends): (bool, bool),
    ) -> Self {
        let mut descent = Self {
            points,
            settled: vec![false; nodes.len()],
            nodes,
            marks,
            steps: StepLaw::of(std::iter::empty()),
            kinds: [0.0; 2],
            price: 0.0,
            guarded,
            bends,
            greed,
            window: Window::default(),
            sweep: 0,
            next: 0,
            changes: 0,
        };
        descent.learn();
        descent
    }

    /// What was found, and the points beside it.
    pub fn finish(self) -> (Vec<Node>, Vec<usize>) {
        (self.nodes, self.marks)
    }

    /// About how far it is, from 0 to 1.
    pub fn share(&self) -> f64 {
        let swept = self.sweep as f64 + self.next as f64 / self.nodes.len() as f64;
        // Most is done in the first few sweeps.
        1.0 - (-swept / 3.0).exp()
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

    /// Fits the laws of the code to what is there, and the price of a bit.
    fn learn(&mut self) {
        let count = self.nodes.len();
        let step = |i: usize| self.nodes[i % count].at - self.nodes[(i + count - 1) % count].at;
        self.steps = StepLaw::of((0..count).map(|i| (step(i), step(i + count - 1))));
        self.kinds = kinds(self.nodes.iter().filter(|node| node.on).count(), count);
        let price = self.greed * PRICE * self.points.len() as f64 / count as f64;
        if self.price / price > OTHER_PRICE || price / self.price > OTHER_PRICE {
            self.settled.fill(false);
        }
        self.price = price;
    }

    /// Takes nodes `from` to `to` and one more at each end into the window, with the points beside them.
    fn open(&mut self, from: usize, to: usize) {
        let (nodes, count) = (self.nodes.len(), self.points.len());
        self.window.nodes.clear();
        self.window.nodes.extend((from + nodes - 1..=to + nodes + 1).map(|i| self.nodes[i % nodes]));
        let (first, last) = (self.mark_at(from), self.mark_at(to));
        let many = (last + count - first) % count;
        let points = &self.points;
        self.window.load((first..=first + many).map(|i| points[i % count]));
    }

    /// What the nodes of the window cost in bits' price, from the first to the last whose step is told.
    fn bits(&self) -> f64 {
        let nodes = &self.window.nodes;
        let step = |i: usize| nodes[i].at - nodes[i - 1].at;
        let kind = |node: &Node| self.kinds[usize::from(!node.on)];
        let all = (2..nodes.len()).map(|i| self.steps.bits(step(i), step(i - 1)) + kind(&nodes[i]));
        self.price * all.sum::<f64>()
    }

    /// Squares and bits' price of the window, whose rest was prepared for node k, where they are below `most`.
    fn cost(&mut self, k: usize, most: f64) -> f64 {
        self.cost_of(k, k, most)
    }

    /// The same where the rest was prepared for nodes `first` to `last`.
    fn cost_of(&mut self, first: usize, last: usize, most: f64) -> f64 {
        let bits = self.bits();
        if bits >= most { bits } else { bits + self.window.squares(first, last, most - bits) }
    }

    /// Moves node k of the window from grid point to grid point as long as that helps.
    fn shift(&mut self, k: usize, now: f64) -> f64 {
        let mut now = now;
        let mut before: Option<DVec2> = None;
        for _ in 0..MOVES {
            let at = self.window.nodes[k].at;
            let mut best = (now, at);
            for (x, y) in NEIGHBOURS {
                let place = at + DVec2::new(f64::from(x), f64::from(y));
                // Seen around where it was before.
                if before.is_some_and(|before| (place - before).abs().max_element() <= 1.0) {
                    continue;
                }
                self.window.nodes[k].at = place;
                let cost = self.cost(k, best.0);
                if cost < best.0 {
                    best = (cost, place);
                }
            }
            self.window.nodes[k].at = best.1;
            if best.1 == at {
                break;
            }
            before = Some(at);
            now = best.0;
        }
        now
    }

    /// Whether these nodes, in the place of `many` nodes from `from` on, meet themselves and the rest no more often.
    fn has_room(&self, (from, many): (usize, usize), nodes: &[Node], old: &[Node]) -> bool {
        if !self.guarded {
            return true;
        }
        let met = self.met((from, many), nodes);
        met == 0 || met <= self.met((from, many), old)
    }

    /// How often the window's nodes, in the place of `many` nodes from `from` on, meet themselves and the rest.
    fn met(&self, (from, many): (usize, usize), nodes: &[Node]) -> usize {
        let count = self.nodes.len();
        meetings(nodes, (from + many - 2..=from + count + 1).map(|i| &self.nodes[i % count]))
    }

    /// Moves nodes whose stretch meets something to where it meets less, at the least cost. False where that is none.
    ///
    /// A curve that was put on the grid may cross itself where the outline only comes near to that.
    fn untangle(&mut self) -> bool {
        let mut changed = false;
        for i in 0..self.nodes.len() {
            let count = self.nodes.len();
            let from = i + count - REACH;
            self.open(from, from + 2 * REACH);
            let old = self.window.nodes.clone();
            let (span, k) = ((from - 1, old.len()), REACH + 1);
            let met = self.met(span, &old);
            if met == 0 {
                continue;
            }
            self.window.hold_rest(k, k);
            let mut best = (met, f64::INFINITY, old[k]);
            for y in -UNTANGLING..=UNTANGLING {
                for x in -UNTANGLING..=UNTANGLING {
                    let at = old[k].at + DVec2::new(f64::from(x), f64::from(y));
                    self.window.nodes[k] = Node { at, on: true };
                    let cost = self.cost(k, f64::INFINITY);
                    let fewer = self.met(span, &self.window.nodes);
                    if fewer < best.0 || fewer == best.0 && fewer < met && cost < best.1 {
                        best = (fewer, cost, self.window.nodes[k]);
                    }
                }
            }
            if best.0 < met {
                self.nodes[i] = best.2;
                self.mark(i);
                self.unsettle(i);
                changed = true;
            }
        }
        changed
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

    /// Has all nodes looked at again from which a change at node i is seen.
    fn unsettle(&mut self, i: usize) {
        let count = self.nodes.len();
        for k in 0..=2 * REACH + 2 {
            self.settled[(i + count + k - REACH - 1) % count] = false;
        }
        self.changes += 1;
    }

    /// Tries other places of a node, and the other kind.
    fn try_place(&mut self, i: usize) -> bool {
        let count = self.nodes.len();
        let from = i + count - REACH;
        self.open(from, from + 2 * REACH);
        let k = REACH + 1;
        self.window.hold_rest(k, k);
        let old = self.window.nodes.clone();
        let span = (from - 1, old.len());
        let now = self.cost(k, f64::INFINITY);
        let mut best = (now, old[k]);
        let cost = self.shift(k, now);
        if cost < now && self.has_room(span, &self.window.nodes, &old) {
            best = (cost, self.window.nodes[k]);
        }
        let kept = best.1;
        // A control point lies beyond the curve, a corner on it.
        let neighbours = old[k - 1].at.midpoint(old[k + 1].at);
        let way = if kept.on { kept.at * 1.5 - neighbours * 0.5 } else { kept.at.midpoint(neighbours) };
        let ways = [kept.at, way.round()];
        for &at in if self.bends || !kept.on { &ways[..] } else { &[] } {
            self.window.nodes[k] = Node { at, on: !kept.on };
            let cost = self.cost(k, f64::INFINITY);
            let cost = self.shift(k, cost);
            if cost < best.0 && self.has_room(span, &self.window.nodes, &old) {
                best = (cost, self.window.nodes[k]);
            }
        }
        if best.0 >= now {
            return false;
        }
        self.nodes[i] = best.1;
        self.mark(i);
        self.unsettle(i);
        true
    }

    /// Tries to move a node and the next one together: the same way, back, or a quarter turned.
    fn try_pair(&mut self, i: usize) -> bool {
        let count = self.nodes.len();
        let from = i + count - REACH;
        self.open(from, from + 2 * REACH + 1);
        let k = REACH + 1;
        self.window.hold_rest(k, k + 1);
        let old = self.window.nodes.clone();
        let span = (from - 1, old.len());
        let mut best = (self.cost_of(k, k + 1, f64::INFINITY), None);
        for (x, y) in NEIGHBOURS {
            let by = DVec2::new(f64::from(x), f64::from(y));
            for way in [by, -by, by.perp(), -by.perp()] {
                self.window.nodes[k].at = old[k].at + by;
                self.window.nodes[k + 1].at = old[k + 1].at + way;
                let cost = self.cost_of(k, k + 1, best.0);
                if cost < best.0 && self.has_room(span, &self.window.nodes, &old) {
                    best = (cost, Some([self.window.nodes[k], self.window.nodes[k + 1]]));
                }
            }
        }
        let Some(pair) = best.1 else { return false };
        let next = (i + 1) % count;
        (self.nodes[i], self.nodes[next]) = (pair[0], pair[1]);
        for k in [i, next] {
            self.mark(k);
            self.unsettle(k);
        }
        true
    }

    /// Tries to do without a node.
    fn try_drop(&mut self, i: usize) -> bool {
        let count = self.nodes.len();
        if count <= FEWEST {
            return false;
        }
        let from = i + count - REACH;
        self.open(from, from + 2 * REACH);
        let old = self.window.nodes.clone();
        let k = REACH + 1;
        self.window.hold_rest(k, k);
        let now = self.cost(k, f64::INFINITY);
        self.window.nodes.remove(k);
        let mut cost = f64::INFINITY;
        for k in [k - 1, k] {
            self.window.hold_rest(k, k);
            cost = self.cost(k, f64::INFINITY);
            cost = self.shift(k, cost);
        }
        if cost >= now || !self.has_room((from - 1, old.len()), &self.window.nodes, &old) {
            return false;
        }
        let near = [self.window.nodes[k - 1], self.window.nodes[k]];
        self.nodes[(i + count - 1) % count] = near[0];
        self.nodes[(i + 1) % count] = near[1];
        self.nodes.remove(i);
        self.marks.remove(i);
        self.settled.remove(i);
        self.mark(i + count - 2);
        self.mark(i);
        self.unsettle(i % (count - 1));
        true
    }

    /// Tries one more node behind node i.
    fn try_add(&mut self, i: usize) -> bool {
        let (nodes, count) = (self.nodes.len(), self.points.len());
        let (first, last) = (self.mark_at(i), self.mark_at(i + 1));
        let many = (last + count - first) % count;
        if many < 2 {
            return false;
        }
        let from = i + nodes - REACH + 1;
        self.open(from, from + 2 * REACH - 1);
        let old = self.window.nodes.clone();
        let span = (from - 1, old.len());
        let k = REACH + 1;
        self.window.hold_rest(k, k);
        let now = self.cost(k, f64::INFINITY);
        let mut best = now;
        let mut found = None;
        for share in [0.5, 0.25, 0.75] {
            let mark = (first + ((many as f64 * share) as usize).clamp(1, many - 1)) % count;
            for &on in if self.bends { &[true, false][..] } else { &[true] } {
                self.window.nodes.clone_from(&old);
                self.window.nodes.insert(k, Node { at: self.points[mark].round(), on });
                let mut cost = f64::INFINITY;
                for k in [k, k - 1, k + 1] {
                    self.window.hold_rest(k, k);
                    cost = self.cost(k, f64::INFINITY);
                    cost = self.shift(k, cost);
                }
                if cost < best && self.has_room(span, &self.window.nodes, &old) {
                    best = cost;
                    let near = [k - 1, k, k + 1].map(|k| self.window.nodes[k]);
                    found = Some((mark, near));
                }
            }
        }
        let Some((mark, near)) = found else { return false };
        self.nodes[i] = near[0];
        self.nodes[(i + 1) % nodes] = near[2];
        self.nodes.insert(i + 1, near[1]);
        self.marks.insert(i + 1, mark);
        self.settled.insert(i + 1, false);
        for k in [i, i + 1, i + 2] {
            self.mark(k);
        }
        self.unsettle(i + 1);
        true
    }

    /// Looks at some nodes; false where no single change helps any more.
    pub fn step(&mut self) -> bool {
        let mut seen = 0;
        while seen < NODES_A_STEP && self.next < self.nodes.len() {
            let i = self.next;
            if self.settled[i] {
                self.next += 1;
                continue;
            }
            seen += 1;
            self.settled[i] = true;
            if !self.try_place(i) {
                self.try_pair(i);
            }
            if self.try_drop(i) {
                continue;
            }
            if self.sweep + LAST_SWEEPS < SWEEPS && self.try_add(i) {
                self.next += 1;
            }
            self.next += 1;
        }
        if self.next < self.nodes.len() {
            return true;
        }
        let done = self.changes * 200 < self.nodes.len() && self.sweep > 0;
        self.greed = 1.0;
        let untangled = self.guarded && (done || self.sweep == 0) && self.untangle();
        (self.sweep, self.next, self.changes) = (self.sweep + 1, 0, 0);
        self.learn();
        (!done || untangled) && self.sweep < SWEEPS
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outline::crossings;
    use crate::spline::Spline;

    #[test]
    fn what_crosses_itself_is_put_right_near_where_it_was_and_all_else_is_left_alone() {
        let at =
            |i: usize, many: usize| DVec2::from_angle(std::f64::consts::TAU * i as f64 / many as f64) * 4.3;
        let points: Vec<DVec2> = (0..120).map(|i| at(i, 120)).collect();
        let ring: Vec<Node> = (0..12).map(|i| Node { at: at(i, 12).round(), on: true }).collect();
        let of = |nodes: Vec<Node>| {
            let marks = (0..12).map(|i| 10 * i).collect();
            Descent::new(points.clone(), (nodes, marks), 1.0, (true, true))
        };
        let crossed = |descent: &Descent| {
            let line = Spline { nodes: descent.nodes.clone(), grid: 1.0 }.polyline(16);
            crossings(&line, 99).map_or(99, |found| found.len())
        };
        let mut plain = of(ring.clone());
        assert!(!plain.untangle() && plain.nodes == ring);
        let mut tangled = ring;
        tangled.swap(4, 5);
        let mut descent = of(tangled.clone());
        assert!(crossed(&descent) > 0);
        assert!(descent.untangle());
        while descent.untangle() {}
        assert_eq!(crossed(&descent), 0, "{:?}", descent.nodes);
        assert!(tangled.iter().zip(&descent.nodes).filter(|(a, b)| a != b).count() <= 3);
    }
}
