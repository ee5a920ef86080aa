//! Iterated function systems.

use crate::error::IfsError;
use crate::ifs::contraction2::Contraction;
use crate::linear::affine2::Affine2;

/// An iterated function system (IFS) of the plane: 1 to 64 affine maps that have an attractor together,
/// and the probability of each in the chaos game.
///
/// The attractor is the one compact set `A` with `A = w_1(A) u .. u w_N(A)` (Hutchinson 1981; Burch &
/// Hart 1997, eq 1). It exists exactly if the maps contract in some word length, which
/// [`Ifs::new`] checks; each map alone may stretch.
#[derive(Clone, Debug, PartialEq)]
pub struct Ifs {
    maps: Vec<Affine2>,
    probabilities: Vec<f64>,
    contraction: Contraction,
}

impl Ifs {
    /// An IFS of these maps, each as probable as its determinant is large.
    ///
    /// # Errors
    /// Those of [`Contraction::find`].
    pub fn new(maps: Vec<Affine2>) -> Result<Self, IfsError> {
        let contraction = Contraction::find(&maps)?;
        let probabilities = by_determinant(&maps);
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
    pub fn maps(&self) -> &[Affine2] {
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
    pub fn contraction(&self) -> &Contraction {
        &self.contraction
    }

    /// The same shape elsewhere: every map conjugated, so that the attractor is the image of this one
    /// under `by` (Darwish & Abd-El-Wahab, eq 1). `None` if `by` is singular or the numbers overflow.
    #[must_use]
    pub fn conjugate(&self, by: Affine2) -> Option<Self> {
        let maps: Option<Vec<_>> = self.maps.iter().map(|map| map.conjugate(by)).collect();
        let mut ifs = Self::new(maps?).ok()?;
        ifs.probabilities.clone_from(&self.probabilities);
        Some(ifs)
    }
}

/// Probabilities in proportion to |det|, so that points fall evenly; a map that is nearly singular
/// still gets a little, or its piece would never show.
fn by_determinant(maps: &[Affine2]) -> Vec<f64> {
    let areas: Vec<f64> = maps.iter().map(|map| map.determinant().abs()).collect();
    let total: f64 = areas.iter().sum();
    // Where all maps are singular, their lengths take the place of areas.
    let weights: Vec<f64> = if total > 0.0 { areas } else { maps.iter().map(|map| map.norm()).collect() };
    let total: f64 = weights.iter().sum();
    let floor = if total > 0.0 { 0.01 * total } else { 1.0 };
    let weights: Vec<f64> = weights.into_iter().map(|w| w.max(floor)).collect();
    let total: f64 = weights.iter().sum();
    weights.into_iter().map(|w| w / total).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let ifs = Ifs::new(vec![Affine2::similitude(0.5, 0.0, glam::DVec2::X); 2]).unwrap();
        assert_eq!(ifs.clone().with_probabilities(&[1.0, 3.0]).unwrap().probabilities(), [0.25, 0.75]);
        for bad in [&[1.0][..], &[0.0, 0.0], &[-1.0, 2.0], &[f64::NAN, 1.0], &[f64::INFINITY, 1.0]] {
            assert_eq!(ifs.clone().with_probabilities(bad), Err(IfsError::Probabilities { maps: 2 }));
        }
    }
}
