//! Numbers as people write them: 1/3, √3/6, (1+√5)/4.

use std::cmp::Ordering;
use std::sync::Arc;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive};

use crate::error::ExactError;
use crate::number::field::{Element, Field};
use crate::number::interval::Interval;
use crate::number::rational::Rational;
use crate::number::roots::ComplexInterval;
use crate::number::value::Number;

/// No longer text is written.
const LONGEST: usize = 60;
/// Numbers under a root up to this are searched for squares.
const LARGEST_UNDER_ROOT: u64 = 1_000_000_000_000;

impl Number {
    /// The shortest usual form of a fraction, or of a number `(a + b√d)/c`, which [`Number::parse`] reads. `None` for
    /// all others, and for very long ones.
    #[must_use]
    pub fn text(&self) -> Option<String> {
        let text = match self.as_rational() {
            Some(value) => value.to_string(),
            None => Surd::of(self)?.text(),
        };
        (text.chars().count() <= LONGEST).then_some(text)
    }

    /// The same real number in the least field that has it, a square root of a whole number where that is possible: so
    /// numbers of one quadratic field have the same field.
    ///
    /// # Errors
    /// [`ExactError::NotReal`], or where doubles do not tell its conjugates apart.
    pub fn in_real_field(&self) -> Result<Self, ExactError> {
        if self.as_rational().is_some() {
            return Ok(self.clone());
        }
        let own = self.in_own_field()?;
        if !own.field().is_real() {
            return Err(ExactError::NotReal);
        }
        let Some(surd) = Surd::of(&own) else { return Ok(own) };
        let within = ComplexInterval::real(Interval::new(0.0, f64::MAX));
        let field = Arc::new(Field::of_root(&[-BigInt::from(surd.d), BigInt::ZERO, 1.into()], within)?);
        Ok(Self::new(&field, Element(vec![surd.a, surd.b])))
    }
}

/// `a + b√d`, where d is no multiple of a square.
struct Surd {
    a: Rational,
    b: Rational,
    d: u64,
}

impl Surd {
    /// `None` where the number is none, or d is too large to be searched for squares.
    fn of(number: &Number) -> Option<Self> {
        if !number.field().is_real() {
            return None;
        }
        let minimal = number.field().minimal_polynomial(number.element());
        let [c, b, a] = &minimal[..] else { return None };
        let discriminant: BigInt = b * b - BigInt::from(4) * a * c;
        let all = discriminant.to_u64().filter(|all| *all <= LARGEST_UNDER_ROOT)?;
        let (mut d, mut root, mut k) = (all, 1u64, 2u64);
        while k * k <= d {
            while d.is_multiple_of(k * k) {
                (d, root) = (d / (k * k), root * k);
            }
            k += 1;
        }
        let over = BigInt::from(2) * a;
        let middle = Rational::from_parts(-b, over.clone())?;
        let half = Rational::from_parts(root.into(), over)?;
        // The leading coefficient is positive: the larger root has the positive square root.
        let difference = number.minus(&middle.clone().into()).ok()?;
        let is_larger = difference.field().sign(difference.element())? == Ordering::Greater;
        Some(Self { a: middle, b: if is_larger { half } else { -&half }, d })
    }

    fn text(&self) -> String {
        let over = self.a.denominator().lcm(&self.b.denominator());
        let whole = |x: &Rational| x.numerator() * (&over / x.denominator());
        let (p, q) = (whole(&self.a), whole(&self.b));
        let times = if q.abs().is_one() { String::new() } else { q.abs().to_string() };
        let root = format!("{times}√{}", self.d);
        let (is_sum, text) = match (p.sign(), q.is_negative()) {
            (num_bigint::Sign::NoSign, is_negative) => (false, format!("{}{root}", minus(is_negative))),
            (num_bigint::Sign::Plus, is_negative) => {
                (true, format!("{p}{}{root}", if is_negative { '-' } else { '+' }))
            }
            (num_bigint::Sign::Minus, false) => (true, format!("{root}-{}", -p)),
            (num_bigint::Sign::Minus, true) => {
                let text = format!("-({}+{root})", -p);
                return if over.is_one() { text } else { format!("{text}/{over}") };
            }
        };
        match (over.is_one(), is_sum) {
            (true, _) => text,
            (false, false) => format!("{text}/{over}"),
            (false, true) => format!("({text})/{over}"),
        }
    }
}

const fn minus(is_negative: bool) -> &'static str {
    if is_negative { "-" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_usual_form() {
        for (formula, wanted) in [
            ("2/6", "1/3"),
            ("-0.25", "-1/4"),
            ("cos(60°)/3", "1/6"),
            ("sqrt(3)/6", "√3/6"),
            ("-1/sqrt(12)", "-√3/6"),
            ("5*sqrt(75)/70", "5√3/14"),
            ("phi/2", "(1+√5)/4"),
            ("1-phi", "(1-√5)/2"),
            ("phi-1", "(√5-1)/2"),
            ("-phi", "-(1+√5)/2"),
            ("-1-sqrt(2)", "-(1+√2)"),
            ("1+sqrt(8)", "1+2√2"),
            ("sqrt(2)*sqrt(3)", "√6"),
            ("cos(72°)", "(√5-1)/4"),
            ("sqrt(2)*sqrt(2)*sqrt(3)", "2√3"),
        ] {
            let number = Number::parse(formula).unwrap();
            let text = number.text();
            assert_eq!(text.as_deref(), Some(wanted), "{formula}");
            assert_eq!(Number::parse(wanted).unwrap(), number, "{formula}");
        }
        for formula in ["cos(40°)", "2^(1/3)", "sqrt(2)+sqrt(3)", "i", "1e200"] {
            assert_eq!(Number::parse(formula).unwrap().text(), None, "{formula}");
        }
    }

    #[test]
    fn numbers_of_one_quadratic_field_have_the_same_field() {
        let [a, b] = ["cos(72°)", "7*sqrt(20)-1/3"]
            .map(|formula| Number::parse(formula).unwrap().in_real_field().unwrap());
        assert!(a.field() == b.field() && a.field().polynomial() == [-5, 0, 1].map(BigInt::from));
        assert_eq!(a, Number::parse("cos(72°)").unwrap());
        // A product of complex numbers is real, and so is its field.
        let product = Number::parse("i*sqrt(3)*i").unwrap().in_real_field().unwrap();
        assert!(product.field().is_real() && (product.to_f64() + 3f64.sqrt()).abs() < 1e-14);
        assert_eq!(Number::parse("i").unwrap().in_real_field().unwrap_err(), ExactError::NotReal);
    }
}
