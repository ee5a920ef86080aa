//! Polynomials in one variable, the constant term first.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::number::rational::Rational;

/// A polynomial with fractions for coefficients. The last is not zero; the zero polynomial has none.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub(crate) struct Polynomial(Vec<Rational>);

impl Polynomial {
    pub fn new(mut coefficients: Vec<Rational>) -> Self {
        while coefficients.last().is_some_and(Rational::is_zero) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    pub fn of_whole(coefficients: &[BigInt]) -> Self {
        Self::new(coefficients.iter().map(|c| Rational::from(c.clone())).collect())
    }

    pub fn coefficients(&self) -> &[Rational] {
        &self.0
    }

    pub const fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Zero for constants, zero among them.
    pub fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub fn minus(&self, other: &Self) -> Self {
        let zero = Rational::ZERO;
        let at = |from: &[Rational], k: usize| from.get(k).cloned().unwrap_or_else(|| zero.clone());
        Self::new((0..self.0.len().max(other.0.len())).map(|k| &at(&self.0, k) - &at(&other.0, k)).collect())
    }

    pub fn times(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::default();
        }
        let mut product = vec![Rational::ZERO; self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            for (j, b) in other.0.iter().enumerate() {
                product[i + j] = &product[i + j] + &(a * b);
            }
        }
        Self::new(product)
    }

    /// Quotient and remainder, `None` where the divisor is zero.
    pub fn divided(&self, divisor: &Self) -> Option<(Self, Self)> {
        let lead = divisor.0.last()?.inverse()?;
        let mut rest = self.0.clone();
        let mut quotient = vec![Rational::ZERO; (self.0.len() + 1).saturating_sub(divisor.0.len())];
        for k in (0..quotient.len()).rev() {
            let factor = &rest[k + divisor.0.len() - 1] * &lead;
            if !factor.is_zero() {
                for (j, d) in divisor.0.iter().enumerate() {
                    rest[k + j] = &rest[k + j] - &(&factor * d);
                }
            }
            quotient[k] = factor;
        }
        Some((Self::new(quotient), Self::new(rest)))
    }

    pub fn derivative(&self) -> Self {
        let slopes = self.0.iter().enumerate().skip(1);
        Self::new(slopes.map(|(k, c)| c * &Rational::whole(k as i64)).collect())
    }

    /// With leading coefficient one.
    pub fn monic(&self) -> Self {
        let Some(lead) = self.0.last().and_then(Rational::inverse) else { return Self::default() };
        Self::new(self.0.iter().map(|c| c * &lead).collect())
    }

    /// The monic greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.monic(), other.monic());
        while let Some((_, rest)) = a.divided(&b) {
            (a, b) = (b, rest.monic());
        }
        a
    }

    /// `(g, s)` with g the monic greatest common divisor, and `s self = g` modulo the other.
    pub fn bezout(&self, modulus: &Self) -> (Self, Self) {
        let one = Self::new(vec![Rational::ONE]);
        let (mut a, mut b, mut s, mut t) = (self.clone(), modulus.clone(), one, Self::default());
        while let Some((quotient, rest)) = a.divided(&b) {
            let next = s.minus(&quotient.times(&t));
            (a, b, s, t) = (b, rest, t, next);
        }
        let Some(lead) = a.0.last().and_then(Rational::inverse) else { return (a, s) };
        let scale = Self::new(vec![lead]);
        (a.monic(), s.times(&scale))
    }

    pub fn at(&self, x: &Rational) -> Rational {
        self.0.iter().rev().fold(Rational::ZERO, |sum, c| &(&sum * x) + c)
    }

    /// The same roots with whole coefficients that have no common divisor, the leading one positive.
    pub fn primitive(&self) -> Vec<BigInt> {
        let common = self.0.iter().fold(BigInt::one(), |lcm, c| lcm.lcm(&c.denominator()));
        let whole = self.0.iter().map(|c| c.numerator() * (&common / c.denominator())).collect();
        without_content(whole)
    }
}

/// Whole coefficients without their common divisor, the leading one positive.
pub(crate) fn without_content(mut coefficients: Vec<BigInt>) -> Vec<BigInt> {
    let mut content = coefficients.iter().fold(BigInt::zero(), |gcd, c| gcd.gcd(c));
    if coefficients.last().is_some_and(Signed::is_negative) {
        content = -content;
    }
    if !content.is_zero() {
        for c in &mut coefficients {
            *c /= &content;
        }
    }
    coefficients
}
