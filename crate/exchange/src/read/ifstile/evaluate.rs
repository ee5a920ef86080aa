//! Expressions, computed.

use frond_core::MAX_MAPS;

use super::machine::{Found, Machine};
use super::number::Number;
use super::rational::Rational;
use super::syntax::{Expression, MANY, Suffix};
use super::value::Value;
use crate::text::short;

/// What an expression comes to.
pub fn evaluate<'p, 'a>(machine: &mut Machine<'p, 'a>, expression: &'p Expression<'a>) -> Found<'a> {
    machine.expression(expression)
}

impl<'p, 'a> Machine<'p, 'a> {
    fn expression(&mut self, expression: &'p Expression<'a>) -> Found<'a> {
        match expression {
            Expression::Number(text) => match Rational::decimal(text) {
                Some(x) => Ok(Value::Number(Number::Exact(x))),
                None => {
                    let text = short(text, 30);
                    self.fail(format!("“{text}” is no number, or has too many digits."))
                }
            },
            Expression::Name(name) => self.within(|machine| machine.named(name)),
            Expression::Own => match self.lists.last() {
                Some(list) => Ok(Value::list(list.clone())),
                None => self.fail("“$” stands outside of a list."),
            },
            Expression::List(elements) => self.within(|machine| machine.made(elements)),
            Expression::Union(parts) => self.within(|machine| machine.union(parts)),
            Expression::Sum(terms) => self.within(|machine| {
                let mut sum: Option<Value<'a>> = None;
                for (minus, term) in terms {
                    let term = machine.value(term)?;
                    sum = Some(match sum {
                        None => term,
                        Some(before) if *minus => {
                            let term = machine.negated(term)?;
                            machine.plus(before, term)?
                        }
                        Some(before) => machine.plus(before, term)?,
                    });
                }
                sum.map_or_else(|| machine.fail("An empty sum."), Ok)
            }),
            Expression::Product(factors) => self.within(|machine| {
                let mut product: Option<Value<'a>> = None;
                for (joint, factor) in factors {
                    let factor = machine.value(factor)?;
                    product = Some(match product {
                        None => factor,
                        Some(before) => machine.joined(before, *joint, factor)?,
                    });
                }
                product.map_or_else(|| machine.fail("An empty product."), Ok)
            }),
            Expression::Power(parts) => self.within(|machine| {
                let [base, exponent] = &**parts;
                let (base, exponent) = (machine.value(base)?, machine.value(exponent)?);
                machine.raised(base, &exponent)
            }),
            Expression::Negative(of) => {
                let value = self.within(|machine| machine.value(of))?;
                self.negated(value)
            }
            Expression::Suffixed(of, suffixes) => self.within(|machine| machine.suffixed(of, suffixes)),
        }
    }

    fn union(&mut self, parts: &'p [Expression<'a>]) -> Found<'a> {
        let mut all = Vec::with_capacity(parts.len().min(MAX_MAPS));
        for part in parts {
            if all.len() > MAX_MAPS {
                return self.fail(MANY);
            }
            all.push(self.value(part)?);
        }
        self.union_of(all)
    }

    fn suffixed(&mut self, of: &'p Expression<'a>, suffixes: &'p [Suffix<'a>]) -> Found<'a> {
        let (mut value, rest) = match (of, suffixes) {
            (Expression::Own, [Suffix::Call(arguments), rest @ ..]) if !arguments.is_empty() => {
                let [level] = arguments.as_slice() else {
                    return self.fail("“$” takes one number: $(1) is the list around this one.");
                };
                let level = self.value(level)?;
                let level = self.number(level)?.as_whole().and_then(|level| usize::try_from(level).ok());
                let Some(level) = level.filter(|&level| level < self.lists.len()) else {
                    return self.fail("There are not so many lists around “$”.");
                };
                self.own(level, rest)?
            }
            (Expression::Own, _) => self.own(0, suffixes)?,
            (Expression::Name(name), [Suffix::Call(arguments), rest @ ..]) => {
                (self.call(name, arguments)?, rest)
            }
            (Expression::List(elements), [Suffix::Call(arguments), rest @ ..])
                if arguments.len() == 1 && !elements.iter().any(|one| matches!(one, Expression::Own)) =>
            {
                // Of what is only asked for one element, the others are not computed.
                let index = self.value(&arguments[0])?;
                let at = self.place(&index, elements.len())?;
                self.lists.push(Vec::new());
                let value = self.value(&elements[at])?;
                self.lists.pop();
                (value, rest)
            }
            _ => (self.value(of)?, suffixes),
        };
        for suffix in rest {
            value = match suffix {
                Suffix::Field(name) => match &value {
                    Value::Block(instance) => self.field(&instance.clone(), name)?,
                    other => return self.fail(format!("{name} is asked for of {}, no block.", other.noun())),
                },
                Suffix::Call(arguments) if matches!(value, Value::Block(_)) => {
                    let arguments = self.arguments(arguments)?;
                    match &value {
                        Value::Block(instance) => self.called(instance.block, arguments)?,
                        _ => value,
                    }
                }
                Suffix::Flat if matches!(value, Value::Map(_)) => self.columns(value)?,
                suffix => {
                    let look = self.look(suffix)?;
                    let list = self.elements(value)?;
                    self.charge(1 + list.len() / 16)?;
                    self.seen(&list, look)?
                }
            };
        }
        Ok(value)
    }
}
