//! Pairs of words: what a descent on an attractor looks at.

use std::ops::{ControlFlow, Range};

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::gap::pair_descent::{Explore, Pair, Sight};
use crate::gap::piece_distance::{Distances, Looks, Metric};
use crate::gap::word_tree::{Piece, WordTree};
use crate::support::table::SupportTable;

/// After so many looks a finer table of support values pays.
const LOOKS_BEFORE_FINE: usize = 150;
/// And one that is finer still, which takes longer to make.
const LOOKS_BEFORE_FINEST: usize = 2000;

/// The pieces of the maps of a frame; `P` is what is kept of the nearest points.
pub(crate) struct WordPairs<'a, P> {
    pub frame: &'a Frame,
    pub support: &'a mut SupportTable,
    tree: &'a mut WordTree,
    /// Pieces whose sizes, as parts of the whole, add up to this or less are small.
    small: f64,
    metric: Metric,
    looks: usize,
    nearest: std::marker::PhantomData<P>,
}

impl<'a, P> WordPairs<'a, P> {
    /// Pairs of the words of a frame, whose attractor has these support values; not begun.
    pub fn new(frame: &'a Frame, support: &'a mut SupportTable, tree: &'a mut WordTree) -> Self {
        let nearest = std::marker::PhantomData;
        Self { frame, support, tree, small: -1.0, metric: Metric::default(), looks: 0, nearest }
    }

    /// Begins with the words of one letter. Pieces together as small as `near` count as meeting, where the resolution
    /// is no finer than rounding.
    pub fn begin(&mut self, resolution: f64, near: f64) {
        let frame = self.frame;
        // Where rounding is coarser than the resolution, nothing is small.
        let visible = frame.rounding * frame.stretch <= resolution;
        self.small = if visible { near / self.support.diameter(DMat2::IDENTITY) } else { -1.0 };
        self.tree.begin(frame);
    }

    /// Whether the pieces of a pair are so small that rounding counts for more than what their parts would show.
    pub fn is_no_larger_than_rounding(&self, pair: &Pair) -> bool {
        self.tree.are_small(pair.u, pair.v, self.frame.rounding * self.frame.stretch)
    }
}

/// What is kept of the nearest points of two pieces: nothing, or the points.
pub(crate) trait Nearest: Copy + Default {
    type Looks;
    fn look(metric: &Metric, support: &SupportTable, parts: &[Piece], other: &Affine2) -> Self::Looks;
    /// What was seen of part `k`, which is of the `first` piece of the pair or of the second.
    fn sight(looks: &Self::Looks, k: usize, first: bool) -> Sight<Self>;
}

impl Nearest for () {
    type Looks = Distances;
    #[inline(always)]
    fn look(metric: &Metric, support: &SupportTable, parts: &[Piece], other: &Affine2) -> Distances {
        metric.distances(support, parts, other)
    }
    #[inline(always)]
    fn sight(looks: &Distances, k: usize, _: bool) -> Sight<()> {
        looks.sight(k)
    }
}

impl Nearest for [DVec2; 2] {
    type Looks = Looks;
    fn look(metric: &Metric, support: &SupportTable, parts: &[Piece], other: &Affine2) -> Looks {
        metric.look(support, parts, other)
    }
    fn sight(looks: &Looks, k: usize, first: bool) -> Sight<Self> {
        let (part, other) = looks.points(k);
        let points = if first { [part, other] } else { [other, part] };
        let Distances { apart, overlap, reach } = looks.distances;
        Sight { apart: apart[k], overlap: overlap[k], reach: reach[k], points }
    }
}

impl<P: Nearest> Explore for WordPairs<'_, P> {
    type Nearest = P;

    fn choose_metric(&mut self, to_measure: bool) {
        self.metric =
            if to_measure { Metric::to_measure(self.frame) } else { Metric::to_separate(self.frame) };
    }

    fn first(&mut self, i: u32, others: Range<u32>, mut see: impl FnMut(u32, Sight<P>)) {
        let one = self.tree.get(i).map;
        let looks = P::look(&self.metric, self.support, self.tree.range(others.clone()), &one);
        for (k, j) in others.enumerate() {
            see(j, P::sight(&looks, k, false));
        }
    }

    fn root(&mut self, i: u8, j: u8) -> (u32, u32) {
        (i.into(), j.into())
    }

    fn is_small(&self, pair: &Pair) -> bool {
        self.tree.are_small(pair.u, pair.v, self.small)
    }

    /// Splits the larger piece.
    fn split(&mut self, pair: &Pair, mut see: impl FnMut(u32, u32, Sight<P>) -> ControlFlow<()>) {
        let accuracy = 1.0 - self.frame.factor;
        if self.looks > LOOKS_BEFORE_FINE && !self.support.is_fine() {
            self.support.set(&self.frame.maps, 0.012 * accuracy, 64);
        }
        if self.looks > LOOKS_BEFORE_FINEST && !self.support.is_finest() {
            self.support.set_finest(&self.frame.maps, 0.003 * accuracy, 256);
        }
        let (parts, first) = self.tree.parts_of_larger(self.frame, pair.u, pair.v);
        let other = if first { pair.v } else { pair.u };
        let whole = self.tree.get(other).map;
        self.looks += parts.len();
        for four in parts.clone().step_by(4) {
            let four = four..parts.end.min(four + 4);
            let looks = P::look(&self.metric, self.support, self.tree.range(four.clone()), &whole);
            for (k, part) in four.enumerate() {
                let (u, v) = if first { (part, other) } else { (other, part) };
                if see(u, v, P::sight(&looks, k, first)).is_break() {
                    return;
                }
            }
        }
    }
}
