//! Names, and what they stand for: in a block, and in the blocks that it calls.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::affine::{Affine, MAX_DIMENSION};
use super::blocks::{Definition, Program, refused};
use super::number::{Number, Outcome};
use super::syntax::{Expression, TOO_LONG, parse, words};
use super::value::{Image, Instance, Value};
use crate::read::problem::ImportError;
use crate::text::short;

/// Names within names, brackets within brackets, calls within calls.
const MAX_DEPTH: usize = 160;
/// Said where they go on beyond that.
const ENDLESS: &str = "Names or brackets go on without end. Define what is named there without itself.";
/// So many letters of a text are a step.
const STEP_LETTERS: usize = 64;

pub type Found<'a> = Result<Value<'a>, ImportError>;

/// A block at work.
pub struct Frame<'a> {
    /// The block and its parents.
    pub chain: Vec<usize>,
    /// What its variables were given by whoever called it.
    pub given: Vec<(&'a str, Value<'a>)>,
    /// What is known; none of what is being computed.
    known: BTreeMap<&'a str, Option<Value<'a>>>,
    /// The dimensions of its maps.
    pub size: usize,
    /// Its sets, and their numbers.
    pub sets: BTreeMap<&'a str, usize>,
}

impl<'a> Frame<'a> {
    pub const fn new(chain: Vec<usize>, given: Vec<(&'a str, Value<'a>)>, size: usize) -> Self {
        Self { chain, given, known: BTreeMap::new(), size, sets: BTreeMap::new() }
    }
}

pub struct Machine<'p, 'a> {
    pub program: &'p Program<'a>,
    pub frames: Vec<Frame<'a>>,
    /// The lists that are being made, the inner ones last.
    pub lists: Vec<Vec<Value<'a>>>,
    /// The line that is being read.
    pub line: usize,
    /// The steps that are left.
    pub steps: usize,
    depth: usize,
    /// What an expression comes to: names stand for expressions, which have names in them.
    evaluate: Evaluate<'p, 'a>,
}

pub type Evaluate<'p, 'a> = fn(&mut Machine<'p, 'a>, &'p Expression<'a>) -> Found<'a>;

impl<'p, 'a> Machine<'p, 'a> {
    pub fn new(
        program: &'p Program<'a>,
        frame: Frame<'a>,
        line: usize,
        steps: usize,
        evaluate: Evaluate<'p, 'a>,
    ) -> Self {
        Self { program, frames: vec![frame], lists: Vec::new(), line, steps, depth: 0, evaluate }
    }

    pub fn value(&mut self, expression: &'p Expression<'a>) -> Found<'a> {
        self.charge(1)?;
        (self.evaluate)(self, expression)
    }

    pub fn frame(&self) -> &Frame<'a> {
        &self.frames[self.frames.len() - 1]
    }

    pub fn size(&self) -> usize {
        self.frame().size
    }

    pub fn fail<T>(&self, why: impl AsRef<str>) -> Result<T, ImportError> {
        Err(refused("aifs-unread", self.line, why.as_ref()))
    }

    pub fn told<T>(&self, outcome: Outcome<T>) -> Result<T, ImportError> {
        outcome.or_else(|why| self.fail(why))
    }

    pub fn charge(&mut self, steps: usize) -> Result<(), ImportError> {
        match self.steps.checked_sub(steps) {
            Some(left) => self.steps = left,
            None => {
                self.steps = 0;
                return self.fail(TOO_LONG);
            }
        }
        Ok(())
    }

    /// One step further in, while something is done there.
    pub fn within<T>(
        &mut self,
        act: impl FnOnce(&mut Self) -> Result<T, ImportError>,
    ) -> Result<T, ImportError> {
        if self.depth == MAX_DEPTH {
            return self.fail(ENDLESS);
        }
        self.depth += 1;
        let outcome = act(self);
        self.depth -= 1;
        outcome
    }

    pub fn definition(&self, name: &str) -> Option<&'p Definition<'a>> {
        self.program.find(&self.frame().chain, name)
    }

    pub fn parsed(&mut self, definition: &'p Definition<'a>) -> Result<&'p Expression<'a>, ImportError> {
        if definition.parsed.get().is_none() {
            self.charge(1 + definition.value.len() / STEP_LETTERS)?;
        }
        let steps = &mut self.steps;
        let parsed = definition.parsed.get_or_init(|| parse(definition.value, steps));
        parsed.as_ref().map_err(|why| refused("aifs-unread", definition.line, why))
    }

    pub fn words(&mut self, definition: &'p Definition<'a>) -> Result<&'p [&'a str], ImportError> {
        if definition.words.get().is_none() {
            self.charge(1 + definition.value.len() / STEP_LETTERS)?;
        }
        let words = definition.words.get_or_init(|| words(definition.value));
        self.charge(1 + words.len() / 8)?;
        Ok(words)
    }

    /// The value of a definition, computed.
    pub fn computed(&mut self, definition: &'p Definition<'a>) -> Found<'a> {
        let expression = self.parsed(definition)?;
        let here = std::mem::replace(&mut self.line, definition.line);
        // A substitution sees the lists that it is put into.
        let lists = if definition.substitution { None } else { Some(std::mem::take(&mut self.lists)) };
        let value = self.within(|machine| machine.value(expression))?;
        if let Some(lists) = lists {
            self.lists = lists;
        }
        self.line = here;
        Ok(value)
    }

    /// What a name stands for where it is a variable.
    pub fn variable(&mut self, name: &'a str) -> Result<Option<Value<'a>>, ImportError> {
        self.charge(1)?;
        let frame = self.frame();
        if let Some((_, value)) = frame.given.iter().find(|(given, _)| *given == name) {
            return Ok(Some(value.clone()));
        }
        if let Some(&set) = frame.sets.get(name) {
            let map = Rc::new(Affine::identity(frame.size));
            return Ok(Some(Value::Images(Rc::new(vec![Image { map, set }]))));
        }
        match frame.known.get(name) {
            Some(Some(value)) => return Ok(Some(value.clone())),
            Some(None) => {
                let name = short(name, 20);
                return self.fail(format!("“{name}” is defined by itself. Define it without."));
            }
            None => {}
        }
        let Some(definition) = self.definition(name) else { return Ok(None) };
        if definition.substitution {
            return self.computed(definition).map(Some);
        }
        let at = self.frames.len() - 1;
        self.frames[at].known.insert(name, None);
        let value = self.computed(definition)?;
        self.frames[at].known.insert(name, Some(value.clone()));
        Ok(Some(value))
    }

    /// What any name stands for.
    pub fn named(&mut self, name: &'a str) -> Found<'a> {
        match name {
            "$i" => return Ok(Value::Map(Rc::new(Affine::identity(self.size())))),
            "$e" => return Ok(Value::maps(Vec::new())),
            "$pi" if self.definition(name).is_none() => {
                let half = Number::function("asin", &[Number::ONE]).map_or(Ok(Number::ZERO), |half| half);
                let half = self.told(half)?;
                return self.told(half.times(&Number::whole(2))).map(Value::Number);
            }
            _ => {}
        }
        if let Some(value) = self.variable(name)? {
            return Ok(value);
        }
        match self.program.ids.get(name) {
            Some(&block) => Ok(Value::Block(Rc::new(Instance { block, given: Vec::new() }))),
            None => {
                let name = short(name, 30);
                self.fail(format!(
                    "“{name}” is not defined. Define it in this block or in one that it inherits."
                ))
            }
        }
    }

    /// Does something in a block that is called.
    fn inside<T>(
        &mut self,
        instance: &Instance<'a>,
        act: impl FnOnce(&mut Self) -> Result<T, ImportError>,
    ) -> Result<T, ImportError> {
        let (chain, _) = self.program.chain(instance.block);
        self.charge(chain.len() + instance.given.len())?;
        let frame = Frame::new(chain, instance.given.clone(), self.size());
        self.frames.push(frame);
        let lists = std::mem::take(&mut self.lists);
        let here = self.line;
        let outcome = self.within(|machine| {
            machine.measure()?;
            act(machine)
        });
        self.lists = lists;
        self.frames.pop();
        if outcome.is_ok() {
            self.line = here;
        }
        outcome
    }

    /// What a block returns: its last variable.
    pub fn returned(&mut self, instance: &Instance<'a>) -> Found<'a> {
        let variables = self.variables_of(instance.block)?;
        match variables.last() {
            Some(&last) => self.inside(instance, |machine| machine.named(last)),
            None => self.fail("A block without variables is called, and returns nothing."),
        }
    }

    /// A variable of a block.
    pub fn field(&mut self, instance: &Instance<'a>, name: &'a str) -> Found<'a> {
        self.inside(instance, |machine| match machine.variable(name)? {
            Some(value) => Ok(value),
            None => machine.fail(format!("The block has no variable “{}”.", short(name, 30))),
        })
    }

    /// A block whose first variables are these.
    pub fn called(&mut self, block: usize, arguments: Vec<Value<'a>>) -> Found<'a> {
        let variables = self.variables_of(block)?;
        if arguments.len() > variables.len() {
            let (count, most) = (arguments.len(), variables.len());
            return self.fail(format!("A block with {most} variables is called with {count}."));
        }
        self.returned(&Instance { block, given: variables.into_iter().zip(arguments).collect() })
    }

    /// The names of a block and of those that it inherits.
    pub fn variables_of(&mut self, block: usize) -> Result<Vec<&'a str>, ImportError> {
        let (chain, _) = self.program.chain(block);
        let count: usize = chain.iter().map(|&one| self.program.blocks[one].definitions.len()).sum();
        self.charge(1 + count)?;
        Ok(self.program.variables(&chain))
    }

    /// Takes the dimensions from `$dim`, where the block has it.
    pub fn measure(&mut self) -> Result<(), ImportError> {
        let Some(definition) = self.definition("$dim") else { return Ok(()) };
        let value = self.computed(definition)?;
        let here = std::mem::replace(&mut self.line, definition.line);
        let size = match &value {
            Value::Number(x) => x.as_whole().and_then(|x| usize::try_from(x).ok()),
            _ => None,
        };
        let Some(size) = size.filter(|size| (1..=MAX_DIMENSION).contains(size)) else {
            return self.fail(format!("$dim is a whole number from 1 to {MAX_DIMENSION}."));
        };
        self.line = here;
        let at = self.frames.len() - 1;
        self.frames[at].size = size;
        Ok(())
    }
}
