//! Which way a displacement points in each piece.

use frond_core::{Affine, Dim2, Dim3, Dimension, Polar2, Polar3};
use glam::{DMat2, DMat3, DVec2, DVec3};
use serde::{Deserialize, Serialize};

/// How the displacement of a piece follows the turns of the maps that lead to it, so that every leaflet of a fern
/// sways about its own stem (Fujimoto et al., section 5.3, examples 2 and 3).
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Spin {
    /// It does not: displacements keep their direction.
    #[default]
    None,
    /// By the orthogonal polar factor, reflections included.
    Orthogonal,
    /// By the rotation that is left when a reflection x -> -x is split off first.
    Rotation,
    /// By A / ||A||: the orthogonal factor for a similarity, less across a flat map, without cases.
    Scaled,
}

/// What turns are in the plane and in space: polar factors.
pub trait Turning: Dimension {
    /// The orthogonal polar factor of a matrix that is not singular.
    fn orthogonal(m: Self::Matrix) -> Self::Matrix;
    /// What is left of it when a reflection x -> -x is split off first, if it reflects.
    fn rotation(m: Self::Matrix) -> Self::Matrix;
}

impl Turning for Dim2 {
    fn orthogonal(m: DMat2) -> DMat2 {
        Polar2::of(m).orthogonal()
    }

    fn rotation(m: DMat2) -> DMat2 {
        let flip = DMat2::from_diagonal(DVec2::new(-1.0, 1.0));
        if m.determinant() < 0.0 {
            DMat2::from_angle(Polar2::turning(m * flip).angle)
        } else {
            Self::orthogonal(m)
        }
    }
}

impl Turning for Dim3 {
    fn orthogonal(m: DMat3) -> DMat3 {
        Polar3::of(m).orthogonal
    }

    fn rotation(m: DMat3) -> DMat3 {
        let flip = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0));
        Self::orthogonal(if m.determinant() < 0.0 { m * flip } else { m })
    }
}

impl Spin {
    /// The factor of one map. A singular map gives the identity, but for [`Spin::Scaled`], where only the zero map
    /// does.
    #[must_use]
    pub fn factor<D: Turning>(self, map: &Affine<D>) -> D::Matrix {
        let m = map.linear;
        let norm = map.norm();
        if self == Self::None || norm == 0.0 || !norm.is_finite() {
            return D::IDENTITY;
        }
        if self == Self::Scaled {
            return m * (1.0 / norm);
        }
        // In the plane, the smaller stretch over the larger.
        if D::determinant(m).abs() <= 1e-12 * norm.powi(D::COORDINATES as i32) {
            return D::IDENTITY;
        }
        if self == Self::Rotation { D::rotation(m) } else { D::orthogonal(m) }
    }
}

#[cfg(test)]
mod tests {
    use frond_core::{Affine2, Affine3};
    use glam::DQuat;

    use super::*;

    #[test]
    fn factors_of_similarities_are_their_turns() {
        let turned = Affine2::similitude(0.3, 1.0, DVec2::X);
        for spin in [Spin::Orthogonal, Spin::Rotation, Spin::Scaled] {
            let difference = spin.factor(&turned) - DMat2::from_angle(1.0);
            assert!(difference.abs().to_cols_array().iter().all(|x| *x < 1e-12), "{spin:?}");
        }
        assert_eq!(Spin::None.factor(&turned), DMat2::IDENTITY);
    }

    #[test]
    fn reflections_and_flat_maps() {
        let mirror = Affine2::from_row([-0.5, 0.0, 0.0, 0.5, 1.0, 0.0]);
        assert!(Spin::Orthogonal.factor(&mirror).determinant() < -0.99);
        assert!((Spin::Rotation.factor(&mirror) - DMat2::IDENTITY).determinant().abs() < 1e-12);
        let stem = Affine2::from_row([0.0, 0.0, 0.0, 0.16, 0.0, 0.0]);
        assert_eq!(Spin::Orthogonal.factor(&stem), DMat2::IDENTITY);
        assert_eq!(Spin::Rotation.factor(&stem), DMat2::IDENTITY);
        assert_eq!(Spin::Scaled.factor(&stem), DMat2::from_diagonal(DVec2::Y));
        let zero = Affine2::new(DMat2::ZERO, DVec2::X);
        assert_eq!(Spin::Scaled.factor(&zero), DMat2::IDENTITY);
    }

    #[test]
    fn in_space_they_are_turns_as_well() {
        let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -1.0).normalize(), 0.7);
        let near = |a: DMat3, b: DMat3| (a - b).to_cols_array().iter().all(|x| x.abs() < 1e-12);
        let turned = Affine3::similitude(0.3, turn, DVec3::X);
        for spin in [Spin::Orthogonal, Spin::Rotation, Spin::Scaled] {
            assert!(near(spin.factor(&turned), DMat3::from_quat(turn)), "{spin:?}");
        }
        assert_eq!(Spin::None.factor(&turned), DMat3::IDENTITY);
        let flip = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0));
        let mirrored = Affine3::new(turned.linear * flip, DVec3::ZERO);
        assert!(near(Spin::Orthogonal.factor(&mirrored), DMat3::from_quat(turn) * flip));
        assert!(near(Spin::Rotation.factor(&mirrored), DMat3::from_quat(turn)));
        let flat = Affine3::scaling(DVec3::new(0.5, 0.5, 0.0));
        assert_eq!(Spin::Orthogonal.factor(&flat), DMat3::IDENTITY);
        // The norm of a flat map of space is known to eight digits.
        let scaled = Spin::Scaled.factor(&flat) - DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0));
        assert!(scaled.to_cols_array().iter().all(|x| x.abs() < 1e-8));
    }
}
