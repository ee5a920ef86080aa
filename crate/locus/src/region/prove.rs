//! Proofs for samples of a locus that hold as far as epsilon tells.
//!
//! What shows that one system is connected mostly shows it of its neighbours: the same pieces cross. So a sample is
//! first held against what was found for those beside it, and searched on its own where that is not enough: where
//! proofs end, and on a coarse grid, from which they spread.

use std::ops::Range;

use frond_core::Affine2;
use glam::DVec2;

use crate::decide::{Scratch, decide};
use crate::exact::address::Address;
use crate::family::Family;
use crate::gap::difference_set::are_equal;
use crate::grid::LocusGrid;
use crate::region::contacts::{Contact, Contacts};
use crate::region::descent::Descent;
use crate::region::extent::Extent;
use crate::region::inner_differences::InnerDifferences;
use crate::region::joining::{Candidates, Words};
use crate::verdict::State;

/// Looks in vain after which no sample of a rectangle is searched any more, for each that it has to.
const LOOKS_IN_VAIN: usize = 5000;
/// What lies so many rows or columns from all that was seen to is searched though nothing is proved beside it.
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

/// Where crossings are searched, the gap is bounded so many times closer.
const CLOSER: f64 = 1e-3;

/// What holds two pieces of a sample together, and may do so in the next.
#[derive(Clone, Debug, PartialEq)]
enum Held {
    Crossing(Words),
    Point(Contact),
}

/// One sample.
struct Asked<'a> {
    maps: &'a [Affine2],
    epsilon: f64,
    scratch: &'a mut Scratch,
}

impl LocusGrid {
    /// Looks for proofs for those samples of a rectangle that are [`State::Touching`]: `state` holds the states of
    /// [`LocusGrid::patch`], or of [`LocusGrid::tile`], for the same epsilon and rectangle, and is
    /// [`State::Connected`] afterwards where pieces were found to cross (see [`crossings`](crate::crossings)), to
    /// differ by what surely are differences, or to share points exactly. Returns for how many samples that is new.
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
            seen: vec![false; state.len()],
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
            prover.seen[k] = true;
            let at = DVec2::new(self.u(x.start + k % width), self.v(y.start + k / width));
            family.fill(at.x, at.y, &mut maps);
            // The bound of the gap has to be known here, not believed.
            if decide(&maps, epsilon, Self::budget(maps.len()), scratch).state != State::Touching {
                continue;
            }
            let extent = Extent { middle: at, half: DVec2::ZERO };
            if prover.begin(family, extent, epsilon, scratch)
                && prover.prove(k, &beside, Asked { maps: &maps, epsilon, scratch })
            {
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
    contacts: Contacts,
    candidates: Candidates,
    /// Samples in a row.
    width: usize,
    /// What each sample was proved by.
    found: Vec<Option<usize>>,
    proofs: Vec<Vec<Held>>,
    seen: Vec<bool>,
    searched: Vec<bool>,
    looks_left: usize,
    /// An upper bound of the widest gap, in the descent's units.
    gap: f64,
    /// How large the attractor may be in these units.
    size: f64,
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
        self.size = self.descent.diameter().1 * stretch;
        self.bound_gap(epsilon);
        self.gap.is_finite()
    }

    /// Takes the widest gap to be no more than `epsilon` of the diameter.
    fn bound_gap(&mut self, epsilon: f64) {
        self.gap = (1.01 * epsilon + 1e-8) * self.size;
    }

    /// Whether no sample near it that comes before was seen to, and there is time to search it.
    fn is_seed(&self, k: usize) -> bool {
        let (row, column) = (k / self.width, k % self.width);
        let columns = column.saturating_sub(SEEDS - 1)..(column + SEEDS).min(self.width);
        let mut before = (row.saturating_sub(SEEDS - 1)..=row)
            .flat_map(|row| columns.clone().map(move |column| row * self.width + column));
        self.looks_left > 0 && !before.any(|before| self.seen[before])
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
    fn prove(&mut self, k: usize, beside: &[usize], mut asked: Asked<'_>) -> bool {
        self.descent.join_filled();
        self.contacts.begin(asked.maps);
        let mut held = Vec::new();
        let equal = are_equal(asked.maps);
        let is_proved = self.holds_still(beside, asked.maps, &mut held)
            || equal && self.differ(asked.maps)
            || self.search(k, beside, &mut asked, &mut held);
        if !is_proved {
            return false;
        }
        let same = beside.iter().copied().find(|&proof| self.proofs[proof] == held);
        self.found[k] = Some(same.unwrap_or_else(|| {
            self.proofs.push(held);
            self.proofs.len() - 1
        }));
        true
    }

    /// Joins what holds together as it does in other systems; whether that is all.
    fn holds_still(&mut self, beside: &[usize], maps: &[Affine2], held: &mut Vec<Held>) -> bool {
        let Self { descent, contacts, proofs, gap, .. } = self;
        for one in beside.iter().flat_map(|&proof| &proofs[proof]) {
            let holds = match one {
                Held::Crossing(words) => descent.cross_again(words, *gap),
                Held::Point(contact) => {
                    let [i, j] = contact.each_ref().map(Address::first);
                    let lanes = &descent.lanes.maps;
                    !descent.components.joined(i, j)
                        && contacts.hold(maps, |k| lanes[usize::from(k)][0], contact)
                        && descent.components.join(i, j)
                }
            };
            if holds {
                held.push(one.clone());
            }
        }
        descent.is_whole()
    }

    /// Looks for more that holds the sample together.
    fn search(&mut self, k: usize, beside: &[usize], asked: &mut Asked<'_>, held: &mut Vec<Held>) -> bool {
        if self.looks_left == 0 || self.searched[k] {
            return false;
        }
        self.searched[k] = true;
        let before = self.descent.nodes;
        let joined = held.len();
        let points = self.share_points(asked.maps, held);
        let is_proved = self.descent.is_whole()
            || if are_equal(asked.maps) {
                held.len() > joined && self.differ(asked.maps)
            } else {
                self.cross(beside, asked, held)
            };
        if !is_proved {
            self.looks_left = self.looks_left.saturating_sub(self.descent.nodes - before + points);
        }
        is_proved
    }

    /// Joins pieces that share points. Returns how many points were looked at.
    fn share_points(&mut self, maps: &[Affine2], held: &mut Vec<Held>) -> usize {
        let Self { descent, contacts, .. } = self;
        let lanes = &descent.lanes.maps;
        let mut found = Vec::new();
        let looks = contacts.join(maps, |k| lanes[usize::from(k)][0], &mut descent.components, &mut found);
        held.extend(found.into_iter().map(Held::Point));
        looks
    }

    fn cross(&mut self, beside: &[usize], asked: &mut Asked<'_>, held: &mut Vec<Held>) -> bool {
        // The narrower the gaps, the less a piece has to reach beyond another one.
        let Asked { maps, epsilon, scratch } = asked;
        let closer = CLOSER * *epsilon;
        match decide(maps, closer, LocusGrid::budget(maps.len()), scratch).state {
            State::Touching | State::Connected => self.bound_gap(closer),
            State::Undecided => {}
            State::Disconnected | State::NoAttractor => return false,
        }
        if self.holds_still(beside, maps, held) {
            return true;
        }
        self.candidates.begin(&mut self.descent);
        let mut words = Vec::new();
        let is_whole = self.candidates.cross(&mut self.descent, self.gap, &mut words);
        held.extend(words.into_iter().map(Held::Crossing));
        is_whole
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
