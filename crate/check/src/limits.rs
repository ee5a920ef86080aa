//! What is too large to be checked.

use num_bigint::BigInt;

use crate::polygon::Scene;
use crate::refused::Refused;

/// Letters are bytes.
pub(crate) const MAPS: usize = 256;
pub(crate) const CORNERS: usize = 512;
pub(crate) const PAIRS: usize = 1_000_000;
pub(crate) const CELLS: usize = 100_000;
pub(crate) const FARTHEST_CELL: u32 = 1_000_000;
/// Letters of one word, and of all words together.
pub(crate) const LETTERS: usize = 1000;
pub(crate) const TEXT: usize = 10_000_000;
/// Multiplications of machine words, roughly: a minute or two.
const WORK: u64 = 50_000_000_000;

pub(crate) fn at_most(count: usize, most: usize, what: &'static str) -> Result<(), Refused> {
    if count > most { Err(Refused::TooLarge { what, most: most as u64 }) } else { Ok(()) }
}

/// Roughly how long a check takes: numbers grow by as many digits a letter as the maps have.
pub(crate) struct Work {
    a_letter: u64,
    a_corner: u64,
    corners: u64,
    sum: u64,
}

impl Work {
    /// That of a polygon which is seen to be convex.
    pub fn of(scene: &Scene) -> Self {
        let size = |whole: u64, numbers: &mut dyn Iterator<Item = &BigInt>| {
            whole.max(numbers.map(BigInt::bits).max().unwrap_or(0)) / 64 + 2
        };
        let a_corner = size(scene.corners.bits, &mut scene.corners.rows.iter().flatten());
        let corners = scene.corners.rows.len() as u64;
        Self {
            a_letter: size(scene.maps.bits, &mut scene.maps.rows.iter().flatten()),
            a_corner,
            corners,
            sum: (corners * a_corner).pow(2),
        }
    }

    /// And how far the image of the polygon under a word of so many letters reaches, so many times.
    pub fn add(&mut self, times: u64, letters: usize) {
        let letters = letters as u64;
        let end = letters * self.a_letter + 2 * self.a_corner;
        let once = letters * end * 3 * self.a_letter + end * 2 * self.corners * self.a_corner;
        self.sum = self.sum.saturating_add(once.saturating_mul(times));
    }

    pub fn check(&self) -> Result<(), Refused> {
        if self.sum > WORK {
            Err(Refused::TooLarge { what: "digits to multiply", most: WORK })
        } else {
            Ok(())
        }
    }
}
