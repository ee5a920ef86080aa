//! Iterated function systems.

use crate::dimension::{Dim2, Dim3, Dimension};
use crate::error::IfsError;
use crate::ifs::contraction::Contraction;
use crate::linear::affine::Affine;
use crate::linear::transform::TransformError;

/// An iterated function system (IFS): 1 to 64 affine maps that have an attractor together, and the probability of each
/// in the chaos game. `Ifs` alone is one of the plane, [`Ifs3`] one of space.
///
/// The attractor is the one compact set `A` with `A = w_1(A) u .. u w_N(A)` (Hutchinson 1981; Burch &
/// Hart 1997, eq 1). It exists exactly if the maps contract in some word length, which
/// [`Ifs::new`] checks; each map alone may stretch.
///
/// ```
/// use frond_core::{Affine2, Ifs, similarity_dimension};
/// use glam::DVec2;
///
/// let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.5, 0.75_f64.sqrt())];
/// let gasket = Ifs::new(corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5)).to_vec())?;
/// assert!((similarity_dimension(&gasket).unwrap_or(0.0) - 3.0_f64.log2()).abs() < 1e-12);
/// // A map that stretches on and on has no attractor, and the error says what to do.
/// let error = Ifs::new(vec![Affine2::similitude(1.5, 0.0, DVec2::ZERO)]).unwrap_err();
/// assert_eq!(error.code(), "no-attractor");
/// # Ok::<(), frond_core::IfsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Ifs<D: Dimension = Dim2> {
    maps: Vec<Affine<D>>,
    probabilities: Vec<f64>,
    contraction: Contraction<D>,
}

/// An iterated function system of space.
pub type Ifs3 = Ifs<Dim3>;

impl<D: Dimension> Ifs<D> {
    /// An IFS of these maps, each as probable as its determinant is large.
    ///
    /// # Errors
    /// Those of [`Contraction::find`].
    // Generic code is compiled in each crate that calls it: once there, not at every call.
    #[inline(never)]
    pub fn new(maps: Vec<Affine<D>>) -> Result<Self, IfsError> {
        let contraction = Contraction::find(&maps)?;
        let linear: Vec<D::Matrix> = maps.iter().map(|map| map.linear).collect();
        let probabilities = D::probabilities(&linear);
        Ok(Self { maps, probabilities, contraction })
    }

    /// The same maps with given probabilities, which are scaled to the sum 1.
    ///
    /// # Errors
    /// [`IfsError::Probabilities`] if they are not one for each map, or one is negative or not finite,
    /// or all are zero.
    #[inline(never)]
    pub fn with_probabilities(mut self, probabilities: &[f64]) -> Result<Self, IfsError> {
        let sum: f64 = probabilities.iter().sum();
        let fits = probabilities.len() == self.len()
            && probabilities.iter().all(|p| *p >= 0.0)
            && sum > 0.0
            && sum.is_finite();
        if !fits {
            return Err(IfsError::Probabilities { maps: self.len() });
        }
        self.probabilities = probabilities.iter().map(|p| p / sum).collect();
        Ok(self)
    }

    /// The maps.
    #[must_use]
    pub fn maps(&self) -> &[Affine<D>] {
        &self.maps
    }

    /// The number of maps, 1 to 64.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "an IFS is never empty")]
    pub fn len(&self) -> usize {
        self.maps.len()
    }

    /// One probability a map; their sum is 1.
    #[must_use]
    pub fn probabilities(&self) -> &[f64] {
        &self.probabilities
    }

    /// Coordinates in which the maps contract.
    #[must_use]
    pub fn contraction(&self) -> &Contraction<D> {
        &self.contraction
    }

    /// The same shape elsewhere: every map conjugated, so that the attractor is the image of this one under `by`
    /// (Darwish & Abd-El-Wahab, eq 1). The probabilities stay.
    ///
    /// # Errors
    /// [`TransformError`] where `by` is singular, nearly so, not finite or out of range, or the new numbers are too
    /// large.
    #[inline(never)]
    pub fn conjugate(&self, by: Affine<D>) -> Result<Self, TransformError> {
        let back = by.undo()?;
        let maps = self.maps.iter().map(|&map| by * map * back).collect();
        let mut ifs = Self::new(maps)?;
        ifs.probabilities.clone_from(&self.probabilities);
        Ok(ifs)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec2, DVec3};

    use super::*;
    use crate::{Affine2, Affine3};

    #[test]
    fn probabilities_follow_the_determinants_but_none_is_zero() {
        let fern = [
            [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
            [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
            [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
            [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
        ]
        .map(Affine2::from_row);
        let ifs = Ifs::new(fern.to_vec()).unwrap();
        let p = ifs.probabilities();
        assert!((p.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        assert!(p[0] > 0.009 && p[1] > 0.7);
    }

    #[test]
    fn given_probabilities_are_scaled_or_refused() {
        let ifs = Ifs::new(vec![Affine2::similitude(0.5, 0.0, DVec2::X); 2]).unwrap();
        assert_eq!(ifs.clone().with_probabilities(&[1.0, 3.0]).unwrap().probabilities(), [0.25, 0.75]);
        for bad in [&[1.0][..], &[0.0, 0.0], &[-1.0, 2.0], &[f64::NAN, 1.0], &[f64::INFINITY, 1.0]] {
            assert_eq!(ifs.clone().with_probabilities(bad), Err(IfsError::Probabilities { maps: 2 }));
        }
    }

    fn half(at: DVec3) -> Affine3 {
        Affine3::similitude(0.5, DQuat::IDENTITY, at)
    }

    #[test]
    fn probabilities_follow_what_is_largest() {
        let solid = Ifs3::new(vec![half(DVec3::ZERO), Affine3::scaling(DVec3::new(0.8, 0.8, 0.0))]).unwrap();
        assert!(solid.probabilities()[0] > 0.98 && solid.probabilities()[1] > 0.009);
        let sheets = [0.5, 0.25].map(|s| {
            Affine3::similitude(s, DQuat::IDENTITY, DVec3::X) * Affine3::scaling(DVec3::new(1.0, 1.0, 0.0))
        });
        let flat = Ifs3::new(sheets.to_vec()).unwrap();
        assert!((flat.probabilities()[0] - 0.8).abs() < 1e-12, "{:?}", flat.probabilities());
        let points = Ifs3::new(vec![Affine3::scaling(DVec3::ZERO); 4]).unwrap();
        assert_eq!(points.probabilities(), [0.25; 4]);
    }

    #[test]
    fn a_moved_shape_keeps_its_probabilities_and_a_flattened_one_is_refused() {
        let ifs =
            Ifs3::new(vec![half(DVec3::X), half(DVec3::Y)]).unwrap().with_probabilities(&[0.1, 0.9]).unwrap();
        let moved = ifs.conjugate(Affine3::moving(DVec3::new(15.0, 0.0, 0.0))).unwrap();
        assert_eq!(moved.probabilities(), [0.1, 0.9]);
        assert_eq!(moved.maps()[0].translation, DVec3::new(8.5, 0.0, 0.0));
        let code = |by: Affine3| ifs.conjugate(by).unwrap_err().code();
        assert_eq!(code(Affine3::scaling(DVec3::new(1.0, 1.0, 0.0))), "transform-singular");
        assert_eq!(code(Affine3::scaling(DVec3::splat(1e-300))), "transform-scale");
        assert_eq!(code(Affine3::moving(DVec3::splat(1e101))), "not-finite");
    }
}
