//! Lists: made one by one, also without end but for a condition, and looked at by index and slice.

use std::rc::Rc;

use super::machine::{Found, Machine};
use super::number::Number;
use super::syntax::{Expression, Suffix};
use super::value::Value;
use crate::read::problem::ImportError;

/// The longest list.
const MAX_LIST: usize = 4096;
/// So many steps are taken for each element that is made, because it stays.
const ELEMENT_STEPS: usize = 8;

/// What is done to a list.
pub enum Look<'a> {
    Size,
    Flat,
    At(Value<'a>),
    Slice([Option<i64>; 3]),
}

impl<'p, 'a> Machine<'p, 'a> {
    /// A list of its elements. Behind `$` come a condition and an element, which is made while the condition is
    /// positive; or one element alone, which is made until it is `$`.
    pub fn made(&mut self, elements: &'p [Expression<'a>]) -> Found<'a> {
        self.lists.push(Vec::new());
        let outcome = self.fill(elements);
        let list = self.lists.pop().unwrap_or_default();
        outcome.map(|()| Value::list(list))
    }

    fn fill(&mut self, elements: &'p [Expression<'a>]) -> Result<(), ImportError> {
        let mut at = 0;
        while let Some(element) = elements.get(at) {
            if !matches!(element, Expression::Own) {
                let value = self.value(element)?;
                self.append(value)?;
                at += 1;
                continue;
            }
            let (condition, body) = match &elements[at + 1..] {
                [] => return Ok(()),
                [until] => {
                    while let Some(value) = self.unless_own(until)? {
                        self.append(value)?;
                    }
                    return Ok(());
                }
                [condition, body, ..] => (condition, body),
            };
            loop {
                let condition = self.value(condition)?;
                if !self.holds(condition)? {
                    break;
                }
                let value = self.value(body)?;
                self.append(value)?;
            }
            at += 3;
        }
        Ok(())
    }

    /// What an expression comes to; none where that is `$`, the list itself.
    fn unless_own(&mut self, mut expression: &'p Expression<'a>) -> Result<Option<Value<'a>>, ImportError> {
        loop {
            match expression {
                Expression::Own => return Ok(None),
                Expression::Suffixed(of, suffixes) => match (&**of, suffixes.as_slice()) {
                    (Expression::Name("if"), [Suffix::Call(arguments)]) if arguments.len() > 2 => {
                        expression = self.branch(arguments)?;
                    }
                    _ => return self.value(expression).map(Some),
                },
                _ => return self.value(expression).map(Some),
            }
        }
    }

    fn append(&mut self, value: Value<'a>) -> Result<(), ImportError> {
        self.charge(ELEMENT_STEPS)?;
        match self.lists.last_mut() {
            Some(list) if list.len() < MAX_LIST => list.push(value),
            _ => {
                return self.fail(format!(
                    "A list is longer than {MAX_LIST}. End it by its condition, such as 10-$()."
                ));
            }
        }
        Ok(())
    }

    /// Whether a number is positive, or all numbers of a list.
    pub fn holds(&mut self, value: Value<'a>) -> Result<bool, ImportError> {
        match self.plain(value)? {
            Value::List(list) => {
                self.charge(list.len())?;
                for value in list.iter() {
                    if !self.holds(value.clone())? {
                        return Ok(false);
                    }
                }
                Ok(true)
            }
            other => Ok(self.number(other)?.signum() > 0),
        }
    }

    /// A list that is being made, looked at.
    pub fn own(
        &mut self,
        level: usize,
        suffixes: &'p [Suffix<'a>],
    ) -> Result<(Value<'a>, &'p [Suffix<'a>]), ImportError> {
        if level >= self.lists.len() {
            return self.fail("“$” stands outside of a list.");
        }
        let at = self.lists.len() - 1 - level;
        match suffixes {
            [] => Ok((Value::list(self.lists[at].clone()), suffixes)),
            [first, rest @ ..] => {
                let look = self.look(first)?;
                // Taken out for the moment, so that it is not copied.
                let list = std::mem::take(&mut self.lists[at]);
                self.charge(1)?;
                let value = self.seen(&list, look);
                self.lists[at] = list;
                Ok((value?, rest))
            }
        }
    }

    pub fn arguments(&mut self, list: &'p [Expression<'a>]) -> Result<Vec<Value<'a>>, ImportError> {
        list.iter().map(|one| self.value(one)).collect()
    }

    pub fn look(&mut self, suffix: &'p Suffix<'a>) -> Result<Look<'a>, ImportError> {
        match suffix {
            Suffix::Call(arguments) if arguments.is_empty() => Ok(Look::Size),
            Suffix::Call(arguments) if arguments.len() == 1 => Ok(Look::At(self.value(&arguments[0])?)),
            Suffix::Call(_) => self.fail("A list is asked for one element: a(2)."),
            Suffix::Flat => Ok(Look::Flat),
            Suffix::Index(index) => Ok(Look::At(self.value(index)?)),
            Suffix::Slice(parts) => {
                let mut ends = [None; 3];
                for (end, part) in ends.iter_mut().zip(parts.iter()) {
                    if let Some(part) = part {
                        let value = self.value(part)?;
                        let Some(whole) = self.number(value)?.as_whole() else {
                            return self.fail("The parts of a slice are whole numbers.");
                        };
                        *end = Some(whole);
                    }
                }
                Ok(Look::Slice(ends))
            }
            Suffix::Field(_) => self.fail("A list has no variables."),
        }
    }

    pub fn elements(&mut self, value: Value<'a>) -> Result<Rc<Vec<Value<'a>>>, ImportError> {
        match self.plain(value)? {
            Value::List(list) => Ok(list),
            Value::Map(map) if map.shift.iter().all(Number::is_zero) => {
                Ok(Rc::new(map.matrix.iter().cloned().map(Value::Number).collect()))
            }
            other => self.fail(format!("An element is asked for of {}, no list.", other.noun())),
        }
    }

    /// The columns of the matrix of a map.
    pub fn columns(&mut self, value: Value<'a>) -> Found<'a> {
        let size = self.single(value.clone())?.size;
        let entries = self.elements(value)?;
        self.charge(ELEMENT_STEPS * entries.len())?;
        let column = |k: usize| Value::list((0..size).map(|row| entries[row * size + k].clone()).collect());
        Ok(Value::list((0..size).map(column).collect()))
    }

    /// The place that an index stands for; from the end where it is negative.
    pub fn place(&mut self, index: &Value<'a>, count: usize) -> Result<usize, ImportError> {
        let index = self.number(index.clone())?;
        let found = index.as_whole().and_then(|index| {
            let count = i64::try_from(count).ok()?;
            let at = if index < 0 { count + index } else { index };
            usize::try_from(at).ok().filter(|_| at < count)
        });
        match found {
            Some(at) => Ok(at),
            None => self.fail(format!(
                "A list of {count} is asked for an element that it does not have. The first is 0, the last −1."
            )),
        }
    }

    pub fn seen(&mut self, list: &[Value<'a>], look: Look<'a>) -> Found<'a> {
        match look {
            Look::Size => Ok(Value::Number(Number::whole(i64::try_from(list.len()).unwrap_or(i64::MAX)))),
            Look::Flat => {
                let mut flat = Vec::new();
                for value in list {
                    match value {
                        Value::List(inner) => flat.extend(inner.iter().cloned()),
                        other => flat.push(other.clone()),
                    }
                    self.charge(ELEMENT_STEPS)?;
                }
                self.charge(ELEMENT_STEPS * flat.len())?;
                if flat.len() > MAX_LIST {
                    return self.fail(format!("A list is longer than {MAX_LIST}."));
                }
                Ok(Value::list(flat))
            }
            Look::At(index) => match self.plain(index)? {
                Value::List(indices) => {
                    self.charge(ELEMENT_STEPS * indices.len())?;
                    let pick = |index: &Value<'a>| Ok(list[self.place(index, list.len())?].clone());
                    indices.iter().map(pick).collect::<Result<Vec<_>, ImportError>>().map(Value::list)
                }
                index => Ok(list[self.place(&index, list.len())?].clone()),
            },
            Look::Slice(ends) => {
                let picked = sliced(list.len(), ends);
                let Some(picked) = picked else { return self.fail("The step of a slice is 0.") };
                self.charge(ELEMENT_STEPS * picked.len())?;
                Ok(Value::list(picked.into_iter().map(|at| list[at].clone()).collect()))
            }
        }
    }
}

/// The places of a slice, as Python has them; none where the step is 0.
fn sliced(count: usize, [from, to, step]: [Option<i64>; 3]) -> Option<Vec<usize>> {
    let count = i64::try_from(count).ok()?;
    let step = step.unwrap_or(1);
    if step == 0 {
        return None;
    }
    let (low, high) = if step > 0 { (0, count) } else { (-1, count - 1) };
    let place = |end: i64| (if end < 0 { end.saturating_add(count) } else { end }).clamp(low, high);
    let (first, last) = if step > 0 { (low, high) } else { (high, low) };
    let mut at = from.map_or(first, place);
    let end = to.map_or(last, place);
    let mut places = Vec::new();
    while (step > 0 && at < end) || (step < 0 && at > end) {
        places.push(usize::try_from(at).ok()?);
        at = at.saturating_add(step);
    }
    Some(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slices_are_those_of_python() {
        // Each as Python 3 has it of range(5).
        for (ends, wanted) in [
            ([Some(1), Some(4), None], vec![1, 2, 3]),
            ([Some(2), None, None], vec![2, 3, 4]),
            ([None, Some(3), None], vec![0, 1, 2]),
            ([None, None, Some(2)], vec![0, 2, 4]),
            ([Some(-3), None, None], vec![2, 3, 4]),
            ([None, None, Some(-1)], vec![4, 3, 2, 1, 0]),
            ([Some(-2), Some(0), Some(-2)], vec![3, 1]),
            ([Some(9), Some(-9), Some(-3)], vec![4, 1]),
            ([Some(3), Some(1), None], vec![]),
        ] {
            assert_eq!(sliced(5, ends), Some(wanted), "{ends:?}");
        }
        assert_eq!(sliced(5, [None, None, Some(0)]), None);
    }
}
