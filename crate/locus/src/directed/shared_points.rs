//! Points that pieces of states share, exactly: ends of ways that repeat.

use std::collections::HashMap;

use frond_core::{Affine2, DirectedIfs};
use glam::DVec2;

use crate::exact::address::Address;
use crate::exact::quadratic::QuadraticSystem;
use crate::exact::recognise::{self, Recognised};
use crate::overlap_graph::OverlapGraph;

/// A point that two pieces of a state share, by the ways to it: letters are arrows of the whole graph.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Meeting {
    pub pair: (usize, usize),
    pub ways: [Address; 2],
    pub at: DVec2,
}

/// The arrows of a graph in one row: state after state.
#[derive(Clone, Debug)]
pub(crate) struct Arrows {
    pub maps: Vec<Affine2>,
    /// Of each state the first of its arrows, and one past the last of all.
    first: Vec<usize>,
    /// Of each arrow the state that it copies.
    from: Vec<usize>,
    /// The most maps of a state.
    widest: usize,
}

/// Arrows are letters of one byte.
const MOST_ARROWS: usize = 255;
/// Ways round that are looked at, of each state, and the longest.
const MOST_ROUNDS: usize = 24;
const LONGEST_ROUND: usize = 6;
/// Ways that are looked at for these.
const MOST_LOOKS: usize = 6000;
/// Points that are kept of each state, and steps from the ways round to them.
const MOST_POINTS: usize = 3000;
const STEPS: usize = 3;
/// Points this near, over the diameter of the state, are taken for the same.
const CELLS_PER_UNIT: f64 = 67_108_864.0;
/// Points of two pieces that are checked at most.
const MOST_TRIES_PER_PAIR: usize = 6;

impl Arrows {
    /// `None` where there are too many.
    pub fn of(system: &DirectedIfs) -> Option<Self> {
        let mut first = vec![0];
        let (mut maps, mut from) = (Vec::new(), Vec::new());
        for state in system.states() {
            maps.extend(state.iter().map(|part| part.map));
            from.extend(state.iter().map(|part| part.from));
            first.push(maps.len());
        }
        let widest = system.states().iter().map(Vec::len).max().unwrap_or(0);
        (maps.len() <= MOST_ARROWS).then_some(Self { maps, first, from, widest })
    }

    fn of_state(&self, state: usize) -> std::ops::Range<usize> {
        self.first[state]..self.first[state + 1]
    }

    /// The state that an arrow leads into.
    fn into(&self, arrow: usize) -> usize {
        self.first.partition_point(|&first| first <= arrow) - 1
    }

    /// The place of an arrow among the maps of its state.
    fn place(&self, arrow: usize) -> usize {
        arrow - self.first[self.into(arrow)]
    }

    /// A way as people read it: the maps along it, each by its place in its state, from 1.
    pub fn shown(&self, way: &Address) -> String {
        let places = |part: &[u8]| -> Vec<u8> {
            part.iter().map(|&arrow| self.place(usize::from(arrow)) as u8).collect()
        };
        // Different arrows may have one place: what is read may be shorter.
        Address::new(places(&way.head), places(&way.repeat))
            .map_or(String::new(), |way| way.shown(self.widest))
    }

    /// Ways round from each state, short ones first.
    fn rounds(&self, state: usize) -> Vec<Vec<u8>> {
        let mut found = Vec::new();
        let mut level: Vec<(Vec<u8>, usize)> = vec![(Vec::new(), state)];
        let mut looked = 0;
        for _ in 0..LONGEST_ROUND {
            let mut next = Vec::new();
            for (way, at) in &level {
                for arrow in self.of_state(*at) {
                    looked += 1;
                    if looked > MOST_LOOKS {
                        return found;
                    }
                    let longer = [way.as_slice(), &[arrow as u8]].concat();
                    if self.from[arrow] == state {
                        found.push(longer.clone());
                        if found.len() >= MOST_ROUNDS {
                            return found;
                        }
                    }
                    next.push((longer, self.from[arrow]));
                }
            }
            level = next;
        }
        found
    }

    /// Points of each state with the ways to them.
    fn points(&self, states: usize) -> Vec<Vec<(DVec2, Address)>> {
        let mut points: Vec<Vec<(DVec2, Address)>> = vec![Vec::new(); states];
        for (state, own) in points.iter_mut().enumerate() {
            for round in self.rounds(state) {
                let Some(way) = Address::new(Vec::new(), round) else { continue };
                if let Some(point) = way.point(&self.maps)
                    && own.iter().all(|(_, known)| *known != way)
                {
                    own.push((point, way));
                }
            }
        }
        let mut begin = vec![0; states];
        for _ in 0..STEPS {
            let ends: Vec<usize> = points.iter().map(Vec::len).collect();
            for state in 0..states {
                for arrow in self.of_state(state) {
                    let from = self.from[arrow];
                    for k in begin[from]..ends[from] {
                        if points[state].len() >= MOST_POINTS {
                            break;
                        }
                        let (point, way) = points[from][k].clone();
                        if let Some(longer) = self.prolonged(arrow, &way)
                            && longer.head.len() > way.head.len()
                        {
                            points[state].push((self.maps[arrow].apply(point), longer));
                        }
                    }
                }
            }
            begin = ends;
        }
        points
    }

    /// The way that takes an arrow first.
    fn prolonged(&self, arrow: usize, way: &Address) -> Option<Address> {
        Address::new([&[arrow as u8], way.head.as_slice()].concat(), way.repeat.clone())
    }

    /// What pieces of each state seem to share: found in floating point, and so only proposed. Short ways first.
    pub fn proposed(&self, diameters: &[f64]) -> Vec<Vec<Meeting>> {
        let points = self.points(diameters.len());
        let of_state = |(state, diameter): (usize, &f64)| {
            let unit = CELLS_PER_UNIT / diameter.max(f64::MIN_POSITIVE);
            let mut holders: HashMap<[i64; 2], Vec<(usize, Address)>> = HashMap::new();
            let mut found = Vec::new();
            for arrow in self.of_state(state) {
                for (point, way) in &points[self.from[arrow]] {
                    let Some(way) = self.prolonged(arrow, way) else { continue };
                    let at = self.maps[arrow].apply(*point);
                    let cell = (at * unit).to_array().map(|x| (x + 0.3719).round() as i64);
                    let here = holders.entry(cell).or_default();
                    let place = self.place(arrow);
                    if here.iter().any(|(holder, _)| *holder == place) {
                        continue;
                    }
                    found.extend(here.iter().map(|(other, first)| Meeting {
                        pair: (*other, place),
                        ways: [first.clone(), way.clone()],
                        at,
                    }));
                    if here.len() < 4 {
                        here.push((place, way));
                    }
                }
            }
            let letters = |way: &Address| way.head.len() + way.repeat.len();
            found
                .sort_by_key(|meeting| (letters(&meeting.ways[0]) + letters(&meeting.ways[1]), meeting.pair));
            found
        };
        diameters.iter().enumerate().map(of_state).collect()
    }
}

/// What was checked without rounding: of each state enough meetings to join all pieces that they join.
#[derive(Clone, Debug)]
pub(crate) struct Shared {
    pub meetings: Vec<Vec<Meeting>>,
    /// Whether they join all pieces of the state.
    pub joined: Vec<bool>,
    /// Readings of numbers that they hang on.
    pub assuming: Vec<String>,
}

impl Shared {
    /// The meetings of those proposed that `holds` says yes to. `ends` are systems of one graph: pieces that are the
    /// same in all of them meet as well.
    pub fn checked(
        ends: &[&DirectedIfs],
        proposed: &[Vec<Meeting>],
        mut holds: impl FnMut(&Meeting) -> bool,
        assuming: Vec<String>,
    ) -> Self {
        let (mut meetings, mut joined) = (Vec::new(), Vec::new());
        for (state, proposed) in proposed.iter().enumerate() {
            let maps = ends.first().map_or(&[][..], |system| &system.states()[state]);
            let same =
                |i: usize, j: usize| ends.iter().all(|end| end.states()[state][i] == end.states()[state][j]);
            let mut graph = OverlapGraph::new(maps.len());
            for i in 0..maps.len() {
                (i + 1..maps.len()).filter(|&j| same(i, j)).for_each(|j| graph.add(i, j));
            }
            let mut tries = vec![0; maps.len() * maps.len()];
            let mut kept = Vec::new();
            for meeting in proposed {
                let (i, j) = meeting.pair;
                let tried = &mut tries[i * maps.len() + j];
                if graph.components().joined(i, j) || *tried >= MOST_TRIES_PER_PAIR {
                    continue;
                }
                *tried += 1;
                if holds(meeting) {
                    graph.add(i, j);
                    kept.push(meeting.clone());
                }
            }
            kept.sort_by_key(|meeting| meeting.pair);
            joined.push(graph.is_connected());
            meetings.push(kept);
        }
        Self { meetings, joined, assuming }
    }

    /// Those of the maps as they are given, and those of the numbers that they come near.
    pub fn of(system: &DirectedIfs, diameters: &[f64]) -> Option<(Self, Option<Self>)> {
        let arrows = Arrows::of(system)?;
        let proposed = arrows.proposed(diameters);
        let check = |exact: &QuadraticSystem, assuming| {
            Self::checked(
                &[system],
                &proposed,
                |meeting| exact.coincide(&meeting.ways[0], &meeting.ways[1]),
                assuming,
            )
        };
        let given = match QuadraticSystem::as_given(&arrows.maps) {
            Some(exact) => check(&exact, Vec::new()),
            None => Self::checked(&[system], &proposed, |_| false, Vec::new()),
        };
        let open = given.joined.iter().any(|joined| !joined);
        let meant = open.then(|| recognise::read(&arrows.maps)).flatten();
        let meant = meant.map(|Recognised { system: exact, assuming }| check(&exact, assuming));
        Some((given, meant))
    }
}

/// The largest set of states of which each is in `good` and copies states of the set alone: where the pieces of each of
/// these are joined, all of them are in one piece.
pub(crate) fn closed(system: &DirectedIfs, good: &[bool]) -> Vec<bool> {
    let mut kept = good.to_vec();
    loop {
        let next: Vec<bool> = system
            .states()
            .iter()
            .enumerate()
            .map(|(state, maps)| kept[state] && maps.iter().all(|part| kept[part.from]))
            .collect();
        if next == kept {
            return kept;
        }
        kept = next;
    }
}
