//! Arithmetic without rounding: expansions of doubles, numbers a + b sqrt(d) of any length, which numbers doubles most
//! plausibly stand for, and what is proved with them.

pub(crate) mod address;
pub(crate) mod area;
pub(crate) mod double_double;
pub(crate) mod expansion;
pub(crate) mod quadratic;
pub(crate) mod recognise;
pub(crate) mod residue;
