//! The exact algebra of self-similar sets and tiles: which pieces meet, and what follows from it.
//!
//! Numbers are fractions or elements of number fields ([`Number`], [`Field`]), and so two maps are the same or are not.
//! A [`System`] is a graph-directed system of affine maps of a line, a plane or space. [`analyze`] finds its neighbour
//! maps, and from them the open set condition, the Hausdorff dimension between bounds, inner points, and the boundary
//! of a tile as a system of its own. What it says is proved under the theorem that its [`Reason`] names. [`meeting`]
//! finds points that the first pieces share. [`ExactNumbers`] says which numbers the doubles of maps stand for.

mod error;
mod graph;
mod number;
mod system;

pub use error::ExactError;
pub use graph::analysis::{Analysis, Boundary, Dimension, OpenSetCondition, Reason, Settings, analyze};
pub use graph::meeting::{Address, MOST_LETTERS, Meeting, SharedPoint, meeting};
pub use graph::neighbours::Overlap;
pub use num_bigint::BigInt;
pub use number::field::{Element, Field, LARGEST_FIELD};
pub use number::interval::Interval;
pub use number::rational::Rational;
pub use number::roots::{ComplexInterval, Root};
pub use number::value::Number;
pub use system::build::{DoubleMap, FieldMap, MOST_MAPS, MOST_STATES, RealMap, System};
pub use system::numbers::{ExactNumber, ExactNumbers, ExactRows, MOST_NUMBERS, WrongNumber};
pub use system::projected::VectorMap;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadMe;
