//! Displacements rearranged by a shuffle, point by point: the formulas as they stand.

use frond_core::{Affine, Dim2, Dimension};
use glam::DVec2;

use crate::mesh::Mesh;
use crate::shuffle::code::shuffle;
use crate::shuffle::spin::{Spin, Turning};
use crate::shuffle::weight::weights;

/// A point of an attractor: the piece that a code names, and where in it, as the point `tail` of the whole that
/// the piece's map takes there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<'a, V = DVec2> {
    /// Letters from 0, the largest piece first; at least as many as the deepest shuffle reaches.
    pub code: &'a [u8],
    /// A point of the whole attractor, or near it.
    pub tail: V,
}

/// The displacement function F_v (Fujimoto et al., eq 14), of the plane or of space.
pub trait Displacement {
    /// Where it lives.
    type Dim: Turning;

    /// The displacement at a point.
    fn at(&self, point: <Self::Dim as Dimension>::Vector) -> <Self::Dim as Dimension>::Vector;
}

impl Displacement for Mesh {
    type Dim = Dim2;

    fn at(&self, point: DVec2) -> DVec2 {
        Self::at(self, point)
    }
}

type VectorOf<M> = <<M as Displacement>::Dim as Dimension>::Vector;
type MatrixOf<M> = <<M as Displacement>::Dim as Dimension>::Matrix;

/// Displacements of the points of an attractor, shuffled by their codes. There is no repair of continuity here:
/// the shape tears where kb is 1 or more.
#[derive(Clone, Debug)]
pub struct Field<'a, M: Displacement = Mesh> {
    maps: &'a [Affine<M::Dim>],
    factors: Vec<MatrixOf<M>>,
    mesh: &'a M,
}

impl<'a, M: Displacement> Field<'a, M> {
    /// The displacements of `mesh` on the attractor of `maps`.
    #[must_use]
    pub fn new(maps: &'a [Affine<M::Dim>], mesh: &'a M, spin: Spin) -> Self {
        Self { maps, factors: maps.iter().map(|map| spin.factor(map)).collect(), mesh }
    }

    /// The point's coordinate F_x (Fujimoto et al., eq 9). Letters that no map has are passed over.
    #[must_use]
    pub fn position(&self, place: Place<'_, VectorOf<M>>) -> VectorOf<M> {
        let maps = place.code.iter().rev().filter_map(|&letter| self.maps.get(usize::from(letter)));
        maps.fold(place.tail, |point, map| map.apply(point))
    }

    /// The displacement of one term (Fujimoto et al., eqs 11 and 17): that of the point whose code has the block
    /// kb + 1 .. k reversed, turned by the factors of the letters kb + 1 to k in this order.
    #[must_use]
    pub fn term(&self, kb: usize, k: usize, place: Place<'_, VectorOf<M>>) -> VectorOf<M> {
        let mut moved = place.code.to_vec();
        shuffle(&mut moved, kb, k);
        let from = self.mesh.at(self.position(Place { code: &moved, ..place }));
        let block = place.code.get(kb..k.min(place.code.len())).unwrap_or(&[]);
        let factors = block.iter().rev().filter_map(|&letter| self.factors.get(usize::from(letter)));
        factors.fold(from, |v, factor| *factor * v)
    }

    /// The superposition of the terms kb to ke (Fujimoto et al., eqs 12 and 18).
    #[must_use]
    pub fn superposed(&self, kb: usize, ke: usize, delta: f64, place: Place<'_, VectorOf<M>>) -> VectorOf<M> {
        let list = weights(delta, kb, ke);
        // A term without weight costs nothing: with delta 0 only the first is looked at.
        let terms = list.iter().enumerate().filter(|(_, weight)| **weight > 0.0);
        let terms = terms.map(|(i, weight)| self.term(kb, kb + i, place) * *weight);
        terms.fold(M::Dim::ZERO, |sum, term| sum + term)
    }

    /// [`Field::term`] between whole numbers (Fujimoto et al., eq 19): a bilinear blend of four.
    #[must_use]
    pub fn term_between(&self, kb: f64, ke: f64, place: Place<'_, VectorOf<M>>) -> VectorOf<M> {
        between::<M::Dim>(kb, ke, |kb, ke| self.term(kb, ke, place))
    }

    /// [`Field::superposed`] between whole numbers: a bilinear blend of four sums.
    #[must_use]
    pub fn superposed_between(
        &self,
        kb: f64,
        ke: f64,
        delta: f64,
        place: Place<'_, VectorOf<M>>,
    ) -> VectorOf<M> {
        between::<M::Dim>(kb, ke, |kb, ke| self.superposed(kb, ke, delta, place))
    }
}

/// The deepest letter that is asked for; what is beyond, NaN or negative is taken to the nearest that is not.
const DEEPEST_LETTER: f64 = 64.0;

/// Equation 19. Where `ke` falls below `kb` it is raised to it, which is the identity.
fn between<D: Dimension>(kb: f64, ke: f64, value: impl Fn(usize, usize) -> D::Vector) -> D::Vector {
    let split = |x: f64| {
        let x = if x.is_nan() { 0.0 } else { x.clamp(0.0, DEEPEST_LETTER) };
        (x.floor() as usize, x.fract())
    };
    let ((b, rb), (e, re)) = (split(kb), split(ke));
    let corners = [
        (b, 1.0 - rb, e, 1.0 - re),
        (b, 1.0 - rb, e + 1, re),
        (b + 1, rb, e, 1.0 - re),
        (b + 1, rb, e + 1, re),
    ];
    corners
        .into_iter()
        .filter(|(_, x, _, y)| x * y > 0.0)
        .map(|(b, x, e, y)| value(b, e.max(b)) * (x * y))
        .fold(D::ZERO, |sum, value| sum + value)
}

#[cfg(test)]
mod tests {
    use frond_core::Affine2;

    use super::*;

    fn gasket() -> [Affine2; 3] {
        [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f]))
    }

    fn lift() -> Mesh {
        let list = (0..16).map(|i| DVec2::new(0.1 * f64::from(i), 0.3 - 0.01 * f64::from(i * i))).collect();
        Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, list).unwrap()
    }

    #[test]
    fn the_plain_deformation_is_the_limit() {
        let (maps, mesh) = (gasket(), lift());
        let field = Field::new(&maps, &mesh, Spin::None);
        let place = Place { code: &[0, 2, 1, 1, 0], tail: DVec2::new(0.2, 0.3) };
        let plain = mesh.at(field.position(place));
        assert_eq!(field.superposed(5, 5, 0.75, place), plain);
        assert_eq!(field.term(2, 2, place), plain);
        assert_eq!(field.term(2, 3, place), plain);
        // Without roughness only the first term is left, which is plain.
        assert_eq!(field.superposed(0, 5, 0.0, place), plain);
    }

    #[test]
    fn it_slides_without_a_jump() {
        let (maps, mesh) = (gasket(), lift());
        let field = Field::new(&maps, &mesh, Spin::None);
        let place = Place { code: &[0, 2, 1, 1, 0], tail: DVec2::new(0.2, 0.3) };
        let mut last = field.superposed_between(0.0, 5.0, 0.75, place);
        for i in 1..=500 {
            let next = field.superposed_between(f64::from(i) / 100.0, 5.0, 0.75, place);
            assert!((next - last).length() < 0.02, "{i}");
            last = next;
        }
        assert!((last - mesh.at(field.position(place))).length() < 1e-12);
    }

    #[test]
    fn bad_depths_do_no_harm() {
        let (maps, mesh) = (gasket(), lift());
        let field = Field::new(&maps, &mesh, Spin::Scaled);
        let place = Place { code: &[0, 9, 255], tail: DVec2::ZERO };
        for (kb, ke) in [(f64::NAN, f64::INFINITY), (-1.0, -2.0), (1e300, 3.0), (9.5, 2.5)] {
            assert!(field.superposed_between(kb, ke, 1.0, place).is_finite(), "{kb} {ke}");
        }
        assert!(field.term(7, 2, place).is_finite());
    }
}
