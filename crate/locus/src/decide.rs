//! The fast answer: one parameter of a locus.

use frond_core::{Affine2, IfsError};

use crate::frame::Frame;
use crate::outline::Outline;
use crate::proof;
use crate::search::Search;

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
    pub(crate) search: Search,
}

/// How far the bounds of a gap may differ, relative to it, to be good enough for a picture.
const SHADE: f64 = 0.05;
/// Looks spent at most on measuring the gap of one disconnected parameter.
const SHADING: usize = 2000;

/// Decides whether the attractor of raw maps is connected, and how wide its widest gap is.
///
/// `epsilon` is relative to the diameter of the attractor; `budget` limits the pairs of pieces looked
/// at (20,000 is plenty). The answer depends on the arguments alone, not on what `scratch` was used
/// for before. For the components, bounds and points use [`connectedness`](crate::connectedness).
pub fn decide(maps: &[Affine2], epsilon: f64, budget: usize, scratch: &mut Scratch) -> Sample {
    let Scratch { frame, outline, search } = scratch;
    match frame.set(maps) {
        Ok(()) => {}
        Err(IfsError::Unproved) => return Sample { state: State::Undecided, gap: f32::NAN },
        Err(_) => return Sample { state: State::NoAttractor, gap: f32::NAN },
    }
    let whole = |state| Sample { state, gap: 0.0 };
    if proof::at_once(maps) {
        return whole(State::Connected);
    }
    if frame.point {
        return whole(State::Touching);
    }
    outline.set(&frame.maps, 0.012 * (1.0 - frame.factor), 64);
    search.begin(frame, outline, epsilon);
    let settled = search.settle(frame, outline, budget);
    if search.components.count() == 1 {
        return whole(State::Touching);
    }
    let apart = settled || search.coarsest().count() > 1;
    let span = search.span(frame, outline, SHADE, 0.0, search.nodes + SHADING);
    let diameter = search.plane_diameter;
    if apart {
        let middle = f64::midpoint(span.lower, span.upper);
        Sample { state: State::Disconnected, gap: (middle / diameter) as f32 }
    } else {
        Sample { state: State::Undecided, gap: (span.upper / diameter) as f32 }
    }
}
