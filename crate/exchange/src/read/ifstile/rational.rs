//! Rational numbers: small ones in two words, larger ones as long as they need.

use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_rational::Ratio;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// A rational number in lowest terms. It is small where both parts fit, so that equal numbers are equal values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rational {
    /// The numerator, and the denominator, which is positive.
    Small(i64, i64),
    Large(Box<Ratio<BigInt>>),
}

/// Decimals are read with no more digits before or behind their point.
const MOST_DIGITS: i64 = 1200;

impl Rational {
    pub const ZERO: Self = Self::Small(0, 1);
    pub const ONE: Self = Self::Small(1, 1);

    pub const fn whole(x: i64) -> Self {
        Self::Small(x, 1)
    }

    /// A fraction whose denominator is not zero.
    pub fn fraction(over: i64, under: i64) -> Self {
        Self::quotient(i128::from(over), i128::from(under))
    }

    fn quotient(over: i128, under: i128) -> Self {
        let divisor = gcd(over.unsigned_abs(), under.unsigned_abs());
        let (over, under) = match i128::try_from(divisor) {
            Ok(divisor) if divisor > 1 => (over / divisor, under / divisor),
            _ => (over, under),
        };
        let (over, under) = if under < 0 { (-over, -under) } else { (over, under) };
        match (i64::try_from(over), i64::try_from(under)) {
            (Ok(over), Ok(under)) => Self::Small(over, under),
            _ => Self::Large(Box::new(Ratio::new_raw(BigInt::from(over), BigInt::from(under)))),
        }
    }

    /// The same number, small where it can be.
    pub fn of(ratio: Ratio<BigInt>) -> Self {
        match (ratio.numer().to_i64(), ratio.denom().to_i64()) {
            (Some(over), Some(under)) => Self::Small(over, under),
            _ => Self::Large(Box::new(ratio)),
        }
    }

    pub fn ratio(&self) -> Ratio<BigInt> {
        match self {
            Self::Small(over, under) => Ratio::new_raw(BigInt::from(*over), BigInt::from(*under)),
            Self::Large(ratio) => (**ratio).clone(),
        }
    }

    /// The decimal of a text, such as 1.25e-3; none where it is no decimal, or has too many digits.
    pub fn decimal(text: &str) -> Option<Self> {
        let (digits, exponent) = match text.split_once(['e', 'E']) {
            Some((digits, exponent)) => (digits, exponent.parse::<i64>().ok()?),
            None => (text, 0),
        };
        let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
        let count = i64::try_from(whole.len() + part.len()).ok()?;
        let exponent = exponent.checked_sub(i64::try_from(part.len()).ok()?)?;
        let shown = [whole, part].concat();
        if shown.is_empty() || !shown.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        if count > MOST_DIGITS || exponent.abs() > MOST_DIGITS {
            return None;
        }
        let over: BigInt = shown.parse().ok()?;
        let power = BigInt::from(10).pow(u32::try_from(exponent.unsigned_abs()).ok()?);
        let ratio = if exponent < 0 { Ratio::new(over, power) } else { Ratio::from_integer(over * power) };
        Some(Self::of(ratio))
    }

    /// A double, exactly; none where it is not finite.
    pub fn of_double(x: f64) -> Option<Self> {
        if !x.is_finite() {
            return None;
        }
        let bits = x.to_bits();
        let exponent = i64::try_from((bits >> 52) & 0x7ff).ok()?;
        let fraction = bits & ((1 << 52) - 1);
        let (fraction, exponent) =
            if exponent == 0 { (fraction, -1074) } else { (fraction | (1 << 52), exponent - 1075) };
        let over = BigInt::from_biguint(if x < 0.0 { Sign::Minus } else { Sign::Plus }, fraction.into());
        let power = BigInt::one() << exponent.unsigned_abs();
        let ratio = if exponent < 0 { Ratio::new(over, power) } else { Ratio::from_integer(over * power) };
        Some(Self::of(ratio))
    }

    /// How many binary digits its larger part has.
    pub fn bits(&self) -> u64 {
        match self {
            Self::Small(..) => 64,
            Self::Large(ratio) => ratio.numer().bits().max(ratio.denom().bits()),
        }
    }

    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Small(0, _))
    }

    pub fn is_one(&self) -> bool {
        matches!(self, Self::Small(1, 1))
    }

    /// The whole number that it is.
    pub fn as_whole(&self) -> Option<i64> {
        match self {
            Self::Small(over, 1) => Some(*over),
            _ => None,
        }
    }

    pub fn signum(&self) -> i32 {
        match self {
            Self::Small(over, _) => i32::from(*over > 0) - i32::from(*over < 0),
            Self::Large(ratio) if ratio.is_negative() => -1,
            Self::Large(_) => 1,
        }
    }

    pub fn negated(&self) -> Self {
        match self {
            Self::Small(over, under) => Self::quotient(-i128::from(*over), i128::from(*under)),
            Self::Large(ratio) => Self::of(-(**ratio).clone()),
        }
    }

    pub fn plus(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Small(a, b), Self::Small(c, d)) => {
                let [a, b, c, d] = [a, b, c, d].map(|part| i128::from(*part));
                Self::quotient(a * d + c * b, b * d)
            }
            _ if self.is_whole() && other.is_whole() => Self::of_whole(self.numerator() + other.numerator()),
            _ => Self::of(self.ratio() + other.ratio()),
        }
    }

    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    pub fn times(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Small(a, b), Self::Small(c, d)) => {
                let [a, b, c, d] = [a, b, c, d].map(|part| i128::from(*part));
                Self::quotient(a * c, b * d)
            }
            _ if self.is_whole() && other.is_whole() => Self::of_whole(self.numerator() * other.numerator()),
            _ => Self::of(self.ratio() * other.ratio()),
        }
    }

    fn is_whole(&self) -> bool {
        match self {
            Self::Small(_, under) => *under == 1,
            Self::Large(ratio) => ratio.is_integer(),
        }
    }

    fn numerator(&self) -> BigInt {
        match self {
            Self::Small(over, _) => BigInt::from(*over),
            Self::Large(ratio) => ratio.numer().clone(),
        }
    }

    /// Whole numbers need no reducing, which takes long.
    fn of_whole(x: BigInt) -> Self {
        x.to_i64().map_or_else(|| Self::Large(Box::new(Ratio::from_integer(x))), Self::whole)
    }

    /// One divided by it; none of zero.
    pub fn inverse(&self) -> Option<Self> {
        match self {
            Self::Small(0, _) => None,
            Self::Small(over, under) => Some(Self::quotient(i128::from(*under), i128::from(*over))),
            Self::Large(ratio) => Some(Self::of(ratio.recip())),
        }
    }

    /// The largest whole number that is not larger.
    pub fn floor(&self) -> Self {
        match self {
            Self::Small(over, under) => Self::whole(over.div_euclid(*under)),
            Self::Large(ratio) => Self::of(ratio.floor()),
        }
    }

    pub fn compare(&self, other: &Self) -> Ordering {
        self.minus(other).signum().cmp(&0)
    }

    /// The rational number whose power this is; none where there is none.
    pub fn root(&self, degree: u32) -> Option<Self> {
        let ratio = self.ratio();
        if degree == 0 || (ratio.is_negative() && degree.is_multiple_of(2)) {
            return None;
        }
        let of = |part: &BigInt| {
            let root = part.nth_root(degree);
            (root.pow(degree) == *part).then_some(root)
        };
        Some(Self::of(Ratio::new_raw(of(ratio.numer())?, of(ratio.denom())?)))
    }

    /// The nearest double; none beyond the largest.
    pub fn to_double(&self) -> Option<f64> {
        let most = 1_i64 << 53;
        if let Self::Small(over, under) = self
            && over.abs() <= most
            && *under <= most
        {
            return Some(*over as f64 / *under as f64);
        }
        nearest_double(&self.ratio()).filter(|x| x.is_finite())
    }
}

/// Rounds to 53 binary digits, or to as many as a double near zero has, ties to even.
fn nearest_double(ratio: &Ratio<BigInt>) -> Option<f64> {
    let (over, under) = (ratio.numer().abs(), ratio.denom());
    if over.is_zero() {
        return Some(0.0);
    }
    let size = i64::try_from(over.bits()).ok()? - i64::try_from(under.bits()).ok()?;
    // The quotient has 53 or 54 digits before its point.
    let mut shift = (size - 53).max(-1074);
    let divided = |shift: i64| {
        let by = BigInt::one() << shift.unsigned_abs();
        let (over, under) = if shift < 0 { (&over * by, under.clone()) } else { (over.clone(), under * by) };
        let whole = &over / &under;
        let rest: BigInt = (over - &whole * &under) * 2;
        let up = match rest.cmp(&under) {
            Ordering::Greater => true,
            Ordering::Equal => whole.bit(0),
            Ordering::Less => false,
        };
        if up { whole + 1 } else { whole }
    };
    let mut whole = divided(shift);
    if whole.bits() > 53 {
        shift += 1;
        whole = divided(shift);
    }
    let half = i32::try_from(shift / 2).ok()?;
    let rest = i32::try_from(shift).ok()? - half;
    let size = whole.to_u64()? as f64 * 2.0_f64.powi(half) * 2.0_f64.powi(rest);
    Some(if ratio.is_negative() { -size } else { size })
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        // Most parts are small, and short division is quicker.
        if let (Ok(mut p), Ok(mut q)) = (u64::try_from(a), u64::try_from(b)) {
            while q != 0 {
                (p, q) = (q, p % q);
            }
            return u128::from(p);
        }
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn roots_are_found_where_they_are_rational() {
        let of = |over, under| Rational::quotient(over, under);
        assert_eq!(of(4, 9).root(2), Some(of(2, 3)));
        assert_eq!(of(-8, 27).root(3), Some(of(-2, 3)));
        assert_eq!(of(2, 1).root(2), None);
        assert_eq!(of(-4, 1).root(2), None);
    }

    #[test]
    fn parts_that_do_not_fit_are_long() {
        let most = Rational::whole(i64::MAX);
        let sum = most.plus(&Rational::ONE);
        assert_eq!(sum.ratio(), Ratio::from_integer(BigInt::from(1_u64 << 63)));
        assert_eq!(sum.minus(&Rational::ONE), most);
        assert_eq!(Rational::whole(i64::MIN).negated(), sum);
        assert_eq!(most.times(&most).times(&most.inverse().unwrap()), most);
    }

    proptest! {
        #[test]
        fn decimals_are_the_doubles_that_the_standard_library_reads(
            digits in "[0-9]{1,20}", part in "[0-9]{0,20}", exponent in -330..310_i32
        ) {
            let text = format!("{digits}.{part}e{exponent}");
            let wanted: f64 = text.parse().unwrap();
            let found = Rational::decimal(&text).unwrap().to_double();
            prop_assert_eq!(found, Some(wanted).filter(|x| x.is_finite()));
        }

        #[test]
        fn doubles_come_back(x in proptest::num::f64::NORMAL | proptest::num::f64::SUBNORMAL) {
            prop_assert_eq!(Rational::of_double(x).unwrap().to_double(), Some(x));
        }
    }
}
