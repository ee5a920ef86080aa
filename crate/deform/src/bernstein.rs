//! Bernstein polynomials, which blend control points along one side of a mesh.

use std::ops::{Add, Mul};

/// The most control points along a side.
pub(crate) const MOST_CONTROLS: usize = 16;

/// The Bernstein polynomials of degree `count - 1` at `t`, by de Casteljau's triangle: no cancellation inside
/// [0, 1], and no factorials.
pub(crate) fn bernstein(t: f64, count: usize) -> [f64; MOST_CONTROLS] {
    let mut values = [0.0; MOST_CONTROLS];
    values[0] = 1.0;
    for degree in 1..count {
        let mut carry = 0.0;
        for value in &mut values[..=degree] {
            let here = *value;
            *value = here * (1.0 - t) + carry;
            carry = here * t;
        }
    }
    values
}

/// The control points over another interval of the line that has these over [0, 1]: the blossom (Ramshaw 1987) at `to`
/// so many times, at `from` for the rest.
pub(crate) fn laid_over<V>(line: &[V], from: f64, to: f64) -> Vec<V>
where
    V: Copy + Add<Output = V> + Mul<f64, Output = V>,
{
    let one = |count: usize| {
        let mut points = line.to_vec();
        for step in 1..line.len() {
            let t = if step <= count { to } else { from };
            for i in 0..line.len() - step {
                points[i] = points[i] * (1.0 - t) + points[i + 1] * t;
            }
        }
        points[0]
    };
    (0..line.len()).map(one).collect()
}
