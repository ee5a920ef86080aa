//! What can be wrong with a graph-directed system.

use thiserror::Error;

use crate::error::{IfsError, MAX_MAPS};

/// The most states of a system that is made by hand ([`DirectedIfs::new`](crate::DirectedIfs::new)).
pub const MAX_STATES: usize = 64;

/// The most states of a system that was found and not made by hand
/// ([`DirectedIfs::found`](crate::DirectedIfs::found)).
pub const MOST_FOUND_STATES: usize = 1024;
/// The most maps of all its states together.
pub const MOST_FOUND_MAPS: usize = 8192;

/// Why states and maps are no graph-directed system that can be drawn.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum DirectedError {
    /// There is no state.
    #[error("There are no states. Add at least one.")]
    NoStates,
    /// There are more than [`MAX_STATES`], or than [`MOST_FOUND_STATES`] of a system that was found.
    #[error("There are {count} states, and the most is {most}. Remove some.")]
    TooManyStates {
        /// How many there are.
        count: usize,
        /// How many there may be.
        most: usize,
    },
    /// The states of a system that was found have more than [`MOST_FOUND_MAPS`] maps together.
    #[error("There are {count} maps of all states together, and the most is {MOST_FOUND_MAPS}. Remove some.")]
    TooManyMapsInAll {
        /// How many there are.
        count: usize,
    },
    /// A state is a union of no copies, so that no way out of it goes on.
    #[error(
        "State {} has no maps, so that there is nothing in it. Give it a map, or remove it and the maps that copy it.",
        .state + 1
    )]
    NoMaps {
        /// The state, from 0.
        state: usize,
    },
    /// A state is a union of more than [`MAX_MAPS`] copies.
    #[error("State {} has {count} maps, and the most is {MAX_MAPS}. Remove some.", .state + 1)]
    TooManyMaps {
        /// The state, from 0.
        state: usize,
        /// How many maps it has.
        count: usize,
    },
    /// A map copies a state that is not there.
    #[error(
        "Map {} of state {} copies state {}, and there {}. Let it copy one that is there.",
        .map + 1, .state + 1, .from.saturating_add(1), are(*.states)
    )]
    From {
        /// The state, from 0.
        state: usize,
        /// Its map, from 0.
        map: usize,
        /// What it copies, from 0.
        from: usize,
        /// How many states there are.
        states: usize,
    },
    /// A number is NaN or infinite, or so large that products of maps overflow.
    #[error(
        "Map {} of state {} holds a number that is not finite or is too large. Give numbers below 1e100.",
        .map + 1, .state + 1
    )]
    NotFinite {
        /// The state, from 0.
        state: usize,
        /// Its map, from 0.
        map: usize,
    },
    /// Some way round through the states does not shrink.
    #[error(
        "These maps have no attractor: the way round through the states {} scales by {factor:.4}, and has to shrink. \
         Make a map on it smaller.",
        way(.cycle)
    )]
    NoAttractor {
        /// The maps along the way: the state that each is of, and its place there, from 0. The last copies the state
        /// of the first.
        cycle: Vec<(usize, usize)>,
        /// The spectral radius of their product.
        factor: f64,
    },
    /// Whether there is an attractor could not be found out within the budget.
    #[error(
        "Some way round through the states is too close to not shrinking at all, so that it is unknown whether there is \
         an attractor. Make the largest maps a little smaller."
    )]
    Unproved,
    /// There is one state, and something is wrong with its maps.
    #[error(transparent)]
    Ifs(#[from] IfsError),
}

fn are(states: usize) -> String {
    if states == 1 { "is one".to_owned() } else { format!("are {states}") }
}

/// `1, 2, 1`, with the map where it matters: `1 (by map 2)`.
fn way(cycle: &[(usize, usize)]) -> String {
    let steps = cycle.iter().map(|(state, map)| format!("{} (by its map {}), ", state + 1, map + 1));
    let back = cycle.first().map(|(state, _)| (state + 1).to_string());
    steps.chain(back).collect()
}

impl DirectedError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoStates => "no-states",
            Self::TooManyStates { .. } => "too-many-states",
            Self::NoMaps { .. } => "no-maps",
            Self::TooManyMaps { .. } | Self::TooManyMapsInAll { .. } => "too-many-maps",
            Self::From { .. } => "state",
            Self::NotFinite { .. } => "not-finite",
            Self::NoAttractor { .. } => "no-attractor",
            Self::Unproved => "attractor-unproved",
            Self::Ifs(error) => error.code(),
        }
    }
}
