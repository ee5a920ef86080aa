//! Which map becomes which, and by how many turns.

use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

use glam::DVec2;

use crate::bounds::hull2::Hull;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::morph::interpolation::Morph;
use crate::morph::options::{Kind, MorphError, MorphOptions};
use crate::morph::pairing::assignment;
use crate::order::Total;

/// A way to match the maps of two systems, for [`MorphOptions`].
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// `correspondence[i]` is the map of the last system that map i of the first becomes.
    pub correspondence: Vec<usize>,
    /// Whole extra turns of each map.
    pub turns: Vec<i32>,
    /// How far the maps have to move, turn and stretch, in all: the smaller, the plainer.
    pub cost: f64,
}

/// Up to so many maps, every matching is looked at.
const MOST_MATCHED_ALL_WAYS: usize = 5;
/// The extra turns that are tried.
const WINDINGS: [i32; 3] = [0, 1, -1];

/// Ways to match the maps of two systems, the plainest first, at most `limit`; the given order without extra turns is
/// always among them.
///
/// Up to five maps: all permutations, each with up to one extra turn of each map either way. More: the assignment that
/// moves the maps least, and what comes of it by swapping maps and by turning single ones. The cost of a match is a
/// rough one, taken from the maps alone: how far the place of a piece and its fixed point move in proportion to the
/// shape, how far it turns, how much its stretch changes, and whether it has to be turned over. What a match is worth,
/// only its path tells.
///
/// # Errors
/// [`MorphError::Counts`] if the systems have different numbers of maps.
pub fn candidates(from: &Ifs, to: &Ifs, limit: usize) -> Result<Vec<Candidate>, MorphError> {
    if from.len() != to.len() {
        return Err(MorphError::Counts { from: from.len(), to: to.len() });
    }
    let costs = Costs::of(from.maps(), to.maps(), [Frame::of(from), Frame::of(to)]);
    let count = from.len();
    let mut found = if count <= MOST_MATCHED_ALL_WAYS { costs.all(limit) } else { costs.near(limit) };
    let identity = costs.candidate((0..count).collect(), vec![0; count]);
    let order = |candidate: &Candidate| {
        // Fewer extra turns first where the cost is the same to rounding.
        let turns = candidate.turns.iter().map(|t| t.abs()).sum::<i32>();
        ((candidate.cost * 1e9).round(), turns)
    };
    found.sort_unstable_by(|a, b| {
        let ((x, s), (y, t)) = (order(a), order(b));
        let names = || (&a.correspondence, &a.turns).cmp(&(&b.correspondence, &b.turns));
        x.total_cmp(&y).then(s.cmp(&t)).then_with(names)
    });
    found.truncate(limit.max(1));
    let same =
        |other: &Candidate| other.correspondence == identity.correspondence && other.turns == identity.turns;
    if !found.iter().any(same) {
        if found.len() >= limit.max(1) {
            found.pop();
        }
        found.push(identity);
    }
    Ok(found)
}

impl Candidate {
    /// The candidate of a given matching.
    ///
    /// # Errors
    /// [`MorphError`] if the matching does not fit the systems: see [`MorphOptions`].
    pub fn of(from: &Ifs, to: &Ifs, correspondence: Vec<usize>, turns: Vec<i32>) -> Result<Self, MorphError> {
        let options = MorphOptions { correspondence, turns, ..MorphOptions::default() };
        Morph::new(from.maps(), to.maps(), &options)?;
        let MorphOptions { mut correspondence, mut turns, .. } = options;
        if correspondence.is_empty() {
            correspondence = (0..from.len()).collect();
        }
        turns.resize(from.len(), 0);
        Ok(Costs::of(from.maps(), to.maps(), [Frame::of(from), Frame::of(to)])
            .candidate(correspondence, turns))
    }
}

/// Where a shape is and how large, to compare the places of pieces by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    centre: DVec2,
    size: f64,
}

impl Frame {
    pub fn of(ifs: &Ifs) -> Self {
        let hull = Hull::of(ifs);
        Self { centre: hull.centre(), size: hull.diameter().max(f64::MIN_POSITIVE) }
    }

    fn place(&self, point: DVec2) -> DVec2 {
        (point - self.centre) / self.size
    }
}

/// What each map costs to become each of the others, by winding.
pub(crate) struct Costs {
    from: Vec<Affine2>,
    to: Vec<Affine2>,
    /// `cost[i][j][t]`
    cost: Vec<Vec<[f64; WINDINGS.len()]>>,
    opposite: Vec<Vec<bool>>,
}

impl Costs {
    pub fn of(from: &[Affine2], to: &[Affine2], frames: [Frame; 2]) -> Self {
        let both = |i: usize, j: usize| pair_cost(from[i], to[j], frames);
        let table: Vec<Vec<_>> =
            (0..from.len()).map(|i| (0..to.len()).map(|j| both(i, j)).collect()).collect();
        Self {
            from: from.to_vec(),
            to: to.to_vec(),
            cost: table.iter().map(|row| row.iter().map(|entry| entry.0).collect()).collect(),
            opposite: table.iter().map(|row| row.iter().map(|entry| entry.1).collect()).collect(),
        }
    }

    pub fn candidate(&self, correspondence: Vec<usize>, turns: Vec<i32>) -> Candidate {
        let cost = (0..correspondence.len()).map(|i| {
            let windings = self.cost[i][correspondence[i]];
            let [plain, more, less] = windings;
            let t = f64::from(turns[i]);
            match WINDINGS.iter().position(|&winding| winding == turns[i]) {
                Some(k) => windings[k],
                // It is a parabola of the winding.
                None => plain + 0.5 * (more - less) * t + (0.5 * (more + less) - plain) * t * t,
            }
        });
        let cost = cost.sum();
        Candidate { correspondence, turns, cost }
    }

    /// The matching of least cost, in which no map turns over if there is such a one.
    pub fn best(&self) -> Vec<usize> {
        let sides = |opposite: bool| if opposite { 1e6 } else { 0.0 };
        let row =
            |i: usize| (0..self.to.len()).map(|j| self.cost[i][j][0] + sides(self.opposite[i][j])).collect();
        let cost: Vec<Vec<f64>> = (0..self.from.len()).map(row).collect();
        assignment(&cost)
    }

    /// The maps that turn over.
    pub fn overturned(&self, correspondence: &[usize]) -> Vec<usize> {
        (0..correspondence.len()).filter(|&i| self.opposite[i][correspondence[i]]).collect()
    }

    /// Whether equal maps stand in their order: swapping them would change nothing.
    fn is_first(&self, correspondence: &[usize]) -> bool {
        (0..correspondence.len()).all(|i| {
            (0..i).all(|k| {
                let (a, b) = (correspondence[k], correspondence[i]);
                a < b || self.from[k] != self.from[i] && self.to[a] != self.to[b]
            })
        })
    }

    /// The best `limit` of all permutations and windings.
    fn all(&self, limit: usize) -> Vec<Candidate> {
        let count = self.from.len();
        let base = WINDINGS.len();
        let mut orders = Vec::new();
        // Cost, extra turns, and the names of permutation and windings: nothing is allocated for each.
        let mut found: Vec<(f64, u32, usize, usize)> = Vec::new();
        let mut order: Vec<usize> = (0..count).collect();
        loop {
            if self.is_first(&order) {
                for code in 0..base.pow(count as u32) {
                    let (mut cost, mut turns, mut rest) = (0.0, 0, code);
                    for (i, &j) in order.iter().enumerate() {
                        let k = rest % base;
                        rest /= base;
                        cost += self.cost[i][j][k];
                        turns += WINDINGS[k].unsigned_abs();
                    }
                    found.push(((cost * 1e9).round(), turns, orders.len(), code));
                }
                orders.push(order.clone());
            }
            if !next_permutation(&mut order) {
                break;
            }
        }
        found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2, a.3).cmp(&(b.1, b.2, b.3))));
        found.truncate(limit.max(1));
        let candidate = |&(_, _, order, code): &(f64, u32, usize, usize)| {
            let digit = |i: usize| code / base.pow(i as u32) % base;
            self.candidate(orders[order].clone(), (0..count).map(|i| WINDINGS[digit(i)]).collect())
        };
        found.iter().map(candidate).collect()
    }

    /// The best assignment and its neighbours by swaps, best first, and these with one map turned.
    fn near(&self, limit: usize) -> Vec<Candidate> {
        let count = self.from.len();
        let sum = |order: &[usize]| (0..count).map(|i| self.cost[i][order[i]][0]).sum::<f64>();
        let plain: Vec<Vec<f64>> =
            self.cost.iter().map(|row| row.iter().map(|winding| winding[0]).collect()).collect();
        let first = assignment(&plain);
        let mut seen = BTreeSet::from([first.clone()]);
        // The least cost first.
        let mut heap = BinaryHeap::from([Reverse((Total(sum(&first)), first))]);
        let mut found = Vec::new();
        while let Some(Reverse((_, order))) = heap.pop() {
            let plain = self.candidate(order.clone(), vec![0; count]);
            for i in 0..count {
                for turn in [1, -1] {
                    let mut turns = vec![0; count];
                    turns[i] = turn;
                    found.push(self.candidate(order.clone(), turns));
                }
            }
            found.push(plain);
            if found.len() >= limit.clamp(1, 64) * (2 * count + 1) {
                break;
            }
            for i in 0..count {
                for k in 0..i {
                    let mut swapped = order.clone();
                    swapped.swap(i, k);
                    let cost = sum(&swapped);
                    if self.from[i] != self.from[k]
                        && self.to[order[i]] != self.to[order[k]]
                        && seen.insert(swapped.clone())
                    {
                        heap.push(Reverse((Total(cost), swapped)));
                    }
                }
            }
        }
        found
    }
}

/// The cost of one map becoming another, by winding, and whether it turns over.
fn pair_cost(a: Affine2, b: Affine2, [first, last]: [Frame; 2]) -> ([f64; WINDINGS.len()], bool) {
    let place = first.place(a.apply(first.centre)).distance_squared(last.place(b.apply(last.centre)));
    let fixed = |map: Affine2, frame: Frame| frame.place(map.fixed_point().unwrap_or(frame.centre));
    let fixed = fixed(a, first).distance_squared(fixed(b, last));
    // One pair always makes a morph.
    let Ok(morph) = Morph::new(&[a], &[b], &MorphOptions::default()) else { return ([1e12; 3], false) };
    let (opposite, turn) = (morph.kinds()[0] == Kind::Opposite, morph.turns()[0].1);
    let ((a1, a2), (b1, b2)) = (a.singular_values(), b.singular_values());
    let stretch = (a1 - b1).powi(2) + (a2 - b2).powi(2);
    let cost = WINDINGS.map(|winding| {
        let half_turns = turn / std::f64::consts::PI + 2.0 * f64::from(winding);
        let cost =
            place + 0.25 * fixed + 0.25 * half_turns.powi(2) + 0.25 * stretch + f64::from(u8::from(opposite));
        if cost.is_finite() { cost.min(1e12) } else { 1e12 }
    });
    (cost, opposite)
}

/// The next order of the same numbers in the order of a dictionary; false after the last.
fn next_permutation(order: &mut [usize]) -> bool {
    let Some(k) = (1..order.len()).rev().find(|&k| order[k - 1] < order[k]) else { return false };
    let Some(l) = (k..order.len()).rev().find(|&l| order[l] > order[k - 1]) else { return false };
    order.swap(k - 1, l);
    order[k..].reverse();
    true
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::any_ifs;

    fn corners(angle: f64, places: &[[f64; 2]]) -> Ifs {
        let map = |&p: &[f64; 2]| Affine2::similitude(0.4, angle, DVec2::from_array(p));
        Ifs::new(places.iter().map(map).collect()).unwrap()
    }

    #[test]
    fn a_shuffled_shape_finds_its_own_maps() {
        for places in [
            &[[0.0, 0.0], [1.0, 0.0], [0.4, 0.9]][..],
            &[[0.0, 0.0], [1.0, 0.0], [0.4, 0.9], [2.0, 2.0], [-1.0, 0.5], [3.0, 0.0], [0.0, 3.0]],
        ] {
            let from = corners(0.0, places);
            let mut shuffled = places.to_vec();
            shuffled.reverse();
            let found = candidates(&from, &corners(0.0, &shuffled), 12).unwrap();
            let reversed: Vec<usize> = (0..places.len()).rev().collect();
            assert_eq!(found[0].correspondence, reversed);
            assert!(found[0].turns.iter().all(|&t| t == 0) && found[0].cost < 1e-9);
            assert_eq!(found.len(), 12);
            assert!(found.windows(2).all(|two| two[0].cost <= two[1].cost + 1e-8));
        }
    }

    #[test]
    fn half_turns_go_either_way() {
        let places = [[0.0, 0.0], [1.0, 0.0]];
        let found = candidates(&corners(0.0, &places), &corners(3.0, &places), 20).unwrap();
        // 3 radians forward, or nearly as well 3.28 back.
        let best: Vec<_> = found[..4].iter().map(|c| (c.correspondence.clone(), c.turns.clone())).collect();
        assert!(
            best.contains(&(vec![0, 1], vec![-1, -1])) || best.contains(&(vec![1, 0], vec![-1, -1])),
            "{best:?}"
        );
    }

    #[test]
    fn the_given_order_is_always_there() {
        let from = corners(0.0, &[[0.0, 0.0], [9.0, 0.0]]);
        let to = corners(0.0, &[[9.0, 0.0], [0.0, 0.0]]);
        for limit in [0, 1, 2, 5] {
            let found = candidates(&from, &to, limit).unwrap();
            assert!(found.len() <= limit.max(1));
            assert!(found.iter().any(|c| c.correspondence == [0, 1] && c.turns == [0, 0]), "{found:?}");
        }
        let three = corners(0.0, &[[0.0, 0.0], [1.0, 0.0], [2.0, 1.0]]);
        assert_eq!(candidates(&from, &three, 5), Err(MorphError::Counts { from: 2, to: 3 }));
    }

    #[test]
    fn equal_maps_are_not_swapped() {
        let twice = corners(0.3, &[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]]);
        let three = corners(0.0, &[[0.0, 0.0], [1.0, 0.0], [0.4, 0.9]]);
        // Three orders instead of six, with 27 windings each.
        assert_eq!(candidates(&twice, &three, 1000).unwrap().len(), 81);
        assert_eq!(candidates(&three, &twice, 1000).unwrap().len(), 81);
        assert_eq!(candidates(&three, &three, 1000).unwrap().len(), 162);
    }

    #[test]
    fn any_matching_has_a_cost() {
        let places = [[0.0, 0.0], [1.0, 0.0]];
        let (from, to) = (corners(0.0, &places), corners(1.0, &places));
        let cost = |t: i32| Candidate::of(&from, &to, vec![], vec![t, 0]).unwrap().cost;
        let turn = |t: i32| 0.25 * (1.0 / std::f64::consts::PI + 2.0 * f64::from(t)).powi(2);
        for t in [-16, -3, -1, 0, 1, 2, 7] {
            assert!((cost(t) - cost(0) - turn(t) + turn(0)).abs() < 1e-9 * cost(t), "{t}");
        }
        assert!(Candidate::of(&from, &to, vec![0, 0], vec![]).is_err());
    }

    #[test]
    fn sixty_four_equal_maps_are_no_burden() {
        let many = Ifs::new(vec![Affine2::similitude(0.1, 0.0, DVec2::ONE); 64]).unwrap();
        let found = candidates(&many, &many, 12).unwrap();
        assert_eq!(found[0].correspondence, (0..64).collect::<Vec<_>>());
    }

    proptest! {
        #[test]
        fn every_candidate_makes_a_morph(a in any_ifs(), b in any_ifs(), limit in 1_usize..30) {
            let count = a.len().min(b.len());
            let cut = |ifs: &Ifs| Ifs::new(ifs.maps()[..count].to_vec());
            let (Ok(a), Ok(b)) = (cut(&a), cut(&b)) else { return Ok(()) };
            let found = candidates(&a, &b, limit).unwrap();
            prop_assert!(!found.is_empty() && found.len() <= limit);
            prop_assert_eq!(&found, &candidates(&a, &b, limit).unwrap());
            for (i, c) in found.iter().enumerate() {
                let Candidate { correspondence, turns, cost } = c.clone();
                prop_assert!(cost.is_finite());
                let options = MorphOptions { correspondence, turns, ..Default::default() };
                prop_assert!(Morph::new(a.maps(), b.maps(), &options).is_ok());
                prop_assert!(!found[..i].contains(c));
            }
        }
    }
}
