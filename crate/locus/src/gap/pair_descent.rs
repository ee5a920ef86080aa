//! The descent on pairs of words: how near the pieces of an attractor come to each other.
//!
//! A pair of words stands for the two pieces of the attractor that they name, one in each of two attractorlets. Support
//! functions bound the distance of the two from below, two points of the attractor bound it from above. A pair that is
//! neither apart nor small is split at the larger piece. Which pairs are looked into, and in which order, is up to who
//! asks: [`bracket`](crate::gap::bracket) wants no more than the widest gap, [`kruskal`](crate::gap::kruskal) to know
//! which pieces meet and how far all others are apart.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::{ControlFlow, Range};

use frond_core::shared::Total;

use crate::overlap_graph::Components;
use crate::support::extremes::{larger, lesser};

/// How pairs of pieces are looked at and split.
pub(crate) trait Explore {
    /// What is kept of the two nearest points of two attractorlets.
    type Nearest: Copy + Default;
    /// In which metric the next looks are: one in which pieces are told apart best, or that of the plane, to measure.
    fn choose_metric(&mut self, to_measure: bool);
    /// Looks at attractorlet `i` and each of one to four others, which are the second of their pairs.
    fn first(&mut self, i: u32, others: Range<u32>, see: impl FnMut(u32, Sight<Self::Nearest>));
    /// The numbers by which it knows two attractorlets.
    fn root(&mut self, i: u8, j: u8) -> (u32, u32);
    /// Whether both pieces of a pair are so small that they are taken to meet if they are not known to be apart.
    fn is_small(&self, pair: &Pair) -> bool;
    /// Splits a pair and looks at its parts `(u, v)`, until `see` has seen enough.
    fn split(&mut self, pair: &Pair, see: impl FnMut(u32, u32, Sight<Self::Nearest>) -> ControlFlow<()>);
}

/// What is seen of two pieces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight<P> {
    /// A lower bound of their distance in the plane; not above 0 where the two may meet.
    pub apart: f64,
    /// How near their middles are, against what reaches from one to the other.
    pub overlap: f64,
    /// The square of the distance of two points of the attractor, one in each.
    pub reach: f64,
    pub points: P,
}

/// A pair of pieces in two attractorlets `i < j`. Ties of the order go by the pieces, so that nothing depends on how a
/// heap is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Pair {
    /// What it is ordered by: how deep the two overlap, or their distance.
    pub key: Total,
    pub u: u32,
    pub v: u32,
    pub i: u8,
    pub j: u8,
}

/// What is known of two attractorlets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge<P> {
    /// A lower bound of their distance, from the first look.
    lower: f64,
    /// The square of the least distance known of two points.
    pub reach: f64,
    /// These points.
    pub points: P,
    /// The parts that these points were seen in, or those too small to be told apart, if it was not the whole.
    pub parts: Option<(u32, u32)>,
    pub known: Known,
    /// How deep the two overlap, from the first look.
    pub overlap: f64,
    /// Whether the two were looked into.
    begun: bool,
}

/// Whether two attractorlets meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Known {
    /// Nobody has found out.
    Open,
    /// They do, as far as the resolution tells.
    Meet,
    /// They do not: pairs of parts that show it are among those that are apart.
    Apart,
}

/// What a descent on pairs needs, kept for the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct PairDescent<P> {
    /// Of each two attractorlets; see [`PairDescent::edge`].
    pub edges: Vec<Edge<P>>,
    /// Pieces that meet, as far as the resolution tells.
    pub met: Components,
    /// Pairs of the two attractorlets in hand that may meet: a stack.
    open: Vec<Pair>,
    /// The same of others, to be gone on with: see [`PairDescent::go_on`].
    paused: Vec<Pair>,
    /// Pairs that are apart.
    pub apart: Vec<Pair>,
    /// The same while they are taken in the order of their distances.
    pub by_distance: BinaryHeap<Reverse<Pair>>,
    pub count: usize,
    turn: bool,
    /// Whether all parts of a pair are looked at, also when two have met.
    thorough: bool,
    /// Points whose distance has this square or less count as one.
    pub near: f64,
    /// Pairs of pieces looked at.
    pub nodes: usize,
}

/// Parts followed down from a pair whose nearest points are looked for.
const LETTERS_FOLLOWED: usize = 24;

impl<P: Copy + Default> PairDescent<P> {
    /// Begins with the pieces of the maps; those that are known to meet may be joined then.
    ///
    /// Where a `turn` takes each piece to the next, pairs that are as far round from each other are alike, and only
    /// those with piece 0 are looked at.
    pub fn begin(&mut self, count: usize, turn: bool, thorough: bool) {
        (self.count, self.turn, self.thorough) = (count, turn, thorough);
        self.met.reset(count);
        self.edges.clear();
        let unknown = Edge {
            lower: 0.0,
            reach: f64::INFINITY,
            points: P::default(),
            parts: None,
            known: Known::Open,
            overlap: 0.0,
            begun: false,
        };
        self.edges.resize(count * count, unknown);
        self.apart.clear();
        self.paused.clear();
        self.by_distance.clear();
        self.nodes = 0;
    }

    /// The place of a pair `i < j` among the edges.
    #[inline]
    pub fn edge(&self, i: usize, j: usize) -> usize {
        place(self.turn, self.count, i, j)
    }

    /// The function [`PairDescent::edge`], on its own.
    pub fn places(&self) -> impl Fn(usize, usize) -> usize + use<P> {
        let (turn, count) = (self.turn, self.count);
        move |i, j| place(turn, count, i, j)
    }

    /// The pairs `i < j` that stand for all: with a turn those of piece 0 and the first half round.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + use<P> {
        let (rows, columns) = self.rows_and_columns();
        (0..rows).flat_map(move |i| (i + 1..columns).map(move |j| (i, j)))
    }

    fn rows_and_columns(&self) -> (usize, usize) {
        if self.turn { (1, self.count / 2 + 1) } else { (self.count, self.count) }
    }

    /// Takes note that two pieces, `i < j`, meet.
    pub fn join(&mut self, i: usize, j: usize) {
        let at = self.edge(i, j);
        self.edges[at].known = Known::Meet;
        join(&mut self.met, self.turn.then_some(self.count), i, j);
    }

    /// [`PairDescent::join`], and that the square of the distance of two points is `reach`.
    pub fn join_at(&mut self, i: usize, j: usize, reach: f64) {
        let at = self.edge(i, j);
        self.edges[at].reach = lesser(self.edges[at].reach, reach);
        self.join(i, j);
    }

    /// Joins two pieces in another graph than that of those that meet.
    pub fn join_in(&self, components: &mut Components, i: usize, j: usize) {
        join(components, self.turn.then_some(self.count), i, j);
    }

    /// Whether all pieces hang together, as far as the resolution tells.
    pub fn is_whole(&self) -> bool {
        self.met.count() == 1
    }

    /// Looks at every two attractorlets once, but for those known to have a point in common; `see` is told how deep
    /// those overlap that do not meet so far.
    pub fn look_at_all(&mut self, explore: &mut impl Explore<Nearest = P>, mut see: impl FnMut(Pair)) {
        let (rows, columns) = self.rows_and_columns();
        for i in 0..rows {
            for first in (i + 1..columns).step_by(4) {
                let others = first as u32..columns.min(first + 4) as u32;
                explore.first(i as u32, others, |j, sight| {
                    let at = self.edge(i, j as usize);
                    if self.edges[at].reach == 0.0 {
                        return;
                    }
                    self.nodes += 1;
                    self.edges[at].lower = sight.apart;
                    self.edges[at].overlap = sight.overlap;
                    self.edges[at].note(&sight, None);
                    if self.edges[at].reach <= self.near {
                        self.join(i, j as usize);
                    } else {
                        see(Pair { key: Total(sight.overlap), u: i as u32, v: j, i: i as u8, j: j as u8 });
                    }
                });
            }
        }
    }

    /// Looks into two attractorlets until it is known whether they meet, or `budget` looks are spent. Depth first,
    /// parts that overlap most before their sisters.
    pub fn tell_apart(
        &mut self,
        explore: &mut impl Explore<Nearest = P>,
        i: u8,
        j: u8,
        budget: usize,
    ) -> Known {
        let found = self.apart.len();
        self.begin_pair(explore, i, j);
        let known = self.search(explore, i, j, budget);
        if known != Known::Apart {
            self.apart.truncate(found);
        }
        known
    }

    /// [`PairDescent::tell_apart`], from where it ended the last time for these two, for as long as fewer than `limit`
    /// looks were spent in all.
    pub fn go_on(&mut self, explore: &mut impl Explore<Nearest = P>, i: u8, j: u8, limit: usize) -> Known {
        let at = self.edge(i.into(), j.into());
        if std::mem::replace(&mut self.edges[at].begun, true) {
            self.open.clear();
            self.open.extend(self.paused.extract_if(.., |pair| (pair.i, pair.j) == (i, j)));
        } else {
            self.begin_pair(explore, i, j);
        }
        let known = self.search(explore, i, j, limit);
        if known == Known::Open {
            self.paused.append(&mut self.open);
        }
        known
    }

    /// Leaves two attractorlets as they are to be looked into.
    fn begin_pair(&mut self, explore: &mut impl Explore<Nearest = P>, i: u8, j: u8) {
        let at = self.edge(i.into(), j.into());
        let (u, v) = explore.root(i, j);
        let root = Pair { key: Total(self.edges[at].lower), u, v, i, j };
        self.open.clear();
        if root.key.0 > 0.0 {
            self.apart.push(root);
        } else {
            self.open.push(root);
        }
    }

    /// Looks into what is open of two attractorlets.
    fn search(&mut self, explore: &mut impl Explore<Nearest = P>, i: u8, j: u8, budget: usize) -> Known {
        let at = self.edge(i.into(), j.into());
        let mut known = Known::Apart;
        while let Some(pair) = self.open.pop() {
            if explore.is_small(&pair) {
                self.edges[at].parts = Some((pair.u, pair.v));
                known = Known::Meet;
                break;
            }
            if self.nodes >= budget {
                self.open.push(pair);
                known = Known::Open;
                break;
            }
            if self.split(explore, pair, 0.0) <= self.near {
                known = Known::Meet;
                break;
            }
        }
        match known {
            Known::Meet => self.join(i.into(), j.into()),
            _ => self.edges[at].known = known,
        }
        known
    }

    /// Splits a pair that is `apart`: those of its parts that are, too, go to the others, the rest on the stack, the
    /// one that overlaps most on top. Parts are no nearer than the whole, even if the directions tried on them show
    /// less. Returns the square of the least distance known of the two attractorlets.
    pub fn split(&mut self, explore: &mut impl Explore<Nearest = P>, pair: Pair, apart: f64) -> f64 {
        let at = self.edge(pair.i.into(), pair.j.into());
        let before = self.open.len();
        explore.split(&pair, |u, v, sight| {
            self.nodes += 1;
            self.edges[at].note(&sight, Some((u, v)));
            if self.edges[at].reach <= self.near && !self.thorough {
                return ControlFlow::Break(());
            }
            let lower = larger(sight.apart, apart);
            if lower > 0.0 {
                self.apart.push(Pair { key: Total(lower), u, v, ..pair });
            } else {
                self.open.push(Pair { key: Total(sight.overlap), u, v, ..pair });
            }
            ControlFlow::Continue(())
        });
        self.open[before..].sort_unstable_by(|p, q| q.cmp(p));
        self.edges[at].reach
    }

    /// Follows the nearest parts of so many pairs down, the first of them given and the others the nearest left, for
    /// points that are nearer than those met by a search that was cut short.
    pub fn follow_nearest(&mut self, explore: &mut impl Explore<Nearest = P>, first: Pair, pairs: usize) {
        let mut next = Some(first);
        for _ in 0..pairs {
            let Some(pair) = next else { return };
            self.apart.push(pair);
            self.follow(explore, pair);
            next = self.by_distance.pop().map(|Reverse(pair)| pair);
        }
        self.apart.extend(next);
    }

    fn follow(&mut self, explore: &mut impl Explore<Nearest = P>, pair: Pair) {
        let at = self.edge(pair.i.into(), pair.j.into());
        let (mut u, mut v) = (pair.u, pair.v);
        for _ in 0..LETTERS_FOLLOWED {
            let mut nearest = (f64::INFINITY, u, v);
            explore.split(&Pair { u, v, ..pair }, |u, v, sight| {
                self.nodes += 1;
                self.edges[at].note(&sight, Some((u, v)));
                if sight.reach < nearest.0 {
                    nearest = (sight.reach, u, v);
                }
                ControlFlow::Continue(())
            });
            (_, u, v) = nearest;
        }
    }
}

impl<P: Copy> Edge<P> {
    #[inline]
    fn note(&mut self, sight: &Sight<P>, parts: Option<(u32, u32)>) {
        if sight.reach < self.reach {
            (self.reach, self.points, self.parts) = (sight.reach, sight.points, parts);
        }
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
