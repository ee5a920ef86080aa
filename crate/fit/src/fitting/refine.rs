//! Least squares through the attractor: knots and factors move until the outline lies as near as it can.

use std::borrow::Cow;

use glam::DVec2;

use super::distances::Distances;
use super::normal::Rows;
use crate::closed::expansion::Vertex;
use crate::closed::{CONTRACTION, ClosedCurve, FITTING_SHARE};
use crate::outline::{Guard, Near, Nearest};

/// So many products take about as long as one point that is looked up.
const PRODUCTS: u64 = 32;

/// What it costs the curve to be off the outline, where the outline's points do not see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ties {
    /// Weight of the curve's squared distances from the outline, against those of the outline from the curve.
    pub back: f64,
    /// Weight of the square of what is beyond the reach.
    pub beyond: f64,
    /// The same for what the outline's points are from the curve.
    pub far: f64,
    /// In plane units.
    pub reach: f64,
}

/// Levenberg-Marquardt on the distances from points of an outline to a curve.
///
/// Each point is tied to the nearest point of the curve as it is now; only the distance across the curve counts, and
/// along it the point is free to slide, but at corners. The curve in its turn is tied to the outline, with less weight:
/// else it would reach out where no point of the outline sees it.
#[derive(Clone, Debug)]
pub struct Refiner {
    points: Vec<DVec2>,
    outline: Nearest,
    /// Points of the outline for a unit of its length.
    density: f64,
    ties: Ties,
    tolerance: f64,
    levels: usize,
    damping: f64,
    guard: Option<Guard>,
    /// The curve that was measured last: it is mostly the one that is moved next.
    last: Option<(ClosedCurve, Distances)>,
    work: u64,
}

impl Refiner {
    /// Prepares for the points of an outline; edges of copies shorter than `tolerance` are not opened.
    #[must_use]
    pub fn new(points: Vec<DVec2>, tolerance: f64, levels: usize) -> Self {
        let outline = Nearest::new(&points, true);
        let side = |i: usize| points[i].distance(points[(i + 1) % points.len()]);
        let length: f64 = (0..points.len()).map(side).sum();
        let density = points.len() as f64 / length.max(f64::MIN_POSITIVE);
        Self {
            points,
            outline,
            density,
            ties: Ties { back: 1.0, beyond: 0.0, far: 0.0, reach: 0.0 },
            tolerance,
            levels,
            damping: 1e-2,
            guard: None,
            last: None,
            work: 0,
        }
    }

    /// Where curves may cross themselves: those that do elsewhere have an infinite error from now on.
    pub fn set_guard(&mut self, guard: Option<Guard>) {
        self.guard = guard;
    }

    /// How much has been done so far, in points looked up, about: the same for the same steps.
    #[must_use]
    pub fn work(&self) -> u64 {
        self.work
    }

    /// Sets what it costs to be off the outline. At first both directions count alike.
    pub fn set_ties(&mut self, ties: Ties) {
        self.ties = ties;
        self.last = None;
    }

    /// Whether the curve is tied to the outline, as the outline is to the curve.
    fn is_tied(&self) -> bool {
        self.ties.back > 0.0 || self.ties.beyond > 0.0
    }

    /// The sum of squares of a curve; infinite where it is not sound with something to spare, or crosses itself where
    /// it must not.
    #[must_use]
    pub fn error(&mut self, curve: &ClosedCurve) -> f64 {
        if !curve.is_safe() {
            return f64::INFINITY;
        }
        let expansion = curve.expand(self.tolerance, self.levels);
        let polyline = expansion.points();
        self.work += polyline.len() as u64;
        if self.guard.as_ref().is_some_and(|guard| !guard.passes(&polyline)) {
            return f64::INFINITY;
        }
        self.work += (self.points.len() + 2 * polyline.len()) as u64;
        let distances =
            Distances::new(expansion.starts, polyline, &self.points, self.is_tied().then_some(&self.outline));
        let error = self.outline_error(&distances) + self.backward_error(&distances);
        self.last = Some((curve.clone(), distances));
        error
    }

    /// The distances of a curve: those that are known, or measured anew.
    fn distances(&self, curve: &ClosedCurve) -> Cow<'_, Distances> {
        match &self.last {
            Some((known, distances)) if known == curve => Cow::Borrowed(distances),
            _ => {
                let expansion = curve.expand(self.tolerance, self.levels);
                let polyline = expansion.points();
                let back = self.is_tied().then_some(&self.outline);
                Cow::Owned(Distances::new(expansion.starts, polyline, &self.points, back))
            }
        }
    }

    /// For each edge the sum of squares of the points nearest to it, and the index of the farthest of them.
    #[must_use]
    pub fn shares(&self, curve: &ClosedCurve) -> Vec<(f64, usize)> {
        self.distances(curve).shares()
    }

    fn outline_error(&self, distances: &Distances) -> f64 {
        let square = |near: &Near| {
            let squared = near.squared;
            let over = if self.ties.far > 0.0 { (squared.sqrt() - self.ties.reach).max(0.0) } else { 0.0 };
            squared + self.ties.far * over * over
        };
        distances.points.iter().map(square).sum()
    }

    fn backward_error(&self, distances: &Distances) -> f64 {
        let square = |near: &Near| {
            let over = (near.squared.sqrt() - self.ties.reach).max(0.0);
            self.ties.back * near.squared + self.ties.beyond * over * over
        };
        let polyline = &distances.polyline;
        let side = |(i, near): (usize, &[Near; 2])| {
            let (a, b) = (polyline[i], polyline[(i + 1) % polyline.len()]);
            0.5 * (square(&near[0]) + square(&near[1])) * a.distance(b)
        };
        self.density * distances.back.iter().enumerate().map(side).sum::<f64>()
    }

    /// Adds what was done elsewhere.
    pub(crate) fn count(&mut self, work: u64) {
        self.work += work;
    }

    /// Begins anew with weak damping, for another curve.
    pub fn reset(&mut self) {
        self.damping = 1e-2;
    }

    /// One step: the curve is replaced by a better one if one is found, and the sum of squares is given back with
    /// whether it was.
    pub fn step(&mut self, curve: &mut ClosedCurve, error: f64) -> (f64, bool) {
        let system = self.system(curve);
        // Where the points are few and the copies many, it is not looking up that takes long.
        let mut paid = (self.points.len() + system.entries()) as u64;
        self.work += paid;
        let system = system.normal();
        for _ in 0..6 {
            let mut products = 0;
            let change = system.solve(self.damping, &mut products);
            let solving = products / PRODUCTS;
            self.work += solving.saturating_sub(paid);
            paid = paid.saturating_sub(solving);
            let Some(change) = change else {
                self.damping *= 8.0;
                continue;
            };
            let moved = moved(curve, &change);
            let next = self.error(&moved);
            if next < error {
                *curve = moved;
                self.damping = (self.damping * 0.2).max(1e-7);
                return (next, true);
            }
            self.damping = (self.damping * 6.0).min(1e8);
        }
        (error, false)
    }

    /// The equations of the present step.
    #[inline(never)]
    fn system(&self, curve: &ClosedCurve) -> Rows {
        let expansion = curve.expand_with(self.tolerance, self.levels, true);
        let vertices = &expansion.vertices;
        let distances = self.distances(curve);
        let polyline = &distances.polyline;
        let edges = distances.edges();
        let count = curve.knots.len();
        let mut places = vec![usize::MAX; count];
        let mut size = 2 * count;
        for (place, edge) in places.iter_mut().zip(&curve.edges) {
            if edge.is_some() {
                *place = size;
                size += 1;
            }
        }
        let mut rows = Rows::new(size, count);
        let mut row: Vec<(usize, f64)> = Vec::new();
        for (p, near) in self.points.iter().zip(&distances.points) {
            let ends = [near.side, (near.side + 1) % vertices.len()];
            let weights = [1.0 - near.share, near.share];
            let at = polyline[ends[0]].lerp(polyline[ends[1]], near.share);
            let inside = near.share > 0.0 && near.share < 1.0;
            let across = (polyline[ends[1]] - polyline[ends[0]]).perp().normalize_or_zero();
            // What is beyond the reach pulls as a heavier point at a shorter distance would.
            let far = near.squared.sqrt();
            let over = if self.ties.far > 0.0 { (far - self.ties.reach).max(0.0) } else { 0.0 };
            let both = 1.0 + if over > 0.0 { self.ties.far } else { 0.0 };
            let pull = if far > 0.0 { (far + self.ties.far * over) / (both * far) } else { 1.0 };
            let scale = both.sqrt();
            let directions = if inside { [across, DVec2::ZERO] } else { [DVec2::X, DVec2::Y] };
            for direction in directions {
                if direction == DVec2::ZERO {
                    continue;
                }
                row.clear();
                for (vertex, weight) in ends.iter().zip(weights) {
                    fill(&mut row, &vertices[*vertex], direction * (weight * scale), &places);
                }
                rows.add(edges[near.side], &row, direction.dot(*p - at) * pull * scale);
            }
        }
        for (i, nears) in distances.back.iter().enumerate() {
            let next = (i + 1) % vertices.len();
            let weight = 0.5 * self.density * polyline[i].distance(polyline[next]);
            for (share, near) in [0.0, 0.5].into_iter().zip(nears) {
                let at = polyline[i].lerp(polyline[next], share);
                let (a, b) = self.outline.ends(near.side);
                let offset = a.lerp(b, near.share) - at;
                // Across the outline, towards it.
                let far = offset.length();
                let over = (far - self.ties.reach).max(0.0);
                let both = self.ties.back + if over > 0.0 { self.ties.beyond } else { 0.0 };
                if both <= 0.0 {
                    continue;
                }
                let scale = (weight * both).sqrt();
                let direction = offset.normalize_or((b - a).perp().normalize_or_zero()) * scale;
                row.clear();
                fill(&mut row, &vertices[i], direction * (1.0 - share), &places);
                fill(&mut row, &vertices[next], direction * share, &places);
                rows.add(edges[i], &row, (self.ties.back * far + self.ties.beyond * over) / both * scale);
            }
        }
        rows
    }
}

/// Adds what a corner's place along `scaled` owes to each number.
fn fill(row: &mut Vec<(usize, f64)>, vertex: &Vertex, scaled: DVec2, places: &[usize]) {
    if scaled == DVec2::ZERO {
        return;
    }
    for &(knot, derivative) in &vertex.knots {
        let both = derivative.transpose() * scaled;
        add(row, 2 * knot as usize, both.x);
        add(row, 2 * knot as usize + 1, both.y);
    }
    for &(edge, derivative) in &vertex.factors {
        add(row, places[edge as usize], derivative.dot(scaled));
    }
}

fn add(row: &mut Vec<(usize, f64)>, place: usize, value: f64) {
    match row.iter_mut().find(|entry| entry.0 == place) {
        Some(entry) => entry.1 += value,
        None => row.push((place, value)),
    }
}

/// The curve after a change of all its numbers, knots first. Factors are held to what contracts.
#[inline(never)]
fn moved(curve: &ClosedCurve, change: &[f64]) -> ClosedCurve {
    let mut moved = curve.clone();
    for (knot, change) in moved.knots.iter_mut().zip(change.chunks(2)) {
        *knot += DVec2::from_slice(change);
    }
    let mut rest = change[2 * curve.knots.len()..].iter();
    for i in 0..moved.edges.len() {
        let Some(mut copy) = moved.edges[i] else { continue };
        copy.c += rest.next().copied().unwrap_or(0.0);
        let (first, last) = moved.arc_ends(&copy);
        let edge = moved.knots[i].distance(moved.knot(i + 1));
        let most =
            0.999 * FITTING_SHARE * CONTRACTION * moved.knots[first].distance(moved.knots[last]) / edge;
        copy.c = copy.c.clamp(-most, most);
        moved.edges[i] = Some(copy);
    }
    moved
}
