//! Iterated function systems of space.

use crate::error::IfsError;
use crate::ifs::contraction3::Contraction3;
use crate::linear::affine3::Affine3;
use crate::linear::transform::TransformError;

/// An iterated function system (IFS) of space: 1 to 64 affine maps that have an attractor together, and the probability
/// of each in the chaos game. See [`Ifs`](crate::Ifs), of which it is the twin.
#[derive(Clone, Debug, PartialEq)]
pub struct Ifs3 {
    maps: Vec<Affine3>,
    probabilities: Vec<f64>,
    contraction: Contraction3,
}

impl Ifs3 {
    /// An IFS of these maps, each as probable as its determinant is large.
    ///
    /// # Errors
    /// Those of [`Contraction3::find`].
    pub fn new(maps: Vec<Affine3>) -> Result<Self, IfsError> {
        let contraction = Contraction3::find(&maps)?;
        let probabilities = by_volume(&maps);
        Ok(Self { maps, probabilities, contraction })
    }

    /// The same maps with given probabilities, which are scaled to the sum 1.
    ///
    /// # Errors
    /// [`IfsError::Probabilities`] if they are not one for each map, or one is negative or not finite,
    /// or all are zero.
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
    pub fn maps(&self) -> &[Affine3] {
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
    pub fn contraction(&self) -> &Contraction3 {
        &self.contraction
    }

    /// The same shape elsewhere: every map conjugated, so that the attractor is the image of this one under `by`
    /// (Darwish & Abd-El-Wahab, eq 1). The probabilities stay.
    ///
    /// # Errors
    /// [`TransformError`] where `by` is singular, nearly so, not finite or out of range, or the new numbers are too large.
    pub fn conjugate(&self, by: Affine3) -> Result<Self, TransformError> {
        let back = by.undo()?;
        let maps = self.maps.iter().map(|&map| by * map * back).collect();
        let mut ifs = Self::new(maps)?;
        ifs.probabilities.clone_from(&self.probabilities);
        Ok(ifs)
    }
}

/// Probabilities in proportion to how large the pieces are, so that points fall evenly; a small piece still gets a
/// little, or it would never show.
///
/// Pieces are measured by the volume of their maps, or, where all are flat, by the area or the length.
fn by_volume(maps: &[Affine3]) -> Vec<f64> {
    let values: Vec<[f64; 3]> = maps.iter().map(|map| map.singular_values()).collect();
    let largest = values.iter().map(|v| v[0]).fold(0.0, f64::max);
    let measure = |dimensions: usize| -> Vec<f64> {
        values.iter().map(|v| v[..dimensions].iter().map(|s| s / largest).product()).collect()
    };
    // Rounding makes a flat map seem a little thick.
    let weights = if largest > 0.0 {
        [3, 2, 1].map(measure).into_iter().find(|w| w.iter().sum::<f64>() > 1e-12)
    } else {
        None
    };
    let weights = weights.unwrap_or_else(|| vec![1.0; maps.len()]);
    let floor = 0.01 * weights.iter().sum::<f64>();
    let weights: Vec<f64> = weights.into_iter().map(|w| w.max(floor)).collect();
    let total: f64 = weights.iter().sum();
    weights.into_iter().map(|w| w / total).collect()
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::*;

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
    fn given_probabilities_are_scaled_or_refused() {
        let ifs = Ifs3::new(vec![half(DVec3::X), half(DVec3::Y)]).unwrap();
        assert_eq!(ifs.clone().with_probabilities(&[1.0, 3.0]).unwrap().probabilities(), [0.25, 0.75]);
        for bad in [&[1.0][..], &[0.0, 0.0], &[-1.0, 2.0], &[f64::NAN, 1.0], &[f64::INFINITY, 1.0]] {
            assert_eq!(ifs.clone().with_probabilities(bad), Err(IfsError::Probabilities { maps: 2 }));
        }
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
