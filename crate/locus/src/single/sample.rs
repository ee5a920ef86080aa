//! One sample in f32. Shader twin: the last part of crate/render/shader/locus.wgsl.

use glam::{Vec2, Vec4};

use super::SingleMap;
use super::descent::{Descent, End, MAX_MAPS, Pair};
use super::fan::{Fan, Map, ULP, image, norm};
use crate::decide::{Sample, State};

/// Maps must contract by this in the plane's own norm.
const PLAIN: f32 = 0.97;
/// Rounds of lowering the support values at most.
const ROUNDS: usize = 48;
/// Looks spent at most on the verdict, and on measuring a gap after it.
const LOOKS: u32 = 3000;
const SHADING: u32 = 400;
/// How near to each other the bounds of a gap shall come.
const SHADE: f32 = 0.95;
/// Pairs of maps.
const PAIRS: usize = MAX_MAPS * (MAX_MAPS - 1) / 2;
/// Further away than anything.
const FAR: f32 = 1e9;

/// What is known of two attractorlets.
#[derive(Clone, Copy, Debug, Default)]
struct Edge {
    /// The square of the least distance known of two points.
    reach: f32,
    /// A lower bound of the distance.
    lower: f32,
    /// How deep the two overlap: what is looked into first.
    overlap: f32,
    /// One of the below.
    state: u32,
}

const OPEN: u32 = 0;
const APART: u32 = 1;
const MET: u32 = 2;
const UNKNOWN: u32 = 3;
const MEASURED: u32 = 4;

/// The system of a sample, in its frame: the attractor lies in the unit disc.
///
/// # Margin
///
/// Let `e` be [`ULP`], `s` the contraction factor, and `o` the origin and `r` the radius of the frame, which are
/// exact by definition. The maps of the frame are off by `d`: what they were given with, and for the translation
/// `(M o + t - o) / r` the rounding of two products and three sums, at most `5 e (|M o| + |t| + |o|) / r`, and
/// of a division, `2.5 e |t'|`. An attractor whose maps are off by `d` in the unit disc is off by at most
/// `d / (1 - s)`, and so is each piece of it: twice that for the distance of two pieces.
///
/// The step between the middles of a pair begins as a difference of two translations, each at most `1 - s` long since
/// `r` is chosen so. Each split adds `M t_i`. After `k` splits of one piece `M` is off by at most `4 k e s^k` (each
/// product of matrices adds two roundings a product, over the absolute values of the entries, which is twice
/// the product of the norms), which sums up to `4 e s / (1 - s)` on each side; the products with `t_i` and
/// their sums add `3 e` on each side, and the subtractions, where the step is no longer than both pieces together,
/// `4 e s / (1 - s)`. The support values are raised by their own error ([`Fan::new`]), and the products of a look are
/// off by `6 e` at most. In all `e (16 + 12 s / (1 - s))`; a quarter is added.
struct System {
    count: usize,
    maps: [Map; MAX_MAPS],
    factor: f32,
    margin: f32,
    /// The most that a matrix was given with.
    given: f32,
}

impl System {
    /// `None` where the maps do not contract in the plane's own norm, or nothing can be told apart.
    fn new(columns: &[SingleMap], rows: &[SingleMap]) -> Option<Self> {
        let count = columns.len();
        let mut maps = [Map::default(); MAX_MAPS];
        let mut mean = Map::default();
        let mut factor = 0.0_f32;
        let mut given = 0.0_f32;
        for i in 0..count {
            let (c, r) = (columns[i], rows[i]);
            let linear = Vec4::new(c[0] + r[0], c[1] + r[1], c[2] + r[2], c[3] + r[3]);
            let shift = Vec2::new(c[4] + r[4], c[5] + r[5]);
            maps[i] = Map { linear, shift };
            mean.linear += linear;
            mean.shift += shift;
            factor = factor.max(norm(linear) * (1.0 + 16.0 * ULP) + (c[6] + r[6]));
            given = given.max(c[6] + r[6]);
        }
        if factor >= PLAIN {
            return None;
        }
        // The fixed point of the mean of the maps; it need not be exact.
        let share = 1.0 / count as f32;
        let m = mean.linear * share;
        let t = mean.shift * share;
        let determinant = (1.0 - m.x) * (1.0 - m.w) - m.y * m.z;
        let origin = Vec2::new((1.0 - m.w) * t.x + m.y * t.y, m.z * t.x + (1.0 - m.x) * t.y) / determinant;
        let far = origin.dot(origin).sqrt();
        // Translations about that point, and how far they may be off.
        let mut widest = 0.0_f32;
        let mut off = 0.0_f32;
        for i in 0..count {
            let (c, r) = (columns[i], rows[i]);
            let map = &mut maps[i];
            let size = map.shift.dot(map.shift).sqrt();
            // A matrix of absolute values may stretch by the root of two more.
            off = off.max((c[6] + r[6]) * far + (c[7] + r[7]) + 5.0 * ULP * (2.5 * far + size));
            map.shift = image(map.linear, origin) + map.shift - origin;
            widest = widest.max(map.shift.dot(map.shift).sqrt());
        }
        let rest = 1.0 - factor;
        let radius = (widest * (1.0 + 16.0 * ULP) + off) / rest * (1.0 + 16.0 * ULP);
        if radius <= 1e-12 {
            return None;
        }
        for map in &mut maps[..count] {
            map.shift /= radius;
        }
        let error = given + off / radius + 3.0 * ULP * rest;
        let margin = 2.0 * error / rest + ULP * (20.0 + 15.0 * factor / rest);
        if margin < COARSE { Some(Self { count, maps, factor, margin, given }) } else { None }
    }

    /// Whether the areas of two maps leave no room between the pieces; `None` where f32 cannot tell.
    fn areas_fill(&self) -> Option<bool> {
        let area = |m: Vec4| (m.x * m.w - m.y * m.z).abs();
        let spare = area(self.maps[0].linear) + area(self.maps[1].linear) - 1.0;
        let slack = 16.0 * ULP + 16.0 * self.given;
        if spare >= slack {
            Some(true)
        } else if spare < -slack {
            Some(false)
        } else {
            None
        }
    }
}

/// With a wider margin nothing worth knowing would be found.
const COARSE: f32 = 0.01;

const UNDECIDED: Sample = Sample { state: State::Undecided, gap: 0.0 };

/// The answer for the maps that are sums of the columns' and the rows', and the number of looks it took.
pub(super) fn decide(columns: &[SingleMap], rows: &[SingleMap], epsilon: f32) -> (Sample, u32) {
    let Some(system) = System::new(columns, rows) else { return (UNDECIDED, 0) };
    let count = system.count;
    if count == 1 {
        return (Sample { state: State::Connected, gap: 0.0 }, 0);
    }
    if count == 2 {
        match system.areas_fill() {
            Some(true) => return (Sample { state: State::Connected, gap: 0.0 }, 0),
            None => return (UNDECIDED, 0),
            Some(false) => {}
        }
    }
    let maps = &system.maps[..count];
    let fan = Fan::new(maps, fixed_point(&maps[0]), 0.03 * (1.0 - system.factor), ROUNDS);
    let diameter = fan.diameter();
    let resolution = epsilon * diameter;
    let mut descent = Descent {
        maps,
        fan,
        margin: system.margin,
        resolution,
        small: epsilon,
        looks: 0,
        reach: FAR,
        lower: 0.0,
    };
    let mut edges = [Edge::default(); PAIRS];
    let mut groups = Groups::new(count);
    first_looks(&mut descent, &mut edges, &mut groups);
    settle(&mut descent, &mut edges, &mut groups);
    if groups.whole(count) {
        return (Sample { state: State::Touching, gap: 0.0 }, descent.looks);
    }
    let mut coarsest = groups;
    each_pair(count, |k, i, j| {
        if edges[k].state == UNKNOWN || edges[k].state == OPEN {
            coarsest.join(i, j);
        }
    });
    if coarsest.whole(count) {
        return (UNDECIDED, descent.looks);
    }
    let gap = measure(&mut descent, &mut edges, groups);
    (Sample { state: State::Disconnected, gap: gap / diameter }, descent.looks)
}

/// The point that a map of the frame leaves where it is.
fn fixed_point(map: &Map) -> Vec2 {
    let (m, t) = (map.linear, map.shift);
    let determinant = (1.0 - m.x) * (1.0 - m.w) - m.y * m.z;
    Vec2::new((1.0 - m.w) * t.x + m.y * t.y, m.z * t.x + (1.0 - m.x) * t.y) / determinant
}

/// The pairs `i < j` with their numbers.
fn each_pair(count: usize, mut visit: impl FnMut(usize, usize, usize)) {
    let mut k = 0;
    for i in 0..count {
        for j in i + 1..count {
            visit(k, i, j);
            k += 1;
        }
    }
}

/// Which attractorlets are in one component: for each of them the set of all in its component.
#[derive(Clone, Copy)]
struct Groups([u32; MAX_MAPS]);

impl Groups {
    fn new(count: usize) -> Self {
        let mut sets = [0; MAX_MAPS];
        for (i, set) in sets[..count].iter_mut().enumerate() {
            *set = 1 << i;
        }
        Self(sets)
    }

    fn join(&mut self, i: usize, j: usize) {
        let both = self.0[i] | self.0[j];
        for k in 0..MAX_MAPS {
            if both >> k & 1 == 1 {
                self.0[k] = both;
            }
        }
    }

    fn joined(&self, i: usize, j: usize) -> bool {
        self.0[i] >> j & 1 == 1
    }

    fn whole(&self, count: usize) -> bool {
        self.0[0] == (1 << count) - 1
    }
}

fn root(maps: &[Map], i: usize, j: usize) -> Pair {
    Pair { a: maps[i].linear, b: maps[j].linear, step: maps[j].shift - maps[i].shift }
}

/// Looks at every pair once.
fn first_looks(descent: &mut Descent, edges: &mut [Edge; PAIRS], groups: &mut Groups) {
    let maps = descent.maps;
    each_pair(maps.len(), |k, i, j| {
        let seen = descent.look(&root(maps, i, j));
        descent.looks += 1;
        let touching = descent.touch(seen.reach);
        if touching {
            groups.join(i, j);
        }
        let state = if touching {
            MET
        } else if seen.apart > 0.0 {
            APART
        } else {
            OPEN
        };
        edges[k] = Edge { reach: seen.reach, lower: seen.apart, overlap: seen.overlap, state };
    });
}

/// Descends on the pairs that may meet, those that overlap most first, until all pieces are in one component or none of
/// these pairs is left.
fn settle(descent: &mut Descent, edges: &mut [Edge; PAIRS], groups: &mut Groups) {
    let maps = descent.maps;
    let count = maps.len();
    while !groups.whole(count) {
        let mut best = (PAIRS, 0, 0);
        let mut least = FAR;
        each_pair(count, |k, i, j| {
            if edges[k].state == OPEN && !groups.joined(i, j) && edges[k].overlap < least {
                least = edges[k].overlap;
                best = (k, i, j);
            }
        });
        let (k, i, j) = best;
        if k == PAIRS {
            return;
        }
        descent.reach = edges[k].reach;
        let end = descent.descend(root(maps, i, j), 0.0, LOOKS);
        edges[k].reach = descent.reach;
        match end {
            End::Met => {
                edges[k].state = MET;
                groups.join(i, j);
            }
            End::Apart => {
                edges[k].state = APART;
                edges[k].lower = descent.lower;
            }
            End::Unknown => edges[k].state = UNKNOWN,
        }
    }
}

/// The widest gap, in the frame: the middle of a lower and an upper bound of the widest edge of the least spanning tree.
fn measure(descent: &mut Descent, edges: &mut [Edge; PAIRS], groups: Groups) -> f32 {
    let maps = descent.maps;
    let limit = descent.looks + SHADING;
    let mut above;
    loop {
        above = widest(maps.len(), edges, groups, false);
        // A pair that may come nearer than is known, and so narrow the gap.
        let mut best = (PAIRS, 0, 0);
        let mut least = FAR;
        each_pair(maps.len(), |k, i, j| {
            let edge = &edges[k];
            let loose = edge.state == APART && edge.lower < SHADE * edge.reach.sqrt().min(above);
            if loose && edge.reach < least && !groups.joined(i, j) {
                least = edge.reach;
                best = (k, i, j);
            }
        });
        let (k, i, j) = best;
        if k == PAIRS || descent.looks >= limit {
            break;
        }
        descent.reach = edges[k].reach;
        let end = descent.descend(root(maps, i, j), SHADE, limit);
        edges[k].reach = descent.reach;
        if end == End::Apart {
            edges[k].lower = edges[k].lower.max(descent.lower);
        }
        edges[k].state = MEASURED;
    }
    0.5 * (above + widest(maps.len(), edges, groups, true))
}

/// The widest edge of the least spanning tree by lower or by upper bounds, pieces of one component at no distance.
fn widest(count: usize, edges: &[Edge; PAIRS], groups: Groups, lower: bool) -> f32 {
    let mut reached = groups.0[0];
    let mut widest = 0.0_f32;
    for _ in 1..count {
        if reached == (1 << count) - 1 {
            break;
        }
        let mut least = FAR;
        let mut next = 0;
        each_pair(count, |k, i, j| {
            let (from, to) = (reached >> i & 1, reached >> j & 1);
            let edge = &edges[k];
            let distance = if lower { edge.lower } else { edge.reach.sqrt() };
            if from != to && distance <= least {
                least = distance;
                next = if from == 1 { j } else { i };
            }
        });
        reached |= groups.0[next];
        widest = widest.max(least);
    }
    widest
}
