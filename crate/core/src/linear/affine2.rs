//! Affine maps of the plane.

use std::ops::Mul;

use glam::{DMat2, DVec2};

/// An affine map of the plane, `x -> linear * x + translation`.
///
/// Written as a row it is `[a, b, c, d, e, f]`, the order of Fractint files:
///
/// ```text
/// x' = a x + b y + e        linear = | a b |    translation = | e |
/// y' = c x + d y + f                 | c d |                  | f |
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine2 {
    /// The linear part.
    pub linear: DMat2,
    /// The translation.
    pub translation: DVec2,
}

impl Affine2 {
    /// The map that leaves every point where it is.
    pub const IDENTITY: Self = Self { linear: DMat2::IDENTITY, translation: DVec2::ZERO };

    /// A map from its linear part and its translation.
    #[must_use]
    pub const fn new(linear: DMat2, translation: DVec2) -> Self {
        Self { linear, translation }
    }

    /// A map from its row `[a, b, c, d, e, f]`.
    #[must_use]
    pub const fn from_row([a, b, c, d, e, f]: [f64; 6]) -> Self {
        Self { linear: DMat2::from_cols_array(&[a, c, b, d]), translation: DVec2::new(e, f) }
    }

    /// A similitude: scale, turn by `angle` (radians, counter-clockwise), then move.
    #[must_use]
    pub fn similitude(scale: f64, angle: f64, translation: DVec2) -> Self {
        Self { linear: DMat2::from_angle(angle) * scale, translation }
    }

    /// The row `[a, b, c, d, e, f]`.
    #[must_use]
    pub const fn to_row(self) -> [f64; 6] {
        let Self { linear: m, translation: t } = self;
        [m.x_axis.x, m.y_axis.x, m.x_axis.y, m.y_axis.y, t.x, t.y]
    }

    /// The image of a point.
    #[inline]
    #[must_use]
    pub fn apply(self, point: DVec2) -> DVec2 {
        self.linear * point + self.translation
    }

    /// The factor by which the map changes areas, negative if it reflects.
    #[must_use]
    pub fn determinant(self) -> f64 {
        self.linear.determinant()
    }

    /// Both singular values of the linear part, the larger first: how much the map stretches at most
    /// and at least.
    #[inline]
    #[must_use]
    pub fn singular_values(self) -> (f64, f64) {
        singular_values(self.linear)
    }

    /// The operator norm of the linear part: the largest factor by which a distance grows.
    #[inline]
    #[must_use]
    pub fn norm(self) -> f64 {
        self.singular_values().0
    }

    /// The inverse map, or `None` when the linear part is singular or so nearly that nothing is left
    /// of it in floating point.
    #[must_use]
    pub fn inverse(self) -> Option<Self> {
        let inverse = self.linear.inverse();
        let map = Self { linear: inverse, translation: -(inverse * self.translation) };
        (self.determinant() != 0.0 && map.is_finite()).then_some(map)
    }

    /// The point that the map leaves where it is, or `None` when there is no such point or more than
    /// one (an eigenvalue of 1).
    #[must_use]
    pub fn fixed_point(self) -> Option<DVec2> {
        let m = DMat2::IDENTITY - self.linear;
        let point = m.inverse() * self.translation;
        (m.determinant() != 0.0 && point.is_finite()).then_some(point)
    }

    /// The largest absolute value of an eigenvalue of the linear part.
    #[must_use]
    pub fn spectral_radius(self) -> f64 {
        spectral_radius(self.linear)
    }

    /// Whether all six numbers are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.linear.is_finite() && self.translation.is_finite()
    }

    /// Whether the map scales all distances by one factor, to a relative `tolerance`.
    #[must_use]
    pub fn is_similitude(self, tolerance: f64) -> bool {
        let (large, small) = self.singular_values();
        large - small <= tolerance * large
    }

    /// The same map seen in other coordinates: `by * self * by^-1`, whose attractor is the image under
    /// `by` of the former one (Darwish & Abd-El-Wahab, eq 1). `None` when `by` is singular.
    #[must_use]
    pub fn conjugate(self, by: Self) -> Option<Self> {
        by.inverse().map(|inverse| by * self * inverse)
    }
}

/// Composition: `(a * b).apply(x)` is `a.apply(b.apply(x))`.
impl Mul for Affine2 {
    type Output = Self;

    #[inline]
    fn mul(self, inner: Self) -> Self {
        Self { linear: self.linear * inner.linear, translation: self.apply(inner.translation) }
    }
}

/// Both singular values of a matrix, the larger first.
///
/// The matrix is split into its part that commutes with rotations and its part that reverses them; the
/// singular values are the sum and the difference of their lengths, which loses no digits.
#[inline]
pub(crate) fn singular_values(m: DMat2) -> (f64, f64) {
    let (a, c, b, d) = (m.x_axis.x, m.x_axis.y, m.y_axis.x, m.y_axis.y);
    let turning = DVec2::new(a + d, c - b).length() / 2.0;
    let reflecting = DVec2::new(a - d, c + b).length() / 2.0;
    (turning + reflecting, (turning - reflecting).abs())
}

/// The largest absolute value of an eigenvalue.
pub(crate) fn spectral_radius(m: DMat2) -> f64 {
    let half_trace = (m.x_axis.x + m.y_axis.y) / 2.0;
    let half_difference = (m.x_axis.x - m.y_axis.y) / 2.0;
    // This form of the discriminant does not cancel where trace^2 - 4 det would.
    let discriminant = half_difference.mul_add(half_difference, m.y_axis.x * m.x_axis.y);
    if discriminant >= 0.0 {
        half_trace.abs() + discriminant.sqrt()
    } else {
        // A pair of conjugate eigenvalues: its absolute value is the root of the determinant.
        half_trace.hypot((-discriminant).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_survive_the_round_trip_and_mean_what_they_say() {
        let row = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let map = Affine2::from_row(row);
        assert_eq!(map.to_row(), row);
        assert_eq!(map.apply(DVec2::new(10.0, 100.0)), DVec2::new(215.0, 436.0));
    }

    #[test]
    fn composition_applies_the_right_hand_map_first() {
        let a = Affine2::from_row([0.5, 0.1, -0.3, 0.7, 1.0, 2.0]);
        let b = Affine2::from_row([0.2, -0.6, 0.4, 0.3, -1.0, 0.5]);
        let x = DVec2::new(0.3, -0.8);
        assert!(((a * b).apply(x) - a.apply(b.apply(x))).length() < 1e-15);
    }

    #[test]
    fn singular_values_and_spectral_radius_of_known_matrices() {
        let shear = Affine2::from_row([1.0, 1.0, 0.0, 1.0, 0.0, 0.0]);
        let golden = f64::midpoint(1.0, 5.0_f64.sqrt());
        assert!((shear.norm() - golden).abs() < 1e-15);
        assert!((shear.singular_values().1 - 1.0 / golden).abs() < 1e-15);
        assert!((shear.spectral_radius() - 1.0).abs() < 1e-15);
        let turn = Affine2::similitude(0.7, 1.0, DVec2::ZERO);
        assert!((turn.norm() - 0.7).abs() < 1e-15);
        assert!((turn.spectral_radius() - 0.7).abs() < 1e-15);
        assert!(turn.is_similitude(1e-12) && !shear.is_similitude(0.1));
    }

    #[test]
    fn singular_maps_have_no_inverse_but_may_have_a_fixed_point() {
        let stem = Affine2::from_row([0.0, 0.0, 0.0, 0.16, 0.0, 0.0]);
        assert_eq!(stem.inverse(), None);
        assert_eq!(stem.fixed_point(), Some(DVec2::ZERO));
        assert_eq!(Affine2::IDENTITY.fixed_point(), None);
        assert_eq!(Affine2::from_row([f64::NAN; 6]).inverse(), None);
    }
}
