//! What there is in space, at each moment.

use frond_core::{
    Affine3, Course, Ease, IfsError, Key3, Morph3, MorphError, Motion3, MotionError, Place3, TransformError,
    along,
};
use glam::{DQuat, DVec3};
use thiserror::Error;

use crate::space::document::{Repeat, Space, SpaceKey, SpaceObject, affine, system};
use crate::space::part::SpaceView;
use crate::space::preset::Row3;

/// Why a space cannot be shown, or not at a moment.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FilmError {
    /// The keys of an object do not go together.
    #[error("The keys of “{name}” cannot be played. {source}")]
    Object {
        /// Its name.
        name: String,
        /// Why.
        source: MotionError,
    },
    /// Some keys mirror an object, and others do not.
    #[error(
        "A key mirrors “{name}”, and another does not: nothing that is not flat lies between them. Mirror it in all keys, \
         or in none."
    )]
    Mirror {
        /// Its name.
        name: String,
    },
    /// The keys of the view, or of the morph, do not go together.
    #[error("The keys of the time line cannot be played. {0}")]
    Keys(MotionError),
    /// The first object cannot be morphed so.
    #[error("“{name}” cannot be morphed. {source}")]
    Morph {
        /// Its name.
        name: String,
        /// Why.
        source: MorphError,
    },
    /// A moment has no attractor.
    #[error("“{name}” has no attractor here: {source} It is shown as it was last.")]
    Moment {
        /// Its name.
        name: String,
        /// Why.
        source: IfsError,
    },
    /// A place cannot be undone.
    #[error("“{name}” cannot be there. {source}")]
    Place {
        /// Its name.
        name: String,
        /// Why.
        source: TransformError,
    },
}

impl FilmError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Object { source, .. } | Self::Keys(source) => source.code(),
            Self::Mirror { .. } => "film-mirror",
            Self::Morph { source, .. } => source.code(),
            Self::Moment { source, .. } => source.code(),
            Self::Place { source, .. } => source.code(),
        }
    }
}

/// An object at a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// The maps it is made with.
    pub maps: Vec<Row3>,
    /// What was done to it.
    pub moved: Row3,
    /// The parameters that come of both (Darwish & Abd-El-Wahab, eq 1).
    pub now: Vec<Row3>,
    /// How far the control points of its lattice are moved, where keys say so.
    pub bend: Option<Vec<[f64; 3]>>,
}

/// All that is at a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The objects.
    pub objects: Vec<Moved>,
    /// Where it is seen from, where a key says so.
    pub view: Option<SpaceView>,
    /// Where along the path of the morph, where there is one.
    pub t: Option<f64>,
}

/// A [`Space`] that can be asked for any moment.
///
/// Transforms go from key to key by their polar factors: shifts and the logarithms of stretches straight or along
/// monotone cubics, turns as quaternions ([`Motion3`]); shapes by [`Morph3`]. Where an object has no key it stays what
/// it is. In a loop, keys beyond its end wait; from one at its end it jumps to one at its beginning, unless both say
/// the same.
#[derive(Clone, Debug)]
pub struct Film {
    actors: Vec<Actor>,
    morph: Option<Change>,
    view: Option<Flight>,
    /// After how many seconds it goes back, where it goes to and fro.
    back: Option<f64>,
}

/// Where it is seen from.
#[derive(Clone, Debug)]
struct Flight {
    /// Targets, and logarithms of distances.
    places: Motion3,
    /// Turns, tilts and angles of view; once round, where it loops.
    angles: Motion3,
    /// In a loop, when it begins and how long it is: it may end whole turns further.
    round: Option<[f64; 2]>,
}

impl Flight {
    fn at(&self, time: f64) -> SpaceView {
        let place = self.places.place(time);
        let time = match self.round {
            // The end of a loop is not its beginning where a key stands at both.
            Some([first, period]) if time.is_finite() && time != first + period => {
                first + (time - first).rem_euclid(period)
            }
            _ => time,
        };
        let angles = self.angles.place(time).shift;
        SpaceView {
            target: place.shift.to_array(),
            distance: place.scale.x,
            turn: angles.x,
            tilt: angles.y,
            angle: angles.z.clamp(1e-3, 3.1),
            holds: None,
        }
    }
}

#[derive(Clone, Debug)]
struct Actor {
    name: String,
    maps: Vec<Affine3>,
    shapes: Option<Motion3>,
    moved: Affine3,
    places: Option<Motion3>,
    /// -1 where all keys mirror it.
    side: f64,
    /// The ways of the control points of its lattice.
    bend: Option<Vec<Motion3>>,
}

#[derive(Clone, Debug)]
struct Change {
    family: Morph3,
    path: Vec<DVec3>,
    t: f64,
    times: Option<Motion3>,
}

/// How keys are joined.
#[derive(Clone, Copy)]
struct Joined {
    course: Course,
    period: Option<f64>,
}

/// Stands where a time line holds places alone.
fn nothing() -> Vec<Key3<Vec<Affine3>>> {
    let half = Affine3::scaling(DVec3::splat(0.5));
    vec![Key3 { time: 0.0, ease: Ease::Even, value: vec![half] }]
}

impl Joined {
    /// A time line of what `of` finds in keys; none where it finds nothing.
    fn places<E>(
        self,
        keys: &[&SpaceKey],
        of: impl Fn(&SpaceKey) -> Option<Result<Place3, E>>,
        fail: impl Fn(MotionError) -> E,
    ) -> Result<Option<Motion3>, E> {
        let found =
            |key: &&SpaceKey| of(key).map(|value| Ok(Key3 { time: key.at, ease: key.ease, value: value? }));
        let places = keys.iter().filter_map(found).collect::<Result<Vec<_>, E>>()?;
        if places.is_empty() {
            return Ok(None);
        }
        Motion3::new(places, nothing(), self.course, self.period).map(Some).map_err(fail)
    }
}

fn shifted(shift: DVec3) -> Place3 {
    Place3 { shift, ..Place3::HOME }
}

impl Film {
    /// The film of a space.
    ///
    /// # Errors
    /// [`FilmError`] where keys cannot be played, or the morph is none.
    pub fn new(space: &Space) -> Result<Self, FilmError> {
        let line = space.timeline.as_ref();
        let joined = Joined {
            course: line.map_or(Course::Straight, |line| line.course),
            period: line.filter(|line| line.repeat == Repeat::Round).map(|line| line.seconds),
        };
        let back = line.filter(|line| line.repeat == Repeat::PingPong).map(|line| line.seconds);
        let counts = |key: &&SpaceKey| joined.period.is_none_or(|period| key.at <= period);
        let keys: Vec<&SpaceKey> = line.map_or(Vec::new(), |line| line.keys.iter().filter(counts).collect());
        let actors = space
            .objects
            .iter()
            .enumerate()
            .map(|(index, object)| Actor::new(object, index, &keys, joined))
            .collect::<Result<Vec<_>, _>>()?;
        let morph = space.morph.as_ref().map(|morph| {
            let name = || space.objects.first().map_or_else(String::new, |object| object.shape.name.clone());
            let from = actors.first().map_or(&[][..], |actor| &actor.maps);
            let family = Morph3::new(from, &affine(&morph.to.maps), &morph.options())
                .map_err(|source| FilmError::Morph { name: name(), source })?;
            let middle = morph.path.points.iter().map(|p| DVec3::new(p.u, p.v, p.w));
            let path = [DVec3::ZERO].into_iter().chain(middle).chain([DVec3::new(1.0, 1.0, 0.0)]).collect();
            let time = |key: &SpaceKey| key.t.map(|t| Ok(shifted(DVec3::splat(t))));
            let times = joined.places(&keys, time, FilmError::Keys)?;
            Ok::<_, FilmError>(Change { family, path, t: morph.t, times })
        });
        Ok(Self { morph: morph.transpose()?, view: view_of(&keys, joined)?, actors, back })
    }

    /// All that is at a time, in seconds; NaN counts as 0.
    ///
    /// # Errors
    /// [`FilmError`] where a moment between keys has no attractor, or a place cannot be undone.
    pub fn at(&self, time: f64) -> Result<Moment, FilmError> {
        let time = match self.back {
            Some(back) if time.is_finite() => {
                let time = time.rem_euclid(2.0 * back);
                if time > back { 2.0 * back - time } else { time }
            }
            _ => time,
        };
        let t = self.morph.as_ref().map(|morph| {
            morph.times.as_ref().map_or(morph.t, |times| times.place(time).shift.x.clamp(0.0, 1.0))
        });
        let mut objects = Vec::with_capacity(self.actors.len());
        for (index, actor) in self.actors.iter().enumerate() {
            let morphed = self.morph.as_ref().filter(|_| index == 0).zip(t).map(|(morph, t)| {
                let p = along(&morph.path, t);
                morph.family.at3(p.x, p.y, p.z)
            });
            objects.push(actor.at(time, morphed)?);
        }
        let view = self.view.as_ref().map(|flight| flight.at(time));
        Ok(Moment { objects, view, t })
    }
}

/// The views of keys: targets and logarithms of distances, and angles, each by itself, so that the horizon stays level.
fn view_of(keys: &[&SpaceKey], joined: Joined) -> Result<Option<Flight>, FilmError> {
    let place = |key: &SpaceKey| {
        let view = key.view.as_ref()?;
        let scale = DVec3::splat(view.distance);
        Some(Place3::new(DVec3::from_array(view.target), DQuat::IDENTITY, scale))
    };
    let wrong = |error: MotionError| error;
    let place = |key: &SpaceKey| place(key).map(|found| found.map_err(MotionError::from));
    let places = joined.places(keys, place, wrong).map_err(FilmError::Keys)?;
    // The shorter way round, from key to key, and in a loop from the last to the first.
    let whole = std::f64::consts::TAU;
    let near = |turn: f64, to: f64| turn + whole * ((to - turn) / whole).round();
    let mut turns: Vec<(f64, f64)> = Vec::new();
    for key in keys {
        if let Some(view) = &key.view {
            let turn = turns.last().map_or(view.turn, |&(_, before)| near(view.turn, before));
            turns.push((key.at, turn));
        }
    }
    let mut angles: Vec<Key3<Place3>> = keys
        .iter()
        .filter_map(|key| key.view.as_ref().map(|view| (key, view)))
        .zip(&turns)
        .map(|((key, view), &(time, turn))| Key3 {
            time,
            ease: key.ease,
            value: shifted(DVec3::new(turn, view.tilt, view.angle)),
        })
        .collect();
    let mut round = None;
    if let (Some(period), [first, ..], [.., last]) = (joined.period, &turns[..], &turns[..]) {
        round = Some([first.0, period]);
        let turned = near(first.1, last.1) - first.1;
        let cut = last.0 - first.0 == period;
        // One at the end that looks as the one at the beginning, if a whole turn further, is that one again.
        let off = angles[angles.len() - 1].value.shift - angles[0].value.shift - DVec3::X * turned;
        if cut && off.abs().max_element() < 1e-9 {
            angles.pop();
        }
        if !cut || angles.len() < turns.len() {
            // The keys around the seam once more, a loop earlier and later.
            let again = |key: &Key3<Place3>, loops: f64| Key3 {
                time: key.time + loops * period,
                ease: key.ease,
                value: shifted(key.value.shift + DVec3::X * turned * loops),
            };
            let count = angles.len();
            let before = again(&angles[count - 1], -1.0);
            let after = [again(&angles[0], 1.0), again(&angles[1 % count], 1.0)];
            angles.insert(0, before);
            angles.extend(after);
            angles.dedup_by(|a, b| a.time == b.time);
        }
    }
    if angles.is_empty() {
        return Ok(None);
    }
    let angles = Motion3::new(angles, nothing(), joined.course, None).map_err(FilmError::Keys)?;
    Ok(places.map(|places| Flight { places, angles, round }))
}

/// The ways of the control points of an object's lattice; none where no key says where they are.
fn lattice(
    object: &SpaceObject,
    index: usize,
    keys: &[&SpaceKey],
    joined: Joined,
    wrong: impl Fn(MotionError) -> FilmError,
) -> Result<Option<Vec<Motion3>>, FilmError> {
    let Some(bend) = &object.bend else { return Ok(None) };
    let count = bend.moves.len();
    let moves = |key: &SpaceKey| key.bends.get(index)?.as_ref().filter(|moves| moves.len() == count).cloned();
    let found: Vec<(f64, Ease, Vec<[f64; 3]>)> =
        keys.iter().filter_map(|key| Some((key.at, key.ease, moves(key)?))).collect();
    if found.is_empty() {
        return Ok(None);
    }
    let way = |point: usize| {
        let key = |(time, ease, moves): &(f64, Ease, Vec<[f64; 3]>)| Key3 {
            time: *time,
            ease: *ease,
            value: shifted(DVec3::from_array(moves[point])),
        };
        let keys = found.iter().map(key).collect();
        Motion3::new(keys, nothing(), joined.course, joined.period).map_err(&wrong)
    };
    (0..count).map(way).collect::<Result<_, _>>().map(Some)
}

impl Actor {
    fn new(
        object: &SpaceObject,
        index: usize,
        keys: &[&SpaceKey],
        joined: Joined,
    ) -> Result<Self, FilmError> {
        let name = object.shape.name.clone();
        let maps = affine(&object.shape.maps);
        let shape = |key: &&SpaceKey| {
            let value = affine(key.maps.get(index)?.as_ref()?);
            Some(Key3 { time: key.at, ease: key.ease, value })
        };
        let shapes: Vec<_> = keys.iter().filter_map(shape).collect();
        let wrong = |source| FilmError::Object { name: name.clone(), source };
        let shapes = if shapes.is_empty() {
            None
        } else {
            Some(Motion3::new(Vec::new(), shapes, joined.course, joined.period).map_err(wrong)?)
        };
        let moved = |key: &SpaceKey| Some(Affine3::from_row((*key.moved.get(index)?)?));
        let sides: Vec<f64> =
            keys.iter().filter_map(|key| moved(key)).map(|by| by.determinant().signum()).collect();
        let side = sides.first().copied().unwrap_or(1.0);
        if sides.iter().any(|other| *other != side) {
            return Err(FilmError::Mirror { name });
        }
        let place = |key: &SpaceKey| {
            let by = moved(key)?;
            Some(Place3::of(by).map_err(|error| wrong(MotionError::from(error))))
        };
        let places = joined.places(keys, place, wrong)?;
        let bend = lattice(object, index, keys, joined, wrong)?;
        let moved = object.moved.map_or(Affine3::IDENTITY, Affine3::from_row);
        Ok(Self { maps, shapes, moved, places, side, bend, name })
    }

    fn at(&self, time: f64, morphed: Option<Vec<Affine3>>) -> Result<Moved, FilmError> {
        let maps = morphed
            .or_else(|| self.shapes.as_ref().map(|shapes| shapes.shape(time)))
            .unwrap_or_else(|| self.maps.clone());
        let moved = self.places.as_ref().map_or(self.moved, |places| {
            let place = places.place(time).transform();
            Affine3::new(place.linear * self.side, place.translation)
        });
        let name = || self.name.clone();
        let rows: Vec<Row3> = maps.iter().map(|map| map.to_row()).collect();
        let now = if moved == Affine3::IDENTITY {
            rows.clone()
        } else {
            let ifs = system(&rows).map_err(|source| FilmError::Moment { name: name(), source })?;
            let there = ifs.conjugate(moved).map_err(|source| FilmError::Place { name: name(), source })?;
            there.maps().iter().map(|map| map.to_row()).collect()
        };
        system(&now).map_err(|source| FilmError::Moment { name: name(), source })?;
        let by = |way: &Motion3| way.place(time).shift.to_array();
        let bend = self.bend.as_ref().map(|ways| ways.iter().map(by).collect());
        Ok(Moved { maps: rows, moved: moved.to_row(), now, bend })
    }
}

#[cfg(test)]
mod tests;
