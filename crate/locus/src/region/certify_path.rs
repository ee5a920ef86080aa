//! A path, proved from end to end.

use std::collections::BinaryHeap;

use frond_core::shared::{Ranked, Total};
use frond_core::{Affine2, Morph};
use glam::{DVec2, DVec3};

use crate::decide::{Scratch, decide_bounds};
use crate::family::{Leg, Motions};
use crate::grid::LocusGrid;
use crate::region::descent::Descent;
use crate::region::extent::Extent;
use crate::region::joint_bound::joint_bound;
use crate::region::trap::Effort;

/// What to prove of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertifyOptions {
    /// The gap that is to be excluded, relative to the diameter of the attractor.
    pub within: f64,
    /// The most boxes to look at. On average no more than 1000 pairs of pieces are looked at in each: where it takes
    /// more, fewer boxes are looked at.
    pub budget: usize,
    /// Where the stretch begins and ends, as fractions of the length of the path in (u, v, w): what is beyond the path
    /// is left out. Where both are the same it is one moment.
    pub t0: f64,
    /// See `t0`.
    pub t1: f64,
}

impl Default for CertifyOptions {
    fn default() -> Self {
        Self { within: 1.0 / 600.0, budget: 4000, t0: 0.0, t1: 1.0 }
    }
}

/// What is proved of a stretch of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathCertificate {
    /// Proved: at no parameter of the stretch is the widest gap larger than this, relative to the diameter of the
    /// attractor there. 0 if all is proved connected, infinite where nothing could be proved.
    pub gap: f64,
    /// Whether that is no more than was asked for.
    pub holds: bool,
    /// The boxes that cover the stretch.
    pub boxes: usize,
    /// Where the least could be proved, as a fraction of the length of the whole path.
    pub worst: f64,
    /// Whether the question is answered: it holds, or it does not anywhere near `worst`, where the gap is known to be
    /// wider than asked for. Otherwise the budget was spent.
    pub complete: bool,
    /// How many joints of pieces the bound rests on: in a linear morph between two chains of pieces with the same ends
    /// they stay joined on the whole straight way ([`frond_core::joints`]). 0 where it rests on boxes.
    pub joints: usize,
}

impl CertifyOptions {
    /// What of the stretch lies on the path, from 0 to 1; `None` where it is none.
    #[must_use]
    pub fn stretch(&self) -> Option<(f64, f64)> {
        let Self { t0, t1, .. } = *self;
        // NaN is none of these.
        (t0 <= t1 && t0 <= 1.0 && t1 >= 0.0).then_some((t0.max(0.0), t1.min(1.0)))
    }
}

impl PathCertificate {
    /// What is proved of nothing.
    const NOTHING: Self =
        Self { gap: f64::INFINITY, holds: false, boxes: 0, worst: 0.0, complete: false, joints: 0 };
}

/// A piece of a leg, and what is proved of it.
#[derive(Clone, Copy, Debug)]
struct Segment {
    gap: f64,
    leg: usize,
    from: f64,
    to: f64,
    /// The part of the gap that comes of points moving over the segment: the rest stays when it is split.
    moving: f64,
    /// Whether it was looked at for long.
    deep: bool,
}

impl Segment {
    const fn new(leg: usize, from: f64, to: f64) -> Self {
        Self { gap: f64::INFINITY, leg, from, to, moving: 1.0, deep: false }
    }

    /// The widest gap first; of equal ones the longest.
    const fn ranked(self) -> Ranked<(Total, Total), Self> {
        Ranked { key: (Total(self.gap), Total(self.to - self.from)), item: self }
    }
}

/// Segments shorter than this part of a leg are not split: there numbers end.
const SHORTEST_SEGMENT: f64 = 1e-12;
/// A bound this near to what is known to be there is as good as it gets.
const TIGHT_RATIO: f64 = 1.1;
/// Where points move farther than this over a segment, no crossing is likely to last.
const LARGEST_STRAY: f64 = 0.1;
/// Where motion makes up less than this part of what bounds a gap, it is worth asking whether the gap is there; and
/// where hardly any, splitting the segment does not help: then it is looked at once more, for long.
const MOTION_SHARE_TO_ASK: f64 = 0.2;
const MOTION_SHARE_TO_LOOK_LONG: f64 = 0.02;
/// Pairs of words tried for a crossing of two maps.
const MOST_TRIES: usize = 150;
const FEWEST_TRIES: usize = 10;
/// Looks spent on each two maps where one looks for long.
const LOOKS_FOR_LONG: usize = 20_000;
/// Pairs of pieces looked at for each box of the budget, at most: so that it bounds the time.
const PAIRS_PER_BOX: usize = 1000;
/// Where they move less than this, it is worth looking long for points that are near.
const STRAY_TO_LOOK_LONG: f64 = 0.01;

/// Proves as small a bound as it can of the widest gap along a path through (u, v, w): it covers the path with
/// segments, each of which is decided as a whole, and splits the worst until the bound is within what is
/// asked for, no smaller one can be, or `budget` segments were looked at.
///
/// A segment is connected throughout by pieces that cross ([`crossings`](crate::crossings)), or bounded by pairs of
/// points that stay near each other. Both are proofs about all its parameters, with rounding reckoned with. Where the
/// shapes just touch, as at the end of many a morph, no segment is proved connected, and the bound shrinks with their
/// lengths. Where pieces stay joined end to end, that says more than any segment.
///
/// Nothing is proved of a path of no points, nor of what is no stretch of it: where `t0` is above `t1`, both are beyond
/// the same end of the path, or one is NaN. Then the gap is infinite.
#[must_use]
pub fn certify_path(morph: &Morph, points: &[DVec3], options: &CertifyOptions) -> PathCertificate {
    let Some((t0, t1)) = options.stretch().filter(|_| !points.is_empty()) else {
        return PathCertificate::NOTHING;
    };
    if let Some((gap, joints)) = joint_bound(morph, points).filter(|&(gap, _)| gap <= options.within) {
        return PathCertificate { gap, holds: true, boxes: 0, worst: t0, complete: true, joints };
    }
    let motions = Motions::of(morph);
    let legs: Vec<Leg<'_>> = match points {
        [] => Vec::new(),
        [at] => vec![Leg { morph, motions: &motions, from: *at, to: *at }],
        _ => points.windows(2).map(|p| Leg { morph, motions: &motions, from: p[0], to: p[1] }).collect(),
    };
    let lengths: Vec<f64> = legs.iter().map(|leg| leg.from.distance(leg.to)).collect();
    let total: f64 = lengths.iter().sum();
    if !total.is_finite() {
        return PathCertificate::NOTHING;
    }
    let mut work = Work {
        legs,
        within: options.within.max(0.0),
        least: 0.0,
        looks: 0,
        pairs: 0,
        tries: MOST_TRIES,
        scratch: Scratch::default(),
        descent: Descent::default(),
        maps: Vec::with_capacity(morph.len()),
    };
    let mut cover = BinaryHeap::new();
    let mut before = 0.0;
    let starts: Vec<f64> = lengths
        .iter()
        .map(|length| {
            let start = before;
            before += length;
            start
        })
        .collect();
    // The part of each leg that belongs to the stretch; one of no length is a point of those beside it.
    let part = |leg: usize, t: f64| {
        let length = lengths[leg];
        if length > 0.0 { ((t * total - starts[leg]) / length).clamp(0.0, 1.0) } else { 0.0 }
    };
    let parts = (0..lengths.len()).map(|leg| Segment::new(leg, part(leg, t0), part(leg, t1)));
    cover.extend(parts.filter(|part| part.from < part.to).map(|part| work.look(part).ranked()));
    if cover.is_empty() {
        // One moment, on the first leg that goes as far.
        let reaches = |&leg: &usize| t0 * total <= starts[leg] + lengths[leg];
        let leg = (0..lengths.len()).find(reaches).unwrap_or(lengths.len() - 1);
        cover.push(work.look(Segment::new(leg, part(leg, t0), part(leg, t0))).ranked());
    }
    let complete = work.shrink(&mut cover, options.budget);
    let Some(&Ranked { item: worst, .. }) = cover.peek() else { return PathCertificate::NOTHING };
    let at = starts[worst.leg] + lengths[worst.leg] * worst.from.midpoint(worst.to);
    PathCertificate {
        gap: worst.gap,
        holds: worst.gap.is_finite() && worst.gap <= work.within,
        boxes: cover.len(),
        worst: if total > 0.0 { at / total } else { t0 },
        complete: complete && worst.gap.is_finite(),
        joints: 0,
    }
}

struct Work<'a> {
    legs: Vec<Leg<'a>>,
    within: f64,
    /// Somewhere the relative gap is known to be at least this.
    least: f64,
    looks: usize,
    /// Pairs of pieces looked at.
    pairs: usize,
    /// Pairs of words to try for a crossing: fewer where none was found before, as where pieces just touch.
    tries: usize,
    scratch: Scratch,
    descent: Descent<3>,
    maps: Vec<Affine2>,
}

impl Work<'_> {
    /// Splits the worst segments; whether the question is answered.
    fn shrink(&mut self, cover: &mut BinaryHeap<Ranked<(Total, Total), Segment>>, budget: usize) -> bool {
        loop {
            let Some(&Ranked { item: worst, .. }) = cover.peek() else { return true };
            if worst.gap <= self.within {
                return true;
            }
            let Segment { leg, from, to, gap, moving, deep } = worst;
            if moving < MOTION_SHARE_TO_ASK {
                self.weigh(leg, from.midpoint(to));
                if self.least > self.within && gap <= TIGHT_RATIO * self.least {
                    return true;
                }
            }
            let stuck = moving < MOTION_SHARE_TO_LOOK_LONG && gap * (1.0 - moving) > self.within
                || to - from < SHORTEST_SEGMENT;
            let spent = self.looks + 2 > budget || self.pairs > budget.saturating_mul(PAIRS_PER_BOX);
            if spent || stuck && deep {
                return false;
            }
            cover.pop();
            if stuck {
                cover.push(self.look(Segment { deep: true, ..worst }).ranked());
                continue;
            }
            let middle = from.midpoint(to);
            for (from, to) in [(from, middle), (middle, to)] {
                cover.push(self.look(Segment { gap, ..Segment::new(leg, from, to) }).ranked());
            }
        }
    }

    /// Takes note of how wide the gap is at a point: that cannot be excluded.
    fn weigh(&mut self, leg: usize, x: f64) {
        let at = self.legs[leg].at(x);
        self.legs[leg].morph.fill3(at.x, at.y, at.z, &mut self.maps);
        let budget = LocusGrid::budget(self.maps.len());
        let known = decide_bounds(&self.maps, 1e-9_f64.max(0.1 * self.within), budget, &mut self.scratch);
        // Relative to the attractor itself a gap is wider than to what bounds it: this is on the safe side.
        self.least = self.least.max(known.lower);
    }

    /// Bounds the gap over a segment, no worse than it is known to be.
    fn look(&mut self, segment: Segment) -> Segment {
        self.looks += 1;
        let Segment { gap, leg, from, to, deep, .. } = segment;
        let extent = Extent::between(DVec2::new(from, 0.0), DVec2::new(to, 0.0));
        if !self.descent.begin(&self.legs[leg], extent, &mut self.scratch.frame) {
            return segment;
        }
        let (long, short) = Affine2::new(self.descent.lanes.from_round, DVec2::ZERO).singular_values();
        let unit = self.descent.diameter().0 * short / long * (1.0 - 1e-12);
        // The shorter the segment, the nearer points there may be that stay near.
        let stray = self.descent.lanes.stray();
        let effort = Effort {
            looks: if deep {
                LOOKS_FOR_LONG
            } else if stray < STRAY_TO_LOOK_LONG {
                2000
            } else {
                150
            },
            tries: if deep {
                MOST_TRIES
            } else if stray < LARGEST_STRAY {
                self.tries
            } else {
                0
            },
            near: 0.8 * self.within * unit,
        };
        let joined = self.descent.cross(f64::INFINITY, effort).is_some();
        if effort.tries > 0 {
            self.tries = if joined { MOST_TRIES } else { (self.tries / 2).max(FEWEST_TRIES) };
        }
        self.pairs += self.descent.nodes;
        let seen = if joined { 0.0 } else { self.descent.bottleneck() / unit };
        // NaN, of an attractor that may be a point, bounds nothing.
        let gap = if seen < gap { seen } else { gap };
        let moving = if stray < STRAY_TO_LOOK_LONG { 2.0 * stray / (unit * gap) } else { 1.0 };
        Segment { gap, moving, ..segment }
    }
}
