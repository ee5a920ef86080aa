//! From one graph-directed system to another.

use thiserror::Error;

use crate::directed::around::Around;
use crate::directed::error::MAX_STATES;
use crate::directed::map::DirectedMap;
use crate::directed::matching::Matching;
use crate::directed::system::DirectedIfs;
use crate::linear::affine::Affine2;
use crate::morph::interpolation::Morph;
use crate::morph::options::{HalfTurns, Mode, MorphOptions};

/// Why two graph-directed systems cannot be morphed.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum DirectedMorphError {
    /// Their graphs are too different.
    #[error(
        "To match these two graphs takes more than {MAX_STATES} states, since every state may become several. Choose \
         shapes whose states copy each other more alike."
    )]
    TooManyStates,
}

impl DirectedMorphError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        "graph-match"
    }
}

/// A family of graph-directed systems over (u, v), the first at (0, 0) and the last at (1, 1): what [`Morph`] is for
/// systems of one state. Burch & Hart (1997, section 7.1) ask for it; their eq 6 is what each map follows.
///
/// The graphs need not be the same. They are matched from the shapes (state 0) on: each map of a state becomes one
/// of the other's, and so does what they copy; a state that becomes several is split, and where one has fewer maps some
/// are doubled. This changes neither shape. States that a shape is not made of are left out, unless the graphs are the
/// same.
///
/// A plain system that grows from a foot to a tip, as ferns do, becomes an outline otherwise: the way around it, up and
/// down each leaf, becomes the way around the outline. Pieces that follow each other share their feet and
/// tips then, and in [`Mode::Linear`] they do so all the way.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectedMorph {
    /// Which state of the first becomes which of the last.
    states: Vec<(usize, usize)>,
    /// Of each state what its maps copy.
    arrows: Vec<Vec<usize>>,
    morph: Morph,
    steps: Vec<String>,
}

impl DirectedMorph {
    /// The family from `from` to `to`, each map by the shortest turn.
    ///
    /// # Errors
    /// [`DirectedMorphError`] if the graphs cannot be matched.
    pub fn new(from: &DirectedIfs, to: &DirectedIfs, mode: Mode) -> Result<Self, DirectedMorphError> {
        Self::turning(from, to, mode, HalfTurns::default())
    }

    /// The same, where maps that turn by half a turn go one way or the other.
    ///
    /// # Errors
    /// [`DirectedMorphError`] if the graphs cannot be matched.
    pub fn turning(
        from: &DirectedIfs,
        to: &DirectedIfs,
        mode: Mode,
        half: HalfTurns,
    ) -> Result<Self, DirectedMorphError> {
        let mut family = Self::matched(from, to, mode)?;
        let least = match half {
            HalfTurns::Signs => return Ok(family),
            HalfTurns::CounterClockwise => 0..=1,
            HalfTurns::Clockwise => -1..=0,
        };
        let other = family.morph.other_half_turns().into_iter();
        let turns = other.map(|turn| if least.contains(&turn) { turn } else { 0 }).collect();
        let [first, last] = [0.0, 1.0].map(|end| family.morph.at(end, end));
        let options = MorphOptions { mode, turns, ..MorphOptions::default() };
        family.morph = Morph::new(&first, &last, &options).map_err(|_| DirectedMorphError::TooManyStates)?;
        Ok(family)
    }

    fn matched(from: &DirectedIfs, to: &DirectedIfs, mode: Mode) -> Result<Self, DirectedMorphError> {
        if let Some(around) = Around::of(from, to) {
            return Self::around(&around, false, mode);
        }
        if let Some(around) = Around::of(to, from) {
            return Self::around(&around, true, mode);
        }
        let matching = Matching::of(from, to).ok_or(DirectedMorphError::TooManyStates)?;
        let (mut first, mut last) = (Vec::new(), Vec::new());
        for (&(i, j), maps) in matching.states.iter().zip(&matching.maps) {
            first.extend(maps.iter().map(|&(p, _, _)| from.states()[i][p].map));
            last.extend(maps.iter().map(|&(_, q, _)| to.states()[j][q].map));
        }
        let steps = steps(&matching);
        let arrows = matching.maps.iter().map(|maps| maps.iter().map(|&(_, _, from)| from).collect());
        Ok(Self {
            arrows: arrows.collect(),
            morph: between(&first, &last, mode)?,
            states: matching.states,
            steps,
        })
    }

    /// A plant that becomes an outline, or the other way.
    fn around(around: &Around, swapped: bool, mode: Mode) -> Result<Self, DirectedMorphError> {
        let maps = |states: &[Vec<DirectedMap>]| -> Vec<Affine2> {
            states.iter().flatten().map(|part| part.map).collect()
        };
        let (plant, outline) = (maps(&around.plant_maps), maps(&around.outline_maps));
        let (first, last) = if swapped { (&outline, &plant) } else { (&plant, &outline) };
        let pair = |&state: &usize| if swapped { (state, 0) } else { (0, state) };
        let [plant, outline] = if swapped { ["last", "first"] } else { ["first", "last"] };
        let arrows = around.plant_maps.iter().map(|maps| maps.iter().map(|part| part.from).collect());
        Ok(Self {
            arrows: arrows.collect(),
            states: around.outline.iter().map(pair).collect(),
            morph: between(first, last, mode)?,
            steps: vec![format!(
                "The way around the {plant} shape, up and down its leaves, was parted into {} stretches: each becomes \
                 an edge of the {outline} shape.",
                around.steps
            )],
        })
    }

    /// Which state of the first system becomes which of the last, a pair for each state on the way.
    #[must_use]
    pub fn states(&self) -> &[(usize, usize)] {
        &self.states
    }

    /// How the linear parts are interpolated.
    #[must_use]
    pub const fn mode(&self) -> Mode {
        self.morph.mode()
    }

    /// By how much each map turns in all, in radians, state after state: none in a linear morph.
    #[must_use]
    pub fn turns(&self) -> Vec<f64> {
        let turned = |turn: &(f64, f64)| if self.mode() == Mode::Linear { 0.0 } else { turn.1 };
        self.morph.turns().iter().map(turned).collect()
    }

    /// How many maps turn by half a turn, which is as short either way.
    #[must_use]
    pub fn half_turns(&self) -> usize {
        self.morph.other_half_turns().into_iter().filter(|&turn| turn != 0).count()
    }

    /// A sentence for each step that was taken to match the graphs; none where they are the same.
    #[must_use]
    pub fn steps(&self) -> &[String] {
        &self.steps
    }

    /// The states at (u, v). Any parameters are allowed; there need not be an attractor.
    #[must_use]
    pub fn at(&self, u: f64, v: f64) -> Vec<Vec<DirectedMap>> {
        let maps: Vec<Affine2> = self.morph.at(u, v);
        let mut rest = maps.into_iter();
        let state = |of: &Vec<usize>| {
            of.iter().zip(rest.by_ref()).map(|(&from, map)| DirectedMap { from, map }).collect()
        };
        self.arrows.iter().map(state).collect()
    }
}

/// They are equally many, and nothing is asked for but the mode.
fn between(first: &[Affine2], last: &[Affine2], mode: Mode) -> Result<Morph, DirectedMorphError> {
    let options = MorphOptions { mode, ..MorphOptions::default() };
    Morph::new(first, last, &options).map_err(|_| DirectedMorphError::TooManyStates)
}

fn steps(matching: &Matching) -> Vec<String> {
    let mut steps = Vec::new();
    for (which, name) in [(0, "A"), (1, "B")] {
        let state = |pair: &(usize, usize)| if which == 0 { pair.0 } else { pair.1 };
        for one in 0..MAX_STATES {
            let times = matching.states.iter().filter(|&pair| state(pair) == one).count();
            if times > 1 {
                let (one, times) = (one + 1, times);
                steps.push(format!("State {one} of shape {name} is used {times} times."));
            }
        }
        match matching.doubled[which] {
            0 => {}
            1 => steps.push(format!("One map of shape {name} is used twice.")),
            count => steps.push(format!("{count} maps of shape {name} are used more than once.")),
        }
    }
    steps
}
