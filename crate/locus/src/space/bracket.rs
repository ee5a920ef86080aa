//! How near the pieces of an attractor of space come.

use frond_core::{Affine3, SupportTable3};
use glam::DVec3;

use crate::gap::pairs::{Near, Pairs, Parts, Sight, Widest};
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

/// What is known of all pairs of attractorlets; points are in the frame, distances in space.
#[derive(Clone, Debug, Default)]
pub(crate) struct Closest {
    pieces: Vec<Piece>,
    pairs: Pairs<DVec3>,
}

/// Directions tried on a pair.
const DIRECTIONS_PER_PAIR: usize = 4;

impl Closest {
    /// Starts with the attractorlets of a frame.
    pub fn begin(&mut self, frame: &Frame3, table: &SupportTable3) {
        let count = frame.maps.len();
        self.pieces.clear();
        self.pairs.begin(count);
        let mut looking = Looking { frame, table, pieces: &mut self.pieces };
        for &map in &frame.maps {
            looking.add(map);
        }
        for i in 0..count {
            for j in i + 1..count {
                let pair = i * count + j;
                if frame.maps[i] == frame.maps[j] {
                    let at = frame.maps[i].apply(table.points()[0]);
                    self.pairs.meet(pair, Near { reach: 0.0, points: [at; 2] });
                } else {
                    looking.file(&mut self.pairs, pair, [i as u32, j as u32]);
                }
            }
        }
    }

    /// Bounds of the widest edge of the minimum spanning tree, as [`Pairs::bracket`].
    pub fn bracket(
        &mut self,
        frame: &Frame3,
        table: &SupportTable3,
        resolution: f64,
        within: f64,
        budget: usize,
    ) -> Widest {
        let mut looking = Looking { frame, table, pieces: &mut self.pieces };
        self.pairs.bracket(&mut looking, resolution, within, budget)
    }

    /// Looks at one pair of attractorlets until it is known whether they come as near as `resolution`: whether they do.
    pub fn settle(
        &mut self,
        frame: &Frame3,
        table: &SupportTable3,
        pair: usize,
        resolution: f64,
        budget: usize,
    ) -> bool {
        let mut looking = Looking { frame, table, pieces: &mut self.pieces };
        self.pairs.settle(&mut looking, pair, resolution, budget)
    }

    /// The nearest points known of two attractorlets.
    pub fn near(&self, pair: usize) -> Near<DVec3> {
        self.pairs.near(pair)
    }

    /// Pairs of pieces looked at.
    pub const fn nodes(&self) -> usize {
        self.pairs.nodes
    }
}

/// The pieces of a frame, by number.
struct Looking<'a> {
    frame: &'a Frame3,
    table: &'a SupportTable3,
    pieces: &'a mut Vec<Piece>,
}

impl Parts<DVec3> for Looking<'_> {
    fn split(&mut self, pairs: &mut Pairs<DVec3>, pair: usize, [u, v]: [u32; 2]) {
        let first = self.pieces[u as usize].size >= self.pieces[v as usize].size;
        let large = if first { u } else { v } as usize;
        if self.pieces[large].parts == 0 {
            self.pieces[large].parts = self.pieces.len() as u32;
            let whole = self.pieces[large].map;
            for &map in &self.frame.maps {
                self.add(whole * map);
            }
        }
        let begin = self.pieces[large].parts;
        for part in begin..begin + self.frame.maps.len() as u32 {
            self.file(pairs, pair, if first { [part, v] } else { [u, part] });
        }
    }
}

impl Looking<'_> {
    fn add(&mut self, map: Affine3) {
        let m = self.frame.linear * map.linear;
        let size = (m.x_axis.length_squared() + m.y_axis.length_squared() + m.z_axis.length_squared()).sqrt();
        self.pieces.push(Piece { map, size, parts: 0 });
    }

    /// Looks at two pieces of a pair of attractorlets, and keeps them if they may hold the two nearest points.
    fn file(&self, pairs: &mut Pairs<DVec3>, pair: usize, parts: [u32; 2]) {
        pairs.nodes += 1;
        let Self { frame, table, pieces } = self;
        let [first, second] = parts.map(|k| pieces[k as usize]);
        let (a, b) = (first.map, second.map);
        let off = frame.rounding * frame.stretch;
        let mut step = b.translation - a.translation;
        if step == DVec3::ZERO {
            step = DVec3::X;
        }
        let (mut lower, mut depth, mut reach) = (f64::NEG_INFINITY, 0.0_f64, f64::INFINITY);
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
            let points = [a.apply(point_a), b.apply(point_b)];
            let between = points[1] - points[0];
            let distance = (frame.linear * between).length() + 2.0 * off;
            reach = reach.min(distance);
            pairs.meet(pair, Near { reach: distance, points });
            if lower > pairs.near(pair).reach {
                break;
            }
            if round + 1 < DIRECTIONS_PER_PAIR {
                // Towards the least point of the difference of the two (Frank & Wolfe 1956).
                let turn = step - between;
                let size = turn.dot(frame.metric * turn);
                if size <= 0.0 {
                    break;
                }
                step -= turn * (normal.dot(turn) / size).clamp(0.0, 1.0);
            }
        }
        let sight = Sight { lower, depth, size: first.size.max(second.size), reach };
        pairs.keep(pair, parts, &sight, off);
    }
}
