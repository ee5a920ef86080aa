//! Affine maps of the plane: their rows, and those that are made of a turn, scales or a shear.

use glam::{DMat2, DVec2};

use crate::linear::affine::Affine2;
use crate::linear::sin_cos::sin_cos;
use crate::linear::svd2::singular_values;

impl Affine2 {
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

    /// Scales by `factors` along x and y, about the origin.
    #[must_use]
    pub fn scaling(factors: DVec2) -> Self {
        Self::new(DMat2::from_diagonal(factors), DVec2::ZERO)
    }

    /// Turns by `angle` (radians, counter-clockwise) about the origin. Quarter turns are exact.
    #[must_use]
    pub fn rotation(angle: f64) -> Self {
        let (sin, cos) = sin_cos(angle);
        Self::new(DMat2::from_cols(DVec2::new(cos, sin), DVec2::new(-sin, cos)), DVec2::ZERO)
    }

    /// Shears: `x' = x + along_x y`, `y' = y + along_y x`. Singular where their product is 1.
    #[must_use]
    pub const fn shear(along_x: f64, along_y: f64) -> Self {
        Self::from_row([1.0, along_x, along_y, 1.0, 0.0, 0.0])
    }

    /// Both singular values of the linear part, the larger first: how much the map stretches at most
    /// and at least.
    #[inline]
    #[must_use]
    pub fn singular_values(self) -> (f64, f64) {
        singular_values(self.linear)
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
