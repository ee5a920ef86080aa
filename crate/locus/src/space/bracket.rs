//! How near the pieces of an attractor of space come: bounds of the widest edge of the minimum spanning tree.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use frond_core::{Affine3, SupportTable3, Total};
use glam::DVec3;

use crate::gap::spanning_tree::SpanningTree;
use crate::space::frame::Frame3;

/// One piece: the image of the attractor under the map of a word.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// The map of the word, in the frame; its translation is the middle of the piece.
    map: Affine3,
    /// The Frobenius norm of the map into space: an upper bound of its radius.
    size: f64,
    /// The index of its first part, 0 while it is not split.
    parts: u32,
}

/// A pair of pieces in two attractorlets that may hold their two nearest points: a lower bound of their distance, where
/// it is positive, otherwise the less the deeper they overlap; and the pieces, which ties go by.
type Open = (Total, u32, u32);

/// The nearest points known of two attractorlets, in the frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearest {
    /// Their distance in space, and what rounding may add to it: infinite while none are known.
    pub reach: f64,
    pub from: DVec3,
    pub to: DVec3,
}

const UNKNOWN: Nearest = Nearest { reach: f64::INFINITY, from: DVec3::ZERO, to: DVec3::ZERO };

/// What is known of all pairs of attractorlets.
#[derive(Clone, Debug, Default)]
pub(crate) struct Closest {
    pieces: Vec<Piece>,
    /// Of each pair `i < j`, at `i * count + j`.
    open: Vec<BinaryHeap<Reverse<Open>>>,
    pub nearest: Vec<Nearest>,
    /// A lower bound of the distances in pairs that are too small to be split.
    floor: Vec<f64>,
    count: usize,
    tree: SpanningTree,
    /// Pairs of pieces looked at.
    pub nodes: usize,
}

/// Bounds of the widest gap, in units of space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    /// Above 0 only where the attractor is in several pieces.
    pub lower: f64,
    pub upper: f64,
    /// The pair of attractorlets that has `upper`.
    pub widest: Option<usize>,
}

/// Directions tried on a pair.
const DIRECTIONS_PER_PAIR: usize = 4;

impl Closest {
    /// Starts with the attractorlets of a frame.
    pub fn begin(&mut self, frame: &Frame3, table: &SupportTable3) {
        self.count = frame.maps.len();
        self.nodes = 0;
        self.pieces.clear();
        for &map in &frame.maps {
            self.add(frame, map);
        }
        let pairs = self.count * self.count;
        self.open.iter_mut().for_each(BinaryHeap::clear);
        self.open.resize_with(pairs, BinaryHeap::new);
        self.nearest.clear();
        self.nearest.resize(pairs, UNKNOWN);
        self.floor.clear();
        self.floor.resize(pairs, f64::INFINITY);
        for i in 0..self.count {
            for j in i + 1..self.count {
                let pair = i * self.count + j;
                if frame.maps[i] == frame.maps[j] {
                    let at = frame.maps[i].apply(table.points()[0]);
                    self.nearest[pair] = Nearest { reach: 0.0, from: at, to: at };
                } else {
                    self.file(frame, table, pair, i as u32, j as u32);
                }
            }
        }
    }

    /// Bounds of the widest edge of the minimum spanning tree, refined until the upper one is at most `resolution`,
    /// or the lower one is positive and within `within` of the upper, or so many pairs of pieces were looked at.
    ///
    /// Any cut of the pieces into two sets bounds the edge from below by the least distance across it; the cut at the
    /// widest edge of the tree of upper bounds is the one that tells most.
    pub fn bracket(
        &mut self,
        frame: &Frame3,
        table: &SupportTable3,
        resolution: f64,
        within: f64,
        budget: usize,
    ) -> Bracket {
        let mut fresh = true;
        let mut bracket = Bracket { lower: 0.0, upper: f64::INFINITY, widest: None };
        loop {
            if fresh {
                bracket.upper = self.grow();
                bracket.widest = self.widest(bracket.upper);
                if bracket.upper <= resolution {
                    bracket.lower = 0.0;
                    return bracket;
                }
            }
            let (pair, lower) = self.across();
            bracket.lower = lower.clamp(0.0, bracket.upper);
            let close = lower > 0.0 && bracket.upper - lower <= within * bracket.upper;
            if close || self.nodes >= budget {
                return bracket;
            }
            let before = self.nearest[pair].reach;
            if !self.refine(frame, table, pair) {
                return bracket;
            }
            fresh = self.nearest[pair].reach < before;
        }
    }

    /// Looks at one pair of attractorlets until it is known whether they come as near as `resolution`.
    pub fn settle(
        &mut self,
        frame: &Frame3,
        table: &SupportTable3,
        pair: usize,
        resolution: f64,
        budget: usize,
    ) {
        while self.nearest[pair].reach > resolution
            && self.lower(pair) <= resolution
            && self.nodes < budget
            && self.refine(frame, table, pair)
        {}
    }

    /// A lower bound of the distance of two attractorlets; negative or 0 where they may meet.
    pub fn lower(&self, pair: usize) -> f64 {
        let reach = self.nearest[pair].reach;
        self.open[pair].peek().map_or(reach, |Reverse((lower, ..))| lower.0.min(reach)).min(self.floor[pair])
    }

    /// The widest edge of the minimum spanning tree of the upper bounds.
    fn grow(&mut self) -> f64 {
        let Self { tree, nearest, count, .. } = self;
        tree.cut(*count, |i, j| {
            let (i, j) = (usize::from(i.min(j)), usize::from(i.max(j)));
            nearest[i * *count + j].reach
        })
    }

    fn widest(&self, upper: f64) -> Option<usize> {
        let across =
            |pair: &usize| self.tree.beyond[pair / self.count] != self.tree.beyond[pair % self.count];
        let pairs = (0..self.nearest.len()).filter(|pair| pair / self.count < pair % self.count);
        pairs.filter(across).find(|&pair| self.nearest[pair].reach == upper)
    }

    /// The pair across the cut whose lower bound is least, and that bound.
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

    /// Splits the larger piece of the most promising pair of two attractorlets; `false` if none is left.
    fn refine(&mut self, frame: &Frame3, table: &SupportTable3, pair: usize) -> bool {
        let Some(Reverse((_, u, v))) = self.open[pair].pop() else { return false };
        let first = self.pieces[u as usize].size >= self.pieces[v as usize].size;
        for part in self.parts(frame, if first { u } else { v }) {
            let (u, v) = if first { (part, v) } else { (u, part) };
            self.file(frame, table, pair, u, v);
        }
        true
    }

    fn parts(&mut self, frame: &Frame3, piece: u32) -> Range<u32> {
        let large = piece as usize;
        if self.pieces[large].parts == 0 {
            self.pieces[large].parts = self.pieces.len() as u32;
            let whole = self.pieces[large].map;
            for &map in &frame.maps {
                self.add(frame, whole * map);
            }
        }
        let parts = self.pieces[large].parts;
        parts..parts + frame.maps.len() as u32
    }

    fn add(&mut self, frame: &Frame3, map: Affine3) {
        let m = frame.linear * map.linear;
        let size = (m.x_axis.length_squared() + m.y_axis.length_squared() + m.z_axis.length_squared()).sqrt();
        self.pieces.push(Piece { map, size, parts: 0 });
    }

    /// Looks at two pieces of a pair of attractorlets, and keeps them if they may hold the two nearest points.
    fn file(&mut self, frame: &Frame3, table: &SupportTable3, pair: usize, u: u32, v: u32) {
        self.nodes += 1;
        let (a, b) = (&self.pieces[u as usize].map, &self.pieces[v as usize].map);
        let off = frame.rounding * frame.stretch;
        let mut step = b.translation - a.translation;
        if step == DVec3::ZERO {
            step = DVec3::X;
        }
        let (mut lower, mut depth) = (f64::NEG_INFINITY, 0.0_f64);
        let nearest = &mut self.nearest[pair];
        for round in 0..DIRECTIONS_PER_PAIR {
            // The direction is about that of `step` in space, and a form on the frame.
            let normal = frame.metric * step;
            // That of the normal as it is, not as it would be without rounding; no shorter than it may be.
            let length = (frame.normal * normal).length() + frame.blur * normal.abs().element_sum();
            if length == 0.0 {
                break;
            }
            let (far_a, point_a) = table.support_and_point(a.linear.transpose() * normal);
            let (far_b, point_b) = table.support_and_point(-(b.linear.transpose() * normal));
            let along = normal.dot(b.translation - a.translation);
            let reaches = far_a + far_b;
            // Outward: a few roundings of numbers of this size, and what pieces may be off.
            let apart = (along - reaches - 1e-15 * (along.abs() + reaches.abs())) / length - off;
            lower = lower.max(apart);
            depth = depth.max(along / reaches.max(f64::MIN_POSITIVE));
            let (from, to) = (a.apply(point_a), b.apply(point_b));
            let reach = (frame.linear * (to - from)).length() + 2.0 * off;
            if reach < nearest.reach {
                *nearest = Nearest { reach, from, to };
            }
            if lower > nearest.reach {
                return;
            }
            if round + 1 < DIRECTIONS_PER_PAIR {
                // Towards the least point of the difference of the two (Frank & Wolfe 1956).
                let turn = step - (to - from);
                let size = turn.dot(frame.metric * turn);
                if size <= 0.0 {
                    break;
                }
                step -= turn * (normal.dot(turn) / size).clamp(0.0, 1.0);
            }
        }
        let key = if lower > 0.0 { lower } else { depth.min(1.0) - 1.0 };
        // Smaller than rounding there is nothing to see.
        let seen = self.pieces[u as usize].size.max(self.pieces[v as usize].size) > 0.25 * off;
        if key > nearest.reach {
            return;
        }
        if seen {
            self.open[pair].push(Reverse((Total(key), u, v)));
        } else {
            // As far as floating point tells each is a point.
            self.floor[pair] = self.floor[pair].min(key);
            if lower <= 0.0 {
                nearest.reach = nearest.reach.min(4.0 * off);
            }
        }
    }
}
