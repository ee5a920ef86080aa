//! Pieces up to what is around them, where some pieces are the same.
//!
//! All maps scale by one factor. A piece has for its type the pieces around it that it meets, seen from it, and the
//! types of its parts follow from its own (Ngai & Wang 2001). A part of several pieces is shared by them in equal
//! shares, and so each is counted once.

use std::collections::{BTreeSet, HashMap};

use crate::graph::growth::Weighted;
use crate::graph::neighbours::Graph;
use crate::number::interval::Interval;

/// The graph of types, from the state that is meant. `None` where there are more than the budget.
pub(crate) fn types(graph: &Graph, ratio: Interval, budget: usize) -> Option<(usize, Vec<Weighted>)> {
    let mut all: Vec<(usize, Vec<usize>)> = vec![(0, vec![0])];
    let mut numbers: HashMap<(usize, Vec<usize>), usize> = HashMap::from([(all[0].clone(), 0)]);
    let (mut steps, mut next) = (Vec::new(), 0);
    while next < all.len() {
        let (_, around) = all[next].clone();
        let own = all[next].0;
        let edges: BTreeSet<usize> = graph.nodes[own].steps.iter().filter_map(|step| step.first).collect();
        for edge in edges {
            let mut beside = BTreeSet::new();
            let (mut parents, mut twins, mut child) = (0i64, 0i64, 0);
            for &node in &around {
                let mut is_parent = false;
                for step in graph.nodes[node].steps.iter().filter(|step| step.first == Some(edge)) {
                    beside.insert(step.to);
                    if graph.nodes[step.to].is_same {
                        (is_parent, child) = (true, step.to);
                        twins += i64::from(node == own);
                    }
                }
                parents += i64::from(is_parent);
            }
            let key = (child, beside.into_iter().collect::<Vec<_>>());
            let to = *numbers.entry(key.clone()).or_insert_with(|| {
                all.push(key);
                all.len() - 1
            });
            let weight = Interval::ONE / Interval::of_i64(parents * twins);
            steps.push(Weighted { from: next, to, weight, ratio });
            if all.len() > budget {
                return None;
            }
        }
        next += 1;
    }
    Some((all.len(), steps))
}
