//! Graph-directed shapes in a document.

use frond_core::{Affine2, DirectedError, DirectedIfs, DirectedMap, HalfTurns, MAX_MAPS, MAX_STATES};
use frond_fit::{ClosedCurve, PackError};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::preset::directed_presets;
use crate::preset::Row;

/// A copy of a state: [`DirectedMap`] as it is written in documents.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct DirectedCopy {
    /// The state that is copied, from 0.
    pub from: usize,
    /// How.
    pub map: Row,
}

/// One end of a morph between graph-directed shapes. A system of maps is one of a single state.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct DirectedShape {
    /// Its id in the gallery, while it is that of the gallery.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Its name.
    pub name: String,
    /// Its states, each as its maps; the first is the shape that is meant.
    pub states: Vec<Vec<DirectedCopy>>,
    /// The closed curve that the states are made of, as links have it, while they are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outline: Option<String>,
}

impl DirectedShape {
    /// The shape of the gallery with this id.
    #[must_use]
    pub fn of_preset(id: &str) -> Option<Self> {
        let found = directed_presets().into_iter().find(|preset| preset.id == id)?;
        Some(Self {
            preset: Some(found.id.to_owned()),
            name: found.name.to_owned(),
            states: written(&found.states),
            outline: None,
        })
    }

    /// A closed curve as a shape of several states, which run from point to point
    /// ([`ClosedCurve::to_chain`]).
    ///
    /// # Errors
    /// [`OutlineError`] where it cannot be packed or has too many edges.
    pub fn of_outline(name: &str, curve: &ClosedCurve) -> Result<Self, OutlineError> {
        let text = curve.to_text()?;
        Self::of_text(name, &text)
    }

    /// The shape of a closed curve that is packed as in links.
    ///
    /// # Errors
    /// [`OutlineError`] where it is no curve or has too many edges.
    pub fn of_text(name: &str, text: &str) -> Result<Self, OutlineError> {
        let curve = ClosedCurve::from_text(text)?;
        let states = written(&curve.chain_states()?);
        Ok(Self { preset: None, name: name.to_owned(), states, outline: Some(curve.to_text()?) })
    }

    /// Its system.
    ///
    /// # Errors
    /// [`DirectedError`] where the states are none, or have no attractor.
    pub fn system(&self) -> Result<DirectedIfs, DirectedError> {
        DirectedIfs::new(self.maps()?)
    }

    /// Refuses what is seen to be no shape, at once. What is left may still have no attractor: whoever draws it says
    /// so.
    ///
    /// # Errors
    /// [`DirectedError`] as [`DirectedIfs::refuse_obvious`].
    pub fn refuse_obvious(&self) -> Result<(), DirectedError> {
        DirectedIfs::refuse_obvious(&self.maps()?)
    }

    fn maps(&self) -> Result<Vec<Vec<DirectedMap>>, DirectedError> {
        // Before any memory is asked for: the lists may be of any length.
        let count = self.states.len();
        if count > MAX_STATES {
            return Err(DirectedError::TooManyStates { count, most: MAX_STATES });
        }
        if let Some(state) = self.states.iter().position(|maps| maps.len() > MAX_MAPS) {
            return Err(DirectedError::TooManyMaps { state, count: self.states[state].len() });
        }
        let map = |part: &DirectedCopy| DirectedMap { from: part.from, map: Affine2::from_row(part.map) };
        Ok(self.states.iter().map(|maps| maps.iter().map(map).collect()).collect())
    }
}

fn written(states: &[Vec<DirectedMap>]) -> Vec<Vec<DirectedCopy>> {
    let copy = |part: &DirectedMap| DirectedCopy { from: part.from, map: part.map.to_row() };
    states.iter().map(|maps| maps.iter().map(copy).collect()).collect()
}

/// Why a closed curve is no shape of several states.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum OutlineError {
    /// It cannot be packed, or what was packed is no curve.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// It takes more states than there may be.
    #[error(transparent)]
    States(#[from] DirectedError),
}

impl OutlineError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Pack(error) => error.code(),
            Self::States(error) => error.code(),
        }
    }
}

/// The ends of a morph between graph-directed shapes.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Directed {
    /// The first.
    pub a: DirectedShape,
    /// The last.
    pub b: DirectedShape,
    /// Which way maps go that turn by half a turn.
    #[serde(default, rename = "halfTurns", skip_serializing_if = "by_signs")]
    pub half_turns: HalfTurns,
}

fn by_signs(half: &HalfTurns) -> bool {
    *half == HalfTurns::Signs
}
