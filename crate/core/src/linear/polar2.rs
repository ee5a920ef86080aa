//! Polar decomposition in the plane.

use glam::{DMat2, DVec2};

use crate::linear::svd2::singular_values;

/// The polar decomposition `M = Q S` of a matrix: `Q = R(angle)`, times `diag(1, -1)` if it reflects,
/// and `S` symmetric with no negative eigenvalue (Burch & Hart 1997, eqs 2 and 3).
///
/// A singular matrix has no unique `Q`; the rule here is that it counts as one that does not reflect,
/// and the zero matrix as one that does not turn. [`Polar2::turning`] and [`Polar2::reflecting`] take
/// the other choice by force, which is what a morph needs when its other end has decided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polar2 {
    /// The turn in radians, counter-clockwise, in (-pi, pi]: the direction of the first column of `Q`.
    pub angle: f64,
    /// Whether `Q` reflects.
    pub reflects: bool,
    /// The stretch `S`.
    pub stretch: DMat2,
}

/// Below this ratio of the singular values a matrix is called singular.
const SINGULAR: f64 = 1e-12;

impl Polar2 {
    /// The decomposition in closed form: `Q` is the nearest rotation where the determinant is not
    /// negative, else the nearest reflection.
    #[must_use]
    pub fn of(m: DMat2) -> Self {
        let (large, small) = singular_values(m);
        if m.determinant() < 0.0 && small > SINGULAR * large { Self::reflecting(m) } else { Self::turning(m) }
    }

    /// The decomposition by averaging with the inverse transpose (Burch & Hart 1997, eq 2), each step
    /// scaled so that it converges in a few. `None` for singular matrices, which have no inverse.
    #[must_use]
    pub fn by_iteration(m: DMat2) -> Option<Self> {
        let (large, small) = singular_values(m);
        if !m.is_finite() || small <= SINGULAR * large || large == 0.0 {
            return None;
        }
        let mut q = m * (1.0 / (large * small).sqrt());
        for _ in 0..64 {
            let next = (q + q.inverse().transpose()) * 0.5;
            let change = (next - q).abs();
            q = next;
            if change.x_axis.max_element().max(change.y_axis.max_element()) < 1e-15 {
                break;
            }
        }
        let reflects = q.determinant() < 0.0;
        let stretch = q.transpose() * m;
        let off = f64::midpoint(stretch.y_axis.x, stretch.x_axis.y);
        Some(Self {
            angle: q.x_axis.y.atan2(q.x_axis.x),
            reflects,
            stretch: DMat2::from_cols(DVec2::new(stretch.x_axis.x, off), DVec2::new(off, stretch.y_axis.y)),
        })
    }

    /// `M = R(angle) S` with `S` symmetric, whatever the sign of the determinant: where it is negative,
    /// `S` has one negative eigenvalue.
    #[must_use]
    pub fn turning(m: DMat2) -> Self {
        let direction = DVec2::new(m.x_axis.x + m.y_axis.y, m.x_axis.y - m.y_axis.x);
        Self::with_angle(m, angle_of(direction), false)
    }

    /// `M = R(angle) diag(1, -1) S` with `S` symmetric, whatever the sign of the determinant: where it
    /// is positive, `S` has one negative eigenvalue.
    #[must_use]
    pub fn reflecting(m: DMat2) -> Self {
        let direction = DVec2::new(m.x_axis.x - m.y_axis.y, m.x_axis.y + m.y_axis.x);
        Self::with_angle(m, angle_of(direction), true)
    }

    fn with_angle(m: DMat2, angle: f64, reflects: bool) -> Self {
        let s = orthogonal(angle, reflects).transpose() * m;
        let off = f64::midpoint(s.y_axis.x, s.x_axis.y);
        let stretch = DMat2::from_cols(DVec2::new(s.x_axis.x, off), DVec2::new(off, s.y_axis.y));
        Self { angle, reflects, stretch }
    }

    /// The orthogonal factor `Q`.
    #[must_use]
    pub fn orthogonal(self) -> DMat2 {
        orthogonal(self.angle, self.reflects)
    }

    /// The product `Q S`.
    #[must_use]
    pub fn matrix(self) -> DMat2 {
        self.orthogonal() * self.stretch
    }
}

/// The direction of a vector, 0 for the zero vector.
fn angle_of(direction: DVec2) -> f64 {
    if direction == DVec2::ZERO { 0.0 } else { direction.y.atan2(direction.x) }
}

/// `R(angle)`, times `diag(1, -1)` if it reflects.
#[inline]
pub(crate) fn orthogonal(angle: f64, reflects: bool) -> DMat2 {
    let (sin, cos) = angle.sin_cos();
    let second = DVec2::new(-sin, cos);
    DMat2::from_cols(DVec2::new(cos, sin), if reflects { -second } else { second })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn distance(a: DMat2, b: DMat2) -> f64 {
        let d = (a - b).abs();
        d.x_axis.max_element().max(d.y_axis.max_element())
    }

    fn entry() -> impl Strategy<Value = f64> {
        prop_oneof![3 => -2.0..2.0_f64, 1 => Just(0.0), 1 => Just(1.0), 1 => Just(-1.0), 1 => -1e-8..1e-8_f64]
    }

    proptest! {
        #[test]
        fn the_factors_are_what_they_claim(a in entry(), b in entry(), c in entry(), d in entry()) {
            let m = DMat2::from_cols_array(&[a, c, b, d]);
            let p = Polar2::of(m);
            let q = p.orthogonal();
            prop_assert!(distance(q.transpose() * q, DMat2::IDENTITY) < 1e-14);
            prop_assert!(distance(p.matrix(), m) < 1e-14);
            prop_assert_eq!(p.stretch.x_axis.y, p.stretch.y_axis.x);
            // No negative eigenvalue.
            prop_assert!(p.stretch.determinant() > -1e-11 && p.stretch.x_axis.x + p.stretch.y_axis.y >= 0.0);
        }

        #[test]
        fn the_iteration_agrees_with_the_closed_form(a in entry(), b in entry(), c in entry(), d in entry()) {
            let m = DMat2::from_cols_array(&[a, c, b, d]);
            let (large, small) = singular_values(m);
            // The factor Q itself loses as many digits as the condition number has.
            prop_assume!(small > 1e-3 * large);
            let (closed, iterated) = (Polar2::of(m), Polar2::by_iteration(m).unwrap());
            prop_assert_eq!(closed.reflects, iterated.reflects);
            prop_assert!(distance(closed.orthogonal(), iterated.orthogonal()) < 1e-12);
            prop_assert!(distance(closed.stretch, iterated.stretch) < 1e-12);
        }
    }

    #[test]
    fn singular_matrices_follow_the_stated_rule() {
        let stem = DMat2::from_cols_array(&[0.0, 0.0, 0.0, 0.16]);
        let p = Polar2::of(stem);
        assert!(!p.reflects);
        assert_eq!(p.angle, 0.0);
        assert_eq!(p.stretch, stem);
        assert_eq!(Polar2::by_iteration(stem), None);
        let zero = Polar2::of(DMat2::ZERO);
        assert_eq!((zero.angle, zero.reflects, zero.stretch), (0.0, false, DMat2::ZERO));
    }

    #[test]
    fn either_branch_gives_the_matrix_back() {
        let m = DMat2::from_cols_array(&[0.3, 0.4, 0.5, -0.2]);
        assert!(distance(Polar2::turning(m).matrix(), m) < 1e-15);
        assert!(distance(Polar2::reflecting(m).matrix(), m) < 1e-15);
        assert!(Polar2::turning(m).stretch.determinant() < 0.0);
    }
}
