//! Sums and products without rounding, for the few places where a proof hangs on the last digit.

/// A sum and what rounding took from it (Knuth).
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// A product and what rounding took from it (Dekker); exact for factors between 1e-120 and 1e120.
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let halves = |x: f64| {
        let wide = 134_217_729.0 * x;
        let high = wide - (wide - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a1, a0), (b1, b0)) = (halves(a), halves(b));
    (product, a0 * b0 - (((product - a1 * b1) - a0 * b1) - a1 * b0))
}

/// The sign of a sum of finite numbers, -1, 0 or 1, exactly (Shewchuk's growing expansion).
pub(crate) fn sign_of_sum(terms: &[f64]) -> i32 {
    let mut expansion: Vec<f64> = Vec::with_capacity(terms.len());
    for &term in terms {
        let mut carry = term;
        for part in &mut expansion {
            (carry, *part) = two_sum(carry, *part);
        }
        expansion.push(carry);
    }
    // The parts do not overlap and grow: the last that is not zero outweighs all before it.
    match expansion.iter().rev().find(|part| **part != 0.0) {
        Some(part) if *part > 0.0 => 1,
        Some(_) => -1,
        None => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_keep_what_rounding_takes() {
        let x = 1.0 + f64::EPSILON;
        let (high, low) = two_product(x, x);
        assert_eq!((high, low), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
        assert_eq!(two_product(0.5, 0.25), (0.125, 0.0));
    }

    #[test]
    fn signs_survive_cancellation() {
        let tiny = f64::EPSILON / 4.0;
        assert_eq!(sign_of_sum(&[1.0, tiny, -1.0]), 1);
        assert_eq!(sign_of_sum(&[1.0, -tiny, 1e20, -1.0, -1e20]), -1);
        assert_eq!(sign_of_sum(&[0.1, 0.2, -0.2, -0.1]), 0);
        assert_eq!(sign_of_sum(&[]), 0);
        // 0.1 + 0.2 is not the float 0.3, and on which side is exact.
        assert_eq!(sign_of_sum(&[0.1, 0.2, -0.3]), 1);
    }
}
