//! How a map of space turns into another.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::linear::polar3::{Polar3, jacobi};
use crate::linear::svd3::singular_values3;
use crate::morph::options::Kind;
use crate::morph::turn2::{HALF_ERROR, shortest};
use crate::order::Total;

/// How a map turns on its way: from `start`, by `angle` radians about `axis`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn3 {
    /// The turn at the start: `Q` of its polar decomposition, or `-Q` where both ends reflect.
    pub start: DQuat,
    /// The axis, a unit vector that points up, or else forward, or else to the right, in the coordinates before
    /// `start`.
    pub axis: DVec3,
    /// The whole angle about it, counter-clockwise, in [-pi, pi] but for whole extra turns.
    pub angle: f64,
}

impl Turn3 {
    pub(crate) fn at(&self, u: f64) -> DMat3 {
        DMat3::from_quat(self.start * DQuat::from_axis_angle(self.axis, u * self.angle))
    }
}

/// The kind of two matrices, the turn from one to the other with so many extra whole ones, and how each stretches.
pub(crate) fn between(from: DMat3, to: DMat3, extra: i32) -> (Kind, Turn3, [DMat3; 2]) {
    let ends = [from, to];
    let kind = match ends.map(reflects) {
        [None | Some(false), None | Some(false)] => Kind::Turning,
        [None | Some(true), None | Some(true)] => Kind::Reflecting,
        _ => Kind::Opposite,
    };
    // Minus a reflecting matrix of space does not reflect.
    let side = if kind == Kind::Reflecting { -1.0 } else { 1.0 };
    let [a, b] = ends.map(|m| m * side);
    // The end that knows its turn better is asked first. Where neither does, the same one is from either side.
    let rank = |m: DMat3| (freedom(m), m.to_cols_array().map(Total));
    let (p, q) = if rank(a) <= rank(b) {
        let p = nearest(a, DMat3::IDENTITY);
        (p, nearest(b, p))
    } else {
        let q = nearest(b, DMat3::IDENTITY);
        (nearest(a, q), q)
    };
    let stretch = [symmetric(p.transpose() * a) * side, symmetric(q.transpose() * b) * side];
    let turn = turn_between(p, q, extra);
    (kind, turn, stretch)
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

/// In how many directions the rotation nearest to a matrix can still be turned: 0 mostly, 1 for matrices that put all
/// on a line and for reflections that stretch two axes alike, 3 for 0.
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
    let [start, end] = [p, q].map(|m| DQuat::from_mat3(&m).normalize());
    let between = DQuat::from_mat3(&(p.transpose() * q)).normalize();
    let sine = between.xyz().length();
    let axis = if sine > 1e-14 { upwards(between.xyz() / sine) } else { DVec3::Z };
    let angle = 2.0 * between.xyz().dot(axis).atan2(between.w);
    let angle = if between.w.abs() < HALF_ERROR {
        angle + TAU * ((half_turn(start, end, axis) - angle) / TAU).round()
    } else {
        shortest(0.0, angle)
    };
    Turn3 { start, axis, angle: TAU.mul_add(f64::from(extra), angle) }
}

/// Which half turn leads from one rotation to another, of the two about an axis. About it the rotations have angles, as
/// maps of the plane have (the twists of their quaternions), and these decide as they do there: from the other end it
/// is the way back.
fn half_turn(start: DQuat, end: DQuat, axis: DVec3) -> f64 {
    let twist = |q: DQuat| DVec2::new(q.w, q.xyz().dot(axis));
    if twist(start).length() > HALF_ERROR {
        let [from, to] = [start, end].map(|q| 2.0 * twist(q).to_angle());
        return shortest(from, to);
    }
    // Both are half turns about axes across it, and have no angle about it: the order of these axes decides.
    let [from, to] = [start, end].map(|q| upwards(q.xyz()).to_array().map(Total));
    if from < to { PI } else { -PI }
}

/// An axis or its opposite: the one that points up, or else forward, or else to the right.
fn upwards(axis: DVec3) -> DVec3 {
    let down = |x: f64, rest: bool| x < -HALF_ERROR || x < HALF_ERROR && rest;
    if down(axis.z, down(axis.y, axis.x < 0.0)) { -axis } else { axis }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::morph::options::{Mode, MorphOptions};
    use crate::testing3::any_map3;
    use crate::{Affine3, Ifs3, Morph3, MorphError};

    fn options(mode: Mode) -> MorphOptions {
        MorphOptions { mode, ..MorphOptions::default() }
    }

    fn apart(a: Affine3, b: Affine3) -> f64 {
        a.to_row().iter().zip(b.to_row()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    }

    proptest! {
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
        assert!((more.turns()[0].angle - (1.2 - TAU)).abs() < 1e-12);
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
