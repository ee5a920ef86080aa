//! The widest gap of one system, bracketed: the quick way, which `decide` takes for each sample of a locus.

use std::cmp::Reverse;

use crate::gap::pair_descent::{Explore, Known, Pair, PairDescent};
use crate::gap::spanning_tree::SpanningTree;
use crate::overlap_graph::Components;

/// A descent on pairs that looks for the widest gap. It keeps its memory for the next system.
///
/// The widest gap `g` is the greatest, over all ways to cut the pieces into two groups, of the least distance between
/// the groups. So points that are near show it to be no more than the widest edge of the minimum spanning tree
/// between them, and whatever cut is proved to be wide shows it to be no less. The cut to try is the one that this
/// widest edge bridges: pairs of pieces that lie on one side of it need not be looked into at all, and of the others
/// only those parts that may be nearer than what bridges it.
#[derive(Clone, Debug, Default)]
pub(crate) struct CutSearch {
    descent: PairDescent<()>,
    order: Vec<(f64, u8, u8)>,
    tree: SpanningTree,
    /// Which pairs lie across the cut.
    across: Vec<bool>,
    /// Pieces that meet, and those that were not told apart within the budget.
    coarse: Components,
    /// The pairs that were found to meet until a cut was proved: see [`CutSearch::meetings`].
    meetings: Vec<Meeting>,
}

/// Two attractorlets that were found to meet, and the parts where they do, if it was found by these.
pub(crate) type Meeting = (usize, usize, Option<(u32, u32)>);

/// The widest gap, in the plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    pub lower: f64,
    pub upper: f64,
}

/// How far, relative to it, the lower bound of a gap may be below the upper one.
const BRACKET_WIDTH: f64 = 0.095;
/// Looks spent on telling two pieces apart before others are looked at, and how many times as many after that.
const LOOKS_AT_FIRST: usize = 500;
const MORE_LOOKS: usize = 4;
/// Looks spent at most on measuring a gap that is there.
const LOOKS_TO_MEASURE: usize = 2000;
/// How many pairs are followed down after a search that was cut short.
const PAIRS_FOLLOWED: usize = 8;

impl CutSearch {
    /// See [`PairDescent::begin`].
    pub fn begin(&mut self, count: usize, turn: bool) {
        self.descent.begin(count, turn, true);
    }

    /// Pairs of pieces looked at.
    pub const fn looks(&self) -> usize {
        self.descent.nodes
    }

    /// Counts them anew.
    pub const fn forget_looks(&mut self) {
        self.descent.nodes = 0;
    }

    /// Joins pieces that `meet`, for certain.
    pub fn join_proved(&mut self, meet: impl Fn(usize, usize) -> bool) {
        for (i, j) in self.descent.pairs() {
            if meet(i, j) {
                self.descent.join_at(i, j, 0.0);
            }
        }
    }

    /// Joins pieces for which `meet` gives the square of a small distance, until all hang together or some do
    /// not.
    pub fn join_near(&mut self, mut meet: impl FnMut(usize, usize) -> Option<f64>) {
        let mut row = 0;
        for (i, j) in self.descent.pairs() {
            if i > row {
                // All that could join these to the others was tried.
                if (row + 1..self.descent.count).all(|j| !self.descent.met.joined(row, j)) {
                    return;
                }
                row = i;
            }
            if !self.descent.met.joined(i, j)
                && let Some(reach) = meet(i, j)
            {
                self.descent.join_at(i, j, reach);
                if self.is_whole() {
                    return;
                }
            }
        }
    }

    /// Joins two pieces, `i < j`, that are not joined yet if `meet` gives the square of a small distance.
    pub fn join_near_pair(&mut self, i: usize, j: usize, meet: impl FnOnce() -> Option<f64>) {
        if !self.descent.met.joined(i, j)
            && let Some(reach) = meet()
        {
            self.descent.join_at(i, j, reach);
        }
    }

    /// Whether all pieces hang together, as far as the resolution tells.
    pub fn is_whole(&self) -> bool {
        self.descent.is_whole()
    }

    /// The pairs of attractorlets that were found to meet before the first cut was proved, or by the end if none was:
    /// so they are the same whether the gap was measured or not.
    pub fn meetings(&self) -> &[Meeting] {
        &self.meetings
    }

    fn note_meetings(&mut self) {
        let Self { descent, meetings, .. } = self;
        meetings.clear();
        meetings.extend(descent.pairs().filter_map(|(i, j)| {
            let edge = &descent.edges[descent.edge(i, j)];
            (edge.known == Known::Meet).then_some((i, j, edge.parts))
        }));
    }

    /// Bounds the widest gap until it is known whether it is one and how wide about, or `budget` looks are spent.
    /// The lower bound is 0 unless the attractor is proved to be in several pieces.
    ///
    /// `resolution` is in the plane. Unless it is to `measure`, it ends where it is known whether the widest gap is
    /// one, and there are no bounds.
    pub fn bracket(
        &mut self,
        explore: &mut impl Explore<Nearest = ()>,
        resolution: f64,
        budget: usize,
        measure: bool,
    ) -> Bracket {
        self.descent.near = resolution * resolution;
        explore.choose_metric(false);
        self.descent.look_at_all(explore, |_| ());
        self.coarse.clone_from(&self.descent.met);
        let (mut spent, mut rounds) = (0, 0);
        let mut found = Bracket { lower: 0.0, upper: f64::INFINITY };
        while self.coarse.count() > 1 {
            let bridge = self.cut();
            if !self.prove(explore, budget) {
                // The cut is none.
                continue;
            }
            if rounds == 0 {
                self.note_meetings();
                if !measure {
                    return found;
                }
            }
            let before = self.descent.nodes;
            let lower = self.measure(explore, bridge, LOOKS_TO_MEASURE.saturating_sub(spent));
            spent += self.descent.nodes - before;
            let upper = self.cut();
            // Each cut shows that the gap is at least so wide.
            let stuck = spent >= LOOKS_TO_MEASURE && (upper >= found.upper || rounds > self.descent.count);
            found = Bracket { lower: lower.max(found.lower), upper };
            if found.lower >= (1.0 - BRACKET_WIDTH) * upper || stuck {
                return found;
            }
            rounds += 1;
        }
        if rounds == 0 {
            self.note_meetings();
        }
        Bracket { lower: 0.0, upper: self.bottleneck() }
    }

    /// Tells all pairs apart that lie across the cut, in turns, those that overlap most first; `false` if two turn out
    /// to meet, or this is not found out.
    fn prove(&mut self, explore: &mut impl Explore<Nearest = ()>, budget: usize) -> bool {
        explore.choose_metric(false);
        self.order.clear();
        for (i, j) in self.descent.pairs() {
            let at = self.descent.edge(i, j);
            let edge = &self.descent.edges[at];
            if self.across[at] && edge.known != Known::Apart {
                self.order.push((edge.overlap, i as u8, j as u8));
            }
        }
        self.order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let Self { descent, order, coarse, .. } = self;
        // One pair that meets is enough: so none takes all there is while others have not had as much.
        let mut share = LOOKS_AT_FIRST;
        while !order.is_empty() {
            let mut meets = None;
            order.retain(|&(_, i, j)| {
                if meets.is_some() {
                    return true;
                }
                let limit = budget.min(descent.nodes + share);
                let known = descent.go_on(explore, i, j, limit);
                if known == Known::Meet || known == Known::Open && descent.nodes >= budget {
                    meets = Some((i, j));
                }
                known != Known::Apart
            });
            if let Some((i, j)) = meets {
                descent.join_in(coarse, i.into(), j.into());
                return false;
            }
            share *= MORE_LOOKS;
        }
        true
    }

    /// Finds the minimum spanning tree of the components by the points known, and the cut that its widest edge bridges;
    /// returns the length of that edge.
    fn cut(&mut self) -> f64 {
        let Self { descent, tree, coarse, across, .. } = self;
        let place = descent.places();
        let between = |i: u8, j: u8| {
            let (i, j) = (usize::from(i), usize::from(j));
            if coarse.joined(i, j) { 0.0 } else { descent.edges[place(i.min(j), i.max(j))].reach }
        };
        let widest = tree.cut(descent.count, between);
        across.clear();
        across.resize(descent.edges.len(), false);
        for i in 0..descent.count {
            for j in i + 1..descent.count {
                across[place(i, j)] |= tree.beyond[i] != tree.beyond[j];
            }
        }
        widest.sqrt()
    }

    /// The widest edge of the minimum spanning tree of the nearest points known: an upper bound of the widest gap.
    pub fn bottleneck(&mut self) -> f64 {
        let Self { descent, tree, .. } = self;
        let between = |i: u8, j: u8| descent.edges[descent.edge(i.min(j).into(), i.max(j).into())].reach;
        tree.cut(descent.count, between).sqrt()
    }

    /// Looks into the pairs across the cut, which are all apart, the nearest first, until the nearest is not much
    /// nearer than the `bridge`, or `budget` looks are spent; returns a lower bound of their distances.
    fn measure(&mut self, explore: &mut impl Explore<Nearest = ()>, mut bridge: f64, budget: usize) -> f64 {
        explore.choose_metric(true);
        let Self { descent, across, .. } = self;
        let limit = descent.nodes + budget;
        let place = descent.places();
        descent.by_distance.clear();
        let is_across = |pair: &mut Pair| across[place(pair.i.into(), pair.j.into())];
        descent.by_distance.extend(descent.apart.extract_if(.., is_across).map(Reverse));
        for (edge, _) in descent.edges.iter().zip(across.iter()).filter(|(_, across)| **across) {
            bridge = bridge.min(edge.reach.sqrt());
        }
        let kept = descent.apart.len();
        let mut lower = f64::INFINITY;
        while let Some(Reverse(pair)) = descent.by_distance.pop() {
            lower = pair.key.0;
            if lower >= (1.0 - BRACKET_WIDTH) * bridge {
                descent.apart.push(pair);
                break;
            }
            if descent.nodes >= limit {
                descent.follow_nearest(explore, pair, PAIRS_FOLLOWED);
                break;
            }
            bridge = bridge.min(descent.split(explore, pair, lower).sqrt());
            // One by one: they are few, and the heap is large.
            for pair in descent.apart.drain(kept..) {
                descent.by_distance.push(Reverse(pair));
            }
        }
        descent.apart.extend(descent.by_distance.drain().map(|Reverse(pair)| pair));
        lower
    }
}
