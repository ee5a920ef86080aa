//! The shuffled attribute without a tear, on shapes whose pieces meet anywhere.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::smooth::{Attribute, Depths};
use crate::spin::Spin;
use crate::weight::weights;

/// A superposed attribute (Fujimoto et al., eq 12) that is a continuous function of the plane, for tilings and other
/// shapes without corners to share: every term is spread from the middles of its own cells over a grid about as fine
/// as they are, and read off between the nodes.
///
/// What no cell reaches takes the value of the nodes around it, so that the field goes on beyond the shape.
#[derive(Clone, Debug)]
pub struct Splat<'a, A> {
    attribute: &'a A,
    /// The weight of what is not shuffled.
    plain: f64,
    grids: Vec<Grid>,
}

/// The values of one term at the nodes of a grid.
#[derive(Clone, Debug)]
struct Grid {
    low: DVec2,
    step: DVec2,
    columns: usize,
    rows: usize,
    values: Vec<f64>,
}

/// The most nodes along a side.
const FINEST: usize = 512;
/// The most cells of a level; deeper levels are sampled at as many of their words.
const MOST_CELLS: usize = 1 << 18;

/// Of a word behind the head: its map, that of its reversal, and what turns the displacement.
type Tail = (Affine2, Affine2, DMat2);

impl<'a, A: Attribute> Splat<'a, A> {
    /// Spreads all terms over the box from `low` to `high`, which holds the shape, from the middle (a point of the
    /// plane) of each cell. Levels of more cells than there is room for end the sum: `ke` is taken down to them.
    #[must_use]
    pub fn new(
        maps: &[Affine2],
        attribute: &'a A,
        depths: Depths,
        middle: DVec2,
        (low, high): (DVec2, DVec2),
    ) -> Self {
        let deepest = if maps.len() < 2 { 32 } else { (MOST_CELLS as f64).log(maps.len() as f64) as usize };
        let ke = depths.ke.min(deepest);
        let kb = depths.kb.min(ke);
        let weights = weights(depths.delta, kb, ke);
        let exact = if depths.spin == Spin::None { 2 } else { 1 };
        let factors: Vec<DMat2> = maps.iter().map(|map| depths.spin.factor(map)).collect();
        let heads = words(maps, kb);
        let mut tails: Vec<Tail> = vec![(Affine2::IDENTITY, Affine2::IDENTITY, DMat2::IDENTITY)];
        let mut grids = Vec::new();
        for k in kb + 1..=ke {
            tails = tails
                .iter()
                .flat_map(|(there, back, factor)| {
                    maps.iter()
                        .zip(&factors)
                        .map(move |(map, turn)| (*there * *map, *map * *back, *factor * *turn))
                })
                .collect();
            if k >= kb + exact && weights[k - kb] > 0.0 {
                let cells = heads.iter().flat_map(|head| tails.iter().map(move |tail| (head, tail)));
                let at = |(head, (there, ..)): (&Affine2, &Tail)| head.apply(there.apply(middle));
                let mut grid = Grid::for_cells(low, high, cells.clone().map(at), attribute.width());
                for (head, tail) in cells {
                    let (_, back, factor) = tail;
                    let from = head.apply(back.apply(middle));
                    grid.spread(at((head, tail)), |sum, share| attribute.add(from, *factor, share, sum));
                }
                grids.push(grid.settled(attribute.width(), weights[k - kb]));
            }
        }
        Self { attribute, plain: weights.iter().take(exact).sum(), grids }
    }

    /// The attribute at a point of the plane.
    #[must_use]
    pub fn at(&self, point: DVec2) -> Vec<f64> {
        let mut sum = vec![0.0; self.attribute.width()];
        for grid in &self.grids {
            grid.nodes(point, |node, share| {
                let values = &grid.values[node * sum.len()..];
                sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += share * value);
            });
        }
        self.attribute.add(point, DMat2::IDENTITY, self.plain, &mut sum);
        sum
    }
}

impl Grid {
    /// A grid about as fine as cells with these middles are large: they tell how much of the box the shape fills.
    fn for_cells(
        low: DVec2,
        high: DVec2,
        middles: impl Iterator<Item = DVec2> + Clone,
        width: usize,
    ) -> Self {
        // A flat or empty box has a size all the same.
        let size = (high - low).max(DVec2::splat(1e-9 * (high - low).max_element().max(1e-300)));
        let count = middles.clone().count() as f64;
        let coarse = Self::new(low, size, 2.0 * (size.x * size.y / count).sqrt(), 0);
        let mut filled = vec![false; coarse.columns * coarse.rows];
        for middle in middles {
            coarse.nodes(middle, |node, share| filled[node] |= share >= 0.25);
        }
        let share = filled.iter().filter(|filled| **filled).count() as f64 / filled.len() as f64;
        Self::new(low, size, 0.9 * (size.x * size.y * share / count).sqrt(), width)
    }

    /// Zeros, with one number more at each node for the sum of the shares.
    fn new(low: DVec2, size: DVec2, spacing: f64, width: usize) -> Self {
        let side = |length: f64| ((length / spacing).ceil() as usize).clamp(1, FINEST) + 1;
        let (columns, rows) = (side(size.x), side(size.y));
        let step = size / DVec2::new((columns - 1) as f64, (rows - 1) as f64);
        Self { low, step, columns, rows, values: vec![0.0; columns * rows * (width + 1)] }
    }

    /// The four nodes around a point, and how near each is; shares sum to 1.
    fn nodes(&self, point: DVec2, mut visit: impl FnMut(usize, f64)) {
        let last = DVec2::new((self.columns - 1) as f64, (self.rows - 1) as f64);
        let place = ((point - self.low) / self.step).max(DVec2::ZERO).min(last);
        let cell = place.floor().min(last - DVec2::ONE);
        let part = place - cell;
        let (x, y) = (cell.x as usize, cell.y as usize);
        for (dx, wx) in [(0, 1.0 - part.x), (1, part.x)] {
            for (dy, wy) in [(0, 1.0 - part.y), (1, part.y)] {
                visit((y + dy) * self.columns + x + dx, wx * wy);
            }
        }
    }

    /// Adds a value at a point to the nodes around it.
    fn spread(&mut self, point: DVec2, add: impl Fn(&mut [f64], f64)) {
        let mut shares = [(0, 0.0); 4];
        let mut slot = shares.iter_mut();
        self.nodes(point, |node, share| {
            if let Some(slot) = slot.next() {
                *slot = (node, share);
            }
        });
        let width = self.values.len() / (self.columns * self.rows);
        for (node, share) in shares.into_iter().filter(|(_, share)| *share > 0.0) {
            if let Some((last, sum)) = self.values[node * width..(node + 1) * width].split_last_mut() {
                add(sum, share);
                *last += share;
            }
        }
    }

    /// Means instead of sums, times a weight; nodes that nothing reached take the mean of their neighbours, from the
    /// shape outward.
    fn settled(mut self, width: usize, weight: f64) -> Self {
        let nodes = self.columns * self.rows;
        let mut values = vec![0.0; nodes * width];
        let mut known = vec![false; nodes];
        for node in 0..nodes {
            let [sum @ .., share] = &self.values[node * (width + 1)..(node + 1) * (width + 1)] else {
                continue;
            };
            if *share > 1e-9 {
                known[node] = true;
                let mean = sum.iter().map(|x| x * weight / share);
                values[node * width..].iter_mut().zip(mean).for_each(|(slot, x)| *slot = x);
            }
        }
        let mut front: Vec<usize> =
            (0..nodes).filter(|&node| !known[node] && self.touches(node, &known)).collect();
        while !front.is_empty() {
            for &node in &front {
                let near: Vec<usize> = self.neighbours(node).filter(|&other| known[other]).collect();
                for i in 0..width {
                    let sum: f64 = near.iter().map(|other| values[other * width + i]).sum();
                    values[node * width + i] = sum / near.len() as f64;
                }
            }
            front.iter().for_each(|&node| known[node] = true);
            let mut next: Vec<usize> =
                front.iter().flat_map(|&node| self.neighbours(node)).filter(|&n| !known[n]).collect();
            next.sort_unstable();
            next.dedup();
            front = next;
        }
        self.values = values;
        self
    }

    fn touches(&self, node: usize, known: &[bool]) -> bool {
        self.neighbours(node).any(|other| known[other])
    }

    fn neighbours(&self, node: usize) -> impl Iterator<Item = usize> + use<> {
        let (x, y, columns, rows) = (node % self.columns, node / self.columns, self.columns, self.rows);
        let sides = [
            (x > 0).then(|| node - 1),
            (x + 1 < columns).then_some(node + 1),
            (y > 0).then(|| node - columns),
            (y + 1 < rows).then_some(node + columns),
        ];
        sides.into_iter().flatten()
    }
}

/// The maps of all words of so many letters, in the order of a dictionary.
pub(crate) fn words(maps: &[Affine2], letters: usize) -> Vec<Affine2> {
    (0..letters).fold(vec![Affine2::IDENTITY], |words, _| {
        words.iter().flat_map(|word| maps.iter().map(move |map| *word * *map)).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Field, Mesh, Place};

    fn twindragon() -> [Affine2; 2] {
        [[0.5, 0.5, -0.5, 0.5, -0.5, 0.375], [0.5, 0.5, -0.5, 0.5, 0.5, 0.625]].map(Affine2::from_row)
    }

    fn mesh() -> Mesh {
        let list =
            (0..16).map(|i| DVec2::new(f64::from(i * 7 % 16) - 8.0, f64::from(i * 5 % 16) - 8.0) / 40.0);
        Mesh::new(DVec2::splat(-2.0), DVec2::splat(3.0), 4, 4, list.collect()).unwrap()
    }

    const BOX: (DVec2, DVec2) = (DVec2::new(-0.8, -0.8), DVec2::new(1.8, 1.8));
    const MIDDLE: DVec2 = DVec2::splat(0.5);

    fn splat(mesh: &Mesh, kb: usize, ke: usize, spin: Spin) -> Splat<'_, Mesh> {
        Splat::new(&twindragon(), mesh, Depths { kb, ke, delta: 0.7, spin }, MIDDLE, BOX)
    }

    #[test]
    fn it_nowhere_jumps() {
        let mesh = mesh();
        for (kb, spin) in [(0, Spin::None), (2, Spin::Rotation), (8, Spin::None)] {
            let splat = splat(&mesh, kb, 8, spin);
            let at = |t: f64| DVec2::from_slice(&splat.at(DVec2::new(-1.0 + 3.0 * t, 2.0 - 2.7 * t)));
            let mut last = at(0.0);
            for i in 1..=20_000 {
                let next = at(f64::from(i) / 20_000.0);
                assert!((next - last).length() < 2e-3, "{kb} {i}: {}", (next - last).length());
                last = next;
            }
        }
    }

    #[test]
    fn it_goes_where_the_formula_goes() {
        // Smoothed, so not the same; but the two depart from the plain deformation alike.
        let (maps, mesh) = (twindragon(), mesh());
        let field = Field::new(&maps, &mesh, Spin::None);
        let splat = splat(&mesh, 0, 6, Spin::None);
        let (mut both, mut ours, mut theirs) = (0.0, 0.0, 0.0);
        for i in 0..64_u8 {
            let code: Vec<u8> = (0..6).map(|k| i >> k & 1).collect();
            let place = Place { code: &code, tail: MIDDLE };
            let plain = mesh.at(field.position(place));
            let wanted = field.superposed(0, 6, 0.7, place) - plain;
            let found = DVec2::from_slice(&splat.at(field.position(place))) - plain;
            both += found.dot(wanted);
            ours += found.length_squared();
            theirs += wanted.length_squared();
        }
        let (likeness, size) = (both / (ours * theirs).sqrt(), (ours / theirs).sqrt());
        assert!(likeness > 0.8 && size > 0.5 && size < 1.5, "{likeness} {size}");
    }

    #[test]
    fn without_a_block_it_is_the_plain_deformation() {
        let mesh = mesh();
        let splat = splat(&mesh, 5, 5, Spin::None);
        for p in [DVec2::ZERO, DVec2::new(1.2, 0.3), DVec2::splat(9.0)] {
            assert_eq!(DVec2::from_slice(&splat.at(p)), mesh.at(p));
        }
    }

    #[test]
    fn shapes_of_no_size_and_endless_depths_do_no_harm() {
        let mesh = mesh();
        let one = [Affine2::similitude(0.5, 0.0, DVec2::ZERO)];
        let depths = Depths { kb: 0, ke: usize::MAX, delta: 1.0, spin: Spin::Scaled };
        let splat = Splat::new(&one, &mesh, depths, DVec2::ZERO, (DVec2::ZERO, DVec2::ZERO));
        assert!(splat.at(DVec2::ZERO).iter().all(|x| x.is_finite()));
        let splat =
            Splat::new(&[], &mesh, Depths { ke: 3, ..depths }, DVec2::ZERO, (DVec2::ZERO, DVec2::ONE));
        assert!(splat.at(DVec2::ONE).iter().all(|x| x.is_finite()));
    }
}
