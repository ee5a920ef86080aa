//! Where the attractor is: coordinates in which all ways round contract, and a ball around each state.
//!
//! If balls around the states satisfy `f(B_from) in B_i` for all maps, each with room to spare, then every way round
//! contracts in the lengths that the radii measure, and the attractor lies in the balls.

use std::collections::BinaryHeap;

use crate::error::ExactError;
use crate::number::interval::Interval;
use crate::system::build::System;
use crate::system::real::{ORIGIN, Point, Square, distance, plus};
use crate::system::space::Space;

/// Coordinates and balls.
pub(crate) struct Frame {
    pub space: Space,
    pub maps: Vec<Vec<RealEdge>>,
    pub centres: Vec<Point>,
    pub radii: Vec<f64>,
}

/// A map in real coordinates.
#[derive(Clone, Copy)]
pub(crate) struct RealEdge {
    pub from: usize,
    pub linear: Square,
    pub shift: Point,
    pub norm: f64,
}

const MOST_ROUNDS: usize = 3000;
/// Pieces that are cut to find how far each state reaches.
const MOST_CUTS: usize = 200;
const SAMPLES: usize = 48;

impl Frame {
    pub fn new(system: &System) -> Result<Self, ExactError> {
        let is_similar = system.states.iter().flatten().all(|edge| edge.is_similar());
        let mut tried = vec![Square::identity(system.dimension())];
        if !is_similar {
            tried.extend([0.999, 0.9, 0.7, 0.5].into_iter().filter_map(|rate| coordinates(system, rate)));
        }
        let mut error = ExactError::NotContracting;
        for by in tried {
            match Self::of_coordinates(system, &by) {
                Ok(frame) => return Ok(frame),
                Err(found) => error = found,
            }
        }
        Err(error)
    }

    fn of_coordinates(system: &System, by: &Square) -> Result<Self, ExactError> {
        let space = system.space.transformed(by)?;
        let maps: Vec<Vec<RealEdge>> = system
            .states
            .iter()
            .map(|edges| {
                let real = |edge: &crate::system::build::Edge| {
                    let linear = space.action(&edge.linear);
                    RealEdge { from: edge.from, linear, shift: space.point(&edge.shift), norm: linear.norm() }
                };
                edges.iter().map(real).collect()
            })
            .collect();
        let centres = centres(&maps, space.dimension());
        let radii = radii(&maps, &centres).ok_or(ExactError::NotContracting)?;
        let mut frame = Self { space, maps, centres, radii };
        frame.radii = (0..frame.radii.len()).map(|state| frame.reach(state)).collect();
        Ok(frame)
    }

    /// A better bound of how far a state reaches: of its farthest pieces, cut ever smaller.
    fn reach(&self, state: usize) -> f64 {
        let mut heap = BinaryHeap::new();
        heap.push(self.piece(state, state, Square::identity(self.space.dimension()), ORIGIN));
        for _ in 0..MOST_CUTS {
            let Some(piece) = heap.pop() else { break };
            for edge in &self.maps[piece.state] {
                let linear = piece.linear.times(&edge.linear);
                let shift = plus(&piece.linear.apply(&edge.shift), &piece.shift);
                heap.push(self.piece(state, edge.from, linear, shift));
            }
        }
        let farthest = heap.peek().map_or(f64::INFINITY, |piece| piece.bound);
        farthest.min(self.radii[state])
    }

    fn piece(&self, whole: usize, state: usize, linear: Square, shift: Point) -> Piece {
        let centre = plus(&linear.apply(&self.centres[state]), &shift);
        let radius = Interval::point(linear.norm()) * Interval::point(self.radii[state]);
        let bound = (distance(&centre, &self.centres[whole]) + radius).upper();
        Piece { bound, state, linear, shift }
    }
}

struct Piece {
    bound: f64,
    state: usize,
    linear: Square,
    shift: Point,
}

impl Ord for Piece {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Piece {}

/// Near the middles of the smallest balls around points of the attractor.
fn centres(maps: &[Vec<RealEdge>], dimension: usize) -> Vec<Point> {
    type Double = [f64; 3];
    let apply = |edge: &RealEdge, p: &Double| {
        let mut image = [0.0; 3];
        for (i, x) in image.iter_mut().enumerate().take(dimension) {
            let row = edge.linear.rows[i].iter().zip(p).take(dimension);
            *x = edge.shift[i].middle() + row.map(|(entry, p)| entry.middle() * p).sum::<f64>();
        }
        image
    };
    let mut samples: Vec<Vec<Double>> = vec![vec![[0.0; 3]; SAMPLES]; maps.len()];
    let mut seed = 1u64;
    let mut draw = |below: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % below
    };
    for _ in 0..120 {
        samples = maps
            .iter()
            .map(|edges| {
                let next = |k: usize| {
                    let edge = &edges[k % edges.len()];
                    apply(edge, &samples[edge.from][draw(SAMPLES)])
                };
                (0..SAMPLES.max(edges.len())).map(next).collect()
            })
            .collect();
    }
    let middle = |points: &Vec<Double>| {
        // Towards the farthest point, by ever smaller steps (Badoiu & Clarkson 2003).
        let mut centre = points[0];
        for step in 1..60 {
            let far = |p: &Double| (0..3).map(|k| (p[k] - centre[k]).powi(2)).sum::<f64>();
            let Some(farthest) = points.iter().max_by(|a, b| far(a).total_cmp(&far(b))) else { break };
            for (c, far) in centre.iter_mut().zip(farthest) {
                *c += (far - *c) / f64::from(step + 1);
            }
        }
        centre.map(|x| if x.is_finite() { Interval::point(x) } else { Interval::ZERO })
    };
    samples.iter().map(middle).collect()
}

/// Radii of balls that every map sends into one another with room to spare.
fn radii(maps: &[Vec<RealEdge>], centres: &[Point]) -> Option<Vec<f64>> {
    let moved = |state: usize, edge: &RealEdge| {
        let image = plus(&edge.linear.apply(&centres[edge.from]), &edge.shift);
        distance(&image, &centres[state]).upper()
    };
    let far: Vec<Vec<f64>> = maps
        .iter()
        .enumerate()
        .map(|(state, edges)| edges.iter().map(|edge| moved(state, edge)).collect())
        .collect();
    let farthest = far.iter().flatten().copied().fold(0.0, f64::max);
    let norm = maps.iter().flatten().map(|edge| edge.norm).fold(0.0, f64::max);
    if !farthest.is_finite() || !norm.is_finite() {
        return None;
    }
    let room = farthest.mul_add(1e-3, 1e-9);
    let needed = |radii: &[f64], room: f64| -> Vec<f64> {
        let of_state = |(edges, far): (&Vec<RealEdge>, &Vec<f64>)| {
            let reach = edges.iter().zip(far).map(|(edge, far)| {
                let grown = Interval::point(edge.norm) * Interval::point(radii[edge.from]);
                (grown + Interval::point(*far) + Interval::point(room)).upper()
            });
            reach.fold(0.0, f64::max)
        };
        maps.iter().zip(&far).map(of_state).collect()
    };
    let start = if norm < 1.0 { (farthest + 1.01 * room) / (1.0 - norm) * (1.0 + 1e-9) } else { room };
    let mut radii = vec![start; maps.len()];
    for _ in 0..MOST_ROUNDS {
        let next = needed(&radii, room);
        if next.iter().zip(&radii).all(|(next, radius)| next <= radius) {
            return Some(needed(&radii, 0.0));
        }
        // A little more than is needed, so that rounding does not keep it from being enough.
        radii = next.iter().zip(&radii).map(|(next, radius)| next.max(*radius) * (1.0 + 1e-6)).collect();
        if radii.iter().any(|radius| *radius > 1e12 * (farthest + 1e-9)) {
            break;
        }
    }
    None
}

/// Coordinates in which the linear parts contract at some rate, if they do so on average: the square root of a form Q
/// with `Q = 1 + rate^-2 mean(L^T Q L)`.
fn coordinates(system: &System, rate: f64) -> Option<Square> {
    let d = system.dimension();
    type Form = [[f64; 3]; 3];
    let linears: Vec<Form> = system
        .states
        .iter()
        .flatten()
        .map(|edge| system.space.action(&edge.linear).rows.map(|row| row.map(Interval::middle)))
        .collect();
    let scale = 1.0 / (rate * rate * linears.len() as f64);
    let mut form: Form = [[0.0; 3]; 3];
    for _ in 0..2000 {
        let mut next: Form = [[0.0; 3]; 3];
        for (i, row) in next.iter_mut().enumerate().take(d) {
            row[i] = 1.0;
        }
        for l in &linears {
            for i in 0..d {
                for j in 0..d {
                    let mut sum = 0.0;
                    for a in 0..d {
                        for b in 0..d {
                            sum += l[a][i] * form[a][b] * l[b][j];
                        }
                    }
                    next[i][j] += scale * sum;
                }
            }
        }
        let change = (0..9).map(|k| (next[k / 3][k % 3] - form[k / 3][k % 3]).abs()).fold(0.0, f64::max);
        form = next;
        if form[0][0] > 1e12 {
            return None;
        }
        if change < 1e-12 * form[0][0] {
            break;
        }
    }
    // Cholesky: Q = U^T U with an upper triangle U, which is as good as the square root.
    let mut upper: Form = [[0.0; 3]; 3];
    for i in 0..d {
        for j in i..d {
            let sum: f64 = (0..i).map(|k| upper[k][i] * upper[k][j]).sum();
            let rest = form[i][j] - sum;
            upper[i][j] = if i == j { rest.sqrt() } else { rest / upper[i][i] };
            if !upper[i][j].is_finite() {
                return None;
            }
        }
    }
    Some(Square::from_fn(d, |i, j| Interval::point(upper[i][j])))
}
