//! The plane.

use glam::{DMat2, DVec2};

use super::{Dim2, Dimension};
use crate::ifs::{ellipse, probabilities};
use crate::linear::svd2::{extreme_scales, full_determinant, singular_values, spectral_radius};
use crate::morph::options::Kind;
use crate::morph::turn2;

impl Dimension for Dim2 {
    type Vector = DVec2;
    type Matrix = DMat2;
    type Row = [f64; 6];
    type Scales = [f64; 2];
    type Turn = (f64, f64);

    const COORDINATES: usize = 2;
    const ZERO: DVec2 = DVec2::ZERO;
    const IDENTITY: DMat2 = DMat2::IDENTITY;
    const NORM_ERROR: f64 = 1e-14;

    fn row(m: DMat2, t: DVec2) -> [f64; 6] {
        [m.x_axis.x, m.y_axis.x, m.x_axis.y, m.y_axis.y, t.x, t.y]
    }

    #[inline]
    fn length(v: DVec2) -> f64 {
        v.length()
    }
    #[inline]
    fn size(v: DVec2) -> f64 {
        v.abs().max_element()
    }

    #[inline]
    fn determinant(m: DMat2) -> f64 {
        m.determinant()
    }

    #[inline]
    fn inverse(m: DMat2) -> DMat2 {
        m.inverse()
    }

    #[inline]
    fn norm(m: DMat2) -> f64 {
        singular_values(m).0
    }

    #[inline]
    fn singular_values(m: DMat2) -> [f64; 2] {
        singular_values(m).into()
    }

    fn extreme_scales(m: DMat2) -> (f64, f64) {
        extreme_scales(m)
    }

    fn spectral_radius(m: DMat2) -> f64 {
        spectral_radius(m)
    }

    fn full_determinant(m: DMat2) -> f64 {
        full_determinant(m)
    }

    fn certain_radius(m: DMat2, determinant: f64, off: f64) -> f64 {
        let half_trace = (0.5 * (m.x_axis.x + m.y_axis.y).abs() - off).max(0.0);
        let discriminant = half_trace * half_trace - determinant;
        if discriminant >= 0.0 { half_trace + discriminant.sqrt() } else { determinant.sqrt() }
    }

    fn rounding(linear: &[DMat2], plain: f64, _: f64) -> [DMat2; 2] {
        ellipse::best(linear, plain)
    }

    fn probabilities(linear: &[DMat2]) -> Vec<f64> {
        probabilities::by_area(linear)
    }

    fn turning(from: DMat2, to: DMat2, extra: i32) -> (Kind, (f64, f64), [DMat2; 2]) {
        turn2::between(from, to, extra)
    }

    fn angle(&(_, turn): &(f64, f64)) -> f64 {
        turn
    }

    #[inline]
    fn turned(turn: &(f64, f64), kind: Kind, u: f64) -> DMat2 {
        turn2::at(turn, kind, u)
    }
}
