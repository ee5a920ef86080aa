//! The nearest curve of nodes that is found within so many bytes, step by step.

use glam::DVec2;

use super::beginning::Beginning;
use super::contest::{Contest, SIDES};
use super::grids::Grids;
use super::{MAX_NODES, Spline};
use crate::fitting::Straight;
use crate::outline::{Fidelity, MAX_PREPARED, Outline, fidelity};

/// The fewest and the most bytes that a fit is asked to come to.
pub const LEAST_BYTES: usize = 32;
/// See [`LEAST_BYTES`].
pub const MOST_BYTES: usize = 4000;

/// How many points are followed for each byte, and how many at least and at most.
const POINTS_A_BYTE: usize = 6;
const POINTS: (usize, usize) = (400, 6000);

/// How many bits a corner of the plain polylines takes that a fit has to beat.
const CORNER_BITS: [f64; 3] = [9.0, 11.0, 14.0];

/// Few corners that are tried as well.
const FEW_CORNERS: [usize; 4] = [3, 4, 6, 9];

/// What part of the work the plain polylines are.
const PLAIN_SHARE: f64 = 0.2;

/// What descents begin with, in turn.
const BEGINNINGS: [Beginning; 4] = [Beginning::Best, Beginning::Plain, Beginning::Corners, Beginning::Bends];

/// How many grids are tried from one beginning, and after a kick.
const GRIDS: usize = 4;
const GRIDS_AFTER_KICK: usize = 3;

/// How many kicks there are within one byte, and how many at least and at most: each takes time as the bytes do.
const KICKS: f64 = 1200.0;
const KICK_RANGE: (usize, usize) = (3, 12);

/// A curve within so many bytes, and how near it is.
#[derive(Clone, Debug, PartialEq)]
pub struct SplineFit {
    /// The curve.
    pub spline: Spline,
    /// It packed.
    pub bytes: Vec<u8>,
    /// How near the outline it is, a parabola taken as 16 sides.
    pub near: Fidelity,
}

/// What is being done.
#[derive(Clone, Debug)]
enum Work {
    /// Polylines of so many corners, the last first.
    Plain(Vec<usize>, Option<Box<Straight>>),
    /// Descents: the ways that are left, the last first.
    Descents(Vec<Beginning>, Option<Box<Grids>>),
    Done,
}

/// Looks for the nearest curve of corners and parabolas within so many bytes, one short step after the other. See
/// [`fit_within`]. Between steps the work may be dropped, and the best so far taken, at any time.
#[derive(Clone, Debug)]
pub struct SplineFitter {
    outline: Outline,
    followed: Outline,
    contest: Contest,
    work: Work,
    counts: usize,
    kicks: usize,
    share: f64,
}

impl SplineFitter {
    /// Begins a fit within so many bytes, which are held to [`LEAST_BYTES`] and [`MOST_BYTES`].
    #[must_use]
    pub fn new(outline: &Outline, bytes: usize) -> Self {
        let budget = bytes.clamp(LEAST_BYTES, MOST_BYTES);
        let prepared = if outline.points().len() > MAX_PREPARED {
            outline.resampled(MAX_PREPARED)
        } else {
            outline.clone()
        };
        let followed = followed(&prepared, budget);
        let contest = Contest::new(prepared, budget);
        let bits = contest.free_bits();
        let most = followed.points().len().min(MAX_NODES);
        let mut counts: Vec<usize> =
            FEW_CORNERS.into_iter().chain(CORNER_BITS.map(|each| (bits / each) as usize)).collect();
        counts.retain(|&count| (3..=most).contains(&count));
        counts.sort_unstable();
        counts.dedup();
        let many = counts.len();
        Self {
            outline: outline.clone(),
            followed,
            contest,
            work: Work::Plain(counts, None),
            counts: many,
            kicks: ((KICKS / budget as f64) as usize).clamp(KICK_RANGE.0, KICK_RANGE.1),
            share: 0.0,
        }
    }

    /// How far it is, from 0 to 1; it never falls.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.share
    }

    /// Whether there is nothing more to do.
    #[must_use]
    pub fn is_done(&self) -> bool {
        matches!(self.work, Work::Done)
    }

    /// The best so far, measured on all points of the outline. None at first, and where nothing is found: see
    /// [`fit_within`].
    #[must_use]
    pub fn best(&self) -> Option<SplineFit> {
        let (spline, bytes) = self.contest.best()?;
        let near = fidelity(&self.outline, &spline.polyline(SIDES));
        Some(SplineFit { spline: spline.clone(), bytes: bytes.to_vec(), near })
    }

    /// Goes one step on: some milliseconds, seldom more than fifty.
    pub fn step(&mut self) {
        match std::mem::replace(&mut self.work, Work::Done) {
            Work::Plain(counts, straight) => self.plain(counts, straight),
            Work::Descents(ways, grids) => self.descents(ways, grids),
            Work::Done => {}
        }
        let now = match &self.work {
            Work::Plain(counts, straight) => {
                let begun = straight.as_ref().map_or(0.0, |straight| straight.share() - 1.0);
                PLAIN_SHARE * (1.0 - (counts.len() as f64 - begun) / self.counts as f64)
            }
            Work::Descents(ways, grids) => {
                let begun = grids.as_ref().map_or(0.0, |grids| grids.share() - 1.0);
                1.0 - (1.0 - PLAIN_SHARE) * (ways.len() as f64 - begun)
                    / (BEGINNINGS.len() + self.kicks) as f64
            }
            Work::Done => 1.0,
        };
        self.share = self.share.max(now);
    }

    /// StepLaw to the end.
    #[must_use]
    pub fn finish(mut self) -> Option<SplineFit> {
        while !self.is_done() {
            self.step();
        }
        self.best()
    }

    fn plain(&mut self, mut counts: Vec<usize>, straight: Option<Box<Straight>>) {
        if let Some(mut straight) = straight {
            if straight.step() {
                self.work = Work::Plain(counts, Some(straight));
                return;
            }
            self.contest.show_polygon(&straight.kept().knots);
        }
        self.work = if let Some(count) = counts.pop() {
            let straight = Straight::new(&self.followed, count, self.contest.guard().cloned());
            Work::Plain(counts, Some(Box::new(straight)))
        } else {
            // So few bytes may not follow the outline to where it meets itself.
            self.contest.relax();
            let mut ways: Vec<Beginning> = (0..self.kicks).rev().map(Beginning::Kick).collect();
            ways.extend(BEGINNINGS.into_iter().rev());
            Work::Descents(ways, None)
        };
    }

    fn descents(&mut self, mut ways: Vec<Beginning>, grids: Option<Box<Grids>>) {
        if let Some(mut grids) = grids
            && grids.step(&mut self.contest)
        {
            self.work = Work::Descents(ways, Some(grids));
        } else if let Some(from) = ways.pop() {
            let most = if matches!(from, Beginning::Kick(_)) { GRIDS_AFTER_KICK } else { GRIDS };
            let grids = Grids::new(&self.followed, &self.contest, from, most);
            self.work = Work::Descents(ways, Some(Box::new(grids)));
        }
    }
}

/// Some points of an outline, as many as so many bytes can tell of.
fn followed(outline: &Outline, bytes: usize) -> Outline {
    let points = outline.points();
    let most = (POINTS_A_BYTE * bytes).clamp(POINTS.0, POINTS.1);
    if points.len() < most / 2 {
        return outline.resampled(most);
    }
    let some: Vec<DVec2> = points.iter().copied().step_by(points.len().div_ceil(most)).collect();
    Outline::new(&some).unwrap_or_else(|_| outline.resampled(most))
}

/// The nearest curve of corners and parabolas that is found within so many bytes (held to [`LEAST_BYTES`] and
/// [`MOST_BYTES`]), packed and all.
///
/// Squares of distances and bits are made small together (rate and distortion, or minimum description length): nodes
/// are moved on the grid, taken, added, bent. It is not farther from the outline (root mean square) than polylines of
/// corners chosen by least squares, each on the finest grid on which it fits into as many bytes of the same form. Where
/// the outline meets itself nowhere, the curve does not either.
///
/// An outline of more than [`MAX_PREPARED`] points is followed at so many places along it, and measured at all of its
/// points.
///
/// None where nothing was found: the outline lies so far from the origin that places take too many bytes, or is so thin
/// that on a grid of some hundred steps it would fall together.
#[must_use]
pub fn fit_within(outline: &Outline, bytes: usize) -> Option<SplineFit> {
    SplineFitter::new(outline, bytes).finish()
}
