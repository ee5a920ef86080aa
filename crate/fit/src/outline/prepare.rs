//! What is done to an outline before it is fitted.

use glam::DVec2;

use super::{Outline, OutlineError};

/// Outlines of more points are thinned to so many: finer is not seen, and takes long.
pub const MAX_PREPARED: usize = 16_384;

/// How wide smoothing 1 is, in parts of the diagonal.
const WIDEST_SMOOTHING: f64 = 0.02;

impl Outline {
    /// The outline that is fitted: thinned where it is finer than can be seen, and smoothed by 0 to 1.
    ///
    /// # Errors
    /// As [`Outline::new`].
    pub fn prepared(points: &[DVec2], smoothing: f64) -> Result<Self, OutlineError> {
        let mut outline = Self::new(points)?;
        if outline.points().len() > MAX_PREPARED {
            outline = Self::new(outline.resampled(MAX_PREPARED).points())?;
        }
        if smoothing > 0.0 {
            // Squared, since little is what is mostly wanted.
            let width = WIDEST_SMOOTHING * smoothing.min(1.0).powi(2) * outline.diagonal();
            outline = Self::new(outline.smoothed(width).points())?;
        }
        Ok(outline)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grown::{maple_leaf, noisy};

    #[test]
    fn a_million_points_are_thinned_and_nothing_else_is() {
        let circle = |count: usize| -> Vec<DVec2> {
            (0..count).map(|i| DVec2::from_angle(std::f64::consts::TAU * i as f64 / count as f64)).collect()
        };
        assert_eq!(Outline::prepared(&circle(1_000_000), 0.0).unwrap().points().len(), MAX_PREPARED);
        assert_eq!(Outline::prepared(&circle(500), 0.0).unwrap().points(), &circle(500)[..]);
        assert!(Outline::prepared(&circle(2), 0.0).is_err());
        for smoothing in [0.3, 1.0, 1e300, f64::NAN] {
            let outline = Outline::prepared(&circle(500), smoothing).unwrap();
            assert!(outline.points().iter().all(|p| p.is_finite() && p.length() > 0.9), "{smoothing}");
        }
    }

    #[test]
    fn smoothing_takes_noise_away() {
        let leaf = maple_leaf(1);
        let rough = Outline::prepared(&noisy(&leaf, 1), 0.0).unwrap();
        let smooth = Outline::prepared(&noisy(&leaf, 1), 0.5).unwrap();
        assert!(rough.length() > 1.5 * Outline::new(&leaf).unwrap().length());
        assert!(smooth.length() < 0.7 * rough.length());
    }
}
