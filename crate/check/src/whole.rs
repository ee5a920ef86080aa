//! Doubles as whole numbers.

use num_bigint::BigInt;

/// Numbers as whole multiples of one power of two.
pub(crate) struct Whole<const N: usize> {
    /// `2^bits` times each number.
    pub rows: Vec<[BigInt; N]>,
    /// How often each was doubled; never negative.
    pub bits: u64,
}

impl<const N: usize> Whole<N> {
    /// `None` if one is not finite.
    pub fn of(rows: &[[f64; N]]) -> Option<Self> {
        let all = rows.iter().flatten();
        if !all.clone().all(|x| x.is_finite()) {
            return None;
        }
        let lowest = all.filter(|x| **x != 0.0).map(|x| parts(*x).1).min().unwrap_or(0).min(0);
        let rows = rows.iter().map(|row| {
            row.map(|x| {
                let (digits, power) = parts(x);
                if digits == 0 { BigInt::ZERO } else { BigInt::from(digits) << (power - lowest) }
            })
        });
        Some(Self { rows: rows.collect(), bits: lowest.unsigned_abs() })
    }
}

/// A double: a whole number times `2^-bits`.
pub(crate) struct Factor {
    pub digits: BigInt,
    pub bits: u64,
}

impl Factor {
    /// `None` if it is not finite.
    pub fn of(x: f64) -> Option<Self> {
        let Whole { rows, bits } = Whole::of(&[[x]])?;
        let [digits] = rows.into_iter().next()?;
        Some(Self { digits, bits })
    }

    pub fn is_at_least_one(&self) -> bool {
        self.digits >= BigInt::from(1) << self.bits
    }
}

/// The unit in the last place of a double: by so much it may be off where it stands for another number. None for 0.
pub(crate) fn unit(x: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let exponent = x.to_bits() >> 52 & 0x7ff;
    // That of the smallest normal numbers is the smallest double; above, each power of two doubles it.
    if exponent <= 53 {
        f64::from_bits(1 << exponent.saturating_sub(1))
    } else {
        f64::from_bits((exponent - 52) << 52)
    }
}

/// `(m, e)` with `x = m 2^e`, m odd or zero.
fn parts(x: f64) -> (i64, i64) {
    let bits = x.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i64;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    // Below the normal numbers the leading one is not there, and the exponent stays.
    let (digits, power) =
        if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
    if digits == 0 {
        return (0, 0);
    }
    let even = digits.trailing_zeros();
    let digits = digits >> even;
    (if x < 0.0 { -digits } else { digits }, power + i64::from(even))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubles_are_taken_apart_exactly() {
        assert_eq!(parts(0.75), (3, -2));
        assert_eq!(parts(-6.0), (-3, 1));
        assert_eq!(parts(0.0), (0, 0));
        assert_eq!(parts(f64::from_bits(1)), (1, -1074));
        assert_eq!(parts(f64::MIN_POSITIVE), (1, -1022));
        assert_eq!(parts(f64::MAX), ((1 << 53) - 1, 971));
        for x in [0.1, -1.0 / 3.0, 1e-320, 1e300, std::f64::consts::PI] {
            let (digits, power) = parts(x);
            // In two steps, since 2^-1074 alone underflows on the way.
            let half = power / 2;
            assert_eq!(digits as f64 * 2.0_f64.powi(half as i32) * 2.0_f64.powi((power - half) as i32), x);
        }
    }

    #[test]
    fn rows_share_one_power() {
        let whole = Whole::of(&[[0.75, -1.0], [0.0, 4.0]]).unwrap();
        assert_eq!(whole.bits, 2);
        assert_eq!(whole.rows, [[3.into(), (-4).into()], [0.into(), 16.into()]]);
        assert_eq!(Whole::of(&[[8.0]]).unwrap().rows, [[8.into()]]);
        assert!(Whole::of(&[[f64::NAN]]).is_none() && Whole::of(&[[f64::INFINITY]]).is_none());
        assert_eq!(Whole::<2>::of(&[]).unwrap().bits, 0);
    }
}
