//! Texts, a format each.

mod aifs;
mod csv;
mod depth;
mod desmos;
pub(crate) mod export;
mod flame;
pub(crate) mod fractint;
mod geogebra;
mod json;
mod latex;
mod pieces;
mod python;
mod svg;
mod tikz;
