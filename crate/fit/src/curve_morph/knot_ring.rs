//! A closed curve that can be given further knots anywhere and stays what it is.

use glam::{DMat2, DVec2};

use crate::closed::{ClosedCurve, complex, over};

/// A copy seen from its chords distorts by no more than this: beyond it, digits would be lost.
const MOST_SHEAR: f64 = 1e3;

/// Copies of copies are seen through so many times.
const MOST_THROUGH: usize = 64;

/// What an edge copies: the arc over `span` edges (1 or more) from knot `from` on.
///
/// In the frames in which the arc's chord and the edge's run from 0 to 1, the copy is the matrix with columns (1, 0)
/// and `shape`. A fitted edge has (0, c); a part of one has another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rough {
    pub from: usize,
    pub span: usize,
    pub flipped: bool,
    pub shape: DVec2,
}

/// Knots, and what the edge from each to the next copies.
#[derive(Clone, Debug)]
pub(super) struct Ring {
    pub knots: Vec<DVec2>,
    pub edges: Vec<Option<Rough>>,
}

impl Ring {
    /// The curve, counter-clockwise.
    pub fn new(curve: &ClosedCurve) -> Self {
        let rough = |edge: &Option<crate::ArcCopy>| {
            edge.map(|copy| Rough {
                from: copy.from,
                span: copy.span,
                flipped: copy.reversed,
                shape: DVec2::new(0.0, copy.c),
            })
        };
        let ring = Self { knots: curve.knots.clone(), edges: curve.edges.iter().map(rough).collect() };
        let first = ring.knots[0];
        let twice = |i: usize| (ring.knots[i] - first).perp_dot(ring.knot(i + 1) - first);
        let area: f64 = (0..ring.knots.len()).map(twice).sum();
        if area < 0.0 { ring.turned() } else { ring }
    }

    /// The same curve the other way round. Copies stay the maps that they are: both chords turn.
    fn turned(mut self) -> Self {
        let count = self.knots.len();
        self.knots.reverse();
        self.edges.reverse();
        // The edge from knot i to i + 1 runs from knot count - 2 - i to the next one now.
        self.edges.rotate_left(1);
        for rough in self.edges.iter_mut().flatten() {
            rough.from = (2 * count - 1 - (rough.from + rough.span) % count) % count;
        }
        self
    }

    /// What makes the ring this one and no other: how many knots, where they are, and what the edges copy.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let knots = self.knots.iter().flat_map(|knot| knot.to_array());
        let edges = self.edges.iter().flat_map(|edge| {
            edge.map_or([0.0; 5], |rough| {
                let flipped = f64::from(u8::from(rough.flipped));
                [rough.from as f64, rough.span as f64, flipped, rough.shape.x, rough.shape.y]
            })
        });
        std::iter::once(self.knots.len() as f64).chain(knots).chain(edges)
    }

    pub fn knot(&self, index: usize) -> DVec2 {
        self.knots[index % self.knots.len()]
    }

    pub fn chord(&self, edge: usize) -> DVec2 {
        self.knot(edge + 1) - self.knots[edge]
    }

    /// The arc's ends, the one that comes to lie at the edge's beginning first.
    pub fn ends(&self, rough: &Rough) -> (usize, usize) {
        let count = self.knots.len();
        let (first, last) = (rough.from % count, (rough.from + rough.span) % count);
        if rough.flipped { (last, first) } else { (first, last) }
    }

    /// The linear part of the map that makes an edge of its arc.
    fn linear(&self, edge: usize, rough: &Rough) -> DMat2 {
        let (first, last) = self.ends(rough);
        let chord = self.knots[last] - self.knots[first];
        complex(self.chord(edge)) * DMat2::from_cols(DVec2::X, rough.shape) * complex(over(DVec2::X, chord))
    }

    /// The lengths of chords up to each knot in parts of the whole, with 1 at the end.
    pub fn places(&self) -> Vec<f64> {
        let count = self.knots.len();
        let mut sum = 0.0;
        let mut places = vec![0.0];
        for edge in 0..count {
            sum += self.chord(edge).length();
            places.push(sum);
        }
        for (i, place) in places.iter_mut().enumerate() {
            // Knots that all coincide are far from each other in number at least.
            *place = if sum > 0.0 { *place / sum } else { i as f64 / count as f64 };
        }
        places[count] = 1.0;
        places
    }

    /// The same curve, begun at another knot.
    pub fn rotate(&mut self, first: usize) {
        let count = self.knots.len();
        self.knots.rotate_left(first);
        self.edges.rotate_left(first);
        for rough in self.edges.iter_mut().flatten() {
            rough.from = (rough.from + count - first) % count;
        }
    }

    /// Puts a knot into an edge; the second part's copy is given, the first's stays. Arcs over the edge get longer.
    fn insert(&mut self, edge: usize, knot: DVec2, copies: [Option<Rough>; 2]) {
        let count = self.knots.len();
        self.knots.insert(edge + 1, knot);
        self.edges[edge] = copies[0];
        self.edges.insert(edge + 1, copies[1]);
        for rough in self.edges.iter_mut().flatten() {
            if (edge + count - rough.from) % count < rough.span {
                rough.span += 1;
            }
            if rough.from > edge {
                rough.from += 1;
            }
        }
    }

    /// Puts knots into an edge, as near as can be to `wanted`: points in order and how far along the edge they are,
    /// from 0 to 1. The curve does not change.
    pub fn open(&mut self, edge: usize, wanted: &[(f64, DVec2)]) {
        if wanted.is_empty() {
            return;
        }
        // A copy of one edge is seen through to what that one copies.
        for _ in 0..MOST_THROUGH {
            let Some(rough) = self.edges[edge].filter(|rough| rough.span == 1) else { break };
            let Some(through) = self.through(edge, &rough) else { break };
            self.edges[edge] = through;
        }
        let Some(rough) = self.edges[edge] else {
            let (a, b) = (self.knots[edge], self.knot(edge + 1));
            for (i, (share, _)) in wanted.iter().enumerate() {
                self.insert(edge + i, a.lerp(b, share.clamp(0.0, 1.0)), [None, None]);
            }
            return;
        };
        // The middle one first: then the others find parts of the edge on both sides.
        let middle = wanted.len() / 2;
        match self.nearest_split(edge, &rough, wanted[middle].1) {
            Some((knot, copies)) => {
                self.insert(edge, knot, copies);
                self.open(edge + 1, &wanted[middle + 1..]);
                self.open(edge, &wanted[..middle]);
            }
            None => {
                // There is no place: knots open from the nearer end.
                let early = wanted.iter().filter(|(share, _)| *share < 0.5).count();
                let (a, b) = (self.knots[edge], self.knot(edge + 1));
                for _ in early..wanted.len() {
                    self.insert(edge, b, [self.edges[edge], None]);
                }
                for _ in 0..early {
                    let copy = self.edges[edge];
                    self.insert(edge, a, [None, copy]);
                }
            }
        }
    }

    /// A copy of one edge that is a copy itself copies that one's arc; of a straight edge, it is straight. None where
    /// digits would be lost.
    fn through(&self, edge: usize, rough: &Rough) -> Option<Option<Rough>> {
        let Some(inner) = self.edges[rough.from] else { return Some(None) };
        let linear = self.linear(edge, rough) * self.linear(rough.from, &inner);
        let flipped = rough.flipped != inner.flipped;
        self.seen(self.chord(edge), linear, Rough { flipped, ..inner }).map(Some)
    }

    /// A copy by a linear map, for an edge with a chord.
    fn seen(&self, edge: DVec2, linear: DMat2, rough: Rough) -> Option<Rough> {
        let (first, last) = self.ends(&rough);
        let chord = self.knots[last] - self.knots[first];
        let shape = (complex(over(DVec2::X, edge)) * linear * complex(chord)).y_axis;
        (shape.is_finite() && shape.length() <= MOST_SHEAR).then_some(Rough { shape, ..rough })
    }

    /// The knot of the arc whose image is nearest to a point: where it is, and what the two parts copy.
    fn nearest_split(
        &self,
        edge: usize,
        rough: &Rough,
        wanted: DVec2,
    ) -> Option<(DVec2, [Option<Rough>; 2])> {
        let count = self.knots.len();
        let linear = self.linear(edge, rough);
        let (first, _) = self.ends(rough);
        let (a, b) = (self.knots[edge], self.knot(edge + 1));
        let mut best = None;
        let mut nearest = f64::INFINITY;
        for step in 1..rough.span {
            let along = if rough.flipped { rough.span - step } else { step };
            let knot = a + linear * (self.knot(rough.from + along) - self.knots[first]);
            let distance = knot.distance_squared(wanted);
            if distance >= nearest {
                continue;
            }
            let early = Rough { span: along, ..*rough };
            let late = Rough { from: (rough.from + along) % count, span: rough.span - along, ..*rough };
            let parts = if rough.flipped { [late, early] } else { [early, late] };
            let part = |rough: Rough, chord: DVec2| match self.edges[rough.from] {
                None if rough.span == 1 => Some(None),
                _ => self.seen(chord, linear, rough).map(Some),
            };
            if let (Some(left), Some(right)) = (part(parts[0], knot - a), part(parts[1], b - knot)) {
                nearest = distance;
                best = Some((knot, [left, right]));
            }
        }
        best
    }
}
