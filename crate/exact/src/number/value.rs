//! Numbers that bring their field along.

use std::fmt;
use std::sync::Arc;

use num_bigint::BigInt;
use num_traits::One;

use crate::error::ExactError;
use crate::number::compositum::compositum;
use crate::number::field::{Element, Field, LARGEST_FIELD};
use crate::number::interval::Interval;
use crate::number::polynomial::Polynomial;
use crate::number::rational::Rational;
use crate::number::roots::ComplexInterval;

/// An algebraic number: an element of a [`Field`].
#[derive(Clone, Debug)]
pub struct Number {
    field: Arc<Field>,
    element: Element,
}

impl From<Rational> for Number {
    fn from(value: Rational) -> Self {
        Self { field: Arc::new(Field::rationals()), element: Element(vec![value]) }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.minus(other).is_ok_and(|difference| difference.is_zero())
    }
}

impl Number {
    /// An element of a field.
    #[must_use]
    pub fn new(field: &Arc<Field>, element: Element) -> Self {
        let number = Self { field: field.clone(), element };
        match number.as_rational() {
            Some(value) => value.clone().into(),
            None => number,
        }
    }

    /// A whole number.
    #[must_use]
    pub fn whole(number: i64) -> Self {
        Rational::whole(number).into()
    }

    /// The root of a polynomial, constant term first, in a box.
    ///
    /// # Errors
    /// See [`Field::of_root`].
    pub fn root_of(coefficients: &[BigInt], within: ComplexInterval) -> Result<Self, ExactError> {
        let field = Arc::new(Field::of_root(coefficients, within)?);
        let element = field.generator();
        Ok(Self::new(&field, element))
    }

    /// Its field.
    #[must_use]
    pub const fn field(&self) -> &Arc<Field> {
        &self.field
    }

    /// What it is in its field.
    #[must_use]
    pub const fn element(&self) -> &Element {
        &self.element
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.field.is_zero(&self.element)
    }

    /// The rational that it is, if it is one.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        self.field.as_rational(&self.element)
    }

    /// A box around it.
    #[must_use]
    pub fn enclosure(&self) -> ComplexInterval {
        self.field.enclosure(&self.element)
    }

    /// A double near its real part.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.enclosure().re.middle()
    }

    /// Both in one field.
    fn together(&self, other: &Self) -> Result<(Arc<Field>, Element, Element), ExactError> {
        if let Some(value) = other.as_rational() {
            return Ok((self.field.clone(), self.element.clone(), self.field.rational(value.clone())));
        }
        if let Some(value) = self.as_rational() {
            return Ok((other.field.clone(), other.field.rational(value.clone()), other.element.clone()));
        }
        let both = compositum(&self.field, &other.field)?;
        let first = self.field.substitute(&self.element.0, &both.field, &both.first);
        let second = other.field.substitute(&other.element.0, &both.field, &both.second);
        Ok((both.field, first, second))
    }

    /// The sum.
    ///
    /// # Errors
    /// Where the field of both is too large.
    pub fn plus(&self, other: &Self) -> Result<Self, ExactError> {
        let (field, a, b) = self.together(other)?;
        Ok(Self::new(&field, field.plus(&a, &b)))
    }

    /// The difference.
    ///
    /// # Errors
    /// As [`Number::plus`].
    pub fn minus(&self, other: &Self) -> Result<Self, ExactError> {
        let (field, a, b) = self.together(other)?;
        Ok(Self::new(&field, field.minus(&a, &b)))
    }

    /// The product.
    ///
    /// # Errors
    /// As [`Number::plus`].
    pub fn times(&self, other: &Self) -> Result<Self, ExactError> {
        let (field, a, b) = self.together(other)?;
        Ok(Self::new(&field, field.times(&a, &b)))
    }

    /// The quotient.
    ///
    /// # Errors
    /// As [`Number::plus`], and for a division by zero.
    pub fn over(&self, other: &Self) -> Result<Self, ExactError> {
        let (field, a, b) = self.together(other)?;
        let inverse = field.inverse(&b).ok_or(ExactError::DivisionByZero)?;
        Ok(Self::new(&field, field.times(&a, &inverse)))
    }

    /// Its negative.
    #[must_use]
    pub fn negative(&self) -> Self {
        Self::new(&self.field, self.field.minus(&self.field.zero(), &self.element))
    }

    /// A power with a whole exponent.
    ///
    /// # Errors
    /// For a negative power of zero.
    pub fn power(&self, exponent: i32) -> Result<Self, ExactError> {
        let power = self.field.power(&self.element, exponent).ok_or(ExactError::DivisionByZero)?;
        Ok(Self::new(&self.field, power))
    }

    /// The principal n-th root: of a positive number the positive one, else the one with the smallest angle in the
    /// upper half plane (but for odd roots of negative numbers, which are negative).
    ///
    /// # Errors
    /// Where its degree is too large.
    pub fn root(&self, n: u32) -> Result<Self, ExactError> {
        if n == 0 || n > 64 {
            return Err(ExactError::DegreeTooLarge { degree: n as usize, most: 64 });
        }
        if self.is_zero() || n == 1 {
            return Ok(self.clone());
        }
        let place = self.enclosure();
        let is_real = self.field.is_real() || self.as_rational().is_some();
        if is_real && n % 2 == 1 && place.re.upper() < 0.0 {
            return Ok(self.negative().root(n)?.negative());
        }
        let minimal = self.field.minimal_polynomial(&self.element);
        let mut coefficients = vec![Rational::ZERO; (minimal.len() - 1) * n as usize + 1];
        for (k, c) in minimal.into_iter().enumerate() {
            coefficients[k * n as usize] = c.into();
        }
        let (x, y) = (place.re.middle(), if is_real { 0.0 } else { place.im.middle() });
        let (size, angle) = (x.hypot(y).powf(1.0 / f64::from(n)), y.atan2(x) / f64::from(n));
        let grown = Interval::new(-1e-9 * size, 1e-9 * size);
        let near = |x: f64| Interval::point(x) + grown;
        let within = ComplexInterval { re: near(size * angle.cos()), im: near(size * angle.sin()) };
        let field = Arc::new(Field::of_root_up_to(&Polynomial::new(coefficients), within, LARGEST_FIELD)?);
        let element = field.generator();
        Ok(Self::new(&field, element))
    }

    /// The same number in the field that it generates.
    ///
    /// # Errors
    /// Where doubles do not tell its conjugates apart.
    pub fn in_own_field(&self) -> Result<Self, ExactError> {
        Self::root_of(&self.field.minimal_polynomial(&self.element), self.enclosure())
    }

    /// The number `exp(pi i t)` for a rational t.
    ///
    /// # Errors
    /// Where its degree is more than twice [`LARGEST_FIELD`].
    pub fn turn(t: &Rational) -> Result<Self, ExactError> {
        let tooth = |degree| ExactError::DegreeTooLarge { degree, most: LARGEST_FIELD };
        let half = &(t * &Rational::new(1, 2).unwrap_or(Rational::ZERO));
        let order: usize = half.denominator().try_into().map_err(|_| tooth(usize::MAX))?;
        if order > 360 {
            return Err(tooth(order));
        }
        let polynomial = cyclotomic(order);
        if polynomial.degree() > 2 * LARGEST_FIELD {
            return Err(tooth(polynomial.degree()));
        }
        let steps = num_integer::Integer::mod_floor(&half.numerator(), &half.denominator());
        let angle = std::f64::consts::TAU * Rational::from(steps).to_f64() / order as f64;
        let near = |x: f64| Interval::new(x - 1e-9, x + 1e-9);
        let within = ComplexInterval { re: near(angle.cos()), im: near(angle.sin()) };
        let field = Arc::new(Field::of_root_up_to(&polynomial, within, 2 * LARGEST_FIELD)?);
        let element = field.generator();
        Ok(Self::new(&field, element))
    }

    /// The cosine of pi times a rational, in a real field.
    ///
    /// # Errors
    /// As [`Number::turn`].
    pub fn cosine(t: &Rational) -> Result<Self, ExactError> {
        let turn = Self::turn(t)?;
        let inverse = turn.power(-1)?;
        turn.plus(&inverse)?.over(&Self::whole(2))?.in_own_field()
    }

    /// The imaginary unit.
    ///
    /// # Errors
    /// None in fact: its field is known.
    pub fn i() -> Result<Self, ExactError> {
        Self::turn(&Rational::new(1, 2).unwrap_or(Rational::ZERO))
    }

    /// Elements of one field that are these numbers.
    ///
    /// # Errors
    /// Where the field is too large.
    pub fn in_one_field(numbers: &[Self]) -> Result<(Arc<Field>, Vec<Element>), ExactError> {
        let mut field = Arc::new(Field::rationals());
        // The fields so far, and where their generators are.
        let mut known: Vec<(Arc<Field>, Element)> = Vec::new();
        for number in numbers.iter().filter(|number| number.as_rational().is_none()) {
            if known.iter().any(|(field, _)| field == &number.field) {
                continue;
            }
            let both = compositum(&field, &number.field)?;
            for (_, generator) in &mut known {
                *generator = field.substitute(&generator.0, &both.field, &both.first);
            }
            known.push((number.field.clone(), both.second));
            field = both.field;
        }
        let place = |number: &Self| {
            if let Some(value) = number.as_rational() {
                return field.rational(value.clone());
            }
            let known = known.iter().find(|(own, _)| own == &number.field);
            known.map_or_else(
                || field.zero(),
                |(own, generator)| own.substitute(&number.element.0, &field, generator),
            )
        };
        let elements = numbers.iter().map(place).collect();
        Ok((field, elements))
    }
}

/// The polynomial of the primitive roots of unity of an order.
fn cyclotomic(order: usize) -> Polynomial {
    let mut coefficients = vec![Rational::ZERO; order + 1];
    (coefficients[0], coefficients[order]) = (Rational::whole(-1), Rational::ONE);
    let mut all = Polynomial::new(coefficients);
    for divisor in (1..order).filter(|divisor| order.is_multiple_of(*divisor)) {
        if let Some((quotient, _)) = all.divided(&cyclotomic(divisor)) {
            all = quotient;
        }
    }
    all
}

impl fmt::Display for Number {
    /// As the value of a polynomial at the root of another: `1/2 + x, x^2 - 3 = 0, x = 1.7320508`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(value) = self.as_rational() {
            return write!(f, "{value}");
        }
        write_polynomial(f, &self.element.0)?;
        let whole: Vec<Rational> = self.field.polynomial().iter().map(|c| c.clone().into()).collect();
        write!(f, ", ")?;
        write_polynomial(f, &whole)?;
        let place = self.field.root().place;
        write!(f, " = 0, x = {:.7}", place.re.middle())?;
        if self.field.is_real() { Ok(()) } else { write!(f, " {:+.7} i", place.im.middle()) }
    }
}

fn write_polynomial(f: &mut fmt::Formatter<'_>, coefficients: &[Rational]) -> fmt::Result {
    let mut is_first = true;
    for (k, c) in coefficients.iter().enumerate().rev().filter(|(_, c)| !c.is_zero()) {
        let is_negative = c.sign() == std::cmp::Ordering::Less;
        let sign = match (is_first, is_negative) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        is_first = false;
        let size = c.abs();
        write!(f, "{sign}")?;
        if k == 0 || !(size.is_whole() && size.numerator().is_one()) {
            write!(f, "{size}{}", if k == 0 { "" } else { " " })?;
        }
        match k {
            0 => {}
            1 => write!(f, "x")?,
            _ => write!(f, "x^{k}")?,
        }
    }
    Ok(())
}
