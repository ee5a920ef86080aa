//! How near any two of several pieces come: bounds of the widest edge of their minimum spanning tree.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use frond_core::shared::Total;

use crate::gap::spanning_tree::SpanningTree;
use crate::verdict::Gap;

/// A pair of parts of two pieces that may hold their two nearest points: a lower bound of their distance, where it is
/// positive, otherwise the less the deeper they overlap; and the parts, which ties go by.
type Open = (Total, u32, u32);

/// The nearest points known of two pieces, and their distance with what rounding may add to it: infinite while none are
/// known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near<V> {
    pub reach: f64,
    pub points: [V; 2],
}

/// Bounds of the widest edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Widest {
    /// Above 0 only where the pieces are in several parts.
    pub lower: f64,
    pub upper: f64,
    /// The pair of pieces that has `upper`.
    pub pair: Option<usize>,
}

impl Widest {
    /// The same as an answer about a shape of at most this diameter; `None` where no shape has such a gap. No two
    /// points are farther apart than the diameter, whatever rounding may add.
    pub fn gap(self, diameter: f64) -> Option<Gap> {
        let upper = if self.upper.is_finite() { self.upper.min(diameter) } else { self.upper };
        Some(Gap { lower: self.lower, upper }).filter(|gap| gap.is_possible(diameter))
    }
}

/// What is seen of two parts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight {
    /// A lower bound of their distance.
    pub lower: f64,
    /// How far they are from lying in each other, 0 to 1, where `lower` tells nothing.
    pub depth: f64,
    /// The larger of their sizes.
    pub size: f64,
    /// The distance of two points in them, with what rounding may add.
    pub reach: f64,
}

/// What knows the parts of pieces, by number.
pub(crate) trait Parts<V> {
    /// Splits the larger of two parts, and looks at each of what it is made of with the other one ([`Pairs::keep`]).
    fn split(&mut self, pairs: &mut Pairs<V>, pair: usize, parts: [u32; 2]);
}

/// What is known of all pairs of pieces.
#[derive(Clone, Debug)]
pub(crate) struct Pairs<V> {
    count: usize,
    /// Of each pair `i < j`, at `i * count + j`.
    open: Vec<BinaryHeap<Reverse<Open>>>,
    near: Vec<Near<V>>,
    /// A lower bound of the distances in pairs that are too small to be split.
    floor: Vec<f64>,
    tree: SpanningTree,
    /// Whether two parts were seen to be farther apart than points in them: some bound is wrong, and nothing is said.
    contradicted: bool,
    /// Pairs of parts looked at.
    pub nodes: usize,
}

impl<V> Default for Pairs<V> {
    fn default() -> Self {
        let (open, near, floor) = (Vec::new(), Vec::new(), Vec::new());
        let tree = SpanningTree::default();
        Self { count: 0, open, near, floor, tree, contradicted: false, nodes: 0 }
    }
}

impl<V: Copy + Default> Pairs<V> {
    /// Forgets all, and starts with so many pieces.
    pub fn begin(&mut self, count: usize) {
        let pairs = count * count;
        self.count = count;
        self.nodes = 0;
        self.contradicted = false;
        self.open.iter_mut().for_each(BinaryHeap::clear);
        self.open.resize_with(pairs, BinaryHeap::new);
        self.near.clear();
        self.near.resize(pairs, Near { reach: f64::INFINITY, points: [V::default(); 2] });
        self.floor.clear();
        self.floor.resize(pairs, f64::INFINITY);
    }

    /// What is known of a pair `i < j`, `i * count + j`.
    pub fn near(&self, pair: usize) -> Near<V> {
        self.near[pair]
    }

    /// Points of two pieces, with their distance.
    pub fn meet(&mut self, pair: usize, near: Near<V>) {
        if near.reach < self.near[pair].reach {
            self.near[pair] = near;
        }
    }

    /// Keeps two parts if they may hold the two nearest points of their pieces. `off` is how far computed points may be
    /// off: what is smaller is a point, as far as floating point tells.
    pub fn keep(&mut self, pair: usize, [u, v]: [u32; 2], sight: &Sight, off: f64) {
        let &Sight { lower, depth, size, reach } = sight;
        self.contradicted |= lower > reach || lower.is_nan();
        let near = &mut self.near[pair];
        let key = if lower > 0.0 { lower } else { depth.clamp(0.0, 1.0) - 1.0 };
        if key > near.reach {
            return;
        }
        if size > 0.25 * off {
            self.open[pair].push(Reverse((Total(key), u, v)));
        } else {
            self.floor[pair] = self.floor[pair].min(key);
            if lower <= 0.0 {
                near.reach = near.reach.min(4.0 * off);
            }
        }
    }

    /// Bounds of the widest edge of the minimum spanning tree, refined until the upper one is at most `resolution`,
    /// or the lower one is positive and within `within` of the upper, or so many pairs of parts were looked at.
    ///
    /// Any cut of the pieces into two sets bounds the edge from below by the least distance across it; the cut at the
    /// widest edge of the tree of upper bounds is the one that tells most.
    pub fn bracket(
        &mut self,
        parts: &mut impl Parts<V>,
        resolution: f64,
        within: f64,
        budget: usize,
    ) -> Widest {
        let found = self.search(parts, resolution, within, budget);
        if self.contradicted { Widest { lower: 0.0, upper: f64::INFINITY, pair: None } } else { found }
    }

    fn search(&mut self, parts: &mut impl Parts<V>, resolution: f64, within: f64, budget: usize) -> Widest {
        let mut fresh = true;
        let mut widest = Widest { lower: 0.0, upper: f64::INFINITY, pair: None };
        if self.count < 2 {
            return Widest { upper: 0.0, ..widest };
        }
        loop {
            if fresh {
                widest.upper = self.grow();
                widest.pair = self.widest(widest.upper);
                if widest.upper <= resolution {
                    widest.lower = 0.0;
                    return widest;
                }
            }
            let (pair, lower) = self.across();
            widest.lower = lower.clamp(0.0, widest.upper);
            let close = lower > 0.0 && widest.upper - lower <= within * widest.upper;
            if close || self.nodes >= budget {
                return widest;
            }
            let before = self.near[pair].reach;
            if !self.refine(parts, pair) {
                return widest;
            }
            fresh = self.near[pair].reach < before;
        }
    }

    /// Looks at one pair of pieces until it is known whether they come as near as `resolution`: whether they do.
    pub fn settle(&mut self, parts: &mut impl Parts<V>, pair: usize, resolution: f64, budget: usize) -> bool {
        while self.near[pair].reach > resolution
            && self.lower(pair) <= resolution
            && self.nodes < budget
            && self.refine(parts, pair)
        {}
        self.near[pair].reach <= resolution && !self.contradicted
    }

    /// A lower bound of the distance of two pieces; negative or 0 where they may meet.
    fn lower(&self, pair: usize) -> f64 {
        let reach = self.near[pair].reach;
        self.open[pair].peek().map_or(reach, |Reverse((lower, ..))| lower.0.min(reach)).min(self.floor[pair])
    }

    /// The widest edge of the minimum spanning tree of the upper bounds.
    fn grow(&mut self) -> f64 {
        let Self { tree, near, count, .. } = self;
        tree.cut(*count, |i, j| {
            let (i, j) = (usize::from(i.min(j)), usize::from(i.max(j)));
            near[i * *count + j].reach
        })
    }

    fn widest(&self, upper: f64) -> Option<usize> {
        let across =
            |pair: &usize| self.tree.beyond[pair / self.count] != self.tree.beyond[pair % self.count];
        let pairs = (0..self.near.len()).filter(|pair| pair / self.count < pair % self.count);
        pairs.filter(across).find(|&pair| self.near[pair].reach == upper)
    }

    /// The pair across the widest edge whose lower bound is least, and that bound: no edge that joins the two sides is
    /// shorter.
    fn across(&self) -> (usize, f64) {
        let mut best = (0, f64::INFINITY);
        for i in 0..self.count {
            for j in i + 1..self.count {
                if self.tree.beyond[i] != self.tree.beyond[j] {
                    let lower = self.lower(i * self.count + j);
                    if lower < best.1 {
                        best = (i * self.count + j, lower);
                    }
                }
            }
        }
        best
    }

    /// Splits the most promising pair of parts of two pieces; `false` if none is left.
    fn refine(&mut self, parts: &mut impl Parts<V>, pair: usize) -> bool {
        let Some(Reverse((_, u, v))) = self.open[pair].pop() else { return false };
        parts.split(self, pair, [u, v]);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parts that are never split.
    struct Whole;

    impl Parts<f64> for Whole {
        fn split(&mut self, _: &mut Pairs<f64>, _: usize, _: [u32; 2]) {}
    }

    /// Two pieces of which this is seen, with points at the distance `reach`.
    fn bracketed(lower: f64, reach: f64) -> Option<Gap> {
        let mut pairs = Pairs::default();
        pairs.begin(2);
        pairs.meet(1, Near { reach, points: [0.0, reach] });
        pairs.keep(1, [0, 1], &Sight { lower, depth: 0.0, size: 1.0, reach }, 1e-12);
        pairs.bracket(&mut Whole, 1e-6, 0.01, 100).gap(1.0)
    }

    #[test]
    fn pieces_that_are_farther_apart_than_points_in_them_say_nothing() {
        assert_eq!(bracketed(0.3, 0.301), Some(Gap { lower: 0.3, upper: 0.301 }));
        for (lower, reach) in [(0.7, 9e-14), (0.7, 0.3), (f64::INFINITY, 0.3), (f64::NAN, 0.3)] {
            assert_eq!(bracketed(lower, reach), None, "{lower} {reach}");
        }
        // No two points are farther apart than the diameter.
        let wide = Widest { lower: 0.3, upper: 5.0, pair: None };
        assert_eq!(wide.gap(1.0), Some(Gap { lower: 0.3, upper: 1.0 }));
    }
}
