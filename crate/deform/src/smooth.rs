//! The shuffled attribute without a tear, on shapes whose pieces meet in corners.

use glam::{DMat2, DVec2};

use crate::field::Place;
use crate::lattice::Lattice;
use crate::mesh::Mesh;
use crate::spin::Spin;
use crate::splat::words;
use crate::weight::weights;

/// What is given to the points of a shape and shuffled (Fujimoto et al., eq 8): some numbers for each.
pub trait Attribute {
    /// How many numbers.
    fn width(&self) -> usize;
    /// Adds `weight` times the attribute at `point`, turned by `factor` where it has a direction, to `sum`.
    fn add(&self, point: DVec2, factor: DMat2, weight: f64, sum: &mut [f64]);
}

/// The displacement: two numbers.
impl Attribute for Mesh {
    fn width(&self) -> usize {
        2
    }

    fn add(&self, point: DVec2, factor: DMat2, weight: f64, sum: &mut [f64]) {
        let v = factor * self.at(point) * weight;
        sum[0] += v.x;
        sum[1] += v.y;
    }
}

/// How far and how roughly an attribute is shuffled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depths {
    /// Letters that stay: the locality.
    pub kb: usize,
    /// The last letter that moves: the detail.
    pub ke: usize,
    /// What each further letter counts: the roughness.
    pub delta: f64,
    /// How directions follow the pieces.
    pub spin: Spin,
}

/// A superposed attribute (Fujimoto et al., eq 12) that is continuous over the shape.
///
/// The paper averages each region that the shuffle leaves whole and interpolates the averages over a Delaunay
/// triangulation. Here every term is sampled at the corners of its own cells, averaged over the cells that share
/// a corner, and interpolated inside: neighbours agree on what they share, so nothing tears. The terms kb and
/// kb + 1, which are no shuffle at all, stay exact where nothing turns.
#[derive(Clone, Debug)]
pub struct Smooth<'a, A> {
    lattice: &'a Lattice,
    attribute: &'a A,
    depths: Depths,
    /// The weight of what is not shuffled.
    plain: f64,
    /// The shuffled terms at the vertices of the level `ke`.
    values: Vec<f64>,
}

impl<'a, A: Attribute> Smooth<'a, A> {
    /// Samples all terms. `ke` is taken down to the depth of the lattice.
    #[must_use]
    pub fn new(lattice: &'a Lattice, attribute: &'a A, depths: Depths) -> Self {
        let ke = depths.ke.min(lattice.levels().len() - 1);
        let kb = depths.kb.min(ke);
        let depths = Depths { kb, ke, ..depths };
        let weights = weights(depths.delta, kb, ke);
        // Turned displacements jump between pieces from the first shuffled letter on.
        let exact = if depths.spin == Spin::None { 2 } else { 1 };
        let plain = weights.iter().take(exact).sum();
        let mut this = Self { lattice, attribute, depths, plain, values: Vec::new() };
        let mut rests = this.rests();
        this.values = vec![0.0; lattice.levels()[0].vertices.len() * attribute.width()];
        for k in 1..=ke {
            this.values = this.refined(k);
            if k > kb {
                this.advance(&mut rests);
            }
            if k >= kb + exact {
                this.add_term(&rests, k, weights[k - kb]);
            }
        }
        this
    }

    /// The corners, before any letter is shuffled.
    fn rests(&self) -> Vec<Rest> {
        self.lattice.corners().points().iter().map(|&point| Rest { point, factor: DMat2::IDENTITY }).collect()
    }

    /// One letter more: `z_k = w_ak(z_(k-1))` for every word behind the head, so that all terms of all cells together
    /// cost little more than the cells of the finest level.
    fn advance(&self, rests: &mut Vec<Rest>) {
        let count = self.lattice.corners().points().len();
        let maps = self.lattice.maps();
        let factors: Vec<DMat2> = maps.iter().map(|map| self.depths.spin.factor(map)).collect();
        *rests = rests
            .chunks_exact(count)
            .flat_map(|word| {
                maps.iter().zip(&factors).flat_map(move |(map, factor)| {
                    word.iter()
                        .map(move |rest| Rest { point: map.apply(rest.point), factor: rest.factor * *factor })
                })
            })
            .collect();
    }

    /// Adds a term, sampled at the corners of the cells of level `k` and averaged where they share them.
    fn add_term(&mut self, rests: &[Rest], k: usize, weight: f64) {
        let level = &self.lattice.levels()[k];
        let count = self.lattice.corners().points().len();
        let width = self.attribute.width();
        let mut shared = vec![0_u32; level.vertices.len()];
        for cell in &level.cells {
            cell[..count].iter().for_each(|&vertex| shared[vertex as usize] += 1);
        }
        let tails = rests.len() / count;
        let heads = words(self.lattice.maps(), self.depths.kb);
        for (index, cell) in level.cells.iter().enumerate() {
            let (head, tail) = (index / tails, index % tails);
            for (rest, &vertex) in rests[tail * count..].iter().zip(&cell[..count]) {
                let share = weight / f64::from(shared[vertex as usize]);
                let sum = &mut self.values[vertex as usize * width..][..width];
                self.attribute.add(heads[head].apply(rest.point), rest.factor, share, sum);
            }
        }
    }

    /// The values so far at the vertices of level `k`, from those of the level before.
    fn refined(&self, k: usize) -> Vec<f64> {
        let (coarse, fine) = (&self.lattice.levels()[k - 1], &self.lattice.levels()[k]);
        let (maps, corners) = (self.lattice.maps(), self.lattice.corners());
        let (count, width) = (corners.points().len(), self.attribute.width());
        let shares: Vec<[f64; 4]> = maps
            .iter()
            .flat_map(|map| corners.points().iter().map(|&point| corners.weights(map.apply(point))))
            .collect();
        let mut values = vec![0.0; fine.vertices.len() * width];
        for (index, cell) in fine.cells.iter().enumerate() {
            let parent = &coarse.cells[index / maps.len()];
            for (corner, &vertex) in cell[..count].iter().enumerate() {
                let share = &shares[index % maps.len() * count + corner];
                for i in 0..width {
                    let value = |(&from, share): (&u32, &f64)| self.values[from as usize * width + i] * share;
                    values[vertex as usize * width + i] = parent[..count].iter().zip(share).map(value).sum();
                }
            }
        }
        values
    }

    /// The attribute at a place, whose code has at least ke letters; those that are missing are taken to be 0.
    #[must_use]
    pub fn at(&self, place: Place<'_>) -> Vec<f64> {
        let maps = self.lattice.maps();
        let letter = |i: usize| place.code.get(i).map_or(0, |&letter| usize::from(letter) % maps.len());
        let cell = (0..self.depths.ke).fold(0, |cell, i| cell * maps.len() + letter(i));
        let last = self.depths.ke.max(place.code.len());
        let rest = (self.depths.ke..last).rev().fold(place.tail, |point, i| maps[letter(i)].apply(point));
        let whole = (0..self.depths.ke).rev().fold(rest, |point, i| maps[letter(i)].apply(point));
        let count = self.lattice.corners().points().len();
        let width = self.attribute.width();
        let mut sum = vec![0.0; width];
        let vertices = &self.lattice.levels()[self.depths.ke].cells[cell][..count];
        for (&vertex, share) in vertices.iter().zip(self.lattice.corners().weights(rest)) {
            for (sum, value) in sum.iter_mut().zip(&self.values[vertex as usize * width..]) {
                *sum += share * value;
            }
        }
        self.attribute.add(whole, DMat2::IDENTITY, self.plain, &mut sum);
        sum
    }

    /// The attribute at every vertex of the finest level, vertex by vertex.
    #[must_use]
    pub fn at_vertices(&self) -> Vec<f64> {
        let mut values = self.values.clone();
        let vertices = &self.lattice.levels()[self.depths.ke].vertices;
        for (&point, sum) in vertices.iter().zip(values.chunks_exact_mut(self.attribute.width())) {
            self.attribute.add(point, DMat2::IDENTITY, self.plain, sum);
        }
        values
    }
}

/// A corner after the shuffled letters, before those of the head.
#[derive(Clone, Copy, Debug)]
struct Rest {
    point: DVec2,
    factor: DMat2,
}

#[cfg(test)]
mod tests {
    use frond_core::Affine2;
    use proptest::prelude::*;

    use super::*;
    use crate::corners::Corners;

    fn gasket() -> Vec<Affine2> {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.3, 0.8)];
        corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5)).to_vec()
    }

    fn square(parts: u32) -> Vec<Affine2> {
        let (s, n) = (1.0 / f64::from(parts), f64::from(parts));
        (0..parts * parts)
            .map(|i| Affine2::similitude(s, 0.0, DVec2::new(f64::from(i % parts), f64::from(i / parts)) / n))
            .collect()
    }

    /// The gasket again, but its first piece is mirrored, so that displacements are, too.
    fn mirrored() -> Vec<Affine2> {
        let mut maps: Vec<Affine2> = [DVec2::ZERO, DVec2::X, DVec2::new(0.5, 0.75_f64.sqrt())]
            .map(|c| Affine2::similitude(0.5, 0.0, c * 0.5))
            .to_vec();
        let axis = DMat2::from_angle(std::f64::consts::FRAC_PI_6);
        let mirror = axis * DMat2::from_diagonal(DVec2::new(1.0, -1.0)) * axis.transpose();
        maps[0].linear *= mirror;
        maps
    }

    fn bumpy() -> Mesh {
        let list =
            (0..16).map(|i| DVec2::new(f64::from(i * 7 % 16) - 8.0, f64::from(i * 5 % 16) - 8.0) / 20.0);
        Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, list.collect()).unwrap()
    }

    /// The pieces that hold a point, by the letters of one that does, and the point of the whole that each takes there.
    fn all_places(maps: &[Affine2], point: DVec2, letters: usize) -> Vec<(Vec<u8>, DVec2)> {
        let corners = Corners::find(maps).unwrap();
        let mut places = vec![(Vec::new(), point)];
        for _ in 0..letters {
            places = places
                .into_iter()
                .flat_map(|(code, rest)| {
                    let inside = |(i, map): (usize, &Affine2)| {
                        let rest = map.inverse().unwrap().apply(rest);
                        let held = corners.weights(rest).iter().all(|w| (-1e-9..=1.0 + 1e-9).contains(w));
                        let longer = [&code[..], &[i as u8]].concat();
                        held.then_some((longer, rest))
                    };
                    maps.iter().enumerate().filter_map(inside).collect::<Vec<_>>()
                })
                .collect();
        }
        places
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]

        #[test]
        fn pieces_agree_on_what_they_share(
            shape in 0..4_usize, kb in 0..4_usize, more in 0..4_usize, delta in 0.0..1.5_f64, turned: bool,
            vertex in 0..10_000_usize, along in 0.0..1.0_f64,
        ) {
            let maps = [gasket(), square(2), square(3), mirrored()][shape].clone();
            let spin = if turned { Spin::Orthogonal } else { Spin::None };
            let lattice = Lattice::new(&maps, Corners::find(&maps).unwrap(), kb + more);
            let mesh = bumpy();
            let smooth = Smooth::new(&lattice, &mesh, Depths { kb, ke: kb + more, delta, spin });
            // A point on a side of a small cell: two or more pieces hold it where sides are shared.
            let level = lattice.levels().last().unwrap();
            let cell = level.cells[vertex % level.cells.len()];
            let (a, b) = (level.vertices[cell[0] as usize], level.vertices[cell[1] as usize]);
            for point in [a, a.lerp(b, along)] {
                let places = all_places(&maps, point, kb + more);
                prop_assert!(!places.is_empty());
                let values: Vec<Vec<f64>> =
                    places.iter().map(|(code, tail)| smooth.at(Place { code, tail: *tail })).collect();
                for value in &values {
                    let same = value.iter().zip(&values[0]).all(|(x, y)| (x - y).abs() < 1e-9);
                    prop_assert!(same, "{:?} of {:?}", values, places);
                }
            }
        }
    }

    #[test]
    fn where_nothing_is_shared_it_is_the_formula() {
        let (maps, mesh) = (mirrored(), bumpy());
        let corners = Corners::find(&maps).unwrap();
        let lattice = Lattice::new(&maps, corners.clone(), 4);
        for (i, &corner) in corners.points().iter().enumerate() {
            let code = vec![i as u8; 4];
            let place = Place { code: &code, tail: corner };
            for (kb, spin) in
                [(0, Spin::None), (0, Spin::Orthogonal), (2, Spin::Scaled), (3, Spin::Orthogonal)]
            {
                let smooth = Smooth::new(&lattice, &mesh, Depths { kb, ke: 4, delta: 0.8, spin });
                let wanted = crate::Field::new(&maps, &mesh, spin).superposed(kb, 4, 0.8, place);
                assert!(
                    (DVec2::from_slice(&smooth.at(place)) - wanted).length() < 1e-12,
                    "{i} {kb} {spin:?}"
                );
            }
        }
    }

    #[test]
    fn without_a_block_it_is_the_plain_deformation() {
        let (maps, mesh) = (gasket(), bumpy());
        let lattice = Lattice::new(&maps, Corners::find(&maps).unwrap(), 5);
        let smooth = Smooth::new(&lattice, &mesh, Depths { kb: 5, ke: 5, delta: 0.75, spin: Spin::None });
        let values = smooth.at_vertices();
        for (value, &point) in values.chunks_exact(2).zip(&lattice.levels()[5].vertices) {
            assert!((DVec2::from_slice(value) - mesh.at(point)).length() < 1e-12);
        }
    }

    #[test]
    fn depths_beyond_the_lattice_are_taken_down() {
        let (maps, mesh) = (gasket(), bumpy());
        let lattice = Lattice::new(&maps, Corners::find(&maps).unwrap(), 2);
        let smooth =
            Smooth::new(&lattice, &mesh, Depths { kb: 90, ke: 80, delta: f64::NAN, spin: Spin::Scaled });
        assert!(smooth.at(Place { code: &[], tail: DVec2::ZERO }).iter().all(|x| x.is_finite()));
    }
}
