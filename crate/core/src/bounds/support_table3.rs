//! Support values of an attractor of space.

use glam::{DMat3, DVec3};

use crate::linear::affine::Affine3;

/// Bounds of an attractor in all directions, and points of it that lie far in them.
///
/// The support function `h(d) = max { d . x : x in A }` obeys `h(d) = max_i ( h(M_i^T d) + d . t_i )`, and between
/// directions it is convex. So its values on a grid over the six faces of a cube, lowered from those of a ball until
/// they settle, bound it everywhere, each step rounding outward. Beside each direction is a point of the attractor,
/// found by the same recursion from within.
#[derive(Clone, Debug, Default)]
pub struct SupportTable3 {
    /// Cells along an edge of the cube.
    cells: usize,
    directions: Vec<DVec3>,
    support: Vec<f64>,
    points: Vec<DVec3>,
    links: Vec<Link>,
    next: Vec<f64>,
    moved: Vec<DVec3>,
}

/// How the value of a direction follows from four others.
#[derive(Clone, Copy, Debug)]
struct Link {
    low: u32,
    across: f64,
    up: f64,
    scale: f64,
    shift: f64,
    nearest: u32,
}

/// A few times the error of one rounding.
const ULPS: f64 = 8.0 * f64::EPSILON;
/// Most rounds of lowering.
const MOST_ROUNDS: usize = 400;

impl SupportTable3 {
    /// Bounds the attractor of maps that are given in coordinates where it lies in the unit ball around 0, and where
    /// they shrink by `factor` in the long run. `cells` is the fineness: 4 is some 3 in 100 off, 8 some 1 in 100.
    pub fn set(&mut self, maps: &[Affine3], factor: f64, cells: usize, within: f64) {
        self.grid(cells.clamp(1, 64));
        let Self { cells, directions, links, .. } = &mut *self;
        let (cells, count) = (*cells, directions.len());
        links.clear();
        for map in maps {
            let transposed = map.linear.transpose();
            links.extend(directions.iter().map(|&d| link(cells, transposed * d, d.dot(map.translation))));
        }
        self.support.clear();
        self.support.extend(self.directions.iter().map(|d| d.length() * (1.0 + ULPS)));
        let settled = within * (1.0 - factor).max(1e-3);
        for _ in 0..MOST_ROUNDS {
            let mut next = std::mem::take(&mut self.next);
            next.clear();
            next.resize(count, f64::NEG_INFINITY);
            for links in self.links.chunks_exact(count) {
                for (next, link) in next.iter_mut().zip(links) {
                    *next = next.max(self.value(link));
                }
            }
            let mut change = 0.0_f64;
            self.next = next;
            for (old, new) in self.support.iter_mut().zip(&self.next) {
                // Both are bounds.
                change = change.max(*old - new);
                *old = old.min(*new);
            }
            if change <= settled {
                break;
            }
        }
        self.gather(maps, settled);
    }

    /// Finds points from within.
    fn gather(&mut self, maps: &[Affine3], settled: f64) {
        let count = self.directions.len();
        let start = maps.first().and_then(|map| map.fixed_point()).unwrap_or(DVec3::ZERO);
        self.points.clear();
        self.points.resize(count, start);
        for _ in 0..MOST_ROUNDS {
            self.moved.clone_from(&self.points);
            let mut change = 0.0_f64;
            for (d, moved) in self.directions.iter().zip(&mut self.moved).enumerate() {
                let (direction, moved) = moved;
                let mut most = direction.dot(*moved);
                for (map, links) in maps.iter().zip(self.links.chunks_exact(count)) {
                    let point = map.apply(self.points[links[d].nearest as usize]);
                    let along = direction.dot(point);
                    if along > most {
                        change = change.max(along - most);
                        (most, *moved) = (along, point);
                    }
                }
            }
            std::mem::swap(&mut self.points, &mut self.moved);
            if change <= settled {
                break;
            }
        }
    }

    fn grid(&mut self, cells: usize) {
        if self.cells == cells {
            return;
        }
        self.cells = cells;
        self.directions.clear();
        for face in 0..6 {
            for j in 0..=cells {
                for i in 0..=cells {
                    let place = |k: usize| (2 * k) as f64 / cells as f64 - 1.0;
                    self.directions.push(on_face(face, place(i), place(j)));
                }
            }
        }
    }

    #[inline]
    fn value(&self, link: &Link) -> f64 {
        let (low, row) = (link.low as usize, self.cells + 1);
        let h = &self.support;
        let (a, b) = (h[low] + link.across * (h[low + 1] - h[low]), {
            let low = low + row;
            h[low] + link.across * (h[low + 1] - h[low])
        });
        let value = link.scale * (a + link.up * (b - a));
        value + link.shift + ULPS * (value.abs() + link.shift.abs() + link.scale)
    }

    /// An upper bound of `direction . x` over the attractor, for a direction of any length.
    #[inline]
    #[must_use]
    pub fn support(&self, direction: DVec3) -> f64 {
        self.value(&link(self.cells, direction, 0.0))
    }

    /// A point of the attractor that lies far in this direction.
    #[inline]
    #[must_use]
    pub fn point(&self, direction: DVec3) -> DVec3 {
        self.points[link(self.cells, direction, 0.0).nearest as usize]
    }

    /// An upper bound of `direction . x` over the attractor, and a point of it that lies far in this direction.
    #[inline]
    #[must_use]
    pub fn support_and_point(&self, direction: DVec3) -> (f64, DVec3) {
        let link = link(self.cells, direction, 0.0);
        (self.value(&link), self.points[link.nearest as usize])
    }

    /// The points of all directions, some of them more than once.
    #[must_use]
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// An upper bound of the diameter of the image of the attractor under a matrix: the largest width along the
    /// directions of the grid, and what it may be between them.
    #[must_use]
    pub fn diameter(&self, linear: DMat3) -> f64 {
        let width = |d: &DVec3| {
            let pulled = linear.transpose() * *d;
            (self.support(pulled) + self.support(-pulled)) / d.length()
        };
        let widest = self.directions.iter().map(width).fold(0.0, f64::max);
        // No direction is farther than half the diagonal of a cell from one of the grid.
        widest * (std::f64::consts::SQRT_2 / self.cells.max(1) as f64).hypot(1.0)
    }
}

#[inline]
fn on_face(face: usize, a: f64, b: f64) -> DVec3 {
    match face {
        0 => DVec3::new(1.0, a, b),
        1 => DVec3::new(-1.0, a, b),
        2 => DVec3::new(a, 1.0, b),
        3 => DVec3::new(a, -1.0, b),
        4 => DVec3::new(a, b, 1.0),
        _ => DVec3::new(a, b, -1.0),
    }
}

/// Where a direction meets the grid.
#[inline]
fn link(cells: usize, p: DVec3, shift: f64) -> Link {
    let size = p.abs();
    let (face, scale, a, b) = if size.x >= size.y && size.x >= size.z {
        (usize::from(p.x < 0.0), size.x, p.y, p.z)
    } else if size.y >= size.z {
        (2 + usize::from(p.y < 0.0), size.y, p.x, p.z)
    } else {
        (4 + usize::from(p.z < 0.0), size.z, p.x, p.y)
    };
    let row = cells + 1;
    let part = |x: f64| {
        let x = if scale > 0.0 { (x / scale + 1.0) * 0.5 * cells as f64 } else { 0.0 };
        let low = (x as usize).min(cells - 1);
        (low, (x - low as f64).clamp(0.0, 1.0))
    };
    let ((i, across), (j, up)) = (part(a), part(b));
    let low = face * row * row + j * row + i;
    let nearest = low + usize::from(across > 0.5) + if up > 0.5 { row } else { 0 };
    Link { low: low as u32, across, up, scale, shift, nearest: nearest as u32 }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing3::{any_ifs3, orbit3, round};

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(64)))]
        #[test]
        fn no_point_lies_beyond_and_some_come_near(ifs in any_ifs3()) {
            prop_assume!(ifs.contraction().radius > 1e-6);
            let (maps, factor) = round(&ifs);
            let mut table = SupportTable3::default();
            table.set(&maps, factor, 6, 1e-3);
            let orbit = orbit3(&maps, 3, 3000);
            for d in [DVec3::X, DVec3::new(-0.3, 0.2, 0.9), DVec3::new(2.0, -5.0, 1.0), DVec3::new(0.1, 0.1, -0.1)] {
                let far = orbit.iter().map(|x| x.dot(d)).fold(f64::NEG_INFINITY, f64::max);
                prop_assert!(table.support(d) >= far - 1e-12, "{} {far}", table.support(d));
                let (bound, point) = table.support_and_point(d);
                prop_assert!(bound >= point.dot(d) - 1e-12);
                if factor < 0.6 {
                    prop_assert!(bound - far < 0.2 * d.length(), "{bound} {far}");
                    prop_assert!(far - point.dot(d) < 0.2 * d.length(), "{} {far}", point.dot(d));
                }
            }
            let wide = orbit.iter().step_by(10).flat_map(|a| orbit.iter().step_by(10).map(move |b| a.distance(*b))).fold(0.0, f64::max);
            prop_assert!(table.diameter(DMat3::IDENTITY) >= wide);
        }
    }

    #[test]
    fn a_cube_is_bounded_by_its_own_faces() {
        // Eight halves of the cube from -0.5 to 0.5, in the unit ball.
        let corner = |k: u32| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)) - 0.5;
        let maps: Vec<Affine3> =
            (0..8).map(|k| Affine3::new(DMat3::from_diagonal(DVec3::splat(0.5)), corner(k) * 0.5)).collect();
        let mut table = SupportTable3::default();
        table.set(&maps, 0.5, 4, 1e-6);
        assert!((table.support(DVec3::X) - 0.5).abs() < 1e-5);
        assert!((table.support(DVec3::ONE) - 1.5).abs() < 1e-5);
        assert!((table.support(DVec3::new(0.25, -0.25, 1.0)) - 0.75).abs() < 1e-5);
        assert!(table.point(DVec3::ONE).distance(DVec3::splat(0.5)) < 1e-4);
        let diameter = table.diameter(DMat3::IDENTITY);
        assert!(diameter >= 3.0_f64.sqrt() && diameter < 2.0, "{diameter}");
    }
}
