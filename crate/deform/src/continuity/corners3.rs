//! Shapes of space whose pieces meet in corners.

use frond_core::Affine3;
use glam::{BVec3, DMat3, DVec3};

use crate::continuity::cells::MOST_CORNERS;

/// A tetrahedron or a box, straight or oblique, that holds a shape and whose images under the maps meet face to face:
/// what is interpolated between corners is continuous.
///
/// The images of a tetrahedron meet in corners alone, as those of the gasket tetrahedron do; those of a box are cells
/// of one grid, as those of Menger's sponge. Other shapes have none.
#[derive(Clone, Debug, PartialEq)]
pub struct Corners3 {
    points: Vec<DVec3>,
    /// From space to coordinates in which the first corner is the origin, and those next to it are 1 along the axes.
    frame: Affine3,
    /// Cells of the grid along each axis, where it is a box.
    grid: Option<[u32; 3]>,
}

/// Distances below this share of the shape's size are none.
const CORNER_TOLERANCE: f64 = 1e-9;
/// The most words that are looked at for corners.
const MOST_WORDS: usize = 4096;
/// The most letters of these.
const LONGEST_WORD: u32 = 4;

impl Corners3 {
    /// The corners of the attractor of `maps`, if it has any.
    #[must_use]
    pub fn find(maps: &[Affine3]) -> Option<Self> {
        Self::of_box(maps).or_else(|| Self::of_tetrahedron(maps))
    }

    /// Four of a tetrahedron, or eight of a box: the bits of their number say which are 1 along x, y and z.
    #[must_use]
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// Cells of the grid along each axis of the box; `None` for a tetrahedron.
    #[must_use]
    pub const fn grid(&self) -> Option<[u32; 3]> {
        self.grid
    }

    /// To coordinates in which the first corner is the origin, and those next to it are 1 along the axes.
    pub(crate) fn frame(&self) -> Affine3 {
        self.frame
    }

    /// Where a point lies as the corners have it: 0 to 1 along each axis inside a box.
    pub(crate) fn place(&self, point: DVec3) -> DVec3 {
        self.frame.apply(point)
    }

    /// How much each corner counts at a point: barycentric in a tetrahedron, trilinear in a box. They sum to 1 and give
    /// back the point; outside they go on.
    #[must_use]
    pub fn weights(&self, point: DVec3) -> [f64; MOST_CORNERS] {
        let DVec3 { x, y, z } = self.place(point);
        if self.grid.is_none() {
            return [1.0 - x - y - z, x, y, z, 0.0, 0.0, 0.0, 0.0];
        }
        let side = |high: bool, t: f64| if high { t } else { 1.0 - t };
        std::array::from_fn(|i| side(i & 1 == 1, x) * side(i & 2 == 2, y) * side(i & 4 == 4, z))
    }

    /// A box whose eight corners are left where they are by a map each, and whose images are cells of one grid.
    fn of_box(maps: &[Affine3]) -> Option<Self> {
        if maps.len() < 8 {
            return None;
        }
        let fixed = maps.iter().map(|map| map.fixed_point()).collect::<Option<Vec<DVec3>>>()?;
        // The first in a direction that no face of a box of this world looks in is a corner.
        let slant = DVec3::new(1.0, 0.618_033_988_7, 0.414_213_562_3);
        let first = *fixed.iter().min_by(|a, b| a.dot(slant).total_cmp(&b.dot(slant)))?;
        let size = fixed.iter().map(|p| p.distance(first)).fold(0.0, f64::max);
        let others: Vec<DVec3> =
            fixed.into_iter().filter(|p| p.distance(first) > CORNER_TOLERANCE * size).collect();
        let count = others.len();
        let triples = (0..count).flat_map(|i| (0..i).flat_map(move |j| (0..j).map(move |k| [k, j, i])));
        for [x, y, z] in triples {
            let sides = DMat3::from_cols(others[x] - first, others[y] - first, others[z] - first);
            if sides.determinant().abs() <= 1e-6 * size.powi(3) {
                continue;
            }
            let Some(frame) = Affine3::new(sides, first).inverse() else { continue };
            let places: Vec<DVec3> = others.iter().map(|&p| frame.apply(p)).collect();
            let low = DVec3::splat(-CORNER_TOLERANCE);
            let inside = |p: &DVec3| p.cmpge(low).all() && p.cmple(DVec3::ONE - low).all();
            let corner = |i: usize| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64);
            let met = |i: usize| places.iter().any(|p| p.distance(corner(i)) <= CORNER_TOLERANCE);
            if !(places.iter().all(inside) && (1..8).all(met)) {
                continue;
            }
            let points = (0..8).map(|i| first + sides * corner(i)).collect();
            let mut this = Self { points, frame, grid: None };
            this.grid = Some(this.cells(maps)?);
            return Some(this);
        }
        None
    }

    /// The grid whose cells all images are, each another one.
    fn cells(&self, maps: &[Affine3]) -> Option<[u32; 3]> {
        let mut found: Option<(DVec3, bool)> = None;
        let mut cells: Vec<[i64; 3]> = Vec::new();
        for map in maps {
            let map = map.conjugate(self.frame)?;
            let rows = [0, 1, 2].map(|k| map.linear.row(k));
            // A box whose sides lie along the axes: each of them comes from one axis.
            let sides = DVec3::from_array(rows.map(|row| row.abs().element_sum()));
            let lead = DVec3::from_array(rows.map(|row| row.abs().max_element()));
            let plain = DVec3::from_array([0, 1, 2].map(|k| rows[k][k].abs()));
            let straight = (sides - plain).abs().max_element() <= CORNER_TOLERANCE;
            let counts = sides.recip().round();
            let fits = (counts * sides - 1.0).abs().max_element() <= CORNER_TOLERANCE;
            if (sides - lead).abs().max_element() > CORNER_TOLERANCE || !fits || counts.min_element() < 2.0 {
                return None;
            }
            let (known, all) = *found.get_or_insert((counts, true));
            if known != counts || map.inverse().is_none() {
                return None;
            }
            found = Some((known, all && straight));
            let low = (map.apply(DVec3::ONE).min(map.translation) * counts).round();
            let off = map.apply(DVec3::ONE).min(map.translation) * counts - low;
            let inside = low.cmpge(DVec3::ZERO).all() && low.cmple(counts - 1.0).all();
            let cell = low.to_array().map(|x| x as i64);
            if off.abs().max_element() > 1e-6 || !inside || cells.contains(&cell) {
                return None;
            }
            cells.push(cell);
        }
        let (counts, straight) = found?;
        // Where axes change places, all must be cut alike for cells of cells to fit.
        let alike = counts.x == counts.y && counts.y == counts.z;
        (straight || alike).then(|| counts.to_array().map(|x| x as u32))
    }

    /// A tetrahedron whose corners are points of words of few letters, and whose images meet in corners alone.
    fn of_tetrahedron(maps: &[Affine3]) -> Option<Self> {
        let points = candidates(maps);
        let farthest = |measure: &dyn Fn(DVec3) -> f64| {
            let best = points.iter().copied().max_by(|a, b| measure(*a).total_cmp(&measure(*b)))?;
            Some((best, measure(best)))
        };
        // What is farthest from a point, a line, a plane is a corner of the hull.
        let start = *points.first()?;
        let (a, _) = farthest(&|p| p.distance(start))?;
        let (b, size) = farthest(&|p| p.distance(a))?;
        let along = (b - a).try_normalize()?;
        let (c, wide) = farthest(&|p| along.cross(p - a).length())?;
        let up = along.cross(c - a).try_normalize()?;
        let (d, high) = farthest(&|p| up.dot(p - a).abs())?;
        if wide.min(high) <= 1e-6 * size {
            return None;
        }
        let frame = Affine3::new(DMat3::from_cols(b - a, c - a, d - a), a).inverse()?;
        let this = Self { points: vec![a, b, c, d], frame, grid: None };
        this.fits(maps).then_some(this)
    }

    /// Whether all images lie in the tetrahedron, have its corners, and share nothing but corners.
    fn fits(&self, maps: &[Affine3]) -> bool {
        let image = |map: &Affine3| -> Option<[[f64; 4]; 4]> {
            map.inverse()?;
            let weights = |i: usize| {
                let [a, b, c, d, ..] = self.weights(map.apply(self.points[i]));
                [a, b, c, d]
            };
            Some([weights(0), weights(1), weights(2), weights(3)])
        };
        let Some(images) = maps.iter().map(image).collect::<Option<Vec<_>>>() else { return false };
        let tolerance = CORNER_TOLERANCE;
        let held = images.iter().flatten().flatten().all(|weight| *weight >= -tolerance);
        let kept = (0..4).all(|i| images.iter().flatten().any(|corner| (corner[i] - 1.0).abs() <= tolerance));
        // A plane along a face of the whole that parts them, but for one corner of both.
        let parted = |one: &[[f64; 4]; 4], other: &[[f64; 4]; 4], axis: usize| {
            let least = one.iter().map(|corner| corner[axis]).fold(f64::INFINITY, f64::min);
            let most = other.iter().map(|corner| corner[axis]).fold(f64::NEG_INFINITY, f64::max);
            if least > most + tolerance {
                return true;
            }
            let near = |corners: &[[f64; 4]; 4], at: f64| -> Vec<[f64; 4]> {
                corners.iter().copied().filter(|corner| (corner[axis] - at).abs() <= tolerance).collect()
            };
            if least < most - tolerance {
                return false;
            }
            // Of one of them the plane has a single corner, and that is one of the other's as well.
            let (ones, others) = (near(one, least), near(other, most));
            let same = |a: &[f64; 4], b: &[f64; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance);
            (ones.len() == 1 || others.len() == 1) && ones.iter().any(|a| others.iter().any(|b| same(a, b)))
        };
        let apart = |i: usize, j: usize| {
            (0..4).any(|axis| parted(&images[i], &images[j], axis) || parted(&images[j], &images[i], axis))
        };
        held && kept && (0..images.len()).all(|i| (0..i).all(|j| apart(i, j)))
    }

    /// Whether a point of a cell, as the corners have it, lies on the cell's own surface, where others may share it.
    pub(crate) fn on_surface(&self, place: DVec3) -> bool {
        let near = |to: f64| -> BVec3 { (place - to).abs().cmplt(DVec3::splat(1e-6)) };
        near(0.0).any() || near(1.0).any()
    }
}

/// Points of the attractor among which its corners are, if words of few letters lead to them: where words keep still,
/// and where other words take these.
fn candidates(maps: &[Affine3]) -> Vec<DVec3> {
    let longest = (1..=LONGEST_WORD)
        .take_while(|&length| maps.len().checked_pow(length).is_some_and(|words| words <= MOST_WORDS))
        .last();
    let mut words = vec![Affine3::IDENTITY];
    let mut found: Vec<DVec3> = Vec::new();
    for _ in 0..longest.unwrap_or(1) {
        // What was found before, a letter further on.
        let moved: Vec<DVec3> =
            found.iter().flat_map(|&point| maps.iter().map(move |map| map.apply(point))).collect();
        words = words.iter().flat_map(|word| maps.iter().map(move |map| *word * *map)).collect();
        found.extend(moved);
        found.extend(words.iter().filter_map(|word| word.fixed_point()));
        if found.len() > 1 << 16 {
            break;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;
    use crate::testing::{gasket3, grid3};

    /// Anywhere, turned and sheared.
    fn somewhere() -> Affine3 {
        let shear = DMat3::from_cols_array(&[1.0, 0.2, 0.0, 0.3, 2.0, 0.1, -0.4, 0.0, 0.7]);
        Affine3::new(shear, DVec3::new(0.3, -7.1, 2.2))
    }

    fn moved(maps: &[Affine3]) -> Vec<Affine3> {
        maps.iter().map(|map| map.conjugate(somewhere()).unwrap()).collect()
    }

    #[test]
    fn gaskets_sponges_and_dusts_have_corners_wherever_they_are() {
        let sponge = grid3(3, |[x, y, z]| u8::from(x == 1) + u8::from(y == 1) + u8::from(z == 1) < 2);
        let dust = grid3(3, |cell| cell.iter().all(|x| *x != 1));
        for (maps, corners) in
            [(gasket3(0.5), 4), (gasket3(0.4), 4), (sponge, 8), (dust, 8), (grid3(2, |_| true), 8)]
        {
            for maps in [moved(&maps), maps] {
                let found = Corners3::find(&maps).expect("corners");
                assert_eq!(found.points().len(), corners);
                for (i, &point) in found.points().iter().enumerate() {
                    let weights = found.weights(point);
                    assert!((weights[i] - 1.0).abs() < 1e-9, "{weights:?}");
                }
                let inside = found.points().iter().sum::<DVec3>() / corners as f64 + DVec3::splat(0.01);
                let again: DVec3 =
                    found.points().iter().zip(found.weights(inside)).map(|(p, w)| *p * w).sum();
                assert!((again - inside).length() < 1e-12);
            }
        }
    }

    #[test]
    fn corners_need_not_be_fixed() {
        // Each half turned by a third of a turn about the axis through its own corner: as a set it is the same.
        let corners = [
            DVec3::ONE,
            DVec3::new(1.0, -1.0, -1.0),
            DVec3::new(-1.0, 1.0, -1.0),
            DVec3::new(-1.0, -1.0, 1.0),
        ];
        let turned = |&c: &DVec3| {
            let turn = DQuat::from_axis_angle(c.normalize(), std::f64::consts::TAU / 3.0);
            Affine3::similitude(0.5, turn, c * 0.5)
        };
        let maps: Vec<Affine3> = corners.iter().map(turned).collect();
        assert_eq!(Corners3::find(&maps).unwrap().points().len(), 4);
        // By less than that they are no longer.
        let turned =
            |&c: &DVec3| Affine3::similitude(0.5, DQuat::from_axis_angle(c.normalize(), 0.3), c * 0.5);
        assert_eq!(Corners3::find(&corners.iter().map(turned).collect::<Vec<_>>()), None);
    }

    #[test]
    fn overlapping_doubled_flat_and_empty_ones_have_none() {
        assert_eq!(Corners3::find(&gasket3(0.55)), None);
        assert_eq!(Corners3::find(&[gasket3(0.5), gasket3(0.5)].concat()), None);
        assert_eq!(Corners3::find(&[grid3(2, |_| true), grid3(2, |_| true)].concat()), None);
        assert_eq!(Corners3::find(&[]), None);
        assert_eq!(Corners3::find(&vec![Affine3::IDENTITY; 5]), None);
        assert_eq!(Corners3::find(&vec![Affine3::similitude(0.5, DQuat::IDENTITY, DVec3::X); 64]), None);
        let flat: Vec<Affine3> =
            gasket3(0.5).iter().map(|map| *map * Affine3::scaling(DVec3::new(1.0, 1.0, 0.0))).collect();
        assert_eq!(Corners3::find(&flat), None);
    }
}
