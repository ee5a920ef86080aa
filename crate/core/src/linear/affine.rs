//! Affine maps of the plane and of space.

use std::ops::Mul;

use crate::dimension::{Dim2, Dim3, Dimension};
use crate::linear::transform::{TransformError, check, power_of_two};

/// An affine map, `x -> linear * x + translation`, of the plane ([`Affine2`]) or of space ([`Affine3`]).
///
/// Written as a row it has the rows of its matrix, then its translation; for the plane that is the order of Fractint
/// files, `[a, b, c, d, e, f]`:
///
/// ```text
/// x' = a x + b y + e        linear = | a b |    translation = | e |
/// y' = c x + d y + f                 | c d |                  | f |
/// ```
///
/// ```
/// use frond_core::Affine2;
/// use glam::DVec2;
///
/// let half = Affine2::similitude(0.5, 0.0, DVec2::X);
/// assert_eq!(half.apply(DVec2::new(2.0, 4.0)), DVec2::new(2.0, 2.0));
/// // Composed, the right-hand map comes first.
/// assert_eq!((half * half).translation, DVec2::new(1.5, 0.0));
/// assert_eq!(half.fixed_point(), Some(DVec2::new(2.0, 0.0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine<D: Dimension> {
    /// The linear part.
    pub linear: D::Matrix,
    /// The translation.
    pub translation: D::Vector,
}

/// An affine map of the plane: a row of six numbers.
pub type Affine2 = Affine<Dim2>;

/// An affine map of space: a row of twelve numbers.
pub type Affine3 = Affine<Dim3>;

impl<D: Dimension> Affine<D> {
    /// The map that leaves every point where it is.
    pub const IDENTITY: Self = Self { linear: D::IDENTITY, translation: D::ZERO };

    /// A map from its linear part and its translation.
    #[inline]
    #[must_use]
    pub const fn new(linear: D::Matrix, translation: D::Vector) -> Self {
        Self { linear, translation }
    }

    /// Moves by `shift`.
    #[must_use]
    pub const fn moving(shift: D::Vector) -> Self {
        Self::new(D::IDENTITY, shift)
    }

    /// The rows of the matrix, then the translation.
    #[must_use]
    pub fn to_row(self) -> D::Row {
        D::row(self.linear, self.translation)
    }

    /// The image of a point.
    #[inline]
    #[must_use]
    pub fn apply(self, point: D::Vector) -> D::Vector {
        self.linear * point + self.translation
    }

    /// The factor by which the map changes areas or volumes, negative if it reflects.
    #[must_use]
    pub fn determinant(self) -> f64 {
        D::determinant(self.linear)
    }

    /// The operator norm of the linear part: the largest factor by which a distance grows.
    #[inline]
    #[must_use]
    pub fn norm(self) -> f64 {
        D::norm(self.linear)
    }

    /// The largest absolute value of an eigenvalue of the linear part.
    #[must_use]
    pub fn spectral_radius(self) -> f64 {
        D::spectral_radius(self.linear)
    }

    /// Whether the map scales all distances by one factor, to a relative `tolerance`.
    #[must_use]
    pub fn is_similitude(self, tolerance: f64) -> bool {
        let values = D::singular_values(self.linear);
        let (large, small) = (values.as_ref()[0], values.as_ref()[D::COORDINATES - 1]);
        large - small <= tolerance * large
    }

    /// Whether all numbers are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.to_row().as_ref().iter().all(|x| x.is_finite())
    }

    /// The inverse map, or `None` when the linear part is singular or so nearly that nothing is left of it in floating
    /// point.
    #[must_use]
    pub fn inverse(self) -> Option<Self> {
        let inverse = D::inverse(self.linear);
        let map = Self { linear: inverse, translation: -(inverse * self.translation) };
        (self.determinant() != 0.0 && map.is_finite()).then_some(map)
    }

    /// The point that the map leaves where it is, or `None` when there is no such point or more than one (an eigenvalue
    /// of 1).
    #[must_use]
    pub fn fixed_point(self) -> Option<D::Vector> {
        let m = D::IDENTITY - self.linear;
        let point = D::inverse(m) * self.translation;
        (D::determinant(m) != 0.0 && Self::moving(point).is_finite()).then_some(point)
    }

    /// The same transform about another point than the origin, which stays where it is if the transform left the
    /// origin.
    #[must_use]
    pub fn about(self, point: D::Vector) -> Self {
        Self::moving(point) * self * Self::moving(-point)
    }

    /// The same map seen in other coordinates: `by * self * by^-1`, whose attractor is the image under `by` of the
    /// former one (Darwish & Abd-El-Wahab, eq 1). `None` when `by` is singular.
    #[must_use]
    pub fn conjugate(self, by: Self) -> Option<Self> {
        by.inverse().map(|inverse| by * self * inverse)
    }

    /// The inverse of a transform that shapes may be moved by.
    ///
    /// # Errors
    /// [`TransformError`] where the transform is singular, nearly so, not finite or out of range.
    pub fn undo(self) -> Result<Self, TransformError> {
        let (largest, least) = D::extreme_scales(self.linear);
        check(self.is_finite(), largest, least)?;
        // In units of the largest scale, so that the determinant neither vanishes nor overflows.
        let unit = power_of_two(largest);
        let inverse = D::inverse(self.linear * (1.0 / unit)) * (1.0 / unit);
        Ok(Self::new(inverse, -(inverse * self.translation)))
    }

    /// [`Affine::conjugate`] by a transform that shapes may be moved by.
    ///
    /// # Errors
    /// As [`Affine::undo`] of `by`.
    pub fn moved(self, by: Self) -> Result<Self, TransformError> {
        Ok(by * self * by.undo()?)
    }
}

/// Composition: `(a * b).apply(x)` is `a.apply(b.apply(x))`.
impl<D: Dimension> Mul for Affine<D> {
    type Output = Self;

    #[inline]
    fn mul(self, inner: Self) -> Self {
        Self { linear: self.linear * inner.linear, translation: self.apply(inner.translation) }
    }
}
