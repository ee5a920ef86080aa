//! The graph of shifts, made so that every digit leads one way.

use std::collections::HashMap;

use crate::digits::shifts::{ShiftGraph, Way};

/// A graph whose states are sets of shifts: from each there is one way for a digit at most, to all shifts that the
/// digit leads to (the subset construction, Rabin & Scott 1959). An address of the first shape is a way here exactly
/// if it is one there, and no two ways have the same address.
#[derive(Clone, Debug, Default)]
pub(crate) struct SubsetGraph {
    /// The shifts of each state, as places in the graph of shifts, in their order.
    pub sets: Vec<Vec<usize>>,
    /// The ways from each state, in the order of their digits.
    pub ways: Vec<Vec<Way>>,
}

const MOST_SETS: usize = 4000;
/// Ways of shifts that are looked at in all.
const MOST_LOOKS: usize = 4_000_000;

impl SubsetGraph {
    /// `None` where it becomes too large.
    pub fn of(graph: &ShiftGraph, digits: usize) -> Option<Self> {
        let mut this = Self::default();
        if graph.shifts.is_empty() {
            return Some(this);
        }
        this.sets.push(vec![0]);
        let mut known = HashMap::from([(vec![0], 0)]);
        let mut looks = 0;
        while this.ways.len() < this.sets.len() {
            let mut next: Vec<Vec<usize>> = vec![Vec::new(); digits];
            for &shift in &this.sets[this.ways.len()] {
                looks += graph.ways[shift].len();
                for way in &graph.ways[shift] {
                    next[way.digit].push(way.to);
                }
            }
            if looks > MOST_LOOKS || this.sets.len() > MOST_SETS {
                return None;
            }
            let mut ways = Vec::new();
            for (digit, mut set) in next.into_iter().enumerate().filter(|(_, set)| !set.is_empty()) {
                set.sort_unstable();
                set.dedup();
                let to = *known.entry(set).or_insert_with_key(|set| {
                    this.sets.push(set.clone());
                    this.sets.len() - 1
                });
                ways.push(Way { digit, to });
            }
            this.ways.push(ways);
        }
        Some(this)
    }
}
