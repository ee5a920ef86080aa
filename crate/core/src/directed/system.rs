//! Graph-directed systems.

use std::ops::Range;

use glam::DVec2;

use crate::directed::contraction::DirectedContraction;
use crate::directed::error::{DirectedError, MAX_STATES, MOST_FOUND_MAPS, MOST_FOUND_STATES};
use crate::directed::map::DirectedMap;
use crate::directed::{measure, reach};
use crate::error::MAX_MAPS;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::linear::transform::TransformError;

/// A graph-directed iterated function system of the plane: states, each a union of 1 to 64 copies of states. Made by
/// hand ([`DirectedIfs::new`]) there are 1 to 64 of them, found by a search ([`DirectedIfs::found`]) up to 1024.
///
/// State i stands for a compact set `K_i`, and these are the only ones with
///
/// ```text
/// K_i = union of  map(K_from)  over the maps of state i
/// ```
///
/// (Mauldin & Williams 1988; recurrent systems, Barnsley, Elton & Hardin 1989). They exist exactly if all ways round
/// through the graph contract, which [`DirectedIfs::new`] checks; a map that is on no way round may be any, the
/// identity too. State 0 is the shape that is meant; it may be made of others that are not made of it. An [`Ifs`]
/// is the case of one state.
///
/// ```
/// use frond_core::{Affine2, DirectedIfs, DirectedMap, Ifs, directed_dimension};
///
/// // The unit square and its diagonal half, each cut into copies of both.
/// let half = |e, f| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f]);
/// let square = |e, f| DirectedMap { from: 0, map: half(e, f) };
/// let corner = |e, f| DirectedMap { from: 1, map: half(e, f) };
/// let states = vec![
///     vec![square(0.0, 0.0), square(0.5, 0.0), square(0.0, 0.5), square(0.5, 0.5)],
///     vec![square(0.0, 0.0), corner(0.5, 0.0), corner(0.0, 0.5)],
/// ];
/// let both = DirectedIfs::new(states)?;
/// assert!((directed_dimension(&both, 1).unwrap_or(0.0) - 2.0).abs() < 1e-9);
/// # Ok::<(), frond_core::DirectedError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DirectedIfs {
    states: Vec<Vec<DirectedMap>>,
    probabilities: Vec<Vec<f64>>,
    contraction: DirectedContraction,
}

impl DirectedIfs {
    /// A system of these states. Each map is as probable as its copy is large.
    ///
    /// # Errors
    /// [`DirectedError`] where they are none, or have no attractor.
    pub fn new(states: Vec<Vec<DirectedMap>>) -> Result<Self, DirectedError> {
        check(&states, MAX_STATES)?;
        Self::checked(states)
    }

    /// The same of states that were found, not made by hand: up to [`MOST_FOUND_STATES`] of them, of up to
    /// [`MOST_FOUND_MAPS`] maps in all.
    ///
    /// # Errors
    /// As [`DirectedIfs::new`].
    pub fn found(states: Vec<Vec<DirectedMap>>) -> Result<Self, DirectedError> {
        check(&states, MOST_FOUND_STATES)?;
        let count = states.iter().map(Vec::len).sum();
        if count > MOST_FOUND_MAPS {
            return Err(DirectedError::TooManyMapsInAll { count });
        }
        Self::checked(states)
    }

    fn checked(states: Vec<Vec<DirectedMap>>) -> Result<Self, DirectedError> {
        if let [maps] = states.as_slice() {
            return Ok(Self::from(&Ifs::new(maps.iter().map(|part| part.map).collect())?));
        }
        let contraction = DirectedContraction::find(&states)?;
        let probabilities = measure::probabilities(&states);
        Ok(Self { states, probabilities, contraction })
    }

    /// Refuses states that are seen to be no system, without the search of [`DirectedIfs::new`], which may refuse more.
    ///
    /// # Errors
    /// [`DirectedError`] where they are none, or the way round that scales most does not contract.
    pub fn refuse_obvious(states: &[Vec<DirectedMap>]) -> Result<(), DirectedError> {
        check(states, MAX_STATES)?;
        if let [maps] = states {
            Ifs::new(maps.iter().map(|part| part.map).collect())?;
            return Ok(());
        }
        DirectedContraction::refuse_obvious(states)
    }

    /// A recurrent system: piece i is the copy, by its map, of the pieces in its span. State 0 is all pieces
    /// together, state i + 1 is piece i.
    ///
    /// # Errors
    /// [`DirectedError`], as [`DirectedIfs::new`]; an empty span makes a state without maps.
    pub fn recurrent(maps: &[Affine2], spans: &[Range<usize>]) -> Result<Self, DirectedError> {
        // What has no span has no maps either, and is told of as such. Of endless spans no more is built than will be
        // refused.
        let of = |map: Affine2, span: Range<usize>| -> Vec<DirectedMap> {
            span.take(MAX_MAPS + 1).map(|piece| DirectedMap { from: piece.saturating_add(1), map }).collect()
        };
        let pieces = maps.len().min(MAX_STATES);
        let mut states = vec![of(Affine2::IDENTITY, 0..maps.len())];
        states.extend((0..pieces).map(|i| of(maps[i], spans.get(i).cloned().unwrap_or_default())));
        Self::new(states)
    }

    /// The states, each as its maps.
    #[must_use]
    pub fn states(&self) -> &[Vec<DirectedMap>] {
        &self.states
    }

    /// The number of states, 1 to [`MOST_FOUND_STATES`].
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a system is never empty")]
    pub fn len(&self) -> usize {
        self.states.len()
    }

    /// How probable each map of each state is; of every state their sum is 1.
    #[must_use]
    pub fn probabilities(&self) -> &[Vec<f64>] {
        &self.probabilities
    }

    /// Coordinates in which the maps contract.
    #[must_use]
    pub fn contraction(&self) -> &DirectedContraction {
        &self.contraction
    }

    /// For each state whether this one is made of it, at any depth; itself too. None where there is no such state.
    #[must_use]
    pub fn reached(&self, state: usize) -> Vec<bool> {
        if state < self.len() { reach::reached(&self.states, state) } else { vec![false; self.len()] }
    }

    /// The states that the shape, state 0, is not made of at any depth: they are not seen in it.
    #[must_use]
    pub fn unreached(&self) -> Vec<usize> {
        let seen = reach::reached(&self.states, 0);
        (0..self.len()).filter(|&state| !seen[state]).collect()
    }

    /// The states that are not made of smaller copies of themselves at any depth: no way leads back to them.
    #[must_use]
    pub fn never_return(&self) -> Vec<usize> {
        (0..self.len()).filter(|&state| !reach::returns(&self.states, state)).collect()
    }

    /// A point of each state: the end of the way that takes the first map each time.
    #[must_use]
    pub fn points(&self) -> Vec<DVec2> {
        let end = |state: usize| {
            let mut way = vec![state];
            let mut at = self.states[state][0].from;
            while !way.contains(&at) {
                way.push(at);
                at = self.states[at][0].from;
            }
            let lead = way.iter().position(|&met| met == at).unwrap_or(0);
            let first = |state: &usize| self.states[*state][0].map;
            let round = way[lead..].iter().map(first).fold(Affine2::IDENTITY, |word, map| word * map);
            let fixed = round.fixed_point().unwrap_or(self.contraction.discs[at].centre);
            way[..lead].iter().rev().map(first).fold(fixed, |point, map| map.apply(point))
        };
        (0..self.len()).map(end).collect()
    }

    /// The same shapes elsewhere, each moved by a transform of its own: `K_i` becomes its image under `by[i]`. States
    /// beyond the end of `by` stay.
    ///
    /// # Errors
    /// [`TransformError`] as [`Affine2::undo`], or [`DirectedError`] as [`DirectedIfs::found`] where the numbers become
    /// too large or rounding leaves it open whether the maps contract.
    pub fn moved(&self, by: &[Affine2]) -> Result<Result<Self, DirectedError>, TransformError> {
        let back: Vec<Affine2> = by.iter().map(|transform| transform.undo()).collect::<Result<_, _>>()?;
        let at = |of: &[Affine2], state: usize| of.get(state).copied().unwrap_or(Affine2::IDENTITY);
        let part = |into: usize, part: &DirectedMap| DirectedMap {
            map: at(by, into) * part.map * at(&back, part.from),
            ..*part
        };
        let states = self.states.iter().enumerate();
        let states = states.map(|(into, maps)| maps.iter().map(|map| part(into, map)).collect());
        // As many states as there were, which may have been found.
        Ok(Self::found(states.collect())
            .map(|moved| Self { probabilities: self.probabilities.clone(), ..moved }))
    }
}

impl From<&Ifs> for DirectedIfs {
    /// One state that is made of itself.
    fn from(ifs: &Ifs) -> Self {
        Self {
            states: vec![ifs.maps().iter().map(|&map| DirectedMap { from: 0, map }).collect()],
            probabilities: vec![ifs.probabilities().to_vec()],
            contraction: DirectedContraction::of_one(ifs.contraction()),
        }
    }
}

/// Numbers beyond this make products of maps overflow.
const LARGEST_NUMBER: f64 = 1e100;

fn check(states: &[Vec<DirectedMap>], most: usize) -> Result<(), DirectedError> {
    let count = states.len();
    if count == 0 {
        return Err(DirectedError::NoStates);
    }
    if count > most {
        return Err(DirectedError::TooManyStates { count, most });
    }
    for (state, maps) in states.iter().enumerate() {
        if maps.is_empty() {
            return Err(DirectedError::NoMaps { state });
        }
        if maps.len() > MAX_MAPS {
            return Err(DirectedError::TooManyMaps { state, count: maps.len() });
        }
        for (map, part) in maps.iter().enumerate() {
            if part.from >= count {
                return Err(DirectedError::From { state, map, from: part.from, states: count });
            }
            if !part.map.to_row().iter().all(|x| x.abs() < LARGEST_NUMBER) {
                return Err(DirectedError::NotFinite { state, map });
            }
        }
    }
    Ok(())
}
