//! The search: numbers are freed where they do little and spent where they do more.

use std::collections::BTreeMap;

use frond_core::hash;
use frond_core::shared::sort_indices;

use super::candidates::Library;
use super::choice::{Choice, Temper, cheapest_first};
use super::marks::{Marked, marks_of, scattered};
use super::moves::{Move, Name};
use super::outlook::Outlook;
use super::partition::partition;
use super::refine::{Refiner, Ties};
use crate::closed::ClosedCurve;
use crate::outline::{Guard, Outline, decimated};

/// The share of the pairs of numbers that begins as knots; trading finds the right one.
const KNOT_SHARE: f64 = 0.8;

/// After so many rounds without a gain the search sets out anew.
const IDLE_ROUNDS: usize = 30;

/// With so few pairs of numbers it begins somewhere else instead, and sooner: what can be reached from one beginning is
/// soon found then, and mostly is not the best.
pub(crate) const FEW_PAIRS: usize = 12;
const FEW_IDLE_ROUNDS: usize = 10;

/// A beginning takes as long as so many rounds.
const ROUNDS_A_BEGINNING: usize = 5;

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
pub(crate) const CURVES_FINISHED: usize = 3;

/// How deep copies are opened while fitting.
pub(crate) const FITTING_LEVELS: usize = 3;

/// What a search may cost, in the refiner's units of work: so much, and so much more for each pair of numbers.
const WORK: (u64, u64) = (14_000_000, 84_000);

/// The most rounds for each point that is followed, and for each pair of numbers: in outlines of few points there is
/// less to be found. With few pairs there are as many as points, but no more than this, for each.
const ROUNDS: (usize, usize) = (8, 20);
const ENOUGH_POINTS: usize = 300;

/// A search that gains less than this share over this part of its work ends.
const STALL: (f64, f64) = (0.002, 0.4);

/// The most moves of a round, in parts of the pairs of numbers.
const BATCH_SHARE: f64 = 0.05;

/// A curve that is changed, round by round.
#[derive(Clone, Debug)]
pub(crate) struct Search {
    /// The points that are followed, as an outline.
    thin: Outline,
    /// What it may cost, and how many rounds it may have.
    whole: u64,
    most_rounds: usize,
    pairs: usize,
    refiner: Refiner,
    tolerance: f64,
    now: Marked,
    error: f64,
    rounds: usize,
    batch: usize,
    jitter: f64,
    greed: f64,
    reach: f64,
    /// Rounds without a gain.
    stale: usize,
    /// Beginnings by chance.
    beginnings: usize,
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
    /// What could be done to the curve, where that is known.
    outlook: Option<Outlook>,
}

impl Search {
    /// Prepares for so many pairs of numbers. `tolerance` is that of [`Refiner::new`]; of what a search may cost, this
    /// one has a `share`; the outline has so many `points`.
    pub fn new(thin: Outline, pairs: usize, tolerance: f64, share: f64, points: usize) -> Self {
        let refiner = Refiner::new(thin.points().to_vec(), tolerance, FITTING_LEVELS);
        let whole = (share * (WORK.0 + WORK.1 * pairs as u64) as f64) as u64;
        let most_rounds = if pairs <= FEW_PAIRS {
            points.min(ENOUGH_POINTS) * pairs
        } else {
            ROUNDS.0 * thin.points().len() + ROUNDS.1 * pairs
        };
        Self {
            whole,
            most_rounds,
            thin,
            pairs,
            refiner,
            tolerance,
            now: Marked { curve: ClosedCurve::polygon(Vec::new()), marks: Vec::new() },
            error: f64::INFINITY,
            rounds: 0,
            batch: ((pairs as f64 * BATCH_SHARE) as usize).max(2),
            jitter: 0.0,
            greed: 1.0,
            reach: 0.0,
            stale: 0,
            beginnings: 0,
            refused: BTreeMap::new(),
            line: None,
            loose: false,
            home: None,
            found: Vec::new(),
            least: (f64::INFINITY, 0),
            unseen: None,
            outlook: None,
        }
    }

    /// From now on the guard holds. The search is for what is better than the best polyline, of which the root mean
    /// square is given in plane units.
    pub fn set_line(&mut self, line: &ClosedCurve, rms: f64, guard: Option<Guard>) {
        self.reach = FREE_DISTANCE * rms;
        self.refiner.set_guard(guard);
        self.refiner.set_ties(Ties { reach: self.reach, ..TIES });
        if let Some(marks) = marks_of(&line.knots, self.thin.points()) {
            let error = self.refiner.error(line);
            self.line = Some((Marked { curve: line.clone(), marks }, error));
        }
    }

    /// Whether it has few pairs of numbers.
    pub fn has_few(&self) -> bool {
        self.pairs <= FEW_PAIRS
    }

    /// How far the curve may stray, in plane units.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// How many rounds there were.
    pub fn rounds(&self) -> usize {
        self.rounds
    }

    /// How much has been done so far, in the refiner's units of work.
    pub fn work(&self) -> u64 {
        self.refiner.work()
    }

    /// The best of the search, where it was not asked for before.
    pub fn take_unseen(&mut self) -> Option<ClosedCurve> {
        self.unseen.take()
    }

    /// What the next round sets out from.
    #[cfg(test)]
    pub fn now(&self) -> &ClosedCurve {
        &self.now.curve
    }

    /// The best curves that were found, the best first.
    pub fn into_found(mut self) -> Vec<ClosedCurve> {
        self.found.push((self.now.curve, self.error));
        self.found.extend(self.home.map(|(marked, error)| (marked.curve, error)));
        let mut curves: Vec<ClosedCurve> = Vec::new();
        for (curve, _) in best_first(&self.found) {
            if !curves.contains(&curve) {
                curves.push(curve);
            }
        }
        curves.truncate(CURVES_FINISHED);
        curves
    }

    /// How much of the search is over: of its work, its rounds, or the patience with one that gains nothing.
    pub fn spent(&self) -> f64 {
        let whole = self.whole as f64;
        let work = self.refiner.work();
        let idle = (work - self.least.1.min(work)) as f64 / (STALL.1 * whole);
        let tried = (self.rounds + ROUNDS_A_BEGINNING * self.beginnings) as f64 / self.most_rounds as f64;
        (work as f64 / whole).max(tried).max(idle.min(1.0).powi(4)).min(1.0)
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

    /// The first copies. False where there is nothing to begin with.
    pub fn begin_with_copies(&mut self) -> bool {
        let knots = ((KNOT_SHARE * self.pairs as f64) as usize).max(3);
        self.error = f64::INFINITY;
        let marks = partition(&self.thin, knots);
        if marks.len() >= 3 {
            self.begin(marks);
        }
        if !self.error.is_finite() {
            self.begin(decimated(&self.thin, knots));
        }
        self.add_copies();
        if !self.error.is_finite() {
            let Some(line) = self.line.take() else {
                return false;
            };
            (self.now, self.error) = line;
        }
        self.note();
        true
    }

    /// As many copies as there are numbers for, on a curve of knots alone.
    fn add_copies(&mut self) {
        self.refine(3);
        let mut outlook = self.outlook(Vec::new());
        let (_, mut using) = outlook.offers(&self.now, self.thin.points(), 0, &BTreeMap::new());
        using.retain(|offer| matches!(offer.action, Move::Copy(..)) && offer.cost < 0.0);
        let using = cheapest_first(&using, &|offer| offer.cost);
        let free = self.pairs.saturating_sub(self.now.curve.knots.len());
        let moves: Vec<_> = using.iter().take(free).map(|offer| offer.action).collect();
        // All that can be had, or the best half of it, or of that: copies at once may cross each other.
        for many in [moves.len(), moves.len() / 2, moves.len() / 4] {
            let next = self.now.after(&moves[..many], self.thin.points(), outlook.library());
            let error = self.refiner.error(&next.curve);
            if error.is_finite() {
                (self.now, self.error) = (next, error);
                break;
            }
        }
        self.refiner.reset();
        self.refine(4);
    }

    /// Off from knots that chance has put on the outline, and from copies on them. False where that is no curve.
    fn begin_anew(&mut self) -> bool {
        self.beginnings += 1;
        let seed = self.beginnings as u32;
        let least = self.pairs.div_ceil(2).clamp(3, self.pairs);
        let random = f64::from(hash::unit(hash::counter(seed, 4999)));
        let knots = least + (random * (self.pairs - least + 1) as f64) as usize;
        let marks = scattered(self.thin.points().len(), knots, seed);
        let kept = (self.now.clone(), self.error);
        self.error = f64::INFINITY;
        if marks.len() >= 3 {
            self.begin(marks);
        }
        if self.error.is_finite() {
            self.add_copies();
        }
        let begun = self.error.is_finite();
        if !begun {
            (self.now, self.error) = kept;
        }
        begun
    }

    /// Keeps in mind what is the best so far.
    fn note(&mut self) {
        if self.error < self.least.0 {
            if self.error < self.least.0 * (1.0 - STALL.0) {
                self.least = (self.error, self.refiner.work());
            }
            self.unseen = Some(self.now.curve.clone());
        }
    }

    /// One round; false where there is nothing more to do.
    pub fn step(&mut self) -> bool {
        let more = self.trade();
        self.note();
        more
    }

    /// One round: the cheapest numbers are freed and spent where they gain most; kept if it is for the better.
    #[inline(never)]
    fn trade(&mut self) -> bool {
        let mut outlook = match self.outlook.take() {
            Some(outlook) => outlook,
            None => self.outlook(self.refiner.shares(&self.now.curve)),
        };
        let moves = self.choose(&mut outlook);
        self.refiner.count(outlook.library().work(self.now.curve.knots.len()));
        self.rounds += 1;
        let spent = self.spent();
        if spent >= LOOSENED && !self.loose {
            self.loosen();
            return true;
        }
        if spent >= 1.0 {
            return false;
        }
        if moves.is_empty() {
            self.anneal();
            self.outlook = Some(outlook);
            self.grow_stale();
            return true;
        }
        let next = self.now.after(&moves, self.thin.points(), outlook.library());
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
            self.outlook = Some(outlook);
            self.grow_stale();
        }
        true
    }

    /// One more round without a gain. One in which nothing is left to try is one, too.
    fn grow_stale(&mut self) {
        self.stale += 1;
        let idle = if self.has_few() { FEW_IDLE_ROUNDS } else { IDLE_ROUNDS };
        if self.stale >= idle {
            self.set_out();
        }
    }

    /// The second part of the search: the curve may stray more. It begins with the best so far, the polyline among it.
    #[inline(never)]
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
    #[inline(never)]
    fn set_out(&mut self) {
        self.stale = 0;
        self.found.push((self.now.curve.clone(), self.error));
        self.found = best_first(&self.found);
        self.found.truncate(CURVES_FINISHED + 1);
        match &self.home {
            Some((marked, error)) if *error <= self.error => {
                (self.now, self.error) = (marked.clone(), *error);
            }
            _ => self.home = Some((self.now.clone(), self.error)),
        }
        let mut outlook = self.outlook(self.refiner.shares(&self.now.curve));
        self.outlook = None;
        self.batch = RESTART_MOVES;
        if self.has_few() && self.begin_anew() {
            return;
        }
        let (jitter, greed) = (self.jitter, self.greed);
        (self.jitter, self.greed) = (2.0, 4.0);
        let moves = self.choose(&mut outlook);
        (self.jitter, self.greed) = (jitter, greed);
        let next = self.now.after(&moves, self.thin.points(), outlook.library());
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

    /// What could be done to the curve.
    fn outlook(&self, truth: Vec<(f64, usize)>) -> Outlook {
        let library = Library::new(&self.now.curve, self.tolerance, FITTING_LEVELS);
        Outlook::new(&self.now, self.thin.points(), library, truth)
    }

    /// The moves of the next round.
    fn choose(&self, outlook: &mut Outlook) -> Vec<Move> {
        let (freeing, using) = outlook.offers(&self.now, self.thin.points(), self.rounds, &self.refused);
        let temper = Temper { jitter: self.jitter, greed: self.greed, seed: self.rounds as u32 };
        Choice::new(&self.now, self.pairs, self.batch, self.error).of(freeing, using, temper)
    }
}

/// Curves by their errors.
fn best_first(found: &[(ClosedCurve, f64)]) -> Vec<(ClosedCurve, f64)> {
    let mut order: Vec<usize> = (0..found.len()).collect();
    sort_indices(&mut order, &|i, j| found[i].1.total_cmp(&found[j].1));
    order.into_iter().map(|i| found[i].clone()).collect()
}
