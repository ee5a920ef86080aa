//! Shapes whose pieces meet in corners.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

/// A triangle or a parallelogram that holds a shape and whose images under the maps meet corner to corner: pieces
/// then share nothing but corners and whole sides, and what is interpolated between corners is continuous.
///
/// The gasket has its triangle, the square and the carpet their square; overlapping shapes, trees and most tilings
/// have none.
#[derive(Clone, Debug, PartialEq)]
pub struct Corners {
    points: Vec<DVec2>,
    /// From the plane to the coordinates of the first corner and the two sides that leave it.
    to_sides: DMat2,
}

/// Maps whose corners are looked for: beyond, there are too many choices of corners.
const MOST_MAPS: usize = 9;
/// Distances below this share of the shape's size are none.
const TOLERANCE: f64 = 1e-9;
/// How many levels of cells are looked at.
const LEVELS: usize = 3;

impl Corners {
    /// The corners of the attractor of `maps`, if it has any that are fixed by a map each.
    #[must_use]
    pub fn find(maps: &[Affine2]) -> Option<Self> {
        if maps.len() > MOST_MAPS {
            return None;
        }
        let fixed: Vec<DVec2> = maps.iter().filter_map(|map| map.fixed_point()).collect();
        for i in 0..fixed.len() {
            for j in i + 1..fixed.len() {
                for k in j + 1..fixed.len() {
                    let (a, b, c) = (fixed[i], fixed[j], fixed[k]);
                    let fourth = |p: DVec2| fixed.iter().any(|q| p.distance(*q) <= TOLERANCE * a.distance(b));
                    let candidates = [
                        vec![a, b, c],
                        if fourth(b + c - a) { vec![a, b, b + c - a, c] } else { Vec::new() },
                        if fourth(a + c - b) { vec![b, a, a + c - b, c] } else { Vec::new() },
                        if fourth(a + b - c) { vec![c, a, a + b - c, b] } else { Vec::new() },
                    ];
                    if let Some(found) =
                        candidates.into_iter().filter_map(Self::of).find(|found| found.fit(maps))
                    {
                        return Some(found);
                    }
                }
            }
        }
        None
    }

    /// The triangle, or the parallelogram in cyclic order.
    fn of(points: Vec<DVec2>) -> Option<Self> {
        let (first, rest) = points.split_first()?;
        let (along, up) = (*rest.first()? - *first, *rest.last()? - *first);
        let sides = DMat2::from_cols(along, up);
        let flat = sides.determinant().abs() <= 1e-6 * (along.length_squared() + up.length_squared());
        (points.len() > 2 && !flat).then(|| Self { to_sides: sides.inverse(), points })
    }

    /// The corners, in cyclic order.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// How much each corner counts at a point: barycentric in a triangle, bilinear in a parallelogram. They sum to 1.
    #[must_use]
    pub fn weights(&self, point: DVec2) -> [f64; 4] {
        let DVec2 { x, y } = self.to_sides * (point - self.points[0]);
        if self.points.len() == 3 {
            [1.0 - x - y, x, y, 0.0]
        } else {
            [(1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y]
        }
    }

    /// Whether a point is in it.
    fn holds(&self, point: DVec2) -> bool {
        let DVec2 { x, y } = self.to_sides * (point - self.points[0]);
        let inside = x >= -TOLERANCE && y >= -TOLERANCE;
        let beyond = if self.points.len() == 3 { x + y } else { x.max(y) };
        inside && beyond <= 1.0 + TOLERANCE
    }

    /// Whether all cells lie in it, and every corner of a cell that lies in another cell is a corner there too.
    fn fit(&self, maps: &[Affine2]) -> bool {
        let mut cells = vec![Affine2::IDENTITY];
        for _ in 0..LEVELS {
            cells = cells.iter().flat_map(|cell| maps.iter().map(move |map| *cell * *map)).collect();
            let corners: Vec<DVec2> =
                cells.iter().flat_map(|cell| self.points.iter().map(move |&p| cell.apply(p))).collect();
            if !corners.iter().all(|&corner| self.holds(corner)) {
                return false;
            }
            for cell in &cells {
                let Some(inverse) = cell.inverse() else { return false };
                let near = corners.iter().map(|&corner| inverse.apply(corner)).filter(|&p| self.holds(p));
                for point in near {
                    let share = self.weights(point).into_iter().fold(0.0, f64::max);
                    if share < 1.0 - 1e-6 {
                        return false;
                    }
                }
            }
        }
        true
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

    #[test]
    fn gaskets_squares_and_carpets_have_corners() {
        assert_eq!(Corners::find(&gasket(0.5)).unwrap().points().len(), 3);
        assert_eq!(
            Corners::find(&square(2, Some(0))).unwrap().points().len(),
            3,
            "three quarters are a gasket"
        );
        for maps in [square(2, None), square(3, None), square(3, Some(4))] {
            assert_eq!(Corners::find(&maps).unwrap().points().len(), 4);
        }
    }

    #[test]
    fn overlapping_apart_and_turned_ones_have_none() {
        assert_eq!(Corners::find(&gasket(0.55)), None);
        let twindragon = [[0.5, 0.5, -0.5, 0.5, -0.5, 0.375], [0.5, 0.5, -0.5, 0.5, 0.5, 0.625]];
        assert_eq!(Corners::find(&twindragon.map(Affine2::from_row)), None);
        assert_eq!(Corners::find(&[]), None);
        assert_eq!(Corners::find(&vec![Affine2::IDENTITY; 5]), None);
        assert_eq!(Corners::find(&square(4, None)), None, "sixteen maps are not looked at");
    }

    #[test]
    fn weights_give_back_the_point() {
        for maps in [gasket(0.5), square(3, None)] {
            let corners = Corners::find(&maps).unwrap();
            let p = DVec2::new(0.3, 0.2);
            let weights = corners.weights(p);
            let again: DVec2 = corners.points().iter().zip(weights).map(|(c, w)| *c * w).sum();
            assert!((again - p).length() < 1e-12);
        }
    }
}
