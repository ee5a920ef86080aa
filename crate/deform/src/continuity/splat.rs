//! The shuffled terms without a tear, on shapes whose pieces meet anywhere.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::continuity::footing::Footing;
use crate::continuity::grid::Grid;
use crate::mesh::Mesh;
use crate::shuffle::level_terms::{Source, Words};
use crate::shuffle::terms::{Terms, deepest_level};

/// A superposed displacement (Fujimoto et al., eq 12) that is a smooth function of the plane, for tilings and other
/// shapes without corners to share: every term is spread from the middles of its own cells over a grid about as fine
/// as they are, and read off between the nodes; it and its slope are continuous.
///
/// What no cell reaches takes the value of the nodes around it, so that the field goes on beyond the shape.
#[derive(Clone, Debug)]
pub(crate) struct Splat {
    maps: Vec<Affine2>,
    /// The middle of each word of each level.
    middles: Vec<Vec<DVec2>>,
    /// The coarsest grid, and how often it is halved.
    coarsest: Grid,
    halvings: usize,
    finest: Grid,
    /// What each level is spread over, from the first that is shuffled at all.
    layers: Vec<Option<Layer>>,
}

/// How one level lies on its grid; families whose terms it belongs to have it in common.
#[derive(Clone, Debug)]
struct Layer {
    grid: Grid,
    halvings: usize,
    /// 1 over the sum of the shares of all middles at each node, 0 where none reaches.
    scale: Vec<f64>,
    /// The nodes that none reaches, from the shape outward, in rings.
    holes: Vec<Vec<usize>>,
}

/// The most squares along a side of the finest grid.
const FINEST_GRID: f64 = 512.0;
/// The most nodes for each cell: a shape that is almost nothing needs no more.
const MOST_NODES: f64 = 256.0;
/// The most cells of a level.
const MOST_CELLS: usize = 1 << 18;

impl Splat {
    /// The deepest level that a shape of so many maps may have.
    pub fn deepest(maps: usize) -> usize {
        deepest_level(maps, MOST_CELLS)
    }

    /// Over the box from `low` to `high`, which holds the shape; `middle` is a point amid it.
    pub fn new(maps: &[Affine2], terms: &Terms, middle: DVec2, (low, high): (DVec2, DVec2)) -> Self {
        // A flat or empty box has a size all the same.
        let size = (high - low).max(DVec2::splat(1e-9 * (high - low).max_element().max(1e-300)));
        let (low, size) = (low - 0.05 * size, 1.1 * size);
        let coarsest = Grid::new(low, size, 0.5 * size.max_element());
        let mut middles = vec![vec![middle]];
        let mut cells = vec![Affine2::IDENTITY];
        let mut layers = vec![None];
        let mut halvings = 0;
        for k in 1..=terms.depth() {
            cells = cells.iter().flat_map(|cell| maps.iter().map(move |map| *cell * *map)).collect();
            let here: Vec<DVec2> = cells.iter().map(|cell| cell.apply(middle)).collect();
            let used = terms.families.iter().any(|family| (family.first..family.end).contains(&k));
            layers.push(used.then(|| {
                let layer = Layer::new(coarsest, low, size, &here);
                halvings = halvings.max(layer.halvings);
                layer
            }));
            middles.push(here);
        }
        let finest = (0..halvings).fold(coarsest, |grid, _| grid.halved());
        Self { maps: maps.to_vec(), middles, coarsest, halvings, finest, layers }
    }

    /// The shuffled terms at each node of the finest grid.
    pub fn fill<S: Source>(&self, source: &S, mesh: &Mesh, terms: &Terms, factors: &[DMat2]) -> Vec<DVec2> {
        let mut sums: Vec<Vec<DVec2>> = vec![Vec::new(); self.halvings + 1];
        let mut words: Words<'_> = Words::new(terms, if S::TURNS { factors } else { &[] });
        for (k, (middles, layer)) in self.middles.iter().zip(&self.layers).enumerate().skip(1) {
            let Some(layer) = layer else {
                words.advance(k, self.maps.len(), |_, _, _, _| ());
                continue;
            };
            let samples: Vec<DVec2> = middles.iter().map(|&middle| source.at(middle)).collect();
            let mut terms_here = vec![DVec2::ZERO; middles.len()];
            words.advance(k, self.maps.len(), |family, to, from, turn| {
                let weight = terms.weight(family, k, mesh, middles[to]);
                let sample = samples[from] * weight;
                terms_here[to] += if S::TURNS && !factors.is_empty() { *turn * sample } else { sample };
            });
            let sum = &mut sums[layer.halvings];
            sum.resize(layer.grid.nodes(), DVec2::ZERO);
            layer.spread(middles, &terms_here, sum);
        }
        let mut grid = self.coarsest;
        let mut values = vec![DVec2::ZERO; grid.nodes()];
        for (i, sum) in sums.iter().enumerate() {
            if i > 0 {
                values = grid.refine(&values);
                grid = grid.halved();
            }
            values.iter_mut().zip(sum).for_each(|(value, sum)| *value += *sum);
        }
        values
    }

    /// The nodes around a point of the plane, and what they count.
    pub fn footing(&self, point: DVec2) -> Footing {
        self.finest.footing(point)
    }
}

impl Layer {
    /// On a grid about as fine as cells with these middles are large: they tell how much of the box the shape fills.
    fn new(coarsest: Grid, low: DVec2, size: DVec2, middles: &[DVec2]) -> Self {
        let count = middles.len() as f64;
        let looked_at = Grid::new(low, size, 2.0 * (size.x * size.y / count).sqrt());
        let mut filled = vec![false; looked_at.nodes()];
        for &middle in middles {
            looked_at.footing(middle).iter().for_each(|(node, share)| filled[node] |= share >= 0.2);
        }
        let share = filled.iter().filter(|filled| **filled).count() as f64 / filled.len() as f64;
        let area = size.x * size.y / count;
        let wanted = (0.9 * (area * share).sqrt())
            .max((area / MOST_NODES).sqrt())
            .max(size.max_element() / FINEST_GRID);
        let (mut grid, mut halvings) = (coarsest, 0);
        while grid.spacing() > 1.4 * wanted {
            grid = grid.halved();
            halvings += 1;
        }
        let mut scale = vec![0.0; grid.nodes()];
        for &middle in middles {
            grid.footing(middle).iter().for_each(|(node, share)| scale[node] += share);
        }
        scale.iter_mut().for_each(|sum| *sum = if *sum > 1e-9 { 1.0 / *sum } else { 0.0 });
        let holes = holes(&grid, &scale);
        Self { grid, halvings, scale, holes }
    }

    /// Adds to each node the mean of the values near it.
    fn spread(&self, middles: &[DVec2], values: &[DVec2], sum: &mut [DVec2]) {
        let mut means = vec![DVec2::ZERO; self.scale.len()];
        for (&middle, value) in middles.iter().zip(values) {
            self.grid.footing(middle).iter().for_each(|(node, share)| means[node] += *value * share);
        }
        means.iter_mut().zip(&self.scale).for_each(|(mean, scale)| *mean *= *scale);
        let mut known: Vec<bool> = self.scale.iter().map(|scale| *scale > 0.0).collect();
        for ring in &self.holes {
            for &node in ring {
                let near = self.grid.neighbours(node).filter(|&other| known[other]);
                let (total, count) =
                    near.fold((DVec2::ZERO, 0.0), |(sum, n), other| (sum + means[other], n + 1.0));
                means[node] = total / count;
            }
            ring.iter().for_each(|&node| known[node] = true);
        }
        sum.iter_mut().zip(&means).for_each(|(sum, mean)| *sum += *mean);
    }
}

/// The nodes that nothing reaches, ring by ring.
fn holes(grid: &Grid, scale: &[f64]) -> Vec<Vec<usize>> {
    let mut known: Vec<bool> = scale.iter().map(|scale| *scale > 0.0).collect();
    let mut front: Vec<usize> = (0..known.len())
        .filter(|&node| !known[node] && grid.neighbours(node).any(|other| known[other]))
        .collect();
    let mut rings = Vec::new();
    while !front.is_empty() {
        front.iter().for_each(|&node| known[node] = true);
        let mut next: Vec<usize> =
            front.iter().flat_map(|&node| grid.neighbours(node)).filter(|&node| !known[node]).collect();
        next.sort_unstable();
        next.dedup();
        rings.push(std::mem::replace(&mut front, next));
    }
    rings
}
