//! Affine maps of space: their rows, and those that are made of turns, scales or a shear.

use glam::{DMat3, DQuat, DVec3};

use crate::linear::affine::{Affine2, Affine3};
use crate::linear::sin_cos::sin_cos;
use crate::linear::svd3::singular_values3;
use crate::linear::transform::TransformError;

impl Affine3 {
    /// A map from the rows of its matrix, then its translation.
    #[must_use]
    pub fn from_row(row: [f64; 12]) -> Self {
        let [a, b, c, d, e, f, g, h, i, x, y, z] = row;
        Self {
            linear: DMat3::from_cols_array(&[a, d, g, b, e, h, c, f, i]),
            translation: DVec3::new(x, y, z),
        }
    }

    /// A map of the plane as one of space, flat at z = 0: across the plane it shrinks as it does along it on the whole.
    #[must_use]
    pub fn lifted(map: &Affine2) -> Self {
        let [a, b, c, d, e, f] = map.to_row();
        let across = map.determinant().abs().sqrt().min(0.99);
        Self::from_row([a, b, 0.0, c, d, 0.0, 0.0, 0.0, across, e, f, 0.0])
    }

    /// Scales by `factors` along x, y and z, about the origin.
    #[must_use]
    pub fn scaling(factors: DVec3) -> Self {
        Self::new(DMat3::from_diagonal(factors), DVec3::ZERO)
    }

    /// An upper bound of how much the map stretches, sooner found than its norm: exact for similitudes.
    #[must_use]
    pub fn stretch(self) -> f64 {
        let gram = self.linear.transpose() * self.linear;
        let row = |r: DVec3| r.abs().element_sum();
        row(gram.x_axis).max(row(gram.y_axis)).max(row(gram.z_axis)).sqrt()
    }

    /// A similitude: scale, turn, then move.
    #[must_use]
    pub fn similitude(scale: f64, turn: DQuat, translation: DVec3) -> Self {
        Self::new(DMat3::from_quat(turn) * scale, translation)
    }

    /// Turns by `angle` (radians) about an axis through the origin, counter-clockwise seen from its tip. Quarter turns
    /// about x, y and z are exact.
    ///
    /// # Errors
    /// [`TransformError::NotFinite`] where the axis is zero or a number is not finite.
    pub fn rotation(axis: DVec3, angle: f64) -> Result<Self, TransformError> {
        let size = axis.abs().max_element();
        let axis = (axis / size).normalize();
        if !axis.is_finite() || !angle.is_finite() {
            return Err(TransformError::NotFinite);
        }
        let (sin, cos) = sin_cos(angle);
        // Rodrigues' formula, column by column.
        let column = |e: DVec3| e * cos + axis.cross(e) * sin + axis * (axis.dot(e) * (1.0 - cos));
        let linear = DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z));
        Ok(Self::new(linear, DVec3::ZERO))
    }

    /// Turns about x, then about y, then about z, by angles in radians: the order in which the paper's figures are
    /// turned.
    ///
    /// # Errors
    /// [`TransformError::NotFinite`] where an angle is not finite.
    pub fn euler(angles: DVec3) -> Result<Self, TransformError> {
        let about = |axis, angle| Self::rotation(axis, angle);
        Ok(about(DVec3::Z, angles.z)? * about(DVec3::Y, angles.y)? * about(DVec3::X, angles.x)?)
    }

    /// Turns by a quaternion of any length but 0.
    ///
    /// # Errors
    /// [`TransformError::NotFinite`] where the quaternion is zero or not finite.
    pub fn turning(turn: DQuat) -> Result<Self, TransformError> {
        let unit = turn / turn.length();
        if !unit.is_finite() {
            return Err(TransformError::NotFinite);
        }
        Ok(Self::new(DMat3::from_quat(unit), DVec3::ZERO))
    }

    /// Shears: `x' = x + xy y + xz z`, `y' = yx x + y + yz z`, `z' = zx x + zy y + z`, given as
    /// `[xy, xz, yx, yz, zx, zy]`.
    #[must_use]
    pub fn shear([xy, xz, yx, yz, zx, zy]: [f64; 6]) -> Self {
        Self::from_row([1.0, xy, xz, yx, 1.0, yz, zx, zy, 1.0, 0.0, 0.0, 0.0])
    }

    /// The three singular values of the linear part, the largest first.
    #[must_use]
    pub fn singular_values(self) -> [f64; 3] {
        singular_values3(self.linear)
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
