//! Codes, how they are shuffled, and the displacements that come of it: the terms of the paper's sum, unrepaired.

pub mod code;
pub mod cube;
pub mod cursor;
pub mod field;
pub mod level_terms;
pub mod means;
pub mod moments;
pub mod place_terms;
pub mod spin;
pub mod terms;
pub mod weight;
