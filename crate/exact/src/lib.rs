//! x
pub mod error; pub mod number;
pub use error::ExactError;
pub use number::{field::*, interval::*, rational::*, roots::{ComplexInterval, Root}, value::*};
