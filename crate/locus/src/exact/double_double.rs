//! Numbers of twice the digits, where doubles would cancel too many.

use std::ops::{Add, Mul, Sub};

use crate::exact::expansion::{two_product, two_sum};

/// A number of some 32 digits, as the sum of two doubles (Dekker 1971). Relative to the sizes of the terms it is
/// rounded by 1e-31 or so.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// The product of two doubles, exactly.
    pub fn product(a: f64, b: f64) -> Self {
        Self::from(a) * b
    }

    /// The quotient, to the nearest double or one beside it.
    pub fn over(self, by: Self) -> f64 {
        let first = self.high / by.high;
        first + (self - by * first).high / by.high
    }
}

impl From<f64> for DoubleDouble {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    // Called a hundred times a map in few places: not copied into each of them, for the size of the download.
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let (high, low) = two_sum(self.high, other.high);
        let (high, low) = two_sum(high, low + (self.low + other.low));
        Self { high, low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self { high: -other.high, low: -other.low }
    }
}

impl Mul<f64> for DoubleDouble {
    type Output = Self;

    #[inline(never)]
    fn mul(self, by: f64) -> Self {
        let (high, low) = two_product(self.high, by);
        let (high, low) = two_sum(high, low + self.low * by);
        Self { high, low }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_keep_what_cancels() {
        // (1 + e)^2 - 1 - 2 e is e^2.
        let (x, tiny) = (1.0 + f64::EPSILON, f64::EPSILON);
        let left = DoubleDouble::product(x, x) - DoubleDouble::from(1.0) - DoubleDouble::from(2.0 * tiny);
        assert_eq!(left.over(DoubleDouble::from(1.0)), tiny * tiny);
        let third = DoubleDouble::from(1.0).over(DoubleDouble::from(3.0));
        assert_eq!((DoubleDouble::product(third, 3.0) * 0.5).over(DoubleDouble::product(0.5, 3.0)), third);
    }
}
