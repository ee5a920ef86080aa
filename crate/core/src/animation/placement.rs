//! Where an object is: moved, turned and scaled.

use glam::{DMat3, DQuat, DVec3};

use crate::linear::affine::Affine3;
use crate::linear::polar3::{Polar3, jacobi};
use crate::linear::transform::TransformError;

/// A place in space: stretched, then turned, then moved. It is what key frames hold, since a turn and a stretch between
/// two places are known, whereas a matrix between two matrices may be flat.
///
/// The stretch is the symmetric factor of the polar decomposition. It is held as its logarithm, of which any mean is
/// that of a stretch again: its diagonal as scales, and what lies beside it as shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place3 {
    /// Where the object's origin goes.
    pub shift: DVec3,
    /// The turn, a unit quaternion.
    pub turn: DQuat,
    /// The scales along the object's own axes, each positive: powers of e of the diagonal of the stretch's logarithm.
    pub scale: DVec3,
    /// The entries yz, xz and xy of that logarithm: 0 where the stretch is along the object's axes.
    pub shear: DVec3,
}

impl Default for Place3 {
    fn default() -> Self {
        Self::HOME
    }
}

impl Place3 {
    /// Where the object was made.
    pub const HOME: Self =
        Self { shift: DVec3::ZERO, turn: DQuat::IDENTITY, scale: DVec3::ONE, shear: DVec3::ZERO };

    /// A place with this shift, this turn of any length but 0, and these scales.
    ///
    /// # Errors
    /// [`TransformError`] where a number is not finite, or a scale is not positive or out of range.
    pub fn new(shift: DVec3, turn: DQuat, scale: DVec3) -> Result<Self, TransformError> {
        let turn = turn / turn.length();
        if !(shift.is_finite() && turn.is_finite() && scale.is_finite()) {
            return Err(TransformError::NotFinite);
        }
        if scale.min_element() <= 0.0 {
            return Err(TransformError::Singular);
        }
        let place = Self { shift, turn, scale, shear: DVec3::ZERO };
        place.transform().undo()?;
        Ok(place)
    }

    /// The transform.
    #[must_use]
    pub fn transform(&self) -> Affine3 {
        Affine3::new(DMat3::from_quat(self.turn) * self.stretch(), self.shift)
    }

    /// The stretch, a symmetric matrix.
    #[must_use]
    pub fn stretch(&self) -> DMat3 {
        if self.shear == DVec3::ZERO {
            return DMat3::from_diagonal(self.scale);
        }
        let [x, y, z] = self.scale.to_array().map(f64::ln);
        let DVec3 { x: yz, y: xz, z: xy } = self.shear;
        symmetric(DMat3::from_cols_array(&[x, xy, xz, xy, y, yz, xz, yz, z]), f64::exp)
    }

    /// The place of a transform. A reflection is left out: it is that of the transform times -1.
    ///
    /// # Errors
    /// [`TransformError`] where the transform cannot be undone.
    pub fn of(transform: Affine3) -> Result<Self, TransformError> {
        transform.undo()?;
        let polar = Polar3::of(transform.linear);
        let side = polar.orthogonal.determinant().signum();
        let turn = DQuat::from_mat3(&(polar.orthogonal * side)).normalize();
        let s = polar.stretch;
        let beside = DVec3::new(s.z_axis.y, s.z_axis.x, s.y_axis.x);
        let diagonal = DVec3::new(s.x_axis.x, s.y_axis.y, s.z_axis.z).abs();
        // What is rounding only is left out, so that what was never sheared never is.
        if beside.abs().max_element() <= 1e-13 * diagonal.max_element() {
            return Self::new(transform.translation, turn, diagonal);
        }
        let log = symmetric(s, f64::ln);
        let scale = DVec3::new(log.x_axis.x, log.y_axis.y, log.z_axis.z).exp();
        let shear = DVec3::new(log.z_axis.y, log.z_axis.x, log.y_axis.x);
        let place = Self { shear, ..Self::new(transform.translation, turn, scale)? };
        place.transform().undo()?;
        Ok(place)
    }
}

/// A function of a symmetric matrix, by its eigenvalues.
fn symmetric(m: DMat3, of: impl Fn(f64) -> f64) -> DMat3 {
    let (values, vectors) = jacobi(m);
    vectors * DMat3::from_diagonal(DVec3::from_array(values.map(of))) * vectors.transpose()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_place_is_found_in_its_transform(
            axis in proptest::array::uniform3(-1.0..1.0_f64), angle in -3.0..3.0_f64,
            scale in proptest::array::uniform3(0.1..5.0_f64), shift in proptest::array::uniform3(-9.0..9.0_f64),
        ) {
            let axis = DVec3::from_array(axis);
            prop_assume!(axis.length() > 0.1);
            let turn = DQuat::from_axis_angle(axis.normalize(), angle);
            let place = Place3::new(DVec3::from_array(shift), turn * 2.0, DVec3::from_array(scale)).unwrap();
            let found = Place3::of(place.transform()).unwrap();
            prop_assert!(found.shift == place.shift && (found.scale - place.scale).length() < 1e-9);
            prop_assert!(found.turn.dot(place.turn).abs() > 1.0 - 1e-9);
        }
    }

    proptest! {
        #[test]
        fn no_transform_loses_anything(
            m in proptest::array::uniform9(-2.0..2.0_f64), shift in proptest::array::uniform3(-9.0..9.0_f64),
        ) {
            let transform = Affine3::new(DMat3::from_cols_array(&m), DVec3::from_array(shift));
            prop_assume!(transform.determinant().abs() > 1e-2);
            let found = Place3::of(transform).unwrap().transform();
            let same = transform.linear * transform.determinant().signum();
            let off = (found.linear - same).to_cols_array().into_iter().fold(0.0_f64, |a, x| a.max(x.abs()));
            prop_assert!(off < 1e-8 && found.translation == transform.translation, "{off}");
        }
    }

    #[test]
    fn places_that_are_none_are_refused() {
        let new = |shift: f64, w: f64, scale: f64| {
            Place3::new(DVec3::splat(shift), DQuat::from_xyzw(0.0, 0.0, 0.0, w), DVec3::new(1.0, 1.0, scale))
        };
        assert!(new(1.0, 1.0, 1.0).is_ok());
        for bad in [
            new(f64::NAN, 1.0, 1.0),
            new(0.0, 0.0, 1.0),
            new(0.0, 1.0, 0.0),
            new(0.0, 1.0, -1.0),
            new(0.0, 1.0, 1e-300),
        ] {
            assert!(bad.is_err(), "{bad:?}");
        }
    }
}
