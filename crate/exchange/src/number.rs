//! Numbers as people write them: 1/3 and sqrt(3)/2 where that is exactly the double, else decimals that come back to
//! it.

use std::fmt;

use frond_core::closed_form::{simplest_fraction, simplest_root};

/// Roots that turn up in figures: of triangles and hexagons, squares, pentagons.
const ROOTS: [u8; 3] = [3, 2, 5];
/// Decimals with no more digits than this are what somebody typed.
const TYPED_DIGITS: usize = 9;

/// How a double is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number {
    /// By its shortest decimal, which is read as the same double.
    Decimal(f64),
    /// `(p + r sqrt(d)) / q`, without a root where `r` is 0. Computed in doubles, from the inside outward and from left
    /// to right, it is the same double.
    Closed {
        /// The whole part.
        p: i64,
        /// The factor of the root.
        r: i64,
        /// The denominator.
        q: i64,
        /// What the root is of.
        d: u8,
    },
}

impl Number {
    /// What is best for a double.
    pub fn of(x: f64) -> Self {
        let decimal = Self::Decimal(x);
        let digits =
            |text: &str| text.trim_start_matches(['-', '0', '.']).bytes().filter(u8::is_ascii_digit).count();
        // Numbers with exponents have many digits when they are written without.
        if x == 0.0 || !(1e-6..1e6).contains(&x.abs()) || digits(&format!("{x}")) <= TYPED_DIGITS {
            return decimal;
        }
        let off = 4.0 * f64::EPSILON * x.abs();
        let fraction = simplest_fraction(x, off).map(|(p, q)| Self::Closed { p, r: 0, q, d: 1 });
        let mut roots = ROOTS.iter().filter_map(|&d| {
            let (p, r, q) = simplest_root(x, off, d)?;
            Some(Self::Closed { p, r, q, d })
        });
        let closed =
            fraction.into_iter().find(|it| it.value() == x).or_else(|| roots.find(|it| it.value() == x));
        closed.unwrap_or(decimal)
    }

    /// The double that it is computed as.
    #[expect(clippy::cast_precision_loss, reason = "the whole numbers are small")]
    pub fn value(self) -> f64 {
        match self {
            Self::Decimal(x) => x,
            Self::Closed { p, r: 0, q, .. } => p as f64 / q as f64,
            Self::Closed { p: 0, r, q, d } => r as f64 * f64::from(d).sqrt() / q as f64,
            Self::Closed { p, r, q, d } => (p as f64 + r as f64 * f64::from(d).sqrt()) / q as f64,
        }
    }

    /// Whether it needs a square root.
    pub const fn has_root(self) -> bool {
        matches!(self, Self::Closed { r, .. } if r != 0)
    }

    /// As TeX, and programs that read it, write it.
    pub fn tex(self) -> String {
        let Self::Closed { p, r, q, d } = self else { return decimal_tex(self.value()) };
        let root = match r.abs() {
            0 => String::new(),
            1 => format!("\\sqrt{{{d}}}"),
            times => format!("{times}\\sqrt{{{d}}}"),
        };
        let (negative, above) = match (p, r) {
            (_, 0) => (p < 0, p.abs().to_string()),
            (0, _) => (r < 0, root),
            _ => (false, format!("{p}{}{root}", if r < 0 { '-' } else { '+' })),
        };
        let sign = if negative { "-" } else { "" };
        if q == 1 { format!("{sign}{above}") } else { format!("{sign}\\frac{{{above}}}{{{q}}}") }
    }
}

/// A decimal without the exponent that TeX would not understand.
fn decimal_tex(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if (1e-5..1e15).contains(&x.abs()) {
        return format!("{x}");
    }
    let text = format!("{x:e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{digits}\\cdot10^{{{power}}}")
}

/// As most programs read it: `sqrt(3)/2`.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::Closed { p, r, q, d } = *self else { return plain(self.value(), f) };
        let times = match r {
            1 | -1 => format!("sqrt({d})"),
            _ => format!("{}*sqrt({d})", r.abs()),
        };
        let sign = if r < 0 { "-" } else { "" };
        match (p, r, q) {
            (_, 0, _) => write!(f, "{p}/{q}"),
            (0, _, 1) => write!(f, "{sign}{times}"),
            (0, _, _) => write!(f, "{sign}{times}/{q}"),
            (_, _, 1) => write!(f, "{p} {} {times}", if r < 0 { '-' } else { '+' }),
            _ => write!(f, "({p} {} {times})/{q}", if r < 0 { '-' } else { '+' }),
        }
    }
}

/// The shortest decimal that is read as this double; with an exponent where it would be long without.
pub fn plain(x: f64, f: &mut impl fmt::Write) -> fmt::Result {
    if x == 0.0 || (1e-5..1e16).contains(&x.abs()) { write!(f, "{x}") } else { write!(f, "{x:e}") }
}

/// The same as a text of its own.
pub fn decimal(x: f64) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = plain(x, &mut text);
    text
}

#[cfg(test)]
mod tests {
    use frond_scene::presets;
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn numbers_of_figures_are_written_as_in_books() {
        let root = |d: f64| d.sqrt();
        for (x, text, tex) in [
            (0.5, "0.5", "0.5"),
            (0.0, "0", "0"),
            (0.85, "0.85", "0.85"),
            (1.0 / 3.0, "1/3", "\\frac{1}{3}"),
            (-2.0 / 3.0, "-2/3", "-\\frac{2}{3}"),
            (root(3.0) / 2.0, "sqrt(3)/2", "\\frac{\\sqrt{3}}{2}"),
            (-root(3.0) / 6.0, "-sqrt(3)/6", "-\\frac{\\sqrt{3}}{6}"),
            (root(2.0), "sqrt(2)", "\\sqrt{2}"),
            (5.0 * root(3.0) / 14.0, "5*sqrt(3)/14", "\\frac{5\\sqrt{3}}{14}"),
            ((3.0 - root(5.0)) / 2.0, "(3 - sqrt(5))/2", "\\frac{3-\\sqrt{5}}{2}"),
            (1.0 + root(2.0), "1 + sqrt(2)", "1+\\sqrt{2}"),
            (std::f64::consts::PI, "3.141592653589793", "3.141592653589793"),
            (1e-9, "1e-9", "1\\cdot10^{-9}"),
        ] {
            let number = Number::of(x);
            assert_eq!((number.to_string().as_str(), number.tex().as_str()), (text, tex), "{x}");
        }
    }

    #[test]
    fn what_only_comes_near_stays_a_decimal() {
        assert_eq!(Number::of(0.1 + 0.2), Number::Decimal(0.300_000_000_000_000_04));
        let near = f64::from_bits((1.0_f64 / 3.0).to_bits() + 1);
        assert_eq!(Number::of(near), Number::Decimal(near));
    }

    #[test]
    fn most_numbers_of_the_gallery_are_exact() {
        let rows = presets().into_iter().flat_map(|preset| preset.maps).flatten();
        let long: Vec<f64> = rows.filter(|x| format!("{x}").len() > 12).collect();
        let exact = long.iter().filter(|&&x| matches!(Number::of(x), Number::Closed { .. })).count();
        assert!(10 * exact > 6 * long.len(), "{exact} of {}", long.len());
    }

    proptest! {
        #[test]
        fn every_number_is_itself(x in proptest::num::f64::NORMAL | proptest::num::f64::ZERO) {
            let number = Number::of(x);
            prop_assert_eq!(number.value().to_bits(), x.to_bits());
            if let Number::Decimal(_) = number {
                prop_assert_eq!(number.to_string().parse::<f64>().unwrap().to_bits(), x.to_bits());
            }
        }
    }
}
