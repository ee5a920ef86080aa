//! The widest gap of one parameter, bracketed.

use std::collections::BinaryHeap;
use std::ops::Range;

use crate::gap::pair::Pair;
use crate::gap::piece_distance::Distances;
use crate::gap::spanning_tree::Tree;
use crate::overlap_graph::Components;

/// How pairs of pieces are looked at and split.
pub(crate) trait Explore {
    /// Gets ready to tell pieces apart, or to measure how far apart they are.
    fn lean(&mut self, to_measure: bool);
    /// Looks at attractorlet `i` and one to four others.
    fn first(&mut self, i: u32, others: Range<u32>) -> Distances;
    /// The numbers by which it knows two attractorlets.
    fn root(&mut self, i: u8, j: u8) -> (u32, u32);
    /// Whether both pieces of a pair are so small that they are taken to meet if they are not known to be apart.
    fn is_small(&self, pair: &Pair) -> bool;
    /// Splits a pair into parts.
    fn split(&mut self, pair: &Pair, into: &mut Vec<Part>);
}

/// One of the pairs that a pair was split into.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part {
    pair: Pair,
    overlap: f64,
    reach: f64,
}

impl Part {
    /// What was seen in lane `k` of the pieces `u` and `v`, parts of `whole`: they are no nearer than that.
    pub fn new(looks: &Distances, k: usize, whole: &Pair, u: u32, v: u32) -> Self {
        let pair = Pair { key: looks.apart[k].max(whole.key), u, v, ..*whole };
        Self { pair, overlap: looks.overlap[k], reach: looks.reach[k] }
    }
}

/// What the search for the widest gap needs, kept for the next.
///
/// The widest gap `g` is the greatest, over all ways to cut the pieces into two groups, of the least distance between the
/// groups. So points that are near show it to be no more than the widest edge of the least spanning tree between
/// them, and whatever cut is proved to be wide shows it to be no less. The cut to try is the one that this
/// widest edge bridges: pairs of pieces that lie on one side of it need not be looked into at all, and of the
/// others only those parts that may be nearer than what bridges it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rift {
    stack: Vec<Pair>,
    /// The parts of one, by how deep they overlap.
    parts: Vec<Part>,
    /// Pairs that are apart.
    apart: Vec<Pair>,
    by_distance: BinaryHeap<Pair>,
    edges: Vec<Edge>,
    order: Vec<(f64, u8, u8)>,
    tree: Tree,
    /// Which pairs lie across the cut.
    across: Vec<bool>,
    /// Pieces that meet, as far as the resolution tells.
    met: Components,
    /// The same, and those that were not told apart within the budget.
    coarse: Components,
    count: usize,
    turn: bool,
    resolution: f64,
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
/// How many pairs are followed down after a search that was cut short, and how far.
const DIVES: usize = 8;
const DEPTH: usize = 24;

impl Rift {
    /// Begins with the pieces of the maps; those that are known to meet may be joined in `met` then.
    ///
    /// Where a `turn` takes each piece to the next, pairs that are as far round from each other are alike, and only
    /// those with piece 0 are looked at.
    pub fn begin(&mut self, count: usize, turn: bool) {
        self.count = count;
        self.turn = turn;
        self.met.reset(count);
        self.edges.clear();
        self.edges.resize(count * count, Edge { lower: 0.0, reach: f64::INFINITY, apart: false });
        self.nodes = 0;
    }

    /// The place of a pair among the edges.
    #[inline]
    fn edge(&self, i: usize, j: usize) -> usize {
        place(self.turn, self.count, i, j)
    }

    fn turns(&self) -> Option<usize> {
        self.turn.then_some(self.count)
    }

    /// The pairs `i < j` that stand for all.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (count, turn) = (self.count, self.turn);
        let (rows, columns) = if turn { (1, count / 2 + 1) } else { (count, count) };
        (0..rows).flat_map(move |i| (i + 1..columns).map(move |j| (i, j)))
    }

    /// Takes note that points of two pieces, `i < j`, are near: the square of their distance is `reach`.
    fn join(&mut self, i: usize, j: usize, reach: f64) {
        let at = self.edge(i, j);
        self.edges[at].reach = self.edges[at].reach.min(reach);
        {
            let turns = self.turns();
            join(&mut self.met, turns, i, j);
        }
    }

    /// Joins pieces that `meet`, for certain.
    pub fn join_proved(&mut self, meet: impl Fn(usize, usize) -> bool) {
        for (i, j) in self.pairs() {
            if meet(i, j) {
                self.join(i, j, 0.0);
            }
        }
    }

    /// Joins pieces for which `meet` gives the square of a small distance, until all hang together or some do
    /// not.
    pub fn join_near(&mut self, mut meet: impl FnMut(usize, usize) -> Option<f64>) {
        let mut row = 0;
        for (i, j) in self.pairs() {
            if i > row {
                // All that could join these to the others was tried.
                if (row + 1..self.count).all(|j| !self.met.joined(row, j)) {
                    return;
                }
                row = i;
            }
            if !self.met.joined(i, j)
                && let Some(reach) = meet(i, j)
            {
                self.join(i, j, reach);
                if self.is_whole() {
                    return;
                }
            }
        }
    }

    /// Bounds the widest gap until it is known whether it is one and how wide about, or `budget` looks are spent.
    /// The lower bound is 0 unless the attractor is proved to be in several pieces.
    ///
    /// `resolution` is in the plane.
    pub fn bracket(&mut self, explore: &mut impl Explore, resolution: f64, budget: usize) -> Bracket {
        self.resolution = resolution;
        explore.lean(false);
        self.apart.clear();
        self.look_at_all(explore);
        self.coarse.clone_from(&self.met);
        let (mut spent, mut rounds) = (0, 0);
        let mut found = Bracket { lower: 0.0, upper: f64::INFINITY };
        while self.coarse.count() > 1 {
            let bridge = self.cut();
            if !self.prove(explore, budget) {
                // The cut is none.
                continue;
            }
            let before = self.nodes;
            let lower = self.measure(explore, bridge, MEASURE.saturating_sub(spent));
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
    fn prove(&mut self, explore: &mut impl Explore, budget: usize) -> bool {
        explore.lean(false);
        self.order.clear();
        for (i, j) in self.pairs() {
            let at = self.edge(i, j);
            if self.across[at] && !self.edges[at].apart {
                self.order.push((self.edges[at].reach, i as u8, j as u8));
            }
        }
        self.order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let order = std::mem::take(&mut self.order);
        let done = order.iter().all(|&(_, i, j)| self.tell_apart(explore, i, j, budget));
        self.order = order;
        done
    }

    /// Whether all pieces hang together, as far as the resolution tells.
    pub fn is_whole(&self) -> bool {
        self.met.count() == 1
    }

    /// Looks at every two attractorlets once.
    fn look_at_all(&mut self, explore: &mut impl Explore) {
        let (rows, columns) = if self.turn { (1, self.count / 2 + 1) } else { (self.count, self.count) };
        for i in 0..rows {
            for first in (i + 1..columns).step_by(4) {
                let others = first..columns.min(first + 4);
                let looks = explore.first(i as u32, others.start as u32..others.end as u32);
                self.nodes += others.len();
                for (k, j) in others.enumerate() {
                    let at = self.edge(i, j);
                    self.edges[at].lower = looks.apart[k];
                    self.edges[at].reach = self.edges[at].reach.min(looks.reach[k]);
                    if self.edges[at].reach <= self.resolution * self.resolution {
                        {
                            let turns = self.turns();
                            join(&mut self.met, turns, i, j);
                        }
                    }
                }
            }
        }
    }

    /// Finds the least spanning tree of the components by the points known, and the cut that its widest edge bridges;
    /// returns the length of that edge.
    fn cut(&mut self) -> f64 {
        let Self { tree, edges, coarse, count, turn, across, .. } = self;
        let (count, turn) = (*count, *turn);
        let between = |i: u8, j: u8| {
            let (i, j) = (usize::from(i), usize::from(j));
            if coarse.joined(i, j) { 0.0 } else { edges[place(turn, count, i.min(j), i.max(j))].reach }
        };
        let widest = tree.cut(count, between);
        across.clear();
        across.resize(edges.len(), false);
        for i in 0..count {
            for j in i + 1..count {
                across[place(turn, count, i, j)] |= tree.beyond[i] != tree.beyond[j];
            }
        }
        widest.sqrt()
    }

    /// The widest edge of the least spanning tree of the nearest points known: an upper bound of the widest gap.
    pub fn bottleneck(&mut self) -> f64 {
        let Self { tree, edges, count, turn, .. } = self;
        let between = |i: u8, j: u8| edges[place(*turn, *count, i.min(j).into(), i.max(j).into())].reach;
        tree.cut(*count, between).sqrt()
    }

    /// Looks into two attractorlets until all pairs of parts are apart; `false` if they turn out to meet, or it is
    /// not found out.
    fn tell_apart(&mut self, explore: &mut impl Explore, i: u8, j: u8, budget: usize) -> bool {
        let at = self.edge(i.into(), j.into());
        let found = self.apart.len();
        self.stack.clear();
        let (u, v) = explore.root(i, j);
        self.stack.push(Pair { key: self.edges[at].lower, u, v, i, j });
        while let Some(pair) = self.stack.pop() {
            if pair.key > 0.0 {
                self.apart.push(pair);
                continue;
            }
            let small = explore.is_small(&pair);
            let near = !small && self.nodes < budget && self.split(explore, pair) <= self.resolution;
            if small || near {
                {
                    let turns = self.turns();
                    join(&mut self.met, turns, i.into(), j.into());
                }
            } else if self.nodes < budget {
                continue;
            }
            {
                let turns = self.turns();
                join(&mut self.coarse, turns, i.into(), j.into());
            }
            self.apart.truncate(found);
            return false;
        }
        self.edges[at].apart = true;
        true
    }

    /// Looks into the pairs across the cut, which are all apart, the nearest first, until the nearest is not much nearer than the
    /// `bridge`, or `budget` looks are spent; returns a lower bound of their distances.
    fn measure(&mut self, explore: &mut impl Explore, mut bridge: f64, budget: usize) -> f64 {
        explore.lean(true);
        let limit = self.nodes + budget;
        let Self { apart, by_distance, across, edges, turn, count, .. } = self;
        by_distance.clear();
        let is_across = |pair: &mut Pair| across[place(*turn, *count, pair.i.into(), pair.j.into())];
        by_distance.extend(apart.extract_if(.., is_across));
        for (edge, _) in edges.iter().zip(across).filter(|(_, across)| **across) {
            bridge = bridge.min(edge.reach.sqrt());
        }
        let mut lower = f64::INFINITY;
        while let Some(pair) = self.by_distance.pop() {
            lower = pair.key;
            if lower >= (1.0 - CLOSE) * bridge {
                self.apart.push(pair);
                break;
            }
            if self.nodes >= limit {
                self.follow(explore, pair);
                break;
            }
            bridge = bridge.min(self.split(explore, pair));
            self.by_distance.extend(self.stack.drain(..));
        }
        self.apart.extend(self.by_distance.drain());
        lower
    }

    /// Follows the nearest parts of some of the nearest pairs down, for points that are nearer than those met
    /// by a search that was cut short.
    fn follow(&mut self, explore: &mut impl Explore, first: Pair) {
        let mut next = Some(first);
        for _ in 0..DIVES {
            let Some(mut pair) = next else { return };
            self.apart.push(pair);
            for _ in 0..DEPTH {
                self.split(explore, pair);
                let near = self.parts.iter().min_by(|a, b| a.reach.total_cmp(&b.reach));
                pair = near.map_or(pair, |part| part.pair);
                self.stack.clear();
            }
            next = self.by_distance.pop();
        }
        self.apart.extend(next);
    }

    /// Puts the parts of a pair on the stack, the one that overlaps most on top; returns the least distance known
    /// of the two attractorlets.
    fn split(&mut self, explore: &mut impl Explore, pair: Pair) -> f64 {
        self.parts.clear();
        explore.split(&pair, &mut self.parts);
        self.nodes += self.parts.len();
        self.parts.sort_unstable_by(|a, b| b.overlap.total_cmp(&a.overlap).then(a.pair.cmp(&b.pair)));
        self.stack.extend(self.parts.iter().map(|part| part.pair));
        let at = self.edge(pair.i.into(), pair.j.into());
        let least = self.parts.iter().map(|part| part.reach).fold(f64::INFINITY, f64::min);
        self.edges[at].reach = self.edges[at].reach.min(least);
        self.edges[at].reach.sqrt()
    }
}

/// The place of a pair `i < j` of `count` pieces among the edges: with a turn by how far round it goes.
#[inline]
fn place(turn: bool, count: usize, i: usize, j: usize) -> usize {
    if turn { (j - i).min(count - (j - i)) } else { i * count + j }
}

/// Joins two pieces and, with a turn of so many pieces, all that are alike.
fn join(components: &mut Components, turn: Option<usize>, i: usize, j: usize) {
    components.join(i, j);
    if let Some(count) = turn {
        for k in 1..count {
            components.join((i + k) % count, (j + k) % count);
        }
    }
}
