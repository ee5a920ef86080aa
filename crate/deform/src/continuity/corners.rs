//! Shapes whose pieces meet in corners.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::continuity::cells::MOST_CORNERS;
use crate::continuity::polygon::{hull, overlap, turn};

/// A convex polygon that holds a shape and whose images under the maps meet corner to corner: pieces share nothing but
/// corners and whole sides, and what is interpolated between corners is continuous.
///
/// The gasket has its triangle, the square and the carpet their square, the pentagon gasket its pentagon; overlapping
/// shapes, trees and most tilings have none.
#[derive(Clone, Debug, PartialEq)]
pub struct Corners {
    points: Vec<DVec2>,
    letters: Vec<usize>,
    /// From the plane to the coordinates of the first corner and the two sides that leave it, where these say all:
    /// for triangles and parallelograms.
    to_sides: Option<DMat2>,
}

/// Distances below this share of the shape's size are none.
const CORNER_TOLERANCE: f64 = 1e-9;
/// Where cells touch along a side, their parts are looked at, down to about as many of each.
const PARTS_A_SIDE: usize = 256;

impl Corners {
    /// The most corners that are looked for.
    pub const MOST_CORNERS: usize = MOST_CORNERS;

    /// The corners of the attractor of `maps`, if it has any that are fixed by a map each. There is but one polygon to
    /// look at, the hull of the fixed points, so that shapes without corners cost next to nothing.
    #[must_use]
    pub fn find(maps: &[Affine2]) -> Option<Self> {
        let fixed = maps.iter().map(|map| map.fixed_point()).collect::<Option<Vec<DVec2>>>()?;
        let size = fixed.iter().map(|p| p.distance(fixed[0])).fold(0.0, f64::max);
        let letters = hull(&fixed, CORNER_TOLERANCE * size);
        if !(3..=Self::MOST_CORNERS).contains(&letters.len()) {
            return None;
        }
        let points: Vec<DVec2> = letters.iter().map(|&letter| fixed[letter]).collect();
        let last = points.len() - 1;
        let (along, up) = (points[1] - points[0], points[last] - points[0]);
        let square =
            last == 3 && points[0].distance(points[1] + points[3] - points[2]) <= CORNER_TOLERANCE * size;
        let to_sides = (last == 2 || square).then(|| DMat2::from_cols(along, up).inverse());
        let this = Self { points, letters, to_sides };
        // Slivers have no inside worth the name.
        let sound = (0..=last).all(|i| this.bulge(i) > 1e-6 * size * size);
        (sound && this.fit(maps, CORNER_TOLERANCE * size)).then_some(this)
    }

    /// The corners, in cyclic order, counter-clockwise.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// For each corner the map that leaves it where it is.
    #[must_use]
    pub fn letters(&self) -> &[usize] {
        &self.letters
    }

    /// Three corners, or all four of a parallelogram.
    pub(crate) fn anchors(&self) -> Vec<usize> {
        let count = self.points.len();
        if self.to_sides.is_some() { (0..count).collect() } else { vec![0, count / 3, 2 * count / 3] }
    }

    /// How much each corner counts at a point: barycentric in a triangle, bilinear in a parallelogram, Wachspress's
    /// rational coordinates in other polygons. They sum to 1, give back the point, and on a side are linear and hang
    /// on its ends alone. Outside, triangles and parallelograms go on; other polygons are left along the line to
    /// their middle.
    #[must_use]
    pub fn weights(&self, point: DVec2) -> [f64; Self::MOST_CORNERS] {
        let mut list = [0.0; Self::MOST_CORNERS];
        let Some(to_sides) = self.to_sides else {
            self.wachspress(point, &mut list);
            return list;
        };
        let DVec2 { x, y } = to_sides * (point - self.points[0]);
        if self.points.len() == 3 {
            [list[0], list[1], list[2]] = [1.0 - x - y, x, y];
        } else {
            [list[0], list[1], list[2], list[3]] =
                [(1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y];
        }
        list
    }

    /// The product of the distances to all sides that do not meet in a corner, times twice the area that the corner
    /// cuts off (Wachspress 1975): no division but by the sum, so that sides are no exception.
    fn wachspress(&self, point: DVec2, list: &mut [f64; Self::MOST_CORNERS]) {
        let count = self.points.len();
        let sides = |p: DVec2| {
            let mut sides = [0.0; Self::MOST_CORNERS];
            for (i, side) in sides[..count].iter_mut().enumerate() {
                *side = turn(self.points[i], self.points[(i + 1) % count], p);
            }
            sides
        };
        let middle = self.points.iter().sum::<DVec2>() / count as f64;
        let (from, to) = (sides(middle), sides(point));
        let inside =
            (0..count).filter(|&i| to[i] < 0.0).map(|i| from[i] / (from[i] - to[i])).fold(1.0, f64::min);
        let mut sides = sides(middle.lerp(point, inside));
        sides.iter_mut().for_each(|side| *side = side.max(0.0));
        let mut sum = 0.0;
        for (i, slot) in list[..count].iter_mut().enumerate() {
            let others = (0..count).filter(|&j| j != i && (j + 1) % count != i);
            *slot = others.map(|j| sides[j]).product::<f64>() * self.bulge(i);
            sum += *slot;
        }
        list.iter_mut().for_each(|slot| *slot /= sum);
    }

    /// Twice the area of the triangle of a corner and its neighbours.
    fn bulge(&self, i: usize) -> f64 {
        let count = self.points.len();
        turn(self.points[(i + count - 1) % count], self.points[i], self.points[(i + 1) % count])
    }

    /// How far a point is inside: the least distance to the line of a side, times its length; negative outside.
    pub(crate) fn depth(&self, point: DVec2) -> f64 {
        let count = self.points.len();
        (0..count)
            .map(|i| turn(self.points[i], self.points[(i + 1) % count], point))
            .fold(f64::INFINITY, f64::min)
    }

    /// Whether all cells lie in it, apart but for shared corners and sides.
    fn fit(&self, maps: &[Affine2], tolerance: f64) -> bool {
        let held = |point: DVec2| self.depth(point) >= -tolerance * self.points[0].distance(self.points[1]);
        if !maps.iter().all(|map| map.inverse().is_some() && self.points.iter().all(|&p| held(map.apply(p))))
        {
            return false;
        }
        let cells: Vec<Cell> = maps.iter().map(|map| self.cell(*map)).collect();
        let levels = PARTS_A_SIDE.ilog(maps.len().clamp(2, PARTS_A_SIDE)) as usize;
        (0..cells.len()).all(|i| (0..i).all(|j| self.meet(&cells[i], &cells[j], maps, tolerance, levels)))
    }

    fn cell(&self, map: Affine2) -> Cell {
        let corners: Vec<DVec2> = self.points.iter().map(|&p| map.apply(p)).collect();
        let low = corners.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = corners.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        Cell { map, corners, low, high }
    }

    /// Whether two cells do not overlap, and every corner of one that lies in the other is a corner there too; and so
    /// for some levels of their parts.
    fn meet(&self, one: &Cell, other: &Cell, maps: &[Affine2], tolerance: f64, levels: usize) -> bool {
        if one.apart(other, tolerance) {
            return true;
        }
        if overlap(&one.corners, &other.corners, tolerance) {
            return false;
        }
        let Some(touches) = self.shared(one, other, tolerance).zip(self.shared(other, one, tolerance)) else {
            return false;
        };
        // What touches in a corner goes on to do so; sides may be cut differently.
        if touches.0 < 2 || levels == 0 {
            return true;
        }
        let parts = |cell: &Cell, beside: &Cell| -> Vec<Cell> {
            let parts = maps.iter().map(|map| self.cell(cell.map * *map));
            parts.filter(|part| !part.apart(beside, tolerance)).collect()
        };
        let (ones, others) = (parts(one, other), parts(other, one));
        ones.iter().all(|one| others.iter().all(|other| self.meet(one, other, maps, tolerance, levels - 1)))
    }

    /// How many corners of one cell lie in another; `None` if they are no corners there.
    fn shared(&self, one: &Cell, other: &Cell, tolerance: f64) -> Option<usize> {
        let count = self.points.len();
        let sign = other.map.determinant().signum();
        let mut touches = 0;
        for &corner in &one.corners {
            let held = (0..count).all(|i| {
                let (a, b) = (other.corners[i], other.corners[(i + 1) % count]);
                sign * turn(a, b, corner) >= -tolerance * a.distance(b)
            });
            if held {
                let nearest = other.corners.iter().map(|p| p.distance(corner)).fold(f64::INFINITY, f64::min);
                if nearest > 4.0 * tolerance {
                    return None;
                }
                touches += 1;
            }
        }
        Some(touches)
    }
}

/// The image of the polygon under a map, and its box.
struct Cell {
    map: Affine2,
    corners: Vec<DVec2>,
    low: DVec2,
    high: DVec2,
}

impl Cell {
    /// Whether the boxes are.
    fn apart(&self, other: &Self, tolerance: f64) -> bool {
        let room = DVec2::splat(tolerance);
        (self.low - other.high).cmpgt(room).any() || (other.low - self.high).cmpgt(room).any()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(parts: usize, without: Option<usize>) -> Vec<Affine2> {
        let s = 1.0 / parts as f64;
        (0..parts * parts)
            .filter(|&i| Some(i) != without)
            .map(|i| Affine2::similitude(s, 0.0, DVec2::new((i % parts) as f64 * s, (i / parts) as f64 * s)))
            .collect()
    }

    fn gasket(scale: f64) -> Vec<Affine2> {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.5, 0.8)];
        corners.map(|c| Affine2::similitude(scale, 0.0, c * (1.0 - scale))).to_vec()
    }

    /// Pieces at the corners of a polygon that just touch.
    fn polygon(sides: u32) -> Vec<Affine2> {
        let angle = std::f64::consts::TAU / f64::from(sides);
        let sum: f64 = (1..=sides / 4).map(|k| (angle * f64::from(k)).cos()).sum();
        let r = 1.0 / (2.0 * (1.0 + sum));
        let corner = |i| DVec2::from_angle(0.3 + angle * f64::from(i));
        (0..sides).map(|i| Affine2::similitude(r, 0.0, corner(i) * (1.0 - r))).collect()
    }

    #[test]
    fn gaskets_squares_and_carpets_have_corners() {
        assert_eq!(Corners::find(&gasket(0.5)).unwrap().points().len(), 3);
        assert_eq!(
            Corners::find(&square(2, Some(0))).unwrap().points().len(),
            3,
            "three quarters are a gasket"
        );
        for maps in [square(2, None), square(3, None), square(3, Some(4)), square(4, None)] {
            assert_eq!(Corners::find(&maps).unwrap().points().len(), 4);
        }
        for sides in 5..=8 {
            assert_eq!(Corners::find(&polygon(sides)).unwrap().points().len(), sides as usize, "{sides}");
        }
        assert_eq!(Corners::find(&polygon(9)), None, "more corners than are looked for");
    }

    #[test]
    fn overlapping_apart_and_turned_ones_have_none() {
        assert_eq!(Corners::find(&gasket(0.55)), None);
        let twindragon = [[0.5, 0.5, -0.5, 0.5, -0.5, 0.375], [0.5, 0.5, -0.5, 0.5, 0.5, 0.625]];
        assert_eq!(Corners::find(&twindragon.map(Affine2::from_row)), None);
        assert_eq!(Corners::find(&[]), None);
        assert_eq!(Corners::find(&vec![Affine2::IDENTITY; 5]), None);
        assert_eq!(Corners::find(&vec![Affine2::similitude(0.5, 0.0, DVec2::X); 64]), None);
        assert_eq!(Corners::find(&[gasket(0.5), gasket(0.5)].concat()), None, "doubled");
        // Two halves of a square, cut across and along: a corner of one would lie on a side of the other.
        let rows =
            [[0.5, 0.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.5, 0.0], [1.0, 0.0, 0.0, 0.5, 0.0, 0.5]];
        assert_eq!(Corners::find(&rows.map(Affine2::from_row)), None);
    }

    #[test]
    fn weights_give_back_the_point() {
        for maps in [gasket(0.5), square(3, None), polygon(5), polygon(6), polygon(8)] {
            let corners = Corners::find(&maps).unwrap();
            let points = corners.points();
            let side = points[0].lerp(points[1], 0.3);
            for p in [DVec2::new(0.3, 0.2), points[0], points[2], side, points[0].midpoint(points[1])] {
                let weights = corners.weights(p);
                let again: DVec2 = points.iter().zip(weights).map(|(c, w)| *c * w).sum();
                assert!((again - p).length() < 1e-12, "{p} {again}");
            }
            let weights = corners.weights(side);
            assert!((weights[0] - 0.7).abs() < 1e-12 && weights[2..].iter().all(|w| w.abs() < 1e-12));
            assert!(corners.weights(DVec2::splat(1e9)).iter().all(|w| w.is_finite()));
        }
    }
}
