//! Numbers as they are written in different countries.

/// How the numbers of a table are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// 1234.5
    Point,
    /// 1234,5
    Comma,
    /// 1.234,5
    PointParts,
    /// 1,234.5
    CommaParts,
    /// 1234.5 and 1234,5 in one table.
    Either,
}

/// Longer words are no numbers.
const LONGEST_WORD: usize = 1000;

impl Style {
    /// All, the one that is to be taken first where several will do.
    pub const ALL: [Self; 5] = [Self::Point, Self::Comma, Self::PointParts, Self::CommaParts, Self::Either];

    /// What a field of a table is; None where it is no number of this style. It may be NaN.
    pub fn number(self, field: &str) -> Option<f64> {
        let (decimal, parts) = match self {
            Self::Point => ('.', None),
            Self::Comma => (',', None),
            Self::PointParts => (',', Some('.')),
            Self::CommaParts => ('.', Some(',')),
            Self::Either => return Self::Point.number(field).or_else(|| Self::Comma.number(field)),
        };
        if field.len() > LONGEST_WORD {
            return None;
        }
        if (decimal == '.' || !field.contains('.'))
            && let Ok(value) = field.parse()
        {
            return Some(value);
        }
        // R prints [,1] and [1,] above and before the numbers of a matrix.
        if field.trim_start().starts_with("[,") {
            return None;
        }
        let field = bare(field);
        let (mantissa, exponent) = field.split_at(field.find(['e', 'E']).unwrap_or(field.len()));
        let (whole, rest) = mantissa.split_once(decimal).map_or((mantissa, None), |(a, b)| (a, Some(b)));
        let mut plain = Plain::default();
        let written = joined(whole, parts, &mut plain).and_then(|()| {
            if let Some(rest) = rest {
                // A decimal comma has a digit after it: otherwise it is the end of something.
                (digits(rest) && (decimal == '.' || !rest.is_empty())).then_some(())?;
                plain.push(".")?;
                plain.push(rest)?;
            }
            match exponent.char_indices().nth(1) {
                Some((at, sign)) if is_minus(sign) => {
                    plain.push("e-")?;
                    plain.push(&exponent[at + sign.len_utf8()..])
                }
                _ => plain.push(exponent),
            }
        });
        match written {
            Some(()) => plain.text().parse().ok(),
            // Words that are numbers, and numbers in quotes that are longer.
            None if decimal == '.' || !field.contains('.') => field.parse().ok(),
            None => None,
        }
    }
}

/// A number as it is written, with a point.
struct Plain {
    bytes: [u8; 64],
    length: usize,
}

impl Default for Plain {
    fn default() -> Self {
        Self { bytes: [0; 64], length: 0 }
    }
}

impl Plain {
    fn push(&mut self, text: &str) -> Option<()> {
        let end = self.length + text.len();
        self.bytes.get_mut(self.length..end)?.copy_from_slice(text.as_bytes());
        self.length = end;
        Some(())
    }

    fn text(&self) -> &str {
        str::from_utf8(&self.bytes[..self.length]).unwrap_or_default()
    }
}

/// A field without its quotes and the brackets around it, and without signs that are not seen.
fn bare(field: &str) -> &str {
    let around = |c: char| {
        c.is_whitespace()
            || matches!(c, '"' | '\'' | '“' | '”' | '\u{200b}' | '\u{2060}' | '\u{feff}' | '\u{1a}')
    };
    field
        .trim_start_matches(|c| around(c) || matches!(c, '(' | '[' | '{'))
        .trim_end_matches(|c| around(c) || matches!(c, ')' | ']' | '}'))
}

/// Hyphens and dashes that stand for a minus.
const fn is_minus(sign: char) -> bool {
    matches!(sign, '-' | '\u{2010}'..='\u{2014}' | '\u{2212}' | '\u{fe63}' | '\u{ff0d}')
}

fn digits(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Writes a whole number without the signs that part its thousands: `parts`, blanks or apostrophes.
fn joined(whole: &str, parts: Option<char>, to: &mut Plain) -> Option<()> {
    let (sign, bare) = match whole.strip_prefix(is_minus) {
        Some(bare) => ("-", bare.trim_start()),
        None => ("", whole.strip_prefix('+').unwrap_or(whole)),
    };
    let between =
        |letter: char| Some(letter) == parts || matches!(letter, '\'' | '’') || letter.is_whitespace();
    let mut groups = bare.split(between);
    let first = groups.next().filter(|first| digits(first))?;
    to.push(sign)?;
    to.push(first)?;
    for group in groups {
        if group.len() != 3 || !digits(group) || !(1..=3).contains(&first.len()) {
            return None;
        }
        to.push(group)?;
    }
    Some(())
}

/// Whether a number could have its thousands parted by `sign`: 1,234 or 12,345,678, but neither 0,123 nor 1,23.
pub fn may_be_parted(field: &str, sign: char) -> bool {
    let field = bare(field);
    !field.trim_start_matches(|sign| sign == '+' || is_minus(sign)).starts_with('0')
        && field.contains(sign)
        && joined(field, Some(sign), &mut Plain::default()).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_each_country_writes_them() {
        for (field, values) in [
            ("12", [Some(12.0); 5]),
            ("-1e3", [Some(-1e3); 5]),
            ("1.5", [Some(1.5), None, None, Some(1.5), Some(1.5)]),
            ("-1,5", [None, Some(-1.5), Some(-1.5), None, Some(-1.5)]),
            (",5", [None, Some(0.5), Some(0.5), None, Some(0.5)]),
            ("1,5e3", [None, Some(1500.0), Some(1500.0), None, Some(1500.0)]),
            ("1.234", [Some(1.234), None, Some(1234.0), Some(1.234), Some(1.234)]),
            ("1,234", [None, Some(1.234), Some(1.234), Some(1234.0), Some(1.234)]),
            ("1.234,5", [None, None, Some(1234.5), None, None]),
            ("-1,234.5", [None, None, None, Some(-1234.5), None]),
            ("1.234.567", [None, None, Some(1_234_567.0), None, None]),
            ("\u{2212}1,234,567", [None, None, None, Some(-1_234_567.0), None]),
            ("\u{2212}5", [Some(-5.0); 5]),
            ("–0.5", [Some(-0.5), None, None, Some(-0.5), Some(-0.5)]),
            ("− 2", [Some(-2.0); 5]),
            ("5e−3", [Some(5e-3); 5]),
            ("\u{a0}7\u{2009}", [Some(7.0); 5]),
            ("(8", [Some(8.0); 5]),
            ("1\u{2009}234", [Some(1234.0); 5]),
            ("1 234", [Some(1234.0); 5]),
            ("12\u{a0}345,5", [None, Some(12345.5), Some(12345.5), None, Some(12345.5)]),
            ("1'234.5", [Some(1234.5), None, None, Some(1234.5), Some(1234.5)]),
            ("\"1,5\"", [None, Some(1.5), Some(1.5), None, Some(1.5)]),
        ] {
            assert_eq!(Style::ALL.map(|style| style.number(field)), values, "{field}");
        }
        for field in [
            "",
            " ",
            "a",
            "1,",
            "1,2,3",
            "1;2",
            "1 2",
            "12 3456",
            "1234,567,890",
            "--1,5",
            "1,5x",
            "1,-5",
            "€1",
            "] 430.000",
            "[,1]",
            "[1,]",
            "—",
            "1–2",
        ] {
            let all = Style::ALL.map(|style| style.number(field));
            assert_eq!(all, [None; 5], "{field}");
        }
        assert!(Style::Comma.number("NaN").is_some_and(f64::is_nan));
        assert_eq!(Style::Point.number(&"1".repeat(1001)), None);
    }

    #[test]
    fn thousands_are_told_where_they_could_be_meant() {
        for (field, may) in
            [("1,234", true), ("-12,345,678", true), ("0,123", false), ("1,23", false), ("1234", false)]
        {
            assert_eq!(may_be_parted(field, ','), may, "{field}");
        }
    }
}
