//! The attractorlet-overlap graph and its components.

use std::cell::Cell;

/// Which pieces belong together: a union-find forest.
///
/// It answers what Burch & Hart's Theorem 3 asks of the powers of an adjacency matrix, in almost linear time.
#[derive(Clone, Debug, Default)]
pub struct Components {
    /// Towards the root of each piece. A cell, so that a look-up may shorten the way for the next.
    parent: Vec<Cell<u16>>,
    count: usize,
}

impl Components {
    /// `pieces` pieces, each for itself; at most 65,536.
    #[must_use]
    pub fn new(pieces: usize) -> Self {
        let mut components = Self::default();
        components.reset(pieces);
        components
    }

    /// Starts again with `pieces` pieces, each for itself, and keeps the memory.
    pub fn reset(&mut self, pieces: usize) {
        debug_assert!(pieces <= usize::from(u16::MAX) + 1);
        self.parent.clear();
        self.parent.extend((0..pieces).map(|i| Cell::new(i as u16)));
        self.count = pieces;
    }

    /// A piece that stands for the component of piece `i`.
    #[inline]
    #[must_use]
    pub fn root(&self, mut i: usize) -> usize {
        loop {
            let parent = self.parent[i].get();
            if usize::from(parent) == i {
                return i;
            }
            let above = self.parent[usize::from(parent)].get();
            self.parent[i].set(above);
            i = usize::from(above);
        }
    }

    /// Whether two pieces are in one component.
    #[inline]
    #[must_use]
    pub fn joined(&self, i: usize, j: usize) -> bool {
        self.root(i) == self.root(j)
    }

    /// Puts two pieces into one component; `false` if they were in one already.
    pub fn join(&mut self, i: usize, j: usize) -> bool {
        let (a, b) = (self.root(i), self.root(j));
        if a == b {
            return false;
        }
        // The smaller number is the root, so that labels do not depend on the order of the joins.
        self.parent[a.max(b)].set(a.min(b) as u16);
        self.count -= 1;
        true
    }

    /// How many components there are.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// For each piece the number of its component, from 0, in the order of their first pieces.
    #[must_use]
    pub fn labels(&self) -> Vec<usize> {
        let mut label = vec![usize::MAX; self.parent.len()];
        let mut next = 0;
        for i in 0..self.parent.len() {
            let root = self.root(i);
            if label[root] == usize::MAX {
                label[root] = next;
                next += 1;
            }
            label[i] = label[root];
        }
        label
    }
}

/// The attractorlet-overlap graph: its vertices are the pieces of an attractor, and an edge joins two
/// that meet (Burch & Hart 1997, definition 3). The attractor is connected if and only if this graph is
/// (Hata 1985; Burch & Hart's theorem 2).
#[derive(Clone, Debug)]
pub struct OverlapGraph {
    neighbours: Vec<Vec<usize>>,
    components: Components,
}

impl OverlapGraph {
    /// A graph of `pieces` pieces and no edge.
    #[must_use]
    pub fn new(pieces: usize) -> Self {
        Self { neighbours: vec![Vec::new(); pieces], components: Components::new(pieces) }
    }

    /// Adds the edge between `i` and `j`, once, whichever way round it is given.
    pub fn add(&mut self, i: usize, j: usize) {
        if i == j || self.neighbours[i].contains(&j) {
            return;
        }
        for (from, to) in [(i, j), (j, i)] {
            let at = self.neighbours[from].partition_point(|&k| k < to);
            self.neighbours[from].insert(at, to);
        }
        self.components.join(i, j);
    }

    /// The pieces that piece `i` meets, in ascending order.
    #[must_use]
    pub fn neighbours(&self, i: usize) -> &[usize] {
        &self.neighbours[i]
    }

    /// Every edge once, the smaller number first, in ascending order.
    #[must_use]
    pub fn edges(&self) -> Vec<(usize, usize)> {
        let all = self.neighbours.iter().enumerate();
        all.flat_map(|(i, to)| to.iter().filter(move |&&j| i < j).map(move |&j| (i, j))).collect()
    }

    /// The components of the graph.
    #[must_use]
    pub const fn components(&self) -> &Components {
        &self.components
    }

    /// Whether every piece can be reached from every other. A graph without pieces is connected.
    #[must_use]
    pub const fn is_connected(&self) -> bool {
        self.components.count() <= 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_kept_once_and_both_ways() {
        let mut graph = OverlapGraph::new(4);
        for (i, j) in [(2, 1), (1, 2), (0, 1), (3, 3)] {
            graph.add(i, j);
        }
        assert_eq!(graph.edges(), [(0, 1), (1, 2)]);
        assert_eq!(graph.neighbours(1), [0, 2]);
        assert_eq!(graph.components().labels(), [0, 0, 0, 1]);
        assert!(!graph.is_connected());
        graph.add(3, 0);
        assert!(graph.is_connected());
        assert!(OverlapGraph::new(0).is_connected() && OverlapGraph::new(1).is_connected());
    }

    #[test]
    fn long_chains_are_one_component() {
        let mut components = Components::new(1000);
        assert!((1..1000).rev().all(|i| components.join(i - 1, i)));
        assert!(!components.join(0, 999));
        assert_eq!(components.count(), 1);
        assert!(components.labels().iter().all(|&l| l == 0));
    }
}
