//! Where the search for near points begins for a sample of a grid: where that for a sample on a coarser grid ended.
//!
//! Samples lie on the grids of every 1st, 2nd, 4th .. row and column. One that is on no coarser grid than every
//! `2^k`-th begins where the next one below and to the left ended that is on the grid of every `2^(k + 1)`-th; those
//! of the coarsest begin from scratch. So what is found depends on the grid and the sample alone: not on the rectangle
//! that is asked for, nor on what was decided before.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use crate::gap::trails::Trails;

/// A column and a row of a grid.
type Place = (usize, usize);

/// The ways to near points of the samples that others begin from.
#[derive(Clone, Debug, Default)]
pub(crate) struct Starts {
    known: HashMap<Place, Trails, BuildHasherDefault<PlaceHasher>>,
    none: Trails,
}

/// Hashes columns and rows: as nobody chooses them to collide, a product is enough.
#[derive(Clone, Debug, Default)]
struct PlaceHasher(u64);

impl Hasher for PlaceHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_usize(byte.into()));
    }

    fn write_usize(&mut self, number: usize) {
        // 2^64 over the golden ratio. The table takes its places from the lowest bits, and tells by the highest.
        let mixed = (self.0 ^ number as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = mixed ^ mixed >> 32;
    }
}

/// On the grid of every so-manieth row and column samples begin from scratch.
const COARSEST: usize = 16;
/// More are not kept: they are found again.
const MOST_KEPT: usize = 4096;

impl Starts {
    /// Where the search begins at a place. `find` searches at a place, given where to begin.
    pub fn of(&mut self, at: Place, find: &mut dyn FnMut(Place, &Trails) -> Trails) -> &Trails {
        let Some(before) = coarser(at) else { return &self.none };
        if !self.known.contains_key(&before) {
            let start = self.of(before, find);
            let found = find(before, start);
            self.insert(before, found);
        }
        self.known.get(&before).unwrap_or(&self.none)
    }

    /// Keeps what was found at a place, if others begin from there.
    pub fn keep(&mut self, at: Place, found: &Trails) {
        if (at.0 | at.1).is_multiple_of(2) {
            self.insert(at, found.clone());
        }
    }

    fn insert(&mut self, at: Place, found: Trails) {
        if self.known.len() >= MOST_KEPT {
            self.known.clear();
        }
        self.known.insert(at, found);
    }
}

/// The sample of a coarser grid that the search begins from.
fn coarser((x, y): Place) -> Option<Place> {
    let step = 2 << (x | y | COARSEST).trailing_zeros();
    (step <= COARSEST).then(|| (x - x % step, y - y % step))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::trails::Step;

    #[test]
    fn the_way_to_a_sample_goes_over_ever_finer_grids() {
        let way = |at: Place| {
            let mut way: Vec<_> = std::iter::successors(Some(at), |&at| coarser(at)).collect();
            way.reverse();
            way
        };
        assert_eq!(way((32, 16)), [(32, 16)]);
        assert_eq!(way((37, 91)), [(32, 80), (32, 88), (36, 88), (36, 90), (37, 91)]);
        assert_eq!(way((24, 31)), [(16, 16), (24, 24), (24, 28), (24, 30), (24, 31)]);
    }

    #[test]
    fn what_is_found_depends_on_the_place_alone() {
        // Each way is longer by its column than the one it begins from.
        let find = |(x, _): Place, from: &Trails| {
            let before = from.iter().next().map_or(0, |(_, _, steps)| steps.len());
            let mut found = Trails::default();
            found.push(0, 1, &vec![Step { part: 0, large: 0 }; before + x]);
            found
        };
        let length = |trails: &Trails| trails.iter().next().map(|(_, _, steps)| steps.len());
        let (mut one, mut other) = (Starts::default(), Starts::default());
        for k in 0..6000 {
            let (x, y) = (k * 7 % 97, k * 13 % 89);
            let (back, up) = (96 - x, 88 - y);
            other.of((back, up), &mut { find });
            let fresh = length(Starts::default().of((x, y), &mut { find }));
            assert_eq!(length(one.of((x, y), &mut { find })), fresh);
            assert_eq!(length(other.of((x, y), &mut { find })), fresh);
        }
        assert!(one.known.len() <= MOST_KEPT);
    }
}
