//! Descent on pairs of words over a whole box of parameters: whether all of its attractors are disconnected.
//!
//! It is the descent of [`PairDescent`](crate::gap::pair_descent::PairDescent) in all corners of the box at once. A
//! pair of pieces is apart over the box if one direction shows it in all corners by more than the points of the two
//! may dip in between: see [`derivative_bounds`](crate::region::derivative_bounds). What is left open counts as
//! meeting.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::Range;

use glam::DVec2;

use crate::family::Family;
use crate::frame::Frame;
use crate::overlap_graph::Components;
use crate::region::derivative_bounds::{Lanes, bows};
use crate::region::extent::Extent;
use crate::region::silhouette::Silhouettes;
use crate::support::extremes::{larger, lesser};
use crate::support::lanes::{Maps, SupportLanes};

/// A piece in all lanes.
#[derive(Clone, Debug)]
pub(crate) struct Part<const L: usize> {
    pub maps: Maps<L>,
    /// An upper bound of its map's operator norm over the box.
    pub norm: f64,
    /// c of its map's translation, and how far that of a point may be off: see
    /// [`derivative_bounds`](crate::region::derivative_bounds).
    pub bows: [DVec2; 2],
    pub sag: f64,
    /// Half the squared Frobenius norm in the first lane.
    size: f64,
    /// The index of its first part, 0 while it is not split.
    parts: u32,
    /// The piece it is a part of, itself if it is an attractorlet; and by which letter.
    parent: u32,
    letter: u8,
}

/// A pair of pieces in two attractorlets `i < j`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Couple {
    /// How near their middles are against what reaches from one to the other: 0 if they coincide.
    pub overlap: f64,
    pub u: u32,
    pub v: u32,
    pub i: u8,
    pub j: u8,
}

/// A pair that may cross, in the order of how likely it does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Promising {
    pub promise: f64,
    pub couple: Couple,
}

impl PartialEq for Promising {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Promising {}

impl PartialOrd for Promising {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Promising {
    /// Of two alike the one that was met first comes first.
    fn cmp(&self, other: &Self) -> Ordering {
        let words = |pair: &Self| (pair.couple.u, pair.couple.v);
        self.promise.total_cmp(&other.promise).then_with(|| words(other).cmp(&words(self)))
    }
}

/// What was seen of a pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight {
    /// A lower bound of the distance of the two over the box; not above 0 where they may meet.
    pub apart: f64,
    pub overlap: f64,
    /// The distance of a point of one from a point of the other over the box, at most.
    pub reach: f64,
    /// The same in some lane, the least.
    pub near: f64,
}

/// What a descent needs, kept for the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct Descent<const L: usize> {
    pub lanes: Lanes<L>,
    pub fan: SupportLanes<L>,
    pub parts: Vec<Part<L>>,
    pub open: Vec<Couple>,
    /// For each two maps what is known of their distance: from below, of pairs apart, and from above.
    pub lower: Vec<f64>,
    pub upper: Vec<f64>,
    pub components: Components,
    pub count: usize,
    /// Pairs looked at.
    pub nodes: usize,
    narrow: f64,
    /// What the search for crossings keeps.
    pub silhouettes: Silhouettes,
    pub promising: BinaryHeap<Promising>,
}

/// Directions tried on a pair.
const DIRECTIONS_PER_PAIR: usize = 2;
/// The square of a direction has all its digits from here on.
const LEAST_SQUARE: f64 = 1e-290;

impl<const L: usize> Descent<L> {
    /// Starts on a box; `false` if nothing can be said of it as a whole.
    pub fn begin<F: Family + ?Sized>(&mut self, family: &F, extent: Extent, frame: &mut Frame) -> bool {
        if !self.lanes.set(family, extent, frame) || self.lanes.widest_margin() > 0.5 {
            return false;
        }
        self.set_support();
        true
    }

    /// Bounds the attractors of the lanes that are set.
    pub fn set_support(&mut self) {
        self.fan.set(&self.lanes.maps, 0.012 * (1.0 - self.lanes.factor), 64);
        self.lanes.refine(&self.fan);
        self.count = self.lanes.maps.len();
        self.parts.clear();
        self.silhouettes.clear();
        for k in 0..self.count {
            self.add(self.lanes.maps[k], self.lanes.norms[k], k as u32, k as u8);
        }
    }

    /// Bounds of the diameter of the attractors over the box: below that of any, above that of all.
    pub fn diameter(&self) -> (f64, f64) {
        let (upper, lower) = self.fan.diameter();
        let margin = self.lanes.widest_margin();
        ((lower - margin).max(0.0), upper + margin)
    }

    pub fn reset(&mut self) {
        self.open.clear();
        self.lower.clear();
        self.lower.resize(self.count * self.count, f64::INFINITY);
        self.upper.clear();
        self.upper.resize(self.count * self.count, f64::INFINITY);
        self.components.reset(self.count);
        self.nodes = 0;
    }

    fn add(&mut self, maps: Maps<L>, norm: f64, parent: u32, letter: u8) {
        let m = maps[0].linear;
        let size = 0.5 * (m.x_axis.length_squared() + m.y_axis.length_squared());
        let bows = bows(&maps.map(|map| map.translation));
        let sag = self.lanes.sag(&maps);
        self.parts.push(Part { maps, norm, bows, sag, size, parts: 0, parent, letter });
    }

    /// The word of a piece, its first letter first.
    pub fn word(&self, mut piece: u32) -> Vec<u8> {
        let mut word = Vec::new();
        loop {
            let Part { parent, letter, .. } = self.parts[piece as usize];
            word.push(letter);
            if parent == piece {
                break;
            }
            piece = parent;
        }
        word.reverse();
        word
    }

    /// Proves the attractors of the whole box disconnected: a lower bound of their widest gap, in the lanes'
    /// units, or `None` if that is not seen within `budget` looks.
    ///
    /// Pieces that come nearer than `narrow`, relative to the diameter, are not told apart: pieces on both sides of
    /// the widest gap are farther.
    pub fn separate(&mut self, narrow: f64, budget: usize) -> Option<f64> {
        self.narrow = (narrow * self.diameter().1).max(self.lanes.rounding);
        self.reset();
        for i in 0..self.count {
            for j in i + 1..self.count {
                if !self.file(i as u32, j as u32, i as u8, j as u8) && self.components.count() == 1 {
                    return None;
                }
            }
        }
        self.open.sort_unstable_by(|a, b| b.overlap.total_cmp(&a.overlap));
        while let Some(couple) = self.open.pop() {
            let Couple { u, v, i, j, .. } = couple;
            if self.components.joined(usize::from(i), usize::from(j)) {
                continue;
            }
            if self.nodes >= budget {
                return None;
            }
            let (parts, first) = self.parts_of_larger(u, v);
            let before = self.open.len();
            for part in parts {
                let (u, v) = if first { (part, v) } else { (u, part) };
                if !self.file(u, v, i, j) {
                    break;
                }
            }
            if self.components.count() == 1 {
                return None;
            }
            self.open[before..].sort_unstable_by(|a, b| b.overlap.total_cmp(&a.overlap));
        }
        let across = |k: &usize| !self.components.joined(k / self.count, k % self.count);
        let upper = (0..self.count * self.count).filter(|k| k / self.count < k % self.count);
        Some(upper.filter(across).map(|k| self.lower[k]).fold(f64::INFINITY, f64::min))
    }

    /// Files a pair as apart or as open; `false` if the two attractorlets come too near to be told apart over the
    /// box, which counts as meeting.
    fn file(&mut self, u: u32, v: u32, i: u8, j: u8) -> bool {
        let sight = self.look(u, v);
        let k = usize::from(i) * self.count + usize::from(j);
        if sight.apart > 0.0 {
            self.lower[k] = lesser(self.lower[k], sight.apart);
        } else if sight.near <= self.narrow {
            self.components.join(usize::from(i), usize::from(j));
            return false;
        } else {
            self.open.push(Couple { overlap: sight.overlap, u, v, i, j });
        }
        true
    }

    /// The parts of the larger of two pieces, and whether that is the first.
    pub fn parts_of_larger(&mut self, u: u32, v: u32) -> (Range<u32>, bool) {
        let first = self.parts[u as usize].size >= self.parts[v as usize].size;
        (self.parts_of(if first { u } else { v }), first)
    }

    pub fn parts_of(&mut self, piece: u32) -> Range<u32> {
        let large = piece as usize;
        if self.parts[large].parts == 0 {
            self.parts[large].parts = self.parts.len() as u32;
            let Part { maps: whole, norm, .. } = self.parts[large];
            for k in 0..self.count {
                let maps = std::array::from_fn(|l| whole[l] * self.lanes.maps[k][l]);
                self.add(maps, norm * self.lanes.norms[k], piece, k as u8);
            }
        }
        let parts = self.parts[large].parts;
        parts..parts + self.count as u32
    }

    /// The margin of what is linear in a point of each of two pieces, along a direction.
    #[inline]
    fn margin(&self, a: &Part<L>, b: &Part<L>, normal: DVec2) -> f64 {
        let length = normal.length();
        let along = (0..2).map(|row| normal.dot(b.bows[row] - a.bows[row])).fold(f64::NEG_INFINITY, larger);
        self.lanes.margin(along / length + a.sag + b.sag)
    }

    /// Looks at two pieces: as [`Metric::look`](crate::gap::piece_distance::Metric::look), in all lanes along the
    /// same directions.
    #[inline]
    pub fn look(&mut self, u: u32, v: u32) -> Sight {
        self.nodes += 1;
        let (part_a, part_b) = (&self.parts[u as usize], &self.parts[v as usize]);
        let (a, b) = (&part_a.maps, &part_b.maps);
        let mut step = DVec2::ZERO;
        for l in 0..L {
            step += b[l].translation - a[l].translation;
        }
        let mut best =
            Sight { apart: 0.0, overlap: f64::INFINITY, reach: f64::INFINITY, near: f64::INFINITY };
        for round in 0..DIRECTIONS_PER_PAIR {
            let normal = step;
            // The square of a shorter one has lost digits: it shows nothing.
            if normal.length_squared() < LEAST_SQUARE {
                return best;
            }
            let (mut apart, mut middles, mut reaches) = (f64::INFINITY, 0.0, 0.0);
            let (mut far_a, mut far_b) = (0, 0);
            for l in 0..L {
                let (h_a, number_a) = self.fan.support(a[l].linear.transpose() * normal, l);
                let (h_b, number_b) = self.fan.support(-(b[l].linear.transpose() * normal), l);
                let along = normal.dot(b[l].translation - a[l].translation);
                apart = lesser(apart, along - (h_a + h_b));
                middles += along;
                reaches += h_a + h_b;
                if l == 0 {
                    (far_a, far_b) = (number_a, number_b);
                }
            }
            let mut steps = [DVec2::ZERO; L];
            let (mut most, mut least, mut between) = (0.0_f64, f64::INFINITY, DVec2::ZERO);
            for l in 0..L {
                steps[l] = b[l].apply(self.fan.point(far_b, l)) - a[l].apply(self.fan.point(far_a, l));
                let squared = steps[l].length_squared();
                most = larger(most, squared);
                least = lesser(least, squared);
                between += steps[l];
            }
            best.near = lesser(best.near, least.sqrt());
            let bow = bows(&steps).map(DVec2::length);
            best.reach = lesser(best.reach, most.sqrt() + self.lanes.margin(larger(bow[0], bow[1])));
            if apart > 0.0 {
                best.apart = apart / normal.length() - self.margin(part_a, part_b, normal);
                if best.apart > 0.0 {
                    return best;
                }
            }
            best.overlap = lesser(best.overlap, middles / reaches);
            if round + 1 < DIRECTIONS_PER_PAIR {
                let turn = step - between;
                let length = turn.length_squared();
                if length == 0.0 {
                    return best;
                }
                step -= turn * (normal.dot(turn) / length).clamp(0.0, 1.0);
            }
        }
        best
    }
}
