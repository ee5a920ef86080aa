//! What expressions come to.

use std::rc::Rc;

use super::affine::Affine;
use super::number::Number;

#[derive(Clone, Debug)]
pub enum Value<'a> {
    Number(Number),
    List(Rc<Vec<Self>>),
    Map(Rc<Affine>),
    /// Several, any of them; or none.
    Maps(Rc<Vec<Rc<Affine>>>),
    /// Images of sets.
    Images(Rc<Vec<Image>>),
    /// A block, with what some of its variables are.
    Block(Rc<Instance<'a>>),
}

/// The image of a set.
#[derive(Clone, Debug)]
pub struct Image {
    pub map: Rc<Affine>,
    /// The set, by its number.
    pub set: usize,
}

#[derive(Debug)]
pub struct Instance<'a> {
    pub block: usize,
    pub given: Vec<(&'a str, Value<'a>)>,
}

impl Value<'_> {
    pub fn list(values: Vec<Self>) -> Self {
        Self::List(Rc::new(values))
    }

    pub fn numbers(list: Vec<Number>) -> Self {
        Self::list(list.into_iter().map(Self::Number).collect())
    }

    /// One map, or several.
    pub fn maps(maps: Vec<Rc<Affine>>) -> Self {
        match <[_; 1]>::try_from(maps) {
            Ok([one]) => Self::Map(one),
            Err(maps) => Self::Maps(Rc::new(maps)),
        }
    }

    /// What it is, for sentences.
    pub const fn noun(&self) -> &'static str {
        match self {
            Self::Number(_) => "a number",
            Self::List(_) => "a list",
            Self::Map(_) => "a map",
            Self::Maps(_) => "several maps",
            Self::Images(_) => "a set",
            Self::Block(_) => "a block",
        }
    }
}
