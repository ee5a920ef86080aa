//! How near a fit is to its outline.

use glam::DVec2;

use super::{Nearest, Outline, box_slope};

/// How near a closed polyline is to an outline. Lengths are in percent of the diagonal of the outline's box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fidelity {
    /// Root of the mean square distance from the outline's points to the fit.
    pub rms: f64,
    /// The Hausdorff distance: no point of either is farther from the other.
    pub hausdorff: f64,
    /// Length of the fit over that of the outline.
    pub length_ratio: f64,
    /// Box dimension of the outline between 1/64 and 1/256 of the diagonal.
    pub outline_slope: f64,
    /// The same of the fit.
    pub fit_slope: f64,
}

impl Fidelity {
    /// Fit less outline, in box dimension.
    #[must_use]
    pub fn slope_difference(&self) -> f64 {
        self.fit_slope - self.outline_slope
    }
}

/// Measures a closed polyline `fit` (three points or more) against an outline.
#[must_use]
pub fn fidelity(outline: &Outline, fit: &[DVec2]) -> Fidelity {
    Gauge::new(outline).measure(fit)
}

/// Measures polylines against one outline: what hangs on the outline alone is found once.
#[derive(Clone, Debug)]
pub(crate) struct Gauge {
    outline: Outline,
    nearest: Nearest,
    diagonal: f64,
    length: f64,
    slope: f64,
}

impl Gauge {
    pub fn new(outline: &Outline) -> Self {
        Self {
            nearest: Nearest::new(outline.points(), true),
            diagonal: outline.diagonal(),
            length: outline.length(),
            slope: box_slope(outline.points(), outline),
            outline: outline.clone(),
        }
    }

    /// As [`fidelity`] measures.
    pub fn measure(&self, fit: &[DVec2]) -> Fidelity {
        let (rms, farthest) = self.squares_of(fit);
        let (hausdorff, length) = self.reach_of(fit, farthest);
        self.with_slope(fit, rms, hausdorff, length)
    }

    /// The root mean square alone.
    pub fn rms(&self, fit: &[DVec2]) -> f64 {
        self.squares_of(fit).0
    }

    /// As [`measure`](Self::measure), where `keeps` says that it is worth it: by the root mean square alone, and then
    /// by the Hausdorff distance as well. What takes longest comes last.
    pub fn measure_where(&self, fit: &[DVec2], keeps: impl Fn(f64, Option<f64>) -> bool) -> Option<Fidelity> {
        let (rms, farthest) = self.squares_of(fit);
        if !keeps(rms, None) {
            return None;
        }
        let (hausdorff, length) = self.reach_of(fit, farthest);
        keeps(rms, Some(hausdorff)).then(|| self.with_slope(fit, rms, hausdorff, length))
    }

    /// The root mean square, and the square of the largest distance of the outline's points.
    #[inline(never)]
    fn squares_of(&self, fit: &[DVec2]) -> (f64, f64) {
        let to_fit = Nearest::new(fit, true);
        let points = self.outline.points();
        let mut guess = 0;
        let squares = points.iter().map(|&p| {
            let near = to_fit.to_guessed(p, guess);
            guess = near.side;
            near.squared
        });
        let (sum, most) = squares.fold((0.0, 0.0_f64), |(sum, most), x| (sum + x, most.max(x)));
        (100.0 * (sum / points.len() as f64).sqrt() / self.diagonal, most)
    }

    /// The Hausdorff distance, of which one direction is known, and the length of the fit.
    #[inline(never)]
    fn reach_of(&self, fit: &[DVec2], mut farthest: f64) -> (f64, f64) {
        let (mut length, mut guess) = (0.0, 0);
        for (i, &a) in fit.iter().enumerate() {
            let b = fit[(i + 1) % fit.len()];
            let side = a.distance(b);
            length += side;
            // Between the ends, too: the middle of a long side may be the farthest.
            let steps = (side / (2e-3 * self.diagonal)).ceil().clamp(1.0, 1000.0);
            for step in 0..steps as usize {
                let near = self.nearest.to_guessed(a.lerp(b, step as f64 / steps), guess);
                guess = near.side;
                farthest = farthest.max(near.squared);
            }
        }
        (100.0 * farthest.sqrt() / self.diagonal, length)
    }

    fn with_slope(&self, fit: &[DVec2], rms: f64, hausdorff: f64, length: f64) -> Fidelity {
        Fidelity {
            rms,
            hausdorff,
            length_ratio: length / self.length,
            outline_slope: self.slope,
            fit_slope: box_slope(fit, &self.outline),
        }
    }
}
