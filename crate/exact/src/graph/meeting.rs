//! Which pieces of an iterated function system meet, with a point of both.
//!
//! An endless walk through the graph of neighbour maps spells the addresses of a common point of two pieces. A walk
//! that comes back to a pair goes round without end, and then both addresses repeat: with h at that pair, where p and q
//! are the words of the way round, `h f_q = f_p h`, so that h takes the fixed point of `f_q` to that of `f_p`.

use std::collections::VecDeque;

use crate::error::ExactError;
use crate::graph::neighbours::Graph;
use crate::system::build::System;
use crate::system::frame::Frame;

/// The most letters of the head or of the repeated part of an address.
pub const MOST_LETTERS: usize = 1000;
/// Pairs on the way that are tried as the start of a way round.
const MOST_TRIED: usize = 60;

/// An endless word of maps: `head` once, then `repeat` without end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    /// The maps before those that repeat, the outermost first.
    pub head: Vec<usize>,
    /// The maps that repeat.
    pub repeat: Vec<usize>,
}

/// A point of the pieces of two maps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SharedPoint {
    /// The two maps.
    pub pieces: [usize; 2],
    /// Its address in the one and in the other.
    pub addresses: [Address; 2],
}

/// Which first pieces meet.
#[derive(Clone, Debug)]
pub struct Meeting {
    /// Points that pieces share: as many as join all pieces that are known to be joined by such points.
    pub points: Vec<SharedPoint>,
    /// For each map the number of the set that it is joined with.
    pub sets: Vec<usize>,
    /// Whether all pairs were found: then maps of two sets have pieces that do not meet.
    pub is_complete: bool,
    /// How many pairs were looked at.
    pub pairs: usize,
}

impl Meeting {
    /// How many sets of pieces there are that are not joined.
    #[must_use]
    pub fn count(&self) -> usize {
        self.sets.iter().max().map_or(0, |most| most + 1)
    }
}

/// Finds which first pieces of a system of one state meet. The search ends at a number of pairs, or by `false` of the
/// hook, which is told how many there are.
///
/// # Errors
/// Where the system has several states, the maps are not seen to contract, or one has no inverse.
pub fn meeting(
    system: &System,
    budget: usize,
    goes_on: impl FnMut(usize) -> bool,
) -> Result<Meeting, ExactError> {
    if system.states.len() != 1 {
        return Err(ExactError::TooMany { count: system.states.len(), most: 1 });
    }
    let frame = Frame::new(system)?;
    let graph = Graph::new(system, &frame, budget, goes_on)?;
    let walks = Walks::new(&graph);
    let mut sets = Sets { parents: (0..system.states[0].len()).collect() };
    let mut points = Vec::new();
    for step in &graph.nodes[0].steps {
        let (Some(i), Some(j)) = (step.first, step.second) else { continue };
        if i >= j || !walks.is_alive[step.to] || sets.of(i) == sets.of(j) {
            continue;
        }
        if let Some(addresses) = walks.point([i, j], step.to) {
            points.push(SharedPoint { pieces: [i, j], addresses });
            sets.join(i, j);
        }
    }
    // Long ways round are not written down, and yet the pieces meet.
    let all_written = graph.nodes[0].steps.iter().all(|step| match (step.first, step.second) {
        (Some(i), Some(j)) => !walks.is_alive[step.to] || sets.of(i) == sets.of(j),
        _ => true,
    });
    let is_complete = graph.is_complete && all_written;
    Ok(Meeting { points, sets: sets.numbers(), is_complete, pairs: graph.nodes.len() })
}

/// The pairs from which a walk goes on without end, as far as is known.
struct Walks<'a> {
    graph: &'a Graph,
    is_alive: Vec<bool>,
}

impl<'a> Walks<'a> {
    fn new(graph: &'a Graph) -> Self {
        let mut before: Vec<Vec<usize>> = vec![Vec::new(); graph.nodes.len()];
        let mut ways: Vec<usize> = Vec::new();
        for (k, node) in graph.nodes.iter().enumerate() {
            ways.push(node.steps.len());
            for step in &node.steps {
                before[step.to].push(k);
            }
        }
        let mut is_alive = vec![true; ways.len()];
        let mut dead: Vec<usize> = (0..ways.len()).filter(|&k| ways[k] == 0).collect();
        while let Some(k) = dead.pop() {
            is_alive[k] = false;
            for &from in &before[k] {
                ways[from] -= 1;
                if ways[from] == 0 {
                    dead.push(from);
                }
            }
        }
        Self { graph, is_alive }
    }

    /// The addresses of a common point, the shortest of those tried.
    fn point(&self, pieces: [usize; 2], from: usize) -> Option<[Address; 2]> {
        let all = self.search(from, None);
        let mut best: Option<(usize, Vec<Letters>, Vec<Letters>)> = None;
        for &at in all.order.iter().take(MOST_TRIED) {
            let head = all.way(from, at);
            if best.as_ref().is_some_and(|(least, ..)| head.len() >= *least) {
                break;
            }
            let Some(repeat) = self.round(at) else { continue };
            let total = head.len() + repeat.len();
            if best.as_ref().is_none_or(|(least, ..)| total < *least) {
                best = Some((total, head, repeat));
            }
        }
        let (_, head, repeat) = best?;
        let spelled = |side: usize| {
            let letters = |way: &[Letters]| way.iter().filter_map(|step| step[side]).collect::<Vec<usize>>();
            let mut address = Address { head: vec![pieces[side]], repeat: letters(&repeat) };
            address.head.extend(letters(&head));
            let longest = address.head.len().max(address.repeat.len());
            (longest <= MOST_LETTERS && !address.repeat.is_empty()).then_some(address)
        };
        Some([spelled(0)?, spelled(1)?])
    }

    /// The shortest way from a pair back to it.
    fn round(&self, at: usize) -> Option<Vec<Letters>> {
        let found = self.search(at, Some(at));
        let (from, letters) = found.last?;
        let mut way = found.way(at, from);
        way.push(letters);
        Some(way)
    }

    fn search(&self, from: usize, until: Option<usize>) -> Search {
        let mut found = Search { order: vec![from], before: vec![None; self.is_alive.len()], last: None };
        let mut waiting = VecDeque::from([from]);
        while let Some(at) = waiting.pop_front() {
            for step in self.graph.nodes[at].steps.iter().filter(|step| self.is_alive[step.to]) {
                let letters = [step.first, step.second];
                if Some(step.to) == until {
                    found.last = Some((at, letters));
                    return found;
                }
                if step.to != from && found.before[step.to].is_none() {
                    found.before[step.to] = Some((at, letters));
                    found.order.push(step.to);
                    waiting.push_back(step.to);
                }
            }
        }
        found
    }
}

/// Of a step, the map of either piece that is cut.
type Letters = [Option<usize>; 2];

/// Pairs in the order in which they were reached, and from where.
struct Search {
    order: Vec<usize>,
    before: Vec<Option<(usize, Letters)>>,
    last: Option<(usize, Letters)>,
}

impl Search {
    fn way(&self, from: usize, to: usize) -> Vec<Letters> {
        let (mut way, mut at) = (Vec::new(), to);
        while at != from {
            let Some((before, letters)) = self.before[at] else { break };
            way.push(letters);
            at = before;
        }
        way.reverse();
        way
    }
}

/// Sets of maps that are joined.
struct Sets {
    parents: Vec<usize>,
}

impl Sets {
    fn of(&self, mut map: usize) -> usize {
        while self.parents[map] != map {
            map = self.parents[map];
        }
        map
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of(a), self.of(b));
        self.parents[a.max(b)] = a.min(b);
    }

    /// Numbered from 0 in the order of their first maps.
    fn numbers(&self) -> Vec<usize> {
        let mut roots: Vec<usize> = Vec::new();
        let mut number = |map: usize| {
            let root = self.of(map);
            roots.iter().position(|&other| other == root).unwrap_or_else(|| {
                roots.push(root);
                roots.len() - 1
            })
        };
        (0..self.parents.len()).map(&mut number).collect()
    }
}
