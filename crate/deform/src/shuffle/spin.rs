//! Which way a displacement points in each piece.

use frond_core::{Affine2, Polar2};
use glam::{DMat2, DVec2};
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

impl Spin {
    /// The factor of one map. A singular map gives the identity, but for [`Spin::Scaled`], where only the zero map
    /// does.
    #[must_use]
    pub fn factor(self, map: &Affine2) -> DMat2 {
        let m = map.linear;
        let norm = map.norm();
        if self == Self::None || norm == 0.0 || !norm.is_finite() {
            return DMat2::IDENTITY;
        }
        if self == Self::Scaled {
            return m * (1.0 / norm);
        }
        // The smaller stretch over the larger.
        if m.determinant().abs() <= 1e-12 * norm * norm {
            return DMat2::IDENTITY;
        }
        let flip = DMat2::from_diagonal(DVec2::new(-1.0, 1.0));
        match self {
            Self::Rotation if m.determinant() < 0.0 => DMat2::from_angle(Polar2::turning(m * flip).angle),
            _ => Polar2::of(m).orthogonal(),
        }
    }
}

#[cfg(test)]
mod tests {
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
}
