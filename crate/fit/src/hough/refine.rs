//! From the middle of a bin to the map itself, and the part of the graph on which it holds.

use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};

use super::pairing::Pairing;

/// A map that holds on a part of the graph.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Candidate {
    /// a, b, c, d, e of eq 1.
    pub map: [f64; 5],
    /// The part that it copies, well or at least roughly.
    pub domain: [f64; 2],
    /// Coarse feature points that it copies well.
    pub points: usize,
    /// Root mean square distance of the images of these from the fine feature points, in heights.
    pub rms: f64,
}

/// How far images may be from the graph, in half heights, as the map becomes better.
const FIT_DISTANCES: [f64; 4] = [0.16, 0.1, 0.06, 0.04];

/// A point this far off is worth nothing when maps are compared; a part with half of that is worth three quarters.
const WORTHLESS_DISTANCE: f64 = 0.03;

/// The part is given with what lies around it as long as images are this near: a copy of little is cheap there, too.
const CONTEXT_DISTANCE: f64 = 0.25;

/// The ends of the range are looked for so many fine points around.
const END_SEARCH_POINTS: isize = 3;

/// Coarse points that a part has at least.
const FEWEST_POINTS: usize = 5;

/// The map in the frame, and as it is given out.
pub(super) fn refine(pairing: &Pairing, start: [f64; 5]) -> Option<([f64; 5], Candidate)> {
    let (coarse, fine) = (pairing.coarse.points(), pairing.fine.points());
    let slack = 1.5 * (fine[1].x - fine[0].x);
    let image = |j: usize| start[0] * coarse[j].x + start[3];
    let (low, high) = (fine[0].x - slack, fine[fine.len() - 1].x + slack);
    let inside = |&j: &usize| image(j) >= low && image(j) <= high;
    let first = (0..coarse.len()).find(inside)?;
    let last = (0..coarse.len()).rev().find(inside)?;
    if last < first + FEWEST_POINTS - 1 {
        return None;
    }
    let shifted = |index: usize, by: isize| index.checked_add_signed(by).filter(|&i| i < fine.len());
    let ends = [first, last].map(|j| pairing.fine.nearest(image(j)));
    let mut best: Option<Fit> = None;
    for by in 0..(2 * END_SEARCH_POINTS + 1).pow(2) {
        let (left, right) = (
            by / (2 * END_SEARCH_POINTS + 1) - END_SEARCH_POINTS,
            by % (2 * END_SEARCH_POINTS + 1) - END_SEARCH_POINTS,
        );
        let (Some(l), Some(n)) = (shifted(ends[0], left), shifted(ends[1], right)) else { continue };
        let a = (fine[n].x - fine[l].x) / (coarse[last].x - coarse[first].x);
        let d = fine[l].x - a * coarse[first].x;
        let [quantum, .., quantum_d, _] = pairing.quanta();
        let off = ((a - start[0]).abs() / quantum).max((d - start[3]).abs() / (quantum + quantum_d));
        if !(a * start[0] > 0.0 && a.abs() < 1.0 - 1e-9 && off <= 2.0) {
            continue;
        }
        let Some(fit) = follow(pairing, [a, start[1], start[2], d, start[4]], [first, last]) else {
            continue;
        };
        if best.as_ref().is_none_or(|best| fit.worth() > best.worth()) {
            best = Some(fit);
        }
    }
    let Fit { map, run, points, rms } = best?;
    let domain = run.map(|j| pairing.frame.t(coarse[j].x));
    let candidate = Candidate { map: pairing.frame.out(map), domain, points, rms: 0.5 * rms };
    Some((map, candidate))
}

struct Fit {
    map: [f64; 5],
    run: [usize; 2],
    points: usize,
    rms: f64,
}

impl Fit {
    /// A long part is worth more than a short one, unless the map is sloppy there.
    fn worth(&self) -> f64 {
        self.points as f64 * (1.0 - (self.rms / WORTHLESS_DISTANCE).powi(2))
    }
}

/// Least squares on the longest part on which the map holds, again and again.
fn follow(pairing: &Pairing, mut map: [f64; 5], [first, last]: [usize; 2]) -> Option<Fit> {
    let (coarse, fine) = (pairing.coarse.points(), pairing.fine.points());
    let edge = 0.5 * (fine[1].x - fine[0].x);
    let (low, high) = (fine[0].x - edge, fine[fine.len() - 1].x + edge);
    let target = |map: &[f64; 5], j: usize| {
        let t = map[0] * coarse[j].x + map[3];
        (t >= low && t <= high).then(|| fine[pairing.fine.nearest(t)].y)
    };
    let rest = |map: &[f64; 5], j: usize| {
        let told = map[1] * coarse[j].x + map[2] * coarse[j].y + map[4];
        target(map, j).map_or(f64::INFINITY, |x| (x - told).abs())
    };
    let mut run = [first, last];
    for near in FIT_DISTANCES {
        run = longest(first, last, |j| rest(&map, j) <= near)?;
        if run[1] + 1 - run[0] < FEWEST_POINTS {
            return None;
        }
        let rows = (run[0]..=run[1]).filter_map(|j| Some((coarse[j].x, coarse[j].y, target(&map, j)?)));
        let [b, c, e] = solve(rows)?;
        (map[1], map[2], map[4]) = (b, c, e);
    }
    if map[2].abs() >= 1.0 {
        return None;
    }
    let points = run[1] + 1 - run[0];
    let squares: f64 = (run[0]..=run[1]).map(|j| rest(&map, j).powi(2)).sum();
    let rms = (squares / points as f64).sqrt();
    while run[0] > first && rest(&map, run[0] - 1) <= CONTEXT_DISTANCE {
        run[0] -= 1;
    }
    while run[1] < last && rest(&map, run[1] + 1) <= CONTEXT_DISTANCE {
        run[1] += 1;
    }
    rms.is_finite().then_some(Fit { map, run, points, rms })
}

/// The first of the longest runs.
fn longest(first: usize, last: usize, holds: impl Fn(usize) -> bool) -> Option<[usize; 2]> {
    let (mut best, mut begun): (Option<[usize; 2]>, Option<usize>) = (None, None);
    for j in first..=last {
        if !holds(j) {
            begun = None;
            continue;
        }
        let from = *begun.get_or_insert(j);
        if best.is_none_or(|[a, b]| j - from > b - a) {
            best = Some([from, j]);
        }
    }
    best
}

/// b, c, e that take b t + c x + e nearest to y.
fn solve(rows: impl Iterator<Item = (f64, f64, f64)>) -> Option<[f64; 3]> {
    let (mut normal, mut right) = (DMat3::ZERO, DVec3::ZERO);
    for (t, x, y) in rows {
        let row = DVec3::new(t, x, 1.0);
        normal += DMat3::from_cols(row * t, row * x, row);
        right += row * y;
    }
    let size = normal.x_axis.x * normal.y_axis.y * normal.z_axis.z;
    (normal.determinant() > 1e-9 * size).then(|| (normal.inverse() * right).to_array())
}
