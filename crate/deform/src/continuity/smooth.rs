//! The shuffled terms without a tear, on shapes whose pieces meet in corners.

use frond_core::{Affine2, Dim2};
use glam::{DMat2, DVec2};

use crate::continuity::cells::Cells;
use crate::continuity::corners::Corners;
use crate::continuity::footing::Footing;
use crate::continuity::lattice::Lattice;
use crate::mesh::Mesh;
use crate::shuffle::cursor::Cursor;
use crate::shuffle::level_terms::Source;
use crate::shuffle::terms::Terms;

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
        let slots = self.lattice.slots();
        let shares: Vec<[f64; Corners::MOST_CORNERS]> = slots.iter().map(|slot| slot.shares).collect();
        let cells = Cells {
            levels: self.lattice.levels(),
            corners: self.lattice.corners().points().len(),
            shares: &shares,
            maps: self.lattice.maps().len(),
        };
        let vertices = self.lattice.vertices();
        cells.fill::<Dim2>(samples, if turns { factors } else { &[] }, terms, |family, k, vertex| {
            terms.weight(family, k, mesh, vertices[vertex])
        })
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
