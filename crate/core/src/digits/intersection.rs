//! What two shapes of one grid share: a graph, and what is known from it.

use glam::DVec2;

use crate::digits::error::DigitError;
use crate::directed::dimension::directed_dimension;
use crate::directed::map::DirectedMap;
use crate::directed::system::DirectedIfs;
use crate::error::MAX_MAPS;
use crate::linear::affine::Affine2;

/// The intersection of two shapes of one grid, the second moved by a fraction, as a graph-directed system.
///
/// Let A have the digits D and B the digits D', both with the matrix M, and write `X_t` for what A shares with B
/// moved by t. A point of A begins with a digit d, one of B with a digit d', and what is left of them is
/// `M t + d' - d` apart:
///
/// ```text
/// X_t = union over d, d' of  M^-1 (X_t' + d),   t' = M t + d' - d
/// ```
///
/// (Bondarenko & Kravchenko 2010, arXiv:1003.6046, measure such intersections by it; neighbour graphs of tiles are made
/// in the same way). Where t is a fraction, all t' have its denominator; only those count that go on for ever without
/// leaving the bound of A - B, and these are finitely many. They are found in whole numbers.
///
/// These shifts are the states, `K_i = union of M^-1 (K_j + d)`; or, where that makes a simpler graph, the sets of
/// shifts that are met after the same digits of A, so that a state has one arrow for each digit at most (the subset
/// construction, Rabin & Scott 1959). States from which the same arrows begin are one (Moore 1956).
#[derive(Clone, Debug, PartialEq)]
pub struct GridIntersection {
    /// The states; the first is the intersection. None where the shapes do not meet.
    pub states: Vec<GridState>,
    /// The denominator of all shifts, in lowest terms with the one that was asked for.
    pub denominator: i64,
    /// How many shifts lead on for ever.
    pub shifts: usize,
    /// Whether [`GridIntersection::dimension`] is the Hausdorff dimension and not only a bound: digits leave
    /// different remainders ([`keeps_apart`](crate::DigitSystem::keeps_apart)), those of the first shape, and where a
    /// state is one shift, of both.
    pub is_exact: bool,
    pub(crate) maps: Vec<Affine2>,
}

/// A kind of piece that an intersection is made of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GridState {
    /// It is the part of the first shape that lies in the second moved by any of these, one or more: numerators over
    /// the [denominator](GridIntersection::denominator).
    pub shifts: Vec<[i64; 2]>,
    /// Its pieces: the digit of the first shape and the state that is copied there, both from 0.
    pub copies: Vec<(usize, usize)>,
}

/// How many ways there are through the graph of an intersection, and so points at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AddressCount {
    /// So many, or `u64::MAX` where there are more.
    Finite(u64),
    /// As many as there are whole numbers.
    Countable,
    /// More than that.
    Uncountable,
}

/// Addresses of points that are listed at most, and the distance, relative to their size, below which two are one.
const MOST_POINTS: u64 = 4096;
const SAME_POINT: f64 = 1e-10;
/// Steps of the search for maps.
const MOST_STEPS: usize = 10_000;

impl GridIntersection {
    /// Whether the shapes do not meet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.states.is_empty()
    }

    /// The graph-directed system, whose state 0 is the intersection. `None` where it is empty.
    ///
    /// # Errors
    /// [`DigitError::Directed`] where the maps contract too slowly for it to be proved that they do.
    pub fn system(&self) -> Result<Option<DirectedIfs>, DigitError> {
        if self.is_empty() {
            return Ok(None);
        }
        let map = |&(digit, from): &(usize, usize)| DirectedMap { from, map: self.maps[digit] };
        let states = self.states.iter().map(|state| state.copies.iter().map(map).collect());
        Ok(Some(DirectedIfs::found(states.collect())?))
    }

    /// The dimension by the graph, `log r / log b` where M scales by b and the paths of the graph grow like powers of r
    /// (Mauldin & Williams 1988). `None` where it is empty, or M is no similarity.
    ///
    /// Where [`is_exact`](Self::is_exact) it is the Hausdorff dimension. Pieces of the first shape are among those of a
    /// tile (Bandt 1991), which have no inner points in common: with one arrow for a digit, the graph obeys the open
    /// set condition. With one state for a shift there are at most so many times as many paths, as a piece of the first
    /// shape reaches only so many of the second. Where it is not exact it is not below the Hausdorff dimension.
    #[must_use]
    pub fn dimension(&self) -> Option<f64> {
        directed_dimension(&self.system().ok()??, 0)
    }

    /// How many addresses belong to it: endless ways through the graph. A point may have several.
    #[must_use]
    pub fn addresses(&self) -> AddressCount {
        let count = self.states.len();
        let reach: Vec<Vec<bool>> = (0..count).map(|state| self.reached(state)).collect();
        // One step at least.
        let back = |from: usize, to: usize| reach[to][from];
        let rounds = |state: usize| {
            self.states[state].copies.iter().filter(|&&(_, to)| to == state || back(state, to)).count()
        };
        if (0..count).any(|state| rounds(state) > 1) {
            return AddressCount::Uncountable;
        }
        let leaves_a_round = |state: usize| rounds(state) == 1 && self.states[state].copies.len() > 1;
        if (0..count).any(leaves_a_round) {
            return AddressCount::Countable;
        }
        // Every round goes on for ever by itself: what leads to them is a graph without rounds.
        let mut known = vec![None; count];
        let total = if count == 0 { 0 } else { self.ends(0, &rounds, &mut known) };
        AddressCount::Finite(total)
    }

    fn ends(&self, state: usize, rounds: &impl Fn(usize) -> usize, known: &mut [Option<u64>]) -> u64 {
        if let Some(count) = known[state] {
            return count;
        }
        let count = if rounds(state) > 0 {
            1
        } else {
            let copies = &self.states[state].copies;
            copies.iter().fold(0, |sum: u64, &(_, to)| sum.saturating_add(self.ends(to, rounds, known)))
        };
        known[state] = Some(count);
        count
    }

    /// The points that it is made of, where they are finitely many and have at most 4096 addresses; else `None`. What
    /// is nearer to each other than rounding tells counts as one point.
    #[must_use]
    pub fn points(&self) -> Option<Vec<DVec2>> {
        match self.addresses() {
            AddressCount::Finite(0) => Some(Vec::new()),
            AddressCount::Finite(count) if count <= MOST_POINTS => {
                let mut known = vec![None; self.states.len()];
                Some(self.points_of(0, &mut known))
            }
            _ => None,
        }
    }

    fn points_of(&self, state: usize, known: &mut [Option<Vec<DVec2>>]) -> Vec<DVec2> {
        if let Some(points) = &known[state] {
            return points.clone();
        }
        let (mut round, mut at, mut returns) = (Affine2::IDENTITY, state, false);
        // The only way on from a state that leads back to itself is the way back.
        for _ in 0..self.states.len() {
            let [(digit, to)] = self.states[at].copies[..] else { break };
            (round, at) = (round * self.maps[digit], to);
            returns = at == state;
            if returns {
                break;
            }
        }
        let mut points: Vec<DVec2> = returns.then(|| round.fixed_point()).flatten().into_iter().collect();
        if points.is_empty() {
            for &(digit, to) in &self.states[state].copies {
                for point in self.points_of(to, known) {
                    let point = self.maps[digit].apply(point);
                    let near = |other: &DVec2| other.distance(point) <= SAME_POINT * (1.0 + point.length());
                    if !points.iter().any(near) {
                        points.push(point);
                    }
                }
            }
        }
        known[state] = Some(points.clone());
        points
    }

    /// For each state whether `from` leads to it, by no steps or more.
    fn reached(&self, from: usize) -> Vec<bool> {
        let mut seen = vec![false; self.states.len()];
        let mut open = vec![from];
        while let Some(state) = open.pop() {
            if !std::mem::replace(&mut seen[state], true) {
                open.extend(self.states[state].copies.iter().map(|&(_, to)| to));
            }
        }
        seen
    }

    /// Maps whose attractor the intersection is, where the graph shows some: at most 64. They are the ways from a state
    /// back to itself, if all ways come back to it, seen through the only way that leads there. `None` where
    /// the graph shows none; there may be others all the same.
    #[must_use]
    pub fn attractor(&self) -> Option<Vec<Affine2>> {
        let mut at = 0;
        let mut lead = Affine2::IDENTITY;
        for _ in 0..self.states.len() {
            if let Some(ways) = self.first_returns(at) {
                let moved = ways.into_iter().map(|way| lead.undo().map(|back| lead * way * back));
                return moved.collect::<Result<_, _>>().ok();
            }
            let [(digit, to)] = self.states[at].copies[..] else { return None };
            lead = lead * self.maps[digit];
            at = to;
        }
        None
    }

    /// The ways from a state back to itself, if every way comes back and there are at most 64.
    fn first_returns(&self, root: usize) -> Option<Vec<Affine2>> {
        let mut found = Vec::new();
        let mut open = vec![(root, Affine2::IDENTITY, 0)];
        let mut steps = 0;
        while let Some((state, way, length)) = open.pop() {
            steps += 1;
            // What has gone on so long without the root has a round of its own.
            if length > self.states.len() || steps > MOST_STEPS {
                return None;
            }
            for &(digit, to) in self.states[state].copies.iter().rev() {
                let way = way * self.maps[digit];
                if to != root {
                    open.push((to, way, length + 1));
                } else if !found.contains(&way) {
                    // The same digits may lead back by other shifts.
                    found.push(way);
                }
            }
            if found.len() > MAX_MAPS {
                return None;
            }
        }
        Some(found)
    }
}
