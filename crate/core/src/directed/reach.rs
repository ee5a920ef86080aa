//! Which states of a graph lead where.

use crate::directed::map::DirectedMap;

/// For each state whether `root` is made of it, at any depth; itself first.
pub(crate) fn reached(states: &[Vec<DirectedMap>], root: usize) -> Vec<bool> {
    let mut seen = vec![false; states.len()];
    let mut open = vec![root];
    while let Some(state) = open.pop() {
        if !std::mem::replace(&mut seen[state], true) {
            open.extend(states[state].iter().map(|map| map.from).filter(|&from| !seen[from]));
        }
    }
    seen
}

/// The classes of states that are made of each other, a label a state. A state that is not made of itself has a class
/// of its own.
pub(crate) fn classes(states: &[Vec<DirectedMap>]) -> Vec<usize> {
    let reach: Vec<Vec<bool>> = (0..states.len()).map(|root| reached(states, root)).collect();
    (0..states.len()).map(|i| (0..i).find(|&j| reach[i][j] && reach[j][i]).unwrap_or(i)).collect()
}

/// Whether a state is made of smaller copies of itself, at any depth.
pub(crate) fn returns(states: &[Vec<DirectedMap>], state: usize) -> bool {
    states[state].iter().any(|map| reached(states, map.from)[state])
}
