//! The corners of all cells, level by level.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use frond_core::Affine2;
use glam::DVec2;

use crate::continuity::cells::Level;
use crate::continuity::corners::Corners;
use crate::shuffle::terms::deepest_level;

/// The cells of a shape that has [`Corners`], and the corners that they share, for the words of 0, 1, 2, .. letters.
///
/// A corner of a cell is a corner of one of its parts, too, and keeps its number: the vertices of a level are the first
/// ones of the next.
#[derive(Clone, Debug)]
pub struct Lattice {
    maps: Vec<Affine2>,
    corners: Corners,
    vertices: Vec<DVec2>,
    levels: Vec<Level>,
    /// The corners that a cell gets when it is taken apart.
    slots: Vec<Slot>,
    /// For each corner of each part of a cell, which one it is.
    parts: Vec<Source>,
    /// Whether parts share sides: if those of the whole do not, no others do.
    meet: bool,
}

/// A corner of a part of a cell that is none of the cell.
#[derive(Clone, Debug)]
pub(crate) struct Slot {
    point: DVec2,
    /// What the corners of the cell count there.
    pub shares: [f64; Corners::MOST_CORNERS],
    side: Option<(usize, usize)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    Corner(usize),
    Slot(usize),
}

/// Between two vertices, the lower number first: the first of the vertices on that side, and how many.
type Sides = HashMap<(u32, u32), (u32, u32), BuildHasherDefault<Mix>>;

impl Lattice {
    /// The most cells of the finest level: with all that hangs on them they take some 100 MB.
    pub const MOST_CELLS: usize = 1 << 20;

    /// The deepest level that a shape of so many maps may have.
    #[must_use]
    pub fn deepest(maps: usize) -> usize {
        deepest_level(maps, Self::MOST_CELLS)
    }

    /// The cells of up to `depth` letters, or of as many as [`Lattice::deepest`] allows.
    #[must_use]
    pub fn new(maps: &[Affine2], corners: Corners, depth: usize) -> Self {
        let depth = depth.min(Self::deepest(maps.len()));
        let count = corners.points().len();
        let first = Level {
            vertices: count,
            cells: (0..count as u32).collect(),
            fresh: Vec::new(),
            shared: vec![1; count],
        };
        let vertices = corners.points().to_vec();
        let (slots, parts) = taken_apart(maps, &corners);
        let meet = parts.chunks_exact(count).enumerate().any(|(i, one)| {
            let shared = |other: &[Source]| one.iter().filter(|source| other.contains(source)).count();
            parts.chunks_exact(count).take(i).any(|other| shared(other) > 1)
        });
        let mut this =
            Self { maps: maps.to_vec(), corners, vertices, levels: vec![first], slots, parts, meet };
        (0..depth).for_each(|_| this.refine());
        this
    }

    /// Adds a level.
    ///
    /// Parts of different cells meet in a corner of both, or on a whole side of both, and then at the same vertices
    /// along it: so no vertex need be looked for by its place.
    fn refine(&mut self) {
        let count = self.corners.points().len();
        let mut level = Level::default();
        let Some(coarse) = self.levels.last() else { return };
        level.cells.reserve(coarse.cells.len() * self.maps.len());
        level.fresh.reserve(coarse.cells.len() / count * self.slots.len());
        let room = if self.meet { coarse.cells.len() * 3 / 4 } else { 0 };
        let mut sides = Sides::with_capacity_and_hasher(room, BuildHasherDefault::default());
        let mut along = vec![0_u32; count];
        for slot in &self.slots {
            if let Some((side, _)) = slot.side {
                along[side] += 1;
            }
        }
        for corners in coarse.cells.chunks_exact(count) {
            let own = level.fresh.len();
            for slot in &self.slots {
                // As exact as the map of the cell: shares give back the point.
                let at = |(&corner, share): (&u32, &f64)| self.vertices[corner as usize] * *share;
                let place: DVec2 = corners.iter().zip(&slot.shares).map(at).sum();
                let mut number = self.vertices.len() as u32;
                if let Some((side, rank)) = slot.side.filter(|_| self.meet) {
                    let (a, b) = (corners[side], corners[(side + 1) % count]);
                    let fresh = (number, along[side]);
                    let (first, length) = *sides.entry((a.min(b), a.max(b))).or_insert(fresh);
                    let known = if a < b { first + rank as u32 } else { first + length - 1 - rank as u32 };
                    if first == fresh.0 {
                        // All vertices of a side are made when it is first met, in order from its lower end.
                        let room = if rank == 0 { length as usize } else { 0 };
                        self.vertices.resize(self.vertices.len() + room, DVec2::ZERO);
                    }
                    number = known;
                    self.vertices[number as usize] = place;
                } else {
                    self.vertices.push(place);
                }
                level.fresh.push(number);
            }
            let fresh = &level.fresh[own..];
            level.cells.extend(self.parts.iter().map(|source| match *source {
                Source::Corner(i) => corners[i],
                Source::Slot(i) => fresh[i],
            }));
        }
        level.vertices = self.vertices.len();
        level.shared = vec![0; level.vertices];
        level.cells.iter().for_each(|&vertex| {
            let shared = &mut level.shared[vertex as usize];
            *shared = shared.saturating_add(1);
        });
        self.levels.push(level);
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

    /// The corners of all cells, each once, those of larger cells first.
    #[must_use]
    pub fn vertices(&self) -> &[DVec2] {
        &self.vertices
    }

    /// The levels, that of no letters first.
    #[must_use]
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// The vertices of a cell.
    #[must_use]
    pub fn cell(&self, level: usize, index: usize) -> &[u32] {
        let count = self.corners.points().len();
        &self.levels[level].cells[index * count..(index + 1) * count]
    }

    pub(crate) fn slots(&self) -> &[Slot] {
        &self.slots
    }
}

/// The corners that a cell gets when it is taken apart, those along one side in a row, and what each corner of each
/// part is.
fn taken_apart(maps: &[Affine2], corners: &Corners) -> (Vec<Slot>, Vec<Source>) {
    let points = corners.points();
    let count = points.len();
    let tolerance = 1e-7 * points[0].distance(points[1]);
    let of_parts: Vec<DVec2> = maps.iter().flat_map(|map| points.iter().map(|&p| map.apply(p))).collect();
    let mut slots: Vec<(Slot, (f64, usize))> = Vec::new();
    for &point in &of_parts {
        let near = |p: &DVec2| p.distance(point) <= tolerance;
        if points.iter().any(near) || slots.iter().any(|(slot, _)| near(&slot.point)) {
            continue;
        }
        let ends = |i: usize| (points[i], points[(i + 1) % count]);
        let off = |i: usize| {
            let (a, b) = ends(i);
            (b - a).perp_dot(point - a).abs() / a.distance(b)
        };
        let side = (0..count).find(|&i| off(i) <= tolerance);
        let far = side.map_or(0.0, |i| point.distance(ends(i).0));
        slots.push((
            Slot { point, shares: corners.weights(point), side: side.map(|side| (side, 0)) },
            (far, slots.len()),
        ));
    }
    let place = |slot: &Slot| slot.side.map_or(count, |(side, _)| side);
    slots.sort_unstable_by(|(a, (x, i)), (b, (y, j))| {
        place(a).cmp(&place(b)).then(x.total_cmp(y)).then(i.cmp(j))
    });
    let mut slots: Vec<Slot> = slots.into_iter().map(|(slot, _)| slot).collect();
    for i in 1..slots.len() {
        if let (Some((before, rank)), Some((side, _))) = (slots[i - 1].side, slots[i].side)
            && before == side
        {
            slots[i].side = Some((side, rank + 1));
        }
    }
    let source = |&point: &DVec2| {
        let near = |p: &DVec2| p.distance(point) <= tolerance;
        points.iter().position(near).map_or_else(
            || Source::Slot(slots.iter().position(|slot| near(&slot.point)).unwrap_or(0)),
            Source::Corner,
        )
    };
    let parts = of_parts.iter().map(source).collect();
    (slots, parts)
}

/// Mixes pairs of numbers: they are no secret, and looked up by the million.
#[derive(Default)]
pub(crate) struct Mix(u64);

impl Hasher for Mix {
    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 29)
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u32(u32::from(byte)));
    }

    fn write_u32(&mut self, number: u32) {
        self.0 = (self.0.rotate_left(5) ^ u64::from(number)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    }
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
            assert_eq!((level.cells.len() / 3, level.vertices), (cells, (3 * cells + 3) / 2), "level {n}");
        }
    }

    /// Cells, and corners of cells that have others of their level nearer than a corner is wide, but another number.
    fn assert_sound(maps: &[Affine2], depth: usize) {
        let lattice = lattice(maps, depth);
        let count = lattice.corners().points().len();
        let cells = (0..depth).fold(vec![Affine2::IDENTITY], |cells, _| {
            cells.iter().flat_map(|cell| maps.iter().map(move |map| *cell * *map)).collect()
        });
        for (i, cell) in cells.iter().enumerate() {
            for (&vertex, &corner) in lattice.cell(depth, i).iter().zip(lattice.corners().points()) {
                assert!(lattice.vertices()[vertex as usize].distance(cell.apply(corner)) < 1e-9, "{i}");
            }
        }
        let mut sorted = lattice.vertices()[..lattice.levels()[depth].vertices].to_vec();
        sorted.sort_by(|a, b| a.x.total_cmp(&b.x));
        for (i, p) in sorted.iter().enumerate() {
            let near = sorted[i + 1..].iter().take_while(|q| q.x < p.x + 1e-7);
            assert!(near.filter(|q| q.distance(*p) < 1e-7).count() == 0, "{count} {p}: twice");
        }
    }

    #[test]
    fn no_corner_has_two_numbers() {
        let square = |keep: fn(i32) -> bool| -> Vec<Affine2> {
            let cells = (0..9).filter(|&i| keep(i));
            let part = |i| DVec2::new(f64::from(i % 3), f64::from(i / 3)) / 3.0;
            cells.map(|i| Affine2::similitude(1.0 / 3.0, 0.0, part(i))).collect()
        };
        for keep in [|_| true, |i| i != 4, |i| i % 2 == 0] {
            assert_sound(&square(keep), 3);
        }
        // Halves of a right triangle, each mirrored onto the whole: sides are shared by cells that are cut alike.
        let halves =
            [[0.5, 0.5, 0.5, -0.5, 0.0, 0.0], [-0.5, 0.5, 0.5, 0.5, 1.0, 0.0]].map(Affine2::from_row);
        if Corners::find(&halves).is_some() {
            assert_sound(&halves, 8);
        }
        let four = [[0.5, 0.0], [0.0, 0.0], [0.0, 0.5]]
            .map(|[x, y]| Affine2::similitude(0.5, 0.0, DVec2::new(x, y)));
        let middle = Affine2::from_row([-0.5, 0.0, 0.0, -0.5, 0.5, 0.5]);
        assert_sound(&[&four[..], &[middle]].concat(), 5);
    }

    #[test]
    fn squares_share_their_sides() {
        let thirds: Vec<Affine2> = (0..9)
            .map(|i| {
                Affine2::similitude(1.0 / 3.0, 0.0, DVec2::new(f64::from(i % 3), f64::from(i / 3)) / 3.0)
            })
            .collect();
        let lattice = lattice(&thirds, 4);
        assert_eq!(lattice.levels()[4].vertices, 82 * 82);
        assert_eq!([2, 3, 4, 9].map(Lattice::deepest), [20, 12, 10, 6]);
        assert_eq!(Lattice::new(&thirds, Corners::find(&thirds).unwrap(), 99).levels().len(), 7);
    }
}
