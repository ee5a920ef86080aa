//! From one system of space to another.

use glam::{DMat3, DQuat, DVec3};

use crate::bounds::bounds3::Bounds3;
use crate::ifs::ifs3::Ifs3;
use crate::linear::affine3::Affine3;
use crate::linear::polar3::{Polar3, jacobi};
use crate::linear::svd3::singular_values3;
use crate::morph::morph2::{Kind, Mode, MorphError, MorphOptions};
use crate::morph::pairing::assignment;

/// How a map turns on its way: from `start`, by `angle` radians about `axis`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn3 {
    /// The turn at the start: `Q` of its polar decomposition, or `-Q` where both ends reflect.
    pub start: DQuat,
    /// The axis, a unit vector, in the coordinates before `start`.
    pub axis: DVec3,
    /// The whole angle, in [0, pi] but for whole extra turns.
    pub angle: f64,
}

impl Turn3 {
    fn at(&self, u: f64) -> DMat3 {
        DMat3::from_quat(self.start * DQuat::from_axis_angle(self.axis, u * self.angle))
    }
}

/// A family of systems of space over (u, v): u turns and stretches, v moves; (0, 0) is the first system and (1, 1) the
/// last (Burch & Hart 1997, eq 6, with quaternions for Q).
///
/// The linear parts are decomposed as `M = Q S`; `Q` turns about one axis by the least angle, and whole turns more where
/// they are asked for, and `S` is interpolated element by element. What reflects is treated as in the plane
/// ([`Morph`](crate::Morph)): where both ends reflect, `Q` is minus a rotation all the way. Where one does and the other does not, both
/// are written as the rotation nearest to them times a symmetric matrix; the one that reflects has a negative stretch
/// along the axis that it stretches least, and goes through a collapse of that axis. A map without a turn of its own (it puts all
/// on a line or in a point) takes as much of the other end's turn as fits it.
#[derive(Clone, Debug, PartialEq)]
pub struct Morph3 {
    mode: Mode,
    pairs: Vec<Pair>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Pair {
    kind: Kind,
    from: Affine3,
    to: Affine3,
    turn: Turn3,
    stretch: [DMat3; 2],
}

impl Morph3 {
    /// The family from `from` to `to`. The options are those of the plane; extra turns are about the axis of the turn.
    ///
    /// # Errors
    /// [`MorphError`] if the counts differ or the options do not fit them.
    pub fn new(from: &[Affine3], to: &[Affine3], options: &MorphOptions) -> Result<Self, MorphError> {
        let order = options.order(from.len(), to.len())?;
        let turn = |i: usize| options.turns.get(i).copied().unwrap_or(0);
        let pairs = order.iter().enumerate().map(|(i, &j)| Pair::new(from[i], to[j], turn(i))).collect();
        Ok(Self { mode: options.mode, pairs })
    }

    /// Which map of `to` each map of `from` becomes so that pieces travel, turn and stretch least in all; in their own order
    /// where the numbers of maps differ.
    #[must_use]
    pub fn correspondence(from: &Ifs3, to: &Ifs3) -> Vec<usize> {
        if from.len() != to.len() {
            return (0..from.len()).collect();
        }
        let [a, b] = [from, to].map(Bounds3::of);
        let place = |bounds: &Bounds3, map: Affine3| {
            (map.apply(bounds.centre) - bounds.centre) / bounds.radius.max(f64::MIN_POSITIVE)
        };
        let cost = |x: Affine3, y: Affine3| {
            let pair = Pair::new(x, y, 0);
            let travel = place(&a, x).distance_squared(place(&b, y));
            let turn = (pair.turn.angle / std::f64::consts::PI).powi(2);
            let (s, t) = (x.singular_values(), y.singular_values());
            let stretch: f64 = (0..3).map(|k| (s[k] - t[k]).powi(2)).sum();
            let over = if pair.kind == Kind::Opposite { 1.0 } else { 0.0 };
            let cost = travel + 0.25 * turn + 0.25 * stretch + over;
            if cost.is_finite() { cost.min(1e12) } else { 1e12 }
        };
        let table: Vec<Vec<f64>> =
            from.maps().iter().map(|&x| to.maps().iter().map(|&y| cost(x, y)).collect()).collect();
        assignment(&table)
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

    /// How each map turns.
    #[must_use]
    pub fn turns(&self) -> Vec<Turn3> {
        self.pairs.iter().map(|pair| pair.turn).collect()
    }

    /// The maps at (u, v). Any parameters are allowed; there need not be an attractor.
    #[must_use]
    pub fn at(&self, u: f64, v: f64) -> Vec<Affine3> {
        self.at3(u, v, 0.0)
    }

    /// The maps at (u, v, w): turned by u, stretched by u + w and moved by v. A linear morph leaves w out.
    #[must_use]
    pub fn at3(&self, u: f64, v: f64, w: f64) -> Vec<Affine3> {
        let mut maps = Vec::with_capacity(self.len());
        self.fill3(u, v, w, &mut maps);
        maps
    }

    /// [`Morph3::at3`], written over what `maps` held: no memory is asked for in a loop.
    pub fn fill3(&self, u: f64, v: f64, w: f64, maps: &mut Vec<Affine3>) {
        maps.clear();
        maps.extend(self.pairs.iter().map(|pair| pair.at(u, v, w, self.mode)));
    }
}

impl Pair {
    fn new(from: Affine3, to: Affine3, extra: i32) -> Self {
        let ends = [from.linear, to.linear];
        let kind = match ends.map(reflects) {
            [None | Some(false), None | Some(false)] => Kind::Turning,
            [None | Some(true), None | Some(true)] => Kind::Reflecting,
            _ => Kind::Opposite,
        };
        // Minus a reflecting matrix of space does not reflect.
        let side = if kind == Kind::Reflecting { -1.0 } else { 1.0 };
        let [a, b] = ends.map(|m| m * side);
        // The end that knows its turn better is asked first.
        let (p, q) = if freedom(a) <= freedom(b) {
            let p = nearest(a, DMat3::IDENTITY);
            (p, nearest(b, p))
        } else {
            let q = nearest(b, DMat3::IDENTITY);
            (nearest(a, q), q)
        };
        let stretch = [symmetric(p.transpose() * a) * side, symmetric(q.transpose() * b) * side];
        let turn = turn_between(p, q, extra);
        Self { kind, from, to, turn, stretch }
    }

    fn at(&self, u: f64, v: f64, w: f64, mode: Mode) -> Affine3 {
        let translation = self.from.translation * (1.0 - v) + self.to.translation * v;
        let linear = match mode {
            Mode::Linear => mix(self.from.linear, self.to.linear, u),
            // The ends are given back to the last bit.
            Mode::Polar if u == 0.0 && w == 0.0 => self.from.linear,
            Mode::Polar if u == 1.0 && w == 0.0 => self.to.linear,
            Mode::Polar => self.turn.at(u) * mix(self.stretch[0], self.stretch[1], u + w),
        };
        Affine3::new(linear, translation)
    }
}

fn mix(a: DMat3, b: DMat3, u: f64) -> DMat3 {
    a * (1.0 - u) + b * u
}

fn symmetric(m: DMat3) -> DMat3 {
    (m + m.transpose()) * 0.5
}

/// Below this ratio of the singular values a matrix is called singular.
const SINGULAR: f64 = 1e-12;

/// Whether a matrix reflects; `None` where it is singular and may be seen as either.
fn reflects(m: DMat3) -> Option<bool> {
    let [large, _, small] = singular_values3(m);
    (small > SINGULAR * large).then(|| m.determinant() < 0.0)
}

/// In how many directions the rotation nearest to a matrix can still be turned: 0 mostly, 1 for matrices that put all on a
/// line and for reflections that stretch two axes alike, 3 for 0.
fn freedom(m: DMat3) -> u8 {
    let [a, b, c] = singular_values3(m);
    if a == 0.0 {
        3
    } else if b <= SINGULAR * a {
        1
    } else {
        let level = m.determinant() < 0.0 && c > SINGULAR * a && b - c <= 1e-9 * a;
        if level && a - c <= 1e-9 * a { 2 } else { u8::from(level) }
    }
}

/// The rotation nearest to a matrix; of several the one nearest to `like`.
fn nearest(m: DMat3, like: DMat3) -> DMat3 {
    let [a, b, c] = singular_values3(m);
    if a == 0.0 {
        return like;
    }
    if b <= SINGULAR * a {
        // All goes onto a line: the longest direction before and after.
        let columns = [m.x_axis, m.y_axis, m.z_axis];
        let rows = [m.row(0), m.row(1), m.row(2)];
        let longest = |v: [DVec3; 3]| {
            v.into_iter().max_by(|x, y| x.length().total_cmp(&y.length())).unwrap_or(DVec3::X)
        };
        let (after, before) = (longest(columns).normalize(), longest(rows).normalize());
        let before = before * (m * before).dot(after).signum();
        return DMat3::from_quat(DQuat::from_rotation_arc(like * before, after)) * like;
    }
    let Polar3 { orthogonal: q, stretch } = Polar3::of(m);
    if q.determinant() > 0.0 {
        return q;
    }
    // One axis has to be turned over: that of the least stretch.
    let (values, vectors) = jacobi(stretch);
    let close = |k: usize| values[k] - c <= 1e-9 * a;
    let least: Vec<DVec3> = (0..3).filter(|&k| close(k)).map(|k| vectors.col(k)).collect();
    let overturned = |v: DVec3| {
        let v = v.normalize();
        let mirror = DMat3::IDENTITY - DMat3::from_cols(v * v.x, v * v.y, v * v.z) * 2.0;
        q * mirror
    };
    if let [only] = least[..] {
        return overturned(only);
    }
    // Of several axes, the one that leaves the rotation nearest to the other: the least of a form on their span.
    let form = symmetric(q.transpose() * like);
    let span: DMat3 =
        least.iter().fold(DMat3::ZERO, |sum, &v| sum + DMat3::from_cols(v * v.x, v * v.y, v * v.z));
    let (values, vectors) = jacobi(span * form * span + (DMat3::IDENTITY - span) * 10.0);
    let best = (0..3).min_by(|&i, &j| values[i].total_cmp(&values[j])).unwrap_or(0);
    overturned(vectors.col(best))
}

/// The turn from one rotation to another, the shortest and `extra` whole ones.
fn turn_between(p: DMat3, q: DMat3, extra: i32) -> Turn3 {
    let start = DQuat::from_mat3(&p).normalize();
    let between = DQuat::from_mat3(&(p.transpose() * q)).normalize();
    let between = if between.w < 0.0 { -between } else { between };
    let sine = between.xyz().length();
    let angle = 2.0 * sine.atan2(between.w);
    let axis = if sine > 1e-14 { between.xyz() / sine } else { DVec3::Z };
    // Half a turn goes either way: the way is that whose axis points up, or else forward, or else to the right.
    let down = axis.z < -1e-9 || axis.z < 1e-9 && (axis.y < -1e-9 || axis.y < 1e-9 && axis.x < 0.0);
    let axis = if down && between.w < 1e-9 { -axis } else { axis };
    Turn3 { start, axis, angle: angle + std::f64::consts::TAU * f64::from(extra) }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing3::any_map3;

    fn options(mode: Mode) -> MorphOptions {
        MorphOptions { mode, ..MorphOptions::default() }
    }

    fn apart(a: Affine3, b: Affine3) -> f64 {
        a.to_row().iter().zip(b.to_row()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    }

    proptest! {
        #[test]
        fn it_goes_from_end_to_end_without_a_jump(a in any_map3(), b in any_map3(), linear: bool) {
            let mode = if linear { Mode::Linear } else { Mode::Polar };
            let morph = Morph3::new(&[a], &[b], &options(mode)).unwrap();
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
        fn the_sign_of_the_determinant_is_kept(a in any_map3(), b in any_map3()) {
            let morph = Morph3::new(&[a], &[b], &options(Mode::Polar)).unwrap();
            for k in 0..=20 {
                let det = morph.at(f64::from(k) / 20.0, 0.0)[0].determinant();
                match morph.kinds()[0] {
                    Kind::Turning => prop_assert!(det > -1e-12),
                    Kind::Reflecting => prop_assert!(det < 1e-12),
                    Kind::Opposite => {}
                }
            }
        }

        #[test]
        fn the_third_parameter_stretches_alone(a in any_map3(), b in any_map3(), u in -1.0..2.0_f64, w in -1.0..1.0_f64) {
            let morph = Morph3::new(&[a], &[b], &options(Mode::Polar)).unwrap();
            prop_assert_eq!(morph.at3(1.0, 1.0, 0.0), vec![b]);
            let (here, there) = (morph.at3(u, 0.3, w)[0], morph.at(u + w, 0.3)[0]);
            let turn = morph.turns()[0];
            let back = turn.at(u) * turn.at(u + w).transpose();
            prop_assert!(apart(Affine3::new(back * there.linear, here.translation), here) < 1e-9);
        }
    }

    #[test]
    fn a_half_turn_is_flat_halfway_only_when_linear() {
        let turned = |angle| Affine3::similitude(0.5, DQuat::from_rotation_y(angle), DVec3::ZERO);
        let det = |mode| {
            Morph3::new(&[turned(0.0)], &[turned(3.1)], &options(mode)).unwrap().at(0.5, 0.5)[0].determinant()
        };
        assert!(det(Mode::Linear) < 1e-3);
        assert!((det(Mode::Polar) - 0.125).abs() < 1e-12);
    }

    #[test]
    fn it_turns_about_one_axis_and_more_often_if_asked() {
        let axis = DVec3::new(1.0, 2.0, 2.0) / 3.0;
        let (a, b) = (
            Affine3::similitude(0.5, DQuat::IDENTITY, DVec3::X),
            Affine3::similitude(0.25, DQuat::from_axis_angle(axis, 1.2), DVec3::Y),
        );
        let morph = Morph3::new(&[a], &[b], &options(Mode::Polar)).unwrap();
        let turn = morph.turns()[0];
        assert!((turn.angle - 1.2).abs() < 1e-12 && turn.axis.distance(axis) < 1e-12);
        let middle = Affine3::similitude(0.375, DQuat::from_axis_angle(axis, 0.6), DVec3::new(0.5, 0.5, 0.0));
        assert!(apart(morph.at(0.5, 0.5)[0], middle) < 1e-12);
        let choice = MorphOptions { turns: vec![-1], ..MorphOptions::default() };
        let more = Morph3::new(&[a], &[b], &choice).unwrap();
        assert!((more.turns()[0].angle - (1.2 - std::f64::consts::TAU)).abs() < 1e-12);
        assert_eq!(more.at(1.0, 1.0), [b]);
    }

    #[test]
    fn a_point_and_a_line_take_the_turn_of_the_other_end() {
        let turned = Affine3::similitude(0.5, DQuat::from_rotation_x(1.0), DVec3::ZERO);
        let point = Affine3::scaling(DVec3::ZERO);
        let morph = Morph3::new(&[point], &[turned], &options(Mode::Polar)).unwrap();
        assert!(morph.turns()[0].angle < 1e-12);
        // It stretches along x, and so the turn about x of the other end fits it.
        let line = Affine3::scaling(DVec3::new(0.3, 0.0, 0.0));
        let morph = Morph3::new(&[turned], &[line], &options(Mode::Polar)).unwrap();
        assert!(morph.turns()[0].angle < 1e-9, "{:?}", morph.turns());
        assert!(apart(morph.at3(1.0, 1.0, 0.0)[0], line) == 0.0);
        assert!(apart(morph.at(1.0 - 1e-9, 1.0)[0], line) < 1e-8);
    }

    #[test]
    fn reflections_are_kept_or_pass_through_one_flat_moment() {
        let mirror = Affine3::scaling(DVec3::new(0.5, 0.4, -0.3));
        let inversion = Affine3::scaling(DVec3::splat(-0.5));
        let morph = Morph3::new(&[mirror], &[inversion], &options(Mode::Polar)).unwrap();
        assert_eq!(morph.kinds(), [Kind::Reflecting]);
        let plain = Affine3::scaling(DVec3::splat(0.5));
        for other in [mirror, inversion] {
            let morph = Morph3::new(&[other], &[plain], &options(Mode::Polar)).unwrap();
            assert_eq!(morph.kinds(), [Kind::Opposite]);
            let signs = (0..=100).map(|k| morph.at(f64::from(k) / 100.0, 0.0)[0].determinant() > 0.0);
            let signs: Vec<bool> = signs.collect();
            assert_eq!(signs.windows(2).filter(|two| two[0] != two[1]).count(), 1);
        }
    }

    #[test]
    fn shuffled_corners_find_each_other() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE];
        let halves = |order: [usize; 5]| {
            Ifs3::new(order.map(|k| Affine3::similitude(0.4, DQuat::IDENTITY, corners[k])).to_vec()).unwrap()
        };
        let order = [3, 1, 4, 0, 2];
        let found = Morph3::correspondence(&halves([0, 1, 2, 3, 4]), &halves(order));
        assert!((0..5).all(|k| order[found[k]] == k), "{found:?}");
        let choice = MorphOptions { correspondence: vec![0, 0], ..MorphOptions::default() };
        let two = [Affine3::IDENTITY; 2];
        assert_eq!(Morph3::new(&two, &two, &choice), Err(MorphError::Correspondence { maps: 2 }));
        assert_eq!(Morph3::new(&two, &[], &options(Mode::Polar)), Err(MorphError::Counts { from: 2, to: 0 }));
    }
}
