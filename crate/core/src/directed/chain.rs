//! Shapes whose states run from point to point, as outlines do.

use glam::DVec2;

use crate::directed::map::DirectedMap;
use crate::directed::reach;
use crate::directed::system::DirectedIfs;
use crate::error::MAX_MAPS;
use crate::linear::affine::Affine2;

/// A shape that goes once round, as the copies that follow each other.
///
/// Each state that it is made of runs from one point to another: it is copies that do, each from where the one before
/// it ended. Closed curves of edges that are straight or copies of arcs are such, and so is Koch's snowflake.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ring {
    /// The copies, each of a state from its first point to its last.
    pub edges: Vec<DirectedMap>,
    /// The first point of each state and its last; of use for those that the shape is made of.
    pub ends: Vec<[DVec2; 2]>,
    /// Of each state the one that is the same points run through backwards, where there is one. A segment is its own.
    pub backwards: Vec<Option<usize>>,
}

/// Points this near, over the size of the shape, are taken for the same.
const SAME: f64 = 1e-7;
/// The most copies that follow each other.
const MOST_EDGES: usize = 4 * MAX_MAPS;

impl Ring {
    /// The shape of a system, state 0, where it is a ring. Where it is nothing but other states that are parts of it
    /// alone, as they are, these are taken apart.
    pub fn of(system: &DirectedIfs) -> Option<Self> {
        let states = system.states();
        if reach::returns(states, 0) {
            return None;
        }
        let ends = ends(system);
        let mut edges = states[0].clone();
        let part = |edge: &DirectedMap| edge.map == Affine2::IDENTITY && !reach::returns(states, edge.from);
        while edges.iter().all(part) {
            edges = edges.iter().flat_map(|edge| states[edge.from].iter().copied()).collect();
            if edges.len() > MOST_EDGES {
                return None;
            }
        }
        let begin = |edge: &DirectedMap| edge.map.apply(ends[edge.from][0]);
        let [low, high] = edges
            .iter()
            .map(begin)
            .fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
        if edges.len() < 2 || !follow(&edges, &ends, SAME * low.distance(high), true) {
            return None;
        }
        let mut copied = vec![false; states.len()];
        for edge in &edges {
            let reached = reach::reached(states, edge.from);
            copied.iter_mut().zip(reached).for_each(|(copied, reached)| *copied |= reached);
        }
        let runs = |state: usize| {
            let [first, last] = ends[state];
            let long = first.distance(last);
            states[state].len() > 1 && long > 0.0 && follow(&states[state], &ends, SAME * long, false)
        };
        let all = (0..states.len()).all(|state| !copied[state] || runs(state));
        let backwards = backwards(states, &ends);
        all.then_some(Self { edges, ends, backwards })
    }

    /// With one copy more: the longest is taken apart.
    pub fn split(&mut self, states: &[Vec<DirectedMap>]) {
        let long = |edge: &DirectedMap| {
            let [first, last] = self.ends[edge.from];
            edge.map.apply(first).distance(edge.map.apply(last))
        };
        let longest = (0..self.edges.len())
            .filter(|&k| states[self.edges[k].from].len() == 2)
            .max_by(|&i, &j| long(&self.edges[i]).total_cmp(&long(&self.edges[j])));
        if let Some(k) = longest {
            let DirectedMap { from, map } = self.edges[k];
            let parts = states[from].iter().map(|part| DirectedMap { from: part.from, map: map * part.map });
            self.edges.splice(k..=k, parts);
        }
    }
}

/// Whether each copy begins where the one before it ends.
fn follow(maps: &[DirectedMap], ends: &[[DVec2; 2]], near: f64, round: bool) -> bool {
    let at = |part: &DirectedMap, which: usize| part.map.apply(ends[part.from][which]);
    let last = maps.last().filter(|_| round).into_iter();
    last.chain(maps).zip(maps.iter().skip(usize::from(!round))).all(|(before, after)| {
        let gap = at(before, 1).distance(at(after, 0));
        gap <= near
    })
}

/// Of each state the one that is made of the same copies in the opposite order, of states of which the same is true.
fn backwards(states: &[Vec<DirectedMap>], ends: &[[DVec2; 2]]) -> Vec<Option<usize>> {
    let count = states.len();
    let segment: Vec<bool> = (0..count).map(|state| is_segment(states, ends, state)).collect();
    let point = |part: &DirectedMap, which: usize| part.map.apply(ends[part.from][which]);
    let near = |p: DVec2, q: DVec2, by: f64| p.distance(q) <= SAME * by;
    // The largest relation that agrees with itself.
    let mut twins = vec![vec![true; count]; count];
    loop {
        let holds = |i: usize, j: usize| {
            if segment[i] || segment[j] {
                return i == j;
            }
            let long = ends[i][0].distance(ends[i][1]);
            states[i].len() == states[j].len()
                && states[i].iter().zip(states[j].iter().rev()).all(|(a, b)| {
                    twins[a.from][b.from]
                        && near(point(a, 0), point(b, 1), long)
                        && near(point(a, 1), point(b, 0), long)
                        && (segment[a.from] || a.map == b.map)
                })
        };
        let next: Vec<Vec<bool>> =
            (0..count).map(|i| (0..count).map(|j| twins[i][j] && holds(i, j)).collect()).collect();
        if next == twins {
            break;
        }
        twins = next;
    }
    twins.iter().map(|row| row.iter().position(|twin| *twin)).collect()
}

/// Whether a state is the segment between its ends: made of itself alone, from point to point along it.
fn is_segment(states: &[Vec<DirectedMap>], ends: &[[DVec2; 2]], state: usize) -> bool {
    let [first, last] = ends[state];
    let along = last - first;
    states[state].iter().all(|part| {
        let own = part.map.apply(first);
        let step = part.map.apply(last) - own;
        part.from == state
            && along.perp_dot(own - first).abs() <= SAME * along.length_squared()
            && along.perp_dot(step).abs() <= SAME * along.length_squared()
            && along.dot(step) > 0.0
    })
}

/// Of each state the end of the way that takes the first map each time, and of the one that takes the last.
fn ends(system: &DirectedIfs) -> Vec<[DVec2; 2]> {
    let reversed = |maps: &Vec<DirectedMap>| maps.iter().rev().copied().collect();
    let first = points(system.states());
    let last = points(&system.states().iter().map(reversed).collect::<Vec<Vec<DirectedMap>>>());
    first.into_iter().zip(last).map(|(first, last)| [first, last]).collect()
}

/// The end of the way from each state that takes the first map each time.
fn points(states: &[Vec<DirectedMap>]) -> Vec<DVec2> {
    let end = |state: usize| {
        let mut way = vec![state];
        let mut at = states[state][0].from;
        while !way.contains(&at) {
            way.push(at);
            at = states[at][0].from;
        }
        let lead = way.iter().position(|&met| met == at).unwrap_or(0);
        let first = |state: &usize| states[*state][0].map;
        let round = way[lead..].iter().map(first).fold(Affine2::IDENTITY, |word, map| word * map);
        let fixed = round.fixed_point().unwrap_or(DVec2::NAN);
        way[..lead].iter().rev().map(first).fold(fixed, |point, map| map.apply(point))
    };
    (0..states.len()).map(end).collect()
}
