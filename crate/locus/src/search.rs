//! Descent on pairs of words: which pieces meet, and how far the others are apart.
//!
//! A pair of words stands for the two pieces of the attractor that they name, one in each of two
//! attractorlets. Support functions bound the distance between the two from below, two points of the
//! attractor bound it from above. Pairs that are neither apart nor small are split at the larger
//! piece. First the pairs that are not yet known to be apart are pursued, depth first, those that overlap
//! most before their sisters: it ends with a verdict. Then the others, nearest first, which is Kruskal's algorithm on the distances between
//! pieces: it ends with the widest edge of their least spanning tree.

use std::collections::BinaryHeap;
use std::ops::Range;

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::graph::Components;
use crate::look::{Gauge, Look};
use crate::outline::Outline;
use crate::pair::{Nearest, Pair, Piece};

/// What a descent needs, kept for the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct Search {
    pieces: Vec<Piece>,
    /// Pairs that may meet: a stack.
    pub open: Vec<Pair>,
    /// Pairs passed over since their attractorlets were in one component already.
    pub later: Vec<Pair>,
    /// Pairs that are apart.
    pub apart: Vec<Pair>,
    /// The same while they are taken in the order of their distances.
    pub by_distance: BinaryHeap<Pair>,
    pub nearest: Vec<Nearest>,
    pub components: Components,
    /// Pairs of pieces looked at.
    pub nodes: usize,
    pub count: usize,
    pub gauge: Gauge,
    metric: DMat2,
    rounding: f64,
    /// The largest factor by which a distance of the frame grows in the plane.
    pub stretch: f64,
    /// The diameter of the attractor in the frame, and in the plane.
    diameter: f64,
    pub plane_diameter: f64,
    /// Pieces within this distance touch.
    pub resolution: f64,
}

impl Search {
    /// Starts a descent: every two attractorlets that differ are looked at once.
    ///
    /// `epsilon` is relative to the diameter of the attractor.
    pub fn begin(&mut self, frame: &Frame, outline: &Outline, epsilon: f64) {
        let count = frame.maps.len();
        self.count = count;
        self.metric = frame.metric;
        self.gauge = Gauge::to_separate(frame);
        self.rounding = frame.rounding;
        self.diameter = outline.diameter(DMat2::IDENTITY);
        self.plane_diameter = outline.diameter(frame.from_round);
        self.pieces.clear();
        self.open.clear();
        self.apart.clear();
        self.by_distance.clear();
        self.nearest.clear();
        self.later.clear();
        let unknown = Nearest { reach: f64::INFINITY, from: DVec2::ZERO, to: DVec2::ZERO, met: false };
        self.nearest.resize(count * count, unknown);
        self.components.reset(count);
        self.nodes = 0;
        self.stretch = Affine2::new(frame.from_round, DVec2::ZERO).norm();
        // No finer than rounding lets one see, unless rounding has become coarse itself.
        let seen = (4.0 * self.rounding * self.stretch).min(1e-9 * self.plane_diameter);
        self.resolution = (epsilon * self.plane_diameter).max(seen);
        for &map in &frame.maps {
            self.add(map);
        }
        for i in 0..count {
            for j in i + 1..count {
                if frame.maps[i] == frame.maps[j] {
                    // The same piece twice.
                    self.nearest[i * count + j].reach = 0.0;
                    self.meet(i, j);
                } else {
                    let look = self.look(outline, i as u32, j as u32);
                    if !self.note(&look, i as u8, j as u8) {
                        self.file(&look, Pair { key: 0.0, u: i as u32, v: j as u32, i: i as u8, j: j as u8 });
                    }
                }
            }
        }
        self.open.sort_unstable();
    }

    fn add(&mut self, map: Affine2) {
        let m = map.linear;
        let size = 0.5 * (m.x_axis.dot(self.metric * m.x_axis) + m.y_axis.dot(self.metric * m.y_axis));
        self.pieces.push(Piece { map, size, parts: 0 });
    }

    /// Pursues the pairs that are not known to be apart until all pieces are in one component, or none
    /// of these pairs is left; `false` if `budget` looks did not suffice.
    pub fn settle(&mut self, frame: &Frame, outline: &Outline, budget: usize) -> bool {
        while self.components.count() > 1 {
            let Some(pair) = self.open.pop() else { return true };
            if self.components.joined(usize::from(pair.i), usize::from(pair.j)) {
                self.later.push(pair);
            } else if !self.pursue(frame, outline, pair, budget) {
                return false;
            }
        }
        true
    }

    /// Goes on where [`Search::settle`] ended, until of every two attractorlets it is known whether they meet.
    pub fn settle_all(&mut self, frame: &Frame, outline: &Outline, budget: usize) -> bool {
        self.open.append(&mut self.later);
        while let Some(pair) = self.open.pop() {
            let met = self.nearest[usize::from(pair.i) * self.count + usize::from(pair.j)].met;
            if !met && !self.pursue(frame, outline, pair, budget) {
                return false;
            }
        }
        true
    }

    /// Decides a pair, or splits it; `false`, leaving it open, if the budget is spent.
    fn pursue(&mut self, frame: &Frame, outline: &Outline, pair: Pair, budget: usize) -> bool {
        if self.is_small(pair) && self.rounding * self.stretch <= self.resolution {
            self.meet(usize::from(pair.i), usize::from(pair.j));
        } else if self.nodes >= budget {
            self.open.push(pair);
            return false;
        } else {
            self.split(frame, outline, pair, 0.0);
        }
        true
    }

    /// The components if all pairs that are still open should meet: pieces in different ones are proved apart.
    pub fn coarsest(&self) -> Components {
        let mut components = self.components.clone();
        for pair in self.open.iter().chain(&self.later) {
            components.join(usize::from(pair.i), usize::from(pair.j));
        }
        components
    }

    /// Pairs of attractorlets that were found to meet, `i < j`, in ascending order.
    pub fn overlaps(&self) -> Vec<(usize, usize)> {
        let all = self.nearest.iter().enumerate().filter(|(_, nearest)| nearest.met);
        all.map(|(k, _)| (k / self.count, k % self.count)).collect()
    }

    /// The same, and those that are not known to be apart.
    pub fn may_meet(&self) -> Vec<(usize, usize)> {
        let open = self.open.iter().chain(&self.later).map(|pair| (usize::from(pair.i), usize::from(pair.j)));
        let mut pairs: Vec<_> = self.overlaps().into_iter().chain(open).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    /// Whether both pieces together are no larger than the resolution.
    fn is_small(&self, pair: Pair) -> bool {
        let limit = self.resolution / self.diameter;
        let limit = limit * limit;
        let (u, v) = (&self.pieces[pair.u as usize], &self.pieces[pair.v as usize]);
        // The larger stretch is between one and 1.42 times the mean square one.
        if u.size + v.size > limit {
            return false;
        }
        let stretch = |piece: &Piece| {
            let m = piece.map.linear;
            let (x, y) = (self.metric * m.x_axis, self.metric * m.y_axis);
            let (xx, xy, yy) = (m.x_axis.dot(x), m.x_axis.dot(y), m.y_axis.dot(y));
            (f64::midpoint(xx, yy) + (0.5 * (xx - yy)).hypot(xy)).sqrt()
        };
        let sum = stretch(u) + stretch(v);
        sum * sum <= limit
    }

    /// Splits the larger piece of a pair, known to be `apart`, and looks at the pairs of its parts.
    pub fn split(&mut self, frame: &Frame, outline: &Outline, pair: Pair, apart: f64) {
        let Pair { u, v, i, j, .. } = pair;
        let (parts, first) = self.parts_of_larger(frame, u, v);
        let before = self.open.len();
        for part in parts {
            let (u, v) = if first { (part, v) } else { (u, part) };
            let look = self.look(outline, u, v);
            if self.note(&look, i, j) {
                return;
            }
            self.file(&look, Pair { key: apart, u, v, i, j });
        }
        self.open[before..].sort_unstable();
    }

    /// The parts of the larger one of two pieces, and whether that is the first.
    pub fn parts_of_larger(&mut self, frame: &Frame, u: u32, v: u32) -> (Range<u32>, bool) {
        let first = self.pieces[u as usize].size >= self.pieces[v as usize].size;
        let large = if first { u } else { v } as usize;
        if self.pieces[large].parts == 0 {
            self.pieces[large].parts = self.pieces.len() as u32;
            let whole = self.pieces[large].map;
            for &map in &frame.maps {
                self.add(whole * map);
            }
        }
        let parts = self.pieces[large].parts;
        (parts..parts + self.count as u32, first)
    }

    /// Takes note of how near two attractorlets come; whether that makes them meet.
    #[inline]
    pub fn note(&mut self, look: &Look, i: u8, j: u8) -> bool {
        self.nodes += 1;
        let (i, j) = (usize::from(i), usize::from(j));
        let nearest = &mut self.nearest[i * self.count + j];
        if look.reach < nearest.reach {
            *nearest = Nearest { reach: look.reach, from: look.from, to: look.to, met: nearest.met };
            if look.reach.sqrt() <= self.resolution {
                self.meet(i, j);
                return true;
            }
        }
        false
    }

    /// Files a pair with those that are apart, by its distance, or with those that may meet, by how deep they
    /// overlap. Its key is the distance of the pair that it is a part of: parts are no nearer than that, even
    /// if the directions tried on them show less.
    #[inline]
    fn file(&mut self, look: &Look, mut pair: Pair) {
        pair.key = look.apart.max(pair.key);
        if pair.key > 0.0 {
            self.apart.push(pair);
        } else {
            pair.key = look.overlap;
            self.open.push(pair);
        }
    }

    /// Records that two attractorlets `i < j` meet, as far as the resolution tells.
    pub fn meet(&mut self, i: usize, j: usize) {
        self.components.join(i, j);
        self.nearest[i * self.count + j].met = true;
    }

    /// Looks at two pieces.
    #[inline]
    pub fn look(&self, outline: &Outline, u: u32, v: u32) -> Look {
        self.gauge.look(outline, &self.pieces[u as usize].map, &self.pieces[v as usize].map)
    }
}
