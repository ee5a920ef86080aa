//! Intervals of doubles that surely contain what is computed: each end is rounded outwards.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};
use num_traits::ToPrimitive;

/// All numbers from `lower` to `upper`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lower: f64,
    upper: f64,
}

impl Interval {
    /// Zero alone.
    pub const ZERO: Self = Self::point(0.0);
    /// One alone.
    pub const ONE: Self = Self::point(1.0);

    /// One number.
    #[must_use]
    pub const fn point(value: f64) -> Self {
        Self { lower: value, upper: value }
    }

    /// From one number to another. Numbers that are none make it everything.
    #[must_use]
    pub fn new(lower: f64, upper: f64) -> Self {
        if lower <= upper { Self { lower, upper } } else { Self::everything() }
    }

    const fn everything() -> Self {
        Self { lower: f64::NEG_INFINITY, upper: f64::INFINITY }
    }

    /// The doubles around a whole number.
    #[must_use]
    pub fn of_i64(number: i64) -> Self {
        let near = number as f64;
        if number.unsigned_abs() <= 1 << 53 { Self::point(near) } else { Self::point(near).wider() }
    }

    /// The doubles around a long whole number.
    #[must_use]
    pub fn of_large(number: &BigInt) -> Self {
        let shift = number.bits().saturating_sub(52);
        if shift == 0 {
            return Self::point(number.to_f64().unwrap_or(f64::NAN));
        }
        let head = (number.magnitude() >> shift).to_f64().unwrap_or(f64::INFINITY);
        let scale = i32::try_from(shift).map_or(f64::INFINITY, |power| 2f64.powi(power));
        // What is beyond all doubles is at least the last of them.
        let size = Self::new((head * scale).min(f64::MAX), (head + 1.0) * scale);
        if number.sign() == Sign::Minus { -size } else { size }
    }

    fn wider(self) -> Self {
        Self::new(self.lower.next_down(), self.upper.next_up())
    }

    /// The lower end.
    #[must_use]
    pub const fn lower(self) -> f64 {
        self.lower
    }

    /// The upper end.
    #[must_use]
    pub const fn upper(self) -> f64 {
        self.upper
    }

    /// A number near the middle.
    #[must_use]
    pub const fn middle(self) -> f64 {
        self.lower.midpoint(self.upper)
    }

    /// How far the ends are apart.
    #[must_use]
    pub fn width(self) -> f64 {
        self.upper - self.lower
    }

    /// Whether a number lies in it.
    #[must_use]
    pub fn contains(self, value: f64) -> bool {
        self.lower <= value && value <= self.upper
    }

    /// Whether two intervals have a number in common.
    #[must_use]
    pub fn meets(self, other: Self) -> bool {
        self.lower <= other.upper && other.lower <= self.upper
    }

    /// The sizes of its numbers.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.lower >= 0.0 {
            self
        } else if self.upper <= 0.0 {
            -self
        } else {
            Self::new(0.0, self.upper.max(-self.lower))
        }
    }

    /// The squares of its numbers.
    #[must_use]
    pub fn square(self) -> Self {
        let size = self.abs();
        let square = size * size;
        Self::new(square.lower.max(0.0), square.upper)
    }

    /// The roots of its numbers, taken for at least zero.
    #[must_use]
    pub fn sqrt(self) -> Self {
        // The root of a double is rounded correctly everywhere.
        let root = Self::new(self.lower.max(0.0).sqrt(), self.upper.max(0.0).sqrt()).wider();
        Self::new(root.lower.max(0.0), root.upper)
    }

    /// The larger of two numbers of two intervals.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self::new(self.lower.max(other.lower), self.upper.max(other.upper))
    }

    /// The natural logarithms of positive numbers; everything where one is not.
    #[must_use]
    pub fn ln(self) -> Self {
        if self.lower <= 0.0 || !self.upper.is_finite() {
            return Self::everything();
        }
        Self::new(ln(self.lower).lower, ln(self.upper).upper)
    }

    /// The exponentials of its numbers.
    #[must_use]
    pub fn exp(self) -> Self {
        Self::new(exp(self.lower).lower.max(0.0), exp(self.upper).upper)
    }

    /// A power of positive numbers.
    #[must_use]
    pub fn power(self, exponent: Self) -> Self {
        (self.ln() * exponent).exp()
    }
}

/// log 2: the nearest double is below it by 2.3e-17.
fn ln_2() -> Interval {
    Interval::new(std::f64::consts::LN_2, std::f64::consts::LN_2.next_up())
}

/// log x = k log 2 + 2 artanh((m - 1)/(m + 1)) with x = 2^k m, by the series of artanh.
fn ln(x: f64) -> Interval {
    let (mut m, mut k) = (x, 0i32);
    if m < f64::MIN_POSITIVE {
        (m, k) = (m * 2f64.powi(60), -60);
    }
    let exponent = ((m.to_bits() >> 52) & 0x7ff) as i32 - 1023;
    m = f64::from_bits((m.to_bits() & !(0x7ff << 52)) | (1023 << 52));
    k += exponent;
    if m > std::f64::consts::SQRT_2 {
        (m, k) = (m / 2.0, k + 1);
    }
    let m = Interval::point(m);
    let t = (m - Interval::ONE) / (m + Interval::ONE);
    let square = t.square();
    // |t| is at most 0.1716: what follows the term of t^41 is below 1e-30 of the first.
    let mut sum = Interval::new(0.0, 1e-30);
    for n in (0..21).rev() {
        sum = sum * square + Interval::ONE / Interval::point(f64::from(2 * n + 1));
    }
    Interval::point(f64::from(k)) * ln_2() + Interval::point(2.0) * t * sum
}

/// exp x = 2^k exp r with |r| at most 0.35, by the series.
fn exp(x: f64) -> Interval {
    if x < -700.0 {
        return Interval::new(0.0, 1e-300);
    }
    if x.is_nan() || x > 700.0 {
        return Interval::new(1e300, f64::INFINITY);
    }
    let k = (x / std::f64::consts::LN_2).round();
    let r = Interval::point(x) - Interval::point(k) * ln_2();
    // What follows the term of r^20 is below 0.36^21 / 21! < 1e-28.
    let mut sum = Interval::ONE + Interval::new(-1e-15, 1e-15) * Interval::point(1e-12);
    for n in (1..=20).rev() {
        sum = Interval::ONE + r * sum / Interval::point(f64::from(n));
    }
    sum * Interval::point(2f64.powi(k as i32))
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(below(self.lower, other.lower), -below(-self.upper, -other.upper))
    }
}

/// A sum rounded down. What rounding has lost is a double itself (Knuth 1969), and so its sign is known.
fn below(a: f64, b: f64) -> f64 {
    let sum = a + b;
    let part = sum - a;
    let lost = (a - (sum - part)) + (b - part);
    if lost >= 0.0 { sum } else { sum.next_down() }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lower: -self.upper, upper: -self.lower }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self == Self::ZERO || other == Self::ZERO {
            return Self::ZERO;
        }
        if self == Self::ONE {
            return other;
        }
        if other == Self::ONE {
            return self;
        }
        let all = [
            self.lower * other.lower,
            self.lower * other.upper,
            self.upper * other.lower,
            self.upper * other.upper,
        ];
        if all.iter().any(|x| x.is_nan()) {
            return Self::everything();
        }
        Self::new(
            all.into_iter().fold(f64::INFINITY, f64::min),
            all.into_iter().fold(f64::NEG_INFINITY, f64::max),
        )
        .wider()
    }
}

impl Div for Interval {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.contains(0.0) {
            return Self::everything();
        }
        if other == Self::ONE {
            return self;
        }
        let inverse = Self::new(1.0 / other.upper, 1.0 / other.lower).wider();
        if self == Self::ONE { inverse } else { self.divided(other) }
    }
}

impl Interval {
    fn divided(self, other: Self) -> Self {
        let all = [
            self.lower / other.lower,
            self.lower / other.upper,
            self.upper / other.lower,
            self.upper / other.upper,
        ];
        if all.iter().any(|x| x.is_nan()) {
            return Self::everything();
        }
        if self == Self::ZERO {
            return Self::ZERO;
        }
        Self::new(
            all.into_iter().fold(f64::INFINITY, f64::min),
            all.into_iter().fold(f64::NEG_INFINITY, f64::max),
        )
        .wider()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_and_exponentials_contain_the_known_values() {
        // Digits from tables: the double below each and the one above.
        for (found, known) in [
            (Interval::point(3.0).ln(), 1.098_612_288_668_109_8),
            (Interval::point(1e-3).ln(), -6.907_755_278_982_137),
            (Interval::ONE.exp(), std::f64::consts::E),
            (Interval::point(-20.0).exp(), 2.061_153_622_438_558e-9),
            (Interval::point(2.0).power(Interval::point(0.5)), std::f64::consts::SQRT_2),
        ] {
            assert!(
                found.lower() <= known.next_up() && known.next_down() <= found.upper(),
                "{known} {found:?}"
            );
            assert!(found.width() < 1e-13 * known.abs(), "{known} {found:?}");
        }
    }

    #[test]
    fn numbers_beyond_all_doubles_are_above_the_last() {
        for bits in [1023u32, 1024, 1050, 1100, 5000] {
            let size = Interval::of_large(&(BigInt::from(1) << bits));
            let first = if bits == 1023 { 2f64.powi(1023) } else { f64::MAX };
            assert!(
                size.lower() <= first && size.lower() > 1e307 && size.upper() >= first,
                "{bits} {size:?}"
            );
            assert!(bits == 1023 || size.upper() == f64::INFINITY, "{bits} {size:?}");
        }
    }

    #[test]
    fn ends_are_rounded_outwards() {
        let tenth = Interval::ONE / Interval::point(10.0);
        assert!(tenth.lower() < 0.1 + 1e-17 && tenth.lower() < tenth.upper());
        let sum = Interval::point(1.0) + Interval::point(1e-30);
        assert_eq!((sum.lower(), sum.upper()), (1.0, 1.0f64.next_up()));
        assert!(!(Interval::ONE / Interval::new(-1.0, 1.0)).upper().is_finite());
    }
}
