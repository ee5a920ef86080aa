//! Formulas as people write them: 1/3, √3/2, (1 + sqrt(5))/2, cos 30°, and of coordinates .85*x + .04*y.

/// No formula for one number is longer; so neither is the way into its brackets.
const LONGEST: usize = 200;
const DEGREES: f64 = std::f64::consts::PI / 180.0;

/// x times `x`, y times `y`, and `k`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Form {
    pub x: f64,
    pub y: f64,
    pub k: f64,
}

impl Form {
    const fn constant(k: f64) -> Self {
        Self { x: 0.0, y: 0.0, k }
    }

    const fn is_constant(self) -> bool {
        self.x == 0.0 && self.y == 0.0
    }

    fn plus(self, sign: f64, other: Self) -> Self {
        Self { x: self.x + sign * other.x, y: self.y + sign * other.y, k: self.k + sign * other.k }
    }

    fn scaled(self, by: f64) -> Self {
        Self { x: self.x * by, y: self.y * by, k: self.k * by }
    }

    fn times(self, other: Self) -> Option<Self> {
        if other.is_constant() {
            Some(self.scaled(other.k))
        } else {
            self.is_constant().then(|| other.scaled(self.k))
        }
    }

    fn over(self, other: Self) -> Option<Self> {
        let Self { x, y, k } = self;
        other.is_constant().then(|| Self { x: x / other.k, y: y / other.k, k: k / other.k })
    }

    /// A function of a number.
    fn map(self, function: impl Fn(f64) -> f64) -> Option<Self> {
        self.is_constant().then(|| Self::constant(function(self.k)))
    }
}

/// A number or a formula without coordinates, where it is finite.
pub fn value(text: &str) -> Option<f64> {
    // Letters alone are names of columns.
    if !text.contains(|c: char| c.is_ascii_digit() || matches!(c, 'π' | '½' | '¼' | '¾') || c == 'p') {
        return None;
    }
    form(text).filter(|form| form.is_constant()).map(|form| form.k).filter(|k| k.is_finite())
}

/// A formula that is linear in x and y, all of whose numbers are finite.
pub fn form(text: &str) -> Option<Form> {
    if text.len() > LONGEST {
        return None;
    }
    let mut reader = Reader { rest: text.trim() };
    let form = reader.sum()?;
    let finite = form.x.is_finite() && form.y.is_finite() && form.k.is_finite();
    (reader.rest.is_empty() && finite).then_some(form)
}

/// Whether a sign stands for a minus: hyphens, dashes, and the dash of Windows in a text that was taken for Latin-1.
pub const fn is_minus(sign: char) -> bool {
    matches!(sign, '-' | '\u{2010}'..='\u{2014}' | '\u{2212}' | '\u{fe63}' | '\u{ff0d}' | '\u{96}')
}

/// What is left of a formula.
struct Reader<'a> {
    rest: &'a str,
}

type Function = fn(f64) -> f64;

/// Words, the longer before those they begin with.
const FUNCTIONS: [(&str, Function); 10] = [
    ("sqrt", f64::sqrt),
    ("√", f64::sqrt),
    ("cbrt", f64::cbrt),
    ("sin", f64::sin),
    ("cos", f64::cos),
    ("tan", f64::tan),
    ("atan", f64::atan),
    ("exp", f64::exp),
    ("ln", f64::ln),
    ("abs", f64::abs),
];
const CONSTANTS: [(&str, f64); 5] =
    [("pi", std::f64::consts::PI), ("π", std::f64::consts::PI), ("½", 0.5), ("¼", 0.25), ("¾", 0.75)];

impl<'a> Reader<'a> {
    fn skip(&mut self, length: usize) {
        self.rest = self.rest[length..].trim_start();
    }

    /// Takes a sign that comes next.
    fn sign(&mut self, is: impl Fn(char) -> bool) -> Option<char> {
        let sign = self.rest.chars().next().filter(|&sign| is(sign))?;
        self.skip(sign.len_utf8());
        Some(sign)
    }

    /// Takes a word that comes next, whose letters end there.
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

    fn sum(&mut self) -> Option<Form> {
        let mut form = self.product()?;
        while let Some(sign) = self.sign(|c| c == '+' || is_minus(c)) {
            form = form.plus(if sign == '+' { 1.0 } else { -1.0 }, self.product()?);
        }
        Some(form)
    }

    fn product(&mut self) -> Option<Form> {
        let mut form = self.signed()?;
        loop {
            if self.rest.starts_with("**") {
                return None;
            }
            if self.sign(|c| matches!(c, '*' | '×' | '·' | '⋅')).is_some() {
                form = form.times(self.signed()?)?;
            } else if self.sign(|c| matches!(c, '/' | '÷' | '⁄' | '∕')).is_some() {
                form = form.over(self.signed()?)?;
            } else if self
                .rest
                .starts_with(|c: char| c == '(' || c == '√' || c == 'π' || c.is_ascii_alphabetic())
            {
                // 2√3, 2(1 + x): a product without a sign.
                form = form.times(self.power()?)?;
            } else {
                return Some(form);
            }
        }
    }

    fn signed(&mut self) -> Option<Form> {
        match self.sign(|c| c == '+' || is_minus(c)) {
            Some('+') | None => self.power(),
            Some(_) => Some(self.power()?.scaled(-1.0)),
        }
    }

    fn power(&mut self) -> Option<Form> {
        let base = self.suffixed()?;
        let two = self.rest.starts_with("**");
        if two {
            self.skip(2);
        }
        if two || self.sign(|c| c == '^').is_some() {
            let exponent = self.signed()?;
            return exponent.is_constant().then(|| base.map(|base| base.powf(exponent.k)))?;
        }
        Some(base)
    }

    fn suffixed(&mut self) -> Option<Form> {
        let form = self.single()?;
        if self.sign(|c| c == '°').is_some() || self.word("deg") {
            return form.map(|angle| angle * DEGREES);
        }
        match self.sign(|c| matches!(c, '²' | '³')) {
            Some('²') => form.map(|base| base * base),
            Some(_) => form.map(|base| base * base * base),
            None => Some(form),
        }
    }

    fn single(&mut self) -> Option<Form> {
        if self.sign(|c| c == '(').is_some() {
            let form = self.sum()?;
            return self.sign(|c| c == ')').map(|_| form);
        }
        let length = number_length(self.rest);
        if length > 0 {
            let number = self.rest[..length].parse().ok()?;
            self.skip(length);
            return Some(Form::constant(number));
        }
        for (word, constant) in CONSTANTS {
            if self.word(word) {
                return Some(Form::constant(constant));
            }
        }
        for (word, function) in FUNCTIONS {
            if self.word(word) {
                // Of a root or a sine without brackets is what stands next, with its degrees: cos 30°.
                return self.suffixed()?.map(function);
            }
        }
        if self.word("x") {
            return Some(Form { x: 1.0, ..Form::default() });
        }
        self.word("y").then_some(Form { y: 1.0, ..Form::default() })
    }
}

/// How long the number is that a text begins with, without a sign.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(0);
    let mut end = whole;
    if text[end..].starts_with('.') {
        let rest = digits(end + 1);
        if whole + rest == 0 {
            return 0;
        }
        end += 1 + rest;
    }
    if end > 0 && text[end..].starts_with(['e', 'E']) {
        let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
        let power = digits(end + 1 + sign);
        if power > 0 {
            end += 1 + sign + power;
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_what_they_say() {
        let root = |x: f64| x.sqrt();
        for (text, wanted) in [
            ("1/3", 1.0 / 3.0),
            ("-2/3", -2.0 / 3.0),
            ("\u{2212}.5", -0.5),
            ("sqrt(3)/6", root(3.0) / 6.0),
            ("√3/2", root(3.0) / 2.0),
            ("2√3", 2.0 * root(3.0)),
            ("(1 + sqrt 5)/2", (1.0 + root(5.0)) / 2.0),
            ("1/sqrt(2) - 1", 1.0 / root(2.0) - 1.0),
            ("2^-3", 0.125),
            ("2**3", 8.0),
            ("3²", 9.0),
            ("-2^2", -4.0),
            ("1e-2*3", 0.03),
            ("½", 0.5),
            ("0.5*(2", f64::NAN),
            ("1 2", f64::NAN),
            ("T1", f64::NAN),
            ("e", f64::NAN),
            ("a", f64::NAN),
            ("p", f64::NAN),
            ("1/0", f64::NAN),
            ("sqrt(-1)", f64::NAN),
            ("1x", f64::NAN),
            ("", f64::NAN),
        ] {
            let found = value(text);
            assert_eq!(found, Some(wanted).filter(|wanted| !wanted.is_nan()), "{text}");
        }
        assert!((value("cos(60°)").unwrap() - 0.5).abs() < 1e-15);
        assert!((value("sin pi/2").unwrap_or(9.0)).abs() < 1e-15);
        assert_eq!(value(&"(".repeat(150)), None);
        assert_eq!(value(&format!("{}1", "-(".repeat(99))), None);
    }

    #[test]
    fn coordinates_have_their_factors() {
        for (text, x, y, k) in [
            (".2*x -.26*y", 0.2, -0.26, 0.0),
            ("0.85x + 0.04y + 1.6", 0.85, 0.04, 1.6),
            ("(x + y)/2 - 1", 0.5, 0.5, -1.0),
            ("1 - x", -1.0, 0.0, 1.0),
            ("7", 0.0, 0.0, 7.0),
        ] {
            assert_eq!(form(text), Some(Form { x, y, k }), "{text}");
        }
        assert_eq!(form("x*y"), None);
        assert_eq!(form("sin(x)"), None);
        assert_eq!(form("1/x"), None);
    }
}
