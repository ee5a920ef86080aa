//! How much a map of the plane stretches.

use glam::{DMat2, DVec2};

/// Both singular values of a matrix, the larger first.
///
/// The matrix is split into its part that commutes with rotations and its part that reverses them; the
/// singular values are the sum and the difference of their lengths, which loses no digits.
#[inline]
pub(crate) fn singular_values(m: DMat2) -> (f64, f64) {
    let (a, c, b, d) = (m.x_axis.x, m.x_axis.y, m.y_axis.x, m.y_axis.y);
    let turning = DVec2::new(a + d, c - b).length() / 2.0;
    let reflecting = DVec2::new(a - d, c + b).length() / 2.0;
    (turning + reflecting, (turning - reflecting).abs())
}

/// `a b + c d`, also where the two cancel right but for the last digit (Kahan).
fn sum_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let second = c * d;
    a.mul_add(b, second) + c.mul_add(d, -second)
}

/// The determinant with all its digits, also of flat maps.
pub(crate) fn full_determinant(m: DMat2) -> f64 {
    sum_of_products(m.x_axis.x, m.y_axis.y, -m.x_axis.y, m.y_axis.x)
}

/// The largest absolute value of an eigenvalue.
pub(crate) fn spectral_radius(m: DMat2) -> f64 {
    let half_trace = (m.x_axis.x + m.y_axis.y) / 2.0;
    let half_difference = (m.x_axis.x - m.y_axis.y) / 2.0;
    // This form of the discriminant does not cancel where trace^2 - 4 det would.
    let discriminant = sum_of_products(half_difference, half_difference, m.y_axis.x, m.x_axis.y);
    if discriminant >= 0.0 {
        half_trace.abs() + discriminant.sqrt()
    } else {
        // A pair of conjugate eigenvalues: its absolute value is the root of the determinant.
        half_trace.hypot((-discriminant).sqrt())
    }
}

/// The same of matrices of any size: in units of the largest number, so that the squares of small ones do not vanish.
pub(crate) fn extreme_scales(m: DMat2) -> (f64, f64) {
    let largest = m.to_cols_array().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let unit = largest.max(f64::MIN_POSITIVE);
    let (largest, least) = singular_values(m * (1.0 / unit));
    (largest * unit, least * unit)
}
