//! Maps in numbers of 24 bits, and how far the exact ones may be from them.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

/// Half of what a sample needs for each map: six coefficients, and how far the exact map may be from them.
///
/// Rows of the matrix, the translation, then bounds of the errors of these two.
pub type SingleMap = [f32; 8];

/// The map whose entries are the sums of those of two.
pub(super) fn sum(a: &Affine2, b: &Affine2) -> Affine2 {
    Affine2::new(a.linear + b.linear, a.translation + b.translation)
}

/// Coordinates that are centred on an attractor and of its size, but for a power of two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    pub centre: DVec2,
    scale: f64,
}

/// What stands for a map that has no place among numbers of 24 bits: its error swallows everything.
const LOST: SingleMap = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e9, 1e9];

impl Unit {
    /// Those of raw maps; any will do where these have no attractor.
    pub fn of(maps: &[Affine2]) -> Self {
        let count = maps.len() as f64;
        let mean = maps.iter().fold(Affine2::new(DMat2::ZERO, DVec2::ZERO), |all, map| sum(&all, map));
        let mean = Affine2::new(mean.linear * (1.0 / count), mean.translation / count);
        let centre = mean.fixed_point().filter(|p| p.is_finite()).unwrap_or(DVec2::ZERO);
        let size = maps.iter().map(|map| map.apply(centre).distance(centre)).fold(0.0, f64::max);
        let known = size > 1e-100 && size < 1e100;
        Self { centre, scale: if known { (-size.log2().round()).exp2() } else { 1.0 } }
    }

    /// A map whose translation is given about the centre, in numbers of 24 bits.
    pub fn rounded(&self, linear: DMat2, shift: DVec2) -> SingleMap {
        let shift = shift * self.scale;
        let exact = [linear.x_axis.x, linear.y_axis.x, linear.x_axis.y, linear.y_axis.y, shift.x, shift.y];
        if !exact.iter().all(|x| x.abs() < 1e6) {
            return LOST;
        }
        let near = exact.map(|x| if x.abs() < 1e-30 { 0.0 } else { x as f32 });
        let off = |i: usize| (exact[i] - f64::from(near[i])).abs() as f32;
        let length =
            |range: std::ops::Range<usize>| range.map(|i| off(i) * off(i)).sum::<f32>().sqrt() * 1.001;
        // What doubles lose themselves, in `shift` more than in the coefficients.
        let slack = 1e-14 * (1.0 + self.centre.length() * self.scale + shift.length());
        [
            near[0],
            near[1],
            near[2],
            near[3],
            near[4],
            near[5],
            length(0..4) + 1e-15,
            length(4..6) + slack as f32,
        ]
    }
}
