//! Fitting an outline step by step, with the best so far always at hand.

use frond_core::hash;
use glam::DVec2;
use thiserror::Error;

use super::candidates::Library;
use super::final_refine::Finisher;
use super::moves::{Marked, Move, Offer};
use super::refine::{Refiner, Ties};
use super::{ClosedCurve, partition};
use crate::outline::{Outline, features};

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
/// Every step takes some milliseconds to some hundred; between steps the work may be dropped at any time.
#[derive(Clone, Debug)]
pub struct Fitter {
    ring: Vec<DVec2>,
    all: Outline,
    diagonal: f64,
    pairs: usize,
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
    outline: Outline,
    /// Rounds without a gain.
    stale: usize,
    /// The best polygon, until copies have had their time to do better.
    straight: Option<(Marked, f64)>,
    /// Where the present search set out.
    home: Option<(Marked, f64)>,
    /// The best of each search.
    found: Vec<(ClosedCurve, f64)>,
    finisher: Option<Finisher>,
}

/// After so many rounds without a gain the search sets out anew.
const IDLE_ROUNDS: usize = 15;

/// Moves with which it does.
const RESTART_MOVES: usize = 3;

/// How far the curve may stray from the outline, in root mean squares of the first polygon.
const FREE_DISTANCE: f64 = 4.0;

/// What the curve pays for straying.
const TIES: Ties = Ties { back: 0.03, beyond: 2.0, far: 4.0, reach: 0.0 };

/// So many curves are finished.
const CURVES_FINISHED: usize = 3;

/// How deep copies are opened while fitting.
const FITTING_LEVELS: usize = 3;

/// The most rounds of trade.
const MOST_TRADE_ROUNDS: usize = 900;

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
        let diagonal = outline.diagonal();
        // The outline's own points are what is measured in the end; many more than needed are thinned evenly.
        let stride = points.div_ceil(MAX_FOLLOWED);
        let ring: Vec<_> = outline.points().iter().copied().step_by(stride).collect();
        let thin = Outline::new(&ring).unwrap_or_else(|_| outline.clone());
        let ring = thin.points().to_vec();
        let marks = features(&thin, pairs);
        let curve = ClosedCurve::polygon(marks.iter().map(|&i| ring[i]).collect());
        let tolerance = 1.5e-3 * diagonal;
        let refiner = Refiner::new(ring.clone(), tolerance, FITTING_LEVELS);
        let error = refiner.error(&curve);
        let best = ClosedFit { curve: curve.clone(), error };
        Ok(Self {
            ring,
            all: outline.clone(),
            diagonal,
            pairs,
            refiner,
            tolerance,
            now: Marked { curve, marks },
            error,
            best,
            stage: Stage::Straight,
            rounds: 0,
            batch: (pairs / 10).max(2),
            jitter: 0.0,
            share: 0.0,
            greed: 1.0,
            reach: 0.0,
            outline: thin,
            stale: 0,
            straight: None,
            home: None,
            found: Vec::new(),
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
        if stage != Stage::Polish && self.error < self.best.error {
            self.best = ClosedFit { curve: self.now.curve.clone(), error: self.error };
        }
        let share = match self.stage {
            Stage::Straight => 0.02 * self.rounds as f64,
            Stage::Copies => 0.1,
            Stage::Trade => 0.15 + 0.75 * self.rounds as f64 / MOST_TRADE_ROUNDS as f64,
            Stage::Polish => 0.9 + 0.1 * self.finisher.as_ref().map_or(0.0, Finisher::share),
            Stage::Done => 1.0,
        };
        self.share = self.share.max(share);
        let followed = self.finisher.as_ref().map_or(self.refiner.points().len(), Finisher::points) as f64;
        let rms = 100.0 * (self.best.error / followed).sqrt() / self.diagonal;
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

    fn begin(&mut self, marks: Vec<usize>) {
        let curve = ClosedCurve::polygon(marks.iter().map(|&i| self.ring[i]).collect());
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
        self.now.follow(&self.ring);
    }

    fn straight(&mut self) {
        if self.rounds == 0 {
            let marks = partition(&self.outline, self.pairs);
            if marks.len() >= 3 {
                self.begin(marks);
            }
            self.refine(2);
            let forward = self.refiner.forward_error(&self.now.curve);
            self.reach = FREE_DISTANCE * (forward / self.ring.len() as f64).sqrt();
            self.refiner.set_ties(Ties { reach: self.reach, ..TIES });
            self.error = self.refiner.error(&self.now.curve);
            self.best.error = self.refiner.error(&self.best.curve);
        } else {
            self.refine(4);
        }
        self.rounds += 1;
        if self.rounds == 3 {
            self.rounds = 0;
            self.stage = Stage::Copies;
        }
    }

    fn copies(&mut self) {
        let knots = ((KNOT_SHARE * self.pairs as f64) as usize).max(3);
        let marks = partition(&self.outline, knots);
        if marks.len() < 3 {
            self.stage = Stage::Polish;
            return;
        }
        self.straight = Some((self.now.clone(), self.error));
        self.begin(marks);
        self.refine(3);
        let library = Library::new(&self.now.curve, self.tolerance, FITTING_LEVELS);
        let (_, mut using) = self.now.offers(&self.ring, &library, &[]);
        using.retain(|offer| matches!(offer.action, Move::Copy(..)) && offer.cost < 0.0);
        using.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        let free = self.pairs.saturating_sub(self.now.curve.knots.len());
        let moves: Vec<_> = using.iter().take(free).map(|offer| offer.action).collect();
        let next = self.now.after(&moves, &self.ring, &library);
        if next.curve.is_safe() {
            self.now = next;
            self.error = self.refiner.error(&self.now.curve);
        }
        self.refiner.reset();
        self.refine(4);
        self.stage = Stage::Trade;
    }

    /// One round: the cheapest numbers are freed and spent where they gain most; kept if it is for the better.
    fn trade(&mut self) {
        let library = Library::new(&self.now.curve, self.tolerance, FITTING_LEVELS);
        let moves = self.choose(&library);
        self.rounds += 1;
        if self.rounds >= MOST_TRADE_ROUNDS {
            self.stage = Stage::Polish;
            self.rounds = 0;
            return;
        }
        if self.rounds == MOST_TRADE_ROUNDS / 3
            && let Some((marked, error)) = self.straight.take()
            && self.home.as_ref().map_or(self.error, |home| home.1.min(self.error)) > error
        {
            // Copies came to less than corners: they are tried one by one from the polygon on.
            (self.now, self.error, self.home) = (marked, error, None);
            return;
        }
        if moves.is_empty() {
            self.anneal();
            return;
        }
        let next = self.now.after(&moves, &self.ring, &library);
        let (kept, kept_error) = (self.now.clone(), self.error);
        let mut better = false;
        if next.curve.is_safe() && next.curve.knots.len() + next.curve.copies() <= self.pairs {
            self.now = next;
            self.error = self.refiner.error(&self.now.curve);
            self.refiner.reset();
            self.refine(1);
            if self.error < 1.2 * kept_error {
                self.refine(3);
            }
            better = self.error < kept_error * (1.0 - 1e-4);
        }
        if better {
            self.stale = 0;
            self.batch = (self.batch + 1).min((self.pairs / 10).max(2));
        } else {
            (self.now, self.error) = (kept, kept_error);
            if self.batch == 1 {
                self.anneal();
            }
            self.batch = (self.batch / 2).max(1);
            self.stale += 1;
            if self.stale >= IDLE_ROUNDS {
                self.set_out();
            }
        }
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
        let next = self.now.after(&moves, &self.ring, &library);
        if next.curve.is_safe() && next.curve.knots.len() + next.curve.copies() <= self.pairs {
            let kept = (self.now.clone(), self.error);
            self.now = next;
            self.error = self.refiner.error(&self.now.curve);
            self.refiner.reset();
            self.refine(4);
            if self.error.is_nan() || self.error > 2.0 * kept.1 {
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
        let (mut freeing, mut using) =
            self.now.offers(&self.ring, library, &self.refiner.shares(&self.now.curve));
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
        let Some(finisher) = &mut self.finisher else {
            let mut curves = vec![self.best.curve.clone()];
            self.found.sort_by(|a, b| a.1.total_cmp(&b.1));
            curves
                .extend(self.found.drain(..).map(|found| found.0).filter(|curve| *curve != self.best.curve));
            curves.truncate(CURVES_FINISHED);
            let few = self.all.points().len() <= 16_384;
            let outline = if few { self.all.clone() } else { self.outline.clone() };
            let mut finisher =
                Finisher::new(outline, &curves, self.tolerance / 3.0, FITTING_LEVELS + 1, self.reach);
            finisher.begin(None);
            self.finisher = Some(finisher);
            return;
        };
        let more = finisher.step();
        if let Some((curve, error)) = finisher.best() {
            self.best = ClosedFit { curve: curve.clone(), error };
        }
        if !more {
            self.stage = Stage::Done;
        }
    }
}
