//! Coordinates along the axes in which a shape is about as wide as it is high.
//!
//! A shape may be stretched along an axis a million times. Then the corners of a polygon about it have coordinates that
//! differ as much, and rounding is counted in the longer one. Powers of two along both axes change no digit of the
//! maps: what is found in these coordinates is brought back digit for digit.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

/// A shape is stretched if its sides differ by this power of two.
const LEAST_STRETCH: i32 = 3;
/// Points of the attractor that are looked at.
const MOST_POINTS: usize = 600;
const MOST_ROUNDS: usize = 6;

/// How often x and y are doubled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisScales {
    powers: [i32; 2],
}

/// `x 2^power`; in two steps, since the factor need not be a number.
fn doubled(x: f64, power: i32) -> f64 {
    let half = power / 2;
    x * 2.0_f64.powi(half) * 2.0_f64.powi(power - half)
}

/// The same, if no digit is lost.
fn exactly(x: f64, power: i32) -> Option<f64> {
    let there = doubled(x, power);
    (there.is_finite() && doubled(there, -power) == x).then_some(there)
}

impl AxisScales {
    /// `None` where a shape is not stretched, or is not known to have a size along both axes.
    pub fn of(maps: &[Affine2]) -> Option<Self> {
        let mut points = vec![maps.first()?.fixed_point()?];
        for _ in 0..MOST_ROUNDS {
            if points.len() * maps.len() > MOST_POINTS {
                break;
            }
            points = points.iter().flat_map(|&p| maps.iter().map(move |map| map.apply(p))).collect();
        }
        let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let sides = (high - low).to_array();
        if !sides.iter().all(|side| (f64::MIN_POSITIVE..f64::INFINITY).contains(side)) {
            return None;
        }
        let powers = sides.map(|side| -side.log2().floor() as i32);
        ((powers[0] - powers[1]).abs() >= LEAST_STRETCH).then_some(Self { powers })
    }

    /// The maps in these coordinates.
    pub fn maps(self, maps: &[Affine2]) -> Option<Vec<Affine2>> {
        let [x, y] = self.powers;
        let map = |map: &Affine2| {
            let DMat2 { x_axis, y_axis } = map.linear;
            let first = DVec2::new(x_axis.x, exactly(x_axis.y, y - x)?);
            let second = DVec2::new(exactly(y_axis.x, x - y)?, y_axis.y);
            let shift = DVec2::new(exactly(map.translation.x, x)?, exactly(map.translation.y, y)?);
            Some(Affine2::new(DMat2::from_cols(first, second), shift))
        };
        maps.iter().map(map).collect()
    }

    /// A point of these coordinates, or the sides of a box, in the plane.
    pub fn point(self, p: DVec2) -> Option<DVec2> {
        let [x, y] = self.powers;
        Some(DVec2::new(exactly(p.x, -x)?, exactly(p.y, -y)?))
    }

    /// The normal of a line of these coordinates, in the plane, but for its length.
    pub fn normal(self, n: DVec2) -> Option<DVec2> {
        let [x, y] = self.powers;
        let most = if n.x == 0.0 {
            y
        } else if n.y == 0.0 {
            x
        } else {
            x.max(y)
        };
        Some(DVec2::new(exactly(n.x, x - most)?, exactly(n.y, y - most)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretched_shapes_are_brought_back_digit_for_digit() {
        let (wide, high) = (2.0_f64.powi(40), 2.0_f64.powi(-300));
        let square = [[0.0, 0.0], [0.6, 0.1], [0.1, 0.7]].map(|[e, f]| [0.3, -0.1, 0.2, 0.25, e, f]);
        let stretched = square.map(|[a, b, c, d, e, f]| {
            Affine2::from_row([a, b * (wide / high), c * (high / wide), d, e * wide, f * high])
        });
        let scales = AxisScales::of(&stretched).unwrap();
        assert!(AxisScales::of(&square.map(Affine2::from_row)).is_none());
        let seen = scales.maps(&stretched).unwrap();
        assert!(AxisScales::of(&seen).is_none() && seen.iter().all(|map| map.norm() < 1.0));
        let p = DVec2::new(0.1, -0.3);
        let there = scales.point(p).unwrap();
        // A line keeps its points: n . p is the same for all of them but for one factor.
        let (n, q) = (DVec2::new(0.7, -0.4), DVec2::new(0.5, 0.9));
        let normal = scales.normal(n).unwrap();
        let factor = normal.dot(there) / n.dot(p);
        let other = normal.dot(scales.point(q).unwrap()) / n.dot(q);
        assert!((factor / other - 1.0).abs() < 1e-12 && factor > 0.0);
    }

    #[test]
    fn what_would_lose_a_digit_is_left_as_it_is() {
        let thin = [0.0, 1.0].map(|e| Affine2::from_row([0.3, 1e-300, 0.0, 0.3, e, 1e-300 * (e + 1e-3)]));
        assert!(
            AxisScales::of(&thin).is_none_or(|scales| scales.maps(&thin).is_none_or(|maps| maps.len() == 2))
        );
        assert!(AxisScales::of(&[]).is_none());
        let segment = [0.0, 1.0].map(|e| Affine2::from_row([0.3, 0.0, 0.0, 0.3, e, 0.0]));
        assert!(AxisScales::of(&segment).is_none());
    }
}
