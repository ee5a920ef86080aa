//! The affine maps by which a shape is moved, and moving a shape by them (Darwish & Abd-El-Wahab, eq 1).
//!
//! Moving a shape is moving its parameters: with `T x = A x + b` every map `w` becomes `T w T^-1`, and the attractor
//! of the new maps is the image of the old one under `T`.

use glam::{DMat2, DMat3, DQuat, DVec2, DVec3, EulerRot};
use thiserror::Error;

use crate::error::IfsError;
use crate::linear::affine2::{Affine2, singular_values};
use crate::linear::affine3::Affine3;
use crate::linear::svd3::singular_values3;

/// Why a shape cannot be moved as asked.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum TransformError {
    /// A number of the transform is NaN or infinite, or an axis has no direction.
    #[error("The transform holds a number that is not finite. Give numbers, and an axis that is not zero.")]
    NotFinite,
    /// The transform flattens the shape, so that there is no way back.
    #[error(
        "This transform flattens the shape, and no parameters describe the way back. Scale by more than 0."
    )]
    Singular,
    /// Its least and its largest scale are too far apart for the maps to keep their digits.
    #[error(
        "This transform scales by {least:e} one way and by {largest:e} another: the parameters would lose all their \
         digits. Keep the scales within a factor of 1e12."
    )]
    NearlySingular {
        /// The least scale.
        least: f64,
        /// The largest scale.
        largest: f64,
    },
    /// It is out of the range of numbers that can be drawn.
    #[error(
        "This transform scales by {scale:e}, which no picture shows. Keep scales between 1e-100 and 1e100."
    )]
    Scale {
        /// The scale that is too small or too large.
        scale: f64,
    },
    /// The maps that come out are no system, for instance because a number is too large.
    #[error(transparent)]
    Ifs(#[from] IfsError),
}

impl TransformError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NotFinite => "transform-not-finite",
            Self::Singular => "transform-singular",
            Self::NearlySingular { .. } => "transform-nearly-singular",
            Self::Scale { .. } => "transform-scale",
            Self::Ifs(error) => error.code(),
        }
    }
}

/// Scales beyond these are refused.
const SCALES: std::ops::Range<f64> = 1e-100..1e100;
/// So are transforms whose scales are farther apart than this.
const CONDITION: f64 = 1e12;

fn check(finite: bool, largest: f64, least: f64) -> Result<(), TransformError> {
    if !finite {
        return Err(TransformError::NotFinite);
    }
    if least == 0.0 || largest == 0.0 {
        return Err(TransformError::Singular);
    }
    if let Some(&scale) = [largest, least].iter().find(|scale| !SCALES.contains(scale)) {
        // One axis flat, the others not: that is nearer to what went wrong.
        return Err(if largest > least * CONDITION && SCALES.contains(&largest) {
            TransformError::NearlySingular { least, largest }
        } else {
            TransformError::Scale { scale }
        });
    }
    if largest > least * CONDITION {
        return Err(TransformError::NearlySingular { least, largest });
    }
    Ok(())
}

impl Affine2 {
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

    /// Moves by `shift`.
    #[must_use]
    pub const fn moving(shift: DVec2) -> Self {
        Self::new(DMat2::IDENTITY, shift)
    }

    /// Shears: `x' = x + along_x y`, `y' = y + along_y x`. Singular where their product is 1.
    #[must_use]
    pub const fn shear(along_x: f64, along_y: f64) -> Self {
        Self::from_row([1.0, along_x, along_y, 1.0, 0.0, 0.0])
    }

    /// The same transform about another point than the origin, which stays where it is if the transform left the origin.
    #[must_use]
    pub fn about(self, point: DVec2) -> Self {
        Self::moving(point) * self * Self::moving(-point)
    }

    /// The inverse of a transform that shapes may be moved by.
    ///
    /// # Errors
    /// [`TransformError`] where the transform is singular, nearly so, not finite or out of range.
    pub fn undo(self) -> Result<Self, TransformError> {
        // In units of the largest number, so that the squares of small ones do not vanish.
        let unit =
            self.to_row()[..4].iter().fold(0.0_f64, |most, x| most.max(x.abs())).max(f64::MIN_POSITIVE);
        let (largest, least) = singular_values(self.linear * (1.0 / unit));
        let (largest, least) = (largest * unit, least * unit);
        check(self.is_finite(), largest, least)?;
        // In units of the largest scale, so that the determinant neither vanishes nor overflows.
        let unit = power_of_two(largest);
        let inverse = (self.linear * (1.0 / unit)).inverse() * (1.0 / unit);
        Ok(Self::new(inverse, -(inverse * self.translation)))
    }

    /// The map seen after the plane has been moved by `by`: `by * self * by^-1` (Darwish & Abd-El-Wahab, eq 1).
    ///
    /// # Errors
    /// As [`Affine2::undo`] of `by`.
    pub fn moved(self, by: Self) -> Result<Self, TransformError> {
        Ok(by * self * by.undo()?)
    }
}

impl Affine3 {
    /// Scales by `factors` along x, y and z, about the origin.
    #[must_use]
    pub fn scaling(factors: DVec3) -> Self {
        Self::new(DMat3::from_diagonal(factors), DVec3::ZERO)
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

    /// Turns about x, then about y, then about z, by angles in radians: the order in which the paper's figures are turned.
    ///
    /// # Errors
    /// [`TransformError::NotFinite`] where an angle is not finite.
    pub fn euler(angles: DVec3) -> Result<Self, TransformError> {
        let about = |axis, angle| Self::rotation(axis, angle);
        Ok(about(DVec3::Z, angles.z)? * about(DVec3::Y, angles.y)? * about(DVec3::X, angles.x)?)
    }

    /// The angles that [`Affine3::euler`] takes for the turn of a unit quaternion.
    #[must_use]
    pub fn euler_of(turn: DQuat) -> DVec3 {
        let (z, y, x) = turn.to_euler(EulerRot::ZYX);
        DVec3::new(x, y, z)
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

    /// Moves by `shift`.
    #[must_use]
    pub const fn moving(shift: DVec3) -> Self {
        Self::new(DMat3::IDENTITY, shift)
    }

    /// Shears: `x' = x + xy y + xz z`, `y' = yx x + y + yz z`, `z' = zx x + zy y + z`, given as
    /// `[xy, xz, yx, yz, zx, zy]`.
    #[must_use]
    pub fn shear([xy, xz, yx, yz, zx, zy]: [f64; 6]) -> Self {
        Self::from_row([1.0, xy, xz, yx, 1.0, yz, zx, zy, 1.0, 0.0, 0.0, 0.0])
    }

    /// The same transform about another point than the origin, which stays where it is if the transform left the origin.
    #[must_use]
    pub fn about(self, point: DVec3) -> Self {
        Self::moving(point) * self * Self::moving(-point)
    }

    /// The inverse of a transform that shapes may be moved by.
    ///
    /// # Errors
    /// [`TransformError`] where the transform is singular, nearly so, not finite or out of range.
    pub fn undo(self) -> Result<Self, TransformError> {
        let [largest, _, least] = singular_values3(self.linear);
        check(self.is_finite(), largest, least)?;
        let unit = power_of_two(largest);
        let inverse = (self.linear * (1.0 / unit)).inverse() * (1.0 / unit);
        Ok(Self::new(inverse, -(inverse * self.translation)))
    }

    /// The map seen after space has been moved by `by`: `by * self * by^-1` (Darwish & Abd-El-Wahab, eq 1).
    ///
    /// # Errors
    /// As [`Affine3::undo`] of `by`.
    pub fn moved(self, by: Self) -> Result<Self, TransformError> {
        Ok(by * self * by.undo()?)
    }

    /// The three singular values of the linear part, the largest first.
    #[must_use]
    pub fn singular_values(self) -> [f64; 3] {
        singular_values3(self.linear)
    }

    /// The operator norm of the linear part: the largest factor by which a distance grows.
    #[must_use]
    pub fn norm(self) -> f64 {
        crate::linear::svd3::norm3(self.linear)
    }

    /// The largest absolute value of an eigenvalue of the linear part.
    #[must_use]
    pub fn spectral_radius(self) -> f64 {
        crate::linear::svd3::spectral_radius3(self.linear)
    }

    /// Whether the map scales all distances by one factor, to a relative `tolerance`.
    #[must_use]
    pub fn is_similitude(self, tolerance: f64) -> bool {
        let [large, _, small] = self.singular_values();
        large - small <= tolerance * large
    }
}

/// Sine and cosine, exact at whole quarter turns as they are written in floating point.
fn sin_cos(angle: f64) -> (f64, f64) {
    let quarters = angle / std::f64::consts::FRAC_PI_2;
    if quarters.fract() == 0.0 && quarters.abs() < 1e15 {
        return [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][quarters.rem_euclid(4.0) as usize];
    }
    angle.sin_cos()
}

/// The power of two at or below a positive number: dividing by it costs no digit.
fn power_of_two(x: f64) -> f64 {
    x.log2().floor().exp2()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use proptest::prelude::*;

    use super::*;

    fn apart(a: Affine3, b: Affine3) -> f64 {
        a.to_row().iter().zip(b.to_row()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    }

    fn any_transform() -> impl Strategy<Value = Affine3> {
        let number = || prop_oneof![4 => -2.0..2.0_f64, 1 => Just(0.0), 1 => Just(1.0)];
        proptest::collection::vec(number(), 12).prop_map(|row| {
            let row: [f64; 12] = row.try_into().unwrap_or([0.0; 12]);
            Affine3::from_row(row)
        })
    }

    proptest! {
        #[test]
        fn moving_the_map_is_moving_the_points(map in any_transform(), by in any_transform(), x in -3.0..3.0_f64) {
            let [large, _, small] = by.singular_values();
            prop_assume!(small > 1e-3 * large);
            let moved = map.moved(by).unwrap();
            let point = DVec3::new(x, 1.0 - x, 0.3);
            let (there, here) = (moved.apply(by.apply(point)), by.apply(map.apply(point)));
            prop_assert!(there.distance(here) < 1e-9 * (1.0 + here.length()) / (small / large), "{there} {here}");
            // And back.
            let back = moved.moved(by.undo().unwrap()).unwrap();
            prop_assert!(apart(back, map) < 1e-7 * (large / small).powi(2), "{back:?}");
        }

        #[test]
        fn angles_and_quaternions_agree(x in -1.5..1.5_f64, y in -1.5..1.5_f64, z in -3.0..3.0_f64) {
            let angles = DVec3::new(x, y, z);
            let euler = Affine3::euler(angles).unwrap();
            let turn = DQuat::from_mat3(&euler.linear);
            prop_assert!(apart(Affine3::turning(turn * 3.0).unwrap(), euler) < 1e-12);
            prop_assert!(apart(Affine3::euler(Affine3::euler_of(turn)).unwrap(), euler) < 1e-12);
        }
    }

    #[test]
    fn what_is_exact_comes_back_to_the_last_bit() {
        let map = Affine3::from_row([0.3, 0.1, -0.2, 0.05, 0.4, 0.1, 0.7, -0.3, 0.2, 1.5, -2.25, 3.75]);
        let quarter = Affine3::rotation(DVec3::new(0.0, 0.0, 3.0), FRAC_PI_2).unwrap();
        for by in [quarter, Affine3::scaling(DVec3::new(2.0, 0.25, -8.0)), quarter * quarter * quarter] {
            assert_eq!(map.moved(by).unwrap().moved(by.undo().unwrap()), Ok(map));
        }
        let flat = Affine2::from_row([0.3, 0.1, -0.2, 0.4, 1.5, -2.25]);
        for by in
            [Affine2::rotation(-FRAC_PI_2), Affine2::rotation(PI), Affine2::scaling(DVec2::new(-4.0, 0.5))]
        {
            assert_eq!(flat.moved(by).unwrap().moved(by.undo().unwrap()), Ok(flat));
        }
    }

    #[test]
    fn about_a_point_it_stays() {
        let point = DVec3::new(1.0, 2.0, 3.0);
        let turn = Affine3::rotation(DVec3::ONE, 1.0).unwrap().about(point);
        assert!(turn.apply(point).distance(point) < 1e-15);
        let flat = DVec2::new(1.0, 2.0);
        assert!(Affine2::shear(0.5, 0.0).about(flat).apply(flat).distance(flat) < 1e-15);
        assert_eq!(
            Affine3::shear([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).apply(DVec3::ONE),
            DVec3::new(4.0, 8.0, 12.0)
        );
        // Counter-clockwise.
        assert_eq!(Affine3::rotation(DVec3::Z, FRAC_PI_2).unwrap().apply(DVec3::X), DVec3::Y);
        assert_eq!(Affine2::rotation(FRAC_PI_2).apply(DVec2::X), DVec2::Y);
    }

    #[test]
    fn what_cannot_be_undone_is_refused_with_a_reason() {
        let code = |by: Affine3| by.undo().map_or_else(|error| error.code(), |_| "done");
        let scale = |x: f64, y: f64, z: f64| Affine3::scaling(DVec3::new(x, y, z));
        assert_eq!(code(scale(1.0, 1.0, 0.0)), "transform-singular");
        assert_eq!(code(scale(0.0, 0.0, 0.0)), "transform-singular");
        assert_eq!(code(scale(1e-300, 1e-300, 1e-300)), "transform-scale");
        assert_eq!(code(scale(1e300, 1e300, 1e300)), "transform-scale");
        assert_eq!(code(scale(1.0, 1e-300, 1.0)), "transform-nearly-singular");
        assert_eq!(code(scale(1.0, 1.0, 1e-13)), "transform-nearly-singular");
        assert_eq!(code(scale(f64::NAN, 1.0, 1.0)), "transform-not-finite");
        assert_eq!(code(scale(1.0, f64::INFINITY, 1.0)), "transform-not-finite");
        assert_eq!(code(Affine3::moving(DVec3::splat(f64::NAN))), "transform-not-finite");
        // Small all over is no reason: its determinant would be 1e-297.
        assert_eq!(code(scale(1e-99, 1e-99, 1e-99)), "done");
        assert_eq!(Affine2::scaling(DVec2::splat(1e-300)).undo().unwrap_err().code(), "transform-scale");
        assert_eq!(Affine2::shear(1.0, 1.0).undo(), Err(TransformError::Singular));
        assert!(
            Affine3::rotation(DVec3::ZERO, 1.0).is_err() && Affine3::rotation(DVec3::X, f64::NAN).is_err()
        );
        assert!(Affine3::turning(DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)).is_err());
        assert!(
            Affine3::rotation(DVec3::splat(1e-300), 1.0).is_ok()
                && Affine3::rotation(DVec3::splat(1e300), 1.0).is_ok()
        );
    }
}
