//! What can be wrong with an iterated function system.

use thiserror::Error;

/// The most maps an [`Ifs`](crate::Ifs) may have.
pub const MAX_MAPS: usize = 64;

/// Why a list of maps is no iterated function system that can be drawn.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum IfsError {
    /// The list is empty.
    #[error("There are no maps. Add at least one.")]
    NoMaps,
    /// The list is longer than [`MAX_MAPS`].
    #[error("There are {count} maps, and the most is 64. Remove some.")]
    TooManyMaps {
        /// Its length.
        count: usize,
    },
    /// A number is NaN or infinite, or so large that products of maps overflow.
    #[error("Map {} holds a number that is not finite or is too large. Give numbers below 1e100.", .map + 1)]
    NotFinite {
        /// Index of the map, from 0.
        map: usize,
    },
    /// The maps do not contract in the long run, so that there is no attractor.
    #[error(
        "These maps have no attractor: applied again and again, some of them do not shrink (the word \
         {word} scales by {factor:.4}). Make them smaller."
    )]
    NoAttractor {
        /// A word whose map does not contract, numbered from 1 and joined by dots.
        word: String,
        /// The spectral radius of that map.
        factor: f64,
    },
    /// Whether there is an attractor could not be found out within the budget.
    #[error(
        "These maps are too close to not shrinking at all, so that it is unknown whether they have an \
         attractor. Make the largest one a little smaller."
    )]
    Unproved,
    /// The probabilities do not fit the maps.
    #[error("The probabilities must be {maps} numbers, none negative, with a positive sum.")]
    Probabilities {
        /// Number of maps.
        maps: usize,
    },
}

impl IfsError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoMaps => "no-maps",
            Self::TooManyMaps { .. } => "too-many-maps",
            Self::NotFinite { .. } => "not-finite",
            Self::NoAttractor { .. } => "no-attractor",
            Self::Unproved => "attractor-unproved",
            Self::Probabilities { .. } => "probabilities",
        }
    }
}
