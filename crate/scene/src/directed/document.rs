//! Graph-directed shapes in a document.

use frond_core::{Affine2, DirectedError, DirectedIfs, DirectedMap, MAX_MAPS, MAX_STATES};
use serde::{Deserialize, Serialize};

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
}

impl DirectedShape {
    /// The shape of the gallery with this id.
    #[must_use]
    pub fn of_preset(id: &str) -> Option<Self> {
        let found = directed_presets().into_iter().find(|preset| preset.id == id)?;
        let copy = |part: &DirectedMap| DirectedCopy { from: part.from, map: part.map.to_row() };
        let states = found.states.iter().map(|maps| maps.iter().map(copy).collect()).collect();
        Some(Self { preset: Some(found.id.to_owned()), name: found.name.to_owned(), states })
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
            return Err(DirectedError::TooManyStates { count });
        }
        if let Some(state) = self.states.iter().position(|maps| maps.len() > MAX_MAPS) {
            return Err(DirectedError::TooManyMaps { state, count: self.states[state].len() });
        }
        let map = |part: &DirectedCopy| DirectedMap { from: part.from, map: Affine2::from_row(part.map) };
        Ok(self.states.iter().map(|maps| maps.iter().map(map).collect()).collect())
    }
}

/// The ends of a morph between graph-directed shapes.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Directed {
    /// The first.
    pub a: DirectedShape,
    /// The last.
    pub b: DirectedShape,
}
