//! From one system to another.

use glam::{DMat2, DVec2};
use thiserror::Error;

use crate::linear::affine2::{Affine2, singular_values};
use crate::linear::polar2::{Polar2, orthogonal};

/// How the linear parts are interpolated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mode {
    /// The polar factors: the angle turns, the stretch is interpolated element by element (Burch & Hart
    /// 1997, eq 6).
    #[default]
    Polar,
    /// The matrices element by element, which may flatten a map on the way (their Fig 3).
    Linear,
}

/// What may be chosen about a morph.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MorphOptions {
    /// How the linear parts are interpolated.
    pub mode: Mode,
    /// `correspondence[i]` is the map of the last system that map i of the first becomes. Empty: the same
    /// index.
    pub correspondence: Vec<usize>,
    /// Whole extra turns of each map, counter-clockwise, -16 to 16. Empty: the shortest turn.
    pub turns: Vec<i32>,
}

impl MorphOptions {
    /// The map of the last system that each of the first becomes.
    pub(crate) fn order(&self, from: usize, to: usize) -> Result<Vec<usize>, MorphError> {
        if from != to {
            return Err(MorphError::Counts { from, to });
        }
        let identity: Vec<usize> = (0..from).collect();
        let order =
            if self.correspondence.is_empty() { identity.clone() } else { self.correspondence.clone() };
        let mut sorted = order.clone();
        sorted.sort_unstable();
        if sorted != identity {
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

/// A family of systems over (u, v): u turns and stretches, v moves; (0, 0) is the first system and
/// (1, 1) the last (Burch & Hart 1997, section 5). A third parameter, w, lets the stretch run ahead of the turn
/// ([`Morph::at3`]): their last section asks for a path through all three.
///
/// A singular map takes the kind of its other end, since it may be seen as either. Maps of opposite kinds
/// are written as a rotation times a symmetric matrix at both ends, so that the one that reflects has a
/// negative stretch along one axis, and goes through a collapse of that axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Morph {
    mode: Mode,
    pairs: Vec<Pair>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Pair {
    kind: Kind,
    from: Affine2,
    to: Affine2,
    angle: f64,
    turn: f64,
    stretch: [DMat2; 2],
}

impl Morph {
    /// The family from `from` to `to`.
    ///
    /// # Errors
    /// [`MorphError`] if the counts differ or the options do not fit them.
    pub fn new(from: &[Affine2], to: &[Affine2], options: &MorphOptions) -> Result<Self, MorphError> {
        let order = options.order(from.len(), to.len())?;
        let turn = |i: usize| options.turns.get(i).copied().unwrap_or(0);
        let pairs = order.iter().enumerate().map(|(i, &j)| Pair::new(from[i], to[j], turn(i))).collect();
        Ok(Self { mode: options.mode, pairs })
    }

    /// The number of maps.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pairs.len()
    }

    /// Whether there are no maps at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// How the linear parts are interpolated.
    #[must_use]
    pub const fn mode(&self) -> Mode {
        self.mode
    }

    /// The kind of each map.
    #[must_use]
    pub fn kinds(&self) -> Vec<Kind> {
        self.pairs.iter().map(|pair| pair.kind).collect()
    }

    /// The angle of each map at the start and its whole turn, in radians.
    #[must_use]
    pub fn turns(&self) -> Vec<(f64, f64)> {
        self.pairs.iter().map(|pair| (pair.angle, pair.turn)).collect()
    }

    /// The maps at (u, v). Any parameters are allowed; there need not be an attractor.
    #[must_use]
    pub fn at(&self, u: f64, v: f64) -> Vec<Affine2> {
        let mut maps = Vec::with_capacity(self.len());
        self.fill(u, v, &mut maps);
        maps
    }

    /// The maps at (u, v), written over what `maps` held: no memory is asked for in a loop.
    pub fn fill(&self, u: f64, v: f64, maps: &mut Vec<Affine2>) {
        self.fill3(u, v, 0.0, maps);
    }

    /// The maps at (u, v, w), where turn, stretch and move each have a parameter of their own: the map turns by u,
    /// is stretched by u + w and moved by v. The plane w = 0 is that of [`Morph::at`], and the ends are
    /// (0, 0, 0) and (1, 1, 0). A linear morph has no turn apart from its stretch, and leaves w out.
    #[must_use]
    pub fn at3(&self, u: f64, v: f64, w: f64) -> Vec<Affine2> {
        let mut maps = Vec::with_capacity(self.len());
        self.fill3(u, v, w, &mut maps);
        maps
    }

    /// [`Morph::at3`], written over what `maps` held.
    pub fn fill3(&self, u: f64, v: f64, w: f64, maps: &mut Vec<Affine2>) {
        maps.clear();
        maps.extend(self.pairs.iter().map(|pair| pair.at(u, v, w, self.mode)));
    }
}

impl Pair {
    fn new(from: Affine2, to: Affine2, extra: i32) -> Self {
        let ends = [from.linear, to.linear];
        let kind = match ends.map(reflects) {
            [None | Some(false), None | Some(false)] => Kind::Turning,
            [None | Some(true), None | Some(true)] => Kind::Reflecting,
            _ => Kind::Opposite,
        };
        let [p, q] = ends.map(|m| match kind {
            Kind::Reflecting => Polar2::reflecting(m),
            Kind::Turning | Kind::Opposite => Polar2::turning(m),
        });
        // An end without a direction of its own, such as the zero matrix, does not turn.
        let (angle, last) = match ends.map(|m| directed(m, kind)) {
            [true, true] => (p.angle, q.angle),
            [true, false] => (p.angle, p.angle),
            [false, true] => (q.angle, q.angle),
            [false, false] => (0.0, 0.0),
        };
        let stretch = [(ends[0], angle), (ends[1], last)]
            .map(|(m, angle)| symmetric(orthogonal(angle, kind == Kind::Reflecting).transpose() * m));
        let turn = shortest(last - angle) + std::f64::consts::TAU * f64::from(extra);
        Self { kind, from, to, angle, turn, stretch }
    }

    #[inline]
    fn at(&self, u: f64, v: f64, w: f64, mode: Mode) -> Affine2 {
        let translation = self.from.translation * (1.0 - v) + self.to.translation * v;
        let linear = match mode {
            Mode::Linear => mix(self.from.linear, self.to.linear, u),
            Mode::Polar => {
                // The ends are given back to the last bit.
                if u == 0.0 && w == 0.0 {
                    self.from.linear
                } else if u == 1.0 && w == 0.0 {
                    self.to.linear
                } else {
                    let q = orthogonal(u.mul_add(self.turn, self.angle), self.kind == Kind::Reflecting);
                    q * mix(self.stretch[0], self.stretch[1], u + w)
                }
            }
        };
        Affine2::new(linear, translation)
    }
}

fn mix(a: DMat2, b: DMat2, u: f64) -> DMat2 {
    a * (1.0 - u) + b * u
}

fn symmetric(m: DMat2) -> DMat2 {
    let off = f64::midpoint(m.x_axis.y, m.y_axis.x);
    DMat2::from_cols(DVec2::new(m.x_axis.x, off), DVec2::new(off, m.y_axis.y))
}

/// Whether a matrix reflects; `None` where it is singular and may be seen as either.
fn reflects(m: DMat2) -> Option<bool> {
    let (large, small) = singular_values(m);
    (small > 1e-12 * large).then(|| m.determinant() < 0.0)
}

/// Whether the rotation nearest to a matrix (or the reflection) is determined.
fn directed(m: DMat2, kind: Kind) -> bool {
    let (x, y) = (m.x_axis, m.y_axis);
    let direction = match kind {
        Kind::Reflecting => DVec2::new(x.x - y.y, x.y + y.x),
        Kind::Turning | Kind::Opposite => DVec2::new(x.x + y.y, x.y - y.x),
    };
    direction.length() > 1e-12 * singular_values(m).0
}

/// The same angle in (-pi, pi].
fn shortest(angle: f64) -> f64 {
    let turned = angle.rem_euclid(std::f64::consts::TAU);
    if turned > std::f64::consts::PI { turned - std::f64::consts::TAU } else { turned }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::any_map;

    fn options(mode: Mode) -> MorphOptions {
        MorphOptions { mode, ..MorphOptions::default() }
    }

    fn apart(a: Affine2, b: Affine2) -> f64 {
        a.to_row().iter().zip(b.to_row()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    }

    proptest! {
        #[test]
        fn it_goes_from_end_to_end_without_a_jump(a in any_map(), b in any_map(), linear: bool) {
            let mode = if linear { Mode::Linear } else { Mode::Polar };
            let morph = Morph::new(&[a], &[b], &options(mode)).unwrap();
            prop_assert!(apart(morph.at(0.0, 0.0)[0], a) == 0.0);
            prop_assert!(apart(morph.at(1.0, 1.0)[0], b) == 0.0);
            let mut last = a;
            for k in 0..=1000 {
                let t = f64::from(k) / 1000.0;
                let now = morph.at(t, t)[0];
                prop_assert!(apart(now, last) < 0.02, "jump of {} at {t}", apart(now, last));
                last = now;
            }
        }

        #[test]
        fn the_sign_of_the_determinant_is_kept(a in any_map(), b in any_map()) {
            let morph = Morph::new(&[a], &[b], &options(Mode::Polar)).unwrap();
            for k in 0..=20 {
                let det = morph.at(f64::from(k) / 20.0, 0.0)[0].determinant();
                match morph.kinds()[0] {
                    Kind::Turning => prop_assert!(det > -1e-12),
                    Kind::Reflecting => prop_assert!(det < 1e-12),
                    Kind::Opposite => {}
                }
            }
        }
    }

    proptest! {
        #[test]
        fn the_third_parameter_stretches_alone(
            a in any_map(), b in any_map(), u in -1.0..2.0_f64, v in -1.0..2.0_f64, w in -1.0..1.0_f64,
        ) {
            let morph = Morph::new(&[a], &[b], &options(Mode::Polar)).unwrap();
            prop_assert_eq!(morph.at3(0.0, 0.0, 0.0), vec![a]);
            prop_assert_eq!(morph.at3(1.0, 1.0, 0.0), vec![b]);
            prop_assert_eq!(morph.at3(u, v, 0.0), morph.at(u, v));
            let (here, there) = (morph.at3(u, v, w)[0], morph.at(u + w, v)[0]);
            prop_assert_eq!(here.translation, there.translation);
            // Turned back by how much further the other has turned, they are the same.
            let back = orthogonal(-w * morph.turns()[0].1, false);
            prop_assert!(apart(Affine2::new(back * there.linear, here.translation), here) < 1e-9);
            let linear = Morph::new(&[a], &[b], &options(Mode::Linear)).unwrap();
            prop_assert_eq!(linear.at3(u, v, w), linear.at(u, v));
        }
    }

    #[test]
    fn a_half_turn_is_flat_halfway_only_when_linear() {
        let (a, b) = (Affine2::similitude(0.5, 0.0, DVec2::ZERO), Affine2::similitude(0.5, 3.1, DVec2::ZERO));
        let det = |mode| Morph::new(&[a], &[b], &options(mode)).unwrap().at(0.5, 0.5)[0].determinant();
        assert!(det(Mode::Linear) < 1e-3);
        assert!((det(Mode::Polar) - 0.25).abs() < 1e-12);
    }

    #[test]
    fn extra_turns_and_correspondence_are_followed() {
        let a = [Affine2::similitude(0.5, 0.0, DVec2::ZERO), Affine2::similitude(0.4, 0.0, DVec2::X)];
        let b = [Affine2::similitude(0.3, 1.0, DVec2::Y), Affine2::similitude(0.2, 0.0, DVec2::ONE)];
        let choice = MorphOptions { correspondence: vec![1, 0], turns: vec![0, -1], ..Default::default() };
        let morph = Morph::new(&a, &b, &choice).unwrap();
        assert_eq!(morph.at(1.0, 1.0), [b[1], b[0]]);
        assert!((morph.turns()[1].1 - (1.0 - std::f64::consts::TAU)).abs() < 1e-12);
    }

    #[test]
    fn options_that_do_not_fit_are_refused() {
        let one = [Affine2::IDENTITY];
        let with = |correspondence: Vec<usize>, turns: Vec<i32>| {
            Morph::new(&one, &one, &MorphOptions { correspondence, turns, ..Default::default() })
        };
        assert_eq!(Morph::new(&one, &[], &options(Mode::Polar)), Err(MorphError::Counts { from: 1, to: 0 }));
        assert_eq!(with(vec![1], vec![]), Err(MorphError::Correspondence { maps: 1 }));
        assert_eq!(with(vec![0, 0], vec![]), Err(MorphError::Correspondence { maps: 1 }));
        assert_eq!(with(vec![], vec![1, 2]), Err(MorphError::Turns { maps: 1 }));
        assert_eq!(with(vec![], vec![1_000_000]), Err(MorphError::Turns { maps: 1 }));
    }
}
