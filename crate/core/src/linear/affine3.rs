//! Affine maps of space.

use std::ops::Mul;

use glam::{DMat3, DVec3};

/// An affine map of space, `x -> linear * x + translation`.
///
/// Written as a row it has 12 numbers: the three rows of the matrix, then the translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine3 {
    /// The linear part.
    pub linear: DMat3,
    /// The translation.
    pub translation: DVec3,
}

impl Affine3 {
    /// The map that leaves every point where it is.
    pub const IDENTITY: Self = Self { linear: DMat3::IDENTITY, translation: DVec3::ZERO };

    /// A map from its linear part and its translation.
    #[must_use]
    pub const fn new(linear: DMat3, translation: DVec3) -> Self {
        Self { linear, translation }
    }

    /// A map from the rows of its matrix, then its translation.
    #[must_use]
    pub fn from_row(row: [f64; 12]) -> Self {
        let [a, b, c, d, e, f, g, h, i, x, y, z] = row;
        Self {
            linear: DMat3::from_cols_array(&[a, d, g, b, e, h, c, f, i]),
            translation: DVec3::new(x, y, z),
        }
    }

    /// The rows of the matrix, then the translation.
    #[must_use]
    pub fn to_row(self) -> [f64; 12] {
        let m = self.linear.transpose();
        let t = self.translation;
        [
            m.x_axis.x, m.x_axis.y, m.x_axis.z, m.y_axis.x, m.y_axis.y, m.y_axis.z, m.z_axis.x, m.z_axis.y,
            m.z_axis.z, t.x, t.y, t.z,
        ]
    }

    /// The image of a point.
    #[must_use]
    pub fn apply(self, point: DVec3) -> DVec3 {
        self.linear * point + self.translation
    }

    /// The factor by which the map changes volumes, negative if it reflects.
    #[must_use]
    pub fn determinant(self) -> f64 {
        self.linear.determinant()
    }

    /// The inverse map, or `None` when the linear part is singular.
    #[must_use]
    pub fn inverse(self) -> Option<Self> {
        let inverse = self.linear.inverse();
        let map = Self { linear: inverse, translation: -(inverse * self.translation) };
        (self.determinant() != 0.0 && map.is_finite()).then_some(map)
    }

    /// The point that the map leaves where it is, or `None` when there is not exactly one.
    #[must_use]
    pub fn fixed_point(self) -> Option<DVec3> {
        let m = DMat3::IDENTITY - self.linear;
        let point = m.inverse() * self.translation;
        (m.determinant() != 0.0 && point.is_finite()).then_some(point)
    }

    /// Whether all twelve numbers are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.linear.is_finite() && self.translation.is_finite()
    }

    /// The same map seen in other coordinates: `by * self * by^-1` (Darwish & Abd-El-Wahab, eq 1).
    /// `None` when `by` is singular.
    #[must_use]
    pub fn conjugate(self, by: Self) -> Option<Self> {
        by.inverse().map(|inverse| by * self * inverse)
    }
}

/// Composition: `(a * b).apply(x)` is `a.apply(b.apply(x))`.
impl Mul for Affine3 {
    type Output = Self;

    fn mul(self, inner: Self) -> Self {
        Self { linear: self.linear * inner.linear, translation: self.apply(inner.translation) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_survive_the_round_trip_and_mean_what_they_say() {
        let row = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0];
        let map = Affine3::from_row(row);
        assert_eq!(map.to_row(), row);
        assert_eq!(map.apply(DVec3::new(1.0, 10.0, 100.0)), DVec3::new(331.0, 665.0, 999.0));
    }

    #[test]
    fn a_flat_map_has_no_inverse() {
        let flat = Affine3::from_row([0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0]);
        assert_eq!(flat.inverse(), None);
        assert_eq!(flat.fixed_point(), Some(DVec3::new(2.0, 4.0, 3.0)));
    }
}
