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

use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::gap::pair::{Nearest, Pair};
use crate::gap::piece_distance::{Gauge, Looks};
use crate::gap::word_tree::Pieces;
use crate::overlap_graph::Components;
use crate::support::table::Outline;

/// What a descent needs, kept for the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct Search {
    pub pieces: Pieces,
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
    rounding: f64,
    /// See [`Frame::stretch`].
    stretch: f64,
    /// See [`Frame::off`]: in coordinates of the plane. In others, which flat shapes need, it says so much too much that no
    /// narrow gap would have an upper bound, and is left out.
    pub off: f64,
    /// The diameter of the attractor in the frame, and in the plane.
    diameter: f64,
    pub plane_diameter: f64,
    /// Pieces within this distance touch.
    pub resolution: f64,
    /// Points that are computed to be within this distance are within the resolution, whatever rounding may add.
    near: f64,
}

impl Search {
    /// Starts a descent: every two attractorlets that differ are looked at once.
    ///
    /// `epsilon` is relative to the diameter of the attractor.
    pub fn begin(&mut self, frame: &Frame, outline: &Outline, epsilon: f64) {
        let count = frame.maps.len();
        self.count = count;
        self.gauge = Gauge::to_separate(frame);
        self.rounding = frame.rounding;
        self.diameter = outline.diameter(DMat2::IDENTITY);
        self.plane_diameter = frame.diameter(outline.diameter(frame.from_round));
        self.pieces.begin(frame);
        self.open.clear();
        self.apart.clear();
        self.by_distance.clear();
        self.nearest.clear();
        self.later.clear();
        let unknown = Nearest { reach: f64::INFINITY, from: DVec2::ZERO, to: DVec2::ZERO, met: false };
        self.nearest.resize(count * count, unknown);
        self.components.reset(count);
        self.nodes = 0;
        self.stretch = frame.stretch;
        self.off = if frame.plain { frame.off() } else { 0.0 };
        self.resolution = frame.resolution(epsilon, self.plane_diameter);
        self.near = (self.resolution - self.off).max(0.5 * self.resolution);
        for i in 0..count {
            for first in (i + 1..count).step_by(4) {
                let pairs = first..count.min(first + 4);
                let looks = self.look(outline, pairs.start as u32..pairs.end as u32, i as u32);
                for (k, j) in pairs.enumerate() {
                    let pair = Pair { key: 0.0, u: i as u32, v: j as u32, i: i as u8, j: j as u8 };
                    if frame.maps[i] == frame.maps[j] {
                        // The same piece twice.
                        self.nearest[i * count + j].reach = 0.0;
                        self.meet(i, j);
                    } else if !self.note(&looks, k, false, pair.i, pair.j) {
                        self.file(&looks, k, pair);
                    }
                }
            }
        }
        self.open.sort_unstable();
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
        if self.pieces.are_small(pair.u, pair.v, self.near / self.diameter)
            && self.rounding * self.stretch <= self.resolution
        {
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

    /// The same, and those that are not known to be apart.
    pub fn may_meet(&self) -> Vec<(usize, usize)> {
        let open = self.open.iter().chain(&self.later).map(|pair| (usize::from(pair.i), usize::from(pair.j)));
        let mut pairs: Vec<_> = self.overlaps().into_iter().chain(open).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    /// Pairs of attractorlets that were found to meet, `i < j`, in ascending order.
    pub fn overlaps(&self) -> Vec<(usize, usize)> {
        let all = self.nearest.iter().enumerate().filter(|(_, nearest)| nearest.met);
        all.map(|(k, _)| (k / self.count, k % self.count)).collect()
    }

    /// Splits the larger piece of a pair, known to be `apart`, and looks at the pairs of its parts.
    pub fn split(&mut self, frame: &Frame, outline: &Outline, pair: Pair, apart: f64) {
        let Pair { u, v, i, j, .. } = pair;
        let (parts, first) = self.pieces.parts_of_larger(frame, u, v);
        let other = if first { v } else { u };
        let before = self.open.len();
        for four in parts.clone().step_by(4) {
            let four = four..parts.end.min(four + 4);
            let looks = self.look(outline, four.clone(), other);
            for (k, part) in four.enumerate() {
                if self.note(&looks, k, first, i, j) {
                    return;
                }
                let (u, v) = if first { (part, v) } else { (u, part) };
                self.file(&looks, k, Pair { key: apart, u, v, i, j });
            }
        }
        self.open[before..].sort_unstable();
    }

    /// Takes note of how near two attractorlets come: of look `k`, at parts of the `first` of them or of the
    /// second; whether that makes them meet.
    #[inline]
    pub fn note(&mut self, looks: &Looks, k: usize, first: bool, i: u8, j: u8) -> bool {
        self.nodes += 1;
        let (i, j) = (usize::from(i), usize::from(j));
        let nearest = &mut self.nearest[i * self.count + j];
        let reach = looks.reach[k];
        if reach < nearest.reach {
            let (part, other) = looks.points(k);
            let (from, to) = if first { (part, other) } else { (other, part) };
            *nearest = Nearest { reach, from, to, met: nearest.met };
            if reach.sqrt() <= self.near {
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
    fn file(&mut self, looks: &Looks, k: usize, mut pair: Pair) {
        pair.key = looks.apart[k].max(pair.key);
        if pair.key > 0.0 {
            self.apart.push(pair);
        } else {
            pair.key = looks.overlap[k];
            self.open.push(pair);
        }
    }

    /// From here on no two attractorlets are found to meet, however near they come.
    pub fn stop_joining(&mut self) {
        (self.resolution, self.near) = (-1.0, -1.0);
    }

    /// Records that two attractorlets `i < j` meet, as far as the resolution tells.
    pub fn meet(&mut self, i: usize, j: usize) {
        self.components.join(i, j);
        self.nearest[i * self.count + j].met = true;
    }

    /// Looks at one to four pieces, each against the other.
    pub fn look(&self, outline: &Outline, parts: Range<u32>, other: u32) -> Looks {
        self.gauge.look(outline, self.pieces.range(parts), &self.pieces.get(other).map)
    }
}
