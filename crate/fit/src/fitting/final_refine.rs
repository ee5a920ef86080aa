//! The end of a fit: several ways to finish, judged by what is measured.

use super::judge::Judge;
use super::refine::{Refiner, Ties};
use crate::closed::ClosedCurve;
use crate::outline::Outline;

/// What the curve pays for straying from the outline, one way to finish after the other. Little is best for the
/// outline's distance from the curve, much for the curve's from the outline, and for how rough it is.
const TIE_WEIGHTS: [f64; 4] = [0.0, 0.003, 0.03, 0.1];

/// Those for curves that are not the best found.
const RUNNER_UP_WEIGHTS: [f64; 2] = [0.0, 0.01];

/// What it pays for being beyond the reach, in parts of that.
const BEYOND_SHARE: f64 = 20.0;

/// The most steps of each way.
const MOST_STEPS: usize = 6;

/// Finishes some curves in some ways, and shows them to a judge.
#[derive(Clone, Debug)]
pub(crate) struct Finisher {
    judge: Judge,
    refiner: Refiner,
    reach: f64,
    /// What is still to be done: curves and weights.
    ways: Vec<(Option<ClosedCurve>, f64)>,
    /// The curve that these ways set out from.
    start: Option<ClosedCurve>,
    now: Option<(ClosedCurve, f64, usize)>,
    many: usize,
}

impl Finisher {
    /// Prepares for curves, the best first, which follow an outline. `tolerance` and `levels` are those of
    /// [`Refiner::new`], `reach` is that of [`Ties`].
    pub fn new(
        outline: &Outline,
        judge: Judge,
        curves: &[ClosedCurve],
        tolerance: f64,
        levels: usize,
        reach: f64,
    ) -> Self {
        let mut refiner = Refiner::new(outline.points().to_vec(), tolerance, levels);
        refiner.set_guard(judge.guard().cloned());
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
        let mut finisher = Self { judge, refiner, reach, ways, start: None, now: None, many };
        finisher.begin(None);
        finisher
    }

    /// Who has the best so far.
    pub fn judge(&self) -> &Judge {
        &self.judge
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
        self.judge.show(&curve);
        let more = self.begin(Some(curve));
        if !more {
            self.judge.coarsen();
        }
        more
    }

    /// Begins the next way.
    fn begin(&mut self, before: Option<ClosedCurve>) -> bool {
        let Some((curve, back)) = self.ways.pop() else { return false };
        if let Some(curve) = &curve {
            self.judge.show(curve);
            self.start = Some(curve.clone());
        }
        let Some(mut curve) = curve.or(before) else { return false };
        self.refiner.set_ties(Ties { back, beyond: BEYOND_SHARE * back, far: 0.0, reach: 0.8 * self.reach });
        self.refiner.reset();
        let mut error = self.refiner.error(&curve);
        // Where nothing tied it, a knot that no point of the outline sees may have gone anywhere.
        if let Some(start) = self.start.as_ref().filter(|start| **start != curve) {
            let from_start = self.refiner.error(start);
            if from_start < error {
                (curve, error) = (start.clone(), from_start);
            }
        }
        self.now = Some((curve, error, 0));
        true
    }
}
