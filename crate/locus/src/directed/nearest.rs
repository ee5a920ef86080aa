//! How near the pieces of a state come: bounds of the widest edge of the minimum spanning tree.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use frond_core::{Affine2, DirectedIfs, Total};
use glam::DVec2;

use crate::directed::extent::Extent;
use crate::gap::spanning_tree::SpanningTree;

/// A piece: the copy of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    pub map: Affine2,
    /// The state that is copied.
    pub from: usize,
}

/// A piece, or a part of one.
#[derive(Clone, Copy, Debug)]
struct Part {
    piece: Piece,
    /// An upper bound of its diameter.
    size: f64,
    /// The index of its first part, 0 while it is not split.
    parts: u32,
}

/// A pair of parts of two pieces that may hold their two nearest points: a lower bound of their distance, where it is
/// positive, otherwise the less the deeper they overlap; and the parts, which ties go by.
type Open = (Total, u32, u32);

/// The nearest points known of two pieces, in the plane, and their distance with what rounding may add to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near {
    pub reach: f64,
    pub points: [DVec2; 2],
}

/// Bounds of the widest edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Widest {
    /// Above 0 only where the pieces are in several parts.
    pub lower: f64,
    pub upper: f64,
    /// The ends of the edge that has `upper`.
    pub ends: Option<[DVec2; 2]>,
}

/// What is known of all pairs of pieces of a state.
pub(crate) struct Nearest<'a> {
    system: &'a DirectedIfs,
    extents: &'a [Extent],
    /// How far computed points of the pieces may be off.
    off: f64,
    count: usize,
    parts: Vec<Part>,
    /// Of each pair `i < j`, at `i * count + j`.
    open: Vec<BinaryHeap<Reverse<Open>>>,
    near: Vec<Near>,
    /// A lower bound of the distances in pairs that are too small to be split.
    floor: Vec<f64>,
    tree: SpanningTree,
    /// Pairs of parts looked at.
    pub nodes: usize,
}

/// Directions tried on a pair.
const DIRECTIONS_PER_PAIR: usize = 4;

impl<'a> Nearest<'a> {
    /// Starts with these pieces of a state.
    pub fn begin(system: &'a DirectedIfs, extents: &'a [Extent], state: usize, pieces: &[Piece]) -> Self {
        let count = pieces.len();
        let pairs = count * count;
        let unknown = Near { reach: f64::INFINITY, points: [DVec2::ZERO; 2] };
        let mut this = Self {
            system,
            extents,
            off: extents[state].off,
            count,
            parts: Vec::new(),
            open: vec![BinaryHeap::new(); pairs],
            near: vec![unknown; pairs],
            floor: vec![f64::INFINITY; pairs],
            tree: SpanningTree::default(),
            nodes: 0,
        };
        for &piece in pieces {
            this.add(piece);
        }
        for i in 0..count {
            for j in i + 1..count {
                let pair = i * count + j;
                if pieces[i] == pieces[j] {
                    let at = pieces[i].map.apply(extents[pieces[i].from].points[0]);
                    this.near[pair] = Near { reach: 0.0, points: [at; 2] };
                } else {
                    this.file(pair, i as u32, j as u32);
                }
            }
        }
        this
    }

    /// Bounds of the widest edge, refined until the upper one is at most `resolution`, or the lower one is positive
    /// and within `within` of the upper, or so many pairs were looked at.
    pub fn bracket(&mut self, resolution: f64, within: f64, budget: usize) -> Widest {
        let mut fresh = true;
        let mut widest = Widest { lower: 0.0, upper: f64::INFINITY, ends: None };
        if self.count < 2 {
            return Widest { upper: 0.0, ..widest };
        }
        loop {
            if fresh {
                let Self { tree, near, count, .. } = self;
                widest.upper = tree.cut(*count, |i, j| {
                    let (i, j) = (usize::from(i.min(j)), usize::from(i.max(j)));
                    near[i * *count + j].reach
                });
                widest.ends = self.ends(widest.upper);
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
            if !self.refine(pair) {
                return widest;
            }
            fresh = self.near[pair].reach < before;
        }
    }

    /// Looks at one pair of pieces until it is known whether they come as near as `resolution`: whether they do.
    pub fn settle(&mut self, i: usize, j: usize, resolution: f64, budget: usize) -> bool {
        let pair = i * self.count + j;
        while self.near[pair].reach > resolution
            && self.lower(pair) <= resolution
            && self.nodes < budget
            && self.refine(pair)
        {}
        self.near[pair].reach <= resolution
    }

    /// A lower bound of the distance of two pieces; negative or 0 where they may meet.
    fn lower(&self, pair: usize) -> f64 {
        let reach = self.near[pair].reach;
        self.open[pair].peek().map_or(reach, |Reverse((lower, ..))| lower.0.min(reach)).min(self.floor[pair])
    }

    fn ends(&self, upper: f64) -> Option<[DVec2; 2]> {
        let pairs = (0..self.near.len()).filter(|pair| pair / self.count < pair % self.count);
        pairs
            .filter(|pair| self.tree.beyond[pair / self.count] != self.tree.beyond[pair % self.count])
            .find(|&pair| self.near[pair].reach == upper)
            .map(|pair| self.near[pair].points)
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

    /// Splits the larger part of the most promising pair of two pieces; `false` if none is left.
    fn refine(&mut self, pair: usize) -> bool {
        let Some(Reverse((_, u, v))) = self.open[pair].pop() else { return false };
        let first = self.parts[u as usize].size >= self.parts[v as usize].size;
        let large = if first { u } else { v };
        let whole = self.parts[large as usize];
        let maps = &self.system.states()[whole.piece.from];
        let begin = if whole.parts == 0 { self.parts.len() as u32 } else { whole.parts };
        if whole.parts == 0 {
            self.parts[large as usize].parts = begin;
            for part in maps {
                self.add(Piece { map: whole.piece.map * part.map, from: part.from });
            }
        }
        for part in begin..begin + maps.len() as u32 {
            let (u, v) = if first { (part, v) } else { (u, part) };
            self.file(pair, u, v);
        }
        true
    }

    fn add(&mut self, piece: Piece) {
        let size = piece.map.norm() * self.extents[piece.from].diameter;
        self.parts.push(Part { piece, size, parts: 0 });
    }

    /// Looks at two parts of a pair of pieces, and keeps them if they may hold the two nearest points.
    fn file(&mut self, pair: usize, u: u32, v: u32) {
        self.nodes += 1;
        let [first, second] = [u, v].map(|k| self.parts[k as usize]);
        let (a, b) = (first.piece.map, second.piece.map);
        let [inner_a, inner_b] = [first, second].map(|part| &self.extents[part.piece.from]);
        let middle = |map: Affine2, extent: &Extent| map.apply(extent.points[0]);
        let mut step = middle(b, inner_b) - middle(a, inner_a);
        let (mut lower, mut depth) = (f64::NEG_INFINITY, 0.0_f64);
        let near = &mut self.near[pair];
        for round in 0..DIRECTIONS_PER_PAIR {
            let normal = step.try_normalize().unwrap_or(DVec2::X);
            let (pulled_a, pulled_b) = (a.linear.transpose() * normal, -(b.linear.transpose() * normal));
            let (far_a, far_b) = (inner_a.support(pulled_a), inner_b.support(pulled_b));
            let along = normal.dot(b.translation - a.translation);
            // Outward: a few roundings of numbers of this size, and what pieces may be off.
            let rounded = 16.0 * f64::EPSILON * (along.abs() + far_a.abs() + far_b.abs());
            let apart = along - far_a - far_b - rounded - 2.0 * self.off;
            lower = lower.max(apart);
            depth =
                depth.max(1.0 + (along - far_a - far_b) / (first.size + second.size).max(f64::MIN_POSITIVE));
            let points = [a.apply(inner_a.farthest(pulled_a)), b.apply(inner_b.farthest(pulled_b))];
            let between = points[1] - points[0];
            let reach = between.length() + 2.0 * self.off;
            if reach < near.reach {
                *near = Near { reach, points };
            }
            if lower > near.reach {
                return;
            }
            if round + 1 < DIRECTIONS_PER_PAIR {
                // Towards the least point of the difference of the two (Frank & Wolfe 1956).
                let turn = step - between;
                let size = turn.length_squared();
                if size <= 0.0 {
                    break;
                }
                step -= turn * (step.dot(turn) / size).clamp(0.0, 1.0);
            }
        }
        let key = if lower > 0.0 { lower } else { depth.clamp(0.0, 1.0) - 1.0 };
        if key > near.reach {
            return;
        }
        // Smaller than rounding there is nothing to see.
        if first.size.max(second.size) > 0.25 * self.off {
            self.open[pair].push(Reverse((Total(key), u, v)));
        } else {
            // As far as floating point tells each is a point.
            self.floor[pair] = self.floor[pair].min(key);
            if lower <= 0.0 {
                near.reach = near.reach.min(4.0 * self.off);
            }
        }
    }
}
