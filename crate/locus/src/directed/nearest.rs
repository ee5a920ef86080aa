//! How near the pieces of a state come.

use frond_core::{Affine2, DirectedIfs};
use glam::DVec2;

use crate::directed::extent::Extent;
use crate::gap::pairs::{Near, Pairs, Parts, Sight};
use crate::verdict::Gap;

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

/// Bounds of the widest edge of the minimum spanning tree.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge {
    /// Above 0 only where the pieces are in several parts.
    pub lower: f64,
    pub upper: f64,
    /// The ends of the edge that has `upper`.
    pub ends: Option<[DVec2; 2]>,
}

/// What is known of all pairs of pieces of a state.
pub(crate) struct Nearest<'a> {
    pairs: Pairs<DVec2>,
    count: usize,
    /// That of the state, at most.
    diameter: f64,
    looking: Looking<'a>,
}

/// The parts of the pieces, and what is known of the states that they are copies of.
struct Looking<'a> {
    system: &'a DirectedIfs,
    extents: &'a [Extent],
    /// How far computed points of the pieces may be off.
    off: f64,
    parts: Vec<Part>,
}

/// Directions tried on a pair.
const DIRECTIONS_PER_PAIR: usize = 4;

impl<'a> Nearest<'a> {
    /// Starts with these pieces of a state.
    pub fn begin(system: &'a DirectedIfs, extents: &'a [Extent], state: usize, pieces: &[Piece]) -> Self {
        let count = pieces.len();
        let mut pairs = Pairs::default();
        pairs.begin(count);
        let mut looking = Looking { system, extents, off: extents[state].off, parts: Vec::new() };
        for &piece in pieces {
            looking.add(piece);
        }
        for i in 0..count {
            for j in i + 1..count {
                let pair = i * count + j;
                if pieces[i] == pieces[j] {
                    let at = pieces[i].map.apply(extents[pieces[i].from].points[0]);
                    pairs.meet(pair, Near { reach: 0.0, points: [at; 2] });
                } else {
                    looking.file(&mut pairs, pair, [i as u32, j as u32]);
                }
            }
        }
        Self { pairs, count, diameter: extents[state].diameter, looking }
    }

    /// Bounds of the widest edge, as [`Pairs::bracket`]; nothing where these contradict each other.
    pub fn bracket(&mut self, resolution: f64, within: f64, budget: usize) -> Edge {
        let found = self.pairs.bracket(&mut self.looking, resolution, within, budget);
        let Some(Gap { lower, upper }) = found.gap(self.diameter) else {
            return Edge { lower: 0.0, upper: f64::INFINITY, ends: None };
        };
        Edge { lower, upper, ends: found.pair.map(|pair| self.pairs.near(pair).points) }
    }

    /// Looks at one pair of pieces until it is known whether they come as near as `resolution`: whether they do.
    pub fn settle(&mut self, i: usize, j: usize, resolution: f64, budget: usize) -> bool {
        self.pairs.settle(&mut self.looking, i * self.count + j, resolution, budget)
    }

    /// Pairs of parts looked at.
    pub const fn nodes(&self) -> usize {
        self.pairs.nodes
    }
}

impl Parts<DVec2> for Looking<'_> {
    fn split(&mut self, pairs: &mut Pairs<DVec2>, pair: usize, [u, v]: [u32; 2]) {
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
            self.file(pairs, pair, if first { [part, v] } else { [u, part] });
        }
    }
}

impl Looking<'_> {
    fn add(&mut self, piece: Piece) {
        let size = piece.map.norm() * self.extents[piece.from].diameter;
        self.parts.push(Part { piece, size, parts: 0 });
    }

    /// Looks at two parts of a pair of pieces, and keeps them if they may hold the two nearest points.
    fn file(&self, pairs: &mut Pairs<DVec2>, pair: usize, parts: [u32; 2]) {
        pairs.nodes += 1;
        let [first, second] = parts.map(|k| self.parts[k as usize]);
        let (a, b) = (first.piece.map, second.piece.map);
        let [inner_a, inner_b] = [first, second].map(|part| &self.extents[part.piece.from]);
        let middle = |map: Affine2, extent: &Extent| map.apply(extent.points[0]);
        let mut step = middle(b, inner_b) - middle(a, inner_a);
        let (mut lower, mut depth, mut reach) = (f64::NEG_INFINITY, 0.0_f64, f64::INFINITY);
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
            let distance = between.length() + 2.0 * self.off;
            reach = reach.min(distance);
            pairs.meet(pair, Near { reach: distance, points });
            if lower > pairs.near(pair).reach {
                break;
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
        let sight = Sight { lower, depth, size: first.size.max(second.size), reach };
        pairs.keep(pair, parts, &sight, self.off);
    }
}
