//! Pieces that cross: a proof of connectedness that small changes leave valid.
//!
//! The idea is the *trap* of Calegari, Koch & Walker (Roots, Schottky semigroups, and a proof of Bandt's conjecture,
//! arXiv 1410.8542). An attractor is connected in steps as short as its gap, so that two smaller copies whose ends
//! take turns around a disc would have to come nearer to each other than that gap. They take it for two similarities
//! with one factor, to find inner points of the set M. Stated and proved here is a version for any number of affine
//! maps that contract in one norm, with a graph of pairs in place of the one pair, and with straight rays, which take
//! no more than the hulls of pieces.
//!
//! **Theorem.** Let all maps `w_i` of a system contract in one norm, `|w_i| <= s < 1`, and let g be the widest gap of
//! its attractor A: the widest edge of the minimum spanning tree of the distances between the pieces `A_i`. For a
//! word u write `A_u` for its piece, `|w_u|` for the norm of its map, and `r_u = |w_u| G / 2` for some `G >= g`.
//! Suppose that for a word u that begins with i and a word v that begins with j there are points p1, p2 of `A_u` and
//! q1, q2 of `A_v`, and a unit vector for each of them, such that
//!
//! 1. along its vector each p is beyond all of `A_v` by more than `r_v`, and each q beyond all of `A_u` by more than
//!    `r_u`,
//! 2. the vectors alternate: those of p1, q1, p2, q2 are in cyclic order.
//!
//! If the graph of all pairs (i, j) for which this can be found is connected, then A is connected.
//!
//! **Lemma.** From each of these points let a ray go along its vector. No ray of a p meets one of a q. *Proof.* Let
//! `p + a d = q + b e` with `a, b >= 0` and unit vectors d and e. Times d: `b (d . e) = a + d . (p - q) > a`, times
//! e: `a (d . e) = b + e . (q - p) > b`. So a and b are positive, and `d . e` is more than both a / b and b / a, of
//! which one is at least 1: a contradiction.
//!
//! **Proof.** Suppose that g > 0. *A is connected in steps of g*: with n so large that all pieces of n letters are
//! smaller than g, any two points of one such piece are a step apart; and for any word of less than n letters the
//! parts of its piece hang together by distances of at most g, since they are those of A, made smaller. *So `A_u` is
//! connected in steps of `|w_u| g`*, and the union P of closed discs of radius `|w_u| g / 2 <= r_u` about its points
//! is connected by paths; so is the union Q of discs about `A_v`. A large disc D holds P, Q and the beginnings of the
//! rays. A path from the boundary of D along the ray to p1, in P to p2, and out along its ray, and another one
//! likewise through q1, Q and q2, join alternating points of the boundary of D inside it, so that they meet. By the
//! lemma they do not meet on two rays, by 1 not on a ray and in the other's union; so P and Q meet, and `d(A_i, A_j)
//! <= d(A_u, A_v) <= (|w_u| + |w_v|) g / 2 <= s g < g`. As this holds for the edges of a connected graph, the widest
//! gap is below g, a contradiction. So g = 0, and A is connected (Hata 1985).
//!
//! All conditions are strict inequalities between points and hulls, so that they hold for all systems nearby: for a
//! whole box of parameters, if in the corners they hold by more than what
//! [`derivative_bounds`](crate::region::derivative_bounds) leaves open in between. Here the rays are those along
//! which a point lies beyond the hull of the other piece: in the cyclic order of directions, first the one piece juts
//! out beyond the other, then the other beyond the one, and again, as with two bars laid across each other.

use std::collections::BinaryHeap;

use frond_core::Affine2;
use glam::DVec2;

use crate::family::{Drift, Family};
use crate::frame::Frame;
use crate::gap::spanning_tree::SpanningTree;
use crate::region::derivative_bounds::bows;
use crate::region::descent::{Couple, Descent, Promising, Sight};
use crate::region::extent::Extent;
use crate::region::silhouette::beyond;
use crate::support::extremes::larger;
use crate::support::lanes::{DIRECTIONS, Points, direction};

/// Two pieces that cross, so that they hold two attractorlets together.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// A map.
    pub i: usize,
    /// Another one, `i < j`.
    pub j: usize,
    /// The word of a piece in attractorlet i: letters from 0, the first of which is i.
    pub u: Vec<u8>,
    /// The word of a piece in attractorlet j.
    pub v: Vec<u8>,
    /// Two points of the first piece, then two of the second, in the plane. Each juts out beyond the
    /// other piece; seen from the middle the two pieces take turns.
    pub corners: [DVec2; 4],
}

/// How long to look for crossings.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// Looks spent on each two maps for a bound of the gap.
    pub looks: usize,
    /// Pairs of words to try for each two maps.
    pub tries: usize,
    /// A bound of the gap that is good enough.
    pub near: f64,
}

/// Pairs of words to try for each two maps, mostly.
pub(crate) const TRIES: usize = 300;

/// Proves an attractor connected by pieces that cross, if it can: enough crossings to join all maps.
///
/// `gap` is an upper bound of the widest gap, in the plane, infinite where none is known; `slack` is how far, in the
/// plane, every point of the attractor may be off, for a proof that holds for all systems so near.
///
/// It sees only what robustly holds, and not all of that: that pieces touch in a point, never; that pieces of
/// one shape and direction overlap, hardly ever.
///
/// ```
/// use frond_core::Affine2;
/// use frond_locus::crossings;
///
/// // Two thin bars laid across each other, each of two halves that reach a little beyond the middle.
/// let bars = [
///     [0.6, 0.0, 0.0, 0.05, -0.4, 0.0],
///     [0.6, 0.0, 0.0, 0.05, 0.4, 0.0],
///     [0.05, 0.0, 0.0, 0.6, 0.02, -0.37],
///     [0.05, 0.0, 0.0, 0.6, 0.02, 0.43],
/// ];
/// let found = crossings(&bars.map(Affine2::from_row), f64::INFINITY, 0.0).expect("a plus");
/// assert_eq!(found.len(), 3);
/// ```
#[must_use]
pub fn crossings(maps: &[Affine2], gap: f64, slack: f64) -> Option<Vec<Crossing>> {
    crossings_beside(&[], maps, gap, slack, TRIES)
}

/// The same, where pairs of maps are known to meet for another reason: no crossings are needed for these. The proof
/// stays: their distance is 0, below any gap. `tries` pairs of words are tried at most for each two maps.
pub(crate) fn crossings_beside(
    met: &[(usize, usize)],
    maps: &[Affine2],
    gap: f64,
    slack: f64,
    tries: usize,
) -> Option<Vec<Crossing>> {
    let mut descent = Descent::<1>::default();
    let extent = Extent { middle: DVec2::ZERO, half: DVec2::ZERO };
    let slack = if slack.is_nan() { f64::INFINITY } else { slack.max(0.0) };
    if maps.len() < 2 || !descent.begin(&Fixed(maps), extent, &mut Frame::default()) {
        return None;
    }
    let to_round = Affine2::new(descent.lanes.from_round, DVec2::ZERO).inverse()?.norm();
    descent.lanes.rounding += 2.0 * slack * to_round;
    let known = gap.max(0.0) * to_round;
    let found = descent.cross_beside(met, known, Effort { looks: 150, tries, near: 2e-3 })?;
    Some(found.iter().map(|&(couple, corners)| descent.crossing(couple, corners.map(|[p]| p))).collect())
}

/// One system as a family.
struct Fixed<'a>(&'a [Affine2]);

impl Family for Fixed<'_> {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn fill(&self, _: f64, _: f64, maps: &mut Vec<Affine2>) {
        maps.clear();
        maps.extend_from_slice(self.0);
    }

    fn drift(&self, _: usize, _: DVec2, _: f64, drifts: &mut Vec<Drift>) {
        drifts.clear();
        drifts.resize(self.len(), Drift::STILL);
    }
}

/// How promising a pair is: by its overlap, below 1; behind those the pairs apart, by their distance.
pub(crate) fn reaching(sight: &Sight) -> f64 {
    if sight.apart > 0.0 { 1.0 + sight.apart } else { sight.overlap.min(1.0 - f64::EPSILON) }
}

/// A pair of crossing pieces and the four points that show it, in all lanes.
pub(crate) type Found<const L: usize> = (Couple, [Points<L>; 4]);

impl<const L: usize> Descent<L> {
    /// Proves the attractors of the whole box connected by crossings; `None` if that is not seen. `known` is an upper
    /// bound of their widest gap in the lanes' units.
    pub fn cross(&mut self, known: f64, effort: Effort) -> Option<Vec<Found<L>>> {
        self.cross_beside(&[], known, effort)
    }

    /// The same, where some pairs of maps are known to meet.
    fn cross_beside(&mut self, met: &[(usize, usize)], known: f64, effort: Effort) -> Option<Vec<Found<L>>> {
        self.reset();
        let mut filled = met.to_vec();
        for i in 0..self.count {
            for j in i + 1..self.count {
                let sight = self.look(i as u32, j as u32);
                self.note(&sight, i, j);
                if self.lanes.areas[i] + self.lanes.areas[j] > 1.0 {
                    filled.push((i, j));
                }
                let overlap = reaching(&sight);
                self.open.push(Couple { overlap, u: i as u32, v: j as u32, i: i as u8, j: j as u8 });
            }
        }
        self.open.sort_unstable_by(|a, b| a.overlap.total_cmp(&b.overlap));
        let pairs = std::mem::take(&mut self.open);
        self.close_in(&pairs, Effort { looks: effort.looks.min(LOOKS_AT_FIRST), ..effort });
        if effort.looks > LOOKS_AT_FIRST {
            self.close_in(&pairs, effort);
        }
        let gap = self.bottleneck().min(known);
        let found = self.join_by_crossings(&pairs, &filled, gap, effort);
        self.open = pairs;
        found
    }

    /// Looks for near points of the pairs that bound the widest gap: again and again of those across the cut that the
    /// widest edge of the minimum spanning tree bridges, the one that overlaps most, until that edge is near or
    /// none of these is left that may be shorter.
    fn close_in(&mut self, pairs: &[Couple], effort: Effort) {
        let mut tried = vec![false; pairs.len()];
        let mut tree = SpanningTree::default();
        loop {
            let upper = |i: u8, j: u8| self.upper[usize::from(i.min(j)) * self.count + usize::from(i.max(j))];
            let widest = tree.cut(self.count, upper);
            if widest < effort.near {
                return;
            }
            let helps = |pair: &Couple| {
                tree.beyond[usize::from(pair.i)] != tree.beyond[usize::from(pair.j)]
                    && pair.overlap < 1.0 + widest
            };
            // They are in the order of how deep they overlap.
            let Some(k) = (0..pairs.len()).find(|&k| !tried[k] && helps(&pairs[k])) else { return };
            tried[k] = true;
            self.look_for_near_points(pairs[k], effort);
        }
    }

    /// `filled` are pairs that meet for another reason.
    fn join_by_crossings(
        &mut self,
        pairs: &[Couple],
        filled: &[(usize, usize)],
        gap: f64,
        effort: Effort,
    ) -> Option<Vec<Found<L>>> {
        self.components.reset(self.count);
        for &(i, j) in filled {
            self.components.join(i, j);
        }
        if self.components.count() == 1 {
            return Some(Vec::new());
        }
        let mut found = Vec::with_capacity(self.count - 1);
        for &pair in pairs {
            let (i, j) = (usize::from(pair.i), usize::from(pair.j));
            if self.components.joined(i, j) || pair.overlap >= 1.0 {
                continue;
            }
            if let Some(crossing) = self.crossing_of(pair, gap, effort.tries) {
                found.push(crossing);
                self.components.join(i, j);
                if self.components.count() == 1 {
                    return Some(found);
                }
            }
        }
        None
    }

    /// Looks for crossing pieces in two attractorlets.
    pub fn crossing_of(&mut self, pair: Couple, gap: f64, tries: usize) -> Option<Found<L>> {
        // The heap is kept for the next.
        let mut open = std::mem::take(&mut self.promising);
        open.clear();
        open.push(self.promise(pair));
        let found = self.first_crossing(&mut open, gap, tries);
        self.promising = open;
        found
    }

    /// How likely a pair is to cross: large pieces cross more lastingly, those that overlap much more likely.
    fn promise(&self, couple: Couple) -> Promising {
        let size = larger(self.parts[couple.u as usize].norm, self.parts[couple.v as usize].norm);
        Promising { promise: size * (1.0 - couple.overlap).powi(2), couple }
    }

    fn first_crossing(
        &mut self,
        open: &mut BinaryHeap<Promising>,
        gap: f64,
        tries: usize,
    ) -> Option<Found<L>> {
        for _ in 0..tries {
            let couple = open.pop()?.couple;
            if let Some(corners) = self.corners(couple.u, couple.v, gap) {
                return Some((couple, corners));
            }
            // Where points may dip by half a piece's size, nothing more can be seen.
            if self.parts[couple.u as usize].norm.max(self.parts[couple.v as usize].norm)
                < 2.0 * self.lanes.rounding
            {
                continue;
            }
            let (parts, first) = self.parts_of_larger(couple.u, couple.v);
            for part in parts {
                let (u, v) = if first { (part, couple.v) } else { (couple.u, part) };
                let sight = self.look(u, v);
                if sight.apart <= 0.0 {
                    open.push(self.promise(Couple { overlap: sight.overlap, u, v, ..couple }));
                }
            }
        }
        None
    }

    /// Follows the parts of a pair that overlap most down, for points of the two attractorlets that are near each
    /// other.
    fn look_for_near_points(&mut self, pair: Couple, effort: Effort) {
        let k = usize::from(pair.i) * self.count + usize::from(pair.j);
        let end = self.nodes + effort.looks;
        self.open.clear();
        self.open.push(pair);
        // Parts that are apart may still be the nearest there are: they come last, the nearest first.
        let mut beyond: Vec<Couple> = Vec::new();
        loop {
            let nearest = |list: &[Couple]| {
                (0..list.len()).min_by(|&a, &b| list[a].overlap.total_cmp(&list[b].overlap))
            };
            let couple = match self.open.pop() {
                Some(couple) => couple,
                None => match nearest(&beyond) {
                    Some(best) => beyond.swap_remove(best),
                    None => return,
                },
            };
            if couple.overlap >= 1.0 + self.upper[k] {
                continue;
            }
            if self.nodes >= end || self.upper[k] < effort.near {
                return;
            }
            let (parts, first) = self.parts_of_larger(couple.u, couple.v);
            let before = self.open.len();
            for part in parts {
                let (u, v) = if first { (part, couple.v) } else { (couple.u, part) };
                let sight = self.look(u, v);
                self.note(&sight, usize::from(pair.i), usize::from(pair.j));
                let couple = Couple { overlap: reaching(&sight), u, v, ..couple };
                if sight.apart > 0.0 { beyond.push(couple) } else { self.open.push(couple) }
            }
            self.open[before..].sort_unstable_by(|a, b| b.overlap.total_cmp(&a.overlap));
        }
    }

    /// Whether two pieces cross, over the whole box, if no gap is wider than `gap`: two points of the first and
    /// two of the second that show it.
    #[expect(clippy::needless_range_loop, reason = "a lane is the same place in several arrays")]
    pub fn corners(&mut self, u: u32, v: u32, gap: f64) -> Option<[Points<L>; 4]> {
        for piece in [u, v] {
            self.silhouettes.prepare(piece, &self.parts[piece as usize].maps[0], &self.fan);
        }
        let [near, far] = [u, v].map(|piece| &self.parts[piece as usize]);
        let swell = [near, far].map(|part| 0.5 * part.norm * gap * (1.0 + 1e-12));
        let shapes = [u, v].map(|piece| self.silhouettes.get(piece));
        let by = beyond(shapes[0], shapes[1], swell);
        // The turns that the pieces take in the first lane; of each turn the direction that shows it best.
        let mut turns: [(usize, f64, usize, usize); MOST_TURNS] = [(0, 0.0, 0, 0); MOST_TURNS];
        let mut count = 0;
        for k in 0..DIRECTIONS {
            let a = usize::from(by[1][k] > 0.0);
            let by = by[a][k];
            if by > 0.0 {
                let number = usize::from(shapes[a].number[k]);
                if count == 0 || turns[count - 1].0 != a {
                    if count == MOST_TURNS {
                        return None;
                    }
                    turns[count] = (a, by, k, number);
                    count += 1;
                } else if by > turns[count - 1].1 {
                    turns[count - 1] = (a, by, k, number);
                }
            }
        }
        // The first turn may go on at the end.
        if count > 4 && count % 2 == 1 {
            if turns[count - 1].1 > turns[0].1 {
                turns[0] = turns[count - 1];
            }
            count -= 1;
        }
        if count < 4 {
            return None;
        }
        let mut points = [[DVec2::ZERO; L]; 4];
        for (point, &(a, _, k, number)) in points.iter_mut().zip(&turns[..4]) {
            let (own, other, swell) = if a == 0 { (near, far, swell[1]) } else { (far, near, swell[0]) };
            let d = direction(k);
            let mut beyond = f64::INFINITY;
            for l in 0..L {
                point[l] = own.maps[l].apply(self.fan.point(number, l));
                let map = &other.maps[l];
                let hull = map.translation.dot(d) + self.fan.support(map.linear.transpose() * d, l).0;
                beyond = beyond.min(d.dot(point[l]) - hull);
            }
            let length = d.length();
            let bow = bows(point).into_iter().zip(other.bows).map(|(p, q)| d.dot(p - q) / length);
            let bow = bow.fold(f64::NEG_INFINITY, f64::max) + other.sag;
            if beyond <= (swell + self.lanes.margin(bow)) * length {
                return None;
            }
        }
        let [p, q, r, s] = points;
        Some(if turns[0].0 == 0 { [p, r, q, s] } else { [q, s, p, r] })
    }

    fn note(&mut self, sight: &Sight, i: usize, j: usize) {
        let upper = &mut self.upper[i * self.count + j];
        *upper = upper.min(sight.reach);
    }

    /// The widest edge of the minimum spanning tree of the nearest points known, over all corners.
    pub fn bottleneck(&self) -> f64 {
        let upper = |i: u8, j: u8| self.upper[usize::from(i.min(j)) * self.count + usize::from(i.max(j))];
        SpanningTree::default().cut(self.count, upper)
    }

    fn crossing(&self, couple: Couple, corners: [DVec2; 4]) -> Crossing {
        let plane = |p: DVec2| self.lanes.origin + self.lanes.from_round * p;
        Crossing {
            i: usize::from(couple.i),
            j: usize::from(couple.j),
            u: self.word(couple.u),
            v: self.word(couple.v),
            corners: corners.map(plane),
        }
    }
}

/// Looks spent on a pair at first: mostly near points are found soon, or not at all.
const LOOKS_AT_FIRST: usize = 150;
/// Two convex pieces take more turns than this only where the points of one hardly reach beyond the other.
const MOST_TURNS: usize = 12;
