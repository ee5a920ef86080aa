//! What is too large to be checked.

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
/// Of the polynomial of exact numbers.
pub(crate) const DEGREE: usize = 16;
/// Characters of one fraction, and of all fractions together.
pub(crate) const NUMERAL: usize = 1000;
pub(crate) const NUMERALS: usize = 200_000;
/// Bytes of all entries over one denominator.
pub(crate) const HELD: usize = 64 << 20;

pub(crate) fn at_most(count: usize, most: usize, what: &'static str) -> Result<(), Refused> {
    if count > most { Err(Refused::TooLarge { what, most: most as u64 }) } else { Ok(()) }
}
