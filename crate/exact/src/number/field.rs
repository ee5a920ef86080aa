//! Number fields: the rationals with one root of a polynomial.

use std::cmp::Ordering;
use std::sync::OnceLock;

use num_bigint::BigInt;

use crate::error::ExactError;
use crate::number::factor;
use crate::number::interval::Interval;
use crate::number::matrix::{Echelon, Matrix};
use crate::number::polynomial::Polynomial;
use crate::number::rational::Rational;
use crate::number::roots::{ComplexInterval, Root, roots};

/// The degree up to which fields are computed with.
pub const LARGEST_FIELD: usize = 16;

/// The field `Q[x]/(p)` of an irreducible polynomial p, and the root of p that x stands for.
#[derive(Debug)]
pub struct Field {
    whole: Vec<BigInt>,
    monic: Polynomial,
    roots: Vec<Root>,
    chosen: usize,
    /// x^n and the powers after it, as far as a product of two elements needs.
    high: Vec<Vec<Rational>>,
    /// The powers of each root, from 0.
    powers: Vec<Vec<ComplexInterval>>,
    conjugate: OnceLock<Option<Element>>,
}

/// An element of a [`Field`]: the factors of the powers of x, from 0.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Element(pub(crate) Vec<Rational>);

impl Element {
    /// The factors of the powers of x, from 0.
    #[must_use]
    pub fn coefficients(&self) -> &[Rational] {
        &self.0
    }
}

impl PartialEq for Field {
    fn eq(&self, other: &Self) -> bool {
        self.whole == other.whole && self.chosen == other.chosen
    }
}

impl Field {
    /// The rationals alone.
    #[must_use]
    pub fn rationals() -> Self {
        let whole = vec![BigInt::ZERO, 1.into()];
        let root = Root { place: ComplexInterval::real(Interval::ZERO), is_real: true };
        Self::assembled(whole, vec![root], 0)
    }

    /// The field of the root of a polynomial, constant term first, that lies in a box. The polynomial may be reducible
    /// and have roots several times: the factor with that root is found.
    ///
    /// # Errors
    /// Where there is no such root or more than one, or the degree of its factor is more than [`LARGEST_FIELD`].
    pub fn of_root(coefficients: &[BigInt], within: ComplexInterval) -> Result<Self, ExactError> {
        Self::of_root_up_to(&Polynomial::of_whole(coefficients), within, LARGEST_FIELD)
    }

    pub(crate) fn of_root_up_to(
        polynomial: &Polynomial,
        within: ComplexInterval,
        most: usize,
    ) -> Result<Self, ExactError> {
        if polynomial.degree() == 0 {
            return Err(ExactError::NoRoot);
        }
        let (mut found, mut count) = (None, 0);
        for factor in factor::factors(polynomial)? {
            let roots = roots(&Polynomial::of_whole(&factor))?;
            for (k, _) in roots.iter().enumerate().filter(|(_, root)| root.place.meets(within)) {
                count += 1;
                found = Some((factor.clone(), roots.clone(), k));
            }
        }
        match found {
            Some((factor, _, _)) if factor.len() > most + 1 => {
                Err(ExactError::DegreeTooLarge { degree: factor.len() - 1, most })
            }
            Some((factor, roots, k)) if count == 1 => Ok(Self::assembled(factor, roots, k)),
            _ => Err(ExactError::NotOneRoot { count }),
        }
    }

    fn assembled(whole: Vec<BigInt>, roots: Vec<Root>, chosen: usize) -> Self {
        let monic = Polynomial::of_whole(&whole).monic();
        let n = monic.degree();
        let lower = &monic.coefficients()[..n];
        let mut high: Vec<Vec<Rational>> = vec![lower.iter().map(|c| -c).collect()];
        while high.len() + 1 < n {
            let last = &high[high.len() - 1];
            let top = &last[n - 1];
            let shifted = |k: usize| if k == 0 { Rational::ZERO } else { last[k - 1].clone() };
            high.push((0..n).map(|k| &shifted(k) + &(top * &high[0][k])).collect());
        }
        let powers_of = |root: &Root| {
            let mut powers = vec![ComplexInterval::real(Interval::ONE)];
            while powers.len() < n {
                powers.push(powers[powers.len() - 1].times(root.place));
            }
            powers
        };
        let powers = roots.iter().map(powers_of).collect();
        Self { whole, monic, roots, chosen, high, powers, conjugate: OnceLock::new() }
    }

    /// How many rationals an element is made of.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.monic.degree()
    }

    /// The irreducible polynomial, constant term first.
    #[must_use]
    pub fn polynomial(&self) -> &[BigInt] {
        &self.whole
    }

    pub(crate) const fn monic(&self) -> &Polynomial {
        &self.monic
    }

    /// All roots of the polynomial: the real ones from left to right, then the others.
    #[must_use]
    pub fn roots(&self) -> &[Root] {
        &self.roots
    }

    /// Which of the roots x stands for.
    #[must_use]
    pub const fn chosen(&self) -> usize {
        self.chosen
    }

    /// The root that x stands for.
    #[must_use]
    pub fn root(&self) -> Root {
        self.roots[self.chosen]
    }

    /// Whether all elements are real numbers.
    #[must_use]
    pub fn is_real(&self) -> bool {
        self.root().is_real
    }

    /// A rational as an element.
    #[must_use]
    pub fn rational(&self, value: Rational) -> Element {
        let mut all = vec![Rational::ZERO; self.degree()];
        all[0] = value;
        Element(all)
    }

    /// Zero.
    #[must_use]
    pub fn zero(&self) -> Element {
        self.rational(Rational::ZERO)
    }

    /// One.
    #[must_use]
    pub fn one(&self) -> Element {
        self.rational(Rational::ONE)
    }

    /// The root itself.
    #[must_use]
    pub fn generator(&self) -> Element {
        self.element(&[Rational::ZERO, Rational::ONE])
    }

    /// The value of a polynomial at the root.
    #[must_use]
    pub fn element(&self, coefficients: &[Rational]) -> Element {
        self.reduced(&Polynomial::new(coefficients.to_vec()))
    }

    pub(crate) fn reduced(&self, polynomial: &Polynomial) -> Element {
        let rest = polynomial.divided(&self.monic).map_or_else(Polynomial::default, |(_, rest)| rest);
        let mut all = rest.coefficients().to_vec();
        all.resize(self.degree(), Rational::ZERO);
        Element(all)
    }

    /// Whether an element is zero.
    #[must_use]
    pub fn is_zero(&self, a: &Element) -> bool {
        a.0.iter().all(Rational::is_zero)
    }

    /// The rational that an element is, if it is one.
    #[must_use]
    pub fn as_rational<'a>(&self, a: &'a Element) -> Option<&'a Rational> {
        a.0[1..].iter().all(Rational::is_zero).then_some(&a.0[0])
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, a: &Element, b: &Element) -> Element {
        Element(crate::number::matrix::sum(&a.0, &b.0))
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, a: &Element, b: &Element) -> Element {
        Element(crate::number::matrix::difference(&a.0, &b.0))
    }

    /// The product.
    #[must_use]
    pub fn times(&self, a: &Element, b: &Element) -> Element {
        let n = self.degree();
        let mut product = vec![Rational::ZERO; 2 * n - 1];
        for (i, x) in a.0.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
            for (j, y) in b.0.iter().enumerate().filter(|(_, y)| !y.is_zero()) {
                product[i + j] = &product[i + j] + &(x * y);
            }
        }
        let high = product.split_off(n);
        for (factor, power) in high.iter().zip(&self.high).filter(|(factor, _)| !factor.is_zero()) {
            for (x, p) in product.iter_mut().zip(power) {
                *x = &*x + &(factor * p);
            }
        }
        Element(product)
    }

    /// One over an element, `None` for zero.
    #[must_use]
    pub fn inverse(&self, a: &Element) -> Option<Element> {
        if self.is_zero(a) {
            return None;
        }
        let (_, inverse) = Polynomial::new(a.0.clone()).bezout(&self.monic);
        Some(self.reduced(&inverse))
    }

    /// A power with a whole exponent, `None` for a negative one of zero.
    #[must_use]
    pub fn power(&self, a: &Element, exponent: i32) -> Option<Element> {
        let mut base = if exponent < 0 { self.inverse(a)? } else { a.clone() };
        let (mut exponent, mut power) = (exponent.unsigned_abs(), self.one());
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = self.times(&power, &base);
            }
            base = self.times(&base, &base);
            exponent >>= 1;
        }
        Some(power)
    }

    /// A box around an element, seen as the number that it is.
    #[must_use]
    pub fn enclosure(&self, a: &Element) -> ComplexInterval {
        self.enclosure_at(&a.0, self.chosen)
    }

    /// A box around what an element becomes where x stands for another root.
    pub(crate) fn enclosure_at(&self, coefficients: &[Rational], root: usize) -> ComplexInterval {
        let mut sum = ComplexInterval::real(Interval::ZERO);
        for (c, power) in coefficients.iter().zip(&self.powers[root]).filter(|(c, _)| !c.is_zero()) {
            let c = c.enclosure();
            sum = sum.plus(ComplexInterval { re: c * power.re, im: c * power.im });
        }
        sum
    }

    /// The sign of an element, exactly. `None` where the field is not real.
    #[must_use]
    pub fn sign(&self, a: &Element) -> Option<Ordering> {
        if !self.is_real() {
            return self.as_rational(a).map(Rational::sign);
        }
        if self.is_zero(a) {
            return Some(Ordering::Equal);
        }
        let near = self.enclosure(a).re;
        if near.lower() > 0.0 || near.upper() < 0.0 {
            return Some(near.lower().total_cmp(&0.0));
        }
        // The root is halved in on, until the value at it is seen apart from zero, which it is not.
        let place = self.root().place.re;
        let (mut lower, mut upper) = (Rational::from_f64(place.lower())?, Rational::from_f64(place.upper())?);
        let half = Rational::new(1, 2)?;
        let first = self.monic.at(&lower).sign();
        loop {
            let (low, high) = between(&a.0, &lower, &upper);
            if low.sign() == Ordering::Greater || high.sign() == Ordering::Less {
                return Some(low.sign());
            }
            let middle = &(&lower + &upper) * &half;
            match self.monic.at(&middle).sign() {
                Ordering::Equal => (lower, upper) = (middle.clone(), middle),
                sign if sign == first => lower = middle,
                _ => upper = middle,
            }
        }
    }

    /// How two elements of a real field compare.
    #[must_use]
    pub fn compare(&self, a: &Element, b: &Element) -> Option<Ordering> {
        self.sign(&self.minus(a, b))
    }

    /// The complex conjugate of an element, if it is in the field.
    ///
    /// Where conjugation commutes with all ways to send the field into the complex numbers (real fields, imaginary
    /// quadratic ones, cyclotomic ones, all with complex multiplication), the conjugate of the generator follows from
    /// the traces of its products with powers. What is found in doubles is checked exactly.
    #[must_use]
    pub fn conjugate(&self, a: &Element) -> Option<Element> {
        if self.is_real() {
            return Some(a.clone());
        }
        let generator = self.conjugate.get_or_init(|| self.conjugate_generator()).as_ref()?;
        Some(self.substitute(&a.0, self, generator))
    }

    /// The value of a polynomial at an element of another field.
    pub(crate) fn substitute(&self, coefficients: &[Rational], target: &Self, at: &Element) -> Element {
        let constant = |c: &Rational| target.rational(c.clone());
        coefficients
            .iter()
            .rev()
            .fold(target.zero(), |sum, c| target.plus(&target.times(&sum, at), &constant(c)))
    }

    fn conjugate_generator(&self) -> Option<Element> {
        let n = self.degree();
        let mut power = self.one();
        let mut traces = Vec::new();
        for _ in 0..2 * n - 1 {
            traces.push(self.trace(&power));
            power = self.times(&power, &self.generator());
        }
        let lead = Rational::from(self.whole[n].clone());
        let mut wanted = Vec::new();
        for j in 0..n {
            let products = self.powers.iter().zip(&self.roots).map(|(powers, root)| {
                let product = powers[j].times(root.place.conjugate());
                product.re.middle()
            });
            // Times a power of the leading coefficient it is a whole number.
            let scale = lead.power(j as i32 + 1)?;
            let whole = (products.sum::<f64>() * scale.to_f64()).round();
            wanted.push((&Rational::from_f64(whole)? / &scale)?);
        }
        let columns: Vec<Vec<Rational>> = (0..n).map(|k| traces[k..k + n].to_vec()).collect();
        let found = Element(Matrix::from_columns(&columns).inverse()?.apply(&wanted));
        let is_root = self.is_zero(&self.substitute(self.monic.coefficients(), self, &found));
        let place = self.enclosure(&found);
        let mirrored = self.root().place.conjugate();
        let others = self.roots.iter().filter(|root| root.place.meets(place)).count();
        (is_root && place.meets(mirrored) && others == 1).then_some(found)
    }

    fn trace(&self, a: &Element) -> Rational {
        let matrix = self.multiplication(a);
        (0..self.degree()).fold(Rational::ZERO, |sum, k| &sum + &matrix.row(k)[k])
    }

    /// Multiplication by an element, as a matrix that acts on coefficients.
    pub(crate) fn multiplication(&self, a: &Element) -> Matrix {
        let (mut columns, mut power) = (Vec::new(), a.clone());
        for _ in 0..self.degree() {
            columns.push(power.0.clone());
            power = self.times(&power, &self.generator());
        }
        Matrix::from_columns(&columns)
    }

    /// The irreducible polynomial of an element, constant term first.
    #[must_use]
    pub fn minimal_polynomial(&self, a: &Element) -> Vec<BigInt> {
        let (mut space, mut power) = (Echelon::default(), self.one());
        loop {
            if let Some(factors) = space.insert(power.0.clone()) {
                let mut all: Vec<Rational> = factors.iter().map(|factor| -factor).collect();
                all.push(Rational::ONE);
                return Polynomial::new(all).primitive();
            }
            power = self.times(&power, a);
        }
    }
}

/// The least and the largest value that Horner's rule allows on an interval of fractions.
pub(crate) fn between(coefficients: &[Rational], lower: &Rational, upper: &Rational) -> (Rational, Rational) {
    let (mut low, mut high) = (Rational::ZERO, Rational::ZERO);
    for c in coefficients.iter().rev() {
        let mut all = [&low * lower, &low * upper, &high * lower, &high * upper];
        all.sort();
        (low, high) = (&all[0] + c, &all[3] + c);
    }
    (low, high)
}
