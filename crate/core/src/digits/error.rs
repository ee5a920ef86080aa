//! What can be wrong with digits, and with a question about two shapes made of them.

use thiserror::Error;

use crate::directed::error::{DirectedError, MOST_FOUND_MAPS, MOST_FOUND_STATES};
use crate::error::MAX_MAPS;

/// The largest entry of a matrix of a [`DigitSystem`](crate::DigitSystem), and of its digits.
pub(crate) const LARGEST_ENTRY: i64 = 32;
pub(crate) const LARGEST_DIGIT: i64 = 1000;
/// The largest denominator of a shift, and its largest numerator.
pub(crate) const LARGEST_DENOMINATOR: i64 = 1_000_000;
pub(crate) const LARGEST_NUMERATOR: i64 = 1_000_000_000_000;

/// Why digits make no shape, or what two shapes share is not worked out.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum DigitError {
    /// There is no digit.
    #[error("There are no digits. Give at least one.")]
    NoDigits,
    /// There are more than [`MAX_MAPS`].
    #[error("There are {count} digits, and the most is {MAX_MAPS}. Leave some out.")]
    TooManyDigits {
        /// How many there are.
        count: usize,
    },
    /// A digit is there twice.
    #[error("Digit {} is digit {} once more. Leave one of them out.", .digit + 1, .before + 1)]
    Repeated {
        /// The digit, from 0.
        digit: usize,
        /// The one that it repeats, from 0.
        before: usize,
    },
    /// A number is too large to be computed with exactly.
    #[error(
        "A number is too large. Entries of the matrix go up to {LARGEST_ENTRY}, digits up to {LARGEST_DIGIT}."
    )]
    TooLarge,
    /// Not every direction is stretched by the matrix.
    #[error(
        "The matrix does not stretch in every direction, so that pieces do not shrink. Both its eigenvalues have to \
         be larger than 1."
    )]
    NotExpanding,
    /// The two shapes have different matrices.
    #[error(
        "The two shapes have different matrices, and so no grid in common. Give both the same one; where one matrix is a \
         power of the other, write the shape with longer digits."
    )]
    Matrices,
    /// The denominator of the shift is not a whole number that can be computed with, or a numerator is too large.
    #[error(
        "The shift has to be a fraction: whole numbers over one denominator from 1 to {LARGEST_DENOMINATOR}."
    )]
    Shift,
    /// The shapes reach each other by too many shifts.
    #[error(
        "More than {most} shifts have to be followed. Give a shift with a smaller denominator, or smaller digits."
    )]
    TooManyShifts {
        /// How many were followed.
        most: usize,
    },
    /// The graph is larger than what a system may have.
    #[error(
        "What the two share is made of more than {MOST_FOUND_STATES} kinds of pieces, more than {MAX_MAPS} pieces of one \
         kind, or more than {MOST_FOUND_MAPS} of all: it stops there. Give a shift with a smaller denominator."
    )]
    TooManyStates,
    /// What was built is no graph-directed system that can be drawn.
    #[error(transparent)]
    Directed(#[from] DirectedError),
}

impl DigitError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoDigits => "digits-none",
            Self::TooManyDigits { .. } => "digits-too-many",
            Self::Repeated { .. } => "digits-repeated",
            Self::TooLarge => "digits-too-large",
            Self::NotExpanding => "digits-not-expanding",
            Self::Matrices => "grid-matrices",
            Self::Shift => "grid-shift",
            Self::TooManyShifts { .. } => "grid-too-many-shifts",
            Self::TooManyStates => "grid-too-many-states",
            Self::Directed(error) => error.code(),
        }
    }
}
