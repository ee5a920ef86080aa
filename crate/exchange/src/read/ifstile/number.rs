//! Numbers of a program: rational as long as they can be, and doubles from there on.
//!
//! Angles stay exact as rational parts of a half turn, so that a rotation by 90 degrees, of which programs say the
//! cosine, is one of whole numbers.

use std::cmp::Ordering;
use std::f64::consts::PI;

use super::rational::Rational;

/// Longer numbers are refused: their size would double with each product.
const MOST_BITS: u64 = 1536;
pub const TOO_LARGE: &str = "A number becomes too large.";
const OVER_ZERO: &str = "A number is divided by 0.";
const NO_NUMBER: &str = "What is computed there is no real number.";

/// A sentence about what cannot be computed.
pub type Outcome<T> = Result<T, &'static str>;

#[derive(Clone, Debug, PartialEq)]
pub enum Number {
    Exact(Rational),
    /// So many times pi, not zero.
    Turn(Rational),
    Real(f64),
}

impl Number {
    pub const ZERO: Self = Self::Exact(Rational::ZERO);
    pub const ONE: Self = Self::Exact(Rational::ONE);

    pub const fn whole(x: i64) -> Self {
        Self::Exact(Rational::whole(x))
    }

    fn turn(part: Rational) -> Self {
        if part.is_zero() { Self::ZERO } else { Self::Turn(part) }
    }

    pub fn real(x: f64) -> Outcome<Self> {
        if x.is_nan() {
            return Err(NO_NUMBER);
        }
        if x.is_finite() { Ok(Self::Real(x)) } else { Err(TOO_LARGE) }
    }

    pub fn checked(self) -> Outcome<Self> {
        let long = matches!(&self, Self::Exact(x) | Self::Turn(x) if x.bits() > MOST_BITS);
        if long { Err(TOO_LARGE) } else { Ok(self) }
    }

    pub fn double(&self) -> Outcome<f64> {
        match self {
            Self::Exact(x) => x.to_double().ok_or(TOO_LARGE),
            Self::Turn(part) => part.to_double().map(|part| part * PI).ok_or(TOO_LARGE),
            Self::Real(x) => Ok(*x),
        }
    }

    /// The rational number that it is, or that its double is.
    pub fn rational(&self) -> Outcome<Rational> {
        match self {
            Self::Exact(x) => Ok(x.clone()),
            _ => Rational::of_double(self.double()?).ok_or(TOO_LARGE),
        }
    }

    /// The same without angles, as entries of maps are.
    pub fn entry(&self) -> Outcome<Self> {
        match self {
            Self::Turn(_) => Ok(Self::Real(self.double()?)),
            other => Ok(other.clone()),
        }
    }

    pub fn exact(&self) -> Option<&Rational> {
        match self {
            Self::Exact(x) => Some(x),
            _ => None,
        }
    }

    pub fn as_whole(&self) -> Option<i64> {
        self.exact().and_then(Rational::as_whole)
    }

    /// How long it is, in words of 64 binary digits.
    pub fn words(&self) -> usize {
        match self {
            Self::Exact(x) | Self::Turn(x) => usize::try_from(x.bits().div_ceil(64)).unwrap_or(usize::MAX),
            Self::Real(_) => 1,
        }
    }

    /// How many steps so many products of numbers of so many words together take: long fractions are reduced, which
    /// takes the square of their length.
    pub const fn steps(products: usize, words: usize) -> usize {
        if words <= 2 { 1 + products / 8 } else { 1 + products.saturating_mul(words * words + 4) }
    }

    pub fn is_zero(&self) -> bool {
        match self {
            Self::Exact(x) => x.is_zero(),
            Self::Turn(_) => false,
            Self::Real(x) => *x == 0.0,
        }
    }

    pub fn signum(&self) -> i32 {
        match self {
            Self::Exact(x) | Self::Turn(x) => x.signum(),
            Self::Real(x) => i32::from(*x > 0.0) - i32::from(*x < 0.0),
        }
    }

    pub fn negated(&self) -> Self {
        match self {
            Self::Exact(x) => Self::Exact(x.negated()),
            Self::Turn(x) => Self::Turn(x.negated()),
            Self::Real(x) => Self::Real(-x),
        }
    }

    pub fn plus(&self, other: &Self) -> Outcome<Self> {
        match (self, other) {
            (zero, it) | (it, zero) if matches!(zero, Self::Exact(x) if x.is_zero()) => Ok(it.clone()),
            (Self::Exact(x), Self::Exact(y)) => Self::Exact(x.plus(y)).checked(),
            (Self::Turn(x), Self::Turn(y)) => Self::turn(x.plus(y)).checked(),
            _ => Self::real(self.double()? + other.double()?),
        }
    }

    pub fn minus(&self, other: &Self) -> Outcome<Self> {
        self.plus(&other.negated())
    }

    pub fn times(&self, other: &Self) -> Outcome<Self> {
        match (self, other) {
            (Self::Exact(x), it) | (it, Self::Exact(x)) if x.is_zero() || x.is_one() => {
                Ok(if x.is_zero() { Self::ZERO } else { it.clone() })
            }
            (Self::Exact(x), Self::Exact(y)) => Self::Exact(x.times(y)).checked(),
            (Self::Exact(x), Self::Turn(y)) | (Self::Turn(y), Self::Exact(x)) => {
                Self::turn(x.times(y)).checked()
            }
            _ => Self::real(self.double()? * other.double()?),
        }
    }

    pub fn over(&self, other: &Self) -> Outcome<Self> {
        if other.is_zero() {
            return Err(OVER_ZERO);
        }
        match (self, other) {
            (Self::Exact(_) | Self::Turn(_), Self::Exact(y)) => {
                self.times(&Self::Exact(y.inverse().ok_or(OVER_ZERO)?))
            }
            (Self::Turn(x), Self::Turn(y)) => Self::Exact(x.times(&y.inverse().ok_or(OVER_ZERO)?)).checked(),
            _ => Self::real(self.double()? / other.double()?),
        }
    }

    /// What is left of it by whole steps of the other, with the sign of the other; itself where the other is 0.
    pub fn modulo(&self, other: &Self) -> Outcome<Self> {
        if other.is_zero() {
            return Ok(self.clone());
        }
        let steps = self.over(other)?.floor()?;
        self.minus(&steps.times(other)?)
    }

    pub fn floor(&self) -> Outcome<Self> {
        match self {
            Self::Exact(x) => Ok(Self::Exact(x.floor())),
            _ => Self::real(self.double()?.floor()).map(Self::settled),
        }
    }

    pub fn ceil(&self) -> Outcome<Self> {
        Ok(self.negated().floor()?.negated())
    }

    /// A whole double as the whole number.
    fn settled(self) -> Self {
        match self {
            Self::Real(x) if x.fract() == 0.0 => Rational::of_double(x).map_or(self, Self::Exact),
            other => other,
        }
    }

    pub fn compare(&self, other: &Self) -> Outcome<Ordering> {
        Ok(self.minus(other)?.signum().cmp(&0))
    }

    pub fn power(&self, exponent: &Self) -> Outcome<Self> {
        if exponent.is_zero() {
            return Ok(Self::ONE);
        }
        if self.is_zero() {
            return if exponent.signum() < 0 { Err(OVER_ZERO) } else { Ok(Self::ZERO) };
        }
        if let (Self::Exact(base), Self::Exact(Rational::Small(over, under))) = (self, exponent) {
            let root = if *under == 1 {
                Some(base.clone())
            } else if base.signum() < 0 {
                None
            } else {
                u32::try_from(*under).ok().filter(|degree| *degree <= 64).and_then(|degree| base.root(degree))
            };
            if let Some(root) = root {
                return whole_power(&root, *over);
            }
        }
        let (base, power) = (self.double()?, exponent.double()?);
        if base < 0.0 && power.fract() != 0.0 {
            return Err("A broken power of a negative number is no number.");
        }
        Self::real(base.powf(power))
    }

    /// A function of the standard library; of an angle where an exact value is known.
    pub fn function(name: &str, arguments: &[Self]) -> Option<Outcome<Self>> {
        let [x] = arguments else {
            return match (name, arguments) {
                ("arg", [x, y]) => Some(angle(x, y)),
                _ => None,
            };
        };
        Some(match name {
            "sin" => x.sine(&Rational::ZERO),
            "cos" => x.sine(&Rational::Small(1, 2)),
            "tan" => {
                let under = x.sine(&Rational::Small(1, 2));
                x.sine(&Rational::ZERO).and_then(|over| over.over(&under?))
            }
            "asin" => x.arc(f64::asin, [(0, 0), (1, 2)]),
            "acos" => x.arc(f64::acos, [(1, 0), (0, 2)]),
            "atan" => x.arc(f64::atan, [(0, 0), (1, 1)]),
            "exp" if x.is_zero() => Ok(Self::ONE),
            "exp" => x.double().and_then(|x| Self::real(x.exp())),
            "log" if x.signum() <= 0 => Err("A logarithm of 0 or of a negative number is no number."),
            "log" if *x == Self::ONE => Ok(Self::ZERO),
            "log" => x.double().and_then(|x| Self::real(x.ln())),
            "floor" => x.floor(),
            "ceil" => x.ceil(),
            "abs" => Ok(if x.signum() < 0 { x.negated() } else { x.clone() }),
            "arg" => angle(x, &Self::ZERO),
            _ => return None,
        })
    }

    /// The sine of what it is with so much of a half turn more.
    fn sine(&self, more: &Rational) -> Outcome<Self> {
        let part = match self {
            Self::Exact(x) if x.is_zero() => more.clone(),
            Self::Turn(part) => part.plus(more),
            _ if more.is_zero() => return Self::real(self.double()?.sin()),
            _ => return Self::real(self.double()?.cos()),
        };
        // Of a turn of 12 twelfths, what is left of it.
        let twelfths = part.times(&Rational::whole(6));
        let left =
            twelfths.minus(&twelfths.times(&Rational::Small(1, 12)).floor().times(&Rational::whole(12)));
        let exact = match left.as_whole() {
            Some(0 | 6) => Rational::ZERO,
            Some(1 | 5) => Rational::Small(1, 2),
            Some(3) => Rational::ONE,
            Some(7 | 11) => Rational::Small(-1, 2),
            Some(9) => Rational::whole(-1),
            _ => {
                let left = left.to_double().ok_or(TOO_LARGE)? / 6.0;
                // Within a quarter of a turn nothing is lost.
                let (sign, left) = if left > 1.0 { (-1.0, left - 1.0) } else { (1.0, left) };
                let left = left.min(1.0 - left);
                return Self::real(sign * (left * PI).sin());
            }
        };
        Ok(Self::Exact(exact))
    }

    /// An angle; exact at these values, which stand with the quarter turns that they give, and at their negatives.
    fn arc(&self, function: fn(f64) -> f64, known: [(i64, i64); 2]) -> Outcome<Self> {
        for (value, quarters) in known {
            if self.as_whole() == Some(value) {
                return Ok(Self::turn(Rational::whole(quarters).times(&Rational::Small(1, 4))));
            }
            if self.as_whole() == Some(-value) {
                let found = function(-(value as f64)) / PI * 4.0;
                return Ok(Self::turn(Rational::fraction(found.round() as i64, 4)));
            }
        }
        Self::real(function(self.double()?))
    }
}

/// The angle of a point.
fn angle(x: &Number, y: &Number) -> Outcome<Number> {
    let quarters = match (x.signum(), y.signum()) {
        (0, 0) => return Err("The angle of the point 0 is none."),
        (1, 0) => 0,
        (0, 1) => 1,
        (-1, 0) => 2,
        (0, -1) => -1,
        _ => return Number::real(y.double()?.atan2(x.double()?)),
    };
    Ok(Number::turn(Rational::fraction(quarters, 2)))
}

fn whole_power(base: &Rational, exponent: i64) -> Outcome<Number> {
    let base = if exponent < 0 { base.inverse().ok_or(OVER_ZERO)? } else { base.clone() };
    let mut left = exponent.unsigned_abs();
    let (mut square, mut power) = (Number::Exact(base), Number::ONE);
    while left > 0 {
        if left % 2 == 1 {
            power = power.times(&square)?;
        }
        left /= 2;
        if left > 0 {
            square = square.times(&square)?;
        }
    }
    Ok(power)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(name: &str, x: Number) -> Number {
        Number::function(name, &[x]).unwrap().unwrap()
    }

    #[test]
    fn rotations_by_known_angles_are_exact() {
        let right = call("asin", Number::ONE);
        let degrees = |x: i64| right.times(&Number::whole(x)).unwrap().over(&Number::whole(90)).unwrap();
        for (angle, sine, cosine) in
            [(0, 0, 2), (30, 1, 9), (90, 2, 0), (150, 1, 9), (180, 0, -2), (-90, -2, 0)]
        {
            let half = |twice: i64| Number::Exact(Rational::fraction(twice, 2));
            assert_eq!(call("sin", degrees(angle)), half(sine), "{angle}");
            if cosine < 9 {
                assert_eq!(call("cos", degrees(angle)), half(cosine), "{angle}");
            }
        }
        for angle in -400..400 {
            let x = f64::from(angle).to_radians();
            for (name, wanted) in [("sin", x.sin()), ("cos", x.cos())] {
                let found = call(name, degrees(angle.into())).double().unwrap();
                assert!((found - wanted).abs() < 4e-15, "{name} {angle}: {found}");
            }
        }
        assert_eq!(call("acos", Number::whole(-1)), Number::Turn(Rational::ONE));
        assert_eq!(call("atan", Number::whole(-1)), Number::Turn(Rational::Small(-1, 4)));
    }

    #[test]
    fn roots_are_exact_where_they_can_be() {
        let half = Number::Exact(Rational::Small(1, 2));
        assert_eq!(Number::whole(9).power(&half), Ok(Number::whole(3)));
        assert_eq!(Number::whole(2).power(&half), Ok(Number::Real(2.0_f64.sqrt())));
        assert_eq!(Number::whole(-7).modulo(&Number::whole(3)), Ok(Number::whole(2)));
        assert_eq!(Number::whole(7).modulo(&Number::whole(-3)), Ok(Number::whole(-2)));
        assert_eq!(Number::whole(7).modulo(&Number::ZERO), Ok(Number::whole(7)));
        assert_eq!(Number::whole(2).power(&Number::whole(5000)), Err(TOO_LARGE));
        assert_eq!(Number::ZERO.power(&Number::whole(-1)), Err(OVER_ZERO));
    }
}
