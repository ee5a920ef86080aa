//! Formulas as people write them, read as exact numbers: 1/3, 0.25, sqrt(3)/2, cos 60°, (1 + i)/2, 2^(1/3).

use num_bigint::BigInt;
use num_traits::ToPrimitive;

use crate::error::ExactError;
use crate::number::rational::Rational;
use crate::number::value::Number;

/// No formula is longer; so neither is the way into its brackets.
const LONGEST: usize = 200;
/// Digits after the point, and the size of exponents.
const LARGEST_EXPONENT: i32 = 400;
/// The largest whole exponent of a power.
const LARGEST_POWER: i32 = 64;
/// Binary digits of the numbers that a value is made of.
const LARGEST_VALUE: u64 = 1400;
/// Binary digits that a power is computed with.
const LARGEST_WORK: u64 = 20_000;

impl Number {
    /// The number that a formula means. Decimals are fractions: 0.1 is one tenth. Degrees and multiples of pi may stand
    /// in sines and cosines alone; `phi` is the golden ratio.
    ///
    /// # Errors
    /// [`ExactError::NotFormula`], [`ExactError::NotExact`], or what went wrong in the arithmetic.
    pub fn parse(text: &str) -> Result<Self, ExactError> {
        if text.chars().count() > LONGEST {
            return Err(ExactError::NotFormula { at: text.len() });
        }
        let mut reader = Reader { all: text, rest: text.trim_start() };
        let found = reader.sum()?;
        if !reader.rest.is_empty() {
            return reader.wrong();
        }
        reader.number(found)
    }
}

/// A part of a formula.
#[derive(Clone)]
enum Part {
    Number(Number),
    /// So many times pi.
    Angle(Rational),
}

struct Reader<'a> {
    all: &'a str,
    rest: &'a str,
}

impl Reader<'_> {
    const fn at(&self) -> usize {
        self.all.len() - self.rest.len()
    }

    const fn wrong<T>(&self) -> Result<T, ExactError> {
        Err(ExactError::NotFormula { at: self.at() })
    }

    const fn inexact(&self) -> ExactError {
        ExactError::NotExact { at: self.at() }
    }

    fn number(&self, part: Part) -> Result<Number, ExactError> {
        match part {
            Part::Number(number) => Ok(number),
            Part::Angle(t) if t.is_zero() => Ok(Number::whole(0)),
            Part::Angle(_) => Err(self.inexact()),
        }
    }

    /// Nothing grows without end, however often it is multiplied.
    fn bounded(&self, number: Number) -> Result<Part, ExactError> {
        if digits(&number) > LARGEST_VALUE { Err(self.inexact()) } else { Ok(Part::Number(number)) }
    }

    fn skip(&mut self, length: usize) {
        self.rest = self.rest[length..].trim_start();
    }

    fn takes(&mut self, signs: &[char]) -> Option<char> {
        let sign = self.rest.chars().next().filter(|sign| signs.contains(sign))?;
        self.skip(sign.len_utf8());
        Some(sign)
    }

    fn word(&mut self, word: &str) -> bool {
        let Some(start) = self.rest.get(..word.len()) else { return false };
        let after = self.rest[word.len()..].chars().next();
        let goes_on = word.is_ascii() && after.is_some_and(|c| c.is_ascii_alphabetic());
        if !start.eq_ignore_ascii_case(word) || goes_on {
            return false;
        }
        self.skip(word.len());
        true
    }

    fn sum(&mut self) -> Result<Part, ExactError> {
        let mut sum = self.product()?;
        while let Some(sign) = self.takes(&['+', '-', '\u{2212}', '\u{2013}', '\u{2010}']) {
            let next = self.product()?;
            sum = match (sum, next) {
                (Part::Angle(a), Part::Angle(b)) => Part::Angle(if sign == '+' { &a + &b } else { &a - &b }),
                (a, b) => {
                    let (a, b) = (self.number(a)?, self.number(b)?);
                    self.bounded(if sign == '+' { a.plus(&b)? } else { a.minus(&b)? })?
                }
            };
        }
        Ok(sum)
    }

    fn product(&mut self) -> Result<Part, ExactError> {
        let mut product = self.signed()?;
        loop {
            if self.takes(&['*', '×', '·', '⋅']).is_some() {
                let next = self.signed()?;
                product = self.multiplied(product, next)?;
            } else if self.takes(&['/', '÷', '⁄', '∕']).is_some() {
                let next = self.signed()?;
                let divisor = self.number(next)?;
                product = match product {
                    Part::Number(a) => self.bounded(a.over(&divisor)?)?,
                    Part::Angle(t) => {
                        let divisor = divisor.as_rational().ok_or(self.inexact())?;
                        Part::Angle((&t / divisor).ok_or(ExactError::DivisionByZero)?)
                    }
                };
            } else if self
                .rest
                .starts_with(|c: char| c == '(' || "√πφ".contains(c) || c.is_ascii_alphabetic())
            {
                let next = self.power()?;
                product = self.multiplied(product, next)?;
            } else {
                return Ok(product);
            }
        }
    }

    fn multiplied(&self, a: Part, b: Part) -> Result<Part, ExactError> {
        match (a, b) {
            (Part::Number(a), Part::Number(b)) => self.bounded(a.times(&b)?),
            (Part::Angle(t), Part::Number(number)) | (Part::Number(number), Part::Angle(t)) => {
                Ok(Part::Angle(&t * number.as_rational().ok_or(self.inexact())?))
            }
            _ => Err(self.inexact()),
        }
    }

    fn signed(&mut self) -> Result<Part, ExactError> {
        match self.takes(&['+', '-', '\u{2212}', '\u{2013}', '\u{2010}']) {
            Some('+') | None => self.power(),
            Some(_) => Ok(match self.power()? {
                Part::Number(number) => Part::Number(number.negative()),
                Part::Angle(t) => Part::Angle(-&t),
            }),
        }
    }

    fn power(&mut self) -> Result<Part, ExactError> {
        let base = self.suffixed()?;
        let two = self.rest.starts_with("**");
        if two {
            self.skip(2);
        }
        if !two && self.takes(&['^']).is_none() {
            return Ok(base);
        }
        let exponent = self.signed()?;
        let (base, exponent) = (self.number(base)?, self.number(exponent)?);
        let exponent = exponent.as_rational().ok_or(self.inexact())?;
        let small = |n: BigInt| n.to_i32().filter(|n| n.abs() <= LARGEST_POWER).ok_or(self.inexact());
        let (numerator, denominator) = (small(exponent.numerator())?, small(exponent.denominator())?);
        let root = base.root(denominator.unsigned_abs())?;
        let field = root.field().polynomial().iter().map(BigInt::bits).max().unwrap_or(0);
        let work = (digits(&root) + field).saturating_mul(numerator.unsigned_abs().into());
        if work > LARGEST_WORK { Err(self.inexact()) } else { self.bounded(root.power(numerator)?) }
    }

    fn suffixed(&mut self) -> Result<Part, ExactError> {
        let part = self.single()?;
        if self.takes(&['°']).is_some() || self.word("deg") {
            let number = self.number(part)?;
            let degrees = number.as_rational().ok_or(self.inexact())?;
            let share = Rational::new(1, 180).ok_or(ExactError::DivisionByZero)?;
            return Ok(Part::Angle(degrees * &share));
        }
        match self.takes(&['²', '³']) {
            None => Ok(part),
            Some(sign) => self.bounded(self.number(part)?.power(if sign == '²' { 2 } else { 3 })?),
        }
    }

    fn single(&mut self) -> Result<Part, ExactError> {
        if self.takes(&['(']).is_some() {
            let part = self.sum()?;
            return if self.takes(&[')']).is_some() { Ok(part) } else { self.wrong() };
        }
        if self.rest.starts_with(|c: char| c == '.' || c.is_ascii_digit()) {
            return self.decimal();
        }
        for (word, n, d) in [("½", 1, 2), ("¼", 1, 4), ("¾", 3, 4)] {
            if self.word(word) {
                let fraction = Rational::new(n, d).ok_or(ExactError::DivisionByZero)?;
                return Ok(Part::Number(fraction.into()));
            }
        }
        if self.word("pi") || self.word("π") {
            return Ok(Part::Angle(Rational::ONE));
        }
        if self.word("i") {
            return Ok(Part::Number(Number::i()?));
        }
        if self.word("phi") || self.word("φ") {
            let root = Number::whole(5).root(2)?;
            return Ok(Part::Number(root.plus(&Number::whole(1))?.over(&Number::whole(2))?));
        }
        for (word, degree) in [("sqrt", 2), ("√", 2), ("cbrt", 3)] {
            if self.word(word) {
                let part = self.suffixed()?;
                return Ok(Part::Number(self.number(part)?.root(degree)?));
            }
        }
        for word in ["sin", "cos", "tan"] {
            if self.word(word) {
                let part = self.suffixed()?;
                return Ok(Part::Number(self.circular(word, part)?));
            }
        }
        self.wrong()
    }

    fn circular(&self, word: &str, part: Part) -> Result<Number, ExactError> {
        let t = match part {
            Part::Angle(t) => t,
            Part::Number(number) if number.is_zero() => Rational::ZERO,
            Part::Number(_) => return Err(self.inexact()),
        };
        let quarter = Rational::new(1, 2).ok_or(ExactError::DivisionByZero)?;
        let sine = || Number::cosine(&(&quarter - &t));
        match word {
            "cos" => Number::cosine(&t),
            "sin" => sine(),
            _ => sine()?.over(&Number::cosine(&t)?),
        }
    }

    fn decimal(&mut self) -> Result<Part, ExactError> {
        let (mut digits, mut length, mut places, mut point) = (String::new(), 0, 0, false);
        for c in self.rest.chars() {
            match c {
                '0'..='9' => {
                    digits.push(c);
                    places += i32::from(point);
                }
                '.' if !point => point = true,
                _ => break,
            }
            length += 1;
        }
        let Ok(whole) = digits.parse::<BigInt>() else { return self.wrong() };
        let mut exponent = 0;
        if let Some(after) = self.rest[length..].strip_prefix(['e', 'E']) {
            let sign = usize::from(after.starts_with(['+', '-']));
            let count = after[sign..].bytes().take_while(u8::is_ascii_digit).count();
            if count > 0 {
                exponent = after[..sign + count].parse().map_err(|_| self.inexact())?;
                length += 1 + sign + count;
            }
        }
        let power =
            Some(exponent).filter(|e: &i32| e.abs() <= LARGEST_EXPONENT).ok_or(self.inexact())? - places;
        self.skip(length);
        let scale = Rational::whole(10).power(power).ok_or(ExactError::DivisionByZero)?;
        Ok(Part::Number((&Rational::from(whole) * &scale).into()))
    }
}

/// The most binary digits of a numerator or denominator.
fn digits(number: &Number) -> u64 {
    let parts = number.element().coefficients().iter();
    parts.map(|x| x.numerator().bits().max(x.denominator().bits())).max().unwrap_or(0)
}
