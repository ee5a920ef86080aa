//! The shuffled terms at the corners that cells share, of the plane or of space.

use frond_core::Dimension;

use crate::shuffle::level_terms::Words;
use crate::shuffle::terms::{Family, Terms};

/// The most corners of a cell.
pub(crate) const MOST_CORNERS: usize = 8;

/// The cells of the words of one length.
#[derive(Clone, Debug, Default)]
pub struct Level {
    /// How many vertices there are.
    pub vertices: usize,
    /// For each cell, words in the order of a dictionary, the numbers of its vertices, one after the other.
    pub cells: Vec<u32>,
    /// For each cell of the level before, the numbers of the vertices that are new.
    pub(crate) fresh: Vec<u32>,
    /// How many cells share each vertex.
    pub(crate) shared: Vec<u16>,
}

/// The cells of all levels, and what their corners have to do with those of their parts.
pub(crate) struct Cells<'a> {
    pub levels: &'a [Level],
    /// Corners of a cell.
    pub corners: usize,
    /// For each corner that a cell gets when it is taken apart, what its own corners count there.
    pub shares: &'a [[f64; MOST_CORNERS]],
    /// Parts of a cell.
    pub maps: usize,
}

impl Cells<'_> {
    /// The sum of the shuffled terms (Fujimoto et al., eq 12) at each vertex, from what is shuffled at each vertex:
    /// every term is sampled at the corners of its own cells, averaged over the cells that share a corner, and
    /// interpolated at the corners of smaller ones.
    ///
    /// `factors` are none where nothing turns; `varying` is the weight of a term at a vertex, where it is not the same
    /// all over.
    pub fn fill<D: Dimension>(
        &self,
        samples: &[D::Vector],
        factors: &[D::Matrix],
        terms: &Terms,
        varying: impl Fn(&Family, usize, usize) -> f64,
    ) -> Vec<D::Vector> {
        let (turns, count) = (!factors.is_empty(), self.corners);
        let mut values = vec![D::ZERO; samples.len()];
        let mut words: Words<'_, D> = Words::new(terms, factors);
        for (k, pair) in self.levels.windows(2).enumerate() {
            let [coarse, fine] = pair else { continue };
            if !self.shares.is_empty() {
                // What the terms so far come to at the new vertices.
                let fresh = fine.fresh.chunks_exact(self.shares.len());
                for (cell, fresh) in coarse.cells.chunks_exact(count).zip(fresh) {
                    for (&vertex, shares) in fresh.iter().zip(self.shares) {
                        let value = |(&from, share): (&u32, &f64)| values[from as usize] * *share;
                        values[vertex as usize] =
                            cell.iter().zip(shares).map(value).fold(D::ZERO, |sum, value| sum + value);
                    }
                }
            }
            let k = k + 1;
            // Where the roughness varies, the weights of each family at each vertex.
            let weighed = |family: &Family| -> Vec<f64> {
                if terms.fixed().is_some() || k < family.first || k >= family.end {
                    return Vec::new();
                }
                (0..fine.vertices).map(|vertex| varying(family, k, vertex)).collect()
            };
            let weights: Vec<Vec<f64>> = terms.families.iter().map(weighed).collect();
            let first = terms.families.first().map_or(0, |family| family.kb);
            let shares: [f64; 32] = std::array::from_fn(|shared| 1.0 / shared.max(1) as f64);
            words.advance(k, self.maps, |family, to, from, turn| {
                let weights = &weights[family.kb - first];
                let weight = terms.fixed().map_or(0.0, |weights| weights.list[family.slot(k)]);
                let (to, from) = (to * count, from * count);
                let pairs = fine.cells[to..to + count].iter().zip(&fine.cells[from..from + count]);
                for (&to, &from) in pairs {
                    let (to, sample) = (to as usize, samples[from as usize]);
                    let sample = if turns { *turn * sample } else { sample };
                    let weight = weights.get(to).copied().unwrap_or(weight);
                    let shared = usize::from(fine.shared[to]);
                    let share = shares.get(shared).copied().unwrap_or_else(|| 1.0 / shared as f64);
                    values[to] = values[to] + sample * (weight * share);
                }
            });
        }
        values
    }
}
