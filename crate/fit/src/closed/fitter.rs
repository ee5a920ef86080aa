//! Fitting an outline step by step, with the best so far always at hand.

use std::collections::BTreeMap;

use frond_core::hash;
use glam::DVec2;
use thiserror::Error;

use super::candidates::Library;
use super::final_refine::Finisher;
use super::judge::{Judge, Judged};
use super::moves::{Marked, Move, Name, Offer};
use super::refine::{Refiner, Ties};
use super::straight::Straight;
use super::{ClosedCurve, partition};
use crate::outline::{Guard, MAX_PREPARED, Nearest, Outline, decimated};

/// The least and the most numbers a fit may have.
const NUMBER_RANGE: (usize, usize) = (12, 2000);

/// The most points of the outline that are followed while searching.
const MAX_FOLLOWED: usize = 2400;

/// The share of the pairs of numbers that begins as knots; trading finds the right one.
const KNOT_SHARE: f64 = 0.8;

/// Why an outline is not fitted.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum FitError {
    /// Not between 12 and 2000.
    #[error("A fit has 12 to 2000 numbers, and {numbers} were asked for. Choose another number.")]
    BadNumbers {
        /// What was asked for.
        numbers: usize,
    },
    /// The outline has not more points than the fit has knots.
    #[error(
        "The outline has {points} points, too few for a fit of {numbers} numbers. Ask for fewer, or take a finer outline."
    )]
    OutlineTooCoarse {
        /// Points of the outline.
        points: usize,
        /// What was asked for.
        numbers: usize,
    },
}

impl FitError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::BadNumbers { .. } => "bad-numbers",
            Self::OutlineTooCoarse { .. } => "outline-too-coarse",
        }
    }
}

/// What a fitter is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Polygons: the first usable fit, then the best straight one.
    Straight,
    /// The first copies.
    Copies,
    /// Numbers go where they do most.
    Trade,
    /// All numbers together, on all points.
    Polish,
    /// There is nothing more to do.
    Done,
}

/// How far a fitter has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// What was done.
    pub stage: Stage,
    /// From 0 to 1; it never falls.
    pub share: f64,
    /// Root mean square distance from the outline's points to the best fit, in percent of the diagonal.
    pub rms: f64,
}

/// The best fit so far.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedFit {
    /// The curve.
    pub curve: ClosedCurve,
    /// The sum of squared distances from the points that are followed.
    pub error: f64,
}

/// Fits a self-affine closed curve to an outline, one short step after the other.
///
/// It begins with the best polyline of as many numbers, and what it has in the end is no farther from the outline than
/// that (root mean square, of the curve as it is drawn). Where the outline does not meet itself, the drawn curve does
/// not either. Every step takes some milliseconds to some hundred; between steps the work may be dropped at any time.
#[derive(Clone, Debug)]
pub struct Fitter {
    outline: Outline,
    /// The points that are followed while searching, as an outline.
    thin: Outline,
    diagonal: f64,
    pairs: usize,
    straight: Straight,
    judge: Option<Judge>,
    refiner: Refiner,
    tolerance: f64,
    now: Marked,
    error: f64,
    best: ClosedFit,
    stage: Stage,
    rounds: usize,
    batch: usize,
    jitter: f64,
    share: f64,
    greed: f64,
    reach: f64,
    /// Rounds without a gain.
    stale: usize,
    /// Moves that were tried in vain, and until which round they are not tried again.
    refused: BTreeMap<Name, usize>,
    /// The best polyline, until copies have had their time to do better.
    line: Option<(Marked, f64)>,
    /// Whether the curve may stray more by now.
    loose: bool,
    /// Where the present search set out.
    home: Option<(Marked, f64)>,
    /// The best of each search.
    found: Vec<(ClosedCurve, f64)>,
    /// The least error of the search, and when it was found.
    least: (f64, u64),
    /// Whether it is still to be shown to the judge.
    unseen: Option<ClosedCurve>,
    finisher: Option<Finisher>,
}

/// After so many rounds without a gain the search sets out anew.
const IDLE_ROUNDS: usize = 30;

/// Moves with which it does.
const RESTART_MOVES: usize = 3;

/// How far the curve may stray from the outline, in root mean squares of the best polyline.
const FREE_DISTANCE: f64 = 4.0;

/// What the curve pays for straying while searching.
const TIES: Ties = Ties { back: 0.01, beyond: 0.5, far: 0.0, reach: 0.0 };

/// The same in the second part of the search, which begins after this share of it.
const LOOSE_TIES: Ties = Ties { back: 0.003, beyond: 0.3, far: 0.0, reach: 0.0 };
const LOOSENED: f64 = 0.5;

/// So many rounds what was tried in vain is not tried again, more or less.
const REFUSED_ROUNDS: f64 = 60.0;

/// So many curves are finished.
const CURVES_FINISHED: usize = 3;

/// How deep copies are opened while fitting.
const FITTING_LEVELS: usize = 3;

/// What a search may cost, in the refiner's units of work: so much, and so much more for each pair of numbers.
const WORK: (u64, u64) = (14_000_000, 84_000);

/// A search that gains less than this share over this part of its work ends.
const STALL: (f64, f64) = (0.002, 0.4);

/// The most moves of a round, in parts of the pairs of numbers.
const BATCH_SHARE: f64 = 0.05;

/// Rounds between two looks of the judge, which measures what is drawn.
const ROUNDS_UNSEEN: usize = 16;

impl Fitter {
    /// Begins a fit of at most `numbers` numbers: 2 a knot, 2 a copied edge.
    ///
    /// # Errors
    /// Where the numbers are not between 12 and 2000, or the outline has too few points for them.
    pub fn new(outline: &Outline, numbers: usize) -> Result<Self, FitError> {
        if numbers < NUMBER_RANGE.0 || numbers > NUMBER_RANGE.1 {
            return Err(FitError::BadNumbers { numbers });
        }
        let pairs = numbers / 2;
        let points = outline.points().len();
        if points < pairs.max(8) {
            return Err(FitError::OutlineTooCoarse { points, numbers });
        }
        let outline = if points > MAX_PREPARED { outline.resampled(MAX_PREPARED) } else { outline.clone() };
        let diagonal = outline.diagonal();
        let straight = Straight::new(&outline, pairs, Guard::new(&outline));
        let (curve, error) = straight.best();
        let best = ClosedFit { curve: curve.clone(), error };
        let tolerance = 1.5e-3 * diagonal;
        let thin = thinned(&outline, MAX_FOLLOWED.max(6 * pairs));
        let refiner = Refiner::new(thin.points().to_vec(), tolerance, FITTING_LEVELS);
        Ok(Self {
            now: Marked { curve: curve.clone(), marks: Vec::new() },
            outline,
            thin,
            diagonal,
            pairs,
            straight,
            judge: None,
            refiner,
            tolerance,
            error: f64::INFINITY,
            best,
            stage: Stage::Straight,
            rounds: 0,
            batch: ((pairs as f64 * BATCH_SHARE) as usize).max(2),
            jitter: 0.0,
            share: 0.0,
            greed: 1.0,
            reach: 0.0,
            stale: 0,
            refused: BTreeMap::new(),
            line: None,
            loose: false,
            home: None,
            found: Vec::new(),
            least: (f64::INFINITY, 0),
            unseen: None,
            finisher: None,
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
        if matches!(stage, Stage::Copies | Stage::Trade) && self.error < self.least.0 {
            if self.error < self.least.0 * (1.0 - STALL.0) {
                self.least = (self.error, self.refiner.work());
            }
            self.unseen = Some(self.now.curve.clone());
        }
        if stage == Stage::Trade && (self.rounds.is_multiple_of(ROUNDS_UNSEEN) || self.stage != stage) {
            self.look();
        }
        let share = match self.stage {
            Stage::Straight => 0.1 * self.straight.share(),
            Stage::Copies => 0.1,
            Stage::Trade => 0.1 + 0.7 * self.spent(),
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

    /// How much of the search is over: of its work, or of the patience with one that gains nothing.
    fn spent(&self) -> f64 {
        let whole = (WORK.0 + WORK.1 * self.pairs as u64) as f64;
        let work = self.refiner.work();
        let idle = (work - self.least.1.min(work)) as f64 / (STALL.1 * whole);
        (work as f64 / whole).max(idle.min(1.0).powi(4)).min(1.0)
    }

    /// Has the best of the search measured.
    fn look(&mut self) {
        if let (Some(curve), Some(judge)) = (self.unseen.take(), &mut self.judge) {
            judge.show(&curve);
            self.best = of_judge(judge, &self.outline);
        }
    }

    fn begin(&mut self, marks: Vec<usize>) {
        let ring = self.thin.points();
        let curve = ClosedCurve::polygon(marks.iter().map(|&i| ring[i]).collect());
        self.error = self.refiner.error(&curve);
        self.now = Marked { curve, marks };
        self.refiner.reset();
    }

    /// Some steps of least squares. The marks follow.
    fn refine(&mut self, steps: usize) {
        for _ in 0..steps {
            let (error, moved) = self.refiner.step(&mut self.now.curve, self.error);
            let little = error > self.error * (1.0 - 1e-4);
            self.error = error;
            if !moved || little {
                break;
            }
        }
        self.now.follow(self.thin.points());
    }

    fn straight(&mut self) {
        if self.straight.step() {
            let (curve, error) = self.straight.best();
            self.best = ClosedFit { curve: curve.clone(), error };
            return;
        }
        let guard = self.straight.guard().cloned();
        let judge = Judge::new(&self.outline, guard.clone(), self.straight.kept());
        self.best = of_judge(&judge, &self.outline);
        self.reach = FREE_DISTANCE * judge.best().near.rms / 100.0 * self.diagonal;
        self.judge = Some(judge);
        self.refiner.set_guard(guard);
        self.refiner.set_ties(Ties { reach: self.reach, ..TIES });
        let curve = self.best.curve.clone();
        if let Some(marks) = marks_of(&curve.knots, self.thin.points()) {
            let error = self.refiner.error(&curve);
            self.line = Some((Marked { curve, marks }, error));
        }
        self.stage = Stage::Copies;
    }

    fn copies(&mut self) {
        let knots = ((KNOT_SHARE * self.pairs as f64) as usize).max(3);
        self.error = f64::INFINITY;
        let marks = partition(&self.thin, knots);
        if marks.len() >= 3 {
            self.begin(marks);
        }
        if !self.error.is_finite() {
            self.begin(decimated(&self.thin, knots));
        }
        self.refine(3);
        let library = Library::new(&self.now.curve, self.tolerance, FITTING_LEVELS);
        let (_, mut using) = self.now.offers(self.thin.points(), &library, &[], |_| false);
        using.retain(|offer| matches!(offer.action, Move::Copy(..)) && offer.cost < 0.0);
        using.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        let free = self.pairs.saturating_sub(self.now.curve.knots.len());
        let moves: Vec<_> = using.iter().take(free).map(|offer| offer.action).collect();
        // All that can be had, or the best half of it, or of that: copies at once may cross each other.
        for many in [moves.len(), moves.len() / 2, moves.len() / 4] {
            let next = self.now.after(&moves[..many], self.thin.points(), &library);
            let error = self.refiner.error(&next.curve);
            if error.is_finite() {
                (self.now, self.error) = (next, error);
                break;
            }
        }
        self.refiner.reset();
        self.refine(4);
        if !self.error.is_finite() {
            let Some(line) = self.line.take() else {
                self.stage = Stage::Polish;
                return;
            };
            (self.now, self.error) = line;
        }
        self.stage = Stage::Trade;
    }

    /// One round: the cheapest numbers are freed and spent where they gain most; kept if it is for the better.
    fn trade(&mut self) {
        let library = Library::new(&self.now.curve, self.tolerance, FITTING_LEVELS);
        let moves = self.choose(&library);
        self.refiner.count(library.work(self.now.curve.knots.len()));
        self.rounds += 1;
        let spent = self.spent();
        if spent >= LOOSENED && !self.loose {
            self.loosen();
            return;
        }
        if spent >= 1.0 {
            self.stage = Stage::Polish;
            self.rounds = 0;
            return;
        }
        if moves.is_empty() {
            self.anneal();
            return;
        }
        let next = self.now.after(&moves, self.thin.points(), &library);
        let (kept, kept_error) = (self.now.clone(), self.error);
        let mut better = false;
        if next.curve.knots.len() + next.curve.copies() <= self.pairs {
            self.now = next;
            self.error = self.refiner.error(&self.now.curve);
            self.refiner.reset();
            if self.error.is_finite() {
                self.refine(1);
            }
            if self.error < 1.2 * kept_error {
                self.refine(3);
            }
            better = self.error < kept_error * (1.0 - 1e-4);
        }
        if better {
            self.stale = 0;
            self.batch = (self.batch + 1).min((self.pairs as f64 * BATCH_SHARE).max(2.0) as usize);
        } else {
            (self.now, self.error) = (kept, kept_error);
            if self.batch == 1 {
                self.anneal();
                for action in &moves {
                    let chance = f64::from(hash::unit(hash::counter(self.rounds as u32, 991)));
                    let long = REFUSED_ROUNDS * (0.5 + chance);
                    self.refused.insert(self.now.name(action), self.rounds + long as usize);
                }
            }
            self.batch = (self.batch / 2).max(1);
            self.stale += 1;
            if self.stale >= IDLE_ROUNDS {
                self.set_out();
            }
        }
    }

    /// The second part of the search: the curve may stray more. It begins with the best so far, the polyline among it.
    fn loosen(&mut self) {
        self.loose = true;
        self.refiner.set_ties(Ties { reach: self.reach, ..LOOSE_TIES });
        self.refused.clear();
        self.found.push((self.now.curve.clone(), self.error));
        let now = self.now.clone();
        let known = [self.line.take().map(|line| line.0), self.home.take().map(|home| home.0)];
        self.error = self.refiner.error(&now.curve);
        for marked in known.into_iter().flatten() {
            let error = self.refiner.error(&marked.curve);
            if error < self.error {
                (self.now, self.error) = (marked, error);
            }
        }
        self.least = (self.error, self.refiner.work());
    }

    /// Back to the best, and off again with some moves that are kept whatever they cost: another start.
    fn set_out(&mut self) {
        self.stale = 0;
        self.found.push((self.now.curve.clone(), self.error));
        self.found.sort_by(|a, b| a.1.total_cmp(&b.1));
        self.found.truncate(CURVES_FINISHED + 1);
        match &self.home {
            Some((marked, error)) if *error <= self.error => {
                (self.now, self.error) = (marked.clone(), *error);
            }
            _ => self.home = Some((self.now.clone(), self.error)),
        }
        let library = Library::new(&self.now.curve, self.tolerance, FITTING_LEVELS);
        self.batch = RESTART_MOVES;
        let (jitter, greed) = (self.jitter, self.greed);
        (self.jitter, self.greed) = (2.0, 4.0);
        let moves = self.choose(&library);
        (self.jitter, self.greed) = (jitter, greed);
        let next = self.now.after(&moves, self.thin.points(), &library);
        if next.curve.knots.len() + next.curve.copies() <= self.pairs {
            let kept = (self.now.clone(), self.error);
            self.now = next;
            self.error = self.refiner.error(&self.now.curve);
            self.refiner.reset();
            if self.error.is_finite() {
                self.refine(4);
            }
            if !self.error.is_finite() || self.error > 2.0 * kept.1 {
                (self.now, self.error) = kept;
            }
        }
    }

    /// From now on estimates are taken with chance: what they say is not worth it may be, once all has moved.
    fn anneal(&mut self) {
        if self.jitter == 0.0 {
            self.jitter = 1.0;
            self.greed = 1.5;
        }
    }

    /// Pairs of offers that gain more than they cost, far from each other, the best first.
    fn choose(&self, library: &Library) -> Vec<Move> {
        let truth = self.refiner.shares(&self.now.curve);
        let refused = |name: &Name| self.refused.get(name).is_some_and(|&until| until > self.rounds);
        let (mut freeing, mut using) = self.now.offers(self.thin.points(), library, &truth, refused);
        let mut chance = 0;
        let mut shake = |offer: &mut Offer| {
            chance += 1;
            let random = f64::from(hash::unit(hash::counter(self.rounds as u32, chance)));
            offer.cost *= (self.jitter * 2.0 * (random - 0.5)).exp();
        };
        if self.jitter > 0.0 {
            freeing.iter_mut().for_each(&mut shake);
            using.iter_mut().for_each(&mut shake);
        }
        let per = |offer: &Offer| offer.cost / f64::from(offer.numbers.abs().max(1));
        freeing.sort_by(|a, b| per(a).total_cmp(&per(b)));
        using.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        let mut touched = vec![false; self.now.marks.len()];
        let mut claim = |action: &Move| {
            let knots = self.now.touched(action);
            let free = knots.iter().all(|&k| !touched[k]);
            if free {
                knots.iter().for_each(|&k| touched[k] = true);
            }
            free
        };
        let mut moves = Vec::new();
        let used = self.now.curve.knots.len() + self.now.curve.copies();
        let mut spare = 2 * (self.pairs as i32 - used as i32);
        let mut sellers = freeing.iter();
        let mut owed = 0.0;
        let least = 1e-4 * self.error;
        for offer in using.iter().filter(|offer| offer.cost < -least) {
            if moves.len() >= 2 * self.batch {
                break;
            }
            // Without a price it may be had at once.
            while offer.numbers > spare {
                let Some(seller) = sellers.next() else { return moves };
                if owed + seller.cost > -offer.cost * self.greed {
                    return moves;
                }
                if claim(&seller.action) {
                    owed += seller.cost;
                    spare -= seller.numbers;
                    moves.push(seller.action);
                }
            }
            if owed < -offer.cost * self.greed && claim(&offer.action) {
                spare -= offer.numbers;
                owed = 0.0;
                moves.push(offer.action);
            }
        }
        moves
    }

    /// Several ends are tried, on all points, and the best is kept by what is measured.
    fn polish(&mut self) {
        if let (None, Some(judge)) = (&self.finisher, self.judge.take()) {
            let mut curves: Vec<ClosedCurve> = Vec::new();
            self.found.push((self.now.curve.clone(), self.error));
            self.found.extend(self.home.take().map(|(marked, error)| (marked.curve, error)));
            self.found.sort_by(|a, b| a.1.total_cmp(&b.1));
            for (curve, _) in self.found.drain(..) {
                if !curves.contains(&curve) {
                    curves.push(curve);
                }
            }
            curves.truncate(CURVES_FINISHED);
            self.finisher = Some(Finisher::new(
                &self.outline,
                judge,
                &curves,
                self.tolerance / 3.0,
                FITTING_LEVELS + 1,
                self.reach,
            ));
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

/// Every so manieth point of an outline, so that there are `most` at most.
fn thinned(outline: &Outline, most: usize) -> Outline {
    let stride = outline.points().len().div_ceil(most);
    let ring: Vec<_> = outline.points().iter().copied().step_by(stride).collect();
    // One that crosses itself may be turned round, which its points are not to be.
    Outline::new(&ring)
        .ok()
        .filter(|thin| thin.points().first() == ring.first())
        .unwrap_or_else(|| outline.clone())
}

/// The points of a ring that are nearest to knots, in their order; none where they are too close for that.
fn marks_of(knots: &[DVec2], ring: &[DVec2]) -> Option<Vec<usize>> {
    let nearest = Nearest::new(ring, true);
    let mut marks: Vec<usize> = knots
        .iter()
        .map(|&p| {
            let near = nearest.to(p);
            (near.side + usize::from(near.share > 0.5)) % ring.len()
        })
        .collect();
    // The first is where the numbers begin anew at most once.
    let first = marks[0];
    for i in 1..marks.len() {
        let ahead = (marks[i] + ring.len() - first) % ring.len();
        let before = (marks[i - 1] + ring.len() - first) % ring.len();
        let place = if ahead <= before { before + 1 } else { ahead };
        if place + (marks.len() - 1 - i) >= ring.len() {
            return None;
        }
        marks[i] = (first + place) % ring.len();
    }
    Some(marks)
}
