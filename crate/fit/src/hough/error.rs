//! Why nothing is counted.

use thiserror::Error;

/// Why nothing is counted.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum HoughError {
    /// Fewer than three feature points.
    #[error("There are {count} feature points, and three are the least. Take more.")]
    TooFewFeatures {
        /// How many there are.
        count: usize,
    },
    /// More than [`MAX_FEATURES`](crate::MAX_FEATURES).
    #[error("There are {count} feature points, and the most is 1025. Take fewer.")]
    TooManyFeatures {
        /// How many there are.
        count: usize,
    },
    /// A series of more than [`MAX_POINTS`](crate::MAX_POINTS) points.
    #[error("There are {count} points, and the most is 1048576. Take every second one, or fewer.")]
    TooManyPoints {
        /// How many there are.
        count: usize,
    },
    /// A number is NaN, infinite or beyond 1e100.
    #[error("Feature point {} holds a number that is not finite or is too large. Mend it or leave it out.", .index + 1)]
    NotFinite {
        /// Index of the point.
        index: usize,
    },
    /// The parameters do not increase.
    #[error("Feature point {} does not lie to the right of the one before it. Sort the points, and keep one of equals.", .index + 1)]
    NotIncreasing {
        /// Index of the second of the two.
        index: usize,
    },
}

impl HoughError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooFewFeatures { .. } => "too-few-features",
            Self::TooManyFeatures { .. } => "too-many-features",
            Self::TooManyPoints { .. } => "too-many-points",
            Self::NotFinite { .. } => "not-finite",
            Self::NotIncreasing { .. } => "not-increasing",
        }
    }
}
