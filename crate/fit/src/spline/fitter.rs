//! The nearest curve of nodes that is found within so many bytes, step by step.

use glam::DVec2;

use super::Spline;
use super::beginning::Beginning;
use super::contest::{Contest, SIDES};
use super::grids::Grids;
use super::polylines::Polylines;
use crate::outline::{Fidelity, Outline, fidelity};

/// The fewest and the most bytes that a fit is asked to come to.
pub const LEAST_BYTES: usize = 32;
/// See [`LEAST_BYTES`].
pub const MOST_BYTES: usize = 4000;

/// How many points are followed for each byte, and how many at least and at most.
const POINTS_A_BYTE: usize = 6;
const POINTS: (usize, usize) = (400, 6000);

/// What part of the work the plain polylines are, about.
const PLAIN_SHARE: f64 = 0.3;

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
    /// The polylines that a fit has to beat.
    Plain(Box<Polylines>),
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
    /// The nearest polyline, where the contest measures at some points of the outline alone.
    polyline: Option<(Spline, Vec<u8>)>,
    work: Work,
    kicks: usize,
    share: f64,
}

impl SplineFitter {
    /// Begins a fit within so many bytes, which are held to [`LEAST_BYTES`] and [`MOST_BYTES`].
    #[must_use]
    pub fn new(outline: &Outline, bytes: usize) -> Self {
        let budget = bytes.clamp(LEAST_BYTES, MOST_BYTES);
        let contest = Contest::new(outline, budget);
        let followed = followed(contest.outline(), budget);
        Self {
            outline: outline.clone(),
            followed,
            work: Work::Plain(Box::new(Polylines::new(&contest))),
            contest,
            polyline: None,
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
        let fit = |(spline, bytes): (&Spline, &[u8])| {
            let near = fidelity(&self.outline, &spline.polyline(SIDES));
            SplineFit { spline: spline.clone(), bytes: bytes.to_vec(), near }
        };
        let best = fit(self.contest.best()?);
        // What is nearer at some points of a long outline may be farther at all of them.
        let nearer = |line: &SplineFit| self.is_done() && line.near.rms < best.near.rms;
        let line = self.polyline.as_ref().map(|(spline, bytes)| fit((spline, bytes))).filter(nearer);
        Some(line.unwrap_or(best))
    }

    /// Goes one step on: some milliseconds, seldom more than fifty.
    pub fn step(&mut self) {
        match std::mem::replace(&mut self.work, Work::Done) {
            Work::Plain(polylines) => self.plain(polylines),
            Work::Descents(ways, grids) => self.descents(ways, grids),
            Work::Done => {}
        }
        let now = match &self.work {
            Work::Plain(polylines) => PLAIN_SHARE * polylines.share(),
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

    fn plain(&mut self, mut polylines: Box<Polylines>) {
        self.work = if polylines.step(&mut self.contest) {
            Work::Plain(polylines)
        } else {
            if self.contest.outline().points().len() < self.outline.points().len() {
                self.polyline = self.contest.best().map(|(spline, bytes)| (spline.clone(), bytes.to_vec()));
            }
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
        } else if let Some(from) = ways.pop().filter(|_| !self.contest.is_enough()) {
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
/// are moved on the grid, taken, added, bent. It is not farther from the outline (root mean square) than
/// [`polyline_within`](crate::polyline_within), with which it begins. Where the outline meets itself nowhere, the curve
/// does not either. An outline whose own corners fit into the bytes, so finely that nobody could tell, is looked for no
/// further.
///
/// An outline of more than [`MAX_PREPARED`](crate::MAX_PREPARED) points is followed at so many places along it, and
/// measured at all of its points.
///
/// None where nothing was found: the outline lies so far from the origin that places take too many bytes, or is so thin
/// that on a grid of some hundred steps it would fall together.
#[must_use]
pub fn fit_within(outline: &Outline, bytes: usize) -> Option<SplineFit> {
    SplineFitter::new(outline, bytes).finish()
}
