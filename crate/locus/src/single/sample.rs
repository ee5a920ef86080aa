//! One sample in f32. Shader twin: the last part of crate/render/shader/locus.wgsl.

use super::descent::{Descent, End, MAX_MAPS, Pair};
use super::map::SingleMap;
use super::support::{Map, SupportTable};
use super::system::{System, fixed_point};
use crate::verdict::{Sample, State};

/// Rounds of lowering the support values at most.
const SUPPORT_ROUNDS: usize = 48;
/// Looks spent at most on the verdict, and on measuring a gap after it.
const LOOKS_TO_DECIDE: u32 = 3000;
const LOOKS_TO_MEASURE: u32 = 400;
/// How near to each other the bounds of a gap are to come: the lower over the upper.
const GAP_TIGHTNESS: f32 = 0.95;
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
    state: Known,
}

/// Whether two attractorlets meet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Known {
    #[default]
    Open,
    Apart,
    Met,
    Unknown,
    /// Apart, and their distance was measured.
    Measured,
}

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
    let table = SupportTable::new(maps, fixed_point(maps[0]), 0.03 * (1.0 - system.factor), SUPPORT_ROUNDS);
    let diameter = table.diameter();
    let resolution = epsilon * diameter;
    let mut descent = Descent {
        maps,
        table,
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
        if edges[k].state == Known::Unknown || edges[k].state == Known::Open {
            coarsest.join(i, j);
        }
    });
    if coarsest.whole(count) {
        return (UNDECIDED, descent.looks);
    }
    let gap = measure(&mut descent, &mut edges, groups).map(|gap| gap / diameter);
    // NaN is not in the range.
    match gap.filter(|gap| (0.0..=1.0).contains(gap)) {
        Some(gap) => (Sample { state: State::Disconnected, gap }, descent.looks),
        None => (UNDECIDED, descent.looks),
    }
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
            Known::Met
        } else if seen.apart > 0.0 {
            Known::Apart
        } else {
            Known::Open
        };
        edges[k] = Edge { reach: seen.reach, lower: seen.apart, overlap: seen.overlap, state };
    });
}

/// The numbers of the pair of pieces in two components whose key is least, and of its two, where any has one.
fn next_pair(
    count: usize,
    edges: &[Edge; PAIRS],
    groups: &Groups,
    key: impl Fn(&Edge) -> Option<f32>,
) -> Option<(usize, usize, usize)> {
    let mut best = None;
    let mut least = FAR;
    each_pair(count, |k, i, j| {
        if let Some(key) = key(&edges[k])
            && key < least
            && !groups.joined(i, j)
        {
            least = key;
            best = Some((k, i, j));
        }
    });
    best
}

/// Descends on the pairs that may meet, those that overlap most first, until all pieces are in one component or none of
/// these pairs is left.
fn settle(descent: &mut Descent, edges: &mut [Edge; PAIRS], groups: &mut Groups) {
    let maps = descent.maps;
    let count = maps.len();
    while !groups.whole(count) {
        let open = |edge: &Edge| (edge.state == Known::Open).then_some(edge.overlap);
        let Some((k, i, j)) = next_pair(count, edges, groups, open) else { return };
        descent.reach = edges[k].reach;
        let end = descent.descend(root(maps, i, j), 0.0, LOOKS_TO_DECIDE);
        edges[k].reach = descent.reach;
        match end {
            End::Met => {
                edges[k].state = Known::Met;
                groups.join(i, j);
            }
            End::Apart => {
                edges[k].state = Known::Apart;
                edges[k].lower = descent.lower;
            }
            End::Unknown => edges[k].state = Known::Unknown,
        }
    }
}

/// The widest gap, in the frame: the middle of a lower and an upper bound of the widest edge of the minimum spanning
/// tree. `None` where these contradict each other.
fn measure(descent: &mut Descent, edges: &mut [Edge; PAIRS], groups: Groups) -> Option<f32> {
    let maps = descent.maps;
    let limit = descent.looks + LOOKS_TO_MEASURE;
    let mut above;
    loop {
        above = widest(maps.len(), edges, groups, false);
        // A pair that may come nearer than is known, and so narrow the gap.
        let loose = |edge: &Edge| {
            let loose = edge.lower < GAP_TIGHTNESS * edge.reach.sqrt().min(above);
            (edge.state == Known::Apart && loose).then_some(edge.reach)
        };
        let next = next_pair(maps.len(), edges, &groups, loose);
        let Some((k, i, j)) = next.filter(|_| descent.looks < limit) else { break };
        descent.reach = edges[k].reach;
        let end = descent.descend(root(maps, i, j), GAP_TIGHTNESS, limit);
        edges[k].reach = descent.reach;
        if end == End::Apart {
            edges[k].lower = edges[k].lower.max(descent.lower);
        }
        edges[k].state = Known::Measured;
    }
    let below = widest(maps.len(), edges, groups, true);
    (below <= above + descent.margin).then_some(0.5 * (above + below))
}

/// The widest edge of the minimum spanning tree by lower or by upper bounds, pieces of one component at no distance.
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
