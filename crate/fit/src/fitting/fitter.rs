//! Fitting an outline step by step, with the best so far always at hand.

use super::final_refine::Finisher;
use super::fit_error::FitError;
use super::judge::{Judge, Judged, is_exact};
use super::progress::{ClosedFit, Progress, Stage};
use super::search::{FEW_PAIRS, FITTING_LEVELS, Search};
use super::straight::{Straight, enough_points};
use crate::closed::ClosedCurve;
use crate::outline::{self, Guard, MAX_PREPARED, Nearest, Outline, corners};

/// The least and the most numbers a fit may have.
const NUMBER_RANGE: (usize, usize) = (12, 2000);

/// The most points of the outline that are followed.
const MAX_FOLLOWED: usize = 2400;

/// While searching for few numbers, each pair of them has so many points to follow: it cannot tell more from these, and
/// the ends follow all.
const POINTS_A_PAIR: usize = 12;

/// With more, up to so many pairs, each has so many, and as many rounds as on all points take a part of the time. Some
/// more of them make up for what fewer points tell.
const SOME_PAIRS: usize = 40;
const POINTS_A_PAIR_OF_SOME: usize = 16;
const MORE_ROUNDS: f64 = 1.8;

/// Edges of copies shorter than this are not opened while fitting, in parts of the diagonal; on the points of some
/// pairs, which lie farther apart, those shorter than the second.
const FITTING_TOLERANCE: f64 = 1.5e-3;
const COARSE_TOLERANCE: f64 = 2.5e-3;

/// Rounds between two looks of the judge, which measures what is drawn, at least.
const ROUNDS_UNSEEN: usize = 16;

/// What has been searched between two looks, in times of what looks take, where numbers are few. With more, what is
/// measured often is nearer in the end.
const SEARCH_A_LOOK: u64 = 6;

/// Fits a self-affine closed curve to an outline, one short step after the other.
///
/// An outline of no more corners than the numbers allow is its own fit, at once. Otherwise it begins with the best
/// polyline of as many numbers, and what it has in the end is no farther from the outline than
/// that (root mean square, of the curve as it is drawn). Where the outline does not meet itself, the drawn curve does
/// not either. Every step takes some milliseconds to some hundred; between steps the work may be dropped at any time.
#[derive(Clone, Debug)]
pub struct Fitter {
    outline: Outline,
    diagonal: f64,
    /// None where the outline itself is no more than that.
    straight: Option<Straight>,
    search: Option<Search>,
    /// The points that the ends follow; a search for not many numbers follows fewer.
    followed: Outline,
    judge: Option<Judge>,
    /// What there must have been searched before the judge looks again.
    next_look: u64,
    finisher: Option<Finisher>,
    best: ClosedFit,
    stage: Stage,
    share: f64,
}

impl Fitter {
    /// Begins a fit of at most `numbers` numbers: 2 a knot, 2 a copied edge.
    ///
    /// # Errors
    /// Where the numbers are not between 12 and 2000.
    pub fn new(outline: &Outline, numbers: usize) -> Result<Self, FitError> {
        if numbers < NUMBER_RANGE.0 || numbers > NUMBER_RANGE.1 {
            return Err(FitError::BadNumbers { numbers });
        }
        let pairs = numbers / 2;
        if let Some(best) = exact(outline, pairs) {
            return Ok(Self {
                outline: outline.clone(),
                diagonal: outline.diagonal(),
                straight: None,
                search: None,
                followed: outline.clone(),
                judge: None,
                next_look: 0,
                finisher: None,
                best,
                stage: Stage::Done,
                share: 1.0,
            });
        }
        let points = outline.points().len();
        let outline = match points {
            // Of few corners there is more to follow along the sides.
            _ if points < pairs.max(8) => outline.subdivided(4 * pairs.max(8)),
            _ if points > MAX_PREPARED => outline.resampled(MAX_PREPARED),
            _ => outline.clone(),
        };
        let diagonal = outline.diagonal();
        let straight = Straight::new(&outline, pairs, Guard::new(&outline));
        let (curve, error) = straight.best();
        let best = ClosedFit { curve: curve.clone(), error };
        let most = MAX_FOLLOWED.max(6 * pairs);
        let enough = most.min(enough_points(pairs));
        // As many rounds as with all of them.
        let share = |points: usize| points as f64 / outline.points().len().min(most) as f64;
        let (thin, followed, share, tolerance) = if pairs <= FEW_PAIRS {
            (thinned(&outline, POINTS_A_PAIR * pairs), thinned(&outline, most), 1.0, FITTING_TOLERANCE)
        } else if pairs <= SOME_PAIRS {
            let followed = thinned(&outline, enough);
            let thin = thinned(&outline, POINTS_A_PAIR_OF_SOME * pairs);
            let share = (MORE_ROUNDS * share(thin.points().len())).min(share(followed.points().len()));
            (thin, followed, share, COARSE_TOLERANCE)
        } else {
            let thin = thinned(&outline, enough);
            let share = share(thin.points().len());
            (thin.clone(), thin, share, FITTING_TOLERANCE)
        };
        let search = Search::new(thin, pairs, tolerance * diagonal, share, outline.points().len());
        Ok(Self {
            outline,
            diagonal,
            straight: Some(straight),
            search: Some(search),
            followed,
            judge: None,
            next_look: 0,
            finisher: None,
            best,
            stage: Stage::Straight,
            share: 0.0,
        })
    }

    /// The best fit so far; from the start on there is one.
    #[must_use]
    pub fn best(&self) -> &ClosedFit {
        &self.best
    }

    /// Whether there is nothing more to do.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.stage == Stage::Done
    }

    /// Goes one step on.
    pub fn step(&mut self) -> Progress {
        let stage = self.stage;
        match stage {
            Stage::Straight => self.straight(),
            Stage::Copies => self.copies(),
            Stage::Trade => self.trade(),
            Stage::Polish => self.polish(),
            Stage::Done => {}
        }
        let share = match self.stage {
            Stage::Straight => 0.1 * self.straight.as_ref().map_or(1.0, Straight::share),
            Stage::Copies => 0.1,
            Stage::Trade => 0.1 + 0.7 * self.search.as_ref().map_or(1.0, Search::spent),
            Stage::Polish => 0.8 + 0.2 * self.finisher.as_ref().map_or(0.0, Finisher::share),
            Stage::Done => 1.0,
        };
        self.share = self.share.max(share);
        let rms = 100.0 * (self.best.error / self.outline.points().len() as f64).sqrt() / self.diagonal;
        Progress { stage, share: self.share, rms }
    }

    /// Steps to the end.
    #[must_use]
    pub fn finish(mut self) -> ClosedCurve {
        while !self.is_done() {
            self.step();
        }
        self.best.curve
    }

    /// Has the best of the search measured.
    fn look(&mut self) {
        if let (Some(search), Some(judge)) = (&mut self.search, &mut self.judge)
            && let Some(curve) = search.take_unseen()
        {
            let before = judge.work();
            judge.show(&curve);
            if judge.looks_roughly() {
                self.next_look = search.work() + SEARCH_A_LOOK * (judge.work() - before);
            }
            self.best = of_judge(judge, &self.outline);
            if is_exact(&judge.best().near) {
                self.stage = Stage::Done;
            }
        }
    }

    fn straight(&mut self) {
        let Some(straight) = &mut self.straight else { return };
        if straight.step() {
            let (curve, error) = straight.best();
            self.best = ClosedFit { curve: curve.clone(), error };
            return;
        }
        let guard = straight.guard().cloned();
        let few = self.search.as_ref().is_some_and(Search::has_few);
        let judge = Judge::new(&self.outline, guard.clone(), straight.kept(), few);
        self.best = of_judge(&judge, &self.outline);
        let near = judge.best().near;
        if let Some(search) = &mut self.search {
            search.set_line(&self.best.curve, near.rms / 100.0 * self.diagonal, guard);
        }
        self.judge = Some(judge);
        self.stage = if is_exact(&near) { Stage::Done } else { Stage::Copies };
    }

    fn copies(&mut self) {
        let begun = self.search.as_mut().is_some_and(Search::begin_with_copies);
        self.stage = if begun { Stage::Trade } else { Stage::Polish };
    }

    fn trade(&mut self) {
        let Some(search) = &mut self.search else { return };
        let more = search.step();
        if !more {
            self.stage = Stage::Polish;
        }
        let rested = search.rounds().is_multiple_of(ROUNDS_UNSEEN) && search.work() >= self.next_look;
        if !more || rested {
            self.look();
        }
    }

    /// Several ends are tried, on all points, and the best is kept by what is measured.
    fn polish(&mut self) {
        if let (Some(search), Some(judge)) = (self.search.take(), self.judge.take()) {
            let reach = search.reach();
            let curves = search.into_found();
            let tolerance = FITTING_TOLERANCE * self.diagonal / 3.0;
            self.finisher =
                Some(Finisher::new(&self.followed, judge, &curves, tolerance, FITTING_LEVELS + 1, reach));
            return;
        }
        let Some(finisher) = &mut self.finisher else {
            self.stage = Stage::Done;
            return;
        };
        let more = finisher.step();
        self.best = of_judge(finisher.judge(), &self.outline);
        if !more {
            self.stage = Stage::Done;
        }
    }
}

fn of_judge(judge: &Judge, outline: &Outline) -> ClosedFit {
    let Judged { curve, near, .. } = judge.best();
    let error = (near.rms / 100.0 * outline.diagonal()).powi(2) * outline.points().len() as f64;
    ClosedFit { curve: curve.clone(), error }
}

/// An outline of no more than so many corners, as documents keep it. None where it has more, or where that would make
/// it meet itself.
fn exact(outline: &Outline, most: usize) -> Option<ClosedFit> {
    let corners = Outline::new(&corners(outline, most)?).ok()?;
    let curve = ClosedCurve::polygon(corners.points().to_vec()).quantised().ok()?;
    if Guard::new(&corners).is_some_and(|guard| !guard.passes(&curve.knots)) {
        return None;
    }
    let nearest = Nearest::new(&curve.knots, true);
    let error = outline.points().iter().map(|&p| nearest.to(p).squared).sum();
    Some(ClosedFit { curve, error })
}

/// Some points of an outline, `most` at most.
fn thinned(outline: &Outline, most: usize) -> Outline {
    let ring = outline::thinned(outline.points(), most);
    // One that crosses itself may be turned round, which its points are not to be.
    Outline::new(&ring)
        .ok()
        .filter(|thin| thin.points().first() == ring.first())
        .unwrap_or_else(|| outline.clone())
}

#[cfg(test)]
mod tests {
    use frond_core::hash;
    use glam::DVec2;

    use super::*;
    use crate::{island, maple_leaf, oak_leaf, sugar_maple, white_oak};

    /// What a fit has in hand while it searches, and what is like it: copies rougher or less rough, knots elsewhere.
    fn variants(curve: &ClosedCurve, diagonal: f64, seed: u32) -> Vec<ClosedCurve> {
        let random = |k: usize| f64::from(hash::unit(hash::counter(seed, k as u32)));
        let varied = |size: f64| {
            let mut next = curve.clone();
            for (i, knot) in next.knots.iter_mut().enumerate() {
                *knot += size * diagonal * (DVec2::new(random(3 * i), random(3 * i + 1)) - 0.5);
            }
            for (i, copy) in next.edges.iter_mut().enumerate() {
                if let Some(copy) = copy {
                    copy.c *= 1.0 + 40.0 * size * (random(3 * i + 2) - 0.5);
                }
            }
            next
        };
        [0.0, 0.002, 0.01, 0.05].map(varied).into_iter().filter(ClosedCurve::is_sound).collect()
    }

    #[test]
    fn a_rough_look_refuses_nothing_that_would_be_kept() {
        let outlines = [maple_leaf(1), sugar_maple(2), white_oak(1), oak_leaf(3), island(4)];
        let (mut refused, mut kept) = (0, 0);
        for (which, points) in outlines.iter().enumerate() {
            let outline = Outline::new(points).unwrap().resampled(150);
            for numbers in [12, 24] {
                let mut fitter = Fitter::new(&outline, numbers).unwrap();
                for step in 0.. {
                    if fitter.is_done() {
                        break;
                    }
                    fitter.step();
                    let (Some(search), Some(judge)) = (&fitter.search, &fitter.judge) else { continue };
                    if step % 32 != 0 {
                        continue;
                    }
                    for curve in variants(search.now(), outline.diagonal(), step) {
                        let Ok(curve) = curve.quantised() else { continue };
                        let may = judge.clone().may_keep(&curve);
                        let keeps = judge.clone().measure(&curve, false);
                        assert!(may || !keeps, "outline {which}, {numbers} numbers, step {step}");
                        refused += usize::from(!may);
                        kept += usize::from(keeps);
                    }
                }
            }
        }
        // It saves drawings, and there is something to lose.
        assert!(refused > 100 && kept > 5, "{refused} refused, {kept} kept");
    }
}
