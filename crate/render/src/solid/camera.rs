//! Where a picture of space is taken from.

use glam::{DMat3, DVec3};
use thiserror::Error;

/// Why there is no view.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum CameraError {
    /// A number is not finite, or too large.
    #[error("The camera's place is not a number that can be used. Give finite numbers below 1e100.")]
    NotFinite,
    /// The eye lies where it is to look.
    #[error("The eye lies where it looks: there is no direction. Move one of the two.")]
    NoDirection,
    /// The angle is not between 0 and a half turn.
    #[error("The angle of view must be above 0 and below 180 degrees.")]
    BadAngle,
}

impl CameraError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NotFinite => "camera-not-finite",
            Self::NoDirection => "camera-no-direction",
            Self::BadAngle => "camera-angle",
        }
    }
}

/// A pinhole camera: what lies at depth z before the eye and x beside its axis is seen at x / z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye, in units of space.
    pub eye: DVec3,
    /// Turns space so that x points to the right, y up and z away from the eye. A rotation, but for its handedness.
    pub turn: DMat3,
    /// Half the height of the picture at depth 1.
    pub slope: f64,
}

impl Camera {
    /// From `eye` to `target`, with `up` upwards as far as possible; `angle` is the height of the picture, in radians.
    ///
    /// # Errors
    /// [`CameraError`] where there is no such view.
    pub fn looking(eye: DVec3, target: DVec3, up: DVec3, angle: f64) -> Result<Self, CameraError> {
        let held = |p: DVec3| p.is_finite() && p.abs().max_element() <= 1e100;
        if !(held(eye) && held(target) && held(up)) {
            return Err(CameraError::NotFinite);
        }
        if !(angle > 0.0 && angle < std::f64::consts::PI) {
            return Err(CameraError::BadAngle);
        }
        let ahead = (target - eye).try_normalize().ok_or(CameraError::NoDirection)?;
        let beside = ahead.cross(up.normalize_or_zero());
        // Straight up or down: any side will do.
        let right = if beside.length() > 1e-9 { beside.normalize() } else { ahead.any_orthonormal_vector() };
        let turn = DMat3::from_cols(right, right.cross(ahead), ahead).transpose();
        Ok(Self { eye, turn, slope: (0.5 * angle).tan() })
    }

    /// Around `target` at a `distance`: `turn` to the side, from where y is straight ahead, and `tilt` upwards, in
    /// radians; z is up.
    ///
    /// # Errors
    /// As [`looking`](Self::looking).
    pub fn around(
        target: DVec3,
        distance: f64,
        turn: f64,
        tilt: f64,
        angle: f64,
    ) -> Result<Self, CameraError> {
        let (sin, cos) = turn.sin_cos();
        let (rise, flat) = tilt.sin_cos();
        let away = DVec3::new(sin * flat, -cos * flat, rise);
        // Over the top, up is where the turn points: the picture does not flip.
        let up = DVec3::new(-sin * rise, cos * rise, flat);
        Self::looking(target + distance * away, target, up, angle)
    }

    /// A point as the eye has it: x to the right, y up, z away.
    #[must_use]
    pub fn seen(&self, point: DVec3) -> DVec3 {
        self.turn * (point - self.eye)
    }

    /// Pixels for a unit at depth 1 in a picture that is `height` pixels high.
    #[must_use]
    pub fn focal(&self, height: u32) -> f64 {
        0.5 * f64::from(height) / self.slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_looks_where_it_is_told() {
        let eye = DVec3::new(15.0, 0.0, 0.0);
        let camera = Camera::looking(eye, DVec3::ZERO, DVec3::Y, 1.0).unwrap();
        assert!((camera.seen(DVec3::ZERO) - DVec3::new(0.0, 0.0, 15.0)).length() < 1e-12);
        let above = camera.seen(DVec3::Y);
        assert!(above.y > 0.99 && above.x.abs() < 1e-12);
        // From +x towards the origin with y up, -z lies to the right.
        assert!((camera.seen(-DVec3::Z).x - 1.0).abs() < 1e-12);
    }

    #[test]
    fn round_about_z_is_up() {
        let camera = Camera::around(DVec3::ZERO, 5.0, 0.0, 0.0, 0.8).unwrap();
        assert!((camera.eye - DVec3::new(0.0, -5.0, 0.0)).length() < 1e-12);
        assert!((camera.seen(DVec3::Z) - DVec3::new(0.0, 1.0, 5.0)).length() < 1e-12);
        assert!((camera.seen(DVec3::X) - DVec3::new(1.0, 0.0, 5.0)).length() < 1e-12);
        let right = Camera::around(DVec3::ZERO, 5.0, std::f64::consts::FRAC_PI_2, 0.0, 0.8).unwrap();
        assert!((right.eye - DVec3::new(5.0, 0.0, 0.0)).length() < 1e-12);
    }

    #[test]
    fn going_round_keeps_distance_and_never_flips() {
        let target = DVec3::new(1.0, 2.0, 3.0);
        let mut last: Option<DMat3> = None;
        for step in 0..=400 {
            let tilt = f64::from(step) / 400.0 * 7.0 - 3.5;
            let camera = Camera::around(target, 4.0, 0.7, tilt, 0.8).unwrap();
            assert!((camera.seen(target) - DVec3::new(0.0, 0.0, 4.0)).length() < 1e-9);
            if let Some(before) = last {
                let moved = camera.turn - before;
                assert!(moved.to_cols_array().iter().all(|x| x.abs() < 0.05), "tilt {tilt}");
            }
            last = Some(camera.turn);
        }
    }

    #[test]
    fn what_is_no_view_is_refused() {
        let look = |eye, target, angle| Camera::looking(eye, target, DVec3::Y, angle);
        assert_eq!(look(DVec3::X, DVec3::X, 1.0), Err(CameraError::NoDirection));
        assert_eq!(look(DVec3::splat(f64::NAN), DVec3::X, 1.0), Err(CameraError::NotFinite));
        assert_eq!(look(DVec3::splat(1e200), DVec3::X, 1.0), Err(CameraError::NotFinite));
        for angle in [0.0, -1.0, 3.2, f64::NAN] {
            assert_eq!(look(DVec3::Z, DVec3::X, angle), Err(CameraError::BadAngle));
        }
        assert!(look(DVec3::Y, DVec3::ZERO, 1.0).is_ok(), "straight down");
    }
}
