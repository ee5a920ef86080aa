//! How far two attractors are from each other.
//!
//! The Hausdorff distance of two compact sets is the least r such that each lies within r of the other: the greater of
//! `max { d(x, B) : x in A }` and `max { d(y, A) : y in B }` (Hutchinson 1981, section 2.4). Morphs are continuous in
//! it (Burch & Hart 1997, Theorem 1).
//!
//! Bounds are found by branching: the piece of a word u lies in the ball `w_u(ball)`. No point of the piece is farther
//! from B than the middle of its ball is, and the radius beside; a point of the piece is at least as far as the
//! nearest ball of B. The piece that may hold the farthest point is split, until the bounds are near enough. For each
//! piece only those pieces of B are kept that may hold the point of B nearest to one of its points, and these are split
//! as it is.
//!
//! Shapes that nearly cover each other would need pieces without number. There the maps tell more: by the collage
//! theorem (Barnsley 1988; Hutchinson 1981, section 3.1) the distance is at most `h(W(A), V(A)) / (1 - s)`, W and V
//! being the two systems and s the contraction of V. And points where pieces have their corners are looked at first:
//! shapes differ most there.

use std::collections::BinaryHeap;
use std::ops::Range;

use crate::dimension::{Dim2, Dimension};
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine;
use crate::order::{Ranked, Total};

/// How well a distance is to be known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HausdorffOptions {
    /// How far the bounds may be apart, relative to the size of what holds both shapes. At least 1e-9 of it.
    pub tolerance: f64,
    /// How many pairs of pieces are compared at most. The bounds hold however few there are.
    pub budget: usize,
}

impl Default for HausdorffOptions {
    fn default() -> Self {
        Self { tolerance: 1e-4, budget: 4_000_000 }
    }
}

/// The Hausdorff distance of two attractors, between bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HausdorffDistance<D: Dimension = Dim2> {
    /// It is not less.
    pub lower: f64,
    /// It is not more.
    pub upper: f64,
    /// A point of the first shape and one of the second: one of them is at least `lower` away from all of the other
    /// shape, and the other one is near the nearest there.
    pub points: [D::Vector; 2],
}

/// Rounding, relative to the numbers that are added.
const ROUNDING: f64 = 1e-13;
const FINEST: f64 = 1e-9;
/// Points that are looked at before the search at most.
const MOST_CORNERS: usize = 256;
/// Pairs that are compared for one piece at most: of a circle all points are as near to its middle.
const MOST_AT_ONCE: usize = 1 << 20;
/// Pieces of one shape that are kept at most: a hundred megabytes.
const MOST_PIECES: usize = 1 << 20;

/// Bounds of the Hausdorff distance of the attractors of two systems.
///
/// They are exact up to rounding, which they include. Where `options.budget` ends the search they are farther apart
/// than `options.tolerance` asks for.
#[must_use]
pub fn hausdorff_distance<D: Dimension>(
    a: &Ifs<D>,
    b: &Ifs<D>,
    options: &HausdorffOptions,
) -> HausdorffDistance<D> {
    let mut trees = [Pieces::of(a), Pieces::of(b)];
    let apart = D::length(trees[0].roots().centre - trees[1].roots().centre);
    let size = apart + trees[0].roots().radius + trees[1].roots().radius;
    let numbers = trees.each_ref().map(Pieces::largest_number).into_iter().fold(size, f64::max);
    let finest = if options.tolerance.is_nan() { FINEST } else { options.tolerance.max(FINEST) };
    // A point that a map fixes is the less certain the less the map shrinks.
    let shrinks = [a, b].map(|ifs| 1.0 - ifs.contraction().factor).into_iter().fold(1.0, f64::min);
    let search = Search { tolerance: finest * size, rounding: ROUNDING * numbers / shrinks };
    let mut found = Found { lower: 0.0, upper: 0.0, points: trees.each_ref().map(|tree| tree.roots().at) };
    let at_most = collage(a, b).min(collage(b, a));
    let mut left = options.budget;
    for turned in [false, true] {
        let [first, second] = &mut trees;
        let (from, to) = if turned { (second, first) } else { (first, second) };
        // What is nearer than the other direction has shown to be far needs no more looking at.
        let share = if turned { left } else { left / 2 };
        left = left.saturating_sub(search.farthest(from, to, turned, share, at_most, &mut found));
    }
    let Found { lower, upper, points } = found;
    let upper = upper.min(at_most);
    HausdorffDistance {
        lower: (lower - search.rounding).max(0.0),
        upper: upper.max(lower) + search.rounding,
        points,
    }
}

/// What the maps alone say: the distance is at most `h(W(A), V(A)) / (1 - s)`. Infinite where V shrinks only in blocks.
fn collage<D: Dimension>(a: &Ifs<D>, b: &Ifs<D>) -> f64 {
    let (of, by) = (a.contraction(), b.contraction());
    if by.length != 1 || a.maps().len() * b.maps().len() > MOST_AT_ONCE {
        return f64::INFINITY;
    }
    let (radius, spread) = (of.radius * (1.0 + ROUNDING), D::norm(by.from_round) * (1.0 + D::NORM_ERROR));
    // In round coordinates of V: no point of A is taken farther apart by the two maps.
    let apart = |w: &Affine<D>, v: &Affine<D>| {
        let turned = D::norm(by.to_round * (w.linear - v.linear) * of.from_round) * (1.0 + D::NORM_ERROR);
        turned * radius + D::length(by.to_round * (w.apply(of.centre) - v.apply(of.centre)))
    };
    let farthest = |from: &[Affine<D>], to: &[Affine<D>]| {
        let to_nearest = |w: &Affine<D>| to.iter().map(|v| apart(w, v)).fold(f64::INFINITY, f64::min);
        from.iter().map(to_nearest).fold(0.0, f64::max)
    };
    let apart = farthest(a.maps(), b.maps()).max(farthest(b.maps(), a.maps()));
    let bound = apart * spread / (1.0 - by.factor) * (1.0 + 1e-9);
    if bound.is_nan() { f64::INFINITY } else { bound }
}

struct Found<D: Dimension> {
    lower: f64,
    upper: f64,
    points: [D::Vector; 2],
}

struct Search {
    tolerance: f64,
    rounding: f64,
}

/// A piece of the first shape, and what of the second may be nearest to one of its points.
struct Leaf {
    piece: u32,
    near: Vec<u32>,
    /// No point of the piece is farther from the second shape.
    upper: f64,
}

impl Search {
    /// Raises the bounds of `found` to those of the points of `from` that are farthest from `to`. Returns how many
    /// pairs were compared.
    fn farthest<D: Dimension>(
        &self,
        from: &mut Pieces<D>,
        to: &mut Pieces<D>,
        turned: bool,
        budget: usize,
        at_most: f64,
        found: &mut Found<D>,
    ) -> usize {
        let mut spent = 0;
        let mut open = BinaryHeap::new();
        let look = |node: Node<D>, piece: u32, near: Vec<u32>, to: &mut Pieces<D>, found: &mut Found<D>| {
            let (leaf, lower, nearest, cost) = self.look(node, piece, near, to);
            if lower > found.lower {
                found.lower = lower;
                let points = [node.at, to.nodes[nearest as usize].at];
                found.points = if turned { [points[1], points[0]] } else { points };
            }
            (leaf, cost)
        };
        for at in from.corners() {
            if spent < budget / 4 {
                let node = Node { at, centre: at, radius: 0.0, ..from.nodes[0] };
                spent += look(node, 0, vec![0], to, found).1;
            }
        }
        let (root, cost) = look(from.nodes[0], 0, vec![0], to, found);
        spent += cost;
        open.push(Ranked { key: Total(root.upper), item: root });
        while let Some(Ranked { item: Leaf { piece, near, upper }, .. }) = open.pop() {
            // It is the one that may reach farthest.
            if upper.min(at_most) <= found.lower + self.tolerance || spent >= budget {
                found.upper = found.upper.max(upper);
                return spent;
            }
            let Some(parts) = from.parts(piece) else {
                found.upper = found.upper.max(upper);
                return spent;
            };
            for part in parts {
                let (leaf, cost) = look(from.nodes[part as usize], part, near.clone(), to, found);
                spent += cost;
                open.push(Ranked { key: Total(leaf.upper.min(upper)), item: leaf });
            }
        }
        spent
    }

    /// Bounds of how far a piece is from a shape of which some pieces are near: the farthest that one of its points may
    /// be, and the least that its own point is.
    fn look<D: Dimension>(
        &self,
        node: Node<D>,
        piece: u32,
        mut near: Vec<u32>,
        to: &mut Pieces<D>,
    ) -> (Leaf, f64, u32, usize) {
        let finest = node.radius.max(0.25 * self.tolerance);
        let mut cost = 0;
        loop {
            cost += near.len();
            let radius = |k: &u32| to.nodes[*k as usize].radius;
            let to_ball =
                |from: D::Vector, k: &u32| D::length(to.nodes[*k as usize].centre - from) - radius(k);
            let to_point = |from: D::Vector, k: &u32| D::length(to.nodes[*k as usize].at - from);
            let upper = near.iter().map(|k| to_point(node.centre, k)).fold(f64::INFINITY, f64::min);
            near.retain(|k| to_ball(node.centre, k) <= upper + 2.0 * node.radius + self.rounding);
            let coarse = near.iter().filter(|k| radius(k) > finest).count();
            let grown = cost + near.len() + coarse * to.maps.len();
            if coarse == 0 || grown > MOST_AT_ONCE || !to.holds(coarse) {
                let nearest = near.iter().min_by_key(|k| Total(to_point(node.at, k))).copied().unwrap_or(0);
                let lower = near.iter().map(|k| to_ball(node.at, k)).fold(f64::INFINITY, f64::min);
                let leaf = Leaf { piece, near, upper: upper + node.radius };
                return (leaf, if lower.is_finite() { lower.max(0.0) } else { 0.0 }, nearest, cost);
            }
            let mut finer = Vec::with_capacity(2 * near.len());
            for k in near {
                if to.nodes[k as usize].radius <= finest {
                    finer.push(k);
                } else {
                    finer.extend(to.parts(k).into_iter().flatten());
                }
            }
            near = finer;
        }
    }
}

/// A piece: the ball that holds it, and one of its points.
#[derive(Clone, Copy)]
struct Node<D: Dimension> {
    map: Affine<D>,
    centre: D::Vector,
    radius: f64,
    at: D::Vector,
    /// Its first part, if it was split.
    parts: Option<u32>,
}

/// The pieces of an attractor, as far as they were asked for.
struct Pieces<'a, D: Dimension> {
    maps: &'a [Affine<D>],
    from_round: D::Matrix,
    /// A point of the attractor, and the ball that holds all of it: its radius in round coordinates.
    point: D::Vector,
    centre: D::Vector,
    far: f64,
    nodes: Vec<Node<D>>,
}

impl<'a, D: Dimension> Pieces<'a, D> {
    fn of(ifs: &'a Ifs<D>) -> Self {
        let contraction = ifs.contraction();
        let from_centre = |point: D::Vector| D::length(contraction.to_round * (point - contraction.centre));
        let fixed = ifs.maps().iter().filter_map(|map| map.fixed_point());
        let point = fixed.min_by_key(|&point| Total(from_centre(point))).unwrap_or(contraction.centre);
        let far = contraction.radius * (1.0 + ROUNDING);
        let (centre, from_round) = (contraction.centre, contraction.from_round);
        let mut pieces = Self { maps: ifs.maps(), from_round, point, centre, far, nodes: Vec::new() };
        let whole = pieces.node(Affine::IDENTITY);
        pieces.nodes.push(whole);
        pieces
    }

    fn node(&self, map: Affine<D>) -> Node<D> {
        let radius = D::norm(map.linear * self.from_round) * self.far * (1.0 + D::NORM_ERROR);
        Node { map, centre: map.apply(self.centre), radius, at: map.apply(self.point), parts: None }
    }

    /// The whole attractor.
    fn roots(&self) -> &Node<D> {
        &self.nodes[0]
    }

    fn largest_number(&self) -> f64 {
        D::length(self.centre) + self.nodes[0].radius
    }

    /// The points that the maps fix, in each piece: corners, if the shape has any.
    fn corners(&self) -> Vec<D::Vector> {
        let fixed: Vec<_> = self.maps.iter().filter_map(|map| map.fixed_point()).take(MOST_CORNERS).collect();
        let images = self.maps.iter().flat_map(|map| fixed.iter().map(|&point| map.apply(point)));
        images.take(MOST_CORNERS).collect()
    }

    /// Whether so many pieces more can be split.
    fn holds(&self, more: usize) -> bool {
        self.nodes.len() + more * self.maps.len() <= MOST_PIECES
    }

    /// The parts of a piece, one for each map. `None` where there are too many pieces already.
    fn parts(&mut self, piece: u32) -> Option<Range<u32>> {
        let count = self.maps.len() as u32;
        let Node { map, parts, .. } = self.nodes[piece as usize];
        let first = match parts {
            Some(first) => first,
            None if !self.holds(1) => return None,
            None => {
                let first = self.nodes.len() as u32;
                for &letter in self.maps {
                    let node = self.node(map * letter);
                    self.nodes.push(node);
                }
                self.nodes[piece as usize].parts = Some(first);
                first
            }
        };
        Some(first..first + count)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::*;
    use crate::ifs::system::Ifs3;
    use crate::sample::chaos_game2::ChaosGame;
    use crate::{Affine2, Affine3};

    fn ifs(rows: &[[f64; 6]]) -> Ifs {
        Ifs::new(rows.iter().map(|&row| Affine2::from_row(row)).collect()).unwrap()
    }

    fn scaled(factor: f64, places: &[[f64; 2]]) -> Ifs {
        ifs(&places.iter().map(|&[e, f]| [factor, 0.0, 0.0, factor, e, f]).collect::<Vec<_>>())
    }

    fn gasket() -> Ifs {
        scaled(0.5, &[[0.0, 0.0], [0.5, 0.0], [0.25, 0.75_f64.sqrt() / 2.0]])
    }

    /// That a distance is between the bounds, which are near enough.
    #[track_caller]
    fn is<D: Dimension>(found: HausdorffDistance<D>, expected: f64, within: f64) {
        let HausdorffDistance { lower, upper, .. } = found;
        assert!(lower <= expected && expected <= upper, "{expected} is not in {lower} .. {upper}");
        assert!(upper - lower <= within, "{lower} .. {upper}");
    }

    #[test]
    fn distances_that_are_known_are_between_the_bounds() {
        let options = HausdorffOptions::default();
        // The middle of a segment is 1/6 from Cantor's dust.
        let dust = scaled(1.0 / 3.0, &[[0.0, 0.0], [2.0 / 3.0, 0.0]]);
        let segment = scaled(0.5, &[[0.0, 0.0], [0.5, 0.0]]);
        is(hausdorff_distance(&dust, &segment, &options), 1.0 / 6.0, 2.2e-4);
        let found = hausdorff_distance(&segment, &dust, &options);
        is(found, 1.0 / 6.0, 2.2e-4);
        assert!((found.points[0].x - 0.5).abs() < 1e-3, "{:?}", found.points);
        // The hole of the gasket has an inscribed circle of radius 1 / (4 sqrt 3).
        let top = 0.75_f64.sqrt() / 2.0;
        let half = |a: f64, e: f64, f: f64| [a, 0.0, 0.0, a, e, f];
        let full =
            ifs(&[half(0.5, 0.0, 0.0), half(0.5, 0.5, 0.0), half(0.5, 0.25, top), half(-0.5, 0.75, top)]);
        is(hausdorff_distance(&gasket(), &full, &options), 1.0 / (4.0 * 3.0_f64.sqrt()), 4e-4);
    }

    #[test]
    fn a_shape_moved_is_as_far_as_it_was_moved() {
        let shape = gasket();
        for by in [DVec2::new(3.0, 4.0), DVec2::new(0.003, -0.004), DVec2::new(0.2, 0.1)] {
            let moved = shape.conjugate(Affine2::new(glam::DMat2::IDENTITY, by)).unwrap();
            is(hausdorff_distance(&shape, &moved, &HausdorffOptions::default()), by.length(), 1.5e-3);
        }
        let itself = hausdorff_distance(&shape, &shape, &HausdorffOptions::default());
        assert!(itself.lower == 0.0 && itself.upper < 1e-9, "{itself:?}");
        // The top of a piece that is turned a little about the corner of the shape moves across an edge, by
        // sin(d / 2); by the collage theorem no point moves twice as far.
        let turned = |angle: f64| {
            let mut maps = shape.maps().to_vec();
            maps[0] = Affine2::similitude(0.5, angle, DVec2::ZERO);
            Ifs::new(maps).unwrap()
        };
        let options = HausdorffOptions { budget: 300_000, ..HausdorffOptions::default() };
        let HausdorffDistance { lower, upper, .. } =
            hausdorff_distance(&turned(0.0), &turned(0.01), &options);
        let moved = 0.005_f64.sin();
        assert!(moved * 0.98 < lower && moved <= upper && upper < 0.0101, "{lower} {upper}");
    }

    #[test]
    fn the_middle_of_a_cube_is_far_from_the_sponge() {
        let cells = |keep: &dyn Fn([usize; 3]) -> bool, side: usize| {
            let all = (0..side.pow(3)).map(|k| [k % side, k / side % side, k / side / side]);
            let factor = 1.0 / side as f64;
            let map = |at: [usize; 3]| {
                Affine3::new(
                    glam::DMat3::from_diagonal(DVec3::splat(factor)),
                    DVec3::from_array(at.map(|x| x as f64 * factor)),
                )
            };
            Ifs3::new(all.filter(|&at| keep(at)).map(map).collect()).unwrap()
        };
        let sponge = cells(&|at| at.iter().filter(|&&x| x == 1).count() < 2, 3);
        let cube = cells(&|_| true, 2);
        let options = HausdorffOptions { tolerance: 0.01, ..HausdorffOptions::default() };
        is(hausdorff_distance(&cube, &sponge, &options), 2.0_f64.sqrt() / 6.0, 0.1);
    }

    /// Against points of random systems: no point is farther from all pieces of the other than the bound, and one is as
    /// far.
    #[test]
    fn bounds_hold_for_random_systems() {
        let roll = |seed: u32, k: u32| f64::from(crate::hash::counter(seed, k)) / f64::from(u32::MAX);
        for seed in 0..40 {
            let map = |k: u32| {
                let n = |j: u32| roll(seed, 8 * k + j);
                Affine2::similitude(0.2 + 0.4 * n(0), 6.3 * n(1), DVec2::new(n(2), n(3)))
            };
            let system = |from: u32| Ifs::new((from..from + 2 + seed % 2).map(map).collect()).unwrap();
            let pair = [system(0), system(10)];
            let points = pair.each_ref().map(|ifs| {
                let (mut points, mut pieces) = (vec![0.0; 6000], vec![0; 3000]);
                ChaosGame::new(ifs, seed).fill(&mut points, &mut pieces);
                points.chunks(2).map(|p| DVec2::new(f64::from(p[0]), f64::from(p[1]))).collect::<Vec<_>>()
            });
            let directed = |a: &[DVec2], b: &[DVec2]| {
                let to = |p: &DVec2| b.iter().map(|q| p.distance(*q)).fold(f64::INFINITY, f64::min);
                a.iter().map(to).fold(0.0, f64::max)
            };
            let sampled = directed(&points[0], &points[1]).max(directed(&points[1], &points[0]));
            for budget in [0, 200, 4_000_000] {
                let options = HausdorffOptions { budget, ..HausdorffOptions::default() };
                let HausdorffDistance { lower, upper, points: [p, q] } =
                    hausdorff_distance(&pair[0], &pair[1], &options);
                assert!(lower <= upper);
                // Samples of 3,000 points leave gaps of some hundredths.
                assert!(
                    sampled <= upper + 0.05 && lower <= sampled + 0.05,
                    "{seed}: {sampled}, {lower} .. {upper}"
                );
                assert!(p.distance(q) >= lower - 1e-9 || budget == 0, "{seed}: {p} {q} {lower}");
            }
        }
    }

    /// Where all pieces lie upon each other none is left out: without a limit there would be 64^4 of them.
    #[test]
    fn many_maps_upon_each_other_stay_within_memory() {
        let at = |k: u32| DVec2::from_angle(f64::from(k)) * 0.1;
        let heap = Ifs::new((0..64).map(|k| Affine2::similitude(0.9, 0.0, at(k))).collect()).unwrap();
        let point = scaled(0.5, &[[0.0, 0.0]]);
        let (from, mut to) = (Pieces::of(&point), Pieces::of(&heap));
        let search = Search { tolerance: 1e-9, rounding: 1e-12 };
        let (_, lower, _, cost) = search.look(from.nodes[0], 0, vec![0], &mut to);
        assert!(to.nodes.len() <= MOST_PIECES && cost <= MOST_AT_ONCE, "{} {cost}", to.nodes.len());
        // The heap is a disc of radius 0.1 / (1 - 0.9), but for what lies between its 64 corners.
        assert!(lower == 0.0, "{lower}");
        let HausdorffDistance { lower, upper, .. } =
            hausdorff_distance(&point, &heap, &HausdorffOptions::default());
        assert!(lower <= 1.0 && 0.99 < upper, "{lower} {upper}");
    }

    #[test]
    fn points_lines_and_any_size_are_measured() {
        let point = |x: f64| ifs(&[[0.5, 0.0, 0.0, 0.5, x, 0.0], [0.25, 0.0, 0.0, 0.25, 1.5 * x, 0.0]]);
        is(hausdorff_distance(&point(0.5), &point(2.0), &HausdorffOptions::default()), 3.0, 1e-3);
        for size in [1e-90, 1e90] {
            let halves = |s: f64| ifs(&[[0.5, 0.0, 0.0, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0, s, 0.0]]);
            is(
                hausdorff_distance(&halves(size), &halves(2.0 * size), &HausdorffOptions::default()),
                2.0 * size,
                1e-2 * size,
            );
        }
        let wild = HausdorffOptions { tolerance: f64::NAN, budget: 10_000 };
        assert!(hausdorff_distance(&gasket(), &point(9.0), &wild).upper.is_finite());
    }
}
