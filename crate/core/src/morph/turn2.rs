//! How a map of the plane turns into another.

use std::f64::consts::{PI, TAU};

use glam::{DMat2, DVec2};

use crate::linear::polar2::{Polar2, orthogonal};
use crate::linear::svd2::singular_values;
use crate::morph::options::Kind;

/// The kind of two matrices; the angle at the first and the whole turn to the second, with so many extra ones; and how
/// each stretches.
pub(crate) fn between(from: DMat2, to: DMat2, extra: i32) -> (Kind, (f64, f64), [DMat2; 2]) {
    let ends = [from, to];
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
    let turn = shortest(angle, last) + TAU * f64::from(extra);
    (kind, (angle, turn), stretch)
}

/// The orthogonal factor after the part `u` of a turn.
#[inline]
pub(crate) fn at(&(angle, turn): &(f64, f64), kind: Kind, u: f64) -> DMat2 {
    orthogonal(u.mul_add(turn, angle), kind == Kind::Reflecting)
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

/// How far it is from one angle to another by the shorter way. Half a turn is as short by either: the difference of the
/// angles in (-pi, pi] decides, as Burch & Hart (1997, eq 6) print it. Seen from the other end it is the way back.
///
/// The angles are less than a turn from 0.
pub(crate) fn shortest(from: f64, to: f64) -> f64 {
    let difference = principal(to) - principal(from);
    if is_half(difference) { difference } else { principal(difference) }
}

/// The same angle in (-pi, pi]; pi also where rounding puts it on the other side.
fn principal(angle: f64) -> f64 {
    let angle = if angle > PI { angle - TAU } else { angle };
    if angle <= HALF_ERROR - PI { angle + TAU } else { angle }
}

/// Whether a turn is half a turn, to rounding.
pub(crate) fn is_half(turn: f64) -> bool {
    (turn.abs() - PI).abs() <= HALF_ERROR
}

/// Turns that are so near half a turn are taken for it: what is typed or multiplied out is off by rounding.
pub(crate) const HALF_ERROR: f64 = 1e-9;
