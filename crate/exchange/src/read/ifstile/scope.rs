//! The names of a block, and what its expressions come to.

use frond_core::MAX_MAPS;

use super::blocks::{Block, Definition, refused};
use super::value::{Map, Value};
use crate::read::problem::ImportError;
use crate::system::System;
use crate::text::{name_or, number, short};

/// Blocks within blocks, names within names, brackets within brackets.
pub const MAX_DEPTH: usize = 32;
/// Said where they go on beyond that.
const ENDLESS: &str = "Names or brackets go on without end.";
const TOO_LARGE: &str = "A number becomes too large.";
/// So many letters of a text are a step.
const STEP_LETTERS: usize = 64;

/// The definitions of a block, its parents' behind its own.
pub struct Scope<'a> {
    pub chain: Vec<&'a Block<'a>>,
    pub size: usize,
    pub set: &'a str,
    pub line: usize,
    pub steps: usize,
    /// The most steps.
    pub most: usize,
}

impl<'a> Scope<'a> {
    fn find(&self, name: &str) -> Option<Definition<'a>> {
        self.chain.iter().find_map(|block| block.definitions.get(name).copied())
    }

    /// The same to be read: that takes the longer the longer it is.
    fn look(&mut self, name: &str) -> Result<Option<Definition<'a>>, ImportError> {
        let found = self.find(name);
        self.charge(1 + found.map_or(0, |it| it.value.len() / STEP_LETTERS))?;
        Ok(found)
    }

    /// The name of the only set.
    pub fn find_set(&mut self) -> Result<Option<&'a str>, ImportError> {
        let mut found: Option<&str> = None;
        for depth in 0..self.chain.len() {
            self.step()?;
            let block = self.chain[depth];
            for &name in &block.sets {
                self.step()?;
                match found {
                    _ if !self.find(name).is_some_and(|it| it.set) => {}
                    Some(set) if set != name => {
                        let (one, other) = (short(set, 20), short(name, 20));
                        return self.fail(&format!("“{one}” and “{other}” are two sets."));
                    }
                    _ => found = Some(name),
                }
            }
        }
        Ok(found)
    }

    fn fail<T>(&self, why: &str) -> Result<T, ImportError> {
        Err(refused("aifs-unread", self.line, why))
    }

    pub fn read(&mut self) -> Result<System, ImportError> {
        if let Some(it) = self.find("$subspace") {
            self.line = it.line;
            return self.fail("$subspace is not read.");
        }
        self.size = match self.find("$dim") {
            None | Some(Definition { value: "2", .. }) => 2,
            Some(Definition { value: "3", .. }) => 3,
            Some(it) => {
                self.line = it.line;
                return self.fail("$dim is neither 2 nor 3.");
            }
        };
        let Some(Definition { value, line, .. }) = self.look(self.set)? else {
            return self.fail("No equation of a set is here.");
        };
        self.line = line;
        let Value::Images(maps) = self.value(value, 0)? else {
            return self.fail("This is no equation of a set by its images.");
        };
        let name = self.look("$n")?;
        let name = name.map_or_else(String::new, |it| name_or(it.value.trim_matches('"'), ""));
        Ok(if self.size == 2 {
            let row = |Map { matrix: m, shift: s, .. }: Map| [m[0], m[1], m[2], m[3], s[0], s[1]];
            System::plane(name, maps.into_iter().map(row).collect())
        } else {
            let row =
                |map: Map| std::array::from_fn(|k| if k < 9 { map.matrix[k] } else { map.shift[k - 9] });
            System::space(name, maps.into_iter().map(row).collect())
        })
    }

    fn step(&mut self) -> Result<(), ImportError> {
        self.charge(1)
    }

    fn charge(&mut self, steps: usize) -> Result<(), ImportError> {
        self.steps += steps;
        if self.steps > self.most { self.fail("This takes too many steps to compute.") } else { Ok(()) }
    }

    fn value(&mut self, text: &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut rest = text;
        let value = self.union(&mut rest, depth)?;
        if rest.trim().is_empty() {
            return Ok(value);
        }
        let why = format!("“{}” is not read.", short(rest, 30));
        self.fail(&why)
    }

    fn name(&mut self, name: &'a str, depth: usize) -> Result<Value, ImportError> {
        self.step()?;
        match name {
            _ if name == self.set => return Ok(Value::Images(vec![Map::scaling(self.size, 1.0)])),
            "$i" => return Ok(Value::Maps(vec![Map::scaling(self.size, 1.0)])),
            "$pi" => return Ok(Value::Number(std::f64::consts::PI)),
            _ => {}
        }
        if depth > MAX_DEPTH {
            return self.fail(ENDLESS);
        }
        let Some(Definition { value, line, .. }) = self.look(name)? else {
            let why = format!("“{}” is not read.", short(name, 30));
            return self.fail(&why);
        };
        let here = std::mem::replace(&mut self.line, line);
        let value = self.value(value, depth + 1)?;
        self.line = here;
        Ok(value)
    }

    fn union(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut value = self.sum(rest, depth)?;
        while take(rest, '|') {
            self.step()?;
            let next = self.sum(rest, depth)?;
            value = match (value, next) {
                (Value::Images(one), Value::Images(other)) => Value::Images(self.few([one, other].concat())?),
                (Value::Images(_), _) | (_, Value::Images(_)) => {
                    return self.fail("Images of the set are united with what is none.");
                }
                (one, other) => {
                    let both = [self.maps(one)?, self.maps(other)?].concat();
                    Value::Maps(self.few(both)?)
                }
            };
        }
        Ok(value)
    }

    fn sum(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut value = self.product(rest, depth)?;
        loop {
            let sign = if take(rest, '+') {
                1.0
            } else if take(rest, '-') {
                -1.0
            } else {
                return Ok(value);
            };
            self.step()?;
            let next = self.product(rest, depth)?;
            let (Value::Number(one), Value::Number(other)) = (value, next) else {
                return self.fail("Sums are read of numbers alone.");
            };
            value = self.number(one + sign * other)?;
        }
    }

    fn product(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut value = self.power(rest, depth)?;
        loop {
            let times = take(rest, '*');
            if !times && !take(rest, '/') {
                return Ok(value);
            }
            self.step()?;
            let next = self.power(rest, depth)?;
            value = match (value, next, times) {
                (Value::Number(one), Value::Number(other), true) => self.number(one * other)?,
                (Value::Number(_), Value::Number(0.0), false) => {
                    return self.fail("A number is divided by 0.");
                }
                (Value::Number(one), Value::Number(other), false) => self.number(one / other)?,
                (_, _, false) => return self.fail("Quotients are read of numbers alone."),
                (Value::Images(_), _, _) => return self.fail("A set stands before “*”."),
                (one, Value::Images(images), _) => Value::Images(self.composed(one, &images)?),
                (one, other, _) => {
                    let other = self.maps(other)?;
                    Value::Maps(self.composed(one, &other)?)
                }
            };
        }
    }

    fn power(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut negative = false;
        while take(rest, '-') {
            self.step()?;
            negative = !negative;
        }
        let value = self.raised(rest, depth)?;
        match value {
            value if !negative => Ok(value),
            Value::Number(x) => Ok(Value::Number(-x)),
            other => {
                let maps = self.maps(other)?;
                Ok(Value::Maps(self.composed(Value::Number(-1.0), &maps)?))
            }
        }
    }

    fn raised(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let value = self.atom(rest, depth)?;
        if !take(rest, '^') {
            return Ok(value);
        }
        let sign = if take(rest, '-') { -1.0 } else { 1.0 };
        let Value::Number(power) = self.atom(rest, depth)? else { return self.fail("A power is no number.") };
        match value {
            Value::Number(0.0) if sign * power < 0.0 => self.fail("A number is divided by 0."),
            Value::Number(x) if x < 0.0 && power.fract() != 0.0 => {
                self.fail("A broken power of a negative number is no number.")
            }
            Value::Number(x) => self.number(x.powf(sign * power)),
            Value::Images(_) => self.fail("A set has no power."),
            other if sign > 0.0 && (0.0..=MAX_MAPS as f64).contains(&power) && power.fract() == 0.0 => {
                let maps = self.maps(other)?;
                let mut all = vec![Map::scaling(self.size, 1.0)];
                for _ in 0..power as usize {
                    self.step()?;
                    all = self.composed(Value::Maps(maps.clone()), &all)?;
                }
                Ok(Value::Maps(all))
            }
            _ => self.fail("Powers of maps are read from 0 to 64."),
        }
    }

    fn atom(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        self.step()?;
        if depth > MAX_DEPTH {
            return self.fail(ENDLESS);
        }
        if take(rest, '(') {
            let value = self.union(rest, depth + 1)?;
            return if take(rest, ')') { Ok(value) } else { self.fail("A bracket is missing its partner.") };
        }
        if take(rest, '[') {
            let mut list = Vec::new();
            loop {
                match self.union(rest, depth + 1)? {
                    Value::Number(x) if list.len() < 9 => list.push(x),
                    Value::Number(_) => return self.fail("A list is longer than a matrix."),
                    _ => return self.fail("Lists are read of numbers alone."),
                }
                if take(rest, ']') {
                    return Ok(Value::List(list));
                }
                if !take(rest, ',') {
                    return self.fail("A list is not closed.");
                }
            }
        }
        let word = word(rest);
        if word.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return match number(word) {
                Some(x) => Ok(Value::Number(x)),
                None => self.fail(&format!("“{}” is no number.", short(word, 30))),
            };
        }
        if word.is_empty() {
            let why = if rest.is_empty() {
                "Something is missing at the end.".into()
            } else {
                format!("“{}” is not read.", short(rest, 30))
            };
            return self.fail(&why);
        }
        if rest.starts_with(['(', '[']) {
            let why = format!("“{}{}” is not read.", short(word, 30), &rest[..1]);
            return self.fail(&why);
        }
        self.name(word, depth)
    }

    /// A number scales, a list is a translation or a matrix.
    fn maps(&self, value: Value) -> Result<Vec<Map>, ImportError> {
        let size = self.size;
        match value {
            Value::Maps(maps) => Ok(maps),
            Value::Number(x) => Ok(vec![Map::scaling(size, x)]),
            Value::List(list) if list.len() == size => {
                let mut map = Map::scaling(size, 1.0);
                map.shift[..size].copy_from_slice(&list);
                Ok(vec![map])
            }
            Value::List(list) if list.len() == size * size => {
                let mut map = Map::scaling(size, 0.0);
                map.matrix[..size * size].copy_from_slice(&list);
                Ok(vec![map])
            }
            Value::List(list) => {
                let why =
                    format!("A list of {} numbers is neither a translation nor a matrix here.", list.len());
                self.fail(&why)
            }
            Value::Images(_) => self.fail("A set stands where a map should be."),
        }
    }

    fn composed(&mut self, outer: Value, inner: &[Map]) -> Result<Vec<Map>, ImportError> {
        let outer = self.maps(outer)?;
        if outer.len() * inner.len() > MAX_MAPS {
            return self.fail("There are more than 64 maps, and the most is 64.");
        }
        self.charge(outer.len() * inner.len())?;
        let maps: Vec<Map> =
            outer.iter().flat_map(|one| inner.iter().map(|other| one.after(other))).collect();
        match maps.iter().position(|map| !map.matrix.iter().chain(&map.shift).all(|x| x.is_finite())) {
            Some(_) if maps.len() == 1 => self.fail(TOO_LARGE),
            Some(at) => self.fail(&format!("Of {} products, in number {}: {TOO_LARGE}", maps.len(), at + 1)),
            None => Ok(maps),
        }
    }

    /// What is computed from numbers is one, or it is said.
    fn number(&self, x: f64) -> Result<Value, ImportError> {
        if x.is_finite() { Ok(Value::Number(x)) } else { self.fail(TOO_LARGE) }
    }

    fn few(&self, maps: Vec<Map>) -> Result<Vec<Map>, ImportError> {
        if maps.len() > MAX_MAPS {
            self.fail("There are more than 64 maps, and the most is 64.")
        } else {
            Ok(maps)
        }
    }
}

fn take(rest: &mut &str, sign: char) -> bool {
    *rest = rest.trim_start();
    rest.strip_prefix(sign).map(|after| *rest = after).is_some()
}

/// A number or a name.
fn word<'a>(rest: &mut &'a str) -> &'a str {
    let text = *rest;
    let is_number = text.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    let mut before = ' ';
    let end = text.find(|c: char| {
        // A sign belongs to a number behind its exponent.
        let exponent = is_number && matches!(before, 'e' | 'E') && matches!(c, '+' | '-');
        before = c;
        !(exponent
            || c.is_ascii_alphanumeric()
            || c == '_'
            || (is_number && c == '.')
            || (!is_number && matches!(c, '$' | '&')))
    });
    let (word, after) = text.split_at(end.unwrap_or(text.len()));
    *rest = after;
    word
}
