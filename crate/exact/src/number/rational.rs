//! Fractions of whole numbers of any length. Most are small, and then they are two machine words.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::number::interval::Interval;

/// A fraction in lowest terms, with a positive denominator.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Form);

/// `Small` wherever both numbers fit, so that equal fractions are equal values.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Form {
    Small(i64, i64),
    Large(Box<(BigInt, BigInt)>),
}

impl Rational {
    /// Zero.
    pub const ZERO: Self = Self(Form::Small(0, 1));
    /// One.
    pub const ONE: Self = Self(Form::Small(1, 1));

    /// A whole number.
    #[must_use]
    pub fn whole(number: i64) -> Self {
        // The one word whose negative is none is kept as a long number.
        if number == i64::MIN { Self::reduced(number.into(), 1) } else { Self(Form::Small(number, 1)) }
    }

    /// A fraction, `None` where the denominator is zero.
    #[must_use]
    pub fn new(numerator: i64, denominator: i64) -> Option<Self> {
        (denominator != 0).then(|| Self::reduced(numerator.into(), denominator.into()))
    }

    /// A fraction of long numbers, `None` where the denominator is zero.
    #[must_use]
    pub fn from_parts(numerator: BigInt, denominator: BigInt) -> Option<Self> {
        (!denominator.is_zero()).then(|| Self::reduced_large(numerator, denominator))
    }

    /// The number that a double is, `None` where it is not finite.
    #[must_use]
    pub fn from_f64(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let bits = value.abs().to_bits();
        let (exponent, fraction) = ((bits >> 52) as i32, bits & ((1 << 52) - 1));
        let (mantissa, shift) =
            if exponent == 0 { (fraction, -1074) } else { (fraction | (1 << 52), exponent - 1075) };
        let mantissa = BigInt::from(mantissa) * if value < 0.0 { -1 } else { 1 };
        let (numerator, denominator) = if shift >= 0 {
            (mantissa << shift as u32, BigInt::one())
        } else {
            (mantissa, BigInt::one() << (-shift) as u32)
        };
        Some(Self::reduced_large(numerator, denominator))
    }

    fn reduced(numerator: i128, denominator: i128) -> Self {
        let sign = if denominator < 0 { -1 } else { 1 };
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs());
        // Products and sums of machine words stay far below the end of this type.
        let (n, d) = (sign * numerator / divisor as i128, sign * denominator / divisor as i128);
        match (i64::try_from(n), i64::try_from(d)) {
            (Ok(n), Ok(d)) if n != i64::MIN => Self(Form::Small(n, d)),
            _ => Self(Form::Large(Box::new((n.into(), d.into())))),
        }
    }

    fn reduced_large(numerator: BigInt, denominator: BigInt) -> Self {
        let divisor = numerator.gcd(&denominator);
        let divisor = if denominator.is_negative() { -divisor } else { divisor };
        let (n, d) = (numerator / &divisor, denominator / divisor);
        match (n.to_i64(), d.to_i64()) {
            (Some(n), Some(d)) if n != i64::MIN => Self(Form::Small(n, d)),
            _ => Self(Form::Large(Box::new((n, d)))),
        }
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> BigInt {
        match &self.0 {
            Form::Small(n, _) => (*n).into(),
            Form::Large(both) => both.0.clone(),
        }
    }

    /// The denominator, which is positive.
    #[must_use]
    pub fn denominator(&self) -> BigInt {
        match &self.0 {
            Form::Small(_, d) => (*d).into(),
            Form::Large(both) => both.1.clone(),
        }
    }

    /// Whether this is 0.
    #[must_use]
    pub const fn is_zero(&self) -> bool {
        matches!(self.0, Form::Small(0, _))
    }

    /// Whether this is 1.
    #[must_use]
    pub const fn is_one(&self) -> bool {
        matches!(self.0, Form::Small(1, 1))
    }

    /// Whether the denominator is 1.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        match &self.0 {
            Form::Small(_, d) => *d == 1,
            Form::Large(both) => both.1.is_one(),
        }
    }

    /// The binary digits of the longer of both numbers; 0 for what fits into machine words.
    pub(crate) fn bits(&self) -> u64 {
        match &self.0 {
            Form::Small(..) => 0,
            Form::Large(both) => both.0.bits().max(both.1.bits()),
        }
    }

    /// Negative, zero or positive.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        match &self.0 {
            Form::Small(n, _) => n.cmp(&0),
            Form::Large(both) => match both.0.sign() {
                Sign::Minus => Ordering::Less,
                Sign::NoSign => Ordering::Equal,
                Sign::Plus => Ordering::Greater,
            },
        }
    }

    /// Without its sign.
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.sign() == Ordering::Less { -self } else { self.clone() }
    }

    /// One over this, `None` for zero.
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        match &self.0 {
            Form::Small(0, _) => None,
            Form::Small(n, d) => Some(Self::reduced((*d).into(), (*n).into())),
            Form::Large(both) => Some(Self::reduced_large(both.1.clone(), both.0.clone())),
        }
    }

    /// A power with a whole exponent, `None` for a negative one of zero.
    #[must_use]
    pub fn power(&self, exponent: i32) -> Option<Self> {
        let base = if exponent < 0 { self.inverse()? } else { self.clone() };
        let exponent = exponent.unsigned_abs();
        Some(Self::reduced_large(base.numerator().pow(exponent), base.denominator().pow(exponent)))
    }

    /// Doubles around this.
    #[must_use]
    pub fn enclosure(&self) -> Interval {
        match &self.0 {
            Form::Small(n, 1) => Interval::of_i64(*n),
            Form::Small(n, d) => Interval::of_i64(*n) / Interval::of_i64(*d),
            Form::Large(both) => Interval::of_large(&both.0) / Interval::of_large(&both.1),
        }
    }

    /// A double near this.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.enclosure().middle()
    }
}

impl From<BigInt> for Rational {
    fn from(number: BigInt) -> Self {
        Self::reduced_large(number, BigInt::one())
    }
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    if b == 1 {
        return 1;
    }
    // Long divisions are slow: as soon as both fit, machine words go on.
    while b != 0 {
        if let (Ok(mut x), Ok(mut y)) = (u64::try_from(a), u64::try_from(b)) {
            while y != 0 {
                (x, y) = (y, x % y);
            }
            return x.into();
        }
        (a, b) = (b, a % b);
    }
    a
}

impl Add for &Rational {
    type Output = Rational;

    fn add(self, other: Self) -> Rational {
        if let (Form::Small(a, b), Form::Small(c, d)) = (&self.0, &other.0) {
            if *b == 1
                && *d == 1
                && let Some(sum) = a.checked_add(*c).filter(|&sum| sum != i64::MIN)
            {
                return Rational(Form::Small(sum, 1));
            }
            let [a, b, c, d] = [*a, *b, *c, *d].map(i128::from);
            // Each product is below 2^126, and so their sum fits.
            return Rational::reduced(a * d + c * b, b * d);
        }
        let (b, d) = (self.denominator(), other.denominator());
        Rational::reduced_large(self.numerator() * &d + other.numerator() * &b, b * d)
    }
}

impl Neg for &Rational {
    type Output = Rational;

    fn neg(self) -> Rational {
        match &self.0 {
            Form::Small(n, d) => Rational(Form::Small(-n, *d)),
            Form::Large(both) => Rational::reduced_large(-both.0.clone(), both.1.clone()),
        }
    }
}

impl Sub for &Rational {
    type Output = Rational;

    fn sub(self, other: Self) -> Rational {
        self + &-other
    }
}

impl Mul for &Rational {
    type Output = Rational;

    fn mul(self, other: Self) -> Rational {
        if let (Form::Small(a, b), Form::Small(c, d)) = (&self.0, &other.0) {
            let [a, b, c, d] = [*a, *b, *c, *d].map(i128::from);
            return Rational::reduced(a * c, b * d);
        }
        Rational::reduced_large(
            self.numerator() * other.numerator(),
            self.denominator() * other.denominator(),
        )
    }
}

impl Div for &Rational {
    type Output = Option<Rational>;

    fn div(self, other: Self) -> Option<Rational> {
        let inverse = other.inverse()?;
        Some(self.mul(&inverse))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        (self - other).sign()
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_whole() {
            write!(f, "{}", self.numerator())
        } else {
            write!(f, "{}/{}", self.numerator(), self.denominator())
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_stay_in_lowest_terms() {
        let half = Rational::new(3, -6).unwrap();
        assert_eq!(half.to_string(), "-1/2");
        assert_eq!(&half + &Rational::new(1, 2).unwrap(), Rational::ZERO);
        assert_eq!(Rational::new(1, 0), None);
        assert_eq!(Rational::from_f64(0.1).unwrap().to_string(), "3602879701896397/36028797018963968");
    }

    #[test]
    fn long_numbers_come_back_short() {
        let large = Rational::whole(i64::MAX);
        let square = &large * &large;
        assert_eq!(square.to_string(), "85070591730234615847396907784232501249");
        assert_eq!((&square / &large).unwrap(), large);
        let lowest = &Rational::whole(-i64::MAX) - &Rational::ONE;
        assert_eq!((-&lowest).to_string(), "9223372036854775808");
        assert_eq!(-&-&lowest, lowest);
        let around = square.enclosure();
        assert!(
            around.lower() <= around.upper() && (around.middle() / 8.507059173023462e37 - 1.0).abs() < 1e-15
        );
    }
}
