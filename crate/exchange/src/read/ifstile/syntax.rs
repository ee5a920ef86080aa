//! Expressions as they are written.
//!
//! ```text
//! union    a | b              sum      a + b - c         product  a * b / c % d
//! power    a ^ b              suffix   a[1] a[1:3] a(x) a.b
//! ```

/// Brackets within brackets.
const MAX_NESTED: usize = 40;
/// Parts of a union, of which some may be empty.
const MAX_UNITED: usize = 4096;
/// Said where there are more maps than a system has.
pub const MANY: &str = "There are more than 64 maps, and the most is 64. Unite fewer.";
/// Said where it takes too long.
pub const TOO_LONG: &str = "This takes too many steps to compute. Make the block smaller.";

#[derive(Debug)]
pub enum Expression<'a> {
    Number(&'a str),
    Name(&'a str),
    /// `$`: the list that is being made.
    Own,
    List(Vec<Self>),
    Union(Vec<Self>),
    /// Each with whether it is taken away.
    Sum(Vec<(bool, Self)>),
    Product(Vec<(Joint, Self)>),
    Power(Box<[Self; 2]>),
    Negative(Box<Self>),
    Suffixed(Box<Self>, Vec<Suffix<'a>>),
}

/// How a factor follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joint {
    Times,
    Over,
    Modulo,
}

#[derive(Debug)]
pub enum Suffix<'a> {
    Call(Vec<Expression<'a>>),
    /// `[]`
    Flat,
    Index(Expression<'a>),
    Slice(Box<[Option<Expression<'a>>; 3]>),
    Field(&'a str),
}

/// Words and signs that are left, and so many more as may be read.
pub struct Parser<'a, 'b> {
    rest: &'a str,
    depth: usize,
    steps: &'b mut usize,
}

type Parsed<T> = Result<T, String>;

/// Reads an expression, and takes a step from those that are left for each of its parts.
pub fn parse<'a>(text: &'a str, steps: &mut usize) -> Parsed<Expression<'a>> {
    let mut parser = Parser { rest: text, depth: 0, steps };
    let found = parser.union()?;
    parser.skip();
    if parser.rest.is_empty() { Ok(found) } else { Err(parser.unread()) }
}

/// The names in a text.
pub fn words(text: &str) -> Vec<&str> {
    let mut words = Vec::new();
    for line in text.lines() {
        let mut rest = line.split('#').next().unwrap_or_default();
        while let Some(start) = rest.find(|c: char| is_letter(c) || c.is_ascii_digit() || c == '.') {
            rest = &rest[start..];
            let word = if rest.starts_with(is_letter) {
                let word = &rest[..name_length(rest)];
                words.push(word.trim_start_matches('&'));
                word
            } else {
                &rest[..number_length(rest).max(1)]
            };
            rest = &rest[word.len()..];
        }
    }
    words
}

const fn is_letter(c: char) -> bool {
    c.is_ascii_alphabetic() || matches!(c, '_' | '$' | '&')
}

fn name_length(text: &str) -> usize {
    let more = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
    let first = text.chars().next().map_or(0, char::len_utf8);
    text[first..].find(more).map_or(text.len(), |end| first + end)
}

/// A sign belongs to a number behind its exponent.
fn number_length(text: &str) -> usize {
    let mut before = ' ';
    let end = text.find(|c: char| {
        let exponent = matches!(before, 'e' | 'E') && matches!(c, '+' | '-');
        before = c;
        !(exponent || c.is_ascii_alphanumeric() || c == '.' || c == '_')
    });
    end.unwrap_or(text.len())
}

impl<'a> Parser<'a, '_> {
    fn skip(&mut self) {
        loop {
            self.rest = self.rest.trim_start();
            if !self.rest.starts_with('#') {
                return;
            }
            self.rest = self.rest.find('\n').map_or("", |end| &self.rest[end..]);
        }
    }

    fn unread(&self) -> String {
        if self.rest.is_empty() {
            return "Something is missing at the end.".into();
        }
        format!("“{}” is not read there.", crate::text::short(self.rest, 30))
    }

    fn take(&mut self, sign: char) -> bool {
        self.skip();
        self.rest.strip_prefix(sign).map(|after| self.rest = after).is_some()
    }

    fn step(&mut self) -> Parsed<()> {
        *self.steps = self.steps.checked_sub(1).ok_or(TOO_LONG)?;
        Ok(())
    }

    fn union(&mut self) -> Parsed<Expression<'a>> {
        let first = self.sum()?;
        let mut all = Vec::new();
        while self.take('|') {
            if all.len() == MAX_UNITED {
                return Err(MANY.into());
            }
            all.push(self.sum()?);
        }
        if all.is_empty() {
            return Ok(first);
        }
        all.insert(0, first);
        Ok(Expression::Union(all))
    }

    fn sum(&mut self) -> Parsed<Expression<'a>> {
        let first = self.product()?;
        let mut more = Vec::new();
        loop {
            if self.take('+') {
                more.push((false, self.product()?));
            } else if self.take('-') {
                more.push((true, self.product()?));
            } else if more.is_empty() {
                return Ok(first);
            } else {
                more.insert(0, (false, first));
                return Ok(Expression::Sum(more));
            }
        }
    }

    fn product(&mut self) -> Parsed<Expression<'a>> {
        let first = self.signed()?;
        let mut more = Vec::new();
        loop {
            let joint = if self.take('*') {
                Joint::Times
            } else if self.take('/') {
                Joint::Over
            } else if self.take('%') {
                Joint::Modulo
            } else if more.is_empty() {
                return Ok(first);
            } else {
                more.insert(0, (Joint::Times, first));
                return Ok(Expression::Product(more));
            };
            more.push((joint, self.signed()?));
        }
    }

    fn signed(&mut self) -> Parsed<Expression<'a>> {
        let mut negative = false;
        loop {
            if self.take('-') {
                negative = !negative;
            } else if !self.take('+') {
                break;
            }
            self.step()?;
        }
        let value = self.power()?;
        Ok(if negative { Expression::Negative(Box::new(value)) } else { value })
    }

    fn power(&mut self) -> Parsed<Expression<'a>> {
        let base = self.suffixed()?;
        if !self.take('^') {
            return Ok(base);
        }
        // The exponent has its own sign and its own exponent: 2^-1^2 is 2^-(1^2).
        self.enter()?;
        let exponent = self.signed()?;
        self.depth -= 1;
        Ok(Expression::Power(Box::new([base, exponent])))
    }

    fn suffixed(&mut self) -> Parsed<Expression<'a>> {
        let value = self.atom()?;
        let mut suffixes = Vec::new();
        loop {
            if self.take('(') {
                suffixes.push(Suffix::Call(self.listed(')')?));
            } else if self.take('[') {
                suffixes.push(self.index()?);
            } else if self.rest.starts_with('.') && self.rest[1..].starts_with(is_letter) {
                self.rest = &self.rest[1..];
                suffixes.push(Suffix::Field(self.word()));
            } else if suffixes.is_empty() {
                return Ok(value);
            } else {
                return Ok(Expression::Suffixed(Box::new(value), suffixes));
            }
            self.step()?;
        }
    }

    fn index(&mut self) -> Parsed<Suffix<'a>> {
        if self.take(']') {
            return Ok(Suffix::Flat);
        }
        self.enter()?;
        let mut parts: [Option<Expression<'a>>; 3] = [None, None, None];
        let mut at = 0;
        loop {
            if self.take(':') {
                at += 1;
                if at == 3 {
                    return Err("A slice has at most two colons: [from:to:step].".into());
                }
            } else if self.take(']') {
                break;
            } else if parts[at].is_some() {
                return Err("An index in square brackets is not closed.".into());
            } else {
                parts[at] = Some(self.union()?);
            }
        }
        self.depth -= 1;
        let [first, second, third] = parts;
        match (at, first) {
            (0, Some(index)) => Ok(Suffix::Index(index)),
            (_, first) => Ok(Suffix::Slice(Box::new([first, second, third]))),
        }
    }

    fn enter(&mut self) -> Parsed<()> {
        self.depth += 1;
        if self.depth > MAX_NESTED { Err("Names or brackets go on without end.".into()) } else { Ok(()) }
    }

    /// What stands between commas up to the closing bracket.
    fn listed(&mut self, close: char) -> Parsed<Vec<Expression<'a>>> {
        self.enter()?;
        let mut list = Vec::new();
        let mut closed = self.take(close);
        while !closed {
            list.push(self.union()?);
            closed = self.take(close);
            if closed || self.take(',') {
                continue;
            }
            return Err(match (self.rest.is_empty(), close) {
                (true, ')') => "A bracket is missing its partner.".into(),
                (true, _) => "A list is not closed.".into(),
                _ => self.unread(),
            });
        }
        self.depth -= 1;
        Ok(list)
    }

    fn word(&mut self) -> &'a str {
        let (word, after) = self.rest.split_at(name_length(self.rest));
        self.rest = after;
        word
    }

    fn atom(&mut self) -> Parsed<Expression<'a>> {
        self.step()?;
        self.skip();
        if self.take('(') {
            self.enter()?;
            let value = self.union()?;
            self.depth -= 1;
            return if self.take(')') {
                Ok(value)
            } else if self.rest.is_empty() {
                Err("A bracket is missing its partner.".into())
            } else {
                Err(self.unread())
            };
        }
        if self.take('[') {
            return Ok(Expression::List(self.listed(']')?));
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            let (number, after) = self.rest.split_at(number_length(self.rest));
            self.rest = after;
            return Ok(Expression::Number(number));
        }
        if self.rest.starts_with(is_letter) {
            let name = self.word().trim_start_matches('&');
            return Ok(if name == "$" { Expression::Own } else { Expression::Name(name) });
        }
        Err(self.unread())
    }
}
