//! Plain polylines within so many bytes: what a fit is compared with, and what it begins with.

use glam::DVec2;

use super::contest::Contest;
use super::pack::kept_grid;
use super::{MAX_NODES, Node, Spline};
use crate::fitting::Straight;
use crate::outline::{Outline, corners, turn};

/// How many bits a corner may take, all bytes shared out: each makes another number of corners.
const CORNER_BITS: [f64; 6] = [6.5, 7.5, 8.5, 9.5, 11.0, 13.0];

/// Few corners that are tried as well.
const FEW_CORNERS: [usize; 6] = [3, 4, 6, 9, 12, 16];

/// An outline's own corners are tried where each has so many bits.
const LEAST_BITS: f64 = 2.0;

/// Grids, from coarse to fine: how many parts of the diagonal the first is, and how many are tried, each finer than the
/// one before by a root of two.
const COARSEST: f64 = 12.0;
const GRIDS: i32 = 28;

/// The same for an outline's own corners, which are exact once the grid is fine enough.
const OWN_GRIDS: i32 = 36;

/// How many grids are tried within an octave to each side of the finest that holds a polyline.
const NEAR_GRIDS: i32 = 16;

/// How many grids of whole powers of two are tried.
const WHOLE_GRIDS: i32 = 16;

/// Polylines of several numbers of corners by least squares, each on several grids, one after the other.
#[derive(Clone, Debug)]
pub struct Polylines {
    /// The numbers of corners that are left, the last first, and how many there were.
    counts: Vec<usize>,
    many: usize,
    straight: Option<Box<Straight>>,
    /// A polyline, and the grids that are left for it.
    corners: Vec<DVec2>,
    grids: Vec<f64>,
    /// Whether it is the outline itself.
    own: bool,
    relaxed: bool,
}

impl Polylines {
    /// Those of the contest's outline within its bytes.
    pub fn new(contest: &Contest) -> Self {
        let mut polylines = Self {
            counts: counts(contest),
            many: 0,
            straight: None,
            corners: Vec::new(),
            grids: Vec::new(),
            own: false,
            relaxed: false,
        };
        polylines.many = polylines.counts.len();
        // What an outline of few corners is itself.
        let most = (contest.free_bits() / LEAST_BITS) as usize;
        let own = corners(contest.outline(), most)
            .unwrap_or_else(|| without_idle(contest.outline().points().to_vec()));
        if (3..=most).contains(&own.len()) {
            polylines.own = true;
            polylines.put_on_grids(own, contest, OWN_GRIDS);
        }
        polylines
    }

    /// About how far it is, from 0 to 1.
    pub fn share(&self) -> f64 {
        let begun = self.straight.as_ref().map_or(0.0, |straight| 0.8 * straight.share());
        let shown = if self.grids.is_empty() { 0.0 } else { 0.9 };
        1.0 - (self.counts.len() as f64 + 1.0 - begun.max(shown)) / (self.many as f64 + 1.0)
    }

    /// One step; false where there is nothing more to do.
    pub fn step(&mut self, contest: &mut Contest) -> bool {
        if contest.is_exact() {
            return false;
        }
        if let Some(grid) = self.grids.pop() {
            contest.show(on_grid(&self.corners, grid));
        } else if std::mem::take(&mut self.own) && contest.is_enough() {
            return false;
        } else if let Some(straight) = &mut self.straight {
            if !straight.step() {
                let corners = straight.kept().knots;
                self.straight = None;
                self.put_on_grids(corners, contest, GRIDS);
            }
        } else if let Some(count) = self.counts.pop() {
            let straight = Straight::new(contest.outline(), count, contest.guard().cloned());
            self.straight = Some(Box::new(straight));
        } else if !self.relaxed && contest.relax() {
            // So few bytes may not follow the outline to where it meets itself.
            (self.relaxed, self.counts) = (true, counts(contest));
        } else {
            return false;
        }
        true
    }

    /// Chooses the grids for a polyline.
    fn put_on_grids(&mut self, corners: Vec<DVec2>, contest: &Contest, many: i32) {
        let diagonal = contest.outline().diagonal();
        let fits = |grid: &f64| contest.fits(&on_grid(&corners, *grid));
        let grids = (0..many).map(|i| diagonal / COARSEST * 0.5_f64.powf(f64::from(i) / 2.0));
        let mut chosen = Vec::new();
        if let Some(finest) = grids.take_while(fits).last() {
            // Around the finest that fits: where corners come to lie is as good as chance.
            let near = (-NEAR_GRIDS..=NEAR_GRIDS).map(|k| f64::from(k) / f64::from(NEAR_GRIDS));
            chosen.extend(near.map(|octaves| finest * octaves.exp2()));
            let whole = finest.log2().floor();
            chosen.extend([whole - 1.0, whole, whole + 1.0].map(f64::exp2));
        }
        // Drawings lie on grids of their own. There steps are alike, and take fewer bytes than on coarser ones.
        let mut whole = (0..WHOLE_GRIDS).map(|i| (diagonal.log2().floor() - f64::from(i)).exp2());
        chosen.extend(whole.rfind(fits));
        chosen.extend(unit(contest.outline().points()));
        (self.corners, self.grids) = (corners, chosen);
    }
}

/// The nearest polyline that is found within so many bytes, in the form of all curves here.
pub(crate) fn nearest_polyline(outline: &Outline, bytes: usize) -> Option<Spline> {
    let mut contest = Contest::new(outline, bytes);
    let mut polylines = Polylines::new(&contest);
    while polylines.step(&mut contest) {}
    contest.best().map(|(spline, _)| spline.clone())
}

/// The numbers of corners to try, in rising order.
fn counts(contest: &Contest) -> Vec<usize> {
    let bits = 8.0 * contest.budget() as f64;
    let most = contest.outline().points().len().min(MAX_NODES);
    let mut counts: Vec<usize> =
        FEW_CORNERS.into_iter().chain(CORNER_BITS.map(|each| (bits / each) as usize)).collect();
    counts.retain(|&count| (3..=most).contains(&count));
    counts.sort_unstable();
    counts.dedup();
    counts
}

/// The polygon of these corners on a grid, without those that say nothing there.
fn on_grid(corners: &[DVec2], grid: f64) -> Spline {
    let grid = kept_grid(grid);
    let places = without_idle(corners.iter().map(|p| (*p / grid).round()).collect());
    Spline { nodes: places.into_iter().map(|at| Node { at, on: true }).collect(), grid }
}

/// A closed line without points that are repeated or that lie on the straight way between their neighbours.
fn without_idle(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    let mut kept: Vec<DVec2> = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        let after = points[(i + 1) % points.len()];
        let before = kept.last().or(points.last()).copied().unwrap_or(p);
        if turn(before, p, after) != 0 || (p - before).dot(after - p) <= 0.0 {
            kept.push(p);
        }
    }
    kept
}

/// The shortest step along an axis: the width of the grid that a drawing was made on.
fn unit(points: &[DVec2]) -> Option<f64> {
    let steps = points.windows(2).flat_map(|w| (w[1] - w[0]).abs().to_array());
    steps.filter(|&step| step > 0.0).min_by(f64::total_cmp)
}
