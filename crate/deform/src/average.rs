//! The paper's own repair: averages and a Delaunay triangulation.

use std::collections::HashMap;

use frond_core::Affine2;
use glam::{DMat2, DVec2};
use spade::{DelaunayTriangulation, FloatTriangulation, HasPosition, Point2, Triangulation};

use crate::fill::{Source, Words};
use crate::footing::Footing;
use crate::mesh::Mesh;
use crate::terms::Terms;

/// A superposed displacement made continuous as Fujimoto et al. do it in section 5.3: one displacement for each region
/// that the shuffle leaves whole, interpolated over a Delaunay triangulation of the regions' middles.
///
/// Here the regions are the words of ke letters, and each has the displacement of its middle. Middles that coincide are
/// taken together, and four points far out have the displacement of the middle that is nearest, so that the
/// triangulation covers all and there is one even for middles in a line. The plain displacement is left exact.
#[derive(Clone, Debug)]
pub(crate) struct Average {
    maps: usize,
    middles: Vec<DVec2>,
    /// For each word the vertex that it belongs to, and how many do.
    vertices: Vec<u32>,
    shared: Vec<u32>,
    /// The vertices whose displacements the outer four have.
    nearest: [usize; 4],
    triangulation: DelaunayTriangulation<Vertex>,
    /// To coordinates in which the shape fills the unit square.
    low: DVec2,
    scale: f64,
}

#[derive(Clone, Copy, Debug)]
struct Vertex {
    position: Point2<f64>,
    number: u32,
}

impl HasPosition for Vertex {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.position
    }
}

/// The most words of ke letters: a triangulation of as many points takes a tenth of a second.
const MOST_CELLS: usize = 1 << 16;
/// Middles are rounded to this part of the shape's size: no rounding error makes a triangle of its own.
const STEP: f64 = 1.0 / (1_u64 << 30) as f64;
/// How far out the outer four points lie.
const FAR: [(f64, f64); 4] = [(-1.0, -1.0), (2.0, -1.0), (-1.0, 2.0), (2.0, 2.0)];

impl Average {
    /// The most letters for a shape of so many maps.
    pub fn deepest(maps: usize) -> usize {
        if maps < 2 {
            return 32;
        }
        let mut cells = 1;
        (0..)
            .take_while(|_| {
                cells *= maps;
                cells <= MOST_CELLS
            })
            .count()
    }

    /// Over the words of as many letters as the last term; `middle` is a point amid the shape, which the box holds.
    pub fn new(maps: &[Affine2], terms: &Terms, middle: DVec2, (low, high): (DVec2, DVec2)) -> Self {
        let words = (0..terms.depth()).fold(vec![Affine2::IDENTITY], |words, _| {
            words.iter().flat_map(|word| maps.iter().map(move |map| *word * *map)).collect()
        });
        let middles: Vec<DVec2> = words.iter().map(|word| word.apply(middle)).collect();
        let scale = 1.0 / (high - low).max_element().max(1e-300);
        let mut known: HashMap<(i64, i64), u32> = HashMap::with_capacity(middles.len());
        let (mut points, mut shared, mut vertices) = (Vec::new(), Vec::new(), Vec::new());
        for &middle in &middles {
            let cell = ((middle - low) * scale / STEP).round();
            let number = *known.entry((cell.x as i64, cell.y as i64)).or_insert(points.len() as u32);
            if number as usize == points.len() {
                points.push(cell * STEP);
                shared.push(0);
            }
            shared[number as usize] += 1;
            vertices.push(number);
        }
        let nearest = FAR.map(|far| {
            let distance = |&i: &usize| points[i].distance_squared(far.into());
            (0..points.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
        });
        points.extend(FAR.map(DVec2::from));
        let vertex = |(number, point): (usize, &DVec2)| Vertex {
            position: Point2::new(point.x, point.y),
            number: number as u32,
        };
        // It refuses coordinates that are NaN or beyond all measure: there are none.
        let list = points.iter().enumerate().map(vertex).collect();
        let triangulation = DelaunayTriangulation::bulk_load(list).unwrap_or_default();
        Self { maps: maps.len(), middles, vertices, shared, nearest, triangulation, low, scale }
    }

    /// The shuffled terms at each vertex of the triangulation.
    pub fn fill<S: Source>(&self, source: &S, mesh: &Mesh, terms: &Terms, factors: &[DMat2]) -> Vec<DVec2> {
        let samples: Vec<DVec2> = self.middles.iter().map(|&middle| source.at(middle)).collect();
        let mut values = vec![DVec2::ZERO; self.shared.len()];
        let mut words = Words::new(terms, if S::TURNS { factors } else { &[] });
        let mut rest = self.middles.len();
        for k in 1..=terms.depth() {
            rest /= self.maps;
            words.advance(k, self.maps, |family, to, from, turn| {
                for i in 0..rest {
                    let (to, from) = (to * rest + i, from * rest + i);
                    let weight = terms.weight(family, k, mesh, self.middles[to]);
                    let sample = samples[from] * weight;
                    let sample = if S::TURNS && !factors.is_empty() { *turn * sample } else { sample };
                    let vertex = self.vertices[to] as usize;
                    values[vertex] += sample / f64::from(self.shared[vertex]);
                }
            });
        }
        values.extend(self.nearest.map(|i| values[i]));
        values
    }

    /// The vertices of the triangle around a point of the plane, and what they count.
    pub fn footing(&self, point: DVec2) -> Footing {
        let place = ((point - self.low) * self.scale).max(DVec2::splat(-0.99)).min(DVec2::splat(1.99));
        let mut found = Vec::with_capacity(3);
        self.triangulation.barycentric().get_weights(Point2::new(place.x, place.y), &mut found);
        let mut footing = Footing::default();
        for (vertex, share) in found {
            footing.add(self.triangulation.vertex(vertex).data().number, share);
        }
        footing
    }
}
