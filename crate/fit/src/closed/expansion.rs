//! A self-affine closed curve as a polyline, with what its points owe to each number.

use glam::{DMat2, DVec2};

use super::{ArcCopy, ClosedCurve, complex, over};

/// The most points of an expansion.
pub(crate) const MAX_VERTICES: usize = 1 << 18;

/// Derivatives smaller than this are left out.
const LEAST_DERIVATIVE: f64 = 1e-3;

/// A point of the expansion and its derivatives by knots and by the factors c of edges.
#[derive(Clone, Debug)]
pub(crate) struct Vertex {
    pub at: DVec2,
    /// How long the sides were between which it is, when it was new.
    size: f64,
    pub knots: Vec<(u32, DMat2)>,
    pub factors: Vec<(u32, DVec2)>,
}

impl Vertex {
    pub fn knot(curve: &ClosedCurve, index: usize, jets: bool) -> Self {
        let knots = if jets { vec![(index as u32, DMat2::IDENTITY)] } else { Vec::new() };
        Self { at: curve.knots[index], size: f64::INFINITY, knots, factors: Vec::new() }
    }

    fn add(&mut self, knot: usize, derivative: DMat2) {
        match self.knots.iter_mut().find(|entry| entry.0 == knot as u32) {
            Some(entry) => entry.1 += derivative,
            None => self.knots.push((knot as u32, derivative)),
        }
    }
}

/// A curve taken apart to straight sides.
#[derive(Clone, Debug)]
pub struct Expansion {
    pub(crate) vertices: Vec<Vertex>,
    /// The first vertex of each edge, and their number at the end.
    pub(crate) starts: Vec<usize>,
}

impl Expansion {
    /// The corners, in order.
    #[must_use]
    pub fn points(&self) -> Vec<DVec2> {
        self.vertices.iter().map(|vertex| vertex.at).collect()
    }

    /// The corners of one edge, without its last.
    #[must_use]
    pub fn edge(&self, index: usize) -> Vec<DVec2> {
        self.vertices[self.starts[index]..self.starts[index + 1]].iter().map(|v| v.at).collect()
    }
}

/// One copy: how the points of its arc become points of the edge.
struct Frame<'a> {
    curve: &'a ClosedCurve,
    index: usize,
    copy: ArcCopy,
    first: usize,
    last: usize,
    edge: DVec2,
    chord: DVec2,
    squash: DMat2,
    linear: DMat2,
}

impl<'a> Frame<'a> {
    fn new(curve: &'a ClosedCurve, index: usize, copy: ArcCopy) -> Self {
        let (first, last) = curve.arc_ends(&copy);
        let chord = curve.knots[last] - curve.knots[first];
        let edge = curve.knot(index + 1) - curve.knots[index];
        let squash = DMat2::from_diagonal(DVec2::new(1.0, copy.c));
        let linear = complex(edge) * squash * complex(over(DVec2::X, chord));
        Self { curve, index, copy, first, last, edge, chord, squash, linear }
    }

    /// With w = (U - A) / (B - A) in the arc's own frame, the image of U is P + (Q - P) (Re w + i c Im w); the rest is
    /// its derivative by P, Q, A, B, U and c.
    fn image(&self, vertex: &Vertex, size: f64, jets: bool) -> Vertex {
        let w = over(vertex.at - self.curve.knots[self.first], self.chord);
        let s = self.squash * w;
        let at = self.curve.knots[self.index] + complex(self.edge) * s;
        let mut image = Vertex { at, size, knots: Vec::new(), factors: Vec::new() };
        if !jets {
            return image;
        }
        let next = (self.index + 1) % self.curve.knots.len();
        image.add(self.index, complex(DVec2::X - s));
        image.add(next, complex(s));
        image.add(self.first, -self.linear * complex(DVec2::X - w));
        image.add(self.last, -self.linear * complex(w));
        for &(knot, derivative) in &vertex.knots {
            image.add(knot as usize, self.linear * derivative);
        }
        image.knots.retain(|(_, m)| {
            m.x_axis.abs().max_element().max(m.y_axis.abs().max_element()) > LEAST_DERIVATIVE
        });
        image.factors.push((self.index as u32, self.edge.perp() * w.y));
        for &(edge, derivative) in &vertex.factors {
            let moved = self.linear * derivative;
            match image.factors.iter_mut().find(|entry| entry.0 == edge) {
                Some(entry) => entry.1 += moved,
                None => image.factors.push((edge, moved)),
            }
        }
        image
    }
}

impl ClosedCurve {
    /// The curve as a polyline: copies are opened until edges of copies are shorter than `tolerance`, at most `levels`
    /// deep. The curve must be [sound](Self::is_sound).
    #[must_use]
    pub fn expand(&self, tolerance: f64, levels: usize) -> Expansion {
        self.expand_with(tolerance, levels, false)
    }

    /// The corners of [`expand`](Self::expand).
    #[must_use]
    pub fn polyline(&self, tolerance: f64, levels: usize) -> Vec<DVec2> {
        self.expand(tolerance, levels).points()
    }

    pub(crate) fn expand_with(&self, tolerance: f64, levels: usize, jets: bool) -> Expansion {
        let count = self.knots.len();
        let knots: Vec<_> = (0..count).map(|i| Vertex::knot(self, i, jets)).collect();
        let mut level = Expansion { vertices: knots.clone(), starts: (0..=count).collect() };
        if self.copies() == 0 {
            return level;
        }
        for _ in 0..levels {
            let next = self.opened(&level, &knots, tolerance, jets);
            // Every corner is exact from the level on that brings it: one that brings none is the last.
            let done = next.vertices.len() == level.vertices.len() || next.vertices.len() > MAX_VERTICES;
            level = next;
            if done {
                break;
            }
        }
        level
    }

    /// Each copy as the image of its arc in `level`.
    pub(crate) fn opened(
        &self,
        level: &Expansion,
        knots: &[Vertex],
        tolerance: f64,
        jets: bool,
    ) -> Expansion {
        let mut next = Expansion {
            vertices: Vec::with_capacity(2 * level.vertices.len()),
            starts: Vec::with_capacity(knots.len() + 1),
        };
        for (i, knot) in knots.iter().enumerate() {
            next.starts.push(next.vertices.len());
            next.vertices.push(knot.clone());
            if let Some(copy) = self.edges[i] {
                let frame = Frame::new(self, i, copy);
                frame.open(level, tolerance, jets, &mut next.vertices);
            }
        }
        next.starts.push(next.vertices.len());
        next
    }
}

impl Frame<'_> {
    /// Puts the images of the arc's corners between its ends.
    fn open(&self, level: &Expansion, tolerance: f64, jets: bool, out: &mut Vec<Vertex>) {
        let count = self.curve.knots.len();
        let scale = crate::fractal::piece::spectral_norm(self.linear);
        let mut before = 0.0_f64;
        for step in 0..self.copy.span {
            let place = if self.copy.reversed { self.copy.span - 1 - step } else { step };
            let edge = (self.copy.from + place) % count;
            let (start, end) = (level.starts[edge], level.starts[edge + 1]);
            let side = scale * self.curve.knots[edge].distance(self.curve.knot(edge + 1));
            // A corner of the arc itself lies between two of its edges; its first end is the edge's own knot.
            let corner = if self.copy.reversed { (edge + 1) % count } else { edge };
            if step > 0 {
                out.push(self.image(&level.vertices[level.starts[corner]], side.max(before), jets));
            }
            before = side;
            let corners = if side < tolerance { start..start } else { start + 1..end };
            let mut take = |at: usize| {
                let vertex = &level.vertices[at];
                let size = scale * vertex.size;
                if size >= tolerance {
                    out.push(self.image(vertex, size, jets));
                }
            };
            if self.copy.reversed {
                corners.rev().for_each(&mut take);
            } else {
                corners.for_each(&mut take);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> ClosedCurve {
        let knots = [[0.0, 0.0], [0.5, 0.2], [1.0, 0.0], [1.1, 0.5], [1.0, 1.0], [0.0, 1.0]]
            .map(DVec2::from)
            .to_vec();
        let mut curve = ClosedCurve::polygon(knots);
        curve.edges[0] = Some(ArcCopy { from: 1, span: 3, reversed: false, c: 0.7 });
        curve.edges[3] = Some(ArcCopy { from: 0, span: 2, reversed: true, c: -0.4 });
        curve
    }

    #[test]
    fn an_edge_is_the_image_of_its_arc() {
        let curve = square();
        assert!(curve.is_sound());
        let fine = curve.expand(1e-6, 12);
        for (i, copy) in curve.edges.iter().enumerate() {
            let Some(copy) = copy else { continue };
            let (linear, origin) = curve.map(i).unwrap();
            let mut arc: Vec<_> = (0..copy.span).flat_map(|k| fine.edge((copy.from + k) % 6)).collect();
            arc.push(curve.knot(copy.from + copy.span));
            if copy.reversed {
                arc.reverse();
            }
            let ours = fine.edge(i);
            // Each opened one level deeper than the other: corners are compared with the nearest.
            let near = crate::outline::Nearest::new(&ours, false);
            let last = near.to(curve.knot(i + 1)).squared.sqrt();
            for p in &arc {
                let image = curve.knots[i] + linear * (*p - origin);
                assert!(near.to(image).squared.sqrt() < 1e-4 + last, "edge {i}: {image}");
            }
            assert!(
                (curve.knots[i] + linear * (arc[arc.len() - 1] - origin)).distance(curve.knot(i + 1)) < 1e-12
            );
        }
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        let curve = square();
        let expand = |curve: &ClosedCurve| curve.expand_with(0.0, 3, true);
        let plain = expand(&curve);
        let step = 1e-6;
        for i in 0..6 {
            for axis in [DVec2::X, DVec2::Y] {
                let mut moved = curve.clone();
                moved.knots[i] += axis * step;
                for (a, b) in plain.vertices.iter().zip(&expand(&moved).vertices) {
                    let told: DVec2 = a.knots.iter().filter(|k| k.0 == i as u32).map(|k| k.1 * axis).sum();
                    assert!(((b.at - a.at) / step).distance(told) < 2e-3, "knot {i}");
                }
            }
            if curve.edges[i].is_some() {
                let mut moved = curve.clone();
                if let Some(copy) = &mut moved.edges[i] {
                    copy.c += step;
                }
                for (a, b) in plain.vertices.iter().zip(&expand(&moved).vertices) {
                    let told: DVec2 = a.factors.iter().filter(|k| k.0 == i as u32).map(|k| k.1).sum();
                    assert!(((b.at - a.at) / step).distance(told) < 1e-4, "factor {i}");
                }
            }
        }
    }
}
