//! The control points of space.

use frond_core::Dim3;
use glam::{DMat3, DVec3};

use crate::bernstein::{MOST_CONTROLS, bernstein, laid_over};
use crate::mesh::MeshError;
use crate::shuffle::field::Displacement;

/// A Bézier volume over a box: displacements at a lattice of control points, blended by Bernstein polynomials
/// (Sederberg and Parry 1986), as Fujimoto et al. do with 4 x 4 of them in the plane (section 5.3; for space they print
/// none, so that this is reconstructed). Outside the box the polynomial goes on.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh3 {
    min: DVec3,
    max: DVec3,
    /// 1 over the sides of the box.
    scale: DVec3,
    sizes: [usize; 3],
    displacements: Vec<DVec3>,
}

impl Mesh3 {
    /// The most control points along a side.
    pub const LARGEST: usize = 6;

    /// A mesh over the box from `min` to `max`, of `sizes` control points along x, y and z; `displacements` with x
    /// fastest, then y, in units of space.
    ///
    /// # Errors
    /// [`MeshError`].
    pub fn new(
        min: DVec3,
        max: DVec3,
        sizes: [usize; 3],
        displacements: Vec<DVec3>,
    ) -> Result<Self, MeshError> {
        if !sizes.iter().all(|size| (2..=Self::LARGEST).contains(size)) {
            return Err(MeshError::Size3 { sizes });
        }
        let (wanted, found) = (sizes.iter().product(), displacements.len());
        if wanted != found {
            return Err(MeshError::Count { wanted, found });
        }
        let fits = |p: &DVec3| p.abs().max_element() < 1e100 && p.is_finite();
        let size = max - min;
        if !(fits(&min) && fits(&max) && displacements.iter().all(fits) && size.min_element() > 0.0) {
            return Err(MeshError::Numbers3);
        }
        Ok(Self { min, max, scale: size.recip(), sizes, displacements })
    }

    /// A mesh that leaves everything where it is.
    ///
    /// # Errors
    /// [`MeshError::Size3`] and [`MeshError::Numbers3`].
    pub fn at_rest(min: DVec3, max: DVec3, sizes: [usize; 3]) -> Result<Self, MeshError> {
        let count = sizes.iter().fold(1_usize, |product, size| product.saturating_mul(*size));
        Self::new(min, max, sizes, vec![DVec3::ZERO; count.min(Self::LARGEST.pow(3))])
    }

    /// Its box, the least and the largest coordinates.
    #[must_use]
    pub const fn bounds(&self) -> (DVec3, DVec3) {
        (self.min, self.max)
    }

    /// Control points along x, y and z.
    #[must_use]
    pub const fn sizes(&self) -> [usize; 3] {
        self.sizes
    }

    /// The displacements, x fastest, then y.
    #[must_use]
    pub fn displacements(&self) -> &[DVec3] {
        &self.displacements
    }

    /// Where control point `i` lies while it is at rest.
    #[must_use]
    pub fn rest(&self, i: usize) -> DVec3 {
        let [columns, rows, _] = self.sizes;
        let place = [i % columns, i / columns % rows, i / (columns * rows)].map(|k| k as f64);
        let steps = self.sizes.map(|size| (size - 1) as f64);
        self.min + (self.max - self.min) * DVec3::from_array(place) / DVec3::from_array(steps)
    }

    /// The displacement F_v at a point (Fujimoto et al., eq 14).
    #[must_use]
    pub fn at(&self, point: DVec3) -> DVec3 {
        let place = (point - self.min) * self.scale;
        self.blended([0, 1, 2].map(|axis| bernstein(place[axis], self.sizes[axis])))
    }

    /// [`Mesh3::at`], and how it changes: its derivative along x, y and z, in the columns.
    #[must_use]
    pub fn slope(&self, point: DVec3) -> (DVec3, DMat3) {
        let place = (point - self.min) * self.scale;
        let axes = [0, 1, 2].map(|axis| bernstein(place[axis], self.sizes[axis]));
        let along = |axis: usize| {
            let mut axes = axes;
            axes[axis] = derivative(place[axis], self.sizes[axis]);
            self.blended(axes) * self.scale[axis]
        };
        (self.blended(axes), DMat3::from_cols(along(0), along(1), along(2)))
    }

    fn blended(&self, [across, up, deep]: [[f64; MOST_CONTROLS]; 3]) -> DVec3 {
        let [columns, rows, _] = self.sizes;
        let mut sum = DVec3::ZERO;
        for (layer, z) in self.displacements.chunks_exact(columns * rows).zip(deep) {
            let mut part = DVec3::ZERO;
            for (row, y) in layer.chunks_exact(columns).zip(up) {
                let along = row.iter().zip(across).fold(DVec3::ZERO, |sum, (d, x)| sum + *d * x);
                part += along * y;
            }
            sum += part * z;
        }
        sum
    }

    /// The same displacement, by the control points over another box.
    ///
    /// # Errors
    /// [`MeshError::Numbers3`] where the box is none, or the control points would be beyond all measure.
    pub fn over(&self, low: DVec3, high: DVec3) -> Result<Self, MeshError> {
        let (from, to) = ((low - self.min) * self.scale, (high - self.min) * self.scale);
        let mut list = self.displacements.clone();
        for axis in 0..3 {
            let (stride, count) = (self.sizes[..axis].iter().product::<usize>(), self.sizes[axis]);
            for first in (0..list.len()).filter(|i| i / stride % count == 0) {
                let line: Vec<DVec3> = (0..count).map(|k| list[first + k * stride]).collect();
                for (k, point) in laid_over(&line, from[axis], to[axis]).into_iter().enumerate() {
                    list[first + k * stride] = point;
                }
            }
        }
        Self::new(low, high, self.sizes, list)
    }

    /// No displacement inside the box is longer.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.displacements.iter().map(|d| d.length()).fold(0.0, f64::max) * ROUNDED_UP
    }

    /// Inside the box the displacements of two points differ by no more than this times their distance: by the
    /// differences of neighbouring control points, of which the derivatives are weighted means.
    #[must_use]
    pub fn steepness(&self) -> f64 {
        let axis = |axis: usize| {
            let most = self.differences(&[axis]).map(DVec3::length).fold(0.0, f64::max);
            (self.sizes[axis] - 1) as f64 * self.scale[axis] * most
        };
        (0..3).map(|k| axis(k) * axis(k)).sum::<f64>().sqrt() * ROUNDED_UP
    }

    /// No second derivative of the displacement, along any line inside the box, is larger: by the second differences of
    /// the control points, of which the derivatives are weighted means.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        let mut sum = 0.0;
        for a in 0..3 {
            for b in a..3 {
                let steps = |axis: usize, less: usize| self.sizes[axis].saturating_sub(less) as f64;
                let degree = steps(a, 1) * if a == b { steps(a, 2) } else { steps(b, 1) };
                let most = self.differences(&[a, b]).map(DVec3::length).fold(0.0, f64::max);
                // For a unit vector u, u_a^2 is at most 1, and so is 2 u_a u_b.
                sum += degree * most * self.scale[a] * self.scale[b];
            }
        }
        sum * ROUNDED_UP
    }

    /// The differences of the control points along these axes, one after the other.
    fn differences(&self, axes: &[usize]) -> impl Iterator<Item = DVec3> {
        let (mut list, mut sizes) = (self.displacements.clone(), self.sizes);
        for &axis in axes {
            let (stride, count) = (sizes[..axis].iter().product::<usize>(), sizes[axis]);
            let inner = (0..list.len()).filter(|i| i / stride % count + 1 < count);
            list = inner.map(|i| list[i + stride] - list[i]).collect();
            sizes[axis] = count - 1;
        }
        list.into_iter()
    }
}

impl Displacement for Mesh3 {
    type Dim = Dim3;

    fn at(&self, point: DVec3) -> DVec3 {
        Self::at(self, point)
    }
}

/// Rounding must not make a bound too small.
const ROUNDED_UP: f64 = 1.0 + 1e-9;

/// The derivatives of [`bernstein`].
fn derivative(t: f64, count: usize) -> [f64; MOST_CONTROLS] {
    let lower = bernstein(t, count - 1);
    std::array::from_fn(|i| {
        let before = if i > 0 { lower[i - 1] } else { 0.0 };
        let here = if i + 1 < count { lower[i] } else { 0.0 };
        if i < count { (count - 1) as f64 * (before - here) } else { 0.0 }
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::Mesh;

    const LOW: DVec3 = DVec3::new(-1.0, 0.0, 2.0);
    const HIGH: DVec3 = DVec3::new(1.0, 3.0, 2.5);

    fn any_sizes() -> impl Strategy<Value = [usize; 3]> {
        [2..=Mesh3::LARGEST, 2..=4_usize, 2..=4_usize]
    }

    fn any_mesh() -> impl Strategy<Value = Mesh3> {
        any_sizes().prop_flat_map(|sizes| {
            let count = sizes.iter().product::<usize>();
            proptest::collection::vec([-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64], count).prop_map(
                move |list| {
                    let list = list.into_iter().map(DVec3::from_array).collect();
                    Mesh3::new(LOW, HIGH, sizes, list).unwrap()
                },
            )
        })
    }

    fn any_point() -> impl Strategy<Value = DVec3> {
        [0.0..=1.0_f64, 0.0..=1.0_f64, 0.0..=1.0_f64]
            .prop_map(|place| LOW + (HIGH - LOW) * DVec3::from_array(place))
    }

    proptest! {
        #[test]
        fn corners_are_met_and_bounds_hold(mesh in any_mesh(), a in any_point(), b in any_point()) {
            for (i, corner) in [(0, LOW), (mesh.displacements().len() - 1, HIGH)] {
                prop_assert!((mesh.at(corner) - mesh.displacements()[i]).length() < 1e-12);
                prop_assert!((mesh.rest(i) - corner).length() < 1e-12);
            }
            prop_assert!(mesh.at(a).length() <= mesh.reach());
            prop_assert!((mesh.at(a) - mesh.at(b)).length() <= mesh.steepness() * a.distance(b) + 1e-12);
            // From its tangent it is off by half the second derivative at most.
            let (value, slope) = mesh.slope(a);
            let off = mesh.at(b) - (value + slope * (b - a));
            prop_assert!(off.length() <= 0.5 * mesh.curvature() * a.distance_squared(b) + 1e-12);
            let step = 1e-6 * (b - a);
            let along = (mesh.at(a + step) - mesh.at(a - step)) * 0.5;
            prop_assert!((along - slope * step).length() < 1e-8 * (1.0 + mesh.curvature()));
        }

        #[test]
        fn another_box_changes_nothing(mesh in any_mesh(), a in any_point(), p in any_point()) {
            let over = mesh.over(a - DVec3::ONE, a + DVec3::splat(0.5)).unwrap();
            prop_assert!((over.at(p) - mesh.at(p)).length() < 1e-6 * (1.0 + over.reach()));
        }

        #[test]
        fn a_mesh_that_turns_affinely_is_affine(sizes in any_sizes(), p in any_point()) {
            let rest = Mesh3::at_rest(LOW, HIGH, sizes).unwrap();
            let turn = DMat3::from_cols_array(&[0.3, 0.5, -1.0, -0.2, 1.0, 0.25, 0.0, 2.0, 0.7]);
            let affine = |p: DVec3| turn * p + DVec3::ONE;
            let list = (0..rest.displacements().len()).map(|i| affine(rest.rest(i))).collect();
            let mesh = Mesh3::new(LOW, HIGH, sizes, list).unwrap();
            prop_assert!((mesh.at(p) - affine(p)).length() < 1e-12);
            prop_assert!(mesh.curvature() < 1e-9);
        }

        #[test]
        fn a_mesh_without_change_along_z_is_that_of_the_plane(
            list in proptest::collection::vec([-1.0..1.0_f64, -1.0..1.0_f64], 16), p in any_point(), deep in 2..4_usize,
        ) {
            let flat: Vec<_> = list.into_iter().map(glam::DVec2::from_array).collect();
            let high: Vec<_> = flat.iter().map(|d| d.extend(0.0)).collect();
            let plane = Mesh::new(LOW.truncate(), HIGH.truncate(), 4, 4, flat).unwrap();
            let space = Mesh3::new(LOW, HIGH, [4, 4, deep], high.repeat(deep)).unwrap();
            prop_assert!((space.at(p) - plane.at(p.truncate()).extend(0.0)).length() < 1e-14);
        }
    }

    #[test]
    fn bad_meshes_are_refused() {
        let rest = |sizes| Mesh3::at_rest(LOW, HIGH, sizes).map_err(|e| e.code());
        assert_eq!(rest([1, 4, 4]), Err("mesh-size"));
        assert_eq!(rest([4, 4, usize::MAX]), Err("mesh-size"));
        assert!(rest([6, 6, 6]).is_ok());
        let new = |max: DVec3, list: Vec<DVec3>| Mesh3::new(LOW, max, [2; 3], list).map_err(|e| e.code());
        assert_eq!(new(HIGH, vec![DVec3::ZERO; 7]), Err("mesh-count"));
        for bad in [DVec3::NAN, DVec3::X * f64::INFINITY, DVec3::Y * 1e101] {
            assert_eq!(new(HIGH, vec![bad; 8]), Err("mesh-numbers"));
        }
        for max in [LOW, DVec3::new(1.0, 3.0, 2.0), DVec3::INFINITY, DVec3::NAN] {
            assert_eq!(new(max, vec![DVec3::ZERO; 8]), Err("mesh-numbers"));
        }
    }
}
