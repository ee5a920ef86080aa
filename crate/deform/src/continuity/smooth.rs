//! The shuffled terms without a tear, on shapes whose pieces meet in corners.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::continuity::footing::Footing;
use crate::continuity::lattice::Lattice;
use crate::mesh::Mesh;
use crate::shuffle::cursor::Cursor;
use crate::shuffle::level_terms::{Source, Words};
use crate::shuffle::terms::{Family, Terms};

/// A superposed displacement (Fujimoto et al., eq 12) that is continuous over the shape.
///
/// The paper averages each region that the shuffle leaves whole and interpolates the averages over a Delaunay
/// triangulation. Here every term is sampled at the corners of its own cells, averaged over the cells that share
/// a corner, and interpolated inside: neighbours agree on what they share, so nothing tears. The terms kb and
/// kb + 1, which are no shuffle at all, stay exact where nothing turns.
///
/// Where the roughness varies, the weights are those at the corners and are interpolated like the terms, so that they
/// sum to 1 everywhere and a mesh moved as a whole moves the shape as a whole.
#[derive(Clone, Debug)]
pub(crate) struct Smooth {
    lattice: Lattice,
    inverses: Vec<Affine2>,
    depth: usize,
}

impl Smooth {
    /// With cells for terms up to `depth`, at most [`Lattice::deepest`].
    pub fn new(lattice: Lattice) -> Self {
        let inverses = lattice.maps().iter().map(|map| map.inverse().unwrap_or(Affine2::IDENTITY)).collect();
        Self { depth: lattice.levels().len() - 1, inverses, lattice }
    }

    pub const fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    /// The shuffled terms at each vertex. Displacements that a term takes from elsewhere are those of vertices as well,
    /// since the reversed word is one of the same level: one look at the source for each.
    pub fn fill<S: Source>(&self, source: &S, mesh: &Mesh, terms: &Terms, factors: &[DMat2]) -> Vec<DVec2> {
        self.fill_from(&self.samples(source), S::TURNS, mesh, terms, factors)
    }

    /// What the source is at each vertex.
    pub fn samples<S: Source>(&self, source: &S) -> Vec<DVec2> {
        self.lattice.vertices().iter().map(|&vertex| source.at(vertex)).collect()
    }

    /// [`Smooth::fill`] from what the source is at each vertex; `turns` says whether it has a direction.
    pub fn fill_from(
        &self,
        samples: &[DVec2],
        turns: bool,
        mesh: &Mesh,
        terms: &Terms,
        factors: &[DMat2],
    ) -> Vec<DVec2> {
        let turns = turns && !factors.is_empty();
        let vertices = self.lattice.vertices();
        let mut values = vec![DVec2::ZERO; vertices.len()];
        let count = self.lattice.corners().points().len();
        let slots = self.lattice.slots();
        let mut words = Words::new(terms, if turns { factors } else { &[] });
        for (k, pair) in self.lattice.levels().windows(2).enumerate() {
            let [coarse, fine] = pair else { continue };
            if !slots.is_empty() {
                // What the terms so far come to at the new vertices.
                for (cell, fresh) in
                    coarse.cells.chunks_exact(count).zip(fine.fresh.chunks_exact(slots.len()))
                {
                    for (&vertex, slot) in fresh.iter().zip(slots) {
                        let value = |(&from, share): (&u32, &f64)| values[from as usize] * *share;
                        values[vertex as usize] = cell.iter().zip(&slot.shares).map(value).sum();
                    }
                }
            }
            let k = k + 1;
            // Where the roughness varies, the weights of each family at each vertex.
            let weighed = |family: &Family| -> Vec<f64> {
                if terms.fixed().is_some() || k < family.first || k >= family.end {
                    return Vec::new();
                }
                vertices[..fine.vertices]
                    .iter()
                    .map(|&vertex| terms.weight(family, k, mesh, vertex))
                    .collect()
            };
            let varying: Vec<Vec<f64>> = terms.families.iter().map(weighed).collect();
            let first = terms.families.first().map_or(0, |family| family.kb);
            let shares: [f64; 32] = std::array::from_fn(|shared| 1.0 / shared.max(1) as f64);
            words.advance(k, self.lattice.maps().len(), |family, to, from, turn| {
                let varying = &varying[family.kb - first];
                let weight = terms.fixed().map_or(0.0, |weights| weights.list[family.slot(k)]);
                let (to, from) = (to * count, from * count);
                let pairs = fine.cells[to..to + count].iter().zip(&fine.cells[from..from + count]);
                for (&to, &from) in pairs {
                    let (to, sample) = (to as usize, samples[from as usize]);
                    let sample = if turns { *turn * sample } else { sample };
                    let weight = varying.get(to).copied().unwrap_or(weight);
                    let shared = usize::from(fine.shared[to]);
                    let share = shares.get(shared).copied().unwrap_or_else(|| 1.0 / shared as f64);
                    values[to] += sample * (weight * share);
                }
            });
        }
        values
    }

    /// The vertices around the point of a piece that its map takes `z` to, and what they count.
    pub fn footing(&self, cursor: &Cursor, kept: usize, z: DVec2) -> Footing {
        let corners = self.lattice.corners();
        let letters = cursor.letters();
        let maps = self.inverses.len();
        if letters <= self.depth
            && let Some(corner) = corners.points().iter().position(|&corner| corner == z)
        {
            return Footing::of(self.lattice.cell(letters, cursor.index as usize)[corner]);
        }
        let (mut index, mut rest) =
            (cursor.index as usize, cursor.behind(self.depth, kept, self.lattice.maps(), z));
        for _ in letters..self.depth {
            let inside = |letter: &usize| corners.depth(self.inverses[*letter].apply(rest));
            let letter = (0..maps).max_by(|a, b| inside(a).total_cmp(&inside(b))).unwrap_or(0);
            rest = self.inverses[letter].apply(rest);
            index = index * maps + letter;
        }
        let mut footing = Footing::default();
        for (&vertex, share) in self.lattice.cell(self.depth, index).iter().zip(corners.weights(rest)) {
            footing.add(vertex, share);
        }
        footing
    }
}
