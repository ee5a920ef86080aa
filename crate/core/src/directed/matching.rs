//! Which state and which map of one graph become which of another.

use crate::bounds::hull2::Hull;
use crate::directed::error::MAX_STATES;
use crate::directed::map::DirectedMap;
use crate::directed::system::DirectedIfs;
use crate::morph::pairing::assignment;

/// Two graphs brought to one: its states are pairs of states, and its maps pairs of maps.
///
/// Where state i is to become state j, each map of i becomes one of j, and so does what they copy. What is copied by
/// maps of several pairs is split: the pairs (i, j) and (i, k) are two copies of state i. Neither this nor doubling a
/// map changes a shape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Matching {
    /// Which state of the first becomes which of the last; the first pair is that of the shapes.
    pub states: Vec<(usize, usize)>,
    /// Of each pair the maps: the one of the first, the one of the last, and the pair that is copied.
    pub maps: Vec<Vec<(usize, usize, usize)>>,
    /// Maps that were doubled, of the first and of the last.
    pub doubled: [usize; 2],
}

/// What it costs to need a pair that is not there yet, beside squares of lengths over the diameter.
const NEW_PAIR: f64 = 0.2;

impl Matching {
    /// The matching of two systems; `None` where it would take more than 64 states. Graphs whose arrows are the
    /// same, in the same order, are left as they are: their order is the user's.
    pub fn of(from: &DirectedIfs, to: &DirectedIfs) -> Option<Self> {
        let copies = |system: &DirectedIfs| -> Vec<Vec<usize>> {
            system.states().iter().map(|maps| maps.iter().map(|part| part.from).collect()).collect()
        };
        let arrows = copies(from);
        if arrows == copies(to) {
            let maps = arrows.iter().map(|maps| maps.iter().enumerate().map(|(k, &at)| (k, k, at)).collect());
            return Some(Self {
                states: (0..from.len()).map(|i| (i, i)).collect(),
                maps: maps.collect(),
                doubled: [0; 2],
            });
        }
        // From whichever end, the search begins with the same graph: swapped, a morph runs backwards.
        if numbers(to).lt(numbers(from)) {
            return Self::search(to, from).map(Self::swapped);
        }
        Self::search(from, to)
    }

    fn swapped(mut self) -> Self {
        self.states.iter_mut().for_each(|pair| *pair = (pair.1, pair.0));
        self.maps.iter_mut().flatten().for_each(|map| *map = (map.1, map.0, map.2));
        self.doubled.reverse();
        self
    }

    fn search(from: &DirectedIfs, to: &DirectedIfs) -> Option<Self> {
        let hulls = [Hull::of_states(from), Hull::of_states(to)];
        let mut this = Self { states: vec![(0, 0)], maps: Vec::new(), doubled: [0; 2] };
        let mut next = 0;
        while next < this.states.len() {
            let (i, j) = this.states[next];
            let (a, b) = (&from.states()[i], &to.states()[j]);
            let cost = |p: &DirectedMap, q: &DirectedMap| {
                let moved = place(p, i, &hulls[0]).distance_squared(place(q, j, &hulls[1]));
                let d = p.map.linear - q.map.linear;
                let bent = d.x_axis.length_squared() + d.y_axis.length_squared();
                let fresh = if this.states.contains(&(p.from, q.from)) { 0.0 } else { NEW_PAIR };
                let cost = moved + 0.1 * bent + fresh;
                if cost.is_finite() { cost } else { 1e12 }
            };
            let order = pairs(a, b, cost);
            this.doubled[0] += order.len() - a.len();
            this.doubled[1] += order.len() - b.len();
            let mut maps = Vec::with_capacity(order.len());
            for (p, q) in order {
                let pair = (a[p].from, b[q].from);
                let at = this.states.iter().position(|known| *known == pair).unwrap_or_else(|| {
                    this.states.push(pair);
                    this.states.len() - 1
                });
                maps.push((p, q, at));
            }
            this.maps.push(maps);
            if this.states.len() > MAX_STATES {
                return None;
            }
            next += 1;
        }
        Some(this)
    }
}

/// What makes a system this one and no other, but for which map is of which state.
fn numbers(system: &DirectedIfs) -> impl Iterator<Item = f64> {
    let map = |part: &DirectedMap| part.map.to_row().into_iter().chain([part.from as f64]);
    let maps = system.states().iter().flatten().flat_map(map);
    std::iter::once(system.len() as f64).chain(maps)
}

/// Where a copy lies in the state that it is a part of, relative to its size.
fn place(part: &DirectedMap, state: usize, hulls: &[Hull]) -> glam::DVec2 {
    let whole = &hulls[state];
    (part.map.apply(hulls[part.from].centre()) - whole.centre()) / whole.diameter().max(f64::MIN_POSITIVE)
}

/// Each map of the longer list with one of the other, such that none is left out and the sum is least: in the order
/// of the first.
fn pairs(
    a: &[DirectedMap],
    b: &[DirectedMap],
    cost: impl Fn(&DirectedMap, &DirectedMap) -> f64,
) -> Vec<(usize, usize)> {
    let swapped = a.len() < b.len();
    let (long, short) = if swapped { (b.len(), a.len()) } else { (a.len(), b.len()) };
    let of = |l: usize, s: usize| if swapped { cost(&a[s], &b[l]) } else { cost(&a[l], &b[s]) };
    let costs: Vec<Vec<f64>> = (0..long).map(|l| (0..short).map(|s| of(l, s)).collect()).collect();
    let nearest = |row: &[f64]| (0..short).min_by(|&p, &q| row[p].total_cmp(&row[q])).unwrap_or(0);
    // Columns beyond those of the shorter list are second copies of whichever is nearest.
    let square: Vec<Vec<f64>> = costs
        .iter()
        .map(|row| (0..long).map(|s| if s < short { row[s] } else { row[nearest(row)] }).collect())
        .collect();
    let chosen = assignment(&square);
    let mut order: Vec<(usize, usize)> = chosen
        .into_iter()
        .enumerate()
        .map(|(l, s)| (l, if s < short { s } else { nearest(&costs[l]) }))
        .map(|(l, s)| if swapped { (s, l) } else { (l, s) })
        .collect();
    order.sort_unstable();
    order
}
