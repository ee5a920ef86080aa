//! States that stand for the same shape, made one.

use std::collections::HashMap;

use crate::digits::shifts::Way;
use crate::directed::error::{MOST_FOUND_MAPS, MOST_FOUND_STATES};
use crate::error::MAX_MAPS;

/// The states that are left of a graph.
pub(crate) struct Merged {
    /// For each the state of the larger graph that is met first; state 0 stays the first.
    pub firsts: Vec<usize>,
    /// The ways from each, without repetitions.
    pub ways: Vec<Vec<Way>>,
}

/// Ways that are looked at in all: some seconds.
const MOST_LOOKS: usize = 20_000_000;

/// The graph with those states made one from which the same ways begin, all along (Moore 1956). `None` where more are
/// left, or more ways from one or from all, than a graph-directed system may have, or they take too many looks.
pub(crate) fn merged(graph: &[Vec<Way>]) -> Option<Merged> {
    let count = graph.len();
    let mut class = vec![0; count];
    let mut classes = count.min(1);
    let each: usize = graph.iter().map(Vec::len).sum();
    let mut looks = 0;
    let signature = |class: &[usize], state: usize| {
        let mut ways: Vec<Way> = graph[state].iter().map(|way| Way { to: class[way.to], ..*way }).collect();
        ways.sort_unstable();
        ways.dedup();
        ways
    };
    loop {
        let mut names = HashMap::new();
        let mut next = Vec::with_capacity(count);
        for (state, &old) in class.iter().enumerate() {
            let fresh = names.len();
            next.push(*names.entry((old, signature(&class, state))).or_insert(fresh));
        }
        // Classes only split, so that there is an end after as many rounds as there may be states.
        let split = names.len();
        looks += each;
        if split > MOST_FOUND_STATES || looks > MOST_LOOKS {
            return None;
        }
        class = next;
        if split == classes {
            break;
        }
        classes = split;
    }
    let first = |label: usize| class.iter().position(|&other| other == label).unwrap_or(0);
    let firsts: Vec<usize> = (0..classes).map(first).collect();
    let ways: Vec<Vec<Way>> = firsts.iter().map(|&state| signature(&class, state)).collect();
    let few = ways.iter().all(|ways| ways.len() <= MAX_MAPS);
    let all: usize = ways.iter().map(Vec::len).sum();
    (few && all <= MOST_FOUND_MAPS).then_some(Merged { firsts, ways })
}
