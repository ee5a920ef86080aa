//! The end of a fit: several ways to finish, judged by what is measured.

use super::{ClosedCurve, Refiner, Ties};
use crate::outline::{Fidelity, Outline, fidelity};

/// What the curve pays for straying from the outline, one way to finish after the other. Little is best for the
/// outline's distance from the curve, much for the curve's from the outline, and for how rough it is.
const TIE_WEIGHTS: [f64; 6] = [0.003, 0.01, 0.03, 0.1, 0.3, 1.0];

/// Those for curves that are not the best found.
const RUNNER_UP_WEIGHTS: [f64; 2] = [0.01, 0.1];

/// The most steps of each way.
const MOST_STEPS: usize = 6;

/// In parts of the diagonal: as fine as links hold curves.
const LINK_PRECISION: f64 = 1.5e-4;

/// Differences of box dimension below this do not count.
const SLOPE_TOLERANCE: f64 = 0.004;

/// What a difference of 1 beyond it counts.
const SLOPE_WEIGHT: f64 = 15.0;

/// The Hausdorff distance may be so many root mean squares.
const MOST_HAUSDORFF: f64 = 4.5;

/// What each further one counts.
const FAR_WEIGHT: f64 = 0.08;

/// How good a fit is, the smaller the better: the root mean square distance, raised by how much the roughness is off
/// and by how far the farthest point is.
pub(crate) fn score(near: &Fidelity) -> f64 {
    let slope = (near.slope_difference().abs() - SLOPE_TOLERANCE).max(0.0);
    let far =
        if near.rms > 0.0 { (near.hausdorff / near.rms - MOST_HAUSDORFF).clamp(0.0, 100.0) } else { 0.0 };
    near.rms * (1.0 + SLOPE_WEIGHT * slope + FAR_WEIGHT * far)
}

/// Finishes some curves in some ways, and keeps the best.
#[derive(Clone, Debug)]
pub(crate) struct Finisher {
    outline: Outline,
    refiner: Refiner,
    reach: f64,
    /// What is still to be done: curves and weights.
    ways: Vec<(Option<ClosedCurve>, f64)>,
    now: Option<(ClosedCurve, f64, usize)>,
    many: usize,
    best: Option<(ClosedCurve, f64, f64)>,
}

impl Finisher {
    /// Prepares for curves, the best first. `tolerance` and `levels` are those of [`Refiner::new`], `reach` is that of
    /// [`Ties`].
    pub fn new(outline: Outline, curves: &[ClosedCurve], tolerance: f64, levels: usize, reach: f64) -> Self {
        let refiner = Refiner::new(outline.points().to_vec(), tolerance, levels);
        let mut ways = Vec::new();
        for (i, curve) in curves.iter().enumerate() {
            let weights: &[f64] = if i == 0 { &TIE_WEIGHTS } else { &RUNNER_UP_WEIGHTS };
            // Each way begins where the one before it ended.
            ways.extend(
                weights.iter().enumerate().map(|(k, &weight)| ((k == 0).then(|| curve.clone()), weight)),
            );
        }
        ways.reverse();
        let many = ways.len();
        let mut finisher = Self { outline, refiner, reach, ways, now: None, many, best: None };
        if let Some(curve) = curves.first() {
            finisher.judge(curve);
        }
        finisher
    }

    /// The best so far, and the sum of squared distances from the outline's points.
    pub fn best(&self) -> Option<(&ClosedCurve, f64)> {
        self.best.as_ref().map(|(curve, _, error)| (curve, *error))
    }

    /// How many points are followed.
    pub fn points(&self) -> usize {
        self.refiner.points().len()
    }

    /// From 0 to 1.
    pub fn share(&self) -> f64 {
        1.0 - self.ways.len() as f64 / self.many.max(1) as f64
    }

    /// One step; false where there is nothing more to do.
    pub fn step(&mut self) -> bool {
        let Some((mut curve, error, steps)) = self.now.take() else { return false };
        let (next, moved) = self.refiner.step(&mut curve, error);
        if moved && next < error * (1.0 - 1e-4) && steps + 1 < MOST_STEPS {
            self.now = Some((curve, next, steps + 1));
            return true;
        }
        self.judge(&curve);
        self.begin(Some(curve))
    }

    /// Begins the next way.
    pub fn begin(&mut self, before: Option<ClosedCurve>) -> bool {
        let Some((curve, weight)) = self.ways.pop() else { return false };
        let Some(curve) = curve.or(before) else { return false };
        self.refiner.set_ties(Ties { back: weight, beyond: 2.0, far: 4.0, reach: 0.8 * self.reach });
        self.refiner.reset();
        let error = self.refiner.error(&curve);
        self.now = Some((curve, error, 0));
        true
    }

    /// Measures a curve as a link brings it back, and as it is; the better counts only if both are good.
    fn judge(&mut self, curve: &ClosedCurve) {
        if !curve.is_sound() {
            return;
        }
        let diagonal = self.outline.diagonal();
        let measure = |curve: &ClosedCurve| fidelity(&self.outline, &curve.polyline(2e-4 * diagonal, 12));
        let packed =
            curve.to_bytes(LINK_PRECISION * diagonal).and_then(|bytes| ClosedCurve::from_bytes(&bytes));
        let near = measure(curve);
        let both = packed.map_or(f64::INFINITY, |packed| score(&measure(&packed)));
        let total = 0.5 * (score(&near) + both);
        if self.best.as_ref().is_none_or(|best| total < best.1) {
            let error = (near.rms / 100.0 * diagonal).powi(2) * self.outline.points().len() as f64;
            self.best = Some((curve.clone(), total, error));
        }
    }
}
