//! The control mesh.

use glam::DVec2;
use thiserror::Error;

use crate::bernstein::{MOST_CONTROLS, bernstein, laid_over};

/// A Bézier mesh over a box: displacements at a grid of control points, blended by Bernstein polynomials, degree
/// 3 along both sides for the usual 4 x 4 (Fujimoto et al., section 5.3). Outside the box the polynomial goes on.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    min: DVec2,
    max: DVec2,
    /// 1 over the sides of the box.
    scale: DVec2,
    columns: usize,
    rows: usize,
    displacements: Vec<DVec2>,
}

/// Why there is no such mesh.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshError {
    /// Too few or too many control points.
    #[error("A mesh of {columns} x {rows} control points cannot be made. Give 2 to 16 along each side.")]
    Size {
        /// Control points across.
        columns: usize,
        /// Control points up.
        rows: usize,
    },
    /// Too few or too many control points of space.
    #[error(
        "A lattice of {} x {} x {} control points cannot be made. Give 2 to 6 along each side.",
        .sizes[0], .sizes[1], .sizes[2]
    )]
    Size3 {
        /// Control points along x, y and z.
        sizes: [usize; 3],
    },
    /// Not one displacement for each control point.
    #[error("The mesh needs {wanted} displacements, one for each control point, and got {found}.")]
    Count {
        /// As many as control points.
        wanted: usize,
        /// As many as there were.
        found: usize,
    },
    /// A number is NaN, infinite or beyond 1e100, or the box has no area.
    #[error("The mesh must have finite numbers and a box with an area.")]
    Numbers,
    /// The same in space, or the box has no volume.
    #[error("The lattice must have numbers below 1e100 and a box with a volume. Give it such.")]
    Numbers3,
}

impl MeshError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Size { .. } | Self::Size3 { .. } => "mesh-size",
            Self::Count { .. } => "mesh-count",
            Self::Numbers | Self::Numbers3 => "mesh-numbers",
        }
    }
}

impl Mesh {
    /// The most control points along a side: Bernstein polynomials of a higher degree hardly feel one point.
    pub const LARGEST: usize = MOST_CONTROLS;

    /// A mesh over the box from `min` to `max`; `displacements` row by row from the bottom, in units of the plane.
    ///
    /// # Errors
    /// [`MeshError`].
    pub fn new(
        min: DVec2,
        max: DVec2,
        columns: usize,
        rows: usize,
        displacements: Vec<DVec2>,
    ) -> Result<Self, MeshError> {
        let side = 2..=Self::LARGEST;
        if !side.contains(&columns) || !side.contains(&rows) {
            return Err(MeshError::Size { columns, rows });
        }
        let (wanted, found) = (columns * rows, displacements.len());
        if wanted != found {
            return Err(MeshError::Count { wanted, found });
        }
        let fits = |p: &DVec2| p.x.abs() < 1e100 && p.y.abs() < 1e100;
        let size = max - min;
        if !(fits(&min) && fits(&max) && displacements.iter().all(fits) && size.x > 0.0 && size.y > 0.0) {
            return Err(MeshError::Numbers);
        }
        Ok(Self { min, max, scale: size.recip(), columns, rows, displacements })
    }

    /// The same mesh with other displacements.
    ///
    /// # Errors
    /// [`MeshError::Count`] and [`MeshError::Numbers`].
    pub fn moved(&self, displacements: &[DVec2]) -> Result<Self, MeshError> {
        Self::new(self.min, self.max, self.columns, self.rows, displacements.to_vec())
    }

    /// A mesh that leaves everything where it is.
    ///
    /// # Errors
    /// [`MeshError::Size`] and [`MeshError::Numbers`].
    pub fn at_rest(min: DVec2, max: DVec2, columns: usize, rows: usize) -> Result<Self, MeshError> {
        let count = columns.saturating_mul(rows).min(Self::LARGEST * Self::LARGEST);
        Self::new(min, max, columns, rows, vec![DVec2::ZERO; count])
    }

    /// Its box, lower left and upper right.
    #[must_use]
    pub const fn bounds(&self) -> (DVec2, DVec2) {
        (self.min, self.max)
    }

    /// Control points across.
    #[must_use]
    pub const fn columns(&self) -> usize {
        self.columns
    }

    /// Control points up.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.rows
    }

    /// The displacements, row by row from the bottom.
    #[must_use]
    pub fn displacements(&self) -> &[DVec2] {
        &self.displacements
    }

    /// Where control point `i` lies while it is at rest.
    #[must_use]
    pub fn rest(&self, i: usize) -> DVec2 {
        let place = DVec2::new((i % self.columns) as f64, (i / self.columns) as f64);
        let steps = DVec2::new((self.columns - 1) as f64, (self.rows - 1) as f64);
        self.min + (self.max - self.min) * place / steps
    }

    /// The displacement F_v at a point (Fujimoto et al., eq 14).
    #[inline]
    #[must_use]
    pub fn at(&self, point: DVec2) -> DVec2 {
        if let Some(list) = self.displacements.as_array::<16>().filter(|_| self.columns == 4) {
            // The usual mesh, looked at by the million.
            let place = (point - self.min) * self.scale;
            let (across, up) = (cubic(place.x), cubic(place.y));
            let row = |j: usize| {
                list[4 * j] * across[0]
                    + list[4 * j + 1] * across[1]
                    + list[4 * j + 2] * across[2]
                    + list[4 * j + 3] * across[3]
            };
            return row(0) * up[0] + row(1) * up[1] + row(2) * up[2] + row(3) * up[3];
        }
        let mut sum = DVec2::ZERO;
        self.blend(point, |i, weight| sum += self.displacements[i] * weight);
        sum
    }

    /// How much each control point moves a point: their displacements, weighted so, sum to [`Mesh::at`]. The
    /// weights sum to 1.
    pub fn blend(&self, point: DVec2, mut visit: impl FnMut(usize, f64)) {
        let place = (point - self.min) * self.scale;
        let (across, up) = (bernstein(place.x, self.columns), bernstein(place.y, self.rows));
        for (row, &y) in up[..self.rows].iter().enumerate() {
            for (column, &x) in across[..self.columns].iter().enumerate() {
                visit(row * self.columns + column, x * y);
            }
        }
    }

    /// No displacement between two points, the lower left and the upper right of a box, is longer: the longest
    /// displacement of a control point, were the same mesh laid over that box.
    #[must_use]
    pub fn reach(&self, low: DVec2, high: DVec2) -> f64 {
        let (from, to) = ((low - self.min) * self.scale, (high - self.min) * self.scale);
        let rows = self.displacements.chunks_exact(self.columns);
        let across: Vec<Vec<DVec2>> = rows.map(|row| laid_over(row, from.x, to.x)).collect();
        let column = |i: usize| across.iter().map(|row| row[i]).collect::<Vec<_>>();
        let all = (0..self.columns).flat_map(|i| laid_over(&column(i), from.y, to.y));
        let longest = all.map(|d| d.length()).fold(0.0, f64::max);
        // Rounding must not make it too short.
        longest * (1.0 + 1e-9)
    }

    /// No second derivative of the displacement, along any line inside the box, is larger: by the second differences of
    /// the control points, of which the derivatives are weighted means.
    pub(crate) fn curvature(&self) -> f64 {
        let d = |i: usize, j: usize| self.displacements[j * self.columns + i];
        let (columns, rows) = (self.columns, self.rows);
        let largest = |across: usize, up: usize, difference: &dyn Fn(usize, usize) -> DVec2| {
            let places = (0..columns - across).flat_map(|i| (0..rows - up).map(move |j| (i, j)));
            places.map(|(i, j)| difference(i, j).length()).fold(0.0, f64::max)
        };
        let twice = |count: usize| ((count - 1) * (count - 2)) as f64;
        let mut sum = 0.0;
        if columns > 2 {
            let most = largest(2, 0, &|i, j| d(i, j) - 2.0 * d(i + 1, j) + d(i + 2, j));
            sum += twice(columns) * most * self.scale.x * self.scale.x;
        }
        if rows > 2 {
            let most = largest(0, 2, &|i, j| d(i, j) - 2.0 * d(i, j + 1) + d(i, j + 2));
            sum += twice(rows) * most * self.scale.y * self.scale.y;
        }
        let most = largest(1, 1, &|i, j| d(i, j) - d(i + 1, j) - d(i, j + 1) + d(i + 1, j + 1));
        sum + ((columns - 1) * (rows - 1)) as f64 * most * self.scale.x * self.scale.y
    }

    /// The display grid: `count` x `count` points at equal steps over the box, each where the mesh takes it, row
    /// by row from the bottom (the paper draws 11 x 11).
    #[must_use]
    pub fn grid(&self, count: usize) -> Vec<DVec2> {
        let steps = count.max(2) - 1;
        let at = |i: usize, j: usize| {
            let place = DVec2::new(i as f64, j as f64) / steps as f64;
            let point = self.min + (self.max - self.min) * place;
            point + self.at(point)
        };
        (0..count).flat_map(|j| (0..count).map(move |i| (i, j))).map(|(i, j)| at(i, j)).collect()
    }
}

/// [`bernstein`] of degree 3.
#[inline]
fn cubic(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    let (ss, tt) = (s * s, t * t);
    [ss * s, 3.0 * ss * t, 3.0 * s * tt, tt * t]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn any_mesh() -> impl Strategy<Value = Mesh> {
        (2..=7_usize, 2..=7_usize).prop_flat_map(|(columns, rows)| {
            proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), columns * rows).prop_map(move |list| {
                let list = list.into_iter().map(DVec2::from).collect();
                Mesh::new(DVec2::new(-3.0, 0.0), DVec2::new(3.0, 10.0), columns, rows, list).unwrap()
            })
        })
    }

    proptest! {
        #[test]
        fn corners_are_met_and_weights_sum_to_one(mesh in any_mesh(), x in -4.0..4.0_f64, y in -1.0..11.0_f64) {
            let (min, max) = mesh.bounds();
            let (columns, last) = (mesh.columns(), mesh.displacements().len() - 1);
            for (point, i) in [
                (min, 0), (max, last), (DVec2::new(max.x, min.y), columns - 1), (DVec2::new(min.x, max.y), last + 1 - columns),
            ] {
                prop_assert!((mesh.at(point) - mesh.displacements()[i]).length() < 1e-12);
                prop_assert!((mesh.rest(i) - point).length() < 1e-12);
            }
            let mut sum = 0.0;
            mesh.blend(DVec2::new(x, y), |_, weight| sum += weight);
            prop_assert!((sum - 1.0).abs() < 1e-9);
        }

        #[test]
        fn a_mesh_that_turns_affinely_is_affine(columns in 2..=16_usize, rows in 2..=16_usize, x in 0.0..1.0_f64, y in 0.0..1.0_f64) {
            let rest = Mesh::at_rest(DVec2::ZERO, DVec2::ONE, columns, rows).unwrap();
            let affine = |p: DVec2| DVec2::new(0.3 * p.x - 0.2 * p.y + 1.0, 0.5 * p.x + p.y);
            let list = (0..columns * rows).map(|i| affine(rest.rest(i))).collect();
            let mesh = Mesh::new(DVec2::ZERO, DVec2::ONE, columns, rows, list).unwrap();
            let p = DVec2::new(x, y);
            prop_assert!((mesh.at(p) - affine(p)).length() < 1e-12);
        }
    }

    #[test]
    fn bad_meshes_are_refused() {
        let rest =
            |columns, rows| Mesh::at_rest(DVec2::ZERO, DVec2::ONE, columns, rows).map_err(|e| e.code());
        assert_eq!(rest(1, 4), Err("mesh-size"));
        assert_eq!(rest(4, usize::MAX), Err("mesh-size"));
        assert!(rest(16, 16).is_ok());
        let new =
            |max: DVec2, list: Vec<DVec2>| Mesh::new(DVec2::ZERO, max, 2, 2, list).map_err(|e| e.code());
        assert_eq!(new(DVec2::ONE, vec![DVec2::ZERO; 3]), Err("mesh-count"));
        assert_eq!(new(DVec2::ONE, vec![DVec2::NAN; 4]), Err("mesh-numbers"));
        assert_eq!(new(DVec2::X, vec![DVec2::ZERO; 4]), Err("mesh-numbers"));
        assert_eq!(new(DVec2::INFINITY, vec![DVec2::ZERO; 4]), Err("mesh-numbers"));
    }

    #[test]
    fn the_grid_follows_the_mesh() {
        let list = vec![DVec2::ZERO, DVec2::ZERO, DVec2::ZERO, DVec2::ONE];
        let mesh = Mesh::new(DVec2::ZERO, DVec2::ONE, 2, 2, list).unwrap();
        let grid = mesh.grid(3);
        assert_eq!(grid.len(), 9);
        assert_eq!((grid[0], grid[4], grid[8]), (DVec2::ZERO, DVec2::splat(0.75), DVec2::splat(2.0)));
    }

    #[test]
    fn curvature_bounds_how_far_the_middle_of_a_line_is_off() {
        for (columns, rows) in [(2, 2), (4, 4), (3, 7), (16, 2)] {
            let list =
                (0..columns * rows).map(|i| DVec2::new((i * 7 % 11) as f64, (i * 5 % 13) as f64) * 0.1);
            let mesh = Mesh::new(DVec2::ZERO, DVec2::new(2.0, 0.5), columns, rows, list.collect()).unwrap();
            let (curvature, mut nearest) = (mesh.curvature(), 0.0_f64);
            for i in 0..400_u32 {
                let place = |salt: u32| {
                    let unit = |k| frond_core::hash::unit(frond_core::hash::counter(i, 2 * salt + k));
                    DVec2::new(2.0 * f64::from(unit(0)), 0.5 * f64::from(unit(1)))
                };
                let a = place(0);
                let b = a.lerp(place(1), 0.02);
                let off = mesh.at(a.midpoint(b)).distance(mesh.at(a).midpoint(mesh.at(b)));
                nearest = nearest.max(off / (0.125 * curvature * a.distance_squared(b)));
            }
            assert!(nearest <= 1.0 + 1e-6, "{columns} {rows}: {nearest}");
            assert!(nearest > 0.02, "{columns} {rows}: {nearest}");
        }
    }
}
