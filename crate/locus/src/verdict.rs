//! What is asked about an attractor, and the words of the answers.

use glam::{DMat2, DVec2};

/// What is known about whether an attractor is in one piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// Proved to be in one piece.
    Connected,
    /// Proved to be in pieces.
    Disconnected,
    /// In one piece as far as the resolution tells: the pieces come within epsilon of each other.
    Touching,
    /// The budget was spent before an answer was found.
    Undecided,
}

impl Verdict {
    /// Its name in the programming interface.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Connected => "connected",
            Self::Disconnected => "disconnected",
            Self::Touching => "touching",
            Self::Undecided => "undecided",
        }
    }

    /// Whether the attractor is in one piece as far as is known.
    #[must_use]
    pub const fn holds(self) -> bool {
        matches!(self, Self::Connected | Self::Touching)
    }
}

/// How finely and how long to look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Pieces within this distance touch, relative to the diameter of the attractor. Below some 1e-14 it
    /// is raised to what floating point can tell apart; NaN and negative numbers count as 0.
    pub epsilon: f64,
    /// The most pairs of pieces to look at, for the verdict and for the gap each.
    pub budget: usize,
}

impl Default for Options {
    /// What a picture of 600 pixels resolves.
    fn default() -> Self {
        Self { epsilon: 1.0 / 600.0, budget: 400_000 }
    }
}

/// Bounds of a distance in plane units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gap {
    /// It is at least this.
    pub lower: f64,
    /// It is at most this: two points of the attractor are as near, rounding reckoned with.
    pub upper: f64,
}

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

impl Gap {
    /// Whether both bounds can be true of a shape of at most this diameter. NaN is none of it.
    pub(crate) fn is_possible(self, diameter: f64) -> bool {
        0.0 <= self.lower && self.lower <= self.upper && self.upper <= diameter && diameter.is_finite()
    }
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

/// The answer of [`decide`](crate::decide()).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The verdict.
    pub state: State,
    /// The widest gap over the diameter of the attractor: 0 where it holds together. Mostly to 5 in 100, but
    /// off by a factor of two or so in the rare case that its bounds close slowly. Where it is undecided, an
    /// upper bound, or NaN if it is not even known whether there is an attractor; NaN where there is none.
    pub gap: f32,
}

/// An ellipse that holds the attractor, and whose shape the maps shrink.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Its centre, in the plane.
    pub centre: DVec2,
    /// Takes differences of points of the plane to coordinates where the ellipse is the unit disc: the
    /// attractor lies where `|to_round (x - centre)| <= 1`.
    pub to_round: DMat2,
    /// Its inverse.
    pub from_round: DMat2,
    /// In these coordinates every block shrinks distances by this factor or less.
    pub factor: f64,
    /// The letters of the longest block: 1 where the blocks are the maps themselves.
    pub length: usize,
}

impl Ellipse {
    fn is_finite(&self) -> bool {
        self.centre.is_finite() && self.to_round.is_finite() && self.from_round.is_finite()
    }
}

/// The answer of [`decide_bounds`](crate::decide_bounds).
///
/// With `g` the widest gap (the widest edge of the minimum spanning tree of the distances between pieces,
/// in the plane), `lower * diameter <= g <= upper * diameter`, rounding reckoned with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// What [`decide`](crate::decide) says.
    pub sample: Sample,
    /// A lower bound of the widest gap over `diameter`: above 0 only where the attractor is proved disconnected.
    pub lower: f64,
    /// An upper bound of the widest gap over `diameter`, shown by points of the attractor; 0 where it is
    /// proved connected. Infinite where nothing is known.
    pub upper: f64,
    /// An upper bound of the diameter of the attractor, in units of the plane: 0 if it is one point, NaN
    /// where it is not known to exist.
    pub diameter: f64,
    /// Where the attractor lies and how fast it contracts; `None` where it is not known to exist, or so small, below
    /// 1e-300, that no double holds the inverse of its size.
    pub ellipse: Option<Ellipse>,
}

impl Bounded {
    /// The answer as it is; or `Undecided` where its numbers contradict each other or are none, so that one of them is
    /// wrong, and nobody knows which. Every answer of [`decide`](crate::decide()) goes through here.
    pub(crate) fn or_undecided(self) -> Self {
        let Self { sample, lower, upper, diameter, ellipse } = self;
        let possible = match sample.state {
            State::Disconnected => {
                let gap = Gap { lower, upper: upper.min(1.0) };
                let seen = (0.0..=1.0).contains(&sample.gap) && lower > 0.0 && !upper.is_nan();
                seen && gap.is_possible(1.0) && diameter > 0.0 && diameter.is_finite()
            }
            // What was not asked for is NaN and infinite.
            State::Connected | State::Touching => lower == 0.0 && upper >= 0.0 && diameter != f64::INFINITY,
            State::Undecided | State::NoAttractor => true,
        };
        if possible {
            return Self { ellipse: ellipse.filter(Ellipse::is_finite), ..self };
        }
        // No gap is wider than the shape.
        let sample = Sample { state: State::Undecided, gap: 1.0 };
        Self { sample, ..Self::unknown(State::Undecided) }
    }

    /// The answer where it is not known whether there is an attractor, or known that there is none.
    pub(crate) const fn unknown(state: State) -> Self {
        let sample = Sample { state, gap: f32::NAN };
        Self { sample, lower: 0.0, upper: f64::INFINITY, diameter: f64::NAN, ellipse: None }
    }
}

/// The kinds of reasons.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum ReasonKind {
    /// There is one map.
    OneMap,
    /// All maps are the same.
    EqualMaps,
    /// All maps leave one point where it is: it is the attractor.
    CommonPoint,
    /// Two maps whose determinants leave no room between the pieces; or several such pairs.
    Area,
    /// Enough pairs of pieces have a point in common.
    SharedPoints,
    /// Enough pairs of pieces must cross.
    Crossings,
    /// The attractor lies on a line, and enough pairs of pieces overlap there.
    Line,
    /// Copies of one shape and direction that are moved by differences of its points.
    Differences,
    /// Enough pairs of pieces have points in common, infinitely many, and lie to each other in finitely many ways.
    Neighbours,
}

impl ReasonKind {
    /// Its name in the programming interface.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::OneMap => "one-map",
            Self::EqualMaps => "equal-maps",
            Self::CommonPoint => "common-point",
            Self::Area => "area",
            Self::SharedPoints => "shared-points",
            Self::Crossings => "crossings",
            Self::Line => "line",
            Self::Differences => "differences",
            Self::Neighbours => "neighbours",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn apart() -> Bounded {
        let sample = Sample { state: State::Disconnected, gap: 0.3 };
        Bounded { sample, lower: 0.29, upper: 0.31, diameter: 2.0, ..Bounded::unknown(State::Undecided) }
    }

    #[test]
    fn numbers_that_contradict_each_other_are_no_answer() {
        assert_eq!(apart().or_undecided().sample, apart().sample);
        let gap = |gap: f32| Bounded { sample: Sample { gap, ..apart().sample }, ..apart() };
        let broken = [
            Bounded { lower: 0.7, upper: 9e-14, ..apart() },
            Bounded { lower: f64::INFINITY, upper: f64::INFINITY, ..apart() },
            Bounded { lower: f64::NAN, ..apart() },
            Bounded { lower: 0.0, ..apart() },
            Bounded { upper: f64::NAN, ..apart() },
            Bounded { diameter: f64::NAN, ..apart() },
            Bounded { diameter: f64::INFINITY, ..apart() },
            Bounded { diameter: 0.0, ..apart() },
            gap(f32::NAN),
            gap(1.5),
            gap(-0.1),
        ];
        for broken in broken {
            let answer = broken.or_undecided();
            assert_eq!(answer.sample, Sample { state: State::Undecided, gap: 1.0 }, "{broken:?}");
            assert!(answer.lower == 0.0 && answer.upper == f64::INFINITY, "{answer:?}");
        }
        for state in [State::Connected, State::Touching] {
            let whole = Bounded { lower: 0.0, upper: 0.0, ..Bounded::unknown(state) };
            assert_eq!(whole.or_undecided().sample.state, state);
            for broken in [
                Bounded { lower: 0.1, ..whole },
                Bounded { upper: f64::NAN, ..whole },
                Bounded { diameter: f64::INFINITY, ..whole },
            ] {
                assert_eq!(broken.or_undecided().sample.state, State::Undecided, "{broken:?}");
            }
        }
    }

    #[test]
    fn an_ellipse_that_is_none_is_not_told_of() {
        let round = Ellipse {
            centre: DVec2::ZERO,
            to_round: DMat2::IDENTITY,
            from_round: DMat2::IDENTITY,
            factor: 0.5,
            length: 1,
        };
        assert_eq!(Bounded { ellipse: Some(round), ..apart() }.or_undecided().ellipse, Some(round));
        let lost = Ellipse { to_round: DMat2::NAN, ..round };
        assert_eq!(Bounded { ellipse: Some(lost), ..apart() }.or_undecided().ellipse, None);
    }
}
