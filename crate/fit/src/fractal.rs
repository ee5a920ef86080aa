//! Fractal functions and curves: what is made of smaller copies of parts of itself.

mod address;
pub mod curve;
pub mod function;
pub mod piece;
pub mod recurrent;
pub mod sample;
mod through;
mod window;
