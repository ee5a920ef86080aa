//! Where the states of a graph-directed system lie, from outside and from inside.

use frond_core::{DirectedIfs, Hull, StateDisc};
use glam::{DMat2, DVec2};

/// A state: a polygon around it, points of it that stick out farthest, and what rounding does to both.
#[derive(Clone, Debug)]
pub(crate) struct Extent {
    /// The corners of a polygon that holds the state.
    pub hull: Vec<DVec2>,
    /// Points of the state, to rounding.
    pub points: Vec<DVec2>,
    /// An upper bound of its diameter.
    pub diameter: f64,
    /// How far computed points and corners of the state and of its copies may be off in it, in the plane: through the
    /// rounding of coefficients, of products along ways, and of the polygon.
    pub off: f64,
}

/// Directions in which points are sought.
const DIRECTIONS: usize = 24;
/// Rounds of the search.
const ROUNDS: usize = 12;
/// Rounds in which what rounding may do is bounded more tightly.
const ROUNDS_OF_OFFS: usize = 100;
/// A few times the error of one rounding.
const ROUNDING_UNIT: f64 = 64.0 * f64::EPSILON;

impl Extent {
    /// Those of all states.
    pub fn of(system: &DirectedIfs) -> Vec<Self> {
        let hulls = Hull::of_states(system);
        let points = points(system);
        let offs = offs(system);
        let extent = |((hull, points), off): ((Hull, Vec<DVec2>), f64)| Self {
            hull: hull.vertices().to_vec(),
            points,
            diameter: hull.diameter() + 2.0 * off,
            off,
        };
        hulls.into_iter().zip(points).zip(offs).map(extent).collect()
    }

    /// The largest `direction . x` over the polygon.
    pub fn support(&self, direction: DVec2) -> f64 {
        self.hull.iter().map(|corner| corner.dot(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The point of the state, of those known, that is farthest in a direction.
    pub fn farthest(&self, direction: DVec2) -> DVec2 {
        let mut best = (f64::NEG_INFINITY, self.points[0]);
        for point in &self.points {
            let along = point.dot(direction);
            if along > best.0 {
                best = (along, *point);
            }
        }
        best.1
    }
}

/// Points of each state that are farthest in some direction, of those that a few steps lead to.
fn points(system: &DirectedIfs) -> Vec<Vec<DVec2>> {
    let directions: [DVec2; DIRECTIONS] =
        std::array::from_fn(|k| DVec2::from_angle(std::f64::consts::TAU * k as f64 / DIRECTIONS as f64));
    let farthest = |points: &[DVec2], direction: DVec2| {
        points.iter().copied().max_by(|p, q| p.dot(direction).total_cmp(&q.dot(direction)))
    };
    let mut points: Vec<Vec<DVec2>> = system.points().into_iter().map(|point| vec![point]).collect();
    for _ in 0..ROUNDS {
        let next = system.states().iter().zip(&points).map(|(maps, own)| {
            let reach = |direction: DVec2| {
                let images = maps.iter().filter_map(|part| {
                    let pulled = part.map.linear.transpose() * direction;
                    farthest(&points[part.from], pulled).map(|point| part.map.apply(point))
                });
                let all: Vec<DVec2> = images.chain(own.iter().copied()).filter(|p| p.is_finite()).collect();
                farthest(&all, direction)
            };
            let mut found: Vec<DVec2> = directions.iter().filter_map(|&d| reach(d)).collect();
            found.dedup();
            if found.is_empty() { own.clone() } else { found }
        });
        points = next.collect();
    }
    points
}

fn norm(m: DMat2) -> f64 {
    frond_core::Affine2::new(m, DVec2::ZERO).norm()
}

/// How far computed points of the states may be off, in the plane.
///
/// In the round coordinates of its state a map is off by the rounding of its numbers, seen there; each step shrinks
/// what was off before. Products are computed in the plane, which costs as much as the ellipses are thin.
fn offs(system: &DirectedIfs) -> Vec<f64> {
    let contraction = system.contraction();
    let discs = &contraction.discs;
    let thin = discs.iter().map(|disc| norm(disc.to_round) * norm(disc.from_round)).fold(1.0, f64::max);
    let reach = |disc: &StateDisc| disc.centre.length() + norm(disc.from_round) * disc.radius;
    let mut steps: Vec<(usize, usize, f64, f64)> = Vec::new();
    for (into, (disc, maps)) in discs.iter().zip(system.states()).enumerate() {
        for part in maps {
            let inner = &discs[part.from];
            let size = part.map.norm() * reach(inner) + part.map.translation.length() + reach(disc);
            let shrinks = norm(disc.to_round * part.map.linear * inner.from_round);
            steps.push((into, part.from, ROUNDING_UNIT * thin * norm(disc.to_round) * size, shrinks));
        }
    }
    let (error, growth) =
        steps.iter().fold((0.0_f64, 1.0_f64), |(e, g), step| (e.max(step.2), g.max(step.3)));
    let length = contraction.length;
    let spread = length as f64 * growth.powi(length as i32 - 1) / (1.0 - contraction.factor);
    // What is enough for all, and then less where less is enough: as with the discs.
    let mut offs = vec![error * spread; discs.len()];
    for _ in 0..if length == 1 { ROUNDS_OF_OFFS } else { 0 } {
        let mut next = vec![0.0_f64; discs.len()];
        for &(into, from, error, shrinks) in &steps {
            next[into] = next[into].max(error + shrinks * (1.0 + 1e-12) * offs[from]);
        }
        offs = offs.iter().zip(next).map(|(off, next)| off.min(next)).collect();
    }
    // The polygon is computed to some 1e-12 of the disc, outward; its corners are rounded in the plane.
    let in_plane =
        |(disc, off): (&StateDisc, f64)| norm(disc.from_round) * off + ROUNDING_UNIT * thin * reach(disc);
    discs.iter().zip(offs).map(in_plane).collect()
}
