//! The neighbour graph: how two pieces that may meet lie to each other, at every size.
//!
//! (Bandt & Graf 1992 for similitudes.) Two pieces `A_u` and `A_v` lie to each other as `A` and `h(A)` do, with the
//! neighbour map `h = w_u^-1 w_v`. Splitting one of them leads to others: `h w_j` and `w_i^-1 h`. Those whose image
//! of the attractor is far from it are left out. An endless path in the graph proves that its two pieces meet, since
//! its maps stay bounded while the pieces shrink; where the graph is finite such a path comes back to where it was,
//! and then both addresses of the common point repeat themselves.
//!
//! Here the graph is found in floating point. What it says is only proposed: see `exact::quadratic` for what checks it.

use std::collections::{HashMap, VecDeque};

use frond_core::Affine2;

use crate::exact::address::Address;
use crate::exact::quadratic::QuadraticSystem;
use crate::frame::Frame;
use crate::support::table::SupportTable;

pub(crate) struct NeighbourGraph<'a> {
    frame: &'a Frame,
    support: &'a SupportTable,
    inverses: Vec<Affine2>,
    states: Vec<State>,
    index: HashMap<[i64; 6], u32>,
    /// The state of each pair of maps that was asked for, `None` if they are apart.
    roots: HashMap<(usize, usize), Option<u32>>,
    waiting: VecDeque<u32>,
    looks: usize,
    /// Pairs of words that were taken for one that is known: what [`NeighbourGraph::is_exact`] has to check.
    merged: Vec<(u32, Words)>,
}

type Words = [Vec<u8>; 2];

/// A neighbour map.
struct State {
    map: Affine2,
    /// The words u and v by which it was found first.
    words: Words,
    /// By how much errors have grown since.
    grown: f64,
    /// Which of the two pieces is split, 0 or 1.
    split: usize,
    /// The letter added to that word, and where it leads.
    next: Vec<(u8, u32)>,
    /// Whether what follows it was looked at.
    is_open: bool,
    /// Whether an endless path begins here.
    is_alive: bool,
}

/// Neighbour maps, and pairs of pieces, that are looked at most.
const MOST_NEIGHBOURS: usize = 3000;
const MOST_LOOKS: usize = 60_000;
/// Numbers of neighbour maps this near are taken for the same.
const CELLS_PER_UNIT: f64 = 4_194_304.0;
/// What of a number errors may have reached.
const LARGEST_ERROR: f64 = 1e-9;
/// Pieces that are nearer, in units of the attractor, may meet.
const MEETING_DISTANCE: f64 = 1e-6;
/// Directions tried on a pair.
const DIRECTIONS_PER_PAIR: usize = 4;
/// Beyond this stretch, two pieces that lie together have lost their likeness.
const LARGEST_STRETCH: f64 = 1e4;
/// States on the way of a loop that are tried for a shorter one.
const MOST_TRIED_IN_LOOP: usize = 60;

impl<'a> NeighbourGraph<'a> {
    /// `None` if a map has no inverse.
    pub fn new(frame: &'a Frame, support: &'a SupportTable) -> Option<Self> {
        let invert = |map: &Affine2| map.inverse().filter(|inverse| inverse.norm() < LARGEST_STRETCH);
        let inverses = frame.maps.iter().map(invert).collect::<Option<Vec<_>>>()?;
        Some(Self {
            frame,
            support,
            inverses,
            states: Vec::new(),
            index: HashMap::new(),
            roots: HashMap::new(),
            waiting: VecDeque::new(),
            looks: 0,
            merged: Vec::new(),
        })
    }

    /// Follows the pieces of these pairs of maps down, as far as the limits go; from either side, so that all
    /// neighbours are counted.
    pub fn explore(&mut self, pairs: &[(usize, usize)]) {
        for (i, j) in pairs.iter().flat_map(|&(i, j)| [(i, j), (j, i)]) {
            let map = self.inverses[i] * self.frame.maps[j];
            let grown = self.inverses[i].norm();
            let root = self.state(map, [vec![i as u8], vec![j as u8]], grown);
            self.roots.insert((i, j), root);
        }
        while let Some(k) = self.waiting.pop_front() {
            if self.states.len() >= MOST_NEIGHBOURS || self.looks >= MOST_LOOKS {
                self.waiting.clear();
                break;
            }
            self.expand(k);
        }
        self.settle();
    }

    /// The state of a neighbour map, `None` if the two are apart.
    fn state(&mut self, map: Affine2, words: Words, grown: f64) -> Option<u32> {
        self.looks += 1;
        if !self.may_meet(&map) {
            return None;
        }
        // Off the grid by an odd bit, so that numbers that mean something do not lie on its lines.
        let key = map.to_row().map(|x| (x * CELLS_PER_UNIT + 0.3719).round() as i64);
        if let Some(&known) = self.index.get(&key) {
            self.merged.push((known, words));
            return Some(known);
        }
        let k = self.states.len() as u32;
        self.index.insert(key, k);
        // The larger piece; at the same size the second.
        let split = usize::from(map.determinant().abs() > 1.0 - 1e-6);
        self.states.push(State {
            map,
            words,
            grown,
            split,
            next: Vec::new(),
            is_open: true,
            is_alive: false,
        });
        if grown * self.frame.rounding < LARGEST_ERROR && map.norm() < LARGEST_STRETCH {
            self.waiting.push_back(k);
        }
        Some(k)
    }

    fn expand(&mut self, k: u32) {
        let State { map, split, grown, .. } = self.states[k as usize];
        let mut next = Vec::new();
        for letter in 0..self.frame.maps.len() {
            let (step, grows) = if split == 1 {
                (map * self.frame.maps[letter], 1.0)
            } else {
                (self.inverses[letter] * map, self.inverses[letter].norm())
            };
            let mut words = self.states[k as usize].words.clone();
            words[split].push(letter as u8);
            if let Some(to) = self.state(step, words, grown * grows) {
                next.push((letter as u8, to));
            }
        }
        let state = &mut self.states[k as usize];
        state.next = next;
        state.is_open = false;
    }

    fn may_meet(&self, map: &Affine2) -> bool {
        let back = map.linear.transpose();
        let mut step = map.translation;
        for _ in 0..DIRECTIONS_PER_PAIR {
            let (far_a, p) = self.support.support(step);
            let (far_b, q) = self.support.support(-(back * step));
            if step.dot(map.translation) - far_a - far_b > MEETING_DISTANCE * step.length() {
                return false;
            }
            let between = map.apply(q) - p;
            let turn = step - between;
            let length = turn.length_squared();
            if length == 0.0 {
                break;
            }
            step -= turn * (step.dot(turn) / length).clamp(0.0, 1.0);
        }
        true
    }

    /// Finds the states from which one can go on without end: all but those that lead nowhere.
    fn settle(&mut self) {
        let mut before: Vec<Vec<u32>> = vec![Vec::new(); self.states.len()];
        let mut ways: Vec<usize> = Vec::new();
        for (k, state) in self.states.iter().enumerate() {
            ways.push(state.next.len());
            for &(_, to) in &state.next {
                before[to as usize].push(k as u32);
            }
        }
        let mut dead: Vec<usize> = (0..ways.len()).filter(|&k| ways[k] == 0).collect();
        for state in &mut self.states {
            state.is_alive = true;
        }
        while let Some(k) = dead.pop() {
            self.states[k].is_alive = false;
            for &from in &before[k] {
                ways[from as usize] -= 1;
                if ways[from as usize] == 0 {
                    dead.push(from as usize);
                }
            }
        }
    }

    fn alive(&self, k: u32) -> impl Iterator<Item = (u8, u32)> + '_ {
        self.states[k as usize].next.iter().copied().filter(|&(_, to)| self.states[to as usize].is_alive)
    }

    /// A common point of the pieces of two maps, by its addresses in either, the shortest of those tried.
    pub fn common_point(&self, i: usize, j: usize) -> Option<(Address, Address)> {
        let root = self.roots.get(&(i, j)).copied().flatten()?;
        if !self.states[root as usize].is_alive {
            return None;
        }
        let (order, before) = self.search(root, None);
        let mut best: Option<(usize, Vec<u32>, Vec<u32>)> = None;
        for &k in order.iter().take(MOST_TRIED_IN_LOOP) {
            let head = way(root, k, &before);
            if best.as_ref().is_some_and(|(least, ..)| head.len() > *least) {
                break;
            }
            let (_, back) = self.search(k, Some(k));
            if !back.contains_key(&k) {
                continue;
            }
            let mut repeat = way_before(k, &back);
            repeat.push(k);
            let total = head.len() + repeat.len();
            if best.as_ref().is_none_or(|(least, ..)| total < *least) {
                best = Some((total, head, repeat));
            }
        }
        let (_, head, repeat) = best?;
        let mut heads = [vec![i as u8], vec![j as u8]];
        self.spell(&head, &mut heads);
        let mut repeats = [vec![], vec![]];
        self.spell(&repeat, &mut repeats);
        let ([a, b], [c, d]) = (heads, repeats);
        Some((Address::new(a, c)?, Address::new(b, d)?))
    }

    /// All states that can be reached, nearest first, and where each was reached from; up to `until`.
    fn search(&self, from: u32, until: Option<u32>) -> (Vec<u32>, HashMap<u32, u32>) {
        let (mut order, mut before) = (vec![from], HashMap::new());
        let mut at = 0;
        while let Some(&k) = order.get(at) {
            at += 1;
            for (_, to) in self.alive(k) {
                if to != from && !before.contains_key(&to) {
                    before.insert(to, k);
                    order.push(to);
                } else if Some(to) == until {
                    before.insert(to, k);
                    return (order, before);
                }
            }
        }
        (order, before)
    }

    /// Appends the letters met along a way through states.
    fn spell(&self, way: &[u32], words: &mut Words) {
        for step in way.windows(2) {
            let state = &self.states[step[0] as usize];
            if let Some((letter, _)) = state.next.iter().find(|(_, to)| *to == step[1]) {
                words[state.split].push(*letter);
            }
        }
    }

    /// Whether the graph is finite: all that can be reached was looked at.
    pub fn is_closed(&self) -> bool {
        self.states.iter().all(|state| !state.is_open)
    }

    /// How many neighbour maps there are of pieces of like size that meet.
    pub fn types(&self) -> usize {
        self.states.iter().filter(|state| state.is_alive && state.split == 1).count()
    }

    /// Whether pieces share infinitely many points: a loop that can be left for another.
    pub fn share_many(&self) -> bool {
        let fork = |k: u32| self.states[k as usize].is_alive && self.alive(k).count() > 1;
        (0..self.states.len() as u32).any(|k| fork(k) && self.search(k, Some(k)).1.contains_key(&k))
    }

    /// Whether every two neighbour maps that were taken for the same are so, exactly.
    pub fn is_exact(&self, system: &QuadraticSystem) -> bool {
        const MOST_MERGED: usize = 3000;
        self.merged.len() <= MOST_MERGED
            && self.merged.iter().all(|(k, [u, v])| {
                let [s, t] = &self.states[*k as usize].words;
                system.same_neighbour((u, v), (s, t))
            })
    }
}

/// The states on the way from one to another, both included.
fn way(from: u32, to: u32, before: &HashMap<u32, u32>) -> Vec<u32> {
    let mut way = vec![to];
    let mut k = to;
    while k != from {
        k = before[&k];
        way.push(k);
    }
    way.reverse();
    way
}

/// The states on the way round a loop, the last step left out.
fn way_before(k: u32, before: &HashMap<u32, u32>) -> Vec<u32> {
    way(k, before[&k], before)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with<T>(maps: &[Affine2], work: impl FnOnce(&mut NeighbourGraph<'_>) -> T) -> T {
        let mut frame = Frame::default();
        frame.set(maps).unwrap();
        let mut support = SupportTable::default();
        support.set(&frame.maps, 1e-4 * (1.0 - frame.factor), 4000);
        let mut neighbours = NeighbourGraph::new(&frame, &support).unwrap();
        let count = maps.len();
        let pairs: Vec<_> = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j))).collect();
        neighbours.explore(&pairs);
        work(&mut neighbours)
    }

    fn rows(rows: &[[f64; 6]]) -> Vec<Affine2> {
        rows.iter().copied().map(Affine2::from_row).collect()
    }

    #[test]
    fn the_gasket_has_six_neighbours_and_single_points() {
        let gasket = rows(&[
            [0.5, 0.0, 0.0, 0.5, 0.0, 0.0],
            [0.5, 0.0, 0.0, 0.5, 0.5, 0.0],
            [0.5, 0.0, 0.0, 0.5, 0.25, 0.375],
        ]);
        let system = QuadraticSystem::as_given(&gasket).unwrap();
        with(&gasket, |graph| {
            assert!(graph.is_closed() && graph.is_exact(&system) && !graph.share_many());
            assert_eq!(graph.types(), 6);
            let (a, b) = graph.common_point(0, 2).unwrap();
            assert_eq!((a.shown(3), b.shown(3)), ("1(3)".into(), "3(1)".into()));
        });
    }

    #[test]
    fn tiles_have_as_many_neighbours_as_is_known() {
        let twindragon = rows(&[[0.5, 0.5, -0.5, 0.5, -0.5, 0.375], [0.5, 0.5, -0.5, 0.5, 0.5, 0.625]]);
        let square: Vec<[f64; 6]> = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [0.5, 0.5]]
            .map(|[e, f]| [0.5, 0.0, 0.0, 0.5, e, f])
            .to_vec();
        for (maps, wanted) in [(twindragon, 6), (rows(&square), 8)] {
            let system = QuadraticSystem::as_given(&maps).unwrap();
            with(&maps, |graph| {
                assert!(graph.is_closed() && graph.is_exact(&system) && graph.share_many());
                assert_eq!(graph.types(), wanted);
            });
        }
    }

    #[test]
    fn what_is_apart_has_no_endless_path_and_what_overlaps_does_not_close() {
        let third = 1.0 / 3.0;
        let cantor = rows(&[[third, 0.0, 0.0, third, 0.0, 0.0], [third, 0.0, 0.0, third, 2.0 * third, 0.0]]);
        with(&cantor, |graph| assert!(graph.is_closed() && graph.common_point(0, 1).is_none()));
        let any = rows(&[[0.62, -0.41, 0.37, 0.66, 0.0, 0.0], [0.59, 0.3, -0.43, 0.61, 1.0, 0.0]]);
        with(&any, |graph| assert!(!graph.is_closed()));
    }
}
