//! The best polyline: what a fit begins with, and what it has to beat.

use glam::DVec2;

use super::marks::scattered;
use super::partition::partition;
use super::refine::{Refiner, Ties};
use crate::closed::ClosedCurve;
use crate::outline::{Guard, Outline, decimated, features, thinned};

/// The most steps of least squares from each beginning.
const MOST_STEPS: usize = 40;

/// So few corners are also put on the outline by chance, so many times: which polyline they come to depends on where
/// they begin.
const FEW_CORNERS: usize = 12;
const SCATTERED: u32 = 8;

/// A step that gains less than this share is the last.
const LEAST_GAIN: f64 = 1e-5;

/// So many points of the outline are enough to be followed, and so many more for each corner.
const FOLLOWED: (usize, usize) = (1000, 20);

/// A root mean square that no document keeps, in parts of the diagonal.
const EXACT: f64 = 1e-6;

/// The distance of the outline's points from the curve counts: that is what is measured. Beyond a reach, in parts of
/// the diagonal, the curve's own counts, too: else a corner that no point of the outline sees may go anywhere.
const TIES: Ties = Ties { back: 0.0, beyond: 1.0, far: 0.0, reach: 0.0 };
const REACH: f64 = 0.25;

/// How corners are chosen.
#[derive(Clone, Copy, Debug)]
enum Beginning {
    Partition,
    Features,
    Scattered(u32),
}

/// Looks for the polyline of so many corners that is nearest to the points of an outline, step by step.
///
/// It sets out from corners chosen in three ways, few also by chance, and moves them by least squares, at first of some
/// points, at last of all. It never crosses itself where the outline does not: the first beginning does not, and no
/// step is made that would.
#[derive(Clone, Debug)]
pub(crate) struct Straight {
    outline: Outline,
    corners: usize,
    guard: Option<Guard>,
    refiner: Refiner,
    /// That of all points, until it is its turn.
    whole: Option<Refiner>,
    /// The squares of the points that are followed are to be multiplied by it.
    scale: f64,
    /// A sum of squares at which there is nothing left to do.
    exact: f64,
    /// The last is the next.
    beginnings: Vec<Beginning>,
    now: Option<(ClosedCurve, f64, usize)>,
    best: ClosedCurve,
    error: f64,
    many: usize,
}

impl Straight {
    /// Prepares for so many corners, 3 at least. From the start on there is a polyline.
    pub fn new(outline: &Outline, corners: usize, guard: Option<Guard>) -> Self {
        let corners = corners.clamp(3, outline.points().len().max(3));
        let refiner_of = |points: Vec<DVec2>| {
            let mut refiner = Refiner::new(points, 0.0, 1);
            refiner.set_ties(Ties { reach: REACH * outline.diagonal(), ..TIES });
            refiner
        };
        let all = outline.points();
        let some = thinned(all, enough_points(corners));
        let scale = all.len() as f64 / some.len() as f64;
        let mut whole = (some.len() < all.len()).then(|| refiner_of(all.to_vec()));
        let exact = (EXACT * outline.diagonal()).powi(2) * some.len() as f64;
        let mut refiner = refiner_of(some);
        let first = of_marks(outline, &decimated(outline, corners));
        let mut guard = guard;
        if guard.as_ref().is_some_and(|guard| !guard.passes(&first.knots)) {
            // The outline meets itself, and so few corners can't follow it there.
            guard = None;
        }
        refiner.set_guard(guard.clone());
        if let Some(whole) = &mut whole {
            whole.set_guard(guard.clone());
        }
        let error = refiner.error(&first);
        let scattered = if corners <= FEW_CORNERS { SCATTERED } else { 0 };
        let mut beginnings: Vec<_> = (0..scattered).map(Beginning::Scattered).collect();
        beginnings.extend([Beginning::Partition, Beginning::Features]);
        let many = beginnings.len() + 1 + usize::from(whole.is_some());
        let now = Some((first.clone(), error, 0));
        Self {
            outline: outline.clone(),
            corners,
            guard,
            refiner,
            whole,
            scale,
            exact,
            beginnings,
            now,
            best: first,
            error,
            many,
        }
    }

    /// What holds for all that is found.
    pub fn guard(&self) -> Option<&Guard> {
        self.guard.as_ref()
    }

    /// The best so far, and its sum of squares, about.
    pub fn best(&self) -> (&ClosedCurve, f64) {
        (&self.best, self.scale * self.error)
    }

    /// How far it is: 0 to 1.
    pub fn share(&self) -> f64 {
        let steps = self.now.as_ref().map_or(0, |now| now.2);
        let left =
            self.beginnings.len() + usize::from(self.whole.is_some()) + usize::from(self.now.is_some());
        1.0 - (left as f64 - steps as f64 / MOST_STEPS as f64) / self.many as f64
    }

    /// One step; false where there is nothing more to do.
    #[inline(never)]
    pub fn step(&mut self) -> bool {
        let Some((mut curve, error, steps)) = self.now.take() else {
            let Some(beginning) = self.beginnings.pop() else { return self.follow_all() };
            let marks = match beginning {
                Beginning::Partition => partition(&self.outline, self.corners),
                Beginning::Features => features(&self.outline, self.corners),
                Beginning::Scattered(seed) => scattered(self.outline.points().len(), self.corners, seed),
            };
            if marks.len() >= 3 {
                let curve = of_marks(&self.outline, &marks);
                self.refiner.reset();
                let error = self.refiner.error(&curve);
                if error.is_finite() {
                    self.now = Some((curve, error, 0));
                }
            }
            return true;
        };
        let (next, moved) = self.refiner.step(&mut curve, error);
        if next < self.error {
            (self.best, self.error) = (curve.clone(), next);
        }
        if self.error <= self.exact {
            self.beginnings.clear();
            return true;
        }
        if moved && next < error * (1.0 - LEAST_GAIN) && steps + 1 < MOST_STEPS {
            self.now = Some((curve, next, steps + 1));
        }
        true
    }

    /// From now on all points are followed; false where they are already.
    fn follow_all(&mut self) -> bool {
        let Some(whole) = self.whole.take() else { return false };
        self.refiner = whole;
        self.exact *= self.scale;
        self.scale = 1.0;
        self.error = self.refiner.error(&self.best);
        self.now = Some((self.best.clone(), self.error, 0));
        true
    }

    /// The best of all, as documents keep it.
    pub fn finish(mut self) -> ClosedCurve {
        while self.step() {}
        self.kept()
    }

    /// The best so far as documents keep it, where that keeps it from crossing itself.
    pub fn kept(&self) -> ClosedCurve {
        let fine = |curve: &ClosedCurve| self.guard.as_ref().is_none_or(|guard| guard.passes(&curve.knots));
        self.best.quantised().ok().filter(fine).unwrap_or_else(|| self.best.clone())
    }
}

/// How many points of an outline are enough to be followed by so many corners, or pairs of numbers.
pub(crate) fn enough_points(corners: usize) -> usize {
    FOLLOWED.0 + FOLLOWED.1 * corners
}

fn of_marks(outline: &Outline, marks: &[usize]) -> ClosedCurve {
    ClosedCurve::polygon(marks.iter().map(|&i| outline.points()[i]).collect::<Vec<DVec2>>())
}
