//! From one system to another.

use crate::dimension::{Dim2, Dim3, Dimension};
use crate::linear::affine::Affine;
use crate::morph::options::{Kind, Mode, MorphError, MorphOptions};
use crate::morph::turn2::is_half;

/// A family of systems over (u, v): u turns and stretches, v moves; (0, 0) is the first system and
/// (1, 1) the last (Burch & Hart 1997, section 5). A third parameter, w, lets the stretch run ahead of the turn
/// ([`Morph::at3`]): their last section asks for a path through all three.
///
/// A singular map takes the kind of its other end, since it may be seen as either. Maps of opposite kinds
/// are written as a rotation times a symmetric matrix at both ends, so that the one that reflects has a
/// negative stretch along one axis, and goes through a collapse of that axis.
///
/// Each map turns by the shortest turn, and whole turns more where they are asked for. Where that is half a turn,
/// which is as short either way, the sign of eq 6 decides: of the second angle less the first, both in (-pi, pi]. So
/// the family from the last system to the first is this one run backwards, whatever the mode.
///
/// In space quaternions take the place of angles: a map turns about one axis by the least angle. Where both ends
/// reflect, the orthogonal factor is minus a rotation all the way. A map without a turn of its own (it puts all on a
/// line or in a point) takes as much of the other end's turn as fits it.
#[derive(Clone, Debug, PartialEq)]
pub struct Morph<D: Dimension = Dim2> {
    mode: Mode,
    pairs: Vec<Pair<D>>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Pair<D: Dimension> {
    kind: Kind,
    from: Affine<D>,
    to: Affine<D>,
    turn: D::Turn,
    stretch: [D::Matrix; 2],
}

/// The same in space.
pub type Morph3 = Morph<Dim3>;

impl<D: Dimension> Morph<D> {
    /// The family from `from` to `to`.
    ///
    /// # Errors
    /// [`MorphError`] if the counts differ or the options do not fit them.
    #[inline(never)]
    pub fn new(from: &[Affine<D>], to: &[Affine<D>], options: &MorphOptions) -> Result<Self, MorphError> {
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

    /// How each map turns: in the plane its angle at the start and its whole turn, in radians; in space a
    /// [`Turn3`](crate::Turn3).
    #[must_use]
    pub fn turns(&self) -> Vec<D::Turn> {
        self.pairs.iter().map(|pair| pair.turn).collect()
    }

    /// For each map that turns by half a turn, the whole turns (1 or -1) that make it the half turn the other way
    /// round; 0 for all others, and in a linear morph, which does not turn.
    #[must_use]
    pub fn other_half_turns(&self) -> Vec<i32> {
        let other = |pair: &Pair<D>| match D::angle(&pair.turn) {
            turn if self.mode == Mode::Linear || !is_half(turn) => 0,
            turn if turn < 0.0 => 1,
            _ => -1,
        };
        self.pairs.iter().map(other).collect()
    }

    /// The maps at (u, v). Any parameters are allowed; there need not be an attractor.
    #[must_use]
    pub fn at(&self, u: f64, v: f64) -> Vec<Affine<D>> {
        let mut maps = Vec::with_capacity(self.len());
        self.fill(u, v, &mut maps);
        maps
    }

    /// The maps at (u, v), written over what `maps` held: no memory is asked for in a loop.
    pub fn fill(&self, u: f64, v: f64, maps: &mut Vec<Affine<D>>) {
        self.fill3(u, v, 0.0, maps);
    }

    /// The maps at (u, v, w), where turn, stretch and move each have a parameter of their own: the map turns by u,
    /// is stretched by u + w and moved by v. The plane w = 0 is that of [`Morph::at`], and the ends are
    /// (0, 0, 0) and (1, 1, 0). A linear morph has no turn apart from its stretch, and leaves w out.
    #[must_use]
    pub fn at3(&self, u: f64, v: f64, w: f64) -> Vec<Affine<D>> {
        let mut maps = Vec::with_capacity(self.len());
        self.fill3(u, v, w, &mut maps);
        maps
    }

    /// [`Morph::at3`], written over what `maps` held.
    pub fn fill3(&self, u: f64, v: f64, w: f64, maps: &mut Vec<Affine<D>>) {
        maps.clear();
        maps.extend(self.pairs.iter().map(|pair| pair.at(u, v, w, self.mode)));
    }
}

impl<D: Dimension> Pair<D> {
    fn new(from: Affine<D>, to: Affine<D>, extra: i32) -> Self {
        let (kind, turn, stretch) = D::turning(from.linear, to.linear, extra);
        Self { kind, from, to, turn, stretch }
    }

    #[inline]
    fn at(&self, u: f64, v: f64, w: f64, mode: Mode) -> Affine<D> {
        let translation = self.from.translation * (1.0 - v) + self.to.translation * v;
        let linear = match mode {
            Mode::Linear => mix::<D>(self.from.linear, self.to.linear, u),
            // The ends are given back to the last bit.
            Mode::Polar if u == 0.0 && w == 0.0 => self.from.linear,
            Mode::Polar if u == 1.0 && w == 0.0 => self.to.linear,
            Mode::Polar => {
                D::turned(&self.turn, self.kind, u) * mix::<D>(self.stretch[0], self.stretch[1], u + w)
            }
        };
        Affine::new(linear, translation)
    }
}

fn mix<D: Dimension>(a: D::Matrix, b: D::Matrix, u: f64) -> D::Matrix {
    a * (1.0 - u) + b * u
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DQuat, DVec2, DVec3};
    use proptest::prelude::*;

    use super::*;
    use crate::linear::polar2::orthogonal;
    use crate::testing::any_map;
    use crate::testing3::any_map3;
    use crate::{Affine2, Affine3};

    fn options(mode: Mode) -> MorphOptions {
        MorphOptions { mode, ..MorphOptions::default() }
    }

    fn apart<D: Dimension>(a: Affine<D>, b: Affine<D>) -> f64 {
        let (a, b) = (a.to_row(), b.to_row());
        a.as_ref().iter().zip(b.as_ref()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    }

    fn goes_from_end_to_end_without_a_jump<D: Dimension>(a: Affine<D>, b: Affine<D>, linear: bool) {
        let mode = if linear { Mode::Linear } else { Mode::Polar };
        let morph = Morph::new(&[a], &[b], &options(mode)).unwrap();
        assert!(apart(morph.at(0.0, 0.0)[0], a) == 0.0);
        assert!(apart(morph.at(1.0, 1.0)[0], b) == 0.0);
        let mut last = a;
        for k in 0..=1000 {
            let t = f64::from(k) / 1000.0;
            let now = morph.at(t, t)[0];
            assert!(apart(now, last) < 0.02, "jump of {} at {t}", apart(now, last));
            last = now;
        }
    }

    fn keeps_the_sign_of_the_determinant<D: Dimension>(a: Affine<D>, b: Affine<D>) {
        let morph = Morph::new(&[a], &[b], &options(Mode::Polar)).unwrap();
        for k in 0..=20 {
            let det = morph.at(f64::from(k) / 20.0, 0.0)[0].determinant();
            match morph.kinds()[0] {
                Kind::Turning => assert!(det > -1e-12),
                Kind::Reflecting => assert!(det < 1e-12),
                Kind::Opposite => {}
            }
        }
    }

    /// Maps among which half turns between two are common, off by rounding or not, with a zero of either sign.
    fn half_turned(map: impl Strategy<Value = Affine2>) -> impl Strategy<Value = Affine2> {
        let quarter = |k: i32, wobble: f64, scale: f64, mirror: bool| {
            let [cos, sin] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][k.rem_euclid(4) as usize];
            let side = if mirror { -scale } else { scale };
            let (sin, cos) = (sin + wobble, cos - wobble);
            Affine2::from_row([scale * cos, -side * sin, scale * sin, side * cos, 0.5, -0.25])
        };
        let wobble = prop_oneof![Just(0.0), Just(-0.0), Just(1e-17), Just(-1e-16), Just(1e-13)];
        let scale = prop_oneof![Just(0.5), Just(-0.5), 0.1..0.9_f64];
        prop_oneof![1 => map, 3 => (0..4, wobble, scale, any::<bool>()).prop_map(move |(k, o, s, m)| quarter(k, o, s, m))]
    }

    /// Maps of space that turn about axes among which half turns between two are common, and flat ones.
    fn half_turned3() -> impl Strategy<Value = Affine<Dim3>> {
        let axes =
            [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(1.0, 1.0, 0.0), DVec3::new(1.0, -2.0, 2.0), DVec3::ONE];
        let axis = proptest::sample::select(axes.to_vec());
        let sizes = [
            DVec3::splat(0.5),
            DVec3::splat(-0.5),
            DVec3::new(0.5, 0.25, 0.125),
            DVec3::new(0.5, 0.5, -0.25),
        ];
        let flat =
            [DVec3::ZERO, DVec3::new(0.5, 0.0, 0.0), DVec3::new(0.0, 0.0, -0.5), DVec3::new(0.5, 0.5, 0.0)];
        let size = proptest::sample::select([sizes, flat].concat());
        let turned = (axis, -4..5_i32, size, any::<bool>()).prop_map(|(axis, quarters, size, first)| {
            let angle = f64::from(quarters) * std::f64::consts::FRAC_PI_2;
            let turn = Affine3::similitude(1.0, DQuat::from_axis_angle(axis.normalize(), angle), DVec3::ZERO);
            let stretch = Affine3::new(DMat3::from_diagonal(size), DVec3::X);
            if first { stretch * turn } else { turn * stretch }
        });
        prop_oneof![1 => any_map3(), 4 => turned]
    }

    fn runs_backwards<D: Dimension>(
        a: Affine<D>,
        b: Affine<D>,
        turns: i32,
        linear: bool,
        [u, v, w]: [f64; 3],
    ) {
        let mode = if linear { Mode::Linear } else { Mode::Polar };
        let with = |turns| MorphOptions { mode, turns: vec![turns], ..MorphOptions::default() };
        let there = Morph::new(&[a], &[b], &with(turns)).unwrap();
        let back = Morph::new(&[b], &[a], &with(-turns)).unwrap();
        let far = apart(there.at3(u, v, w)[0], back.at3(1.0 - u, 1.0 - v, -w)[0]);
        assert!(far < 1e-8, "{far} between {a:?} and {b:?}, {turns} turns, at {u}, {v}, {w}");
        let opposite: Vec<i32> = back.other_half_turns().iter().map(|turn| -turn).collect();
        assert_eq!(there.other_half_turns(), opposite);
    }

    proptest! {
        #[test]
        fn it_goes_from_end_to_end_without_a_jump(a in any_map(), b in any_map(), linear: bool) {
            goes_from_end_to_end_without_a_jump(a, b, linear);
        }

        #[test]
        fn it_does_so_in_space(a in any_map3(), b in any_map3(), linear: bool) {
            goes_from_end_to_end_without_a_jump(a, b, linear);
        }

        #[test]
        fn the_sign_of_the_determinant_is_kept(a in any_map(), b in any_map()) {
            keeps_the_sign_of_the_determinant(a, b);
        }

        #[test]
        fn from_the_other_end_it_runs_backwards(
            a in half_turned(any_map()), b in half_turned(any_map()), turns in -2..3, linear: bool,
            u in -1.0..2.0_f64, v in -1.0..2.0_f64, w in -1.0..1.0_f64,
        ) {
            runs_backwards(a, b, turns, linear, [u, v, w]);
        }

        #[test]
        fn it_does_so_in_space_too(
            a in half_turned3(), b in half_turned3(), turns in -2..3, linear: bool,
            u in -1.0..2.0_f64, v in -1.0..2.0_f64, w in -1.0..1.0_f64,
        ) {
            runs_backwards(a, b, turns, linear, [u, v, w]);
        }

        #[test]
        fn it_is_kept_in_space(a in any_map3(), b in any_map3()) {
            keeps_the_sign_of_the_determinant(a, b);
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

    /// Burch & Hart (1997, eq 6), as printed: theta is interpolated linearly between arctangents in (-pi, pi].
    #[test]
    fn half_a_turn_goes_as_eq_6_says() {
        let turned = |degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            Affine2::from_row([cos * 0.5, -sin * 0.5, sin * 0.5, cos * 0.5, 0.0, 0.0])
        };
        for (from, to, halfway) in [
            (180.0, 0.0, 90.0),
            (0.0, 180.0, 90.0),
            (-90.0, 90.0, 0.0),
            (90.0, -90.0, 0.0),
            (135.0, -45.0, 45.0),
        ] {
            let morph = Morph::new(&[turned(from)], &[turned(to)], &options(Mode::Polar)).unwrap();
            assert!(apart(morph.at(0.5, 0.5)[0], turned(halfway)) < 1e-12, "{from} to {to}");
            let turns = morph.other_half_turns();
            let other = MorphOptions { turns, ..MorphOptions::default() };
            let other = Morph::new(&[turned(from)], &[turned(to)], &other).unwrap();
            assert!(apart(other.at(0.5, 0.5)[0], turned(halfway + 180.0)) < 1e-12, "{from} to {to}");
        }
        // Minus zeros and rounding do not choose.
        for off in [0.0, -0.0, 1e-16, -1e-16] {
            let from = Affine2::from_row([-0.5, -off, off, -0.5, 0.0, 0.0]);
            let morph = Morph::new(&[from], &[turned(0.0)], &options(Mode::Polar)).unwrap();
            assert!(apart(morph.at(0.5, 0.5)[0], turned(90.0)) < 1e-12, "{off}");
        }
    }

    /// About the axis that points up it is as in the plane.
    #[test]
    fn half_a_turn_in_space_goes_as_in_the_plane() {
        let turned = |degrees: f64| {
            Affine3::similitude(0.5, DQuat::from_rotation_z(degrees.to_radians()), DVec3::ZERO)
        };
        for (from, to, halfway) in
            [(180.0, 0.0, 90.0), (0.0, 180.0, 90.0), (-90.0, 90.0, 0.0), (90.0, -90.0, 0.0)]
        {
            let morph = Morph::new(&[turned(from)], &[turned(to)], &options(Mode::Polar)).unwrap();
            assert!(apart(morph.at(0.5, 0.5)[0], turned(halfway)) < 1e-12, "{from} to {to}");
        }
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
