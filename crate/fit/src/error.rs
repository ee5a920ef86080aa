//! What can be wrong with a fractal function or with what is to be fitted.

use thiserror::Error;

/// The most pieces or points that are taken.
pub const MAX_POINTS: usize = 1 << 20;

/// Why there is no fractal function or curve. Indices count from 0 here and from 1 in messages.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FunctionError {
    /// Fewer than two points, or no piece.
    #[error("There are {count} points, and a curve needs two or more. Add some.")]
    TooFewPoints {
        /// How many there are.
        count: usize,
    },
    /// More than [`MAX_POINTS`].
    #[error("There are {count} points, and the most is 1048576. Take every second one, or fewer.")]
    TooManyPoints {
        /// How many there are, or were when counting stopped.
        count: usize,
    },
    /// A number is NaN, infinite or beyond 1e100.
    #[error("Point or piece {} holds a number that is not finite or is too large. Mend it or leave it out.", .index + 1)]
    NotFinite {
        /// Index of the point or piece.
        index: usize,
    },
    /// The parameters do not increase from point to point.
    #[error("Point {} does not lie to the right of the one before it. Sort the points, and keep one of equals.", .index + 1)]
    NotIncreasing {
        /// Index of the second of the two.
        index: usize,
    },
    /// As many factors and domains are needed as there are pieces.
    #[error("There are {pieces} pieces, but {given} factors, turns or domains. Give one for each piece.")]
    WrongCount {
        /// Pieces between the points.
        pieces: usize,
        /// What was given.
        given: usize,
    },
    /// A vertical factor of 1 or more: copies do not shrink.
    #[error("Piece {} multiplies heights by {factor:.4}. Make it less than 1.", .piece + 1)]
    NotContractive {
        /// Index of the piece.
        piece: usize,
        /// Its factor: |c|, or the norm of the matrix.
        factor: f64,
    },
    /// A 2 x 2 factor that lengthens some direction of the plane.
    #[error(
        "The factor of piece {} makes the direction ({:.2}, {:.2}) {factor:.3} times as long. It must shorten every \
         direction: make its numbers smaller.",
        .piece + 1, .direction[0], .direction[1]
    )]
    Lengthens {
        /// Index of the piece.
        piece: usize,
        /// The norm of its factor.
        factor: f64,
        /// The unit vector that it makes longest.
        direction: [f64; 2],
    },
    /// The domain of a piece is not longer than the piece itself, or not inside the curve.
    #[error("Piece {} copies a part that is not longer than itself, or not inside the curve. Choose a longer part.", .piece + 1)]
    BadDomain {
        /// Index of the piece.
        piece: usize,
    },
    /// The pieces leave a hole or lie over each other, by more than printed numbers are rounded.
    #[error(
        "Piece {} begins at {begin:.6}, but the one before it ends at {end:.6}. Choose a, d and the parts so that pieces \
         meet: up to 1/400 of the whole is taken for rounding.",
        .piece + 1
    )]
    NotJoined {
        /// Index of the second of the two.
        piece: usize,
        /// Where it begins.
        begin: f64,
        /// Where the one before it ends.
        end: f64,
    },
    /// No values at the ends of the domains, which hang on each other, or endlessly many are in accord.
    #[error(
        "With just these parts and factors no values at the ends of the parts fit together. Change a factor or a part a \
         little, or let parts begin and end at points."
    )]
    Unsettled,
}

impl FunctionError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooFewPoints { .. } => "too-few-points",
            Self::TooManyPoints { .. } => "too-many-points",
            Self::NotFinite { .. } => "not-finite",
            Self::NotIncreasing { .. } => "not-increasing",
            Self::WrongCount { .. } => "wrong-count",
            Self::NotContractive { .. } | Self::Lengthens { .. } => "not-contractive",
            Self::BadDomain { .. } => "bad-domain",
            Self::NotJoined { .. } => "not-joined",
            Self::Unsettled => "unsettled",
        }
    }
}
