//! The graph of neighbour maps.
//!
//! A neighbour map is `h = f_u^-1 f_v` for two words u and v: where the piece of v is, seen from the piece of u. The
//! larger piece of a pair is cut (both, where they are of one size), which gives the maps after h. Pairs whose balls
//! are apart are dropped. Where finitely many maps are left, the system is of finite type, and two pieces meet exactly
//! where an endless walk starts at their map (Bandt & Graf 1992; Bandt & Mesing 2009).

use std::collections::HashMap;

use crate::error::ExactError;
use crate::number::interval::Interval;
use crate::number::matrix::{Matrix, sum};
use crate::number::rational::Rational;
use crate::system::build::System;
use crate::system::frame::Frame;
use crate::system::real::{distance, plus};

/// What becomes of a pair where its pieces are cut: the edges of both pieces, unless one stays whole.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub first: Option<usize>,
    pub second: Option<usize>,
    pub to: usize,
}

/// Two pieces that may meet.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub first: usize,
    pub is_same: bool,
    pub steps: Vec<Step>,
    /// How it was first found.
    parent: Option<(usize, Option<usize>, Option<usize>)>,
}

/// All pairs. The first nodes, one for each state, are its pieces and themselves.
pub(crate) struct Graph {
    pub nodes: Vec<Node>,
    /// Whether all of it was found.
    pub is_complete: bool,
    /// Whether sizes are compared, so that each two words of one map are met as a pair.
    pub is_sized: bool,
    /// Two words of one map, edges by number from the state where both start.
    pub overlap: Option<Overlap>,
}

/// Two words that give the same piece.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overlap {
    /// The state in which both begin.
    pub state: usize,
    /// The maps of one, the outermost first.
    pub first: Vec<usize>,
    /// The maps of the other.
    pub second: Vec<usize>,
}

type Key = (usize, usize, Matrix, Vec<Rational>);

/// Sizes are told apart if their logarithms differ by more.
const SAME_SIZE: f64 = 1e-9;

/// Numbers with more binary digits are long: the time for a pair grows with the square of their length.
const LONG_NUMBER: u64 = 96;

struct Inverse {
    linear: Matrix,
    shift: Vec<Rational>,
}

impl Graph {
    /// All pairs, up to a number of them, where those with long numbers count more. The hook is told how many there
    /// are, and ends the search by `false`.
    pub fn new(
        system: &System,
        frame: &Frame,
        budget: usize,
        mut goes_on: impl FnMut(usize) -> bool,
    ) -> Result<Self, ExactError> {
        let mut inverses = Vec::new();
        let mut sizes: Vec<Vec<f64>> = Vec::new();
        for (state, edges) in system.states.iter().enumerate() {
            let (mut of_state, mut of_sizes) = (Vec::new(), Vec::new());
            for (map, edge) in edges.iter().enumerate() {
                let linear = edge.linear.inverse().ok_or(ExactError::Singular { state, map })?;
                let shift = linear.apply(&edge.shift).iter().map(|x| -x).collect();
                of_state.push(Inverse { linear, shift });
                of_sizes.push(frame.space.action(&edge.linear).determinant().abs().middle().ln());
            }
            inverses.push(of_state);
            sizes.push(of_sizes);
        }
        let is_sized = sizes.iter().flatten().all(|size| *size < -1e3 * SAME_SIZE);
        let space = system.space.size();
        let mut nodes: Vec<Node> = Vec::new();
        let mut keys: Vec<Key> = Vec::new();
        let mut found: HashMap<Key, usize> = HashMap::new();
        let mut relative: Vec<f64> = Vec::new();
        for state in 0..system.states.len() {
            let key = (state, state, Matrix::identity(space), vec![Rational::ZERO; space]);
            found.insert(key.clone(), state);
            keys.push(key);
            relative.push(0.0);
            nodes.push(Node { first: state, is_same: true, steps: Vec::new(), parent: None });
        }
        let (mut overlap, mut is_complete, mut next, mut length) = (None, true, 0, 0);
        'all: while next < nodes.len() {
            if nodes.len() + length > budget || (next % 64 == 0 && !goes_on(nodes.len())) {
                is_complete = false;
                break;
            }
            let (a, b, linear, shift) = keys[next].clone();
            let size = relative[next];
            let cuts_first = !is_sized || size <= SAME_SIZE;
            let cuts_second = !is_sized || size >= -SAME_SIZE;
            let choices = |cuts: bool, count: usize| -> Vec<Option<usize>> {
                if cuts { (0..count).map(Some).collect() } else { vec![None] }
            };
            for second in choices(cuts_second, system.states[b].len()) {
                let (to_b, linear_b, shift_b, size_b) = match second {
                    Some(k) => {
                        let edge = &system.states[b][k];
                        let moved = sum(&linear.apply(&edge.shift), &shift);
                        (edge.from, linear.times(&edge.linear), moved, size + sizes[b][k])
                    }
                    None => (b, linear.clone(), shift.clone(), size),
                };
                for first in choices(cuts_first, system.states[a].len()) {
                    let (to_a, linear, shift, size) = match first {
                        Some(k) => {
                            let inverse = &inverses[a][k];
                            let moved = sum(&inverse.linear.apply(&shift_b), &inverse.shift);
                            (
                                system.states[a][k].from,
                                inverse.linear.times(&linear_b),
                                moved,
                                size_b - sizes[a][k],
                            )
                        }
                        None => (to_b, linear_b.clone(), shift_b.clone(), size_b),
                    };
                    let to_a = if first.is_none() { a } else { to_a };
                    let key = (to_a, to_b, linear, shift);
                    let known = found.get(&key).copied();
                    if known.is_none() && are_apart(frame, &key) {
                        continue;
                    }
                    let to = known.unwrap_or_else(|| {
                        let to = nodes.len();
                        length += cost(&key);
                        let parent = Some((next, first, second));
                        nodes.push(Node { first: to_a, is_same: false, steps: Vec::new(), parent });
                        relative.push(size);
                        keys.push(key.clone());
                        found.insert(key, to);
                        to
                    });
                    let is_overlap = nodes[to].is_same && !(nodes[next].is_same && first == second);
                    if is_overlap && overlap.is_none() {
                        overlap = Some(words(&nodes, next, first, second));
                    }
                    nodes[next].steps.push(Step { first, second, to });
                    if nodes.len() + length > budget {
                        is_complete = false;
                        break 'all;
                    }
                }
            }
            next += 1;
        }
        let mut graph = Self { nodes, is_complete, is_sized, overlap };
        if is_complete {
            graph.prune();
        }
        Ok(graph)
    }

    /// Takes the steps away that lead to pieces that do not meet.
    fn prune(&mut self) {
        loop {
            let dead: Vec<bool> = self.nodes.iter().map(|node| node.steps.is_empty()).collect();
            let mut changed = false;
            for node in &mut self.nodes {
                let before = node.steps.len();
                node.steps.retain(|step| !dead[step.to]);
                changed |= node.steps.len() != before;
            }
            if !changed {
                break;
            }
        }
    }

    /// The pairs of different pieces that meet.
    pub fn neighbours(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.nodes.len()).filter(|&k| !self.nodes[k].is_same && !self.nodes[k].steps.is_empty())
    }
}

fn words(nodes: &[Node], at: usize, first: Option<usize>, second: Option<usize>) -> Overlap {
    let (mut one, mut other): (Vec<usize>, Vec<usize>) =
        (first.into_iter().collect(), second.into_iter().collect());
    let mut at = at;
    while let Some((parent, first, second)) = nodes[at].parent {
        one.extend(first);
        other.extend(second);
        at = parent;
    }
    one.reverse();
    other.reverse();
    Overlap { state: nodes[at].first, first: one, second: other }
}

/// What a pair with long numbers costs besides itself: those of doubles grow with each letter.
fn cost((_, _, linear, shift): &Key) -> usize {
    let longest = linear.entries().iter().chain(shift).map(Rational::bits).max().unwrap_or(0);
    usize::try_from((longest / LONG_NUMBER).pow(2)).unwrap_or(usize::MAX)
}

fn are_apart(frame: &Frame, (a, b, linear, shift): &Key) -> bool {
    let action = frame.space.action(linear);
    let centre = plus(&action.apply(&frame.centres[*b]), &frame.space.point(shift));
    let reach = Interval::point(frame.radii[*a])
        + Interval::point(action.quick_norm()) * Interval::point(frame.radii[*b]);
    distance(&centre, &frame.centres[*a]).lower() > reach.upper()
}
