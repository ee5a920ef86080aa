//! Key frames: places and parameters at times, and what they are at each moment between.

use glam::DVec3;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::animation::placement::Place3;
use crate::animation::spline::{cubic, cubic_turn, straight};
use crate::error::IfsError;
use crate::ifs::system::Ifs3;
use crate::linear::affine::Affine3;
use crate::linear::transform::TransformError;
use crate::morph::interpolation::Morph3;
use crate::morph::options::{MorphError, MorphOptions};

/// How a value goes from one key to the next.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Ease {
    /// At an even pace.
    #[default]
    Even,
    /// Slowly at first.
    In,
    /// Slowly at last.
    Out,
    /// Slowly at first and at last.
    InOut,
    /// It stays, and jumps at the next key.
    Hold,
}

impl Ease {
    /// The part of the way after the part `t` of the time, both from 0 to 1.
    #[must_use]
    pub fn at(self, t: f64) -> f64 {
        let t = t.clamp(0.0, 1.0);
        match self {
            Self::Even => t,
            Self::In => t * t,
            Self::Out => t * (2.0 - t),
            Self::InOut => t * t * (3.0 - 2.0 * t),
            Self::Hold => f64::from(u8::from(t >= 1.0)),
        }
    }
}

/// The way from place to place.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Course {
    /// Straight from key to key, the turn about one axis.
    #[default]
    Straight,
    /// Without a jerk at the keys, and never past them: each coordinate stays between those of two keys, and a turn
    /// within a sixth of its angle of the shortest arc.
    Smooth,
}

/// A value at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Key3<T> {
    /// When, in seconds.
    pub time: f64,
    /// How it goes on to the next key.
    pub ease: Ease,
    /// The value.
    pub value: T,
}

/// Why a time line cannot be played.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MotionError {
    /// There is no key with parameters.
    #[error("There is no key with a shape. Add one.")]
    NoKeys,
    /// There are more keys than [`Motion3::MOST_KEYS`].
    #[error("There are {count} keys, and the most is 1000. Remove some.")]
    TooManyKeys {
        /// Their number.
        count: usize,
    },
    /// A time is not finite, or two keys of one kind have the same.
    #[error("Key {} has no time of its own. Give each key a number of seconds that no other has.", .key + 1)]
    Time {
        /// Index of the key among those of its kind in the order of their times, from 0.
        key: usize,
    },
    /// The length of the loop does not hold all keys.
    #[error("The loop of {period} s ends before the last key, or has no length. Make it longer.")]
    Period {
        /// Its length in seconds.
        period: f64,
    },
    /// The shapes of two keys cannot be morphed.
    #[error(transparent)]
    Morph(#[from] MorphError),
    /// A moment has no attractor.
    #[error(transparent)]
    Ifs(#[from] IfsError),
    /// A place cannot be undone.
    #[error(transparent)]
    Transform(#[from] TransformError),
}

impl MotionError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoKeys => "motion-no-keys",
            Self::TooManyKeys { .. } => "motion-keys",
            Self::Time { .. } => "motion-time",
            Self::Period { .. } => "motion-period",
            Self::Morph(error) => error.code(),
            Self::Ifs(error) => error.code(),
            Self::Transform(error) => error.code(),
        }
    }
}

/// A time line of one object: where it is, and what its parameters are, at each moment. Each moment is a set of
/// parameters: that of the shape, conjugated by its place (Darwish & Abd-El-Wahab, section 3.6).
///
/// Shifts and logarithms of scales go straight or along monotone cubics, turns about one axis or along a cubic of
/// turns, and shapes by [`Morph3`] from key to key. Before the first key and after the last all stays as it is there;
/// in a loop, the last goes on to the first. Where one stands at the beginning of a loop and another at its end, it
/// jumps from the one to the other; where both say the same, it goes on without a seam.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion3 {
    places: Vec<Key3<Place3>>,
    shapes: Vec<Key3<Vec<Affine3>>>,
    /// From each key with a shape to the next.
    morphs: Vec<Morph3>,
    course: Course,
    period: Option<f64>,
}

impl Motion3 {
    /// The most keys of each kind.
    pub const MOST_KEYS: usize = 1000;

    /// A time line of these keys, in any order; without places the object stays at home. `period` is the length of a
    /// loop in seconds, from time 0 on, `None` where it does not repeat. Keys may stand at its end.
    ///
    /// # Errors
    /// [`MotionError`] where keys are missing, too many or without times of their own, where shapes that follow each
    /// other cannot be morphed, or a key has no attractor.
    pub fn new(
        mut places: Vec<Key3<Place3>>,
        mut shapes: Vec<Key3<Vec<Affine3>>>,
        course: Course,
        period: Option<f64>,
    ) -> Result<Self, MotionError> {
        order(&mut places, period)?;
        order(&mut shapes, period)?;
        if shapes.is_empty() {
            return Err(MotionError::NoKeys);
        }
        for key in &places {
            Place3::new(key.value.shift, key.value.turn, key.value.scale)?;
            key.value.transform().undo()?;
        }
        for key in &shapes {
            Ifs3::new(key.value.clone())?;
        }
        if let Some(period) = period {
            close(&mut places, period);
            close(&mut shapes, period);
        }
        let count = shapes.len();
        let cut = period.is_some_and(|period| shapes[count - 1].time - shapes[0].time == period);
        let ends = if period.is_some() && !cut { count } else { count - 1 };
        let morph = |k: usize| {
            let [from, to] = [k, (k + 1) % count].map(|k| &shapes[k].value);
            let morph = Morph3::new(from, to, &MorphOptions::default())?;
            // A half turn is counter-clockwise, as it looks to whoever turns something by a key.
            let turns: Vec<i32> = morph.other_half_turns().iter().map(|&turn| turn.max(0)).collect();
            Morph3::new(from, to, &MorphOptions { turns, ..MorphOptions::default() })
        };
        let morphs = (0..ends).map(morph).collect::<Result<_, _>>()?;
        Ok(Self { places, shapes, morphs, course, period })
    }

    /// The keys with places, in the order of their times; of a loop without the one at its end that says what its first
    /// says.
    #[must_use]
    pub fn places(&self) -> &[Key3<Place3>] {
        &self.places
    }

    /// The keys with shapes, as [`Self::places`].
    #[must_use]
    pub fn shapes(&self) -> &[Key3<Vec<Affine3>>] {
        &self.shapes
    }

    /// From the first key to the last, in seconds, or the length of the loop.
    #[must_use]
    pub fn length(&self) -> f64 {
        let last = |times: Vec<f64>| times.into_iter().fold(0.0, f64::max);
        let times = self.places.iter().map(|k| k.time).chain(self.shapes.iter().map(|k| k.time));
        self.period.unwrap_or_else(|| last(times.collect()))
    }

    /// Where the object is at a time; any number will do, NaN counts as 0.
    #[must_use]
    pub fn place(&self, time: f64) -> Place3 {
        let keys = &self.places;
        let Some(leg) = self.leg(keys, time) else { return Place3::HOME };
        let [_, from, to, _] = leg.keys;
        let (a, b) = (keys[from].value, keys[to].value);
        if leg.part == 0.0 || a == b {
            return a;
        }
        if leg.part == 1.0 {
            return b;
        }
        let values = leg.keys.map(|k| keys[k].value);
        let along = |p: [DVec3; 4]| match self.course {
            Course::Straight => straight(p[1], p[2], leg.part),
            Course::Smooth => cubic(p, leg.times, leg.part),
        };
        let turn = match self.course {
            Course::Straight if a.turn == b.turn => a.turn,
            Course::Straight => a.turn.slerp(b.turn, leg.part).normalize(),
            Course::Smooth => cubic_turn(values.map(|p| p.turn), leg.times, leg.part),
        };
        // As factors of the first, so that what is equal stays equal.
        let scale = a.scale * exp(along(values.map(|p| log(p.scale / a.scale))));
        Place3 {
            shift: along(values.map(|p| p.shift)),
            turn,
            scale: scale.clamp(a.scale.min(b.scale), a.scale.max(b.scale)),
            shear: along(values.map(|p| p.shear)),
        }
    }

    /// The parameters of the shape at a time, before it is moved to its place.
    #[must_use]
    pub fn shape(&self, time: f64) -> Vec<Affine3> {
        let Some(leg) = self.leg(&self.shapes, time) else { return Vec::new() };
        let from = leg.keys[1];
        match self.morphs.get(from) {
            Some(morph) => morph.at(leg.part, leg.part),
            None => self.shapes[from].value.clone(),
        }
    }

    /// The set of parameters at a time: the shape, moved to its place.
    ///
    /// # Errors
    /// [`MotionError::Ifs`] where the shape between two keys has no attractor, [`MotionError::Transform`] where the
    /// place is out of range: both ends of a leg may be well, and what is between them not.
    pub fn at(&self, time: f64) -> Result<Ifs3, MotionError> {
        let ifs = Ifs3::new(self.shape(time))?;
        let place = self.place(time);
        if place == Place3::HOME { Ok(ifs) } else { Ok(ifs.conjugate(place.transform())?) }
    }

    /// Where a time falls among keys: which of them are around it, and the eased part of the way.
    fn leg<T>(&self, keys: &[Key3<T>], time: f64) -> Option<Leg> {
        let count = keys.len();
        let last = count.checked_sub(1)?;
        let time = if time.is_nan() { 0.0 } else { time };
        let (low, high) = (keys[0].time, keys[last].time);
        let Some(period) = self.period else {
            let time = time.clamp(low, high);
            let from =
                keys.partition_point(|key| key.time <= time).saturating_sub(1).min(last.saturating_sub(1));
            let around = [from.saturating_sub(1), from, (from + 1).min(last), (from + 2).min(last)];
            return Some(Leg::new(keys, around, around.map(|k| keys[k].time), time));
        };
        let time = once_round(time, low, period);
        let from = keys.partition_point(|key| key.time <= time).saturating_sub(1);
        // As often round as it takes, from the loop before on.
        let around = [from + last, from + count, from + count + 1, from + count + 2];
        let times = around.map(|k| keys[k % count].time + period * ((k / count) as f64 - 1.0));
        Some(Leg::new(keys, around.map(|k| k % count), times, time))
    }
}

/// The same moment of a loop within one round from `first` on. The end of it is kept: it is not the beginning where a
/// key stands at both.
pub(crate) fn once_round(time: f64, first: f64, period: f64) -> f64 {
    if time == first + period {
        return time;
    }
    let time = first + (time - first).rem_euclid(period);
    if time.is_finite() { time } else { first }
}

/// Leaves out a key at the end of a loop that says what the one at its beginning says: it is that one again.
fn close<T: PartialEq>(keys: &mut Vec<Key3<T>>, period: f64) {
    if let [first, .., last] = &keys[..]
        && last.time - first.time == period
        && last.value == first.value
    {
        keys.pop();
    }
}

/// Four keys around a time, of which it lies between the middle two.
struct Leg {
    keys: [usize; 4],
    times: [f64; 4],
    part: f64,
}

impl Leg {
    fn new<T>(values: &[Key3<T>], keys: [usize; 4], times: [f64; 4], time: f64) -> Self {
        let span = times[2] - times[1];
        let part = if span > 0.0 { (time - times[1]) / span } else { 0.0 };
        Self { keys, times, part: values[keys[1]].ease.at(part) }
    }
}

fn log(v: DVec3) -> DVec3 {
    DVec3::new(v.x.ln(), v.y.ln(), v.z.ln())
}

fn exp(v: DVec3) -> DVec3 {
    DVec3::new(v.x.exp(), v.y.exp(), v.z.exp())
}

/// Sorts keys by their times and checks these.
fn order<T>(keys: &mut [Key3<T>], period: Option<f64>) -> Result<(), MotionError> {
    if keys.len() > Motion3::MOST_KEYS {
        return Err(MotionError::TooManyKeys { count: keys.len() });
    }
    keys.sort_by(|a, b| a.time.total_cmp(&b.time));
    if let Some(key) = keys.iter().position(|key| key.time.is_nan() || key.time.abs() >= 1e9) {
        return Err(MotionError::Time { key });
    }
    if let Some(key) = keys.windows(2).position(|two| two[0].time == two[1].time) {
        return Err(MotionError::Time { key: key + 1 });
    }
    if let Some(period) = period {
        let fits = |key: &Key3<T>| (0.0..=period).contains(&key.time);
        if !(period > 0.0 && period < 1e9 && keys.iter().all(fits)) {
            return Err(MotionError::Period { period });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;

    fn key<T>(time: f64, value: T) -> Key3<T> {
        Key3 { time, ease: Ease::Even, value }
    }

    fn place(x: f64, angle: f64, scale: f64) -> Place3 {
        Place3::new(DVec3::new(x, 0.0, 0.0), DQuat::from_rotation_z(angle), DVec3::splat(scale)).unwrap()
    }

    fn halves(ratio: f64) -> Vec<Affine3> {
        [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]
            .map(|c| Affine3::scaling(DVec3::splat(ratio)).about(c))
            .to_vec()
    }

    #[test]
    fn at_a_key_it_is_what_the_key_says() {
        let keys = [(0.0, place(0.0, 0.0, 1.0)), (2.0, place(4.0, 1.0, 4.0)), (3.0, place(5.0, 2.5, 0.5))];
        for course in [Course::Straight, Course::Smooth] {
            for period in [None, Some(5.0)] {
                let places = keys.map(|(time, value)| key(time, value)).to_vec();
                let motion = Motion3::new(places, vec![key(0.0, halves(0.5))], course, period).unwrap();
                for (time, value) in keys {
                    assert_eq!(motion.place(time), value, "{course:?} {time}");
                }
                // Nothing jumps.
                let mut last = motion.place(0.0).transform();
                for k in 0..=5000 {
                    let now = motion.place(f64::from(k) / 1000.0).transform();
                    let step = now
                        .to_row()
                        .iter()
                        .zip(last.to_row())
                        .map(|(a, b)| (a - b).abs())
                        .fold(0.0, f64::max);
                    assert!(step < 0.03, "{course:?} {period:?} {k}: {step}");
                    last = now;
                }
            }
        }
    }

    #[test]
    fn scales_go_by_factors_and_turns_about_one_axis() {
        let places = vec![key(0.0, place(0.0, 0.0, 1.0)), key(2.0, place(4.0, 1.0, 4.0))];
        let motion = Motion3::new(places, vec![key(0.0, halves(0.5))], Course::Straight, None).unwrap();
        let middle = motion.place(1.0);
        assert!((middle.scale.x - 2.0).abs() < 1e-12 && (middle.shift.x - 2.0).abs() < 1e-12);
        assert!(middle.turn.dot(DQuat::from_rotation_z(0.5)) > 1.0 - 1e-12);
        assert_eq!(motion.place(-9.0), place(0.0, 0.0, 1.0));
        assert_eq!(motion.place(f64::INFINITY), place(4.0, 1.0, 4.0));
        assert_eq!(motion.place(f64::NAN), place(0.0, 0.0, 1.0));
        assert_eq!(motion.length(), 2.0);
    }

    #[test]
    fn each_moment_is_a_set_of_parameters() {
        let shapes = vec![key(0.0, halves(0.5)), key(1.0, halves(0.3))];
        let places = vec![key(0.0, Place3::HOME), key(1.0, place(1.0, 0.0, 2.0))];
        let motion = Motion3::new(places, shapes, Course::Straight, None).unwrap();
        let now = motion.at(0.5).unwrap();
        assert!((now.maps()[0].norm() - 0.4).abs() < 1e-12);
        // The corner at 0 has gone half the way.
        assert!(now.maps()[0].fixed_point().unwrap().distance(DVec3::new(0.5, 0.0, 0.0)) < 1e-12);
        assert_eq!(motion.at(0.0).unwrap().maps(), halves(0.5));
    }

    #[test]
    fn a_loop_comes_back_and_goes_on() {
        let shapes = vec![key(0.0, halves(0.5)), key(1.0, halves(0.3))];
        let motion = Motion3::new(Vec::new(), shapes, Course::Smooth, Some(3.0)).unwrap();
        for time in [0.0, 0.4, 1.0, 2.9] {
            for turns in [-2.0, 1.0, 5.0] {
                let (now, then) = (motion.at(time).unwrap(), motion.at(time + 3.0 * turns).unwrap());
                assert!((now.maps()[0].norm() - then.maps()[0].norm()).abs() < 1e-9);
            }
        }
        // From the last key to the first takes two seconds.
        assert!((motion.at(2.0).unwrap().maps()[0].norm() - 0.4).abs() < 1e-12);
    }

    #[test]
    fn a_key_at_the_end_of_a_loop_is_reached_and_cut_from() {
        for course in [Course::Straight, Course::Smooth] {
            let places = vec![key(0.0, place(0.0, 0.0, 1.0)), key(6.0, place(6.0, 1.0, 4.0))];
            let shapes = vec![key(0.0, halves(0.5)), key(6.0, halves(0.3))];
            let motion = Motion3::new(places, shapes, course, Some(6.0)).unwrap();
            for k in 0..=60 {
                let part = f64::from(k) / 60.0;
                let now = motion.place(6.0 * part);
                // With nothing beyond the ends it is even.
                assert!((now.shift.x - 6.0 * part).abs() < 1e-9, "{course:?} {part}");
                assert!(now.turn.dot(DQuat::from_rotation_z(part)) > 1.0 - 1e-12, "{course:?} {part}");
            }
            assert_eq!(motion.place(6.0), place(6.0, 1.0, 4.0));
            assert_eq!(motion.shape(6.0), halves(0.3));
            assert_eq!(
                (motion.place(12.0), motion.place(-6.0)),
                (place(0.0, 0.0, 1.0), place(0.0, 0.0, 1.0))
            );
            assert_eq!(motion.shape(12.0), halves(0.5));
            assert!((motion.place(6.5).shift.x - 0.5).abs() < 1e-9);
        }
    }

    #[test]
    fn a_loop_that_ends_as_it_begins_has_no_seam() {
        let round = |last: Option<Place3>| {
            let values = [place(0.0, 0.0, 1.0), place(3.0, 1.0, 2.0), place(1.0, 2.5, 1.5)];
            let mut places: Vec<_> = (0..3).map(|k| key(2.0 * f64::from(k), values[k as usize])).collect();
            places.extend(last.map(|value| key(6.0, value)));
            Motion3::new(places, vec![key(0.0, halves(0.5))], Course::Smooth, Some(6.0)).unwrap()
        };
        let (with, without) = (round(Some(place(0.0, 0.0, 1.0))), round(None));
        assert!((0..=60).all(|k| with.place(0.1 * f64::from(k)) == without.place(0.1 * f64::from(k))));
        // As fast behind the seam as before it.
        let h = 1e-6;
        let speed = |time: f64| (with.place(time + h).shift - with.place(time - h).shift) / (2.0 * h);
        assert!(speed(6.0 - 2.0 * h).distance(speed(2.0 * h)) < 1e-4);
    }

    #[test]
    fn easing_keeps_the_ends() {
        for ease in [Ease::Even, Ease::In, Ease::Out, Ease::InOut, Ease::Hold] {
            assert_eq!((ease.at(0.0), ease.at(1.0)), (0.0, 1.0));
            assert!((0..100).all(|k| ease.at(f64::from(k) / 100.0) <= ease.at(f64::from(k + 1) / 100.0)));
        }
        assert_eq!((Ease::Hold.at(0.99), Ease::In.at(0.5), Ease::Out.at(0.5)), (0.0, 0.25, 0.75));
    }

    #[test]
    fn time_lines_that_are_none_are_refused() {
        let new = |times: &[f64], period| {
            let places = times.iter().map(|&t| key(t, Place3::HOME)).collect();
            Motion3::new(places, vec![key(0.0, halves(0.5))], Course::Straight, period).map(|_| ())
        };
        assert_eq!(new(&[0.0, 1.0, 0.5], None), Ok(()));
        assert_eq!(new(&[0.0, 1.0, 1.0], None), Err(MotionError::Time { key: 2 }));
        assert_eq!(new(&[f64::NAN], None), Err(MotionError::Time { key: 0 }));
        assert_eq!(new(&[0.0, 1.0], Some(1.0)), Ok(()));
        assert_eq!(new(&[0.0, 1.0], Some(0.9)), Err(MotionError::Period { period: 0.9 }));
        assert_eq!(new(&[0.0], Some(0.0)), Err(MotionError::Period { period: 0.0 }));
        assert_eq!(new(&vec![0.0; 1001], None), Err(MotionError::TooManyKeys { count: 1001 }));
        let shapes = |shapes| Motion3::new(Vec::new(), shapes, Course::Straight, None).unwrap_err().code();
        assert_eq!(shapes(vec![]), "motion-no-keys");
        assert_eq!(shapes(vec![key(0.0, halves(0.5)), key(1.0, halves(0.5)[..2].to_vec())]), "map-counts");
        assert_eq!(shapes(vec![key(0.0, halves(1.5))]), "no-attractor");
    }
}
