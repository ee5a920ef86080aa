//! States that stand for the same shape, made one.

use std::collections::HashMap;

use crate::digits::error::DigitError;
use crate::digits::shifts::Way;
use crate::digits::subsets::SubsetGraph;
use crate::directed::error::MAX_STATES;

/// The least graph with the same addresses: states from which the same addresses begin are one (Moore 1956). Of each
/// state the one of the larger graph that is met first, and its ways; state 0 stays the first.
pub(crate) fn merged(graph: &SubsetGraph) -> Result<(Vec<usize>, Vec<Vec<Way>>), DigitError> {
    let count = graph.sets.len();
    let mut class = vec![0; count];
    let mut classes = count.min(1);
    loop {
        let mut names: HashMap<(usize, Vec<Way>), usize> = HashMap::new();
        let mut next = Vec::with_capacity(count);
        for (state, ways) in graph.ways.iter().enumerate() {
            let ways = ways.iter().map(|way| Way { to: class[way.to], ..*way }).collect();
            let fresh = names.len();
            next.push(*names.entry((class[state], ways)).or_insert(fresh));
        }
        // Classes only split, so that there is an end after as many rounds as there may be states.
        let split = names.len();
        if split > MAX_STATES {
            return Err(DigitError::TooManyStates);
        }
        class = next;
        if split == classes {
            break;
        }
        classes = split;
    }
    let first = |label: usize| class.iter().position(|&other| other == label).unwrap_or(0);
    let firsts: Vec<usize> = (0..classes).map(first).collect();
    let ways = firsts
        .iter()
        .map(|&state| graph.ways[state].iter().map(|way| Way { to: class[way.to], ..*way }).collect());
    let ways = ways.collect();
    Ok((firsts, ways))
}
