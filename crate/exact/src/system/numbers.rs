//! Rows of doubles, some of which are meant for exact numbers.

use std::sync::Arc;

use num_bigint::BigInt;
use thiserror::Error;

use crate::error::ExactError;
use crate::number::field::{Element, Field, between};
use crate::number::rational::Rational;
use crate::number::value::Number;
use crate::system::build::{RealMap, System};

/// The most formulas of one list.
pub const MOST_NUMBERS: usize = 64;

/// A number that was given as a formula.
#[derive(Clone, Debug)]
pub struct ExactNumber {
    number: Number,
    value: f64,
}

/// Numbers that doubles stand for: a double that is the nearest to one of them, or to its negative, is that number.
/// Any other double is itself.
#[derive(Clone, Debug, Default)]
pub struct ExactNumbers {
    all: Vec<ExactNumber>,
}

/// One formula of a list is refused.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("number {}: {error}", .index + 1)]
pub struct WrongNumber {
    /// Which one, from 0.
    pub index: usize,
    /// Why.
    pub error: ExactError,
}

impl ExactNumber {
    /// A real number, from a formula.
    ///
    /// # Errors
    /// As [`Number::parse`]; and for numbers that are not real, that are beyond all doubles, or so near to zero that
    /// the double is zero.
    pub fn read(formula: &str) -> Result<Self, ExactError> {
        let number = Number::parse(formula)?.in_real_field()?;
        let value = number.nearest().ok_or(ExactError::NoDouble)?;
        if value == 0.0 && !number.is_zero() {
            return Err(ExactError::NoDouble);
        }
        Ok(Self { number, value: value + 0.0 })
    }

    /// The number.
    #[must_use]
    pub const fn number(&self) -> &Number {
        &self.number
    }

    /// The double nearest to it.
    #[must_use]
    pub const fn value(&self) -> f64 {
        self.value
    }

    /// As [`Number::text`].
    #[must_use]
    pub fn text(&self) -> Option<String> {
        self.number.text()
    }
}

impl ExactNumbers {
    /// Reads a list of formulas.
    ///
    /// # Errors
    /// As [`ExactNumber::read`], with the place of the formula in the list; where there are more than
    /// [`MOST_NUMBERS`]; and for a number whose double stands for another one of the list.
    pub fn read<S: AsRef<str>>(formulas: &[S]) -> Result<Self, WrongNumber> {
        let mut all: Vec<ExactNumber> = Vec::new();
        for (index, formula) in formulas.iter().enumerate() {
            let wrong = |error| WrongNumber { index, error };
            if index >= MOST_NUMBERS {
                return Err(wrong(ExactError::TooMany { count: formulas.len(), most: MOST_NUMBERS }));
            }
            let found = ExactNumber::read(formula.as_ref()).map_err(wrong)?;
            let same =
                all.iter().position(|other| other.value.abs().to_bits() == found.value.abs().to_bits());
            let Some(other) = same else {
                all.push(found);
                continue;
            };
            let turned = all[other].value.is_sign_negative() != found.value.is_sign_negative();
            let number = if turned { found.number.negative() } else { found.number.clone() };
            if number != all[other].number {
                return Err(wrong(ExactError::SameDouble));
            }
        }
        Ok(Self { all })
    }

    /// The number that a double stands for, if it does not stand for itself.
    #[must_use]
    pub fn meant(&self, value: f64) -> Option<Number> {
        let found = self.all.iter().find(|number| number.value.abs() == value.abs())?;
        let is_turned = (found.value < 0.0) != (value < 0.0);
        Some(if is_turned { found.number.negative() } else { found.number.clone() })
    }

    /// The maps of the plane that rows stand for, in one field.
    ///
    /// # Errors
    /// Where a row has a number that is not finite, or the field of all numbers is too large.
    pub fn rows(&self, rows: &[[f64; 6]]) -> Result<ExactRows, ExactError> {
        let (mut numbers, mut named) = (Vec::new(), Vec::new());
        for (map, row) in rows.iter().enumerate() {
            for (entry, &value) in row.iter().enumerate() {
                let meant = self.meant(value);
                if meant.is_some() {
                    named.push((map, entry));
                }
                let own = || Rational::from_f64(value).map(Number::from);
                numbers.push(meant.or_else(own).ok_or(ExactError::Malformed)?);
            }
        }
        let (field, elements) = Number::in_one_field(&numbers)?;
        let rows = elements.chunks_exact(6).filter_map(|row| row.to_vec().try_into().ok()).collect();
        Ok(ExactRows { field, rows, named })
    }

    /// The iterated function system that rows stand for.
    ///
    /// # Errors
    /// As [`ExactNumbers::rows`], and as [`System::of_matrices`].
    pub fn system(&self, rows: &[[f64; 6]]) -> Result<System, ExactError> {
        self.rows(rows)?.system()
    }
}

/// Maps of the plane as rows `[a, b, c, d, e, f]` of numbers of one real field, with `x' = a x + b y + e` and
/// `y' = c x + d y + f`.
#[derive(Clone, Debug)]
pub struct ExactRows {
    field: Arc<Field>,
    rows: Vec<[Element; 6]>,
    named: Vec<(usize, usize)>,
}

impl ExactRows {
    /// The field of all numbers.
    #[must_use]
    pub const fn field(&self) -> &Arc<Field> {
        &self.field
    }

    /// All numbers.
    #[must_use]
    pub fn rows(&self) -> &[[Element; 6]] {
        &self.rows
    }

    /// Which numbers were given by formulas: the map and the place in its row.
    #[must_use]
    pub fn named(&self) -> &[(usize, usize)] {
        &self.named
    }

    /// As a system, whose neighbours can be found.
    ///
    /// # Errors
    /// As [`System::of_matrices`].
    pub fn system(&self) -> Result<System, ExactError> {
        let map =
            |row: &[Element; 6]| RealMap { from: 0, matrix: row[..4].to_vec(), shift: row[4..].to_vec() };
        System::of_matrices(&self.field, 2, &[self.rows.iter().map(map).collect()])
    }

    /// Whether two endless words are the addresses of one point: each `head` once, then `repeat` without end. Letters
    /// are maps, and those that repeat have to contract.
    #[must_use]
    pub fn coincide(&self, words: [[&[u8]; 2]; 2]) -> bool {
        let point = |[head, repeat]: [&[u8]; 2]| self.point(head, repeat);
        match words.map(point) {
            [Some(a), Some(b)] => a == b,
            _ => false,
        }
    }

    /// The point of an address; `None` for a letter that is no map, or where no one point stays where it is.
    fn point(&self, head: &[u8], repeat: &[u8]) -> Option<[Element; 2]> {
        let field = &self.field;
        let [a, b, c, d, e, f] = self.word(repeat)?;
        // (1 - L) x = t.
        let one = field.one();
        let (p, q) = (field.minus(&one, &a), field.minus(&one, &d));
        let determinant = field.minus(&field.times(&p, &q), &field.times(&b, &c));
        let over = field.inverse(&determinant)?;
        let both = |s: &Element, t: &Element, u: &Element, v: &Element| {
            field.times(&field.plus(&field.times(s, t), &field.times(u, v)), &over)
        };
        let mut point = [both(&q, &e, &b, &f), both(&c, &e, &p, &f)];
        for &letter in head.iter().rev() {
            let row = self.rows.get(usize::from(letter))?;
            let image = |k: usize| {
                let [s, t] = [2 * k, 2 * k + 1].map(|entry| &row[entry]);
                let sum = field.plus(&field.times(s, &point[0]), &field.times(t, &point[1]));
                field.plus(&sum, &row[4 + k])
            };
            point = [image(0), image(1)];
        }
        Some(point)
    }

    fn word(&self, letters: &[u8]) -> Option<[Element; 6]> {
        let field = &self.field;
        let mut all = self.rows.get(usize::from(*letters.first()?))?.clone();
        for &letter in &letters[1..] {
            let next = self.rows.get(usize::from(letter))?;
            let entry = |row: usize, column: [usize; 2]| {
                let [s, t] = [2 * row, 2 * row + 1].map(|k| &all[k]);
                field.plus(&field.times(s, &next[column[0]]), &field.times(t, &next[column[1]]))
            };
            let shift = |row: usize| field.plus(&entry(row, [4, 5]), &all[4 + row]);
            all =
                [entry(0, [0, 2]), entry(0, [1, 3]), entry(1, [0, 2]), entry(1, [1, 3]), shift(0), shift(1)];
        }
        Some(all)
    }

    /// The determinant of the linear part of a map.
    fn determinant(&self, map: usize) -> Option<Element> {
        let [a, b, c, d, ..] = self.rows.get(map)?;
        Some(self.field.minus(&self.field.times(a, d), &self.field.times(b, c)))
    }

    /// Whether two maps scale areas by factors with a sum of one or more.
    #[must_use]
    pub fn areas_fill(&self, i: usize, j: usize) -> bool {
        let size = |map: usize| {
            let determinant = self.determinant(map)?;
            let is_negative = self.field.sign(&determinant)? == std::cmp::Ordering::Less;
            let negative = || self.field.minus(&self.field.zero(), &determinant);
            Some(if is_negative { negative() } else { determinant })
        };
        let (Some(a), Some(b)) = (size(i), size(j)) else { return false };
        let sum = self.field.compare(&self.field.plus(&a, &b), &self.field.one());
        sum.is_some_and(std::cmp::Ordering::is_ge)
    }

    /// The ends of an interval around the generator of the field, in which its polynomial rises or falls all along, as
    /// Horner's rule shows for the slope: decimals of few digits.
    #[must_use]
    pub fn root_within(&self) -> Option<[Rational; 2]> {
        if self.field.degree() == 1 {
            return Some([Rational::whole(-1), Rational::ONE]);
        }
        let place = self.field.root().place.re;
        let slope = self.field.monic().derivative();
        for digits in 6..17 {
            let scale = Rational::from(BigInt::from(10).pow(digits));
            let shifted = |x: f64, up: bool| {
                let scaled = &Rational::from_f64(x)? * &scale;
                let floor = num_integer::Integer::div_floor(&scaled.numerator(), &scaled.denominator());
                &Rational::from(if up { floor + 1 } else { floor }) / &scale
            };
            // Beyond what is known of the root, so that it is in the inside.
            let (lower, upper) = (shifted(place.lower().next_down(), false)?, shifted(place.upper(), true)?);
            let (low, high) = between(slope.coefficients(), &lower, &upper);
            if low.sign() == high.sign() && !low.is_zero() {
                return Some([lower, upper]);
            }
        }
        Some([Rational::from_f64(place.lower())?, Rational::from_f64(place.upper())?])
    }
}
