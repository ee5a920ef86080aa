//! How much a map of space stretches.

use glam::{DMat3, DVec3};

/// The three singular values of a matrix, the largest first.
///
/// Columns are turned in pairs until they are at right angles (Hestenes 1958): nothing is squared, so that small values
/// beside large ones keep their digits.
pub(crate) fn singular_values3(m: DMat3) -> [f64; 3] {
    let size = m.to_cols_array().into_iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if size == 0.0 || !size.is_finite() {
        return [size; 3];
    }
    let mut columns = [m.x_axis / size, m.y_axis / size, m.z_axis / size];
    for _ in 0..30 {
        let mut turned = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let (x, y) = (columns[p], columns[q]);
            let (xx, xy, yy) = (x.length_squared(), x.dot(y), y.length_squared());
            if xy == 0.0 || xy.abs() <= 1e-16 * (xx * yy).sqrt() {
                continue;
            }
            turned = true;
            let tau = (yy - xx) / (2.0 * xy);
            let t = if tau == 0.0 { 1.0 } else { tau.signum() / (tau.abs() + tau.hypot(1.0)) };
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            columns[p] = x * c - y * s;
            columns[q] = x * s + y * c;
        }
        if !turned {
            break;
        }
    }
    // In units of its own largest number, so that the squares of small ones do not vanish.
    let length = |column: DVec3| {
        let unit = column.abs().max_element();
        if unit > 0.0 { (column / unit).length() * unit * size } else { 0.0 }
    };
    let mut values = columns.map(length);
    values.sort_by(|a, b| b.total_cmp(a));
    values
}

/// The largest singular value, to some 1e-14 of itself: faster than all three.
///
/// It is the root of the largest eigenvalue of `M^T M`, by the cosine formula for the cubic.
#[inline]
pub(crate) fn norm3(m: DMat3) -> f64 {
    let (x, y, z) = (m.x_axis, m.y_axis, m.z_axis);
    let (a, b, c) = (x.length_squared(), y.length_squared(), z.length_squared());
    let (d, e, f) = (x.dot(y), x.dot(z), y.dot(z));
    let mean = (a + b + c) / 3.0;
    let (a, b, c) = (a - mean, b - mean, c - mean);
    let spread = ((a * a + b * b + c * c + 2.0 * (d * d + e * e + f * f)) / 6.0).sqrt();
    if spread <= 1e-16 * mean || mean.is_nan() {
        return mean.sqrt();
    }
    let (a, b, c, d, e, f) = (a / spread, b / spread, c / spread, d / spread, e / spread, f / spread);
    let half = 0.5 * (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e));
    let largest = mean + 2.0 * spread * (half.clamp(-1.0, 1.0).acos() / 3.0).cos();
    largest.max(0.0).sqrt()
}

/// The largest absolute value of an eigenvalue: the root of order 2^k of the norm of the power 2^k (Gelfand 1941).
pub(crate) fn spectral_radius3(m: DMat3) -> f64 {
    let largest = |m: DMat3| m.to_cols_array().into_iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let mut power = m;
    let (mut logarithm, mut share) = (0.0, 1.0);
    for _ in 0..48 {
        let size = largest(power);
        if !size.is_finite() {
            return size;
        }
        if size == 0.0 {
            return 0.0;
        }
        logarithm += share * size.ln();
        power *= 1.0 / size;
        power *= power;
        share *= 0.5;
    }
    logarithm.exp()
}

#[cfg(test)]
mod tests {
    use glam::DQuat;
    use proptest::prelude::*;

    use super::*;

    fn matrix() -> impl Strategy<Value = DMat3> {
        let entry = prop_oneof![4 => -2.0..2.0_f64, 1 => Just(0.0), 1 => Just(1.0)];
        proptest::array::uniform9(entry).prop_map(|m| DMat3::from_cols_array(&m))
    }

    proptest! {
        #[test]
        fn singular_values_are_those_of_the_polynomial(m in matrix()) {
            let [a, b, c] = singular_values3(m);
            prop_assert!(a >= b && b >= c && c >= 0.0);
            prop_assert!((a * b * c - m.determinant().abs()).abs() < 1e-12);
            let squares: f64 = m.to_cols_array().iter().map(|x| x * x).sum();
            prop_assert!((a * a + b * b + c * c - squares).abs() < 1e-12);
            prop_assert!((norm3(m) - a).abs() < 1e-12 * (1.0 + a), "{} {a}", norm3(m));
        }

        #[test]
        fn no_eigenvalue_is_larger_than_the_radius(m in matrix(), by in matrix()) {
            let radius = spectral_radius3(m);
            prop_assert!(radius <= norm3(m) * (1.0 + 1e-9) + 1e-12);
            // Other coordinates change nothing.
            prop_assume!(by.determinant().abs() > 0.1 && radius > 0.05);
            let moved = spectral_radius3(by * m * by.inverse());
            prop_assert!((moved - radius).abs() < 1e-4 * radius, "{moved} {radius}");
        }
    }

    #[test]
    fn known_matrices() {
        let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 1.0)) * 0.7;
        assert!(singular_values3(turn).iter().all(|s| (s - 0.7).abs() < 1e-15));
        assert!((spectral_radius3(turn) - 0.7).abs() < 1e-13);
        assert!((norm3(turn) - 0.7).abs() < 1e-14);
        let flat = DMat3::from_diagonal(DVec3::new(1.0, 1e-9, 0.0));
        assert_eq!(singular_values3(flat), [1.0, 1e-9, 0.0]);
        let nilpotent = DMat3::from_cols_array(&[0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 1.0, 7.0, 0.0]);
        assert_eq!(spectral_radius3(nilpotent), 0.0);
        let jordan = DMat3::from_cols_array(&[0.5, 0.0, 0.0, 9.0, 0.5, 0.0, 0.0, 9.0, 0.5]);
        assert!((spectral_radius3(jordan) - 0.5).abs() < 1e-10);
        assert_eq!(spectral_radius3(DMat3::ZERO), 0.0);
        assert!(norm3(DMat3::from_diagonal(DVec3::splat(f64::NAN))).is_nan());
    }
}
