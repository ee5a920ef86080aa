//! What operators make of values: unions, sums, products, powers; and values as numbers and maps.

use std::rc::Rc;

use frond_core::MAX_MAPS;

use super::affine::Affine;
use super::machine::{Found, Machine};
use super::number::{Number, Outcome, TOO_LARGE};
use super::syntax::{Joint, MANY};
use super::value::{Image, Value};
use crate::read::problem::ImportError;

impl<'p, 'a> Machine<'p, 'a> {
    /// Maps united with maps, or images of sets with images of sets.
    pub fn union_of(&mut self, parts: Vec<Value<'a>>) -> Found<'a> {
        let (mut maps, mut images) = (Vec::new(), Vec::new());
        for part in parts {
            match part {
                Value::Images(more) => images.extend(more.iter().cloned()),
                other => maps.extend(self.maps(other)?),
            }
            if maps.len().max(images.len()) > MAX_MAPS {
                return self.fail(MANY);
            }
        }
        match (images.is_empty(), maps.is_empty()) {
            (true, _) => Ok(Value::maps(maps)),
            (false, true) => Ok(Value::Images(Rc::new(images))),
            _ => {
                self.fail("Sets are united with maps. Say of which set those are the images, as in f*A|g*A.")
            }
        }
    }

    /// A value without the blocks that stand for what they return.
    pub fn plain(&mut self, value: Value<'a>) -> Found<'a> {
        match value {
            Value::Block(instance) => self.within(|machine| machine.returned(&instance)),
            other => Ok(other),
        }
    }

    pub fn plus(&mut self, one: Value<'a>, other: Value<'a>) -> Found<'a> {
        self.charge(1)?;
        let (one, other) = (self.plain(one)?, self.plain(other)?);
        match (one, other) {
            (Value::Number(x), Value::Number(y)) => {
                self.charge(Number::steps(1, x.words() + y.words()))?;
                self.told(x.plus(&y)).map(Value::Number)
            }
            (Value::List(x), Value::List(y)) if x.len() == y.len() => {
                self.charge(x.len())?;
                let pairs = x.iter().cloned().zip(y.iter().cloned());
                let sums = pairs.map(|(x, y)| self.plus(x, y)).collect::<Result<Vec<_>, _>>()?;
                Ok(Value::list(sums))
            }
            (one, other) => {
                let (one, other) = (self.single(one)?, self.single(other)?);
                self.alike(&one, &other)?;
                self.charge(Number::steps(one.size * one.size, one.words() + other.words()))?;
                self.told(one.plus(&other)).map(|sum| Value::Map(Rc::new(sum)))
            }
        }
    }

    pub fn negated(&mut self, value: Value<'a>) -> Found<'a> {
        match self.plain(value)? {
            Value::Number(x) => Ok(Value::Number(x.negated())),
            Value::List(list) => {
                self.charge(list.len())?;
                let negated = list.iter().cloned().map(|x| self.negated(x)).collect::<Result<Vec<_>, _>>()?;
                Ok(Value::list(negated))
            }
            Value::Map(map) => Ok(Value::Map(Rc::new(map.negated()))),
            other => self.fail(format!("A minus stands before {}.", other.noun())),
        }
    }

    pub fn joined(&mut self, one: Value<'a>, joint: Joint, other: Value<'a>) -> Found<'a> {
        self.charge(1)?;
        let (one, other) = (self.plain(one)?, self.plain(other)?);
        if let (Value::Number(x), Value::Number(y)) = (&one, &other) {
            self.charge(Number::steps(1, x.words() + y.words()))?;
            let outcome = match joint {
                Joint::Times => x.times(y),
                Joint::Over => x.over(y),
                Joint::Modulo => x.modulo(y),
            };
            return self.told(outcome).map(Value::Number);
        }
        if joint == Joint::Modulo {
            return self.fail("“%” stands between numbers alone.");
        }
        // A list that is no map is a list of numbers.
        match (&one, &other) {
            (Value::List(list), Value::Number(x)) if !self.is_map(list) => {
                return self.scaled(list, x, joint);
            }
            (Value::Number(x), Value::List(list)) if joint == Joint::Times && !self.is_map(list) => {
                return self.scaled(list, x, joint);
            }
            _ => {}
        }
        match (one, other, joint) {
            (Value::Images(_), _, _) => {
                self.fail("A set stands before “*”: a map stands first, and then the set, as in f*A.")
            }
            (one, Value::Images(images), Joint::Times) => {
                let maps = self.maps(one)?;
                self.few(maps.len(), images.len())?;
                let mut all = Vec::with_capacity(maps.len() * images.len());
                for map in &maps {
                    for Image { map: inner, set } in &*images {
                        all.push(Image { map: self.composed(map, inner)?, set: *set });
                    }
                }
                Ok(Value::Images(Rc::new(all)))
            }
            (_, Value::Images(_), _) => self.fail("A set stands behind “/”. Write “*”."),
            (one, other, joint) => {
                let maps = self.maps(one)?;
                let inner = if joint == Joint::Over {
                    let map = self.single(other)?;
                    vec![self.inverse(&map)?]
                } else {
                    self.maps(other)?
                };
                self.few(maps.len(), inner.len())?;
                let mut all = Vec::with_capacity(maps.len() * inner.len());
                for (k, map) in maps.iter().enumerate() {
                    for (j, inner_map) in inner.iter().enumerate() {
                        let count = maps.len() * inner.len();
                        all.push(self.numbered(count, k * inner.len() + j, |machine| {
                            machine.composed(map, inner_map)
                        })?);
                    }
                }
                Ok(Value::maps(all))
            }
        }
    }

    /// Says of several products which one cannot be made.
    fn numbered<T>(
        &mut self,
        count: usize,
        at: usize,
        act: impl FnOnce(&mut Self) -> Result<T, ImportError>,
    ) -> Result<T, ImportError> {
        act(self).or_else(|error| match &error {
            ImportError::At { why, .. } if count > 1 && why == TOO_LARGE => {
                self.fail(format!("Of {count} products, in number {}: {why}", at + 1))
            }
            _ => Err(error),
        })
    }

    fn few(&self, one: usize, other: usize) -> Result<(), ImportError> {
        if one * other > MAX_MAPS { self.fail(MANY) } else { Ok(()) }
    }

    fn scaled(&mut self, list: &[Value<'a>], x: &Number, joint: Joint) -> Found<'a> {
        self.charge(list.len())?;
        let each = |value: &Value<'a>| self.joined(value.clone(), joint, Value::Number(x.clone()));
        list.iter().map(each).collect::<Result<Vec<_>, _>>().map(Value::list)
    }

    pub fn composed(&mut self, outer: &Rc<Affine>, inner: &Rc<Affine>) -> Result<Rc<Affine>, ImportError> {
        self.alike(outer, inner)?;
        let dense = outer.matrix.iter().filter(|x| !x.is_zero()).count();
        self.charge(Number::steps(dense * outer.size, outer.words() + inner.words()))?;
        if outer.is_identity() {
            return Ok(inner.clone());
        }
        let product = self.told(outer.after(inner))?;
        self.finite(product)
    }

    fn alike(&self, one: &Affine, other: &Affine) -> Result<(), ImportError> {
        if one.size == other.size {
            return Ok(());
        }
        let (one, other) = (one.size, other.size);
        self.fail(format!("A map of {one} dimensions meets one of {other}. Give both the same."))
    }

    /// A map all of whose entries are doubles, too.
    fn finite(&self, map: Affine) -> Result<Rc<Affine>, ImportError> {
        let doubles: Outcome<Vec<f64>> = map.matrix.iter().chain(&map.shift).map(Number::double).collect();
        self.told(doubles)?;
        Ok(Rc::new(map))
    }

    pub fn inverse(&mut self, map: &Affine) -> Result<Rc<Affine>, ImportError> {
        let products = 2 * map.size.pow(3);
        self.charge(Number::steps(products, 2 * map.words()))?;
        let inverse = self.told(map.inverse())?;
        // What is computed on the way is about as long as what comes out.
        self.charge(Number::steps(products, 2 * inverse.words()))?;
        self.finite(inverse)
    }

    pub fn raised(&mut self, base: Value<'a>, exponent: &Value<'a>) -> Found<'a> {
        self.charge(1)?;
        let Value::Number(exponent) = self.plain(exponent.clone())? else {
            return self.fail("An exponent is a number.");
        };
        let base = self.plain(base)?;
        match &base {
            Value::Number(x) => {
                let power = self.told(x.power(&exponent))?;
                self.charge(Number::steps(4, 2 * power.words()))?;
                return Ok(Value::Number(power));
            }
            Value::Images(_) => return self.fail("A set has no power. Maps have: f^2*A."),
            // A translation is made so many times, also a broken number of times.
            Value::List(list) if is_flat(list) && (list.len() != self.size().pow(2) || list.len() == 1) => {
                return self.scaled(list, &exponent, Joint::Times);
            }
            _ => {}
        }
        let Some(power) = exponent.as_whole() else {
            return self.fail("Powers of maps are whole numbers.");
        };
        let mut maps = self.maps(base)?;
        if let [map] = maps.as_slice() {
            let mut square = if power < 0 { self.inverse(map)? } else { map.clone() };
            let mut product: Option<Rc<Affine>> = None;
            let mut left = power.unsigned_abs();
            while left > 0 {
                if left % 2 == 1 {
                    product = Some(match product {
                        None => square.clone(),
                        Some(before) => self.composed(&before, &square)?,
                    });
                }
                left /= 2;
                if left > 0 {
                    square = self.composed(&square, &square)?;
                }
            }
            return Ok(Value::Map(product.unwrap_or_else(|| Rc::new(Affine::identity(self.size())))));
        }
        if !(0..=64).contains(&power) {
            return self.fail("Powers of several maps are read from 0 to 64.");
        }
        let first = maps;
        maps = vec![Rc::new(Affine::identity(self.size()))];
        for _ in 0..power {
            self.few(first.len(), maps.len())?;
            let mut all = Vec::with_capacity(first.len() * maps.len());
            for outer in &first {
                for inner in &maps {
                    all.push(self.composed(outer, inner)?);
                }
            }
            maps = all;
        }
        Ok(Value::maps(maps))
    }

    /// Whether a list is a translation or a matrix.
    pub fn is_map(&self, list: &[Value<'a>]) -> bool {
        let size = self.size();
        let row = |value: &Value<'a>| matches!(value, Value::List(row) if row.len() == size && is_flat(row));
        self.is_flat_map(list) || (list.len() == size && list.iter().all(row))
    }

    /// The same, of numbers alone.
    pub fn is_flat_map(&self, list: &[Value<'a>]) -> bool {
        let size = self.size();
        is_flat(list) && (list.len() == size || list.len() == size * size)
    }

    /// A number scales, a list is a translation or a matrix.
    pub fn maps(&mut self, value: Value<'a>) -> Result<Vec<Rc<Affine>>, ImportError> {
        let size = self.size();
        match self.plain(value)? {
            Value::Map(map) => Ok(vec![map]),
            Value::Maps(maps) => Ok(maps.to_vec()),
            Value::Number(x) => {
                self.charge(1 + size * size / 8)?;
                self.told(Affine::scaling(size, &x)).and_then(|map| Ok(vec![self.finite(map)?]))
            }
            Value::List(list) => {
                self.charge(1 + list.len() / 8)?;
                let numbers = self.flat_numbers(&list)?;
                let map = match numbers.len() {
                    count if count == size => Affine::translation(&numbers),
                    count if count == size * size => Affine::linear(size, &numbers),
                    count => {
                        return self.fail(format!(
                            "A list of {count} numbers is neither a translation nor a matrix of {size} dimensions."
                        ));
                    }
                };
                self.told(map).and_then(|map| Ok(vec![self.finite(map)?]))
            }
            other => self.fail(format!("{} stands where a map should be.", capital(other.noun()))),
        }
    }

    pub fn single(&mut self, value: Value<'a>) -> Result<Rc<Affine>, ImportError> {
        match self.maps(value)?.as_slice() {
            [map] => Ok(map.clone()),
            [] => self.fail("The empty set stands where a map should be."),
            _ => self.fail("Several maps stand where one should be."),
        }
    }

    pub fn number(&mut self, value: Value<'a>) -> Result<Number, ImportError> {
        match self.plain(value)? {
            Value::Number(x) => Ok(x),
            other => self.fail(format!("{} stands where a number should be.", capital(other.noun()))),
        }
    }

    /// The numbers of a list; of one of rows, those of all rows.
    pub fn flat_numbers(&mut self, list: &[Value<'a>]) -> Result<Vec<Number>, ImportError> {
        let mut numbers = Vec::with_capacity(list.len());
        for value in list {
            match value {
                Value::List(row) => {
                    for x in row.iter() {
                        numbers.push(self.number(x.clone())?);
                    }
                }
                other => numbers.push(self.number(other.clone())?),
            }
        }
        Ok(numbers)
    }
}

fn is_flat(list: &[Value<'_>]) -> bool {
    list.iter().all(|value| matches!(value, Value::Number(_)))
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
