//! What may be chosen about a morph, and what can be wrong with it.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::sort::is_permutation;

/// How the linear parts are interpolated.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Mode {
    /// The polar factors: the angle turns, the stretch is interpolated element by element (Burch & Hart
    /// 1997, eq 6).
    #[default]
    Polar,
    /// The matrices element by element, which may flatten a map on the way (their Fig 3).
    Linear,
}

/// Which way maps go that turn by half a turn, which is as short either way.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum HalfTurns {
    /// As eq 6 of Burch & Hart (1997) has it, by the signs of the angles: the same way from either end.
    #[default]
    Signs,
    /// All of them counter-clockwise.
    CounterClockwise,
    /// All of them clockwise.
    Clockwise,
}

/// What may be chosen about a morph.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MorphOptions {
    /// How the linear parts are interpolated.
    pub mode: Mode,
    /// `correspondence[i]` is the map of the last system that map i of the first becomes. Empty: the same
    /// index.
    pub correspondence: Vec<usize>,
    /// Whole extra turns of each map, counter-clockwise, -16 to 16; in space about the axis of its turn that points up.
    /// Empty: the shortest turn.
    pub turns: Vec<i32>,
}

impl MorphOptions {
    /// The map of the last system that each of the first becomes.
    pub(crate) fn order(&self, from: usize, to: usize) -> Result<Vec<usize>, MorphError> {
        if from != to {
            return Err(MorphError::Counts { from, to });
        }
        let order =
            if self.correspondence.is_empty() { (0..from).collect() } else { self.correspondence.clone() };
        if !is_permutation(&order, from) {
            return Err(MorphError::Correspondence { maps: from });
        }
        let fits = |turns: &[i32]| turns.len() == from && turns.iter().all(|t| (-16..=16).contains(t));
        if !(self.turns.is_empty() || fits(&self.turns)) {
            return Err(MorphError::Turns { maps: from });
        }
        Ok(order)
    }
}

/// Why two systems cannot be morphed as asked.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum MorphError {
    /// They have different numbers of maps.
    #[error("The first shape has {from} maps and the last {to}. Bring them to one number first (pair them).")]
    Counts {
        /// Maps of the first.
        from: usize,
        /// Maps of the last.
        to: usize,
    },
    /// The correspondence does not name each map of the last system once.
    #[error("The correspondence must name each of the {maps} maps once.")]
    Correspondence {
        /// Number of maps.
        maps: usize,
    },
    /// The turns are not one for each map.
    #[error("The turns must be {maps} whole numbers between -16 and 16.")]
    Turns {
        /// Number of maps.
        maps: usize,
    },
}

impl MorphError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Counts { .. } => "map-counts",
            Self::Correspondence { .. } => "correspondence",
            Self::Turns { .. } => "turns",
        }
    }
}

/// What both ends of one map have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Neither end reflects.
    Turning,
    /// Both reflect, and so does every map between them.
    Reflecting,
    /// One reflects and the other does not: somewhere between them the map is flat, on every way.
    Opposite,
}
