//! Real and complex numbers with 256 binary digits behind the point: far more than a double has, so that what is
//! computed with them and then rounded is the double next to the exact number.

use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::{Signed, Zero};

use super::rational::Rational;

const DIGITS: u64 = 256;

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fixed(BigInt);

impl Fixed {
    pub fn zero() -> Self {
        Self(BigInt::zero())
    }

    pub fn one() -> Self {
        Self(BigInt::from(1) << DIGITS)
    }

    /// 2 to the power of minus `digits`.
    pub fn tiny(digits: u64) -> Self {
        Self(BigInt::from(1) << DIGITS.saturating_sub(digits))
    }

    pub fn of(x: &Rational) -> Self {
        let ratio = x.ratio();
        Self((ratio.numer() << DIGITS) / ratio.denom())
    }

    pub fn of_double(x: f64) -> Self {
        Rational::of_double(x).map_or_else(Self::zero, |x| Self::of(&x))
    }

    pub fn ratio(&self) -> Ratio<BigInt> {
        Ratio::new(self.0.clone(), BigInt::from(1) << DIGITS)
    }

    pub fn to_double(&self) -> f64 {
        Rational::of(self.ratio()).to_double().unwrap_or(f64::NAN)
    }

    /// The nearest whole number.
    pub fn nearest_whole(&self) -> BigInt {
        (&self.0 + (BigInt::from(1) << (DIGITS - 1))) >> DIGITS
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    pub fn minus(&self, other: &Self) -> Self {
        Self(&self.0 - &other.0)
    }

    pub fn negated(&self) -> Self {
        Self(-&self.0)
    }

    pub fn times(&self, other: &Self) -> Self {
        Self((&self.0 * &other.0) >> DIGITS)
    }

    /// None over zero.
    pub fn over(&self, other: &Self) -> Option<Self> {
        (!other.0.is_zero()).then(|| Self((&self.0 << DIGITS) / &other.0))
    }

    /// Of what is negative, 0.
    pub fn root(&self) -> Self {
        if self.0.is_negative() { Self::zero() } else { Self((&self.0 << DIGITS).sqrt()) }
    }

    pub fn abs(&self) -> Self {
        Self(self.0.abs())
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Complex {
    pub re: Fixed,
    pub im: Fixed,
}

impl Complex {
    pub fn real(re: Fixed) -> Self {
        Self { re, im: Fixed::zero() }
    }

    pub fn zero() -> Self {
        Self::real(Fixed::zero())
    }

    pub fn conjugate(&self) -> Self {
        Self { re: self.re.clone(), im: self.im.negated() }
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self { re: self.re.plus(&other.re), im: self.im.plus(&other.im) }
    }

    pub fn minus(&self, other: &Self) -> Self {
        Self { re: self.re.minus(&other.re), im: self.im.minus(&other.im) }
    }

    pub fn times(&self, other: &Self) -> Self {
        Self {
            re: self.re.times(&other.re).minus(&self.im.times(&other.im)),
            im: self.re.times(&other.im).plus(&self.im.times(&other.re)),
        }
    }

    /// None over zero.
    pub fn over(&self, other: &Self) -> Option<Self> {
        let square = other.square();
        let product = self.times(&other.conjugate());
        Some(Self { re: product.re.over(&square)?, im: product.im.over(&square)? })
    }

    /// The square of its modulus.
    pub fn square(&self) -> Fixed {
        self.re.times(&self.re).plus(&self.im.times(&self.im))
    }

    pub fn modulus(&self) -> Fixed {
        self.square().root()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_and_quotients_round_to_the_nearest_double() {
        let three = Fixed::of_double(3.0);
        assert_eq!(three.root().to_double(), 3.0_f64.sqrt());
        assert_eq!(Fixed::one().over(&three).unwrap().to_double(), 1.0 / 3.0);
        let z = Complex { re: Fixed::one(), im: Fixed::of_double(-2.0) };
        let one = z.over(&z).unwrap();
        assert_eq!((one.re.to_double(), one.im.to_double()), (1.0, 0.0));
        assert_eq!(Fixed::of_double(-2.5).nearest_whole(), BigInt::from(-2));
    }
}
