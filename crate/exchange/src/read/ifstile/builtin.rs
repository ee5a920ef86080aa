//! The functions of the language.

use std::cmp::Ordering;
use std::rc::Rc;

use super::affine::{Affine, MAX_DIMENSION};
use super::blocks::refused;
use super::machine::{Found, Machine};
use super::number::Number;
use super::rational::Rational;
use super::syntax::{Expression, Joint};
use super::value::{Instance, Value};
use crate::read::problem::ImportError;
use crate::text::short;

/// What stands for many things at once, from which IFStile's finder chooses.
const TEMPLATES: [&str; 8] =
    ["$number", "$vector", "$binary", "$semigroup", "$permutation", "$real", "$integer", "$template"];
const BRANCHES: &str = "“if” takes a condition, a value, and another for else: if(x,1,2).";
/// The code of what holds one.
pub const TEMPLATE: &str = "aifs-template";

impl<'p, 'a> Machine<'p, 'a> {
    /// A name with round brackets behind it: a function, a block, or the size or an element of a list.
    pub fn call(&mut self, name: &'a str, arguments: &'p [Expression<'a>]) -> Found<'a> {
        self.charge(1)?;
        if name == "if" {
            return self.chosen(arguments);
        }
        if name.starts_with('$') {
            return self.special(name, arguments);
        }
        let variable =
            self.definition(name).is_some() || self.frame().given.iter().any(|(given, _)| *given == name);
        if !variable && let Some(&block) = self.program.ids.get(name) {
            let arguments = self.arguments(arguments)?;
            return self.called(block, arguments);
        }
        if !variable {
            return self.function(name, arguments);
        }
        match (self.named(name)?, arguments) {
            (Value::Block(instance), _) => {
                let arguments = self.arguments(arguments)?;
                self.called(instance.block, arguments)
            }
            (Value::List(list), []) => {
                Ok(Value::Number(Number::whole(i64::try_from(list.len()).unwrap_or(i64::MAX))))
            }
            (Value::List(list), [index]) => {
                let index = self.value(index)?;
                let index = self.number(index)?.as_whole().unwrap_or(i64::MAX);
                let count = i64::try_from(list.len()).unwrap_or(i64::MAX);
                let at = if index < 0 { count.saturating_add(index) } else { index };
                match usize::try_from(at).ok().and_then(|at| list.get(at)) {
                    Some(value) => Ok(value.clone()),
                    None => self.fail(format!("“{}” has no element {index}.", short(name, 20))),
                }
            }
            (other, _) => {
                let (name, noun) = (short(name, 20), other.noun());
                self.fail(format!(
                    "“{name}” is {noun}, and is called like a function. Write “*” for a product."
                ))
            }
        }
    }

    fn function(&mut self, name: &'a str, arguments: &'p [Expression<'a>]) -> Found<'a> {
        let mut numbers = Vec::new();
        for argument in arguments {
            match self.value(argument)? {
                // The angle of a point.
                Value::List(list) if name == "arg" => numbers.extend(self.flat_numbers(&list)?),
                other => numbers.push(self.number(other)?),
            }
        }
        match Number::function(name, &numbers) {
            Some(outcome) => self.told(outcome).map(Value::Number),
            None => {
                let name = short(name, 30);
                self.fail(format!(
                    "“{name}(” is not read: there is no such function of so many numbers, and no block of this name."
                ))
            }
        }
    }

    /// `if(condition, value, condition, value, .., else)`, of which only what is chosen is computed.
    fn chosen(&mut self, arguments: &'p [Expression<'a>]) -> Found<'a> {
        match arguments {
            [condition] => {
                let condition = self.value(condition)?;
                let holds = self.holds(condition)?;
                Ok(Value::Number(Number::whole(i64::from(holds))))
            }
            [one, other] => {
                let (one, other) = (self.value(one)?, self.value(other)?);
                let order = self.compared(&one, &other)?;
                Ok(Value::Number(Number::whole(order as i64)))
            }
            _ => {
                let branch = self.branch(arguments)?;
                self.value(branch)
            }
        }
    }

    /// Which of the values of `if` is chosen.
    pub fn branch(&mut self, arguments: &'p [Expression<'a>]) -> Result<&'p Expression<'a>, ImportError> {
        let [pairs @ .., last] = arguments else {
            return self.fail(BRANCHES);
        };
        if pairs.is_empty() || pairs.len() % 2 == 1 {
            return self.fail(BRANCHES);
        }
        for pair in pairs.chunks(2) {
            let condition = self.value(&pair[0])?;
            if self.holds(condition)? {
                return Ok(&pair[1]);
            }
        }
        Ok(last)
    }

    fn compared(&mut self, one: &Value<'a>, other: &Value<'a>) -> Result<Ordering, ImportError> {
        self.charge(1)?;
        let (Value::List(one), Value::List(other)) = (one, other) else {
            let (one, other) = (self.number(one.clone())?, self.number(other.clone())?);
            return self.told(one.compare(&other));
        };
        for (one, other) in one.iter().zip(other.iter()) {
            let order = self.compared(one, other)?;
            if order != Ordering::Equal {
                return Ok(order);
            }
        }
        Ok(one.len().cmp(&other.len()))
    }

    fn special(&mut self, name: &'a str, arguments: &'p [Expression<'a>]) -> Found<'a> {
        if TEMPLATES.contains(&name) {
            let why =
                format!("“{name}” stands for many values, of which IFStile's finder chooses one. Write one.");
            return Err(refused(TEMPLATE, self.line, &why));
        }
        match (name, arguments) {
            ("$companion", [list]) => {
                let lower = self.number_list(list)?;
                if !(1..=MAX_DIMENSION).contains(&lower.len()) {
                    let count = lower.len();
                    return self.fail(format!(
                        "A companion matrix has 1 to {MAX_DIMENSION} numbers, and here are {count}. Give as many as $dim \
                         says, without the leading 1."
                    ));
                }
                self.told(Affine::companion(&lower)).map(|map| Value::Map(Rc::new(map)))
            }
            ("$diagonal", [list]) => {
                let entries = self.number_list(list)?;
                if entries.len() != self.size() {
                    return self.fail("A diagonal has as many numbers as $dim says.");
                }
                self.told(Affine::diagonal(&entries)).map(|map| Value::Map(Rc::new(map)))
            }
            ("$exchange", []) => Ok(Value::Map(Rc::new(Affine::exchange(self.size())))),
            ("$charpoly", [map]) => {
                let map = self.value(map)?;
                let map = self.single(map)?;
                let products = map.size.pow(4);
                self.charge(Number::steps(products, 2 * map.words()))?;
                let lower = self.told(map.characteristic())?;
                let longest = lower.iter().map(Number::words).max().unwrap_or(1);
                self.charge(Number::steps(products, longest))?;
                Ok(Value::numbers(lower))
            }
            ("$numden", [x]) => {
                let x = self.value(x)?;
                let Number::Exact(x) = self.number(x)? else {
                    return self.fail(
                        "“$numden” of a number that is not rational takes how near it should be, too.",
                    );
                };
                self.parts(&x)
            }
            ("$numden", [x, near]) => {
                let (x, near) = (self.value(x)?, self.value(near)?);
                let (x, near) = (self.number(x)?, self.number(near)?);
                let (x, near) = (self.told(x.rational())?, self.told(near.rational())?);
                match nearest(&x, &near) {
                    Some(found) => self.parts(&found),
                    None => Ok(Value::numbers(vec![Number::ZERO, Number::ZERO])),
                }
            }
            ("$union", [list]) => {
                let value = self.value(list)?;
                self.united(value)
            }
            ("$new", [block, given @ ..]) if given.len() % 2 == 0 => self.made_of(block, given),
            _ => {
                let name = short(name, 30);
                self.fail(format!(
                    "“{name}(” is not read with so many arguments: it is no function of the language."
                ))
            }
        }
    }

    fn number_list(&mut self, list: &'p Expression<'a>) -> Result<Vec<Number>, ImportError> {
        match self.value(list)? {
            Value::List(list) => {
                self.charge(list.len())?;
                list.iter().map(|value| self.number(value.clone())).collect()
            }
            other => Ok(vec![self.number(other)?]),
        }
    }

    /// Numerator and denominator.
    fn parts(&mut self, x: &Rational) -> Found<'a> {
        let ratio = x.ratio();
        let of = |part: &num_bigint::BigInt| {
            Value::Number(Number::Exact(Rational::of(num_rational::Ratio::from_integer(part.clone()))))
        };
        Ok(Value::list(vec![of(ratio.numer()), of(ratio.denom())]))
    }

    /// A block with some of its variables.
    fn made_of(&mut self, block: &'p Expression<'a>, given: &'p [Expression<'a>]) -> Found<'a> {
        let Value::Block(instance) = self.value(block)? else {
            return self.fail("“$new” takes a block first: $new(block, variable, value).");
        };
        let mut all = Vec::new();
        let block = instance.block;
        for pair in given.chunks(2) {
            let name = match &pair[0] {
                Expression::Name(name) => *name,
                other => {
                    let place = self.value(other)?;
                    let names = self.variables_of(block)?;
                    names[self.place(&place, names.len())?]
                }
            };
            all.push((name, self.value(&pair[1])?));
        }
        Ok(Value::Block(Rc::new(Instance { block, given: all })))
    }

    /// A union of what is in a list, whose lists are products of what is in them, whose lists are unions.
    fn united(&mut self, value: Value<'a>) -> Found<'a> {
        let Value::List(list) = value else { return Ok(value) };
        if self.is_flat_map(&list) {
            return Ok(Value::List(list));
        }
        let mut all = Vec::new();
        for value in list.iter() {
            let value = self.within(|machine| machine.multiplied(value.clone()))?;
            all.push(value);
        }
        self.union_of(all)
    }

    fn multiplied(&mut self, value: Value<'a>) -> Found<'a> {
        let Value::List(list) = value else { return Ok(value) };
        if self.is_flat_map(&list) {
            return Ok(Value::List(list));
        }
        let mut product = Value::Map(Rc::new(Affine::identity(self.size())));
        for value in list.iter() {
            let value = self.within(|machine| machine.united(value.clone()))?;
            product = self.joined(product, Joint::Times, value)?;
        }
        Ok(product)
    }
}

/// The first convergent that is so near.
fn nearest(x: &Rational, near: &Rational) -> Option<Rational> {
    let (mut before, mut now) = ([Rational::ONE, Rational::ZERO], [x.floor(), Rational::ONE]);
    let mut rest = x.minus(&x.floor());
    for _ in 0..64 {
        let found = now[0].times(&now[1].inverse()?);
        let off = found.minus(x);
        let off = if off.signum() < 0 { off.negated() } else { off };
        if off.compare(near) != Ordering::Greater {
            return Some(found);
        }
        let inverse = rest.inverse()?;
        let whole = inverse.floor();
        rest = inverse.minus(&whole);
        let next = [0, 1].map(|k| now[k].times(&whole).plus(&before[k]));
        before = std::mem::replace(&mut now, next);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_near_a_number_are_its_convergents() {
        let pi = Rational::of_double(std::f64::consts::PI).unwrap();
        for (near, wanted) in
            [("0.2", (3, 1)), ("0.002", (22, 7)), ("0.0001", (333, 106)), ("1e-6", (355, 113))]
        {
            let found = nearest(&pi, &Rational::decimal(near).unwrap());
            assert_eq!(found, Some(Rational::fraction(wanted.0, wanted.1)), "{near}");
        }
    }
}
