//! Proofs for samples of a locus that hold as far as epsilon tells.
//!
//! What shows that one system is connected mostly shows it of its neighbours: the same pieces cross. So a sample is
//! first held against what was found for those beside it, and searched on its own where that is not enough: where
//! proofs end, and on a coarse grid, from which they spread.

use std::ops::Range;

use frond_core::Affine2;
use glam::DVec2;

use crate::decide::{Scratch, decide};
use crate::family::Family;
use crate::gap::difference_set::are_equal;
use crate::grid::LocusGrid;
use crate::region::descent::{Couple, Descent};
use crate::region::extent::Extent;
use crate::region::inner_differences::InnerDifferences;
use crate::region::trap::reaching;
use crate::verdict::State;

/// Pairs of words tried at most for each two maps of a sample.
const TRIES: usize = 600;
/// Looks after which a sample is let be.
const MOST_LOOKS: usize = 60_000;
/// Looks in vain after which no sample of a rectangle is searched any more, for each that it has to.
const LOOKS_IN_VAIN: usize = 5000;
/// Of so many rows and columns one is searched though nothing is proved beside it.
const SEEDS: usize = 4;
/// Where the proofs lie that are tried, from a sample in the order of rows: those before it, the nearest first.
const BESIDE: [[isize; 2]; 12] = [
    [0, -1],
    [-1, 0],
    [-1, -1],
    [-1, 1],
    [0, -2],
    [-2, 0],
    [-1, -2],
    [-1, 2],
    [-2, -1],
    [-2, 1],
    [0, -3],
    [-3, 0],
];

/// Words of two pieces that cross.
type Words = [Box<[u8]>; 2];

impl LocusGrid {
    /// Looks for proofs for those samples of a rectangle that are [`State::Touching`]: `state` holds the states of
    /// [`LocusGrid::patch`], or of [`LocusGrid::tile`], for the same epsilon and rectangle, and is
    /// [`State::Connected`] afterwards where pieces were found to cross (see [`crossings`](crate::crossings)), or to
    /// differ by what surely are differences. Returns for how many samples that is new.
    ///
    /// What it says is proved whatever `state` held before. It takes some 50 microseconds a sample, and depends
    /// on the rectangle: in another one neighbours may be missing that would have helped.
    ///
    /// # Panics
    /// If `state` does not have one number for each sample of the rectangle, as far as it lies in the grid.
    // In one piece of code, as `patch`.
    pub fn prove(
        &self,
        family: &dyn Family,
        epsilon: f64,
        x: Range<usize>,
        y: Range<usize>,
        state: &mut [u8],
        scratch: &mut Scratch,
    ) -> usize {
        let x = x.start..x.end.min(self.width());
        let y = y.start..y.end.min(self.height());
        let width = x.len();
        assert_eq!(state.len(), width * y.len(), "one state for each sample");
        let touching: Vec<usize> = (0..state.len()).filter(|&k| state[k] == State::Touching as u8).collect();
        let mut prover = Prover {
            width,
            found: vec![None; state.len()],
            searched: vec![false; state.len()],
            looks_left: touching.len() * LOOKS_IN_VAIN,
            ..Prover::default()
        };
        let mut maps = Vec::with_capacity(family.len());
        let mut count = 0;
        // Down, and up again with what was found on the way.
        for (n, &k) in touching.iter().chain(touching.iter().rev()).enumerate() {
            let down = n < touching.len();
            let beside = prover.beside(k, down);
            if state[k] != State::Touching as u8 || beside.is_empty() && !(down && prover.is_seed(k)) {
                continue;
            }
            let at = DVec2::new(self.u(x.start + k % width), self.v(y.start + k / width));
            family.fill(at.x, at.y, &mut maps);
            // The bound of the gap has to be known here, not believed.
            if decide(&maps, epsilon, Self::budget(maps.len()), scratch).state != State::Touching {
                continue;
            }
            let extent = Extent { middle: at, half: DVec2::ZERO };
            if prover.begin(family, extent, epsilon, scratch) && prover.prove(k, &beside, &maps) {
                state[k] = State::Connected as u8;
                count += 1;
            }
        }
        count
    }
}

#[derive(Default)]
struct Prover {
    descent: Descent<1>,
    differences: InnerDifferences,
    /// Samples in a row.
    width: usize,
    /// What each sample was proved by.
    found: Vec<Option<usize>>,
    proofs: Vec<Vec<Words>>,
    searched: Vec<bool>,
    looks_left: usize,
    /// An upper bound of the widest gap, in the descent's units.
    gap: f64,
}

impl Prover {
    /// Gets ready for a sample whose pieces are known to come within `epsilon` of each other.
    fn begin(&mut self, family: &dyn Family, extent: Extent, epsilon: f64, scratch: &mut Scratch) -> bool {
        if !self.descent.begin(family, extent, &mut scratch.frame) {
            return false;
        }
        let from_round = Affine2::new(self.descent.lanes.from_round, DVec2::ZERO);
        let Some(to_round) = from_round.inverse() else { return false };
        // Lengths of the plane are as many times those here as one way tells, and the other way back. What rounding
        // adds to distances is far below the last term.
        let stretch = from_round.norm() * to_round.norm();
        self.gap = (1.01 * epsilon + 1e-8) * self.descent.diameter().1 * stretch;
        self.gap.is_finite()
    }

    fn is_seed(&self, k: usize) -> bool {
        (k / self.width).is_multiple_of(SEEDS) && (k % self.width).is_multiple_of(SEEDS)
    }

    /// The proofs of samples near one, each once: of those before it, or after.
    fn beside(&self, k: usize, before: bool) -> Vec<usize> {
        let sign = if before { 1 } else { -1 };
        let mut all = Vec::new();
        for [down, across] in BESIDE {
            let row = (k / self.width).checked_add_signed(sign * down);
            let column = (k % self.width).checked_add_signed(sign * across).filter(|&x| x < self.width);
            let Some((row, column)) = row.zip(column) else { continue };
            let found = self.found.get(row * self.width + column).copied().flatten();
            all.extend(found.filter(|proof| !all.contains(proof)));
        }
        all
    }

    /// Proves sample `k`, if it can, by the help of such proofs.
    fn prove(&mut self, k: usize, beside: &[usize], maps: &[Affine2]) -> bool {
        self.descent.join_filled();
        let mut words = Vec::new();
        if are_equal(maps) {
            if !self.differ(maps) {
                return false;
            }
        } else if !self.cross(k, beside, &mut words) {
            return false;
        }
        let same = beside.iter().copied().find(|&proof| self.proofs[proof] == words);
        self.found[k] = Some(same.unwrap_or_else(|| {
            self.proofs.push(words);
            self.proofs.len() - 1
        }));
        true
    }

    fn cross(&mut self, k: usize, beside: &[usize], words: &mut Vec<Words>) -> bool {
        for pair in beside.iter().flat_map(|&proof| &self.proofs[proof]) {
            if self.descent.cross_again(pair, self.gap) {
                words.push(pair.clone());
            }
        }
        if self.descent.is_whole() {
            return true;
        }
        if self.looks_left == 0 || self.searched[k] {
            return false;
        }
        self.searched[k] = true;
        let crossed = self.descent.cross_the_rest(self.gap, words);
        if !crossed {
            self.looks_left = self.looks_left.saturating_sub(self.descent.nodes);
        }
        crossed
    }

    /// For copies of one shape and direction, which do not cross.
    fn differ(&mut self, maps: &[Affine2]) -> bool {
        if !self.differences.begin(maps, self.descent.size()) {
            return false;
        }
        for i in 0..maps.len() {
            for j in i + 1..maps.len() {
                if !self.descent.components.joined(i, j) && self.differences.join(maps, i, j) {
                    self.descent.components.join(i, j);
                }
            }
        }
        self.descent.is_whole()
    }
}

impl Descent<1> {
    /// Forgets which attractorlets are joined, but for those whose areas leave no room between them.
    fn join_filled(&mut self) {
        self.reset();
        for i in 0..self.count {
            for j in i + 1..self.count {
                if self.lanes.areas[i] + self.lanes.areas[j] > 1.0 {
                    self.components.join(i, j);
                }
            }
        }
    }

    fn is_whole(&self) -> bool {
        self.components.count() == 1
    }

    /// How wide and how high the attractor is in the plane.
    fn size(&self) -> DVec2 {
        let turned = self.lanes.from_round.transpose();
        let reach = |d: DVec2| self.fan.support(turned * d, 0).0;
        let width = |d: DVec2| reach(d) + reach(-d);
        DVec2::new(width(DVec2::X), width(DVec2::Y))
    }

    /// Whether two pieces that crossed in another system do so in this one, and join what was not yet.
    fn cross_again(&mut self, [u, v]: &Words, gap: f64) -> bool {
        let (i, j) = (usize::from(u[0]), usize::from(v[0]));
        if self.components.joined(i, j) {
            return false;
        }
        let [u, v] = [u, v].map(|word| self.piece(word));
        self.corners(u, v, gap).is_some() && self.components.join(i, j)
    }

    /// The piece of a word.
    fn piece(&mut self, word: &[u8]) -> u32 {
        let first = u32::from(word[0]);
        word[1..].iter().fold(first, |piece, &letter| self.parts_of(piece).start + u32::from(letter))
    }

    /// Looks for crossings that join what is not joined yet, and adds their words to those found.
    fn cross_the_rest(&mut self, gap: f64, found: &mut Vec<Words>) -> bool {
        let mut pairs = Vec::new();
        for i in 0..self.count {
            for j in i + 1..self.count {
                let overlap = reaching(&self.look(i as u32, j as u32));
                if overlap < 1.0 {
                    pairs.push(Couple { overlap, u: i as u32, v: j as u32, i: i as u8, j: j as u8 });
                }
            }
        }
        pairs.sort_unstable_by(|a, b| a.overlap.total_cmp(&b.overlap));
        for pair in pairs {
            let (i, j) = (usize::from(pair.i), usize::from(pair.j));
            if self.components.joined(i, j) {
                continue;
            }
            if self.nodes > MOST_LOOKS {
                return false;
            }
            if let Some((couple, _)) = self.crossing_of(pair, gap, TRIES) {
                found.push([couple.u, couple.v].map(|piece| self.word(piece).into()));
                self.components.join(i, j);
                if self.is_whole() {
                    return true;
                }
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use frond_core::{Morph, MorphOptions};

    use super::*;

    #[test]
    fn no_gap_is_wider_than_what_epsilon_leaves() {
        // Cantor's dust, whose widest gap is a third of it, bent so that the round coordinates are not those given.
        let place = Affine2::from_row([3.0, 1.5, 0.2, 0.8, 40.0, -7.0]);
        let maps = [0.0, 2.0 / 3.0].map(|e| {
            Affine2::from_row([1.0 / 3.0, 0.0, 0.0, 1.0 / 3.0, e, 0.0]).conjugate(place).expect("a place")
        });
        let morph = Morph::new(&maps, &maps, &MorphOptions::default()).unwrap();
        let mut prover = Prover::default();
        let extent = Extent { middle: DVec2::ZERO, half: DVec2::ZERO };
        assert!(prover.begin(&morph, extent, 1.0 / 3.0, &mut Scratch::default()));
        let (least, most) = prover.descent.diameter();
        assert!(prover.gap >= least / 3.0 && prover.gap <= 20.0 * most, "{} of {least}", prover.gap);
    }
}
