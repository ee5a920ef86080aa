//! Arithmetic without rounding, and the facts that are read from it.

pub(crate) mod address;
pub(crate) mod area;
pub(crate) mod expansion;
pub(crate) mod quadratic;
pub(crate) mod recognise;
