//! Space.

use glam::{DMat3, DVec3};

use super::{Dim3, Dimension};
use crate::ifs::{ellipsoid, probabilities};
use crate::linear::svd3::{norm3, singular_values3, spectral_radius3};
use crate::morph::options::Kind;
use crate::morph::turn3::{self, Turn3};

impl Dimension for Dim3 {
    type Vector = DVec3;
    type Matrix = DMat3;
    type Row = [f64; 12];
    type Scales = [f64; 3];
    type Turn = Turn3;

    const COORDINATES: usize = 3;
    const ZERO: DVec3 = DVec3::ZERO;
    const IDENTITY: DMat3 = DMat3::IDENTITY;
    const NORM_ERROR: f64 = 1e-13;

    fn row(m: DMat3, t: DVec3) -> [f64; 12] {
        let (x, y, z) = (m.x_axis, m.y_axis, m.z_axis);
        [x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z, t.x, t.y, t.z]
    }

    #[inline]
    fn length(v: DVec3) -> f64 {
        v.length()
    }
    #[inline]
    fn size(v: DVec3) -> f64 {
        v.abs().max_element()
    }

    #[inline]
    fn determinant(m: DMat3) -> f64 {
        m.determinant()
    }

    #[inline]
    fn inverse(m: DMat3) -> DMat3 {
        m.inverse()
    }

    #[inline]
    fn norm(m: DMat3) -> f64 {
        norm3(m)
    }

    fn singular_values(m: DMat3) -> [f64; 3] {
        singular_values3(m)
    }

    fn extreme_scales(m: DMat3) -> (f64, f64) {
        let [largest, _, least] = singular_values3(m);
        (largest, least)
    }

    fn spectral_radius(m: DMat3) -> f64 {
        spectral_radius3(m)
    }

    fn full_determinant(m: DMat3) -> f64 {
        m.determinant()
    }

    fn certain_radius(m: DMat3, _: f64, _: f64) -> f64 {
        spectral_radius3(m)
    }

    fn rounding(linear: &[DMat3], plain: f64, least: f64) -> [DMat3; 2] {
        ellipsoid::best(linear, plain, least)
    }

    fn probabilities(linear: &[DMat3]) -> Vec<f64> {
        probabilities::by_volume(linear)
    }

    fn turning(from: DMat3, to: DMat3, extra: i32) -> (Kind, Turn3, [DMat3; 2]) {
        turn3::between(from, to, extra)
    }

    fn angle(turn: &Turn3) -> f64 {
        turn.angle
    }

    fn turned(turn: &Turn3, _: Kind, u: f64) -> DMat3 {
        turn.at(u)
    }
}
