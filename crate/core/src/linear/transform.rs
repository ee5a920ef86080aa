//! Why a shape cannot be moved by an affine map (Darwish & Abd-El-Wahab, eq 1).
//!
//! Moving a shape is moving its parameters: with `T x = A x + b` every map `w` becomes `T w T^-1`, and the attractor
//! of the new maps is the image of the old one under `T`.

use thiserror::Error;

use crate::error::IfsError;

/// Why a shape cannot be moved as asked.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
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
const SCALE_RANGE: std::ops::Range<f64> = 1e-100..1e100;
/// So are transforms whose scales are farther apart than this.
const MOST_CONDITION: f64 = 1e12;

pub(crate) fn check(finite: bool, largest: f64, least: f64) -> Result<(), TransformError> {
    if !finite {
        return Err(TransformError::NotFinite);
    }
    if least == 0.0 || largest == 0.0 {
        return Err(TransformError::Singular);
    }
    if let Some(&scale) = [largest, least].iter().find(|scale| !SCALE_RANGE.contains(scale)) {
        // One axis flat, the others not: that is nearer to what went wrong.
        return Err(if largest > least * MOST_CONDITION && SCALE_RANGE.contains(&largest) {
            TransformError::NearlySingular { least, largest }
        } else {
            TransformError::Scale { scale }
        });
    }
    if largest > least * MOST_CONDITION {
        return Err(TransformError::NearlySingular { least, largest });
    }
    Ok(())
}

/// The power of two at or below a positive number: dividing by it costs no digit.
pub(crate) fn power_of_two(x: f64) -> f64 {
    x.log2().floor().exp2()
}

/// What lengths of this size are multiplied by so that their squares do not vanish: a power of two, which costs no
/// digit. 1 where they do not.
pub(crate) fn lifting(size: f64) -> f64 {
    /// 2^600: the least double above 0 becomes 2e-143.
    const LIFT: f64 = f64::from_bits((1023 + 600) << 52);
    if size > 0.0 && size < 1e-100 { LIFT } else { 1.0 }
}

/// A bound of a length that was lifted, in the units before.
pub(crate) fn lowered(length: f64, lift: f64) -> f64 {
    if lift == 1.0 || length == 0.0 { length } else { (length / lift).next_up() }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use glam::{DQuat, DVec2, DVec3};
    use proptest::prelude::*;

    use super::*;
    use crate::{Affine2, Affine3};

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
