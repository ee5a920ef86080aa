//! Small fractions and square roots that a double comes near: 1/3, sqrt(3)/2.

/// The largest denominator of a fraction, and of a number with a root.
const LARGEST_DENOMINATOR: i64 = 1000;
const LARGEST_ROOT_DENOMINATOR: i64 = 48;
/// The largest factor of a root.
const LARGEST_ROOT_FACTOR: f64 = 4.0;

/// The simplest fraction `(p, q)` of small numbers within `off` of `x`, by the continued fraction.
#[must_use]
pub fn simplest_fraction(x: f64, off: f64) -> Option<(i64, i64)> {
    let ((mut p0, mut q0), (mut p1, mut q1)) = ((0_i64, 1_i64), (1_i64, 0_i64));
    let mut rest = x.abs();
    for _ in 0..16 {
        let whole = rest.floor();
        if whole > 1e9 {
            break;
        }
        let (p, q) = (whole as i64 * p1 + p0, whole as i64 * q1 + q0);
        if q > LARGEST_DENOMINATOR || p > 1 << 40 {
            break;
        }
        if (x.abs() - p as f64 / q as f64).abs() <= off {
            return Some((if x < 0.0 { -p } else { p }, q));
        }
        ((p0, q0), (p1, q1)) = ((p1, q1), (p, q));
        rest = 1.0 / (rest - whole);
    }
    None
}

/// `(p, r, q)` with `(p + r sqrt(d)) / q` within `off` of `x`, of the least `q`, then `r`.
#[must_use]
pub fn simplest_root(x: f64, off: f64, d: u8) -> Option<(i64, i64, i64)> {
    let root = f64::from(d).sqrt();
    for q in 1..=LARGEST_ROOT_DENOMINATOR {
        let scaled = x * q as f64;
        for r in 1..=(LARGEST_ROOT_FACTOR * q as f64) as i64 {
            for r in [r, -r] {
                let p = (scaled - r as f64 * root).round();
                let away = (scaled - r as f64 * root - p).abs();
                // The root itself is rounded, too.
                if away <= off * q as f64 + 2.0 * f64::EPSILON * (r as f64).abs() && p.abs() < 1e6 {
                    return Some((p as i64, r, q));
                }
            }
        }
    }
    None
}
