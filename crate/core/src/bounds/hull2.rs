//! A convex polygon around the attractor.

use glam::{DMat2, DVec2};

use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::linear::transform::{lifting, lowered};

/// A convex polygon that holds the attractor, tight to about a hundredth of its size.
///
/// It comes from the support function of the attractor, `h(d) = max { d . x : x in A }`, which obeys
/// `h(d) = max_i ( h(M_i^T d) + d . t_i )`: the values in some directions are lowered from those of a
/// disc until they settle, each step rounding outward, in coordinates in which the maps contract.
#[derive(Clone, Debug, PartialEq)]
pub struct Hull {
    vertices: Vec<DVec2>,
    centre: DVec2,
    radius: f64,
    diameter: f64,
}

/// How many directions there are.
pub(crate) const DIRECTIONS: usize = 48;
/// Most rounds of lowering.
pub(crate) const MOST_ROUNDS: usize = 400;

impl Hull {
    /// The polygon around the attractor of `ifs`.
    #[must_use]
    pub fn of(ifs: &Ifs) -> Self {
        let size = ifs.maps().iter().map(|map| map.translation.abs().max_element()).fold(0.0, f64::max);
        let lift = lifting(size);
        if lift != 1.0 {
            let maps =
                ifs.maps().iter().map(|map| Affine2::new(map.linear, map.translation * lift)).collect();
            if let Ok(large) = Ifs::new(maps) {
                return Self::of(&large).lowered(lift);
            }
        }
        let contraction = ifs.contraction();
        let origin = contraction.centre;
        let (to, from) = (contraction.to_round, contraction.from_round);
        if contraction.radius <= 0.0 {
            return Self::around(vec![origin]);
        }
        // Round coordinates, in units of the disc that is known to hold the attractor.
        let unit = contraction.radius;
        let maps: Vec<Affine2> = ifs
            .maps()
            .iter()
            .map(|map| Affine2::new(to * map.linear * from, to * (map.apply(origin) - origin) / unit))
            .collect();
        let directions = Directions::new();
        let support = directions.settle(&maps, contraction.factor);
        let polygon = directions.polygon(&support);
        Self::around(polygon.into_iter().map(|p| origin + from * (p * unit)).collect())
    }

    fn lowered(self, lift: f64) -> Self {
        Self {
            vertices: self.vertices.into_iter().map(|vertex| vertex / lift).collect(),
            centre: self.centre / lift,
            radius: lowered(self.radius, lift),
            diameter: lowered(self.diameter, lift),
        }
    }

    /// The polygon of these corners, counter-clockwise.
    pub(crate) fn around(vertices: Vec<DVec2>) -> Self {
        let vertices = counter_clockwise(vertices);
        let (min, max) = extent(&vertices);
        let centre = (min + max) * 0.5;
        let radius = vertices.iter().map(|v| v.distance(centre)).fold(0.0, f64::max);
        let diameter = vertices
            .iter()
            .enumerate()
            .flat_map(|(i, a)| vertices[i + 1..].iter().map(move |b| a.distance(*b)))
            .fold(0.0, f64::max);
        Self { vertices, centre, radius, diameter }
    }

    /// The corners, counter-clockwise: one for an attractor that is a single point.
    #[must_use]
    pub fn vertices(&self) -> &[DVec2] {
        &self.vertices
    }

    /// The largest `direction . x` over the polygon.
    #[must_use]
    pub fn support(&self, direction: DVec2) -> f64 {
        self.vertices.iter().map(|v| v.dot(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The centre of the bounding box.
    #[must_use]
    pub fn centre(&self) -> DVec2 {
        self.centre
    }

    /// The radius of a disc around [`Hull::centre`] that holds the polygon.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The diameter of the polygon: an upper bound of that of the attractor.
    #[must_use]
    pub fn diameter(&self) -> f64 {
        self.diameter
    }

    /// The lower left corner of the bounding box.
    #[must_use]
    pub fn min(&self) -> DVec2 {
        extent(&self.vertices).0
    }

    /// The upper right corner of the bounding box.
    #[must_use]
    pub fn max(&self) -> DVec2 {
        extent(&self.vertices).1
    }
}

fn extent(points: &[DVec2]) -> (DVec2, DVec2) {
    points.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)))
}

fn counter_clockwise(mut polygon: Vec<DVec2>) -> Vec<DVec2> {
    let doubled_area: f64 =
        (0..polygon.len()).map(|i| polygon[i].perp_dot(polygon[(i + 1) % polygon.len()])).sum();
    if doubled_area < 0.0 {
        polygon.reverse();
    }
    polygon
}

/// Unit vectors at equal angles.
pub(crate) struct Directions {
    pub directions: [DVec2; DIRECTIONS],
    step: f64,
}

impl Directions {
    pub fn new() -> Self {
        let step = std::f64::consts::TAU / DIRECTIONS as f64;
        Self { directions: std::array::from_fn(|k| DVec2::from_angle(step * k as f64)), step }
    }

    /// Support values of the attractor of `maps` in these directions; the attractor is known
    /// to lie in the unit disc.
    fn settle(&self, maps: &[Affine2], factor: f64) -> [f64; DIRECTIONS] {
        // Where each direction of each map goes does not change from round to round.
        let links: Vec<Link> = maps
            .iter()
            .flat_map(|map| {
                let transposed = map.linear.transpose();
                self.directions.map(|d| self.link(transposed, d, map.translation))
            })
            .collect();
        let mut support = [1.0; DIRECTIONS];
        let mut change = f64::INFINITY;
        for _ in 0..MOST_ROUNDS {
            change = 0.0;
            let next = image(&links, &support);
            for (old, (new, _)) in support.iter_mut().zip(next) {
                // Never above the last bound: both hold.
                let lower = new.min(*old);
                change = change.max(*old - lower);
                *old = lower;
            }
            if change < 1e-4 {
                break;
            }
        }
        // Maps that hardly shrink get there too slowly.
        if change > 0.01 * (1.0 - factor)
            && let Some(found) = solve(&links, &support)
        {
            for (old, new) in support.iter_mut().zip(found) {
                *old = old.min(new);
            }
        }
        support.map(|value| value + 1e-12)
    }

    /// How to bound the support in direction `d` of the image of a set under a map from that of the
    /// set: the direction that the map takes to `d` lies between two of these, and the support
    /// function is convex.
    pub fn link(&self, transposed: DMat2, d: DVec2, translation: DVec2) -> Link {
        let pulled = transposed * d;
        let length = pulled.length();
        let turn = pulled.y.atan2(pulled.x).rem_euclid(std::f64::consts::TAU) / self.step;
        let low = (turn.floor() as usize).min(DIRECTIONS - 1);
        let angle = (turn - low as f64).clamp(0.0, 1.0) * self.step;
        let scale = length / self.step.sin();
        Link {
            low,
            from_low: scale * (self.step - angle).sin(),
            from_high: scale * angle.sin(),
            shift: d.dot(translation),
        }
    }

    /// The polygon of all points within the support values.
    pub fn polygon(&self, support: &[f64; DIRECTIONS]) -> Vec<DVec2> {
        let mut polygon =
            vec![DVec2::new(-2.0, -2.0), DVec2::new(2.0, -2.0), DVec2::new(2.0, 2.0), DVec2::new(-2.0, 2.0)];
        let mut clipped = Vec::with_capacity(DIRECTIONS + 4);
        for (direction, &most) in self.directions.iter().zip(support) {
            clipped.clear();
            for i in 0..polygon.len() {
                let (p, q) = (polygon[i], polygon[(i + 1) % polygon.len()]);
                let (over_p, over_q) = (direction.dot(p) - most, direction.dot(q) - most);
                if over_p <= 0.0 {
                    clipped.push(p);
                }
                if (over_p < 0.0 && over_q > 0.0) || (over_p > 0.0 && over_q < 0.0) {
                    clipped.push(p + (q - p) * (over_p / (over_p - over_q)));
                }
            }
            // Rounding may clip a set without inside to nothing: keep what there was.
            if !clipped.is_empty() {
                std::mem::swap(&mut polygon, &mut clipped);
            }
        }
        polygon.dedup_by(|a, b| a.distance(*b) < 1e-14);
        polygon
    }
}

/// The support values of the union of the images of a set with these support values, and which map each
/// is from.
fn image(links: &[Link], support: &[f64; DIRECTIONS]) -> [(f64, usize); DIRECTIONS] {
    let mut next = [(f64::NEG_INFINITY, 0); DIRECTIONS];
    for (map, round) in links.chunks_exact(DIRECTIONS).enumerate() {
        for (value, link) in next.iter_mut().zip(round) {
            let bound = link.bound(support);
            if bound > value.0 {
                *value = (bound, map);
            }
        }
    }
    next
}

/// The support values that the images reproduce, at one stroke: with the map of each direction chosen they solve
/// linear equations, and maps are chosen anew until none does better (Howard's policy iteration). `None` where that
/// leads nowhere, as it does when the directions are too few for how little the maps shrink.
fn solve(links: &[Link], start: &[f64; DIRECTIONS]) -> Option<[f64; DIRECTIONS]> {
    let mut support = *start;
    for _ in 0..64 {
        let chosen = image(links, &support).map(|(_, map)| map);
        support = evaluate(links, &chosen)?;
        // The polygon is mapped into itself, so that it holds the attractor.
        if image(links, &support).iter().zip(&support).all(|((next, _), now)| *next <= now + 1e-12) {
            return Some(support);
        }
    }
    None
}

/// Solves `support = bound of the chosen map from support` by elimination.
fn evaluate(links: &[Link], chosen: &[usize; DIRECTIONS]) -> Option<[f64; DIRECTIONS]> {
    let mut rows = Box::new([[0.0; DIRECTIONS + 1]; DIRECTIONS]);
    for (k, (row, &map)) in rows.iter_mut().zip(chosen).enumerate() {
        let link = &links[map * DIRECTIONS + k];
        row[k] += 1.0;
        row[link.low] -= link.from_low;
        row[(link.low + 1) % DIRECTIONS] -= link.from_high;
        row[DIRECTIONS] = link.shift;
    }
    for k in 0..DIRECTIONS {
        let pivot = (k..DIRECTIONS).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs()))?;
        rows.swap(k, pivot);
        let top = rows[k];
        if top[k].abs() < 1e-14 {
            return None;
        }
        for row in &mut rows[k + 1..] {
            let times = row[k] / top[k];
            if times != 0.0 {
                for (value, above) in row[k..].iter_mut().zip(&top[k..]) {
                    *value -= times * above;
                }
            }
        }
    }
    let mut support = [0.0; DIRECTIONS];
    for k in (0..DIRECTIONS).rev() {
        let known: f64 = (k + 1..DIRECTIONS).map(|i| rows[k][i] * support[i]).sum();
        support[k] = (rows[k][DIRECTIONS] - known) / rows[k][k];
    }
    // Within the unit disc, or the equations have no solution that means something.
    support.iter().all(|value| value.abs() <= 1.0 + 1e-6).then_some(support)
}

pub(crate) struct Link {
    low: usize,
    from_low: f64,
    from_high: f64,
    shift: f64,
}

impl Link {
    #[inline]
    pub fn bound(&self, support: &[f64; DIRECTIONS]) -> f64 {
        let high = if self.low + 1 == DIRECTIONS { 0 } else { self.low + 1 };
        self.from_low * support[self.low] + self.from_high * support[high] + self.shift
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{any_ifs, orbit};

    #[test]
    fn the_gasket_gets_its_triangle() {
        let maps =
            [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f]));
        let hull = Hull::of(&Ifs::new(maps.to_vec()).unwrap());
        assert!((hull.diameter() - 2.0_f64.sqrt()).abs() < 1e-3, "{}", hull.diameter());
        assert!((hull.min() - DVec2::ZERO).length() < 1e-3 && (hull.max() - DVec2::ONE).length() < 1e-3);
        assert!((hull.support(DVec2::ONE) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_point_and_a_segment_have_hulls() {
        let point = Ifs::new(vec![Affine2::from_row([0.5, 0.0, 0.0, 0.5, 1.0, 2.0])]).unwrap();
        let hull = Hull::of(&point);
        assert!((hull.centre() - DVec2::new(2.0, 4.0)).length() < 1e-9 && hull.diameter() < 1e-9);
        let segment = [0.0, 0.5].map(|e| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, 0.0]));
        let hull = Hull::of(&Ifs::new(segment.to_vec()).unwrap());
        assert!((hull.diameter() - 1.0).abs() < 1e-2 && hull.max().y.abs() < 1e-2);
    }

    #[test]
    fn slow_maps_have_tight_hulls_too() {
        let slow = [0.0, 1.0].map(|f| Affine2::from_row([0.999_999, 0.0, 0.0, 0.999_999, 0.0, f]));
        let hull = Hull::of(&Ifs::new(slow.to_vec()).unwrap());
        assert!(hull.min().length() < 1e3 && (hull.max() - DVec2::new(0.0, 1e6)).length() < 1e3, "{hull:?}");
    }

    #[test]
    fn slow_turns_have_tight_hulls_too() {
        // The worst are those that turn so little that so many directions cannot tell, or by no part of a circle.
        for shrink in [0.01, 2e-3, 1e-3, 1e-4, 1e-6] {
            for angle in [1.0, 0.1, 0.01, 2.0 * std::f64::consts::FRAC_PI_3, -3.1] {
                let slow = Affine2::similitude(1.0 - shrink, angle, DVec2::ZERO);
                for (scale, place) in [(0.2, DVec2::X), (0.5, DVec2::new(0.0, 3.0)), (0.8, DVec2::splat(0.1))]
                {
                    let ifs = Ifs::new(vec![slow, Affine2::similitude(scale, 0.5, place)]).unwrap();
                    let hull = Hull::of(&ifs);
                    // Its farthest points are at the fixed point of the second map, or beyond.
                    let reach = ifs.maps()[1].fixed_point().unwrap().length();
                    let least = reach.max(place.length() / (1.0 + scale));
                    assert!(
                        hull.radius() < 6.0 * least,
                        "{shrink} {angle} {scale}: {} {least}",
                        hull.radius()
                    );
                }
            }
        }
    }

    proptest! {
        #[test]
        fn no_point_of_the_attractor_is_outside(ifs in any_ifs(), seed in 0_u32..1000) {
            let hull = Hull::of(&ifs);
            let v = hull.vertices();
            prop_assert!(!v.is_empty() && v.iter().all(|p| p.is_finite()));
            let slack = 1e-9 * (hull.diameter() + hull.centre().length());
            for p in orbit(&ifs, seed, 300) {
                prop_assert!(p.distance(hull.centre()) <= hull.radius() + slack);
                for k in 0..v.len() {
                    let (a, b) = (v[k], v[(k + 1) % v.len()]);
                    let edge = (b - a).normalize_or_zero();
                    prop_assert!(edge.perp_dot(p - a) >= -slack, "{p} outside edge {a} {b}");
                }
            }
        }

        #[test]
        fn it_is_not_much_too_large(ifs in any_ifs()) {
            let hull = Hull::of(&ifs);
            let points = orbit(&ifs, 1, 4000);
            let (low, high) = extent(&points);
            // A chaos game of some thousand points reaches most of the way in plain shapes.
            let seen = (high - low).length();
            prop_assume!(ifs.contraction().factor < 0.8 && ifs.contraction().length == 1 && seen > 1e-3);
            prop_assume!(ifs.contraction().to_round == DMat2::IDENTITY);
            prop_assert!(hull.diameter() < 2.0 * seen, "{} {seen}", hull.diameter());
        }
    }
}
