//! Roots of rational polynomials, and the irreducible factor that each belongs to.
//!
//! Polynomials are lists of coefficients, the constant first, and monic.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::{One, ToPrimitive, Zero};

use super::fixed::{Complex, Fixed};
use super::rational::Rational;

type Polynomial = Vec<Rational>;

/// A root with no negative imaginary part.
#[derive(Clone, Debug)]
pub struct Root {
    pub value: Complex,
    pub real: bool,
    /// How often it is one.
    pub multiplicity: usize,
    /// The factor that it is a root of, once.
    pub factor: Polynomial,
    /// No other root of the factor is so near.
    pub radius: Fixed,
}

/// Differences below are none: 96 binary digits.
fn close() -> Fixed {
    Fixed::tiny(96)
}

/// The roots of a monic polynomial that are real or lie above the real axis: those of larger modulus first, of the same
/// modulus those with the larger real part. None where numbers are too large to find them.
pub fn roots(polynomial: &[Rational]) -> Option<Vec<Root>> {
    let mut all = Vec::new();
    for (part, multiplicity) in square_free(polynomial) {
        let values = simple_roots(&part)?;
        for value in values.iter().filter(|value| value.im >= Fixed::zero()) {
            let factor = factor_of(&part, &values, value);
            let radius = radius(&part, value, &values)?;
            all.push(Root { real: value.im.is_zero(), value: value.clone(), multiplicity, factor, radius });
        }
    }
    all.sort_by(|one, other| {
        let by = |x: Fixed, y: Fixed| {
            if x.minus(&y).abs() < close() { Ordering::Equal } else { y.cmp(&x) }
        };
        by(one.value.modulus(), other.value.modulus())
            .then_with(|| by(one.value.re.clone(), other.value.re.clone()))
    });
    Some(all)
}

/// The factors whose roots are simple, each with how often it divides the polynomial (Yun, in the plain form).
fn square_free(polynomial: &[Rational]) -> Vec<(Polynomial, usize)> {
    if simple_modulo(polynomial) {
        return vec![(polynomial.to_vec(), 1)];
    }
    let mut parts = Vec::new();
    let mut rest = monic(polynomial.to_vec());
    let mut common = divisor(&rest, &derivative(&rest));
    let mut once = quotient(&rest, &common).0;
    let mut multiplicity = 1;
    while once.len() > 1 {
        let next = divisor(&once, &common);
        let part = quotient(&once, &next).0;
        if part.len() > 1 {
            parts.push((part, multiplicity));
        }
        rest = quotient(&common, &next).0;
        (once, common) = (next, rest);
        multiplicity += 1;
    }
    parts
}

/// Whether a monic polynomial has simple roots modulo a prime: then it has them. This saves long fractions.
pub fn simple_modulo(polynomial: &[Rational]) -> bool {
    const PRIME: u64 = (1 << 61) - 1;
    let times = |x: u64, y: u64| (u128::from(x) * u128::from(y) % u128::from(PRIME)) as u64;
    let inverse = |x: u64| {
        let (mut power, mut square, mut left) = (1, x, PRIME - 2);
        while left > 0 {
            if left % 2 == 1 {
                power = times(power, square);
            }
            square = times(square, square);
            left /= 2;
        }
        power
    };
    let rest = |x: &BigInt| ((x % PRIME + PRIME) % PRIME).to_u64().unwrap_or(0);
    let of = |x: &Rational| {
        let ratio = x.ratio();
        let under = rest(ratio.denom());
        (under != 0).then(|| times(rest(ratio.numer()), inverse(under)))
    };
    let Some(mut one) = polynomial.iter().map(of).collect::<Option<Vec<u64>>>() else { return false };
    let mut other: Vec<u64> = one.iter().zip(0..).skip(1).map(|(&x, k)| times(x, k)).collect();
    loop {
        while other.last() == Some(&0) {
            other.pop();
        }
        let Some(&lead) = other.last() else { return one.len() == 1 };
        let by = inverse(lead);
        while one.len() >= other.len() {
            let factor = times(one[one.len() - 1], by);
            let start = one.len() - other.len();
            for (x, &y) in one[start..].iter_mut().zip(&other) {
                *x = (*x + PRIME - times(factor, y)) % PRIME;
            }
            one.pop();
        }
        std::mem::swap(&mut one, &mut other);
    }
}

fn derivative(of: &[Rational]) -> Polynomial {
    let power = |k: usize| Rational::whole(i64::try_from(k).unwrap_or(0));
    of.iter().enumerate().skip(1).map(|(k, x)| x.times(&power(k))).collect()
}

fn trimmed(mut polynomial: Polynomial) -> Polynomial {
    while polynomial.last().is_some_and(Rational::is_zero) {
        polynomial.pop();
    }
    polynomial
}

fn monic(polynomial: Polynomial) -> Polynomial {
    let polynomial = trimmed(polynomial);
    let Some(inverse) = polynomial.last().and_then(Rational::inverse) else { return polynomial };
    polynomial.iter().map(|x| x.times(&inverse)).collect()
}

/// Quotient and remainder by a polynomial that is monic.
fn quotient(of: &[Rational], by: &[Rational]) -> (Polynomial, Polynomial) {
    if by.is_empty() || of.len() < by.len() {
        return (Vec::new(), of.to_vec());
    }
    let mut rest = of.to_vec();
    let mut found = vec![Rational::ZERO; of.len() - by.len() + 1];
    for k in (0..found.len()).rev() {
        let factor = rest[k + by.len() - 1].clone();
        for (j, x) in by.iter().enumerate() {
            rest[k + j] = rest[k + j].minus(&factor.times(x));
        }
        found[k] = factor;
    }
    (found, trimmed(rest))
}

/// The greatest common divisor, monic.
fn divisor(one: &[Rational], other: &[Rational]) -> Polynomial {
    let (mut one, mut other) = (monic(one.to_vec()), monic(other.to_vec()));
    while !other.is_empty() {
        let rest = monic(quotient(&one, &other).1);
        one = std::mem::replace(&mut other, rest);
    }
    one
}

fn value_at(of: &[Rational], at: &Complex) -> Complex {
    of.iter().rev().fold(Complex::zero(), |sum, x| sum.times(at).plus(&Complex::real(Fixed::of(x))))
}

/// All roots of a polynomial that has each once: near at first (Aberth), then by Newton.
fn simple_roots(of: &[Rational]) -> Option<Vec<Complex>> {
    let plain: Vec<f64> = of.iter().map(Rational::to_double).collect::<Option<_>>()?;
    let slope = derivative(of);
    let mut values = Vec::new();
    for (re, im) in near_roots(&plain)? {
        let mut z = Complex { re: Fixed::of_double(re), im: Fixed::of_double(im) };
        for _ in 0..12 {
            let step = value_at(of, &z).over(&value_at(&slope, &z))?;
            z = z.minus(&step);
            if step.square().is_zero() {
                break;
            }
        }
        // The polynomial is real: what lies on the axis but for rounding lies on it.
        if z.im.abs() < close() {
            z.im = Fixed::zero();
        }
        values.push(z);
    }
    // Newton may run into a root that another start has found: then there are too few.
    for (k, one) in values.iter().enumerate() {
        if values[..k].iter().any(|other| one.minus(other).modulus() < close()) {
            return None;
        }
    }
    Some(values)
}

/// Roots in doubles.
fn near_roots(of: &[f64]) -> Option<Vec<(f64, f64)>> {
    let degree = of.len() - 1;
    // Fujiwara's bound.
    let bound = (0..degree)
        .map(|k| of[k].abs().powf(1.0 / (degree - k) as f64))
        .fold(0.0, f64::max)
        .mul_add(2.0, 1e-3);
    if !bound.is_finite() {
        return None;
    }
    let mut all: Vec<(f64, f64)> = (0..degree)
        .map(|k| {
            let angle = 0.4 + std::f64::consts::TAU * k as f64 / degree as f64;
            (0.7 * bound * angle.cos(), 0.7 * bound * angle.sin())
        })
        .collect();
    let times = |(a, b): (f64, f64), (c, d): (f64, f64)| (a * c - b * d, a * d + b * c);
    let over = |(a, b): (f64, f64), (c, d): (f64, f64)| {
        let square = c * c + d * d;
        ((a * c + b * d) / square, (b * c - a * d) / square)
    };
    for _ in 0..500 {
        let mut largest = 0.0_f64;
        for k in 0..degree {
            let z = all[k];
            let (mut value, mut slope) = ((0.0, 0.0), (0.0, 0.0));
            for &x in of.iter().rev() {
                slope = times(slope, z);
                slope = (slope.0 + value.0, slope.1 + value.1);
                value = times(value, z);
                value.0 += x;
            }
            if value == (0.0, 0.0) {
                continue;
            }
            let newton = over(value, slope);
            let mut pull = (0.0, 0.0);
            for (j, &other) in all.iter().enumerate() {
                if j != k {
                    let one = over((1.0, 0.0), (z.0 - other.0, z.1 - other.1));
                    pull = (pull.0 + one.0, pull.1 + one.1);
                }
            }
            let product = times(newton, pull);
            let step = over(newton, (1.0 - product.0, -product.1));
            if !(step.0.is_finite() && step.1.is_finite()) {
                continue;
            }
            all[k] = (z.0 - step.0, z.1 - step.1);
            largest = largest.max(step.0.hypot(step.1) / (1e-300 + z.0.hypot(z.1)));
        }
        if largest < 1e-14 {
            break;
        }
    }
    Some(all)
}

/// A disc around a root with a root of the polynomial in it (degree times the step of Newton), and half as wide as
/// the way to the next at most.
fn radius(of: &[Rational], at: &Complex, all: &[Complex]) -> Option<Fixed> {
    let step = value_at(of, at).over(&value_at(&derivative(of), at))?.modulus();
    let degree = Fixed::of_double(of.len() as f64);
    let radius = step.times(&degree).plus(&Fixed::tiny(200));
    let apart = all.iter().filter(|other| *other != at).map(|other| at.minus(other).modulus()).min();
    let isolated = apart.is_none_or(|apart| apart > radius.plus(&radius).plus(&radius));
    isolated.then_some(radius)
}

/// The factor of least degree that has a root: products of roots whose coefficients are near whole numbers are tried,
/// and taken where they divide.
fn factor_of(of: &[Rational], roots: &[Complex], root: &Complex) -> Polynomial {
    // Scaled by the common denominator, roots are algebraic integers, and factors have whole coefficients.
    let scale = of.iter().fold(BigInt::one(), |scale, x| {
        let under = x.ratio().denom().clone();
        let rest = &scale % &under;
        if rest.is_zero() { scale } else { scale * under }
    });
    if scale.to_i64().is_none_or(|scale| scale > 1 << 40) {
        return of.to_vec();
    }
    let by = Complex::real(Fixed::of(&Rational::of(Ratio::from_integer(scale.clone()))));
    // One of each pair.
    let others: Vec<&Complex> =
        roots.iter().filter(|z| z.im >= Fixed::zero() && z.minus(root).modulus() >= close()).collect();
    let mut choices: Vec<u32> = (0..1_u32 << others.len().min(12)).collect();
    choices.sort_by_key(|choice| choice.count_ones());
    let mut best: Option<Polynomial> = None;
    for choice in choices {
        let chosen = others.iter().enumerate().filter(|(k, _)| choice >> k & 1 == 1).map(|(_, z)| *z);
        let mut product = vec![Complex::real(Fixed::one())];
        for z in chosen.chain([root]) {
            product = multiplied(&product, &z.times(&by));
            if !z.im.is_zero() {
                product = multiplied(&product, &z.conjugate().times(&by));
            }
        }
        if best.as_ref().is_some_and(|best| best.len() <= product.len()) || product.len() >= of.len() {
            continue;
        }
        let near = Fixed::tiny(40);
        let whole = |x: &Complex| {
            let whole = x.re.nearest_whole();
            let off = x.re.minus(&Fixed::of(&Rational::of(Ratio::from_integer(whole.clone()))));
            (off.abs() < near).then_some(whole)
        };
        let Some(whole) = product.iter().map(whole).collect::<Option<Vec<_>>>() else { continue };
        let degree = whole.len() - 1;
        let factor: Polynomial = whole
            .into_iter()
            .enumerate()
            .map(|(k, x)| Rational::of(Ratio::new(x, num_traits::pow(scale.clone(), degree - k))))
            .collect();
        if quotient(of, &factor).1.is_empty() {
            best = Some(factor);
        }
    }
    best.unwrap_or_else(|| of.to_vec())
}

/// Times x minus a number.
fn multiplied(product: &[Complex], root: &Complex) -> Vec<Complex> {
    let mut next = vec![Complex::zero()];
    next.extend(product.iter().cloned());
    for (k, x) in product.iter().enumerate() {
        next[k] = next[k].minus(&x.times(root));
    }
    next
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(list: &[i64]) -> Polynomial {
        list.iter().map(|&x| Rational::whole(x)).collect()
    }

    fn found(list: &[i64]) -> Vec<(f64, f64, usize, Polynomial)> {
        let all = roots(&whole(list)).unwrap();
        all.into_iter()
            .map(|it| (it.value.re.to_double(), it.value.im.to_double(), it.multiplicity, it.factor))
            .collect()
    }

    #[test]
    fn roots_are_ordered_by_modulus_and_then_by_real_part() {
        // The fifteenth roots of -1 that are primitive thirtieths of 1: all of modulus 1.
        let all = found(&[1, 1, 0, -1, -1, -1, 0, 1, 1]);
        for ((re, im, ..), k) in all.iter().zip([1.0, 7.0, 11.0, 13.0]) {
            let angle = std::f64::consts::TAU * k / 30.0;
            assert!((re - angle.cos()).abs() < 1e-15 && (im - angle.sin()).abs() < 1e-15, "{re} {im}");
        }
        // Tribonacci: the real root is the smaller one of x^3 + x^2 + x - 1.
        let all = found(&[-1, 1, 1, 1]);
        assert!(all[0].1 > 1.0 && all[1].1 == 0.0);
        assert!((all[1].0 - 0.543_689_012_692_076_4).abs() < 1e-15);
    }

    #[test]
    fn what_is_simple_modulo_a_prime_is_simple() {
        assert!(simple_modulo(&whole(&[-2, 0, 1])) && simple_modulo(&whole(&[5, 1])));
        assert!(simple_modulo(&whole(&[4, 0, 0, 0, 1])));
        // (x - 1)^2, (x^2 - 2)^2 (x - 3), x^3.
        assert!(!simple_modulo(&whole(&[1, -2, 1])) && !simple_modulo(&whole(&[-12, 4, 12, -4, -3, 1])));
        assert!(!simple_modulo(&whole(&[0, 0, 0, 1])));
        // Of (x - 1/3) (x + 1/3) and of (x - 1/3)^2.
        let of = |k: i64, j: i64| [Rational::fraction(k, 9), Rational::fraction(j, 3), Rational::ONE];
        assert!(simple_modulo(&of(-1, 0)) && !simple_modulo(&of(1, -2)));
    }

    #[test]
    fn roots_know_their_factors_and_how_often_they_are_roots() {
        // (x^2 - 2)^2 (x - 3) = x^5 - 3 x^4 - 4 x^3 + 12 x^2 + 4 x - 12.
        let all = found(&[-12, 4, 12, -4, -3, 1]);
        let root = 2.0_f64.sqrt();
        assert_eq!(all[0], (3.0, 0.0, 1, whole(&[-3, 1])));
        assert_eq!(all[1], (root, 0.0, 2, whole(&[-2, 0, 1])));
        assert_eq!(all[2], (-root, 0.0, 2, whole(&[-2, 0, 1])));
        // x^4 + 4 = (x^2 + 2 x + 2) (x^2 - 2 x + 2).
        let all = found(&[4, 0, 0, 0, 1]);
        assert_eq!(all[0], (1.0, 1.0, 1, whole(&[2, -2, 1])));
        assert_eq!(all[1], (-1.0, 1.0, 1, whole(&[2, 2, 1])));
        // With fractions: (x - 1/2) (x^2 + 1/3).
        let polynomial =
            [(-1, 6), (1, 3), (-1, 2), (1, 1)].map(|(over, under)| Rational::fraction(over, under));
        let all = roots(&polynomial).unwrap();
        assert_eq!(all[0].factor, [(1, 3), (0, 1), (1, 1)].map(|(a, b)| Rational::fraction(a, b)));
        assert_eq!(all[1].factor, [(-1, 2), (1, 1)].map(|(a, b)| Rational::fraction(a, b)));
    }
}
