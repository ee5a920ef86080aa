//! The corners of all cells, level by level.

use std::collections::HashMap;

use frond_core::Affine2;
use glam::DVec2;

use crate::corners::Corners;

/// The cells of a shape that has [`Corners`], and the corners that they share, for the words of 0, 1, 2, .. letters.
#[derive(Clone, Debug)]
pub struct Lattice {
    maps: Vec<Affine2>,
    corners: Corners,
    levels: Vec<Level>,
}

/// The cells of the words of one length.
#[derive(Clone, Debug, Default)]
pub struct Level {
    /// The corners of all cells, each once.
    pub vertices: Vec<DVec2>,
    /// For each cell, words in the order of a dictionary, the numbers of its vertices.
    pub cells: Vec<[u32; 4]>,
}

impl Lattice {
    /// The most cells of the finest level: with all that hangs on them they take some 100 MB.
    pub const MOST_CELLS: usize = 1 << 20;

    /// The deepest level that a shape of so many maps may have.
    #[must_use]
    pub fn deepest(maps: usize) -> usize {
        if maps < 2 { 32 } else { (Self::MOST_CELLS as f64).log(maps as f64).floor() as usize }
    }

    /// The cells of up to `depth` letters, or of as many as [`Lattice::deepest`] allows.
    #[must_use]
    pub fn new(maps: &[Affine2], corners: Corners, depth: usize) -> Self {
        let depth = depth.min(Self::deepest(maps.len()));
        let points = corners.points();
        let first = Level { vertices: points.to_vec(), cells: vec![numbers(0..points.len() as u32)] };
        let mut this = Self { maps: maps.to_vec(), corners, levels: vec![first] };
        let mut cells = vec![Affine2::IDENTITY];
        for _ in 0..depth {
            cells = cells.iter().flat_map(|cell| maps.iter().map(move |map| *cell * *map)).collect();
            this.levels.push(this.level(&cells));
        }
        this
    }

    fn level(&self, cells: &[Affine2]) -> Level {
        let points = self.corners.points();
        let mut level = Level::default();
        // Corners of one level are at least as far from each other as the smallest cell is wide.
        let size = points[0].distance(points[1]);
        let least =
            cells.iter().map(|cell| cell.linear.determinant().abs().sqrt()).fold(f64::INFINITY, f64::min);
        let step = 0.01 * least * size;
        let mut known: HashMap<(i64, i64), u32> = HashMap::with_capacity(cells.len() * 2);
        for cell in cells {
            let mut cell_numbers = [0; 4];
            for (number, &point) in cell_numbers.iter_mut().zip(points) {
                let place = cell.apply(point);
                *number = *near(&place, step).iter().find_map(|key| known.get(key)).unwrap_or(&u32::MAX);
                if *number == u32::MAX {
                    *number = level.vertices.len() as u32;
                    level.vertices.push(place);
                    known.insert(near(&place, step)[0], *number);
                }
            }
            level.cells.push(cell_numbers);
        }
        level
    }

    /// The maps of the shape.
    #[must_use]
    pub fn maps(&self) -> &[Affine2] {
        &self.maps
    }

    /// The corners of the whole.
    #[must_use]
    pub const fn corners(&self) -> &Corners {
        &self.corners
    }

    /// The levels, that of no letters first.
    #[must_use]
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }
}

fn numbers(from: impl Iterator<Item = u32>) -> [u32; 4] {
    let mut list = [0; 4];
    list.iter_mut().zip(from).for_each(|(slot, number)| *slot = number);
    list
}

/// The square of a point, its own first, and those that it is so near to that rounding may have put its twin there.
fn near(point: &DVec2, step: f64) -> [(i64, i64); 4] {
    let scaled = *point / step;
    let own = scaled.round();
    let other = own + (scaled - own).signum();
    let key = |x: f64, y: f64| (x as i64, y as i64);
    [key(own.x, own.y), key(other.x, own.y), key(own.x, other.y), key(other.x, other.y)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(maps: &[Affine2], depth: usize) -> Lattice {
        Lattice::new(maps, Corners::find(maps).unwrap(), depth)
    }

    #[test]
    fn gaskets_share_as_many_corners_as_they_should() {
        // Turned and moved, so that no coordinate is round.
        let place = Affine2::similitude(3.7, 0.4, DVec2::new(0.123, -7.1));
        let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.5, 0.8)];
        let maps = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5).conjugate(place).unwrap());
        let lattice = lattice(&maps, 9);
        for (n, level) in lattice.levels().iter().enumerate() {
            let cells = 3_usize.pow(n as u32);
            assert_eq!((level.cells.len(), level.vertices.len()), (cells, (3 * cells + 3) / 2), "level {n}");
        }
    }

    #[test]
    fn squares_share_their_sides() {
        let thirds: Vec<Affine2> = (0..9)
            .map(|i| {
                Affine2::similitude(1.0 / 3.0, 0.0, DVec2::new(f64::from(i % 3), f64::from(i / 3)) / 3.0)
            })
            .collect();
        let lattice = lattice(&thirds, 4);
        assert_eq!(lattice.levels()[4].vertices.len(), 82 * 82);
        assert_eq!(Lattice::deepest(9), 6);
        assert_eq!(Lattice::new(&thirds, Corners::find(&thirds).unwrap(), 99).levels().len(), 7);
    }
}
