//! The paper's own repair, averages and a Delaunay triangulation, and a variant of it.

use std::collections::HashMap;

use frond_core::Ifs;
use glam::{DMat2, DVec2};

use crate::continuity::delaunay::{Delaunay, STEPS};
use crate::continuity::footing::Footing;
use crate::mesh::Mesh;
use crate::shuffle::level_terms::{Source, Words};
use crate::shuffle::means::{Means, words};
use crate::shuffle::terms::{Terms, deepest_level};

/// A superposed displacement made continuous as Fujimoto et al. do it in section 5.3: the mean displacement of each
/// region that the shuffle leaves whole, interpolated over a Delaunay triangulation of the regions' middles.
///
/// Here the regions are the pieces of ke letters. The mean of a term over one is that of F_v over the piece that it is
/// shuffled to, exactly, turned as a whole; all points count alike, as the chaos game throws them. Where the roughness
/// varies, the weights are those at the middle. Middles that coincide are taken together, and four points far out have
/// the displacement of the middle that is nearest, so that the triangulation covers all and there is one even for
/// middles in a line.
///
/// Some terms shuffle nothing: k = kb and, where nothing turns, k = kb + 1. The paper averages all terms
/// ([`Continuity::Published`](crate::Continuity::Published)); its kb = ke, where nothing is separated, is the plain
/// deformation. The variant leaves these terms exact ([`Continuity::Average`](crate::Continuity::Average)), so that
/// kb = ke is the plain deformation without a jump.
#[derive(Clone, Debug)]
pub(crate) struct Average {
    maps: usize,
    means: Means,
    middles: Vec<DVec2>,
    /// For each word the vertex that it belongs to, and for each vertex what each of its words counts there.
    vertices: Vec<u32>,
    shares: Vec<f64>,
    /// The vertices whose displacements the outer four have.
    nearest: [usize; 4],
    triangulation: Delaunay,
    /// Whether the terms that shuffle nothing are averaged, too.
    all: bool,
    /// To coordinates in which the shape fills the unit square.
    low: DVec2,
    scale: f64,
}

/// The most words of ke letters: a triangulation of as many points takes a tenth of a second.
const MOST_CELLS: usize = 1 << 16;
/// How far out the outer four points lie.
const OUTER_POINTS: [(f64, f64); 4] = [(-1.0, -1.0), (2.0, -1.0), (-1.0, 2.0), (2.0, 2.0)];

impl Average {
    /// The most letters for a shape of so many maps.
    pub fn deepest(maps: usize) -> usize {
        deepest_level(maps, MOST_CELLS)
    }

    /// Over the words of as many letters as the last term, for meshes of the same size as this; the box holds the
    /// shape. `all` says whether the terms that shuffle nothing are averaged, too, where others shuffle.
    pub fn new(ifs: &Ifs, mesh: &Mesh, terms: &Terms, (low, high): (DVec2, DVec2), all: bool) -> Self {
        let all = all && terms.depth() > 0;
        let means = Means::new(ifs, terms.depth(), mesh, (low, high));
        let middle = means.middle();
        let middles: Vec<DVec2> =
            words(ifs.maps(), terms.depth()).iter().map(|word| word.apply(middle)).collect();
        let scale = 1.0 / (high - low).max_element().max(1e-300);
        let mut known: HashMap<[i32; 2], u32> = HashMap::with_capacity(middles.len());
        let (mut points, mut shared, mut vertices) = (Vec::new(), Vec::<u32>::new(), Vec::new());
        for &middle in &middles {
            // Rounded, so that no rounding error makes a triangle of its own.
            let steps = ((middle - low) * scale).clamp(DVec2::ZERO, DVec2::ONE) * STEPS;
            let place = [steps.x.round() as i32, steps.y.round() as i32];
            let number = *known.entry(place).or_insert(points.len() as u32);
            if number as usize == points.len() {
                points.push(place);
                shared.push(0);
            }
            shared[number as usize] += 1;
            vertices.push(number);
        }
        let nearest = OUTER_POINTS.map(|far| {
            let distance =
                |&i: &usize| (DVec2::from(points[i].map(f64::from)) / STEPS).distance_squared(far.into());
            (0..points.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
        });
        points.extend(OUTER_POINTS.map(|(x, y)| [x, y].map(|x| (x * STEPS) as i32)));
        let shares = shared.into_iter().map(|count| 1.0 / f64::from(count)).collect();
        let triangulation = Delaunay::new(points);
        Self { maps: ifs.len(), means, middles, vertices, shares, nearest, triangulation, all, low, scale }
    }

    /// Whether the terms that shuffle nothing are averaged, too.
    pub const fn averages_all(&self) -> bool {
        self.all
    }

    /// The averaged terms at each vertex of the triangulation.
    pub fn fill<S: Source>(&self, source: &S, mesh: &Mesh, terms: &Terms, factors: &[DMat2]) -> Vec<DVec2> {
        let means = source.means(&self.means);
        let mut values = vec![DVec2::ZERO; self.shares.len()];
        let mut words: Words<'_> = Words::new(terms, if S::TURNS { factors } else { &[] });
        let mut rest = self.middles.len();
        for k in 1..=terms.depth() {
            rest /= self.maps;
            words.advance(k, self.maps, |family, to, from, turn| {
                let same = terms.fixed().map(|weights| weights.list[family.slot(k)]);
                for i in 0..rest {
                    let (to, from) = (to * rest + i, from * rest + i);
                    let weight = same.unwrap_or_else(|| terms.weight(family, k, mesh, self.middles[to]));
                    let mean = means[from] * weight;
                    let mean = if S::TURNS && !factors.is_empty() { *turn * mean } else { mean };
                    let vertex = self.vertices[to] as usize;
                    values[vertex] += mean * self.shares[vertex];
                }
            });
        }
        if self.all {
            for ((&mean, &middle), &vertex) in means.iter().zip(&self.middles).zip(&self.vertices) {
                let plain = terms.at(mesh, middle, &mut None).plain;
                values[vertex as usize] += mean * (plain * self.shares[vertex as usize]);
            }
        }
        values.extend(self.nearest.map(|i| values[i]));
        values
    }

    /// The vertices of the triangle around a point of the plane, and what they count.
    pub fn footing(&self, point: DVec2) -> Footing {
        let place = ((point - self.low) * self.scale).max(DVec2::splat(-0.99)).min(DVec2::splat(1.99));
        let mut footing = Footing::default();
        for (vertex, share) in self.triangulation.weights(place) {
            footing.add(vertex, share);
        }
        footing
    }
}
