//! The fast answer: one parameter of a locus.

use frond_core::{Affine2, IfsError};
use glam::DMat2;

use crate::bounded::Bounded;
use crate::dive::Dive;
use crate::frame::Frame;
use crate::outline::Outline;
use crate::proof;
use crate::rift::{Bracket, Rift};

/// What is known of one parameter. The numbers are those of the state arrays of a locus.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum State {
    /// Proved to be in one piece.
    Connected = 0,
    /// In one piece as far as the resolution tells: the pieces come within epsilon of each other.
    Touching = 1,
    /// Proved to be in several pieces.
    Disconnected = 2,
    /// The budget was spent before an answer was found.
    Undecided = 3,
    /// The maps have no attractor.
    NoAttractor = 4,
}

impl State {
    /// Whether the attractor is in one piece as far as is known.
    #[must_use]
    pub const fn holds(self) -> bool {
        matches!(self, Self::Connected | Self::Touching)
    }

    /// The state of this number, `None` above 4.
    #[must_use]
    pub const fn from_code(code: u8) -> Option<Self> {
        match code {
            0 => Some(Self::Connected),
            1 => Some(Self::Touching),
            2 => Some(Self::Disconnected),
            3 => Some(Self::Undecided),
            4 => Some(Self::NoAttractor),
            _ => None,
        }
    }
}

/// The answer of [`decide`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The verdict.
    pub state: State,
    /// The widest gap over the diameter of the attractor: 0 where it holds together. Mostly to 5 in 100, but
    /// off by a factor of two or so in the rare case that its bounds close slowly. Where it is undecided, an
    /// upper bound, or NaN if it is not even known whether there is an attractor; NaN where there is none.
    pub gap: f32,
}

/// The memory that [`decide`] works in; keep one for many calls.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    pub(crate) frame: Frame,
    pub(crate) outline: Outline,
    pub(crate) dive: Dive,
    pub(crate) rift: Rift,
}

/// Decides whether the attractor of raw maps is connected, and how wide its widest gap is.
///
/// `epsilon` is relative to the diameter of the attractor; `budget` limits the pairs of pieces looked
/// at (20,000 is plenty). The answer depends on the arguments alone, not on what `scratch` was used
/// for before. For bounds of the gap use [`decide_bounds`], for the components and points
/// [`connectedness`](crate::connectedness).
pub fn decide(maps: &[Affine2], epsilon: f64, budget: usize, scratch: &mut Scratch) -> Sample {
    scratch.decide(maps, epsilon, budget, false).sample
}

/// [`decide`], with what is proved about the widest gap and about where the attractor lies.
///
/// ```
/// use frond_core::Affine2;
/// use frond_locus::{Scratch, decide_bounds};
///
/// // Cantor's dust, twice as large: its gap is a third of it.
/// let third = 1.0 / 3.0;
/// let maps = [0.0, 4.0 * third].map(|e| Affine2::from_row([third, 0.0, 0.0, third, e, 0.0]));
/// let known = decide_bounds(&maps, 1e-4, 20_000, &mut Scratch::default());
/// assert!(known.lower * known.diameter <= 2.0 * third && 2.0 * third <= known.upper * known.diameter);
/// ```
pub fn decide_bounds(maps: &[Affine2], epsilon: f64, budget: usize, scratch: &mut Scratch) -> Bounded {
    scratch.decide(maps, epsilon, budget, true)
}

impl Scratch {
    /// Without `bounds`, the diameter and the bounds are not computed where the verdict does not need them.
    fn decide(&mut self, maps: &[Affine2], epsilon: f64, budget: usize, bounds: bool) -> Bounded {
        let Self { frame, outline, dive, rift } = self;
        match frame.set(maps) {
            Ok(()) => {}
            Err(IfsError::Unproved) => return Bounded::unknown(State::Undecided),
            Err(_) => return Bounded::unknown(State::NoAttractor),
        }
        let ellipse = Some(frame.ellipse());
        let whole = |state, upper, diameter| Bounded {
            sample: Sample { state, gap: 0.0 },
            lower: 0.0,
            upper,
            diameter,
            ellipse,
        };
        let proved = proof::at_once(maps);
        if frame.point {
            return whole(if proved { State::Connected } else { State::Touching }, 0.0, 0.0);
        }
        if proved {
            // The attractor lies in the unit disc of the frame.
            return whole(State::Connected, 0.0, 2.0 * frame.stretch);
        }
        let count = maps.len();
        rift.begin(frame, count);
        if !rift.is_whole() && dive.set(frame) {
            let near = epsilon * epsilon * dive.extent(frame);
            rift.join_near(|i, j| dive.meet(frame, i, j, near));
        }
        if rift.is_whole() && !bounds {
            return whole(State::Touching, f64::INFINITY, f64::NAN);
        }
        if frame.factor < SWIFT {
            outline.sketch(&frame.maps, 0.02 * (1.0 - frame.factor), 64);
        } else {
            outline.set(&frame.maps, 0.012 * (1.0 - frame.factor), 64);
        }
        let diameter = outline.diameter(frame.from_round);
        let bracket = if rift.is_whole() {
            Bracket { lower: 0.0, upper: 0.0 }
        } else {
            let resolution = frame.resolution(epsilon, diameter);
            rift.bracket(frame, outline, resolution, outline.diameter(DMat2::IDENTITY), budget)
        };
        // Points are computed: they may be this far off.
        let off = frame.rounding * frame.stretch;
        let relative = |length: f64| length / diameter;
        let (lower, upper) =
            (relative(bracket.lower) * (1.0 - SLACK), relative(rift.bottleneck() + off) * (1.0 + SLACK));
        if rift.is_whole() {
            return whole(State::Touching, upper, diameter);
        }
        let sample = if lower > 0.0 {
            let middle = f64::midpoint(bracket.lower, bracket.upper);
            Sample { state: State::Disconnected, gap: relative(middle) as f32 }
        } else {
            Sample { state: State::Undecided, gap: relative(bracket.upper) as f32 }
        };
        Bounded { sample, lower, upper, diameter, ellipse }
    }
}

/// Maps that shrink more slowly than this add up what a rough outline is too wide.
const SWIFT: f64 = 0.8;
/// What the last few operations may add to a bound, relative to it.
const SLACK: f64 = 1e-14;
