//! The corners of all cells of space, level by level.

use std::collections::HashMap;
use std::hash::BuildHasherDefault;

use frond_core::Affine3;
use glam::DVec3;

use crate::continuity::cells::{Cells, Level, MOST_CORNERS};
use crate::continuity::corners3::Corners3;
use crate::continuity::lattice::Mix;
use crate::shuffle::terms::deepest_level;

/// The cells of a shape that has [`Corners3`], and the corners that they share, for the words of 0, 1, 2, .. letters:
/// what [`Lattice`](crate::Lattice) is in the plane.
///
/// A corner of a cell is a corner of one of its parts, too, and keeps its number.
#[derive(Clone, Debug)]
pub(crate) struct Lattice3 {
    pub maps: Vec<Affine3>,
    pub corners: Corners3,
    pub vertices: Vec<DVec3>,
    pub levels: Vec<Level>,
    /// For each corner that a cell gets when it is taken apart, what its own corners count there.
    shares: Vec<[f64; MOST_CORNERS]>,
    /// Whether such a corner may be one of another cell as well.
    shared: Vec<bool>,
    /// For each corner of each part, the corner of the cell or, beyond these, the new one that it is.
    parts: Vec<usize>,
}

/// The most cells of the finest level.
const MOST_CELLS: usize = 1 << 18;
/// Places along an axis of the finest grid.
const MOST_PLACES: u32 = 1 << 16;

impl Lattice3 {
    /// The deepest level for these maps.
    pub fn deepest(maps: usize, corners: &Corners3) -> usize {
        let places = corners.grid().map_or(1, |counts| counts.into_iter().max().unwrap_or(1));
        let fits = |depth: &u32| places.checked_pow(*depth).is_some_and(|places| places < MOST_PLACES);
        let by_places = (1..=32).take_while(fits).last().unwrap_or(0);
        deepest_level(maps, MOST_CELLS).min(by_places as usize)
    }

    /// The cells of up to `depth` letters, or of as many as [`Lattice3::deepest`] allows.
    pub fn new(maps: &[Affine3], corners: Corners3, depth: usize) -> Self {
        let depth = depth.min(Self::deepest(maps.len(), &corners));
        let points = corners.points().to_vec();
        let count = points.len();
        let near = 1e-7 * points[0].distance(points[1]);
        let mut known = points.clone();
        let mut parts = Vec::with_capacity(maps.len() * count);
        for point in maps.iter().flat_map(|map| points.iter().map(|&corner| map.apply(corner))) {
            let found = known.iter().position(|other| other.distance(point) <= near);
            parts.push(found.unwrap_or(known.len()));
            if found.is_none() {
                known.push(point);
            }
        }
        let fresh = &known[count..];
        let shares = fresh.iter().map(|&point| corners.weights(point)).collect();
        let meets = |&point: &DVec3| corners.grid().is_some() && corners.on_surface(corners.place(point));
        let shared = fresh.iter().map(meets).collect();
        let first = Level {
            vertices: count,
            cells: (0..count as u32).collect(),
            fresh: Vec::new(),
            shared: vec![1; count],
        };
        let maps = maps.to_vec();
        let mut this = Self { maps, corners, vertices: points, levels: vec![first], shares, shared, parts };
        (0..depth).for_each(|_| this.refine());
        this
    }

    /// Adds a level. Cells of a grid meet at places that are whole numbers, which is how shared corners are found;
    /// tetrahedra share none of their new ones.
    fn refine(&mut self) {
        let count = self.corners.points().len();
        let mut level = Level::default();
        let Some(coarse) = self.levels.last() else { return };
        let depth = self.levels.len() as i32;
        let counts = self.corners.grid().unwrap_or([1; 3]).map(|count| f64::from(count).powi(depth));
        let counts = DVec3::from_array(counts);
        level.cells.reserve(coarse.cells.len() * self.maps.len());
        let mut met: HashMap<(u32, u32), u32, BuildHasherDefault<Mix>> = HashMap::default();
        for corners in coarse.cells.chunks_exact(count) {
            let own = level.fresh.len();
            for (shares, &shared) in self.shares.iter().zip(&self.shared) {
                let at = |(&corner, share): (&u32, &f64)| self.vertices[corner as usize] * *share;
                let point: DVec3 = corners.iter().zip(shares).map(at).sum();
                let next = self.vertices.len() as u32;
                let mut number = next;
                if shared {
                    let [x, y, z] = (self.corners.place(point) * counts).round().to_array().map(|x| x as u32);
                    number = *met.entry((x | y << 16, z)).or_insert(next);
                }
                if number == next {
                    self.vertices.push(point);
                }
                level.fresh.push(number);
            }
            let fresh = &level.fresh[own..];
            let vertex = |&part: &usize| if part < count { corners[part] } else { fresh[part - count] };
            level.cells.extend(self.parts.iter().map(vertex));
        }
        level.vertices = self.vertices.len();
        level.shared = vec![0; level.vertices];
        level.cells.iter().for_each(|&vertex| level.shared[vertex as usize] += 1);
        self.levels.push(level);
    }

    /// The part of the whole that a point lies deepest in, and the point that its map takes there.
    pub fn part(&self, point: DVec3) -> (usize, DVec3) {
        let inner = |map: &Affine3| map.inverse().map_or(point, |inverse| inverse.apply(point));
        let inside = |map: &Affine3| {
            let place = self.corners.place(inner(map));
            let beyond = match self.corners.grid() {
                Some(_) => (DVec3::ONE - place).min_element(),
                None => 1.0 - place.element_sum(),
            };
            place.min_element().min(beyond)
        };
        let depths = self.maps.iter().map(inside).enumerate();
        let letter = depths.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(letter, _)| letter);
        (letter, inner(&self.maps[letter]))
    }

    pub fn depth(&self) -> usize {
        self.levels.len() - 1
    }

    /// The vertices of a cell.
    pub fn cell(&self, level: usize, index: usize) -> &[u32] {
        let count = self.corners.points().len();
        &self.levels[level].cells[index * count..(index + 1) * count]
    }

    pub fn cells(&self) -> Cells<'_> {
        Cells {
            levels: &self.levels,
            corners: self.corners.points().len(),
            shares: &self.shares,
            maps: self.maps.len(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;
    use crate::testing::{gasket3, grid3};

    #[test]
    fn every_corner_is_there_once_and_counted_as_often_as_it_is_shared() {
        let sponge = grid3(3, |[x, y, z]| u8::from(x == 1) + u8::from(y == 1) + u8::from(z == 1) < 2);
        for (maps, depth, scale) in [(gasket3(0.5), 5, 32.0), (sponge, 2, 9.0), (grid3(2, |_| true), 4, 16.0)]
        {
            let lattice = Lattice3::new(&maps, Corners3::find(&maps).unwrap(), depth);
            let last = &lattice.levels[depth];
            let place = |point: DVec3| (point * scale).round().to_array().map(|x| x as i32);
            let places: HashSet<_> = lattice.vertices.iter().map(|&p| place(p)).collect();
            assert_eq!(places.len(), lattice.vertices.len());
            let mut words = vec![Affine3::IDENTITY];
            for _ in 0..depth {
                words = words.iter().flat_map(|word| maps.iter().map(move |map| *word * *map)).collect();
            }
            let mut shared = vec![0; lattice.vertices.len()];
            for (index, word) in words.iter().enumerate() {
                for (&vertex, &corner) in lattice.cell(depth, index).iter().zip(lattice.corners.points()) {
                    assert!(lattice.vertices[vertex as usize].distance(word.apply(corner)) < 1e-12);
                    shared[vertex as usize] += 1;
                }
            }
            assert_eq!(last.shared, shared);
        }
        let cube = grid3(2, |_| true);
        let whole = Lattice3::new(&cube, Corners3::find(&cube).unwrap(), 4);
        assert_eq!(whole.vertices.len(), 17 * 17 * 17);
    }

    #[test]
    fn it_is_no_larger_than_memory_allows() {
        let cube = grid3(4, |_| true);
        let corners = Corners3::find(&cube).unwrap();
        assert_eq!(Lattice3::deepest(cube.len(), &corners), 3);
        assert_eq!(Lattice3::new(&cube, corners, 1000).depth(), 3);
    }
}
