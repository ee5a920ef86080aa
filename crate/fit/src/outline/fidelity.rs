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
    let diagonal = outline.diagonal();
    let to_fit = Nearest::new(fit, true);
    let squares = outline.points().iter().map(|&p| to_fit.to(p).squared);
    let (sum, mut farthest) = squares.fold((0.0, 0.0_f64), |(sum, most), x| (sum + x, most.max(x)));
    let to_outline = Nearest::new(outline.points(), true);
    let mut length = 0.0;
    for (i, &a) in fit.iter().enumerate() {
        let b = fit[(i + 1) % fit.len()];
        let side = a.distance(b);
        length += side;
        // Between the ends, too: the middle of a long side may be the farthest.
        let steps = (side / (2e-3 * diagonal)).ceil().clamp(1.0, 1000.0);
        for step in 0..steps as usize {
            farthest = farthest.max(to_outline.to(a.lerp(b, step as f64 / steps)).squared);
        }
    }
    Fidelity {
        rms: 100.0 * (sum / outline.points().len() as f64).sqrt() / diagonal,
        hausdorff: 100.0 * farthest.sqrt() / diagonal,
        length_ratio: length / outline.length(),
        outline_slope: box_slope(outline.points(), outline),
        fit_slope: box_slope(fit, outline),
    }
}
