//! Where an object is: moved, turned and scaled.

use glam::{DMat3, DQuat, DVec3};

use crate::affine3::Affine3;
use crate::polar3::Polar3;
use crate::transform::TransformError;

/// A place in space: scaled along its own axes, then turned, then moved. It is what key frames hold, since a turn and a
/// scale between two places are known, whereas a matrix between two matrices may be flat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place3 {
    /// Where the object's origin goes.
    pub shift: DVec3,
    /// The turn, a unit quaternion.
    pub turn: DQuat,
    /// The scales along the object's own axes, each positive.
    pub scale: DVec3,
}

impl Default for Place3 {
    fn default() -> Self {
        Self::HOME
    }
}

impl Place3 {
    /// Where the object was made.
    pub const HOME: Self = Self { shift: DVec3::ZERO, turn: DQuat::IDENTITY, scale: DVec3::ONE };

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
        let place = Self { shift, turn, scale };
        place.transform().undo()?;
        Ok(place)
    }

    /// The transform.
    #[must_use]
    pub fn transform(&self) -> Affine3 {
        Affine3::new(DMat3::from_quat(self.turn) * DMat3::from_diagonal(self.scale), self.shift)
    }

    /// The place nearest to a transform: its polar factor, and the diagonal of its stretch. Whatever shears or reflects is
    /// left out; of a similitude nothing is.
    ///
    /// # Errors
    /// [`TransformError`] where the transform cannot be undone.
    pub fn of(transform: Affine3) -> Result<Self, TransformError> {
        transform.undo()?;
        let polar = Polar3::of(transform.linear);
        let side = polar.orthogonal.determinant().signum();
        let turn = DQuat::from_mat3(&(polar.orthogonal * side)).normalize();
        let diagonal = DVec3::new(polar.stretch.x_axis.x, polar.stretch.y_axis.y, polar.stretch.z_axis.z);
        Self::new(transform.translation, turn, diagonal.abs())
    }
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
