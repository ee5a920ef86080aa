//! Systems whose maps share one linear part.

use std::ops::{ControlFlow, Range};

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::gap::pair_descent::{Explore, Pair, Sight};
use crate::gap::piece_distance::Metric;
use crate::gap::trails::Step;
use crate::support::extremes::{larger, lesser};
use crate::support::f64x4::DVec2x4;
use crate::support::table::SupportTable;

/// The differences of the pieces of maps `M x + t_i`.
///
/// Two pieces at the same depth are translates of each other, so that all there is to know of them is by how much
/// they are moved: `A_i` and `A_j` are as far apart as `t_i - t_j` is from `M D`, where `D`, the set of all
/// differences of two points of the attractor, is itself an attractor: that of the maps `M x + t_a - t_b`. So a
/// descent follows one point instead of two words, and most words of a length share their point with others. The
/// supports of `D` are sums: its convex hull is that of the sum of the widths of all images of the translations.
#[derive(Clone, Debug, Default)]
pub(crate) struct DifferenceSet {
    /// Whether the linear part is a similitude, or nearly.
    round: bool,
    /// The powers of the linear part, from 0.
    powers: Vec<DMat2>,
    /// Their norms, at most.
    sizes: Vec<f64>,
    /// The differences of two translations, each once, four by four; those left over repeat the last.
    steps: Vec<DVec2x4>,
    /// How many there are.
    count: usize,
    /// The points of the descent.
    nodes: Vec<Node>,
    shifts: Vec<DVec2>,
    sorted: Vec<DVec2>,
    passed: Vec<(DVec2, usize, usize)>,
    /// The steps to where the search is.
    trail: Vec<Step>,
}

/// A point of the descent.
#[derive(Clone, Copy, Debug)]
struct Node {
    at: DVec2,
    /// The power that the next step is taken by.
    power: u32,
    /// The point before it, itself if it is the first, and the step from there.
    before: u32,
    step: u16,
}

/// More than this many powers are not summed up exactly.
const MOST_TERMS: usize = 96;
/// What is left out of the sums, against the whole.
const LARGEST_REST: f64 = 0.004;
/// How far from the middle of the differences to go on a greedy descent, against the disc they lie in, squared; how
/// often back, and how many steps.
const SQUARE_TO_ENTER: f64 = 0.7;
/// The same for a step that led to near points of another system: these are known to have been there.
const SQUARE_TO_FOLLOW: f64 = 1.0;
const MOST_RETURNS: usize = 12;
const MOST_STEPS: usize = 120;
/// How many of its last steps are gone back where the way to near points of another system is followed, and how many
/// steps are tried from there.
const STEPS_BACK: usize = 3;
const STEPS_FROM_TRAIL: usize = 40;

/// Of more maps there are too many differences to look at them all.
const MOST_MAPS: usize = 16;

/// Whether the maps share one linear part, and are few.
pub(crate) fn are_equal(maps: &[Affine2]) -> bool {
    (2..=MOST_MAPS).contains(&maps.len()) && maps[1..].iter().all(|map| map.linear == maps[0].linear)
}

/// Whether any two of these maps, which share one linear part, have pieces that meet: see [`area`].
pub(crate) fn fill(map: &Affine2) -> bool {
    area(map) >= 0.5
}

/// By how much a map shrinks areas, at least.
///
/// Where those of two maps add up to 1 or more, their pieces meet: were they apart, a small enough neighbourhood
/// of the attractor of these two alone would hold its two disjoint images and more.
pub(crate) fn area(map: &Affine2) -> f64 {
    let [a, b, c, d, ..] = map.to_row();
    let (ad, bc) = (a * d, b * c);
    // Each product and their difference are off by half an ulp, and so may be a sum of two areas.
    (ad - bc).abs() - 4.0 * f64::EPSILON * (ad.abs() + bc.abs())
}

impl DifferenceSet {
    /// Gets ready for the maps of a frame, which share one linear part and contract one by one.
    ///
    /// Of a regular polygon with an even number of corners every other difference is known to repeat another.
    pub fn set(&mut self, frame: &Frame, polygon: bool) {
        let m = frame.maps[0].linear;
        self.round = frame.factor * frame.factor - m.determinant().abs() < 1e-3;
        self.powers.clear();
        self.sizes.clear();
        self.powers.push(DMat2::IDENTITY);
        self.sizes.push(1.0);
        self.shifts.clear();
        self.shifts.extend(frame.maps.iter().map(|map| map.translation));
        self.set_steps(polygon);
        self.nodes.clear();
    }

    /// Bounds the differences, and the points that reach far among them.
    pub fn bound(&mut self, frame: &Frame, support: &mut SupportTable) {
        let m = frame.maps[0].linear;
        // The attractor lies in the unit disc, its differences in that of radius 2.
        let mut terms = 1;
        while terms < MOST_TERMS && 2.0 * self.size(terms, m, frame.factor) > LARGEST_REST {
            terms += 1;
        }
        let rest = 2.0 * self.size(terms, m, frame.factor) * (1.0 + 1e-12);
        support.set_differences(&self.powers[..terms], &self.shifts, rest);
    }

    /// An upper bound of the norm of power `k`, which is computed if it was not.
    fn size(&mut self, k: usize, m: DMat2, factor: f64) -> f64 {
        while self.powers.len() <= k {
            let last = self.powers.len() - 1;
            let power = self.powers[last] * m;
            self.powers.push(power);
            let size = self.sizes[last] * factor;
            // Of a similitude the norms are powers, too.
            let norm =
                if self.round { size } else { Affine2::new(power, DVec2::ZERO).norm() * (1.0 + 1e-12) };
            self.sizes.push(lesser(size, norm));
        }
        self.sizes[k]
    }

    fn set_steps(&mut self, polygon: bool) {
        let Self { shifts, sorted, steps, count, .. } = self;
        sorted.clear();
        sorted.push(DVec2::ZERO);
        let sides = shifts.len();
        let opposite = |i: usize| (i + sides / 2) % sides;
        let repeats =
            |i: usize, j: usize| polygon && sides.is_multiple_of(2) && (opposite(j), opposite(i)) < (i, j);
        for (i, a) in shifts.iter().enumerate() {
            for (j, b) in shifts.iter().enumerate() {
                if i != j && !repeats(i, j) {
                    sorted.push(*a - *b);
                }
            }
        }
        if sides > 2 && !polygon {
            sorted.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
            sorted.dedup();
        }
        *count = sorted.len();
        steps.clear();
        steps.extend(sorted.chunks(4).map(|four| {
            let lane = |k: usize| four[k.min(four.len() - 1)];
            let four = [lane(0), lane(1), lane(2), lane(3)];
            DVec2x4::new(four)
        }));
    }

    /// The square of a distance that the attractor has at least across, in the plane: between images of one point.
    pub fn extent(&self, frame: &Frame) -> f64 {
        self.sorted.iter().map(|&d| frame.square(d)).fold(0.0, larger)
    }

    /// The square of the distance in the plane of two points of pieces `i` and `j`, if it was found to be `reach` or
    /// less: always on to where the difference is least.
    pub fn meet(&mut self, frame: &Frame, i: usize, j: usize, reach: f64) -> Option<f64> {
        self.trail.clear();
        self.search(frame, self.shifts[i] - self.shifts[j], reach, MOST_STEPS)
    }

    /// The way to the points that were found last.
    pub fn trail(&self) -> &[Step] {
        &self.trail
    }

    /// The way to a point of the descent, for [`DifferenceSet::follow`].
    pub fn way(&self, mut node: u32) -> Vec<Step> {
        let mut way = Vec::new();
        while let Some(&Node { before, step, .. }) = self.nodes.get(node as usize)
            && before != node
        {
            way.push(Step { part: step, large: 0 });
            node = before;
        }
        way.reverse();
        way
    }

    /// [`DifferenceSet::meet`], from near where the way to such points of a neighbouring system leads.
    pub fn follow(&mut self, frame: &Frame, i: usize, j: usize, reach: f64, trail: &[Step]) -> Option<f64> {
        let m = frame.maps[0].linear;
        let mut offset = self.shifts[i] - self.shifts[j];
        // The last ones, as a ring.
        let mut offsets = [offset; STEPS_BACK + 1];
        self.trail.clear();
        for &step in trail {
            // Of other maps there may be fewer.
            if usize::from(step.part) >= self.count {
                break;
            }
            let k = self.trail.len() + 1;
            let limit = SQUARE_TO_FOLLOW * self.square_of_rest(k, m, frame.factor);
            offset = self.step(offset, k, step.part.into());
            if offset.length_squared() >= limit {
                break;
            }
            self.trail.push(step);
            offsets[self.trail.len() % (STEPS_BACK + 1)] = offset;
        }
        // The last steps may lead astray.
        let start = self.trail.len().saturating_sub(STEPS_BACK);
        self.trail.truncate(start);
        self.search(frame, offsets[start % (STEPS_BACK + 1)], reach, STEPS_FROM_TRAIL)
    }

    /// How long, squared, the sum of all steps after step `k` may be.
    #[inline(always)]
    fn square_of_rest(&mut self, k: usize, m: DMat2, factor: f64) -> f64 {
        // The differences lie within twice the norm of the power.
        let rest = 2.0 * self.size(k + 1, m, factor);
        rest * rest
    }

    /// Goes on from where the trail leads.
    fn search(&mut self, frame: &Frame, mut offset: DVec2, reach: f64, steps: usize) -> Option<f64> {
        let m = frame.maps[0].linear;
        self.passed.clear();
        let mut back = 0;
        for _ in 0..steps {
            let squared = frame.square(offset);
            // 0 is the difference of any point from itself.
            if squared <= reach {
                return Some(squared);
            }
            let mut k = self.trail.len() + 1;
            let limit = SQUARE_TO_ENTER * self.square_of_rest(k, m, frame.factor);
            let (best, second) = self.nearest_steps(k, offset);
            if second.0 < limit {
                self.passed.push((offset, k, second.1));
            }
            let next = if best.0 < limit {
                best.1
            } else {
                back += 1;
                let (passed, at, step) = self.passed.pop().filter(|_| back <= MOST_RETURNS)?;
                self.trail.truncate(at - 1);
                (offset, k) = (passed, at);
                step
            };
            offset = self.step(offset, k, next);
            self.trail.push(Step { part: next as u16, large: 0 });
        }
        None
    }

    fn step(&self, offset: DVec2, k: usize, step: usize) -> DVec2 {
        offset + self.powers[k] * self.steps[step / 4].at(step % 4)
    }

    /// The squares of the two least lengths after a step, and the steps.
    #[inline(always)]
    fn nearest_steps(&self, k: usize, offset: DVec2) -> ((f64, usize), (f64, usize)) {
        let (mut best, mut second) = ((f64::INFINITY, 0), (f64::INFINITY, 0));
        for (block, &step) in self.steps.iter().enumerate() {
            let next = after(self.powers[k], offset, step);
            let squares = next.dot(next);
            for (l, &square) in squares.to_array().iter().enumerate().take(self.count - 4 * block) {
                let this = (square, 4 * block + l);
                if square < best.0 {
                    (best, second) = (this, best);
                } else if square < second.0 {
                    second = this;
                }
            }
        }
        (best, second)
    }
}

/// Where four steps lead.
#[inline(always)]
fn after(power: DMat2, offset: DVec2, step: DVec2x4) -> DVec2x4 {
    let (x, y, o) = (DVec2x4::splat(power.x_axis), DVec2x4::splat(power.y_axis), DVec2x4::splat(offset));
    DVec2x4 { x: o.x + x.x * step.x + y.x * step.y, y: o.y + x.y * step.x + y.y * step.y }
}

/// A descent on [`DifferenceSet`].
pub(crate) struct Translates<'a> {
    frame: &'a Frame,
    support: &'a SupportTable,
    differences: &'a mut DifferenceSet,
    small: f64,
    metric: Metric,
}

impl<'a> Translates<'a> {
    /// `diameter` is that of the attractor in the frame.
    pub fn new(
        frame: &'a Frame,
        support: &'a SupportTable,
        differences: &'a mut DifferenceSet,
        resolution: f64,
        diameter: f64,
    ) -> Self {
        // Both pieces are as large, and where rounding is coarser than the resolution, nothing is small.
        let visible = frame.rounding * frame.stretch <= resolution;
        let small = if visible { 0.5 * resolution / (frame.stretch * diameter) } else { -1.0 };
        Self { frame, support, differences, small, metric: Metric::default() }
    }
}

impl Explore for Translates<'_> {
    type Nearest = ();

    fn choose_metric(&mut self, to_measure: bool) {
        self.metric =
            if to_measure { Metric::to_measure(self.frame) } else { Metric::to_separate(self.frame) };
    }

    fn first(&mut self, i: u32, others: Range<u32>, mut see: impl FnMut(u32, Sight<()>)) {
        let shifts = &self.differences.shifts;
        let offset = |j: u32| shifts[i as usize] - shifts[j as usize];
        let lanes = [0, 1, 2, 3].map(|k| offset((others.start + k).min(others.end - 1)));
        let offsets = DVec2x4::new(lanes);
        self.differences.size(1, self.frame.maps[0].linear, self.frame.factor);
        let looks = self.metric.differences(self.support, self.differences.powers[1], offsets);
        for (k, j) in others.enumerate() {
            see(j, looks.sight(k));
        }
    }

    fn root(&mut self, i: u8, j: u8) -> (u32, u32) {
        let DifferenceSet { nodes, shifts, .. } = &mut *self.differences;
        let (at, before) = (shifts[usize::from(i)] - shifts[usize::from(j)], nodes.len() as u32);
        nodes.push(Node { at, power: 1, before, step: 0 });
        (before, 0)
    }

    fn is_small(&self, pair: &Pair) -> bool {
        let power = self.differences.nodes[pair.u as usize].power;
        self.differences.sizes[power as usize] <= self.small
    }

    fn split(&mut self, pair: &Pair, mut see: impl FnMut(u32, u32, Sight<()>) -> ControlFlow<()>) {
        let Node { at: offset, power: k, .. } = self.differences.nodes[pair.u as usize];
        self.differences.size(k as usize + 1, self.frame.maps[0].linear, self.frame.factor);
        let (power, next) = (self.differences.powers[k as usize], self.differences.powers[k as usize + 1]);
        for block in 0..self.differences.steps.len() {
            let offsets = after(power, offset, self.differences.steps[block]);
            let looks = self.metric.differences(self.support, next, offsets);
            for l in 0..4.min(self.differences.count - 4 * block) {
                let node = self.differences.nodes.len() as u32;
                let (at, step) = (offsets.at(l), (4 * block + l) as u16);
                self.differences.nodes.push(Node { at, power: k + 1, before: pair.u, step });
                if see(node, 0, looks.sight(l)).is_break() {
                    return;
                }
            }
        }
    }
}
