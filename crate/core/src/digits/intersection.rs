//! What two shapes of one grid share.

use glam::DVec2;

use crate::digits::error::{DigitError, LARGEST_DENOMINATOR, LARGEST_NUMERATOR};
use crate::digits::merging::merged;
use crate::digits::reach::gcd;
use crate::digits::shifts::ShiftGraph;
use crate::digits::subsets::SubsetGraph;
use crate::digits::system::DigitSystem;
use crate::directed::dimension::directed_dimension;
use crate::directed::map::DirectedMap;
use crate::directed::system::DirectedIfs;
use crate::error::MAX_MAPS;
use crate::linear::affine::Affine2;

/// The intersection of two shapes of one grid, the second moved by a fraction, as a graph-directed system.
///
/// Let A have the digits D and B the digits D', both with the matrix M, and write `X_t` for what A shares with B
/// moved by t. A point of A begins with a digit d, one of B with a digit d', and what is left of them is `M t + d' -
/// d` apart:
///
/// ```text
/// X_t = union over d, d' of  M^-1 (X_t' + d),   t' = M t + d' - d
/// ```
///
/// (Bondarenko & Kravchenko 2010, arXiv:1003.6046, measure such intersections by it; neighbour graphs of tiles are
/// made in the same way). Where t is a fraction, all t' have its denominator; only those count that go on for ever
/// without leaving the bound of A - B, and these are finitely many. They are found in whole numbers. Several t' that
/// are met after the same digits of A are made one state, and states from which the same digits begin as well, so
/// that a state has one arrow for each digit at most: `K_i = union of M^-1 (K_j + d)`.
#[derive(Clone, Debug, PartialEq)]
pub struct GridIntersection {
    /// The states; the first is the intersection. None where the shapes do not meet.
    pub states: Vec<GridState>,
    /// The denominator of all shifts, in lowest terms with the one that was asked for.
    pub denominator: i64,
    /// How many shifts lead on for ever.
    pub shifts: usize,
    /// Whether the dimension of [`GridIntersection::dimension`] is the true one and not only a bound: whether the
    /// digits of the first shape leave different remainders ([`DigitSystem::keeps_apart`]).
    pub is_exact: bool,
    maps: Vec<Affine2>,
}

/// A kind of piece that an intersection is made of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GridState {
    /// It is the part of the first shape that lies in the second moved by any of these: numerators over the
    /// [denominator](GridIntersection::denominator).
    pub shifts: Vec<[i64; 2]>,
    /// Its pieces: the digit of the first shape and the state that is copied there, both from 0.
    pub copies: Vec<(usize, usize)>,
}

/// How many addresses, and so points at most, an intersection has.
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

/// Intersects a shape of a grid with another, moved by `numerators / denominator`.
///
/// # Errors
/// [`DigitError`] where the matrices differ, the shift is no such fraction, or the graph becomes too large.
///
/// ```
/// use frond_core::{AddressCount, DigitSystem, grid_intersection};
///
/// // Cantor's set and itself, moved by a quarter: two copies of a ninth of its size.
/// let cantor = DigitSystem::new([3, 0, 0, 3], vec![[0, 0], [2, 0]])?;
/// let shared = grid_intersection(&cantor, &cantor, [1, 0], 4)?;
/// assert_eq!(shared.states.len(), 2);
/// assert_eq!(shared.attractor().map(|maps| maps.len()), Some(2));
/// assert!((shared.dimension().unwrap_or(0.0) - 2.0_f64.ln() / 9.0_f64.ln()).abs() < 1e-12);
/// assert_eq!(shared.addresses(), AddressCount::Uncountable);
/// # Ok::<(), frond_core::DigitError>(())
/// ```
pub fn grid_intersection(
    first: &DigitSystem,
    second: &DigitSystem,
    numerators: [i64; 2],
    denominator: i64,
) -> Result<GridIntersection, DigitError> {
    if first.matrix() != second.matrix() {
        return Err(DigitError::Matrices);
    }
    let fits = |x: &i64| (-LARGEST_NUMERATOR..=LARGEST_NUMERATOR).contains(x);
    if !(1..=LARGEST_DENOMINATOR).contains(&denominator) || !numerators.iter().all(fits) {
        return Err(DigitError::Shift);
    }
    let shared = numerators.iter().fold(i128::from(denominator), |sum, &x| gcd(sum, i128::from(x).abs()));
    // It divides the denominator, and so is one.
    let shared = i64::try_from(shared).unwrap_or(1);
    let (numerators, denominator) = (numerators.map(|x| x / shared), denominator / shared);
    let graph = ShiftGraph::of(first, second, numerators, denominator)?;
    let subsets = SubsetGraph::of(&graph, first.digits().len())?;
    let (firsts, ways) = merged(&subsets)?;
    let states = firsts.iter().zip(ways).map(|(&state, ways)| GridState {
        shifts: subsets.sets[state].iter().map(|&shift| graph.shifts[shift]).collect(),
        copies: ways.iter().map(|way| (way.digit, way.to)).collect(),
    });
    Ok(GridIntersection {
        states: states.collect(),
        denominator,
        shifts: graph.shifts.len(),
        is_exact: first.keeps_apart(),
        maps: (0..first.digits().len()).map(|digit| first.map(digit)).collect(),
    })
}

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
        Ok(Some(DirectedIfs::new(states.collect())?))
    }

    /// The dimension by the graph, `log r / log b` where M scales by b and the paths of the graph grow like powers of r
    /// (Mauldin & Williams 1988). `None` where it is empty, or M is no similarity.
    ///
    /// Where [`is_exact`](Self::is_exact) it is the Hausdorff dimension: all pieces are those of a tile that holds
    /// them, at different addresses, which have no inner points in common. Else it is not below it.
    #[must_use]
    pub fn dimension(&self) -> Option<f64> {
        directed_dimension(&self.system().ok()??, 0)
    }

    /// How many addresses of the first shape belong to it. A point may have several.
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
        while let Some((state, way, length)) = open.pop() {
            // What has gone on so long without the root has a round of its own.
            if length > self.states.len() {
                return None;
            }
            for &(digit, to) in self.states[state].copies.iter().rev() {
                let way = way * self.maps[digit];
                if to == root {
                    found.push(way);
                } else {
                    open.push((to, way, length + 1));
                }
            }
            if found.len() > MAX_MAPS {
                return None;
            }
        }
        Some(found)
    }
}
