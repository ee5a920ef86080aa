//! Pairs of words: what a descent on an attractor looks at.

use std::ops::Range;

use crate::frame::Frame;
use crate::gap::bracket::{Explore, Part};
use crate::gap::pair::Pair;
use crate::gap::piece_distance::{Distances, Gauge};
use crate::gap::word_tree::Pieces;
use crate::support::table::Outline;

/// After so many looks a finer outline pays.
const ROUGH: usize = 150;

/// The pieces of the maps of a frame.
pub(crate) struct Words<'a> {
    pub frame: &'a Frame,
    pub outline: &'a mut Outline,
    pub pieces: &'a mut Pieces,
    /// Pieces whose sizes, as parts of the whole, add up to this or less are small.
    pub small: f64,
    gauge: Gauge,
    looks: usize,
}

impl<'a> Words<'a> {
    pub fn new(frame: &'a Frame, outline: &'a mut Outline, pieces: &'a mut Pieces, resolution: f64) -> Self {
        // Where rounding is coarser than the resolution, nothing is small.
        let visible = frame.rounding * frame.stretch <= resolution;
        let small = if visible { resolution / outline.diameter(glam::DMat2::IDENTITY) } else { -1.0 };
        pieces.begin(frame);
        Self { frame, outline, pieces, small, gauge: Gauge::default(), looks: 0 }
    }
}

impl Explore for Words<'_> {
    fn lean(&mut self, to_measure: bool) {
        self.gauge = if to_measure { Gauge::to_measure(self.frame) } else { Gauge::to_separate(self.frame) };
    }

    fn first(&mut self, i: u32, others: Range<u32>) -> Distances {
        self.gauge.distances(self.outline, self.pieces.range(others), &self.pieces.get(i).map)
    }

    fn root(&mut self, i: u8, j: u8) -> (u32, u32) {
        (i.into(), j.into())
    }

    fn is_small(&self, pair: &Pair) -> bool {
        self.pieces.are_small(pair.u, pair.v, self.small)
    }

    /// Splits the larger piece.
    fn split(&mut self, pair: &Pair, into: &mut Vec<Part>) {
        if self.looks > ROUGH && !self.outline.is_fine() {
            self.outline.set(&self.frame.maps, 0.012 * (1.0 - self.frame.factor), 64);
        }
        let (parts, first) = self.pieces.parts_of_larger(self.frame, pair.u, pair.v);
        let other = if first { pair.v } else { pair.u };
        self.looks += parts.len();
        for four in parts.clone().step_by(4) {
            let four = four..parts.end.min(four + 4);
            let looks = self.gauge.distances(
                self.outline,
                self.pieces.range(four.clone()),
                &self.pieces.get(other).map,
            );
            for (k, part) in four.enumerate() {
                let (u, v) = if first { (part, other) } else { (other, part) };
                into.push(Part::new(&looks, k, pair, u, v));
            }
        }
    }
}
