//! The double nearest to a real number, rounded exactly.

use std::cmp::Ordering;

use crate::number::rational::Rational;
use crate::number::value::Number;

impl Number {
    /// The double nearest to a real number; of two that are as near, the one whose last digit is even. `None` for a
    /// number that is not real, or beyond all doubles.
    #[must_use]
    pub fn nearest(&self) -> Option<f64> {
        match self.field().sign(self.element())? {
            Ordering::Equal => Some(0.0),
            Ordering::Less => self.negative().nearest_of_positive().map(|size| -size),
            Ordering::Greater => self.nearest_of_positive(),
        }
    }

    fn nearest_of_positive(&self) -> Option<f64> {
        // Positive doubles lie in the order of their bits.
        let place = self.enclosure().re;
        let mut lower = place.lower().clamp(0.0, f64::MAX).to_bits();
        let mut beyond = place.upper().clamp(0.0, f64::MAX).to_bits() + 1;
        while lower + 1 < beyond {
            let middle = u64::midpoint(lower, beyond);
            match self.to_rational(&Rational::from_f64(f64::from_bits(middle))?)? {
                Ordering::Less => beyond = middle,
                _ => lower = middle,
            }
        }
        let below = f64::from_bits(lower);
        // Past the last double the next one would be 2^1024.
        let step = if below == f64::MAX { below - below.next_down() } else { below.next_up() - below };
        let half = &Rational::from_f64(step)? * &Rational::new(1, 2)?;
        let halfway = &Rational::from_f64(below)? + &half;
        let goes_up = match self.to_rational(&halfway)? {
            Ordering::Less => false,
            Ordering::Equal => lower & 1 == 1,
            Ordering::Greater => true,
        };
        let nearest = if goes_up { below.next_up() } else { below };
        nearest.is_finite().then_some(nearest)
    }

    /// How a real number compares to a fraction.
    fn to_rational(&self, other: &Rational) -> Option<Ordering> {
        self.field().compare(self.element(), &self.field().rational(other.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(text: &str) -> Option<f64> {
        Number::parse(text).unwrap().nearest()
    }

    #[test]
    fn decimals_are_read_as_rust_reads_them() {
        for text in [
            "0.1",
            "0.3333333333333333",
            "1e-320",
            "4.9e-324",
            "2.4e-324",
            "2.5e-324",
            "1.7976931348623158e308",
            "9007199254740993",
            "9007199254740995",
            "123456789.123456789123456789",
            "1e22",
            "1e23",
        ] {
            assert_eq!(nearest(text), text.parse().ok(), "{text}");
            assert_eq!(nearest(&format!("-{text}")), text.parse().ok().map(|x: f64| -x), "{text}");
        }
        assert_eq!(nearest("1e309"), None);
        assert_eq!(nearest("1.7976931348623159e308"), None);
    }

    #[test]
    fn roots_are_rounded_as_the_processor_rounds_them() {
        for n in 1..60 {
            assert_eq!(nearest(&format!("sqrt({n})")), Some(f64::from(n).sqrt()), "{n}");
            assert_eq!(nearest(&format!("{n}/7")), Some(f64::from(n) / 7.0), "{n}");
        }
        // Almost nothing is left: 1.9e-17, which doubles lose.
        let left = nearest("sqrt(2)-1.4142135623730950").unwrap();
        assert!((left - 4.88e-17).abs() < 1e-19, "{left}");
        assert_eq!(nearest("i"), None);
    }
}
