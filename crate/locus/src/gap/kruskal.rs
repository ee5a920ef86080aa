//! Which pieces meet, and how far all others are apart: the thorough way, for the full answer about one system.
//!
//! First the pairs that are not yet known to be apart are pursued, those that overlap most before the others: it ends
//! with a verdict. Then the others, nearest first, which is Kruskal's algorithm on the distances between pieces: it
//! ends with the widest edge of their minimum spanning tree.

use std::cmp::Reverse;

use glam::DVec2;

use crate::frame::Frame;
use crate::gap::pair_descent::{Edge, Explore, Known, Pair, PairDescent};
use crate::gap::word_pairs::WordPairs;
use crate::gap::word_tree::WordTree;
use crate::overlap_graph::Components;
use crate::support::table::SupportTable;

/// Two points of the attractor, in the frame: of the first piece and of the second.
pub(crate) type Ends = [DVec2; 2];

/// A descent on pairs that finds out about all of them.
pub(crate) struct KruskalSearch<'a> {
    words: WordPairs<'a, Ends>,
    descent: PairDescent<Ends>,
    /// Attractorlets that may meet, the pair that overlaps most last.
    open: Vec<Pair>,
    /// Of those the ones passed over since they were in one component already.
    later: Vec<Pair>,
    /// The diameter of the attractor in the plane.
    pub plane_diameter: f64,
    /// Pieces within this distance touch.
    pub resolution: f64,
}

/// The widest gap, in the plane.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct WidestEdge {
    pub lower: f64,
    pub upper: f64,
    /// The points that realise the upper bound.
    pub ends: Option<Ends>,
}

/// How many pairs are followed down after a search that was cut short.
const PAIRS_FOLLOWED: usize = 9;

impl<'a> KruskalSearch<'a> {
    /// Starts a descent: every two attractorlets that differ are looked at once.
    ///
    /// `epsilon` is relative to the diameter of the attractor.
    pub fn begin(
        frame: &'a Frame,
        support: &'a mut SupportTable,
        tree: &'a mut WordTree,
        epsilon: f64,
    ) -> Self {
        let plane_diameter = frame.diameter(support.diameter(frame.from_round));
        let mut search = Self {
            words: WordPairs::new(frame, support, tree),
            descent: PairDescent::default(),
            open: Vec::new(),
            later: Vec::new(),
            plane_diameter,
            resolution: 0.0,
        };
        search.begin_again(epsilon);
        search
    }

    /// Starts anew with another epsilon.
    pub fn begin_again(&mut self, epsilon: f64) {
        let Self { words, descent, open, .. } = self;
        let frame = words.frame;
        self.resolution = frame.resolution(epsilon, self.plane_diameter);
        // Points that are computed to be within this distance are within the resolution, whatever rounding may add.
        let near = (self.resolution - frame.off()).max(0.5 * self.resolution);
        words.begin(self.resolution, near);
        words.choose_metric(false);
        descent.begin(frame.maps.len(), false, false);
        descent.near = near * near;
        for (i, j) in descent.pairs() {
            // The same piece twice.
            if frame.maps[i] == frame.maps[j] {
                descent.join_at(i, j, 0.0);
            }
        }
        self.later.clear();
        open.clear();
        descent.look_at_all(words, |pair| open.push(pair));
        // Without a look more, those that were seen to be apart.
        open.retain(|pair| descent.tell_apart(words, pair.i, pair.j, 0) == Known::Open);
        open.sort_unstable_by(|p, q| q.cmp(p));
    }

    /// Pursues the pairs that are not known to be apart until all pieces are in one component, or none
    /// of these pairs is left; `false` if `budget` looks did not suffice.
    pub fn settle(&mut self, budget: usize) -> bool {
        while !self.descent.is_whole() {
            let Some(pair) = self.open.pop() else { return true };
            if self.descent.met.joined(usize::from(pair.i), usize::from(pair.j)) {
                self.later.push(pair);
            } else if self.descent.tell_apart(&mut self.words, pair.i, pair.j, budget) == Known::Open {
                return false;
            }
        }
        true
    }

    /// Goes on where [`KruskalSearch::settle`] ended, until of every two attractorlets it is known whether they meet.
    pub fn settle_all(&mut self, budget: usize) -> bool {
        self.open.append(&mut self.later);
        while let Some(pair) = self.open.pop() {
            let known = self.edge(pair.i.into(), pair.j.into()).known;
            if known == Known::Open
                && self.descent.tell_apart(&mut self.words, pair.i, pair.j, budget) == Known::Open
            {
                return false;
            }
        }
        true
    }

    /// What is known of two attractorlets `i < j`.
    pub fn edge(&self, i: usize, j: usize) -> &Edge<Ends> {
        &self.descent.edges[self.descent.edge(i, j)]
    }

    /// Records that two attractorlets `i < j` meet.
    pub fn join(&mut self, i: usize, j: usize) {
        self.descent.join(i, j);
    }

    /// What belongs together by the pieces that were found to meet.
    pub fn met(&self) -> &Components {
        &self.descent.met
    }

    /// The components if all pairs that are still open should meet: pieces in different ones are proved apart.
    pub fn coarsest(&self) -> Components {
        let mut components = self.descent.met.clone();
        for (i, j) in self.known(|known| known == Known::Open) {
            components.join(i, j);
        }
        components
    }

    /// Pairs of attractorlets that were found to meet, `i < j`, in ascending order.
    pub fn overlaps(&self) -> Vec<(usize, usize)> {
        self.known(|known| known == Known::Meet).collect()
    }

    /// The same, and those that are not known to be apart.
    pub fn may_meet(&self) -> Vec<(usize, usize)> {
        self.known(|known| known != Known::Apart).collect()
    }

    fn known(&self, is: impl Fn(Known) -> bool) -> impl Iterator<Item = (usize, usize)> {
        self.descent.pairs().filter(move |&(i, j)| is(self.edge(i, j).known))
    }

    /// Support values of the attractor.
    pub fn support(&self) -> &SupportTable {
        self.words.support
    }

    /// Pairs of pieces looked at.
    pub fn nodes(&self) -> usize {
        self.descent.nodes
    }

    /// Takes looks into account that were spent before.
    pub fn add_nodes(&mut self, spent: usize) {
        self.descent.nodes += spent;
    }

    /// Joins the components in the order of their distances until one is left, or `budget` looks are
    /// spent, and so measures the widest gap. Pieces that were joined before for being near count as far apart as their
    /// nearest known points: the upper bound is that of all pieces.
    ///
    /// A distance is known well enough when its bounds differ by `relative` of it or by `absolute`, or where no parts
    /// of the pieces would tell more: of very flat shapes the digits of the coefficients do not.
    pub fn measure(&mut self, relative: f64, absolute: f64, budget: usize) -> WidestEdge {
        // From here on pieces are known to be apart, however near they come, unless they were left open: then they
        // may meet, as far as the lower bound goes.
        let mut components = self.coarsest();
        let Self { words, descent, .. } = self;
        descent.near = -1.0;
        words.choose_metric(true);
        let mut lower = 0.0_f64;
        while components.count() > 1 {
            descent.by_distance.extend(descent.apart.drain(..).map(Reverse));
            let Some(Reverse(pair)) = descent.by_distance.pop() else { break };
            let (i, j) = (usize::from(pair.i), usize::from(pair.j));
            if components.joined(i, j) {
                continue;
            }
            // Whatever is still to be joined is at least as far apart as the nearest pair left.
            let distance = pair.key.0;
            lower = lower.max(distance);
            let reach = descent.edges[descent.edge(i, j)].reach.sqrt();
            let known = reach - distance <= (relative * reach).max(absolute);
            if known || words.is_no_larger_than_rounding(&pair) {
                components.join(i, j);
            } else if descent.nodes < budget {
                descent.split(words, pair, distance);
            } else {
                descent.follow_nearest(words, pair, PAIRS_FOLLOWED);
                break;
            }
        }
        WidestEdge { lower, ..self.widest_edge() }
    }

    /// An upper bound of the widest gap: the widest edge of the minimum spanning tree of the nearest points known,
    /// and what rounding may add.
    pub fn widest_edge(&self) -> WidestEdge {
        let mut widest = WidestEdge::default();
        let mut components = Components::new(self.descent.count);
        let mut pairs: Vec<(usize, usize)> = self.descent.pairs().collect();
        pairs.sort_by(|a, b| self.edge(a.0, a.1).reach.total_cmp(&self.edge(b.0, b.1).reach));
        for (i, j) in pairs {
            if components.join(i, j) {
                let edge = self.edge(i, j);
                let [from, to] = edge.points;
                let upper = self.words.frame.farthest(edge.reach.sqrt(), to - from);
                if upper >= widest.upper {
                    (widest.upper, widest.ends) = (upper, Some(edge.points));
                }
            }
        }
        // No two points are farther apart than the diameter.
        widest.upper = widest.upper.min(self.plane_diameter);
        widest
    }
}
